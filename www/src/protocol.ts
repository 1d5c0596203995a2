// What the page and the worker say to each other: the only things that cross between the two threads.
//
// Down go commands (state, no answer) and questions (each with an id and exactly one answer);
// up come events. The interpreter's own types are taken from its generated package, never written again.
// Must not know: how either side does its work.

import type {
  Codes, Diagnostic, Fitted, FoundPiece, FoundPrograms, Palette, Readout, Rewriting, SectionPiece, SetupAnswer, SetupForm, SetupGroup, SetupPlace, StepDirection,
  StepUnit, StopSwitch, Stroke, Summary,
} from '../pkg/gcode_playground.js';
import type { ViewCommand, ViewQuestions, ViewsState } from './protocol-views';
import type { SwitchesInText } from './switches-in-text';

export type { Codes, Diagnostic, Palette, Readout, Rewriting, SectionPiece, StepDirection, StepUnit, StopSwitch, Stroke, Summary };
export type { Fitted, FoundPiece, FoundPrograms, SetupAnswer, SetupForm, SetupGroup, SetupPlace };
export type { CodeRow, Edit, Fix, FoundProgram, SetupField, SetupState } from '../pkg/gcode_playground.js';

/** A size in CSS pixels and the device pixels each of them has. */
export interface Size {
  readonly width: number;
  readonly height: number;
  readonly pixelRatio: number;
}

export type Command =
  | { readonly kind: 'canvas'; readonly canvas: OffscreenCanvas; readonly size: Size; readonly palette: Palette }
  | { readonly kind: 'resize'; readonly size: Size }
  | { readonly kind: 'palette'; readonly palette: Palette }
  | { readonly kind: 'language'; readonly tag: string }
  | { readonly kind: 'setup'; readonly json: string }
  /** `revision` comes back with the report, so that a report on older text can be told apart. */
  | (TextCommand & { readonly revision: number; readonly cursor: number | undefined; readonly came: Came })
  /** Ends the run under way. */
  | { readonly kind: 'stop' }
  | { readonly kind: 'cursor'; readonly offset: number | undefined }
  | { readonly kind: 'hover'; readonly motion: number | undefined }
  | ViewCommand
  | { readonly kind: 'fit' }
  /** CSS pixels. */
  | { readonly kind: 'pan'; readonly dx: number; readonly dy: number }
  | { readonly kind: 'zoom'; readonly factor: number; readonly x: number; readonly y: number };

/** How a change came: of what was put in at once the interpreter concludes anew how its numbers are meant. */
export type Came = 'typed' | 'at-once';

/** Offsets are those of the text before; of several changes the last in the text comes first. */
export interface TextChange {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

/** How the text of the worker becomes that of the editor. */
export type TextCommand =
  /** All of it; a piece ends behind a line end. */
  | { readonly kind: 'text'; readonly pieces: readonly string[] }
  | { readonly kind: 'edit'; readonly changes: readonly TextChange[] };

/** How fast it plays: so many times as fast as the machine, or the whole program in so many seconds. */
export type Pace = { readonly kind: 'times'; readonly factor: number } | { readonly kind: 'whole'; readonly seconds: number };

/** The program with every cycle written out; `tokens` as for `tokens`, none when the text is very long. */
export interface WrittenOut {
  readonly text: string;
  readonly tokens: Uint32Array;
}

/** The kinds of files the page can save, in the order of its menu. */
export const FILE_FORMATS = ['card', 'svg', 'png', 'csv', 'dxf', 'stl', 'program'] as const;
export type FileFormat = (typeof FILE_FORMATS)[number];

/** Every question with what it asks and what it is answered. */
export interface Questions extends ViewQuestions {
  ping: { ask: undefined; answer: true };
  /** Lines from 0, end exclusive; the answer is triples `from, to, class`. */
  tokens: { ask: { readonly firstLine: number; readonly endLine: number }; answer: Uint32Array };
  pick: { ask: { readonly x: number; readonly y: number }; answer: Stroke | undefined };
  /** The tool goes on for so many seconds, or to a stop. */
  play: {
    ask: { readonly from: 'here' | 'start'; readonly seconds: number; readonly pace: Pace; readonly stops: StopSwitch };
    answer: Readout | undefined;
  };
  /** The tool is put where so much of the animation has been shown, 0 to 1; without that, the whole path is shown. */
  seek: { ask: { readonly share: number | undefined }; answer: Readout | undefined };
  step: { ask: { readonly unit: StepUnit; readonly direction: StepDirection }; answer: Readout | undefined };
  /** `x` a diameter, both mm; the answer is CSS pixels from the canvas's top left corner. */
  locate: { ask: { readonly x: number; readonly z: number }; answer: { readonly x: number; readonly y: number } };
  expand: { ask: undefined; answer: WrittenOut };
  /** What can be written as a cycle; offsets of the reader's selection. */
  rewritings: { ask: { readonly from: number; readonly to: number }; answer: readonly Rewriting[] };
  codes: { ask: undefined; answer: Codes };
  /** The bytes of a file; none where there is nothing to put into it. */
  export: { ask: { readonly format: FileFormat }; answer: Uint8Array<ArrayBuffer> | undefined };
  /** The half-section of the part at the moment that is shown. */
  section: { ask: undefined; answer: readonly SectionPiece[] };
  /** The programs found in a text, and one of them in pieces. */
  'programs-in': { ask: { readonly text: string }; answer: FoundPrograms };
  'pieces-of': { ask: { readonly program: number; readonly language: string }; answer: readonly FoundPiece[] };
  'setup-form': { ask: undefined; answer: SetupForm };
  'another-tool': { ask: { readonly word: string }; answer: SetupGroup | undefined };
  'read-setup': { ask: SetupTyped; answer: SetupAnswer };
}

/** The texts in the fields of the setup form; `json` is the setup of the page as it is. */
export interface SetupTyped {
  readonly keys: readonly string[];
  readonly texts: readonly string[];
  readonly keep: SetupPlace;
  readonly json: string;
}

export type QuestionKind = keyof Questions;

export interface Question<K extends QuestionKind = QuestionKind> {
  readonly kind: 'question';
  readonly id: number;
  readonly about: K;
  readonly ask: Questions[K]['ask'];
}

/** What takes a noticeable time: the program is run, then the material taken off. */
export type Work = 'run' | 'part';

/** What one finished run has found. */
export interface Report {
  readonly revision: number;
  readonly summary: Summary;
  readonly diagnostics: readonly Diagnostic[];
  readonly fitted: Fitted;
  /** How numbers without a point are read, where the reader has to know. */
  readonly decimal: string | undefined;
  /** All there is to tell; or the path, as the part takes longer; or the part that belongs to the path told before. */
  readonly stage: 'whole' | 'path' | 'part';
}

export type WorkerEvent =
  | { readonly kind: 'ready' }
  | { readonly kind: 'load-failed'; readonly reason: string }
  | { readonly kind: 'report'; readonly report: Report }
  /** `done` from 0 to 1; sent only for runs that take a noticeable time. */
  | { readonly kind: 'progress'; readonly revision: number; readonly work: Work; readonly done: number }
  | { readonly kind: 'views'; readonly views: ViewsState }
  | { readonly kind: 'switches'; readonly inText: SwitchesInText }
  | { readonly kind: 'setup-rejected'; readonly reason: string }
  | { readonly kind: 'setup-accepted' }
  | { readonly kind: 'answer'; readonly id: number; readonly answer: unknown }
  /** The interpreter threw: this worker is of no further use. */
  | { readonly kind: 'crashed'; readonly reason: string };
