// The dialog in which stock, tools, start, machine and tailstock are said, and where that is kept.
//
// In: the groups of fields, and answers to what is entered: both the interpreter's, labels and messages in words. Out:
// `read` and `another` (questions), `kept` (the reader has applied it).
// Must not know: what a field is for, or which values it can have.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { SetupAnswer, SetupForm, SetupGroup, SetupPlace } from '../protocol/protocol';
import { SetupInput } from './setup-input';

/** What is typed quickly is asked about together. */
const ASK_AFTER_MS = 80;

export interface SetupEntries {
  readonly keys: readonly string[];
  readonly texts: readonly string[];
  readonly keep: SetupPlace;
}

export interface SetupFormEvents {
  read(entries: SetupEntries): Promise<SetupAnswer | undefined>;
  another(word: string): Promise<SetupGroup | undefined>;
  kept(answer: SetupAnswer, place: SetupPlace): void;
}

/** Groups that are seldom filled in are folded. */
const FOLDED: ReadonlySet<SetupGroup['group']> = new Set(['start', 'machine', 'tailstock', 'control', 'rules']);

export class SetupDialog {
  readonly #events: SetupFormEvents;
  readonly #groups = make('div', { className: 'groups' });
  readonly #place = make('fieldset', { className: 'place-of-setup' });
  readonly #moves = make('p', { className: 'moves' });
  readonly #form = make('form', { id: 'setup-form', className: 'text', noValidate: true });
  readonly #apply = make('button', { type: 'submit', className: 'framed apply' });
  readonly #news = make('p', { className: 'slips', role: 'status' });
  readonly #word = make('input', { type: 'text', autocomplete: 'off', spellcheck: false, size: 8, id: 'another-tool' });
  readonly #add = make('button', { type: 'button', className: 'framed' });
  readonly #noTool = make('p', { className: 'slip', id: 'another-tool-slip', hidden: true });
  readonly #dialog: Dialog;
  #strings: Strings;
  #inputs: SetupInput[] = [];
  /** The first field of each group. */
  readonly #first = new Map<SetupGroup['group'] | undefined, SetupInput>();
  #wasIn: SetupPlace = 'page';
  #keep: SetupPlace = 'page';
  #asking: ReturnType<typeof setTimeout> | undefined;
  #asked = 0;

