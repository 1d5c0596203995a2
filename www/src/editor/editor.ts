// The program editor: CodeMirror 6 with the core's own highlighting and messages.
//
// In: text, tokens, diagnostics, the blocks to mark. Out: `changed` and `cursorMoved` when the *reader* did
// it (what the program does to the editor fires nothing), `contextChanged` when that is another program, `viewMoved` when other lines came into sight, and
// `fileChanged` when the text is another file's, be it by undo. Loaded by `program.ts`, with all of CodeMirror.
// Must not know: the language it edits.

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
 * Lines above and below the visible ones whose tokens are asked for too, so that
 * slow scrolling asks for none.
 */
const MARGIN_LINES = 60;
/** Longer stretches (a file without line ends) stay without colours. */
const HIGHLIGHT_LIMIT = 200_000;
/** Tokens and diagnostics of a run come within this time where the page is quick; the reader does not see it. */
const TOGETHER_MS = 25;

/** Marks a change that the page made, not the reader. */
const byProgram = Annotation.define<true>();

export class Editor implements TextHolder {
  readonly #view: EditorView;
  readonly #follower: Follower;
  readonly #events: EditorEvents;
  readonly #language = new Compartment();
  /** Empty until the reader is in the text. */
  readonly #completion = new Compartment();
  #completionIsComing = false;
  readonly #access: Access;
  /** What of the text is shown; it is folded anew around each text of the page's. */
  #shownLines: readonly LineRange[] = [];
  #shownLanguage: Language;
  #diagnostics: readonly Diagnostic[] = [];
  /** What is to be shown over the text with the next update. */
  #coming: { tokens?: Uint32Array; diagnostics?: readonly Diagnostic[] } = {};
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Counts the versions of the text. */
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
    // Not at the window: WebKit would move it there after it was shown. Not in the frame, which would cut it off.
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
          // Tab is not bound: it leaves the editor.
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

  /** The lines in sight with a margin, from 0, end exclusive; undefined when they are too long to colour. */
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

  /** Each update of the editor lays the page out, so what comes shortly one after the other is one update, and one task of its own. */
  #showSoon(): void {
    this.#timer ??= setTimeout(() => this.showNow(), TOGETHER_MS);
  }

  /** No more is to come soon. */
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
      // What stands there already costs a key nothing.
      if (!areShown(state, shown)) updates.push(setDiagnostics(state, shown));
    }
    if (updates.length > 0) this.#view.dispatch(...updates);
  }

  /** The block whose stroke the pointer is on. */
  set hovered(span: Span | undefined) {
    this.#view.dispatch({ effects: showHovered.of(span) });
  }

  /** The values of variables that the reader tries. */
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

  /** Lines, from 0, before which the tool is held. */
  get breakpoints(): readonly number[] {
    return breakpointsOf(this.#view.state);
  }

  /** Marks the line of the cursor to hold the tool, or takes the mark away; says which. */
  toggleBreakpoint(): boolean {
    return toggleBreakpoint(this.#view, this.cursor);
  }

  /** Where the number at the cursor is used. */
  set uses(spans: readonly Span[]) {
    this.#view.dispatch({ effects: showUses.of(spans) });
  }

  /** What the reader can fold: from the end of a line to the end of the last that belongs to it. */
  set foldable(spans: readonly Span[]) {
    this.#view.dispatch({ effects: showFoldable.of(spans) });
  }

  /** The lines that the page around marks. */
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

  /** The block that runs comes into sight, even if the reader has just looked elsewhere. */
  follow(): void {
    this.#follower.resume();
  }

  /** Where the line of that block begins, also after edits; nothing when it is not marked, or gone. */
  get runningLine(): number | undefined {
    return runningLine(this.#view.state);
  }

  /** The block the tool is in; it is kept in sight. */
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

  /** Makes repairs; when the text has changed since they were offered, their places are no more. */
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

  /** Scrolls to the cursor, once what stands around the text has the room it takes. */
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
    // Where only their blocks have moved, the run of the changed text hears of it.
    const [before, now] = [triedOf(update.startState), triedOf(update.state)];
    if (update.docChanged ? before.length !== now.length : before !== now) this.#events.triedChanged();
    if (update.viewportChanged) this.#events.viewMoved();
  }
}
