// The page's end of the line to the worker.
//
// In: commands and typed questions. Out: the worker's events, and promises of answers. Watches that the
// worker answers at all; one that is silent for 15 s, or has failed, is ended and reported as lost.
// Must not know: what the commands mean, or what is on the page.

import type { Command, Question, QuestionKind, Questions, WorkerEvent } from './protocol';

const SILENCE_LIMIT_MS = 15_000;
/** After the computer slept the timer may ring before the answer that is already there is read. */
const GRACE_MS = 1_000;

export type Loss = { readonly kind: 'silent' } | { readonly kind: 'crashed' | 'load-failed'; readonly reason: string };

export interface CoreListener {
  event(event: WorkerEvent): void;
  /** The worker is gone; nothing sent to this client is answered any more. */
  lost(loss: Loss): void;
}

export class CoreClient {
  readonly #worker: Worker;
  readonly #listener: CoreListener;
  readonly #waiting = new Map<number, (answer: never) => void>();
  #nextId = 1;
  #ready = false;
  #ended = false;
  #watch: ReturnType<typeof setTimeout> | undefined;

  constructor(listener: CoreListener) {
    this.#listener = listener;
    this.#worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    this.#worker.onmessage = (message: MessageEvent<WorkerEvent>) => this.#receive(message.data);
    this.#worker.onerror = (error) => this.#lose({ kind: 'load-failed', reason: error.message || 'worker' });
  }

  send(command: Command): void {
    if (this.#ended) return;
    const what = command.kind === 'on-face' ? command.what : command;
    this.#worker.postMessage(command, what.kind === 'canvas' ? [what.canvas] : []);
    this.#watchOver();
  }

  /** The promise stays open for ever when the worker is lost: whoever waits is told by `lost`. */
  ask<K extends QuestionKind>(about: K, ask: Questions[K]['ask']): Promise<Questions[K]['answer']> {
    return new Promise((resolve) => {
      if (this.#ended) return;
      const question: Question<K> = { kind: 'question', id: this.#nextId++, about, ask };
      this.#waiting.set(question.id, resolve as (answer: never) => void);
      this.#worker.postMessage(question);
      if (about !== 'ping') this.#watchOver();
    });
  }

  end(): void {
    this.#ended = true;
    clearTimeout(this.#watch);
    this.#waiting.clear();
    this.#worker.terminate();
  }

  #receive(event: WorkerEvent): void {
    if (this.#ended) return;
    switch (event.kind) {
      case 'answer':
        this.#waiting.get(event.id)?.(event.answer as never);
        this.#waiting.delete(event.id);
        return;
      case 'crashed':
      case 'load-failed':
        this.#lose({ kind: event.kind, reason: event.reason });
        return;
      case 'ready':
        this.#ready = true;
        this.#watchOver();
        break;
      default:
        break;
    }
    this.#listener.event(event);
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

/**
 * Asks with the newest value only: while one question is under way, later ones replace each other,
 * so a fast pointer never builds a queue.
 */
export class Newest<K extends QuestionKind> {
  readonly #client: CoreClient;
  readonly #about: K;
  readonly #answered: (answer: Questions[K]['answer']) => void;
  #busy = false;
  #next: { readonly ask: Questions[K]['ask'] } | undefined;

  constructor(client: CoreClient, about: K, answered: (answer: Questions[K]['answer']) => void) {
    this.#client = client;
    this.#about = about;
    this.#answered = answered;
  }

  ask(ask: Questions[K]['ask']): void {
    if (this.#busy) {
      this.#next = { ask };
      return;
    }
    this.#busy = true;
    void this.#client.ask(this.#about, ask).then((answer) => {
      const next = this.#next;
      this.#busy = false;
      this.#next = undefined;
      // An answer that a newer question has overtaken is still shown: better a little late than frozen.
      this.#answered(answer);
      if (next !== undefined) this.ask(next.ask);
    });
  }

  /** Drops a question that has not been sent yet. */
  forget(): void {
    this.#next = undefined;
  }
}
