// Attributes that the author of a manual sets on an element: visible parts, highlighted lines, position of the tool.
import { expect, test, type BasicPage } from './engines';
import { manual, openHtml, programOf } from './embedded';
import { openMenu, settled, type Playground } from './page';
import { pixels } from './pixels';

const PROGRAM = [
  'O0001',
  'T0101 (T01 R0.4) M03 S800',
  'G00 X52 Z2',
  'G01 X40 F0.2',
  'Z-20',
  'X50 Z-30',
  'G00 X300 Z400',
  'M30',
].join('\n');

/** An element with the program and these attributes. */
async function show(page: BasicPage, attributes: string, text = PROGRAM): Promise<void> {
  await openHtml(page, manual(`<gcode-playground ${attributes}><pre>\n${text}\n</pre></gcode-playground>`));
  await settled(page);
}

function set(page: BasicPage, attribute: string, value: string | null): Promise<void> {
  return page.evaluate(
    async ({ attribute, value }) => {
      const element = document.querySelector('gcode-playground') as Playground;
      Reflect.set(element, attribute, value);
      await element.settled;
    },
    { attribute, value },
  );
}

/** Names of the loaded scripts, without their hashes. */
function scripts(page: BasicPage): Promise<string[]> {
  return page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => /([\w-]+?)(-[\w-]{8})?\.js$/.exec(name)?.[1])
      .filter((name) => name !== undefined),
  );
}

/** Text of the program lines that have a class. */
function lines(page: BasicPage, name: string): Promise<string[]> {
  return page.locator(`.${name}`).evaluateAll((elements) => elements.map((element) => element.textContent ?? ''));
}

test('view="playback" shows the picture and plays it, without the program', async ({ page }) => {
  await show(page, 'view="playback"');
  await expect(page.getByRole('img', { name: /tool path/ })).toBeVisible();
  await expect(page.getByRole('textbox')).toHaveCount(0);
  await expect(page.getByRole('slider', { name: 'Position' })).toBeVisible();
  await page.getByRole('button', { name: /Next motion/ }).click();
  await expect(page.getByText(/line 3/).first()).toBeVisible();
  const loaded = await scripts(page);
  expect(loaded.filter((name) => ['editor', 'further', 'problems'].includes(name))).toEqual([]);
  const played = await page.locator('gcode-playground').evaluate((element) => {
    (element as unknown as { play(): void }).play();
    try {
      (element as unknown as { saveFile(): void }).saveFile();
      return 'saved';
    } catch (error) {
      return String(error);
    }
  });
  expect(played).toContain('view="playback" does not offer saveFile');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
});

test('view="code" shows the program and its problems, without a picture', async ({ page }) => {
  await show(page, 'view="code"', PROGRAM.replace('M30', 'G999\nM30'));
  await expect(page.getByRole('textbox', { name: 'Program' })).toBeVisible();
  await expect(page.getByRole('region', { name: 'Problems' })).toContainText('G999');
  for (const role of ['img', 'slider', 'status'] as const) await expect(page.getByRole(role)).toHaveCount(0);
  expect((await scripts(page)).filter((name) => ['further', 'playback'].includes(name))).toEqual([]);
});

test('controls selects the parts of the page that are shown', async ({ page }) => {
  await show(page, 'controls="none"');
  await expect(page.getByRole('textbox', { name: 'Program' })).toBeVisible();
  await expect(page.getByRole('img', { name: /tool path/ })).toBeVisible();
  for (const role of ['slider', 'status'] as const) await expect(page.getByRole(role)).toHaveCount(0);
  const rows = [/^Setup/, /^How the program was read/, /^(Program|Share|Help|More)$/, /^(Undo|Redo)/, /problems/i];
  for (const name of [...rows, /^Play/, /^Speed and steps/])
    await expect(page.getByRole('button', { name })).toHaveCount(0);
  await set(page, 'controls', 'playback status');
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Speed and steps' })).toBeVisible();
  await expect(page.getByRole('status')).toContainText('5 motions');
  for (const name of rows) await expect(page.getByRole('button', { name })).toHaveCount(0);
  await set(page, 'controls', null);
  await expect(page.getByRole('button', { name: /^Setup/ })).toBeVisible();
  for (const name of ['Program', 'Share', 'Help', 'More'])
    await expect(page.getByRole('button', { name, exact: true })).toBeVisible();
});

test('a menu contains only the items of the groups in controls', async ({ page }) => {
  await show(page, 'controls="views help"');
  for (const name of ['Program', 'Share']) await expect(page.getByRole('button', { name, exact: true })).toHaveCount(0);
  await openMenu(page, 'more');
  await expect(page.getByRole('menuitemcheckbox', { name: 'Front turret' })).toBeVisible();
  await expect(page.getByRole('menuitem', { name: 'Motions' })).toHaveCount(0);
  await page.keyboard.press('Escape');
  await openMenu(page, 'help');
  await expect(page.getByRole('menuitem', { name: 'Keys and gestures' })).toBeVisible();
});

