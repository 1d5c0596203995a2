// The text of an exercise file from the fields of a form.
//
// In: the fields. Out: Markdown with a head, as `www/docs/exercises.md` describes it. Must not know: where the fields
// come from.

import type { Language } from '../dom/language';

export interface ExerciseFields {
  readonly language: Language;
  readonly title: string;
  readonly task: string;
  readonly hints: readonly string[];
  /** The program that the learner begins with. */
  readonly start: string;
  /** The blocks `setup` and `target`. */
  readonly blocks: string;
  /** Codes, separated by commas or blanks. */
  readonly require: string;
  readonly forbid: string;
  /** The least distance of the tool from the blank at the end, mm; empty: not checked. */
  readonly safeEnd: string;
  readonly points: string;
}

export function exerciseText(fields: ExerciseFields): string {
  const { language, title, task, hints, start, blocks } = fields;
  const codes = (text: string): string =>
    text
      .split(/[\s,;，；、]+/)
      .filter(Boolean)
      .join(', ')
      .toUpperCase();
  const entries = [
    ['id', idOf(title)],
    ['kind', 'write'],
    ['points', fields.points.trim()],
    ['require', codes(fields.require)],
    ['forbid', codes(fields.forbid)],
    ['safe-end', fields.safeEnd.trim()],
  ] as const;
  const head = entries.filter(([, value]) => value !== '').map(([key, value]) => `${key}: ${value}`);
  const [setup = '', ...target] = blocks.trim().split(/^(?=```target)/m);
  return [
    ['---', ...head, '---'].join('\n'),
    setup.trim(),
    ...(start.trim() === '' ? [] : [`\`\`\`gcode\n${start.trimEnd()}\n\`\`\``]),
    target.join('').trim(),
    `# ${language}: ${oneLine(title)}`,
    prose(task),
    ...hints.filter((hint) => hint.trim() !== '').map((hint) => `> ${oneLine(hint)}`),
    '',
  ]
    .filter((part, at, all) => part !== '' || at === all.length - 1)
    .join('\n\n');
}

/** The letters a-z and the digits of a title. A title in another script has a checksum, so that ids differ. */
function idOf(title: string): string {
  const id = title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 40)
    .replace(/-+$/, '');
  if (/[a-z]/.test(id)) return id;
  const sum = [...oneLine(title)].reduce((sum, letter) => (sum * 31 + (letter.codePointAt(0) ?? 0)) >>> 0, 0);
  return `exercise-${sum.toString(36)}`;
}

function oneLine(text: string): string {
  return text.replace(/\s+/g, ' ').trim();
}

/** A task must not begin another part of the file: a heading, a block or a hint. */
function prose(text: string): string {
  return text
    .trim()
    .split('\n')
    .map((line) => line.replace(/^(\s*)(?:#+ |>|```|---)\s*/, '$1'))
    .join('\n');
}
