// The example programs: the first one is part of the page, the others are separate files.
//
// In: the id of an example, or a language. Out: the example with its setup and description; or the list of all examples
// by chapter, with small pictures. Must not know: the content of a program or setup; both are passed on unchanged.

import type { Language } from '../dom/language';
// Named, so that the script contains these fields only.
import { labels, shows, title } from '../../../tests/programs/s001-o0001/about.json';
import program from '../../../tests/programs/s001-o0001/program.nc?raw';
import setup from '../../../tests/programs/s001-o0001/setup.json?raw';

type Translated = Readonly<Record<Language, string>>;

export interface Example {
  readonly id: string;
  readonly program: string;
  /** JSON */
  readonly setup: string;
  readonly title: Translated;
  /** One sentence: what this example demonstrates. */
  readonly shows: Translated;
  /** The example whose part is drawn under the part of this one. */
  readonly compareWith?: string;
  /** For a first lesson: the picture names chuck, tool and start point, and shows the whole path. */
  readonly labels?: boolean;
}

/** A difference between a program and its source, in one language. */
export interface Change {
  readonly places: readonly {
    /** Line of the first block, from 1. */
    readonly line: number;
    /** Words of one block; several blocks are separated by line feeds. */
    readonly word: string;
    /** What the source has instead; missing if it has nothing. */
    readonly source?: string;
  }[];
  readonly why: string;
}

/** An entry of the gallery, in one language. */
export interface ListedExample {
  readonly id: string;
  readonly title: string;
  readonly shows: string;
  /** Its G, M and T words. */
  readonly codes: string;
  /** The document that the program is from. */
  readonly source: string;
  /** Missing if the program is not from a document. */
  readonly changed?: 'nothing' | readonly Change[];
  /** Its strokes as SVG paths; missing if nothing is cut. */
  readonly picture?: { readonly rapid: string; readonly cut: string; readonly axis?: number };
}

/** The examples of a page of the manual. */
export interface Chapter {
  /** The page's file in `manual/<language>`, without its ending. */
  readonly page: string;
  readonly title: string;
  readonly examples: readonly ListedExample[];
}

/** The program of a page whose address names no other: the simplest one. */
export const FIRST_EXAMPLE: Example = { id: 's001-o0001', program, setup, title, shows, labels };

const examples = new Map<string, Promise<Example>>([[FIRST_EXAMPLE.id, Promise.resolve(FIRST_EXAMPLE)]]);
const lists = new Map<Language, Promise<readonly Chapter[]>>();

/** `unknown`: no example has this id. `not-loaded`: the network or the server failed. */
export type ExampleFailure = 'unknown' | 'not-loaded';

export async function loadExample(id: string): Promise<Example | ExampleFailure> {
  // The id comes from the address and may be any text.
  if (!/^[a-z]\w*-[\w-]+$/.test(id)) return 'unknown';
  return cached(examples, id, async () => ({ ...(await fetchJson<Omit<Example, 'id'>>(id)), id })).catch(
    (error: unknown) => (error instanceof NotFound ? 'unknown' : 'not-loaded'),
  );
}

/** All examples in order; rejected if they could not be loaded. */
export function loadChapters(language: Language): Promise<readonly Chapter[]> {
  return cached(lists, language, () => fetchJson<readonly Chapter[]>(language));
}

async function fetchJson<Content>(name: string): Promise<Content> {
  const response = await fetch(new URL(`examples/${name}.json`, document.baseURI));
  const { ok, status, headers } = response;
  // Some servers answer with an HTML page instead of 404.
  if ((status >= 400 && status < 500) || (ok && (headers.get('content-type') ?? '').startsWith('text/html')))
    throw new NotFound(name);
  if (!ok) throw new Error(`examples/${name}.json: ${status}`);
  return (await response.json()) as Content;
}

/** The server has no such file. */
class NotFound extends Error {}

/** Caches the promise for `key`; a failed one is removed, so that the next call retries. */
function cached<Key, Value>(all: Map<Key, Promise<Value>>, key: Key, load: () => Promise<Value>): Promise<Value> {
  const before = all.get(key);
  if (before !== undefined) return before;
  const loading = load();
  all.set(key, loading);
  loading.catch(() => all.delete(key));
  return loading;
}
