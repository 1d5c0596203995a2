// Where a popover opens: below its button if there is room, otherwise above it; always within the window.
//
// In: the button and the popover, which is open. Out: the position of the popover. Must not know: its contents.

/** Distance between the button and the popover, and between the popover and the edge of the window, CSS pixels. */
const [GAP_PX, MARGIN_PX] = [4, 8];

/** The popover has `position: fixed`. */
export function placePopover(button: HTMLElement, popover: HTMLElement): void {
  const { left, right, top, bottom } = button.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = popover;
  const x = left + width > innerWidth - MARGIN_PX ? right - width : left;
  const hasRoomBelow = bottom + GAP_PX + height <= innerHeight - MARGIN_PX;
  const y = hasRoomBelow || top - GAP_PX - height < MARGIN_PX ? bottom + GAP_PX : top - GAP_PX - height;
  popover.style.left = `${Math.max(MARGIN_PX, Math.min(x, innerWidth - MARGIN_PX - width))}px`;
  popover.style.top = `${Math.max(MARGIN_PX, Math.min(y, innerHeight - MARGIN_PX - height))}px`;
}

/** Closing a popover returns the focus from it to its button, which Chromium does not do in a shadow tree. */
export function returnFocus(button: HTMLElement, popover: HTMLElement): void {
  popover.addEventListener('beforetoggle', (event) => {
    if (event.newState === 'closed' && popover.matches(':focus-within')) button.focus();
  });
}
