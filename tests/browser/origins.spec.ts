// The element's files on one host, a manual on another: the snippets in the documents work unchanged, and no other host
// is contacted.
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage } from './engines';
import { pressEveryButton } from './embedded';
import { program } from './page';
import { serve } from './sites';

const FILES = join(__dirname, '..', '..', 'www', 'dist', 'embed');
const ID = 's000-o0002';
const CORS = { 'access-control-allow-origin': '*' };

/** A snippet of a document, unchanged: from a line that starts with `begin` to a line equal to `end`. */
function snippet(document: string, begin: string, end: string): string {
  const lines = readFileSync(join(__dirname, '..', '..', document), 'utf8').split('\n');
  const first = lines.findIndex((line) => line.trim().startsWith(begin));
  const last = lines.findIndex((line, at) => at >= first && line.trim() === end);
  return lines
    .slice(first, last + 1)
    .map((line) => line.slice(4))
    .join('\n');
}

/** Serves the element's files at an origin. */
async function host(page: ChromiumPage, origin: string): Promise<void> {
  const version =
    /version = "([^"]+)"/.exec(readFileSync(join(__dirname, '..', '..', 'Cargo.toml'), 'utf8'))?.[1] ?? '';
  await page.route(`${origin}/**`, async (route) => {
    const path = new URL(route.request().url()).pathname.replace(`/embed/${version}/`, '');
    await route.fulfill({ path: join(FILES, version, path), headers: CORS });
  });
}

test("README's snippet, unchanged, in a page of another origin", async ({ page }) => {
  await host(page, 'https://playground.example');
  const site = await serve(FILES, () => ({
    pages: {
      '/index.html': `<!DOCTYPE html><html lang="en"><head><title>A manual</title></head><body>\n${snippet('README.md', '<script type="module"', '</gcode-playground>')}\n</body></html>`,
    },
  }));
  try {
    await page.goto(`${site.origin}/index.html`);
    const motions = await page.evaluate(async () => {
      const element = document.querySelector('gcode-playground')!;
      return new Promise<number>((resolve) =>
        element.addEventListener('gcode-report', (event) =>
          resolve((event as CustomEvent<{ summary: { motions: number } }>).detail.summary.motions),
        ),
      );
    });
    expect(motions).toBe(10);
  } finally {
    await site.close();
  }
});

test('the frame of the recipe, unchanged, shows its program', async ({ page }) => {
  await host(page, 'https://example.org');
  const site = await serve(FILES, () => ({
    pages: {
      '/index.html': `<!DOCTYPE html><html lang="en"><head><title>A lesson</title></head><body>\n${snippet('www/docs/manuals.md', '<iframe', '</iframe>')}\n</body></html>`,
    },
  }));
  try {
    await page.goto(`${site.origin}/index.html`);
    const element = page.frameLocator('iframe').locator('gcode-playground');
    const [height, value, view] = await element.evaluate(
      async (element: HTMLElement & { value: string; settled: Promise<number> }) => {
        await element.settled;
        return [element.getBoundingClientRect().height, element.value, element.getAttribute('view')];
      },
    );
    expect([height, view]).toEqual([400, 'playback']);
    expect(value).toBe('O0001\nT0101\nG97 S800 M03\nG00 X42 Z2\nG90 X36 Z-20 F0.2\nM30');
    await expect(page.frameLocator('iframe').getByRole('img', { name: /[1-9]\d* motions/ })).toBeVisible();
    await page.evaluate(() => {
      const frame = document.querySelector('iframe')!;
      frame.src = frame.src.replace('X36', 'X38').replace('view=playback', 'view=picture&readonly');
    });
    await expect
      .poll(() => element.evaluate((element: HTMLElement & { value: string }) => element.value))
      .toContain('X38');
    await expect(element).toHaveAttribute('view', 'picture');
  } finally {
    await site.close();
  }
});

test('no user action sends a request to a host other than those of the page and of the element', {
  tag: '@night',
}, async ({ page, context }) => {
  const other = await serve(FILES, () => ({ filesAt: '/embed/', fileHeaders: CORS }));
  const own = await serve(FILES, () => ({
    pages: {
      '/index.html': `<!DOCTYPE html><html lang="en"><head><title>A manual</title><script type="module" src="${other.origin}/embed/element.js"></script></head><body><gcode-playground>${program(ID)}</gcode-playground></body></html>`,
    },
  }));
  const asked = new Set<string>();
  context.on('request', (request) => asked.add(new URL(request.url()).origin));
  try {
    await page.goto(`${own.origin}/index.html`);
    const element = page.locator('gcode-playground');
    await element.evaluate((element: HTMLElement & { settled: Promise<number> }) => element.settled);
    expect(await pressEveryButton(page)).toBeGreaterThan(10);
    for (const language of ['zh', 'ru']) {
      await element.evaluate((element, language) => element.setAttribute('language', language), language);
      await element.evaluate((element: HTMLElement & { value: string; settled: Promise<number> }) => {
        element.value = 'GOO X50 Z2\nG71 U2 R1\nG04';
        return element.settled;
      });
    }
    await page.waitForTimeout(500);
    expect(
      [...asked].filter((origin) => origin !== own.origin && origin !== other.origin && origin !== 'null'),
    ).toEqual([]);
    expect([...asked]).toContain(other.origin);
  } finally {
    await own.close();
    await other.close();
  }
});

test('a host as in the recipe allows all origins, and without that header the frame shows a message', async ({
  page,
}) => {
  const server = snippet('www/docs/manuals.md', 'from http.server', 'test(Handler, port=8000)').replace(
    'port=8000',
    'port=0, bind="127.0.0.1"',
  );
  const python = spawn('python3', ['-u', '-c', server], { cwd: FILES, stdio: ['ignore', 'pipe', 'ignore'] });
  try {
    const output = await new Promise<string>((done) => python.stdout.on('data', (data: Buffer) => done(String(data))));
    const port = /port (\d+)/.exec(output)?.[1] ?? '';
    const frame = (origin: string): string =>
      `<!DOCTYPE html><iframe sandbox="allow-scripts" width="600" height="400" src="${origin}/index.html#view=picture&amp;program=G00%20X50%20Z2"></iframe>`;
    const own = await serve(FILES, (origin) => ({
      pages: { '/with.html': frame(`http://127.0.0.1:${port}`), '/without.html': frame(`${origin}/embed`) },
      filesAt: '/embed/',
    }));
    try {
      await page.goto(`${own.origin}/with.html`);
      await expect(page.frameLocator('iframe').getByRole('img', { name: /motions/ })).toBeVisible();
      await page.goto(`${own.origin}/without.html`);
      await expect(page.frameLocator('iframe').getByText('Access-Control-Allow-Origin')).toBeVisible();
    } finally {
      await own.close();
    }
  } finally {
    python.kill();
  }
});
