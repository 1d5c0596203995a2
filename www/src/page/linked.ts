// Reads a program from an address: plain text (`#program=…&setup=…`), packed (`#share=…`, `files/shared-link.ts`), or an
// exercise (`#exercise=…`), whose program the element loads.
//
// In: the part of an address from `#`. Out: the program and its options, or an error. The code that unpacks is loaded
// on demand. Must not know: the meaning of a program.

import { importWithRetry } from '../dom/network';
import { LINK_LIMIT } from '../files/link-limit';
import type { LinkFault, Shared } from '../files/shared-link';

export interface LinkedProgram extends Shared {
  /** The exercise to work on: the address of its file, or its text. */
  readonly exerciseToDo?: string;
}

export type AddressContent =
  | { readonly kind: 'linked'; readonly linked: LinkedProgram }
  | { readonly kind: 'fault'; readonly fault: LinkFault | { readonly kind: 'not-loaded' } }
  /** The id of an example, or an empty fragment. */
  | { readonly kind: 'other' };

const EXAMPLE = /^#[a-z]\w*-[\w-]+$/;
const EXERCISE = /^#exercise=([a-z0-9-]+)$/;

/** The address of the page without its fragment. */
export function pageAddress(): string {
  return location.href.replace(/#.*$/s, '');
}

/** Whether the user's program is kept as the work on this link. */
export function hasWork(linked: LinkedProgram): boolean {
  return linked.task !== null || linked.exerciseToDo !== undefined;
}

/** The text of the exercise to work on, if it is not one of the site. */
export function ownExercise({ exerciseToDo }: LinkedProgram): string | null {
  return exerciseToDo?.startsWith('---') === true ? exerciseToDo : null;
}

/** The address of the file of an exercise. */
export function exerciseAddress(id: string): string {
  return `exercises/${id}.md`;
}

/** The link to an exercise: the element loads the program that it begins with. */
function exerciseLink(exercise: string): LinkedProgram {
  return { ...EMPTY_LINK, exerciseToDo: exerciseAddress(exercise) };
}

const EMPTY_LINK: LinkedProgram = {
  text: '',
  setup: null,
  control: null,
  blockSkip: null,
  program: null,
  language: null,
  view: null,
  step: null,
  readonly: false,
  file: null,
  task: null,
  answerTo: null,
  exercise: null,
  exerciseText: null,
  name: null,
};

/** Reads a program in plain text. */
export function parsePlainLink(hash: string): LinkedProgram | undefined {
  if (hash.length > LINK_LIMIT || hash.startsWith('#share=')) return undefined;
  const parameters = new URLSearchParams(hash.slice(1));
  const text = parameters.get('program');
  if (text === null) return undefined;
  return {
    ...EMPTY_LINK,
    text,
    setup: parameters.get('setup'),
    control: parameters.get('control'),
    blockSkip: parameters.get('block-skip'),
    language: parameters.get('language'),
    view: parameters.get('view'),
    step: parameters.get('step'),
    readonly: parameters.has('readonly'),
  };
}

export async function parseAddress(hash: string): Promise<AddressContent> {
  if (hash.startsWith('#share=')) {
    let parseLink: typeof import('../files/shared-link')['parseLink'];
    try {
      ({ parseLink } = await importWithRetry(() => import('../files/shared-link')));
    } catch {
      return { kind: 'fault', fault: { kind: 'not-loaded' } };
    }
    const opened = await parseLink(hash);
    if (opened.kind !== 'shared') return opened;
    const { shared } = opened;
    const isToDo = shared.exerciseText !== null && shared.exercise === null;
    return { kind: 'linked', linked: isToDo ? { ...shared, exerciseToDo: shared.exerciseText } : shared };
  }
  if (hash.length > LINK_LIMIT)
    return { kind: 'fault', fault: { kind: 'too-long', length: hash.length, limit: LINK_LIMIT } };
  const id = EXERCISE.exec(hash)?.[1];
  const linked = id === undefined ? parsePlainLink(hash) : exerciseLink(id);
  if (linked !== undefined) return { kind: 'linked', linked };
  return hash === '' || hash === '#' || EXAMPLE.test(hash)
    ? { kind: 'other' }
    : { kind: 'fault', fault: { kind: 'unknown' } };
}

/** The name as one line without bidirectional control characters; undefined if it is empty. */
export function cleanName(name: string | null): string | undefined {
  const line = (name ?? '')
    .replace(/[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, '')
    .replace(/[\s\p{Cc}]+/gu, ' ')
    .trim();
  return line === '' ? undefined : line;
}
