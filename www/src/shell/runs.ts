// The runs of the program: what has changed since the last one was begun, and the line to the worker.
//
// In: changes of text and setup. Out: what the worker reports of the newest run. What is changed in one go is
// run in one go; what is typed quickly goes together. A worker that is lost is replaced. Must not know:
// panels, attributes, or what a setup holds.

import type { Program } from '../editor/program';
import type { Answer, Came, Pictures, QuestionKind, Questions } from '../protocol/protocol';
import { CoreClient, Newest, type CoreListener, type Heard, type Loss } from '../worker/core-client';
import type { NewestQuestion } from '../panels/panel';

/** A loss that the reader hears of: not that of a neighbour. */
export type OwnLoss = Exclude<Loss, { readonly kind: 'neighbour' }>;

const SEND_AFTER_MS = 30;

export interface RunsEvents {
  /** The setup as JSON; nothing where it cannot be read. */
  setup(): string | undefined;
  heard(event: Heard): void;
  pictures(pictures: Pictures): void;
  /** Text or setup have changed; the run before is outdated. */
  outdated(): void;
  /** A run of another text begins at the end of this turn. */
  textChanged(): void;
  /** A run is wanted, whether or not there is a worker. */
  wanted(): void;
  /** The newest run is under way. */
  begun(): void;
  /** What was typed has been sent. */
  sent(): void;
  /** The worker has loaded the interpreter. */
  ready(): void;
  /** There is a worker that knows nothing yet. */
  connected(client: CoreClient): void;
  lost(loss: OwnLoss): void;
  unsettled(): void;
  settled(run: number): void;
}

export class Runs {
  readonly #editor: Program;
  readonly #events: RunsEvents;
  #client: CoreClient | undefined;
  /** What follows a new worker: the questions of which only the newest counts. */
  readonly #followers: ((client: CoreClient | undefined) => void)[] = [];
  /** The worker was lost by a program of this element; it does not come between others again. */
  #hasFailed = false;
  /** What was typed waits to be sent. */
  #sending: ReturnType<typeof setTimeout> | undefined;
  /** What has changed since the last run was begun. */
  #changes: { readonly framing: 'fit' | 'keep' } | undefined;
  /** The worker before was lost by the program as it is, which only another change runs. */
  #waits = false;
  /** The worker knows the setup as it is. */
  #setupSent = false;
  /** How the newest change of the text came. */
  #came: Came = 'typed';
  /** The reader has put the cursor where it is. */
  #cursorKnown = false;
  /** How the text that is sent next is looked at. */
  #framing: 'fit' | 'keep' = 'keep';

  constructor(editor: Program, events: RunsEvents) {
    this.#editor = editor;
    this.#events = events;
  }

  // ---- the worker ---------------------------------------------------------------------------------

  /** The line to the worker, which then knows all that was changed before. */
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

  /** After a loss: the program is run in a new worker, unless a change has begun that already. */
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

  /** A new worker waits for the reader's next change: the same text would only fail again. */
  #lost(loss: Loss): void {
    if (loss.kind === 'neighbour') {
      // The fault was not here: the reader sees nothing of it but a new picture.
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

  /** The reader has typed: a run begins soon. */
  typed(): void {
    this.#cursorKnown = true;
    // What comes of the text as it was is of no use from here on.
    this.#outdate();
    clearTimeout(this.#sending);
    this.#sending = setTimeout(() => this.send(), SEND_AFTER_MS);
  }

  /** What was typed a moment ago is run now. */
  flush(): void {
    if (this.#sending !== undefined) this.send();
  }

  /** The text as it is, is run now. */
  send(): void {
    const framing = this.#framing;
    this.#framing = 'keep';
    this.textChanged(framing);
    this.#begin();
    this.#events.sent();
  }

  /** The text is another one: at the end of this turn a run of it begins. */
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
    // Also where changes wait already: there may have been no worker for them.
    queueMicrotask(() => this.#begin());
    this.#events.wanted();
  }

  cameAtOnce(): void {
    this.#came = 'at-once';
  }

  /** What is sent next is another program: nothing that was concluded of the one before holds for it. */
  anotherProgram(): void {
    this.#came = 'at-once';
    this.#framing = 'fit';
  }

  /** Another text has taken the place of the one that the cursor was put into. */
  forgetCursor(): void {
    this.#cursorKnown = false;
  }

  cursorMoved(): void {
    this.#cursorKnown = true;
    if (this.#sending === undefined) this.client?.send({ kind: 'cursor', offset: this.#editor.cursor });
  }

  /** The reader has chosen a place of the text by other means. */
  cursorAt(offset: number): void {
    this.#cursorKnown = true;
    this.client?.send({ kind: 'cursor', offset });
  }

  /** What belongs to the run that was shown must not meet the text or the setup of now. */
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
    // While an edit waits to be sent, the worker would colour older text.
    if (client === undefined || this.#sending !== undefined) return;
    const lines = editor.linesInSight;
    if (lines === undefined) return;
    const { revision } = editor;
    const tokens = await client.ask('tokens', lines);
    if (tokens !== undefined && editor.revision === revision) editor.tokens = tokens;
  }
}
