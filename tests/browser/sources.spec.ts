// Where a program comes from: each form that www/docs/element.md names gives the same text, whenever it is read.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test, expect, type Page } from './engines';
import { serve } from './sites';

const FILES = join(__dirname, '..', '..', 'www', 'dist', 'embed');

/** What HTML and Markdown could take for their own. */
const PROGRAM = 'O0001\n#1=7\n#3=3\n#100=#1*2+#3*4\n\nIF[#100 LT 5](SMALL)\n(A<B *bold* _it_ [link](x) &amp; `code`)\nM98<SUB>\n\n\n  G00 X50 Z2\nG01 Z-30 F0.2\nM30';
const ESCAPED = PROGRAM.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const PICTURE = '<svg slot="fallback" xmlns="http://www.w3.org/2000/svg" width="40" height="20"><title>The picture</title><text y="12">NOT G00 X1</text></svg>';
const ELEMENT = '<script type="module" src="/embed/element.js"></script>';

interface Playground extends HTMLElement {
  value: string;
  setup: string | null;
  readonly settled: Promise<number>;
}

/** Opens a page with this body. */
async function withPage(page: Page, body: string, act: () => Promise<void>, more: Readonly<Record<string, string>> = {}): Promise<void> {
  const html = body.startsWith('<!DOCTYPE') ? body : `<!DOCTYPE html>\n<html lang="en"><head><title>A manual</title>${ELEMENT}</head><body>\n${body}\n</body></html>`;
  const site = await serve(FILES, () => ({ filesAt: '/embed/', pages: { '/index.html': html, ...more } }));
  try {
    await page.goto(`${site.origin}/index.html`);
    await act();
  } finally {
    await site.close();
  }
}

/** The program of the element once it is shown, and whether there is a picture. */
function program(page: Page): Promise<string> {
  return page.evaluate(async () => {
    await customElements.whenDefined('gcode-playground');
    const element = document.querySelector('gcode-playground') as Playground;
    await element.settled;
    return element.value;
  });
}

const FORMS: Readonly<Record<string, string>> = {
  'a script inside': `<gcode-playground view="picture">\n<script type="text/x-gcode">\n${PROGRAM}\n</script>\n</gcode-playground>`,
  'a pre inside': `<gcode-playground view="picture">\n<pre>\n${ESCAPED}\n</pre>\n</gcode-playground>`,
  'a picture and a pre inside': `<gcode-playground view="picture">${PICTURE}<pre>\n${ESCAPED}\n</pre></gcode-playground>`,
  'its own text': `<gcode-playground view="picture">\n${ESCAPED}\n</gcode-playground>`,
  'its own text, beside a pre in a slot': `<gcode-playground view="picture"><pre slot="fallback">G00 X1</pre>\n${ESCAPED}\n</gcode-playground>`,
  'a marked script': `<script type="text/x-gcode" data-gcode-playground data-view="picture">\n${PROGRAM}\n</script>`,
  'a marked pre': `<pre data-gcode-playground data-view="picture">\n${ESCAPED}\n</pre>`,
  'a marked pre with a picture': `<pre data-gcode-playground data-view="picture">${PICTURE}\n${ESCAPED}\n</pre>`,
  'a file': `<gcode-playground view="picture" src="part.nc"><pre slot="fallback">G00 X1</pre></gcode-playground>`,
};

for (const [form, body] of Object.entries(FORMS)) {
  test(`the same program from ${form}`, async ({ page }) => {
    await withPage(page, body, async () => {
      await expect.poll(() => program(page)).toBe(PROGRAM);
      expect(await page.evaluate(() => document.querySelector('gcode-playground')?.getAttribute('view'))).toBe('picture');
    }, { '/part.nc': PROGRAM.replaceAll('\n', '\r\n') });
  });
}

test('every form is described', () => {
  const document = readFileSync(join(__dirname, '..', '..', 'www', 'docs', 'element.md'), 'utf8');
  for (const words of ['<script type="text/x-gcode">', '<pre>', '<script type="text/x-gcode" data-gcode-playground', '<pre data-gcode-playground', '`src`', 'slot="fallback"']) {
    expect(document).toContain(words);
  }
});

test('a file that cannot be had is reported, and what stands in for the picture stays', async ({ page }) => {
  await withPage(page, '<gcode-playground view="picture" src="none.nc"></gcode-playground>', async () => {
    await expect(page.getByText('The program could not be loaded (none.nc: 404).')).toBeVisible();
  });
});

test('text that comes in pieces, later, or by a script, ends at the same program', async ({ page }) => {
  await test.step('pieces', () => withPage(page, '<gcode-playground view="picture"></gcode-playground>', async () => {
    await page.evaluate(async (text) => {
      await customElements.whenDefined('gcode-playground');
      const element = document.querySelector('gcode-playground')!;
      for (const line of text.split('\n')) {
        element.append(`${line}\n`);
        await new Promise((done) => setTimeout(done, 5));
      }
    }, PROGRAM);
    await expect.poll(() => program(page)).toBe(PROGRAM);
  }));
  await test.step('set before it is defined', () => withPage(page, `<!DOCTYPE html><html lang="en"><body><gcode-playground></gcode-playground><script>
    const element = document.querySelector('gcode-playground');
    element.view = 'picture';
    element.setup = { stock: { diameter: 60, length: 80 } };
    element.value = ${JSON.stringify(PROGRAM).replaceAll('<', '\\u003c')};
  </script>${ELEMENT}</body></html>`, async () => {
    await expect.poll(() => program(page)).toBe(PROGRAM);
    expect(await page.evaluate(() => {
      const element = document.querySelector('gcode-playground') as Playground;
      return [element.getAttribute('view'), element.setup];
    })).toEqual(['picture', '{"stock":{"diameter":60,"length":80}}']);
  }));
  await test.step('moved, and put in again', () => withPage(page, `<main></main><gcode-playground view="picture">\n${ESCAPED}\n</gcode-playground>`, async () => {
    await program(page);
    await page.evaluate(() => {
      const element = document.querySelector('gcode-playground')!;
      document.querySelector('main')!.append(element);
      element.remove();
      document.body.prepend(element);
    });
    await expect.poll(() => program(page)).toBe(PROGRAM);
  }));
});

test('what the page writes is followed until the reader edits', async ({ page }) => {
  await withPage(page, '<gcode-playground>G00 X50 Z2</gcode-playground>', async () => {
    await program(page);
    const write = (text: string) => page.evaluate((text) => void (document.querySelector('gcode-playground')!.textContent = text), text);
    await write('G00 X40 Z2');
    await expect.poll(() => program(page)).toBe('G00 X40 Z2');
    await page.getByRole('textbox', { name: 'Program' }).focus();
    await page.keyboard.type('(MINE)');
    await write('G00 X30 Z2');
    await page.waitForTimeout(200);
    expect(await program(page)).toBe('(MINE)G00 X40 Z2');
  });
});

test('a setup inside, and one that is an object', async ({ page }) => {
  const setup = '{"stock":{"diameter":60,"length":80}}';
  await withPage(page, `<gcode-playground view="picture"><script type="application/json">${setup}</script><pre>G00 X62 Z2</pre></gcode-playground>`, async () => {
    expect(await program(page)).toBe('G00 X62 Z2');
    expect(await page.evaluate(() => (document.querySelector('gcode-playground') as Playground).setup)).toBe(setup);
  });
});