test('a readonly program can be read, copied and played, but not changed', async ({ page }) => {
  const text = PROGRAM.replace('M30', 'G1 X5O\nM30');
  await show(page, 'readonly', text);
  const editor = page.getByRole('textbox', { name: 'Program' });
  await editor.focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('X1');
  await page.keyboard.press('Backspace');
  expect(await programOf(page)).toBe(text);
  await expect(page.getByRole('region', { name: 'Problems' })).toBeVisible();
  await expect(page.getByRole('button', { name: /^(Fix|Apply)/ })).toHaveCount(0);
  for (const name of [/^Setup/, /^Undo/, /^Redo/]) await expect(page.getByRole('button', { name })).toHaveCount(0);
  await openMenu(page, 'more');
  await expect(page.getByRole('menuitem', { name: 'Expand cycles' })).toBeVisible();
  await expect(page.getByRole('menuitem', { name: 'Write as a cycle…' })).toHaveCount(0);
  await page.keyboard.press('Escape');
  await openMenu(page, 'program');
  await expect(page.getByRole('menuitem', { name: 'Save file' })).toBeVisible();
  for (const name of ['Open file…', 'Programs in a text…'])
    await expect(page.getByRole('menuitem', { name })).toHaveCount(0);
  await page.keyboard.press('Escape');
  expect(await editor.getAttribute('aria-readonly')).toBe('true');
  await page.evaluate(() => Reflect.set(document.querySelector('gcode-playground')!, 'readonly', false));
  await editor.focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.insertText('(X)');
  await expect.poll(() => programOf(page)).toBe(`(X)${text}`);
});

test('highlight marks lines and their strokes until the reader chooses a block', async ({ page }) => {
  await show(page, '');
  expect(await pixels(page, 'highlight')).toBe(0);
  await set(page, 'highlight', '5-6, 99');
  expect(await lines(page, 'cm-marked-line')).toEqual(['Z-20', 'X50 Z-30']);
  const both = await pixels(page, 'highlight');
  expect(both).toBeGreaterThan(50);
  await page.getByRole('textbox', { name: 'Program' }).focus();
  await page.keyboard.press('Control+Home');
  for (let line = 1; line < 5; line++) await page.keyboard.press('ArrowDown');
  await page.evaluate(async () => void (await (document.querySelector('gcode-playground') as Playground).settled));
  expect(await pixels(page, 'highlight')).toBeLessThan(both);
  expect(await lines(page, 'cm-marked-line')).toHaveLength(2);
  await set(page, 'highlight', null);
  expect(await lines(page, 'cm-marked-line')).toEqual([]);
});

test('highlight works from the start, also in the picture-only view', async ({ page }) => {
  await show(page, 'view="picture" highlight="5"');
  await expect.poll(() => pixels(page, 'highlight')).toBeGreaterThan(20);
});

test('lines shows a part of the program, and the rest can be unfolded', async ({ page }) => {
  await show(page, 'lines="3-6"');
  await expect(page.getByRole('button', { name: 'Show lines 1–2' })).toBeVisible();
  expect((await lines(page, 'cm-line')).filter((line) => !line.startsWith('Show'))).toEqual(
    PROGRAM.split('\n').slice(2, 6),
  );
  expect(await programOf(page)).toBe(PROGRAM);
  await page.getByRole('button', { name: 'Show lines 7–8' }).click();
  expect((await lines(page, 'cm-line')).slice(-2)).toEqual(['G00 X300 Z400', 'M30']);
  await set(page, 'lines', null);
  expect(await lines(page, 'cm-line')).toEqual(PROGRAM.split('\n'));
});

for (const view of ['all', 'playback', 'picture']) {
  test(`step places the tool at the start: view="${view}"`, async ({ page }) => {
    await show(page, `view="${view}" step="3"`);
    const drawn = await pixels(page, 'tool');
    expect(drawn).toBeGreaterThan(20);
    // The path after that position is not drawn.
    const cut = await pixels(page, 'feed');
    await set(page, 'step', 'line 6');
    await set(page, 'step', '4');
    expect(await pixels(page, 'feed')).toBeGreaterThan(cut);
    if (view === 'picture') return;
    await expect(page.getByText(/line 6/).first()).toBeVisible();
    await set(page, 'step', 'line 5');
    await expect(page.getByText(/line 5/).first()).toBeVisible();
  });
}

