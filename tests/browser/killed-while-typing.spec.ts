// A tab or the whole browser is killed at a random moment during typing; after the next start at most the last second
// is missing.
//
// PLAYGROUND_KILLS is the number of kills; they alternate between crashing the tab and killing the browser's processes.
// The typed texts and their times are recorded outside of the browser.
import { chromium, type Browser } from '@playwright/test';
import { spawn } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromiumTest as test, type ChromiumPage, expect } from './engines';
import { choose, editor, program, settled, status, value } from './page';

const KILLS = Number(process.env['PLAYGROUND_KILLS'] ?? 8);
/** Longest time whose input may be missing, ms. */
const MOST_MISSING = 1000;

/** Seeded, so that each run uses the same moments. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

interface Running {
  readonly browser: Browser;
  page: ChromiumPage;
  /** Kills all processes immediately. */
  kill(): Promise<void>;
}

/** Starts a browser with a profile that survives it. */
async function start(
  profile: string,
  { executablePath, args }: { readonly executablePath?: string; readonly args?: readonly string[] },
): Promise<Running> {
  const port = join(profile, 'DevToolsActivePort');
  await rm(port, { force: true });
  const options = [
    '--headless=new',
    '--remote-debugging-port=0',
    `--user-data-dir=${profile}`,
    '--lang=en-US',
    '--window-size=1280,800',
    ...(args ?? []),
    'about:blank',
  ];
  const child = spawn(executablePath ?? chromium.executablePath(), options, {
    detached: true,
    stdio: 'ignore',
    env: { ...process.env, LANGUAGE: 'en_US', LANG: 'en_US.UTF-8' },
  });
  const ended = new Promise<void>((done) => child.once('exit', () => done()));
  let listening = '';
  await expect
    .poll(async () => (listening = (await readFile(port, 'utf8').catch(() => '')).split('\n')[0] ?? ''), {
      timeout: 20_000,
    })
    .not.toBe('');
  const browser = await chromium.connectOverCDP(`http://127.0.0.1:${listening}`);
  const [context] = browser.contexts();
  const page = (await context?.newPage()) as ChromiumPage;
  return {
    browser,
    page,
    kill: async () => {
      if (child.pid !== undefined && child.exitCode === null && child.signalCode === null)
        process.kill(-child.pid, 'SIGKILL');
      await ended;
      await browser.close().catch(() => undefined);
    },
  };
}

/** Crashes the tab's process and opens a new tab. */
async function crashTab(running: Running): Promise<void> {
  const { page } = running;
  const session = await page.context().newCDPSession(page);
  const crashed = new Promise<void>((done) => page.once('crash', () => done()));
  // This command never gets a response.
  void session.send('Page.crash').catch(() => undefined);
  await crashed;
  running.page = (await page.context().newPage()) as ChromiumPage;
  await page.close().catch(() => undefined);
}

/**
 * The list can be newer than the text that the page starts with; the page shows the newer text before it fills the
 * dialog.
 */
async function listCompared(page: ChromiumPage): Promise<void> {
  await choose(page, 'program', 'My programs…');
  const dialog = page.getByRole('dialog', { name: 'My programs' });
  await expect(dialog.getByRole('status')).not.toHaveText('');
  await dialog.getByRole('button', { name: 'Close' }).click();
  await settled(page);
}

async function openAt(page: ChromiumPage, address: string): Promise<void> {
  await page.goto(address);
  await expect(status(page).filter({ hasText: /\d motions/ })).not.toContainText('…');
  await settled(page);
}

test('killing a tab or a browser during typing loses at most the last second', { tag: '@night' }, async ({
  baseURL,
  launchOptions,
}) => {
  test.setTimeout(60_000 + KILLS * 25_000);
  const next = random(20261125);
  const lost: number[] = [];
  const profile = await mkdtemp(join(tmpdir(), 'killed-'));
  const address = new URL('./', baseURL).href;
  let running = await start(profile, launchOptions);
  let before = program('s001-o0001');
  try {
    for (let kill = 0; kill < KILLS; kill++) {
      const { page } = running;
      await openAt(page, address);
      await listCompared(page);
      expect(await value(page), `start ${kill}`).toBe(before);
      await editor(page).focus();
      await page.keyboard.press('Control+End');
      // Each typed text contains its index, so that the final text shows how much is missing.
      const typed: { readonly at: number; readonly text: string }[] = [{ at: Date.now(), text: before }];
      const until = Date.now() + 300 + next() * 3000;
      for (let n = 0; Date.now() < until; n++) {
        const letters = n === 0 ? `(${kill}` : ` ${n}`;
        await page.keyboard.insertText(letters);
        typed.push({ at: Date.now(), text: `${typed.at(-1)?.text ?? ''}${letters}` });
        await page.waitForTimeout(next() * 120);
      }
      const killed = Date.now();
      if (kill % 2 === 0) await crashTab(running);
      else {
        // The processes are not asked to exit, so none can write anything more.
        await running.kill();
        running = await start(profile, launchOptions);
      }
      await openAt(running.page, address);
      await listCompared(running.page);
      const there = await value(running.page);
      // There is no other tab, so there is no conflict.
      await expect(running.page.locator('#own-news')).toBeEmpty();
      const missing = typed.findIndex(({ text }) => text === there);
      expect(missing, `after kill ${kill}: what is there was typed once:\n${there.slice(-80)}`).toBeGreaterThanOrEqual(
        0,
      );
      const firstLost = typed[missing + 1];
      lost.push(firstLost === undefined ? 0 : killed - firstLost.at);
      before = there;
    }
  } finally {
    await running.kill();
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  }
  console.log(
    `killed ${KILLS} times: at most ${Math.max(...lost)} ms of typing missing, ${lost.filter((ms) => ms === 0).length} times nothing`,
  );
  expect(Math.max(...lost)).toBeLessThanOrEqual(MOST_MISSING);
});
