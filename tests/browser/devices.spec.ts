// Elements in the page of a manual on a phone, in dark mode and in print, which only Playwright can emulate.
import { chromiumTest as test, type ChromiumPage, expect, nightUnless } from './engines';
import { manual, openHtml } from './embedded';
import { settled, type Playground } from './page';

const PROGRAM = 'G97 S800 M03\nG00 X52 Z2\nG01 X40 F0.2\nZ-20\nX54\nG00 X200 Z200\nM30\n';
const TEXT = '<p>Words of the manual. </p>'.repeat(40);

function element(attributes: string): string {
  return `<gcode-playground ${attributes}><pre>${PROGRAM}</pre></gcode-playground>`;
}

for (const width of [320, 375]) {
  for (const view of ['all', 'picture', 'playback']) {
    test(
      `on a phone ${width} px wide the drawing is at least 240 px high: view="${view}"`,
      nightUnless(width === 320),
      async ({ browser, baseURL }, info) => {
        const context = await browser.newContext({
          ...(baseURL === undefined ? {} : { baseURL }),
          viewport: { width, height: 640 },
          deviceScaleFactor: 2,
          isMobile: true,
          hasTouch: true,
          locale: 'en-US',
        });
        const page = (await context.newPage()) as ChromiumPage;
        await openHtml(
          page,
          manual(`${TEXT}${element(`view="${view}"`)}${TEXT}`, '<meta name="viewport" content="width=device-width">'),
        );
        await settled(page);
        await page.locator('gcode-playground').scrollIntoViewIfNeeded();
        const seen = await page.locator('gcode-playground').evaluate((element) => {
          const canvas = element.shadowRoot!.querySelector('canvas')!;
          const { top, bottom } = canvas.getBoundingClientRect();
          const frames = ['.shown', '.frame'].map((frame) =>
            element.shadowRoot!.querySelector(frame)!.getBoundingClientRect(),
          );
          return (
            Math.min(bottom, ...frames.map((frame) => frame.bottom)) -
            Math.max(top, ...frames.map((frame) => frame.top))
          );
        });
        expect(seen).toBeGreaterThanOrEqual(240);
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
        await page.screenshot({ path: info.outputPath('phone.png') });

        // Touch on the drawing scrolls the page; after a tap on the drawing, touch pans the drawing.
        await page
          .locator('gcode-playground')
          .evaluate((element) => element.shadowRoot!.querySelector('canvas')!.scrollIntoView({ block: 'center' }));
        const box = (await page.getByRole('img', { name: /tool path/ }).boundingBox())!;
        const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
        const client = await context.newCDPSession(page);
        const drag = async (): Promise<void> => {
          const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', y: number) =>
            client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x: at.x, y }] });
          await touch('touchStart', at.y);
          for (let y = at.y; y > at.y - 90; y -= 10) await touch('touchMove', y);
          await touch('touchEnd', at.y - 90);
          // Wait until momentum scrolling has stopped.
          await page.evaluate(async () => {
            for (let last = NaN; last !== scrollY; await new Promise((done) => setTimeout(done, 300))) last = scrollY;
          });
        };
        const state = (): Promise<{ scrolled: number; shown: number }> =>
          page.locator('gcode-playground').evaluate(async (element) => {
            await (element as Playground).settled;
            const { clientY } = await (element as Playground).locate(0, 0);
            return { scrolled: scrollY, shown: clientY + scrollY };
          });
        const before = await state();
        await drag();
        const scrolled = await state();
        expect(scrolled.scrolled).toBeGreaterThan(before.scrolled + 40);
        expect(scrolled.shown).toBeCloseTo(before.shown, 0);
        const back = before.scrolled;
        await page.evaluate((back) => scrollTo(0, back), back);
        await page.touchscreen.tap(at.x, at.y);
        await drag();
        const moved = await state();
        expect(moved.scrolled).toBe(back);
        expect(moved.shown).toBeLessThan(before.shown - 40);
        await context.close();
      },
    );
  }
}

