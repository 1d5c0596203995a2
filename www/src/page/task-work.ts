// What the reader has made of a task, found again by the link of the task.
//
// In: the address of a task; which program is the work on it. Out: that program, as it was kept last: of the journal, at once,
// or of the list, for which the page waits a moment only. The list (`own-programs-store.ts`) is loaded for such an address alone. Must
// not know: how a program is shown.

import { inTime } from '../dom/in-time';
import { loaded } from '../dom/network';
import { journal, keepWorkOf, lastEntry, workOf, type Entry, type OwnProgram } from './storage';

export interface Work {
  readonly program: OwnProgram & { readonly id: string };
  /** Where it stood in the journal. */
  readonly entry?: Entry;
  /** The revision of the list that it is. */
  readonly revision?: number;
}

export type FoundWork =
  | { readonly kind: 'work'; readonly work: Work }
  /** There is none, or it was deleted. */
  | { readonly kind: 'none' }
  /** The list has not answered yet. */
  | { readonly kind: 'late'; readonly coming: Promise<Work | undefined> };

/** How long the first picture may wait for the list, of which a browser may never give an answer. */
const LATEST_MS = 1500;

export function keepWorkOn(address: string, id: string): void {
  keepWorkOf(nameOf(address), id);
}

export function isWorkOn(address: string, id: string | undefined): boolean {
  return id !== undefined && workOf(nameOf(address)) === id;
}

/** The entry the page begins with is newer than the list, or the list says so later (`own-programs-session.ts`). */
export function lastWorkOn(address: string): Work | undefined {
  const entry = lastEntry();
  return entry !== undefined && isWorkOn(address, entry.id) ? workIn(entry) : undefined;
}

export async function workOn(address: string): Promise<FoundWork> {
  const id = workOf(nameOf(address));
  if (id === undefined) return { kind: 'none' };
  const [newest] = journal()
    .filter((entry) => entry.id === id)
    .sort((a, b) => b.time - a.time);
  const coming = inList(id, newest).catch(() => newest && workIn(newest));
  const found = await inTime(coming, LATEST_MS);
  if (found !== 'late') return found === undefined ? { kind: 'none' } : { kind: 'work', work: found };
  return newest === undefined ? { kind: 'late', coming } : { kind: 'work', work: workIn(newest) };
}

/** As the list has it, unless the list has not had yet what stands in the journal. */
async function inList(id: string, newest: Entry | undefined): Promise<Work | undefined> {
  const store = await loaded(() => import('./own-programs-store'));
  const [row, program] = await Promise.all([store.listed(id), store.programOf(id)]);
  const isThere = row !== undefined && program !== undefined;
  if (newest !== undefined && (!isThere || (row.seen[newest.tab] ?? 0) < newest.time)) return workIn(newest);
  return isThere ? { program: { ...program, id }, revision: row.revision } : undefined;
}

function workIn(entry: Entry): Work {
  return { program: { ...entry.program, id: entry.id }, entry };
}

/** Its check, and what stands before it, which no other link has; what mail programs put into a link or after it makes no other one. */
function nameOf(address: string): string {
  const said = address.replace(/\s|%20|%0[AD]/gi, '');
  const head = /^#share=\d+\.(\d+)\./.exec(said);
  return (head === null ? said : said.slice(0, head[0].length + Number(head[1]))).slice(-40);
}
