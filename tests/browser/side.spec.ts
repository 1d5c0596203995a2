// The unrolled side of the part in a separate picture: G07.1 milling and live-tool drilling, chosen by keyboard,
// picking, in each language.
import { expect, test, type Page, nightUnless } from './engines';
import { chooseLanguage, editor, open, tooltip, type } from './page';

interface Playground extends HTMLElement {
  readonly settled: Promise<number>;
  locateOnSide(z: number, c: number): Promise<{ clientX: number; clientY: number }>;
}

const STOCK = '(STOCK D=60 LENGTH=60)\n';
/** A groove of 10 mm around the whole part; line 11 ends at C300. */
const GROOVE = `${STOCK}(TOOL T0101 TYPE=ENDMILL CUTTER=5)
M45
T0101
G98 G97 S1000 M13
G00 X70 Z-20 C0
G01 X50 F100
G07.1 C30
G01 C100
Z-40
C300
Z-20
C360
G07.1 C0
G00 X100 Z50
M30
`;
/** Four holes of 8 mm at every 90 degrees, on lines 6 to 9. */
const HOLES = `${STOCK}(TOOL T0303 TYPE=DRILL D=8)
M45
T0303
G97 S1000 M13 G00 X66 Z-30 C0
G98 G87 Z-30 C0 X30 R-1 F80
C90
C180
C270
G80 G00 X100 Z50
M30
`;

const side = (page: Page) => page.getByRole('img', { name: /the side|圆柱面图|боковой поверхности/ });
const section = (page: Page) => page.getByRole('img', { name: /tool path|轨迹|траектории/ });

async function place(page: Page, z: number, c: number): Promise<{ clientX: number; clientY: number }> {
  return page.locator('gcode-playground').evaluate(
    async (element, at) => {
      await (element as Playground).settled;
      return (element as Playground).locateOnSide(at.z, at.c);
    },
    { z, c },
  );
}

/** The colour at a position in the picture. */
async function colour(page: Page, z: number, c: number): Promise<string> {
  return page.locator('gcode-playground').evaluate(
    async (element, at) => {
      await (element as Playground).settled;
      const { clientX, clientY } = await (element as Playground).locateOnSide(at.z, at.c);
      const canvases = [...element.shadowRoot!.querySelectorAll<HTMLCanvasElement>('.pictures canvas')];
      const isThere = ({ left, right, top, bottom }: DOMRect): boolean =>
        left <= clientX && clientX <= right && top <= clientY && clientY <= bottom;
      const canvas = canvases.find((canvas) => isThere(canvas.getBoundingClientRect()));
      if (canvas === undefined) return 'outside of all pictures';
      const { left, top, width, height } = canvas.getBoundingClientRect();
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext('2d')!;
      context.drawImage(canvas, 0, 0);
      const [x, y] = [((clientX - left) / width) * canvas.width, ((clientY - top) / height) * canvas.height];
      return [...context.getImageData(Math.round(x), Math.round(y), 1, 1).data].join();
    },
    { z, c },
  );
}

test('a groove around the part is shown unrolled, and can be picked', async ({ page }) => {
  await open(page, '#s003-g71');
  await expect(page.getByRole('radiogroup', { name: 'View' })).toBeHidden();
  await expect(side(page)).toBeHidden();
  await type(page, GROOVE);
  await expect(side(page)).toBeVisible();
  await expect(section(page)).toBeVisible();
  await expect(page.getByRole('radio', { name: 'Face' })).toBeHidden();

  const work = await colour(page, -11.5, 187);
  const cut = await colour(page, -37.5, 205);
  expect(cut).not.toBe(work);
  expect(await colour(page, -17.5, 52)).toBe(cut);
  expect(await colour(page, -31.5, 205)).toBe(work);
  expect(await colour(page, -40, 205)).not.toBe(cut);
  // C increases downwards, as seen from outside.
  expect((await place(page, -20, 200)).clientY).toBeGreaterThan((await place(page, -20, 100)).clientY);

  const stroke = await place(page, -40, 200);
  await page.mouse.move(stroke.clientX, stroke.clientY);
  await expect(tooltip(page)).toContainText('line 11');
  await page.mouse.click(stroke.clientX, stroke.clientY);
  await expect(editor(page)).toBeFocused();
  await page.keyboard.insertText('C310');
  await expect(editor(page)).toContainText('C310');

  await page.getByRole('radio', { name: 'Section' }).click();
  await expect(side(page)).toBeHidden();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('radio', { name: 'Side' })).toBeFocused();
  await expect(side(page)).toBeVisible();
  await expect(section(page)).toBeHidden();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('radio', { name: 'Both' })).toBeFocused();
  await expect(section(page)).toBeVisible();

  // The picture is panned and fitted by keys like the others.
  const before = await place(page, -20, 100);
  await side(page).focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => (await place(page, -20, 100)).clientX).not.toBe(before.clientX);
  await page.keyboard.press('f');
  await expect.poll(async () => (await place(page, -20, 100)).clientX).toBe(before.clientX);
});

const NAMES = {
  en: { side: 'Side', face: 'Face', all: 'All' },
  zh: { side: '圆柱面', face: '端面', all: '全部' },
  ru: { side: 'Развёртка', face: 'Торец', all: 'Все' },
} as const;

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(`holes of live tools are at their C positions: ${locale}`, nightUnless(locale === 'en'), async ({ page }) => {
    const names = NAMES[locale];
    await open(page, '#s003-g71');
    await chooseLanguage(page, locale);
    await type(page, HOLES);
    await expect(page.getByRole('radio', { name: names.side })).toBeVisible();
    // A position without grid lines.
    const work = await colour(page, -21.5, 47);
    const degrees = (mm: number): number => (mm / 30) * (180 / Math.PI);
    for (const c of [0, 90, 180, 270]) {
      // 3 mm from the centre in each direction there is a hole; 5 mm from it there is material.
      for (const [right, down] of [
        [1, 1],
        [1, -1],
        [-1, 1],
        [-1, -1],
      ] as const) {
        expect(await colour(page, -30 + right * 2.1, c + degrees(down * 2.1))).not.toBe(work);
        expect(await colour(page, -30 + right * 3.6, c + degrees(down * 3.6))).toBe(work);
      }
    }
    const hole = await place(page, -30, 180);
    await page.mouse.move(hole.clientX, hole.clientY);
    await expect(tooltip(page)).toContainText(/line 8|第 8 行|строка 8/);

    // With a hole in the face there are three pictures.
    await type(page, HOLES.replace('M30', 'G00 X40 Z5 C0\nG98 G83 X40 Z-12 R-3 F100\nG80 G00 X100\nM30'));
    await expect(page.getByRole('radio', { name: names.face })).toBeVisible();
    await page.getByRole('radio', { name: names.all }).click();
    await expect(page.getByRole('img')).toHaveCount(3);
    await page.getByRole('radio', { name: names.side }).click();
    await expect(section(page)).toBeHidden();
    await expect(side(page)).toBeVisible();
  });
}
