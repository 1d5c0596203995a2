// Finds the user's work on a task by the link of the task.
//
// In: the address of a task; the id of the program that is the work on it. Out: that program as last saved, from the
// journal immediately or from the list, with a short timeout. The list (`own-programs-store.ts`) is loaded only for
// such an address. Must not know: how a program is shown.

import { inTime } from '../dom/in-time';
import { loaded } from '../dom/network';
import { journal, keepWorkOf, lastEntry, workOf, type Entry, type OwnProgram } from './storage';

export interface Work {
  readonly program: OwnProgram & { readonly id: string };
  /** The journal entry that it was read from. */
  readonly entry?: Entry;
  /** Its revision in the list. */
  readonly revision?: number;
}

export type FoundWork =
  | { readonly kind: 'work'; readonly work: Work }
  /** There is no work, or it was deleted. */
  | { readonly kind: 'none' }
  /** The list has not answered yet. */
  | { readonly kind: 'late'; readonly coming: Promise<Work | undefined> };

/** How long the first picture may wait for the list; a browser may never answer. */
const LATEST_MS = 1500;

export function keepWorkOn(address: string, id: string): void {
  keepWorkOf(nameOf(address), id);
}

export function isWorkOn(address: string, id: string | undefined): boolean {
  return id !== undefined && workOf(nameOf(address)) === id;
}

/**
 * The last entry of the journal, if it is the work on this task. If the list is newer, `own-programs-session.ts` finds
 * out later.
 */
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

/** The program of the list, or the journal entry if the list does not contain it yet. */
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

/**
 * A unique key of the task: the checksum of the link and the characters before it. Spaces that mail programs insert and
 * text that they append are ignored.
 */
function nameOf(address: string): string {
  const said = address.replace(/\s|%20|%0[AD]/gi, '');
  const head = /^#share=\d+\.(\d+)\./.exec(said);
  return (head === null ? said : said.slice(0, head[0].length + Number(head[1]))).slice(-40);
}
