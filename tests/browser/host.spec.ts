// The host page of an element: its styles, direction and colours, and texts that look like scripts.
import { expect, test, type BasicPage } from './engines';
import { FOREIGN, manual, openHtml, programOf } from './embedded';
import { chip, settled, type Playground } from './page';

const PROGRAM = '#100=#1+5;\nG97 S800 M03\nG00 X52 Z2\nG01 X40 F0.2\nZ-20\nX54\n';

/** Typical global styles of a page for text and buttons. */
const STYLES = `<style>
  html { font-size: 62.5%; }
  body { letter-spacing: 3px; text-transform: uppercase; font: italic 700 small-caps 30px/3 serif; word-spacing: 1em; text-indent: 3em; text-align: right; white-space: pre;
    color: red; text-shadow: 1px 1px red; list-style: square; cursor: help; hyphens: auto; tab-size: 20; word-break: break-all; font-feature-settings: 'smcp'; border-collapse: collapse; }
  button, select, input { all: unset; }
  * { box-sizing: content-box; line-height: 4; letter-spacing: 2px; font-size: 9px; color: blue; }
  p, pre, ul { margin: 40px; padding: 20px; }
</style>`;

interface Looks {
  readonly what: string;
  readonly style: string;
  readonly size: string;
}

/** Computed styles of everything inside an element. */
function looks(page: BasicPage): Promise<Looks[]> {
  return page.evaluate(() => {
    const root = document.querySelector('gcode-playground')!.shadowRoot!;
    const KEYS = [
      'letter-spacing',
      'text-transform',
      'font-style',
      'font-weight',
      'font-size',
      'font-family',
      'font-variant-caps',
      'line-height',
      'word-spacing',
      'text-indent',
      'text-align',
      'white-space',
      'color',
      'text-shadow',
      'list-style-type',
      'cursor',
      'hyphens',
      'tab-size',
      'word-break',
      'font-feature-settings',
      'border-collapse',
      'direction',
    ];
    return [...root.querySelectorAll('*')]
      .filter((element) => !element.matches('style, slot, slot *'))
      .map((element) => {
        const style = getComputedStyle(element);
        const { width, height } = element.getBoundingClientRect();
        return {
          what: `${element.localName}.${element.getAttribute('class') ?? ''}`,
          style: KEYS.map((key) => `${key}: ${style.getPropertyValue(key)}`).join('; '),
          size: `${Math.round(width)} × ${Math.round(height)}`,
        };
      });
  });
}

test('an element takes no more space in the page than its own height', async ({ page }) => {
  await openHtml(
    page,
    manual(
      `<gcode-playground style="--playground-height: 600px"><pre>${PROGRAM}</pre></gcode-playground>`,
      '<style>body { margin: 0; }</style>',
    ),
  );
  await settled(page);
  expect(await page.evaluate(() => document.documentElement.scrollHeight - document.documentElement.clientHeight)).toBe(
    0,
  );
});

for (const view of ['all', 'playback', 'code']) {
  test(`styles of the page neither leak in nor break anything: view="${view}"`, async ({ page }) => {
    const html = `<gcode-playground view="${view}" caption="A caption" style="width: 1000px"><pre>${PROGRAM}G999\n</pre></gcode-playground>`;
    const open = async (head: string): Promise<Looks[]> => {
      await openHtml(page, manual(html, head));
      await settled(page);
      return looks(page);
    };
    const alone = await open('');
    const inside = await open(STYLES);
    expect(alone.length).toBeGreaterThan(40);
    expect(inside.map(({ what }) => what)).toEqual(alone.map(({ what }) => what));
    const others = inside.filter((look, at) => JSON.stringify(look) !== JSON.stringify(alone[at]));
    expect(others.map((look) => [look, alone[inside.indexOf(look)]])).toEqual([]);
  });
}

