// The bar under the drawing: play, step, scrub, speed, stops, and what is read off where the tool is.
//
// In: whether there is anything to play and, as answers, where the tool is. Out: `play`, `seek`, `step` and `wholePath`.
// While it plays, each painted frame asks how far the tool has come; while it is paused nothing runs.
// Must not know: how the path is drawn, or what a stroke means.

import { icon, make, name, unbroken } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { Pace, Readout, StepDirection, StepUnit, StopSwitch } from '../protocol/protocol';
import { millimetres, ReadoutBoard } from './readout';

/** Seconds in which the whole program is shown, the first one unless another is chosen. */
const WHOLE: readonly number[] = [20, 60];
/** Times the pace of the machine. */
const SPEEDS: readonly number[] = [0.5, 1, 2, 5, 10, 50];
const UNITS: readonly StepUnit[] = ['motion', 'block', 'pass'];
/** A frame that took longer, s, was no frame: the page was hidden, or the computer slept. */
const LONGEST_FRAME = 0.5;

export interface PlaybackEvents {
  /** On for so many seconds; `start` begins the program anew. */
  play(from: 'here' | 'start', seconds: number, pace: Pace, stops: StopSwitch): Promise<Readout | undefined>;
  seek(share: number): void;
  step(unit: StepUnit, direction: StepDirection): void;
  wholePath(): void;
}

export class Playback {
  readonly element: HTMLElement;
  readonly #events: PlaybackEvents;
  readonly #play = make('button', { type: 'button', className: 'play', part: 'play' });
  readonly #playIcon = make('span', { className: 'play-icon' });
  readonly #playText = make('span', { className: 'play-text' });
  readonly #back = make('button', { type: 'button', className: 'quiet' }, icon('previous'));
  readonly #forward = make('button', { type: 'button', className: 'quiet' }, icon('next'));
  readonly #unit = make('select', { className: 'speed unit' });
  readonly #whole = make('button', { type: 'button', className: 'quiet' }, icon('whole'));
  readonly #slider = make('input', { type: 'range', min: '0', max: '1', step: 'any', value: '0', className: 'scrub' });
  readonly #speed = make('select', { className: 'speed' });
  readonly #optional = make('button', { type: 'button', className: 'level optional', 'aria-pressed': 'true', hidden: true }, 'M01');
  readonly #doing = make('p', { className: 'doing', part: 'doing', 'aria-live': 'polite' });
  readonly #board: ReadoutBoard;
  readonly #wholeOptions = WHOLE.map((seconds) => make('option', { value: `whole ${seconds}` }));
  #strings: Strings;
  #place: Readout | undefined;
  /** Painting: the next frame; asking: the tool is under way. */
  #frame: number | undefined;
  #asking = false;
  #lastFrame: number | undefined;
  /** Seconds since the last answer was asked for. */
  #elapsed = 0;
  #from: 'here' | 'start' = 'here';
  /** Counts what has been played, so that an answer can be too late. */
  #take = 0;
  #doingShown = '';

