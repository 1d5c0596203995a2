// The Content-Security-Policy of every page of the project, and the strictest policy that a page with the element can
// have.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test, expect, type BasicPage } from './engines';
import { pressEveryButton } from './embedded';
import { choose, editor, open, openFile, openProblems, problems, program, settled, type, value } from './page';
import { serve, type Site } from './sites';

const DIST = join(__dirname, '..', '..', 'www', 'dist');
const EMBED = join(DIST, 'embed');
const CORS = { 'access-control-allow-origin': '*' };
/** One block contains the letter O instead of a zero. */
const TEXT =
  'O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X52 Z2 M08\nGO1 X40 Z-20 F0.2\nG00 X200 Z200 M09\nM30';

/** Records violations of the page's policy. */
const collect = (): void => {
  const blocked: string[] = [];
  Object.assign(globalThis, { blocked });
  addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI, sourceFile, lineNumber }) => {
    // Some engines request the icon of a page without one.
    if (!blockedURI.endsWith('/favicon.ico'))
      blocked.push(`${effectiveDirective}: ${blockedURI} (${sourceFile}:${lineNumber})`);
  });
};
const blocked = (page: BasicPage): Promise<readonly string[]> =>
  page.evaluate(() => Reflect.get(globalThis, 'blocked') as string[]);

/** Sources by directive. */
function directives(policy: string): ReadonlyMap<string, readonly string[]> {
  return new Map(
    policy
      .split(';')
      .map((part) => part.trim().split(/\s+/))
      .map(([name = '', ...sources]) => [name, sources]),
  );
}

const hashOf = (text: string): string =>
  `'sha256-${createHash('sha256').update(text.replaceAll('\r\n', '\n')).digest('base64')}'`;

/** Faults in the policy of a page. */
function faultsOf(path: string): readonly string[] {
  const html = readFileSync(path, 'utf8');
  const metas = [...html.matchAll(/<meta http-equiv="Content-Security-Policy" content="([^"]*)"/gi)];
  const policy = directives(metas[0]?.[1] ?? '');
  const scripts = policy.get('script-src') ?? [];
  const styles = policy.get('style-src') ?? [];
  // The frame page restricts its policy to its own host by its inline script; see the test below.
  const isFrame = /embed[/\\](\d[^/\\]*[/\\])?index\.html$/.test(path);
  const isAllowed = isFrame
    ? /^('self'|'wasm-unsafe-eval'|'sha256-.{44}'|https?:)$/
    : /^('self'|'wasm-unsafe-eval'|'sha256-.{44}')$/;
  const faults: readonly (readonly [isFault: boolean, what: string])[] = [
    [metas.length !== 1, 'it has no policy, or several'],
    [/<(script|style|link|img|base)\b/i.test(html.slice(0, metas[0]?.index)), 'something comes before the policy'],
    ...['default-src', 'base-uri', 'form-action'].map(
      (name) => [policy.get(name)?.join(' ') !== "'none'", `${name} is not 'none'`] as const,
    ),
    ...[...policy].map(
      ([name, sources]) =>
        [
          sources.some((source) => /^('unsafe-(inline|eval|hashes)'|'strict-dynamic'|\*)$/.test(source)),
          `${name} is wide`,
        ] as const,
    ),
    ...scripts.map((source) => [!isAllowed.test(source), `script-src has ${source}`] as const),
    ...['object-src', 'frame-src', 'child-src', 'script-src-elem', 'script-src-attr'].map(
      (name) => [policy.has(name), `${name} overrides default-src`] as const,
    ),
    ...[...html.matchAll(/<script\b([^>]*)>(.*?)<\/script>/gs)].map(
      ([, attributes = '', text = '']) =>
        [!/\bsrc=/.test(attributes) && !scripts.includes(hashOf(text)), 'an inline script is blocked'] as const,
    ),
    ...[...html.matchAll(/<style\b[^>]*>(.*?)<\/style>/gs)].map(
      ([, text = '']) => [!styles.includes(hashOf(text)), 'an inline style sheet is blocked'] as const,
    ),
    // In the tags that remain without scripts and styles.
    [
      /<[a-z][^>]*\s(on[a-z]+|style)\s*=[^>]*>/i.test(html.replace(/<(script|style)\b.*?<\/\1>/gs, '')),
      'an inline handler or style is blocked',
    ],
  ];
  return faults.filter(([isFault]) => isFault).map(([, what]) => `${path}: ${what}`);
}

