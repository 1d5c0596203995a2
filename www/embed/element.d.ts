import type { Diagnostic, FileFormat, ProgramDifference, Readout, Stroke, Summary } from './node/gcode_playground.js';
import type { Setup } from './node/setup.js';

export type { Diagnostic, FileFormat, ProgramDifference, Readout, Stroke, Summary };
export type {
  Setup,
  SetupDialect,
  SetupLimits,
  SetupMachine,
  SetupPosition,
  SetupStock,
  SetupTailstock,
  SetupTool,
  SetupTravel,
} from './node/setup.js';

/** The file that a program came from. */
export interface ProgramFile {
  readonly name: string;
  readonly encoding: 'utf-8' | 'utf-8-bom' | 'utf-16le' | 'utf-16be' | 'gb18030' | 'windows-1251' | 'windows-1252';
}

/** A program and its file. The text keeps its original line ends. */
export interface OpenedProgram {
  readonly text: string;
  readonly file: ProgramFile | undefined;
}

/**
 * A position of the tool: a fraction of the playback, 0 to 1; the end of a motion, from 1 (0: the start of the program);
 * or the start of a line, from 1.
 */
export type SeekTarget = { readonly share: number } | { readonly motion: number } | { readonly line: number };

/** The cursor: line and column in UTF-16 code units, from 1, and the offset into `opened.text`. */
export interface CursorPlace {
  readonly line: number;
  readonly column: number;
  readonly offset: number;
}

/** A failure. */
export interface PlaygroundError {
  /**
   * The setup was not accepted; the program of `src`, or this part of the element, was not loaded; or the interpreter
   * was stopped.
   */
  readonly kind: 'setup' | 'source' | 'interpreter' | 'parts' | 'panels' | 'editor' | 'completion';
  /** The reason alone. For a stopped interpreter: `silent` (the run took too long) or `crashed`. */
  readonly reason: string;
  /** The sentence that the element shows, in its language. */
  readonly message: string;
}

/**
 * A lathe program, its drawing, its problems, and the tool moving along it. Reference: `docs/element.html` of the site.
 */
