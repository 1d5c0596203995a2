// The npm package: packed, installed into otherwise empty projects, and used from Node, TypeScript, Vite and a plain
// page.
import { execFile, spawn } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { expect } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage } from './engines';
import { serve } from './sites';

const execute = promisify(execFile);
const run = (
  program: string,
  words: readonly string[],
  options: { readonly cwd: string },
): Promise<{ readonly stdout: string }> =>
  execute(program, words, { ...options, env: { ...process.env, NO_COLOR: '1', FORCE_COLOR: '0' } });
const WWW = join(__dirname, '..', '..', 'www');
const PACKAGE = join(WWW, 'dist', 'embed');
const NPM = process.platform === 'win32' ? 'npm.cmd' : 'npm';

let project = '';

test.beforeAll(async () => {
  project = await mkdtemp(join(tmpdir(), 'playground-package-'));
  await writeFile(join(project, 'package.json'), '{ "name": "manual", "private": true, "type": "module" }\n');
  await run(NPM, ['pack', PACKAGE, '--silent'], { cwd: project });
  const archive = (await readdir(project)).find((file) => file.endsWith('.tgz')) ?? '';
  await run(NPM, ['install', `./${archive}`, '--offline', '--no-audit', '--no-fund', '--silent'], { cwd: project });
});
test.afterAll(() => rm(project, { recursive: true, force: true }));

/** The indented block of a document that starts with `start`. */
async function block(document: string, start: string): Promise<string> {
  const text = await readFile(document, 'utf8');
  const blocks = text.split('\n').reduce<string[]>(
    (all, line) => {
      if (line.startsWith('    ')) all[all.length - 1] += `${line.slice(4)}\n`;
      else all.push('');
      return all;
    },
    [''],
  );
  const found = blocks.find((one) => one.startsWith(start));
  if (found === undefined) throw new Error(`${document} has no block that begins with ${start}`);
  return found;
}

test('the package contains its listed files and metadata for TypeScript and editors, and no install scripts or dependencies', async () => {
  const folder = join(project, 'node_modules', 'gcode-playground');
  const { version, scripts, dependencies, customElements } = JSON.parse(
    await readFile(join(folder, 'package.json'), 'utf8'),
  ) as Record<string, unknown>;
  expect(version).toBe(/version = "([^"]+)"/.exec(await readFile(join(WWW, '..', 'Cargo.toml'), 'utf8'))?.[1]);
  expect([scripts, dependencies]).toEqual([undefined, undefined]);
  const files = await readdir(folder);
  for (const file of [
    'element.js',
    'element.d.ts',
    'worker.js',
    'core.wasm',
    'late.wasm',
    'en.txt',
    'index.html',
    'frame.js',
    'sco.js',
    'rules',
    'docs',
    'manual',
    'node',
    'sphinx',
    'LICENSE-MIT',
    'LICENSE-APACHE',
    'THIRD-PARTY-LICENSES.txt',
    'README.md',
    customElements,
  ])
    expect(files).toContain(file);
  expect(files).not.toContain(version);
  const licences = await readFile(join(folder, 'THIRD-PARTY-LICENSES.txt'), 'utf8');
  for (const inside of ['@codemirror/view', 'three', 'i_overlay', 'wasm-bindgen'])
    expect(licences).toMatch(new RegExp(`^${inside} `, 'm'));
});

