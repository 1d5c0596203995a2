// The program editor: CodeMirror 6 with the interpreter's highlighting and messages.
//
// In: text, tokens, diagnostics, blocks to mark. Out, only for actions of the user and not for changes by the page:
// `changed`, `cursorMoved`, and `contextChanged` if it is another program. Also `viewMoved` when other lines become
// visible, and `fileChanged` when the text belongs to another file, even by undo. Loaded by `program.ts`, together with
// CodeMirror. Must not know: the language it edits.

import { defaultKeymap, history, historyKeymap, isolateHistory } from '@codemirror/commands';
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
} from '@codemirror/view';
import { breakpoints, breakpointsOf, toggleBreakpoint } from './breakpoints';
import { applyFix, areShown, lintDiagnostics } from './lint';
import { folding, showFoldable } from './folding';
import { foldOthers, folds, unfoldAt } from './folds';
import { marks, runningLine, showHovered, showMarked, showRunning, showTokens, showUses } from './marks';
import { contextEffect, contextOf, programContext } from './context';
import { docOf, fileOf, fileOfText, lineEndsIn, origin, renamed, textWithLineEnds } from './file';
import { Follower } from './follow';
import type { Access, Change, EditorEvents, LineRange, ProgramContext, Span, Start, TextHolder } from './holder';
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
import { loaded } from '../dom/network';
import { COMMON } from '../dom/words';
import type { Diagnostic, Fix, TextCommand, TriedValue } from '../protocol/protocol';
import { Unsent } from './unsent';

/**
 * Tokens are also requested for this many lines above and below the visible ones, so that slow scrolling needs no new
 * request.
 */
const MARGIN_LINES = 60;
/** A longer range (a file without line ends) gets no colours. */
const HIGHLIGHT_LIMIT = 200_000;
/** Tokens and diagnostics of a run usually arrive within this time of each other; the delay is not noticeable. */
const TOGETHER_MS = 25;

/** Marks a change that was made by the page, not by the user. */
const byProgram = Annotation.define<true>();

export class Editor implements TextHolder {
  readonly #view: EditorView;
  readonly #follower: Follower;
  readonly #events: EditorEvents;
  readonly #language = new Compartment();
  /** Empty until completion is loaded, when the user first enters the text. */
  readonly #completion = new Compartment();
  #completionIsComing = false;
  readonly #access: Access;
  /** The lines that are not folded; folded again after each text that the page sets. */
  #shownLines: readonly LineRange[] = [];
  #shownLanguage: Language;
  #diagnostics: readonly Diagnostic[] = [];
  /** Decorations for the next update. */
  #coming: { tokens?: Uint32Array; diagnostics?: readonly Diagnostic[] } = {};
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Incremented with each change of the text. */
  #revision = 0;
  readonly #unsent: Unsent;