export class GcodePlayground extends HTMLElement {
  /** The program, with `\n` line ends. Setting it fires no event; setting the same text has no effect. */
  value: string;
  /** The program with its original line ends, and its file. Offsets in events refer to this text. */
  get opened(): OpenedProgram;
  set opened(opened: OpenedProgram);
  /** The file that the program came from. */
  readonly file: ProgramFile | undefined;
  /** Length of the program in UTF-16 code units; each line end counts as one. */
  readonly length: number;
  /** The control. Overrides `dialect.control` of the setup. */
  control: string | null;
  /** Everything that is not in the program: JSON, or an object when assigned. */
  get setup(): string | null;
  set setup(setup: Setup | string | null);
  /** The levels of block skip that are on: `1,2`. */
  blockSkip: string | null;
  /** The O number of the program to run. */
  program: string | null;
  /** Address of the program file. */
  src: string | null;
  /** When the element starts: near the viewport, immediately, or on a click. */
  loading: 'lazy' | 'eager' | 'click';
  language: 'en' | 'zh' | 'ru';
  theme: string;
  view: 'all' | 'picture' | 'playback' | 'code';
  /** Groups of panels around program and drawing: names, or `none`. Null: all groups of the view. */
  controls: string | null;
  /** Whether the program is read-only. */
  readonly: boolean;
  /** Initial tool position: after `12` motions, or before `line 8`. */
  step: string | null;
  /** Lines to mark, with their strokes: `6-8, 12`. */
  highlight: string | null;
  /** Lines to show; the others are folded. */
  lines: string | null;
  fit: string | null;
  turret: string | null;
  /** The dimensions and letters in the picture: `none`, `word`, `cycle` or `part`. */
  annotate: string | null;
  /** A calculator over the program, such as `r-of-g90`; its result becomes the program. */
  calculator: string | null;
  /** The address of an exercise, whose task is shown over the program. */
  exercise: string | null;
  caption: string | null;
  /** The page that "Open in the playground" leads to; empty: no link. */
  playground: string | null;
  /** The folder of the rule pages. Null: `rules/` next to `element.js`; empty: no links to them. */
  rules: string | null;
  /** The folder of the documents. Null: `docs/` next to `element.js`; empty: no link to them. */
  docs: string | null;
  /** The folder of the pages of the manual. Null: `manual/` next to `element.js`; empty: no link to them. */
  manual: string | null;
  /** The playback speed: a multiple of the machine's speed, `5`, or the duration of the whole program, `20 s`. */
  get speed(): string | null;
  set speed(speed: string | number | null);
  /** `auto`: the element is as high as its contents. */
  height: string | null;
  /** The least number of lines of the program for which an element with `height="auto"` has room. */
  get rowsMin(): string | null;
  set rowsMin(rows: string | number | null);
  /** The largest number of lines; a longer program scrolls. */
  get rowsMax(): string | null;
  set rowsMax(rows: string | number | null);
  /** Any text with which the page identifies the program. */
  origin: string | null;
  /** Resolves to the number of the run once everything of that run is shown. */
  readonly settled: Promise<number>;
  /** The problems of the current program, frozen, with offsets into `opened.text`; empty until it is checked. */
  readonly diagnostics: readonly Diagnostic[];
  /** Figures of the current program, frozen; undefined until it is checked. */
  readonly summary: Summary | undefined;
  /** Whether the tool is moving along the path. */
  readonly playing: boolean;
  /** The position of the tool, frozen, with offsets into `opened.text`; undefined if the whole path is shown. */
  readonly readout: Readout | undefined;
  /** Plays from the position of the tool, or from the start. */
  play(): void;
  pause(): void;
  /**
   * Moves the tool, once the program has run. Null shows the whole path. Resolves to the position of the tool; undefined
   * if the whole path is shown. Throws a `RangeError` for an impossible position.
   */
  seek(to: SeekTarget | null): Promise<Readout | undefined>;
  /** Opens a file as the program; undo restores the replaced one. */
  openFile(file: File): Promise<void>;
  /** Saves the program as a file, in the encoding and with the line ends of its file. */
  saveFile(): void;
  /** Keeps the current part, to compare the parts of later programs with it. */
  keepPart(): void;
  /** Ends the comparison that `keepPart` began. */
  endComparison(): void;
  /** Checks the program as the answer to the exercise, as a click on "Check" does. */
  checkExercise(): void;
  /** The tool position, in the format of `step`; null if the whole path is shown. */
  currentStep(): Promise<string | null>;
  /** The line of the cursor, from 1. */
  readonly cursorLine: number;
  /** Moves the cursor to a line, from 1, and marks it. */
  goToLine(line: number): void;
  /**
   * A file of the menu "Export"; undefined if it cannot be made, for example the profile of a program without a part.
   */
  exported(format: FileFormat | 'png'): Promise<Uint8Array | undefined>;
  /**
   * The differences from another version to the program, and the tool paths of both as SVG. The other version is the
   * old one.
   */
  differenceFrom(other: {
    readonly text: string;
    readonly names: readonly [string, string];
  }): Promise<{ readonly rows: ProgramDifference; readonly drawing: string } | undefined>;
  /** The complete setup that the program is run with, JSON; undefined if it is invalid. */
  readonly wholeSetup: string | undefined;
  /** The drawing, or the picture as it is shown. */
  pictureFile(format: 'svg' | 'png'): Promise<Blob | undefined>;
  /** The point X (a diameter), Z in the section, both mm, as a point of the window. */
  locate(x: number, z: number): Promise<{ readonly clientX: number; readonly clientY: number }>;
  /** A point of the end face as a point of the window: X a diameter, C in mm. */
  locateOnFace(x: number, c: number): Promise<{ readonly clientX: number; readonly clientY: number }>;
  /** A point of the side as a point of the window: Z in mm, C in degrees; or Y in mm if its ruler shows Y. */
  locateOnSide(z: number, c: number): Promise<{ readonly clientX: number; readonly clientY: number }>;
}

/** Replaces marked `script` and `pre` elements that were added to the page after it was parsed. */
export function upgrade(root?: ParentNode): void;

