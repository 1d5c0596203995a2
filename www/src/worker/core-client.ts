// The client of the worker for one element, connected to its session there.
//
// In: commands and typed questions; changes of text and setup, each of which starts a run. Out: the session's events,
// and promises of answers, for the newest run only; everything about earlier runs is dropped here. Must not know: the
// meaning of commands, the content of the page, or that elements share the worker.

import { CoreThread, type Line, type Loss } from './core-thread';
import {
  counts,
  OF_THE_RUN,
  type Answer,
  type Command,
  type Pictures,
  type Question,
  type QuestionKind,
  type Questions,
  type RunChange,
  type RunEvent,
  type SessionEvent,
} from '../protocol/protocol';

export type { Loss };

/** The events that are passed on, besides answers and pictures. */
export type Heard = Exclude<RunEvent, { readonly kind: 'answer' | 'pictures' | 'settled' }>;

export interface CoreListener {
  /** The interpreter is loaded. */
  ready(): void;
  /** An event of the newest run. */
  event(event: Heard): void;
  /** Shows pictures of the newest run that the worker knows. The listener owns the images. */
  pictures(pictures: Pictures): void;
  /** Something that may change the display is in progress. */
  unsettled(): void;
  /** The worker has processed all messages, and everything of the newest run is shown. */
  settled(run: number): void;
  /** The worker or the session has failed; nothing sent to this client is answered any more. */
  lost(loss: Loss): void;
}

/** A pending question. */
interface Waiting {
  readonly about: QuestionKind;
  readonly resolve: (answer: never) => void;
}

/** Incremented with every change of text or setup in any element. */
let newestRun = 0;

export class CoreClient {
  readonly #line: Line;
  readonly #listener: CoreListener;
  readonly #waiting = new Map<number, Waiting>();
  #nextId = 1;
  #ended = false;
  /** The run that the page wants; `#told` is the last one that was sent to the worker. */
  #run = ++newestRun;
  #told = 0;
  /** The number of sent messages that may change the display. */
  #sent = 0;

  /** `where`: `apart` if this element has made a shared worker fail before. */
  constructor(listener: CoreListener, where: 'with-others' | 'apart') {
    this.#listener = listener;
    this.#line = CoreThread.join(where, {
      ready: () => listener.ready(),
      event: (event) => this.#receive(event),
      lost: (loss) => this.#lose(loss),
    });
  }

  /** The number of the run that the page wants. */
  get run(): number {
    return this.#run;
  }

  /**
   * Text or setup have changed: results of earlier runs are dropped from now on, even before the worker is notified.
   */
  outdate(): void {
    if (this.#run === this.#told) this.#run = ++newestRun;
    this.#listener.unsettled();
  }

  /** Starts a run of the changes. */
  begin(change: RunChange): void {
    this.outdate();
    this.#told = this.#run;
    this.send({ kind: 'run', run: this.#run, ...change });
  }

  send(command: Command): void {
    if (this.#ended) return;
    this.#post(command);
  }

  /**
   * The promise stays pending if the worker fails; `lost` reports that. A question about a run is answered with
   * `undefined` once there is a newer run.
   */
  ask<K extends QuestionKind>(about: K, ask: Questions[K]['ask']): Promise<Answer<K>> {
    return new Promise((resolve) => {
      if (this.#ended) return;
      const question: Question<K> = { kind: 'question', id: this.#nextId++, about, ask };
      this.#waiting.set(question.id, { about, resolve: resolve as (answer: never) => void });
      this.#post(question);
    });
  }

  end(): void {
    this.#ended = true;
    this.#waiting.clear();
    this.#line.leave();
  }

  #post(message: Command | Question): void {
    if (counts(message)) {
      this.#sent++;
      this.#listener.unsettled();
    }
    this.#line.say(message);
  }

  #receive(event: SessionEvent): void {
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
        // While a change was not sent yet, a picture of the last sent run is still shown.
        const dropped = event.run !== this.#told;
        if (dropped) close(event.pictures);
        else this.#listener.pictures(event.pictures);
        this.send({ kind: 'shown', dropped });
        return;
      }
      case 'settled':
        if (event.run === this.#run && event.heard === this.#sent) this.#listener.settled(event.run);
        return;
      // These are about the worker, so they are valid for any run.
      case 'part-failed':
        this.#listener.event(event.run === this.#run ? event : { ...event, neededFor: 'something-else' });
        return;
      case 'parts-loaded':
        this.#listener.event(event);
        return;
      default:
        if (event.run === this.#run) this.#listener.event(event);
    }
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
 * Asks with the newest value only: while a question is pending, later ones replace each other, so a fast pointer never
 * fills a queue.
 */
export class Newest<K extends QuestionKind> {
  readonly #client: CoreClient;
  readonly #about: K;
  readonly #answered: (answer: Answer<K>) => void;
  #busy = false;
  #next: { readonly ask: Questions[K]['ask'] } | undefined;
  /** The pending answer is to be dropped. */
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
      // Show an answer even if a newer question is waiting: a late value is better than a frozen display.
      if (!this.#forgotten) this.#answered(answer);
      if (next !== undefined) this.ask(next.ask);
    });
  }

  /** Drops the waiting question, and the answer to the pending one. */
  forget(): void {
    this.#next = undefined;
    this.#forgotten = true;
  }
}
