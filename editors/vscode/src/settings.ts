// The settings of the extension, and the language of its texts.
//
// In: the configuration and the display language of VS Code. Out: typed values. Must not know: who uses them.

import { env, workspace } from 'vscode';

/** The language id of programs. */
export const LANGUAGE = 'gcode';

/** The prefix of the names of all settings. */
export const SECTION = 'gcode-playground';

export interface Settings {
  /** The native program; empty: the one on `PATH`. */
  readonly path: string;
  /** The control; empty: that of the configuration file, or else the default. */
  readonly control: string;
  /** The address of a site that has the playground, without the last slash; empty: none. */
  readonly pages: string;
  /** Whether lenses show times and passes. */
  readonly codeLens: boolean;
  /** The optional hints: `code`, `feed`, `passes`. */
  readonly hints: readonly string[];
}

export function settings(): Settings {
  const configuration = workspace.getConfiguration(SECTION);
  const text = (name: keyof Settings): string => configuration.get<string>(name, '').trim();
  return {
    path: text('path'),
    control: text('control'),
    pages: text('pages').replace(/\/+$/, ''),
    codeLens: configuration.get<boolean>('codeLens', false),
    hints: configuration.get<readonly string[]>('hints', []),
  };
}

/** The language of messages: the display language, or English if there are no messages in it. */
export function language(): 'en' | 'zh' | 'ru' {
  const tag = env.language.toLowerCase();
  if (tag.startsWith('zh')) return 'zh';
  return tag.startsWith('ru') ? 'ru' : 'en';
}
