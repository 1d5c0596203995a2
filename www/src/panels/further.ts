// The panels around the picture. In each region they come in this order, before the panels of `index.ts`. Loaded only
// if they are shown, in parallel with the interpreter.

import { atCursor } from './at-cursor';
import { calculator } from './calculator';
import { codes } from './codes';
import { convert } from './convert';
import { exercise } from './exercise';
import { exports } from './exports';
import { fileBar } from './file-bar';
import { header } from './header';
import { help } from './help';
import { hints } from './hints';
import { keys } from './keys';
import { labels } from './labels';
import type { PanelKind } from './panel';
import { motions } from './motions';
import { navigation } from './navigation';
import { paste } from './paste';
import { playback } from './playback';
import { readAs } from './read-as';
import { problems } from './problems';
import { profiles } from './profiles';
import { rewrite } from './rewrite';
import { setup } from './setup';
import { solid } from './solid';
import { speedChart } from './speed-chart';
import { statusLine } from './status-line';
import { dimensions } from './dimensions';
import { divider } from './divider';
import { presentation } from './presentation';
import { print } from './print';
import { switches } from './switches';
import { tabs } from './tabs';
import { tidy } from './tidy';
import { totals } from './totals';
import { units } from './units';
import { views } from './views';
import { whatIf } from './what-if';
import { writtenOut } from './written-out';
import dialogStyles from '../dom/dialog.css?inline';
import editorStyles from '../editor/editor.css?inline';

export const FURTHER: readonly PanelKind[] = [
  header,
  tabs,
  divider,
  hints,
  labels,
  speedChart,
  fileBar,
  profiles,
  readAs,
  switches,
  problems,
  atCursor,
  exercise,
  calculator,
  navigation,
  whatIf,
  keys,
  setup,
  views,
  dimensions,
  playback,
  statusLine,
  totals,
  units,
  motions,
  paste,
  solid,
  exports,
  rewrite,
  tidy,
  convert,
  writtenOut,
  help,
  codes,
  presentation,
  print,
];

/** Style sheets of the components that are not panels. */
export const SHARED_STYLES: readonly string[] = [dialogStyles, editorStyles];
