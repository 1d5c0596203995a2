// The program editor: CodeMirror 6 with the interpreter's highlighting and messages.
//
// In: text, tokens, diagnostics, blocks to mark. Out, only for actions of the user and not for changes by the page:
// `onTextChanged`, `onCursorMoved`, and `onContextChanged` if it is another program. Also `onViewMoved` when other
// lines become visible, and `onFileChanged` when the text belongs to another file, even by undo. Loaded by
// `program.ts`, together with CodeMirror. Must not know: the language it edits.

import {
  defaultKeymap,
  history,
  historyKeymap,
  isolateHistory,
  redo,
  redoDepth,
  undo,
  undoDepth,
} from '@codemirror/commands';
import { bracketMatching } from '@codemirror/language';
import { linter, nextDiagnostic, previousDiagnostic, setDiagnostics } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import {
  Annotation,
  Compartment,
  EditorState,
  Transaction,
  type Extension,
  type StateEffect,
  type TransactionSpec,
} from '@codemirror/state';
import {
  drawSelection,
  dropCursor,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  keymap,
  tooltips,
  type ViewUpdate,
  placeholder,
} from '@codemirror/view';
import { breakpoints, breakpointsOf, toggleBreakpoint } from './breakpoints';
import { applyFix, areShown, lintDiagnostics } from './lint';
import { folding, showFoldable } from './folding';
import { foldAllExcept, initialFolds, unfoldAt } from './initial-folds';
import { marks, runningLineStart, showHovered, showMarked, showRunning, showTokens, showUses } from './marks';
import { contextEffect, contextOf, programContext } from './context';
import { docOf, fileOf, fileOfText, lineEndsIn, setOriginEffect, renameEffect, textWithLineEnds } from './file';
import { Follower } from './follow';
import { inputOf } from './input';
import { keepCaretInView } from './keep-caret-in-view';
import type {
  Access,
  Change,
  EditorEvents,
  LineRange,
  ProgramContext,
  Span,
  InitialState,
  TextStore,
} from './text-store';
import { editorPhrases } from './phrases';
import { announceProblem } from './problem-announcement';
import { problemGutter } from './problem-gutter';
import { programText, type ProgramFile, type ProgramText } from './program-text';
import { endTrial, triedOf, triedValues, tryValue } from './tried';
import { wordHover } from './word-hover';
import { editorTheme } from './theme';
import type { Language } from '../dom/language';
import type { LineEnds } from '../files/line-ends';
import { make } from '../dom/dom';
import { importWithRetry } from '../dom/network';
import { COMMON, words } from '../dom/words';
import type { CompletionItem, Diagnostic, Fix, TextCommand, TriedValue } from '../protocol/protocol';
import { Unsent } from './unsent';

/**
 * Tokens are also requested for this many lines above and below the visible ones, so that slow scrolling needs no new
 * request.
 */
const MARGIN_LINES = 60;
/** A longer range (a file without line ends) gets no colours. */
const HIGHLIGHT_LIMIT = 200_000;
/** Tokens and diagnostics of a run usually arrive within this time of each other; the delay is not noticeable. */
const UPDATE_DELAY_MS = 25;

/** Marks a change that was made by the page, not by the user. */
const byPage = Annotation.define<true>();

export class Editor implements TextStore {
  readonly #view: EditorView;
  readonly #follower: Follower;
  readonly #events: EditorEvents;
  readonly #language = new Compartment();
  /** Empty until completion is loaded, when the user first enters the text. */
  readonly #completion = new Compartment();
  #isCompletionLoading = false;
  readonly #access: Access;
  /** The lines that are not folded; folded again after each text that the page sets. */
  #shownLines: readonly LineRange[] = [];
  #uiLanguage: Language;
  #diagnostics: readonly Diagnostic[] = [];
  /** Decorations for the next update. */
  #pendingDecorations: { tokens?: Uint32Array; diagnostics?: readonly Diagnostic[] } = {};
  #updateTimer: ReturnType<typeof setTimeout> | undefined;
  /** Incremented with each change of the text. */
  #revision = 0;
  readonly #unsent: Unsent;

