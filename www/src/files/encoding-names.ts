// The names of the encodings.
//
// Out: a table. Must not know: where they are shown.

import type { Encoding } from './encoding-list';

/** Names for the user, the same in every language. */
export const ENCODING_NAMES: Readonly<Record<Encoding, string>> = {
  'utf-8': 'UTF-8',
  'utf-8-bom': 'UTF-8 BOM',
  'utf-16le': 'UTF-16 LE',
  'utf-16be': 'UTF-16 BE',
  'utf-16le-no-bom': 'UTF-16 LE, no BOM',
  'utf-16be-no-bom': 'UTF-16 BE, no BOM',
  gb18030: 'GB18030',
  'windows-1251': 'Windows-1251',
  'windows-1252': 'Windows-1252',
};
