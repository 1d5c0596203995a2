// The messages between the page and the worker: nothing else crosses between the two threads.
//
// The page sends commands (no answer) and questions (each with an id and exactly one answer); the worker sends events.
// Every change of text or setup starts a run with its own number, and every event contains the number of its run:
// core-client.ts drops events of earlier runs than the page has requested. The interpreter's types are imported from
// its generated package, never repeated. Must not know: the work of either side.

import type { PartName } from '../../pkg/part-files.js';
import type {
  AnswerReport,
  Calculation,
  CalculatorForm,
  Codes,
  Comparison,
  Converted,
  Diagnostic,
  Dimension,
  DrilledHole,
  ExerciseBlocks,
  ExerciseRead,
  ExerciseText,
  Graded,
  Measurement,
  FileFormat,
  ProfileKind,
  Profiles,
  ReadAs,
  SetupOverview,
  FoundPiece,
  FoundPrograms,
  Palette,
  PictureName,
  ProgramForm,
  Readout,
  Rewriting,
  SectionPiece,
  SetupAnswer,
  SetupForm,
  SetupGroup,
  SetupPlace,
  StepDirection,
  CompletionHelp,
  CompletionItem,
  FormHelp,
  HeldBy,
  OutlineHelp,
  ProgramDifference,
  StateHelp,
  StepUnit,
  StopSwitch,
  Stroke,
  Summary,
  Tidied,
  Totals,
  Units,
  UsesHelp,
  WordHelp,
} from '../../pkg/gcode_playground.js';

export type {
  AnswerReport,
  CalculatorForm,
  Codes,
  Comparison,
  Converted,
  Diagnostic,
  Dimension,
  DrilledHole,
  ExerciseBlocks,
  ExerciseRead,
  ExerciseText,
  Graded,
  Measurement,
  Palette,
  PictureName,
  ProgramForm,
  Readout,
  Rewriting,
  SectionPiece,
  StepDirection,
  StepUnit,
  StopSwitch,
  Stroke,
  Summary,
  Tidied,
  Totals,
  Units,
};
export type { SetupOverview, FoundPiece, FoundPrograms, SetupAnswer, SetupForm, SetupGroup, SetupPlace };
export type { ProfileKind, Profiles, ReadAs };
export type { HeldBy, ProgramDifference };
export type { CompletionHelp, CompletionItem, FormHelp, OutlineHelp, StateHelp, UsesHelp, WordHelp };
export type {
  Calculated,
  CalculatorName,
  FormLine,
  FormWord,
  HelpLine,
  OutlineEntry,
  StateRow,
  Use,
} from '../../pkg/gcode_playground.js';
export type {
  CodeRow,
  Edit,
  Fix,
  FoundProgram,
  ReadFact,
  Setting,
  SetupField,
  SetupState,
} from '../../pkg/gcode_playground.js';

/** A size in CSS pixels, with the device pixel ratio. */
export interface Size {
  readonly width: number;
  readonly height: number;
  readonly pixelRatio: number;
}

/** Which dimensions and letters the section shows. */
export const ANNOTATE_CHOICES = ['none', 'word', 'cycle', 'part'] as const;
export type AnnotateChoice = (typeof ANNOTATE_CHOICES)[number];

/** The side of the spindle on which the turret is drawn. */
type TurretSide = 'front' | 'rear';

/** Commands for a picture; lengths and positions in CSS pixels. */
export type CanvasCommand =
  /** Draw this picture from now on, in this size. */
  | { readonly kind: 'canvas'; readonly size: Size }
  | { readonly kind: 'resize'; readonly size: Size }
  /** The page has lost the image of this picture. */
  | { readonly kind: 'repaint' }
  | { readonly kind: 'fit' }
  | { readonly kind: 'pan'; readonly dx: number; readonly dy: number }
  | { readonly kind: 'zoom'; readonly factor: number; readonly x: number; readonly y: number };

export type { PartName };
/** The URLs of the files of each part. */
export type PartFiles = Readonly<Record<PartName, readonly string[]>>;

