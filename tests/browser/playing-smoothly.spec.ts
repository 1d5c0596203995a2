// Cost of playing: frames, paints of the worker and long tasks, which only Chromium reports.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromiumTest as test, type ChromiumPage, expect } from './engines';
import { open, openFile, settled, status } from './page';

const slider = (page: ChromiumPage) => page.getByRole('slider', { name: 'Position along the path' });
const share = async (page: ChromiumPage): Promise<number> => Number(await slider(page).inputValue());

/** Rough turning by cycles, about 2,000 motions. */
function longProgram(): string {
  const passes = Array.from(
    { length: 498 },
    (_, i) => `X${(99.9 - 0.1 * i).toFixed(1)} Z-${(80 - (i % 40)).toFixed(1)}`,
  );
  return [
    '(STOCK D100 L120)',
    'T0101',
    'G99 M03 S900',
    'G00 X102 Z2',
    `G90 ${passes[0]} F0.25`,
    ...passes.slice(1),
    'G00 X150 Z50',
    'M30',
    '',
  ].join('\n');
}

/** Counts frames of the page and of the worker's canvas, and the longest tasks (ms), within `ms`. */
async function count(
  page: ChromiumPage,
  ms: number,
): Promise<{ frames: number; shown: number; longest: number; asked: number }> {
  return page.evaluate(async (ms) => {
    let [frames, longest] = [0, 0];
    const places = new Set<string>();
    const root = document.querySelector('gcode-playground')?.shadowRoot;
    const input = root?.querySelector<HTMLInputElement>('input.scrub');
    const seen = Reflect.get(window, 'asked') as { count: number };
    const before = seen.count;
    const watch = new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) longest = Math.max(longest, entry.duration);
    });
    watch.observe({ type: 'longtask' });
    const end = performance.now() + ms;
    await new Promise<void>((done) => {
      const frame = (): void => {
        frames++;
        places.add(input?.value ?? '');
        if (performance.now() < end) requestAnimationFrame(frame);
        else done();
      };
      requestAnimationFrame(frame);
    });
    watch.disconnect();
    return { frames, shown: places.size, longest, asked: seen.count - before };
  }, ms);
}

test(
  '2,000 motions with their part play smoothly, and nothing runs while paused',
  { tag: '@night' },
  async ({ page }, info) => {
    await page.addInitScript(() => {
      const seen = { count: 0 };
      Reflect.set(window, 'asked', seen);
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (this: Worker, ...all: unknown[]) {
        seen.count++;
        Reflect.apply(post, this, all);
      };
    });
    await open(page);
    await openFile(page, 'part.nc', Buffer.from(longProgram()));
    await expect(status(page)).toContainText(/^1,994 motions/);
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await expect.poll(() => share(page)).toBeGreaterThan(0.05);
    // In its frames, the worker paints.
    await page.workers()[0]?.evaluate(() => {
      const drawn: number[] = [];
      Reflect.set(self, 'drawn', drawn);
      const next = self.requestAnimationFrame.bind(self);
      self.requestAnimationFrame = (work) =>
        next((now) => {
          const begun = performance.now();
          work(now);
          drawn.push(performance.now() - begun);
        });
    });
    const drawn = async (): Promise<number[]> =>
      (await page.workers()[0]?.evaluate(() => (Reflect.get(self, 'drawn') as number[]).splice(0))) ?? [];
    const seconds = 5;
    await drawn();
    const playing = await count(page, 1000 * seconds);
    const draws = (await drawn()).sort((a, b) => a - b);
    const median = draws[draws.length >> 1] ?? 0;
    const text = `${draws.length / seconds} drawings/s of ${median.toFixed(1)} ms (the longest ${draws.at(-1)?.toFixed(1)} ms), ${playing.frames / seconds} frames/s, ${playing.shown / seconds} places of the tool/s, longest task ${Math.round(playing.longest)} ms`;
    console.log(`playing 2,000 motions: ${text}`);
    info.annotations.push({ type: 'playing', description: text });
    await page.getByRole('button', { name: 'Pause' }).click();
    await page.waitForTimeout(500);
    const paused = await count(page, 1000);
    expect(
      await drawn()
        .then(() => page.waitForTimeout(500))
        .then(drawn),
    ).toEqual([]);
    expect(paused.asked).toBe(0);
    expect(paused.shown).toBe(1);
    await page.screenshot({ path: info.outputPath('playing.png') });
    // Far below the target, for busy machines.
    expect(playing.shown / seconds).toBeGreaterThan(10);
  },
);

/** Time of the main thread for each frame within `ms`: callbacks, styles, layout and paint; sorted, ms. */
function frameTimes(page: ChromiumPage, ms: number): Promise<number[]> {
  return page.evaluate(async (ms) => {
    const times: number[] = [];
    const { port1, port2 } = new MessageChannel();
    let begun = 0;
    // The message arrives once the frame is rendered.
    port1.onmessage = () => times.push(performance.now() - begun);
    const end = performance.now() + ms;
    await new Promise<void>((done) => {
      const frame = (): void => {
        begun = performance.now();
        port2.postMessage(undefined);
        if (begun < end) requestAnimationFrame(frame);
        else done();
      };
      requestAnimationFrame(frame);
    });
    return times.sort((a, b) => a - b);
  }, ms);
}

test('playing and dragging a shaft with the dimensions of its part leave most of each frame free', {
  tag: '@night',
}, async ({ page }) => {
  await open(page);
  await openFile(page, 'shaft.nc', readFileSync(join(__dirname, '..', 'speed', 'shaft.nc')));
  await page.getByRole('button', { name: 'Dimensions', exact: true }).click();
  await page.getByRole('menuitemradio', { name: 'Dimensions of the part' }).click();
  await settled(page);
  const box = (await page.locator('canvas').first().boundingBox())!;
  const drag = async (): Promise<void> => {
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    for (let step = 0; step < 120; step++) {
      const turn = step / 20;
      await page.mouse.move(box.x + box.width / 2 + 80 * Math.sin(turn), box.y + box.height / 2 + 80 * Math.cos(turn));
    }
    await page.mouse.up();
  };
  const report = (name: string, times: readonly number[]): void => {
    const at = (share: number): number => times[Math.floor(share * (times.length - 1))] ?? 0;
    console.log(
      `${name}: ${times.length} frames, median ${at(0.5).toFixed(1)} ms, 95 % within ${at(0.95).toFixed(1)} ms`,
    );
    expect(times.length).toBeGreaterThan(60);
    expect(at(0.5)).toBeLessThan(8);
    expect(at(0.95)).toBeLessThan(16);
  };
  const [dragging] = await Promise.all([frameTimes(page, 3000), drag()]);
  report('dragging with dimensions', dragging);
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  report('playing with dimensions', await frameTimes(page, 3000));
});