test('every built page has a policy before its content, and the policy allows no inline scripts except its own', () => {
  const pages = readdirSync(DIST, { recursive: true, withFileTypes: true })
    .filter((file) => file.isFile() && file.name.endsWith('.html'))
    .map(({ parentPath, name }) => join(parentPath, name));
  expect([...new Set(pages.map((path) => path.slice(DIST.length + 1).split(/[/\\]/)[0]))].sort()).toEqual([
    'docs',
    'embed',
    'index.html',
    'manual',
    'parts.html',
    'rules',
  ]);
  expect(pages.flatMap(faultsOf)).toEqual([]);
});

const PAGES = {
  'the page': './',
  'the frame': './embed/index.html#view=picture&program=G00%20X50%20Z2',
  'a rule page': './rules/en/number-missing.html',
  'the list of rules': './rules/ru/index.html',
  'a document': './docs/limits.html',
  'a page of the manual': './manual/en/axes.html',
  'a page of the manual of the published element': './embed/manual/ru/cycles.html',
  'a document of the published element': './embed/docs/element.html',
} as const;

for (const [name, address] of Object.entries(PAGES)) {
  test(`the policy blocks nothing of the page, and an injected script does not run: ${name}`, {
    tag: name === 'the page' || name === 'the frame' ? [] : '@one-engine',
  }, async ({ page }) => {
    await page.addInitScript(collect);
    await page.goto(address);
    if ((await page.locator('gcode-playground').count()) > 0) await settled(page);
    await page.waitForTimeout(300);
    expect(
      await page.evaluate(
        () =>
          [...document.images].every(({ naturalWidth }) => naturalWidth > 0) &&
          getComputedStyle(document.body).fontFamily !== '',
      ),
    ).toBe(true);
    expect(await blocked(page)).toEqual([]);
    const ran = await page.evaluate(async () => {
      document.body.insertAdjacentHTML(
        'beforeend',
        '<img src="no/such.png" onerror="window.ran = 1"><a href="javascript:void (window.ran = 2)">a</a><iframe srcdoc="<script>parent.ran = 3</script>"></iframe>',
      );
      document.querySelector<HTMLElement>('a[href^=javascript]')!.click();
      document.body.append(Object.assign(document.createElement('script'), { textContent: 'window.ran = 4' }));
      document.body.append(
        Object.assign(document.createElement('script'), { src: 'data:text/javascript,window.ran = 5' }),
      );
      document.body.append(Object.assign(document.createElement('script'), { src: 'https://evil.example/script.js' }));
      await new Promise((done) => setTimeout(done, 500));
      return Reflect.get(window, 'ran') as unknown;
    });
    expect(ran).toBe(undefined);
    const scripts = (await blocked(page)).filter((one) => /^(script|default)-src/.test(one));
    for (const source of [/: inline/, /: data/, /: https:\/\/evil\.example/])
      expect(
        scripts.some((one) => source.test(one)),
        `${source}: ${scripts.join('\n')}`,
      ).toBe(true);
  });
}

test('all features of the page work under its policy', { tag: '@night' }, async ({ page }) => {
  await page.addInitScript(collect);
  await page.addInitScript(() => {
    window.print = () => Reflect.set(window, 'printed', true);
  });
  await open(page);
  await type(page, TEXT);
  await openProblems(page);
  await problems(page).getByRole('listitem').first().getByRole('button').first().click();
  await openFile(page, 'part.nc', Buffer.from(program('s003-g71')));
  await expect.poll(() => value(page)).toContain('G71');
  await settled(page);
  await test.step('saved and exported', async () => {
    for (const [menu, item] of [
      ['program', 'Save file'],
      ['share', /PNG/],
      ['share', /SVG/],
    ] as const) {
      const saved = page.waitForEvent('download');
      await choose(page, menu, item);
      expect(readFileSync(await (await saved).path()).length).toBeGreaterThan(100);
    }
  });
  await test.step('printed', async () => {
    await editor(page).focus();
    await page.keyboard.press('Control+P');
    await expect.poll(() => page.evaluate(() => Reflect.get(window, 'printed') as unknown)).toBe(true);
    expect(await pictureOnPaper(page)).toBeGreaterThan(100);
  });
  await test.step('shared', async () => {
    await choose(page, 'share', 'Link, task, QR code…');
    for (const [form, image] of [
      ['qr', 'QR code of the link'],
      ['picture', 'Picture'],
    ] as const) {
      await page.getByRole('dialog', { name: /Share/ }).getByRole('combobox').first().selectOption(form);
      await expect(page.getByRole('img', { name: image, exact: true })).toBeVisible();
    }
    await page.keyboard.press('Escape');
  });
  for (const language of ['中文', 'Русский', 'English']) await choose(page, 'more', language);
  // The items that the page adds to the menus; the items of the element are pressed below.
  const pressed = await page.evaluate(async () => {
    const items = document.querySelectorAll<HTMLElement>('gcode-playground > [slot$="-menu"] [role^="menuitem"]');
    for (const item of items) {
      item.click();
      await new Promise((done) => setTimeout(done, 150));
      for (const dialog of document.querySelectorAll<HTMLDialogElement>('dialog[open]')) dialog.close();
    }
    return items.length;
  });
  expect(pressed).toBeGreaterThan(10);
  await pressEveryButton(page);
  expect(await blocked(page)).toEqual([]);
});

