// Small figures of the cycles: the part under the path of the tool, seen like a drawing, with the chuck on the left.
//
// In: the code of a cycle in FANUC's system A. Out: a figure, which its button describes. Must not know: the codes of
// other systems.

/** Paths in a box of 96 × 56; the centre line is at 50. */
interface Figure {
  /** The blank, unless it is the usual bar. */
  readonly blank?: string;
  /** The finished part. */
  readonly part: string;
  readonly rapid: string;
  readonly feed?: string;
  /** Threads and their passes. */
  readonly thread?: string;
}

/** The blank: a bar with its face at 70. */
const BLANK = 'M6 50V16H70V50z';
const AXIS = 'M2 50H94';
const SHOULDER = 'M26 50V28H70V50z';
const CONTOUR = 'M6 50V16H22L34 28H48V38H70V50z';

/** A small tip after each peck. */
const left = (x: number, y: number): string => `M${x + 3} ${y - 2}l-3 2 3 2`;
const down = (x: number, y: number): string => `M${x - 2} ${y - 3}l2 3 2-3`;

/** A shoulder with a thread of 8 turns before it. */
const THREADED = `M6 50V16H26V28H30${'l2.5 6 2.5-6'.repeat(8)}V50z`;

const FIGURES: Readonly<Record<string, Figure>> = {
  G71: {
    part: CONTOUR,
    rapid: 'M84 9V21M27 21l4-4H84M84 26M32 26l4-4H84M84 31M48 31l4-4H84M48 36l4-4H84M84 9V36',
    feed: 'M84 21H27M84 26H32M84 31H48M84 36H48',
  },
  G72: {
    part: CONTOUR,
    rapid: 'M84 9H28M64 38l4-4V9M56 38l4-4V9M48 28l4-4V9M40 28l4-4V9M32 26l4-4V9',
    feed: 'M64 9V38M56 9V38M48 9V28M40 9V28M32 9V26',
  },
  G73: {
    part: CONTOUR,
    rapid: 'M34 6L86 28M28 11L82 33',
    feed: 'M86 28H58V18H46L34 6M82 33H53V23H40L28 11M78 38H48V28H34L22 16',
  },
  G74: {
    part: 'M6 50V16H70V26H40V44H70V50z',
    rapid: 'M84 30H70M84 40V30M40 40l4-3H84',
    feed: `M84 40H40M70 30H40${left(60, 40)}${left(50, 40)}${left(40, 40)}${left(60, 30)}${left(50, 30)}${left(40, 30)}`,
  },
  G75: {
    part: 'M6 50V16H34V38H52V16H70V50z',
    rapid: 'M84 9H38M38 38l3-4V9',
    feed: `M48 9V38M38 9V38${down(48, 20)}${down(48, 29)}${down(48, 38)}${down(38, 20)}${down(38, 29)}${down(38, 38)}`,
  },
  G76: {
    blank: SHOULDER,
    part: THREADED,
    rapid: 'M84 12V34M28 12H84',
    thread: 'M84 30H37L28 12M84 32H38L28 12M84 34H39L28 12',
  },
  G83: {
    part: 'M6 50V16H70V42H34L29 50z',
    rapid: 'M29 46H84',
    feed: `M84 50H29${left(57, 50)}${left(43, 50)}${left(29, 50)}`,
  },
  G90: { part: 'M6 50V16H30V28H70V50z', rapid: 'M84 9V28M30 9H84', feed: 'M84 28H30V9' },
  G92: { blank: SHOULDER, part: THREADED, rapid: 'M84 12V34M28 12H84', thread: 'M84 34H39L28 12' },
  G94: { part: 'M6 50V16H52V38H70V50z', rapid: 'M86 9H52M86 38V9', feed: 'M52 9V38H86' },
};

export function cycleFigure(code: string): SVGElement | undefined {
  const figure = FIGURES[code];
  if (figure === undefined) return undefined;
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 96 56');
  svg.setAttribute('aria-hidden', 'true');
  for (const [name, d] of Object.entries({ blank: BLANK, axis: AXIS, ...figure })) {
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('class', name);
    path.setAttribute('d', d);
    svg.append(path);
  }
  return svg;
}
