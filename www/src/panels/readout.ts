// The read-out of the playback: place, feed, spindle, time and tool, as on a control's position screen.
//
// In: what the interpreter reads off where the tool is. Out: an element. Must not know: how the numbers come about.

import { make } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { Readout } from '../protocol/protocol';

const NOTHING = '–';

/** A name and a value that stays where it is while its digits change. */
class Cell {
  readonly #name = make('dt');
  readonly #value = make('dd');
  readonly element: HTMLElement;

  constructor(className: string) {
    this.element = make('div', { className: `cell ${className}` }, this.#name, this.#value);
  }

  set name(text: string) {
    if (this.#name.textContent !== text) this.#name.textContent = text;
  }

  set value(text: string) {
    // Setting the same text again would make the browser lay the page out anew in each frame.
    if (this.#value.textContent !== text) this.#value.textContent = text;
  }

  set hint(text: string) {
    if (this.element.title !== text) this.element.title = text;
  }
}

export class ReadoutBoard {
  readonly element = make('dl', { className: 'readout', part: 'readout' });
  readonly #x = new Cell('x');
  readonly #z = new Cell('z');
  readonly #c = new Cell('c');
  readonly #feed = new Cell('feed');
  readonly #spindle = new Cell('spindle');
  readonly #surface = new Cell('surface');
  readonly #time = new Cell('time');
  readonly #tool = new Cell('tool');
  #strings: Strings;
  #shown: Readout | undefined;

  constructor(strings: Strings) {
    this.#strings = strings;
    const cells = [this.#x, this.#z, this.#c, this.#spindle, this.#surface, this.#feed, this.#time, this.#tool];
    this.element.append(...cells.map((cell) => cell.element));
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    const words = strings.playing;
    this.element.setAttribute('aria-label', words.readout);
    this.#x.name = 'X ⌀';
    this.#z.name = 'Z';
    this.#c.name = 'C';
    this.#feed.name = words.feed;
    this.#spindle.name = words.spindle;
    this.#surface.name = words.surfaceSpeed;
    this.#time.name = words.time;
    this.#tool.name = words.tool;
    this.shown = this.#shown;
  }

  set shown(readout: Readout | undefined) {
    this.#shown = readout;
    this.element.classList.toggle('idle', readout === undefined);
    this.#c.element.hidden = readout?.c === undefined;
    this.#x.value = readout === undefined ? NOTHING : millimetres(readout.stroke.atX);
    this.#z.value = readout === undefined ? NOTHING : millimetres(readout.stroke.atZ);
    this.#c.value = readout?.c === undefined ? NOTHING : `${signed(readout.c, 2)}°`;
    this.#feed.value = this.#feedText(readout);
    this.#spindle.value = this.#with(readout?.rpm, 0, this.#strings.playing.turns);
    this.#surface.value = this.#with(readout?.surfaceSpeed, 0, this.#strings.playing.metres);
    this.#time.value = this.#timeText(readout);
    this.#time.hint = this.#strings.playing.unknownTime(readout?.total.unknownRapids ?? 0, readout?.total.unknownCuts ?? 0);
    this.#tool.value = this.#toolText(readout);
  }

  #with(value: number | undefined, digits: number, unit: string): string {
    return value === undefined ? NOTHING : `${value.toFixed(digits)} ${unit}`;
  }

  /** As it is programmed, then what comes of it. */
  #feedText(readout: Readout | undefined): string {
    const words = this.#strings.playing;
    if (readout?.stroke.kind === 'rapid') return this.#strings.rapid;
    const texts = [
      readout?.feedPerTurn === undefined ? '' : `${trimmed(readout.feedPerTurn, 4)} ${words.perTurn}`,
      readout?.feed === undefined ? '' : `${readout.feed < 10 ? trimmed(readout.feed, 2) : readout.feed.toFixed(0)} ${words.perMinute}`,
    ].filter((text) => text !== '');
    return texts.join(' · ') || NOTHING;
  }

  /** "0:12 / 1:38 + 102 rapids": what is not known is counted, never guessed. */
  #timeText(readout: Readout | undefined): string {
    if (readout === undefined) return NOTHING;
    const { elapsed, total } = readout;
    const words = this.#strings.playing;
    if (total.seconds === 0 && total.unknownRapids + total.unknownCuts > 0) return words.notKnown;
    const unknown = [
      total.unknownRapids > 0 ? ` + ${words.rapids(total.unknownRapids)}` : '',
      total.unknownCuts > 0 ? ` + ${words.cuts(total.unknownCuts)}` : '',
    ];
    return `${clock(elapsed.seconds)} / ${clock(total.seconds)}${unknown.join('')}`;
  }

  #toolText(readout: Readout | undefined): string {
    const { tool, toolKind, toolGuessed } = readout ?? {};
    const words = this.#strings.playing;
    const kind = toolKind === undefined ? '' : words.kinds[toolKind];
    const said = [tool, kind].filter((text) => text !== undefined && text !== '').join(' ');
    if (said === '') return NOTHING;
    return toolGuessed === true ? words.assumed(said) : said;
  }
}

/** "1:38" or "1:02:09". */
function clock(seconds: number): string {
  const whole = Math.floor(seconds + 1e-6);
  const two = (value: number): string => String(value).padStart(2, '0');
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}

function trimmed(value: number, digits: number): string {
  return value.toFixed(digits).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '');
}

function signed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text.replace('-', '−');
}

export function millimetres(value: number): string {
  return signed(value, 3);
}
