// Sources of an element's program: each form in the reference gives the same text, whenever it arrives.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test, expect, nightUnless } from './engines';
import { manual, openHtml, openInPieces, programOf, SCRIPT } from './embedded';
import { embed, PROGRAM, type Form } from './forms';
import { settled } from './page';

const FORMS: readonly Form[] = ['text', 'script', 'pre', 'marked script', 'marked pre', 'src'];

for (const form of FORMS) {
  for (const ends of ['LF', 'CRLF'] as const) {
    test(`the program is complete from: ${form}, ${ends}`, nightUnless(ends === 'CRLF'), async ({ page }) => {
      const text = ends === 'LF' ? PROGRAM : PROGRAM.replaceAll('\n', '\r\n');
      await openHtml(page, manual(embed(form, text)));
      await settled(page);
      await expect.poll(() => programOf(page)).toBe(PROGRAM);
    });
  }

  test(`the program is complete while the page is still being parsed: ${form}`, async ({ page }) => {
    const html = embed(form, PROGRAM);
    const at = html.indexOf('SMALL');
    // The class is defined before the element, whose text arrives in three pieces.
    await openInPieces(
      page,
      manual('<p>before</p>').replace('</body></html>', ''),
      html.slice(0, at),
      html.slice(at, at + 9),
      `${html.slice(at + 9)}<p>after</p>`,
    );
    await settled(page);
    await expect.poll(() => programOf(page)).toBe(PROGRAM);
  });
}

/** HTML code blocks of the reference that contain a program. */
function snippets(): string[] {
  const reference = readFileSync(join(__dirname, '../../www/docs/element.md'), 'utf8');
  const blocks = reference.match(/(?<=\n\n) {4}<.*\n(?:\n* {4}.*\n)*/g) ?? [];
  return blocks.map((block) => block.replace(/^ {4}/gm, '').trim());
}

test('every snippet of the reference draws its program', async ({ page }) => {
  // Without the sources of frameworks, which frameworks.spec.ts builds.
  const found = snippets().filter((html) => html.includes('G00') && !/^<script( setup)?>/.test(html));
  expect(found.length).toBeGreaterThan(4);
  for (const html of found) {
    await openHtml(page, manual(html));
    // Several elements in a row are one code block.
    const count = await page.locator('gcode-playground').count();
    for (let which = 0; which < count; which++) {
      await settled(page, which);
      expect(await programOf(page, which), html).toContain('G00');
    }
    await expect(page.getByRole('alert')).toHaveCount(0);
  }
});

test('the content of a slot is never read as the program', async ({ page }) => {
  await openHtml(
    page,
    manual(`
    <gcode-playground view="picture">
      <pre slot="fallback">G00 X1</pre><svg slot="fallback"><text>G00 X2</text></svg><script slot="fallback" type="text/x-gcode">G00 X3</script>
      <style>p { color: red }</style><!-- G00 X4 -->
      G00 X5
    </gcode-playground>`),
  );
  await settled(page);
  expect(await programOf(page)).toBe('G00 X5');
});

test('a picture in a marked program is a fallback for readers without scripts', async ({ page }) => {
  await openHtml(
    page,
    manual(
      '<pre data-gcode-playground data-view="picture"><svg slot="fallback" xmlns="http://www.w3.org/2000/svg"><title>G00 X2</title></svg>\nG00 X5\n</pre>',
    ),
  );
  await settled(page);
  expect(await programOf(page)).toBe('G00 X5');
  expect(await page.evaluate(() => document.querySelector('gcode-playground > svg')?.getAttribute('slot'))).toBe(
    'fallback',
  );
});

test('a setup is read from a script beside the program', async ({ page }) => {
  await openHtml(
    page,
    manual(`
    <gcode-playground>
      <script type="application/json">{"blockSkip": [1]}</script>
      <script type="text/x-gcode">
        G00 X50
        /G00 X60
        </script>
    </gcode-playground>`),
  );
  await settled(page);
  await expect(page.getByRole('status')).toContainText('1 motion');
  expect(await page.locator('gcode-playground').getAttribute('setup')).toBe('{"blockSkip": [1]}');
});

test('a marked program passes on the attributes of the element, and no others', async ({ page }) => {
  await openHtml(
    page,
    manual(`
    <pre data-gcode-playground data-view="picture" data-control="gsk" data-onclick="window.ran = true" data-style="color: red">G00 X50</pre>`),
  );
  await settled(page);
  const element = page.locator('gcode-playground');
  expect(
    await element.evaluate((element) => [...element.attributes].map(({ name, value }) => `${name}=${value}`).sort()),
  ).toEqual(['control=gsk', 'view=picture']);
  await expect(page.getByRole('img')).toHaveCount(1);
});

