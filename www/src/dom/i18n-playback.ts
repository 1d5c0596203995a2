// The words of the playback and of its read-out, in English, Chinese and Russian.
//
// In: nothing. Out: a table for each language. Must not know: what is played.

import { counter } from './plural';
import type { Readout, StepUnit } from '../protocol/protocol';

export interface PlaybackStrings {
  readonly previous: Readonly<Record<StepUnit, string>>;
  readonly next: Readonly<Record<StepUnit, string>>;
  readonly stepBy: string;
  readonly units: Readonly<Record<StepUnit, string>>;
  readonly wholeIn: (seconds: number) => string;
  readonly optionalStops: string;
  readonly optionalStopsHint: string;
  readonly stopped: (code: string, line: number) => string;
  // the read-out
  readonly readout: string;
  readonly feed: string;
  readonly spindle: string;
  readonly surfaceSpeed: string;
  readonly time: string;
  readonly tool: string;
  readonly perMinute: string;
  readonly perTurn: string;
  readonly turns: string;
  readonly metres: string;
  readonly rapids: (n: number) => string;
  readonly cuts: (n: number) => string;
  readonly notKnown: string;
  readonly unknownTime: (rapids: number, cuts: number) => string;
  readonly kinds: Readonly<Record<NonNullable<Readout['toolKind']>, string>>;
  readonly assumed: (tool: string) => string;
}

const en: PlaybackStrings = {
  previous: { motion: 'Previous motion', block: 'Previous block', pass: 'Previous pass' },
  next: { motion: 'Next motion', block: 'Next block', pass: 'Next pass' },
  stepBy: 'Step by',
  units: { motion: 'motion', block: 'block', pass: 'pass' },
  wholeIn: (seconds) => `all in ${seconds} s`,
  optionalStops: 'Optional stop',
  optionalStopsHint: 'When on, the playback stops at M01 too',
  stopped: (code, line) => `${code} in line ${line}: the program stops here. Play goes on.`,
  readout: 'Where the tool is',
  feed: 'Feed',
  spindle: 'Spindle',
  surfaceSpeed: 'Cutting speed',
  time: 'Time',
  tool: 'Tool',
  perMinute: 'mm/min',
  perTurn: 'mm/rev',
  turns: 'rpm',
  metres: 'm/min',
  rapids: counter('en', { one: 'rapid', other: 'rapids' }),
  cuts: counter('en', { one: 'cut', other: 'cuts' }),
  notKnown: 'not known',
  unknownTime: (rapids, cuts) =>
    [
      rapids > 0 ? 'How long rapids take is not known: the setup gives no rapid rate.' : '',
      cuts > 0 ? 'How long some cuts take is not known: they lack a feed or a turning spindle.' : '',
    ].join(' ').trim(),
  kinds: {
    turning: 'turning tool', boring: 'boring bar', grooving: 'grooving tool', threading: 'threading tool',
    drill: 'drill', tap: 'tap', endmill: 'live end mill',
  },
  assumed: (tool) => `${tool}, assumed`,
};

const zh: PlaybackStrings = {
  previous: { motion: '上一段运动', block: '上一程序段', pass: '上一次走刀' },
  next: { motion: '下一段运动', block: '下一程序段', pass: '下一次走刀' },
  stepBy: '步进单位',
  units: { motion: '运动', block: '程序段', pass: '走刀' },
  wholeIn: (seconds) => `全程 ${seconds} 秒`,
  optionalStops: '选择停止',
  optionalStopsHint: '打开后，播放到 M01 时也停下',
  stopped: (code, line) => `第 ${line} 行 ${code}：程序在此停止，按“播放”继续。`,
  readout: '刀具状态',
  feed: '进给',
  spindle: '主轴',
  surfaceSpeed: '切削速度',
  time: '时间',
  tool: '刀具',
  perMinute: 'mm/min',
  perTurn: 'mm/r',
  turns: 'r/min',
  metres: 'm/min',
  rapids: (n) => `${n} 段快移`,
  cuts: (n) => `${n} 段切削`,
  notKnown: '未知',
  unknownTime: (rapids, cuts) =>
    [
      rapids > 0 ? '快速移动所需时间未知：设置中没有给出快移速度。' : '',
      cuts > 0 ? '部分切削所需时间未知：没有进给量，或主轴未转动。' : '',
    ].join(''),
  kinds: {
    turning: '车刀', boring: '镗刀', grooving: '切槽刀', threading: '螺纹刀',
    drill: '钻头', tap: '丝锥', endmill: '动力铣刀',
  },
  assumed: (tool) => `${tool}（推测）`,
};

const ru: PlaybackStrings = {
  previous: { motion: 'Предыдущее перемещение', block: 'Предыдущий кадр', pass: 'Предыдущий проход' },
  next: { motion: 'Следующее перемещение', block: 'Следующий кадр', pass: 'Следующий проход' },
  stepBy: 'Шаг',
  units: { motion: 'перемещение', block: 'кадр', pass: 'проход' },
  wholeIn: (seconds) => `всё за ${seconds} с`,
  optionalStops: 'Останов по выбору',
  optionalStopsHint: 'Если включено, показ останавливается и на M01',
  stopped: (code, line) => `${code} в строке ${line}: здесь программа останавливается. «Пуск» — дальше.`,
  readout: 'Где инструмент',
  feed: 'Подача',
  spindle: 'Шпиндель',
  surfaceSpeed: 'Скорость рез.',
  time: 'Время',
  tool: 'Инструмент',
  perMinute: 'мм/мин',
  perTurn: 'мм/об',
  turns: 'об/мин',
  metres: 'м/мин',
  rapids: counter('ru', { one: 'ускоренный ход', few: 'ускоренных хода', many: 'ускоренных ходов', other: 'ускоренного хода' }),
  cuts: counter('ru', { one: 'рабочий ход', few: 'рабочих хода', many: 'рабочих ходов', other: 'рабочего хода' }),
  notKnown: 'неизвестно',
  unknownTime: (rapids, cuts) =>
    [
      rapids > 0 ? 'Время ускоренных ходов неизвестно: в наладке нет скорости ускоренного хода.' : '',
      cuts > 0 ? 'Время некоторых рабочих ходов неизвестно: нет подачи или шпиндель не вращается.' : '',
    ].join(' ').trim(),
  kinds: {
    turning: 'проходной резец', boring: 'расточной резец', grooving: 'канавочный резец', threading: 'резьбовой резец',
    drill: 'сверло', tap: 'метчик', endmill: 'приводная фреза',
  },
  assumed: (tool) => `${tool}, предположительно`,
};

export const playbackStrings = { en, zh, ru } as const;
