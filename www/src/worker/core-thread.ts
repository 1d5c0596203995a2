// The worker that all elements of a page share, from the page's side.
//
// In: messages of the sessions. Out: events for each of them. A worker that fails, or gives no answer for 15 s
// (30 s while it starts), is ended, and every session is reported as lost; the session that it worked for
// is to blame, the others are only its neighbours. A session that is begun after that goes to a
// worker apart, so there are never more than two. Must not know: what is said in a session.

import { PART_FILES } from '../../pkg/part-files.js';
import { coreModule, forgetCoreModule } from './core-module';
import { startWorker, type StartedWorker } from './start-worker';
import script from './worker.ts?worker&url';
import type { Command, FromWorker, Question, SessionEvent, ToWorker } from '../protocol/protocol';

const SILENCE_LIMIT_MS = 15_000;
/** Its script may still be on its way. */
const START_LIMIT_MS = 30_000;
/** After the computer slept the timer may ring before the answer that is already there is read. */
const GRACE_MS = 1_000;
/** An element that is moved in the page, or replaced by another one, finds the worker where it was. */
const END_AFTER_MS = 1_000;

export type Loss =
  | { readonly kind: 'silent' }
  /** Another session is to blame. */
  | { readonly kind: 'neighbour' }
  | { readonly kind: 'crashed' | 'load-failed'; readonly reason: string };

/** What a session hears. */
export interface LineListener {
  /** The interpreter is loaded. */
  ready(): void;
  event(event: SessionEvent): void;
  /** Nothing that was said is answered any more. */
  lost(loss: Loss): void;
}

/** What a session has of its worker. */
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
  /** The session that the worker is at work for. */
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
        // A picture for nobody.
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

  /** One ping at a time, and only while there is something the worker has to do. */
  #watchOver(): void {
    if (!this.#ready || this.#watch !== undefined) return;
    this.#watch = setTimeout(() => {
      this.#watch = setTimeout(() => this.#lose({ kind: 'silent' }, this.#atWork), GRACE_MS);
    }, SILENCE_LIMIT_MS);
    this.#post({ kind: 'ping' });
  }

  /** An error that the worker has not caught, or that of its start. */
  #failed(reason: string): void {
    if (this.#ready) this.#lose({ kind: 'crashed', reason }, this.#atWork);
    else this.#loadFailed(reason);
  }

  #loadFailed(reason: string): void {
    const listeners = this.#end();
    for (const listener of listeners) listener.lost({ kind: 'load-failed', reason });
  }

  /** `blamed`: the session that the worker was at work for. */
  #lose(loss: Loss, blamed: number | undefined): void {
    const guilty = blamed === undefined ? undefined : this.#sessions.get(blamed);
    const listeners = this.#end();
    for (const listener of listeners)
      listener.lost(guilty === undefined || listener === guilty ? loss : { kind: 'neighbour' });
  }

  /** The sessions there were. */
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
