// The dimensions of an edge of the part in words.
//
// In: numbers from the interpreter. Out: one line of text. Must not know: where it is shown.

import type { Strings } from '../dom/i18n';
import type { Dimension } from '../protocol/protocol';

/** A length, mm, or an angle as it is shown: three decimals at most, a true minus. */
export function shown(value: number): string {
  return String(Math.round(value * 1000) / 1000 || 0).replace('-', '−');
}

export function dimensionText({ views: words }: Strings, edge: Dimension): string {
  const [x0, x1] = edge.x.map(shown) as [string, string];
  const z = shown(edge.z[0]);
  const length = shown(edge.length);
  switch (edge.kind) {
    case 'cylinder':
      return words.cylinder(x0, length);
    case 'face':
      return words.faceEdge(z, x0, x1);
    case 'taper': {
      const ratio = edge.ratio === undefined ? '' : words.ratio(shown(edge.ratio));
      return words.taper(x0, x1, length, shown(edge.angle ?? 0)) + ratio;
    }
    case 'arc':
      return words.arc(shown(edge.radius ?? 0));
    case 'thread':
      return words.threadEdge(shown(edge.lead ?? 0), x1, x0);
  }
}