test('in a right-to-left page, code and drawing are left to right', async ({ page }) => {
  await openHtml(
    page,
    manual(`<gcode-playground caption="מבחן"><pre>${PROGRAM}</pre></gcode-playground>`).replace(
      'lang="en"',
      'lang="he" dir="rtl"',
    ),
  );
  await settled(page);
  const places = await page.evaluate(() => {
    const root = document.querySelector('gcode-playground')!.shadowRoot!;
    const walker = document.createTreeWalker(root.querySelector('.cm-line')!, NodeFilter.SHOW_TEXT);
    const lefts: number[] = [];
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      for (let at = 0; at < node.textContent!.length; at++) {
        const range = document.createRange();
        range.setStart(node, at);
        range.setEnd(node, at + 1);
        lefts.push(range.getBoundingClientRect().left);
      }
    }
    return lefts;
  });
  expect(places).toHaveLength('#100=#1+5;'.length);
  expect(places).toEqual([...places].sort((a, b) => a - b));
  const [right, left] = await page.evaluate(async () => {
    const element = document.querySelector('gcode-playground') as Playground & {
      locate(x: number, z: number): Promise<{ clientX: number }>;
    };
    return [(await element.locate(0, 0)).clientX, (await element.locate(0, -20)).clientX];
  });
  expect(right).toBeGreaterThan(left!);
});

/** Brightness of a corner of the drawing and of the background of the program, 0 to 255. */
function brightness(page: BasicPage): Promise<[number, number]> {
  return page.evaluate(async () => {
    const element = document.querySelector('gcode-playground') as Playground;
    // A colour change of the page takes effect with the next frame.
    await new Promise((done) => setTimeout(done, 200));
    await element.settled;
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const context = Object.assign(document.createElement('canvas'), {
      width: canvas.width,
      height: canvas.height,
    }).getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(canvas.width - 3, 3, 1, 1);
    const ground = getComputedStyle(element.shadowRoot!.querySelector('.frame')!)
      .backgroundColor.match(/[\d.]+/g)!
      .map(Number);
    return [(data[0]! + data[1]! + data[2]!) / 3, (ground[0]! + ground[1]! + ground[2]!) / 3];
  });
}

test('the element uses the colours of the host page, also when they change', async ({ page }) => {
  const html = `<gcode-playground><pre>${PROGRAM}</pre></gcode-playground>`;
  const expectAll = async (range: 'light' | 'dark'): Promise<void> => {
    const all = await brightness(page);
    expect(
      all.every((value) => (range === 'light' ? value > 200 : value < 60)),
      `${range}: ${all.join()}`,
    ).toBe(true);
  };
  await openHtml(page, manual(html, '<style>:root.night { color-scheme: dark; background: black; }</style>'));
  await settled(page);
  await expectAll('light');
  await page.evaluate(() => document.documentElement.classList.add('night'));
  await expectAll('dark');
  // The attribute has priority.
  await page.evaluate(() => document.querySelector('gcode-playground')!.setAttribute('theme', 'light'));
  await expectAll('light');
  await page.evaluate(() => document.querySelector('gcode-playground')!.removeAttribute('theme'));
  await expectAll('dark');
  await page.evaluate(() => document.documentElement.classList.remove('night'));
  await expectAll('light');
});

test('the slot fallback is shown until there is a picture, and without the script', async ({ page }) => {
  const html = `<gcode-playground view="picture"><svg slot="fallback" role="img" aria-label="drawn before" width="100" height="50"></svg><pre slot="fallback">${PROGRAM}</pre><script type="text/x-gcode">${PROGRAM}</script></gcode-playground>`;
  await page.goto(FOREIGN);
  await page.evaluate((html) => void (document.body.innerHTML = html), html);
  const before = page.getByRole('img', { name: 'drawn before' });
  await expect(before).toBeVisible();
  await expect(page.getByText('G97 S800 M03')).toBeVisible();
  // The custom element is defined; the program is not there yet.
  await page.evaluate(async () => {
    const element = document.querySelector('gcode-playground')!;
    element.remove();
    await import(new URL('../../element.js', location.href).href);
    const first = new Promise<boolean>((done) => {
      new ResizeObserver(() => done(document.querySelector('[slot=fallback]')!.checkVisibility())).observe(
        document.querySelector('[slot=fallback]') ?? document.body,
      );
    });
    document.body.append(element);
    Reflect.set(window, 'first', await first);
  });
  expect(await page.evaluate(() => Reflect.get(window, 'first') as boolean)).toBe(true);
  await settled(page);
  await expect(before).toHaveCount(0);
  await expect(page.getByRole('img', { name: /tool path/ })).toBeVisible();
});

const SCRIPTS = [
  '<img src=x onerror="window.ran = 1">',
  '"><script>window.ran = 2</' + 'script>',
  'javascript:window.ran=3',
  '</pre><svg onload="window.ran = 4">',
  '`${window.ran = 5}`',
];

