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
}

/** The columns of the table, in their order. */
export const HEAD_KEYS = [
  'name',
  'exercise',
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
  /** The name on an earlier answer with the same blocks. */
  readonly sameAs: string | undefined;
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
      const name = cleanName(linked.name) ?? '';
      return { name, answer: { name, text: linked.text, exercise: linked.exercise } };
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
        ? { name, answer: { name, text: opened.program.pieces.join(''), exercise: null } }
        : { name, fault: { kind: 'file' } },
    );
  }
  return rows;
}

/** Grades answers to their exercises, and finds identical ones. */
export class AnswerGrader {
  readonly #grade: (exercise: string, answer: string) => Promise<AnswerReport | undefined>;
  readonly #texts = new Map<string, Promise<string | undefined>>();
  /** The name of the first answer with each exercise and blocks. */
  readonly #firstWith = new Map<string, string>();

  constructor(grade: (exercise: string, answer: string) => Promise<AnswerReport | undefined>) {
    this.#grade = grade;
  }

  async grade(row: AnswerRow, chosen: ChosenExercise | undefined): Promise<AnswerRow> {
    const { name, answer } = row;
    if (answer === undefined) return row;
    const exercise = await this.#exerciseOf(answer, chosen);
    if (typeof exercise !== 'string') return { ...row, fault: exercise };
    const found = await this.#grade(exercise, answer.text).catch(() => undefined);
    if (found === undefined) return { ...row, fault: { kind: 'failed' } };
    if (found.kind === 'fault')
      return { ...row, fault: { kind: 'faulty-exercise', line: found.line, message: found.message } };
    const { id, version, title, report, blocks } = found;
    const key = `${id} ${blocks}`;
    const first = this.#firstWith.get(key);
    if (first === undefined) this.#firstWith.set(key, name);
    const own = answer.exercise;
    const isOtherVersion = own !== null && (own.id !== id || own.version !== version);
    const exerciseText = chosen?.isForAll === true ? exercise : null;
    const hints = own?.hints;
    return { ...row, graded: { id, version, title, report, hints, isOtherVersion, sameAs: first, exerciseText } };
  }

  /** The text of the exercise of an answer. */
  async #exerciseOf(answer: Answer, chosen: ChosenExercise | undefined): Promise<string | AnswerFault> {
    const id = answer.exercise?.id;
    if (chosen?.isForAll === true || id === undefined) return chosen?.text ?? { kind: 'no-exercise' };
    const loading = this.#texts.get(id) ?? loadExercise(id);
    this.#texts.set(id, loading);
    return (await loading) ?? { kind: 'not-loaded', id };
  }
}
