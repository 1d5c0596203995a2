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
  caption: string | null;
  /** The page that "Open in the playground" leads to; empty: no link. */
  playground: string | null;
  /** The folder of the rule pages. Null: `rules/` next to `element.js`; empty: no links to them. */
  rules: string | null;
  /** The folder of the documents. Null: `docs/` next to `element.js`; empty: no link to them. */
  docs: string | null;
  /** The folder of the pages of the manual. Null: `manual/` next to `element.js`; empty: no link to them. */
  manual: string | null;
  /** Any text with which the page identifies the program. */
  origin: string | null;
  /** Resolves to the number of the run once everything of that run is shown. */
  readonly settled: Promise<number>;
  play(): void;
  pause(): void;
  openFile(file: File): Promise<void>;
  saveFile(): void;
  /** Keeps the current part, to compare the parts of later programs with it. */
  keepPart(): void;
  endComparison(): void;
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

/**
 * Attributes of the element in JSX: its properties, and handlers of its events. For React, use `import type {} from
 * 'gcode-playground/react'`.
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
    | 'caption'
    | 'playground'
    | 'rules'
    | 'docs'
    | 'manual'
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
