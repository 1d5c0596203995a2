// The first visit: the simplest program with its blank, and a picture that names chuck, tool and start point.
//
// The program of the lesson runs from X100 Z100 to X32 Z2, round a rectangle (X26, Z-30, X32, Z2), and by X100 back to
// the start. Its bar is Ø30 from Z-60 to Z0; the jaws clamp 20 mm of it and are 40 mm long across the axis.
import { chromiumTest, expect, test, type BasicPage } from './engines';
import {
  chip,
  choose,
  chooseLanguage,
  examples,
  goTo,
  locate,
  newPhonePage,
  open,
  openFirstVisit,
  play,
  program,
  status,
  titleText,
  value,
} from './page';

const LESSON = 's001-o0001';
/** Corners of the path, X (a diameter) and Z. */
const PATH = [
  [100, 100],
  [32, 2],
  [26, 2],
  [26, -30],
  [32, -30],
  [32, 2],
  [100, 2],
  [100, 100],
] as const;
const NAMES = {
  en: { chuck: 'chuck', tool: 'tool', start: 'start' },
  zh: { chuck: '卡盘', tool: '刀具', start: '起点' },
  ru: { chuck: 'патрон', tool: 'резец', start: 'старт' },
} as const;
type Name = keyof (typeof NAMES)['en'];

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The boxes of the names that the picture shows, by their text. */
async function shownNames(page: BasicPage): Promise<Readonly<Record<string, Box>>> {
  return page.locator('gcode-playground').evaluate((element) => {
    const found: Record<string, Box> = {};
    for (const word of element.shadowRoot?.querySelectorAll<HTMLElement>('.labels > span') ?? []) {
      if (!word.checkVisibility({ visibilityProperty: true })) continue;
      const { left, right, top, bottom } = word.getBoundingClientRect();
      found[word.textContent ?? ''] = { left, right, top, bottom };
    }
    return found;
  });
}

const namesOf = async (page: BasicPage): Promise<string[]> => Object.keys(await shownNames(page)).toSorted();
const expectNames = (page: BasicPage, ...names: string[]): Promise<void> =>
  expect.poll(() => namesOf(page)).toEqual(names.toSorted());

const contains = (box: Box, { x, y }: { x: number; y: number }): boolean =>
  box.left <= x && x <= box.right && box.top <= y && y <= box.bottom;

