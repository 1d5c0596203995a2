// Layout: tabs in small windows, and the divider.
import { type BasicPage, chromiumTest, expect, test } from './engines';
import {
  atCursor,
  chip,
  choose,
  drawing,
  editor,
  open,
  openMenu,
  openProblems,
  problems,
  status,
  tab,
  title,
  type,
} from './page';

const LEGEND_BELOW = 'the legend and the readout are below the picture of a narrow window';

async function expectLegendBelow(page: BasicPage, width: number): Promise<void> {
  await page.setViewportSize({ width, height: 844 });
  await open(page);
  const isBelow = async (part: string): Promise<void> => {
    const [box, picture] = [await page.locator(part).boundingBox(), await drawing(page).boundingBox()];
    expect(box?.y ?? 0, part).toBeGreaterThanOrEqual((picture?.y ?? 0) + (picture?.height ?? 0));
  };
  await expect(page.locator('[part~=legend]')).toContainText('rapid');
  await isBelow('[part~=legend]');
  await page.getByRole('button', { name: /^Next motion/ }).click();
  await expect(page.locator('[part~=doing]')).toBeVisible();
  await isBelow('[part~=doing]');
  await expect(page.locator('[part~=legend]')).toBeHidden();
}

test(`${LEGEND_BELOW}: 500`, async ({ page }) => expectLegendBelow(page, 500));
// A window of WebKit is at least 447 px wide.
for (const width of [320, 390])
  chromiumTest(`${LEGEND_BELOW}: ${width}`, async ({ page }) => expectLegendBelow(page, width));

test('in a low window, tabs show program, problems and explanation, and the drawing stays visible', async ({
  page,
}) => {
  await page.setViewportSize({ width: 820, height: 420 });
  await open(page);
  await expect(tab(page, 'program')).toHaveAttribute('aria-selected', 'true');
  await expect(editor(page)).toBeVisible();
  await type(page, 'G0 X50 Z2\nX\nM30');
  await expect(tab(page, 'problems')).toContainText('1');

  await tab(page, 'problems').click();
  await expect(problems(page).getByRole('listitem')).toHaveCount(1);
  await expect(editor(page)).toBeHidden();
  await expect(drawing(page)).toBeVisible();
  await expect(page.getByRole('tabpanel', { name: /^Problems/ })).toBeVisible();
  // Arrow keys cycle through the tabs.
  await page.keyboard.press('ArrowRight');
  await expect(tab(page, 'explain')).toHaveAttribute('aria-selected', 'true');
  await expect(chip(page)).toBeVisible();
  await expect(atCursor(page)).toContainText('The control before and after line');
  await expect(problems(page)).toBeHidden();
  await expect(drawing(page)).toBeVisible();
  await page.keyboard.press('ArrowRight');
  await expect(tab(page, 'program')).toHaveAttribute('aria-selected', 'true');
  await expect(editor(page)).toBeVisible();
  // Screen readers hear the state of the run, whichever tab is open.
  await expect(status(page)).toContainText('1 motion');
  await expect(page.getByRole('button', { name: 'Help', exact: true })).toBeVisible();
  await page.keyboard.press('ArrowLeft');
  await expect(tab(page, 'explain')).toHaveAttribute('aria-selected', 'true');
  await expect(status(page)).toContainText('1 motion');

  // F8 shows the block of a problem from any tab.
  await page.keyboard.press('F8');
  await expect(tab(page, 'program')).toHaveAttribute('aria-selected', 'true');
  await expect(editor(page)).toBeFocused();
  await tab(page, 'program').focus();
  await page.keyboard.press('ArrowRight');
  await problems(page).getByRole('listitem').getByRole('button').first().click();
  await expect(editor(page)).toBeFocused();
});

test('in a large window there are no tabs', async ({ page }) => {
  await open(page);
  await type(page, 'G0 X50 Z2\nX\nM30');
  await openProblems(page);
  await expect(problems(page)).toBeVisible();
  await expect(editor(page)).toBeVisible();
  await expect(tab(page, 'program')).toBeHidden();
  await expect(page.getByRole('tabpanel')).toHaveCount(0);
  await expect(status(page)).toContainText('1 motion');
});

