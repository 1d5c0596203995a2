// The elements that the page is written with, by their names in `index.html`.

export function find<E extends HTMLElement = HTMLElement>(id: string): E {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no #${id}`);
  return element as E;
}

/** The words in front of a list to choose from. */
export function label(select: HTMLSelectElement, text: string): void {
  const caption = select.previousElementSibling;
  if (caption !== null) caption.textContent = text;
}
