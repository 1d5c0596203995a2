// Starts runs of the program and holds the connection to the worker.
//
// In: changes of text and setup. Out: the events of the newest run. Changes in one turn start one run; quick typing is
// collected. A worker that has failed is replaced. Must not know: panels, attributes, or the content of a setup.

import type { Program } from '../editor/program';
import type { Answer, ChangeSource, Pictures, QuestionKind, Questions, SectionScale } from '../protocol/protocol';
import { CoreClient, LatestQuestion, type CoreListener, type CoreEvent, type Loss } from '../worker/core-client';
import type { NewestQuestion } from '../panels/panel';

/** A failure that is reported to the user; one that another element caused is not. */
export type ReportedLoss = Exclude<Loss, { readonly kind: 'other-session' }>;

const SEND_AFTER_MS = 30;

interface RunsEvents {
  /** The setup as JSON; undefined if it is invalid. */
  setup(): string | undefined;
  onEvent(event: CoreEvent): void;
  onPictures(pictures: Pictures, scale: SectionScale): void;
  /** Text or setup have changed; the last run is outdated. */
  onInputChanged(): void;
  /** A run of a changed text starts at the end of this turn. */
  onTextChanged(): void;
  /** A run is requested, whether or not there is a worker. */
  onRunRequested(): void;
  /** The newest run has started. */
  onRunStarted(): void;
  /** Pending edits were sent. */
  onSent(): void;
  /** The worker has loaded the interpreter. */
  onReady(): void;
  /** A new worker without any state is connected. */
  onConnected(client: CoreClient): void;
  onLost(loss: ReportedLoss): void;
  onUnsettled(): void;
  onSettled(run: number): void;
}

export class Runs {
  readonly #editor: Program;
  readonly #events: RunsEvents;
  #client: CoreClient | undefined;
  /** Called with each new client, to update the `NewestQuestion`s. */
  readonly #clientListeners: ((client: CoreClient | undefined) => void)[] = [];
  /** A program of this element has made a worker fail; the element then does not share a worker again. */
  #hasFailed = false;
  /** Pending edits wait for this timer. */
  #sendTimer: ReturnType<typeof setTimeout> | undefined;
  /** The changes since the last run started. */
  #changes: { readonly framing: 'fit' | 'keep' } | undefined;
  /** The current program has made the last worker fail: only another change starts a run. */
  #waitsForChange = false;
  /** The worker has the current setup. */
  #setupSent = false;
  /** How the last change of the text was made. */
  #changeSource: ChangeSource = 'typed';
  /** The user has placed the cursor. */
  #isCursorPlaced = false;
  /** The framing of the picture for the next sent text. */
  #framing: 'fit' | 'keep' = 'keep';

  constructor(editor: Program, events: RunsEvents) {
    this.#editor = editor;
    this.#events = events;
  }

  // ---- the worker ---------------------------------------------------------------------------------

  /** The client of the worker, after pending changes were sent. */
  get client(): CoreClient | undefined {
    this.#startRun();
    return this.#client;
  }

