// Formats lengths in mm or inches.
//
// In: mm, and the unit to show. Out: texts. Must not know: the measured quantity, or where it is shown.

import type { Language } from '../dom/language';
import type { LengthUnit } from '../protocol/protocol';

export const MM_PER_UNIT: Readonly<Record<LengthUnit, number>> = { mm: 1, inch: 25.4 };
/** Decimals of the smallest increment of a program, and of common measuring tools. */
const DECIMALS: Readonly<Record<LengthUnit, number>> = { mm: 3, inch: 4 };
const SYMBOLS: Readonly<Record<LengthUnit, Readonly<Record<Language, string>>>> = {
  mm: { en: 'mm', zh: 'mm', ru: 'мм' },
  inch: { en: 'in', zh: 'in', ru: 'дюйм' },
};

export function unitSymbol(unit: LengthUnit, language: Language): string {
  return SYMBOLS[unit][language];
}

/** Converts mm to a unit. */
export function toUnit(mm: number, unit: LengthUnit): number {
  return mm / MM_PER_UNIT[unit];
}

/** Formats a length, mm, without trailing zeros and with a true minus sign. */
export function formatLength(mm: number, unit: LengthUnit): string {
  return formatShort(toUnit(mm, unit), DECIMALS[unit]);
}

/** Formats a coordinate, mm, with all decimals, so that the text does not jump while the value changes. */
export function formatCoordinate(mm: number, unit: LengthUnit): string {
  return formatSigned(toUnit(mm, unit), DECIMALS[unit]);
}

/** Formats a coordinate, mm, with the decimals that a movement of `step`, mm, changes. */
export function formatPlace(mm: number, unit: LengthUnit, step: number): string {
  const decimals = Math.ceil(-Math.log10(toUnit(step, unit)));
  return formatSigned(toUnit(mm, unit), Math.min(Math.max(decimals, 0), DECIMALS[unit]));
}

/** Formats a number with at most this number of decimals. */
export function formatShort(value: number, decimals: number): string {
  return formatSigned(Number(value.toFixed(decimals)), undefined);
}

/** Formats a number with this number of decimals (undefined: all), and a true minus sign. */
export function formatSigned(value: number, decimals: number | undefined): string {
  const text = decimals === undefined ? String(value) : value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}
