// The panels that are there from the start: the picture is shown with these alone. All others: `further.ts`, or
// `with-playback.ts` and `with-code.ts` where less is shown.

import { notice } from './notice';
import type { PanelKind } from './panel';
import { pictures } from './pictures';

export const ALWAYS: readonly PanelKind[] = [notice];
export const PICTURES: readonly PanelKind[] = [notice, pictures];
