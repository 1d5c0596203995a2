// Reads a program from an address: plain text (`#program=…&setup=…`) or packed (`#share=…`, `files/shared-link.ts`).
//
// In: the part of an address from `#`. Out: the program and its options, or an error. The code that unpacks is loaded
// on demand. Must not know: the meaning of a program.

import { loaded } from '../dom/network';
import { LINK_LIMIT } from '../files/link-limit';
import type { LinkFault, Shared } from '../files/shared-link';

export type LinkedProgram = Shared;

export type InAddress =
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
export function linkedProgram(hash: string): LinkedProgram | undefined {
  if (hash.length > LINK_LIMIT || hash.startsWith('#share=')) return undefined;
  const said = new URLSearchParams(hash.slice(1));
  const text = said.get('program');
  if (text === null) return undefined;
  return {
    text,
    setup: said.get('setup'),
    control: said.get('control'),
    blockSkip: said.get('block-skip'),
    program: null,
    language: said.get('language'),
    view: said.get('view'),
    step: said.get('step'),
    readonly: said.has('readonly'),
    file: null,
    task: null,
    name: null,
  };
}

export async function inAddress(hash: string): Promise<InAddress> {
  if (hash.startsWith('#share=')) {
    let openedLink: typeof import('../files/shared-link')['openedLink'];
    try {
      ({ openedLink } = await loaded(() => import('../files/shared-link')));
    } catch {
      return { kind: 'fault', fault: { kind: 'not-loaded' } };
    }
    const opened = await openedLink(hash);
    return opened.kind === 'shared' ? { kind: 'linked', linked: opened.shared } : opened;
  }
  if (hash.length > LINK_LIMIT)
    return { kind: 'fault', fault: { kind: 'too-long', length: hash.length, limit: LINK_LIMIT } };
  const linked = linkedProgram(hash);
  if (linked !== undefined) return { kind: 'linked', linked };
  return hash === '' || hash === '#' || EXAMPLE.test(hash)
    ? { kind: 'other' }
    : { kind: 'fault', fault: { kind: 'unknown' } };
}
