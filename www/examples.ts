// The example programs as files next to the page, made from tests/programs during the build.
//
// In: the folders of tests/programs, in the order of gallery.json. Out: `examples/<id>.json` for each program, and
// `examples/<language>.json` with the list: subjects, titles, small pictures. They are not part of a script, so the
// page loads only the program that it shows. Must not know: the contents of a program. The pictures are made from the
// motions that are committed next to each program.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { smallPictureFromJsonLines, type SmallPicture } from './small-picture';

const PROGRAMS = join(import.meta.dirname, '../tests/programs');
const LANGUAGES = ['en', 'zh', 'ru'] as const;

type Translated = Readonly<Record<(typeof LANGUAGES)[number], string>>;

interface ExampleDescription {
  readonly title: Translated;
  readonly shows: Translated;
  readonly added?: string;
  readonly compareWith?: string;
  readonly labels?: boolean;
}

interface Subject {
  readonly subject: Translated;
  readonly programs: readonly string[];
}

function read(...path: string[]): string {
  return readFileSync(join(PROGRAMS, ...path), 'utf8');
}

/** All files, by name. */
function buildFiles(): Map<string, string> {
  const files = new Map<string, string>();
  const pictures = new Map<string, SmallPicture | undefined>();
  const subjects = JSON.parse(read('gallery.json')) as readonly Subject[];
  const descriptions = new Map<string, ExampleDescription>();
  for (const id of subjects.flatMap(({ programs }) => programs)) {
    const description = JSON.parse(read(id, 'about.json')) as ExampleDescription;
    descriptions.set(id, description);
    pictures.set(id, smallPictureFromJsonLines(read(id, 'output.jsonl')));
    files.set(
      `examples/${id}.json`,
      JSON.stringify({ ...shownFields(description), program: read(id, 'program.nc'), setup: read(id, 'setup.json') }),
    );
  }
  for (const language of LANGUAGES) {
    const list = subjects.map(({ subject, programs }) => ({
      subject: subject[language],
      examples: programs.map((id) => ({
        id,
        title: descriptions.get(id)?.title[language],
        shows: descriptions.get(id)?.shows[language],
        codes: extractCodes(read(id, 'program.nc')),
        picture: pictures.get(id),
      })),
    }));
    files.set(`examples/${language}.json`, JSON.stringify(list));
  }
  return files;
}

/** The fields of `about.json` that the page shows. */
function shownFields({ title, shows, added, compareWith, labels }: ExampleDescription): object {
  return {
    title,
    shows,
    ...(added === undefined ? {} : { added }),
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
