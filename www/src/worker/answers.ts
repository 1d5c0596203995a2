// What the worker answers: one row for each question.
//
// In: the `Playground` and what is asked. Out: the answer, whether it changes what is drawn, and whether it
// has to wait. Must not know: runs, or how answers reach the page.

import { Playground } from '../../pkg/gcode_playground.js';
import type { QuestionKind, Questions, WrittenOut } from '../protocol/protocol';
import { exported } from './exports';
import { piecesOf, programsIn } from './paste';
import { toolAnswers } from './tool';

/** Longer texts are expanded without colours. */
const COLOUR_LIMIT = 200_000;

export interface AnswerRow<K extends QuestionKind> {
  /** A picture changes with it: drawn at once, or once the run is whole. */
  readonly draws?: 'now' | 'when-whole';
  /** It is answered once all material is off. */
  readonly waits?: 'for-the-part';
  answer(core: Playground, ask: Questions[K]['ask']): Questions[K]['answer'] | Promise<Questions[K]['answer']>;
}

export const ANSWERS: { readonly [K in QuestionKind]: AnswerRow<K> } = {
  ping: { answer: () => true },
  tokens: { answer: (core, { firstLine, endLine }) => core.tokens(firstLine, endLine) },
  pick: { answer: (core, { picture, x, y }) => core.pick(picture, x, y) },
  dimension: { draws: 'when-whole', answer: (core, { x, y }) => core.dimension(x, y) },
  play: { draws: 'now', answer: toolAnswers.play },
  seek: { draws: 'now', answer: toolAnswers.seek },
  step: { draws: 'now', answer: toolAnswers.step },
  readout: { answer: toolAnswers.readout },
  locate: {
    answer(core, { picture, x, other }) {
      const [px = 0, py = 0] = core.screenOf(picture, x, other);
      return { x: px, y: py };
    },
  },
  expand: { answer: writtenOut },
  rewritings: { answer: (core, { from, to }) => core.rewritings(from, to) },
  codes: { answer: (core) => core.codes() },
  // A file of a part of a program would pass for all of it.
  export: { waits: 'for-the-part', answer: (core, { format }) => exported(core, format) },
  section: { answer: (core) => core.section() },
  'programs-in': { answer: (_, { text }) => programsIn(text) },
  'pieces-of': { answer: (_, { program, language }) => piecesOf(program, language) },
  'setup-form': { answer: (core) => core.setupForm() },
  'another-tool': { answer: (core, { word }) => core.anotherTool(word) },
  'read-setup': { answer: (core, { keys, texts, keep, json }) => core.readSetupForm([...keys], [...texts], keep, json) },
};

function writtenOut(core: Playground): WrittenOut {
  const text = core.expand();
  if (text.length > COLOUR_LIMIT) return { text, tokens: new Uint32Array() };
  // Colours belong to a text, so the new text needs an interpreter of its own for a moment.
  const reader = new Playground();
  try {
    reader.setText(text);
    return { text, tokens: reader.tokens(0, text.length + 1) };
  } finally {
    reader.free();
  }
}
