// What a panel is, and what it may ask of the shell around it.
//
// A panel is one thing on the page: a button with its dialog, a bar, the pictures. It is one file of this
// folder, with its words in all languages at the end of the file, its styles beside it in a style sheet of
// the same name, and one line in the list of `further.ts`. What is too large for one file, or is loaded when it
// is first needed, is a component beside it, with its own words. A panel knows the shell by `Shell`, and
// other panels by the services they offer. Must not know: where text and setup are kept, or how runs begin.

import type { Language } from '../dom/language';
import type { Span } from '../editor/holder';
import type { Program } from '../editor/program';
import type { ProgramFile, ProgramText } from '../editor/program-text';
import type {
  Answer,
  Command,
  Diagnostic,
  Exported,
  ExportFormat,
  PictureName,
  Pictures,
  QuestionKind,
  Questions,
  Readout,
  Setting,
  SetupGroup,
  StepDirection,
  StepUnit,
  Stroke,
} from '../protocol/protocol';
import type { Heard } from '../worker/core-client';

/**
 * Where panels stand, in the order of the list: the tabs of an element with little room; over, beside and under the editor, between it and the pictures, around these, in the line at the foot.
 */
export const REGIONS = [
  'tabs',
  'notices',
  'bar',
  'problems',
  'divider',
  'views',
  'assumptions',
  'pictures',
  'playback',
  'foot',
  'dialogs',
] as const;
export type Region = (typeof REGIONS)[number];

/** What of the panels the page around can leave out. */
export const CONTROLS = ['file', 'setup', 'problems', 'views', 'playback', 'status', 'tools', 'help', 'link'] as const;
export type Control = (typeof CONTROLS)[number];

export interface PanelKind {
  /** It is shown only where these are; one without is always shown. */
  readonly control?: Control;
  /** It is there to change the program, and is not shown where that is only read. */
  readonly edits?: true;
  /** Its own style sheet. */
  readonly styles?: string;
  /** Called once for each element, when other panels may not be there. */
  make(shell: Shell): Panel;
}

export interface Panel {
  /** What stands where. */
  readonly places: { readonly [R in Region]?: readonly HTMLElement[] };
  /** Shows its words in a language; set once all panels are made, then with each change. */
  set language(language: Language);
  /** Whether there is a finished run with motions; what needs one is out of reach until then. */
  available?: boolean;
  /** A dialog of it is open that all keys belong to. */
  readonly takesKeys?: boolean;
  readonly services?: Partial<Services>;

  /** A key that no dialog takes; says whether it was the panel's own. */
  pressed?(key: Key): 'own' | 'not-own';
  /** What the worker reports of the newest run. */
  heard?(event: Heard): void;
  /** Pictures of the newest run; the images are the panel's. */
  showPictures?(pictures: Pictures): void;
  /** The reader has moved the cursor, or typed. */
  cursorMoved?(): void;
  /** The reader tries other values of variables. */
  triedChanged?(): void;
  /** The tool is somewhere else, or nowhere. */
  toolMoved?(place: Readout | undefined): void;
  /** Another program is put in the place of the one that is there. */
  programReplaced?(): void;
  /** A text has come into the editor at once, between these offsets. */
  textArrived?(from: number, to: number): void;
  /** The reader is to see the program now: it gets the focus. */
  programWanted?(): void;
  /** The text belongs to another file, or its file has another name or encoding. */
  fileChanged?(file: ProgramFile | undefined): void;
  /** How the switches stand in attributes and setup. */
  switched?(set: SwitchesSet): void;
  /** The theme, or the colours of the system, are others. */
  coloursChanged?(): void;
  /** Text or setup have changed: what is shown of the run before must not meet them. */
  outdated?(): void;
  /** The newest run is under way. */
  begun?(): void;
  /** The newest run is neither reported nor under way: something that it needs could not be loaded, or has failed. */
  unreported?(): void;
  /** There is a new worker, which knows nothing yet. */
  connected?(send: (command: Command) => void): void;
  /** The worker was lost, and with it all that was known of the run. */
  lost?(): void;
  /** The element has left the document. */
  left?(): void;
}

/** A key, and whether it was pressed where text is typed. */
export interface Key {
  readonly event: KeyboardEvent;
  readonly inside: 'text' | 'elsewhere';
}

/** How the switches of the operator's panel stand. */
export interface SwitchesSet {
  /** Levels that are on. */
  readonly blockSkip: readonly number[];
  /** The program to run; the first of the text when undefined. */
  readonly program: number | undefined;
}

/** Whether a key was pressed in the program, be it one that is only read. */
export function isInProgram({ inside }: Key, { root }: Shell): boolean {
  return inside === 'text' || (root.activeElement?.closest('.editor') ?? null) !== null;
}

/** A place in the window, CSS pixels. */
export interface ClientPlace {
  readonly clientX: number;
  readonly clientY: number;
}

