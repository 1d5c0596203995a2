// The pictures of the setup form: tip directions, and shapes of inserts.
//
// In: the key of a field, its entry. Out: the choices with their pictures, and the entry for a choice. Must not know:
// how a choice is made.

import { makeSvg } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { ViewsState } from '../protocol/protocol';

export type TurretSide = ViewsState['turret'];

export interface PictureChoice {
  /** Its text in an entry: `3`, `C`. */
  readonly value: string;
  readonly name: string;
  /** The text below the picture. */
  readonly caption: string;
  /** Beside the field, which has the value as text, the picture contains no text. */
  readonly draw: (place: 'in-list' | 'beside-field') => SVGElement;
}

/** The choices of a field. */
export interface FieldPictures {
  readonly columns: number;
  /** Row by row, as they are placed. */
  choices(turret: TurretSide, language: Language): readonly PictureChoice[];
  /** The line above the pictures. */
  about(turret: TurretSide, language: Language): string;
  /** The choice that an entry contains; undefined: none of them. */
  choiceOf(entry: string): string | undefined;
  /** The entry with another choice. */
  withChoice(entry: string, value: string): string;
}

/** The pictures of the field with a key such as `tools.T0101.tip`. */
export function picturesOf(key: string): FieldPictures | undefined {
  if (!key.startsWith('tools.')) return undefined;
  return { tip: TIPS, insert: INSERTS }[key.slice(key.lastIndexOf('.') + 1)];
}

// ---- tip directions ---------------------------------------------------------------------------------

type Sign = -1 | 0 | 1;

/** Where the imaginary tip is, seen from the centre of the nose, along X and Z (B-62754EN, 14.4.2). */
const TIP_PLACES: readonly { readonly tip: number; readonly x: Sign; readonly z: Sign }[] = [
  { tip: 2, x: 1, z: -1 },
  { tip: 6, x: 1, z: 0 },
  { tip: 1, x: 1, z: 1 },
  { tip: 7, x: 0, z: -1 },
  { tip: 0, x: 0, z: 0 },
  { tip: 5, x: 0, z: 1 },
  { tip: 3, x: -1, z: -1 },
  { tip: 8, x: -1, z: 0 },
  { tip: 4, x: -1, z: 1 },
];
const TIP_COLUMNS = 3;

const TIPS: FieldPictures = {
  columns: TIP_COLUMNS,
  choices(turret, language) {
    const rows = [0, 1, 2].map((row) => TIP_PLACES.slice(TIP_COLUMNS * row, TIP_COLUMNS * (row + 1)));
    // With the turret in front, X+ points down.
    const places = (turret === 'front' ? rows.reverse() : rows).flat();
    return places.map(({ tip, x, z }) => ({
      value: String(tip),
      name: WORDS[language].tip(numberOf(tip), `${axis('X', x)} ${axis('Z', z)}`.trim()),
      caption: '',
      draw: (place) => drawTip(place === 'in-list' ? numberOf(tip) : undefined, z, turret === 'front' ? x : minus(x)),
    }));
  },
  about: (turret, language) => WORDS[language].tips[turret],
  choiceOf: (entry) => (/^[0-9]$/.test(entry.trim()) ? entry.trim().replace('9', '0') : undefined),
  withChoice: (_, value) => value,
};

/** The centre of the nose has two numbers. */
function numberOf(tip: number): string {
  return tip === 0 ? '0, 9' : String(tip);
}

function axis(name: 'X' | 'Z', sign: Sign): string {
  return sign === 0 ? '' : `${name}${sign > 0 ? '+' : '−'}`;
}

function minus(sign: Sign): Sign {
  return sign === 0 ? 0 : sign > 0 ? -1 : 1;
}

/** Size of a picture, and the radius of the nose in it. */
const [SIZE, NOSE] = [24, 5];
const MIDDLE = SIZE / 2;

/** The nose with the edges beside it; a dot is the imaginary tip, to the right and down from the centre by signs. */
function drawTip(number: string | undefined, right: Sign, down: Sign): SVGElement {
  const edges =
    right === 0 && down === 0
      ? `M${MIDDLE - NOSE} ${MIDDLE}a${NOSE} ${NOSE} 0 1 0 ${2 * NOSE} 0a${NOSE} ${NOSE} 0 1 0 ${-2 * NOSE} 0`
      : right !== 0 && down !== 0
        ? `M${MIDDLE - NOSE} 3V${MIDDLE}a${NOSE} ${NOSE} 0 0 0 ${NOSE} ${NOSE}H21`
        : `M${MIDDLE - NOSE} 3V${MIDDLE}a${NOSE} ${NOSE} 0 0 0 ${2 * NOSE} 0V3`;
  // Drawn for a tip at the lower left, or below.
  const placed =
    right !== 0 && down !== 0
      ? `scale(${-right} ${down})`
      : right !== 0
        ? `rotate(${right > 0 ? -90 : 90})`
        : `scale(1 ${down < 0 ? -1 : 1})`;
  const text = makeSvg('text', {
    x: MIDDLE - 3.5 * right,
    y: MIDDLE - 4 * down + (right === 0 && down === 0 ? -9.5 : 0),
    'text-anchor': 'middle',
    'dominant-baseline': 'central',
  });
  text.textContent = number ?? '';
  return drawing(
    makeSvg('path', {
      class: 'body',
      d: edges,
      transform: `translate(${MIDDLE} ${MIDDLE}) ${placed} translate(${-MIDDLE} ${-MIDDLE})`,
    }),
    ...(number === undefined ? [] : [text]),
    makeSvg('circle', { class: 'tip-dot', cx: MIDDLE + NOSE * right, cy: MIDDLE + NOSE * down, r: 1.9 }),
  );
}

