// The recipes of the reference for React, Vue and Svelte, built by Vite. Their own plugins are not needed: the compilers
// of Vue and Svelte are called for each file.
import { execFile } from 'node:child_process';
import { mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { chromiumTest as test, expect } from './engines';
import { editor, settled } from './page';
import { serve } from './sites';

const WWW = join(__dirname, '..', '..', 'www');
/** Inside `www`, where the packages are found. */
const PROJECTS = join(WWW, 'test-build', 'frameworks');
const execute = promisify(execFile);

interface Framework {
  readonly name: string;
  /** How its block in the reference begins. */
  readonly start: string;
  /** The file of the block. */
  readonly file: string;
  /** The script that shows it. */
  readonly main: string;
  /** Imports and settings of Vite. */
  readonly imports?: string;
  readonly settings: string;
}

const FRAMEWORKS: readonly Framework[] = [
  {
    name: 'React',
    start: "import { useState } from 'react';",
    file: 'example.jsx',
    main: "import { createElement } from 'react';\nimport { createRoot } from 'react-dom/client';\nimport { Example } from './example.jsx';\ncreateRoot(document.querySelector('main')).render(createElement(Example));\n",
    settings: "esbuild: { jsx: 'automatic' }",
  },
  {
    name: 'Vue',
    start: '<script setup>',
    file: 'example.vue',
    main: "import { createApp } from 'vue';\nimport Example from './example.vue';\ncreateApp(Example).mount('main');\n",
    imports: "import { compileScript, parse } from 'vue/compiler-sfc';",
    settings: `plugins: [{
      name: 'vue',
      transform(source, id) {
        if (!id.endsWith('.vue')) return undefined;
        const { descriptor } = parse(source, { filename: id });
        const compilerOptions = { isCustomElement: (tag) => tag === 'gcode-playground' };
        return compileScript(descriptor, { id, inlineTemplate: true, templateOptions: { compilerOptions } }).content;
      },
    }]`,
  },
  {
    name: 'Svelte',
    start: "<script>\n  import 'gcode-playground';",
    file: 'example.svelte',
    main: "import { mount } from 'svelte';\nimport Example from './example.svelte';\nmount(Example, { target: document.querySelector('main') });\n",
    imports: "import { compile } from 'svelte/compiler';",
    settings:
      "plugins: [{ name: 'svelte', transform: (source, id) => (id.endsWith('.svelte') ? compile(source, { filename: id, generate: 'client' }).js : undefined) }]",
  },
];

/** The indented block of the reference that begins with `start`, with the blocks that follow it. */
async function recipe(start: string): Promise<string> {
  const reference = await readFile(join(WWW, 'docs', 'element.md'), 'utf8');
  const blocks = reference.match(/(?<=\n\n) {4}.*\n(?:\n* {4}.*\n)*/g) ?? [];
  const found = blocks.map((block) => block.replace(/^ {4}/gm, '')).find((block) => block.startsWith(start));
  if (found === undefined) throw new Error(`the reference has no block ${start}`);
  return found;
}

/** Builds the page of a recipe. Returns the folder of the built page. */
async function build({ name, start, file, main, imports = '', settings }: Framework): Promise<string> {
  const folder = join(PROJECTS, name.toLowerCase());
  await rm(folder, { recursive: true, force: true });
  await mkdir(folder, { recursive: true });
  const element = JSON.stringify(join(WWW, 'dist', 'embed', 'element.js'));
  const files: Readonly<Record<string, string>> = {
    [file]: await recipe(start),
    'main.js': main,
    'index.html': `<!doctype html><html lang="en"><head><title>${name}</title></head><body><main></main><script type="module" src="./main.js"></script></body></html>`,
    'vite.config.mjs': `${imports}\nexport default { base: './', resolve: { alias: { 'gcode-playground': ${element} } }, ${settings} };\n`,
  };
  for (const [path, text] of Object.entries(files)) await writeFile(join(folder, path), text);
  const vite = join(WWW, 'node_modules', 'vite', 'bin', 'vite.js');
  await execute(process.execPath, [vite, 'build', folder, '--logLevel=warn'], { cwd: folder });
  return join(folder, 'dist');
}

for (const framework of FRAMEWORKS) {
  test(`the recipe for ${framework.name} shows, follows and keeps the program`, { tag: '@night' }, async ({ page }) => {
    test.setTimeout(120_000);
    const site = await serve(await build(framework), () => ({ filesAt: '/' }));
    try {
      await page.goto(`${site.origin}/index.html`);
      // Lines of 14, 10, 13 and 3 characters.
      await expect(page.getByText('2 motions, 44 characters')).toBeVisible();
      await settled(page);
      await editor(page).focus();
      await page.keyboard.press('Control+Home');
      await page.keyboard.type('G00 X60 Z5');
      await page.keyboard.press('Enter');
      // The cursor stays where the reader types, although the page writes each change back.
      await page.keyboard.type('X58');
      await page.keyboard.press('Enter');
      await expect(page.getByText('4 motions, 59 characters')).toBeVisible();
      for (let step = 0; step < 6; step++) await page.keyboard.press('Control+z');
      await expect(page.getByText('2 motions, 44 characters')).toBeVisible();
    } finally {
      await site.close();
    }
  });
}
