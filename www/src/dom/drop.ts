// Files dropped on a part of the page.
//
// In: the element they may be dropped on. Out: `dropped`, with the first of them. While one is over it, the
// element's `data-drop` says so. Must not know: what is done with a file.

export interface DropEvents {
  /** What to say while a file is held over the element. */
  hint(): string;
  dropped(file: File): void;
}

export function acceptFiles(target: HTMLElement, events: DropEvents): void {
  const carriesFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  const mark = (on: boolean): void => {
    target.dataset['drop'] = on ? events.hint() : '';
  };
  target.addEventListener('dragover', (event) => {
    if (!carriesFile(event)) return;
    event.preventDefault();
    mark(true);
  });
  target.addEventListener('dragleave', (event) => {
    if (!target.contains(event.relatedTarget as Node | null)) mark(false);
  });
  target.addEventListener(
    'drop',
    (event) => {
      mark(false);
      const file = event.dataTransfer?.files[0];
      if (file === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      events.dropped(file);
    },
    { capture: true },
  );
}
