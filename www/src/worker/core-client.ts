// The page's end of the line to the worker.
//
// In: commands and typed questions; changes of text and setup, each of which begins a run. Out: the worker's
// events, and promises of answers, of the newest run only: whatever belongs to an earlier one ends here.
// Watches that the worker answers at all; one that is silent for 15 s, or has failed, is ended and reported
// as lost. Must not know: what the commands mean, or what is on the page.

import { coreModule } from './core-module';
import { counts, OF_THE_RUN, type Answer, type Command, type Core, type Pictures, type Question, type QuestionKind, type Questions, type RunChange, type RunEvent, type WorkerEvent } from '../protocol/protocol';

const SILENCE_LIMIT_MS = 15_000;
/** After the computer slept the timer may ring before the answer that is already there is read. */
const GRACE_MS = 1_000;

export type Loss = { readonly kind: 'silent' } | { readonly kind: 'crashed' | 'load-failed'; readonly reason: string };

/** What reaches the page beside answers and pictures. */
export type Heard = Exclude<RunEvent, { readonly kind: 'answer' | 'pictures' | 'settled' }>;

export interface CoreListener {
  /** The interpreter is loaded. */
  ready(): void;
  /** Of the newest run. */
  event(event: Heard): void;
  /** Shows pictures of the newest run that the worker knows; the images are the listener's. */
  pictures(pictures: Pictures): void;
  /** Something that may change what is shown is under way. */
  unsettled(): void;
  /** The worker has heard all that was sent, and there is nothing more to show of the newest run. */
  settled(run: number): void;
  /** The worker is gone; nothing sent to this client is answered any more. */
  lost(loss: Loss): void;
}

/** A question under way. */
interface Waiting {
  readonly about: QuestionKind;
  readonly resolve: (answer: never) => void;
}

/** Grows with every change of text or setup, whichever worker it goes to. */
let newestRun = 0;

export class CoreClient {
  readonly #worker: Worker;
  readonly #listener: CoreListener;
  readonly #waiting = new Map<number, Waiting>();
  #nextId = 1;
  #ready = false;
  #ended = false;
  #watch: ReturnType<typeof setTimeout> | undefined;
  /** The run that the page wants, and the last one the worker has received. */
  #run = ++newestRun;
  #told = 0;
  /** Messages sent that may change what is shown. */
  #sent = 0;

  constructor(listener: CoreListener) {
    this.#listener = listener;
    this.#worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    this.#worker.onmessage = (message: MessageEvent<WorkerEvent>) => this.#receive(message.data);
    this.#worker.onerror = (error) => this.#lose({ kind: 'load-failed', reason: error.message || 'worker' });
    coreModule().then(
      (module) => this.#ended || this.#worker.postMessage({ kind: 'core', module } satisfies Core),
      (reason: unknown) => this.#lose({ kind: 'load-failed', reason: reason instanceof Error ? reason.message : String(reason) }),
    );
  }

  /** The number of the run that the page wants. */
  get run(): number {
    return this.#run;
  }

