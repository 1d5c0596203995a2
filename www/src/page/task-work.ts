// Finds the user's work on a task by the link of the task.
//
// In: the address of a task; the id of the program that is the work on it. Out: that program as last saved, from the
// journal immediately or from the list, with a short timeout. The list (`own-programs-store.ts`) is loaded only for
// such an address. Must not know: how a program is shown.

import { withTimeout } from '../dom/timeout';
import { importWithRetry } from '../dom/network';
import { readJournal, saveWorkId, readLastEntry, readWorkId, type Entry, type OwnProgram } from './storage';

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
  | { readonly kind: 'late'; readonly pending: Promise<Work | undefined> };

/** How long the first picture may wait for the list; a browser may never answer. */
const LIST_TIMEOUT_MS = 1500;

export function saveWorkOn(address: string, id: string): void {
  saveWorkId(taskKey(address), id);
}

export function isWorkOn(address: string, id: string | undefined): boolean {
  return id !== undefined && readWorkId(taskKey(address)) === id;
}

/**
 * The last entry of the journal, if it is the work on this task. If the list is newer, `own-programs-session.ts` finds
 * out later.
 */
export function lastWorkOn(address: string): Work | undefined {
  const entry = readLastEntry();
  return entry !== undefined && isWorkOn(address, entry.id) ? toWork(entry) : undefined;
}

export async function findWorkOn(address: string): Promise<FoundWork> {
  const id = readWorkId(taskKey(address));
  if (id === undefined) return { kind: 'none' };
  const [newest] = readJournal()
    .filter((entry) => entry.id === id)
    .sort((a, b) => b.time - a.time);
  const pending = readFromList(id, newest).catch(() => newest && toWork(newest));
  const found = await withTimeout(pending, LIST_TIMEOUT_MS);
  if (found !== 'timeout') return found === undefined ? { kind: 'none' } : { kind: 'work', work: found };
  return newest === undefined ? { kind: 'late', pending } : { kind: 'work', work: toWork(newest) };
}

/** The program of the list, or the journal entry if the list does not contain it yet. */
async function readFromList(id: string, newest: Entry | undefined): Promise<Work | undefined> {
  const store = await importWithRetry(() => import('./own-programs-store'));
  const [row, program] = await Promise.all([store.readRow(id), store.readProgram(id)]);
  const isInList = row !== undefined && program !== undefined;
  if (newest !== undefined && (!isInList || (row.seen[newest.tab] ?? 0) < newest.time)) return toWork(newest);
  return isInList ? { program: { ...program, id }, revision: row.revision } : undefined;
}

function toWork(entry: Entry): Work {
  return { program: { ...entry.program, id: entry.id }, entry };
}

/**
 * A unique key of the task: the checksum of the link and the characters before it. Spaces that mail programs insert and
 * text that they append are ignored.
 */
function taskKey(address: string): string {
  const compact = address.replace(/\s|%20|%0[AD]/gi, '');
  const head = /^#share=\d+\.(\d+)\./.exec(compact);
  return (head === null ? compact : compact.slice(0, head[0].length + Number(head[1]))).slice(-40);
}
