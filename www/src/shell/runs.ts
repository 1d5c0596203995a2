// Starts runs of the program and holds the connection to the worker.
//
// In: changes of text and setup. Out: the events of the newest run. Changes in one turn start one run; quick typing is
// collected. A worker that has failed is replaced. Must not know: panels, attributes, or the content of a setup.

import type { Program } from '../editor/program';
import type { Answer, Came, Pictures, QuestionKind, Questions } from '../protocol/protocol';
import { CoreClient, Newest, type CoreListener, type Heard, type Loss } from '../worker/core-client';
import type { NewestQuestion } from '../panels/panel';

/** A failure that is reported to the user; one that another element caused is not. */
export type OwnLoss = Exclude<Loss, { readonly kind: 'neighbour' }>;

const SEND_AFTER_MS = 30;

export interface RunsEvents {
  /** The setup as JSON; undefined if it is invalid. */
  setup(): string | undefined;
  heard(event: Heard): void;
  pictures(pictures: Pictures): void;
  /** Text or setup have changed; the last run is outdated. */
  outdated(): void;
  /** A run of a changed text starts at the end of this turn. */
  textChanged(): void;
  /** A run is requested, whether or not there is a worker. */
  wanted(): void;
  /** The newest run has started. */
  begun(): void;
  /** Pending edits were sent. */
  sent(): void;
  /** The worker has loaded the interpreter. */
  ready(): void;
  /** A new worker without any state is connected. */
  connected(client: CoreClient): void;
  lost(loss: OwnLoss): void;
  unsettled(): void;
  settled(run: number): void;
}

export class Runs {
  readonly #editor: Program;
  readonly #events: RunsEvents;
  #client: CoreClient | undefined;
  /** Called with each new client, to update the `NewestQuestion`s. */
  readonly #followers: ((client: CoreClient | undefined) => void)[] = [];
  /** A program of this element has made a worker fail; the element then does not share a worker again. */
  #hasFailed = false;
  /** Pending edits wait for this timer. */
  #sending: ReturnType<typeof setTimeout> | undefined;
  /** The changes since the last run started. */
  #changes: { readonly framing: 'fit' | 'keep' } | undefined;
  /** The current program has made the last worker fail: only another change starts a run. */
  #waits = false;
  /** The worker has the current setup. */
  #setupSent = false;
  /** How the last change of the text was made. */
  #came: Came = 'typed';
  /** The user has placed the cursor. */
  #cursorKnown = false;
  /** The framing of the picture for the next sent text. */
  #framing: 'fit' | 'keep' = 'keep';

  constructor(editor: Program, events: RunsEvents) {
    this.#editor = editor;
    this.#events = events;
  }

  // ---- the worker ---------------------------------------------------------------------------------

  /** The client of the worker, after pending changes were sent. */
  get client(): CoreClient | undefined {
    this.#begin();
    return this.#client;
  }

