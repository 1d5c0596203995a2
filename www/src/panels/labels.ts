// The names of chuck, tool and start point on the picture of a first lesson.
//
// In: the attribute `labels` of the element; start point and blank of the run; positions and strokes, as the worker
// answers. Out: words over the section at rest, with the whole path fitted. A word is left out if it would cover a
// stroke, the part or other text. Must not know: how a picture is painted.

import { make, makeSvg, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Readout, SetupOverview, ViewsState } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';
import labelsStyles from './labels.css?inline';

/** Width of the left ruler of a picture, its pixels. */
const LEFT_RULER_PX = 46;
/** Length of the jaws across the axis, mm, as the interpreter draws them. */
const JAW_MM = 40;
/** Edge length of the insert, CSS pixels, and the angles of its two edges from Z+, degrees. */
const EDGE_PX = 19;
const EDGES = [5, 85] as const;
/** Distance of a word from the insert or the start point, CSS pixels. */
const GAPS_PX = [4, 10, 16] as const;
/** Minimum distance from the edge of the picture and from other text, CSS pixels. */
const MARGIN_PX = 1;
/** A stroke is found within this distance, CSS pixels, of a position. */
const REACH_PX = 8;

interface Place {
  readonly x: number;
  readonly y: number;
}

interface Box extends Place {
  readonly width: number;
  readonly height: number;
}

export const labels: PanelKind = { control: 'views', styles: labelsStyles, make: (shell) => new Labels(shell) };

