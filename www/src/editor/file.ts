// The file of the text in the editor, and its line ends, which are not visible in it.
//
// In: a text with its own line ends, and its file. Out: the same text, also after edits, with each old line end
// unchanged; new ones are the most frequent kind. Part of the editor's state, so undo restores the file together with
// the text. Must not know: bytes, or how a file is opened or saved.

import { invertedEffects } from '@codemirror/commands';
import {
  MapMode,
  RangeSet,
  RangeSetBuilder,
  RangeValue,
  StateEffect,
  StateField,
  Text,
  type ChangeDesc,
  type EditorState,
  type Extension,
} from '@codemirror/state';
import type { LineEnds, LineEndText } from '../files/line-ends';
import type { ProgramFile, ProgramText } from './program-text';

/** The document of a text. */
export function docOf({ doc, pieces }: ProgramText): Text {
  return doc ?? pieces.reduce(appendText, Text.empty);
}

/** Appends a piece of normalised text to a document. */
export function appendText(doc: Text, piece: string): Text {
  return doc.append(Text.of(piece.split('\n')));
}

/** A line end other than the most frequent kind, at the position of the line break in the document. */
class ExceptionalLineEnd extends RangeValue {
  override mapMode = MapMode.TrackAfter;
  override startSide = 1;
  override endSide = 1;
  readonly text: LineEndText;

  constructor(text: LineEndText) {
    super();
    this.text = text;
  }

  override eq(other: RangeValue): boolean {
    return other instanceof ExceptionalLineEnd && other.text === this.text;
  }
}

const EXCEPTIONAL_LINE_ENDS = {
  '\n': new ExceptionalLineEnd('\n'),
  '\r\n': new ExceptionalLineEnd('\r\n'),
  '\r': new ExceptionalLineEnd('\r'),
} as const;

interface Origin {
  readonly file: ProgramFile | undefined;
  readonly usualEnd: LineEndText;
  readonly exceptionalEnds: RangeSet<ExceptionalLineEnd>;
}

const mapOrigin = (origin: Origin, changes: ChangeDesc): Origin =>
  origin.exceptionalEnds.size === 0 ? origin : { ...origin, exceptionalEnds: origin.exceptionalEnds.map(changes) };

/** The text now belongs to another file. */
const setOrigin = StateEffect.define<Origin>({ map: mapOrigin });
/** The name or encoding of the file has changed. */
const setFile = StateEffect.define<ProgramFile>();
/** Restores line ends that an undone change had removed. */
const restoreEnds = StateEffect.define<RangeSet<ExceptionalLineEnd>>({ map: (ends, changes) => ends.map(changes) });

const field = StateField.define<Origin>({
  create: () => ({ file: undefined, usualEnd: '\n', exceptionalEnds: RangeSet.empty }),
  update(origin, transaction) {
    let next = transaction.docChanged ? mapOrigin(origin, transaction.changes) : origin;
    for (const effect of transaction.effects) {
      if (effect.is(setOrigin)) next = effect.value;
      else if (effect.is(setFile)) next = { ...next, file: effect.value };
      else if (effect.is(restoreEnds)) next = { ...next, exceptionalEnds: effect.value };
    }
    return next;
  },
});

const inverted: Extension = invertedEffects.of((transaction) => {
  const before = transaction.startState.field(field);
  if (transaction.effects.some((effect) => effect.is(setOrigin))) return [setOrigin.of(before)];
  const after = transaction.state.field(field);
  return after.exceptionalEnds.size < before.exceptionalEnds.size ? [restoreEnds.of(before.exceptionalEnds)] : [];
});

/** Stores file and line ends in the state, with initial values. */
export function fileOfText(ends: LineEnds, file: ProgramFile | undefined): Extension {
  return [field.init(() => originOf(ends, file)), inverted];
}

export function fileOf(state: EditorState): ProgramFile | undefined {
  return state.field(field).file;
}

/** The text with its own line ends. */
export function textWithLineEnds(state: EditorState): string {
  const { usualEnd, exceptionalEnds } = state.field(field);
  if (exceptionalEnds.size === 0) return state.doc.sliceString(0, state.doc.length, usualEnd);
  const parts: string[] = [];
  let done = 0;
  for (const other = exceptionalEnds.iter(); other.value !== null; other.next()) {
    parts.push(state.doc.sliceString(done, other.from, usualEnd), other.value.text);
    done = other.from + 1;
  }
  parts.push(state.doc.sliceString(done, state.doc.length, usualEnd));
  return parts.join('');
}

/** The line ends of the text. */
export function lineEndsIn(state: EditorState): LineEnds {
  const { usualEnd, exceptionalEnds } = state.field(field);
  const exceptions: [number, LineEndText][] = [];
  for (const other = exceptionalEnds.iter(); other.value !== null; other.next())
    exceptions.push([other.from, other.value.text]);
  return { usual: usualEnd, exceptions };
}

/** The effect that sets file and line ends for a change that replaces the whole text. */
export function setOriginEffect(ends: LineEnds, file: ProgramFile | undefined): StateEffect<unknown> {
  return setOrigin.of(originOf(ends, file));
}

function originOf({ usual, exceptions }: LineEnds, file: ProgramFile | undefined): Origin {
  const builder = new RangeSetBuilder<ExceptionalLineEnd>();
  for (const [at, end] of exceptions) builder.add(at, at, EXCEPTIONAL_LINE_ENDS[end]);
  return { file, usualEnd: usual, exceptionalEnds: builder.finish() };
}

/** The effect for a new name or encoding of the file. */
export function renameEffect(file: ProgramFile): StateEffect<unknown> {
  return setFile.of(file);
}
