// The readout of the playback: position, feed, spindle, time and tool, as on the position screen of a control.
//
// In: the readout of the interpreter at the tool position. Out: an element. Must not know: how the numbers are
// computed.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { LengthUnit, Readout } from '../protocol/protocol';
import { durationNote, formatClock, formatDuration } from './duration';
import { toUnit, formatCoordinate, formatSigned, unitSymbol } from './lengths';

const NO_VALUE = '–';
const METRES_PER_FOOT = 0.3048;

/** A name and a value. The value does not move while its digits change. */
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
    // Setting the same text would force a new layout in each frame.
    if (this.#value.textContent !== text) this.#value.textContent = text;
  }

  set hint(text: string) {
    if (this.element.title !== text) this.element.title = text;
  }
}

export class ReadoutBoard {
  readonly element = make('dl', { className: 'readout', part: 'readout' });
  readonly #x = new Cell('x');
  readonly #y = new Cell('y');
  readonly #z = new Cell('z');
  readonly #c = new Cell('c');
  readonly #feed = new Cell('feed');
  readonly #spindle = new Cell('spindle');
  readonly #surface = new Cell('surface');
  readonly #time = new Cell('time');
  readonly #tool = new Cell('tool');
  #language: Language;
  #unit: LengthUnit = 'mm';
  #shown: Readout | undefined;

  constructor(language: Language) {
    this.#language = language;
    const cells = [
      this.#x,
      this.#y,
      this.#z,
      this.#c,
      this.#spindle,
      this.#surface,
      this.#feed,
      this.#time,
      this.#tool,
    ];
    this.element.append(...cells.map((cell) => cell.element));
    this.language = language;
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    this.element.setAttribute('aria-label', texts.readout);
    // Millimetres are the default and need no label.
    const unit = this.#unit === 'mm' ? '' : `, ${unitSymbol(this.#unit, language)}`;
    this.#x.name = `X Ø${unit}`;
    this.#y.name = `Y${unit}`;
    this.#z.name = `Z${unit}`;
    this.#c.name = 'C';
    this.#feed.name = texts.feed;
    this.#spindle.name = texts.spindle;
    this.#surface.name = texts.surfaceSpeed;
    this.#time.name = texts.time;
    this.#tool.name = texts.tool;
    this.shown = this.#shown;
  }

  set unit(unit: LengthUnit) {
    this.#unit = unit;
    this.language = this.#language;
  }

  set shown(readout: Readout | undefined) {
    this.#shown = readout;
    this.element.classList.toggle('idle', readout === undefined);
    this.#c.element.hidden = readout?.c === undefined;
    this.#y.element.hidden = readout?.y === undefined;
    this.#y.value = readout?.y === undefined ? NO_VALUE : formatCoordinate(readout.y, this.#unit);
    this.#x.value = readout === undefined ? NO_VALUE : formatCoordinate(readout.stroke.atX, this.#unit);
    this.#z.value = readout === undefined ? NO_VALUE : formatCoordinate(readout.stroke.atZ, this.#unit);
    this.#c.value = readout?.c === undefined ? NO_VALUE : `${formatSigned(readout.c, 2)}°`;
    this.#feed.value = this.#feedText(readout);
    this.#feed.hint = readout?.locked === true ? WORDS[this.#language].locked : '';
    this.#spindle.value = this.#withUnit(readout?.rpm, 0, WORDS[this.#language].turns);
    this.#surface.value = this.#surfaceText(readout?.surfaceSpeed);
    this.#time.value = this.#timeText(readout);
    this.#time.hint = readout === undefined ? '' : durationNote(readout.total, this.#language);
    this.#tool.value = this.#toolText(readout);
  }

