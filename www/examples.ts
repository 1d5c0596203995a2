// The example programs as files next to the page, made from tests/programs during the build.
//
// In: the folders of tests/programs, in the order of gallery.json. Out: `examples/<id>.json` for each program, and
// `examples/<language>.json` with the list: subjects, titles, small pictures. They are not part of a script, so the
// page loads only the program that it shows. Must not know: the contents of a program. The pictures are made from the
// motions that are committed next to each program.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { smallPicture, type SmallPicture } from './small-picture';

const PROGRAMS = join(import.meta.dirname, '../tests/programs');
const LANGUAGES = ['en', 'zh', 'ru'] as const;

type Translated = Readonly<Record<(typeof LANGUAGES)[number], string>>;

interface About {
  readonly title: Translated;
  readonly shows: Translated;
  readonly added?: string;
  readonly compareWith?: string;
}

interface Subject {
  readonly subject: Translated;
  readonly programs: readonly string[];
}

function read(...path: string[]): string {
  return readFileSync(join(PROGRAMS, ...path), 'utf8');
}

/** All files, by name. */
function files(): Map<string, string> {
  const files = new Map<string, string>();
  const pictures = new Map<string, SmallPicture | undefined>();
  const subjects = JSON.parse(read('gallery.json')) as readonly Subject[];
  const abouts = new Map<string, About>();
  for (const id of subjects.flatMap(({ programs }) => programs)) {
    const about = JSON.parse(read(id, 'about.json')) as About;
    abouts.set(id, about);
    pictures.set(id, smallPicture(read(id, 'output.jsonl')));
    files.set(
      `examples/${id}.json`,
      JSON.stringify({ ...example(about), program: read(id, 'program.nc'), setup: read(id, 'setup.json') }),
    );
  }
  for (const language of LANGUAGES) {
    const list = subjects.map(({ subject, programs }) => ({
      subject: subject[language],
      examples: programs.map((id) => ({
        id,
        title: abouts.get(id)?.title[language],
        shows: abouts.get(id)?.shows[language],
        codes: codes(read(id, 'program.nc')),
        picture: pictures.get(id),
      })),
    }));
    files.set(`examples/${language}.json`, JSON.stringify(list));
  }
  return files;
}

/** The fields of `about.json` that the page shows. */
function example({ title, shows, added, compareWith }: About): object {
  return {
    title,
    shows,
    ...(added === undefined ? {} : { added }),
    ...(compareWith === undefined ? {} : { compareWith }),
  };
}

/** The search terms of a program: each G, M and T word once. */
function codes(program: string): string {
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
    for (const [fileName, source] of files()) this.emitFile({ type: 'asset', fileName, source });
  },
  configureServer(server) {
    server.middlewares.use((request, response, next) => {
      const file = files().get((request.url ?? '').split('?')[0]?.slice(1) ?? '');
      if (file === undefined) return next();
      response.setHeader('content-type', 'application/json');
      response.end(file);
    });
  },
};
