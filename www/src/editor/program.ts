// The program: its text, and the editor once it is loaded.
//
// At first a plain text contains the program, so that it can run and be drawn without the editor, which is larger than
// the rest of the page. The editor takes over the text and its decorations later. In: the decorations; edits by panels.
// Out: the events of the editor. Must not know: the worker, or the meaning of the text.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import { COMMON } from '../dom/words';
import type { LineEnds } from '../files/line-ends';
import type { CompletionItem, Diagnostic, Fix, TextCommand, TriedValue } from '../protocol/protocol';
import type { Editor } from './editor';
import type { Access, Change, EditorEvents, LineRange, ProgramContext, Span, TextStore } from './text-store';
import { PlainProgram } from './plain-program';
import type { ProgramFile, ProgramText } from './program-text';

/** UTF-16 units to show until the editor is loaded; the user can hardly see more. */
const MAX_PLACEHOLDER_LENGTH = 20_000;
/** A line with more blanks before the cursor does not count as blank. */
const MAX_BLANKS = 200;

export class Program implements TextStore {
  /** The container of the editor. */
  readonly element = make('div', { className: 'editor', part: 'editor' });
  readonly #events: EditorEvents;
  readonly #access: Access;
  readonly #placeholder = make('pre', { className: 'waiting', tabIndex: 0, lang: 'en' });
  #store: TextStore;
  #editor: Editor | undefined;
  /** The revision of the plain text when the editor took over. */
  #plainRevision = 0;
  #language: Language;
  /** The state to pass to the editor once it is loaded. */
  #diagnostics: readonly Diagnostic[] = [];
  #hovered: Span | undefined;
  #running: Span | undefined;
  #highlightedLines: readonly LineRange[] = [];
  #shownLines: readonly LineRange[] = [];
  #focusPending = false;

