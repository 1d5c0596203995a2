// The encodings of program files.
//
// Out: the list. It is separate from the code that encodes, which the first picture does not need.

/**
 * Each name says whether the file has a byte order mark, so that saving keeps it: UTF-16 has one unless the name says
 * `no-bom`.
 */
export const ENCODINGS = [
  'utf-8',
  'utf-8-bom',
  'utf-16le',
  'utf-16be',
  'utf-16le-no-bom',
  'utf-16be-no-bom',
  'gb18030',
  'windows-1251',
  'windows-1252',
] as const;
export type Encoding = (typeof ENCODINGS)[number];
