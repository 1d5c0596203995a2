// Actions of the switching test inside the page. Each function is sent to the browser as source, so it uses no outer
// variables, and its argument and result are JSON.

import type { State, Step } from './state';

interface Playground extends HTMLElement {
  value: string;
  setup: string | null;
  origin: string | null;
  readonly settled: Promise<number>;
}

/** The visible state of a page: texts and hashes of pixels. */
export type Look = Readonly<Record<string, string>>;

/** Runs before the scripts of each page: disables storing for the next page, and makes the page report everything. */
export function prepare(): void {
  localStorage.clear();
  // Otherwise the page would store the program when it is left.
  Storage.prototype.setItem = () => undefined;
  document.addEventListener('gcode-report', (event) => {
    (window as unknown as { report: unknown }).report = (event as CustomEvent).detail;
  });
}

/** Waits until the page has started; drivers differ in when they consider it loaded. */
export async function ready(): Promise<void> {
  await customElements.whenDefined('gcode-playground');
  if (document.readyState !== 'complete')
    await new Promise((done) => window.addEventListener('load', done, { once: true }));
  // The element is added with its first program.
  const soon = (): Promise<void> => new Promise((done) => setTimeout(done, 5));
  while (document.querySelector('gcode-playground') === null) await soon();
  await (document.querySelector('gcode-playground') as Playground).settled;
}

/** Changes the page to a state; the last change is one that a user or an author would make last. */
export async function go({
  steps,
  from,
}: {
  steps: readonly (Step & { delay: number })[];
  from: State | undefined;
}): Promise<void> {
  const playground = document.querySelector('gcode-playground') as Playground;
  const root = playground.shadowRoot as ShadowRoot;
  const found = <E extends HTMLElement>(selector: string): E => root.querySelector(selector) as E;
  const sleep = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
  const key = (on: HTMLElement, name: string, held: KeyboardEventInit = {}): void => {
    on.dispatchEvent(
      new KeyboardEvent('keydown', { key: name, code: name, bubbles: true, composed: true, cancelable: true, ...held }),
    );
  };
  /** Chooses a value of the language (row 0) or the theme (row 1) in the menu "More". */
  const choose = <V extends string>(row: 0 | 1, values: readonly V[], value: V): void => {
    const item = document.querySelectorAll('#more-menu > [role=group]')[row]?.children[values.indexOf(value)];
    (item as HTMLButtonElement).click();
  };
  /** Chooses an example in the gallery, like a user. */
  const chooseExample = async (id: string): Promise<void> => {
    const kept = window as unknown as { cards: Promise<readonly string[]> | undefined };
    // The ids of the cards, in their order.
    kept.cards ??= fetch('examples/en.json')
      .then((answer) => answer.json() as Promise<readonly { readonly examples: readonly { readonly id: string }[] }[]>)
      .then((subjects) => subjects.flatMap(({ examples }) => examples.map((example) => example.id)));
    const index = (await kept.cards).indexOf(id);
    (document.getElementById('action-gallery') as HTMLButtonElement).click();
    const cards = (): NodeListOf<HTMLButtonElement> => document.querySelectorAll('dialog[open] .card');
    while (cards().length === 0) await sleep(0);
    (cards()[index] as HTMLButtonElement).click();
  };
  /** Focuses the editor. For 200 ms afterwards, CodeMirror takes a selection at the start for one by the browser. */
  const focus = async (content: HTMLElement): Promise<void> => {
    content.focus();
    await sleep(250);
  };
  let now = from;

  const load = async (state: State): Promise<void> => {
    playground.origin = null;
    await chooseExample(state.program);
    while (playground.origin !== state.program) await sleep(0);
    const [program, setup] = [playground.value, playground.setup];
    const lines = program.split('\n');
    if (state.setup === 'thick blank') {
      playground.setup = JSON.stringify({
        ...JSON.parse(setup ?? '{}'),
        stock: { diameter: 180, length: 220, face: 1 },
      });
    } else if (state.setup === 'empty') playground.setup = '{}';
    const content = found<HTMLElement>('.written .cm-content');
    switch (state.text) {
      case 'as it is':
        break;
      case 'line typed':
        await focus(content);
        key(content, 'Home', { ctrlKey: true });
        key(content, 'Enter');
        break;
      case 'character deleted':
        await focus(content);
        key(content, 'Home', { ctrlKey: true });
        for (let line = 0; line < 3; line++) key(content, 'ArrowDown');
        key(content, 'Delete');
        // Until the cursor leaves the block, the picture before the edit may stay.
        key(content, 'ArrowUp');
        break;
      case 'line doubled': {
        const middle = Math.floor(lines.length / 2);
        playground.value = [...lines.slice(0, middle), lines[middle], ...lines.slice(middle)].join('\n');
        break;
      }
      case 'half':
        playground.value = lines.slice(0, Math.ceil(lines.length / 2)).join('\n');
        break;
    }
  };

  for (const step of steps) {
    if ('to' in step) {
      const to = step.to;
      const same = now !== undefined && to.program === now.program && to.text === now.text && to.setup === now.setup;
      if (!same) await load(to);
      if (to.language !== now?.language) choose(0, ['en', 'zh', 'ru'], to.language);
      if (to.theme !== now?.theme) choose(1, ['auto', 'light', 'dark'], to.theme);
      if (to.turret !== now?.turret) {
        // The item shows the side of the turret, which the setup may define: choose it until the side is correct.
        for (let turn = 0; turn < 3; turn++) {
          await playground.settled;
          const item = found<HTMLButtonElement>('[role=menuitemcheckbox]');
          if ((item.getAttribute('aria-checked') === 'true') === (to.turret === 'front') && turn > 0) break;
          item.click();
        }
      }
      now = to;
    } else {
      const canvas = found<HTMLCanvasElement>('canvas');
      switch (step.detour) {
        case 'zoomed and fitted':
          key(canvas, '+');
          key(canvas, 'ArrowLeft');
          await sleep(step.delay);
          key(canvas, 'Home');
          break;
        case 'stepped':
          key(playground, 'F9');
          await sleep(step.delay);
          key(playground, 'F9', { ctrlKey: true });
          break;
        case 'pointed': {
          const { left, top, width, height } = canvas.getBoundingClientRect();
          for (const share of [0.3, 0.5, 0.6]) {
            canvas.dispatchEvent(
              new PointerEvent('pointermove', {
                pointerType: 'mouse',
                clientX: left + share * width,
                clientY: top + share * height,
                bubbles: true,
                composed: true,
              }),
            );
            await sleep(step.delay / 3);
          }
          canvas.dispatchEvent(new PointerEvent('pointerleave', { pointerType: 'mouse' }));
          break;
        }
        case 'kept': {
          // The item that keeps the part follows that of the turret; it is hidden while two parts are compared.
          const keep = found<HTMLButtonElement>('[role=menuitemcheckbox] + [role=menuitem]');
          if (keep.hidden) break;
          keep.click();
          await sleep(step.delay);
          await playground.settled;
          root.querySelector<HTMLButtonElement>('.views > button.small:not([hidden])')?.click();
          break;
        }
      }
    }
    await sleep(step.delay);
  }
  await playground.settled;
  // The tool may still be at the position of a step.
  const whole = found<HTMLButtonElement>('.over-picture > button');
  if (whole.checkVisibility()) whole.click();
}

