// The picture-only view: an element of a manual that shows the tool path of a program, without an editor.
import { test, expect, type BasicPage } from './engines';
import { FOREIGN } from './embedded';
import { motionCount, program } from './page';

const ID = 's000-o0002';

interface Picture extends HTMLElement {
  value: string;
  view: string;
  readonly settled: Promise<number>;
}

/** A page with one element, beside the modules of the built page. */
async function openPicture(page: BasicPage, view: string): Promise<void> {
  await page.goto(FOREIGN);
  await page.evaluate(
    async ({ view, text }) => {
      const element = document.createElement('gcode-playground');
      element.setAttribute('view', view);
      element.textContent = text;
      document.body.replaceChildren(element);
      const reported: number[] = [];
      Object.assign(window, { reported });
      element.addEventListener('gcode-report', (event) => {
        reported.push((event as CustomEvent<{ summary: { motions: number } }>).detail.summary.motions);
      });
      const script = document.createElement('script');
      script.type = 'module';
      script.src = new URL('../../element.js', location.href).href;
      document.head.append(script);
      await customElements.whenDefined('gcode-playground');
      await (element as Picture).settled;
    },
    { view, text: program(ID) },
  );
}

/** Number of pixels with the colour of a cut. */
function cuts(page: BasicPage): Promise<number> {
  return page.evaluate(() => {
    const root = document.querySelector('gcode-playground')?.shadowRoot;
    const canvas = root?.querySelector('canvas');
    const drawing = root?.querySelector('[part~=drawing]');
    if (canvas === null || canvas === undefined || drawing === null || drawing === undefined) return -1;
    const probe = drawing.appendChild(document.createElement('span'));
    probe.style.color = 'var(--playground-feed)';
    const [red = 0, green = 0, blue = 0] = (getComputedStyle(probe).color.match(/[\d.]+/g) ?? []).map(Number);
    probe.remove();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let found = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (Math.abs(data[at]! - red) + Math.abs(data[at + 1]! - green) + Math.abs(data[at + 2]! - blue) < 24) found++;
    }
    return found;
  });
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

test('view="picture" draws the program and loads neither the editor nor the panels', async ({ page }) => {
  await openPicture(page, 'picture');
  expect(await cuts(page)).toBeGreaterThan(100);
  expect(await page.evaluate(() => (window as unknown as { reported: number[] }).reported)).toContain(motionCount(ID));
  // Two pictures, one of them hidden; no editor, no buttons, no status line.
  await expect(page.getByRole('img')).toHaveCount(1);
  for (const role of ['textbox', 'button', 'slider', 'status', 'combobox'] as const)
    await expect(page.getByRole(role)).toHaveCount(0);
  const loaded = await scripts(page);
  expect(loaded).toContain('element');
  // The link to the playground is loaded after the picture, as a small script.
  expect(loaded.filter((name) => !['element', 'worker', 'open-link', 'plain-text-link'].includes(name))).toEqual([]);
});

test('view is also a property of the element, and changing it keeps the program', async ({ page }) => {
  await openPicture(page, 'picture');
  const text = await page.evaluate(() => (document.querySelector('gcode-playground') as Picture).value);
  await page.evaluate(() => {
    (document.querySelector('gcode-playground') as Picture).view = 'all';
  });
  await expect(page.getByRole('textbox', { name: 'Program' })).toBeVisible();
  await expect(page.getByRole('status')).toContainText(`${motionCount(ID)} motions`);
  expect(await page.evaluate(() => (document.querySelector('gcode-playground') as Picture).value)).toBe(text);
  await page.evaluate(async () => {
    const element = document.querySelector('gcode-playground') as Picture;
    element.view = 'picture';
    await element.settled;
  });
  await expect(page.getByRole('textbox')).toHaveCount(0);
  expect(await cuts(page)).toBeGreaterThan(100);
});

test('any other value of view shows everything', async ({ page }) => {
  await openPicture(page, 'something');
  await expect(page.getByRole('textbox', { name: 'Program' })).toBeVisible();
  expect(await page.evaluate(() => (document.querySelector('gcode-playground') as Picture).view)).toBe('all');
});
