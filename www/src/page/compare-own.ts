// The list of the user's saved programs and of earlier states of the open one, to compare with.
//
// In: the `PageHost` and the list of saved programs. Out: a call of `onChoose` with text and name. The list is hidden
// if nothing is saved or the browser has no storage. Must not know: how programs are saved or compared.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMPARE_WORDS } from './compare-words';
import { listPrograms, readProgram, readState, readStates } from './own-programs-store';
import type { PageHost } from './page-host';
import type { SavedProgram } from './storage';

/** Maximum number of entries of each kind; the rest are in "My programs…" only. */
const MAX_LISTED = 100;

/** A version to compare with, and its display name. */
export interface OtherProgram {
  readonly name: string;
  readonly text: string;
}

interface Choice {
  readonly name: string;
  readonly load: () => Promise<SavedProgram | undefined>;
}

/** The available choices: earlier states of the program, then other programs. */
async function loadChoices(
  { saver: { id } }: PageHost,
  language: Language,
): Promise<readonly [states: readonly Choice[], programs: readonly Choice[]]> {
  const texts = COMPARE_WORDS[language];
  const date = new Intl.DateTimeFormat(language, { dateStyle: 'medium', timeStyle: 'short' });
  const [states, programs] = await Promise.all([id === undefined ? [] : readStates(id), listPrograms()]);
  return [
    states
      .slice(0, MAX_LISTED)
      .map((state) => ({ name: date.format(state.time), load: () => readState(id ?? '', state) })),
    programs
      .filter((own) => own.id !== id)
      .slice(0, MAX_LISTED)
      .map((own) => ({
        name: `${own.name === '' ? texts.unnamed : own.name} · ${date.format(own.changed)}`,
        load: () => readProgram(own.id),
      })),
  ];
}

/** Fills `select`, which stays hidden if there is no choice, and calls `onChoose` for each selection. */
export async function fillOwnPrograms(
  select: HTMLSelectElement,
  host: PageHost,
  language: Language,
  onChoose: (other: OtherProgram) => void,
): Promise<void> {
  const texts = COMPARE_WORDS[language];
  const [states, programs] = await loadChoices(host, language).catch(() => [[], []] as const);
  const all = [...states, ...programs];
  const group = (label: string, own: readonly Choice[]): HTMLElement[] =>
    own.length === 0
      ? []
      : [
          make(
            'optgroup',
            { label },
            ...own.map((choice) => make('option', { value: String(all.indexOf(choice)) }, choice.name)),
          ),
        ];
  select.replaceChildren(
    make('option', { value: '' }, texts.own),
    ...group(texts.states, states),
    ...group(texts.programs, programs),
  );
  select.hidden = all.length === 0;
  select.onchange = () => {
    const choice = all[Number(select.value)];
    if (select.value === '' || choice === undefined) return;
    void choice
      .load()
      .catch(() => undefined)
      .then((program) => onChoose({ name: choice.name, text: program?.text ?? '' }));
  };
}
