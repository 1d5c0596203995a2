// The actions of the page: items of the menus of the element.
//
// In: the table of actions, and the `PageHost` passed to them. Out: their items. The code of an action is loaded on
// first use. Must not know: the actions themselves.

import { menuItem } from '../dom/menu';
import { importWithRetry } from '../dom/network';
import { words, type Words } from '../dom/words';
import { find } from './find';
import type { PageHost } from './page-host';

interface Action {
  readonly id: string;
  readonly menu: 'program' | 'share' | 'more';
  readonly label: Words<string>;
  readonly load: () => Promise<(host: PageHost) => void>;
}

/** In display order. */
const ACTIONS: readonly Action[] = [
  {
    id: 'new',
    menu: 'program',
    label: words({ en: 'New', zh: '新建', ru: 'Новая' }),
    load: async () => (await importWithRetry(() => import('./new-dialog'))).newProgram,
  },
  {
    id: 'gallery',
    menu: 'program',
    label: words({ en: 'Gallery', zh: '全部示例', ru: 'Все примеры' }),
    load: () => Promise.resolve((host) => host.openGallery()),
  },
  {
    id: 'exercises',
    menu: 'program',
    label: words({ en: 'Exercises', zh: '练习', ru: 'Упражнения' }),
    load: async () => (await importWithRetry(() => import('./exercises-dialog'))).openExercises,
  },
  {
    id: 'own-programs',
    menu: 'program',
    label: words({ en: 'My programs', zh: '我的程序', ru: 'Мои программы' }),
    load: async () => (await importWithRetry(() => import('./own-programs-dialog'))).openOwnPrograms,
  },
  {
    id: 'share',
    menu: 'share',
    label: words({ en: 'Link, task, QR code', zh: '链接、任务、二维码', ru: 'Ссылка, задание, QR-код' }),
    load: async () => (await importWithRetry(() => import('./share-dialog'))).share,
  },
  {
    id: 'make-exercise',
    menu: 'share',
    label: words({
      en: 'Exercise that checks the part',
      zh: '检查零件的练习',
      ru: 'Упражнение с проверкой детали',
    }),
    load: async () => (await importWithRetry(() => import('./make-exercise-dialog'))).makeExercise,
  },
  {
    id: 'answers',
    menu: 'share',
    label: words({ en: 'Answers of a class', zh: '全班的答案', ru: 'Ответы группы' }),
    load: async () => (await importWithRetry(() => import('./answers-dialog'))).openAnswers,
  },
  {
    id: 'compare',
    menu: 'more',
    label: words({ en: 'Compare with another version', zh: '与其他版本比较', ru: 'Сравнить с другой версией' }),
    load: async () => (await importWithRetry(() => import('./compare-dialog'))).compare,
  },
  {
    id: 'report',
    menu: 'more',
    label: words({
      en: 'Report a difference to my machine',
      zh: '报告与我的机床不同之处',
      ru: 'Сообщить об отличии от моего станка',
    }),
    load: async () => (await importWithRetry(() => import('./report-dialog'))).report,
  },
];

export class Actions {
  readonly #host: PageHost;
  readonly #items = new Map<Action, HTMLButtonElement>();
  readonly #error = find('action-failed');

  constructor(host: PageHost) {
    this.#host = host;
    for (const action of ACTIONS) {
      const item = menuItem({ id: `action-${action.id}`, 'aria-haspopup': 'dialog' });
      item.addEventListener('click', () => void this.#run(action));
      this.#items.set(action, item);
      find(`${action.menu}-menu`).append(item);
    }
  }

  /** Runs the action, as a click on its item does. */
  run(id: string): void {
    const action = ACTIONS.find((action) => action.id === id);
    if (action !== undefined) void this.#run(action);
  }

  showLanguage(): void {
    for (const [action, item] of this.#items) item.textContent = `${action.label[this.#host.language]}…`;
    this.#error.textContent = '';
  }

  async #run(action: Action): Promise<void> {
    let run: (host: PageHost) => void;
    try {
      run = await action.load();
    } catch {
      this.#error.textContent = WORDS[this.#host.language].notLoaded;
      return;
    }
    this.#error.textContent = '';
    run(this.#host);
  }
}

const WORDS = words({
  en: { notLoaded: 'This could not be loaded. Try again when you are online.' },
  zh: { notLoaded: '加载失败。请在网络恢复后重试。' },
  ru: { notLoaded: 'Не удалось загрузить. Повторите, когда появится сеть.' },
});
