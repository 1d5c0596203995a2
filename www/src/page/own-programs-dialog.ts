// The dialog "My programs": the list with names, times and small pictures, a search field and actions; earlier states
// of a program; export and import of all programs as one file.
//
// In: the `PageHost` and the list. Out: a program that replaces the one in the editor; changes of the list, which other
// tabs are notified of. Loaded when it is first opened. Must not know: how programs are stored.

import { Dialog } from '../dom/dialog';
import { icon, make, name as nameButton } from '../dom/dom';
import { inTime } from '../dom/in-time';
import { COMMON } from '../dom/words';
import { download } from '../editor/program-files';
import type { KeptList, PageHost } from './page-host';
import { askToPersist } from './own-programs-persist';
import {
  cut,
  fileOf,
  LIMITS,
  matches,
  nameOf,
  readFile,
  type FiledProgram,
  type Listed,
  type State,
} from './own-programs';
import * as store from './own-programs-store';
import { LIST_WORDS } from './own-programs-words';
import { smallDrawing } from './small-drawing';
import { forgetAllOf } from './storage';
import './own-programs.css';

/** How long the database may take before the dialog reports that it does not answer. */
const NO_ANSWER_MS = 5000;

let dialog: OwnProgramsDialog | undefined;

export function openOwnPrograms(host: PageHost): void {
  dialog ??= new OwnProgramsDialog(host);
  void dialog.open();
}

class OwnProgramsDialog {
  readonly #host: PageHost;
  readonly #caption = make('span');
  readonly #search = make('input', { type: 'search', autocomplete: 'off', spellcheck: false });
  readonly #field = make('label', { className: 'search' }, this.#caption, this.#search);
  readonly #found = make('p', { className: 'found', role: 'status' });
  readonly #shelf = make('div', { className: 'shelf' });
  readonly #back = make('button', { type: 'button' });
  readonly #export = make('button', { type: 'button' });
  readonly #import = make('button', { type: 'button' });
  readonly #file = make('input', { type: 'file', hidden: true, accept: '.json,application/json' });
  readonly #dialog = new Dialog(
    'own-programs',
    [this.#field, this.#found, this.#shelf, this.#file],
    [this.#back, this.#import, this.#export],
  );
  #session: KeptList | undefined;
  #rows: readonly Listed[] = [];
  #dates: { readonly language: string; readonly format: Intl.DateTimeFormat } | undefined;
  /** The program whose buttons are shown, and whether it is being renamed. */
  #acting: { readonly id: string; readonly renaming: boolean } | undefined;
  /** The program whose earlier states are shown. */
  #statesOf: Listed | undefined;
  /** Resolved when all requested actions have finished. */
  #asked: Promise<void> = Promise.resolve();

  constructor(host: PageHost) {
    this.#host = host;
    this.#search.addEventListener('input', () => this.#showList());
    this.#back.addEventListener('click', () => void this.#leaveStates());
    this.#export.addEventListener('click', () => this.#inTurn(() => this.#exportAll()));
    this.#import.addEventListener('click', () => this.#file.click());
    this.#file.addEventListener('change', () => {
      const file = this.#file.files?.[0];
      this.#file.value = '';
      if (file !== undefined) this.#inTurn(() => this.#importFile(file));
    });
    document.body.append(this.#dialog.element);
  }

