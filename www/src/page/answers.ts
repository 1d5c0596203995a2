// The answers of a class to exercises: from links and files to one row for each.
//
// In: texts with links, files, the text of an exercise; `grade`, which runs a program. Out: rows for a table. A link
// contains no verdict: each program is run again. Must not know: how an answer is graded.

import { importWithRetry } from '../dom/network';
import type { AnsweredExercise } from '../files/shared-link';
import type { AnswerReport, Graded } from '../protocol/protocol';
import { loadExercise } from './exercise-list';
import { cleanName, parseAddress } from './linked';

/** A program that was handed in. */
export interface Answer {
  /** The name on the link, or the name of the file; empty if there is none. */
  readonly name: string;
  readonly text: string;
  /** The exercise that the link names. */
  readonly exercise: AnsweredExercise | null;
  /** The text of that exercise, if it is not one of the site. */
  readonly exerciseText: string | null;
}

/** The columns of the table, in their order. */
export const HEAD_KEYS = [
  'name',
  'exercise',
  'result',
  'points',
  'part',
  'failed',
  'problems',
  'time',
  'codes',
  'hints',
  'note',
] as const;
export type HeadKey = (typeof HEAD_KEYS)[number];

/** Why an answer is not graded. */
export type AnswerFault =
  | { readonly kind: 'link' }
  | { readonly kind: 'file' }
  | { readonly kind: 'no-exercise' }
  | { readonly kind: 'not-loaded'; readonly id: string }
  | { readonly kind: 'faulty-exercise'; readonly line: number; readonly message: string }
  | { readonly kind: 'failed' };

/** A row of the table. */
export interface AnswerRow {
  readonly name: string;
  readonly answer?: Answer;
  readonly fault?: AnswerFault;
  readonly graded?: GradedRow;
  /** The fragment that opens the graded answer. */
  readonly link?: string;
}

export interface GradedRow {
  readonly id: string;
  readonly version: string;
  readonly title: string;
  readonly report: Graded;
  /** Number of hints that the learner had opened; undefined for a file. */
  readonly hints: number | undefined;
  /** The learner had another version of the exercise. */
  readonly isOtherVersion: boolean;
  /** The text of the exercise is that of the link, which a learner can change. */
  readonly isFromLink: boolean;
  /** Equal for answers with the same blocks to the same exercise. */
  readonly key: string;
  /** The names on the other answers with this key. */
  readonly sameAs: readonly string[];
  /** The text of the exercise, if it is not one of the site. */
  readonly exerciseText: string | null;
}

/** The exercise that answers without an id belong to, or all answers if `isForAll`. */
export interface ChosenExercise {
  readonly text: string;
  readonly isForAll: boolean;
}

export const MAX_ANSWERS = 300;

/** Reads the links in a text. Text between them is ignored. */
export async function readLinks(text: string): Promise<AnswerRow[]> {
  const links = text.split(/(?=https?:\/\/)/).filter((piece) => /^https?:\/\/[^#]*#./s.test(piece));
  return Promise.all(
    links.slice(0, MAX_ANSWERS).map(async (link): Promise<AnswerRow> => {
      const found = await parseAddress(link.slice(link.indexOf('#')).trim());
      if (found.kind !== 'linked') return { name: '', fault: { kind: 'link' } };
      const { linked } = found;
      const { text, exercise, exerciseText } = linked;
      const name = cleanName(linked.name) ?? '';
      return { name, answer: { name, text, exercise, exerciseText } };
    }),
  );
}

/** Reads program files, in the encodings that the page knows. */
export async function readFiles(files: readonly File[]): Promise<AnswerRow[]> {
  const { readProgram } = await importWithRetry(() => import('../editor/read-program'));
  const rows: AnswerRow[] = [];
  for (const file of files.slice(0, MAX_ANSWERS)) {
    const opened = await readProgram(file);
    const { name } = file;
    rows.push(
      opened.kind === 'text'
        ? { name, answer: { name, text: opened.program.pieces.join(''), exercise: null, exerciseText: null } }
        : { name, fault: { kind: 'file' } },
    );
  }
  return rows;
}

/** Whether two answers are the same one, read twice. */
export function isSameAnswer(a: AnswerRow, b: AnswerRow): boolean {
  const key = ({ name, answer }: AnswerRow): string => JSON.stringify([name, answer?.text, answer?.exercise]);
  return a.answer !== undefined && key(a) === key(b);
}

/** Adds the names on the other answers with the same blocks. */
export function withSame(rows: readonly AnswerRow[]): AnswerRow[] {
  return rows.map((row) => {
    const { graded } = row;
    if (graded === undefined) return row;
    const others = rows.filter((other) => other !== row && other.graded?.key === graded.key);
    return { ...row, graded: { ...graded, sameAs: others.map(({ name }) => name) } };
  });
}

/** Grades answers to their exercises. */
export class AnswerGrader {
  readonly #grade: (exercise: string, answer: string) => Promise<AnswerReport | undefined>;
  readonly #texts = new Map<string, Promise<string | undefined>>();

  constructor(grade: (exercise: string, answer: string) => Promise<AnswerReport | undefined>) {
    this.#grade = grade;
  }

  async grade(row: AnswerRow, chosen: ChosenExercise | undefined): Promise<AnswerRow> {
    const { answer } = row;
    if (answer === undefined) return row;
    const exercise = await this.#exerciseOf(answer, chosen);
    if (typeof exercise !== 'string') return { ...row, fault: exercise };
    const found = await this.#grade(exercise, answer.text).catch(() => undefined);
    if (found === undefined) return { ...row, fault: { kind: 'failed' } };
    if (found.kind === 'fault')
      return { ...row, fault: { kind: 'faulty-exercise', line: found.line, message: found.message } };
    const { id, version, title, report, blocks } = found;
    const own = answer.exercise;
    const isFromLink = chosen?.isForAll !== true && own !== null && answer.exerciseText !== null;
    return {
      ...row,
      graded: {
        id,
        version,
        title,
        report,
        hints: own?.hints,
        isOtherVersion: own !== null && (own.id !== id || own.version !== version),
        isFromLink,
        key: `${id} ${blocks}`,
        sameAs: [],
        exerciseText: isFromLink || chosen?.isForAll === true ? exercise : null,
      },
    };
  }

  /** The text of the exercise of an answer. */
  async #exerciseOf(answer: Answer, chosen: ChosenExercise | undefined): Promise<string | AnswerFault> {
    const id = answer.exercise?.id;
    if (chosen?.isForAll === true || id === undefined) return chosen?.text ?? { kind: 'no-exercise' };
    if (answer.exerciseText !== null) return answer.exerciseText;
    const loading = this.#texts.get(id) ?? loadExercise(id);
    this.#texts.set(id, loading);
    return (await loading) ?? { kind: 'not-loaded', id };
  }
}