test('fit selects whether the picture shows the part or the whole path', async ({ page }) => {
  await show(page, 'view="picture"');
  const size = (): Promise<number> =>
    page.evaluate(async () => {
      const element = document.querySelector('gcode-playground') as Playground & {
        locate(x: number, z: number): Promise<{ clientX: number }>;
      };
      const [a, b] = await Promise.all([element.locate(0, 0), element.locate(0, -30)]);
      return a.clientX - b.clientX;
    });
  const usual = await size();
  await set(page, 'fit', 'path');
  const path = await size();
  expect(path).toBeLessThan(usual / 2);
  await set(page, 'fit', 'part');
  expect(await size()).toBeGreaterThanOrEqual(usual);
});

test('turret sets the side of the tool, and caption names the picture', async ({ page }) => {
  await show(page, 'view="picture" turret="front" caption="Figure 3: a shoulder"');
  const down = (): Promise<boolean> =>
    page.evaluate(async () => {
      const element = document.querySelector('gcode-playground') as Playground & {
        locate(x: number, z: number): Promise<{ clientY: number }>;
      };
      return (await element.locate(50, 0)).clientY > (await element.locate(0, 0)).clientY;
    });
  expect(await down()).toBe(true);
  await expect(page.getByText('Figure 3: a shoulder')).toBeVisible();
  await expect(page.getByRole('group', { name: 'Figure 3: a shoulder' })).toHaveCount(1);
  await set(page, 'turret', 'rear');
  await expect.poll(down).toBe(false);
  await set(page, 'caption', null);
  await expect(page.getByRole('group', { name: 'G-code playground' })).toHaveCount(1);
});

test('every attribute of the reference is a property', async ({ page }) => {
  await show(page, 'view="picture"');
  const missing = await page.evaluate(() => {
    const element = document.querySelector('gcode-playground')!;
    const { observedAttributes } = element.constructor as unknown as { readonly observedAttributes: readonly string[] };
    return observedAttributes.filter(
      (name) => !(name.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase()) in element),
    );
  });
  expect(missing).toEqual([]);
});

for (const view of ['picture', 'playback'] as const) {
  test(`the drawing uses all the space of the element at any width: view="${view}"`, async ({ page }) => {
    await show(page, `view="${view}"`);
    for (const width of [320, 500, 700, 1000]) {
      for (const height of [260, 400, 560]) {
        const seen = await page.evaluate(
          async ({ width, height }) => {
            const element = document.querySelector<Playground>('gcode-playground')!;
            Object.assign(element.style, { width: `${width}px`, height: `${height}px` });
            await element.settled;
            const root = element.shadowRoot!;
            const box = (selector: string): DOMRect => root.querySelector(selector)!.getBoundingClientRect();
            const [frame, pictures, bar] = [
              box('.frame'),
              box('.pictures'),
              root.querySelector('.playback')?.getBoundingClientRect(),
            ];
            const below =
              bar === undefined || bar.height === 0 ? pictures.bottom : Math.max(bar.bottom, pictures.bottom);
            return {
              above: Math.round(pictures.top - frame.top),
              left: Math.round(frame.bottom - below),
              height: Math.round(pictures.height),
            };
          },
          { width, height },
        );
        const where = `${width} × ${height}: ${JSON.stringify(seen)}`;
        expect(seen.above, where).toBeLessThanOrEqual(2);
        // Content that does not fit scrolls, and no space stays empty.
        expect(seen.left, where).toBeLessThanOrEqual(2);
        if (view === 'picture') expect(seen.height, where).toBeGreaterThanOrEqual(height - 4);
      }
    }
  });
}

test('the picture does not change when the width is zero for a moment during layout', async ({ page }) => {
  await show(page, 'view="picture"');
  const size = (): Promise<string> =>
    page.evaluate(() => {
      const { width, height } = document.querySelector('gcode-playground')!.shadowRoot!.querySelector('canvas')!;
      return `${width} × ${height}`;
    });
  const before = await size();
  const cuts = await pixels(page, 'feed');
  expect(cuts).toBeGreaterThan(100);
  await page.evaluate(async () => {
    const element = document.querySelector<Playground>('gcode-playground')!;
    element.style.width = '0px';
    await new Promise((done) => setTimeout(done, 500));
    await element.settled;
  });
  expect(await size()).toBe(before);
  await page.evaluate(async () => {
    const element = document.querySelector<Playground>('gcode-playground')!;
    element.style.width = '';
    await new Promise((done) => setTimeout(done, 500));
    await element.settled;
  });
  expect(await size()).toBe(before);
  expect(await pixels(page, 'feed')).toBe(cuts);
});

