// An action of the user that waits for the path of the current text.
//
// In: changes of text and setup, paths, actions. Out: the call of the action. Must not know: the effect of an action.

interface Action {
  readonly act: () => void;
  /** Whether the action starts the playback. */
  readonly startsPlayback: boolean;
}

export class PendingAction {
  /** Number of changes of text and setup. */
  #revision = 0;
  /** The revision that the current path belongs to. */
  #pathRevision = -1;
  #pending: Action | undefined;

  get revision(): number {
    return this.#revision;
  }

  /** Whether the pending action will start the playback. */
  get startsPlayback(): boolean {
    return this.#pending?.startsPlayback === true;
  }

  onInputChanged(): void {
    this.#revision++;
  }

  /** Acts now if the current text has its path, otherwise as soon as it has. Returns whether the action is pending. */
  whenPathReady(action: Action): boolean {
    if (this.#pathRevision === this.#revision) {
      action.act();
      return false;
    }
    this.#pending = action;
    return true;
  }

  /** The path of the current text exists. */
  onPathReady(): void {
    this.#pathRevision = this.#revision;
    const pending = this.#pending;
    this.#pending = undefined;
    pending?.act();
  }

  /** Returns whether an action was pending. */
  drop(): boolean {
    const wasPending = this.#pending !== undefined;
    this.#pending = undefined;
    return wasPending;
  }
}