/** Fails if a name covers the path or another name. */
async function expectNothingCovered(page: BasicPage, path: readonly (readonly [number, number])[]): Promise<void> {
  const names = Object.entries(await shownNames(page));
  const corners = [];
  for (const [x, z] of path) corners.push(await locate(page, x, z));
  const covered = new Set<string>();
  for (const [at, to] of corners.slice(1).entries()) {
    const from = corners[at]!;
    for (let share = 0; share <= 1; share += 0.005) {
      const point = { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
      for (const [name, box] of names) if (contains(box, point)) covered.add(`${name} covers stroke ${at}`);
    }
  }
  for (const [at, [one, a]] of names.entries())
    for (const [other, b] of names.slice(at + 1)) {
      const apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      if (!apart) covered.add(`${one} covers ${other}`);
    }
  expect([...covered]).toEqual([]);
}

test('the first program is the simplest one, with its blank, and is the first of the gallery', async ({ page }) => {
  await openFirstVisit(page);
  expect(await value(page)).toBe(program(LESSON));
  expect(examples[0]?.id).toBe(LESSON);
  await expect(titleText(page)).toHaveText('First turning pass: G00 and G01');
  await expect(status(page)).toContainText(/^7 motions · \d+ lines · no problems/);
  await expect(chip(page)).toContainText('FANUC');
  await expect(page.getByText('Change X26 to X24 and look at the part.')).toBeVisible();
  await expect(page.getByRole('button', { name: /Ø30×60/ })).toBeVisible();
  await expect(page.getByText('tool starts at X100 Z100')).toBeVisible();
});

test('the picture names chuck, tool and start, each at its place, in three languages', async ({ page }) => {
  await openFirstVisit(page);
  for (const language of ['en', 'zh', 'ru'] as const) {
    const names = NAMES[language];
    await chooseLanguage(page, language);
    await expectNames(page, ...Object.values(names));
    await expectNothingCovered(page, PATH);
    const shown = await shownNames(page);
    const middleOf = (name: Name): { x: number; y: number } => {
      const { left, right, top, bottom } = shown[names[name]]!;
      return { x: (left + right) / 2, y: (top + bottom) / 2 };
    };
    const start = await locate(page, 100, 100);
    for (const name of ['tool', 'start'] as const) {
      const { x, y } = middleOf(name);
      expect(Math.hypot(x - start.x, y - start.y), `${names[name]} from the start point`).toBeLessThan(60);
    }
    // One of the jaws: the hint may be over the other.
    const jaws = [];
    for (const side of [1, -1]) {
      const [inner, outer] = [await locate(page, side * 30, -40), await locate(page, side * 110, -60)];
      const [top, bottom] = [Math.min(inner.y, outer.y), Math.max(inner.y, outer.y)];
      jaws.push({ left: outer.x, right: inner.x, top, bottom });
    }
    expect(jaws.some((jaw) => contains(jaw, middleOf('chuck')))).toBe(true);
  }
});

test('the names are shown at rest: not while playing, and not in a picture that was moved', async ({ page }) => {
  await openFirstVisit(page);
  const all = Object.values(NAMES.en);
  await expectNames(page, ...all);
  await play(page).click();
  await expectNames(page);
  await page.getByRole('button', { name: 'Show the whole path' }).click();
  await expectNames(page, ...all);

  const part = await locate(page, 26, -10);
  await page.mouse.move(part.x, part.y);
  await page.mouse.wheel(0, -400);
  await expectNames(page);
  await page.getByRole('button', { name: 'Show all' }).click();
  await expectNames(page, ...all);

  await test.step('they follow a picture that an edit has changed', async () => {
    const before = (await shownNames(page))['start']!;
    // The tool ends at Z150: the picture is wider, and the start point further to the left.
    await goTo(page, 10, 'Z1'.length);
    await page.keyboard.press('Delete');
    await page.keyboard.type('5');
    await expect
      .poll(async () => (await shownNames(page))['start']?.left ?? before.left)
      .toBeLessThan(before.left - 100);
    await expectNothingCovered(page, [...PATH.slice(0, -1), [100, 150]]);
  });
});

test('a name that would cover a stroke is moved or left out', async ({ page }) => {
  await openFirstVisit(page);
  await expectNames(page, ...Object.values(NAMES.en));
  // Strokes on all sides of the start point, and through both jaws.
  const added = [
    [100, 115],
    [115, 115],
    [115, 90],
    [85, 90],
    [85, 115],
    [100, 100],
    [70, -50],
    [-70, -50],
  ] as const;
  await goTo(page, 11);
  await page.keyboard.insertText(added.map(([x, z]) => `X${x} Z${z};\n`).join(''));
  await expect(status(page)).toContainText(/^15 motions/);
  await page.waitForTimeout(500);
  await expectNothingCovered(page, [...PATH, ...added]);
  expect(await namesOf(page)).not.toEqual(Object.values(NAMES.en).toSorted());
});

test("a beginner's slips in the first program are reported, and the blank stays", async ({ page }) => {
  await openFirstVisit(page);
  const blank = page.getByRole('button', { name: /Ø30×60/ });
  await test.step('G00 for G01: the rapid runs into the bar', async () => {
    await goTo(page, 6, 'G0'.length);
    await page.keyboard.press('Delete');
    await page.keyboard.type('0');
    await expect(status(page)).toContainText(/\d problem/);
    await expect(blank).toBeVisible();
    await page.keyboard.press('Control+Z');
    await expect(status(page)).toContainText('no problems');
  });
  await test.step('X260 for X26: the cut takes nothing off', async () => {
    await goTo(page, 5, 'G00 X26'.length);
    await page.keyboard.type('0');
    await expect(status(page)).toContainText(/\d problem/);
    await expect(blank).toBeVisible();
  });
});

test('only first lessons have names', async ({ page }) => {
  await open(page);
  await page.waitForTimeout(500);
  await expectNames(page);
  await page.evaluate(() => void (location.hash = '#s001-o0002'));
  await expectNames(page, ...Object.values(NAMES.en));
  await choose(page, 'program', /^New/);
  await page.getByRole('dialog').getByRole('button', { name: 'Create', exact: true }).click();
  await expectNames(page);
});

chromiumTest('a small drawing shows only the names that have room', async ({ browser, baseURL }) => {
  const page = await newPhonePage(browser, baseURL);
  await openFirstVisit(page);
  // The drawing is fitted to the part: the start point is outside.
  await expectNames(page, 'chuck');
  await expectNothingCovered(page, PATH);
  await page.context().close();
});
