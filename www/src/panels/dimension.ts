// Formats the dimensions of an edge of the part.
//
// In: numbers from the interpreter. Out: one line of text. Must not know: where it is shown.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Dimension, LengthUnit } from '../protocol/protocol';
import { formatLength, formatShort, toUnit } from './lengths';

export function dimensionText(language: Language, edge: Dimension, unit: LengthUnit): string {
  const texts = WORDS[language];
  const format = (mm: number): string => formatLength(mm, unit);
  const [x0, x1] = edge.x.map(format) as [string, string];
  const z = format(edge.z[0]);
  const length = format(edge.length);
  switch (edge.kind) {
    case 'cylinder':
      return texts.cylinder(x0, length);
    case 'face':
      return texts.faceEdge(z, x0, x1);
    case 'taper': {
      const ratio = edge.ratio === undefined ? '' : texts.ratio(formatShort(edge.ratio, 3));
      return texts.taper(x0, x1, length, formatShort(edge.angle ?? 0, 3)) + ratio;
    }
    case 'arc':
      return texts.arc(format(edge.radius ?? 0));
    case 'thread':
      return texts.threadEdge(format(edge.lead ?? 0), x1, x0);
    case 'across':
      return texts.across(x0, formatShort(toUnit(edge.z[0], unit), unit === 'mm' ? 2 : 3), edge.x[1] > 0 ? x1 : '');
  }
}

const WORDS = words({
  en: {
    cylinder: (diameter: string, length: string) => `Ø${diameter}, length ${length}`,
    faceEdge: (z: string, from: string, to: string) => `Face at Z${z}, Ø${from} to Ø${to}`,
    taper: (from: string, to: string, length: string, angle: string) =>
      `Taper Ø${from} to Ø${to}, length ${length}, ${angle}° to the axis`,
    ratio: (n: string) => `, 1:${n}`,
    arc: (radius: string) => `Radius ${radius}`,
    threadEdge: (lead: string, major: string, minor: string) =>
      `Thread, lead ${lead}, Ø${major} outside, Ø${minor} inside`,
    across: (diameter: string, z: string, bore: string) =>
      `Ø${diameter} at Z${z}${bore === '' ? '' : `, bore Ø${bore}`}`,
  },
  zh: {
    cylinder: (diameter, length) => `Ø${diameter}，长 ${length}`,
    faceEdge: (z, from, to) => `端面 Z${z}，Ø${from} 至 Ø${to}`,
    taper: (from, to, length, angle) => `锥面 Ø${from} 至 Ø${to}，长 ${length}，与轴线夹角 ${angle}°`,
    ratio: (n) => `，锥度 1:${n}`,
    arc: (radius) => `圆弧 R${radius}`,
    threadEdge: (lead, major, minor) => `螺纹，导程 ${lead}，大径 Ø${major}，小径 Ø${minor}`,
    across: (diameter, z, bore) => `Z${z} 处 Ø${diameter}${bore === '' ? '' : `，孔 Ø${bore}`}`,
  },
  ru: {
    cylinder: (diameter, length) => `Ø${diameter}, длина ${length}`,
    faceEdge: (z, from, to) => `Торец Z${z}, от Ø${from} до Ø${to}`,
    taper: (from, to, length, angle) => `Конус от Ø${from} до Ø${to}, длина ${length}, ${angle}° к оси`,
    ratio: (n) => `, 1:${n}`,
    arc: (radius) => `Радиус ${radius}`,
    threadEdge: (lead, major, minor) => `Резьба, ход ${lead}, наружный Ø${major}, внутренний Ø${minor}`,
    across: (diameter, z, bore) => `Ø${diameter} на Z${z}${bore === '' ? '' : `, отверстие Ø${bore}`}`,
  },
});
