// Offline use: stores the page in the browser once it has settled, and announces a newer version without replacing the
// current one.
//
// In: the state of the service worker (`offline/service-worker`); whether the program is saved. Out: the registered
// service worker; the manifest in the user's language; "works offline" in the menu "More"; a bar about a newer version;
// files that the system opens with the installed page. Must not know: which files there are, or how they are stored.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { words } from '../dom/words';
import { TAKE_OVER, type StoreLanguage } from '../offline/messages';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import './offline.css';

/** Minimum interval between checks for a newer version, in a tab that stays open for days. */
const CHECK_EVERY_MS = 3_600_000;

interface OfflineHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** Saves the program for the next visit. */
  save(): 'saved' | 'not-saved';
}

type State = 'unknown' | 'stored' | 'not-stored';
type News = 'none' | 'newer' | 'not-saved';

/** The used part of the File Handling API, which TypeScript's DOM types lack. */
interface LaunchQueue {
  setConsumer(consumer: (launched: { readonly files?: readonly { getFile(): Promise<File> }[] }) => void): void;
}

export class Offline {
  readonly #host: OfflineHost;
  /** An item that only informs. */
  readonly #status = menuItem({ id: 'offline', disabled: true, hidden: true });
  /** Screen readers announce the result, since it arrives later than the page. */
  readonly #announcement = make('p', { className: 'unseen', 'aria-live': 'polite' });
  readonly #text = make('p', { role: 'status' });
  readonly #reloadButton = make('button', { type: 'button', className: 'primary' });
  readonly #laterButton = make('button', { type: 'button', className: 'framed' });
  readonly #news = make('div', { id: 'news', hidden: true }, this.#text, this.#reloadButton, this.#laterButton);
  readonly #manifest = make('link', { rel: 'manifest' });
  #registration: ServiceWorkerRegistration | undefined;
  #state: State = 'unknown';
  #shownNews: News = 'none';
  /** The user has asked for the newer version. */
  #updateRequested = false;
  #lastCheckAt = performance.now();

