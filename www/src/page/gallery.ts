// The example programs: the first one is part of the page, the others are files beside it.
//
// In: the name of an example, a language. Out: the example with its setup and what it shows; the list of all, by
// subject, with small pictures. Must not know: what is in a program or a setup; both are passed on as they are.

import type { Language } from '../dom/language';
import about from '../../../tests/programs/s000-o0002/about.json';
import program from '../../../tests/programs/s000-o0002/program.nc?raw';
import setup from '../../../tests/programs/s000-o0002/setup.json?raw';

type Translated = Readonly<Record<Language, string>>;

export interface Example {
  readonly id: string;
  readonly program: string;
  /** JSON */
  readonly setup: string;
  readonly title: Translated;
  /** One sentence: what this program is here for. */
  readonly shows: Translated;
  /** Words that the document it comes from does not have. */
  readonly added?: string;
  /** The example whose part is laid under its own. */
  readonly compareWith?: string;
}

/** An example as the gallery shows it, in one language. */
export interface Listed {
  readonly id: string;
  readonly title: string;
  readonly shows: string;
  /** Its G, M and T words. */
  readonly codes: string;
  /** Its strokes as paths of SVG; none where nothing is cut. */
  readonly picture?: { readonly rapid: string; readonly cut: string; readonly axis?: number };
}

export interface Subject {
  readonly subject: string;
  readonly examples: readonly Listed[];
}

/** What a page without an address of its own begins with. */
export const FIRST_EXAMPLE: Example = { id: 's000-o0002', program, setup, title: about.title, shows: about.shows };

const examples = new Map<string, Promise<Example>>([[FIRST_EXAMPLE.id, Promise.resolve(FIRST_EXAMPLE)]]);
const lists = new Map<Language, Promise<readonly Subject[]>>();

/** `unknown`: no example has this name. `not-loaded`: the network or its host failed. */
export type NoExample = 'unknown' | 'not-loaded';

/** The example of this name. */
export async function loadExample(id: string): Promise<Example | NoExample> {
  // Any text can stand in an address.
  if (!/^[a-z]\w*-[\w-]+$/.test(id)) return 'unknown';
  return kept(examples, id, async () => ({ ...(await file<Omit<Example, 'id'>>(id)), id })).catch((error: unknown) =>
    error instanceof Missing ? 'unknown' : 'not-loaded',
  );
}

/** All examples in their order; rejected where they could not be loaded. */
export function loadSubjects(language: Language): Promise<readonly Subject[]> {
  return kept(lists, language, () => file<readonly Subject[]>(language));
}

async function file<Content>(name: string): Promise<Content> {
  const response = await fetch(new URL(`examples/${name}.json`, document.baseURI));
  const { ok, status, headers } = response;
  // Some hosts answer with a page instead of 404.
  if ((status >= 400 && status < 500) || (ok && (headers.get('content-type') ?? '').startsWith('text/html')))
    throw new Missing(name);
  if (!ok) throw new Error(`examples/${name}.json: ${status}`);
  return (await response.json()) as Content;
}

/** The host has no such file. */
class Missing extends Error {}

/** What could not be loaded is asked for again the next time. */
function kept<Key, Value>(all: Map<Key, Promise<Value>>, key: Key, load: () => Promise<Value>): Promise<Value> {
  const before = all.get(key);
  if (before !== undefined) return before;
  const loading = load();
  all.set(key, loading);
  loading.catch(() => all.delete(key));
  return loading;
}
