// The panels of an element that plays the picture without the program.

import dialogStyles from '../dom/dialog.css?inline';
import type { PanelKind } from './panel';
import { playback } from './playback';
import { print } from './print';

export const FURTHER: readonly PanelKind[] = [playback, print];
export const SHARED_STYLES: readonly string[] = [dialogStyles];
