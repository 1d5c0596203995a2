// A link as a QR code: the smallest that holds it, with the errors it can have that paper and screens make.
//
// In: an address. Out: a drawing of it, or how much one holds. Loaded when somebody asks for one. Must not know: what the
// address means.

import { correction, generate } from 'lean-qr';

/** Bytes in the largest code at level M, of which 15 % may be lost. */
export const QR_LIMIT = 2331;
const SVG = 'http://www.w3.org/2000/svg';
/** Light modules around it, as readers need them. */
const MARGIN = 4;

/** Nothing where it does not fit. */
export function qrCode(address: string): SVGSVGElement | undefined {
  if (address.length > QR_LIMIT) return undefined;
  const code = generate(address, { minCorrectionLevel: correction.M });
  const size = code.size + 2 * MARGIN;
  let path = '';
  for (let y = 0; y < code.size; y++)
    for (let x = 0; x < code.size; x++) if (code.get(x, y)) path += `M${x + MARGIN} ${y + MARGIN}h1v1h-1z`;
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', `0 0 ${size} ${size}`);
  const add = (tag: string, attributes: Readonly<Record<string, string>>): void => {
    const part = svg.appendChild(document.createElementNS(SVG, tag));
    for (const [name, value] of Object.entries(attributes)) part.setAttribute(name, value);
  };
  // Dark on light in both themes: many readers know no other.
  add('rect', { width: String(size), height: String(size), fill: '#fff' });
  add('path', { d: path, fill: '#000', 'shape-rendering': 'crispEdges' });
  return svg;
}