/** Width of the drawing in print. */
function pictureOnPaper(page: BasicPage): Promise<number> {
  return page.locator('gcode-playground').evaluate(async (element) => {
    dispatchEvent(new Event('beforeprint'));
    const picture = element.shadowRoot?.querySelector<HTMLImageElement>('img.sheet-drawing');
    await picture?.decode().catch(() => undefined);
    const width = picture?.naturalWidth ?? 0;
    dispatchEvent(new Event('afterprint'));
    return width;
  });
}

/** The policies in the reference: for the same origin, and for another origin. */
function documentedPolicies(): readonly string[] {
  const reference = readFileSync(join(__dirname, '..', '..', 'www', 'docs', 'element.md'), 'utf8');
  return [...reference.matchAll(/^ {4}(default-src .*)$/gm)].map(([, policy = '']) => policy);
}

for (const [at, name] of ['the same origin', 'another origin'].entries()) {
  test(`an element from ${name} is fully functional under the policy in the reference`, { tag: '@night' }, async ({
    page,
  }) => {
    const site = (host: string): Site => ({
      pages: {
        '/index.html': `<!DOCTYPE html><html lang="en"><head><title>A manual</title><script src="${host}/collect.js"></script><script type="module" src="${host}/embed/element.js"></script></head><body><gcode-playground><pre>\n${TEXT}\n</pre></gcode-playground></body></html>`,
        '/collect.js': `(${collect.toString()})()`,
      },
      pageHeaders:
        host === ''
          ? { 'content-security-policy': documentedPolicies()[at] ?? '' }
          : { 'content-security-policy': (documentedPolicies()[at] ?? '').replaceAll('https://host.example', host) },
      filesAt: '/embed/',
      fileHeaders: CORS,
    });
    expect(documentedPolicies().length).toBe(2);
    const host = at === 0 ? undefined : await serve(EMBED, () => site(''));
    const own = await serve(EMBED, () => site(host?.origin ?? ''));
    try {
      await page.goto(`${own.origin}/index.html`);
      await settled(page);
      expect(
        (
          await page
            .locator('gcode-playground')
            .evaluate((element) => (element as HTMLElement & { readonly wholeSetup: string }).wholeSetup)
        ).length,
      ).toBeGreaterThan(0);
      await type(page, TEXT.replace('GO1', 'G01'));
      await settled(page);
      await page.evaluate(() => {
        window.print = () => Reflect.set(window, 'printed', true);
      });
      await editor(page).focus();
      await page.keyboard.press('Control+P');
      await expect.poll(() => page.evaluate(() => Reflect.get(window, 'printed') as unknown)).toBe(true);
      expect(await pictureOnPaper(page)).toBeGreaterThan(100);
      await page
        .locator('gcode-playground')
        .evaluate((element) =>
          (element as HTMLElement & { openFile(file: File): Promise<void> }).openFile(new File(['G00 X1\n'], 'a.nc')),
        );
      await expect.poll(() => value(page)).toBe('G00 X1\n');
      expect(await pressEveryButton(page)).toBeGreaterThan(10);
      expect(await blocked(page)).toEqual([]);
    } finally {
      await own.close();
      await host?.close();
    }
  });
}
