// The program's text before the editor is loaded, or without an editor.
//
// In: texts, edits of the user made in a panel. Out: the text with its own line ends, and the whole text for the worker
// after each change. Must not know: the elements that display it.

import type { LineEnds } from '../files/line-ends';
import { splitIntoPieces } from '../files/line-ends';
import type { TextCommand } from '../protocol/protocol';
import type { Change, Span, InitialState, TextEvents, TextStore } from './text-store';
import { programText, type ProgramFile, type ProgramText } from './program-text';

export class PlainProgram implements TextStore {
  readonly #events: TextEvents;
  #program: ProgramText = programText('');
  #text = '';
  #file: ProgramFile | undefined;
  #unsent: InitialState['unsent'] = 'all';
  #selection: Span = { from: 0, to: 0 };
  #revision = 0;

  constructor(events: TextEvents) {
    this.#events = events;
  }

  get text(): string {
    return this.#text;
  }

  get textWithLineEnds(): string {
    const { usual, exceptions } = this.#program.ends;
    const parts: string[] = [];
    let done = 0;
    const upTo = (at: number): string => this.#text.slice(done, at).replaceAll('\n', usual);
    for (const [at, end] of exceptions) {
      parts.push(upTo(at), end);
      done = at + 1;
    }
    return parts.join('') + upTo(this.length);
  }

  get lineEnds(): LineEnds {
    return this.#program.ends;
  }

  get length(): number {
    return this.#text.length;
  }

  get revision(): number {
    return this.#revision;
  }

  get file(): ProgramFile | undefined {
    return this.#file;
  }

  set file(file: ProgramFile) {
    this.#file = file;
    this.#events.onFileChanged();
  }

  get selection(): Span {
    return this.#selection;
  }

  get cursor(): number {
    return this.#selection.to;
  }

  /** The state that the editor takes over. */
  get state(): InitialState {
    return { program: this.#program, file: this.#file, unsent: this.#unsent };
  }

  textBetween(from: number, to: number): string {
    return this.#text.slice(from, to);
  }

  takeUnsent(): TextCommand | undefined {
    if (this.#unsent === 'nothing') return undefined;
    this.#unsent = 'nothing';
    return { kind: 'text', pieces: this.#program.pieces };
  }

  markAllUnsent(): void {
    this.#unsent = 'all';
  }

  setText(program: ProgramText, file: ProgramFile | undefined): void {
    this.#replaceText(program);
    if (file === this.#file) return;
    this.#file = file;
    this.#events.onFileChanged();
  }

  rewrite(text: string): void {
    const { pieces } = programText(text);
    // The lines have changed; most line ends keep their kind.
    this.#replaceText({ pieces, ends: { usual: this.#program.ends.usual, exceptions: [] } });
  }

  change(edits: readonly Change[]): void {
    if (edits.length === 0) return;
    let [text, ends] = [this.#text, this.#program.ends];
    // From the end of the text, so that the offsets of the remaining edits stay valid.
    for (const edit of [...edits].sort((a, b) => b.from - a.from)) {
      text = text.slice(0, edit.from) + edit.text + text.slice(edit.to);
      ends = mapLineEnds(ends, edit);
    }
    this.#replaceText({ pieces: splitIntoPieces(text), ends });
    this.#events.onTextChanged('inserted');
  }

  select(span: Span): void {
    if (span.to <= this.length) this.#selection = span;
  }

  #replaceText(program: ProgramText): void {
    this.#program = program;
    this.#text = program.pieces.join('');
    this.#selection = { from: 0, to: 0 };
    this.#unsent = 'all';
    this.#revision++;
  }
}

function mapLineEnds({ usual, exceptions }: LineEnds, { from, to, text }: Change): LineEnds {
  const by = text.length - (to - from);
  const kept = exceptions.filter(([at]) => at < from || at >= to);
  return { usual, exceptions: kept.map(([at, end]) => [at < from ? at : at + by, end]) };
}
