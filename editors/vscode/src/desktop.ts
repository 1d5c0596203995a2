// The entry point where there are programs: VS Code on a computer, and its remote hosts.

import type { ExtensionContext } from 'vscode';
import { start } from './extension';
import { startServer } from './server';

export { deactivate } from './extension';

export function activate(context: ExtensionContext): Promise<void> {
  return start(context, startServer);
}
