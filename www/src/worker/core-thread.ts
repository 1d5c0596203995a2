// The page's side of the worker that all elements of a page share.
//
// In: messages of the sessions. Out: events for each of them. A worker that fails, or does not answer for 15 s (30 s
// while it starts), is terminated, and every session is reported as lost: the session that was active has caused it,
// the others receive `other-session`. A session of an element that has caused a failure starts in a separate worker, so
// there are never more than two. Must not know: the content of messages.

import { PART_FILES } from '../../pkg/part-files.js';
import { coreModule, discardCoreModule } from './core-module';
import { startWorker, type StartedWorker } from './start-worker';
import script from './worker.ts?worker&url';
import type { Command, FromWorker, Question, SessionEvent, ToWorker } from '../protocol/protocol';
import { describe } from './describe';

const SILENCE_LIMIT_MS = 15_000;
/** Longer, since its script may still be loading. */
const START_LIMIT_MS = 30_000;
/** After the computer was suspended, the timer can fire before an answer that has already arrived is processed. */
const LATE_ANSWER_MS = 1_000;
/** The worker is kept this long without a session, for an element that is moved in the page or replaced by another. */
const END_AFTER_MS = 1_000;

export type Loss =
  | { readonly kind: 'silent' }
  /** Another session has caused the failure. */
  | { readonly kind: 'other-session' }
  | { readonly kind: 'crashed' | 'load-failed'; readonly reason: string };

/** Events for a session. */
interface ConnectionListener {
  /** The interpreter is loaded. */
  onReady(): void;
  onEvent(event: SessionEvent): void;
  /** The worker has failed; no message is answered any more. */
  onLost(loss: Loss): void;
}

/** The connection of a session to its worker. */
export interface WorkerConnection {
  send(content: Command | Question): void;
  close(): void;
}

let nextSession = 1;

export class CoreThread {
  static readonly #threads: Partial<Record<'shared' | 'separate', CoreThread>> = {};

  readonly #mode: 'shared' | 'separate';
  readonly #worker: StartedWorker;
  readonly #sessions = new Map<number, ConnectionListener>();
  #ready = false;
  /** The session that the worker is processing. */
  #activeSession: number | undefined;
  #watchdog: ReturnType<typeof setTimeout> | undefined;
  #endTimer: ReturnType<typeof setTimeout> | undefined;

  static join(mode: 'shared' | 'separate', listener: ConnectionListener): WorkerConnection {
    return (CoreThread.#threads[mode] ??= new CoreThread(mode)).#join(listener);
  }

  private constructor(mode: 'shared' | 'separate') {
    this.#mode = mode;
    this.#worker = startWorker<FromWorker>(
      script,
      (event) => this.#receive(event),
      (reason) => this.#onWorkerError(reason),
    );
    this.#post({ kind: 'files', files: PART_FILES });
    coreModule().then(
      (module) => {
        this.#post({ kind: 'core', module });
        this.#watchdog = setTimeout(() => this.#failLoading('the worker gives no answer'), START_LIMIT_MS);
      },
      (reason: unknown) => this.#failLoading(describe(reason)),
    );
  }

  #join(listener: ConnectionListener): WorkerConnection {
    const session = nextSession++;
    this.#sessions.set(session, listener);
    clearTimeout(this.#endTimer);
    if (this.#ready) queueMicrotask(() => this.#sessions.get(session)?.onReady());
    return {
      send: (content) => {
        this.#post({ kind: 'to-session', session, content });
        if (content.kind !== 'shown') this.#startWatchdog();
      },
      close: () => {
        if (!this.#sessions.delete(session)) return;
        this.#post({ kind: 'close', session });
        if (this.#sessions.size === 0) this.#endTimer = setTimeout(() => this.#end(), END_AFTER_MS);
      },
    };
  }

  #post(message: ToWorker): void {
    this.#worker.post(message);
  }

  #receive(event: FromWorker): void {
    switch (event.kind) {
      case 'event':
        this.#sessions.get(event.session)?.onEvent(event.event);
        // The session is closed, so release the images.
        if (!this.#sessions.has(event.session) && event.event.kind === 'pictures')
          for (const image of Object.values(event.event.pictures)) image.close();
        return;
      case 'active':
        this.#activeSession = event.session;
        return;
      case 'pong':
        clearTimeout(this.#watchdog);
        this.#watchdog = undefined;
        return;
      case 'ready':
        this.#ready = true;
        clearTimeout(this.#watchdog);
        this.#watchdog = undefined;
        this.#startWatchdog();
        for (const listener of [...this.#sessions.values()]) listener.onReady();
        return;
      case 'crashed':
        this.#fail({ kind: 'crashed', reason: event.reason }, event.session);
        return;
      case 'load-failed':
        discardCoreModule();
        this.#failLoading(event.reason);
    }
  }

  /** Sends a ping, one at a time, and only while the worker has something to do. */
  #startWatchdog(): void {
    if (!this.#ready || this.#watchdog !== undefined) return;
    this.#watchdog = setTimeout(() => {
      this.#watchdog = setTimeout(() => this.#fail({ kind: 'silent' }, this.#activeSession), LATE_ANSWER_MS);
    }, SILENCE_LIMIT_MS);
    this.#post({ kind: 'ping' });
  }

  /** An uncaught error in the worker, or an error at its start. */
  #onWorkerError(reason: string): void {
    if (this.#ready) this.#fail({ kind: 'crashed', reason }, this.#activeSession);
    else this.#failLoading(reason);
  }

  #failLoading(reason: string): void {
    const listeners = this.#end();
    for (const listener of listeners) listener.onLost({ kind: 'load-failed', reason });
  }

  /** `activeSession`: the session that the worker was processing. */
  #fail(loss: Loss, activeSession: number | undefined): void {
    const failedListener = activeSession === undefined ? undefined : this.#sessions.get(activeSession);
    const listeners = this.#end();
    for (const listener of listeners)
      listener.onLost(failedListener === undefined || listener === failedListener ? loss : { kind: 'other-session' });
  }

  /** Terminates the worker; returns the listeners of its sessions. */
  #end(): readonly ConnectionListener[] {
    clearTimeout(this.#watchdog);
    clearTimeout(this.#endTimer);
    this.#worker.end();
    if (CoreThread.#threads[this.#mode] === this) delete CoreThread.#threads[this.#mode];
    const listeners = [...this.#sessions.values()];
    this.#sessions.clear();
    return listeners;
  }
}
