// The dialog "My programs": the list with names, times and small pictures, a search field and actions; earlier states
// of a program; export and import of all programs as one file.
//
// In: the `PageHost` and the list. Out: a program that replaces the one in the editor; changes of the list, which other
// tabs are notified of. Loaded when it is first opened. Must not know: how programs are stored.

import { Dialog } from '../dom/dialog';
import { icon, make, setAccessibleName } from '../dom/dom';
import { withTimeout } from '../dom/timeout';
import { COMMON } from '../dom/words';
import { download } from '../editor/program-files';
import type { SavedProgramList, PageHost } from './page-host';
import { askToPersist } from './own-programs-persist';
import {
  shortenName,
  toExportFile,
  LIMITS,
  matches,
  nameOf,
  parseExportFile,
  type ExportedProgram,
  type ProgramRow,
  type State,
} from './own-programs';
import * as store from './own-programs-store';
import { LIST_WORDS } from './own-programs-words';
import { smallDrawing } from './small-drawing';
import { removeFromJournal } from './storage';
import '../dom/dialog.css';
import './own-programs.css';

/** How long the database may take before the dialog reports that it does not answer. */
const ANSWER_TIMEOUT_MS = 5000;

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
  readonly #listElement = make('div', { className: 'shelf' });
  readonly #back = make('button', { type: 'button', className: 'framed' });
  readonly #export = make('button', { type: 'button', className: 'framed' });
  readonly #import = make('button', { type: 'button', className: 'framed' });
  readonly #file = make('input', { type: 'file', hidden: true, accept: '.json,application/json' });
  readonly #dialog = new Dialog(
    'own-programs',
    [this.#field, this.#found, this.#listElement, this.#file],
    [this.#back, this.#import, this.#export],
  );
  #session: SavedProgramList | undefined;
  #rows: readonly ProgramRow[] = [];
  #dates: { readonly language: string; readonly format: Intl.DateTimeFormat } | undefined;
  /** The program whose buttons are shown, and whether it is being renamed. */
  #expanded: { readonly id: string; readonly renaming: boolean } | undefined;
  /** The program whose earlier states are shown. */
  #statesOf: ProgramRow | undefined;
  /** Resolved when all requested actions have finished. */
  #queue: Promise<void> = Promise.resolve();

  constructor(host: PageHost) {
    this.#host = host;
    this.#search.addEventListener('input', () => this.#showList());
    this.#back.addEventListener('click', () => void this.#closeStates());
    this.#export.addEventListener('click', () => this.#enqueue(() => this.#exportAll()));
    this.#import.addEventListener('click', () => this.#file.click());
    this.#file.addEventListener('change', () => {
      const file = this.#file.files?.[0];
      this.#file.value = '';
      if (file !== undefined) this.#enqueue(() => this.#importFile(file));
    });
    document.body.append(this.#dialog.element);
  }

  async open(): Promise<void> {
    const texts = this.#texts;
    this.#statesOf = undefined;
    this.#expanded = undefined;
    this.#search.value = '';
    this.#caption.textContent = texts.search;
    this.#export.textContent = texts.exportAll;
    this.#import.textContent = texts.importAll;
    this.#back.textContent = texts.back;
    this.#found.textContent = '';
    this.#renderFrame();
    this.#dialog.show();
    this.#search.focus();
    await this.#runAndReport(async () => {
      this.#host.saver.host.saveNow();
      if (this.#session === undefined) {
        this.#session = await this.#host.saver.session();
        this.#session.subscribe(() => void this.#refresh());
      }
      const read = this.#session.whenWritten().then(() => this.#load());
      if ((await withTimeout(read, ANSWER_TIMEOUT_MS)) === 'timeout') this.#showOutcome(texts.notRead);
      await read;
      this.#showOutcome(undefined);
      if (this.#rows.length > 0) askToPersist();
    });
  }

  get #texts(): (typeof LIST_WORDS)['en'] {
    return LIST_WORDS[this.#host.language];
  }

  /** Renders the parts that the list and the earlier states share. */
  #renderFrame(): void {
    const texts = this.#texts;
    const of = this.#statesOf;
    this.#dialog.setTexts(
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
    if (!this.#dialog.open || this.#expanded?.renaming === true) return;
    const focused = document.activeElement?.getAttribute('data-focus');
    await this.#load().catch(() => undefined);
    if (focused !== null && focused !== undefined) this.#focus(focused);
  }

  /** Runs the actions one after the other, so that the last message is about the last action. */
  #enqueue(callback: () => Promise<void>): void {
    this.#queue = this.#queue.then(() => this.#runAndReport(callback));
  }

  /** Runs an action and reports an error. */
  async #runAndReport(callback: () => Promise<void>): Promise<void> {
    try {
      await callback();
    } catch (error) {
      this.#showOutcome(store.isFull(error) ? this.#texts.full : this.#texts.notRead);
    }
  }

  // ---- the list -----------------------------------------------------------------------------------

  #showList(): void {
    const found = this.#rows.filter((row) => matches({ ...row, name: this.#nameOf(row) }, this.#search.value.trim()));
    this.#listElement.replaceChildren(make('ul', {}, ...found.map((row) => this.#renderItem(row))));
    if (this.#found.dataset['kind'] !== 'outcome') this.#count(found.length);
  }

  #count(found: number): void {
    const texts = this.#texts;
    this.#found.textContent = this.#rows.length === 0 ? texts.none : found === 0 ? texts.noneFound : texts.count(found);
  }

  /** Shows the result of an action, or the number of programs. */
  #showOutcome(outcome: string | undefined, undo?: () => Promise<void>): void {
    if (outcome === undefined) {
      delete this.#found.dataset['kind'];
      if (this.#statesOf === undefined) this.#showList();
      else this.#found.textContent = '';
      return;
    }
    this.#found.dataset['kind'] = 'outcome';
    this.#found.textContent = outcome;
    if (undo === undefined) return;
    const button = make('button', { type: 'button', className: 'link', 'data-focus': 'undo' }, this.#texts.undo);
    button.addEventListener('click', () => this.#enqueue(undo));
    this.#found.append(button);
  }

  #nameOf({ name }: Pick<ProgramRow, 'name'>): string {
    return name === '' ? this.#texts.noName : name;
  }

  #renderItem(row: ProgramRow): HTMLElement {
    const name = this.#nameOf(row);
    const isCurrent = row.id === this.#host.saver.id;
    const when = `${this.#formatDate(row.changed)}${isCurrent ? ` · ${this.#texts.here}` : ''}`;
    const card = make('button', { type: 'button', className: 'card', 'data-focus': `open:${row.id}` });
    card.append(
      smallDrawing(row.picture),
      make('span', { className: 'title' }, name),
      make('span', { className: 'when' }, when),
    );
    card.addEventListener('click', () => this.#enqueue(() => this.#open(row.id)));
    const isExpanded = this.#expanded?.id === row.id;
    const more = make(
      'button',
      { type: 'button', className: 'more-of', 'aria-expanded': String(isExpanded), 'data-focus': `more:${row.id}` },
      icon('more'),
    );
    setAccessibleName(more, this.#texts.more(name));
    more.addEventListener('click', () => {
      this.#expanded = isExpanded ? undefined : { id: row.id, renaming: false };
      this.#showList();
      this.#focus(`more:${row.id}`);
    });
    const item = make('li', {}, card, more);
    if (isCurrent) item.dataset['here'] = '';
    if (isExpanded) item.append(this.#renderActions(row));
    return item;
  }

  #renderActions(row: ProgramRow): HTMLElement {
    const { actions } = this.#texts;
    const button = (text: string, callback: () => void): HTMLElement => {
      const made = make('button', { type: 'button', className: 'small framed' }, text);
      made.addEventListener('click', callback);
      return made;
    };
    if (this.#expanded?.renaming === true) return make('div', { className: 'acts' }, this.#renderRenaming(row));
    return make(
      'div',
      { className: 'acts' },
      button(actions.rename, () => {
        this.#expanded = { id: row.id, renaming: true };
        this.#showList();
        this.#listElement.querySelector<HTMLInputElement>('form input')?.select();
      }),
      button(actions.duplicate, () => this.#enqueue(() => this.#duplicate(row))),
      button(actions.states, () => this.#enqueue(() => this.#showStates(row))),
      button(actions.delete, () => this.#enqueue(() => this.#delete(row))),
    );
  }

  #renderRenaming(row: ProgramRow): HTMLElement {
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
      make('button', { type: 'submit', className: 'small framed' }, texts.confirmRename),
    );
    const endRenaming = async (): Promise<void> => {
      this.#expanded = { id: row.id, renaming: false };
      await this.#load();
      this.#focus(`more:${row.id}`);
    };
    // Escape closes the field, not the dialog.
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      void endRenaming();
    });
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#enqueue(async () => {
        await store.rename(row.id, shortenName(input.value), (program) =>
          nameOf(program, this.#host.saver.host.titleOf(program.example)),
        );
        await endRenaming();
        this.#session?.changed({ kind: 'list' });
      });
    });
    return form;
  }

  async #open(id: string): Promise<void> {
    const [row, program] = await Promise.all([store.readRow(id), store.readProgram(id)]);
    if (row === undefined || program === undefined) return this.#load();
    this.#dialog.close();
    if (id === this.#host.saver.id) return;
    await this.#host.show({ ...program, id });
    this.#session?.noteRevision(row);
  }

  async #duplicate(row: ProgramRow): Promise<void> {
    const copy = await store.duplicate(row.id);
    if (copy === 'too-many') return this.#showOutcome(this.#texts.tooMany);
    this.#expanded = undefined;
    await this.#load();
    if (copy === undefined) return;
    this.#focus(`more:${copy.id}`);
    this.#session?.changed({ kind: 'list' });
  }

  async #delete(row: ProgramRow): Promise<void> {
    const deleted = await store.deleteProgram(row.id);
    removeFromJournal(row.id);
    this.#expanded = undefined;
    this.#session?.changed({ kind: 'deleted', id: row.id });
    await this.#load();
    if (deleted === undefined) return;
    this.#showOutcome(this.#texts.deleted(this.#nameOf(row)), () => this.#restoreDeleted(deleted));
    this.#focus('undo');
  }

  async #restoreDeleted(deleted: ExportedProgram): Promise<void> {
    await store.addPrograms([deleted]);
    this.#showOutcome(undefined);
    this.#session?.changed({ kind: 'list' });
    await this.#load();
    this.#focus(`more:${deleted.id}`);
  }

  // ---- earlier states -----------------------------------------------------------------------------

  async #showStates(row: ProgramRow): Promise<void> {
    const states = await store.readStates(row.id);
    const texts = this.#texts;
    this.#statesOf = row;
    this.#renderFrame();
    this.#showOutcome(undefined);
    if (states.length === 0) this.#found.textContent = texts.noStates;
    this.#listElement.replaceChildren(make('ul', {}, ...states.map((state) => this.#renderState(row, state))));
    this.#back.focus();
  }

  #renderState(row: ProgramRow, state: State): HTMLElement {
    const when = this.#formatDate(state.time);
    const restore = make(
      'button',
      { type: 'button', 'aria-label': `${this.#texts.restore}: ${when}` },
      this.#texts.restore,
    );
    restore.addEventListener('click', () => this.#enqueue(() => this.#restore(row, state)));
    return make(
      'li',
      { className: 'state' },
      make('span', {}, when, make('span', { className: 'when' }, this.#texts.length(state.length))),
      restore,
    );
  }

  /** Restores an earlier state; the current text becomes an earlier state itself. */
  async #restore({ id }: ProgramRow, state: State): Promise<void> {
    this.#host.saver.host.saveNow();
    await this.#session?.whenWritten();
    const program = await store.restoreState(id, state);
    const row = await store.readRow(id);
    if (program === undefined || row === undefined) return this.#showOutcome(this.#texts.notRead);
    this.#dialog.close();
    this.#session?.noteRevision(row);
    this.#session?.changed({ kind: 'changed', id, revision: row.revision });
    await this.#host.show({ ...program, id });
  }

  async #closeStates(): Promise<void> {
    const of = this.#statesOf;
    this.#statesOf = undefined;
    this.#renderFrame();
    await this.#runAndReport(() => this.#load());
    this.#showOutcome(undefined);
    if (of !== undefined) this.#focus(`more:${of.id}`);
  }

  // ---- files --------------------------------------------------------------------------------------

  async #exportAll(): Promise<void> {
    const day = new Date().toISOString().slice(0, 10);
    download(`gcode-programs-${day}.json`, new TextEncoder().encode(toExportFile(await store.readAll())));
  }

  async #importFile(file: File): Promise<void> {
    const texts = this.#texts;
    if (file.size > LIMITS.file) return this.#showOutcome(texts.wrongFile['too-large']);
    const parsed = parseExportFile(await file.text());
    if (parsed.kind !== 'programs') return this.#showOutcome(texts.wrongFile[parsed.kind]);
    const { added, duplicates, noRoom } = await store.addPrograms(parsed.programs);
    await this.#load();
    const more = [
      noRoom === 0 ? '' : texts.noRoom(noRoom),
      parsed.unreadable === 0 ? '' : texts.unreadable(parsed.unreadable),
    ];
    this.#showOutcome(`${texts.imported(texts.count(added), duplicates)}${more.join('')}`);
    this.#session?.changed({ kind: 'list' });
  }

  // ---- helpers ------------------------------------------------------------------------------------

  #formatDate(time: number): string {
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
