// The settings of the author of a page: marked and shown lines, the frame of the picture, the turret, the playback speed,
// and the caption.
//
// In: the attributes. Out: decorations of the editor, commands for the worker, the caption. Must not know: the program,
// or whether there is a worker.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { ANNOTATE_CHOICES, type AnnotateChoice, type Command, type Pace } from '../protocol/protocol';
import { FRAMES, oneOf, parseLines, parseSpeed, SIDES, speedText, type Lines } from './author';
import type { Layout } from './layout';

interface AuthorHost {
  readonly highlight: string | null;
  readonly lines: string | null;
  readonly fit: string | null;
  readonly turret: string | null;
  readonly annotate: string | null;
  readonly calculator: string | null;
  readonly exercise: string | null;
  readonly caption: string | null;
  get speed(): string | null;
  set speed(speed: string | number | null);
}

interface LineEditor {
  set highlightedLines(lines: readonly Lines[]);
  set shownLines(lines: readonly Lines[]);
}

export class AuthorSettings {
  readonly #host: AuthorHost;
  readonly #editor: LineEditor;
  readonly #layout: Layout;

  constructor(host: AuthorHost, editor: LineEditor, layout: Layout) {
    this.#host = host;
    this.#editor = editor;
    this.#layout = layout;
  }

  /** Applies the attributes for lines and picture. */
  apply(send: (command: Command) => void): void {
    this.#editor.highlightedLines = parseLines(this.#host.highlight);
    this.#editor.shownLines = parseLines(this.#host.lines);
    this.#send(send);
  }

  /** Sends the settings to a new worker, which has the defaults. */
  sendInitial(send: (command: Command) => void): void {
    const { highlight, fit, turret, annotate } = this.#host;
    if ([highlight, fit, turret, annotate].some((attribute) => attribute !== null)) this.#send(send);
  }

  sendFrame(send: (command: Command) => void): void {
    // A presentation shows the cuts as large as possible.
    const presented = this.#layout.frame.dataset['presenting'] === undefined ? undefined : 'cuts';
    send({ kind: 'frame', frame: oneOf(FRAMES, this.#host.fit) ?? presented });
  }

  get annotate(): AnnotateChoice {
    return oneOf(ANNOTATE_CHOICES, this.#host.annotate) ?? 'word';
  }

  get speed(): Pace | undefined {
    return parseSpeed(this.#host.speed);
  }

  changeSpeed(speed: Pace): void {
    this.#host.speed = speedText(speed);
  }

  get calculator(): string | undefined {
    return this.#host.calculator ?? undefined;
  }

  get exercise(): string | undefined {
    return this.#host.exercise ?? undefined;
  }

  showCaption(language: Language): void {
    const { container, caption } = this.#layout;
    const text = this.#host.caption ?? '';
    caption.hidden = text === '';
    caption.textContent = text;
    container.setAttribute('aria-label', text === '' ? WORDS[language].playground : text);
  }

  #send(send: (command: Command) => void): void {
    const { highlight, turret } = this.#host;
    send({
      kind: 'mark',
      lines: parseLines(highlight).map(({ first, last }) => ({ firstLine: first - 1, endLine: last })),
    });
    this.sendFrame(send);
    send({ kind: 'turret', side: oneOf(SIDES, turret) });
    send({ kind: 'annotate', choice: oneOf(ANNOTATE_CHOICES, this.#host.annotate) });
  }
}

const WORDS = words({
  en: { playground: 'G-code playground' },
  zh: { playground: 'G 代码演练场' },
  ru: { playground: 'Песочница G-кода' },
});