  connect(): void {
    const events = this.#events;
    const listener: CoreListener = {
      onReady: () => events.onReady(),
      onEvent: (event) => events.onEvent(event),
      onPictures: (pictures, scale) => events.onPictures(pictures, scale),
      onUnsettled: () => events.onUnsettled(),
      onSettled: (run) => events.onSettled(run),
      onLost: (loss) => this.#onWorkerLost(loss),
    };
    const client = (this.#client = new CoreClient(listener, this.#hasFailed ? 'separate' : 'shared'));
    for (const update of this.#clientListeners) update(client);
    this.#editor.markAllUnsent();
    this.#setupSent = false;
    events.onConnected(client);
  }

  /** After a failure: runs the program in a new worker, unless a change has already done so. */
  restart(): void {
    if (this.#client === undefined) this.connect();
    else if (!this.#waitsForChange) return;
    this.requestRun('keep');
  }

  end(): void {
    this.#client?.end();
    this.#dropClient();
  }

  newest<K extends QuestionKind>(about: K, onAnswer: (answer: Answer<K>) => void): NewestQuestion<K> {
    let newest: LatestQuestion<K> | undefined;
    const update = (client: CoreClient | undefined): void => {
      newest = client === undefined ? undefined : new LatestQuestion(client, about, onAnswer);
    };
    this.#clientListeners.push(update);
    update(this.#client);
    return { ask: (ask: Questions[K]['args']) => newest?.ask(ask), cancel: () => newest?.cancel() };
  }

  #dropClient(): void {
    this.#client = undefined;
    for (const update of this.#clientListeners) update(undefined);
  }

  /** Replaces the worker. It waits for the user's next change, since the same text would only fail again. */
  #onWorkerLost(loss: Loss): void {
    if (loss.kind === 'other-session') {
      // The user notices nothing: another element caused the failure.
      this.connect();
      this.requestRun('keep');
      return;
    }
    if (loss.kind === 'load-failed') this.#dropClient();
    else {
      this.#hasFailed = this.#waitsForChange = true;
      this.connect();
    }
    this.#events.onLost(loss);
  }

  // ---- changes ------------------------------------------------------------------------------------

  /** The user has typed: a run starts soon. */
  onTyped(): void {
    this.#isCursorPlaced = true;
    // Results for the old text are useless from now on.
    this.#markOutdated();
    clearTimeout(this.#sendTimer);
    this.#sendTimer = setTimeout(() => this.send(), SEND_AFTER_MS);
  }

  /** Runs pending edits now. */
  flush(): void {
    if (this.#sendTimer !== undefined) this.send();
  }

  /** Runs the current text now. */
  send(): void {
    const framing = this.#framing;
    this.#framing = 'keep';
    this.textChanged(framing);
    this.#startRun();
    this.#events.onSent();
  }

  /** The text has changed: a run starts at the end of this turn. */
  textChanged(framing: 'fit' | 'keep'): void {
    clearTimeout(this.#sendTimer);
    this.#sendTimer = undefined;
    this.requestRun(framing);
    this.#events.onTextChanged();
  }

  setupChanged(): void {
    this.#setupSent = false;
    this.requestRun('keep');
  }

  requestRun(framing: 'fit' | 'keep'): void {
    this.#changes = { framing: this.#changes?.framing === 'fit' ? 'fit' : framing };
    this.#markOutdated();
    // Needed even if changes are pending: there may have been no worker for them.
    queueMicrotask(() => this.#startRun());
    this.#events.onRunRequested();
  }

  markAsInserted(): void {
    this.#changeSource = 'inserted';
  }

  /** The next text is another program: no assumption about the last one applies to it. */
  onProgramReplaced(): void {
    this.#changeSource = 'inserted';
    this.#framing = 'fit';
  }

  /** The text in which the cursor was placed has been replaced. */
  resetCursor(): void {
    this.#isCursorPlaced = false;
  }

  cursorMoved(): void {
    this.#isCursorPlaced = true;
    if (this.#sendTimer === undefined) this.client?.send({ kind: 'cursor', offset: this.#editor.cursor });
  }

  /** The user has selected a position of the text by other means than the cursor. */
  setCursor(offset: number): void {
    this.#isCursorPlaced = true;
    this.client?.send({ kind: 'cursor', offset });
  }

  /** Results of the last run must not be combined with the current text or setup. */
  #markOutdated(): void {
    this.#client?.markOutdated();
    this.#events.onInputChanged();
  }

  #startRun(): void {
    const [changes, client, editor] = [this.#changes, this.#client, this.#editor];
    if (changes === undefined || client === undefined) return;
    this.#changes = undefined;
    this.#waitsForChange = false;
    const setup = this.#setupSent ? undefined : this.#events.setup();
    this.#setupSent = true;
    const text = editor.takeUnsent();
    const changeSource = this.#changeSource;
    this.#changeSource = 'typed';
    client.startRun({
      setup,
      text,
      tried: editor.tried,
      changeSource,
      framing: changes.framing,
      cursor: this.#isCursorPlaced ? editor.cursor : undefined,
    });
    this.#events.onRunStarted();
    if (text !== undefined) void this.askTokens();
  }

  async askTokens(): Promise<void> {
    const [client, editor] = [this.#client, this.#editor];
    // While an edit is pending, the worker would return tokens of an older text.
    if (client === undefined || this.#sendTimer !== undefined) return;
    const lines = editor.visibleLines;
    if (lines === undefined) return;
    const { revision } = editor;
    const tokens = await client.ask('tokens', lines);
    if (tokens !== undefined && editor.revision === revision) editor.tokens = tokens;
  }
}
