// The notices about a program that is loaded from an address.
//
// In: the state of the load. Out: a notice, and its text for the page. Must not know: how a program is loaded.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { PanelSet } from './panel-set';

export function showSlowLoad(panels: PanelSet, language: Language, address: string): void {
  panels.service('notice')(WORDS[language].programLoading(address), 'source');
}

/** Returns the text of the notice. */
export function showFailedLoad(
  panels: PanelSet,
  language: Language,
  { address, reason, retry }: { readonly address: string; readonly reason: string; readonly retry: () => void },
): string {
  const { programFailed, tryAgain } = WORDS[language];
  const text = programFailed(address, reason);
  panels.service('notice')(text, 'source', { title: tryAgain, act: retry });
  return text;
}

const WORDS = words({
  en: {
    programLoading: (address: string) => `The program is being loaded: ${address}`,
    programFailed: (address: string, reason: string) => `The program could not be loaded from ${address} (${reason}).`,
    tryAgain: 'Try again',
  },
  zh: {
    programLoading: (address) => `正在加载程序：${address}`,
    programFailed: (address, reason) => `无法从 ${address} 加载程序（${reason}）。`,
    tryAgain: '重试',
  },
  ru: {
    programLoading: (address) => `Программа загружается: ${address}`,
    programFailed: (address, reason) => `Не удалось загрузить программу ${address} (${reason}).`,
    tryAgain: 'Повторить',
  },
});