  #withUnit(value: number | undefined, digits: number, unit: string): string {
    return value === undefined ? NO_VALUE : `${value.toFixed(digits)} ${unit}`;
  }

  /** m/min, or ft/min if lengths are in inches. */
  #surfaceText(metres: number | undefined): string {
    const { metres: metric, feet } = WORDS[this.#language];
    return this.#unit === 'mm'
      ? this.#withUnit(metres, 0, metric)
      : this.#withUnit(metres === undefined ? undefined : metres / METRES_PER_FOOT, 0, feet);
  }

  /** The programmed feed, then the resulting one. */
  #feedText(readout: Readout | undefined): string {
    const texts = WORDS[this.#language];
    if (readout?.stroke.kind === 'rapid') return COMMON[this.#language].rapid;
    const metric = this.#unit === 'mm';
    const turn = readout?.feedPerTurn === undefined ? undefined : toUnit(readout.feedPerTurn, this.#unit);
    const minute = readout?.feed === undefined ? undefined : toUnit(readout.feed, this.#unit);
    const unit = unitSymbol(this.#unit, this.#language);
    const parts = [
      turn === undefined ? '' : `${formatTrimmed(turn, metric ? 4 : 5)} ${texts.perTurn(unit)}`,
      minute === undefined
        ? ''
        : `${minute < 10 ? formatTrimmed(minute, 2) : minute.toFixed(metric || minute >= 100 ? 0 : 1)} ${texts.perMinute(unit)}`,
    ].filter((text) => text !== '');
    if (readout?.locked === true) parts.push(texts.override);
    return parts.join(' · ') || NO_VALUE;
  }

  /** "0:12 / 1:38". */
  #timeText(readout: Readout | undefined): string {
    if (readout === undefined) return NO_VALUE;
    const { elapsed, total } = readout;
    const texts = WORDS[this.#language];
    if (total.seconds + total.assumedSeconds === 0 && total.unknownCuts > 0) return texts.notKnown;
    const now = formatClock(elapsed.seconds + elapsed.assumedSeconds);
    return `${now} / ${formatDuration(total, this.#language)}`;
  }

  #toolText(readout: Readout | undefined): string {
    const { tool, toolKind, toolInferred } = readout ?? {};
    const texts = WORDS[this.#language];
    const description = [tool, toolKind].filter((text) => text !== undefined && text !== '').join(' ');
    if (description === '') return NO_VALUE;
    return toolInferred === true ? texts.assumed(description) : description;
  }
}

function formatTrimmed(value: number, digits: number): string {
  return value
    .toFixed(digits)
    .replace(/(\.\d*?)0+$/, '$1')
    .replace(/\.$/, '');
}

const WORDS = words({
  en: {
    readout: 'Where the tool is',
    feed: 'Feed',
    spindle: 'Spindle',
    surfaceSpeed: 'Cutting speed',
    time: 'Time',
    tool: 'Tool',
    perMinute: (unit: string) => `${unit}/min`,
    perTurn: (unit: string) => `${unit}/rev`,
    override: 'override 100 %',
    locked:
      'While a thread is cut, the feed and spindle override count as 100 %, and feed hold waits until the tool is out of the thread.',
    turns: 'rpm',
    metres: 'm/min',
    feet: 'ft/min',
    notKnown: 'not known',
    assumed: (tool: string) => `${tool}, assumed`,
  },
  zh: {
    readout: '刀具状态',
    feed: '进给',
    spindle: '主轴转速',
    surfaceSpeed: '切削速度',
    time: '时间',
    tool: '刀具',
    perMinute: (unit) => `${unit}/min`,
    perTurn: (unit) => `${unit}/r`,
    override: '倍率 100%',
    locked: '切螺纹期间，进给倍率和主轴倍率按 100% 计，进给保持要等刀具退出螺纹后才生效。',
    turns: 'r/min',
    metres: 'm/min',
    feet: 'ft/min',
    notKnown: '未知',
    assumed: (tool) => `${tool}（推测）`,
  },
  ru: {
    readout: 'Где инструмент',
    feed: 'Подача',
    spindle: 'Шпиндель',
    surfaceSpeed: 'Скорость резания',
    time: 'Время',
    tool: 'Инструмент',
    perMinute: (unit) => `${unit}/мин`,
    perTurn: (unit) => `${unit}/об`,
    override: 'коррекция 100 %',
    locked:
      'Пока нарезается резьба, ручная коррекция подачи и шпинделя равна 100 %, а останов подачи ждёт, пока инструмент не выйдет из резьбы.',
    turns: 'об/мин',
    metres: 'м/мин',
    feet: 'фут/мин',
    notKnown: 'неизвестно',
    assumed: (tool) => `${tool}, предположительно`,
  },
});
