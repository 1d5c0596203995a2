// The stored page in two tabs and from any static server; as an installed app; and with programs that cannot be stored.
// Only in Chromium: the tests need a second tab, network emulation and a separate server process.
import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage, nightUnless } from './engines';
import { chooseExample, chooseLanguage, motionCount, openMenu, settled, value } from './page';
import { DIST, nextBuild, storedSite, type StoredSite } from './stored-site';

const AXE = readFileSync(join(DIST, '..', 'node_modules/axe-core/axe.min.js'), 'utf8');

test.use({
  storing: 'on',
  // With WebGL, rendered by the CPU.
  launchOptions: {
    ...(process.env['PLAYGROUND_CHROMIUM'] ? { executablePath: process.env['PLAYGROUND_CHROMIUM'] } : {}),
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist',
      '--disable-quic',
      '--no-first-run',
    ],
  },
});
test.setTimeout(120_000);

/** The title of `s003-g71`. */
/** The next build has another title, too. */
const ROUGH_TURNING = /Rough turning to a contour: G71 (\(NEXT\) )?and G70/;

const status = (page: ChromiumPage) => page.locator('gcode-playground').getByRole('status');
const news = (page: ChromiumPage) => page.getByText('There is a newer version of this page.');
const build = (page: ChromiumPage) =>
  page.evaluate(() => document.querySelector('meta[name=build]')?.getAttribute('content') ?? 'first');

async function visit(page: ChromiumPage, address: string): Promise<void> {
  await page.goto(address);
  await expect(status(page)).toContainText(/\d/);
  await expect(status(page)).not.toContainText('…');
}

async function visitAndStore(page: ChromiumPage, { address }: StoredSite): Promise<void> {
  await visit(page, address);
  await expect(page.locator('#offline', { hasText: 'Works offline' })).toHaveCount(1, { timeout: 60_000 });
}

test('two tabs never mix files of two versions', { tag: '@night' }, async ({ page, context }) => {
  const site = await storedSite();
  await visitAndStore(page, site);
  site.publish(nextBuild());
  const other = (await context.newPage()) as ChromiumPage;
  await visit(other, site.address);
  await expect(news(other)).toBeVisible({ timeout: 60_000 });
  expect(await build(other)).toBe('first');

  await other.getByRole('button', { name: 'Reload', exact: true }).click();
  await expect.poll(() => build(other).catch(() => '')).toBe('next');
  await expect(status(other)).toContainText(/\d+ motions/);
  // The first tab continues with its files, and is notified of the update; the server no longer has its files.
  await expect(news(page)).toBeVisible();
  expect(await build(page)).toBe('first');
  await chooseExample(page, ROUGH_TURNING);
  await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
  expect(await value(page)).not.toContain('NEXT');
  await page.getByRole('button', { name: 'Show the part as a solid' }).click();
  await expect(page.getByRole('img', { name: /three dimensions/ })).toBeVisible();
  await page.keyboard.press('Escape');
  await chooseExample(other, ROUGH_TURNING);
  await expect.poll(() => value(other)).toContain('NEXT');

  // Both versions are kept while a tab uses them.
  const versions = () =>
    other.evaluate(
      async () => (await caches.keys()).filter((name) => /^gcode-playground .* [0-9a-f]{32}$/.test(name)).length,
    );
  expect(await versions()).toBe(2);
  await page.getByRole('button', { name: 'Later' }).click();
  await expect(news(page)).toBeHidden();
  await page.close();
  // For a minute, a tab counts as being opened.
  await other.clock.install();
  await other.evaluate(async () => {
    for (const name of (await caches.keys()).filter((name) => name.endsWith(' tabs'))) {
      const tabs = await caches.open(name);
      for (const request of await tabs.keys()) {
        const tab = (await (await tabs.match(request))!.json()) as { version: string };
        await tabs.put(request, new Response(JSON.stringify({ ...tab, since: 0 })));
      }
    }
  });
  await other.reload();
  await expect.poll(versions).toBe(1);
  await site.stop();
});

