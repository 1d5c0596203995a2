// One element's line to the worker: its session there.
//
// In: commands and typed questions; changes of text and setup, each of which begins a run. Out: the session's
// events, and promises of answers, of the newest run only: whatever belongs to an earlier one ends here.
// Must not know: what the commands mean, what is on the page, or that others share the worker.

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
  /** The worker or the session is gone; nothing sent to this client is answered any more. */
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
  readonly #line: Line;
  readonly #listener: CoreListener;
  readonly #waiting = new Map<number, Waiting>();
  #nextId = 1;
  #ended = false;
  /** The run that the page wants, and the last one the worker has received. */
  #run = ++newestRun;
  #told = 0;
  /** Messages sent that may change what is shown. */
  #sent = 0;

  /** `where`: apart from the others where it has made them wait before. */
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
      // These are about the worker: they count whichever run was current.
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
