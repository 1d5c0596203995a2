// Times as people read them, and what of a time is not known.
//
// In: seconds and counts. Out: texts. Must not know: where they come from.

import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { words } from '../dom/words';

/** A time as far as it is known. */
export interface Duration {
  readonly seconds: number;
  readonly unknownCuts: number;
  readonly unknownRapids: number;
}

/** "1:38" or "1:02:09". */
export function clock(seconds: number): string {
  const whole = Math.floor(seconds + 1e-6);
  const two = (value: number): string => String(value).padStart(2, '0');
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}

/** " + 102 rapids": what is not in the time; empty where all is. */
export function countsOfUnknown({ unknownCuts, unknownRapids }: Duration, language: Language): string {
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