test('with a dark system, a light page shows a light element, and a page for both schemes shows a dark one', async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  const ground = (): Promise<number> =>
    page.locator('gcode-playground').evaluate(
      (element) =>
        getComputedStyle(element.shadowRoot!.querySelector('.frame')!)
          .backgroundColor.match(/\d+/g)!
          .slice(0, 3)
          .map(Number)
          .reduce((sum, value) => sum + value, 0) / 3,
    );
  // Use a new page each time: replacing the content does not reset the colour scheme of a page.
  const heads = {
    plain: '',
    meta: '<meta name="color-scheme" content="light dark">',
    style: '<style>:root { color-scheme: light dark; }</style>',
  };
  for (const [name, head] of Object.entries(heads)) {
    await page.route(`**/${name}.html`, (route) =>
      route.fulfill({ contentType: 'text/html', body: manual(element('view="picture"'), head) }),
    );
    await page.goto(`./rules/en/${name}.html`);
    await settled(page);
    if (name === 'plain') expect(await ground()).toBeGreaterThan(200);
    else expect(await ground(), name).toBeLessThan(60);
  }
});

for (const view of ['all', 'picture', 'playback', 'code']) {
  test(`a dark page prints light, with each program line on its own line: view="${view}"`, async ({ page }, info) => {
    await openHtml(
      page,
      manual(element(`view="${view}" caption="Figure 1"`), '<style>:root { color-scheme: dark; }</style>'),
    );
    await settled(page);
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    for (const line of ['G97 S800 M03', 'G01 X40 F0.2', 'M30'])
      await expect(page.getByText(line, { exact: false }).locator('visible=true').first()).toBeVisible();
    const lines = await page.locator('gcode-playground').evaluate((element) => {
      const root = element.shadowRoot!;
      const printed = [...root.querySelectorAll('.sheet-program li, .paper')].filter((part) => part.checkVisibility());
      return printed
        .map((part) => (part as HTMLElement).innerText)
        .join('\n')
        .trim()
        .split('\n');
    });
    expect(lines).toEqual(PROGRAM.trim().split('\n'));
    const shot = await page.screenshot({ path: info.outputPath('paper.png'), fullPage: true });
    const light = await page.evaluate(async (png) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))]));
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
      context.drawImage(image, 0, 0);
      const element = document.querySelector('gcode-playground')!.getBoundingClientRect();
      const { data } = context.getImageData(element.left, element.top, element.width, element.height);
      // The hatching is light grey.
      let bright = 0;
      for (let at = 0; at < data.length; at += 4) if (data[at]! + data[at + 1]! + data[at + 2]! > 500) bright++;
      return bright / (data.length / 4);
    }, shot.toString('base64'));
    expect(light).toBeGreaterThan(0.7);
  });
}

for (const view of ['all', 'picture', 'playback']) {
  test(
    `printing before the picture is ready shows the placeholder and the program: view="${view}"`,
    nightUnless(view === 'all'),
    async ({ page }, info) => {
      // The interpreter is never loaded.
      await page.route(/\.wasm$/, () => undefined);
      const fallback =
        '<svg slot="fallback" width="400" height="700"><rect width="400" height="700" fill="#ccc"/></svg>';
      const far = '<div style="height: 4000px"></div>';
      await openHtml(
        page,
        manual(
          `<gcode-playground view="${view}">${fallback}<pre>${PROGRAM}</pre></gcode-playground>${far}<gcode-playground view="${view}"><pre>${PROGRAM}</pre></gcode-playground>`,
        ),
      );
      await page.emulateMedia({ media: 'print' });
      await page.evaluate(() => {
        dispatchEvent(new Event('beforeprint'));
      });
      const printed = await page.locator('gcode-playground').evaluateAll((elements) =>
        elements.map((element) => {
          const root = element.shadowRoot!;
          const whole = root.querySelector('.frame')!.getBoundingClientRect();
          const svg = element.querySelector('svg')?.getBoundingClientRect();
          return {
            lines: [...root.querySelectorAll('.sheet-program li, .paper')]
              .filter((part) => part.checkVisibility())
              .map((part) => (part as HTMLElement).innerText)
              .join('\n')
              .trim(),
            picture: svg === undefined ? undefined : svg.bottom <= whole.bottom + 1 && svg.height === 700,
            buttons: [...root.querySelectorAll('button')].filter((button) => button.checkVisibility()).length,
          };
        }),
      );
      await page.screenshot({ path: info.outputPath('paper.png'), fullPage: true });
      expect(printed).toEqual([
        { lines: PROGRAM.trim(), picture: true, buttons: 0 },
        { lines: PROGRAM.trim(), picture: undefined, buttons: 0 },
      ]);
    },
  );
}
