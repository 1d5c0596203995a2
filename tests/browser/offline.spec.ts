// The page without a network: after the first visit everything works. A newer version is announced and never replaces
// the open one; a missing part is reported and retried.
import { join } from 'node:path';
import { expect, test, type Page } from './engines';
import {
  choose,
  chooseFile,
  chooseExample,
  chooseLanguage,
  drawing,
  editor,
  motionCount,
  openMenu,
  program,
  type,
  value,
} from './page';
import { DIST, nextBuild, storedSite, type StoredSite } from './stored-site';

test.use({ storing: 'on' });
// The whole page is fetched, more than once.
test.setTimeout(180_000);

/** Status of the program; the notice about a newer version is also a status. */
const status = (page: Page) => page.locator('gcode-playground').getByRole('status');
const stored = (page: Page) => page.locator('#offline', { hasText: /^(Works offline|可离线使用|Работает без сети)$/ });
/** The title of the example `s003-g71`, up to the words that differ in the next build. */
const G71 = 'Rough turning to a contour: ';
const news = (page: Page) => page.getByText('There is a newer version of this page.');

async function visit(page: Page, site: StoredSite, hash = ''): Promise<void> {
  await page.goto(`${site.address}${hash}`);
  await expect(status(page)).toContainText(/\d/);
  await expect(status(page)).not.toContainText('…');
}

async function visitAndStore(page: Page, site: StoredSite, hash = ''): Promise<void> {
  await visit(page, site, hash);
  await expect.poll(() => stored(page).count(), { timeout: 60_000 }).toBe(1);
}

/** The menu "More" says whether the page works offline. */
async function expectStored(page: Page): Promise<void> {
  await openMenu(page, 'more');
  await expect(stored(page)).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(stored(page)).toBeHidden();
}

async function closed(page: Page): Promise<void> {
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
}

/** Waits until exactly these packs with pages in a language are stored. */
async function expectPacks(page: Page, packs: readonly string[]): Promise<void> {
  const stored = (): Promise<string[]> =>
    page.evaluate(async () => {
      const all = await Promise.all((await caches.keys()).map(async (name) => (await caches.open(name)).keys()));
      const names = all.flat().map(({ url }) => /offline\/((?:manual|rules)-(?:en|zh|ru))\.json$/.exec(url)?.[1]);
      return names.filter((name) => name !== undefined).sort();
    });
  await expect.poll(stored).toEqual(packs);
}

test('after the first visit everything works without a network', async ({ page }) => {
  const site = await storedSite();
  await visitAndStore(page, site);
  // The language of the browser is stored; others are once the page, or a page of the manual, is opened in them.
  await expectPacks(page, ['manual-en', 'rules-en']);
  await chooseLanguage(page, 'ru');
  await expectPacks(page, ['manual-en', 'manual-ru', 'rules-en', 'rules-ru']);
  await chooseLanguage(page, 'en');
  await page.goto(`${site.address}manual/zh/index.html`);
  await expectPacks(page, ['manual-en', 'manual-ru', 'manual-zh', 'rules-en', 'rules-ru', 'rules-zh']);
  await page.goto(site.address);
  await expectStored(page);
  await site.stop();

  await test.step('reload', async () => {
    await page.reload();
    await expect(status(page)).toContainText(/\d+ motions/);
    await expect(status(page)).not.toContainText('…');
    await expectStored(page);
  });
  await test.step('gallery and another example', async () => {
    await chooseExample(page, 'Boring to a contour: G71');
    await expect.poll(() => value(page)).toBe(program('hand-03-g71-boring'));
    await chooseExample(page, G71);
    await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
  });
  await test.step('the part in 3D', async () => {
    await page.getByRole('button', { name: 'Show the part as a solid' }).click();
    const dialog = page.getByRole('dialog', { name: 'The part, a quarter cut away' });
    // A browser without WebGL shows a message instead.
    await expect(dialog.getByRole('img', { name: /three dimensions/ }).or(dialog.getByText('WebGL'))).toBeVisible();
    await closed(page);
  });
  await test.step('setup', async () => {
    await page.getByRole('button', { name: /^Setup/ }).click();
    await expect(page.getByRole('dialog', { name: /Setup/ })).toBeVisible();
    await closed(page);
  });
  await test.step('export', async () => {
    const saved = page.waitForEvent('download');
    await choose(page, 'share', /SVG/);
    expect((await saved).suggestedFilename()).toMatch(/^(program|O\d+)\.svg$/);
  });
  await test.step('help at the word', async () => {
    await editor(page).focus();
    await page.keyboard.press('Control+Home');
    await expect(page.getByRole('region', { name: /^At the cursor/ })).toContainText(/\w/);
  });
  await test.step('languages', async () => {
    await chooseLanguage(page, 'zh');
    await expect(status(page)).toContainText('段运动');
    await chooseLanguage(page, 'ru');
    await expect(status(page)).toContainText('перемещени');
    await expectStored(page);
  });
  await test.step('a program is stored', async () => {
    await type(page, 'G00 X50 Z2\nG01 X40 Z-20 F0.2\nM30\n');
    await expect(status(page)).toContainText('2 перемещени');
    await page.reload();
    await expect(status(page)).toContainText('2 перемещени');
    expect(await value(page)).toContain('X40 Z-20');
  });
  await test.step('pages of rules, with their pictures', async () => {
    await page.goto(`${site.address}rules/ru/absolute-and-incremental.html`);
    await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
    await expect
      .poll(() =>
        page.evaluate(
          () =>
            [...document.images].every(({ complete, naturalWidth }) => complete && naturalWidth > 0) &&
            document.images.length,
        ),
      )
      .toBeGreaterThan(0);
    await page.goto(`${site.address}rules/zh/`);
    await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  });
  await test.step('pages of the manual, with their elements', async () => {
    await page.goto(`${site.address}manual/ru/axes.html`);
    await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
    await expect(drawing(page)).toBeVisible();
  });
  await test.step('reference', async () => {
    await page.goto(`${site.address}docs/limits.html`);
    await expect(page.getByRole('heading', { name: 'Limits', level: 1 })).toBeVisible();
  });
});

