// Parses the table of motions that the element exports.
//
// In: the table as CSV. Out: a row for each motion, with cells by column name. Must not know: the use of the table.

/** In UTF-16 units; for a longer program the table is too expensive. */
export const MAX_LENGTH_FOR_TABLE = 200_000;

export type MotionRow = Readonly<Record<string, string>>;

/** Parses the rows. No cell contains a comma or a line end. */
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
