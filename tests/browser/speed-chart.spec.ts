// The chart of a program that only sets speeds, in place of an empty picture.
import { expect, test, type BasicPage, type Locator } from './engines';
import { open, settled, type } from './page';

const SPEEDS = 'G50 S1500\nG96 S100 M03\nG96 S200\nM30';
const chart = (page: BasicPage): Locator => page.getByRole('img', { name: 'Spindle speed over the diameter' });

test('a program that only sets speeds is a chart until it moves', async ({ page }) => {
  await open(page);
  await type(page, SPEEDS);
  await expect(chart(page)).toBeVisible();
  // The image is drawn, and covers the message of the empty picture.
  const width = () => chart(page).evaluate((image) => (image as HTMLImageElement).naturalWidth);
  await expect.poll(width).toBeGreaterThan(0);
  await expect(page.getByText('No motion yet')).toBeHidden();

  await type(page, `${SPEEDS.replace('M30', 'G00 X40 Z2')}\nM30`);
  await settled(page);
  await expect(chart(page)).toBeHidden();

  // Without a cutting speed there is no chart.
  await type(page, 'G97 S800 M03\nM30');
  await expect(page.getByText('No motion yet')).toBeVisible();
  await expect(chart(page)).toBeHidden();
});
