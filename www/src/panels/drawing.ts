// The drawing: its canvas, pointer and keyboard input, the legend and the tooltip.
//
// In: the stroke under the pointer (as an answer), the counts for the legend. Out: the events below. The pictures are
// painted in the worker and arrive as images. Must not know: how a stroke is found, or its meaning.

import { icon, make, setAccessibleName, perFrame, renderUnbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { Palette, Size, Stroke, Summary, WorkShown } from '../protocol/protocol';
import { PictureCanvas } from './picture-canvas';

/** A pointer that moved less than this between press and release, CSS pixels, has clicked. */
const CLICK_SLOP_PX = { mouse: 4, touch: 10 };
const KEY_PAN_PX = 40;
const KEY_ZOOM = 1.25;
/** Font size of the page at which the picture has its natural scale, CSS pixels. */
const BASE_FONT_SIZE_PX = 16;

export interface DrawingEvents {
  onResize(size: Size): void;
  /** Asks for the picture again, unchanged. */
  requestPicture(): void;
  fit(): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number, x: number, y: number): void;
  onPoint(x: number, y: number): void;
  /** The mouse is over the picture, and nothing is dragged; until `onLeave`. */
  onMouse?(x: number, y: number): void;
  onLeave(): void;
  /** `keepFocus`: a finger tapped, and an on-screen keyboard must not open. */
  onClick(x: number, y: number, keepFocus: boolean): void;
  /** The colours of the host page have changed. */
  onColoursChanged?(): void;
  /** Other pictures that the buttons act on too. */
  companions?(): readonly Drawing[];
}

const PALETTE: readonly (keyof Palette)[] = [
  'background',
  'grid',
  'axis',
  'text',
  'stock',
  'stockEdge',
  'part',
  'partEdge',
  'danger',
  'onlyFirst',
  'onlySecond',
  'rapid',
  'feed',
  'thread',
  'highlight',
  'hover',
  'tool',
  'uncertain',
];

