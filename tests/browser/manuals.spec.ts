// The output of `gcode-playground embed` in the browsers. Without the element (readers without JavaScript), the program
// is shown line by line beside its picture; with the element it is the same program.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test, expect, type BasicPage } from './engines';
import { FOREIGN } from './embedded';

const FOLDER = join(__dirname, '../manuals');
const written = (name: string): string => readFileSync(join(FOLDER, name), 'utf8');
const program = written('hard.nc').trimEnd();

interface Playground extends HTMLElement {
  value: string;
  readonly settled: Promise<number>;
}

/** Opens a page with this block of HTML, beside the modules of the built page. */
async function openBlock(page: BasicPage, block: string): Promise<void> {
  await page.goto(FOREIGN);
  await page.evaluate((block) => {
    const { body } = new DOMParser().parseFromString(`<p>before</p>${block}<p>after</p>`, 'text/html');
    document.body.replaceChildren(...body.childNodes);
  }, block);
}

for (const name of ['hard.html', 'hard.markdown']) {
  test(`${name} shows program and picture without the element`, async ({ page }) => {
    await openBlock(page, written(name));
    const shown = await page.evaluate(() => {
      const pre = document.querySelector('pre')!;
      const svg = document.querySelector('svg[slot=fallback]')!;
      const own = [...pre.childNodes].filter((node) => node !== svg);
      const range = document.createRange();
      range.selectNodeContents(own[0]!);
      return {
        text: own.map((node) => node.textContent).join(''),
        paragraphs: [...document.querySelectorAll('p')].map((paragraph) => paragraph.textContent),
        heights: new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size,
        size: [svg.getBoundingClientRect().width, svg.getBoundingClientRect().height].map(Math.round),
        room: Math.round(svg.parentElement!.getBoundingClientRect().width),
        caption: svg.querySelector('title')?.textContent,
        paths: svg.querySelectorAll('path').length,
      };
    });
    expect(shown.text.trimEnd()).toBe(program);
    expect(shown.paragraphs).toEqual(['before', 'after']);
    // Each line has its own vertical position.
    expect(shown.heights).toBe(program.split('\n').length);
    const [width, height] = shown.size;
    expect(width).toBeGreaterThan(200);
    expect(height).toBeGreaterThan(100);
    if (name === 'hard.markdown') expect(width).toBeLessThanOrEqual(shown.room);
    expect(shown.paths).toBeGreaterThan(3);
    expect(shown.caption).toBe('a "b" <c>');
  });
}

test('the element uses the embedded program', async ({ page }) => {
  await openBlock(page, written('hard.html'));
  const value = await page.evaluate(async () => {
    const script = document.createElement('script');
    script.type = 'module';
    script.src = new URL('../../element.js', location.href).href;
    document.head.append(script);
    await customElements.whenDefined('gcode-playground');
    const element = document.querySelector<Playground>('gcode-playground')!;
    await element.settled;
    return element.value;
  });
  expect(value).toBe(program);
});
