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
  return doc ?? pieces.reduce(append, Text.empty);
}

/** Appends a piece of normalised text to a document. */
export function append(doc: Text, piece: string): Text {
  return doc.append(Text.of(piece.split('\n')));
}

/** A line end other than the most frequent kind, at the position of the line break in the document. */
class OtherEnd extends RangeValue {
  override mapMode = MapMode.TrackAfter;
  override startSide = 1;
  override endSide = 1;
  readonly text: LineEndText;

  constructor(text: LineEndText) {
    super();
    this.text = text;
  }

  override eq(other: RangeValue): boolean {
    return other instanceof OtherEnd && other.text === this.text;
  }
}

const OTHER_ENDS = { '\n': new OtherEnd('\n'), '\r\n': new OtherEnd('\r\n'), '\r': new OtherEnd('\r') } as const;

interface Origin {
  readonly file: ProgramFile | undefined;
  readonly mostEnds: LineEndText;
  readonly otherEnds: RangeSet<OtherEnd>;
}

const moved = (origin: Origin, changes: ChangeDesc): Origin =>
  origin.otherEnds.size === 0 ? origin : { ...origin, otherEnds: origin.otherEnds.map(changes) };

/** The text now belongs to another file. */
const setOrigin = StateEffect.define<Origin>({ map: moved });
/** The name or encoding of the file has changed. */
const setFile = StateEffect.define<ProgramFile>();
/** Restores line ends that an undone change had removed. */
const restoreEnds = StateEffect.define<RangeSet<OtherEnd>>({ map: (ends, changes) => ends.map(changes) });

const field = StateField.define<Origin>({
  create: () => ({ file: undefined, mostEnds: '\n', otherEnds: RangeSet.empty }),
  update(origin, transaction) {
    let next = transaction.docChanged ? moved(origin, transaction.changes) : origin;
    for (const effect of transaction.effects) {
      if (effect.is(setOrigin)) next = effect.value;
      else if (effect.is(setFile)) next = { ...next, file: effect.value };
      else if (effect.is(restoreEnds)) next = { ...next, otherEnds: effect.value };
    }
    return next;
  },
});

const undone: Extension = invertedEffects.of((transaction) => {
  const before = transaction.startState.field(field);
  if (transaction.effects.some((effect) => effect.is(setOrigin))) return [setOrigin.of(before)];
  const after = transaction.state.field(field);
  return after.otherEnds.size < before.otherEnds.size ? [restoreEnds.of(before.otherEnds)] : [];
});

/** Stores file and line ends in the state, with initial values. */
export function fileOfText(ends: LineEnds, file: ProgramFile | undefined): Extension {
  return [field.init(() => originOf(ends, file)), undone];
}

export function fileOf(state: EditorState): ProgramFile | undefined {
  return state.field(field).file;
}

/** The text with its own line ends. */
export function textWithLineEnds(state: EditorState): string {
  const { mostEnds, otherEnds } = state.field(field);
  if (otherEnds.size === 0) return state.doc.sliceString(0, state.doc.length, mostEnds);
  const parts: string[] = [];
  let done = 0;
  for (const other = otherEnds.iter(); other.value !== null; other.next()) {
    parts.push(state.doc.sliceString(done, other.from, mostEnds), other.value.text);
    done = other.from + 1;
  }
  parts.push(state.doc.sliceString(done, state.doc.length, mostEnds));
  return parts.join('');
}

/** The line ends of the text. */
export function lineEndsIn(state: EditorState): LineEnds {
  const { mostEnds, otherEnds } = state.field(field);
  const others: [number, LineEndText][] = [];
  for (const other = otherEnds.iter(); other.value !== null; other.next()) others.push([other.from, other.value.text]);
  return { most: mostEnds, others };
}

/** The effect that sets file and line ends for a change that replaces the whole text. */
export function origin(ends: LineEnds, file: ProgramFile | undefined): StateEffect<unknown> {
  return setOrigin.of(originOf(ends, file));
}

function originOf({ most, others }: LineEnds, file: ProgramFile | undefined): Origin {
  const builder = new RangeSetBuilder<OtherEnd>();
  for (const [at, end] of others) builder.add(at, at, OTHER_ENDS[end]);
  return { file, mostEnds: most, otherEnds: builder.finish() };
}

/** The effect for a new name or encoding of the file. */
export function renamed(file: ProgramFile): StateEffect<unknown> {
  return setFile.of(file);
}