export class Drawing {
  readonly element: HTMLElement;
  readonly #events: DrawingEvents;
  readonly #holder = make('div', { className: 'canvas-holder' });
  readonly #fit = make('button', { type: 'button' }, icon('fit'));
  readonly #zoomIn = make('button', { type: 'button', className: 'zoom' }, icon('plus'));
  readonly #zoomOut = make('button', { type: 'button', className: 'zoom' }, icon('minus'));
  /** The kinds of strokes, and the buttons to fit and zoom. The element decides where they are placed. */
  readonly legend = make('ul', { className: 'legend', part: 'legend' });
  readonly viewButtons = make('div', { className: 'view-buttons' });
  readonly #empty = make('p', { className: 'empty', hidden: true });
  readonly #tip = make('div', { className: 'tip', part: 'tooltip', role: 'tooltip', hidden: true });
  readonly #pointers = new Map<number, { x: number; y: number }>();
  /** A box as wide as the font size of the page, to observe it. */
  readonly #fontProbe = make('div', { className: 'type-size' });
  #scale = 1;
  readonly #sizeObserver = new ResizeObserver(() => {
    const { width, height } = this.#holder.getBoundingClientRect();
    // During layout a page may have no width for a moment; a hidden page has neither width nor height.
    if (width > 0 === height > 0) this.#events.onResize(this.size);
  });
  /** Watches whether the host page scrolls. */
  readonly #scrollObserver = new ResizeObserver(() => this.#canvas.classList.toggle('of-a-page', pageScrolls()));
  readonly #picture = new PictureCanvas(() => this.#events.requestPicture());
  readonly #canvas = this.#picture.element;
  #language: Language;
  #label: (motions: number) => string = () => '';
  #summary: Summary | undefined;
  #work: readonly WorkShown[] = [];
  /** The position of the tool before the first motion, formatted; empty without motions. */
  #start = '';
  #stroke: Stroke | undefined;
  #edge: string | undefined;
  /** Explanation of the block of a motion. */
  #explanation: { readonly motion: number; readonly text: string } | undefined;
  #shownLegend = '';
  #dragDistance = 0;
  #pendingPan = { dx: 0, dy: 0 };
  #pointer = { x: 0, y: 0 };
  /** The pointer that is over the picture, while nothing is dragged. */
  #hovering: 'mouse' | 'other' | undefined;

  constructor(language: Language, events: DrawingEvents) {
    this.#language = language;
    this.#events = {
      ...events,
      pan: (dx, dy) => events.pan(dx / this.scale, dy / this.scale),
      zoom: (factor, x, y) => events.zoom(factor, x / this.scale, y / this.scale),
      onPoint: (x, y) => events.onPoint(x / this.scale, y / this.scale),
      onMouse: (x, y) => events.onMouse?.(x / this.scale, y / this.scale),
      onClick: (x, y, keepFocus) => events.onClick(x / this.scale, y / this.scale, keepFocus),
    };
    this.element = make(
      'section',
      { className: 'drawing', part: 'drawing' },
      this.#holder,
      // With several pictures, this is shown only once.
      ...(events.companions === undefined ? [] : [this.#empty]),
      this.#tip,
    );
    this.viewButtons.append(this.#fit, this.#zoomIn, this.#zoomOut);
    const all = (act: (drawing: Drawing) => void): void => [this, ...(this.#events.companions?.() ?? [])].forEach(act);
    this.#fit.addEventListener('click', () => all((drawing) => drawing.#events.fit()));
    this.#zoomIn.addEventListener('click', () => all((drawing) => drawing.#zoomCentre(KEY_ZOOM)));
    this.#zoomOut.addEventListener('click', () => all((drawing) => drawing.#zoomCentre(1 / KEY_ZOOM)));
    this.#holder.append(this.#canvas, this.#fontProbe);
    this.#addListeners(this.#canvas);
    this.#sizeObserver.observe(this.#holder);
    this.#sizeObserver.observe(this.#fontProbe);
    this.#scrollObserver.observe(this.#holder);
    this.#scrollObserver.observe(document.documentElement);
    this.#fontProbe.addEventListener('transitionend', () => events.onColoursChanged?.());
  }

  /** `label` is the text for screen readers. */
  setLanguage(language: Language, label: (motions: number) => string): void {
    const texts = WORDS[language];
    this.#language = language;
    this.#label = label;
    setAccessibleName(this.#fit, texts.fit);
    setAccessibleName(this.#zoomIn, texts.zoomIn);
    setAccessibleName(this.#zoomOut, texts.zoomOut);
    this.#empty.textContent = texts.nothingToDraw;
    this.#showSummary();
  }

  set summary(summary: Summary | undefined) {
    this.#summary = summary;
    this.#showSummary();
  }

  /** What the picture shows besides strokes. */
  set work(work: readonly WorkShown[]) {
    this.#work = work;
    this.#showSummary();
  }

  set start(start: string) {
    this.#start = start;
    this.#showSummary();
  }

  get size(): Size {
    const { width, height } = this.#holder.getBoundingClientRect();
    const scale = (this.#scale =
      Math.max(Number.parseFloat(getComputedStyle(this.#fontProbe).width) / BASE_FONT_SIZE_PX, 1) || 1);
    return {
      width: Math.max(width / scale, 1),
      height: Math.max(height / scale, 1),
      pixelRatio: (window.devicePixelRatio || 1) * scale,
    };
  }

  /** CSS pixels for one pixel of the picture: texts and strokes scale with the font size of the page. */
  get scale(): number {
    return this.#scale;
  }

  /** The colours as the style sheet resolves them now. */
  get palette(): Palette {
    const probe = make('span', { hidden: true });
    // The style sheet already uses the system colours: the browser must not force its own.
    probe.style.setProperty('forced-color-adjust', 'none');
    this.element.append(probe);
    const style = getComputedStyle(probe);
    const colours = {} as Record<keyof Palette, string>;
    for (const key of PALETTE) {
      probe.style.color = `var(--playground-${key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)})`;
      colours[key] = style.color;
    }
    probe.remove();
    this.#canvas.classList.toggle('is-dark', isDark(colours.background));
    return colours;
  }

  /** Shows a picture in place of the previous one. */
  show(image: ImageBitmap): void {
    this.#picture.show(image);
  }

  /** The top left corner of the canvas in the window, CSS pixels. */
  get origin(): { x: number; y: number } {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return { x: left, y: top };
  }

  /** Shows the stroke under the pointer, if any. */
  showTip(stroke: Stroke | undefined): void {
    this.#stroke = stroke;
    this.#canvas.classList.toggle('on-stroke', stroke !== undefined);
    this.#updateTip();
  }

  /** Shows what the block of a motion does, under the text of its stroke. */
  explain(motion: number, text: string): void {
    this.#explanation = { motion, text };
    this.#updateTip();
  }

  /** Shows the dimensions of the edge under the pointer, if any. */
  showEdge(text: string | undefined): void {
    this.#edge = text;
    this.#updateTip();
  }

  #updateTip(): void {
    const [stroke, edge] = [this.#stroke, this.#edge];
    this.#tip.hidden = stroke === undefined && edge === undefined;
    if (this.#tip.hidden) return;
    const strokeRow =
      stroke === undefined
        ? []
        : [
            make(
              'div',
              { className: 'stroke' },
              make('span', { className: `swatch ${swatch(stroke.kind)}` }),
              make('span', { className: 'what' }, ...renderUnbroken(stroke.text)),
              make('span', { className: 'facts' }, COMMON[this.#language].line(stroke.line)),
            ),
          ];
    const does = stroke !== undefined && this.#explanation?.motion === stroke.motion ? this.#explanation.text : '';
    const blockRow = does === '' ? [] : [make('div', { className: 'does' }, ...renderUnbroken(does))];
    const edgeRow = edge === undefined ? [] : [make('div', { className: 'edge' }, edge)];
    this.#tip.replaceChildren(...strokeRow, ...blockRow, ...edgeRow);
    const bounds = this.#holder.getBoundingClientRect();
    const { width, height } = this.#tip.getBoundingClientRect();
    const x = Math.min(Math.max(this.#pointer.x + 14, 8), Math.max(bounds.width - width - 8, 8));
    const below = this.#pointer.y + 18;
    const y = below + height > bounds.height - 8 ? Math.max(this.#pointer.y - height - 12, 8) : below;
    this.#tip.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  /** Asks again for the stroke under a resting pointer, because another picture is shown. */
  repeatHitTest(): void {
    this.#reportPointer();
  }

  #showSummary(): void {
    const summary = this.#summary;
    this.#canvas.setAttribute('aria-label', this.#label(summary?.motions ?? 0));
    this.#empty.hidden = summary === undefined || summary.motions > 0;
    const kinds: [boolean, string, string][] = [
      [(summary?.rapids ?? 0) > 0, 'rapid', COMMON[this.#language].rapid],
      [(summary?.feeds ?? 0) + (summary?.arcs ?? 0) > 0, 'feed', WORDS[this.#language].feed],
      [(summary?.threads ?? 0) > 0, 'thread', WORDS[this.#language].thread],
      ...this.#work.map((what): [boolean, string, string] => [true, what, WORDS[this.#language][what]]),
      [this.#start !== '', '', WORDS[this.#language].start(this.#start)],
    ];
    const present = kinds.filter(([present]) => present);
    const shown = present.map(([, , text]) => text).join();
    if (shown === this.#shownLegend) return;
    this.#shownLegend = shown;
    this.legend.replaceChildren(
      ...present.map(([, kind, text]) =>
        make('li', {}, ...(kind === '' ? [] : [make('span', { className: `swatch ${kind}` })]), text),
      ),
    );
  }

  #zoomCentre(factor: number): void {
    const { width, height } = this.#holder.getBoundingClientRect();
    this.#events.zoom(factor, width / 2, height / 2);
  }

  #addListeners(canvas: HTMLCanvasElement): void {
    canvas.addEventListener('pointerdown', (event) => this.#onPointerDown(event));
    canvas.addEventListener('pointermove', (event) => this.#onPointerMove(event));
    canvas.addEventListener('pointerup', (event) => this.#onPointerUp(event));
    canvas.addEventListener('pointercancel', (event) => this.#pointers.delete(event.pointerId));
    canvas.addEventListener('pointerleave', (event) => {
      if (event.pointerType === 'mouse') this.#onLeave();
    });
    canvas.addEventListener('dblclick', () => this.#events.fit());
    canvas.addEventListener('wheel', (event) => this.#onWheel(event), { passive: false });
    canvas.addEventListener('keydown', (event) => this.#handleKey(event));
  }

  #pointOf(event: MouseEvent): { x: number; y: number } {
    const { x, y } = this.origin;
    return { x: event.clientX - x, y: event.clientY - y };
  }

  #onPointerDown(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.#canvas.setPointerCapture(event.pointerId);
    if (this.#pointers.size === 0) this.#dragDistance = 0;
    this.#pointers.set(event.pointerId, this.#pointOf(event));
  }

  #onPointerMove(event: PointerEvent): void {
    const now = this.#pointOf(event);
    if (this.#scrollsPage(event)) return;
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) {
      this.#pointer = now;
      this.#hovering = event.pointerType === 'mouse' ? 'mouse' : 'other';
      this.#reportPointer();
      return;
    }
    const others = [...this.#pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    const other = others[0];
    if (other !== undefined) {
      const factor =
        Math.hypot(now.x - other.x, now.y - other.y) / Math.max(Math.hypot(before.x - other.x, before.y - other.y), 1);
      this.#events.zoom(factor, (now.x + other.x) / 2, (now.y + other.y) / 2);
    }
    // With two fingers, the midpoint moves by half the distance that one finger moves.
    const share = other === undefined ? 1 : 0.5;
    const dx = (now.x - before.x) * share;
    const dy = (now.y - before.y) * share;
    this.#dragDistance += Math.hypot(dx, dy);
    this.#pointers.set(event.pointerId, now);
    if (this.#dragDistance < this.#slop(event)) return;
    this.#onLeave();
    this.#pendingPan.dx += dx;
    this.#pendingPan.dy += dy;
    this.#reportPan();
  }

  /** Whether a finger scrolls the page, not the picture. */
  #scrollsPage(event: PointerEvent): boolean {
    return event.pointerType === 'touch' && this.#canvas.matches('.of-a-page:not(:focus)');
  }

  #onPointerUp(event: PointerEvent): void {
    if (!this.#pointers.delete(event.pointerId)) return;
    if (event.pointerType === 'touch') this.#canvas.focus({ preventScroll: true });
    if (this.#dragDistance >= this.#slop(event) || this.#pointers.size > 0) return;
    this.#pointer = this.#pointOf(event);
    // A report that waits for a frame would be about the same point.
    this.#hovering = undefined;
    this.#events.onPoint(this.#pointer.x, this.#pointer.y);
    this.#events.onClick(this.#pointer.x, this.#pointer.y, event.pointerType !== 'mouse');
  }

  #slop(event: PointerEvent): number {
    return event.pointerType === 'mouse' ? CLICK_SLOP_PX.mouse : CLICK_SLOP_PX.touch;
  }

  #onLeave(): void {
    this.#hovering = undefined;
    this.#events.onLeave();
  }

  readonly #reportPointer = perFrame(() => {
    // The pointer may have left since.
    if (this.#hovering === undefined) return;
    this.#events.onPoint(this.#pointer.x, this.#pointer.y);
    if (this.#hovering === 'mouse') this.#events.onMouse?.(this.#pointer.x, this.#pointer.y);
  });
  readonly #reportPan = perFrame(() => {
    this.#events.pan(this.#pendingPan.dx, this.#pendingPan.dy);
    this.#pendingPan = { dx: 0, dy: 0 };
  });

  /** In a page that scrolls, the wheel scrolls the page until the drawing has the focus (or Ctrl is held). */
  #onWheel(event: WheelEvent): void {
    if (pageScrolls() && !event.ctrlKey && !this.#canvas.matches(':focus')) return;
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY : event.deltaY * 30;
    const { x, y } = this.#pointOf(event);
    this.#events.zoom(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0016)), x, y);
  }

  #handleKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    switch (event.key) {
      case 'ArrowLeft':
        this.#events.pan(KEY_PAN_PX, 0);
        break;
      case 'ArrowRight':
        this.#events.pan(-KEY_PAN_PX, 0);
        break;
      case 'ArrowUp':
        this.#events.pan(0, KEY_PAN_PX);
        break;
      case 'ArrowDown':
        this.#events.pan(0, -KEY_PAN_PX);
        break;
      case '+':
      case '=':
        this.#zoomCentre(KEY_ZOOM);
        break;
      case '-':
      case '−':
        this.#zoomCentre(1 / KEY_ZOOM);
        break;
      case 'f':
      case 'F':
      case 'а':
      case 'А':
      case 'Home':
        this.#events.fit();
        break;
      default:
        return;
    }
    event.preventDefault();
  }
}

function pageScrolls(): boolean {
  const page = document.scrollingElement;
  return page !== null && page.scrollHeight > page.clientHeight + 1;
}

/** `colour` is in the browser's notation, `rgb(20, 25, 31)`. */
function isDark(colour: string): boolean {
  const [red = 255, green = 255, blue = 255] = (colour.match(/[\d.]+/g) ?? []).map(Number);
  return 0.3 * red + 0.6 * green + 0.1 * blue < 128;
}

function swatch(kind: Stroke['kind']): string {
  return kind === 'rapid' || kind === 'thread' ? kind : 'feed';
}

const WORDS = words({
  en: {
    nothingToDraw: 'No motion yet. Write a move in the program, or choose an example.',
    fit: 'Show all (F)',
    zoomIn: 'Zoom in (+)',
    zoomOut: 'Zoom out (−)',
    feed: 'cutting',
    thread: 'thread',
    blank: 'cut off the blank',
    chuck: 'chuck',
    tailstock: 'tailstock',
    collision: 'collision',
    start: (at: string) => `tool starts at ${at}`,
  },
  zh: {
    nothingToDraw: '还没有运动。请编写一段移动指令，或选择一个示例。',
    fit: '显示全图 (F)',
    zoomIn: '放大 (+)',
    zoomOut: '缩小 (−)',
    feed: '切削进给',
    thread: '螺纹切削',
    blank: '毛坯切除部分',
    chuck: '卡盘',
    tailstock: '尾座',
    collision: '碰撞',
    start: (at) => `刀具起点 ${at}`,
  },
  ru: {
    nothingToDraw: 'Перемещений пока нет. Напишите кадр с перемещением или выберите пример.',
    fit: 'Показать всё (F)',
    zoomIn: 'Крупнее (+)',
    zoomOut: 'Мельче (−)',
    feed: 'рабочий ход',
    thread: 'резьба',
    blank: 'снято с заготовки',
    chuck: 'патрон',
    tailstock: 'задняя бабка',
    collision: 'столкновение',
    start: (at) => `инструмент начинает в ${at}`,
  },
});
