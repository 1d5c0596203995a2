// The pages of the manual that explain the codes of G-code system A (`www/manual`, directive `codes`).
// `tests/manual_pages.rs` compares the list with the pages.

const CODES_OF_PAGES: Readonly<Record<string, string>> = {
  controls: 'G20 G21',
  'g12-1': 'G12.1 G112 G13.1 G113',
  'g7-1': 'G07.1 G107',
  'g71-g72': 'G70 G71 G72',
  g73: 'G73',
  'g74-g75': 'G74 G75',
  g76: 'G76',
  g90: 'G90',
  g94: 'G94',
  holes: 'G80 G81 G82 G83 G85 G86 G87 G88 G89',
  'lines-and-arcs': 'G00 G01 G02 G03 G04',
  'm-codes':
    'M00 M01 M02 M30 M03 M04 M05 M06 M07 M08 M09 M10 M11 M68 M69 M13 M14 M19 M20 M23 M24 M25 M26 M40 M41 M42 M43 M44 M45 M46 M90 M91 M200 M201 M712 M713',
  macros: 'G65 G66 G67',
  'nose-radius': 'G40 G41 G42',
  offsets: 'G10 G11 G27 G28 G29 G30 G52 G53 G54 G55 G56 G57 G58 G59 G54.1',
  planes: 'G17 G18 G19',
  speeds: 'G50 G96 G97 G98 G99',
  subprograms: 'M98 M97 M198 M99',
  tapping: 'G84 M29',
  threads: 'G32 G34 G92',
};

const PAGE_OF_CODE: ReadonlyMap<string, string> = new Map(
  Object.entries(CODES_OF_PAGES).flatMap(([page, codes]) => codes.split(' ').map((code) => [code, page])),
);

/** The page of a code with the anchor of its row, such as `g71-g72.html#g72`. */
export function manualPageOf(code: string): string | undefined {
  const page = PAGE_OF_CODE.get(code);
  return page === undefined ? undefined : `${page}.html#${code.toLowerCase().replace('.', '-')}`;
}
