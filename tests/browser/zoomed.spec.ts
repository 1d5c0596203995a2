// A zoomed and panned picture equals a crop of a picture large enough to contain everything: the section with and
// without a compared part, the face and the side. Random parts and views, sent to the worker in a separate session.
import { expect, test, type BasicPage } from './engines';
import { open } from './page';

type Random = () => number;

interface View {
  readonly picture: 'section' | 'face' | 'side';
  readonly factor: number;
  /** The centre of the zoom, as fractions of the picture. */
  readonly at: readonly [number, number];
  /** Device pixels per CSS pixel. */
  readonly ratio: 1 | 2;
}

interface Part {
  readonly text: string;
  /** The part for the comparison. */
  readonly kept?: string;
  readonly views: readonly View[];
}

/** The result for a view. */
interface Seen {
  /** Number of pixels that differ from the crop by more than anti-aliasing. */
  readonly different: number;
  /** Number of colours, to check that the picture is not empty. */
  readonly colours: number;
}

/** Seeded random numbers from 0 to 1 (xorshift). */
function random(seed: number): Random {
  let state = seed >>> 0;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 2 ** 32;
  };
}

/** A contour of tapers, arcs, shoulders and grooves, sometimes with a thread. */
function turned(next: Random): string {
  const number = (from: number, to: number): string => (from + (to - from) * next()).toFixed(2);
  const lines = ['(STOCK D=80 LENGTH=90)', 'T0101', 'G99 G97 S800 M3', 'G00 X82 Z2'];
  let [x, z] = [10 + 20 * next(), 0];
  lines.push(`G00 X${x.toFixed(2)}`, 'G01 Z0 F0.2');
  while (z > -70 && x < 76) {
    const [dx, dz] = [30 * next() * next(), 1 + 14 * next()];
    const kind = next();
    [x, z] = [Math.min(78, kind < 0.2 ? x : x + dx), z - dz];
    const to = `X${x.toFixed(2)} Z${z.toFixed(2)}`;
    const chord = Math.hypot(dx, dz);
    if (kind < 0.6) lines.push(`G01 ${to}`);
    else lines.push(`${kind < 0.8 ? 'G02' : 'G03'} ${to} R${(chord * (0.6 + next())).toFixed(2)}`);
  }
  lines.push('G00 X90', 'Z20', 'T0202', `G00 X84 Z${number(-60, -20)}`, `G01 X${number(5, 40)} F0.1`, 'G00 X84');
  if (next() < 0.5) {
    lines.push('Z20', 'T0303', 'G00 X84 Z4', `G92 X${number(20, 60)} Z-60 F${number(2, 6)}`);
  }
  return [...lines, 'G00 X90 Z50', 'M30', ''].join('\n');
}

/** Holes and a milled polygon in the end face. */
function onFace(next: Random): string {
  const lines = [
    '(STOCK D=60 LENGTH=40)',
    '(TOOL T0303 TYPE=DRILL D=8)',
    '(TOOL T0101 TYPE=ENDMILL CUTTER=6)',
    'M45',
    'T0303',
    'G98 G97 S1000 M13',
  ];
  for (let hole = 0; hole < 6; hole++) {
    lines.push(`G00 X${(10 + 45 * next()).toFixed(1)} Z2 C${(360 * next()).toFixed(1)}`, 'G01 Z-5 F80', 'G00 Z2');
  }
  lines.push('G00 Z20', 'T0101', 'G00 X80 Z-4 C0', 'G12.1', `G42 G01 X${(30 + 20 * next()).toFixed(1)} F100`);
  lines.push(
    `C${(5 + 15 * next()).toFixed(1)}`,
    `X-${(20 + 20 * next()).toFixed(1)}`,
    `C-${(5 + 15 * next()).toFixed(1)}`,
    'X40',
    'C0',
    'G40 X80',
    'G13.1',
  );
  return [...lines, 'G00 X90 Z50', 'M30', ''].join('\n');
}

