// Reads a program from an address: plain text (`#program=…&setup=…`) or packed (`#share=…`, `files/shared-link.ts`).
//
// In: the part of an address from `#`. Out: the program and its options, or an error. The code that unpacks is loaded
// on demand. Must not know: the meaning of a program.

import { importWithRetry } from '../dom/network';
import { LINK_LIMIT } from '../files/link-limit';
import type { LinkFault, Shared } from '../files/shared-link';

export type LinkedProgram = Shared;

export type AddressContent =
  | { readonly kind: 'linked'; readonly linked: LinkedProgram }
  | { readonly kind: 'fault'; readonly fault: LinkFault | { readonly kind: 'not-loaded' } }
  /** The id of an example, or an empty fragment. */
  | { readonly kind: 'other' };

const EXAMPLE = /^#[a-z]\w*-[\w-]+$/;

/** The address of the page without its fragment. */
export function pageAddress(): string {
  return location.href.replace(/#.*$/s, '');
}

/** Reads a program in plain text. */
export function parsePlainLink(hash: string): LinkedProgram | undefined {
  if (hash.length > LINK_LIMIT || hash.startsWith('#share=')) return undefined;
  const parameters = new URLSearchParams(hash.slice(1));
  const text = parameters.get('program');
  if (text === null) return undefined;
  return {
    text,
    setup: parameters.get('setup'),
    control: parameters.get('control'),
    blockSkip: parameters.get('block-skip'),
    program: null,
    language: parameters.get('language'),
    view: parameters.get('view'),
    step: parameters.get('step'),
    readonly: parameters.has('readonly'),
    file: null,
    task: null,
    answerTo: null,
    name: null,
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
    return opened.kind === 'shared' ? { kind: 'linked', linked: opened.shared } : opened;
  }
  if (hash.length > LINK_LIMIT)
    return { kind: 'fault', fault: { kind: 'too-long', length: hash.length, limit: LINK_LIMIT } };
  const linked = parsePlainLink(hash);
  if (linked !== undefined) return { kind: 'linked', linked };
  return hash === '' || hash === '#' || EXAMPLE.test(hash)
    ? { kind: 'other' }
    : { kind: 'fault', fault: { kind: 'unknown' } };
}
