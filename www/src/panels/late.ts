// Loads a part of a panel on demand. Loading fails if the network is missing and the part is not cached.
//
// In: a function that loads the part. Out: the part, or a notice that it could not be loaded. The part is then loaded
// when the network returns, and the notice offers to continue. Must not know: the contents of the part.

import { loaded, whenOnline } from '../dom/network';
import { words } from '../dom/words';
import type { Shell } from './panel';

/** Stops waiting for the newest missing part: a later one replaces its notice. */
let stopWaiting: (() => void) | undefined;

/** Returns the part, or undefined if it could not be loaded; `again` repeats the user's action. */
export async function late<Part>(
  shell: Shell,
  load: () => Promise<Part>,
  again: () => void,
): Promise<Part | undefined> {
  try {
    const part = await loaded(load);
    shell.service('hideNotice')('late');
    return part;
  } catch {
    missing(shell, load, again);
    return undefined;
  }
}

function missing<Part>(shell: Shell, load: () => Promise<Part>, again: () => void): void {
  const texts = WORDS[shell.language];
  shell.service('notice')(texts.missing, 'late', { title: texts.tryAgain, act: again });
  stopWaiting?.();
  stopWaiting = whenOnline(() => {
    loaded(load).then(
      () => {
        const texts = WORDS[shell.language];
        shell.service('notice')(texts.there, 'late', { title: texts.open, act: again });
      },
      () => missing(shell, load, again),
    );
  });
}

const WORDS = words({
  en: {
    missing: 'This could not be loaded: the network is missing. It is loaded when the network is back.',
    tryAgain: 'Try again',
    there: 'The network is back: what was missing is there now.',
    open: 'Open',
  },
  zh: {
    missing: '无法加载：没有网络。网络恢复后会自动加载。',
    tryAgain: '重试',
    there: '网络已恢复：缺少的部分已加载。',
    open: '打开',
  },
  ru: {
    missing: 'Загрузить не удалось: нет сети. Загрузка повторится, когда сеть появится.',
    tryAgain: 'Повторить',
    there: 'Сеть снова есть: недостающее загружено.',
    open: 'Открыть',
  },
});
