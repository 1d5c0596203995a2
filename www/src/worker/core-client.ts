// The client of the worker for one element, connected to its session there.
//
// In: commands and typed questions; changes of text and setup, each of which starts a run. Out: the session's events,
// and promises of answers, for the newest run only; everything about earlier runs is dropped here. Must not know: the
// meaning of commands, the content of the page, or that elements share the worker.

import { CoreThread, type WorkerConnection, type Loss } from './core-thread';
import {
  mayChangeDisplay,
  RUN_DEPENDENT,
  type Answer,
  type Command,
  type Pictures,
  type SectionScale,
  type Question,
  type QuestionKind,
  type Questions,
  type RunChange,
  type RunEvent,
  type SessionEvent,
} from '../protocol/protocol';

export type { Loss };

/** The events that are passed on, besides answers and pictures. */
export type CoreEvent = Exclude<RunEvent, { readonly kind: 'answer' | 'pictures' | 'settled' }>;

export interface CoreListener {
  /** The interpreter is loaded. */
  onReady(): void;
  /** An event of the newest run. */
  onEvent(event: CoreEvent): void;
  /** Shows pictures of the newest run that the worker knows. The listener owns the images. */
  onPictures(pictures: Pictures, scale: SectionScale): void;
  /** Something that may change the display is in progress. */
  onUnsettled(): void;
  /** The worker has processed all messages, and everything of the newest run is shown. */
  onSettled(run: number): void;
  /** The worker or the session has failed; nothing sent to this client is answered any more. */
  onLost(loss: Loss): void;
}

/** A pending question. */
interface PendingQuestion {
  readonly about: QuestionKind;
  readonly resolve: (answer: never) => void;
}

/** Incremented with every change of text or setup in any element. */
let newestRun = 0;

export class CoreClient {
  readonly #connection: WorkerConnection;
  readonly #listener: CoreListener;
  readonly #pendingQuestions = new Map<number, PendingQuestion>();
  #nextId = 1;
  #isEnded = false;
  /** The run that the page wants; `#sentRun` is the last one that was sent to the worker. */
  #run = ++newestRun;
  #sentRun = 0;
  /** The number of sent messages that may change the display. */
  #sentCount = 0;

  /** `mode`: `separate` if this element has made a shared worker fail before. */
  constructor(listener: CoreListener, mode: 'shared' | 'separate') {
    this.#listener = listener;
    this.#connection = CoreThread.join(mode, {
      onReady: () => listener.onReady(),
      onEvent: (event) => this.#receive(event),
      onLost: (loss) => this.#fail(loss),
    });
  }

  /** The number of the run that the page wants. */
  get run(): number {
    return this.#run;
  }

  /**
   * Text or setup have changed: results of earlier runs are dropped from now on, even before the worker is notified.
   */
  markOutdated(): void {
    if (this.#run === this.#sentRun) this.#run = ++newestRun;
    this.#listener.onUnsettled();
  }

  /** Starts a run of the changes. */
  startRun(change: RunChange): void {
    this.markOutdated();
    this.#sentRun = this.#run;
    this.send({ kind: 'run', run: this.#run, ...change });
  }

  send(command: Command): void {
    if (this.#isEnded) return;
    this.#post(command);
  }

  /**
   * The promise stays pending if the worker fails; `onLost` reports that. A question about a run is answered with
   * `undefined` once there is a newer run.
   */
  ask<K extends QuestionKind>(about: K, args: Questions[K]['args']): Promise<Answer<K>> {
    return new Promise((resolve) => {
      if (this.#isEnded) return;
      const question: Question<K> = { kind: 'question', id: this.#nextId++, about, args };
      this.#pendingQuestions.set(question.id, { about, resolve: resolve as (answer: never) => void });
      this.#post(question);
    });
  }

  end(): void {
    this.#isEnded = true;
    this.#pendingQuestions.clear();
    this.#connection.close();
  }

  #post(message: Command | Question): void {
    if (mayChangeDisplay(message)) {
      this.#sentCount++;
      this.#listener.onUnsettled();
    }
    this.#connection.send(message);
  }

  #receive(event: SessionEvent): void {
    if (this.#isEnded) {
      if (event.kind === 'pictures') closeImages(event.pictures);
      return;
    }
    switch (event.kind) {
      case 'answer': {
        const pending = this.#pendingQuestions.get(event.id);
        this.#pendingQuestions.delete(event.id);
        if (pending === undefined) return;
        const isOutdated = RUN_DEPENDENT[pending.about] && event.run !== this.#run;
        pending.resolve((isOutdated ? undefined : event.answer) as never);
        return;
      }
      case 'pictures': {
        // While a change was not sent yet, a picture of the last sent run is still shown.
        const dropped = event.run !== this.#sentRun;
        if (dropped) closeImages(event.pictures);
        else this.#listener.onPictures(event.pictures, event.scale);
        this.send({ kind: 'shown', dropped });
        return;
      }
      case 'settled':
        if (event.run === this.#run && event.received === this.#sentCount) this.#listener.onSettled(event.run);
        return;
      // These are about the worker, so they are valid for any run.
      case 'part-failed':
        this.#listener.onEvent(event.run === this.#run ? event : { ...event, neededFor: 'something-else' });
        return;
      case 'parts-loaded':
        this.#listener.onEvent(event);
        return;
      default:
        if (event.run === this.#run) this.#listener.onEvent(event);
    }
  }

  #fail(loss: Loss): void {
    if (this.#isEnded) return;
    this.end();
    this.#listener.onLost(loss);
  }
}

function closeImages(pictures: Pictures): void {
  for (const image of Object.values(pictures)) image.close();
}

/**
 * Asks with the newest value only: while a question is pending, later ones replace each other, so a fast pointer never
 * fills a queue.
 */
export class LatestQuestion<K extends QuestionKind> {
  readonly #client: CoreClient;
  readonly #about: K;
  readonly #onAnswer: (answer: Answer<K>) => void;
  #isPending = false;
  #next: { readonly args: Questions[K]['args'] } | undefined;
  /** The pending answer is to be dropped. */
  #isCancelled = false;

  constructor(client: CoreClient, about: K, onAnswer: (answer: Answer<K>) => void) {
    this.#client = client;
    this.#about = about;
    this.#onAnswer = onAnswer;
  }

  ask(args: Questions[K]['args']): void {
    if (this.#isPending) {
      this.#next = { args };
      this.#isCancelled = false;
      return;
    }
    this.#isPending = true;
    this.#isCancelled = false;
    void this.#client.ask(this.#about, args).then((answer) => {
      const next = this.#next;
      this.#isPending = false;
      this.#next = undefined;
      // Show an answer even if a newer question is waiting: a late value is better than a frozen display.
      if (!this.#isCancelled) this.#onAnswer(answer);
      if (next !== undefined) this.ask(next.args);
    });
  }

  /** Drops the waiting question, and the answer to the pending one. */
  cancel(): void {
    this.#next = undefined;
    this.#isCancelled = true;
  }
}
