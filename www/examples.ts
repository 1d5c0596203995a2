// The example programs as files next to the page, made from tests/programs during the build.
//
// In: the folders of tests/programs, in the order of gallery.json, and the headings of the manual. Out:
// `examples/<id>.json` for each program, and `examples/<language>.json` with the list: chapters of the manual, titles,
// small pictures, sources. They are not part of a script, so the page loads only the program that it shows. Must not
// know: the contents of a program. The pictures are made from the motions that are committed next to each program.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { smallPictureFromJsonLines, type SmallPicture } from './small-picture';

const PROGRAMS = join(import.meta.dirname, '../tests/programs');
const MANUAL = join(import.meta.dirname, 'manual');
const LANGUAGES = ['en', 'zh', 'ru'] as const;

type Translated = Readonly<Record<(typeof LANGUAGES)[number], string>>;

interface ExampleDescription {
  readonly title: Translated;
  readonly shows: Translated;
  readonly source: Translated;
  /** Missing if the program is not from a document. */
  readonly changed?: 'nothing' | readonly { readonly places: readonly object[]; readonly why: Translated }[];
  readonly compareWith?: string;
  readonly labels?: boolean;
}

interface Chapter {
  /** A page of the manual. */
  readonly chapter: string;
  readonly programs: readonly string[];
}

function read(...path: string[]): string {
  return readFileSync(join(PROGRAMS, ...path), 'utf8');
}

/** All files, by name. */
function buildFiles(): Map<string, string> {
  const files = new Map<string, string>();
  const pictures = new Map<string, SmallPicture | undefined>();
  const chapters = JSON.parse(read('gallery.json')) as readonly Chapter[];
  const descriptions = new Map<string, ExampleDescription>();
  for (const id of chapters.flatMap(({ programs }) => programs)) {
    const description = JSON.parse(read(id, 'about.json')) as ExampleDescription;
    descriptions.set(id, description);
    pictures.set(id, smallPictureFromJsonLines(read(id, 'output.jsonl')));
    files.set(
      `examples/${id}.json`,
      JSON.stringify({ ...shownFields(description), program: read(id, 'program.nc'), setup: read(id, 'setup.json') }),
    );
  }
  for (const language of LANGUAGES) {
    const list = chapters.map(({ chapter, programs }) => ({
      page: chapter,
      title: manualTitle(chapter, language),
      examples: programs.map((id) => ({
        id,
        title: descriptions.get(id)?.title[language],
        shows: descriptions.get(id)?.shows[language],
        ...sourceFields(descriptions.get(id), language),
        codes: extractCodes(read(id, 'program.nc')),
        picture: pictures.get(id),
      })),
    }));
    files.set(`examples/${language}.json`, JSON.stringify(list));
  }
  return files;
}

/** The heading of a page of the manual. */
function manualTitle(page: string, language: string): string {
  const [heading = ''] = readFileSync(join(MANUAL, language, `${page}.md`), 'utf8').split('\n');
  return heading.replace(/^# /, '');
}

/** The fields of the list about the source of a program. */
function sourceFields(description: ExampleDescription | undefined, language: keyof Translated): object {
  if (description === undefined) return {};
  const { source, changed } = description;
  if (changed === undefined) return { source: source[language] };
  const changes = changed === 'nothing' ? changed : changed.map(({ places, why }) => ({ places, why: why[language] }));
  return { source: source[language], changed: changes };
}

/** The fields of `about.json` that the page shows with the program. */
function shownFields({ title, shows, compareWith, labels }: ExampleDescription): object {
  return {
    title,
    shows,
    ...(compareWith === undefined ? {} : { compareWith }),
    ...(labels === undefined ? {} : { labels }),
  };
}

/** The search terms of a program: each G, M and T word once. */
function extractCodes(program: string): string {
  const written =
    program
      .replace(/\([^)]*\)/g, '')
      .toUpperCase()
      .match(/[GMT]\d+(?:\.\d+)?/g) ?? [];
  return [...new Set(written)].join(' ');
}

export const examples: Plugin = {
  name: 'examples',
  generateBundle() {
    for (const [fileName, source] of buildFiles()) this.emitFile({ type: 'asset', fileName, source });
  },
  configureServer(server) {
    server.middlewares.use((request, response, next) => {
      const file = buildFiles().get((request.url ?? '').split('?')[0]?.slice(1) ?? '');
      if (file === undefined) return next();
      response.setHeader('content-type', 'application/json');
      response.end(file);
    });
  },
};
