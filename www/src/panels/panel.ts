// The interfaces of panels, and of the shell that they use.
//
// A panel is one part of the page, for example a button with its dialog, a bar, or the pictures. It is one file of this
// folder, with its texts in all languages at the end, a style sheet of the same name, and one line in the list of
// `further.ts`. Code that is too large for one file, or that is loaded on demand, is a separate component with its own
// texts. A panel knows the shell through `Shell`, and other panels through their `Services`. Must not know: where text
// and setup are stored, or how runs begin.

import type { Language } from '../dom/language';
import type { Span } from '../editor/text-store';
import type { Program } from '../editor/program';
import type { ProgramFile, ProgramText } from '../editor/program-text';
import type {
  AnnotateChoice,
  Answer,
  Command,
  Diagnostic,
  ExportResult,
  ExportFormat,
  PictureName,
  Pictures,
  Pace,
  SectionScale,
  QuestionKind,
  Questions,
  Readout,
  Setting,
  SetupGroup,
  StepDirection,
  StepUnit,
  Stroke,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';

/**
 * Where panels are placed, in this order: the row at the top, with menus; the tabs of a narrow element; over, beside
 * and under the editor; between the editor and the pictures; around the pictures; dialogs. Then what is shown on
 * demand: the menus of the row at the top, how the program is read, and the options of the playback.
 */
export const REGIONS = [
  'head',
  'tabs',
  'notices',
  'bar',
  'problems',
  'divider',
  'views',
  'assumptions',
  'pictures',
  'playback',
  'dialogs',
  'program-menu',
  'share-menu',
  'help-menu',
  'more-menu',
  'reading',
  'pace',
] as const;
export type Region = (typeof REGIONS)[number];

/** Groups of panels that the host page can leave out. */
export const CONTROLS = ['file', 'setup', 'problems', 'views', 'playback', 'status', 'tools', 'help', 'link'] as const;
export type Control = (typeof CONTROLS)[number];

export interface PanelKind {
  /** Shown only if the host page includes this group; a panel without one is always shown. */
  readonly control?: Control;
  /** Changes the program, so it is not shown in a read-only element. */
  readonly edits?: true;
  /** Its style sheet. */
  readonly styles?: string;
  /** Called once for each element. Other panels may not exist yet. */
  make(shell: Shell): Panel;
}

/** Something that the user can do, as the command palette lists it. */
export interface UserCommand {
  /** In the language of the element. */
  readonly name: string;
  /** The keys for it, if it has any. */
  readonly keys?: string;
  run(): void;
}

export interface Panel {
  /** The elements of this panel, by region. */
  readonly elements: { readonly [R in Region]?: readonly HTMLElement[] };
  /** Sets the language of its texts: once after all panels are made, then with each change. */
  set language(language: Language);
  /** Whether there is a finished run with motions. Controls that need one are disabled until then. */
  available?: boolean;
  /** Whether an open dialog of this panel receives all keys. */
  readonly capturesKeys?: boolean;
  readonly services?: Partial<Services>;
  /** What the user can do with this panel, besides the items of menus. */
  readonly commands?: readonly UserCommand[];

  /** A key that no dialog handles. Returns whether the panel handled it. */
  onKey?(key: Key): 'handled' | 'ignored';
  /** An event of the newest run. */
  onEvent?(event: CoreEvent): void;
  /** Pictures of the newest run. The panel owns the images. */
  onPictures?(pictures: Pictures, scale: SectionScale): void;
  /** The user has moved the cursor, or typed. */
  onCursorMoved?(): void;
  /** The user has changed the values to try for variables. */
  onTrialChanged?(): void;
  /** The tool has moved; undefined: no tool is shown. */
  onToolMoved?(place: Readout | undefined): void;
  /** Another program has replaced the current one: the host page has set it, or the user has typed or opened it. */
  onProgramReplaced?(by: 'host' | 'user'): void;
  /** Text was inserted into the editor in one piece (not typed), between these offsets. */
  onTextInserted?(from: number, to: number): void;
  /** Show the program: it is about to get the focus. */
  onShowProgram?(): void;
  /** The text belongs to another file, or the file's name or encoding has changed. */
  onFileChanged?(file: ProgramFile | undefined): void;
  /** The state of the switches in attributes and setup has changed. */
  onSwitchesChanged?(set: SwitchState): void;
  /** The attribute `speed` has changed. */
  onSpeedChanged?(): void;
  /** The theme or the system colours have changed. */
  onColoursChanged?(): void;
  /** Text or setup has changed: results of the previous run must not be combined with them. */
  onInputChanged?(): void;
  /** The newest run has begun. */
  onRunStarted?(): void;
  /** The newest run failed, or something that it needs could not be loaded: there will be no report. */
  onRunFailed?(): void;
  /** A new worker is connected. It has no state yet. */
  onWorkerConnected?(send: (command: Command) => void): void;
  /** The worker was lost, with all results of the run. */
  onWorkerLost?(): void;
  /** The element was removed from the document. */
  onDisconnected?(): void;
}

/** A key press, and whether the focus was in a text field. */
export interface Key {
  readonly event: KeyboardEvent;
  readonly inside: 'text' | 'elsewhere';
}

/** State of the switches of the operator's panel. */
export interface SwitchState {
  /** Block skip levels that are on. */
  readonly blockSkip: readonly number[];
  /** The O number of the program to run; undefined: the first one of the text. */
  readonly program: number | undefined;
}

/** Whether the key was pressed in the program, including a read-only program. */
export function isInProgram({ inside }: Key, { root }: Shell): boolean {
  return inside === 'text' || (root.activeElement?.closest('.editor') ?? null) !== null;
}

/** A point in the window, CSS pixels. */
export interface ClientPoint {
  readonly clientX: number;
  readonly clientY: number;
}

/** A place of the section: X as a diameter, and Z, mm. */
export interface Place {
  readonly x: number;
  readonly z: number;
}

/**
 * Topics of notices. The next run hides `program`. `missing` has a separate line, which remains until everything works.
 */
export type Topic = 'file' | 'program' | 'program-setup' | 'setup' | 'editor' | 'source' | 'loading' | 'missing';

/** A button of a notice that fixes its cause. */
export interface NoticeAction {
  readonly title: string;
  act(): void;
}

/** Functions that a panel offers to other panels, to the shell, or to the host page. */
export interface Services {
  notice(text: string, topic?: Topic, action?: NoticeAction): void;
  hideNotice(topic: Topic): void;
  play(): void;
  pause(): void;
  playOrPause(): void;
  /** Buttons to play and to step, for a dialog that covers the bar. */
  playbackButtons(): HTMLElement;
  /** Moves the tool forward or back by one unit. */
  step(unit: StepUnit, direction: StepDirection): void;
  /** Stops the playback and shows the tool where the answer to a question has moved it. */
  moveTool(answer: Promise<Readout | undefined>): Promise<void>;
  /** Plays only the block at the cursor. */
  playBlock(): void;
  /** Plays from the current position to the block at the cursor. */
  playToCursor(): void;
  /** Sets or removes a breakpoint at the line of the cursor: the tool stops before it. */
  toggleBreakpoint(): void;
  openFile(file: File): Promise<void>;
  saveFile(): void;
  /** A file as the menu "Export" makes it, without saving it; undefined if there is no worker. */
  exported(format: ExportFormat): Promise<ExportResult | undefined>;
  /** Converts a place of a picture, as in the question `locate`, to a point in the window. */
  locate(picture: PictureName, ...place: readonly [number, number]): Promise<ClientPoint>;
  /** A click in the section, CSS pixels. Returns whether it measures, and has no other effect. */
  measureAt(x: number, y: number): boolean;
  /** A click in the section. Returns whether it is the answer to an exercise, and has no other effect. */
  answerAt(place: Place): boolean;
  /** Shows only these pictures. */
  showOnly(pictures: readonly PictureName[]): void;
  /** Keeps the current part, to compare later ones with it. */
  keepPart(): void;
  /** Ends the comparison that `keepPart` began, but not one that the user began. */
  endComparison(): void;
  /** Checks the program as the answer to the exercise, and shows the report. */
  checkExercise(): void;
  /** Title, task and drawing of the exercise, for a printed sheet. */
  exerciseSheet(): readonly HTMLElement[];
  /** Prints the task of the exercise with an empty form for the program. */
  printTask(): void;
  openCodes(): void;
  /** Opens a calculator with the values of the block at the cursor. */
  openCalculator(name: string): void;
  /** Opens the explanation of the word and the block at the cursor. */
  explain(): void;
  /** `group` and `key`: the group and the field to open. */
  openSetup(group?: SetupGroup['group'], key?: string): void;
  /** The button that opens the outline of the program. */
  outlineButton(): HTMLElement;
  /** The list of uses of the number at the cursor; empty if there is no such number. */
  usesSection(): HTMLElement;
  /** The button that shows the machine of the program. */
  machineButton(): HTMLElement;
  /** The user's default setup for new programs, JSON. */
  defaultSetup(): string | null;
  /**
   * Changes a setting in the program or in the page, depending on where the setup is stored. If the value is missing,
   * opens the form for the user to enter it.
   */
  applySetting(setting: Setting): void;
}

/** Sends only the newest value, see `LatestQuestion`. Continues with the next worker if one is lost. */
export interface NewestQuestion<K extends QuestionKind> {
  ask(ask: Questions[K]['args']): void;
  cancel(): void;
}

export interface Shell {
  readonly root: ShadowRoot;
  /** The program and its editor. */
  readonly editor: Program;
  readonly language: Language;
  /** Whether the program is read-only. */
  readonly readonly: boolean;
  /** The dimensions and letters that the host page has chosen. */
  readonly annotate: AnnotateChoice;
  /** The calculator that the host page shows over the program. */
  readonly calculator: string | undefined;
  /** All problems of the newest report, also those that are held back while the user types. */
  readonly diagnostics: readonly Diagnostic[];
  /** The address of the exercise that the host page has chosen. */
  readonly exercise: string | undefined;
  /** Whether the program text is shown, not only its results. */
  readonly showsProgram: boolean;
  /** The element that contains all regions. */
  readonly frame: HTMLElement;
  /** The element that contains the panels of a region. */
  region(region: Region): HTMLElement;
  service<S extends keyof Services>(name: S): Services[S];
  /** Whether a panel offers this service: the host page can leave out groups of panels. */
  hasService(name: keyof Services): boolean;

  // ---- the worker: it receives all pending changes before each message ----
  send(command: Command): void;
  /** Resolves to undefined if there is no worker; never resolves if the worker is lost. */
  ask<K extends QuestionKind>(about: K, ask: Questions[K]['args']): Promise<Answer<K> | undefined>;
  newest<K extends QuestionKind>(about: K, answered: (answer: Answer<K>) => void): NewestQuestion<K>;

  /** Adds the style sheet of a part that is loaded on demand. */
  addStyles(styles: string): void;

  // ---- the program ----
  /** Runs pending edits now. */
  flush(): void;
  /** A panel has edited the text: runs it now and fires `gcode-change`. */
  commitEdit(): void;
  /** Replaces the text with the same program in another notation. Undo restores the previous text. */
  rewrite(text: string): void;
  /** Replaces the program in the editor. With `another`, also removes the setup of the previous program. */
  replaceProgram(program: ProgramText, file: ProgramFile | undefined, as: 'another' | 'same'): void;
  /** The program's file or encoding has changed: fires `gcode-change`. */
  notifyFileChanged(): void;
  /** Marks the next change of the text as inserted in one piece, not typed. */
  markAsInserted(): void;
  /** Selects a place of the program and focuses the editor. */
  goTo(span: Span): void;
  /** The user has chosen a stroke: selects its block. */
  chooseStroke(stroke: Stroke, focus: 'focus' | 'keep-focus'): void;
  /** The user has chosen a problem: selects its word, and marks its block and its stroke. */
  chooseProblem(problem: Diagnostic): void;
  /** Fits the pictures again: a presentation has begun or ended. */
  refit(): void;
  /** Tells all panels and the page where the tool is. */
  notifyToolMoved(place: Readout | undefined): void;
  /** Tells the page that the playback has begun or ended. */
  notifyPlaying(state: 'playing' | 'paused'): void;
  /** The playback speed of the attribute `speed`; undefined: the default. */
  readonly speed: Pace | undefined;
  /** The user has chosen another speed, which becomes the attribute. */
  changeSpeed(speed: Pace): void;

  // ---- the setup ----
  /** JSON, as in the attribute. */
  readonly setup: string | null;
  changeSetup(setup: string | null): void;
  /** The user has changed a switch; `switches` are the new attributes. */
  setSwitches(switches: { readonly blockSkip?: string; readonly program?: string }): void;
}