  constructor(
    root: ShadowRoot,
    parent: HTMLElement,
    language: Language,
    access: Access,
    start: Start,
    events: EditorEvents,
  ) {
    const { program, file, unsent } = start;
    this.#events = events;
    this.#shownLanguage = language;
    this.#access = access;
    this.#unsent = new Unsent(unsent);
    // Not on the window: WebKit would move tooltips there after showing them. Not in the frame, which would clip them.
    const aboveTheFrame = make('div', { className: 'own' });
    root.append(aboveTheFrame);
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
          tooltips({ position: 'absolute', parent: aboveTheFrame }),
          marks,
          editorTheme,
          folds(() => this.#shownLanguage),
          folding(() => this.#shownLanguage),
          triedValues(() => this.#shownLanguage),
          wordHover(events),
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
          EditorView.updateListener.of((update) => this.#updated(update)),
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
      effects: renamed(file),
      annotations: [byProgram.of(true), Transaction.addToHistory.of(false)],
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

  unsend(): void {
    this.#unsent.all();
  }

  get cursor(): number {
    return this.#view.state.selection.main.head;
  }

  get selection(): Span {
    const { from, to } = this.#view.state.selection.main;
    return { from, to };
  }

  set language(language: Language) {
    this.#shownLanguage = language;
    this.#view.dispatch({ effects: this.#language.reconfigure(this.#languageExtension(language)) });
    this.diagnostics = this.#diagnostics;
  }

  setText(
    program: ProgramText,
    file: ProgramFile | undefined,
    undoable: 'undoable' | 'final',
    context?: ProgramContext,
  ): void {
    const effects = [origin(program.ends, file), ...(context === undefined ? [] : [contextEffect(context)])];
    this.#replace(program, effects, undoable);
  }

  rewrite(text: string): void {
    this.#replace(programText(text), [], 'undoable');
  }

  #replace(program: ProgramText, effects: readonly StateEffect<unknown>[], undoable: 'undoable' | 'final'): void {
    this.#view.dispatch({
      effects: [...effects, showRunning.of(undefined)],
      changes: { from: 0, to: this.length, insert: docOf(program) },
      selection: { anchor: 0 },
      annotations: [
        byProgram.of(true),
        Transaction.addToHistory.of(undoable === 'undoable'),
        isolateHistory.of('full'),
      ],
      scrollIntoView: true,
    });
    this.#unsent.replaced(program.pieces);
    this.#fold();
    this.#view.dom.classList.remove('cm-chosen');
  }

  /** The visible lines with a margin, from 0, end exclusive; undefined if they are too long to highlight. */
  get linesInSight(): { firstLine: number; endLine: number } | undefined {
    const { doc } = this.#view.state;
    const { from, to } = this.#view.viewport;
    const first = doc.line(Math.max(doc.lineAt(from).number - MARGIN_LINES, 1));
    const last = doc.line(Math.min(doc.lineAt(to).number + MARGIN_LINES, doc.lines));
    if (last.to - first.from > HIGHLIGHT_LIMIT) return undefined;
    return { firstLine: first.number - 1, endLine: last.number };
  }

  set tokens(tokens: Uint32Array) {
    this.#coming.tokens = tokens;
    this.#showSoon();
  }

  set diagnostics(diagnostics: readonly Diagnostic[]) {
    this.#diagnostics = this.#coming.diagnostics = diagnostics;
    this.#showSoon();
  }

  /** Collects changes of the decorations: each update of CodeMirror causes a layout, and should be a separate task. */
  #showSoon(): void {
    this.#timer ??= setTimeout(() => this.showNow(), TOGETHER_MS);
  }

  /** Shows the collected changes; called when no more are expected. */
  showNow(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const { tokens, diagnostics } = this.#coming;
    this.#coming = {};
    const { state } = this.#view;
    const updates: TransactionSpec[] = [];
    if (tokens !== undefined) updates.push({ effects: showTokens.of(tokens) });
    if (diagnostics !== undefined) {
      const shown = lintDiagnostics(
        diagnostics,
        this.#shownLanguage,
        this.length,
        () => this.#diagnostics,
        (setting) => this.#events.settingChosen(setting),
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
  set marked(lines: readonly LineRange[]) {
    this.#view.dispatch({ effects: showMarked.of(lines) });
  }

  set shownLines(lines: readonly LineRange[]) {
    this.#shownLines = lines;
    this.#fold();
  }

  #fold(): void {
    const effects = foldOthers(this.#view.state, this.#shownLines);
    if (effects.length > 0) this.#view.dispatch({ effects });
  }

  /** Scrolls to the running block, even if the user has just scrolled elsewhere. */
  follow(): void {
    this.#follower.resume();
  }

  /** The start of the line marked as running, also after edits; undefined if no line is marked or it was removed. */
  get runningLine(): number | undefined {
    return runningLine(this.#view.state);
  }

  /** The block of the current tool position; it is kept visible. */
  set running(span: Span | undefined) {
    this.#view.dispatch({ effects: showRunning.of(span) });
    if (span !== undefined && span.to <= this.length) this.#follower.show(span.from);
  }

  select(span: Span): void {
    if (span.to > this.length) return;
    this.#view.dispatch({
      selection: { anchor: span.from, head: span.to },
      effects: [...unfoldAt(this.#view, span.from, span.to), EditorView.scrollIntoView(span.from, { y: 'center' })],
      annotations: byProgram.of(true),
    });
    this.#view.dom.classList.add('cm-chosen');
  }

  /** Applies fixes, unless the text has changed since they were offered. */
  apply(edits: Fix['edits']): void {
    if (this.#diagnostics.length > 0) applyFix(this.#view, edits);
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
    this.showNow();
    this.focus();
    if (direction === 'next') nextDiagnostic(this.#view);
    else previousDiagnostic(this.#view);
    announceProblem(this.#view, this.#shownLanguage);
    return true;
  }

  /** Scrolls to the cursor, after the layout of the elements around the text. */
  keepCursorInSight(): void {
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
    const reading = this.#access === 'readonly' ? { 'aria-readonly': 'true' } : {};
    const attributes = {
      'aria-label': COMMON[language].program,
      lang: 'en',
      autocapitalize: 'characters',
      tabindex: '0',
      ...reading,
    };
    return [EditorView.contentAttributes.of(attributes), editorPhrases(language)];
  }

  async #loadCompletion(): Promise<void> {
    if (this.#completionIsComing || this.#access === 'readonly') return;
    this.#completionIsComing = true;
    try {
      const { revision } = this;
      const { catchUp, completion } = await loaded(() => import('./completion'));
      this.#view.dispatch({ effects: this.#completion.reconfigure(completion(this.#events)) });
      if (this.revision !== revision) catchUp(this.#view);
      this.#events.completionLoaded();
    } catch (reason) {
      this.#completionIsComing = false;
      this.#events.completionFailed(reason, () => void this.#loadCompletion());
    }
  }

  #updated(update: ViewUpdate): void {
    const programmatic = update.transactions.some((transaction) => transaction.annotation(byProgram) === true);
    if (update.docChanged) {
      this.#revision++;
      this.#unsent.changed(update.changes);
      this.#diagnostics = [];
      this.#coming = {};
    }
    if (update.focusChanged && this.#view.hasFocus) void this.#loadCompletion();
    if (!programmatic) {
      if (update.selectionSet || update.docChanged) this.#view.dom.classList.remove('cm-chosen');
      const context = contextOf(update.transactions);
      if (context !== undefined) this.#events.contextChanged(context);
      if (update.docChanged) this.#events.changed();
      else if (update.selectionSet) this.#events.cursorMoved();
    }
    for (const transaction of update.transactions) {
      if (!transaction.isUserEvent('input.paste') && !transaction.isUserEvent('input.drop')) continue;
      transaction.changes.iterChangedRanges((_from, _to, from, to) => this.#events.pasted(from, to));
    }
    if (fileOf(update.startState) !== fileOf(update.state)) this.#events.fileChanged();
    // If edits have only moved the blocks, the run of the changed text includes the new positions.
    const [before, now] = [triedOf(update.startState), triedOf(update.state)];
    if (update.docChanged ? before.length !== now.length : before !== now) this.#events.triedChanged();
    if (update.viewportChanged) this.#events.viewMoved();
  }
}
