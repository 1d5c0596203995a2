// The small picture of a program in the list: its strokes, as in the gallery.
//
// In: the element, whose interpreter makes the table of motions. Out: the strokes as SVG paths; `undefined` if nothing
// is cut or the program is too long. Must not know: the use of the picture.

import { smallPictureFromRows, type Row, type SmallPicture } from '../../small-picture';
import type { GcodePlayground } from '../shell/element';
import { MAX_LENGTH_FOR_TABLE, motionRows, type MotionRow } from './motion-table';

export async function makePicture(playground: GcodePlayground): Promise<SmallPicture | undefined> {
  if (playground.length > MAX_LENGTH_FOR_TABLE) return undefined;
  const table = await playground.exported('csv');
  return table === undefined ? undefined : smallPictureFromRows(motionRows(table).map(toRow));
}

function toRow(cells: MotionRow): Row {
  const cell = (name: string): string => cells[name] ?? '';
  const place = (x: string, z: string, c: string): Row['to'] =>
    x === '' ? undefined : { x: Number(x), z: Number(z), ...(c === '' ? {} : { c: Number(c) }) };
  return {
    kind: cell('kind') as NonNullable<Row['kind']>,
    mode: cell('mode'),
    to: place(cell('x'), cell('z'), cell('c')),
    center: place(cell('center_x'), cell('center_z'), cell('center_c')),
    dir: cell('dir') === 'cw' ? 'cw' : 'ccw',
  };
}
