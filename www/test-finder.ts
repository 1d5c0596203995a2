// Bundles the code that finds elements, for engines that Playwright does not drive, into one script:
// test-build/finder.js.
import { build } from 'vite';
import { fileURLToPath } from 'node:url';

const resolvePath = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default async function buildFinder(): Promise<void> {
  await build({
    configFile: false,
    logLevel: 'warn',
    root: resolvePath('.'),
    publicDir: false,
    resolve: { alias: { 'dom-accessibility-api': resolvePath('node_modules/dom-accessibility-api/dist/index.mjs') } },
    build: {
      target: 'es2022',
      outDir: resolvePath('test-build'),
      minify: true,
      lib: {
        entry: resolvePath('../tests/browser/engines/finder.ts'),
        formats: ['iife'],
        name: 'finder',
        fileName: () => 'finder.js',
      },
    },
  });
}
