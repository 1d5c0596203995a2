// The small picture of a program in the gallery.
//
// In: motions as rows, or as the command line prints them, one JSON object per line; X is a diameter. Out: the strokes
// as SVG paths in a box of `WIDTH` by `HEIGHT` whole units, X+ up. Must not know: how the page draws it.

export const WIDTH = 240;
export const HEIGHT = 144;
const MARGIN = 8;
/** Most strokes; more would not be legible at this size. */
const MAX_STROKES = 160;

interface Place {
  readonly x: number;
  readonly z: number;
  readonly c?: number;
}

export interface Row {
  readonly kind?: 'rapid' | 'feed' | 'thread' | 'arc' | 'dwell';
  readonly to?: Place | undefined;
  readonly center?: Place | undefined;
  readonly dir?: 'cw' | 'ccw';
  readonly mode?: string;
}

/** `d` of paths; `axis`: height of the spindle axis, if it is visible. */
export interface SmallPicture {
  readonly rapid: string;
  readonly cut: string;
  readonly axis?: number;
}

interface Stroke {
  readonly kind: 'rapid' | 'cut';
  /** Right and up, mm. */
  readonly points: readonly (readonly [right: number, up: number])[];
}

export function smallPictureFromJsonLines(jsonLines: string): SmallPicture | undefined {
  return smallPictureFromRows(
    jsonLines
      .split('\n')
      .filter((line) => line !== '')
      .map((line) => JSON.parse(line) as Row),
  );
}

export function smallPictureFromRows(rows: readonly Row[]): SmallPicture | undefined {
  // Messages follow the motions; their `to` is an offset in the text.
  const moves = rows.filter((row) => row.kind !== 'dwell' && typeof row.to === 'object');
  const isFace = moves.some(({ mode }) => mode === 'polar');
  const strokes = (isFace ? faceStrokes(moves) : sectionStrokes(moves)).slice(0, MAX_STROKES);
  const cut = strokes.filter(({ kind }) => kind === 'cut').flatMap(({ points }) => points);
  if (cut.length === 0) return undefined;
  const [rights, ups] = [cut.map(([right]) => right), cut.map(([, up]) => up)];
  const [left, right, low, high] = [Math.min(...rights), Math.max(...rights), Math.min(...ups), Math.max(...ups)];
  const scale = Math.min(
    (WIDTH - 2 * MARGIN) / Math.max(right - left, 1),
    (HEIGHT - 2 * MARGIN) / Math.max(high - low, 1),
  );
  const px = (value: number): number => Math.round(WIDTH / 2 + (value - (left + right) / 2) * scale);
  const py = (value: number): number => Math.round(HEIGHT / 2 - (value - (low + high) / 2) * scale);
  const axis = py(0);
  return {
    rapid: path(strokes, 'rapid', px, py),
    cut: path(strokes, 'cut', px, py),
    ...(axis >= 0 && axis <= HEIGHT && !isFace ? { axis } : {}),
  };
}

function sectionStrokes(rows: readonly Row[]): Stroke[] {
  return rows.slice(1).flatMap((row, previous): Stroke[] => {
    const from = rows[previous]?.to;
    if (from === undefined || row.to === undefined) return [];
    return [
      {
        kind: row.kind === 'rapid' ? 'rapid' : 'cut',
        points: row.kind === 'arc' ? arc(from, row) : [toPoint(from), toPoint(row.to)],
      },
    ];
  });
}

/** The strokes milled on the end face: X to the right, C up. */
function faceStrokes(rows: readonly Row[]): Stroke[] {
  const place = ({ x, c }: Place): readonly [number, number] => [x / 2, c ?? 0];
  return rows.slice(1).flatMap((row, previous): Stroke[] => {
    const from = rows[previous]?.to;
    return row.mode !== 'polar' || from === undefined || row.to === undefined
      ? []
      : [{ kind: 'cut', points: [place(from), place(row.to)] }];
  });
}

function toPoint({ x, z }: Place): readonly [number, number] {
  return [z, x / 2];
}

/** An arc as chords of about ten degrees. */
function arc(from: Place, { to, center, dir }: Row): readonly (readonly [number, number])[] {
  if (to === undefined || center === undefined) return [];
  const [[ax, ay], [bx, by], [mx, my]] = [toPoint(from), toPoint(to), toPoint(center)];
  const radius = Math.hypot(ax - mx, ay - my);
  const start = Math.atan2(ay - my, ax - mx);
  const turn = 2 * Math.PI;
  let sweep = Math.atan2(by - my, bx - mx) - start;
  // With Z+ to the right and X+ up, G02 is clockwise.
  sweep = dir === 'cw' ? -(((-sweep % turn) + turn) % turn) : ((sweep % turn) + turn) % turn;
  const chords = Math.max(Math.ceil(Math.abs(sweep) / 0.18), 1);
  return Array.from({ length: chords + 1 }, (_, i) => {
    const angle = start + (sweep * i) / chords;
    return [mx + radius * Math.cos(angle), my + radius * Math.sin(angle)] as const;
  });
}

/** Leaves out strokes that repeat an earlier one, and strokes far outside the box. */
function path(
  strokes: readonly Stroke[],
  kind: Stroke['kind'],
  px: (value: number) => number,
  py: (value: number) => number,
): string {
  const drawnKeys = new Set<string>();
  let text = '';
  let pen = '';
  for (const stroke of strokes) {
    if (stroke.kind !== kind) continue;
    const points = stroke.points.map(([right, up]) => [px(right), py(up)] as const);
    for (const [i, to] of points.entries()) {
      const from = points[i - 1];
      if (from === undefined || (from[0] === to[0] && from[1] === to[1])) continue;
      if ([from, to].some(([x, y]) => Math.abs(x) > 10 * WIDTH || Math.abs(y) > 10 * HEIGHT)) continue;
      const ends = [from.join(' '), to.join(' ')];
      const key = ends.toSorted().join(' ');
      if (drawnKeys.has(key)) continue;
      drawnKeys.add(key);
      text += `${pen === ends[0] ? 'L' : `M${ends[0]}L`}${ends[1]}`;
      pen = ends[1] ?? '';
    }
  }
  return text;
}
