// The report about a difference from a real machine, as a text to send and as a folder for `tests/programs`.
//
// In: the program with its setup, the block, the drawn motions, and the user's description. Out: Markdown, and the
// files of the folder by name. Must not know: where they are sent.

import { foldLineEnds } from '../files/line-ends';
import type { MotionRow } from './motion-table';
import type { ReportWords } from './report-words';

export interface ReportData {
  /** With the original line ends. */
  readonly text: string;
  /** The complete setup, JSON. */
  readonly setup: string;
  /** The line of the block, from 1. */
  readonly line: number;
  /** The motions of all blocks; undefined if the program is too long or they did not arrive in time. */
  readonly motions: readonly MotionRow[] | undefined;
  readonly machine: string;
  /** What the machine did. */
  readonly did: string;
  /** Versions of the playground and of the browser. */
  readonly versions: string;
  /** A link to the program; undefined if it would be too long. */
  readonly link: string | undefined;
}

/** Maximum number of motions of one block in the text; a cycle can have thousands. */
const MAX_MOTIONS = 40;
const COLUMNS = ['kind', 'x', 'z', 'c', 'r', 'dir', 'lead', 'feed', 'rpm'] as const;

export function blockAt(text: string, line: number): string {
  return text.split(/\r\n|\r|\n/)[line - 1] ?? '';
}

export function reportText(data: ReportData, words: ReportWords): string {
  const { text, setup, line, motions, machine, did, versions, link } = data;
  const drawn = motions?.filter((row) => row['line'] === String(line));
  const parts = [
    `# ${words.title}`,
    `**${words.machine}**: ${machine.trim() === '' ? words.unspecified : machine.trim()}`,
    `**${words.block(line)}**: ${inlineCode(blockAt(text, line).trim())}`,
    `**${words.did}**`,
    did.trim() === '' ? words.unspecified : did.trim(),
    `**${words.drawn}**`,
    drawn === undefined ? words.notListed : drawn.length === 0 ? words.nothingDrawn : table(drawn, words),
    `**${words.versions}**: ${versions}`,
    ...(link === undefined ? [] : [`**${words.open}**: ${link}`]),
    `## ${words.setup}`,
    codeBlock('json', setup),
    `## ${words.program}`,
    codeBlock('gcode', foldLineEnds(text)),
  ];
  return `${parts.join('\n\n')}\n`;
}

/** The name of the folder, and its files. */
export function makeFixture(data: ReportData): {
  readonly name: string;
  readonly files: Readonly<Record<string, string>>;
} {
  const { text, setup, line, motions = [], machine, did, versions } = data;
  const number = /^[ \t]*[O:](\d{1,8})/im.exec(text)?.[1];
  const source = `${machine.trim()}, block ${line}: ${did.trim()} (${versions})`;
  const json = (value: unknown): string => `${JSON.stringify(value, undefined, 2)}\n`;
  return {
    name: `machine-${number === undefined ? 'program' : `o${number}`}`,
    files: {
      'program.nc': text,
      'setup.json': json(JSON.parse(setup)),
      'about.json': json({ seed: 'machine', source }),
      'expect.json': json({}),
      // The motions as drawn; the maintainer who adds the folder replaces them by the motions of the machine.
      'motions.jsonl': motions.map((row) => `${JSON.stringify(toMotion(row))}\n`).join(''),
    },
  };
}

/** A motion in the format of `tests/programs`. */
function toMotion(row: MotionRow): object {
  const number = (name: string): number | undefined =>
    row[name] === undefined || row[name] === '' ? undefined : Number(row[name]);
  const place = (before: string): object | undefined =>
    number(`${before}x`) === undefined
      ? undefined
      : { x: number(`${before}x`), z: number(`${before}z`), c: number(`${before}c`) };
  // `JSON.stringify` omits undefined values.
  return {
    kind: row['kind'],
    to: place(''),
    line: Number(row['line']),
    center: place('center_'),
    r: number('r'),
    dir: row['dir'] === '' ? undefined : row['dir'],
    lead: number('lead'),
  };
}

function table(rows: readonly MotionRow[], words: ReportWords): string {
  const shown = rows.slice(0, MAX_MOTIONS);
  const used = COLUMNS.filter((name) => shown.some((row) => (row[name] ?? '') !== ''));
  const line = (cells: readonly string[]): string => `| ${cells.join(' | ')} |`;
  const lines = [
    line(used),
    line(used.map(() => '---')),
    ...shown.map((row) => line(used.map((name) => row[name] ?? ''))),
  ];
  return `${lines.join('\n')}${rows.length > MAX_MOTIONS ? `\n\n${words.more(rows.length - MAX_MOTIONS)}` : ''}`;
}

/** A Markdown code block. The fence has more backticks than any sequence in the text. */
function codeBlock(kind: string, text: string): string {
  const fence = '`'.repeat(Math.max(3, longestTicks(text) + 1));
  return `${fence}${kind}\n${text.replace(/\n$/, '')}\n${fence}`;
}

function inlineCode(text: string): string {
  if (text === '') return '–';
  const ticks = '`'.repeat(longestTicks(text) + 1);
  return ticks.length === 1 ? `\`${text}\`` : `${ticks} ${text} ${ticks}`;
}

function longestTicks(text: string): number {
  return (text.match(/`+/g) ?? []).reduce((most, ticks) => Math.max(most, ticks.length), 0);
}
