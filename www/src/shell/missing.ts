// One notice with "Try again" for everything that could not be loaded or has failed; it stays until all of it works.
//
// In: the missing parts, the errors, and functions that load them again. Out: the notice, in words; each failure, for the
// page. All missing parts are loaded again when the user clicks the button or edits the program, and when the network
// returns. Each has one attempt at a time; an edit starts one no sooner than `MIN_RETRY_DELAY_MS` after the last failure.
// Must not know: how a part is loaded.

import type { Language } from '../dom/language';
import { isOffline, ReloadRequiredError, whenOnline } from '../dom/network';
import { words } from '../dom/words';
import type { NoticeAction } from '../panels/panel';
import { describe } from '../worker/describe';

/** In order of importance: the notice names only the first one that is missing. */
const KINDS = ['interpreter', 'parts', 'panels', 'editor', 'completion'] as const;
type MissingKind = (typeof KINDS)[number];

/** A failure, as the event `gcode-error` reports it. */
export interface HostError {
  /** The setup, the program of `src`, or the part of the element that could not be loaded or was stopped. */
  readonly kind: 'setup' | 'source' | MissingKind;
  readonly reason: string;
  /** The sentence that the element shows, in its language. */
  readonly message: string;
}

/** Minimum delay between a failure and an attempt after an edit. */
const MIN_RETRY_DELAY_MS = 2_000;
/** A failure this soon after the network has returned may be that of a request from before. */
const NETWORK_RETURNS_MS = 5_000;

interface MissingPart {
  readonly message: (language: Language) => string;
  /** Without the sentence around it. */
  readonly reason: string;
  /** Retries; `'reload'` if only reloading the page helps. */
  readonly retry: (() => void) | 'reload';
  isRetrying: boolean;
  /** Another attempt was requested during the current one: the network may have returned meanwhile. */
  isRetryRequested: boolean;
}

interface MissingEvents {
  /** Shows the notice, or replaces it. */
  show(text: string, action: NoticeAction): void;
  hide(): void;
  /** Something has failed, at the first or at another attempt. */
  onFailed(error: HostError): void;
}

export class Missing {
  readonly #events: MissingEvents;
  readonly #parts = new Map<MissingKind, MissingPart>();
  #language: Language;
  /** Earliest time of an attempt after an edit (`performance.now`). */
  #earliestRetry = 0;
  #retryTimer: ReturnType<typeof setTimeout> | undefined;
  /** Set during an attempt, so that the run it starts does not count as an edit. */
  #isRetryingAll = false;
  #stopWaitingForNetwork: (() => void) | undefined;
  /** When the network last returned (`performance.now`). */
  #onlineAt = -Infinity;

  constructor(language: Language, events: MissingEvents) {
    this.#language = language;
    this.#events = events;
  }

  set language(language: Language) {
    this.#language = language;
    this.#show();
  }

  /** Reports a failed load; `retry` retries it, and then either `markFailed` or `markLoaded` is called. */
  markFailed(kind: MissingKind, error: unknown, retry: () => void): void {
    const needsReload = error instanceof ReloadRequiredError;
    const isWithoutNetwork = !needsReload && isOffline();
    const reason = ({ reasons }: Words): string =>
      needsReload ? reasons.needsReload : isWithoutNetwork ? reasons.noNetwork : describe(error);
    this.#add(kind, {
      message: (language) => WORDS[language].failed[kind](reason(WORDS[language])),
      reason: reason(WORDS[this.#language]),
      retry: needsReload ? 'reload' : retry,
    });
  }

  /** Reports that the interpreter takes too long, or has crashed; `retry` as in `markFailed`. */
  markLost(cause: 'silent' | 'crashed', retry: () => void): void {
    this.#add('interpreter', { message: (language) => WORDS[language].lost[cause], reason: cause, retry });
  }