/** The events of the element. They bubble. */
export interface GcodePlaygroundEvents {
  /** The reader has changed the program. */
  'gcode-change': CustomEvent<{ readonly value: string }>;
  /** The reader has moved the cursor. */
  'gcode-cursor': CustomEvent<CursorPlace>;
  /** The program is checked. Until the part is machined, `complete` is false and messages about collisions are missing. */
  'gcode-report': CustomEvent<{
    readonly summary: Summary;
    readonly diagnostics: readonly Diagnostic[];
    readonly complete: boolean;
  }>;
  /** Everything of a run is shown. */
  'gcode-settled': CustomEvent<{ readonly run: number }>;
  /** The task of an exercise is shown, or shown again in another language. */
  'gcode-exercise': CustomEvent<{
    readonly id: string;
    readonly version: string;
    readonly title: string;
    /** The program that the learner begins with. */
    readonly program: string;
  }>;
  /** The program of an exercise was checked; `hints` is the number of open hints. */
  'gcode-checked': CustomEvent<{
    readonly id: string;
    /** The checksum of the exercise file. */
    readonly version: string;
    readonly passed: boolean;
    readonly hints: number;
    readonly checks: readonly { readonly name: string; readonly passed: boolean }[];
  }>;
  /** A setup was not accepted, or something could not be loaded. */
  'gcode-error': CustomEvent<PlaygroundError>;
  /** The playback has begun. */
  'gcode-play': CustomEvent<{ readonly readout: Readout | undefined }>;
  /** The playback has paused or ended. */
  'gcode-pause': CustomEvent<{ readonly readout: Readout | undefined }>;
  /** The tool is in another motion, or was moved within it. */
  'gcode-step': CustomEvent<{ readonly readout: Readout | undefined }>;
  /** The reader has selected a stroke of the drawing. */
  'gcode-select': CustomEvent<{ readonly stroke: Stroke }>;
  /** The reader has changed block skip or the program that is run. */
  'gcode-switch': CustomEvent<{ readonly blockSkip: string | null; readonly program: string | null }>;
  /** The setup form has changed the attribute `setup`. */
  'gcode-setup': CustomEvent<{ readonly setup: string | null }>;
  /** The reader has followed an introductory hint; `left` are the remaining ones. */
  'gcode-hint': CustomEvent<{ readonly left: string }>;
  /** The reader has dragged the line between program and drawing; `split` is the program's share in percent. */
  'gcode-split': CustomEvent<{ readonly split: string }>;
  /** The reader has replaced the program by another one, or undo has restored one. The attributes have these values. */
  'gcode-context': CustomEvent<{
    readonly control: string | null;
    readonly setup: string | null;
    readonly blockSkip: string | null;
    readonly program: string | null;
    readonly origin: string | null;
  }>;
}

/**
 * Attributes of the element in JSX: its properties, and handlers of its events. `import type {} from
 * 'gcode-playground/react'` (or `preact`, `solid`) adds the element to the JSX of the framework.
 */
export type GcodePlaygroundProps = Partial<
  Pick<
    GcodePlayground,
    | 'value'
    | 'src'
    | 'control'
    | 'blockSkip'
    | 'program'
    | 'loading'
    | 'language'
    | 'theme'
    | 'view'
    | 'controls'
    | 'readonly'
    | 'step'
    | 'highlight'
    | 'lines'
    | 'fit'
    | 'turret'
    | 'annotate'
    | 'calculator'
    | 'exercise'
    | 'caption'
    | 'playground'
    | 'rules'
    | 'docs'
    | 'manual'
    | 'height'
    | 'origin'
  >
> & {
  readonly setup?: Setup | string | null;
  readonly speed?: string | number | null;
  readonly rowsMin?: string | number | null;
  readonly rowsMax?: string | number | null;
} & { readonly [Event in keyof GcodePlaygroundEvents as `on${Event}`]?: (event: GcodePlaygroundEvents[Event]) => void };

declare global {
  interface HTMLElementTagNameMap {
    'gcode-playground': GcodePlayground;
  }
  interface HTMLElementEventMap extends GcodePlaygroundEvents {}
}