test('responses during an update are not cached', async ({ page }) => {
  const site = await storedSite();
  // The new service worker is available, the new examples are not.
  const next = nextBuild();
  site.publish(new Map([...next].filter(([path]) => path !== 'offline/examples.json')));
  await visit(page, site.address);
  await expect(page.locator('#offline', { hasText: 'Not stored for offline use' })).toHaveCount(1, { timeout: 60_000 });
  site.publish(next);
  await page.reload();
  await expect(page.locator('#offline', { hasText: 'Works offline' })).toHaveCount(1, { timeout: 60_000 });
  await site.stop();
});

test('a reload does not lose a program that the browser cannot store', { tag: '@night' }, async ({ page }) => {
  const site = await storedSite();
  await visitAndStore(page, site);
  site.publish(nextBuild());
  await page.reload();
  await expect(news(page)).toBeVisible({ timeout: 60_000 });
  const long = `${'G01 X40 Z-20 F0.2\n'.repeat(120_000)}M30\n`;
  await page
    .locator('gcode-playground')
    .evaluate((element, text) => void Object.assign(element, { value: text }), long);
  await page.getByRole('button', { name: 'Reload', exact: true }).click();
  await expect(page.getByText('The browser cannot keep this program')).toBeVisible();
  expect((await value(page)).length).toBe(long.length);
  expect(await build(page)).toBe('first');
  await page.getByRole('button', { name: 'Reload all the same' }).click();
  await expect.poll(() => build(page).catch(() => '')).toBe('next');
  await site.stop();
});

test('the 3D view reports a missing network, and is shown when it is back', async ({ page }) => {
  await page.route(/service-worker\.js/, (route) => route.abort());
  const site = await storedSite();
  await visit(page, site.address);
  await site.stop();
  await page.context().setOffline(true);
  await page.getByRole('button', { name: 'Show the part as a solid' }).click();
  const dialog = page.getByRole('dialog', { name: 'The part, a quarter cut away' });
  await expect(dialog.getByText('The view could not be loaded: no network connection.')).toBeVisible();
  await dialog.getByRole('button', { name: 'Try again' }).click();
  await expect(dialog.getByText('The view could not be loaded: no network connection.')).toBeVisible();
  await site.start();
  await page.context().setOffline(false);
  await expect(dialog.getByRole('img', { name: /three dimensions/ })).toBeVisible();
  await site.stop();
});

test('a zip of the page runs in a subfolder of a generic static server', { tag: '@night' }, async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'playground-zip-'));
  let server: ChildProcess | undefined;
  try {
    const zip = join(folder, 'gcode-playground.zip');
    // As in README, except for the path of the zip.
    execFileSync('python3', ['-m', 'zipfile', '-c', zip, 'www/dist'], { cwd: join(DIST, '..', '..') });
    execFileSync('python3', ['-m', 'zipfile', '-e', zip, join(folder, 'some', 'where')]);
    server = spawn('python3', ['-u', '-m', 'http.server', '0', '--bind', '127.0.0.1'], {
      cwd: folder,
      stdio: ['ignore', 'pipe', 'ignore'],
    });
    const port = await new Promise<string>((resolve) =>
      server!.stdout!.on('data', (data: Buffer) => resolve(/port (\d+)/.exec(String(data))?.[1] ?? '')),
    );
    const address = `http://127.0.0.1:${port}/some/where/dist/`;
    const outside: string[] = [];
    page.on(
      'request',
      (request) =>
        request.url().startsWith('http') && !request.url().startsWith(address) && outside.push(request.url()),
    );
    await visit(page, address);
    await expect(page.locator('#offline', { hasText: 'Works offline' })).toHaveCount(1, { timeout: 60_000 });
    await page.goto(`${address}rules/en/absolute-and-incremental.html`);
    await page.getByRole('link', { name: 'G-code playground' }).click();
    await expect(status(page)).toContainText(/\d+ motions/);
    expect(outside.filter((url) => !url.endsWith('/favicon.ico'))).toEqual([]);
  } finally {
    server?.kill();
    rmSync(folder, { recursive: true, force: true });
  }
});

