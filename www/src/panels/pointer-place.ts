// X and Z at the pointer, in the corner of the section.
//
// In: the position of the pointer, the scale of the picture, the unit. Out: an element, which screen readers do not
// read: it changes with each movement. Must not know: the contents of the picture.

import { make, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import type { LengthUnit, SectionScale } from '../protocol/protocol';
import { formatPlace, unitSymbol } from './lengths';
import type { Place } from './panel';

/** The steps to which a place is rounded, mm. */
const STEPS = [0.1, 0.5, 1];
/** The least size of a step, pixels, so that it can be pointed at. */
const STEP_PIXELS = 6;

export class PointerPlace {
  readonly #x = make('span', { className: 'value' });
  readonly #z = make('span', { className: 'value' });
  readonly #symbol = make('span');
  readonly element = make(
    'p',
    { className: 'pointer-place', part: 'pointer', 'aria-hidden': 'true', hidden: true },
    'X Ø',
    this.#x,
    'Z',
    this.#z,
    this.#symbol,
  );
  #pointer: readonly [number, number] | undefined;
  #scale: SectionScale | undefined;
  #unit: LengthUnit = 'mm';

  /** In pixels of the picture; undefined: the pointer is not over the section. */
  set pointer(pointer: readonly [number, number] | undefined) {
    this.#pointer = pointer;
    this.#show();
  }

  /** Undefined: the picture is an old one. */
  set scale(scale: SectionScale | undefined) {
    this.#scale = scale;
    this.#show();
  }

  setUnit(unit: LengthUnit, language: Language): void {
    this.#unit = unit;
    // Millimetres are the default and need no label.
    setText(this.#symbol, unit === 'mm' ? '' : unitSymbol(unit, language));
    this.#show();
  }

  /** The place at a pixel of the picture, rounded to a step; undefined if the picture is an old one. */
  roundedAt(x: number, y: number): Place | undefined {
    if (this.#scale === undefined) return undefined;
    const { origin, perX, perZ } = this.#scale;
    const place = (pixels: number, perMm: number): number => {
      const step = STEPS.find((step) => step * Math.abs(perMm) >= STEP_PIXELS) ?? 1;
      return Math.round(pixels / perMm / step) * step;
    };
    return { x: place(y - origin[1], perX), z: place(x - origin[0], perZ) };
  }

  #show(): void {
    const [pointer, scale] = [this.#pointer, this.#scale];
    this.element.hidden = pointer === undefined || scale === undefined;
    if (pointer === undefined || scale === undefined) return;
    const [x, y] = pointer;
    const { origin, perX, perZ } = scale;
    const place = (pixels: number, perMm: number): string =>
      formatPlace(pixels / perMm, this.#unit, Math.abs(1 / perMm));
    setText(this.#x, place(y - origin[1], perX));
    setText(this.#z, place(x - origin[0], perZ));
  }
}
