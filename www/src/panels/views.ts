// The row over the drawing: which pictures are shown, the turret's side, and the part that later ones are compared with.
//
// In: what there is to see, and the width there is. Out: which pictures to show, and the events below.
// Must not know: how anything is drawn or compared.

import { make } from '../dom/dom';
import { shown } from './dimension';
import type { Strings } from '../dom/i18n';
import type { Comparison, TurretSide, ViewsState } from '../protocol/protocol';

/** Narrower than this, CSS pixels, there is room for one picture only. */
const ROOM_FOR_BOTH = 620;

export type Pictures = 'section' | 'face' | 'both';

export interface ViewsEvents {
  chosen(pictures: Pictures): void;
  turned(side: TurretSide): void;
  kept(): void;
  ended(): void;
}

export class Views {
  readonly element: HTMLElement;
  readonly #events: ViewsEvents;
  readonly #choice = make('div', { className: 'choice', role: 'radiogroup', hidden: true });
  readonly #buttons: Readonly<Record<Pictures, HTMLButtonElement>>;
  readonly #turret = make('button', { type: 'button', className: 'level' });
  readonly #keep = make('button', { type: 'button', className: 'small' });
  readonly #end = make('button', { type: 'button', className: 'small', hidden: true });
  readonly #differences = make('div', { className: 'differences', 'aria-live': 'polite', hidden: true });
  readonly #sizes = new ResizeObserver(() => {
    // What floats over the drawing stands below this row.
    this.element.parentElement?.style.setProperty('--views-size', `${this.element.offsetHeight}px`);
    this.#show();
  });
  #strings: Strings;
  #state: ViewsState = { face: false, turret: 'rear', comparison: undefined };
  #wanted: Pictures = 'both';
  #told: Pictures = 'section';

  constructor(strings: Strings, events: ViewsEvents) {
    this.#strings = strings;
    this.#events = events;
    const button = (pictures: Pictures): HTMLButtonElement => {
      const made = make('button', { type: 'button', className: 'level', role: 'radio' });
      made.addEventListener('click', () => this.#choose(pictures));
      made.addEventListener('keydown', (event) => this.#key(event));
      return made;
    };
    this.#buttons = { section: button('section'), face: button('face'), both: button('both') };
    this.#choice.append(...Object.values(this.#buttons));
    this.#turret.addEventListener('click', () => events.turned(this.#state.turret === 'front' ? 'rear' : 'front'));
    this.#keep.addEventListener('click', () => events.kept());
    this.#end.addEventListener('click', () => {
      events.ended();
      this.#keep.focus();
    });
    this.element = make(
      'div',
      { className: 'views', part: 'views', role: 'group' },
      this.#choice, this.#turret, this.#keep, this.#end, this.#differences,
    );
    this.#sizes.observe(this.element);
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    const { views: words } = strings;
    this.element.setAttribute('aria-label', words.views);
    this.#choice.setAttribute('aria-label', words.view);
    for (const pictures of ['section', 'face', 'both'] as const) this.#buttons[pictures].textContent = words[pictures];
    this.#turret.textContent = words.frontTurret;
    this.#turret.title = words.frontTurretHint;
    this.#keep.textContent = words.keep;
    this.#keep.title = words.keepHint;
    this.#end.textContent = words.endComparison;
    this.#show();
  }

  set state(state: ViewsState) {
    this.#state = state;
    this.#show();
  }

  #choose(pictures: Pictures): void {
    this.#wanted = pictures;
    this.#show();
  }

  #key(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
    if (step === undefined) return;
    const order = (['section', 'face', 'both'] as const).filter((pictures) => !this.#buttons[pictures].hidden);
    const next = order[(order.indexOf(this.#told) + step + order.length) % order.length];
    if (next === undefined) return;
    this.#choose(next);
    this.#buttons[next].focus();
    event.preventDefault();
  }

  #show(): void {
    const { face, turret, comparison } = this.#state;
    const wide = this.element.getBoundingClientRect().width >= ROOM_FOR_BOTH;
    const pictures = !face ? 'section' : this.#wanted === 'both' && !wide ? 'face' : this.#wanted;
    this.#choice.hidden = !face;
    this.#buttons.both.hidden = !wide;
    for (const [own, button] of Object.entries(this.#buttons)) {
      button.setAttribute('aria-checked', String(own === pictures));
      button.tabIndex = own === pictures ? 0 : -1;
    }
    this.#turret.setAttribute('aria-pressed', String(turret === 'front'));
    this.#keep.hidden = comparison !== undefined;
    this.#end.hidden = this.#differences.hidden = comparison === undefined;
    if (comparison !== undefined) this.#differences.replaceChildren(...this.#tell(comparison));
    if (pictures !== this.#told) {
      this.#told = pictures;
      this.#events.chosen(pictures);
    }
  }

  #tell({ differences, radial, axial }: Comparison): (Node | string)[] {
    const { views: words } = this.#strings;
    if (radial === undefined || axial === undefined) return [words.same];
    const key = (side: 'first' | 'second', text: string): Node[] =>
      differences.some(({ only }) => only === side)
        ? [make('span', { className: 'only' }, make('span', { className: `patch ${side}` }), text)]
        : [];
    const largest = words.largest(shown(radial.length), shown(radial.from.z), shown(axial.length), shown(axial.from.x));
    return [...key('first', words.onlyKept), ...key('second', words.onlyNow), make('span', {}, largest)];
  }
}