test('the controls of the playback row, and the readout over the drawing, do not overlap and are not cut off', {
  tag: '@one-engine',
}, async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Next motion' }).click();
  for (const language of ['en', 'zh', 'ru']) {
    await page
      .locator('gcode-playground')
      .evaluate((element, language) => element.setAttribute('language', language), language);
    for (let width = 740; width <= 1400; width += 60) {
      await page.setViewportSize({ width, height: 800 });
      const overlaps = await page.locator('gcode-playground').evaluate((element) => {
        const root = element.shadowRoot!;
        const [row, picture] = [root.querySelector('.playback')!, root.querySelector('.pictures')!];
        const controls = [
          ...row.children,
          ...root.querySelectorAll('.readout .cell, .doing, .over-picture > button, .legend'),
        ].filter((control) => control.getClientRects().length > 0);
        const boxes = controls.map((control) => control.getBoundingClientRect());
        const outside = controls.filter((control, at) => {
          const [box, all] = [boxes[at]!, (row.contains(control) ? row : picture).getBoundingClientRect()];
          return (
            box.left < all.left || box.right > all.right || box.top < all.top - 0.5 || box.bottom > all.bottom + 0.5
          );
        });
        const share = (a: DOMRect, b: DOMRect): boolean =>
          Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0.5 &&
          Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.5;
        return [
          ...outside.map((control) => `cut off: ${control.className}`),
          ...boxes.flatMap((a, i) =>
            boxes
              .slice(i + 1)
              .flatMap((b, j) => (share(a, b) ? [`${controls[i]?.className} ${controls[i + 1 + j]?.className}`] : [])),
          ),
        ];
      });
      expect(overlaps, `${language}, ${width}`).toEqual([]);
    }
  }
});

test('the divider is moved by keys, and keeps its position', async ({ page }) => {
  await open(page);
  const divider = page.getByRole('separator', { name: 'Width of the program' });
  const width = async (): Promise<number> => (await drawing(page).boundingBox())?.width ?? 0;
  const before = await width();
  await divider.focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
  await expect(divider).toHaveAttribute('aria-valuenow', '52');
  await expect.poll(width).toBeLessThan(before - 100);
  const narrow = await width();
  await open(page);
  await expect(divider).toHaveAttribute('aria-valuenow', '52');
  expect(Math.abs((await width()) - narrow)).toBeLessThan(2);
  await divider.focus();
  await page.keyboard.press('Enter');
  await expect(divider).toHaveAttribute('aria-valuenow', '42');
  // The pointer moves it as well.
  const box = await divider.boundingBox();
  const [x, y] = [(box?.x ?? 0) + 4, (box?.y ?? 0) + 200];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 100, y);
  await page.mouse.up();
  await expect.poll(width).toBeGreaterThan(before + 80);
});

test('playback keys work before any element has the focus', async ({ page }) => {
  await open(page);
  const slider = page.getByRole('slider');
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press('F9');
  await expect(slider).not.toHaveAttribute('aria-valuetext', '–');
  // A button of the page around the element.
  await page.getByRole('button', { name: 'About this program' }).focus();
  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
});

test('the text size of the whole page can be increased, also in the drawing', async ({ page }) => {
  await open(page);
  const height = async (): Promise<number> => (await title(page).boundingBox())?.height ?? 0;
  const before = await height();
  await choose(page, 'more', '200 %');
  await expect.poll(height).toBeGreaterThan(before * 1.7);
  await open(page);
  await openMenu(page, 'more');
  await expect(page.getByRole('menuitemradio', { name: '200 %' })).toHaveAttribute('aria-checked', 'true');
  await page.getByRole('menuitemradio', { name: '100 %', exact: true }).click();
  await expect.poll(height).toBeLessThan(before * 1.1);
});

test('presentation mode shows program and drawing in large type, and steps by the keys of a remote control', async ({
  page,
}) => {
  await open(page);
  const share = page.getByRole('button', { name: 'Share', exact: true });
  await choose(page, 'more', 'Present');
  await expect(page.getByRole('button', { name: 'End presentation' })).toBeVisible();
  await expect(share).toBeHidden();
  await page.keyboard.press('PageDown');
  await page.keyboard.press('PageDown');
  await expect(page.getByRole('slider')).not.toHaveAttribute('aria-valuetext', '–');
  await expect(drawing(page)).toBeVisible();
  await expect(editor(page)).toBeVisible();
  await page.getByRole('button', { name: 'End presentation' }).click();
  await expect(page.getByRole('button', { name: 'End presentation' })).toBeHidden();
  await expect(share).toBeVisible();
});
