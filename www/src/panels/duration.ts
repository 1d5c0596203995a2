// Formats durations, with counts of the motions whose time is unknown.
//
// In: seconds and counts. Out: texts. Must not know: where they come from.

import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { words } from '../dom/words';

/** The known time, and the number of motions of unknown time. */
interface Duration {
  readonly seconds: number;
  readonly unknownCuts: number;
  readonly unknownRapids: number;
}

/** "1:38" or "1:02:09". */
export function formatClock(seconds: number): string {
  const wholeSeconds = Math.floor(seconds + 1e-6);
  const twoDigits = (value: number): string => String(value).padStart(2, '0');
  const [hours, minutes] = [Math.floor(wholeSeconds / 3600), Math.floor(wholeSeconds / 60) % 60];
  return hours > 0
    ? `${hours}:${twoDigits(minutes)}:${twoDigits(wholeSeconds % 60)}`
    : `${minutes}:${twoDigits(wholeSeconds % 60)}`;
}

/** " + 102 rapids": the motions that the time does not include; empty if it includes all. */
export function unknownCounts({ unknownCuts, unknownRapids }: Duration, language: Language): string {
  const texts = WORDS[language];
  const rapids = unknownRapids > 0 ? ` + ${texts.rapids(unknownRapids)}` : '';
  const cuts = unknownCuts > 0 ? ` + ${texts.cuts(unknownCuts)}` : '';
  return rapids + cuts;
}

const WORDS = words({
  en: {
    rapids: counter('en', { one: 'rapid', other: 'rapids' }),
    cuts: counter('en', { one: 'cut', other: 'cuts' }),
  },
  zh: {
    rapids: (n) => `${n} 段快移`,
    cuts: (n) => `${n} 段切削`,
  },
  ru: {
    rapids: counter('ru', {
      one: 'ускоренный ход',
      few: 'ускоренных хода',
      many: 'ускоренных ходов',
      other: 'ускоренного хода',
    }),
    cuts: counter('ru', { one: 'рабочий ход', few: 'рабочих хода', many: 'рабочих ходов', other: 'рабочего хода' }),
  },
});
