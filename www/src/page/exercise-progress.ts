// The learner's progress in the exercises, kept in the browser.
//
// In: the results of checks. Out: the passed exercises, and the number of hints of each. Must not know: an exercise.

/** What is stored about an exercise. */
export interface ExerciseProgress {
  readonly passed: boolean;
  /** Number of checks. */
  readonly tries: number;
  /** Number of hints that were open at the first check that passed, or at the last one. */
  readonly hints: number;
  /** The day of the first check that passed, ISO. */
  readonly date?: string;
}

/** The detail of the event `gcode-checked`, as far as the page uses it. */
export interface CheckedExercise {
  readonly id: string;
  readonly version: string;
  readonly passed: boolean;
  readonly hints: number;
}

/** The detail of the event `gcode-exercise`, as far as the page uses it. */
export interface ShownExercise {
  readonly title: string;
  readonly program: string;
}

export type Progress = Readonly<Record<string, ExerciseProgress>>;

const KEY = 'gcode-playground:exercises';

/** All stored progress; empty if the storage is not available or holds something else. */
export function readProgress(): Progress {
  try {
    return parseProgress(localStorage.getItem(KEY) ?? '{}');
  } catch {
    return {};
  }
}

/** Reads progress from a file; rows of another form are left out. */
export function parseProgress(json: string): Progress {
  const rows = Object.entries(Object(JSON.parse(json)) as Record<string, Partial<ExerciseProgress> | null>);
  const read = rows.flatMap(([id, row]): [string, ExerciseProgress][] => {
    const { passed, tries, hints, date } = Object(row) as Partial<ExerciseProgress>;
    if (typeof passed !== 'boolean' || typeof tries !== 'number' || typeof hints !== 'number') return [];
    return [[id, { passed, tries, hints, ...(typeof date === 'string' ? { date } : {}) }]];
  });
  return Object.fromEntries(read);
}

/** Stores the result of a check. What was passed once stays passed. */
export function saveCheck({ id, passed, hints }: CheckedExercise): void {
  const all = readProgress();
  const before = all[id];
  const tries = (before?.tries ?? 0) + 1;
  const day = new Date().toISOString().slice(0, 10);
  const now =
    before?.passed === true ? { ...before, tries } : { passed, tries, hints, ...(passed ? { date: day } : {}) };
  writeProgress({ ...all, [id]: now });
}

/** Replaces all progress. */
export function writeProgress(progress: Progress): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(progress));
  } catch {
    // Without storage the progress is lost with the page.
  }
}
