// The example programs, taken from tests/programs when the page is built.
//
// In: nothing. Out: the examples in the gallery's order, each with its setup and what it shows.
// Must not know: what is in a program or a setup; both are passed on as they are.

import { LANGUAGES, type Language } from '../dom/language';

type Translated = Readonly<Record<Language, string>>;

export interface Example {
  readonly id: string;
  readonly program: string;
  /** JSON */
  readonly setup: string;
  readonly title: Translated;
  /** One sentence: what this program is here for. */
  readonly shows: Translated;
}

interface About {
  readonly title?: Partial<Translated>;
  readonly shows?: Partial<Translated>;
}

const FOLDER = '../../../tests/programs';
const programs = import.meta.glob<string>('../../../tests/programs/*/program.nc', { query: '?raw', import: 'default', eager: true });
const setups = import.meta.glob<string>('../../../tests/programs/*/setup.json', { query: '?raw', import: 'default', eager: true });
const abouts = import.meta.glob<About>('../../../tests/programs/*/about.json', { import: 'default', eager: true });
const order = import.meta.glob<readonly string[]>('../../../tests/programs/gallery.json', { import: 'default', eager: true });

export const examples: readonly Example[] = (order[`${FOLDER}/gallery.json`] ?? []).flatMap((id) => {
  const program = programs[`${FOLDER}/${id}/program.nc`];
  if (program === undefined) return [];
  const about = abouts[`${FOLDER}/${id}/about.json`];
  return [
    {
      id,
      program,
      setup: setups[`${FOLDER}/${id}/setup.json`] ?? '{}',
      title: translated(about?.title, id),
      shows: translated(about?.shows, ''),
    },
  ];
});

export function exampleOf(id: string | undefined): Example | undefined {
  return examples.find((example) => example.id === id);
}

function translated(texts: Partial<Translated> | undefined, otherwise: string): Translated {
  const pairs = LANGUAGES.map((language) => [language, texts?.[language] ?? texts?.en ?? otherwise]);
  return Object.fromEntries(pairs) as Translated;
}