// ---- inserts ----------------------------------------------------------------------------------------

/** Shapes of ISO 1832 that the interpreter knows, with the angle between two edges, degrees. */
const SHAPES: readonly { readonly shape: string; readonly angle: number | undefined }[] = [
  { shape: 'C', angle: 80 },
  { shape: 'D', angle: 55 },
  { shape: 'V', angle: 35 },
  { shape: 'W', angle: 80 },
  { shape: 'T', angle: 60 },
  { shape: 'S', angle: 90 },
  { shape: 'K', angle: 55 },
  { shape: 'R', angle: undefined },
];

const INSERTS: FieldPictures = {
  columns: 4,
  choices: (_, language) =>
    SHAPES.map(({ shape, angle }) => ({
      value: shape,
      name: angle === undefined ? `${shape}, ${WORDS[language].round}` : `${shape}, ${angle}°`,
      caption: angle === undefined ? shape : `${shape} ${angle}°`,
      draw: () => drawInsert(shape, angle),
    })),
  about: (_, language) => WORDS[language].inserts,
  choiceOf(entry) {
    const letter = entry.trim().charAt(0).toUpperCase();
    return SHAPES.some(({ shape }) => shape === letter) ? letter : undefined;
  },
  // The rest of a designation, such as `NMG120408`, is kept.
  withChoice: (entry, value) => value + entry.trim().slice(1),
};

/** Length of the edges of a parallelogram (K) along its base, for a side of 1. */
const K_BASE = 1.7;

/** The corners of a shape, in any size. */
function cornersOf(shape: string, angle: number): readonly (readonly [number, number])[] {
  const polar = (degrees: number, radius: number): readonly [number, number] => {
    const radians = (degrees * Math.PI) / 180;
    return [radius * Math.cos(radians), -radius * Math.sin(radians)];
  };
  if (shape === 'T') return [90, 210, 330].map((degrees) => polar(degrees, 1));
  if (shape === 'W') {
    // A corner of 80° and its neighbours: the law of sines gives the distance of the blunt corners.
    const blunt = Math.sin((40 * Math.PI) / 180) / Math.sin((80 * Math.PI) / 180);
    return [90, 150, 210, 270, 330, 390].map((degrees, at) => polar(degrees, at % 2 === 0 ? 1 : blunt));
  }
  const base = shape === 'K' ? K_BASE : 1;
  const [dx, dy] = polar(angle, 1);
  return [
    [0, 0],
    [base, 0],
    [base + dx, dy],
    [dx, dy],
  ];
}

function drawInsert(shape: string, angle: number | undefined): SVGElement {
  if (angle === undefined) return drawing(makeSvg('circle', { class: 'body', cx: MIDDLE, cy: MIDDLE, r: 8 }));
  const corners = cornersOf(shape, angle);
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min((SIZE - 4) / (right - left), 16 / (bottom - top));
  const points = corners.map(([x, y]) =>
    [MIDDLE + scale * (x - (left + right) / 2), MIDDLE + scale * (y - (top + bottom) / 2)]
      .map((value) => value.toFixed(1))
      .join(),
  );
  return drawing(makeSvg('polygon', { class: 'body', points: points.join(' ') }));
}

function drawing(...shapes: SVGElement[]): SVGElement {
  const svg = makeSvg('svg', { viewBox: `0 0 ${SIZE} ${SIZE}`, class: 'setup-picture', 'aria-hidden': 'true' });
  svg.append(...shapes);
  return svg;
}

const WORDS = words({
  en: {
    tip: (tip: string, place: string) => (place === '' ? `${tip}, centre of the nose` : `${tip}, ${place}`),
    tips: {
      rear: 'The dot is the imaginary tip. X+ is up, Z+ to the right.',
      front: 'The dot is the imaginary tip. X+ is down, Z+ to the right.',
    },
    round: 'round',
    inserts: 'Shape and point angle of the insert',
  },
  zh: {
    tip: (tip, place) => (place === '' ? `${tip}，刀尖圆弧中心` : `${tip}，${place}`),
    tips: { rear: '圆点为假想刀尖。X+ 向上，Z+ 向右。', front: '圆点为假想刀尖。X+ 向下，Z+ 向右。' },
    round: '圆形',
    inserts: '刀片形状与刀尖角',
  },
  ru: {
    tip: (tip, place) => (place === '' ? `${tip}, центр закругления` : `${tip}, ${place}`),
    tips: {
      rear: 'Точка — воображаемая вершина. X+ вверх, Z+ вправо.',
      front: 'Точка — воображаемая вершина. X+ вниз, Z+ вправо.',
    },
    round: 'круглая',
    inserts: 'Форма пластины и угол при вершине',
  },
});
