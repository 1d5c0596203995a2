// Loads a part of a panel on demand. Loading fails if the network is missing and the part is not cached.
//
// In: a function that loads the part. Out: the part, or a notice that it could not be loaded. The part is then loaded
// when the network returns, and the notice offers to continue. Must not know: the contents of the part.

import { importWithRetry, whenOnline } from '../dom/network';
import { words } from '../dom/words';
import type { Shell } from './panel';

/** Stops waiting for the newest missing part: a later one replaces its notice. */
let cancelRetry: (() => void) | undefined;

/** Returns the part, or undefined if it could not be loaded; `retry` repeats the user's action. */
export async function loadPart<Part>(
  shell: Shell,
  load: () => Promise<Part>,
  retry: () => void,
): Promise<Part | undefined> {
  try {
    const part = await importWithRetry(load);
    shell.service('hideNotice')('loading');
    return part;
  } catch {
    reportMissing(shell, load, retry);
    return undefined;
  }
}

function reportMissing<Part>(shell: Shell, load: () => Promise<Part>, retry: () => void): void {
  const texts = WORDS[shell.language];
  shell.service('notice')(texts.missing, 'loading', { title: texts.tryAgain, act: retry });
  cancelRetry?.();
  cancelRetry = whenOnline(() => {
    importWithRetry(load).then(
      () => {
        const texts = WORDS[shell.language];
        shell.service('notice')(texts.loaded, 'loading', { title: texts.open, act: retry });
      },
      () => reportMissing(shell, load, retry),
    );
  });
}

const WORDS = words({
  en: {
    missing: 'This could not be loaded: no network connection. Will retry when you are back online.',
    tryAgain: 'Try again',
    loaded: 'You are back online: the missing part is loaded.',
    open: 'Open',
  },
  zh: {
    missing: '无法加载：没有网络。网络恢复后会自动加载。',
    tryAgain: '重试',
    loaded: '网络已恢复：缺少的部分已加载。',
    open: '打开',
  },
  ru: {
    missing: 'Загрузить не удалось: нет сети. Загрузка повторится, когда сеть появится.',
    tryAgain: 'Повторить',
    loaded: 'Сеть снова есть: недостающее загружено.',
    open: 'Открыть',
  },
});
