// Makes the QR code of a link: the smallest one of error correction level M that contains it.
//
// In: an address. Out: a drawing of the code, and the maximum length. Loaded on demand. Must not know: the meaning of
// the address.

import { correction, generate } from 'lean-qr';

/** Bytes in the largest code at level M, which tolerates a loss of 15 %. */
export const QR_LIMIT = 2331;
const SVG = 'http://www.w3.org/2000/svg';
/** The quiet zone around the code, in modules. */
const MARGIN = 4;

/** The code of `address`; undefined if it does not fit. */
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
  // Dark on light in both themes: many scanners do not recognise inverted codes.
  add('rect', { width: String(size), height: String(size), fill: '#fff' });
  add('path', { d: path, fill: '#000', 'shape-rendering': 'crispEdges' });
  return svg;
}
