// Moves the tool while the path is played: each painted frame asks how far it has moved. While paused, nothing runs.
//
// In: start and stop. Out: questions with the time since the last one, and the answers to the current playback. Must
// not know: the controls, or why the playback pauses.

import type { PlayResult } from '../protocol/protocol';

/** Maximum time between two frames that is played, seconds; exceeded if the page was hidden or the computer slept. */
const MAX_FRAME_S = 0.5;

/** Where a playback starts: at the position of the tool, or at the start of the program. */
export type StartFrom = 'here' | 'start';

interface PlayerEvents {
  /** Plays this many seconds. */
  play(from: StartFrom, seconds: number): Promise<PlayResult | undefined>;
  /** An answer to the current playback. */
  onPlayed(played: PlayResult | undefined): void;
}

export class Player {
  readonly #events: PlayerEvents;
  /** The requested animation frame; undefined while paused. */
  #frame: number | undefined;
  /** Whether an answer is pending. */
  #isAsking = false;
  #lastFrame: number | undefined;
  /** Seconds since the last question. */
  #elapsed = 0;
  #startFrom: StartFrom = 'here';
  /** Number of the current playback; answers to an earlier one are ignored. */
  #playId = 0;

  constructor(events: PlayerEvents) {
    this.#events = events;
  }

  get isPlaying(): boolean {
    return this.#frame !== undefined;
  }

  start(from: StartFrom): void {
    this.#startFrom = from;
    this.#lastFrame = undefined;
    this.#elapsed = 0;
    this.#isAsking = false;
    this.#playId++;
    this.#frame = requestAnimationFrame(this.#tick);
  }

  /** Returns whether it was playing. */
  stop(): boolean {
    if (this.#frame === undefined) return false;
    cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#playId++;
    return true;
  }

  #tick = (now: number): void => {
    const elapsed = this.#lastFrame === undefined ? 0 : (now - this.#lastFrame) / 1000;
    this.#lastFrame = now;
    this.#elapsed += Math.min(elapsed, MAX_FRAME_S);
    this.#frame = requestAnimationFrame(this.#tick);
    // One question at a time: if the interpreter is slow, the tool moves in larger steps.
    if (this.#isAsking || this.#elapsed === 0) return;
    this.#isAsking = true;
    const playId = this.#playId;
    const answer = this.#events.play(this.#startFrom, this.#elapsed);
    [this.#startFrom, this.#elapsed] = ['here', 0];
    void answer.then((played) => {
      if (playId !== this.#playId) return;
      this.#isAsking = false;
      this.#events.onPlayed(played);
    });
  };
}