test('a newer version is announced, and is loaded on request', async ({ page }) => {
  const site = await storedSite();
  await visitAndStore(page, site);
  site.publish(nextBuild());
  // The tab of the first visit keeps its version, and so does the next one, which finds the newer version.
  await page.reload();
  await expect.poll(() => news(page).count(), { timeout: 60_000 }).toBe(1);
  expect(await page.evaluate(() => document.querySelector('meta[name=build]'))).toBe(null);
  await type(page, 'G00 X50 Z2\nG01 X40 Z-20 F0.2\nM30\n');
  await expect(status(page)).toContainText('2 motions');
  await chooseExample(page, G71);
  await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
  expect(await value(page)).not.toContain('NEXT');
  await type(page, 'G00 X50 Z2\nG01 X40 Z-30 F0.2\nM30\n');

  await page.getByRole('button', { name: 'Reload', exact: true }).click();
  await expect
    .poll(
      () =>
        page.evaluate(() => document.querySelector('meta[name=build]')?.getAttribute('content') ?? '').catch(() => ''),
      { timeout: 30_000 },
    )
    .toBe('next');
  await expect(status(page)).toContainText('2 motions');
  expect(await value(page)).toContain('X40 Z-30');
  await expect(news(page)).toHaveCount(0);
  await site.stop();
  await chooseExample(page, G71);
  await expect.poll(() => value(page)).toContain('NEXT');
  await page.reload();
  await expect(status(page)).toContainText(/\d+ motions/);
});

test('a page that is not stored reports what is missing, and retries', async ({ page }) => {
  const site = await storedSite();
  // The service worker is missing, so nothing is stored.
  site.publish(new Map([['service-worker.js', undefined]]));
  await visit(page, site);
  await openMenu(page, 'more');
  await expect(page.locator('#offline', { hasText: 'Not stored for offline use' })).toBeVisible();
  await page.keyboard.press('Escape');
  await site.stop();
  await chooseFile(page, 'part.nc', Buffer.from('G00 X50 Z2\nG01 X40 Z-25 F0.2\nM30\n'));
  const notice = page.getByRole('alert').filter({ hasText: 'no network connection' });
  await expect(notice).toBeVisible();
  await choose(page, 'program', 'Gallery…');
  await expect(page.getByText('The examples could not be loaded')).toBeVisible();
  await site.start();
  // The gallery opens automatically, unless the user has switched to something else.
  await page.evaluate(() => void dispatchEvent(new Event('online')));
  await page.getByRole('dialog', { name: 'Gallery' }).getByRole('button', { name: 'Close', exact: true }).click();
  // Anything that would replace the text waits for the user.
  const there = page.getByRole('alert').filter({ hasText: 'the missing part is loaded' });
  await expect(there).toBeVisible();
  expect(await value(page)).not.toContain('Z-25');
  await there.getByRole('button', { name: 'Open' }).click();
  await expect.poll(() => value(page)).toContain('Z-25');
  await site.stop();
});

test('a page opened from a disk explains what to do instead', async ({ page }) => {
  await page.goto(`file://${join(DIST, 'index.html')}`);
  for (const text of [
    'From a disk a browser loads no part of this page.',
    '直接从磁盘打开时',
    'С диска браузер эту страницу не загружает.',
  ])
    await expect(page.getByText(text)).toBeVisible();
  await expect(page.getByText('python3 -m http.server 8000 --bind 127.0.0.1').first()).toContainText(`cd "${DIST}/"`);
  await expect(page.getByRole('button')).toHaveCount(0);
});
