// The list of all panels: in each region they stand in this order.

import { codes } from './codes';
import { exports } from './exports';
import { fileBar } from './file-bar';
import { help } from './help';
import { notice } from './notice';
import type { PanelKind } from './panel';
import { paste } from './paste';
import { pictures } from './pictures';
import { playback } from './playback';
import { problems } from './problems';
import { rewrite } from './rewrite';
import { setup } from './setup';
import { solid } from './solid';
import { statusLine } from './status-line';
import { switches } from './switches';
import { views } from './views';
import { writtenOut } from './written-out';

export const PANELS: readonly PanelKind[] = [
  notice, fileBar, switches, problems, setup, views, playback, pictures, statusLine, paste, solid, exports, rewrite, writtenOut, help, codes,
];