  connect(): void {
    const events = this.#events;
    const listener: CoreListener = {
      ready: () => events.ready(),
      event: (event) => events.heard(event),
      pictures: (pictures) => events.pictures(pictures),
      unsettled: () => events.unsettled(),
      settled: (run) => events.settled(run),
      lost: (loss) => this.#lost(loss),
    };
    const client = (this.#client = new CoreClient(listener, this.#hasFailed ? 'apart' : 'with-others'));
    for (const follow of this.#followers) follow(client);
    this.#editor.unsend();
    this.#setupSent = false;
    events.connected(client);
  }

  /** After a failure: runs the program in a new worker, unless a change has already done so. */
  again(): void {
    if (this.#client === undefined) this.connect();
    else if (!this.#waits) return;
    this.wanted('keep');
  }

  end(): void {
    this.#client?.end();
    this.#leave();
  }

  newest<K extends QuestionKind>(about: K, answered: (answer: Answer<K>) => void): NewestQuestion<K> {
    let newest: Newest<K> | undefined;
    const follow = (client: CoreClient | undefined): void => {
      newest = client === undefined ? undefined : new Newest(client, about, answered);
    };
    this.#followers.push(follow);
    follow(this.#client);
    return { ask: (ask: Questions[K]['ask']) => newest?.ask(ask), forget: () => newest?.forget() };
  }

  #leave(): void {
    this.#client = undefined;
    for (const follow of this.#followers) follow(undefined);
  }

  /** Replaces the worker. It waits for the user's next change, since the same text would only fail again. */
  #lost(loss: Loss): void {
    if (loss.kind === 'neighbour') {
      // The user notices nothing: another element caused the failure.
      this.connect();
      this.wanted('keep');
      return;
    }
    if (loss.kind === 'load-failed') this.#leave();
    else {
      this.#hasFailed = this.#waits = true;
      this.connect();
    }
    this.#events.lost(loss);
  }

  // ---- changes ------------------------------------------------------------------------------------

  /** The user has typed: a run starts soon. */
  typed(): void {
    this.#cursorKnown = true;
    // Results for the old text are useless from now on.
    this.#outdate();
    clearTimeout(this.#sending);
    this.#sending = setTimeout(() => this.send(), SEND_AFTER_MS);
  }

  /** Runs pending edits now. */
  flush(): void {
    if (this.#sending !== undefined) this.send();
  }

  /** Runs the current text now. */
  send(): void {
    const framing = this.#framing;
    this.#framing = 'keep';
    this.textChanged(framing);
    this.#begin();
    this.#events.sent();
  }

  /** The text has changed: a run starts at the end of this turn. */
  textChanged(framing: 'fit' | 'keep'): void {
    clearTimeout(this.#sending);
    this.#sending = undefined;
    this.wanted(framing);
    this.#events.textChanged();
  }

  setupChanged(): void {
    this.#setupSent = false;
    this.wanted('keep');
  }

  wanted(framing: 'fit' | 'keep'): void {
    this.#changes = { framing: this.#changes?.framing === 'fit' ? 'fit' : framing };
    this.#outdate();
    // Needed even if changes are pending: there may have been no worker for them.
    queueMicrotask(() => this.#begin());
    this.#events.wanted();
  }

  cameAtOnce(): void {
    this.#came = 'at-once';
  }

  /** The next text is another program: no assumption about the last one applies to it. */
  anotherProgram(): void {
    this.#came = 'at-once';
    this.#framing = 'fit';
  }

  /** The text in which the cursor was placed has been replaced. */
  forgetCursor(): void {
    this.#cursorKnown = false;
  }

  cursorMoved(): void {
    this.#cursorKnown = true;
    if (this.#sending === undefined) this.client?.send({ kind: 'cursor', offset: this.#editor.cursor });
  }

  /** The user has selected a position of the text by other means than the cursor. */
  cursorAt(offset: number): void {
    this.#cursorKnown = true;
    this.client?.send({ kind: 'cursor', offset });
  }

  /** Results of the last run must not be combined with the current text or setup. */
  #outdate(): void {
    this.#client?.outdate();
    this.#events.outdated();
  }

  #begin(): void {
    const [changes, client, editor] = [this.#changes, this.#client, this.#editor];
    if (changes === undefined || client === undefined) return;
    this.#changes = undefined;
    this.#waits = false;
    const setup = this.#setupSent ? undefined : this.#events.setup();
    this.#setupSent = true;
    const text = editor.takeUnsent();
    const came = this.#came;
    this.#came = 'typed';
    client.begin({
      setup,
      text,
      tried: editor.tried,
      came,
      framing: changes.framing,
      cursor: this.#cursorKnown ? editor.cursor : undefined,
    });
    this.#events.begun();
    if (text !== undefined) void this.askTokens();
  }

  async askTokens(): Promise<void> {
    const [client, editor] = [this.#client, this.#editor];
    // While an edit is pending, the worker would return tokens of an older text.
    if (client === undefined || this.#sending !== undefined) return;
    const lines = editor.linesInSight;
    if (lines === undefined) return;
    const { revision } = editor;
    const tokens = await client.ask('tokens', lines);
    if (tokens !== undefined && editor.revision === revision) editor.tokens = tokens;
  }
}
