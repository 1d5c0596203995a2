// The list of the panels that are there from the start: the picture is shown with these alone. All others:
// `further.ts`.

import { notice } from './notice';
import type { PanelKind } from './panel';
import { pictures } from './pictures';

export const FIRST: readonly PanelKind[] = [notice, pictures];