  constructor(strings: Strings, events: PlaybackEvents) {
    this.#strings = strings;
    this.#events = events;
    this.#board = new ReadoutBoard(strings);
    this.#play.append(this.#playIcon, this.#playText);
    this.#speed.append(...this.#wholeOptions, ...SPEEDS.map((speed) => make('option', { value: `times ${speed}` }, `${speed}×`)));
    this.#unit.append(...UNITS.map((unit) => make('option', { value: unit })));
    this.element = make(
      'div',
      { className: 'playback', part: 'playback', role: 'group' },
      make('div', { className: 'buttons' }, this.#back, this.#play, this.#forward),
      this.#unit,
      this.#slider,
      make('div', { className: 'place' }, this.#optional, this.#speed, this.#whole),
      this.#board.element,
      this.#doing,
    );
    this.#play.addEventListener('click', () => this.toggle());
    this.#back.addEventListener('click', () => this.step(this.#chosenUnit, 'previous'));
    this.#forward.addEventListener('click', () => this.step(this.#chosenUnit, 'next'));
    this.#unit.addEventListener('change', () => this.#nameSteps());
    this.#whole.addEventListener('click', () => this.showWholePath());
    this.#slider.addEventListener('input', () => this.#scrub());
    this.#optional.addEventListener('click', () => {
      this.#optional.setAttribute('aria-pressed', String(this.#stops === 'not-optional'));
    });
    this.strings = strings;
    this.place = undefined;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    const words = strings.playing;
    this.element.setAttribute('aria-label', strings.playback);
    for (const [i, option] of this.#wholeOptions.entries()) option.textContent = words.wholeIn(WHOLE[i] ?? 0);
    for (const option of this.#unit.options) option.textContent = words.units[option.value as StepUnit];
    this.#unit.setAttribute('aria-label', words.stepBy);
    this.#unit.title = words.stepBy;
    name(this.#optional, words.optionalStops);
    this.#optional.title = words.optionalStopsHint;
    name(this.#whole, strings.wholePath);
    this.#slider.setAttribute('aria-label', strings.position);
    this.#speed.setAttribute('aria-label', strings.speed);
    this.#speed.title = strings.speed;
    this.#board.strings = strings;
    this.#nameSteps();
    this.#showPlaying();
  }

  /** Another path has been drawn, of so many motions, with so many stops that can be passed over. */
  program(motions: number, optionalStops: number): void {
    this.#stop();
    for (const control of [this.#play, this.#back, this.#forward, this.#slider]) control.disabled = motions <= 0;
    this.#optional.hidden = optionalStops <= 0;
    this.place = undefined;
  }

  /** Where the tool is now. */
  set place(place: Readout | undefined) {
    this.#place = place;
    // While it is dragged, the hand says where the slider is, not an answer to where it was.
    if (!this.#slider.matches(':active')) this.#slider.value = String(place?.share ?? 0);
    this.#board.shown = place;
    this.#whole.hidden = place === undefined;
    this.#showDoing();
    // What is read aloud while it plays would never come to an end.
    if (this.playing) return;
    const stroke = place?.stroke;
    const spoken =
      stroke === undefined ? '–' : this.#strings.positionText(millimetres(stroke.atX), millimetres(stroke.atZ));
    this.#slider.setAttribute('aria-valuetext', spoken);
  }

  get place(): Readout | undefined {
    return this.#place;
  }

  get playing(): boolean {
    return this.#frame !== undefined;
  }

  toggle(): void {
    if (this.playing) this.#stop();
    else this.play();
  }

  play(): void {
    if (this.playing || this.#play.disabled) return;
    this.#from = this.#place === undefined || this.#place.share >= 1 ? 'start' : 'here';
    this.#lastFrame = undefined;
    this.#elapsed = 0;
    this.#asking = false;
    this.#take++;
    this.#frame = requestAnimationFrame(this.#tick);
    this.#showPlaying();
  }

  pause(): void {
    this.#stop();
  }

  step(unit: StepUnit, direction: StepDirection): void {
    if (this.#play.disabled) return;
    this.#stop();
    this.#events.step(unit, direction);
  }

  showWholePath(): void {
    this.#stop();
    this.place = undefined;
    this.#events.wholePath();
    this.#play.focus({ preventScroll: true });
  }

  #tick = (now: number): void => {
    const elapsed = this.#lastFrame === undefined ? 0 : (now - this.#lastFrame) / 1000;
    this.#lastFrame = now;
    this.#elapsed += Math.min(elapsed, LONGEST_FRAME);
    this.#frame = requestAnimationFrame(this.#tick);
    // One question at a time: where the interpreter is slow, the tool makes longer leaps.
    if (this.#asking || this.#elapsed === 0) return;
    this.#asking = true;
    const take = this.#take;
    const asked = this.#events.play(this.#from, this.#elapsed, this.#pace, this.#stops);
    [this.#from, this.#elapsed] = ['here', 0];
    void asked.then((place) => {
      if (take !== this.#take) return;
      this.#asking = false;
      const held = place?.stop !== undefined && (place.stop.kind === 'always' || this.#stops === 'all');
      if (held || place === undefined || place.share >= 1) this.#stop();
      this.place = place;
    });
  };

  #scrub(): void {
    this.#stop();
    this.#events.seek(this.#slider.valueAsNumber);
  }

  #stop(): void {
    if (this.#frame === undefined) return;
    cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#take++;
    this.#showPlaying();
    this.place = this.#place;
  }

  get #pace(): Pace {
    const [kind, number] = this.#speed.value.split(' ');
    return kind === 'times' ? { kind, factor: Number(number) } : { kind: 'whole', seconds: Number(number) };
  }

  get #stops(): StopSwitch {
    return this.#optional.getAttribute('aria-pressed') === 'true' ? 'all' : 'not-optional';
  }

  get #chosenUnit(): StepUnit {
    return UNITS.find((unit) => unit === this.#unit.value) ?? 'motion';
  }

  #nameSteps(): void {
    const key = { motion: 'F9', block: 'Ctrl F9', pass: 'Alt F9' }[this.#chosenUnit];
    const words = this.#strings.playing;
    name(this.#back, `${words.previous[this.#chosenUnit]} (Shift ${key})`);
    name(this.#forward, `${words.next[this.#chosenUnit]} (${key})`);
  }

  #showDoing(): void {
    const { stroke, stop } = this.#place ?? {};
    let text = '';
    if (stop !== undefined) text = this.#strings.playing.stopped(stop.code, stop.line);
    else if (stroke !== undefined) text = `${this.#strings.line(stroke.line)}: ${stroke.text}`;
    if (text === this.#doingShown) return;
    this.#doingShown = text;
    this.#doing.classList.toggle('stopped', stop !== undefined);
    this.#doing.replaceChildren(...(text === '' ? [] : unbroken(text)));
  }

  #showPlaying(): void {
    const text = this.playing ? this.#strings.pause : this.#strings.play;
    this.#playIcon.replaceChildren(icon(this.playing ? 'pause' : 'play'));
    this.#playText.textContent = text;
    this.#play.title = `${text} (Ctrl Enter)`;
    this.#doing.setAttribute('aria-live', this.playing ? 'off' : 'polite');
  }
}