class Labels implements Panel {
  readonly #shell: Shell;
  readonly #chuck = make('span', { className: 'chuck' });
  readonly #tool = make('span');
  readonly #start = make('span');
  readonly #insert = makeSvg('svg', { width: EDGE_PX, height: EDGE_PX });
  readonly #layer = make('div', { className: 'labels', 'aria-hidden': 'true' });
  readonly elements: Panel['elements'];
  #overview: SetupOverview | undefined;
  #hasChuck = false;
  #turret: ViewsState['turret'] = 'rear';
  #isToolShown = false;
  /** Number of placements, so that a late answer for an earlier one is dropped. */
  #placement = 0;

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#layer.append(this.#insert, this.#chuck, this.#tool, this.#start);
    this.elements = { pictures: [this.#layer] };
    // Another hint may be in the way.
    shell.root.host.addEventListener('gcode-hint', () => void this.#place());
  }

  set language(language: Language) {
    const texts = WORDS[language];
    setText(this.#chuck, texts.chuck);
    setText(this.#tool, texts.tool);
    setText(this.#start, texts.start);
    void this.#place();
  }

  onEvent(event: CoreEvent): void {
    const views = event.kind === 'views' ? event.views : event.kind === 'report' ? event.report.views : undefined;
    if (views !== undefined) {
      this.#hasChuck = views.work.includes('chuck');
      this.#turret = views.turret;
    }
    if (event.kind !== 'report') return;
    this.#overview = event.report.overview;
    void this.#place();
  }

  onPictures(): void {
    void this.#place();
  }

  onToolMoved(place: Readout | undefined): void {
    this.#isToolShown = place !== undefined;
    if (this.#isToolShown) this.#clear();
  }

  onWorkerLost(): void {
    this.#overview = undefined;
    this.#clear();
  }

  #clear(): void {
    this.#placement++;
    for (const element of this.#layer.children) element.classList.remove('placed');
  }

  /** Places the names for the current picture. */
  async #place(): Promise<void> {
    const overview = this.#overview;
    const isShown =
      this.#shell.root.host.hasAttribute('labels') && !this.#isToolShown && this.#layer.getClientRects().length > 0;
    if (overview === undefined || !isShown) return this.#clear();
    const placement = ++this.#placement;
    const found = await this.#findPlaces(overview).catch(() => undefined);
    if (placement !== this.#placement) return;
    for (const element of [this.#insert, this.#chuck, this.#tool, this.#start]) {
      const place = found?.get(element);
      element.classList.toggle('placed', place !== undefined);
      if (place !== undefined) element.style.transform = `translate(${place.x}px, ${place.y}px)`;
    }
  }

  /** The top left corners of the names that have room. */
  async #findPlaces({ start, blank }: SetupOverview): Promise<Map<Element, Place>> {
    const places = new Map<Element, Place>();
    const { face, grip } = await this.#findClamping();
    const taken = [...this.#otherTexts()];
    if (blank !== undefined) taken.push(await this.#boxBetween(blank[0], face - blank[1], -blank[0], face));
    const place = async (element: Element, candidates: readonly Place[]): Promise<void> => {
      const { width, height } = element.getBoundingClientRect();
      for (const { x, y } of candidates) {
        const box = { x: Math.round(x), y: Math.round(y), width, height };
        if (!this.#isInside(box) || taken.some((other) => overlap(box, other)) || (await this.#isOnStroke(box)))
          continue;
        taken.push(box);
        places.set(element, box);
        return;
      }
    };
    if (start !== undefined) {
      const tip = await this.#locate(...start);
      // Outwards, away from the spindle axis: −1 is up.
      const out = this.#turret === 'rear' ? -1 : 1;
      const insert = insertBox(tip, out);
      if (this.#isInside(insert)) {
        this.#drawInsert(out);
        places.set(this.#insert, tip);
        taken.push(insert);
        await place(this.#tool, besideInsert(insert, this.#tool.getBoundingClientRect(), out));
        await place(this.#start, besideTip(tip, insert, this.#start.getBoundingClientRect(), -out));
      }
    }
    if (this.#hasChuck && blank !== undefined && grip !== undefined)
      await place(
        this.#chuck,
        await this.#onJaws(blank[0], face - blank[1], grip, this.#chuck.getBoundingClientRect()),
      );
    return places;
  }

  /**
   * Top left corners for a word in the middle of the visible part of a jaw, first on the side without path. The jaws
   * clamp `grip` mm of the bar from its end, `back`.
   */
  async #onJaws(diameter: number, back: number, grip: number, word: DOMRect): Promise<Place[]> {
    const outside = diameter + 2 * JAW_MM;
    const room = this.#room;
    const places: Place[] = [];
    for (const side of [-1, 1]) {
      const jaw = await this.#boxBetween(side * diameter, back, side * outside, back + grip);
      const [left, right] = [Math.max(jaw.x, 0), Math.min(jaw.x + jaw.width, room.width)];
      const [top, bottom] = [Math.max(jaw.y, 0), Math.min(jaw.y + jaw.height, room.height)];
      if (right - left < word.width || bottom - top < word.height + 2 * MARGIN_PX) continue;
      places.push({ x: (left + right - word.width) / 2, y: (top + bottom - word.height) / 2 });
    }
    return places;
  }

  /** Z of the front face of the blank, and its clamping length if it is given, mm. */
  async #findClamping(): Promise<{ readonly face: number; readonly grip: number | undefined }> {
    const form = await this.#shell.ask('setup-form', undefined);
    const fields = form?.groups.flatMap(({ fields }) => fields) ?? [];
    const [face, grip] = ['stock.face', 'stock.grip'].map((key) => {
      const value = Number.parseFloat(fields.find((field) => field.key === key)?.value ?? '');
      return Number.isFinite(value) ? value : undefined;
    });
    return { face: face ?? 0, grip };
  }

  get #room(): DOMRect {
    return this.#layer.getBoundingClientRect();
  }

  /** CSS pixels for one pixel of the picture. */
  get #scale(): number {
    return this.#layer.offsetLeft / LEFT_RULER_PX;
  }

  /** The position of X (a diameter) and Z, mm, in the layer. */
  async #locate(x: number, z: number): Promise<Place> {
    const { clientX, clientY } = await this.#shell.service('locate')('section', x, z);
    const { left, top } = this.#room;
    return { x: clientX - left, y: clientY - top };
  }

  async #boxBetween(x1: number, z1: number, x2: number, z2: number): Promise<Box> {
    const [one, other] = [await this.#locate(x1, z1), await this.#locate(x2, z2)];
    return {
      x: Math.min(one.x, other.x),
      y: Math.min(one.y, other.y),
      width: Math.abs(one.x - other.x),
      height: Math.abs(one.y - other.y),
    };
  }

  #isInside({ x, y, width, height }: Box): boolean {
    const room = this.#room;
    const inside = (from: number, length: number, all: number): boolean =>
      from >= MARGIN_PX && from + length <= all - MARGIN_PX;
    return inside(x, width, room.width) && inside(y, height, room.height);
  }

  /** What else is shown over the pictures: hints, legend, notes. */
  #otherTexts(): readonly Box[] {
    const room = this.#room;
    const others = this.#layer.parentElement?.querySelectorAll('.hint, .legend, .old-picture, .over-picture') ?? [];
    return [...others]
      .map((other) => other.getBoundingClientRect())
      .filter(({ width }) => width > 0)
      .map(({ left, top, width, height }) => ({ x: left - room.left, y: top - room.top, width, height }));
  }

  /** Whether a stroke crosses a box. */
  async #isOnStroke({ x, y, width, height }: Box): Promise<boolean> {
    const scale = this.#scale;
    // Positions so close that no stroke passes between them.
    const columns = Math.ceil(width / REACH_PX);
    for (let column = 0; column <= columns; column++) {
      const at = { x: (x + (column / columns) * width) / scale + LEFT_RULER_PX, y: (y + height / 2) / scale };
      if ((await this.#shell.ask('pick', { picture: 'section', ...at })) !== undefined) return true;
    }
    return false;
  }

  #drawInsert(out: 1 | -1): void {
    const corner = (degrees: number): Place => ({
      x: EDGE_PX * Math.cos((degrees * Math.PI) / 180),
      y: out * EDGE_PX * Math.sin((degrees * Math.PI) / 180),
    });
    const [low, high] = [corner(EDGES[0]), corner(EDGES[1])];
    const corners = [{ x: 0, y: 0 }, low, { x: low.x + high.x, y: low.y + high.y }, high];
    this.#insert.replaceChildren(
      makeSvg('polygon', { points: corners.map(({ x, y }) => `${x},${y}`).join(' ') }),
      makeSvg('circle', { r: 2.5 }),
    );
  }
}

/** The box of an insert with its tip at `tip`; `out` is the direction away from the axis, −1 for up. */
function insertBox(tip: Place, out: 1 | -1): Box {
  const size = EDGE_PX * (Math.cos((EDGES[0] * Math.PI) / 180) + Math.cos((EDGES[1] * Math.PI) / 180));
  return { x: tip.x, y: out < 0 ? tip.y - size : tip.y, width: size, height: size };
}

/** Top left corners for a word beside the insert, the best first: beyond it, to its right, to its left. */
function besideInsert(insert: Box, word: DOMRect, out: 1 | -1): Place[] {
  const right = insert.x + insert.width;
  return GAPS_PX.flatMap((gap) => {
    const beyond = out < 0 ? insert.y - gap - word.height : insert.y + insert.height + gap;
    return [
      { x: right - word.width, y: beyond },
      { x: right + gap, y: insert.y + (insert.height - word.height) / 2 },
      { x: insert.x - gap - word.width, y: beyond },
    ];
  });
}

/** Top left corners for a word at the start point, on the side of the axis: below the insert, or beside it. */
function besideTip(tip: Place, insert: Box, word: DOMRect, inwards: number): Place[] {
  return GAPS_PX.flatMap((gap) => {
    const y = inwards > 0 ? tip.y + gap : tip.y - gap - word.height;
    return [
      { x: insert.x + insert.width - word.width, y },
      { x: tip.x + gap, y },
      { x: tip.x - gap - word.width, y },
    ];
  });
}

function overlap(one: Box, other: Box): boolean {
  const apart = (from: number, length: number, otherFrom: number, otherLength: number): boolean =>
    from >= otherFrom + otherLength + MARGIN_PX || otherFrom >= from + length + MARGIN_PX;
  return !(apart(one.x, one.width, other.x, other.width) || apart(one.y, one.height, other.y, other.height));
}

const WORDS = words({
  en: { chuck: 'chuck', tool: 'tool', start: 'start' },
  zh: { chuck: '卡盘', tool: '刀具', start: '起点' },
  ru: { chuck: 'патрон', tool: 'резец', start: 'старт' },
});
