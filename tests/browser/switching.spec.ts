// The page always shows the same as a fresh page, whatever it showed before and however fast it was switched.
//
// PLAYGROUND_SWITCHING_STEPS, _SEED and _STATES make the test longer or repeat it; a picture of a failure is stored in
// test-results.
import { expect, test } from './engines';
import { writeFileSync } from 'node:fs';
import { examples, open } from './page';
import { freshLoads, fromEnvironment, switching } from './switching/scenario';

const options = fromEnvironment({ seed: 20, steps: 100, states: 10 });
const programs = examples.map(({ id }) => id);

test('switching at random always ends with the picture of a fresh page', { tag: '@night' }, async ({ page }, info) => {
  test.setTimeout(60_000 + 20_000 * options.states + 1_000 * options.steps);
  const keep = (name: string, png: Buffer): void => writeFileSync(info.outputPath(`${name}.png`), png);
  await switching(page, { ...options, programs, keep });
});

test('a program chosen right after another one is drawn completely', async ({ page }, info) => {
  test.setTimeout(120_000);
  // The pool starts with rough turning and the pattern, whose part was once left half cut.
  const keep = (name: string, png: Buffer): void => writeFileSync(info.outputPath(`${name}.png`), png);
  await switching(page, { seed: 3, steps: 30, states: 2, programs, keep });
});

test('the first program is drawn correctly after every load', async ({ page }, info) => {
  test.setTimeout(120_000);
  await freshLoads(page, 5, (name, png) => writeFileSync(info.outputPath(`${name}.png`), png));
});

test('a picture that arrives after the next run has started is painted again', async ({ page }) => {
  // An own program starts two consecutive runs; the picture of the first arrives after the second has started.
  await page.addInitScript(() => {
    const own = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage')!;
    Object.defineProperty(Worker.prototype, 'onmessage', {
      ...own,
      set(heard: (event: MessageEvent<{ event?: { kind: string } }>) => void) {
        own.set!.call(this, (event: MessageEvent<{ event?: { kind: string } }>) => {
          if (event.data.event?.kind === 'pictures') setTimeout(() => heard(event), 150);
          else heard(event);
        });
      },
    });
  });
  await open(page);
  const replace = (text: string, setup: string | undefined): Promise<void> =>
    page.evaluate(
      async ({ text, setup }) => {
        const element = document.querySelector('gcode-playground') as HTMLElement & {
          value: string;
          setup: string | null;
          readonly settled: Promise<number>;
        };
        element.value = text;
        if (setup !== undefined) {
          await new Promise((resolve) => setTimeout(resolve, 60));
          element.setup = setup;
        }
        await element.settled;
      },
      { text, setup },
    );
  const pixels = (): Promise<number> =>
    page.evaluate(() => {
      const canvas = document.querySelector('gcode-playground')!.shadowRoot!.querySelector('canvas')!;
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext('2d')!;
      context.drawImage(canvas, 0, 0);
      return context
        .getImageData(0, 0, copy.width, copy.height)
        .data.reduce((sum, value, at) => (sum * 31 + value * (at % 7)) % 1_000_003, 0);
    });
  const text = 'M03 S500\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nX45\nG00 X100\nM30\n';
  // The setup of the example is kept for the next text; the text below has none.
  await replace(text, '{}');
  const whole = await pixels();
  await replace('G00 X20 Z5\nG01 Z-9 F0.1\n', '{"dialect": {"control": "gsk"}}');
  expect(await pixels()).not.toBe(whole);
  await replace(text, '{}');
  expect(await pixels()).toBe(whole);
});
