// The actions on a program besides editing: buttons in the header, and a menu for the less frequent ones.
//
// In: the table of actions, and the `PageHost` passed to them. Out: their buttons. The code of an action is loaded on
// first use. Must not know: the actions themselves.

import { icon, make, setAccessibleName, type IconName } from '../dom/dom';
import { importWithRetry } from '../dom/network';
import { words, type Words } from '../dom/words';
import type { PageHost } from './page-host';

interface Action {
  readonly id: string;
  /** In the header, or in its "more" menu. */
  readonly place: 'header' | 'more';
  readonly label: Words<string>;
  /** Replaces the label in a narrow header. */
  readonly icon?: IconName;
  readonly load: () => Promise<(host: PageHost) => void>;
}

/** In display order. */
const ACTIONS: readonly Action[] = [
  {
    id: 'own-programs',
    place: 'header',
    icon: 'folder',
    label: { en: 'My programs', zh: '我的程序', ru: 'Мои программы' },
    load: async () => (await importWithRetry(() => import('./own-programs-dialog'))).openOwnPrograms,
  },
  {
    id: 'share',
    place: 'header',
    icon: 'share',
    label: words({ en: 'Share', zh: '分享', ru: 'Поделиться' }),
    load: async () => (await importWithRetry(() => import('./share-dialog'))).share,
  },
  {
    id: 'compare',
    place: 'more',
    label: words({ en: 'Compare with another version', zh: '与其他版本比较', ru: 'Сравнить с другой версией' }),
    load: async () => (await importWithRetry(() => import('./compare-dialog'))).compare,
  },
  {
    id: 'report',
    place: 'more',
    label: words({ en: 'My machine behaves differently', zh: '我的机床动作不同', ru: 'Мой станок работает иначе' }),
    load: async () => (await importWithRetry(() => import('./report-dialog'))).report,
  },
];

export class Actions {
  readonly #host: PageHost;
  readonly #buttons = new Map<Action, HTMLButtonElement>();
  readonly #more = make(
    'button',
    { type: 'button', id: 'more', 'aria-expanded': 'false', 'aria-controls': 'more-actions' },
    icon('more'),
  );
  readonly #menu = make('div', { id: 'more-actions', hidden: true });
  readonly #error = make('p', { id: 'action-failed', role: 'status' });

  /** Appends the buttons to `into`. */
  constructor(into: HTMLElement, host: PageHost) {
    this.#host = host;
    for (const action of ACTIONS) this.#buttons.set(action, this.#button(action));
    const buttonsAt = (place: Action['place']): HTMLButtonElement[] =>
      ACTIONS.flatMap((action) => (action.place === place ? (this.#buttons.get(action) ?? []) : []));
    into.append(...buttonsAt('header'));
    const menuButtons = buttonsAt('more');
    if (menuButtons.length > 0) {
      this.#menu.append(...menuButtons);
      into.append(make('div', { className: 'more' }, this.#more, this.#menu));
    }
    into.append(this.#error);
    this.#more.addEventListener('click', () => this.#open(this.#menu.hidden ? 'open' : 'closed'));
    into.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || this.#menu.hidden) return;
      this.#open('closed');
      this.#more.focus();
    });
    document.addEventListener('pointerdown', (event) => {
      if (!event.composedPath().includes(this.#menu) && !event.composedPath().includes(this.#more))
        this.#open('closed');
    });
    this.showLanguage();
  }

  /** Runs the action, as a click on its button does. */
  run(id: string): void {
    const action = ACTIONS.find((action) => action.id === id);
    if (action !== undefined) void this.#run(action);
  }

  showLanguage(): void {
    for (const [action, button] of this.#buttons) {
      const label = `${action.label[this.#host.language]}…`;
      if (action.icon === undefined) button.textContent = label;
      else {
        button.title = label;
        button.replaceChildren(icon(action.icon), make('span', { className: 'label' }, label));
      }
    }
    setAccessibleName(this.#more, WORDS[this.#host.language].more);
    this.#error.textContent = '';
  }

  #open(state: 'open' | 'closed'): void {
    this.#menu.hidden = state === 'closed';
    this.#more.setAttribute('aria-expanded', String(state === 'open'));
  }

  #button(action: Action): HTMLButtonElement {
    const button = make('button', { type: 'button', id: `action-${action.id}`, 'aria-haspopup': 'dialog' });
    button.addEventListener('click', () => {
      this.#open('closed');
      void this.#run(action);
    });
    return button;
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
  en: { more: 'More', notLoaded: 'This could not be loaded. Try again when you are online.' },
  zh: { more: '更多', notLoaded: '加载失败。请在网络恢复后重试。' },
  ru: { more: 'Ещё', notLoaded: 'Не удалось загрузить. Повторите, когда появится сеть.' },
});