  constructor(language: Language, access: Access, events: EditorEvents) {
    this.#events = events;
    this.#access = access;
    this.#language = language;
    this.#store = new PlainProgram({
      onTextChanged: (input) => {
        this.#diagnostics = [];
        events.onTextChanged(input);
      },
      onFileChanged: () => events.onFileChanged(),
    });
    this.element.append(this.#placeholder);
    this.#showPlaceholder();
  }

  /** Loads the editor and replaces the plain text. Rejected if it cannot be loaded; the next call retries. */
  async loadEditor(root: ShadowRoot): Promise<void> {
    const { Editor } = await importWithRetry(() => import('./editor'));
    const plain = this.#store;
    // A concurrent call has already done it.
    if (!(plain instanceof PlainProgram)) return;
    const focused = this.#focusPending || root.activeElement === this.#placeholder;
    const editor = new Editor(root, this.element, this.#language, this.#access, plain.state, this.#events);
    this.#plainRevision = plain.revision;
    this.#store = this.#editor = editor;
    this.#placeholder.remove();
    if (plain.selection.to > 0) editor.select(plain.selection);
    editor.diagnostics = this.#diagnostics;
    editor.hovered = this.#hovered;
    editor.running = this.#running;
    editor.highlightedLines = this.#highlightedLines;
    editor.shownLines = this.#shownLines;
    editor.flushDecorations();
    if (focused) editor.focus();
    this.#events.onViewMoved();
  }

  // ---- the text -----------------------------------------------------------------------------------

  get text(): string {
    return this.#store.text;
  }

  get textWithLineEnds(): string {
    return this.#store.textWithLineEnds;
  }

  get lineEnds(): LineEnds {
    return this.#store.lineEnds;
  }

  get length(): number {
    return this.#store.length;
  }

  get revision(): number {
    return this.#plainRevision + this.#store.revision;
  }

  get file(): ProgramFile | undefined {
    return this.#store.file;
  }

  set file(file: ProgramFile) {
    this.#store.file = file;
  }

  get selection(): Span {
    return this.#store.selection;
  }

  get cursor(): number {
    return this.#store.cursor;
  }

  textBetween(from: number, to: number): string {
    return this.#store.textBetween(from, to);
  }

  takeUnsent(): TextCommand | undefined {
    return this.#store.takeUnsent();
  }

  markAllUnsent(): void {
    this.#store.markAllUnsent();
  }

  setText(
    program: ProgramText,
    file: ProgramFile | undefined,
    undoable: 'undoable' | 'final',
    context?: ProgramContext,
  ): void {
    this.#diagnostics = [];
    this.#store.setText(program, file, undoable, context);
    this.#showPlaceholder();
  }

  rewrite(text: string): void {
    if (this.#access === 'readonly') return;
    this.#diagnostics = [];
    this.#store.rewrite(text);
    this.#showPlaceholder();
  }

  /** Whether there are changes to undo or to redo. */
  get history(): { readonly canUndo: boolean; readonly canRedo: boolean } {
    return this.#editor?.history ?? { canUndo: false, canRedo: false };
  }

  /** Undoes or redoes a change. */
  travel(direction: 'undo' | 'redo'): void {
    this.#editor?.travel(direction);
  }

  /** Inserts a text at the cursor, as if the user had typed it. */
  type(text: string): void {
    this.#editor?.type(text);
  }

  /** Replaces the line of the cursor by a proposal; its first field is selected. Rejected if a part cannot be loaded. */
  async insertProposal(proposal: CompletionItem): Promise<void> {
    this.#events.onShowProgram();
    await this.#editor?.insertProposal(proposal);
  }

  /** Goes to the next field of a proposal, like Tab. */
  async nextField(): Promise<void> {
    await this.#editor?.nextField();
  }

  /** Whether the line at an offset is blank. */
  isBlankLine(offset: number): boolean {
    const before = this.textBetween(Math.max(offset - MAX_BLANKS, 0), offset);
    const start = before.slice(before.lastIndexOf('\n') + 1);
    return start.length < MAX_BLANKS && (start + this.textBetween(offset, this.endOfLine(offset))).trim() === '';
  }

  change(edits: readonly Change[]): void {
    if (this.#access === 'readonly') return;
    this.#store.change(edits);
    this.#showPlaceholder();
  }

  /** Applies fixes, unless the text has changed since they were offered. */
  applyFixes(edits: Fix['edits']): void {
    if (this.#access === 'readonly') return;
    if (this.#editor !== undefined) this.#editor.applyFixes(edits);
    else if (this.#diagnostics.length > 0) this.change(edits);
  }

  select(span: Span): void {
    this.#store.select(span);
  }

  // ---- decorations --------------------------------------------------------------------------------

  set language(language: Language) {
    this.#language = language;
    if (this.#editor !== undefined) this.#editor.language = language;
    this.#showPlaceholder();
  }

  /** The visible lines with a margin; undefined if nothing is highlighted. */
  get visibleLines(): { firstLine: number; endLine: number } | undefined {
    return this.#editor?.visibleLines;
  }

  /** Triples `from, to, class`, sorted. */
  set tokens(triples: Uint32Array) {
    if (this.#editor !== undefined) this.#editor.tokens = triples;
  }

  set diagnostics(diagnostics: readonly Diagnostic[]) {
    this.#diagnostics = diagnostics;
    if (this.#editor !== undefined) this.#editor.diagnostics = diagnostics;
  }

  /** No further decorations of this run are expected. */
  flushDecorations(): void {
    this.#editor?.flushDecorations();
  }

  /** The values of variables that the user tries; the text is not changed. */
  get tried(): readonly TriedValue[] {
    return this.#editor?.tried ?? [];
  }

  tryValue(value: TriedValue): void {
    this.#editor?.tryValue(value);
  }

  /** Removes all tried values. */
  endTrial(): void {
    this.#editor?.endTrial();
  }

  /** The line of an offset, from 0. */
  lineOf(offset: number): number {
    return this.#editor?.lineOf(offset) ?? this.textBetween(0, offset).split('\n').length - 1;
  }

  /** The start of the line at an offset. */
  lineStart(offset: number): number {
    return this.#editor?.lineStart(offset) ?? this.textBetween(0, offset).lastIndexOf('\n') + 1;
  }

  /** The end of the line at an offset. */
  endOfLine(offset: number): number {
    const rest = this.textBetween(offset, Math.min(offset + 1000, this.length));
    const end = rest.indexOf('\n');
    return offset + (end < 0 ? rest.length : end);
  }

  /** Scrolls to the cursor, after the layout of the elements around the text. */
  scrollToCursor(): void {
    this.#editor?.scrollToCursor();
  }

  /** Announces a text to screen readers. */
  announce(text: string): void {
    this.#editor?.announce(text);
  }

  /** The block of the stroke under the pointer. */
  set hovered(span: Span | undefined) {
    this.#hovered = span;
    if (this.#editor !== undefined) this.#editor.hovered = span;
  }

  /** The lines, from 0, before which the playback pauses. */
  get breakpoints(): readonly number[] {
    return this.#editor?.breakpoints ?? [];
  }

  /** Toggles the breakpoint in the line of the cursor. Returns whether it is set now. */
  toggleBreakpoint(): boolean {
    return this.#editor?.toggleBreakpoint() ?? false;
  }

  /** The uses of the number at the cursor. */
  set uses(spans: readonly Span[]) {
    if (this.#editor !== undefined) this.#editor.uses = spans;
  }

  /** The foldable ranges: from the end of a line to the end of the last line of the range. */
  set foldable(spans: readonly Span[]) {
    if (this.#editor !== undefined) this.#editor.foldable = spans;
  }

  /** The start of the line marked as running, also after edits; undefined if no line is marked or it was removed. */
  get runningLineStart(): number | undefined {
    return this.#editor?.runningLineStart;
  }

  /** The block of the current tool position; it is kept visible. */
  set running(span: Span | undefined) {
    this.#running = span;
    if (this.#editor !== undefined) this.#editor.running = span;
  }

  /** The lines that the page highlights. */
  set highlightedLines(lines: readonly LineRange[]) {
    this.#highlightedLines = lines;
    if (this.#editor !== undefined) this.#editor.highlightedLines = lines;
  }

  /** The lines to show, the others are folded; all lines if empty. */
  set shownLines(lines: readonly LineRange[]) {
    this.#shownLines = lines;
    if (this.#editor !== undefined) this.#editor.shownLines = lines;
  }

  /** The start of a line (from 1); undefined if the text is shorter. */
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

  /** Number of lines that are not folded. */
  get rows(): number {
    return this.#editor?.rows ?? this.lineOf(this.length) + 1;
  }

  /** Scrolls to the running block, even if the user has just scrolled elsewhere. */
  followRunningBlock(): void {
    this.#editor?.followRunningBlock();
  }

  /** Selects a problem and focuses the program. */
  selectProblem(diagnostic: Diagnostic): void {
    this.select({ from: diagnostic.from, to: diagnostic.to });
    this.focus();
  }

  nextProblem(direction: 'next' | 'previous'): void {
    this.#events.onShowProgram();
    this.#editor?.nextProblem(direction);
  }

  focus(): void {
    this.#events.onShowProgram();
    this.#focusPending = this.#editor === undefined;
    this.#editor?.focus();
  }

  #showPlaceholder(): void {
    if (this.#editor !== undefined) return;
    this.#placeholder.textContent = this.textBetween(0, MAX_PLACEHOLDER_LENGTH);
    this.#placeholder.setAttribute('aria-label', COMMON[this.#language].program);
  }
}