  constructor(strings: Strings, events: SetupFormEvents) {
    this.#strings = strings;
    this.#events = events;
    this.#apply.setAttribute('form', 'setup-form');
    this.#form.append(this.#groups);
    this.#dialog = new Dialog('setup', [this.#form, this.#place], [this.#news, this.#apply]);
    this.#form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#submit();
    });
    this.#add.addEventListener('click', () => void this.#another());
    this.#word.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter') return;
      event.preventDefault();
      void this.#another();
    });
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.#dialog.name(strings.setup.setup, strings.close);
    this.#dialog.about = strings.setup.about;
    this.#apply.textContent = strings.setup.apply;
    this.#add.textContent = strings.setup.add;
    this.#word.placeholder = strings.setup.anotherHint;
    this.#noTool.textContent = strings.setup.noTool;
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /** `opened`: the group the reader comes for. */
  show({ groups, place }: SetupForm, opened?: SetupGroup['group']): void {
    this.#wasIn = this.#keep = place;
    this.#inputs = [];
    this.#first.clear();
    this.#word.value = '';
    this.#noTool.hidden = true;
    const texts = this.#strings.setup;
    const another = make(
      'div', { className: 'another' },
      make('label', { htmlFor: 'another-tool' }, texts.another), this.#word, this.#add, this.#noTool,
    );
    const elements = groups.map((group) => this.#group(group, opened));
    // Behind the last tool, or the stock.
    const last = groups.findLastIndex(({ group }) => group === 'tool' || group === 'stock');
    elements.splice(last + 1, 0, another);
    this.#groups.replaceChildren(...elements);
    this.#showPlace();
    this.#news.textContent = '';
    this.#dialog.show();
    this.#form.scrollTop = 0;
    (this.#first.get(opened) ?? this.#inputs[0])?.focus();
    void this.#ask();
  }

  // ---- building -----------------------------------------------------------------------------------

  #group({ group, title, source, fields }: SetupGroup, opened?: SetupGroup['group']): HTMLElement {
    const texts = this.#strings.setup;
    const inputs = fields.map((field) => new SetupInput(field, texts, () => this.#changed()));
    this.#inputs.push(...inputs);
    if (inputs[0] !== undefined) this.#first.set(group, inputs[0]);
    const clear = make('button', { type: 'button', className: 'quiet clear', 'aria-label': texts.clear(title) }, texts.clearShort);
    clear.addEventListener('click', () => {
      for (const input of inputs) input.text = '';
      inputs[0]?.focus();
      this.#changed();
    });
    const grid = make('div', { className: 'fields' }, ...inputs.map(({ element }) => element));
    const from = make('span', { className: `source ${source}` }, texts.source[source]);
    if (FOLDED.has(group)) {
      const summary = make('summary', {}, make('span', { className: 'group-title' }, title), from);
      return make('details', { className: 'group', open: source !== 'nobody' || group === opened }, summary, grid, clear);
    }
    const legend = make('div', { className: 'group-head' }, make('h3', { className: 'group-title' }, title), from, clear);
    const section = make('section', { className: 'group', 'aria-label': title }, legend, grid);
    return section;
  }

  #showPlace(): void {
    const texts = this.#strings.setup;
    const choice = (place: SetupPlace, text: string): HTMLElement => {
      const radio = make('input', { type: 'radio', name: 'place', value: place, checked: this.#keep === place });
      radio.addEventListener('change', () => {
        this.#keep = place;
        this.#showMoves();
      });
      return make('label', {}, radio, text);
    };
    this.#place.replaceChildren(
      make('legend', {}, texts.keep),
      choice('program', texts.keepInProgram),
      choice('page', texts.keepOnPage),
      this.#moves,
    );
    this.#showMoves();
  }

  #showMoves(): void {
    const texts = this.#strings.setup;
    this.#moves.textContent = this.#wasIn === 'program' && this.#keep === 'page' ? texts.willMove : texts.programFirst;
  }

  // ---- asking -------------------------------------------------------------------------------------

  #changed(): void {
    clearTimeout(this.#asking);
    this.#asking = setTimeout(() => void this.#ask(), ASK_AFTER_MS);
  }

  /** Shows what becomes of the entries as they are; only the newest answer counts. */
  async #ask(): Promise<SetupAnswer | undefined> {
    clearTimeout(this.#asking);
    const asked = ++this.#asked;
    const answer = await this.#events.read({
      keys: this.#inputs.map(({ key }) => key),
      texts: this.#inputs.map(({ text }) => text),
      keep: this.#keep,
    });
    if (answer === undefined || asked !== this.#asked) return undefined;
    const states = new Map(answer.fields.map((state) => [state.key, state]));
    for (const input of this.#inputs) input.state = states.get(input.key);
    const wrong = answer.fields.filter(({ slip }) => slip !== undefined).length;
    const news = wrong === 0 ? '' : this.#strings.setup.slips(wrong);
    if (this.#news.textContent !== news) this.#news.textContent = news;
    return answer;
  }

  async #submit(): Promise<void> {
    const keep = this.#keep;
    const answer = await this.#ask();
    if (answer === undefined) return;
    const slip = answer.fields.find((state) => state.slip !== undefined);
    if (slip !== undefined) {
      this.#inputs.find(({ key }) => key === slip.key)?.focus();
      return;
    }
    this.#dialog.close();
    this.#events.kept(answer, keep);
  }

  async #another(): Promise<void> {
    const group = await this.#events.another(this.#word.value);
    this.#noTool.hidden = group !== undefined;
    if (group === undefined) {
      this.#word.focus();
      return;
    }
    const known = this.#inputs.find(({ key }) => key === group.fields[0]?.key);
    if (known === undefined) this.#word.closest('.another')?.before(this.#group(group));
    this.#word.value = '';
    this.#inputs.find(({ key }) => key === group.fields[0]?.key)?.focus();
    void this.#ask();
  }
}
