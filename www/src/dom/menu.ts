// A menu button and its menu, as in the ARIA pattern: Enter, Space and the arrows open it; arrows, Home, End and first
// letters move in it; Escape, Tab and a click outside close it.
//
// In: the contents; each item has the role `menuitem`, and its own listener of `click`. The items may be added later,
// and may be in slots. Out: the button and the menu. Must not know: the purpose of an item.

import { make } from './dom';
import { placePopover } from './popover';

/** An item of a menu; its text and its listener of `click` follow. */
export function menuItem(properties: Readonly<Record<string, string | boolean>> = {}): HTMLButtonElement {
  return make('button', { type: 'button', role: 'menuitem', tabIndex: -1, ...properties });
}

export class Menu {
  readonly button: HTMLButtonElement;
  readonly element: HTMLElement;
  /** The button at which the menu is open, if it is not its own. */
  #opener: HTMLElement | undefined;

  /** `name` is the class and the part of the button (`name-button`) and of the menu. */
  constructor(name: string, button: readonly Node[], contents: readonly Node[]) {
    this.button = make(
      'button',
      { type: 'button', className: `${name}-button`, 'aria-haspopup': 'menu', 'aria-expanded': 'false' },
      ...button,
    );
    this.element = make(
      'div',
      { className: `menu ${name}-menu`, part: `menu ${name}-menu`, role: 'menu', popover: 'auto' },
      ...contents,
    );
    this.button.popoverTargetElement = this.element;
    this.button.addEventListener('keydown', (event) => {
      // A key that is typed before the first item has the focus.
      if (this.open) return this.#handleKey(event);
      if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
      event.preventDefault();
      this.element.showPopover();
      this.#focusItem(event.key === 'ArrowUp' ? -1 : 0);
    });
    this.element.addEventListener('keydown', (event) => this.#handleKey(event));
    // Closed before the item acts, so that a dialog that the item opens returns the focus to the button.
    this.element.addEventListener(
      'click',
      (event) => {
        const path = event.composedPath();
        if (!this.#visible.some((item) => path.includes(item))) return;
        this.#close();
      },
      { capture: true },
    );
    this.element.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.button.setAttribute('aria-expanded', String(open));
      if (!open) return;
      placePopover(this.#opener ?? this.button, this.element);
      if (!this.#visible.some((item) => isFocused(item))) this.#focusItem(0);
    });
  }

  set label(text: string) {
    this.element.setAttribute('aria-label', text);
  }

  get open(): boolean {
    return this.element.matches(':popover-open');
  }

  /** Opens the menu at another button, which has the focus once the menu is closed. */
  openAt(opener: HTMLElement): void {
    this.#opener = opener;
    this.element.showPopover();
  }

  #close(): void {
    const opener = this.#opener ?? this.button;
    this.element.hidePopover();
    opener.focus();
  }

  /** The items that can be chosen, whether or not the menu is open. */
  get choices(): readonly HTMLElement[] {
    const all = [...this.element.querySelectorAll<HTMLElement>('[role^=menuitem], slot')].flatMap((found) =>
      found instanceof HTMLSlotElement ? found.assignedElements({ flatten: true }).flatMap(itemsIn) : [found],
    );
    return all.filter(
      (item): item is HTMLElement =>
        item instanceof HTMLElement && item.closest('[hidden]') === null && !item.matches(':disabled'),
    );
  }

  /** The items that can have the focus; none while the menu is closed. */
  get #visible(): readonly HTMLElement[] {
    return this.choices.filter((item) => item.checkVisibility());
  }

  #handleKey(event: KeyboardEvent): void {
    const items = this.#visible;
    const at = items.findIndex((item) => event.composedPath().includes(item));
    if (event.key === 'ArrowDown') this.#focusItem(at + 1);
    else if (event.key === 'ArrowUp') this.#focusItem(at < 0 ? -1 : at - 1);
    else if (event.key === 'Home') this.#focusItem(0);
    else if (event.key === 'End') this.#focusItem(-1);
    else if (event.key === 'Tab' || event.key === 'Escape') {
      this.#close();
    } else if (event.key.length === 1 && event.key !== ' ' && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const letter = event.key.toLocaleLowerCase();
      const order = items.map((_, step) => items[(at + 1 + step) % items.length]);
      order.find((item) => item?.textContent?.trim().toLocaleLowerCase().startsWith(letter))?.focus();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Focuses an item; the index wraps around. */
  #focusItem(index: number): void {
    const items = this.#visible;
    items.at(index % items.length)?.focus();
  }
}

function isFocused(item: HTMLElement): boolean {
  return (item.getRootNode() as Document | ShadowRoot).activeElement === item;
}

/** The element itself, or the items in it. */
function itemsIn(element: Element): readonly Element[] {
  return element.matches('[role^=menuitem]') ? [element] : [...element.querySelectorAll('[role^=menuitem]')];
}