/** Holes and a slot on the side of the part. */
function onSide(next: Random): string {
  const lines = [
    '(STOCK D=60 LENGTH=80)',
    '(TOOL T0303 TYPE=DRILL D=8)',
    '(TOOL T0101 TYPE=ENDMILL CUTTER=5)',
    'M45',
    'T0303',
    'G97 S1000 M13',
  ];
  for (let hole = 0; hole < 6; hole++) {
    lines.push(`G00 X66 Z-${(5 + 60 * next()).toFixed(1)} C${(360 * next()).toFixed(1)}`, 'G98 G01 X40 F80', 'G00 X66');
  }
  lines.push('G00 X90 Z20', 'T0101', 'G00 X70 Z-20 C0', 'G98 G01 X50 F100', 'G07.1 C30');
  for (let move = 0; move < 6; move++)
    lines.push(`G01 Z-${(5 + 60 * next()).toFixed(1)} C${(360 * next()).toFixed(1)}`);
  return [...lines, 'G07.1 C0', 'G00 X100 Z50', 'M30', ''].join('\n');
}

/** `count` parts with five views each. */
function parts(seed: number, count: number): readonly Part[] {
  const next = random(seed);
  const views = (picture: View['picture']): View[] =>
    Array.from(
      { length: 5 },
      () => ({ picture, factor: 1.3 + 4 * next(), at: [next(), next()], ratio: next() < 0.7 ? 1 : 2 }) as const,
    );
  return Array.from({ length: count }, (_, index): Part => {
    if (index % 8 === 5) return { text: onFace(next), views: views('face') };
    if (index % 8 === 6) return { text: onSide(next), views: views('side') };
    const part = { text: turned(next), views: views('section') };
    return index % 8 === 7 ? { ...part, kept: turned(next) } : part;
  });
}

interface Talk {
  /** Sends commands to the worker, and waits until all pictures are final. */
  say(...what: object[]): Promise<void>;
  /** The latest images of the pictures. */
  readonly images: Map<string, HTMLCanvasElement>;
}

/** Runs before the scripts of the page: stores its worker. */
function keepWorker(): void {
  const listeners = new Set<(message: unknown) => void>();
  Object.assign(window, { listeners });
  window.Worker = class extends Worker {
    constructor(...parameters: ConstructorParameters<typeof Worker>) {
      super(...parameters);
      Object.assign(window, { keptWorker: this });
      // Registered before the listener of the page, which closes images of unknown sessions.
      this.addEventListener('message', ({ data }) => {
        for (const listener of listeners) listener(data);
      });
    }
  };
}

/** Opens a session in the worker of the page. */
function openSession(): void {
  const session = 4711;
  const { keptWorker, listeners } = window as unknown as {
    keptWorker: Worker;
    listeners: Set<(message: unknown) => void>;
  };
  const images: Talk['images'] = new Map();
  let [said, settled] = [0, (): void => undefined];
  const post = (content: object): void => keptWorker.postMessage({ kind: 'to-session', session, content });
  listeners.add((message) => {
    const {
      kind,
      session: of,
      event,
    } = message as {
      kind: string;
      session: number;
      event: { kind: string; received: number; pictures: Record<string, ImageBitmap> };
    };
    if (kind === 'crashed') throw new Error(JSON.stringify(message));
    if (kind !== 'event' || of !== session) return;
    if (event.kind === 'settled' && event.received === said) settled();
    if (event.kind !== 'pictures') return;
    for (const [picture, image] of Object.entries(event.pictures)) {
      const canvas = images.get(picture) ?? document.createElement('canvas');
      [canvas.width, canvas.height] = [image.width, image.height];
      canvas.getContext('2d', { willReadFrequently: true })!.drawImage(image, 0, 0);
      images.set(picture, canvas);
    }
    post({ kind: 'shown', dropped: false });
  });
  const talk: Talk = {
    images,
    say: (...what) =>
      new Promise((done) => {
        said += what.length;
        settled = done;
        what.forEach(post);
      }),
  };
  Object.assign(window, { talk });
}

/**
 * Opaque colours for the part and the path; none for rulers, labels and the centre line, which belong to the picture,
 * not to the part.
 */
const PALETTE = {
  background: '#ffffff',
  grid: '#ebedeb',
  axis: '#00000000',
  text: '#00000000',
  stock: '#f5f3ec',
  stockEdge: '#b9b09a',
  part: '#e4ddc9',
  partEdge: '#857a5e',
  danger: '#c02b2b',
  onlyFirst: '#9c36b5',
  onlySecond: '#0b7285',
  rapid: '#b85c1e',
  feed: '#1565a8',
  thread: '#7a3fae',
  highlight: '#cf1f6b',
  hover: '#b07800',
  tool: '#26323c',
  uncertain: '#8a7a2b',
};

