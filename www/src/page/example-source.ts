// The source of an example, and the changes of the program against it, as paragraphs.
//
// In: an entry of the gallery, or the id of an example. Out: elements for the gallery and for the lines above the
// program. Loaded when one of them needs it. Must not know: the content of a program.

import { make, renderUnbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { loadChapters, type Change, type ListedExample } from './gallery';

type Content = (Node | string)[];

/** Rejected if the list of examples could not be loaded. */
export async function loadSource(id: string, language: Language): Promise<HTMLElement[]> {
  const chapters = await loadChapters(language);
  const listed = chapters.flatMap(({ examples }) => examples).find((example) => example.id === id);
  return listed === undefined ? [] : renderSource(listed, language);
}

export function renderSource({ source, changed }: ListedExample, language: Language): HTMLElement[] {
  const paragraphs = [make('p', {}, ...renderUnbroken(source))];
  if (changed === 'nothing') paragraphs.push(make('p', {}, WORDS[language].nothing));
  else if (changed !== undefined)
    paragraphs.push(...changed.map((change) => make('p', {}, ...describe(change, language))));
  return paragraphs;
}

/** "`M30` added (line 5). The printed program has no end." */
function describe({ places, why }: Change, language: Language): Content {
  const texts = WORDS[language];
  // The same difference in several lines is named once.
  const lines = new Map<string, number[]>();
  for (const { line, word, source } of places) {
    const difference = JSON.stringify([word, source]);
    const own = word.split('\n').map((_, i) => line + i);
    lines.set(difference, [...(lines.get(difference) ?? []), ...own]);
  }
  const differences = [...lines].flatMap(([difference, own], i): Content => {
    const [word, source] = JSON.parse(difference) as readonly [string, string | null];
    const said = source === null ? texts.added(code(word)) : texts.replaced(code(word), code(source));
    return [i === 0 ? '' : texts.separator, ...said, texts.lines(ranges(own), own.length > 1)];
  });
  return [...differences, texts.end, ...renderUnbroken(why)];
}

function code(blocks: string): Node {
  return make('code', { lang: 'en' }, ...renderUnbroken(blocks.replaceAll('\n', ' ')));
}

/** "1–4, 12" */
function ranges(lines: readonly number[]): string {
  const found: [first: number, last: number][] = [];
  for (const line of lines) {
    const last = found.at(-1);
    if (last?.[1] === line - 1) last[1] = line;
    else found.push([line, line]);
  }
  return found.map(([first, last]) => (first === last ? `${first}` : `${first}–${last}`)).join(', ');
}

const WORDS = words({
  en: {
    nothing: 'The program is unchanged.',
    added: (word: Node): Content => [word, ' added'],
    replaced: (word: Node, source: Node): Content => [word, ' instead of ', source],
    lines: (numbers: string, several: boolean) => ` (${several ? 'lines' : 'line'} ${numbers})`,
    separator: ', ',
    end: '. ',
  },
  zh: {
    nothing: '程序与原文相同。',
    added: (word) => ['补充 ', word],
    replaced: (word, source) => [word, '，原文为 ', source],
    lines: (numbers) => `（第 ${numbers} 行）`,
    separator: '；',
    end: '。',
  },
  ru: {
    nothing: 'Программа не изменена.',
    added: (word) => ['добавлено ', word],
    replaced: (word, source) => [word, ' вместо ', source],
    lines: (numbers, several) => ` (${several ? 'строки' : 'строка'} ${numbers})`,
    separator: ', ',
    end: '. ',
  },
});