/** Waits until the page has settled, and returns its visible state. */
export async function look(): Promise<Look> {
  const playground = document.querySelector('gcode-playground') as Playground;
  const root = playground.shadowRoot as ShadowRoot;
  const late = new Promise<never>((_, reject) => {
    setTimeout(() => reject(new Error('the page has not settled within 30 s')), 30_000);
  });
  await Promise.race([playground.settled, late]);
  // The list of problems is closed until a program with problems is opened: the earlier programs decide it.
  const problems = root.querySelector<HTMLButtonElement>('.problems-toggle');
  if (problems?.disabled === false && problems.getAttribute('aria-expanded') === 'false') problems.click();
  const seen: Record<string, string> = {};
  const words = (selector: string): string =>
    [...root.querySelectorAll<HTMLElement>(selector)].map((part) => (part.hidden ? '' : part.innerText)).join('\n');
  for (const [index, canvas] of [...root.querySelectorAll<HTMLCanvasElement>('.pictures canvas')].entries()) {
    const { width, height } = canvas;
    const shown = canvas.getBoundingClientRect();
    const name = index === 0 ? 'section' : 'face';
    if (shown.width === 0) {
      seen[name] = 'hidden';
      continue;
    }
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [width, height];
    const context = copy.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D;
    context.drawImage(canvas, 0, 0);
    (window as unknown as Record<string, unknown>)[name] = copy;
    const pixels = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
    // FNV-1a, one pixel at a time.
    let hash = 0x811c9dc5;
    for (const pixel of pixels) hash = Math.imul(hash ^ pixel, 0x01000193);
    seen[name] = `${width} × ${height}, shown ${shown.width} × ${shown.height}: ${(hash >>> 0).toString(16)}`;
  }
  const report = (window as unknown as { report: { summary: unknown; diagnostics: unknown } | undefined }).report;
  seen['text'] = playground.value;
  seen['summary'] = JSON.stringify(report?.summary);
  seen['messages'] = JSON.stringify(report?.diagnostics);
  seen['problems'] = words('[part=problems]');
  seen['status'] = words('[part=status]');
  seen['read-out'] = words('[part=readout]');
  const turret = root.querySelector('[role=menuitemcheckbox]');
  seen['views'] = `${turret?.textContent} ${turret?.getAttribute('aria-checked')}`;
  seen['legend'] = words('[part=legend]');
  seen['setup'] = words('[part=setup]');
  // The motions in the page's own export.
  const save = HTMLAnchorElement.prototype.click;
  const { createObjectURL } = URL;
  const table = root.querySelectorAll<HTMLButtonElement>('.share-menu [role=menuitem]')[3];
  if (table?.disabled === false) {
    const saved = new Promise<Blob>((resolve) => {
      URL.createObjectURL = (blob) => {
        resolve(blob as Blob);
        return 'about:blank';
      };
      HTMLAnchorElement.prototype.click = () => undefined;
    });
    table.click();
    seen['motions'] = await (await Promise.race([saved, late])).text();
    HTMLAnchorElement.prototype.click = save;
    URL.createObjectURL = createObjectURL;
  }
  return seen;
}

/** The last section that was read, as PNG. */
export function picture(): string {
  return (window as unknown as { section: HTMLCanvasElement | undefined }).section?.toDataURL('image/png') ?? '';
}
