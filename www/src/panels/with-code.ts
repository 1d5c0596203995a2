// The panels of an element that shows the program without its picture. The setup has no button there, but applies the
// settings that fix a problem.

import editorStyles from '../editor/editor.css?inline';
import type { PanelKind } from './panel';
import { print } from './print';
import { problems } from './problems';
import { setup } from './setup';

export const FURTHER: readonly PanelKind[] = [problems, setup, print];
export const SHARED_STYLES: readonly string[] = [editorStyles];
