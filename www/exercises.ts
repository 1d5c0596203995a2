// The exercises as files next to the page.
//
// In: `exercises/<id>.md`, in the order of `course.json`. Out: the same files, and `exercises/list.json`: id, chapter,
// points and titles of each. Must not know: the parts of an exercise that the interpreter reads.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

const FOLDER = join(import.meta.dirname, 'exercises');

/** All files, by name. */
function buildFiles(): Map<string, string> {
  const read = (name: string): string => readFileSync(join(FOLDER, name), 'utf8');
  const ids = JSON.parse(read('course.json')) as readonly string[];
  const texts = ids.map((id) => ({ name: `${id}.md`, text: read(`${id}.md`) }));
  const files = new Map(texts.map(({ name, text }) => [`exercises/${name}`, text]));
  return files.set('exercises/list.json', JSON.stringify(texts.map(({ text }) => row(text))));
}

function row(text: string): object {
  const head = (key: string): string | undefined => new RegExp(`^${key}: *(.+)$`, 'm').exec(text)?.[1]?.trim();
  const title = Object.fromEntries(
    [...text.matchAll(/^# (en|zh|ru): *(.+)$/gm)].map(([, language = '', title = '']) => [language, title.trim()]),
  );
  return { id: head('id'), chapter: head('chapter'), points: Number(head('points') ?? 10), title };
}

export const exercises: Plugin = {
  name: 'exercises',
  generateBundle() {
    for (const [fileName, source] of buildFiles()) this.emitFile({ type: 'asset', fileName, source });
  },
  configureServer(server) {
    server.middlewares.use((request, response, next) => {
      const name = (request.url ?? '').split('?')[0]?.slice(1) ?? '';
      const file = name.startsWith('exercises/') ? buildFiles().get(name) : undefined;
      if (file === undefined) return next();
      response.setHeader('content-type', name.endsWith('.json') ? 'application/json' : 'text/plain; charset=utf-8');
      response.end(file);
    });
  },
};
