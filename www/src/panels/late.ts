// A panel's part that is loaded when it is first needed, and may not be there: the network is missing, and nothing has been stored.
//
// In: how it is loaded, and what is done with it. Out: that it was done, or a notice that says what is missing. The part is fetched
// as soon as the network returns; then the reader says whether it is still wanted. Must not know: what is in it.

import { loaded, whenOnline } from '../dom/network';
import { words } from '../dom/words';
import type { Shell } from './panel';

/** The newest part that is missing: a later one takes the place of its notice. */
let stopWaiting: (() => void) | undefined;

/** The part, or nothing where it could not be had; `again`: what the reader wanted to do. */
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
