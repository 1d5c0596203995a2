// States of the switching test, and random steps between them.
//
// In: a seed. Out: states as plain values, to which a fresh page can be brought, and the actions between them. Must not
// know: the page.

/** A state of the page, from which everything visible follows. */
export interface State {
  /** ID of a program in the gallery. */
  readonly program: string;
  readonly text: (typeof TEXTS)[number];
  readonly setup: (typeof SETUPS)[number];
  readonly language: (typeof LANGUAGES)[number];
  readonly theme: (typeof THEMES)[number];
  readonly turret: (typeof TURRETS)[number];
}

/** Unchanged; edited at its start by keys, like a user; or set by `value`, like an author. */
export const TEXTS = ['as it is', 'line typed', 'character deleted', 'line doubled', 'half'] as const;
/** The setup of the example; another blank; none. */
export const SETUPS = ['of the example', 'thick blank', 'empty'] as const;
export const LANGUAGES = ['en', 'zh', 'ru'] as const;
export const THEMES = ['light', 'dark'] as const;
export const TURRETS = ['front', 'rear'] as const;

/** Actions that have no lasting effect. */
export const DETOURS = ['zoomed and fitted', 'stepped', 'pointed', 'kept'] as const;

export type Step = { readonly to: State } | { readonly detour: (typeof DETOURS)[number] };

/** Seeded random numbers from 0 to 1 (mulberry32). */
export function random(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Distinct states, starting with unchanged programs in order. */
export function pool(programs: readonly string[], size: number, next: () => number): readonly State[] {
  const one = <T>(list: readonly T[]): T => list[Math.floor(next() * list.length)] as T;
  const plain = { text: 'as it is', setup: 'of the example', language: 'en', theme: 'light', turret: 'rear' } as const;
  // Rough turning takes longest and the pattern after it least: this pair failed once.
  const states: State[] = ['s003-g71', 's003-g73'].map((program) => ({ program, ...plain }));
  while (states.length < size) {
    const state: State = {
      program: one(programs),
      text: one(TEXTS),
      setup: one(SETUPS),
      language: one(LANGUAGES),
      theme: one(THEMES),
      turret: one(TURRETS),
    };
    if (!states.some((known) => JSON.stringify(known) === JSON.stringify(state))) states.push(state);
  }
  return states;
}

/** The next step: usually to another state of the pool, sometimes an action without lasting effect. */
export function step(states: readonly State[], next: () => number): Step {
  if (next() < 0.2) return { detour: DETOURS[Math.floor(next() * DETOURS.length)] ?? 'stepped' };
  return { to: states[Math.floor(next() * states.length)] as State };
}
