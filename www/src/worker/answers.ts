// The questions that the worker answers: one row for each.
//
// In: the `Playground` and the question. Out: the answer, whether it changes the drawing, and whether it must wait.
// Must not know: runs, or how answers reach the page.

import { Playground } from '../../pkg/gcode_playground.js';
import type { ProfilesRead, QuestionKind, Questions, WrittenOut } from '../protocol/protocol';
import { difference } from './difference';
import { exported } from './exports';
import { help } from './help';
import { piecesOf, programsIn } from './paste';
import { toolAnswers } from './tool';

/** Longer expanded texts get no syntax colours. */
const COLOUR_LIMIT = 200_000;

export interface AnswerRow<K extends QuestionKind> {
  /** A picture changes: redraw immediately, or when the run is complete. */
  readonly draws?: 'now' | 'when-whole';
  /** Wait until all material is removed. */
  readonly waits?: 'for-the-part';
  /** The parts of the interpreter that are needed besides the first one. */
  readonly needs?: readonly ('late' | 'language')[];
  answer(core: Playground, ask: Questions[K]['ask']): Questions[K]['answer'] | Promise<Questions[K]['answer']>;
}

const IN_WORDS = ['late', 'language'] as const;

export const ANSWERS: { readonly [K in QuestionKind]: AnswerRow<K> } = {
  tokens: { needs: ['late'], answer: (core, { firstLine, endLine }) => core.tokens(firstLine, endLine) },
  pick: { needs: IN_WORDS, answer: (core, { picture, x, y }) => core.pick(picture, x, y) },
  dimension: { needs: IN_WORDS, draws: 'when-whole', answer: (core, { x, y }) => core.dimension(x, y) },
  play: { needs: IN_WORDS, draws: 'now', answer: toolAnswers.play },
  seek: { needs: IN_WORDS, draws: 'now', answer: toolAnswers.seek },
  'seek-block': { needs: IN_WORDS, draws: 'now', answer: toolAnswers['seek-block'] },
  step: { needs: IN_WORDS, draws: 'now', answer: toolAnswers.step },
  'go-to': { needs: IN_WORDS, draws: 'now', answer: toolAnswers['go-to'] },
  strokes: { needs: IN_WORDS, answer: (core, { first, end }) => core.strokes(first, end) },
  readout: { needs: IN_WORDS, answer: toolAnswers.readout },
  totals: { needs: ['late'], answer: (core) => core.totals() },
  locate: {
    answer(core, { picture, place }) {
      const [px = 0, py = 0] = core.screenOf(picture, ...place);
      return { x: px, y: py };
    },
  },
  expand: { needs: IN_WORDS, answer: writtenOut },
  rewritings: { needs: IN_WORDS, answer: (core, { from, to }) => core.rewritings(from, to) },
  codes: { needs: IN_WORDS, answer: (core) => core.codes() },
  // Before the run has ended, nothing is known about the remaining blocks.
  help: { needs: IN_WORDS, waits: 'for-the-part', answer: help },
  uses: { needs: IN_WORDS, answer: (core, { offset }) => core.usesAt(offset) },
  outline: { needs: IN_WORDS, answer: (core) => core.outline() },
  // Wait, since a file of an incomplete program would be mistaken for all of it.
  export: { needs: IN_WORDS, waits: 'for-the-part', answer: (core, { format }) => exported(core, format) },
  section: { needs: IN_WORDS, answer: (core) => core.section() },
  holes: { needs: IN_WORDS, answer: (core) => core.holes() },
  'programs-in': { needs: IN_WORDS, answer: (_, { text }) => programsIn(text) },
  'pieces-of': { needs: IN_WORDS, answer: (_, { program, language }) => piecesOf(program, language) },
  difference: { needs: IN_WORDS, waits: 'for-the-part', answer: difference },
  'setup-form': { needs: IN_WORDS, answer: (core) => core.setupForm() },
  'another-tool': { needs: IN_WORDS, answer: (core, { word }) => core.anotherTool(word) },
  'read-setup': {
    needs: IN_WORDS,
    answer: (core, { keys, texts, keep, json }) => core.readSetupForm([...keys], [...texts], keep, json),
  },
  'profiles-in': { needs: IN_WORDS, answer: (core, { json }) => profilesIn(core, json) },
  'profiles-of-run': { needs: IN_WORDS, answer: (core, { json }) => core.profilesOfRun(json) },
  'with-profile': { needs: IN_WORDS, answer: (core, { json, kind, profile }) => core.withProfile(json, kind, profile) },
};

function profilesIn(core: Playground, json: string): ProfilesRead {
  try {
    return { kind: 'profiles', profiles: core.profilesIn(json) };
  } catch (reason) {
    if (reason instanceof WebAssembly.RuntimeError) throw reason;
    return { kind: 'wrong', reason: reason instanceof Error ? reason.message : String(reason) };
  }
}

function writtenOut(core: Playground): WrittenOut {
  const text = core.expand();
  if (text.length > COLOUR_LIMIT) return { text, tokens: new Uint32Array() };
  // Tokens belong to a text, so the expanded text needs a temporary interpreter.
  const reader = new Playground();
  try {
    reader.setText(text);
    return { text, tokens: reader.tokens(0, text.length + 1) };
  } finally {
    reader.free();
  }
}
