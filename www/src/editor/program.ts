// The program: its text, and the editor around it once there is one.
//
// A plain text holds the program at first, so that it is run and drawn without the editor, which is larger than
// all else of the page. An editor that comes later takes over the text, and all that is to be shown over it. In:
// what is shown over the text; what panels do to it. Out: the events of the editor. Must not know: the worker,
// or what the text means.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { loaded } from '../dom/network';
import { COMMON } from '../dom/words';
import type { LineEnds } from '../files/line-ends';
import type { Diagnostic, Fix, TextCommand, TriedValue } from '../protocol/protocol';
import type { Editor } from './editor';
import type { Access, Change, EditorEvents, LineRange, ProgramContext, Span, TextHolder } from './holder';
import { PlainProgram } from './plain-program';
import type { ProgramFile, ProgramText } from './program-text';

/** UTF-16 units that are shown until the editor is there: more than anybody sees. */
const SHOWN = 20_000;

export class Program implements TextHolder {
  /** Where the editor stands. */
  readonly element = make('div', { className: 'editor', part: 'editor' });
  readonly #events: EditorEvents;
  readonly #access: Access;
  readonly #waiting = make('pre', { className: 'waiting', tabIndex: 0, lang: 'en' });
  #holder: TextHolder;
  #editor: Editor | undefined;
  /** Versions of the text before the editor came. */
  #revisionsBefore = 0;
  #language: Language;
  /** What an editor is to show that comes later. */
  #diagnostics: readonly Diagnostic[] = [];
  #hovered: Span | undefined;
  #running: Span | undefined;
  #marked: readonly LineRange[] = [];
  #shownLines: readonly LineRange[] = [];
  #focusWanted = false;

