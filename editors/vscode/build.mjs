// Bundles the extension: for a computer, for the web, and the page of the picture; with the licences of the bundled
// packages.
//
//   node build.mjs ELEMENT OUT    the folder of the built element, and the folder for the bundles
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { build } from 'esbuild';

const [element, out] = process.argv.slice(2).map((path) => resolve(path));
const here = import.meta.dirname;

/** The modules and texts of the interpreter. */
const files = readdirSync(element).filter((name) => /^[a-z-]+\.(wasm|txt)$/.test(name));
if (!files.includes('core.wasm')) throw new Error(`${element} has no core.wasm`);

const shared = {
  absWorkingDir: here,
  outdir: out,
  bundle: true,
  minify: true,
  target: 'es2022',
  metafile: true,
  logLevel: 'warning',
  define: { ELEMENT_FILES: JSON.stringify(files) },
};

/** VS Code loads CommonJS, and provides `vscode`. */
const extension = {
  ...shared,
  format: 'cjs',
  external: ['vscode'],
  define: {
    ...shared.define,
    // The library derives the addresses of its files from this one; `src/library-files.ts` reads only their names.
    'import.meta.url': '"file:///node/index.js"',
  },
  alias: {
    'gcode-playground': join(element, 'node/index.js'),
    // Only the library imports it under this name.
    'node:fs': join(here, 'src/library-files.ts'),
  },
};

const bundles = await Promise.all([
  build({ ...extension, platform: 'node', entryPoints: ['src/desktop.ts'] }),
  build({ ...extension, platform: 'browser', entryPoints: ['src/web.ts'] }),
  build({ ...shared, format: 'esm', entryPoints: ['src/picture-page.ts'] }),
]);

const inputs = bundles.flatMap(({ metafile }) => Object.keys(metafile.inputs));
const packages = new Set(inputs.map((path) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path)?.[0]).filter(Boolean));
writeFileSync(join(out, 'THIRD-PARTY-LICENSES.txt'), [...packages].sort().map(licenceOf).join('\n'));

/** In the form of the licences of the element. */
function licenceOf(path) {
  const folder = join(here, path);
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  if (file === undefined) throw new Error(`${name} has no licence file`);
  return `${name} ${version} · ${license}\n${'='.repeat(72)}\n${readFileSync(join(folder, file), 'utf8')}`;
}