/** The compiled module of the interpreter. */
interface Core {
  readonly kind: 'core';
  readonly module: WebAssembly.Module;
}

export type LengthUnit = Units['shown'];

export type Command =
  /** A command for one of the pictures. */
  | { readonly kind: 'picture'; readonly picture: PictureName; readonly command: CanvasCommand }
  | { readonly kind: 'palette'; readonly palette: Palette }
  | { readonly kind: 'language'; readonly tag: Extract<PartName, 'en' | 'zh' | 'ru'> }
  /** The unit in which lengths are shown; undefined: that of the program. */
  | { readonly kind: 'unit'; readonly unit: LengthUnit | undefined }
  | BeginRun
  /** The last picture is shown, or was dropped as one of an earlier run: the next one can be sent. */
  | { readonly kind: 'shown'; readonly dropped: boolean }
  /** Ends the current run. */
  | { readonly kind: 'stop' }
  /** Retries to load the parts that have failed. */
  | { readonly kind: 'load-parts' }
  | { readonly kind: 'cursor'; readonly offset: number | undefined }
  | { readonly kind: 'hover'; readonly motion: number | undefined }
  /** Lines, from 0, end exclusive, whose strokes are highlighted while no block is selected. */
  | { readonly kind: 'mark'; readonly lines: readonly { readonly firstLine: number; readonly endLine: number }[] }
  /** What a picture is fitted to; undefined: the default. */
  | { readonly kind: 'frame'; readonly frame: 'cuts' | 'part' | 'path' | undefined }
  /** Undefined: the side in the setup. */
  | { readonly kind: 'turret'; readonly side: TurretSide | undefined }
  /** Which dimensions and letters the section shows; undefined: the default, the dimension of the word at the cursor. */
  | { readonly kind: 'annotate'; readonly choice: AnnotateChoice | undefined }
  /** Begins or ends measuring in the section. */
  | { readonly kind: 'measuring'; readonly isOn: boolean }
  /** Stores the part, so that later ones are drawn over it. */
  | { readonly kind: 'keep-part' }
  | { readonly kind: 'end-comparison' }
  /** The pointer has left the highlighted edge. */
  | { readonly kind: 'leave-edge' };

/**
 * How a change was made. After `inserted` (paste, open) the interpreter decides again how numbers without a point are
 * read.
 */
export type ChangeSource = 'typed' | 'inserted';

/** The changes of text and setup since the last run; run numbers increase. */
export interface BeginRun extends RunChange {
  readonly kind: 'run';
  readonly run: number;
}

export interface RunChange {
  /** The setup as JSON; undefined: unchanged. */
  readonly setup: string | undefined;
  readonly text: TextCommand | undefined;
  /** All values of variables that the user tries. */
  readonly tried: readonly TriedValue[];
  readonly changeSource: ChangeSource;
  readonly cursor: number | undefined;
  /** `fit` shows another program completely; `keep` keeps pan and zoom. */
  readonly framing: 'fit' | 'keep';
}

/** A tried value of a variable: set before the block at an offset, in one of the times (from 1) that it is executed. */
export interface TriedValue {
  readonly at: number;
  readonly time: number;
  readonly variable: number;
  readonly value: number;
}

