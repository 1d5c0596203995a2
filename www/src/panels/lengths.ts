// Lengths as they are shown: in mm or in inches.
//
// In: mm, and the unit they are to be shown in. Out: texts. Must not know: what is measured, or where it is shown.

import type { Language } from '../dom/language';
import type { LengthUnit } from '../protocol/protocol';

const MILLIMETRES: Readonly<Record<LengthUnit, number>> = { mm: 1, inch: 25.4 };
/** Of the least step of a program, and of what can be measured. */
const DECIMALS: Readonly<Record<LengthUnit, number>> = { mm: 3, inch: 4 };
const SYMBOLS: Readonly<Record<LengthUnit, Readonly<Record<Language, string>>>> = {
  mm: { en: 'mm', zh: 'mm', ru: 'мм' },
  inch: { en: 'in', zh: 'in', ru: 'дюйм' },
};

export function symbol(unit: LengthUnit, language: Language): string {
  return SYMBOLS[unit][language];
}

/** So many mm in a unit. */
export function inUnit(mm: number, unit: LengthUnit): number {
  return mm / MILLIMETRES[unit];
}

/** A length, mm, with as many decimals as it needs, and a true minus. */
export function length(mm: number, unit: LengthUnit): string {
  return short(inUnit(mm, unit), DECIMALS[unit]);
}

/** A place, mm, with all decimals: it does not jump while it changes. */
export function place(mm: number, unit: LengthUnit): string {
  return signed(inUnit(mm, unit), DECIMALS[unit]);
}

/** A number with so many decimals at most. */
export function short(value: number, decimals: number): string {
  return signed(Number(value.toFixed(decimals)), undefined);
}

/** A number with so many decimals, or all it has, and a true minus. */
export function signed(value: number, decimals: number | undefined): string {
  const text = decimals === undefined ? String(value) : value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}
