import type { Diagnostic, FileFormat, ProgramDifference, Stroke, Summary } from './node/gcode_playground.js';
import type { Setup } from './node/setup.js';

export type { Diagnostic, FileFormat, ProgramDifference, Stroke, Summary };
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

/** The file a program came from. */
export interface ProgramFile {
  readonly name: string;
  readonly encoding: 'utf-8' | 'utf-8-bom' | 'utf-16le' | 'utf-16be' | 'gb18030' | 'windows-1251' | 'windows-1252';
}

/** A program and its file; the text has its own line ends. */
export interface OpenedProgram {
  readonly text: string;
  readonly file: ProgramFile | undefined;
}

/** A lathe program, its drawing, its problems, and the tool moving along it. `docs/element.html` of the site describes all of it. */
export class GcodePlayground extends HTMLElement {
  /** The program; each line end is `\n`. Setting it fires no event; the text it has already changes nothing. */
  value: string;
  /** The program as it was given, with its own line ends, and its file. Offsets in events count in this text. */
  get opened(): OpenedProgram;
  set opened(opened: OpenedProgram);
  /** The file the program came from. */
  readonly file: ProgramFile | undefined;
  /** UTF-16 units of the program, every line end counted as one. */
  readonly length: number;
  /** The control; overrides `dialect.control` of the setup. */
  control: string | null;
  /** What is not in the program, as JSON; an object can be assigned. */
  get setup(): string | null;
  set setup(setup: Setup | string | null);
  /** The levels of block skip that are on: `1,2`. */
  blockSkip: string | null;
  /** The O number that is run. */
  program: string | null;
  /** The file of the program. */
  src: string | null;
  /** When it starts: near the view, at once, or when the reader clicks. */
  loading: 'lazy' | 'eager' | 'click';
  language: 'en' | 'zh' | 'ru';
  theme: string;
  view: 'all' | 'picture' | 'playback' | 'code';
  /** Which groups of panels stand around program and drawing: names, or `none`; all of the view where it is null. */
  controls: string | null;
  /** The reader cannot change the program. */
  readonly: boolean;
  /** Where the tool stands at the start: `12` motions on, or before `line 8`. */
  step: string | null;
  /** Lines that are marked, with their strokes: `6-8, 12`. */
  highlight: string | null;
  /** Lines that are shown; the others are folded. */
  lines: string | null;
  fit: string | null;
  turret: string | null;
  caption: string | null;
  /** The page that "Open in the playground" leads to; none where it is empty. */
  playground: string | null;
  /** The folder of the rule pages, `rules/` beside `element.js` where it is null; no links to them where it is empty. */
  rules: string | null;
  /** The folder of the documents, `docs/` beside `element.js` where it is null; no link to them where it is empty. */
  docs: string | null;
  /** Any text by which the page knows whose the program is. */
  origin: string | null;
  /** Resolved with the number of the run once all there is to show of it is shown. */
  readonly settled: Promise<number>;
  play(): void;
  pause(): void;
  openFile(file: File): Promise<void>;
  saveFile(): void;
  /** Keeps the part, to lay those of later programs over it. */
  keepPart(): void;
  endComparison(): void;
  /** Where the tool stands, as `step` says it; null where all of the path is shown. */
  currentStep(): Promise<string | null>;
  /** The line of the cursor, from 1. */
  readonly cursorLine: number;
  /** Puts the cursor into a line, from 1, and marks it. */
  goToLine(line: number): void;
  /** A file of the menu "Export"; nothing where there is none, such as the profile of a program without a part. */
  exported(format: FileFormat | 'png'): Promise<Uint8Array | undefined>;
  /** What differs between another version, the first, and the program, and the tool paths of both as SVG. */
  differenceFrom(other: {
    readonly text: string;
    readonly names: readonly [string, string];
  }): Promise<{ readonly rows: ProgramDifference; readonly drawing: string } | undefined>;
  /** All of the setup the program is run with, as JSON; nothing where it cannot be read. */
  readonly wholeSetup: string | undefined;
  /** The drawing, or the picture as it is shown. */
  pictureFile(format: 'svg' | 'png'): Promise<Blob | undefined>;
  /** Where the place X (a diameter), Z in mm is in the window. */
  locate(x: number, z: number): Promise<{ readonly clientX: number; readonly clientY: number }>;
  /** The same of the end face: X a diameter, C in mm. */
  locateOnFace(x: number, c: number): Promise<{ readonly clientX: number; readonly clientY: number }>;
  /** The same of the side: Z in mm, C in degrees; or Y in mm where its ruler shows Y. */
  locateOnSide(z: number, c: number): Promise<{ readonly clientX: number; readonly clientY: number }>;
}

/** Puts elements in the place of marked scripts and `pre`s that have come into the page after it was read. */
export function upgrade(root?: ParentNode): void;

export interface GcodePlaygroundEvents {
  'gcode-change': CustomEvent<{ readonly value: string }>;
  'gcode-report': CustomEvent<{ readonly summary: Summary; readonly diagnostics: readonly Diagnostic[] }>;
  'gcode-settled': CustomEvent<{ readonly run: number }>;
  'gcode-select': CustomEvent<{ readonly stroke: Stroke }>;
  'gcode-switch': CustomEvent<{ readonly blockSkip: string | null; readonly program: string | null }>;
  'gcode-setup': CustomEvent<{ readonly setup: string | null }>;
  'gcode-hint': CustomEvent<{ readonly left: string }>;
  'gcode-split': CustomEvent<{ readonly split: string }>;
  'gcode-context': CustomEvent<{
    readonly control: string | null;
    readonly setup: string | null;
    readonly blockSkip: string | null;
    readonly program: string | null;
    readonly origin: string | null;
  }>;
}

/** What JSX can give the element: its properties, and handlers of its events. React knows them with `import type {} from 'gcode-playground/react'`. */
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
    | 'caption'
    | 'playground'
    | 'rules'
    | 'docs'
    | 'origin'
  >
> & {
  readonly setup?: Setup | string | null;
} & { readonly [Event in keyof GcodePlaygroundEvents as `on${Event}`]?: (event: GcodePlaygroundEvents[Event]) => void };

declare global {
  interface HTMLElementTagNameMap {
    'gcode-playground': GcodePlayground;
  }
  interface HTMLElementEventMap extends GcodePlaygroundEvents {}
}
