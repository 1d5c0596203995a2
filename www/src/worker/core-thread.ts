// The page's side of the worker that all elements of a page share.
//
// In: messages of the sessions. Out: events for each of them. A worker that fails, or does not answer for 15 s (30 s
// while it starts), is terminated, and every session is reported as lost: the session that was active has caused it,
// the others are its neighbours. A session of an element that has caused a failure starts in a separate worker, so
// there are never more than two. Must not know: the content of messages.

import { PART_FILES } from '../../pkg/part-files.js';
import { coreModule, forgetCoreModule } from './core-module';
import { startWorker, type StartedWorker } from './start-worker';
import script from './worker.ts?worker&url';
import type { Command, FromWorker, Question, SessionEvent, ToWorker } from '../protocol/protocol';

const SILENCE_LIMIT_MS = 15_000;
/** Longer, since its script may still be loading. */
const START_LIMIT_MS = 30_000;
/** After the computer was suspended, the timer can fire before an answer that has already arrived is processed. */
const GRACE_MS = 1_000;
/** The worker is kept this long without a session, for an element that is moved in the page or replaced by another. */
const END_AFTER_MS = 1_000;

export type Loss =
  | { readonly kind: 'silent' }
  /** Another session has caused the failure. */
  | { readonly kind: 'neighbour' }
  | { readonly kind: 'crashed' | 'load-failed'; readonly reason: string };

/** Events for a session. */
export interface LineListener {
  /** The interpreter is loaded. */
  ready(): void;
  event(event: SessionEvent): void;
  /** The worker has failed; no message is answered any more. */
  lost(loss: Loss): void;
}

/** The connection of a session to its worker. */
export interface Line {
  say(what: Command | Question): void;
  leave(): void;
}

let nextSession = 1;

export class CoreThread {
  static readonly #threads: Partial<Record<'with-others' | 'apart', CoreThread>> = {};

  readonly #where: 'with-others' | 'apart';
  readonly #worker: StartedWorker;
  readonly #sessions = new Map<number, LineListener>();
  #ready = false;
  /** The session that the worker is processing. */
  #atWork: number | undefined;
  #watch: ReturnType<typeof setTimeout> | undefined;
  #ending: ReturnType<typeof setTimeout> | undefined;

  static join(where: 'with-others' | 'apart', listener: LineListener): Line {
    return (CoreThread.#threads[where] ??= new CoreThread(where)).#join(listener);
  }

  private constructor(where: 'with-others' | 'apart') {
    this.#where = where;
    this.#worker = startWorker<FromWorker>(
      script,
      (event) => this.#receive(event),
      (reason) => this.#failed(reason),
    );
    this.#post({ kind: 'files', files: PART_FILES });
    coreModule().then(
      (module) => {
        this.#post({ kind: 'core', module });
        this.#watch = setTimeout(() => this.#loadFailed('the worker gives no answer'), START_LIMIT_MS);
      },
      (reason: unknown) => this.#loadFailed(reason instanceof Error ? reason.message : String(reason)),
    );
  }

  #join(listener: LineListener): Line {
    const session = nextSession++;
    this.#sessions.set(session, listener);
    clearTimeout(this.#ending);
    if (this.#ready) queueMicrotask(() => this.#sessions.get(session)?.ready());
    return {
      say: (what) => {
        this.#post({ kind: 'say', session, what });
        if (what.kind !== 'shown') this.#watchOver();
      },
      leave: () => {
        if (!this.#sessions.delete(session)) return;
        this.#post({ kind: 'close', session });
        if (this.#sessions.size === 0) this.#ending = setTimeout(() => this.#end(), END_AFTER_MS);
      },
    };
  }

  #post(message: ToWorker): void {
    this.#worker.post(message);
  }

  #receive(event: FromWorker): void {
    switch (event.kind) {
      case 'event':
        this.#sessions.get(event.session)?.event(event.event);
        // The session is closed, so release the images.
        if (!this.#sessions.has(event.session) && event.event.kind === 'pictures')
          for (const image of Object.values(event.event.pictures)) image.close();
        return;
      case 'at-work':
        this.#atWork = event.session;
        return;
      case 'pong':
        clearTimeout(this.#watch);
        this.#watch = undefined;
        return;
      case 'ready':
        this.#ready = true;
        clearTimeout(this.#watch);
        this.#watch = undefined;
        this.#watchOver();
        for (const listener of [...this.#sessions.values()]) listener.ready();
        return;
      case 'crashed':
        this.#lose({ kind: 'crashed', reason: event.reason }, event.session);
        return;
      case 'load-failed':
        forgetCoreModule();
        this.#loadFailed(event.reason);
    }
  }

  /** Sends a ping, one at a time, and only while the worker has something to do. */
  #watchOver(): void {
    if (!this.#ready || this.#watch !== undefined) return;
    this.#watch = setTimeout(() => {
      this.#watch = setTimeout(() => this.#lose({ kind: 'silent' }, this.#atWork), GRACE_MS);
    }, SILENCE_LIMIT_MS);
    this.#post({ kind: 'ping' });
  }

  /** An uncaught error in the worker, or an error at its start. */
  #failed(reason: string): void {
    if (this.#ready) this.#lose({ kind: 'crashed', reason }, this.#atWork);
    else this.#loadFailed(reason);
  }

  #loadFailed(reason: string): void {
    const listeners = this.#end();
    for (const listener of listeners) listener.lost({ kind: 'load-failed', reason });
  }

  /** `blamed`: the session that the worker was processing. */
  #lose(loss: Loss, blamed: number | undefined): void {
    const guilty = blamed === undefined ? undefined : this.#sessions.get(blamed);
    const listeners = this.#end();
    for (const listener of listeners)
      listener.lost(guilty === undefined || listener === guilty ? loss : { kind: 'neighbour' });
  }

  /** Terminates the worker; returns the listeners of its sessions. */
  #end(): readonly LineListener[] {
    clearTimeout(this.#watch);
    clearTimeout(this.#ending);
    this.#worker.end();
    if (CoreThread.#threads[this.#where] === this) delete CoreThread.#threads[this.#where];
    const listeners = [...this.#sessions.values()];
    this.#sessions.clear();
    return listeners;
  }
}
