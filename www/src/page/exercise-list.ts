// The exercises of the site: their list and their files.
//
// In: `exercises/list.json` and the files beside it. Out: ids, titles and texts. Must not know: the contents of an exercise.

import type { Language } from '../dom/language';
import { loadText } from '../dom/load-text';
import { exerciseAddress } from './linked';

export interface ListedExercise {
  readonly id: string;
  readonly points: number;
  readonly title: Partial<Record<Language, string>>;
}

/** The list; undefined if it cannot be loaded. */
export async function loadExercises(): Promise<readonly ListedExercise[] | undefined> {
  const text = await loadText('exercises/list.json');
  return text === undefined ? undefined : (JSON.parse(text) as readonly ListedExercise[]);
}

/** The text of the file of an exercise; undefined if it cannot be loaded. */
export async function loadExercise(id: string): Promise<string | undefined> {
  return /^[a-z0-9-]{1,64}$/.test(id) ? loadText(exerciseAddress(id)) : undefined;
}

export function titleOf({ id, title }: ListedExercise, language: Language): string {
  return title[language] ?? title.en ?? id;
}
