// Files dropped on a part of the page.
//
// In: the element they may be dropped on. Out: `dropped`, with the first of them. While one is over it, the
// element's `data-drop` says so. Must not know: what is done with a file.

export interface DropEvents {
  /** What to say while a file is held over the element. */
  hint(): string;
  dropped(file: File): void;
}

/** Files of all that is inside, before anything inside takes them; or those that nothing inside has taken. */
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
