// The bar under the drawing: play, step, scrub, speed, and where the tool is.
//
// In: the length of the path and, as answers, the place of the tool. Out: `moveTo`, `step` and `wholePath`.
// While it plays, each painted frame asks for one place; while it is paused nothing runs.
// Must not know: how the path is drawn, or what a stroke means.

import { icon, make, name, unbroken } from './dom';
import type { Strings } from './i18n';
import type { ToolPlace } from './protocol';

/** At speed 1 a whole program takes this long. */
const WHOLE_PATH_SECONDS = 20;
const SPEEDS = [0.5, 1, 2, 4, 8];

export interface PlaybackEvents {
  moveTo(distance: number): void;
  step(distance: number, direction: 'next' | 'previous'): void;
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
  readonly #whole = make('button', { type: 'button', className: 'quiet' }, icon('whole'));
  readonly #slider = make('input', { type: 'range', min: '0', max: '0', step: 'any', value: '0', className: 'scrub' });
  readonly #speed = make('select', { className: 'speed' });
  readonly #x = make('span', { className: 'value' });
  readonly #z = make('span', { className: 'value' });
  readonly #doing = make('p', { className: 'doing', part: 'doing' });
  #strings: Strings;
  /** mm */
  #length = 0;
  /** mm along the path; undefined while the whole path is shown and there is no tool. */
  #distance: number | undefined;
  #lastFrame: number | undefined;
  #frame: number | undefined;

  constructor(strings: Strings, events: PlaybackEvents) {
    this.#strings = strings;
    this.#events = events;
    this.#play.append(this.#playIcon, this.#playText);
    for (const speed of SPEEDS) {
      this.#speed.append(make('option', { value: String(speed), selected: speed === 1 }, `${speed}×`));
    }
    const readout = make(
      'div',
      { className: 'readout', part: 'readout' },
      make('span', { className: 'axis' }, 'X ⌀'),
      this.#x,
      make('span', { className: 'axis' }, 'Z'),
      this.#z,
    );
    this.element = make(
      'div',
      { className: 'playback', part: 'playback', role: 'group' },
      make('div', { className: 'buttons' }, this.#back, this.#play, this.#forward),
      this.#slider,
      make('div', { className: 'place' }, readout, this.#speed, this.#whole),
      this.#doing,
    );
    this.#play.addEventListener('click', () => this.toggle());
    this.#back.addEventListener('click', () => this.step('previous'));
    this.#forward.addEventListener('click', () => this.step('next'));
    this.#whole.addEventListener('click', () => this.showWholePath());
    this.#slider.addEventListener('input', () => this.#scrub());
    this.strings = strings;
    this.place = undefined;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.element.setAttribute('aria-label', strings.playback);
    name(this.#back, `${strings.stepBack} (Shift F9)`);
    name(this.#forward, `${strings.stepForward} (F9)`);
    name(this.#whole, strings.wholePath);
    this.#slider.setAttribute('aria-label', strings.position);
    this.#speed.setAttribute('aria-label', strings.speed);
    this.#speed.title = strings.speed;
    this.#showPlaying();
  }

  /** A new path has been drawn, of so many mm: nothing is played any more. */
  set length(length: number) {
    this.#stop();
    this.#length = length;
    this.#slider.max = String(length);
    for (const control of [this.#play, this.#back, this.#forward, this.#slider]) control.disabled = length <= 0;
    this.place = undefined;
  }

  /** Where the tool is now. */
  set place(place: ToolPlace | undefined) {
    if (!this.playing) this.#distance = place?.distance;
    const shown = place?.distance ?? 0;
    // While it is dragged, the hand says where the slider is, not an answer to where it was.
    if (!this.#slider.matches(':active')) this.#slider.value = String(shown);
    const stroke = place?.stroke;
    this.#x.textContent = stroke === undefined ? '–' : millimetres(stroke.atX);
    this.#z.textContent = stroke === undefined ? '–' : millimetres(stroke.atZ);
    this.#doing.replaceChildren(...(stroke === undefined ? [] : unbroken(`${this.#strings.line(stroke.line)}: ${stroke.text}`)));
    this.#whole.hidden = place === undefined;
    const spoken =
      stroke === undefined ? '–' : this.#strings.positionText(millimetres(stroke.atX), millimetres(stroke.atZ));
    this.#slider.setAttribute('aria-valuetext', spoken);
  }

  get playing(): boolean {
    return this.#frame !== undefined;
  }

  toggle(): void {
    if (this.playing) this.#stop();
    else this.play();
  }

  play(): void {
    if (this.playing || this.#length <= 0) return;
    if (this.#distance === undefined || this.#distance >= this.#length) this.#distance = 0;
    this.#lastFrame = undefined;
    this.#frame = requestAnimationFrame(this.#tick);
    this.#showPlaying();
  }

  pause(): void {
    this.#stop();
  }

  step(direction: 'next' | 'previous'): void {
    if (this.#length <= 0) return;
    this.#stop();
    this.#events.step(this.#distance ?? (direction === 'next' ? 0 : this.#length), direction);
  }

  showWholePath(): void {
    this.#stop();
    this.#distance = undefined;
    this.place = undefined;
    this.#events.wholePath();
    this.#play.focus({ preventScroll: true });
  }

  #tick = (now: number): void => {
    const elapsed = this.#lastFrame === undefined ? 0 : (now - this.#lastFrame) / 1000;
    this.#lastFrame = now;
    const speed = (this.#length / WHOLE_PATH_SECONDS) * Number(this.#speed.value);
    const distance = Math.min((this.#distance ?? 0) + elapsed * speed, this.#length);
    this.#distance = distance;
    this.#events.moveTo(distance);
    if (distance < this.#length) this.#frame = requestAnimationFrame(this.#tick);
    else this.#stop();
  };

  #scrub(): void {
    this.#stop();
    this.#distance = this.#slider.valueAsNumber;
    this.#events.moveTo(this.#distance);
  }

  #stop(): void {
    if (this.#frame === undefined) return;
    cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#showPlaying();
  }

  #showPlaying(): void {
    const text = this.playing ? this.#strings.pause : this.#strings.play;
    this.#playIcon.replaceChildren(icon(this.playing ? 'pause' : 'play'));
    this.#playText.textContent = text;
    this.#play.title = `${text} (Ctrl Enter)`;
  }
}

function millimetres(value: number): string {
  const text = value.toFixed(3).replace('-', '−');
  return text === '−0.000' ? '0.000' : text;
}