/** Compares the views of a part with their crops. */
async function look({
  part,
  run,
  palette,
}: {
  part: Part;
  run: number;
  palette: typeof PALETTE;
}): Promise<readonly Seen[]> {
  const { talk } = window as unknown as { talk: Talk };
  const [width, height, rulers] = [280, 220, { left: 46, bottom: 26 }];
  const begin = (number: number, text: string): object => ({
    kind: 'run',
    run: number,
    setup: undefined,
    text: { kind: 'text', pieces: [text] },
    tried: [],
    changeSource: 'inserted',
    cursor: undefined,
    framing: 'fit',
  });
  const pictures = [...new Set(part.views.map(({ picture }) => picture))];
  const small = { width, height, pixelRatio: 1 };
  const pixels = (picture: string, fromX: number, fromY: number, ratio: number): Uint8ClampedArray =>
    talk.images
      .get(picture)!
      .getContext('2d')!
      .getImageData(
        ratio * (fromX + rulers.left),
        ratio * fromY,
        ratio * (width - rulers.left),
        ratio * (height - rulers.bottom),
      ).data;

  for (const picture of pictures)
    await talk.say({ kind: 'picture', picture, command: { kind: 'canvas', size: small } });
  await talk.say({ kind: 'palette', palette });
  if (part.kept !== undefined) await talk.say(begin(2 * run, part.kept), { kind: 'keep-part' });
  await talk.say(begin(2 * run + 1, part.text));
  const seen: Seen[] = [];
  for (const {
    picture,
    factor,
    at: [x, y],
    ratio,
  } of part.views) {
    const change = (command: object): object => ({ kind: 'picture', picture, command });
    await talk.say(
      change({ kind: 'resize', size: { ...small, pixelRatio: ratio } }),
      change({ kind: 'fit' }),
      change({ kind: 'zoom', factor, x: x * width, y: y * height }),
    );
    const cut = pixels(picture, 0, 0, ratio);
    // The centre stays in place: the picture grows by the margins on both sides, enough for all that the fitted picture
    // showed.
    const marginX = Math.ceil((factor - 1) * Math.max(x, 1 - x) * width);
    const marginY = Math.ceil((factor - 1) * Math.max(y, 1 - y) * height);
    await talk.say(
      change({ kind: 'resize', size: { width: width + 2 * marginX, height: height + 2 * marginY, pixelRatio: ratio } }),
    );
    const whole = pixels(picture, marginX, marginY, ratio);
    const colours = new Set<number>();
    const across = ratio * (width - rulers.left);
    const near = (pixel: number, other: number): boolean =>
      [0, 1, 2].every((channel) => Math.abs(cut[pixel + channel]! - (whole[other + channel] ?? 999)) <= 32);
    // Anti-aliasing of an edge changes if a line is clipped at another point: a pixel may have the colour of a
    // neighbour.
    const around = [-1, 0, 1].flatMap((down) => [-1, 0, 1].map((right) => 4 * (down * across + right)));
    let different = 0;
    for (let pixel = 0; pixel < cut.length; pixel += 4) {
      colours.add((cut[pixel]! << 16) | (cut[pixel + 1]! << 8) | cut[pixel + 2]!);
      if (!near(pixel, pixel) && !around.some((step) => near(pixel, pixel + step))) different++;
    }
    seen.push({ different, colours: colours.size });
  }
  if (part.kept !== undefined) await talk.say({ kind: 'end-comparison' });
  return seen;
}

async function compare(page: BasicPage, tried: readonly Part[]): Promise<void> {
  await page.addInitScript(keepWorker);
  await open(page);
  await page.evaluate(openSession);
  let withWork = 0;
  for (const [index, part] of tried.entries()) {
    const seen = await page.evaluate(look, { part, run: 1_000_000 + index, palette: PALETTE });
    for (const [view, { different, colours }] of seen.entries()) {
      // The number of edge pixels grows with the pixel ratio.
      const most = 12 * part.views[view]!.ratio;
      expect(different, `part ${index}, view ${JSON.stringify(part.views[view])}:\n${part.text}`).toBeLessThan(most);
      if (colours > 20) withWork++;
    }
  }
  // Most views show more than the background.
  expect(withWork).toBeGreaterThan(tried.length * 3);
}

test('zoomed in, the part keeps its shape', async ({ page }) => {
  await compare(page, parts(20261127, 4));
});

test('zoomed in, forty parts keep their shapes', { tag: '@night' }, async ({ page }) => {
  test.setTimeout(600_000);
  await compare(page, parts(4321, 40));
});
