// Builds the element for other people's pages into www/dist/embed: the page's sources, without the page, under names that
// stay. `cargo xtask site` adds what is no script: types, rule pages, licences. Addresses are written as bundlers
// read them, `new URL('core.wasm', import.meta.url)`, so that those who bundle the element find its files.
import { defineConfig } from 'vite';

/** The names of the package, where the build has another one. */
const NAMES: Readonly<Record<string, string>> = { 'gcode_playground_bg.wasm': 'core.wasm', further: 'panels', 'solid-view': 'solid', index: 'codemirror' };
const assetFileNames = ({ names: [name = ''] }: { readonly names: readonly string[] }): string => NAMES[name] ?? '[name][extname]';

export default defineConfig({
  base: './',
  publicDir: false,
  build: {
    target: 'es2022', outDir: 'dist/embed', emptyOutDir: true, assetsInlineLimit: 0, cssTarget: 'chrome123',
    // Who bundles the element preloads in a way of their own.
    modulePreload: false,
    rollupOptions: {
      input: { element: 'src/shell/element.ts' },
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: ({ name }) => `${NAMES[name] ?? '[name]'}.js`,
        assetFileNames,
      },
      // One file, and not one that only names another: the first picture waits for it.
      preserveEntrySignatures: 'allow-extension',
    },
  },
  worker: { format: 'iife', rollupOptions: { output: { entryFileNames: '[name].js', assetFileNames } } },
});