  async open(): Promise<void> {
    const texts = this.#texts;
    this.#statesOf = undefined;
    this.#acting = undefined;
    this.#search.value = '';
    this.#caption.textContent = texts.search;
    this.#export.textContent = texts.exportAll;
    this.#import.textContent = texts.importAll;
    this.#back.textContent = texts.back;
    this.#found.textContent = '';
    this.#frame();
    this.#dialog.show();
    this.#search.focus();
    await this.#try(async () => {
      this.#host.keeping.host.keepNow();
      if (this.#session === undefined) {
        this.#session = await this.#host.keeping.session();
        this.#session.follow(() => void this.#refresh());
      }
      const read = this.#session.written().then(() => this.#load());
      if ((await inTime(read, NO_ANSWER_MS)) === 'late') this.#say(texts.notRead);
      await read;
      this.#say(undefined);
      if (this.#rows.length > 0) askToPersist();
    });
  }

  get #texts(): (typeof LIST_WORDS)['en'] {
    return LIST_WORDS[this.#host.language];
  }

  /** Renders the parts that the list and the earlier states share. */
  #frame(): void {
    const texts = this.#texts;
    const of = this.#statesOf;
    this.#dialog.name(
      of === undefined ? texts.title : texts.statesOf(this.#nameOf(of)),
      COMMON[this.#host.language].close,
    );
    this.#dialog.about = of === undefined ? texts.about : texts.statesAbout;
    this.#field.hidden = this.#import.hidden = this.#export.hidden = of !== undefined;
    this.#back.hidden = of === undefined;
  }

  async #load(): Promise<void> {
    this.#rows = await store.listPrograms();
    this.#export.disabled = this.#rows.length === 0;
    if (this.#statesOf === undefined) this.#showList();
  }

  /** Reloads after a change of the list and restores the focus. */
  async #refresh(): Promise<void> {
    if (!this.#dialog.open || this.#acting?.renaming === true) return;
    const focused = document.activeElement?.getAttribute('data-focus');
    await this.#load().catch(() => undefined);
    if (focused !== null && focused !== undefined) this.#focus(focused);
  }

  /** Runs the actions one after the other, so that the last message is about the last action. */
  #inTurn(act: () => Promise<void>): void {
    this.#asked = this.#asked.then(() => this.#try(act));
  }

  /** Runs an action and reports an error. */
  async #try(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.#say(store.isFull(error) ? this.#texts.full : this.#texts.notRead);
    }
  }

  // ---- the list -----------------------------------------------------------------------------------

  #showList(): void {
    const found = this.#rows.filter((row) => matches({ ...row, name: this.#nameOf(row) }, this.#search.value.trim()));
    this.#shelf.replaceChildren(make('ul', {}, ...found.map((row) => this.#item(row))));
    if (this.#found.dataset['kind'] !== 'outcome') this.#count(found.length);
  }

  #count(found: number): void {
    const texts = this.#texts;
    this.#found.textContent = this.#rows.length === 0 ? texts.none : found === 0 ? texts.noneFound : texts.count(found);
  }

  /** Shows the result of an action, or the number of programs. */
  #say(outcome: string | undefined, undo?: () => Promise<void>): void {
    if (outcome === undefined) {
      delete this.#found.dataset['kind'];
      if (this.#statesOf === undefined) this.#showList();
      else this.#found.textContent = '';
      return;
    }
    this.#found.dataset['kind'] = 'outcome';
    this.#found.textContent = outcome;
    if (undo === undefined) return;
    const button = make('button', { type: 'button', 'data-focus': 'undo' }, this.#texts.undo);
    button.addEventListener('click', () => this.#inTurn(undo));
    this.#found.append(button);
  }

  #nameOf({ name }: Pick<Listed, 'name'>): string {
    return name === '' ? this.#texts.noName : name;
  }

  #item(row: Listed): HTMLElement {
    const name = this.#nameOf(row);
    const isHere = row.id === this.#host.keeping.id;
    const when = `${this.#date(row.changed)}${isHere ? ` · ${this.#texts.here}` : ''}`;
    const card = make('button', { type: 'button', className: 'card', 'data-focus': `open:${row.id}` });
    card.append(
      smallDrawing(row.picture),
      make('span', { className: 'title' }, name),
      make('span', { className: 'when' }, when),
    );
    card.addEventListener('click', () => this.#inTurn(() => this.#open(row.id)));
    const isActing = this.#acting?.id === row.id;
    const more = make(
      'button',
      { type: 'button', className: 'more-of', 'aria-expanded': String(isActing), 'data-focus': `more:${row.id}` },
      icon('more'),
    );
    nameButton(more, this.#texts.more(name));
    more.addEventListener('click', () => {
      this.#acting = isActing ? undefined : { id: row.id, renaming: false };
      this.#showList();
      this.#focus(`more:${row.id}`);
    });
    const item = make('li', {}, card, more);
    if (isHere) item.dataset['here'] = '';
    if (isActing) item.append(this.#acts(row));
    return item;
  }

  #acts(row: Listed): HTMLElement {
    const { acts } = this.#texts;
    const button = (text: string, act: () => void): HTMLElement => {
      const made = make('button', { type: 'button' }, text);
      made.addEventListener('click', act);
      return made;
    };
    if (this.#acting?.renaming === true) return make('div', { className: 'acts' }, this.#renaming(row));
    return make(
      'div',
      { className: 'acts' },
      button(acts.rename, () => {
        this.#acting = { id: row.id, renaming: true };
        this.#showList();
        this.#shelf.querySelector<HTMLInputElement>('form input')?.select();
      }),
      button(acts.duplicate, () => this.#inTurn(() => this.#duplicate(row))),
      button(acts.states, () => this.#inTurn(() => this.#showStates(row))),
      button(acts.delete, () => this.#inTurn(() => this.#delete(row))),
    );
  }

  #renaming(row: Listed): HTMLElement {
    const texts = this.#texts;
    const input = make('input', {
      type: 'text',
      value: row.name,
      maxLength: LIMITS.name,
      autocomplete: 'off',
      spellcheck: false,
    });
    const form = make(
      'form',
      {},
      make('label', { className: 'search' }, texts.newName, input),
      make('button', { type: 'submit' }, texts.take),
    );
    const leave = async (): Promise<void> => {
      this.#acting = { id: row.id, renaming: false };
      await this.#load();
      this.#focus(`more:${row.id}`);
    };
    // Escape closes the field, not the dialog.
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      void leave();
    });
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#inTurn(async () => {
        await store.rename(row.id, cut(input.value), (program) =>
          nameOf(program, this.#host.keeping.host.titleOf(program.example)),
        );
        await leave();
        this.#session?.changed({ kind: 'list' });
      });
    });
    return form;
  }

  async #open(id: string): Promise<void> {
    const [row, program] = await Promise.all([store.listed(id), store.programOf(id)]);
    if (row === undefined || program === undefined) return this.#load();
    this.#dialog.close();
    if (id === this.#host.keeping.id) return;
    await this.#host.show({ ...program, id });
    this.#session?.knows(row);
  }

  async #duplicate(row: Listed): Promise<void> {
    const copy = await store.duplicate(row.id);
    if (copy === 'too-many') return this.#say(this.#texts.tooMany);
    this.#acting = undefined;
    await this.#load();
    if (copy === undefined) return;
    this.#focus(`more:${copy.id}`);
    this.#session?.changed({ kind: 'list' });
  }

  async #delete(row: Listed): Promise<void> {
    const whole = await store.deleteProgram(row.id);
    forgetAllOf(row.id);
    this.#acting = undefined;
    this.#session?.changed({ kind: 'deleted', id: row.id });
    await this.#load();
    if (whole === undefined) return;
    this.#say(this.#texts.deleted(this.#nameOf(row)), () => this.#putBack(whole));
    this.#focus('undo');
  }

  async #putBack(whole: FiledProgram): Promise<void> {
    await store.addPrograms([whole]);
    this.#say(undefined);
    this.#session?.changed({ kind: 'list' });
    await this.#load();
    this.#focus(`more:${whole.id}`);
  }

  // ---- earlier states -----------------------------------------------------------------------------

  async #showStates(row: Listed): Promise<void> {
    const states = await store.statesOf(row.id);
    const texts = this.#texts;
    this.#statesOf = row;
    this.#frame();
    this.#say(undefined);
    if (states.length === 0) this.#found.textContent = texts.noStates;
    this.#shelf.replaceChildren(make('ul', {}, ...states.map((state) => this.#state(row, state))));
    this.#back.focus();
  }

  #state(row: Listed, state: State): HTMLElement {
    const when = this.#date(state.time);
    const restore = make(
      'button',
      { type: 'button', 'aria-label': `${this.#texts.restore}: ${when}` },
      this.#texts.restore,
    );
    restore.addEventListener('click', () => this.#inTurn(() => this.#restore(row, state)));
    return make(
      'li',
      { className: 'state' },
      make('span', {}, when, make('span', { className: 'when' }, this.#texts.length(state.length))),
      restore,
    );
  }

  /** Restores an earlier state; the current text becomes an earlier state itself. */
  async #restore({ id }: Listed, state: State): Promise<void> {
    this.#host.keeping.host.keepNow();
    await this.#session?.written();
    const program = await store.restoreState(id, state);
    const row = await store.listed(id);
    if (program === undefined || row === undefined) return this.#say(this.#texts.notRead);
    this.#dialog.close();
    this.#session?.knows(row);
    this.#session?.changed({ kind: 'changed', id, revision: row.revision });
    await this.#host.show({ ...program, id });
  }

  async #leaveStates(): Promise<void> {
    const of = this.#statesOf;
    this.#statesOf = undefined;
    this.#frame();
    await this.#try(() => this.#load());
    this.#say(undefined);
    if (of !== undefined) this.#focus(`more:${of.id}`);
  }

  // ---- files --------------------------------------------------------------------------------------

  async #exportAll(): Promise<void> {
    const day = new Date().toISOString().slice(0, 10);
    download(`gcode-programs-${day}.json`, new TextEncoder().encode(fileOf(await store.everything())));
  }

  async #importFile(file: File): Promise<void> {
    const texts = this.#texts;
    if (file.size > LIMITS.file) return this.#say(texts.wrongFile['too-large']);
    const read = readFile(await file.text());
    if (read.kind !== 'programs') return this.#say(texts.wrongFile[read.kind]);
    const { added, alreadyThere, noRoom } = await store.addPrograms(read.programs);
    await this.#load();
    const more = [
      noRoom === 0 ? '' : texts.noRoom(noRoom),
      read.unreadable === 0 ? '' : texts.unreadable(read.unreadable),
    ];
    this.#say(`${texts.imported(texts.count(added), alreadyThere)}${more.join('')}`);
    this.#session?.changed({ kind: 'list' });
  }

  // ---- helpers ------------------------------------------------------------------------------------

  #date(time: number): string {
    const { language } = this.#host;
    // Cached: constructing one takes some milliseconds.
    if (this.#dates?.language !== language)
      this.#dates = {
        language,
        format: new Intl.DateTimeFormat(language, { dateStyle: 'medium', timeStyle: 'medium' }),
      };
    return this.#dates.format.format(time);
  }

  #focus(name: string): void {
    for (const element of this.#dialog.element.querySelectorAll<HTMLElement>('[data-focus]')) {
      if (element.dataset['focus'] === name) element.focus();
    }
  }
}
