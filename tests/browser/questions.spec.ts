// Questions of a learner, each answered in place by at most one click or by pointing.
import { chromiumTest as test, expect, type Locator, type Page } from './engines';
import { atCursor, chooseLanguage, locate, open, tooltip } from './page';

const card = (page: Page): Locator => page.locator('.word-card');

/** Points at a text in a line of the program, from 1. */
async function pointAt(page: Page, line: number, text: string): Promise<{ x: number; y: number }> {
  const box = await page
    .locator('.cm-line')
    .nth(line - 1)
    .evaluate((element, text) => {
      const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
      const range = document.createRange();
      const at = (element.textContent ?? '').indexOf(text);
      let before = 0;
      for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        const { length } = node.textContent ?? '';
        if (at >= before && at < before + length) {
          range.setStart(node, at - before);
          range.setEnd(node, at - before + 1);
          break;
        }
        before += length;
      }
      const { left, top, width, height } = range.getBoundingClientRect();
      return { x: left + width / 2, y: top + height / 2 };
    }, text);
  await page.mouse.move(box.x, box.y);
  return box;
}

test('what is U2 in G71 U2 R1', async ({ page }) => {
  await open(page, '#s003-g71');
  await pointAt(page, 3, 'U2');
  await expect(card(page)).toContainText('depth of cut of each pass, on radius');
  await expect(card(page)).toContainText('2 mm');
});

test('why is X60 drawn 30 from the centre', async ({ page }) => {
  await open(page);
  await pointAt(page, 9, 'X60');
  await expect(card(page)).toContainText('a diameter');
  await expect(card(page)).toContainText('30 mm from the centre line.');
});

test('where does line 11 go', async ({ page }) => {
  await open(page);
  const { x, y } = await pointAt(page, 11, 'G90');
  await page.mouse.click(x, y);
  await expect(atCursor(page)).toContainText('one taper pass from X105 Z-30 to X120 Z-44');
});

test('what diameter is left at Z-20', async ({ page }) => {
  await open(page);
  // Inside the part, far from any edge and stroke.
  const place = await locate(page, 25, -20);
  await page.mouse.move(place.x, place.y);
  await expect(tooltip(page)).toContainText(/Ø60 at Z−(19|20)/);
});

test('why R-7.5 and not R7.5, and which angle has the taper', async ({ page }) => {
  await open(page);
  await pointAt(page, 11, 'R-7.5');
  // R = (105 − 120) / 2; the angle is that of 7.5 over 14.
  await expect(card(page)).toContainText('The cut starts at Ø105 mm and ends at Ø120 mm: 28.18° to the Z axis.');
  await expect(card(page)).toContainText('With the other sign it would start at Ø135 mm.');
});

test('is F200 per minute or per turn', async ({ page }) => {
  await open(page);
  await pointAt(page, 3, 'F200');
  await expect(card(page)).toContainText('200 mm/min');
});

test('how long does it take', async ({ page }) => {
  await open(page);
  const time = page.locator('[part=time]');
  // One number; the assumed rate is named.
  await expect(time).toHaveText(/^\d+:\d\d$/);
  await expect(time).toHaveAttribute('title', /8,000 mm\/min is assumed/);
});

test('where is the tool at the start', async ({ page }) => {
  await open(page);
  await expect(page.locator('.legend')).toContainText('tool starts at X200 Z100');
});

test('what are X, Z and the semicolon', async ({ page }) => {
  await open(page);
  await pointAt(page, 2, 'X130');
  await expect(card(page)).toContainText('X of the end point, a diameter');
  await pointAt(page, 2, 'Z3');
  await expect(card(page)).toContainText('Z of the end point');
  await page.mouse.move(1, 1);
  await pointAt(page, 2, ';');
  await expect(card(page)).toContainText('end of the block');
  await chooseLanguage(page, 'zh');
  await pointAt(page, 3, ';');
  await expect(card(page)).toContainText('程序段结束');
});

test('why does this block not move', async ({ page }) => {
  await open(page, '#s002-g50-g96');
  const { x, y } = await pointAt(page, 3, 'G50');
  await page.mouse.click(x, y);
  await expect(atCursor(page)).toContainText('No motion: the block names no axis.');
});