test('keys typed in an element do not trigger shortcuts of the host page', async ({ page }) => {
  await openHtml(
    page,
    manual(
      `<gcode-playground><input slot="intro" aria-label="The page's own"><pre>\n${PROGRAM}\n</pre></gcode-playground>`,
    ),
  );
  await settled(page);
  await page.evaluate(() => {
    const received: string[] = [];
    Object.assign(globalThis, { received });
    for (const type of ['keydown', 'keyup'])
      document.addEventListener(type, (event) => received.push(`${type} ${(event as KeyboardEvent).key}`));
  });
  const received = (): Promise<string[]> =>
    page.evaluate(() => (globalThis as unknown as { received: string[] }).received.splice(0));
  const textbox = page.getByRole('textbox', { name: 'Program' });
  await textbox.focus();
  for (const key of ['ArrowRight', 'ArrowLeft', 's', '/', '?', 'Enter', 'Backspace']) await page.keyboard.press(key);
  expect(await received(), 'in the program').toEqual([]);
  await page.getByRole('slider', { name: 'Position' }).focus();
  await page.keyboard.press('ArrowRight');
  expect(await received(), 'on the slider').toEqual([]);
  // The host page still gets its shortcuts with modifiers, keys that leave a text field, and keys typed in its own
  // fields.
  await textbox.focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+k');
  const commands = await received();
  for (const command of ['keydown Escape', 'keydown k']) expect(commands).toContain(command);
  await page.getByLabel("The page's own").focus();
  await page.keyboard.press('x');
  expect(await received()).toEqual(['keydown x', 'keyup x']);
});

test('controls and labels of each row do not overlap at any width of the element', async ({ page }) => {
  for (const language of ['en', 'ru']) {
    await show(page, `language="${language}"`);
    // Below that width there are tabs, and the row over the drawing scrolls.
    for (let width = 740; width <= 1260; width += 40) {
      const { found, labels } = await page.evaluate(async (width) => {
        const element = document.querySelector<Playground>('gcode-playground')!;
        element.style.width = `${width}px`;
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        await element.settled;
        const root = element.shadowRoot!;
        interface Box {
          readonly left: number;
          readonly right: number;
          readonly top: number;
          readonly bottom: number;
        }
        const isOver = (one: Box, other: Box): boolean =>
          one.left < other.right - 1 &&
          other.left < one.right - 1 &&
          one.top < other.bottom - 2 &&
          other.top < one.bottom - 2;
        const isInside = (inner: Box, outer: Box): boolean =>
          inner.left >= outer.left - 1 &&
          inner.right <= outer.right + 1 &&
          inner.top >= outer.top - 1 &&
          inner.bottom <= outer.bottom + 1;
        /** The visible part of a text: a label that does not fit ends in an ellipsis. */
        const cut = (box: Box, of: Element | null, row: Element): Box => {
          if (of === null || of === row) return box;
          const { left, right, top, bottom } = of.getBoundingClientRect();
          const shown =
            getComputedStyle(of).overflowX === 'visible'
              ? box
              : {
                  left: Math.max(box.left, left),
                  right: Math.min(box.right, right),
                  top: Math.max(box.top, top),
                  bottom: Math.min(box.bottom, bottom),
                };
          return cut(shown, of.parentElement, row);
        };
        const found: string[] = [];
        let labels = 0;
        for (const name of ['.head', '.bar', '.views', '.playback']) {
          const row = root.querySelector(name)!;
          const inside = row.getBoundingClientRect();
          const controls = [...row.querySelectorAll('button, input, select, .time')]
            .filter((control) => control.checkVisibility())
            .map((control) => ({
              control,
              text: control.getAttribute('aria-label') ?? control.textContent ?? '',
              box: control.getBoundingClientRect() as Box,
            }))
            .filter(({ box }) => box.right > box.left);
          for (const [at, { text, box, control }] of controls.entries()) {
            if (!isInside(box, inside)) found.push(`${text} sticks out of ${name}`);
            for (const other of controls.slice(at + 1)) {
              if (isOver(box, other.box)) found.push(`${text} over ${other.text}`);
            }
            const words = document.createTreeWalker(control, NodeFilter.SHOW_TEXT);
            for (let node = words.nextNode(); node !== null; node = words.nextNode()) {
              if (node.textContent?.trim() === '' || node.parentElement?.closest('.unseen, [hidden]') !== null)
                continue;
              const range = document.createRange();
              range.selectNodeContents(node);
              for (const line of range.getClientRects()) {
                const shown = cut(line, node.parentElement, row);
                if (shown.right - shown.left <= 1) continue;
                labels++;
                if (!isInside(shown, box)) found.push(`${node.textContent} sticks out of its control`);
              }
            }
          }
        }
        return { found, labels };
      }, width);
      expect(found, `${language}, ${width} px`).toEqual([]);
      expect(labels).toBeGreaterThan(8);
    }
  }
});
