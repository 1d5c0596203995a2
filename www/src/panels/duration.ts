// Formats durations, with the number of cuts whose time is unknown.
//
// In: seconds and counts. Out: texts. Must not know: where they come from.

import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { words } from '../dom/words';

/** The known time, the time of rapids at the assumed rate, and the number of cuts of unknown time. */
interface Duration {
  readonly seconds: number;
  readonly assumedSeconds: number;
  readonly unknownCuts: number;
}

/** "3:32": with the rapids at the assumed rate, and "3:32 + 2 cuts" if the time of cuts is unknown. */
export function formatDuration(duration: Duration, language: Language): string {
  const { seconds, assumedSeconds, unknownCuts } = duration;
  const all = seconds + assumedSeconds;
  if (unknownCuts === 0) return formatClock(all);
  const cuts = WORDS[language].cuts(unknownCuts);
  return all === 0 ? cuts : `${formatClock(all)} + ${cuts}`;
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

/** What the time assumes, and what it does not include; empty if neither. */
export function durationNote(
  { unknownRapids, unknownCuts }: { readonly unknownRapids: number; readonly unknownCuts: number },
  language: Language,
): string {
  const { rapidsAssumed, cutsUnknown } = WORDS[language];
  const notes = [unknownRapids > 0 ? rapidsAssumed : '', unknownCuts > 0 ? cutsUnknown : ''];
  return notes.filter((note) => note !== '').join(' ');
}

const WORDS = words({
  en: {
    cuts: counter('en', { one: 'cut', other: 'cuts' }),
    rapidsAssumed: 'The setup gives no rapid traverse rate: 8,000 mm/min is assumed.',
    cutsUnknown: 'How long some cuts take is not known: they have no feed rate, or the spindle is stopped.',
  },
  zh: {
    cuts: (n) => `${n} 段切削`,
    rapidsAssumed: '设置中没有给出快移速度，按 8,000 mm/min 计算。',
    cutsUnknown: '部分切削所需时间未知：没有进给量，或主轴未转动。',
  },
  ru: {
    rapidsAssumed: 'В наладке нет скорости ускоренного хода: взято 8 000 мм/мин.',
    cutsUnknown: 'Время некоторых рабочих ходов неизвестно: нет подачи или шпиндель не вращается.',
    cuts: counter('ru', { one: 'рабочий ход', few: 'рабочих хода', many: 'рабочих ходов', other: 'рабочего хода' }),
  },
});
