// Builds the element for other sites into www/dist/embed: the sources of the page without the page itself, under stable
// names. `cargo xtask site` adds everything that is not a script: types, rule pages, documents, licences. Addresses are
// written in the form `new URL('core.wasm', import.meta.url)`, so that a bundler finds the files.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig, type Plugin } from 'vite';
import { compiledEarly } from './compiled-early';

/** Names that are different in the package and in the build. */
const NAMES: Readonly<Record<string, string>> = {
  'gcode_playground_bg.wasm': 'core.wasm',
  further: 'panels',
  'solid-view': 'solid',
  index: 'codemirror',
};
const assetFileNames = ({ names: [name = ''] }: { readonly names: readonly string[] }): string =>
  NAMES[name] ?? '[name][extname]';

/** The licences of the bundled packages, in one file. */
const licences: Plugin = {
  name: 'licences',
  generateBundle(_options, bundle) {
    const modules = Object.values(bundle).flatMap((file) => (file.type === 'chunk' ? file.moduleIds : []));
    const packages = new Set(
      modules
        .map((id) => /^.*\/node_modules\/(?:@[^/]+\/)?[^/]+/.exec(id)?.[0])
        .filter((folder) => folder !== undefined),
    );
    const source = [...packages].sort().map(licenceOf).join('\n');
    this.emitFile({ type: 'asset', fileName: 'THIRD-PARTY-LICENSES.txt', source });
  },
};

function licenceOf(folder: string): string {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as {
    readonly name: string;
    readonly version: string;
    readonly license: string;
  };
  const file = existsSync(folder) ? readdirSync(folder).find((file) => /^licen[cs]e/i.test(file)) : undefined;
  if (file === undefined) throw new Error(`${name} has no licence file`);
  return `${name} ${version} · ${license}\n${'='.repeat(72)}\n${readFileSync(join(folder, file), 'utf8')}`;
}

export default defineConfig({
  plugins: [licences, compiledEarly],
  base: './',
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist/embed',
    emptyOutDir: true,
    assetsInlineLimit: 0,
    cssTarget: 'chrome123',
    // A site's bundler has its own method of preloading.
    modulePreload: false,
    rollupOptions: {
      input: { element: 'src/shell/element.ts', search: 'src/page/manual-search.ts' },
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: ({ name }) => `${NAMES[name] ?? '[name]'}.js`,
        assetFileNames,
      },
      // One file, not an entry that only imports another: the first picture waits for it.
      preserveEntrySignatures: 'allow-extension',
    },
  },
  worker: { format: 'iife', rollupOptions: { output: { entryFileNames: '[name].js', assetFileNames } } },
});
