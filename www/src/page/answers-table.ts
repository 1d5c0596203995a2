// The table of answers: its columns as texts, the order of its rows, and the same as CSV.
//
// In: rows, and the texts of a language. Out: cells. Must not know: where the table is shown.

import { HEAD_KEYS, type AnswerRow, type HeadKey } from './answers';
import type { AnswersWords } from './answers-words';

/** Most names of other answers in a note; there may be many of them. */
const MAX_NAMES = 1;

/** The texts of the cells of a row. */
export function cellsOf(row: AnswerRow, texts: AnswersWords): string[] {
  const name = row.name === '' ? texts.noName : row.name;
  const { graded, fault } = row;
  if (graded === undefined)
    return [name, ...HEAD_KEYS.slice(2).map(() => ''), fault === undefined ? '' : texts.fault(fault)];
  const { report, title, hints, sameAs } = graded;
  const others = sameAs.map((name) => (name === '' ? texts.noName : name));
  const notes = [
    ...(others.length === 0 ? [] : [texts.sameAs(others.slice(0, MAX_NAMES), others.length > MAX_NAMES)]),
    ...(graded.isFromLink ? [texts.fromLink] : []),
    ...(graded.isOtherVersion ? [texts.otherVersion] : []),
  ];
  return [
    name,
    title,
    report.passed ? texts.passed : texts.notPassed,
    String(report.points),
    partOf(row, texts),
    report.checks
      .filter(({ passed }) => !passed)
      .map(({ check }) => check)
      .join('; '),
    texts.problems(report.errors, report.warnings),
    report.seconds === undefined ? '–' : clock(report.seconds),
    report.codes.join(' '),
    hints === undefined ? '–' : String(hints),
    notes.join('; '),
  ];
}

/** The verdict on the part with its line and its cause. */
function partOf({ graded }: AnswerRow, texts: AnswersWords): string {
  if (graded === undefined) return '';
  const { part, line, cause } = graded.report;
  const place = line === undefined ? '' : ` (${texts.line(line)})`;
  return cause === undefined ? `${part}${place}` : `${part}${place}; ${cause.text} (${texts.line(cause.line)})`;
}

/** What a row is sorted by in a column. */
export function sortKeyOf(row: AnswerRow, key: HeadKey, texts: AnswersWords): string {
  const { graded } = row;
  if (key === 'time') return String(graded?.report.seconds ?? Number.MAX_SAFE_INTEGER);
  if (key === 'problems') return `${graded?.report.errors ?? ''} ${graded?.report.warnings ?? ''}`;
  return cellsOf(row, texts)[HEAD_KEYS.indexOf(key)] ?? '';
}

/** Minutes and seconds. */
function clock(seconds: number): string {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

/** The rows as CSV, with the same columns. */
export function csvOf(rows: readonly AnswerRow[], texts: AnswersWords): string {
  const lines = [HEAD_KEYS.map((key) => texts.head[key]), ...rows.map((row) => cellsOf(row, texts))];
  return lines.map((cells) => `${cells.map(quoted).join(',')}\r\n`).join('');
}

/** A cell of CSV. A spreadsheet must not read a name as a formula. */
function quoted(text: string): string {
  const safe = /^[=+\-@\t]/.test(text) ? `'${text}` : text;
  const line = safe.replace(/[\r\n]+/g, ' ');
  return /[",]/.test(line) ? `"${line.replaceAll('"', '""')}"` : line;
}
