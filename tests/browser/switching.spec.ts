// Whatever was there before, and however fast it went: the page shows what a fresh one would.
//
// PLAYGROUND_SWITCHING_STEPS, _SEED and _STATES make it longer, or repeat it; a picture of what was
// wrong is kept in test-results.
import { test } from './engines';
import { writeFileSync } from 'node:fs';
import { examples } from './page';
import { freshLoads, fromEnvironment, switching } from './switching/scenario';

const options = fromEnvironment({ seed: 20, steps: 100, states: 10 });
const programs = examples.map(({ id }) => id);

test('switching at random always ends at the picture of a fresh start', async ({ page }, info) => {
  test.setTimeout(60_000 + 20_000 * options.states + 1_000 * options.steps);
  const keep = (name: string, png: Buffer): void => writeFileSync(info.outputPath(`${name}.png`), png);
  await switching(page, { ...options, programs, keep });
});

test('a program chosen right after another one is drawn whole', async ({ page }, info) => {
  test.setTimeout(120_000);
  // The pool begins with rough turning and the pattern, which was left half cut.
  const keep = (name: string, png: Buffer): void => writeFileSync(info.outputPath(`${name}.png`), png);
  await switching(page, { seed: 3, steps: 30, states: 2, programs, keep });
});

test('the first program is right after every load', async ({ page }, info) => {
  test.setTimeout(120_000);
  await freshLoads(page, 5, (name, png) => writeFileSync(info.outputPath(`${name}.png`), png));
});