test('the page can be installed, its manifest is in the language of the page, and it opens files', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, 'launchQueue', {
      value: { setConsumer: (consumer: unknown) => Reflect.set(window, 'launch', consumer) },
    });
  });
  const site = await storedSite();
  await visitAndStore(page, site);
  for (const [language, name] of [
    ['en', 'G-code playground'],
    ['zh', 'G 代码演练场'],
    ['ru', 'Песочница G-кода'],
  ] as const) {
    await chooseLanguage(page, language);
    const manifest = await page.evaluate(
      async () =>
        (await fetch(document.querySelector<HTMLLinkElement>('link[rel=manifest]')!.href)).json() as Promise<{
          name: string;
          icons: { src: string }[];
        }>,
    );
    expect(manifest.name).toBe(name);
    for (const { src } of manifest.icons) expect(readFileSync(join(DIST, src)).length).toBeGreaterThan(100);
  }
  // Installability errors that Chromium reports.
  const session = await page.context().newCDPSession(page);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  expect(installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito')).toEqual([]);
  await page.evaluate(() => {
    const launch = Reflect.get(window, 'launch') as (launched: object) => void;
    launch({ files: [{ getFile: () => Promise.resolve(new File(['G00 X50 Z2\nG01 Z-9 F0.2\n'], 'part.nc')) }] });
  });
  await expect.poll(() => value(page)).toContain('Z-9');
  await site.stop();
});

test('the element in another page stores nothing', { tag: '@night' }, async ({ page }) => {
  const site = await storedSite();
  site.publish(
    new Map([
      [
        'manual.html',
        `<!doctype html><title>Manual</title><script type="module" src="embed/element.js"></script><gcode-playground>G00 X50 Z2\nG01 Z-9 F0.2\nM30</gcode-playground>`,
      ],
    ]),
  );
  await visit(page, `${site.address}manual.html`);
  await settled(page);
  await page.waitForTimeout(2500);
  expect(
    await page.evaluate(async () => [
      (await navigator.serviceWorker.getRegistrations()).length,
      (await caches.keys()).length,
    ]),
  ).toEqual([0, 0]);
  expect(site.requested.filter((path) => /service-worker|offline\//.test(path))).toEqual([]);
  await site.stop();
});

for (const [locale, colorScheme, message, wanted] of [
  ['en', 'light', 'Works offline', 'Reload'],
  ['zh', 'dark', '可离线使用', '重新加载'],
  ['ru', 'light', 'Работает без сети', 'Обновить'],
] as const) {
  test(
    `axe finds nothing in notices about versions and storing, on a phone and on a desktop: ${locale}`,
    nightUnless(locale === 'en'),
    async ({ browser }) => {
      const context = await browser.newContext({ locale, colorScheme, viewport: { width: 390, height: 844 } });
      const page = (await context.newPage()) as ChromiumPage;
      const site = await storedSite();
      await visit(page, site.address);
      await openMenu(page, 'more');
      await expect(page.locator('#offline', { hasText: message })).toBeVisible({ timeout: 60_000 });
      site.publish(nextBuild());
      await page.reload();
      const reload = page.getByRole('button', { name: wanted, exact: true });
      await expect(reload).toBeVisible({ timeout: 60_000 });
      const box = (await reload.boundingBox())!;
      expect(box.x + box.width).toBeLessThanOrEqual(390);
      await page.evaluate(AXE);
      const wrong = async (): Promise<string[]> =>
        page.evaluate(async () => {
          interface Axe {
            run(context: Document): Promise<{ violations: { id: string; nodes: { target: unknown }[] }[] }>;
          }
          const { violations } = await (Reflect.get(window, 'axe') as Axe).run(document);
          return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id} ${JSON.stringify(target)}`));
        });
      expect(await wrong()).toEqual([]);
      await openMenu(page, 'more');
      await expect(page.locator('#offline', { hasText: message })).toBeVisible();
      expect(await wrong()).toEqual([]);
      await page.keyboard.press('Escape');
      await page.setViewportSize({ width: 1280, height: 800 });
      expect(await wrong()).toEqual([]);
      await openMenu(page, 'more');
      expect(await wrong()).toEqual([]);
      await context.close();
      await site.stop();
    },
  );
}
