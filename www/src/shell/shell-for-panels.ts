// The interface of the shell for panels and for the element: worker, program, setup, services.
//
// In: calls of panels. Out: the same to the parts of the shell, each of which has its own state. Must not know: when the
// element is connected, and which attributes it has.

import type { Language } from '../dom/language';
import type { Program } from '../editor/program';
import type { ProgramFile, ProgramText } from '../editor/program-text';
import type { Span } from '../editor/text-store';
import type { NewestQuestion, Region, Services, Shell } from '../panels/panel';
import type {
  AnnotateChoice,
  Answer,
  Command,
  Diagnostic,
  Pace,
  QuestionKind,
  Questions,
  Readout,
  Stroke,
} from '../protocol/protocol';
import type { AuthorSettings } from './author-settings';
import { cursorInFile, strokeInFile } from './file-offsets';
import type { HostContext } from './host-context';
import type { HostPlayback } from './host-playback';
import type { PanelSet } from './panel-set';
import type { RunReports } from './run-reports';
import type { Runs } from './runs';
import { adoptStyles } from './style-sheets';

interface ShellParts {
  readonly root: ShadowRoot;
  readonly frame: HTMLElement;
  readonly editor: Program;
  readonly readonly: boolean;
  readonly showsProgram: boolean;
  readonly panels: PanelSet;
  readonly runs: Runs;
  readonly reports: RunReports;
  readonly context: HostContext;
  readonly author: AuthorSettings;
  readonly playback: HostPlayback;
  language(): Language;
  fire<Detail>(type: string, detail: Detail): void;
  /** The user has changed the program or its file. */
  onChange(): void;
}

export class ShellForPanels implements Shell {
  readonly root: ShadowRoot;
  readonly frame: HTMLElement;
  readonly editor: Program;
  readonly readonly: boolean;
  readonly showsProgram: boolean;
  readonly #parts: ShellParts;

  constructor(parts: ShellParts) {
    this.root = parts.root;
    this.frame = parts.frame;
    this.editor = parts.editor;
    this.readonly = parts.readonly;
    this.showsProgram = parts.showsProgram;
    this.#parts = parts;
  }

  get language(): Language {
    return this.#parts.language();
  }

  get annotate(): AnnotateChoice {
    return this.#parts.author.annotate;
  }

  get calculator(): string | undefined {
    return this.#parts.author.calculator;
  }

  get exercise(): string | undefined {
    return this.#parts.author.exercise;
  }

  get speed(): Pace | undefined {
    return this.#parts.author.speed;
  }

  changeSpeed(speed: Pace): void {
    this.#parts.author.changeSpeed(speed);
  }

  get diagnostics(): readonly Diagnostic[] {
    return this.#parts.reports.diagnostics;
  }

  region(region: Region): HTMLElement {
    return this.#parts.panels.regions[region];
  }

  service<S extends keyof Services>(name: S): Services[S] {
    return this.#parts.panels.service(name);
  }

  hasService(name: keyof Services): boolean {
    return this.#parts.panels.findService(name) !== undefined;
  }

  addStyles(styles: string): void {
    adoptStyles(this.root, [styles]);
  }

  // ---- the worker ---------------------------------------------------------------------------------

  send(command: Command): void {
    this.#parts.runs.client?.send(command);
  }

  async ask<K extends QuestionKind>(about: K, ask: Questions[K]['args']): Promise<Answer<K> | undefined> {
    return this.#parts.runs.client?.ask(about, ask);
  }

  newest<K extends QuestionKind>(about: K, answered: (answer: Answer<K>) => void): NewestQuestion<K> {
    return this.#parts.runs.newest(about, answered);
  }

  // ---- the program --------------------------------------------------------------------------------

  flush(): void {
    this.#parts.runs.flush();
  }

  commitEdit(): void {
    this.#parts.runs.send();
  }

  rewrite(text: string): void {
    this.editor.rewrite(text);
    this.#parts.runs.resetCursor();
    this.#parts.runs.send();
  }

  replaceProgram(program: ProgramText, file: ProgramFile | undefined, as: 'another' | 'same'): void {
    const { context, runs, panels } = this.#parts;
    if (as === 'another') {
      const neutral = context.neutral;
      this.editor.setText(program, file, 'undoable', neutral);
      context.replace(neutral);
    } else this.editor.setText(program, file, 'undoable');
    runs.resetCursor();
    runs.textChanged('fit');
    this.notifyFileChanged();
    if (as === 'another') panels.notify((panel) => panel.onTextInserted?.(0, this.editor.length));
  }

  notifyFileChanged(): void {
    this.#parts.onChange();
  }

  markAsInserted(): void {
    this.#parts.runs.markAsInserted();
  }

  goTo(span: Span): void {
    this.showPlace(span);
    this.notifyCursor();
  }

  /** Selects a place of the program for the page, without an event. */
  showPlace(span: Span): void {
    this.editor.select(span);
    this.editor.focus();
    this.#onCursorSet(span.from);
  }

  chooseStroke(stroke: Stroke, focus: 'focus' | 'keep-focus'): void {
    this.editor.select(stroke);
    if (focus === 'focus') this.editor.focus();
    this.#onCursorSet(stroke.from);
    this.notifyCursor();
    this.#parts.fire('gcode-select', { stroke: strokeInFile(stroke, this.editor) });
  }

  chooseProblem(problem: Diagnostic): void {
    this.editor.selectProblem(problem);
    this.#onCursorSet(problem.from);
    this.notifyCursor();
  }

  refit(): void {
    this.#parts.author.sendFrame((command) => this.send(command));
  }

  notifyToolMoved(place: Readout | undefined): void {
    this.#parts.panels.notify((panel) => panel.onToolMoved?.(place));
    this.#parts.playback.onToolMoved(place);
  }

  notifyPlaying(state: 'playing' | 'paused'): void {
    this.#parts.playback.onPlaying(state);
  }

  /** Tells the page that the user has moved the cursor. */
  notifyCursor(): void {
    this.#parts.fire('gcode-cursor', cursorInFile(this.editor));
  }

  /** The page has moved the cursor on behalf of the user. */
  #onCursorSet(offset: number): void {
    this.#parts.runs.setCursor(offset);
    this.#parts.panels.notify((panel) => panel.onCursorMoved?.());
  }

  // ---- the setup ----------------------------------------------------------------------------------

  get setup(): string | null {
    return this.#parts.context.setup;
  }

  changeSetup(setup: string | null): void {
    this.#parts.context.changeSetup(setup);
  }

  setSwitches(switches: { readonly blockSkip?: string; readonly program?: string }): void {
    this.#parts.context.setSwitches(switches);
  }
}