  constructor(host: OfflineHost) {
    this.#host = host;
    find('more-menu').append(this.#status);
    find('main').before(this.#news, this.#announcement);
    document.head.append(this.#manifest);
    this.#reloadButton.addEventListener('click', () => this.#activateUpdate());
    this.#laterButton.addEventListener('click', () => this.#showNews('none'));
    this.showLanguage();
    this.#openLaunched();
    // Absent on pages served over plain HTTP from another host, and in frames without storage.
    if ('serviceWorker' in navigator) void this.#register(navigator.serviceWorker);
  }

  showLanguage(): void {
    const { language } = this.#host;
    const texts = WORDS[language];
    this.#manifest.href = new URL(`manifest-${language}.webmanifest`, document.baseURI).href;
    this.#reloadButton.textContent = this.#shownNews === 'not-saved' ? texts.reloadAllTheSame : texts.reload;
    this.#laterButton.textContent = texts.later;
    this.#text.textContent = { none: '', newer: texts.newer, 'not-saved': texts.notSaved }[this.#shownNews];
    const text = { unknown: '', stored: texts.stored, 'not-stored': texts.notStored }[this.#state];
    this.#status.hidden = text === '';
    this.#status.textContent = this.#announcement.textContent = text;
    this.#status.dataset['state'] = this.#state;
    this.#status.title = this.#state === 'stored' ? `${text}. ${texts.storedHint}` : text;
    if (this.#state === 'stored') this.#storeLanguage();
  }

  /** Stores the pages of the manual and of the rules in the reader's language. */
  #storeLanguage(): void {
    const message: StoreLanguage = { kind: 'store-language', language: this.#host.language };
    this.#registration?.active?.postMessage(message);
  }

  async #register(container: ServiceWorkerContainer): Promise<void> {
    let { controller } = container;
    container.addEventListener('controllerchange', () => {
      const previous = controller;
      controller = container.controller;
      // Another tab has activated the newer version; this tab continues with its own.
      if (previous !== null && !this.#updateRequested) this.#showNews('newer');
    });
    try {
      this.#registration = await container.register(new URL('service-worker.js', document.baseURI), {
        updateViaCache: 'none',
      });
    } catch {
      this.#showState('not-stored');
      this.#retryWhenOnline(container);
      return;
    }
    const registration = this.#registration;
    registration.addEventListener('updatefound', () => this.#watchState(registration.installing));
    this.#watchState(registration.installing);
    this.#checkStored();
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'visible' && performance.now() - this.#lastCheckAt > CHECK_EVERY_MS)
        this.#checkForUpdate();
    });
    addEventListener('online', () => this.#checkForUpdate());
  }

  #retryWhenOnline(container: ServiceWorkerContainer): void {
    addEventListener('online', () => void this.#register(container), { once: true });
  }

  #checkForUpdate(): void {
    this.#lastCheckAt = performance.now();
    // Ignore a failure: without a network there is no newer version.
    this.#registration?.update().catch(() => undefined);
  }

  #watchState(worker: ServiceWorker | null): void {
    worker?.addEventListener('statechange', () => {
      if (worker.state === 'redundant' && this.#registration?.active === null) this.#showState('not-stored');
      else this.#checkStored();
    });
  }

  #checkStored(): void {
    const active = this.#registration?.active ?? undefined;
    const waiting = this.#registration?.waiting ?? undefined;
    if (active?.state === 'activated') this.#showState('stored');
    if (active !== undefined && waiting !== undefined && this.#shownNews === 'none') this.#showNews('newer');
  }

  #activateUpdate(): void {
    if (this.#host.save() === 'not-saved' && this.#shownNews !== 'not-saved') return this.#showNews('not-saved');
    this.#updateRequested = true;
    const waiting = this.#registration?.waiting ?? undefined;
    if (waiting === undefined) return location.reload();
    waiting.addEventListener('statechange', () => {
      if (waiting.state === 'activated') location.reload();
    });
    waiting.postMessage(TAKE_OVER);
  }

  #showState(state: State): void {
    this.#state = state;
    this.showLanguage();
  }

  #showNews(news: News): void {
    this.#shownNews = news;
    this.#news.hidden = news === 'none';
    this.showLanguage();
  }

  /** Opens files that the system passes to the installed page. */
  #openLaunched(): void {
    const queue = (window as { launchQueue?: LaunchQueue }).launchQueue;
    queue?.setConsumer(({ files = [] }) => {
      const [first] = files;
      if (first !== undefined) void first.getFile().then((file) => this.#host.playground.openFile(file));
    });
  }
}

const WORDS = words({
  en: {
    stored: 'Works offline',
    storedHint: 'The page with all its parts is stored in the browser: it needs no network.',
    notStored: 'Not stored for offline use',
    newer: 'There is a newer version of this page. Your program is kept.',
    notSaved: 'The browser cannot keep this program: save it as a file before you reload.',
    reload: 'Reload',
    reloadAllTheSame: 'Reload all the same',
    later: 'Later',
  },
  zh: {
    stored: '可离线使用',
    storedHint: '页面及其所有部分已保存在浏览器中，无需网络。',
    notStored: '未保存，不能离线使用',
    newer: '本页面有新版本。您的程序会保留。',
    notSaved: '浏览器无法保留此程序：请先保存为文件，再重新加载。',
    reload: '重新加载',
    reloadAllTheSame: '仍要重新加载',
    later: '稍后',
  },
  ru: {
    stored: 'Работает без сети',
    storedHint: 'Страница со всеми частями сохранена в браузере: сеть ей не нужна.',
    notStored: 'Не сохранено для работы без сети',
    newer: 'Есть новая версия страницы. Ваша программа сохранится.',
    notSaved: 'Браузер не может сохранить эту программу: перед обновлением сохраните её в файл.',
    reload: 'Обновить',
    reloadAllTheSame: 'Всё равно обновить',
    later: 'Позже',
  },
});
