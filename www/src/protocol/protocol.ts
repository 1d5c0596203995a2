// What the page and the worker say to each other: the only things that cross between the two threads.
//
// Down go commands (state, no answer) and questions (each with an id and exactly one answer); up come events.
// Every change of text or setup begins a run with a number of its own, and whatever comes up names the run it
// belongs to: what belongs to an earlier one than the page has asked for is dropped by core-client.ts, the
// one place where it arrives. The interpreter's own types are taken from its generated package, never written
// again. Must not know: how either side does its work.

import type { PartName } from '../../pkg/part-files.js';
import type {
  Codes,
  Comparison,
  Diagnostic,
  Dimension,
  DrilledHole,
  FileFormat,
  ProfileKind,
  Profiles,
  ReadAs,
  SetupOverview,
  FoundPiece,
  FoundPrograms,
  Palette,
  PictureName,
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
  Totals,
  Units,
  UsesHelp,
  WordHelp,
} from '../../pkg/gcode_playground.js';

export type {
  Codes,
  Comparison,
  Diagnostic,
  Dimension,
  DrilledHole,
  Palette,
  PictureName,
  Readout,
  Rewriting,
  SectionPiece,
  StepDirection,
  StepUnit,
  StopSwitch,
  Stroke,
  Summary,
  Totals,
  Units,
};
export type { SetupOverview, FoundPiece, FoundPrograms, SetupAnswer, SetupForm, SetupGroup, SetupPlace };
export type { ProfileKind, Profiles, ReadAs };
export type { HeldBy, ProgramDifference };
export type { CompletionHelp, CompletionItem, FormHelp, OutlineHelp, StateHelp, UsesHelp, WordHelp };
export type { FormLine, FormWord, HelpLine, OutlineEntry, StateRow, Use } from '../../pkg/gcode_playground.js';
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

/** A size in CSS pixels and the device pixels each of them has. */
export interface Size {
  readonly width: number;
  readonly height: number;
  readonly pixelRatio: number;
}

/** On which side of the spindle the turret is drawn. */
export type TurretSide = 'front' | 'rear';

/** What happens to a picture; lengths and places in CSS pixels. */
export type CanvasCommand =
  /** Pictures of this size are wanted from now on. */
  | { readonly kind: 'canvas'; readonly size: Size }
  | { readonly kind: 'resize'; readonly size: Size }
  /** The page has no image of this picture any more. */
  | { readonly kind: 'paint-again' }
  | { readonly kind: 'fit' }
  | { readonly kind: 'pan'; readonly dx: number; readonly dy: number }
  | { readonly kind: 'zoom'; readonly factor: number; readonly x: number; readonly y: number };

export type { PartName };
/** The addresses of the files of each part. */
export type PartFiles = Readonly<Record<PartName, readonly string[]>>;

/** The compiled module of the interpreter. */
export interface Core {
  readonly kind: 'core';
  readonly module: WebAssembly.Module;
}

export type LengthUnit = Units['shown'];

export type Command =
  /** What happens to one of the pictures. */
  | { readonly kind: 'picture'; readonly picture: PictureName; readonly what: CanvasCommand }
  | { readonly kind: 'palette'; readonly palette: Palette }
  | { readonly kind: 'language'; readonly tag: Extract<PartName, 'en' | 'zh' | 'ru'> }
  /** The unit in which lengths are shown; that of the program where nothing is said. */
  | { readonly kind: 'unit'; readonly unit: LengthUnit | undefined }
  | BeginRun
  /** The last picture is on the page, or was dropped as one of an earlier run: there is room for the next one. */
  | { readonly kind: 'shown'; readonly dropped: boolean }
  /** Ends the run under way. */
  | { readonly kind: 'stop' }
  /** Tries again to load what could not be loaded. */
  | { readonly kind: 'load-parts' }
  | { readonly kind: 'cursor'; readonly offset: number | undefined }
  | { readonly kind: 'hover'; readonly motion: number | undefined }
  /** Lines, from 0, end exclusive, whose strokes are lit up as long as the reader has chosen no block. */
  | { readonly kind: 'mark'; readonly lines: readonly { readonly firstLine: number; readonly endLine: number }[] }
  /** What a fitted picture shows; without it, what is usual. */
  | { readonly kind: 'frame'; readonly frame: 'part' | 'path' | undefined }
  /** Without a side, that of the setup. */
  | { readonly kind: 'turret'; readonly side: TurretSide | undefined }
  /** Keeps the part, to lay later ones over it. */
  | { readonly kind: 'keep' }
  | { readonly kind: 'end-comparison' }
  /** The pointer has left the edge that is marked. */
  | { readonly kind: 'leave-edge' };

/** How a change came: of what was put in at once the interpreter concludes anew how its numbers are meant. */
export type Came = 'typed' | 'at-once';