  constructor(language: Language, access: Access, events: EditorEvents) {
    this.#events = events;
    this.#access = access;
    this.#language = language;
    this.#holder = new PlainProgram({
      changed: () => {
        this.#diagnostics = [];
        events.changed();
      },
      fileChanged: () => events.fileChanged(),
    });
    this.element.append(this.#waiting);
    this.#showWaiting();
  }

  /** Loads the editor and puts it in its place; rejected where it cannot be had, after which it can be tried again. */
  async edit(root: ShadowRoot): Promise<void> {
    const { Editor } = await loaded(() => import('./editor'));
    const plain = this.#holder;
    // Another call was faster.
    if (!(plain instanceof PlainProgram)) return;
    const focused = this.#focusWanted || root.activeElement === this.#waiting;
    const editor = new Editor(root, this.element, this.#language, this.#access, plain.start, this.#events);
    this.#revisionsBefore = plain.revision;
    this.#holder = this.#editor = editor;
    this.#waiting.remove();
    if (plain.selection.to > 0) editor.select(plain.selection);
    editor.diagnostics = this.#diagnostics;
    editor.hovered = this.#hovered;
    editor.running = this.#running;
    editor.marked = this.#marked;
    editor.shownLines = this.#shownLines;
    editor.showNow();
    if (focused) editor.focus();
    this.#events.viewMoved();
  }

  // ---- the text -----------------------------------------------------------------------------------

  get text(): string {
    return this.#holder.text;
  }

  get textWithLineEnds(): string {
    return this.#holder.textWithLineEnds;
  }

  get lineEnds(): LineEnds {
    return this.#holder.lineEnds;
  }

  get length(): number {
    return this.#holder.length;
  }

  get revision(): number {
    return this.#revisionsBefore + this.#holder.revision;
  }

  get file(): ProgramFile | undefined {
    return this.#holder.file;
  }

  set file(file: ProgramFile) {
    this.#holder.file = file;
  }

  get selection(): Span {
    return this.#holder.selection;
  }

  get cursor(): number {
    return this.#holder.cursor;
  }

  textBetween(from: number, to: number): string {
    return this.#holder.textBetween(from, to);
  }

  takeUnsent(): TextCommand | undefined {
    return this.#holder.takeUnsent();
  }

  unsend(): void {
    this.#holder.unsend();
  }

  setText(
    program: ProgramText,
    file: ProgramFile | undefined,
    undoable: 'undoable' | 'final',
    context?: ProgramContext,
  ): void {
    this.#diagnostics = [];
    this.#holder.setText(program, file, undoable, context);
    this.#showWaiting();
  }

  rewrite(text: string): void {
    if (this.#access === 'readonly') return;
    this.#diagnostics = [];
    this.#holder.rewrite(text);
    this.#showWaiting();
  }

  change(edits: readonly Change[]): void {
    if (this.#access === 'readonly') return;
    this.#holder.change(edits);
    this.#showWaiting();
  }

  /** Makes repairs; when the text has changed since they were offered, their places are no more. */
  apply(edits: Fix['edits']): void {
    if (this.#access === 'readonly') return;
    if (this.#editor !== undefined) this.#editor.apply(edits);
    else if (this.#diagnostics.length > 0) this.change(edits);
  }

  select(span: Span): void {
    this.#holder.select(span);
  }

  // ---- what is shown over it ----------------------------------------------------------------------

  set language(language: Language) {
    this.#language = language;
    if (this.#editor !== undefined) this.#editor.language = language;
    this.#showWaiting();
  }

  /** The lines in sight with a margin; none where nothing is coloured. */
  get linesInSight(): { firstLine: number; endLine: number } | undefined {
    return this.#editor?.linesInSight;
  }

  /** Triples `from, to, class`, in order. */
  set tokens(triples: Uint32Array) {
    if (this.#editor !== undefined) this.#editor.tokens = triples;
  }

  set diagnostics(diagnostics: readonly Diagnostic[]) {
    this.#diagnostics = diagnostics;
    if (this.#editor !== undefined) this.#editor.diagnostics = diagnostics;
  }

  /** No more is to come of this run. */
  showNow(): void {
    this.#editor?.showNow();
  }

  /** The values of variables that the reader tries; the text stays as it is. */
  get tried(): readonly TriedValue[] {
    return this.#editor?.tried ?? [];
  }

  tryValue(value: TriedValue): void {
    this.#editor?.tryValue(value);
  }

  /** Tries no value any more. */
  endTrial(): void {
    this.#editor?.endTrial();
  }

  /** The line of an offset, from 0. */
  lineOf(offset: number): number {
    return this.#editor?.lineOf(offset) ?? this.textBetween(0, offset).split('\n').length - 1;
  }

  /** Where the line of an offset ends. */
  endOfLine(offset: number): number {
    const rest = this.textBetween(offset, Math.min(offset + 1000, this.length));
    const end = rest.indexOf('\n');
    return offset + (end < 0 ? rest.length : end);
  }

  /** Scrolls to the cursor, once what stands around the text has the room it takes. */
  keepCursorInSight(): void {
    this.#editor?.keepCursorInSight();
  }

  /** Read out to those who do not see the page. */
  announce(text: string): void {
    this.#editor?.announce(text);
  }

  /** The block whose stroke the pointer is on. */
  set hovered(span: Span | undefined) {
    this.#hovered = span;
    if (this.#editor !== undefined) this.#editor.hovered = span;
  }

  /** Lines, from 0, before which the tool is held; the reader marks them. */
  get breakpoints(): readonly number[] {
    return this.#editor?.breakpoints ?? [];
  }

  /** Marks the line of the cursor to hold the tool, or takes the mark away; says which. */
  toggleBreakpoint(): boolean {
    return this.#editor?.toggleBreakpoint() ?? false;
  }

  /** Where the number at the cursor is used. */
  set uses(spans: readonly Span[]) {
    if (this.#editor !== undefined) this.#editor.uses = spans;
  }

  /** What the reader can fold: from the end of a line to the end of the last that belongs to it. */
  set foldable(spans: readonly Span[]) {
    if (this.#editor !== undefined) this.#editor.foldable = spans;
  }

  /** Where the line of that block begins, also after edits; nothing when it is not marked, or gone. */
  get runningLine(): number | undefined {
    return this.#editor?.runningLine;
  }

  /** The block the tool is in; it is kept in sight. */
  set running(span: Span | undefined) {
    this.#running = span;
    if (this.#editor !== undefined) this.#editor.running = span;
  }

  /** The lines that the page around marks. */
  set marked(lines: readonly LineRange[]) {
    this.#marked = lines;
    if (this.#editor !== undefined) this.#editor.marked = lines;
  }

  /** The lines that are shown, the others are folded; all where there are none. */
  set shownLines(lines: readonly LineRange[]) {
    this.#shownLines = lines;
    if (this.#editor !== undefined) this.#editor.shownLines = lines;
  }

  /** Where a line (from 1) begins; nothing where the text has not so many. */
  startOfLine(line: number): number | undefined {
    const text = this.text;
    let at = 0;
    for (let before = 1; before < line; before++) {
      const end = text.indexOf('\n', at);
      if (end < 0) return undefined;
      at = end + 1;
    }
    return at;
  }

  /** The block that runs comes into sight, even if the reader has just looked elsewhere. */
  follow(): void {
    this.#editor?.follow();
  }

  /** Sets the cursor down at the start of a problem and shows it. */
  show(diagnostic: Diagnostic): void {
    this.select({ from: diagnostic.from, to: diagnostic.to });
    this.focus();
  }

  nextProblem(direction: 'next' | 'previous'): void {
    this.#events.wanted();
    this.#editor?.nextProblem(direction);
  }

  focus(): void {
    this.#events.wanted();
    this.#focusWanted = this.#editor === undefined;
    this.#editor?.focus();
  }

  #showWaiting(): void {
    if (this.#editor !== undefined) return;
    this.#waiting.textContent = this.textBetween(0, SHOWN);
    this.#waiting.setAttribute('aria-label', COMMON[this.#language].program);
  }
}
