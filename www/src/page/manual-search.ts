// The script of the pages of the manual: the search in the language of the page, and links to other languages.
//
// In: `search.json` beside the page, with the text of each section. Out: links to sections. The list is loaded when the
// field gets the focus; without this script the field is hidden. Must not know: the contents of the pages.
import MiniSearch from 'minisearch';

/** A section of a page. */
interface Section {
  readonly id: number;
  /** File stem of the page. */
  readonly page: string;
  /** The anchor of its heading; empty for the beginning of the page. */
  readonly anchor: string;
  /** Title of the page. */
  readonly title: string;
  readonly heading: string;
  readonly text: string;
}

const MAX_RESULTS = 10;

/**
 * The terms of a text. Chinese has no blanks between words: each pair of characters is a term. A code is found with and
 * without its leading zero: G01 is G1.
 */
export function termsOf(text: string): string[] {
  const words = text.toLowerCase().match(/[\p{L}\p{N}]+(?:\.\p{N}+)?/gu) ?? [];
  return words.flatMap((word) => {
    const runs = word.match(/\p{Script=Han}+|[^\p{Script=Han}]+/gu) ?? [];
    return runs.flatMap((run) => {
      if (!/^\p{Script=Han}/u.test(run)) return [run.replace(/^([gm])0+(?=\d)/, '$1')];
      const characters = [...run];
      return characters.length === 1
        ? characters
        : characters.slice(1).map((second, at) => `${characters[at]}${second}`);
    });
  });
}

/** The sections that contain all terms of a query, the best first. */
export class SectionIndex {
  readonly #index = new MiniSearch<Section>({
    fields: ['title', 'heading', 'text'],
    storeFields: ['page', 'anchor', 'title', 'heading'],
    tokenize: termsOf,
    processTerm: (term) => term,
  });

  constructor(sections: readonly Section[]) {
    this.#index.addAll(sections);
  }

  find(query: string): readonly Pick<Section, 'page' | 'anchor' | 'title' | 'heading'>[] {
    const found = this.#index.search(query, {
      boost: { title: 4, heading: 2 },
      combineWith: 'AND',
      prefix: (term) => !/\p{Script=Han}/u.test(term),
    });
    return found.slice(0, MAX_RESULTS) as unknown as Section[];
  }
}

async function load(): Promise<SectionIndex> {
  const response = await fetch('search.json');
  if (!response.ok) throw new Error(`search.json: ${response.status}`);
  return new SectionIndex((await response.json()) as Section[]);
}

function start(form: HTMLFormElement): void {
  const field = form.querySelector('input');
  const list = form.querySelector('ul');
  const count = form.querySelector('output');
  if (field === null || list === null || count === null) return;
  let index: Promise<SectionIndex> | undefined;
  const prepare = (): Promise<SectionIndex> => {
    index ??= load().catch((error: unknown) => {
      // The next attempt loads it again.
      index = undefined;
      throw error;
    });
    return index;
  };
  const show = async (): Promise<void> => {
    const query = field.value.trim();
    const found = query === '' ? [] : (await prepare()).find(query);
    // Another letter was typed in the meantime.
    if (query !== field.value.trim()) return;
    list.replaceChildren(
      ...found.map(({ page, anchor, title, heading }) => {
        const link = document.createElement('a');
        link.href = `${page}.html${anchor === '' ? '' : `#${anchor}`}`;
        link.textContent = heading === title ? title : `${title} · ${heading}`;
        const item = document.createElement('li');
        item.append(link);
        return item;
      }),
    );
    count.textContent = query === '' ? '' : found.length === 0 ? (form.dataset['none'] ?? '') : String(found.length);
  };
  field.addEventListener('focus', () => void prepare().catch(() => undefined));
  field.addEventListener('input', () => void show().catch(() => undefined));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    void show()
      .then(() => list.querySelector('a')?.click())
      .catch(() => undefined);
  });
  form.hidden = false;
}

for (const form of document.querySelectorAll<HTMLFormElement>('form.search')) start(form);

/** The links to the page in other languages keep the heading: its anchor is the same there. */
function keepHeading(): void {
  for (const link of document.querySelectorAll<HTMLAnchorElement>('header a[hreflang]')) link.hash = location.hash;
}

keepHeading();
addEventListener('hashchange', keepHeading);
