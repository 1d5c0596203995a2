// Builds the offline support, once all else is in www/dist: the service worker with the list of the page's files, and
// `offline/` with one pack for each folder of many small pages. `cargo xtask site` runs it last.
//
// Not listed: `embed`, which is for other sites, and `from-disk.js`, which is needed only without a server.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { defineConfig, type Plugin } from 'vite';
import { packOf, type BuildManifest } from './src/offline/list';

const DIST = join(import.meta.dirname, 'dist');
const EXCLUDED = /^(embed\/|offline\/|service-worker\.js$|from-disk\.js$|\.)/;

function listPaths(): string[] {
  const entries = readdirSync(DIST, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const all = entries.map((entry) => relative(DIST, join(entry.parentPath, entry.name)).split(sep).join('/'));
  return all.filter((path) => !EXCLUDED.test(path)).sort();
}

const hashOf = (content: string | Buffer): string => createHash('sha256').update(content).digest('hex').slice(0, 32);

/** The list, and the packs that are made for it. */
function build(): { readonly manifest: BuildManifest; readonly packs: ReadonlyMap<string, string> } {
  const pagesByPack = new Map<string, Record<string, string>>();
  const files: Record<string, string> = {};
  for (const path of listPaths()) {
    const bytes = readFileSync(join(DIST, path));
    const pack = packOf(path);
    if (pack === undefined) files[path] = hashOf(bytes);
    else pagesByPack.set(pack, { ...pagesByPack.get(pack), [path]: bytes.toString('utf8') });
  }
  const packs = new Map([...pagesByPack].map(([name, pages]) => [name, JSON.stringify(pages)]));
  for (const [name, text] of packs) files[name] = hashOf(text);
  const entry = /assets\/index-[\w-]+\.js/.exec(readFileSync(join(DIST, 'index.html'), 'utf8'))?.[0];
  if (entry === undefined) throw new Error('index.html names no script');
  return { manifest: { version: hashOf(JSON.stringify(files)), files, entry }, packs };
}

const { manifest, packs } = build();

const packFiles: Plugin = {
  name: 'packs',
  generateBundle() {
    for (const [fileName, source] of packs) this.emitFile({ type: 'asset', fileName, source });
  },
};

export default defineConfig({
  plugins: [packFiles],
  publicDir: false,
  define: { BUILD_MANIFEST: JSON.stringify(manifest) },
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: false,
    modulePreload: false,
    // Not every browser accepts a module as a service worker.
    rollupOptions: {
      input: 'src/offline/service-worker.ts',
      output: { format: 'iife', entryFileNames: 'service-worker.js' },
    },
  },
});
