// The table of motions that the element exports, taken apart.
//
// In: the table as CSV. Out: a row for each motion, cells by the names of their columns. Must not know: what the
// motions are for.

/** UTF-16 units: the table of a longer program would cost more than it is worth. */
export const LONGEST_FOR_TABLE = 200_000;

export type MotionRow = Readonly<Record<string, string>>;

/** No cell of the table holds a comma or a line end. */
export function motionRows(table: Uint8Array): readonly MotionRow[] {
  const [head = '', ...lines] = new TextDecoder().decode(table).split('\r\n');
  const columns = head.split(',');
  return lines
    .filter((line) => line !== '')
    .map((line) => {
      const cells = line.split(',');
      return Object.fromEntries(columns.map((column, at) => [column, cells[at] ?? '']));
    });
}
