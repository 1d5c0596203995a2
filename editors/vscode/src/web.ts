// The entry point in VS Code for the web, which starts no programs: the library checks.

import type { ExtensionContext } from 'vscode';
import { start } from './extension';

export { deactivate } from './extension';

export function activate(context: ExtensionContext): Promise<void> {
  return start(context);
}