test('texts that look like scripts are not executed anywhere', { tag: '@night' }, async ({ page }) => {
  const quoted = (text: string): string =>
    text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
  const ATTRIBUTES = [
    'src',
    'control',
    'setup',
    'block-skip',
    'program',
    'language',
    'theme',
    'view',
    'controls',
    'step',
    'highlight',
    'lines',
    'fit',
    'turret',
    'caption',
    'speed',
    'height',
    'rows-min',
    'rows-max',
    'split',
    'hints',
  ];
  const elements = ATTRIBUTES.flatMap((name) =>
    SCRIPTS.map(
      (text) =>
        `<gcode-playground ${name}="${quoted(text)}" style="--playground-height: 300px"><pre>G00 X1 (${quoted(text)})\n${quoted(text)}</pre></gcode-playground>`,
    ),
  );
  const marked = SCRIPTS.map(
    (text) =>
      `<pre data-gcode-playground data-caption="${quoted(text)}" data-onload="${quoted(text)}" data-onclick="${quoted(text)}" data-srcdoc="${quoted(text)}">${quoted(text)}</pre>`,
  );
  for (let at = 0; at < elements.length; at += 17) {
    await openHtml(page, manual([...elements.slice(at, at + 17), ...(at === 0 ? marked : [])].join('\n')));
    await page.waitForTimeout(1500);
    for (const element of await page.locator('gcode-playground').all())
      await element.evaluate((element) => element.dispatchEvent(new MouseEvent('click', { bubbles: true })));
    expect(await page.evaluate(() => Reflect.get(window, 'ran') as unknown)).toBe(undefined);
  }
  await openHtml(
    page,
    manual(
      `<gcode-playground><script type="application/json">{"dialect": {"control": "<img src=x onerror='window.ran = 6'>"}}</script><pre>G00 X1</pre></gcode-playground>`,
    ),
  );
  await settled(page);
  await expect(page.getByRole('alert')).toContainText('onerror');
  await page.evaluate(async () => {
    const element = document.querySelector('gcode-playground') as Playground & { openFile(file: File): Promise<void> };
    await element.openFile(
      new File(['G00 X1 (<img src=x onerror="window.ran = 7">)'], '<img src=x onerror="window.ran = 8">.nc'),
    );
  });
  expect(await programOf(page)).toContain('window.ran = 7');
  await page.waitForTimeout(500);
  expect(await page.evaluate(() => Reflect.get(window, 'ran') as unknown)).toBe(undefined);
});

const ran = (page: BasicPage): Promise<unknown> => page.evaluate(() => Reflect.get(window, 'ran') as unknown);

test('stored values and URLs do not execute scripts', { tag: '@night' }, async ({ page }) => {
  for (const script of SCRIPTS) {
    await page.goto(FOREIGN);
    await page.evaluate((script) => {
      const program = {
        text: `G00 X1 (${script})\n${script}`,
        example: script,
        control: script,
        file: { name: script, encoding: script },
        setup: script,
        blockSkip: script,
        program: script,
      };
      const kept = {
        [`gcode-playground:program:${location.pathname.replace(/foreign\/.*/, '')}`]: program,
        'gcode-playground:choices': { language: script, theme: script, hints: script, split: script, textSize: script },
        'gcode-playground:profiles': { machine: { [script]: script }, tools: { [script]: script }, chosen: script },
      };
      for (const [key, value] of Object.entries(kept)) localStorage.setItem(key, JSON.stringify(value));
    }, script);
    await page.goto('./');
    await settled(page);
    expect(await programOf(page)).toContain(script);
    await chip(page).click();
    await page.getByRole('button', { name: 'Choose machine' }).click();
    await page.waitForTimeout(200);
    expect(await ran(page)).toBe(undefined);
    await page.goto(FOREIGN);
    const encoded = encodeURIComponent(script);
    await page.goto(`./#program=${encoded}&setup=${encoded}&language=${encoded}`);
    await settled(page);
    expect(await ran(page)).toBe(undefined);
    const attributes = [
      'src',
      'control',
      'setup',
      'view',
      'language',
      'theme',
      'controls',
      'step',
      'highlight',
      'lines',
      'caption',
      'onload',
      'onclick',
      'style',
      'split',
    ];
    await page.goto(
      `./embed/index.html#${attributes.map((name) => `${name}=${encoded}`).join('&')}&program=G00%20X1%20(${encoded})`,
    );
    await settled(page);
    expect(await programOf(page)).toContain(script);
    expect(await ran(page)).toBe(undefined);
  }
});
