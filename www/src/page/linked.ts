// A program that an address holds: `#program=…&setup=…&language=…`, percent-encoded.
//
// In: the part of an address from `#` on. Out: the program, and the setup as JSON.
// Must not know: what they say.

export interface LinkedProgram {
  readonly text: string;
  /** JSON */
  readonly setup: string | null;
  readonly language: string | null;
}

export function linkedProgram(hash: string): LinkedProgram | undefined {
  const said = new URLSearchParams(hash.slice(1));
  const text = said.get('program');
  return text === null ? undefined : { text, setup: said.get('setup'), language: said.get('language') };
}
