// The pages of the manual that explain the codes of G-code system A (`www/manual`, directive `codes`). The list is
// generated: `UPDATE_EXPECT=1 cargo test --test it manual_pages::`.

import codesOfPages from './manual-pages.json';

const PAGE_OF_CODE: ReadonlyMap<string, string> = new Map(
  Object.entries(codesOfPages).flatMap(([page, codes]) => codes.split(' ').map((code) => [code, page])),
);

/** The page of a code with the anchor of its row, such as `g71-g72.html#g72`. */
export function manualPageOf(code: string): string | undefined {
  const page = PAGE_OF_CODE.get(code);
  return page === undefined ? undefined : `${page}.html#${code.toLowerCase().replace('.', '-')}`;
}