test('marked programs that are added later are upgraded on request', async ({ page }) => {
  await openHtml(page, manual('<main></main>'));
  await page.evaluate(async () => {
    document.querySelector('main')!.innerHTML =
      '<script type="text/x-gcode" data-gcode-playground data-view="picture">G00 X1</' + 'script>';
    const { upgrade } = (await import(new URL('../../element.js', location.href).href)) as {
      upgrade(root?: ParentNode): void;
    };
    upgrade(document.querySelector('main')!);
    upgrade();
  });
  await settled(page);
  await expect(page.locator('gcode-playground')).toHaveCount(1);
  expect(await programOf(page)).toBe('G00 X1');
});

test('properties set before the class is defined are applied', async ({ page }) => {
  await openHtml(
    page,
    manual('<gcode-playground view="picture">G00 X1</gcode-playground>')
      .replace(SCRIPT, '')
      .concat(`<script>
    Object.assign(document.querySelector('gcode-playground'), { value: 'G00 X9', setup: { stock: { diameter: 60, length: 80 } }, control: 'gsk' });
    document.head.insertAdjacentElement('beforeend', Object.assign(document.createElement('script'), { type: 'module', src: '../../element.js' }));
  </script>`),
  );
  await settled(page);
  expect(await programOf(page)).toBe('G00 X9');
  const element = page.locator('gcode-playground');
  expect(await element.getAttribute('setup')).toBe('{"stock":{"diameter":60,"length":80}}');
  expect(await element.getAttribute('control')).toBe('gsk');
});

test('text that is added later, and changed, is followed until the user edits', async ({ page }) => {
  await openHtml(page, manual('<main></main>'));
  const change = (text: string): Promise<void> =>
    page.evaluate(async (text) => {
      const element =
        document.querySelector('gcode-playground') ??
        document.querySelector('main')!.appendChild(document.createElement('gcode-playground'));
      element.setAttribute('control', 'gsk');
      element.textContent = text;
      await new Promise((done) => setTimeout(done));
    }, text);
  await change('G00 X1');
  expect(await programOf(page)).toBe('G00 X1');
  await change('G01 X22 Z-33 F0.2 (ANOTHER PROGRAM)');
  expect(await programOf(page)).toBe('G01 X22 Z-33 F0.2 (ANOTHER PROGRAM)');
  // It is still the page's own program, with any text: its context is kept.
  expect(await page.locator('gcode-playground').getAttribute('control')).toBe('gsk');
  await settled(page);
  await page.getByRole('textbox', { name: 'Program' }).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.insertText('N1 ');
  await change('G00 X3');
  expect(await programOf(page)).toBe('N1 G01 X22 Z-33 F0.2 (ANOTHER PROGRAM)');
});

test('an element that is moved, removed and inserted again keeps its program', async ({ page }) => {
  await openHtml(
    page,
    manual('<main><gcode-playground view="picture">G00 X1\nG01 Z-5 F0.2</gcode-playground></main><aside></aside>'),
  );
  await settled(page);
  await page.evaluate(() => document.querySelector('aside')!.append(document.querySelector('gcode-playground')!));
  await settled(page);
  expect(await programOf(page)).toBe('G00 X1\nG01 Z-5 F0.2');
  await page.evaluate(async () => {
    const element = document.querySelector('gcode-playground')!;
    element.remove();
    await new Promise((done) => setTimeout(done, 50));
    document.querySelector('main')!.append(element);
  });
  await settled(page);
  expect(await programOf(page)).toBe('G00 X1\nG01 Z-5 F0.2');
});

test('a program that cannot be loaded is reported within a second', async ({ page }) => {
  await openHtml(page, manual('<gcode-playground view="picture" src="nowhere/at-all.nc"></gcode-playground>'));
  // The server returns a page for a missing file, so a URL without a server is used for a failure.
  await page
    .locator('gcode-playground')
    .evaluate((element) => element.setAttribute('src', 'http://127.0.0.1:9/part.nc'));
  const begun = Date.now();
  await expect(page.getByRole('alert')).toContainText('http://127.0.0.1:9/part.nc');
  expect(Date.now() - begun).toBeLessThan(1_500);
  await expect(page.getByRole('alert')).toContainText('could not be loaded');
  // A new URL triggers another attempt.
  await page.locator('gcode-playground').evaluate((element) => element.setAttribute('src', 'data:text/plain,G00 X7'));
  await expect.poll(() => programOf(page)).toBe('G00 X7');
  await expect(page.getByRole('alert')).toHaveCount(0);
});