/** Offsets refer to the old text; several changes are sorted from the end of the text. */
export interface TextChange {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

/** Updates the text of the worker to that of the editor. */
export type TextCommand =
  /** The whole text; each piece ends after a line end. */
  | { readonly kind: 'text'; readonly pieces: readonly string[] }
  | { readonly kind: 'edit'; readonly changes: readonly TextChange[] };

/** The playback speed: a multiple of real time, or the duration of the whole program in seconds. */
export type Pace =
  | { readonly kind: 'times'; readonly factor: number }
  | { readonly kind: 'whole'; readonly seconds: number };

/**
 * Where the playback pauses: at program stops; after each block (`eachBlock`); before the blocks of these lines, from
 * 0, sorted.
 */
export interface PauseConditions {
  readonly stops: StopSwitch;
  readonly eachBlock: boolean;
  readonly lines: readonly number[];
}

/** The position of the tool, and why the playback paused there. */
export interface PlayResult {
  readonly place: Readout | undefined;
  readonly heldBy: HeldBy;
}

/** The program with every cycle expanded; `tokens` as in the question `tokens`, empty for a very long text. */
/** The new sequence numbers. */
export interface Numbering {
  /** The number of the first block, and the difference to the next one; from 1 on. */
  readonly from: number;
  readonly step: number;
  /** The blocks that get a number; `none` removes the numbers that nothing refers to. */
  readonly blocks: 'numbered' | 'all' | 'none';
}

export interface ExpandedProgram {
  readonly text: string;
  readonly tokens: Uint32Array;
}

/** The export formats: the interpreter's, and the picture as shown. */
export type ExportFormat = FileFormat | 'png';

/** An exported file. `ending` is appended to the name of the program. */
export type ExportResult =
  | { readonly kind: 'file'; readonly content: Uint8Array<ArrayBuffer>; readonly ending: string }
  /** The format contains the part, and there is none. */
  | { readonly kind: 'no-part' };

/** Every question, with its arguments and its answer. */
export interface Questions {
  /** Lines from 0, end exclusive; the answer is triples `from, to, class`. */
  tokens: { args: { readonly firstLine: number; readonly endLine: number }; answer: Uint32Array };
  pick: { args: { readonly picture: PictureName; readonly x: number; readonly y: number }; answer: Stroke | undefined };
  /** The edge of the part in the section at a position. */
  dimension: { args: { readonly x: number; readonly y: number }; answer: Dimension | undefined };
  /** Picks the corner or edge of the section at a position, as the first or second place to measure. */
  measure: { args: { readonly x: number; readonly y: number }; answer: Measurement | undefined };
  /** Plays for a number of seconds, or until the playback pauses. */
  play: {
    args: {
      readonly from: 'here' | 'start';
      readonly seconds: number;
      readonly pace: Pace;
      readonly pauseConditions: PauseConditions;
    };
    answer: PlayResult;
  };
  /** Moves the tool to a fraction of the playback, 0 to 1; undefined shows the whole path. */
  seek: { args: { readonly share: number | undefined }; answer: Readout | undefined };
  /** Moves the tool to the start of the block at this offset, or of the next one with a motion. */
  'seek-block': { args: { readonly offset: number }; answer: Readout | undefined };
  step: { args: { readonly unit: StepUnit; readonly direction: StepDirection }; answer: Readout | undefined };
  /** Moves the tool to the end of a motion. */
  'go-to': { args: { readonly motion: number }; answer: Readout | undefined };
  /** Descriptions of motions, `end` exclusive. */
  strokes: { args: { readonly first: number; readonly end: number }; answer: readonly Stroke[] };
  /** One row for each tool in the order of first use, then one for the whole program. */
  totals: { args: undefined; answer: readonly Totals[] };
  /** The position of the tool, in the current language. */
  readout: { args: undefined; answer: Readout | undefined };
  /**
   * The position of a point in a picture. In the section X (a diameter) and Z, on the face X (a diameter) and C, on the
   * side Z and C in degrees (or Y, if its ruler shows Y); lengths in mm. The answer is in CSS pixels from the top left
   * corner of the picture.
   */
  locate: {
    args: { readonly picture: PictureName; readonly place: readonly [number, number] };
    answer: { readonly x: number; readonly y: number };
  };
  expand: { args: undefined; answer: ExpandedProgram };
  /** Parts of the selected text that can be rewritten as a cycle. */
  rewritings: { args: { readonly from: number; readonly to: number }; answer: readonly Rewriting[] };
  /** The edits that format the program, or why it stays as it is. */
  formatted: { args: undefined; answer: Tidied };
  /** The edits that renumber the program, or why it stays as it is. */
  renumbered: { args: Numbering; answer: Tidied };
  /** The edits that write the program in a form, or why it stays as it is. */
  converted: { args: ProgramForm; answer: Converted };
  codes: { args: undefined; answer: Codes };
  /**
   * The form of a calculator: with the values of the block of the last question at the cursor (undefined if there is a
   * newer run), or with those of its worked example.
   */
  calculator: {
    args: { readonly name: string; readonly at: CalculatorPlace };
    answer: CalculatorForm | undefined;
  };
  /** The results of a calculator for the texts of its fields; a figure only at the cursor. */
  calculate: {
    args: { readonly name: string; readonly fields: readonly string[]; readonly at: CalculatorPlace };
    answer: CalculatorAnswer | undefined;
  };
  /** Undefined if the same asker has sent a newer question meanwhile, or there is a newer run. */
  help: { args: HelpRequest; answer: Help | undefined };
  /** The uses of the number at an offset: a sequence number, a program, a variable. */
  uses: { args: { readonly offset: number }; answer: UsesHelp | undefined };
  /** The outline of the text, and its foldable ranges. */
  outline: { args: undefined; answer: OutlineHelp };
  export: { args: { readonly format: ExportFormat }; answer: ExportResult };
  /** The chart of the speeds of a program without motions, as SVG; undefined if it sets no cutting speed. */
  'speed-chart': { args: undefined; answer: string | undefined };
  /** Reads an exercise file. */
  exercise: {
    args: { readonly text: string };
    answer: { readonly read: ExerciseRead; readonly drawing: string | undefined };
  };
  /** Checks the current program as the answer to an exercise. */
  'check-exercise': { args: { readonly text: string }; answer: Graded | undefined };
  /** The blocks of an exercise whose part the current program makes. */
  'exercise-blocks': { args: undefined; answer: ExerciseBlocks };
  /** Checks another program as an answer; `text`: the exercise file. */
  'grade-answer': { args: { readonly text: string; readonly answer: string }; answer: AnswerReport };
  /** The half-section of the part at the current position of the playback. */
  section: { args: undefined; answer: readonly SectionPiece[] };
  /** The holes drilled by live tools up to that position. */
  holes: { args: undefined; answer: readonly DrilledHole[] };
  /** The programs found in a text; then one of them in pieces. */
  'programs-in': { args: { readonly text: string }; answer: FoundPrograms };
  'pieces-of': { args: { readonly program: number; readonly language: string }; answer: readonly FoundPiece[] };
  /** The differences between another version, which counts as the first, and the program. */
  difference: { args: OtherVersion; answer: DifferenceResult };
  'setup-form': { args: undefined; answer: SetupForm };
  'another-tool': { args: { readonly word: string }; answer: SetupGroup | undefined };
  'read-setup': { args: SetupFormInput; answer: SetupAnswer };
  /** The machine and the tools of a setup; then of the program as it is run. */
  'profiles-in': { args: { readonly json: string }; answer: ProfilesResult };
  'profiles-of-run': { args: { readonly json: string }; answer: Profiles };
  'with-profile': {
    args: { readonly json: string; readonly kind: ProfileKind; readonly profile: string };
    answer: string;
  };
}

/** Where the values of a calculator come from. */
export type CalculatorPlace = 'cursor' | 'example';

export interface CalculatorAnswer {
  readonly calculation: Calculation;
  /** SVG of the program that shows the result; empty without a result. */
  readonly figure: string;
}

/** The part of the page that asks for help: a newer question replaces its last one. */
export type HelpClient = 'pointer' | 'cursor' | 'completion' | 'drawing' | 'motions' | 'presentation';

/**
 * The kind of help: for the word at an offset, for its block (at one of the times it is executed, or the usual one),
 * for completion at an offset, or for the block of a motion.
 */
export type HelpRequest = { readonly by: HelpClient } & (
  | { readonly about: 'word'; readonly offset: number }
  | { readonly about: 'block'; readonly offset: number; readonly time: number | undefined }
  | { readonly about: 'completion'; readonly offset: number; readonly isExplicit: boolean }
  | { readonly about: 'motion'; readonly motion: number }
);

/** The answer; members that were not asked for are missing. */
export interface Help {
  readonly request: HelpRequest;
  readonly word?: WordHelp | undefined;
  readonly form?: FormHelp | undefined;
  readonly state?: StateHelp | undefined;
  readonly completion?: CompletionHelp | undefined;
  /** A description of the block of a motion; empty if there is none. */
  readonly explanation?: string | undefined;
}

/** The profiles contained in a setup, or why it is invalid. */
export type ProfilesResult =
  | { readonly kind: 'profiles'; readonly profiles: Profiles }
  | { readonly kind: 'invalid'; readonly reason: string };

/** Another version of the program; `names` are the display names of that version and of the program. */
export interface OtherVersion {
  readonly text: string;
  readonly names: readonly [string, string];
}

/** The differences between two versions, and the tool paths of both as SVG. */
export interface DifferenceResult {
  readonly rows: ProgramDifference;
  readonly drawing: string;
}

/** The texts in the fields of the setup form; `json` is the current setup of the page. */
interface SetupFormInput {
  readonly keys: readonly string[];
  readonly texts: readonly string[];
  readonly keep: SetupPlace;
  readonly json: string;
}

export type QuestionKind = keyof Questions;

/** Whether the answer to a question is about a run: then it is `undefined` once there is a newer run. */
export const RUN_DEPENDENT = {
  tokens: true,
  pick: true,
  play: true,
  seek: true,
  'seek-block': true,
  step: true,
  'go-to': true,
  strokes: true,
  readout: true,
  totals: true,
  expand: true,
  rewritings: true,
  formatted: true,
  renumbered: true,
  converted: true,
  section: true,
  'speed-chart': true,
  holes: true,
  help: true,
  uses: true,
  outline: true,
  dimension: true,
  measure: true,
  'read-setup': true,
  'profiles-of-run': true,
  difference: true,
  locate: false,
  codes: false,
  calculator: false,
  calculate: false,
  exercise: false,
  'check-exercise': true,
  'exercise-blocks': true,
  'grade-answer': false,
  export: false,
  'programs-in': false,
  'pieces-of': false,
  'setup-form': false,
  'another-tool': false,
  'profiles-in': false,
  'with-profile': false,
} as const satisfies Readonly<Record<QuestionKind, boolean>>;

export type Answer<K extends QuestionKind> = (typeof RUN_DEPENDENT)[K] extends true
  ? Questions[K]['answer'] | undefined
  : Questions[K]['answer'];

export interface Question<K extends QuestionKind = QuestionKind> {
  readonly kind: 'question';
  readonly id: number;
  readonly about: K;
  readonly args: Questions[K]['args'];
}

export type WorkShown = 'blank' | 'chuck' | 'tailstock' | 'collision';

/** The contents of the views. */
export interface ViewsState {
  /** The pictures with content: the section, and each surface with motions on it. */
  readonly pictures: readonly PictureName[];
  /** What the pictures show besides strokes. */
  readonly work: readonly WorkShown[];
  readonly turret: TurretSide;
  /** Undefined unless a part is stored. */
  readonly comparison: Comparison | undefined;
}

export interface ProgramHead {
  readonly number: number;
  /** As written in the program: `O0002`. */
  readonly name: string;
}

export interface SwitchesInText {
  /** Levels, sorted and without repetitions; a slash without a number is level 1. */
  readonly blockSkip: readonly number[];
  /** In the order of the text, without repetitions. */
  readonly programs: readonly ProgramHead[];
}

/** Tasks that can take a noticeable time: running the program, then removing the material. */
export type Work = 'run' | 'part';

/** The complete result of a run; no earlier report is needed. */
export interface Report {
  readonly summary: Summary;
  readonly diagnostics: readonly Diagnostic[];
  readonly overview: SetupOverview;
  /** Control, system, units and switches. */
  readonly readAs: ReadAs;
  /** The rules that the setup switches off individually. */
  readonly rulesOff: readonly string[];
  /** The units for display; all lengths in messages are in mm. */
  readonly units: Units;
  /** How numbers without a point are read, if the user should know. */
  readonly decimal: string | undefined;
  /**
   * `whole`: everything; `path`: without the part, which takes longer; `part`: the part for a path reported before;
   * `repeated`: the last report in another language or unit.
   */
  readonly stage: 'whole' | 'path' | 'part' | 'repeated';
  /** Why the last setup was rejected; the run then used the one before. */
  readonly setupRejected: string | undefined;
  /** Undefined until all material is removed. */
  readonly views: ViewsState | undefined;
  /** Undefined until the whole text was searched; for a long one they are reported later. */
  readonly switches: SwitchesInText | undefined;
}

/** All pictures, in display order. */
export const PICTURES = ['section', 'face', 'side'] as const satisfies readonly PictureName[];

/** One of the pictures, or all that have content. */
export type PictureChoice = PictureName | 'all';

/** The painted images; unchanged pictures are missing. */
export type Pictures = { readonly [K in PictureName]?: ImageBitmap };

/** The scale of the section: positions in CSS pixels from the top left corner of the picture. */
export interface SectionScale {
  /** The position of X0 Z0. */
  readonly origin: readonly [number, number];
  /** CSS pixels to the right for each mm of Z. */
  readonly perZ: number;
  /** CSS pixels downwards for each mm of X, a diameter. */
  readonly perX: number;
}

/** The events of a run. */
export type RunEvent =
  /** The run has ended and its path is drawn; messages and part follow once the parts that compute them are loaded. */
  | { readonly kind: 'path'; readonly summary: Summary }
  /**
   * A part of the interpreter could not be loaded, which is needed for the report of the run or only for something
   * else.
   */
  | { readonly kind: 'part-failed'; readonly reason: string; readonly neededFor: 'the-report' | 'something-else' }
  /** All parts that had failed are loaded. */
  | { readonly kind: 'parts-loaded' }
  /** The page keeps the picture of an earlier run: the block that is being typed is incomplete. */
  | { readonly kind: 'old-picture'; readonly of: number }
  | { readonly kind: 'report'; readonly report: Report }
  /** `done` from 0 to 1; sent only for runs that take a noticeable time. */
  | { readonly kind: 'progress'; readonly work: Work; readonly done: number }
  | { readonly kind: 'views'; readonly views: ViewsState }
  | { readonly kind: 'switches'; readonly inText: SwitchesInText }
  | { readonly kind: 'pictures'; readonly pictures: Pictures; readonly scale: SectionScale }
  /**
   * The run has ended, all material is removed and its last picture is shown; `received` is the number of messages of
   * the page that were received by then.
   */
  | { readonly kind: 'settled'; readonly received: number }
  | { readonly kind: 'answer'; readonly id: number; readonly answer: unknown };

/** An event with the number of its run. */
export type SessionEvent = RunEvent & { readonly run: number };

/** Messages to the worker. Each element of the page has a session there, which is opened by its first message. */
export type ToWorker =
  /** The first message to a worker. */
  | { readonly kind: 'files'; readonly files: PartFiles }
  | Core
  | { readonly kind: 'to-session'; readonly session: number; readonly content: Command | Question }
  | { readonly kind: 'close'; readonly session: number }
  | { readonly kind: 'ping' };

export type FromWorker =
  | { readonly kind: 'ready' }
  | { readonly kind: 'load-failed'; readonly reason: string }
  /** The interpreter threw while processing this session: the worker is unusable. */
  | { readonly kind: 'crashed'; readonly session: number; readonly reason: string }
  /** The worker processes this session until the next such message. */
  | { readonly kind: 'active'; readonly session: number }
  | { readonly kind: 'pong' }
  | { readonly kind: 'event'; readonly session: number; readonly event: SessionEvent };

/**
 * Whether a message may change the display. Both sides count these, so that the page knows which messages were
 * processed.
 */
export function mayChangeDisplay(message: Command | Question): boolean {
  return message.kind !== 'shown';
}
