// Navigation in the program: to all uses of the number at the cursor, and by the outline; also the ranges that can be
// folded.
//
// In: answers of the interpreter about the text, once the user has focused it. Out: the place to show. Must not know:
// the meaning of a number, or the contents of the outline.

import { icon, make, name } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { UsesHelp } from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import { late } from './late';
import type { OutlineDialog } from './outline-dialog';
import {
  isInProgram,
  type Key,
  type NewestQuestion,
  type Panel,
  type PanelKind,
  type Services,
  type Shell,
} from './panel';
import navigationStyles from './navigation.css?inline';

export const navigation: PanelKind = {
  control: 'help',
  styles: navigationStyles,
  make: (shell) => new Navigation(shell),
};

/** Most places that are listed, including those next to the cursor. */
const LISTED = 12;
/** Pause in typing, after which the panel asks for foldable ranges. */
const PAUSE_MS = 400;

class Navigation implements Panel {
  readonly #shell: Shell;
  readonly #button = make(
    'button',
    { type: 'button', className: 'outline-button', 'aria-haspopup': 'dialog' },
    icon('outline'),
  );
  readonly #section = make('div', { className: 'uses', hidden: true });
  readonly #question: NewestQuestion<'uses'>;
  readonly #folds: NewestQuestion<'outline'>;
  /** Loaded once the user focuses the text, or opens the outline. */
  #dialog: OutlineDialog | undefined;
  /** Whether the user has focused the text. Until then the panel asks no question. */
  #wanted = false;
  /** The uses that are shown now. */
  #uses: UsesHelp | undefined;
  /** Those uses with the cursor and the language, as text, to compare. */
  #shownAs = '';
  /** Offsets that the user came from, the newest last. */
  #trail: number[] = [];
  #pause: ReturnType<typeof setTimeout> | undefined;
  readonly places = {};
  readonly services: Partial<Services> = { outlineButton: () => this.#button, usesSection: () => this.#section };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => void this.#open());
    this.#question = shell.newest('uses', (uses) => this.#show(uses));
    this.#folds = shell.newest('outline', (outline) => {
      // Undefined if the text has changed since. The panel then asks again.
      if (outline !== undefined) shell.editor.foldable = outline.folds.map(([from, to]) => ({ from, to }));
    });
  }

  set language(language: Language) {
    name(this.#button, `${WORDS[language].outline} (Ctrl Shift O)`);
    if (this.#dialog !== undefined) this.#dialog.language = language;
    this.#show(this.#uses);
  }

  get takesKeys(): boolean {
    return this.#dialog?.open ?? false;
  }

  cursorMoved(): void {
    if (!this.#wanted) {
      this.#folds.ask(undefined);
      // If loading fails, it is tried again when the outline is opened.
      this.#load().catch(() => undefined);
    }
    this.#wanted = true;
    this.#ask();
  }

  heard(event: Heard): void {
    if (event.kind !== 'report' || !this.#wanted) return;
    this.#ask();
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => this.#folds.ask(undefined), PAUSE_MS);
  }

  outdated(): void {
    this.#question.forget();
  }

  lost(): void {
    this.left();
    this.#show(undefined);
  }

  left(): void {
    clearTimeout(this.#pause);
    this.#question.forget();
    this.#folds.forget();
  }

  pressed(key: Key): 'own' | 'not-own' {
    const { event } = key;
    if (event.altKey) return 'not-own';
    const command = event.ctrlKey || event.metaKey;
    if (command && event.shiftKey && event.key.toLowerCase() === 'o') {
      void this.#open();
      return 'own';
    }
    if (event.key !== 'F12' || command || !isInProgram(key, this.#shell)) return 'not-own';
    if (event.shiftKey) this.#back();
    else void this.#follow();
    return 'own';
  }

  #ask(): void {
    this.#question.ask({ offset: this.#shell.editor.selection.from });
  }

  /** Goes to the block that the number at the cursor names, or to the next use of the number. */
  async #follow(): Promise<void> {
    const { editor } = this.#shell;
    const [from, texts] = [editor.selection.from, WORDS[this.#shell.language]];
    this.#shell.flush();
    const uses = await this.#shell.ask('uses', { offset: from });
    const place = uses?.places[uses.next];
    if (uses === undefined || place === undefined) return this.#say(texts.noNumber);
    if (place.from <= from && from <= place.to) return this.#say(texts.onlyHere(uses.name));
    this.#go(from, place);
  }

  #back(): void {
    const from = this.#trail.pop();
    if (from === undefined) return this.#say(WORDS[this.#shell.language].noWayBack);
    this.#shell.goTo({ from, to: from });
  }

  #go(before: number, { from, to }: { readonly from: number; readonly to: number }): void {
    this.#trail.push(before);
    this.#shell.goTo({ from, to });
  }

  #show(uses: UsesHelp | undefined): void {
    const isMarked = this.#uses !== undefined;
    // A number with a single use leads nowhere.
    this.#uses = uses = (uses?.places.length ?? 0) < 2 ? undefined : uses;
    const places = uses?.places ?? [];
    if (isMarked || places.length > 0) this.#shell.editor.uses = places;
    const here = this.#shell.editor.selection.from;
    const shownAs = uses === undefined ? '' : JSON.stringify([this.#shell.language, here, uses]);
    // If the content is unchanged, keep the buttons: the user may be pressing one.
    if (shownAs === this.#shownAs) return;
    this.#shownAs = shownAs;
    this.#section.hidden = uses === undefined;
    if (uses === undefined) return this.#section.replaceChildren();
    const texts = WORDS[this.#shell.language];
    const own = places.findIndex(({ from, to }) => from <= here && here <= to);
    const first = Math.max(0, Math.min(own - LISTED / 2, places.length - LISTED));
    const shown = places.slice(first, first + LISTED);
    const rest = places.length - shown.length;
    const links = shown.map((place, at) => {
      const button = make(
        'button',
        { type: 'button', className: 'use', 'aria-current': first + at === own ? 'location' : 'false' },
        make('span', { className: 'use-line' }, String(place.line)),
        make(place.defines ? 'b' : 'span', { className: 'use-text', lang: 'en' }, place.text),
      );
      button.addEventListener('click', () => this.#go(here, place));
      return make('li', {}, button);
    });
    const heading = make('h3', { className: 'at-cursor-heading' }, texts.usesOf(uses.name));
    const more = rest === 0 ? [] : [make('p', {}, uses.cut ? texts.moreThan(rest) : texts.more(rest))];
    this.#section.replaceChildren(heading, make('ul', { className: 'uses-list' }, ...links), ...more);
  }

  /** If it is already loaded, it opens synchronously, so that the next key goes into it. */
  async #open(): Promise<void> {
    const shell = this.#shell;
    // Pending edits must be part of the outline.
    shell.flush();
    const asked = shell.ask('outline', undefined);
    const cursor = shell.editor.selection.from;
    const dialog = this.#dialog ?? (await this.#load());
    if (dialog === undefined) return;
    dialog.begin();
    const outline = await asked;
    if (outline === undefined) dialog.close();
    else dialog.show(outline, cursor);
  }

  async #load(): Promise<OutlineDialog | undefined> {
    const shell = this.#shell;
    const part = await late(
      shell,
      () => import('./outline-dialog'),
      () => void this.#open(),
    );
    if (this.#dialog === undefined && part !== undefined) {
      this.#dialog = new part.OutlineDialog(shell.language, (offset) =>
        this.#go(shell.editor.selection.from, { from: offset, to: shell.editor.endOfLine(offset) }),
      );
      shell.region('dialogs').append(this.#dialog.element);
    }
    return this.#dialog;
  }

  #say(text: string): void {
    this.#shell.service('notice')(text, 'editor');
  }
}

const WORDS = words({
  en: {
    outline: 'Outline of the program',
    usesOf: (number: string) => `Places of ${number}`,
    more: (count: number) => `and ${count} more`,
    moreThan: (count: number) => `and more than ${count} more`,
    noNumber:
      'F12 goes from a sequence number, a program number or a variable to its other places. None stands at the cursor.',
    onlyHere: (number: string) => `${number} stands only here.`,
    noWayBack: 'This is where the first F12 was pressed.',
  },
  zh: {
    outline: '程序大纲',
    usesOf: (number) => `${number} 出现的位置`,
    more: (count) => `另有 ${count} 处`,
    moreThan: (count) => `另有 ${count} 处以上`,
    noNumber: 'F12 从顺序号、程序号或变量转到它的其他位置。光标处没有这样的编号。',
    onlyHere: (number) => `${number} 只在此处出现。`,
    noWayBack: '这里就是第一次按 F12 的位置。',
  },
  ru: {
    outline: 'Структура программы',
    usesOf: (number) => `Где стоит ${number}`,
    more: (count) => `и ещё ${count}`,
    moreThan: (count) => `и ещё более ${count}`,
    noNumber: 'F12 ведёт от номера кадра, номера программы или переменной к другим их местам. У курсора такого нет.',
    onlyHere: (number) => `${number} стоит только здесь.`,
    noWayBack: 'Здесь клавиша F12 была нажата в первый раз.',
  },
});