/** Topics of notices. Another run hides `program`. `missing` has a separate line, which stays until everything works. */
export type Topic = 'file' | 'program' | 'program-setup' | 'setup' | 'editor' | 'source' | 'late' | 'missing';

/** A button of a notice: what can be done about it. */
export interface Remedy {
  readonly title: string;
  act(): void;
}

/** What one panel does for others, for the shell, or for the page around the element. */
export interface Services {
  notice(text: string, topic?: Topic, remedy?: Remedy): void;
  hideNotice(topic: Topic): void;
  play(): void;
  pause(): void;
  playOrPause(): void;
  /** The tool goes on, or back, by one of these. */
  step(unit: StepUnit, direction: StepDirection): void;
  /** Puts the tool at the end of a motion. */
  goTo(motion: number): Promise<void>;
  /** Puts the tool at the start of the block at an offset, or of the next one that moves it. */
  goToBlock(offset: number): Promise<void>;
  /** The block of the cursor alone is played. */
  playBlock(): void;
  /** Plays on to the block of the cursor. */
  playToCursor(): void;
  /** The tool is held before the line of the cursor, or no longer. */
  toggleBreakpoint(): void;
  openFile(file: File): Promise<void>;
  saveFile(): void;
  /** A file as the menu "Export" makes it, without saving it; undefined where there is no worker. */
  exported(format: ExportFormat): Promise<Exported | undefined>;
  /** Where a place of a picture is, given as the question `locate` has it. */
  locate(picture: PictureName, ...place: readonly [number, number]): Promise<ClientPlace>;
  /** Shows these pictures. */
  showOnly(pictures: readonly PictureName[]): void;
  /** Keeps the part, to lay later ones over it. */
  keepPart(): void;
  /** Ends the comparison that `keepPart` began, not one that the reader began. */
  endComparison(): void;
  openCodes(): void;
  /** `group` and `key`: the group and the field the reader comes for. */
  openSetup(group?: SetupGroup['group'], key?: string): void;
  /** The button that opens the outline of the program. */
  outlineButton(): HTMLElement;
  /** Where the number at the cursor is used: empty where none stands there. */
  usesSection(): HTMLElement;
  /** The button that says which machine the program is run on. */
  machineButton(): HTMLElement;
  /** The setup that programs of the reader's own begin with, as JSON. */
  ownSetup(): string | null;
  /** Puts a setting in the setup, where it is kept now; what only the reader knows is entered in the form. */
  takeSetting(setting: Setting): void;
}

/** Asks with the newest value only, see `Newest`; goes on with the next worker when one is lost. */
export interface NewestQuestion<K extends QuestionKind> {
  ask(ask: Questions[K]['ask']): void;
  forget(): void;
}

export interface Shell {
  readonly root: ShadowRoot;
  /** The program, and the editor it stands in. */
  readonly editor: Program;
  readonly language: Language;
  /** The reader cannot change the program. */
  readonly readonly: boolean;
  /** The program is shown, not only what comes of it. */
  readonly showsProgram: boolean;
  /** What all regions stand in. */
  readonly frame: HTMLElement;
  /** What the panels of a region stand in. */
  region(region: Region): HTMLElement;
  service<S extends keyof Services>(name: S): Services[S];

  // ---- the worker, which knows of all changes before it hears what is sent ----
  send(command: Command): void;
  /** Undefined where there is no worker; stays open where the worker is lost. */
  ask<K extends QuestionKind>(about: K, ask: Questions[K]['ask']): Promise<Answer<K> | undefined>;
  newest<K extends QuestionKind>(about: K, answered: (answer: Answer<K>) => void): NewestQuestion<K>;

  // ---- the program ----
  /** What was typed a moment ago is run now. */
  flush(): void;
  /** A panel has edited the text: it is run now, and `gcode-change` is fired. */
  edited(): void;
  /** The same program written differently: undo brings back what was there. */
  rewrite(text: string): void;
  /** A program takes the place of the one in the editor; the setup of the one before goes with `another`. */
  take(program: ProgramText, file: ProgramFile | undefined, as: 'another' | 'same'): void;
  /** The program's file or encoding is another one: `gcode-change` is fired. */
  changed(): void;
  /** The next change of the text is put in at once, not typed. */
  cameAtOnce(): void;
  /** The reader wants to see a place of the program: it is selected, and has the focus. */
  goTo(span: Span): void;
  /** The reader has chosen a stroke: its block is selected. */
  choose(stroke: Stroke, focus: 'focus' | 'keep-focus'): void;
  /** The reader has chosen a problem: its word is selected, its block and its stroke are marked. */
  chooseProblem(problem: Diagnostic): void;
  /** Lets all panels know where the tool is. */
  toolMoved(place: Readout | undefined): void;

  // ---- the setup ----
  /** JSON, as the attribute has it. */
  readonly setup: string | null;
  changeSetup(setup: string | null): void;
  /** The reader has turned a switch: attributes as they are to be. */
  turn(switches: { readonly blockSkip?: string; readonly program?: string }): void;
}