  constructor(
    root: ShadowRoot,
    parent: HTMLElement,
    language: Language,
    access: Access,
    start: InitialState,
    events: EditorEvents,
  ) {
    const { program, file, unsent } = start;
    this.#events = events;
    this.#uiLanguage = language;
    this.#access = access;
    this.#unsent = new Unsent(unsent);
    // Not on the window: WebKit would move tooltips there after showing them. Not in the frame, which would clip them.
    const tooltipParent = make('div', { className: 'own' });
    root.append(tooltipParent);
    this.#view = new EditorView({
      parent,
      root,
      state: EditorState.create({
        doc: docOf(program),
        extensions: [
          breakpoints,
          problemGutter(),
          highlightActiveLine(),
          highlightActiveLineGutter(),
          highlightSpecialChars(),
          history(),
          fileOfText(program.ends, file),
          programContext(events),
          drawSelection(),
          dropCursor(),
          bracketMatching(),
          highlightSelectionMatches(),
          search({ top: false }),
          linter(null),
          tooltips({ position: 'absolute', parent: tooltipParent }),
          marks,
          editorTheme,
          initialFolds(() => this.#uiLanguage),
          folding(() => this.#uiLanguage),
          keepCaretInView,
          triedValues(() => this.#uiLanguage),
          wordHover(events, () => this.#uiLanguage),
          this.#completion.of([]),
          EditorState.readOnly.of(access === 'readonly'),
          EditorView.editable.of(access === 'editable'),
          // Tab is not bound, so it leaves the editor.
          keymap.of([
            { key: 'F8', run: () => this.nextProblem('next'), shift: () => this.nextProblem('previous') },
            ...searchKeymap,
            ...historyKeymap,
            ...defaultKeymap,
          ]),
          this.#language.of(this.#languageExtension(language)),
          EditorView.updateListener.of((update) => this.#onUpdate(update)),
        ],
      }),
    });
    this.#follower = new Follower(this.#view);
  }

  get text(): string {
    return this.#view.state.doc.toString();
  }

  textBetween(from: number, to: number): string {
    return this.#view.state.sliceDoc(from, to);
  }

  get textWithLineEnds(): string {
    return textWithLineEnds(this.#view.state);
  }

  get lineEnds(): LineEnds {
    return lineEndsIn(this.#view.state);
  }

  get file(): ProgramFile | undefined {
    return fileOf(this.#view.state);
  }

  set file(file: ProgramFile) {
    this.#view.dispatch({
      effects: renameEffect(file),
      annotations: [byPage.of(true), Transaction.addToHistory.of(false)],
    });
  }

  get length(): number {
    return this.#view.state.doc.length;
  }

  get revision(): number {
    return this.#revision;
  }

  takeUnsent(): TextCommand | undefined {
    return this.#unsent.take(this.#view.state.doc);
  }

  markAllUnsent(): void {
    this.#unsent.markAll();
  }

  get cursor(): number {
    return this.#view.state.selection.main.head;
  }

  get selection(): Span {
    const { from, to } = this.#view.state.selection.main;
    return { from, to };
  }

  set language(language: Language) {
    this.#uiLanguage = language;
    this.#view.dispatch({ effects: this.#language.reconfigure(this.#languageExtension(language)) });
    this.diagnostics = this.#diagnostics;
  }

  setText(
    program: ProgramText,
    file: ProgramFile | undefined,
    undoable: 'undoable' | 'final',
    context?: ProgramContext,
  ): void {
    const effects = [setOriginEffect(program.ends, file), ...(context === undefined ? [] : [contextEffect(context)])];
    this.#replace(program, effects, undoable);
  }

  rewrite(text: string): void {
    this.#replace(programText(text), [], 'undoable');
  }

  get history(): { readonly canUndo: boolean; readonly canRedo: boolean } {
    const { state } = this.#view;
    return { canUndo: undoDepth(state) > 0, canRedo: redoDepth(state) > 0 };
  }

  travel(direction: 'undo' | 'redo'): void {
    (direction === 'undo' ? undo : redo)(this.#view);
  }

  #replace(program: ProgramText, effects: readonly StateEffect<unknown>[], undoable: 'undoable' | 'final'): void {
    this.#view.dispatch({
      effects: [...effects, showRunning.of(undefined)],
      changes: { from: 0, to: this.length, insert: docOf(program) },
      selection: { anchor: 0 },
      annotations: [byPage.of(true), Transaction.addToHistory.of(undoable === 'undoable'), isolateHistory.of('full')],
      scrollIntoView: true,
    });
    this.#unsent.recordReplacement(program.pieces);
    this.#foldHiddenLines();
    this.#view.dom.classList.remove('cm-chosen');
  }

  /** The visible lines with a margin, from 0, end exclusive; undefined if they are too long to highlight. */
  get visibleLines(): { firstLine: number; endLine: number } | undefined {
    const { doc } = this.#view.state;
    const { from, to } = this.#view.viewport;
    const first = doc.line(Math.max(doc.lineAt(from).number - MARGIN_LINES, 1));
    const last = doc.line(Math.min(doc.lineAt(to).number + MARGIN_LINES, doc.lines));
    if (last.to - first.from > HIGHLIGHT_LIMIT) return undefined;
    return { firstLine: first.number - 1, endLine: last.number };
  }

  set tokens(tokens: Uint32Array) {
    this.#pendingDecorations.tokens = tokens;
    this.#scheduleDecorations();
  }

  set diagnostics(diagnostics: readonly Diagnostic[]) {
    this.#diagnostics = this.#pendingDecorations.diagnostics = diagnostics;
    this.#scheduleDecorations();
  }

  /** Collects changes of the decorations: each update of CodeMirror causes a layout, and should be a separate task. */
  #scheduleDecorations(): void {
    this.#updateTimer ??= setTimeout(() => this.flushDecorations(), UPDATE_DELAY_MS);
  }

  /** Shows the collected changes; called when no more are expected. */
  flushDecorations(): void {
    clearTimeout(this.#updateTimer);
    this.#updateTimer = undefined;
    const { tokens, diagnostics } = this.#pendingDecorations;
    this.#pendingDecorations = {};
    const { state } = this.#view;
    const updates: TransactionSpec[] = [];
    if (tokens !== undefined) updates.push({ effects: showTokens.of(tokens) });
    if (diagnostics !== undefined) {
      const shown = lintDiagnostics(
        diagnostics,
        this.#uiLanguage,
        this.length,
        () => this.#diagnostics,
        (setting) => this.#events.onSettingChosen(setting),
      );
      // Diagnostics that are already shown need no update.
      if (!areShown(state, shown)) updates.push(setDiagnostics(state, shown));
    }
    if (updates.length > 0) this.#view.dispatch(...updates);
  }

  /** The block of the stroke under the pointer. */
  set hovered(span: Span | undefined) {
    this.#view.dispatch({ effects: showHovered.of(span) });
  }

  /** The values of variables that the user tries. */
  get tried(): readonly TriedValue[] {
    return triedOf(this.#view.state);
  }

  tryValue(value: TriedValue): void {
    tryValue(this.#view, value);
  }

  endTrial(): void {
    endTrial(this.#view);
  }

  /** The line of an offset, from 0. */
  lineOf(offset: number): number {
    return this.#view.state.doc.lineAt(offset).number - 1;
  }

  /** The start of the line of an offset. */
  lineStart(offset: number): number {
    return this.#view.state.doc.lineAt(offset).from;
  }

  /** Number of lines that are not folded. It is also known while the editor is outside the window, unlike its height. */
  get rows(): number {
    const { contentHeight, defaultLineHeight, documentPadding } = this.#view;
    return Math.round((contentHeight - documentPadding.top - documentPadding.bottom) / defaultLineHeight);
  }

  /** The lines, from 0, before which the playback pauses. */
  get breakpoints(): readonly number[] {
    return breakpointsOf(this.#view.state);
  }

  /** Toggles the breakpoint in the line of the cursor. Returns whether it is set now. */
  toggleBreakpoint(): boolean {
    return toggleBreakpoint(this.#view, this.cursor);
  }

  /** The uses of the number at the cursor. */
  set uses(spans: readonly Span[]) {
    this.#view.dispatch({ effects: showUses.of(spans) });
  }

  /** The foldable ranges: from the end of a line to the end of the last line of the range. */
  set foldable(spans: readonly Span[]) {
    this.#view.dispatch({ effects: showFoldable.of(spans) });
  }

  /** The lines that the page highlights. */
  set highlightedLines(lines: readonly LineRange[]) {
    this.#view.dispatch({ effects: showMarked.of(lines) });
  }

  set shownLines(lines: readonly LineRange[]) {
    this.#shownLines = lines;
    this.#foldHiddenLines();
  }

  #foldHiddenLines(): void {
    const effects = foldAllExcept(this.#view.state, this.#shownLines);
    if (effects.length > 0) this.#view.dispatch({ effects });
  }

  /** Scrolls to the running block, even if the user has just scrolled elsewhere. */
  followRunningBlock(): void {
    this.#follower.resume();
  }

  /** The start of the line marked as running, also after edits; undefined if no line is marked or it was removed. */
  get runningLineStart(): number | undefined {
    return runningLineStart(this.#view.state);
  }

  /** The block of the current tool position; it is kept visible. */
  set running(span: Span | undefined) {
    this.#view.dispatch({ effects: showRunning.of(span) });
    if (span !== undefined && span.to <= this.length) this.#follower.reveal(span.from);
  }

  select(span: Span): void {
    if (span.to > this.length) return;
    this.#view.dispatch({
      selection: { anchor: span.from, head: span.to },
      effects: [...unfoldAt(this.#view, span.from, span.to), EditorView.scrollIntoView(span.from, { y: 'center' })],
      annotations: byPage.of(true),
    });
    this.#view.dom.classList.add('cm-chosen');
  }

  /** Applies fixes, unless the text has changed since they were offered. */
  applyFixes(edits: Fix['edits']): void {
    if (this.#diagnostics.length > 0) applyFix(this.#view, edits);
  }

  /** Inserts a text at the cursor, as if the user had typed it. */
  type(text: string): void {
    // CodeMirror maps a selection whose text was replaced to a range that ends before it begins.
    const { anchor, head } = this.#view.state.selection.main;
    const [from, to] = [Math.min(anchor, head), Math.max(anchor, head)];
    this.#view.dispatch({
      changes: { from, to, insert: text },
      selection: { anchor: from + text.length },
      userEvent: 'input.type',
      scrollIntoView: true,
    });
  }

  /** Replaces the line of the cursor by a proposal, which can be undone by itself. */
  async insertProposal(proposal: CompletionItem): Promise<void> {
    const { insertInto } = await importWithRetry(() => import('./completion'));
    const { from, to } = this.#view.state.doc.lineAt(this.cursor);
    this.focus();
    insertInto(this.#view, proposal, from, to);
  }

  /** Does what Tab does in a field of a proposal. */
  async nextField(): Promise<void> {
    const { toNextField } = await importWithRetry(() => import('./completion'));
    toNextField(this.#view);
  }

  change(edits: readonly Change[]): void {
    if (edits.length === 0) return;
    this.#view.dispatch({
      changes: edits.map((edit) => ({ from: edit.from, to: edit.to, insert: edit.text })),
      annotations: isolateHistory.of('full'),
      userEvent: 'input.setup',
    });
  }

  nextProblem(direction: 'next' | 'previous'): boolean {
    this.flushDecorations();
    this.focus();
    if (direction === 'next') nextDiagnostic(this.#view);
    else previousDiagnostic(this.#view);
    announceProblem(this.#view, this.#uiLanguage);
    return true;
  }

  /** Scrolls to the cursor, after the layout of the elements around the text. */
  scrollToCursor(): void {
    requestAnimationFrame(() =>
      this.#view.dispatch({
        effects: EditorView.scrollIntoView(this.#view.state.selection.main.head, { y: 'nearest', yMargin: 12 }),
      }),
    );
  }

  announce(text: string): void {
    this.#view.dispatch({ effects: EditorView.announce.of(text) });
  }

  focus(): void {
    this.#view.focus();
  }

  #languageExtension(language: Language): Extension {
    const readonlyAttributes = this.#access === 'readonly' ? { 'aria-readonly': 'true' } : {};
    const attributes = {
      'aria-label': COMMON[language].program,
      lang: 'en',
      autocapitalize: 'characters',
      tabindex: '0',
      ...readonlyAttributes,
    };
    return [EditorView.contentAttributes.of(attributes), editorPhrases(language), placeholder(WORDS[language].empty)];
  }

  async #loadCompletion(): Promise<void> {
    if (this.#isCompletionLoading || this.#access === 'readonly') return;
    this.#isCompletionLoading = true;
    try {
      const { revision } = this;
      const { completeTypedText, completion } = await importWithRetry(() => import('./completion'));
      this.#view.dispatch({ effects: this.#completion.reconfigure(completion(this.#events)) });
      if (this.revision !== revision) completeTypedText(this.#view);
      this.#events.onCompletionLoaded();
    } catch (reason) {
      this.#isCompletionLoading = false;
      this.#events.onCompletionFailed(reason, () => void this.#loadCompletion());
    }
  }

  #onUpdate(update: ViewUpdate): void {
    const isByPage = update.transactions.some((transaction) => transaction.annotation(byPage) === true);
    if (update.docChanged) {
      this.#revision++;
      this.#unsent.recordChanges(update.changes);
      this.#diagnostics = [];
      this.#pendingDecorations = {};
    }
    if (update.focusChanged && this.#view.hasFocus) void this.#loadCompletion();
    if (!isByPage) {
      if (update.selectionSet || update.docChanged) this.#view.dom.classList.remove('cm-chosen');
      const context = contextOf(update.transactions);
      if (context !== undefined) this.#events.onContextChanged(context);
      if (update.docChanged) this.#events.onTextChanged(inputOf(update.transactions));
      else if (update.selectionSet) this.#events.onCursorMoved();
    }
    for (const transaction of update.transactions) {
      if (!transaction.isUserEvent('input.paste') && !transaction.isUserEvent('input.drop')) continue;
      transaction.changes.iterChangedRanges((_from, _to, from, to) => this.#events.onPasted(from, to));
    }
    if (fileOf(update.startState) !== fileOf(update.state)) this.#events.onFileChanged();
    // If edits have only moved the blocks, the run of the changed text includes the new positions.
    const [before, now] = [triedOf(update.startState), triedOf(update.state)];
    if (update.docChanged ? before.length !== now.length : before !== now) this.#events.onTrialChanged();
    if (update.viewportChanged) this.#events.onViewMoved();
  }
}

const WORDS = words({
  en: { empty: 'Write or paste a program, or drop a file here. Ctrl Space offers whole cycles.' },
  zh: { empty: '在此编写或粘贴程序，或拖入文件。Ctrl 空格可插入完整的循环。' },
  ru: { empty: 'Напишите или вставьте программу, или перетащите файл. Ctrl Пробел предлагает циклы целиком.' },
});
