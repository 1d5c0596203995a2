// Draws the pictures of one session when they are requested, and sends them to the page.
//
// In: requests, and whether the run can be drawn. Out: images, one at a time: the next one is sent after the page has
// acknowledged the previous one. A picture with very many strokes is drawn in slices. Must not know: runs, or the cause
// of a request.

import { Drawn, type Playground } from '../../pkg/gcode_playground.js';
import { inNextFrame } from './frame';
import type { Pictures } from '../protocol/protocol';
import { drawAll, takePictures } from './pictures';

/** Whether to draw a picture: when the run is complete, or immediately. */
export type DrawRequest = 'no' | 'when-complete' | 'now';

interface DrawingEvents {
  /** Whether the run can be drawn; `blocked`: requests wait. */
  state(): 'blocked' | 'incomplete' | 'complete';
  /** Runs a step between messages. */
  runGuarded(step: () => void): void;
  /** Requests a slice, which calls `draw`. */
  queueSlice(): void;
  onDrawn(): void;
  send(pictures: Pictures): void;
}

export class Drawing {
  readonly #core: Playground;
  readonly #events: DrawingEvents;
  #drawRequest: DrawRequest = 'no';
  #frameRequested = false;
  #isInProgress = false;
  /** The page has not shown the last picture yet. */
  #pictureInFlight = false;

  constructor(core: Playground, events: DrawingEvents) {
    this.#core = core;
    this.#events = events;
  }

  /** Whether a picture is being drawn in slices. */
  get isInProgress(): boolean {
    return this.#isInProgress;
  }

  /** Whether a picture will be drawn or shown. */
  get isBusy(): boolean {
    return (
      this.#isInProgress || (this.#drawRequest !== 'no' && this.#events.state() !== 'blocked') || this.#pictureInFlight
    );
  }

  /** Draws in the next frame. */
  request(request: Exclude<DrawRequest, 'no'>): void {
    if (this.#drawRequest !== 'now') this.#drawRequest = request;
    if (this.#frameRequested) return;
    this.#frameRequested = true;
    inNextFrame(() => {
      this.#frameRequested = false;
      const pendingRequest = this.#drawRequest;
      this.#drawRequest = 'no';
      this.#events.runGuarded(() => {
        const state = this.#events.state();
        if (state === 'blocked') this.#drawRequest = pendingRequest;
        else if (pendingRequest === 'now' || (pendingRequest === 'when-complete' && state === 'complete')) this.draw();
      });
    });
  }

  /** Drops requests and slices, which belong to an earlier run. */
  cancel(): void {
    this.#isInProgress = false;
    this.#drawRequest = 'no';
  }

  /** Draws now, or the next slice. */
  draw(): void {
    const drawn = drawAll(this.#core);
    this.#isInProgress = drawn === Drawn.Part;
    this.#events.onDrawn();
    if (this.#isInProgress) this.#events.queueSlice();
    if (drawn === Drawn.Moved) this.request('now');
    this.#sendPictures();
  }

  /** The page has shown the last pictures. */
  onShown(): void {
    this.#pictureInFlight = false;
    this.#sendPictures();
  }

  /** The page has dropped the last pictures, which belong to an earlier run. */
  onDropped(): void {
    this.#pictureInFlight = false;
    // Paint again: if nothing has changed since, no other picture would follow the dropped one.
    this.#core.paintAgain();
  }

  /** Sends the painted images, unless the page has not shown the last ones yet. */
  #sendPictures(): void {
    if (this.#pictureInFlight) return;
    const pictures = takePictures(this.#core);
    if (pictures === undefined) return;
    this.#pictureInFlight = true;
    this.#events.send(pictures);
  }
}