test('the list of attributes matches the element', async ({ page }) => {
  const manifest = JSON.parse(await readFile(join(PACKAGE, 'custom-elements.json'), 'utf8')) as {
    modules: {
      declarations: { attributes: { name: string }[]; events: { name: string }[]; members: { name: string }[] }[];
    }[];
  };
  const declared = manifest.modules[0]?.declarations[0];
  const types = await readFile(join(PACKAGE, 'element.d.ts'), 'utf8');
  for (const { name } of declared?.events ?? []) expect(types).toContain(`'${name}'`);
  await inPage(page, '<gcode-playground loading="click"></gcode-playground>', async () => {
    const { observed, properties } = await page.evaluate(() => {
      const element = customElements.get('gcode-playground') as unknown as {
        readonly observedAttributes: readonly string[];
        readonly prototype: object;
      };
      const classes = [element.prototype, Object.getPrototypeOf(element.prototype) as object];
      return { observed: element.observedAttributes, properties: classes.flatMap(Object.getOwnPropertyNames) };
    });
    expect(declared?.attributes.map(({ name }) => name).sort()).toEqual([...observed].sort());
    for (const { name } of declared?.members ?? []) expect(properties).toContain(name);
    // Members of the element in its TypeScript types.
    const typed = [
      ...(types
        .split('export class')[1]
        ?.split('\n}')[0]
        ?.matchAll(/^ {2}(?:readonly |get )?(\w+)[(:]/gm) ?? []),
    ]
      .map(([, name]) => name)
      .filter((name) => name !== 'set');
    expect(typed.length).toBeGreaterThan(15);
    for (const name of typed) expect(properties).toContain(name);
  });
});

test('the examples of the documents run in Node', async () => {
  for (const document of [join(PACKAGE, 'README.md'), join(WWW, '..', 'README.md'), join(WWW, 'docs', 'library.md')]) {
    await writeFile(join(project, 'check.mjs'), await block(document, 'import { check'));
    const { stdout } = await run(process.execPath, ['check.mjs'], { cwd: project });
    const lines = stdout.trim().split('\n');
    expect(lines[0]).toMatch(/^2 \S+ /);
    expect(lines.at(-1)).toMatch(/^5 \d{4,}$/);
  }

  await writeFile(
    join(project, 'more.mjs'),
    `
    import assert from 'node:assert/strict';
    import {
      check, clean, convert, diff, expand, format, motions, part, renumber, repair, summary, svg,
    } from 'gcode-playground';
    import 'gcode-playground/element.js';
    const rapid = '(STOCK D=60 LENGTH=80)\\nT0101\\nM3 S500\\nG00 X62 Z2\\nG00 Z-30 X20\\nM30\\n';
    assert(check(rapid).some(({ severity }) => severity === 'error'), 'a rapid into the stock');
    assert.match(check('G00 X', {}, { language: 'ru' })[0].message, /[а-я]/);
    assert.match(check('G00 X', {}, { language: 'zh' })[0].message, /[\\u4e00-\\u9fff]/);
    assert.equal(check(new TextEncoder().encode('G00 X50 Z2\\nM30\\n')).length, 0);
    assert.equal(motions('G90 X40 Z-20 F0.2\\nM30\\n', { initial: { x: 52, z: 2 } }).length, 4);
    assert.equal(motions('G90 X40 Z-20 F0.2\\nM30\\n', '{"initial": {"x": 52, "z": 2}}')[0].to.x, 40);
    assert.match(svg(rapid), /^<svg /);
    for (const [bad, named] of [
      [() => check(5), 'string'], [() => check('', '{'), 'EOF'], [() => check('', { nothing: 1 }), 'nothing'], [() => motions(null), 'string'],
      [() => svg('', {}, { language: 'de' }), 'de'], [() => svg('', {}, { langauge: 'zh' }), 'langauge'], [() => check('', {}, 'zh'), 'options'],
    ]) {
      assert.throws(bad, (error) => error instanceof Error && error.message.includes(named));
    }
    assert.equal(check('').length, 1, 'and it goes on after an error');
    const bar = '(STOCK D=30 LENGTH=60)\\nT0101\\nG97 S800 M03\\nG00 X32 Z2\\nG90 X26 Z-20 F0.1\\nG00 X100 Z100\\nM30\\n';
    assert.equal(summary(bar).errors, 0);
    assert(part(bar).polygons.flat().some(([z, x]) => Math.abs(z + 20) < 1e-3 && Math.abs(x - 26) < 1e-3));
    assert.equal(part('G00 X1\\nM30\\n', { initial: { x: 0, z: 0 } }), undefined);
    assert(!/^G90/m.test(expand(bar)) && /^G01 X26/m.test(expand(bar)));
    assert.equal(repair('GO1 X50 Z-2 F0.1 (FACE\\nM30\\n'), 'G01 X50 Z-2 F0.1 (FACE)\\nM30\\n');
    assert.equal(format('g1x50z-2f.1\\r\\ng0x60\\r\\nm30\\r\\n'), 'G01 X50 Z-2 F.1\\r\\nG00 X60\\r\\nM30\\r\\n');
    assert.equal(renumber('N1 G00 X1\\nN2 GOTO 4\\nN4 M30\\n', { from: 100, step: 5 }), 'N100 G00 X1\\nN105 GOTO 110\\nN110 M30\\n');
    assert.throws(() => renumber('N1 G00 X1\\nGOTO #1\\nM30\\n'), /line 2: not renumbered/);
    assert.throws(() => renumber('', { from: 0 }), /from/);
    const arc = 'G00 X20 Z-5\\nG02 X30 Z-10 R5 F.1\\nM30\\n';
    assert.deepEqual(convert(arc, 'center'), { text: arc.replace('R5', 'I5 K0'), left: 0, firstLeft: undefined });
    assert.deepEqual(convert('G00 U-4\\nX30\\nU-2\\nM30\\n', 'absolute'), {
      text: 'G00 U-4\\nX30\\nX28\\nM30\\n', left: 1, firstLeft: { line: 1, text: 'U-4' },
    });
    assert.throws(() => convert(arc, 'polar'), /unknown variant.*incremental/);
    assert.throws(() => check(arc, {}, { signal: AbortSignal.abort() }), /in Node/);
    assert(diff(bar, bar).sameMotions && !diff(bar, bar.replace('X26', 'X27')).sameMotions);
    assert.deepEqual(clean('Turn the shaft:\\nO0001\\nG00 X32 Z2\\nG01 Z-20 F0.1\\nM30\\nThen measure it.\\n').length, 1);
  `,
  );
  await run(process.execPath, ['more.mjs'], { cwd: project });
});

test('in Node, every program of the tests has the same output as on the command line', async () => {
  // Same command as in xtask/src/native.rs, so that nothing is compiled again after the tests.
  await run('cargo', ['build', '--quiet', '--workspace', '--bin', 'gcode-playground', '--example', 'npx'], {
    cwd: join(WWW, '..'),
  });
  const script = join(project, 'node.mjs');
  await copyFile(join(WWW, '..', 'tests', 'package', 'node.mjs'), script);
  const { stdout } = await run(process.execPath, [script, join(WWW, '..')], { cwd: project });
  expect(Number(/^(\d+) programs/.exec(stdout)?.[1])).toBeGreaterThan(50);
});

test('the package works in TypeScript in strict mode', async () => {
  await writeFile(
    join(project, 'program.ts'),
    `
    import { check, motions, svg, type Diagnostic, type Setup } from 'gcode-playground';
    import { check as later, convert, type Converted } from 'gcode-playground/browser';
    import type { GcodePlayground } from 'gcode-playground/element.js';
    import type {} from 'gcode-playground/react';
    import type {} from 'gcode-playground/preact';
    import type {} from 'gcode-playground/solid';
    import type { JSX } from 'react';
    import type { JSX as PreactJSX } from 'preact';
    import type { JSX as SolidJSX } from 'solid-js/jsx-runtime';
    const setup: Setup = { stock: { diameter: 60, length: 80 }, tools: { T0101: { type: 'boring' } }, rules: { classroom: 'off' } };
    check('', setup);
    // @ts-expect-error: no such key.
    check('', { stok: 1 });
    // @ts-expect-error: a point of the outline has X and Z.
    check('', { stock: { outline: [[30]] } });
    export const props: JSX.IntrinsicElements['gcode-playground'] = { value: 'G00 X50', setup, blockSkip: '1', 'ongcode-change': ({ detail }) => console.log(detail.value) };
    // @ts-expect-error: no such view.
    export const wrong: JSX.IntrinsicElements['gcode-playground'] = { view: 'nothing' };
    export const inPreact: PreactJSX.IntrinsicElements['gcode-playground'] = { class: 'wide', speed: 5, 'ongcode-cursor': ({ detail }) => console.log(detail.column) };
    export const inSolid: SolidJSX.IntrinsicElements['gcode-playground'] = { class: 'wide', 'prop:value': 'G00 X50', 'on:gcode-error': ({ detail }) => console.log(detail.message) };
    const found: Diagnostic[] = check('G00 X50', { dialect: { control: 'gsk' } }, { language: 'zh' });
    export const lines: number[] = found.map(({ line }) => line);
    export const soon: Promise<Diagnostic[]> = later('G00 X50', setup, { language: 'ru', signal: AbortSignal.timeout(9) });
    export const written: Promise<Converted> = convert('G00 X50', 'two-blocks');
    // @ts-expect-error: no such form.
    void convert('G00 X50', 'polar');
    // @ts-expect-error: in Node a run cannot be ended.
    check('', {}, { signal: AbortSignal.timeout(9) });
    export const ends: number[] = motions('G00 X50').map(({ to }) => to.x);
    export const picture: string = svg(new Uint8Array());
    export function use(element: GcodePlayground): void {
      element.setup = { stock: { diameter: 60, length: 80 } };
      element.addEventListener('gcode-report', ({ detail }) => console.log(detail.summary.motions, detail.diagnostics[0]?.message));
      element.addEventListener('gcode-step', ({ detail }) => console.log(detail.readout?.stroke.line));
      document.querySelector('gcode-playground')?.play();
      void element.seek({ line: 4 }).then((readout) => console.log(readout?.share, element.summary?.motions, element.diagnostics.length));
      // @ts-expect-error: a position has one key of three.
      void element.seek({ block: 4 });
    }
  `,
  );
  // The parts of the types of these packages that ours need.
  const packages: Readonly<Record<string, string>> = {
    react:
      'export interface HTMLAttributes<T> { className?: string }\nexport type DetailedHTMLProps<E, T> = E;\nexport namespace JSX { interface IntrinsicElements {} }\n',
    preact:
      'export namespace Internal { interface IntrinsicElements { div: { class?: string } } }\nexport import JSX = Internal;\n',
    'solid-js/jsx-runtime':
      'export namespace JSX { interface HTMLAttributes<T> { class?: string }\ninterface IntrinsicElements {} }\n',
  };
  for (const [name, types] of Object.entries(packages)) {
    const folder = join(project, 'node_modules', name);
    await mkdir(folder, { recursive: true });
    await writeFile(join(folder, 'package.json'), JSON.stringify({ name, types: 'index.d.ts' }));
    await writeFile(join(folder, 'index.d.ts'), types);
  }
  const config = {
    compilerOptions: {
      target: 'ES2022',
      module: 'NodeNext',
      moduleResolution: 'NodeNext',
      lib: ['ES2023', 'DOM'],
      strict: true,
      exactOptionalPropertyTypes: true,
      noEmit: true,
      types: [],
    },
    files: ['program.ts'],
  };
  await writeFile(join(project, 'tsconfig.json'), JSON.stringify(config));
  const { stdout } = await run(
    process.execPath,
    [join(WWW, 'node_modules', 'typescript', 'bin', 'tsc'), '--project', project],
    { cwd: project },
  ).catch((error: { stdout: string }) => error);
  expect(stdout).toBe('');
});

/** Opens a page with this body, beside the files of the package. */
async function inPage(page: ChromiumPage, body: string, act: () => Promise<void>): Promise<void> {
  const html = `<!DOCTYPE html><html lang="en"><head><title>A manual</title></head><body>${body}<script type="module" src="/gcode-playground/element.js"></script></body></html>`;
  const site = await serve(join(project, 'node_modules', 'gcode-playground'), () => ({
    filesAt: '/gcode-playground/',
    pages: { '/index.html': html },
  }));
  try {
    await page.goto(`${site.origin}/index.html`);
    await page.evaluate(() => customElements.whenDefined('gcode-playground'));
    await act();
  } finally {
    await site.close();
  }
}

/** Number of motions of the page's only element, once its picture is shown. */
function motionsShown(page: ChromiumPage): Promise<number> {
  return page.evaluate(async () => {
    await customElements.whenDefined('gcode-playground');
    const element = document.querySelector('gcode-playground') as HTMLElement & {
      view: string;
      value: string;
      readonly settled: Promise<number>;
    };
    const reported = new Promise<number>((resolve) =>
      element.addEventListener('gcode-report', (event) =>
        resolve((event as CustomEvent<{ summary: { motions: number } }>).detail.summary.motions),
      ),
    );
    element.value = `${element.value}\n`;
    await element.settled;
    return reported;
  });
}

test('the element works in a plain page, as in its README', async ({ page }) => {
  const readme = await block(join(PACKAGE, 'README.md'), '<script type="module"');
  const site = await serve(join(project, 'node_modules', 'gcode-playground'), () => ({
    filesAt: '/gcode-playground/',
    pages: { '/index.html': `<!DOCTYPE html><title>A manual</title>${readme}` },
  }));
  try {
    await page.goto(`${site.origin}/index.html`);
    expect(await motionsShown(page)).toBe(10);
  } finally {
    await site.close();
  }
});

test('the functions for browsers work in a plain page, as in the documents', async ({ page }) => {
  const example = await block(join(WWW, 'docs', 'library.md'), "import { check } from 'gcode-playground/browser'");
  const imports = { 'gcode-playground/browser': '/gcode-playground/node/browser.js' };
  const html = `<!DOCTYPE html><html lang="en"><head><title>A manual</title><script type="importmap">${JSON.stringify({ imports })}</script></head><body><script type="module">${example}</script></body></html>`;
  const site = await serve(join(project, 'node_modules', 'gcode-playground'), () => ({
    filesAt: '/gcode-playground/',
    pages: { '/index.html': html },
  }));
  try {
    await page.goto(`${site.origin}/index.html`);
    await expect.poll(() => page.title()).toMatch(/^[1-9] [EW]-/);
  } finally {
    await site.close();
  }
});

test('the functions for browsers work in a worker bundled by Vite; a signal ends a long run', async ({ page }) => {
  test.setTimeout(120_000);
  const folder = join(project, 'checked');
  await mkdir(folder, { recursive: true });
  await writeFile(
    join(folder, 'index.html'),
    '<!DOCTYPE html><html lang="en"><head><title>Checked</title></head><body><script type="module" src="./main.js"></script></body></html>',
  );
  await writeFile(
    join(folder, 'main.js'),
    `const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }) => { document.body.textContent = JSON.stringify(data); };
    worker.postMessage('G00 X62 Z2 M03 S800\\nG90 X50 Z-30 F0.2\\nX45\\nG00 X100 Z100\\nM30');`,
  );
  await writeFile(
    join(folder, 'worker.js'),
    `import { check, motions, part, summary } from 'gcode-playground/browser';
    onmessage = async ({ data }) => {
      const rows = await motions(data);
      // The material of twenty thousand motions is removed at most.
      const long = '(STOCK D=60 LENGTH=80)\\nT0101 S500 M03\\n' + 'G01 X50 Z-9 F.2\\nX70 Z5\\n'.repeat(9_000);
      const controller = new AbortController();
      const ended = part(long, {}, { signal: controller.signal }).then(() => 'done', (error) => error.name);
      setTimeout(() => controller.abort());
      postMessage({
        motions: rows.length,
        ended: await ended,
        after: (await summary(data)).motions,
        refused: await check(5).catch((error) => error.name),
        aborted: await check(data, {}, { signal: AbortSignal.abort() }).catch((error) => error.name),
      });
    };`,
  );
  await run(
    process.execPath,
    [join(WWW, 'node_modules', 'vite', 'bin', 'vite.js'), 'build', folder, '--base=./', '--logLevel=warn'],
    { cwd: project },
  );
  const site = await serve(join(folder, 'dist'), () => ({ filesAt: '/deep/down/' }));
  try {
    await page.goto(`${site.origin}/deep/down/index.html`);
    await expect
      .poll(async () => JSON.parse((await page.textContent('body'))?.trim() || '{}') as unknown)
      .toEqual({ motions: 10, ended: 'AbortError', after: 10, refused: 'TypeError', aborted: 'AbortError' });
  } finally {
    await site.close();
  }
});

test('the element works bundled by Vite, with `base: "./"`', async ({ page }) => {
  test.setTimeout(120_000);
  await mkdir(join(project, 'site'), { recursive: true });
  await writeFile(
    join(project, 'site', 'index.html'),
    `<!DOCTYPE html><html lang="en"><head><title>A manual</title></head><body>
    <gcode-playground>G00 X62 Z2 M03 S800\nG90 X50 Z-30 F0.2\nX45\nG00 X100 Z100\nM30</gcode-playground><script type="module" src="./main.js"></script></body></html>`,
  );
  await writeFile(join(project, 'site', 'main.js'), "import 'gcode-playground';\n");
  await run(
    process.execPath,
    [
      join(WWW, 'node_modules', 'vite', 'bin', 'vite.js'),
      'build',
      join(project, 'site'),
      '--base=./',
      '--logLevel=warn',
    ],
    { cwd: project },
  );
  const site = await serve(join(project, 'site', 'dist'), () => ({ filesAt: '/deep/down/' }));
  try {
    await page.goto(`${site.origin}/deep/down/index.html`);
    expect(await motionsShown(page)).toBe(10);
    await expect(page.getByRole('textbox', { name: 'Program' })).toBeVisible();
  } finally {
    await site.close();
  }
});

test("the element works with Vite's development server, as in its README", async ({ page }) => {
  test.setTimeout(120_000);
  const readme = await readFile(join(PACKAGE, 'README.md'), 'utf8');
  const setting = /`(optimizeDeps: [^`]+)`/.exec(readme)?.[1] ?? '';
  const folder = join(project, 'developed');
  await mkdir(folder, { recursive: true });
  await writeFile(
    join(folder, 'index.html'),
    '<!DOCTYPE html><title>A manual</title><gcode-playground>G00 X62 Z2\nG90 X50 Z-30 F0.2</gcode-playground><script type="module" src="./main.js"></script>',
  );
  await writeFile(join(folder, 'main.js'), "import 'gcode-playground';\n");
  await writeFile(join(folder, 'vite.config.js'), `export default { ${setting} };\n`);
  const server = spawn(
    process.execPath,
    [join(WWW, 'node_modules', 'vite', 'bin', 'vite.js'), folder, '--port', '0', '--host', '127.0.0.1'],
    { cwd: project, env: { ...process.env, NO_COLOR: '1', FORCE_COLOR: '0' } },
  );
  try {
    const address = await new Promise<string>((resolve) => {
      let serverLog = '';
      server.stdout.on('data', (data: Buffer) => {
        serverLog += data.toString();
        const found = /http:\/\/127\.0\.0\.1:\d+\//.exec(serverLog)?.[0];
        if (found !== undefined) resolve(found);
      });
    });
    await page.goto(address);
    expect(await motionsShown(page)).toBe(5);
  } finally {
    server.kill();
  }
});
