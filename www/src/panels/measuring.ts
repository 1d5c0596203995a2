// Measuring in the section: clicks pick corners and edges, and a note shows the distance between the last two.
//
// In: clicks, the answers of the worker. Out: the note over the picture; the worker draws the dimensions. Must not know:
// how a corner is found.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Command, LengthUnit, Measurement } from '../protocol/protocol';
import { dimensionText } from './dimension';
import { formatLength, formatShort } from './lengths';
import type { Shell } from './panel';

export class Measuring {
  readonly #shell: Shell;
  readonly #text = make('p', { role: 'status' });
  readonly #end = make('button', { type: 'button', className: 'close' }, icon('whole'));
  /** Over the section. */
  readonly note = make('div', { className: 'measuring', part: 'measuring', hidden: true }, this.#text, this.#end);
  #isOn = false;
  /** What the last pick has found. */
  #found: Measurement | 'nothing' | undefined;
  unit: LengthUnit = 'mm';

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#end.addEventListener('click', () => this.set(false));
  }

  get isOn(): boolean {
    return this.#isOn;
  }

  set(isOn: boolean): void {
    if (isOn === this.#isOn) return;
    this.#isOn = isOn;
    this.#shell.send({ kind: 'measuring', isOn });
    this.#shell.region('pictures').classList.toggle('is-measured', isOn);
    this.restart();
  }

  sendInitial(send: (command: Command) => void): void {
    if (this.#isOn) send({ kind: 'measuring', isOn: true });
    this.restart();
  }

  /** Forgets the picks, as the worker does when a run begins. */
  restart(): void {
    this.#found = undefined;
    this.show();
  }

  /** Picks a place of the section, CSS pixels. */
  async pick(x: number, y: number): Promise<void> {
    this.#found = (await this.#shell.ask('measure', { x, y })) ?? 'nothing';
    this.show();
  }

  show(): void {
    const texts = WORDS[this.#shell.language];
    this.note.hidden = !this.#isOn;
    setAccessibleName(this.#end, texts.end);
    this.#text.textContent = this.#describe(this.#shell.language);
  }

  #describe(language: Language): string {
    const texts = WORDS[language];
    const found = this.#found;
    if (found === undefined) return texts.first;
    if (found === 'nothing') return texts.nothing;
    const { edge, corner, distances, angle = 0 } = found;
    const format = (mm: number): string => formatLength(mm, this.unit);
    const degrees = formatShort(angle, 2);
    if (edge !== undefined) return `${dimensionText(language, edge, this.unit)}. ${texts.second}`;
    if (corner !== undefined) return `Ø${format(corner.x)}, Z${format(corner.z)}. ${texts.second}`;
    if (distances === undefined) return texts.angle(degrees);
    const [axial, radial, shortest] = distances.map(format) as [string, string, string];
    return texts.distances(axial, radial, shortest, degrees);
  }
}

const WORDS = words({
  en: {
    first: 'Measure: click a corner, an edge or a line of the path.',
    second: 'Click a second place for the distance.',
    nothing: 'No corner or edge here. Click nearer to one.',
    distances: (axial: string, radial: string, shortest: string, degrees: string) =>
      `Along Z ${axial} · radial ${radial} · distance ${shortest} · ${degrees}° to the axis`,
    angle: (degrees: string) => `Angle ${degrees}°`,
    end: 'End measuring (Escape)',
  },
  zh: {
    first: '测量：请点击拐角、棱边或轨迹线。',
    second: '再点击另一处即可测量距离。',
    nothing: '此处没有拐角或棱边，请靠近一些再点击。',
    distances: (axial, radial, shortest, degrees) =>
      `轴向 ${axial} · 径向 ${radial} · 距离 ${shortest} · 与轴线夹角 ${degrees}°`,
    angle: (degrees) => `夹角 ${degrees}°`,
    end: '结束测量 (Escape)',
  },
  ru: {
    first: 'Измерение: щёлкните угол, кромку или линию траектории.',
    second: 'Щёлкните второе место, чтобы узнать расстояние.',
    nothing: 'Здесь нет угла или кромки. Щёлкните ближе к ним.',
    distances: (axial, radial, shortest, degrees) =>
      `Вдоль Z ${axial} · по радиусу ${radial} · расстояние ${shortest} · ${degrees}° к оси`,
    angle: (degrees) => `Угол ${degrees}°`,
    end: 'Закончить измерение (Escape)',
  },
});