  /**
   * Text or setup have changed: what comes of earlier runs is not wanted any more, even if the worker
   * hears of it a little later.
   */
  outdate(): void {
    if (this.#run === this.#told) this.#run = ++newestRun;
    this.#listener.unsettled();
  }

  /** Begins the run of what has changed. */
  begin(change: RunChange): void {
    this.outdate();
    this.#told = this.#run;
    this.send({ kind: 'run', run: this.#run, ...change });
  }

  send(command: Command): void {
    if (this.#ended) return;
    this.#post(command);
    if (command.kind !== 'shown') this.#watchOver();
  }

  /**
   * The promise stays open for ever when the worker is lost: whoever waits hears of it by `lost`. What is
   * asked about a run is answered with `undefined` once there is another one.
   */
  ask<K extends QuestionKind>(about: K, ask: Questions[K]['ask']): Promise<Answer<K>> {
    return new Promise((resolve) => {
      if (this.#ended) return;
      const question: Question<K> = { kind: 'question', id: this.#nextId++, about, ask };
      this.#waiting.set(question.id, { about, resolve: resolve as (answer: never) => void });
      this.#post(question);
      if (about !== 'ping') this.#watchOver();
    });
  }

  end(): void {
    this.#ended = true;
    clearTimeout(this.#watch);
    this.#waiting.clear();
    this.#worker.terminate();
  }

  #post(message: Command | Question): void {
    if (counts(message)) {
      this.#sent++;
      this.#listener.unsettled();
    }
    this.#worker.postMessage(message);
  }

  #receive(event: WorkerEvent): void {
    if (this.#ended) {
      if (event.kind === 'pictures') close(event.pictures);
      return;
    }
    switch (event.kind) {
      case 'answer': {
        const waiting = this.#waiting.get(event.id);
        this.#waiting.delete(event.id);
        if (waiting === undefined) return;
        const overtaken = OF_THE_RUN[waiting.about] && event.run !== this.#run;
        waiting.resolve((overtaken ? undefined : event.answer) as never);
        return;
      }
      case 'pictures': {
        // A change that the worker has not received yet leaves the last picture as it is.
        const dropped = event.run !== this.#told;
        if (dropped) close(event.pictures);
        else this.#listener.pictures(event.pictures);
        this.send({ kind: 'shown', dropped });
        return;
      }
      case 'settled':
        if (event.run === this.#run && event.heard === this.#sent) this.#listener.settled(event.run);
        return;
      case 'crashed':
      case 'load-failed':
        this.#lose({ kind: event.kind, reason: event.reason });
        return;
      case 'ready':
        this.#ready = true;
        this.#watchOver();
        this.#listener.ready();
        return;
      default:
        if (event.run === this.#run) this.#listener.event(event);
    }
  }

  /** One ping at a time, and only while there is something the worker has to do. */
  #watchOver(): void {
    if (!this.#ready || this.#watch !== undefined) return;
    this.#watch = setTimeout(() => {
      this.#watch = setTimeout(() => this.#lose({ kind: 'silent' }), GRACE_MS);
    }, SILENCE_LIMIT_MS);
    void this.ask('ping', undefined).then(() => {
      clearTimeout(this.#watch);
      this.#watch = undefined;
    });
  }

  #lose(loss: Loss): void {
    if (this.#ended) return;
    this.end();
    this.#listener.lost(loss);
  }
}

function close(pictures: Pictures): void {
  for (const image of Object.values(pictures)) image.close();
}

/**
 * Asks with the newest value only: while one question is under way, later ones replace each other,
 * so a fast pointer never builds a queue.
 */
export class Newest<K extends QuestionKind> {
  readonly #client: CoreClient;
  readonly #about: K;
  readonly #answered: (answer: Answer<K>) => void;
  #busy = false;
  #next: { readonly ask: Questions[K]['ask'] } | undefined;
  /** The answer under way is not wanted any more. */
  #forgotten = false;

  constructor(client: CoreClient, about: K, answered: (answer: Answer<K>) => void) {
    this.#client = client;
    this.#about = about;
    this.#answered = answered;
  }

  ask(ask: Questions[K]['ask']): void {
    if (this.#busy) {
      this.#next = { ask };
      this.#forgotten = false;
      return;
    }
    this.#busy = true;
    this.#forgotten = false;
    void this.#client.ask(this.#about, ask).then((answer) => {
      const next = this.#next;
      this.#busy = false;
      this.#next = undefined;
      // An answer that a newer question has overtaken is still shown: better a little late than frozen.
      if (!this.#forgotten) this.#answered(answer);
      if (next !== undefined) this.ask(next.ask);
    });
  }

  /** Drops what has not been sent yet, and the answer to what has. */
  forget(): void {
    this.#next = undefined;
    this.#forgotten = true;
  }
}
