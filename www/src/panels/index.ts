// The panels that are loaded first, with which the picture is shown. All others: `further.ts`, or `with-playback.ts`
// and `with-code.ts` in elements that show less.

import { notice } from './notice';
import type { PanelKind } from './panel';
import { pictures } from './pictures';

export const ALWAYS: readonly PanelKind[] = [notice];
export const PICTURES: readonly PanelKind[] = [notice, pictures];