  #add(kind: MissingKind, failed: Pick<MissingPart, 'message' | 'reason' | 'retry'>): void {
    // Several callers can report the same failure.
    const before = this.#parts.get(kind);
    this.#parts.set(kind, { ...failed, isRetrying: false, isRetryRequested: false });
    if (before?.isRetrying !== false) {
      this.#earliestRetry = performance.now() + MIN_RETRY_DELAY_MS;
      this.#events.onFailed({ kind, reason: failed.reason, message: failed.message(this.#language) });
    }
    this.#show();
    const hasJustReturned = performance.now() - this.#onlineAt < NETWORK_RETURNS_MS;
    if (before?.isRetryRequested === true || hasJustReturned) this.onEdit();
    this.#stopWaitingForNetwork ??= whenOnline(() => {
      this.#stopWaitingForNetwork = undefined;
      this.#onlineAt = performance.now();
      this.retryAll();
    });
  }

  /** Reports an attempt that was started elsewhere. */
  markRetrying(kind: MissingKind): void {
    const part = this.#parts.get(kind);
    if (part !== undefined) part.isRetrying = true;
  }

  markLoaded(kind: MissingKind): void {
    if (!this.#parts.delete(kind)) return;
    if (this.#parts.size === 0) this.cancelRetries();
    this.#show();
  }

  retryAll(): void {
    clearTimeout(this.#retryTimer);
    this.#retryTimer = undefined;
    this.#isRetryingAll = true;
    for (const part of [...this.#parts.values()]) {
      if (part.retry === 'reload') continue;
      part.isRetryRequested = part.isRetrying;
      if (part.isRetrying) continue;
      part.isRetrying = true;
      part.retry();
    }
    this.#isRetryingAll = false;
  }

  /** The user has edited the program. */
  onEdit(): void {
    if (this.#parts.size === 0 || this.#isRetryingAll) return;
    this.#retryTimer ??= setTimeout(
      () => {
        this.#retryTimer = undefined;
        // An attempt may have failed since the timer was set.
        if (performance.now() < this.#earliestRetry) this.onEdit();
        else this.retryAll();
      },
      Math.max(0, this.#earliestRetry - performance.now()),
    );
  }

  /** Cancels all retries. */
  cancelRetries(): void {
    clearTimeout(this.#retryTimer);
    this.#retryTimer = undefined;
    this.#stopWaitingForNetwork?.();
    this.#stopWaitingForNetwork = undefined;
  }

  #show(): void {
    const first = KINDS.find((kind) => this.#parts.has(kind));
    const part = first && this.#parts.get(first);
    if (part === undefined) return this.#events.hide();
    const { tryAgain, reload } = WORDS[this.#language];
    this.#events.show(
      part.message(this.#language),
      part.retry === 'reload'
        ? { title: reload, act: () => location.reload() }
        : { title: tryAgain, act: () => this.retryAll() },
    );
  }
}

const WORDS = words({
  en: {
    failed: {
      interpreter: (reason: string) => `The interpreter could not be loaded (${reason}).`,
      parts: (reason: string) =>
        `Not all of the playground could be loaded (${reason}). The drawing is correct, and you can go on editing.`,
      panels: (reason: string) => `Part of the page could not be loaded (${reason}).`,
      editor: (reason: string) => `The editor could not be loaded (${reason}). The drawing is correct.`,
      completion: (reason: string) => `The proposals of the editor could not be loaded (${reason}).`,
    },
    reasons: {
      needsReload: 'the page has to be reloaded',
      noNetwork: 'no network connection; will retry when you are back online',
    },
    lost: {
      silent: 'The run took too long and was stopped. Your program is still here: change it to run it again.',
      crashed: 'The interpreter failed; that is our fault. Your program is still here: change it to run it again.',
    },
    tryAgain: 'Try again',
    reload: 'Reload',
  },
  zh: {
    failed: {
      interpreter: (reason) => `解释器加载失败（${reason}）。`,
      parts: (reason) => `部分内容加载失败（${reason}）。已画出的轨迹是正确的，可以继续编辑。`,
      panels: (reason) => `页面的一部分加载失败（${reason}）。`,
      editor: (reason) => `编辑器加载失败（${reason}）。图形是正确的。`,
      completion: (reason) => `编辑器的输入建议加载失败（${reason}）。`,
    },
    reasons: {
      needsReload: '需要重新加载页面',
      noNetwork: '没有网络；网络恢复后会自动重试',
    },
    lost: {
      silent: '运行时间过长，已停止。您的程序仍在，修改后会重新运行。',
      crashed: '解释器出错，这是我们的问题。您的程序仍在，修改后会重新运行。',
    },
    tryAgain: '重试',
    reload: '重新加载',
  },
  ru: {
    failed: {
      interpreter: (reason) => `Не удалось загрузить интерпретатор (${reason}).`,
      parts: (reason) => `Загружено не всё (${reason}). Чертёж верен; можно редактировать дальше.`,
      panels: (reason) => `Не удалось загрузить часть страницы (${reason}).`,
      editor: (reason) => `Не удалось загрузить редактор (${reason}). Чертёж верен.`,
      completion: (reason) => `Не удалось загрузить подсказки редактора (${reason}).`,
    },
    reasons: {
      needsReload: 'нужно обновить страницу',
      noNetwork: 'нет сети; попытка повторится, когда сеть появится',
    },
    lost: {
      silent:
        'Выполнение длилось слишком долго и было остановлено. Программа сохранена: измените её, чтобы запустить снова.',
      crashed:
        'Произошёл сбой интерпретатора — это наша ошибка. Программа сохранена: измените её, чтобы запустить снова.',
    },
    tryAgain: 'Повторить',
    reload: 'Обновить',
  },
});

type Words = (typeof WORDS)['en'];
