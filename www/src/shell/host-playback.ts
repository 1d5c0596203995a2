// The playback, as the page around the element sees it.
//
// In: that the playback begins or ends, and the position of the tool. Out: the properties `playing` and `readout`, and
// the events `gcode-play`, `gcode-pause` and `gcode-step`, which report every change, also one by a method of the
// element, as in `<video>`. Must not know: how the tool moves.

import type { Program } from '../editor/program';
import type { Readout } from '../protocol/protocol';
import { readoutInFile } from './file-offsets';
import { deepFreeze } from './frozen';

interface HostPlaybackOptions {
  readonly editor: Program;
  fire<Detail>(type: string, detail: Detail): void;
}

export class HostPlayback {
  readonly #options: HostPlaybackOptions;
  #isPlaying = false;
  /** Where the tool is; undefined: the whole path is shown. */
  #place: Readout | undefined;

  constructor(options: HostPlaybackOptions) {
    this.#options = options;
  }

  get playing(): boolean {
    return this.#isPlaying;
  }

  /** The position of the tool, with offsets into `opened.text`; undefined if the whole path is shown. */
  get readout(): Readout | undefined {
    return this.#place && deepFreeze(readoutInFile(this.#place, this.#options.editor));
  }

  onPlaying(state: 'playing' | 'paused'): void {
    const isPlaying = state === 'playing';
    if (isPlaying === this.#isPlaying) return;
    this.#isPlaying = isPlaying;
    this.#fire(isPlaying ? 'gcode-play' : 'gcode-pause');
  }

  onToolMoved(place: Readout | undefined): void {
    const before = this.#place;
    this.#place = place;
    if (this.#isStep(before, place)) this.#fire('gcode-step');
  }

  /** Text or setup have changed: the tool is nowhere until the new path exists. */
  onInputChanged(): void {
    this.#place = undefined;
  }

  /** Whether the move is reported: while it plays, only the next motion. */
  #isStep(before: Readout | undefined, now: Readout | undefined): boolean {
    if (before === undefined || now === undefined) return before !== now;
    return before.stroke.motion !== now.stroke.motion || (!this.#isPlaying && before.share !== now.share);
  }

  #fire(type: string): void {
    this.#options.fire(type, { readout: this.readout });
  }
}
