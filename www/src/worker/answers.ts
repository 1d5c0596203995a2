// The questions that the worker answers: one row for each.
//
// In: the `Playground` and the question. Out: the answer, whether it changes the drawing, and whether it must wait.
// Must not know: runs, or how answers reach the page.

import { Playground } from '../../pkg/gcode_playground.js';
import type { ProfilesResult, QuestionKind, Questions, ExpandedProgram } from '../protocol/protocol';
import { computeDifference } from './difference';
import { exportFile } from './exports';
import { answerHelp } from './help';
import { getPieces, findPrograms } from './paste';
import { toolAnswers } from './tool';
import { describe } from './describe';

/** Longer expanded texts get no syntax colours. */
const MAX_COLOURED_LENGTH = 200_000;

export interface AnswerRow<K extends QuestionKind> {
  /** A picture changes: redraw immediately, or when the run is complete. */
  readonly draws?: 'now' | 'when-complete';
  /** The views are reported after the answer. */
  readonly changesViews?: true;
  /** Whether the answer also makes annotations of the picture. */
  readonly annotates?: (args: Questions[K]['args']) => boolean;
  /** Wait until all material is removed. */
  readonly waitsFor?: 'part';
  /** The parts of the interpreter that are needed besides the first one. */
  readonly needs?: readonly ('late' | 'language')[];
  answer(core: Playground, args: Questions[K]['args']): Questions[K]['answer'] | Promise<Questions[K]['answer']>;
}

const TEXT_PARTS = ['late', 'language'] as const;

export const ANSWERS: { readonly [K in QuestionKind]: AnswerRow<K> } = {
  tokens: { needs: ['late'], answer: (core, { firstLine, endLine }) => core.tokens(firstLine, endLine) },
  pick: { needs: TEXT_PARTS, answer: (core, { picture, x, y }) => core.pick(picture, x, y) },
  dimension: { needs: TEXT_PARTS, draws: 'when-complete', answer: (core, { x, y }) => core.dimension(x, y) },
  measure: { needs: TEXT_PARTS, draws: 'now', answer: (core, { x, y }) => core.measureAt(x, y) },
  play: { needs: TEXT_PARTS, draws: 'now', answer: toolAnswers.play },
  seek: { needs: TEXT_PARTS, draws: 'now', answer: toolAnswers.seek },
  'seek-block': { needs: TEXT_PARTS, draws: 'now', answer: toolAnswers['seek-block'] },
  step: { needs: TEXT_PARTS, draws: 'now', answer: toolAnswers.step },
  'go-to': { needs: TEXT_PARTS, draws: 'now', answer: toolAnswers['go-to'] },
  strokes: { needs: TEXT_PARTS, answer: (core, { first, end }) => core.strokes(first, end) },
  readout: { needs: TEXT_PARTS, answer: toolAnswers.readout },
  totals: { needs: ['late'], answer: (core) => core.totals() },
  locate: {
    answer(core, { picture, place }) {
      const [px = 0, py = 0] = core.screenOf(picture, ...place);
      return { x: px, y: py };
    },
  },
  expand: { needs: TEXT_PARTS, answer: expandProgram },
  rewritings: { needs: TEXT_PARTS, answer: (core, { from, to }) => core.rewritings(from, to) },
  formatted: { needs: TEXT_PARTS, answer: (core) => core.formatted() },
  renumbered: { needs: TEXT_PARTS, answer: (core, { from, step, blocks }) => core.renumbered(from, step, blocks) },
  converted: { needs: TEXT_PARTS, answer: (core, form) => core.converted(form) },
  codes: { needs: TEXT_PARTS, answer: (core) => core.codes() },
  exercise: {
    needs: TEXT_PARTS,
    answer: (core, { text }) => ({ read: core.exercise(text), drawing: core.exerciseDrawing(text) }),
  },
  'check-exercise': {
    needs: TEXT_PARTS,
    draws: 'now',
    changesViews: true,
    answer: (core, { text }) => core.checkExercise(text),
  },
  'exercise-blocks': { needs: TEXT_PARTS, waitsFor: 'part', answer: (core) => core.exerciseBlocks() },
  'grade-answer': { needs: TEXT_PARTS, answer: (core, { text, answer }) => core.gradeAnswer(text, answer) },
  calculator: { needs: TEXT_PARTS, answer: (core, { name, at }) => core.calculatorForm(name, at === 'cursor') },
  calculate: {
    needs: TEXT_PARTS,
    answer(core, { name, fields, at }) {
      const calculation = core.calculate(name, [...fields], at === 'cursor');
      if (calculation === undefined) return undefined;
      const hasFigure = at === 'cursor' && calculation.kind === 'done';
      return { calculation, figure: hasFigure ? core.calculatorFigure(calculation.program) : '' };
    },
  },
  // Before the run has ended, nothing is known about the remaining blocks.
  help: { needs: TEXT_PARTS, waitsFor: 'part', annotates: ({ by }) => by === 'cursor', answer: answerHelp },
  uses: { needs: TEXT_PARTS, answer: (core, { offset }) => core.usesAt(offset) },
  outline: { needs: TEXT_PARTS, answer: (core) => core.outline() },
  // Wait, since a file of an incomplete program would be mistaken for all of it.
  export: { needs: TEXT_PARTS, waitsFor: 'part', answer: (core, { format }) => exportFile(core, format) },
  'speed-chart': { needs: TEXT_PARTS, answer: (core) => core.speedChart() },
  section: { needs: TEXT_PARTS, answer: (core) => core.section() },
  holes: { needs: TEXT_PARTS, answer: (core) => core.holes() },
  'programs-in': { needs: TEXT_PARTS, answer: (_, { text }) => findPrograms(text) },
  'pieces-of': { needs: TEXT_PARTS, answer: (_, { program, language }) => getPieces(program, language) },
  difference: { needs: TEXT_PARTS, waitsFor: 'part', answer: computeDifference },
  'setup-form': { needs: TEXT_PARTS, answer: (core) => core.setupForm() },
  'another-tool': { needs: TEXT_PARTS, answer: (core, { word }) => core.anotherTool(word) },
  'read-setup': {
    needs: TEXT_PARTS,
    answer: (core, { keys, texts, keep, json }) => core.readSetupForm([...keys], [...texts], keep, json),
  },
  'profiles-in': { needs: TEXT_PARTS, answer: (core, { json }) => readProfiles(core, json) },
  'profiles-of-run': { needs: TEXT_PARTS, answer: (core, { json }) => core.profilesOfRun(json) },
  'with-profile': {
    needs: TEXT_PARTS,
    answer: (core, { json, kind, profile }) => core.withProfile(json, kind, profile),
  },
};

function readProfiles(core: Playground, json: string): ProfilesResult {
  try {
    return { kind: 'profiles', profiles: core.profilesIn(json) };
  } catch (reason) {
    if (reason instanceof WebAssembly.RuntimeError) throw reason;
    return { kind: 'invalid', reason: describe(reason) };
  }
}

function expandProgram(core: Playground): ExpandedProgram {
  const text = core.expand();
  if (text.length > MAX_COLOURED_LENGTH) return { text, tokens: new Uint32Array() };
  // Tokens belong to a text, so the expanded text needs a temporary interpreter.
  const reader = new Playground();
  try {
    reader.setText(text);
    return { text, tokens: reader.tokens(0, text.length + 1) };
  } finally {
    reader.free();
  }
}