/** What of text and setup has changed since the run before; numbers of runs grow. */
export interface BeginRun extends RunChange {
  readonly kind: 'run';
  readonly run: number;
}

export interface RunChange {
  /** JSON. */
  readonly setup: string | undefined;
  readonly text: TextCommand | undefined;
  /** All values of variables that the reader tries. */
  readonly tried: readonly TriedValue[];
  readonly came: Came;
  readonly cursor: number | undefined;
  /** Another program is shown whole, wherever the one before was looked at. */
  readonly framing: 'fit' | 'keep';
}

/** What if a variable had another value: it gets it before the block at an offset, one of the times (from 1) that is carried out. */
export interface TriedValue {
  readonly at: number;
  readonly time: number;
  readonly variable: number;
  readonly value: number;
}

/** Offsets are those of the text before; of several changes the last in the text comes first. */
export interface TextChange {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

/** How the text of the worker becomes that of the editor. */
export type TextCommand =
  /** All of it; a piece ends after a line end. */
  | { readonly kind: 'text'; readonly pieces: readonly string[] }
  | { readonly kind: 'edit'; readonly changes: readonly TextChange[] };

/** How fast it plays: so many times as fast as the machine, or the whole program in so many seconds. */
export type Pace =
  | { readonly kind: 'times'; readonly factor: number }
  | { readonly kind: 'whole'; readonly seconds: number };

/** What holds the tool: stops of the program; after each block (`eachBlock`); before the blocks of lines, from 0, in order. */
export interface Holds {
  readonly stops: StopSwitch;
  readonly eachBlock: boolean;
  readonly lines: readonly number[];
}

/** Where the tool is, and what holds it there. */
export interface Played {
  readonly place: Readout | undefined;
  readonly held: HeldBy;
}

/** The program with every cycle expanded; `tokens` as for `tokens`, none when the text is very long. */
export interface WrittenOut {
  readonly text: string;
  readonly tokens: Uint32Array;
}

/** The formats the page can export: those of the interpreter, and the picture as it is shown. */
export type ExportFormat = FileFormat | 'png';

/** An exported file. `ending` follows the name of the program. */
export type Exported =
  | { readonly kind: 'file'; readonly content: Uint8Array<ArrayBuffer>; readonly ending: string }
  /** The format is about the part, and there is none. */
  | { readonly kind: 'no-part' };

/** Every question with what it asks and what it is answered. */
export interface Questions {
  /** Lines from 0, end exclusive; the answer is triples `from, to, class`. */
  tokens: { ask: { readonly firstLine: number; readonly endLine: number }; answer: Uint32Array };
  pick: { ask: { readonly picture: PictureName; readonly x: number; readonly y: number }; answer: Stroke | undefined };
  /** The edge of the part in the section. */
  dimension: { ask: { readonly x: number; readonly y: number }; answer: Dimension | undefined };
  /** The tool goes on for so many seconds, or to where it is held. */
  play: {
    ask: { readonly from: 'here' | 'start'; readonly seconds: number; readonly pace: Pace; readonly holds: Holds };
    answer: Played;
  };
  /**
   * The tool is put where so much of the animation has been shown, 0 to 1; without
   * that, the whole path is shown.
   */
  seek: { ask: { readonly share: number | undefined }; answer: Readout | undefined };
  /** The tool is put at the start of the block at this offset, or of the next one that moves it. */
  'seek-block': { ask: { readonly offset: number }; answer: Readout | undefined };
  step: { ask: { readonly unit: StepUnit; readonly direction: StepDirection }; answer: Readout | undefined };
  /** The tool is put at the end of a motion. */
  'go-to': { ask: { readonly motion: number }; answer: Readout | undefined };
  /** Motions in words: from one, up to another. */
  strokes: { ask: { readonly first: number; readonly end: number }; answer: readonly Stroke[] };
  /** One row for each tool in the order in which they are first used, then one for the whole program. */
  totals: { ask: undefined; answer: readonly Totals[] };
  /** Where the tool is, in the language of now. */
  readout: { ask: undefined; answer: Readout | undefined };
  /**
   * In the section X (a diameter) and Z, on the face X (a diameter) and C, on the side Z and C in degrees (or Y, where its ruler
   * shows that); lengths in mm. The answer is CSS pixels from the picture's top left corner.
   */
  locate: {
    ask: { readonly picture: PictureName; readonly place: readonly [number, number] };
    answer: { readonly x: number; readonly y: number };
  };
  expand: { ask: undefined; answer: WrittenOut };
  /** What can be written as a cycle; offsets of the reader's selection. */
  rewritings: { ask: { readonly from: number; readonly to: number }; answer: readonly Rewriting[] };
  codes: { ask: undefined; answer: Codes };
  /** Nothing where a newer question of the same asker has come meanwhile, or another run. */
  help: { ask: HelpWanted; answer: Help | undefined };
  /** Where the number at an offset is used: a sequence number, a program, a variable. */
  uses: { ask: { readonly offset: number }; answer: UsesHelp | undefined };
  /** The outline of the text, and what of it can be folded. */
  outline: { ask: undefined; answer: OutlineHelp };
  export: { ask: { readonly format: ExportFormat }; answer: Exported };
  /** The half-section of the part at the moment that is shown. */
  section: { ask: undefined; answer: readonly SectionPiece[] };
  /** The holes that live tools have drilled by then. */
  holes: { ask: undefined; answer: readonly DrilledHole[] };
  /** The programs found in a text, and one of them in pieces. */
  'programs-in': { ask: { readonly text: string }; answer: FoundPrograms };
  'pieces-of': { ask: { readonly program: number; readonly language: string }; answer: readonly FoundPiece[] };
  /** What differs between another version, the first, and the program. */
  difference: { ask: OtherVersion; answer: Differed };
  'setup-form': { ask: undefined; answer: SetupForm };
  'another-tool': { ask: { readonly word: string }; answer: SetupGroup | undefined };
  'read-setup': { ask: SetupTyped; answer: SetupAnswer };
  /** Machine and tools of a setup, and of the program as it is run. */
  'profiles-in': { ask: { readonly json: string }; answer: ProfilesRead };
  'profiles-of-run': { ask: { readonly json: string }; answer: Profiles };
  'with-profile': {
    ask: { readonly json: string; readonly kind: ProfileKind; readonly profile: string };
    answer: string;
  };
}

/** Who asks for help: a newer question takes the place of the one before of the same asker. */
export type Asker = 'pointer' | 'cursor' | 'completion' | 'drawing' | 'motions';

/**
 * What help is asked for: the word at an offset, all of its block (as it is carried out for one of its times, or
 * usually), what can be written there, or what the block of a motion does.
 */
export type HelpWanted = { readonly by: Asker } & (
  | { readonly about: 'word'; readonly offset: number }
  | { readonly about: 'block'; readonly offset: number; readonly time: number | undefined }
  | { readonly about: 'completion'; readonly offset: number; readonly askedFor: boolean }
  | { readonly about: 'motion'; readonly motion: number }
);

/** What is known of it; the other members are not there. */
export interface Help {
  readonly asked: HelpWanted;
  readonly word?: WordHelp | undefined;
  readonly form?: FormHelp | undefined;
  readonly state?: StateHelp | undefined;
  readonly completion?: CompletionHelp | undefined;
  /** What the block of a motion does; empty where nothing is to be said. */
  readonly explanation?: string | undefined;
}

/** What of a setup can be kept under a name, or what is wrong with it. */
export type ProfilesRead =
  | { readonly kind: 'profiles'; readonly profiles: Profiles }
  | { readonly kind: 'wrong'; readonly reason: string };

/** Another version of the program; `names` are that of it and that of the program. */
export interface OtherVersion {
  readonly text: string;
  readonly names: readonly [string, string];
}

/** What differs between two versions, and the tool paths of both as SVG. */
export interface Differed {
  readonly rows: ProgramDifference;
  readonly drawing: string;
}

/** The texts in the fields of the setup form; `json` is the setup of the page as it is. */
export interface SetupTyped {
  readonly keys: readonly string[];
  readonly texts: readonly string[];
  readonly keep: SetupPlace;
  readonly json: string;
}

export type QuestionKind = keyof Questions;

/**
 * Questions whose answers hold for a run: once there is another one, the answer is `undefined`. The
 * others' hold as they are.
 */
export const OF_THE_RUN = {
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
  section: true,
  holes: true,
  help: true,
  uses: true,
  outline: true,
  dimension: true,
  'read-setup': true,
  'profiles-of-run': true,
  difference: true,
  locate: false,
  codes: false,
  export: false,
  'programs-in': false,
  'pieces-of': false,
  'setup-form': false,
  'another-tool': false,
  'profiles-in': false,
  'with-profile': false,
} as const satisfies Readonly<Record<QuestionKind, boolean>>;

export type Answer<K extends QuestionKind> = (typeof OF_THE_RUN)[K] extends true
  ? Questions[K]['answer'] | undefined
  : Questions[K]['answer'];

export interface Question<K extends QuestionKind = QuestionKind> {
  readonly kind: 'question';
  readonly id: number;
  readonly about: K;
  readonly ask: Questions[K]['ask'];
}

export type WorkShown = 'blank' | 'chuck' | 'tailstock' | 'collision';

/** What there is to see beside the section. */
export interface ViewsState {
  /** The pictures that show anything: the section, and each surface that something moves over. */
  readonly pictures: readonly PictureName[];
  /** What the pictures show beside strokes. */
  readonly work: readonly WorkShown[];
  readonly turret: TurretSide;
  /** While a part is kept. */
  readonly comparison: Comparison | undefined;
}

export interface ProgramHead {
  readonly number: number;
  /** As it is written: `O0002`. */
  readonly name: string;
}

export interface SwitchesInText {
  /** Levels in order, each once; a slash without a number is 1. */
  readonly blockSkip: readonly number[];
  /** In the order of the text, each once. */
  readonly programs: readonly ProgramHead[];
}

/** What takes a noticeable time: the program is run, then the material taken off. */
export type Work = 'run' | 'part';

/** What a run has found: all of it, so that nothing of an earlier report is needed. */
export interface Report {
  readonly summary: Summary;
  readonly diagnostics: readonly Diagnostic[];
  readonly overview: SetupOverview;
  /** Control, system, units and switches. */
  readonly readAs: ReadAs;
  /** The rules that the setup switches off one by one. */
  readonly rulesOff: readonly string[];
  /** All lengths that cross are mm; this is what they are shown in. */
  readonly units: Units;
  /** How numbers without a point are read, where the reader has to know. */
  readonly decimal: string | undefined;
  /**
   * The whole report; or the path, as the part takes longer; or the part that belongs to the path reported
   * before; or what was reported, in another language or unit.
   */
  readonly stage: 'whole' | 'path' | 'part' | 'again';
  /** Why the setup that was sent last is not the one it ran under. */
  readonly setupRejected: string | undefined;
  /** Known once all material is off. */
  readonly views: ViewsState | undefined;
  /** Known once all of the text was looked at; a long one is reported later. */
  readonly switches: SwitchesInText | undefined;
}

/** All pictures, in the order in which they stand. */
export const PICTURES = ['section', 'face', 'side'] as const satisfies readonly PictureName[];

/** One of the pictures, or all that show anything. */
export type PictureChoice = PictureName | 'all';

/** What was painted; a picture that has not changed is left out. */
export type Pictures = { readonly [K in PictureName]?: ImageBitmap };

/** What is reported of a run. */
export type RunEvent =
  /** The run has ended and its path is drawn; messages and part follow once what makes them is loaded. */
  | { readonly kind: 'path'; readonly summary: Summary }
  /** A part of the interpreter could not be loaded: the report of the run waits for it, or only something else does. */
  | { readonly kind: 'part-failed'; readonly reason: string; readonly neededFor: 'the-report' | 'something-else' }
  /** All parts that could not be loaded have been loaded since. */
  | { readonly kind: 'parts-loaded' }
  /** The picture on the page stays that of an earlier run: the block that is being typed is not whole yet. */
  | { readonly kind: 'old-picture'; readonly of: number }
  | { readonly kind: 'report'; readonly report: Report }
  /** `done` from 0 to 1; sent only for runs that take a noticeable time. */
  | { readonly kind: 'progress'; readonly work: Work; readonly done: number }
  | { readonly kind: 'views'; readonly views: ViewsState }
  | { readonly kind: 'switches'; readonly inText: SwitchesInText }
  | { readonly kind: 'pictures'; readonly pictures: Pictures }
  /**
   * The run has ended, all material is off, and its last picture is shown; so many messages of
   * the page were heard by then.
   */
  | { readonly kind: 'settled'; readonly heard: number }
  | { readonly kind: 'answer'; readonly id: number; readonly answer: unknown };

/** What is reported of a run, with its number. */
export type SessionEvent = RunEvent & { readonly run: number };

/**
 * To the worker. Each element of the page has a session there, which begins with what is first said in it.
 */
export type ToWorker =
  /** The first thing a worker hears. */
  | { readonly kind: 'files'; readonly files: PartFiles }
  | Core
  | { readonly kind: 'say'; readonly session: number; readonly what: Command | Question }
  | { readonly kind: 'close'; readonly session: number }
  | { readonly kind: 'ping' };

export type FromWorker =
  | { readonly kind: 'ready' }
  | { readonly kind: 'load-failed'; readonly reason: string }
  /** The interpreter threw while it was at work for this session: the worker is of no further use. */
  | { readonly kind: 'crashed'; readonly session: number; readonly reason: string }
  /** From here on until the next one, it is this session that the worker is at work for. */
  | { readonly kind: 'at-work'; readonly session: number }
  | { readonly kind: 'pong' }
  | { readonly kind: 'event'; readonly session: number; readonly event: SessionEvent };

/**
 * Whether a message may change what is shown: these are counted on both sides, so that the
 * page knows what was heard.
 */
export function counts(message: Command | Question): boolean {
  return message.kind !== 'shown';
}
