// Accepts files dropped on a part of the page.
//
// In: the element to drop on. Out: `dropped`, with the first file. While a file is over the element, its `data-drop`
// has the hint. Must not know: what happens to a file.

export interface DropEvents {
  /** The hint while a file is over the element. */
  hint(): string;
  dropped(file: File): void;
}

/**
 * `all`: files dropped anywhere inside, before any inner element handles them; `left-over`: only files that no inner
 * element has handled.
 */
export type DropsTaken = 'all' | 'left-over';

export function acceptFiles(target: HTMLElement, events: DropEvents, taken: DropsTaken = 'all'): void {
  const isMine = (event: DragEvent): boolean =>
    (event.dataTransfer?.types.includes('Files') ?? false) && (taken === 'all' || !event.defaultPrevented);
  const mark = (on: boolean): void => {
    if (on) target.dataset['drop'] = events.hint();
    else delete target.dataset['drop'];
  };
  target.addEventListener('dragover', (event) => {
    const mine = isMine(event);
    mark(mine);
    if (mine) event.preventDefault();
  });
  target.addEventListener('dragleave', (event) => {
    if (!target.contains(event.relatedTarget as Node | null)) mark(false);
  });
  target.addEventListener(
    'drop',
    (event) => {
      mark(false);
      const file = isMine(event) ? event.dataTransfer?.files[0] : undefined;
      if (file === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      events.dropped(file);
    },
    { capture: taken === 'all' },
  );
}
