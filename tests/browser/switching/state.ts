// The states the switching test goes through, and the random steps from one to the next.
//
// In: a seed. Out: states as plain values, so that a fresh page can be brought to any of them, and what is
// done to a page on the way. Must not know: the page.

/** What a page shows: everything it should look like follows from this. */
export interface State {
  /** Of the gallery. */
  readonly program: string;
  readonly text: (typeof TEXTS)[number];
  readonly setup: (typeof SETUPS)[number];
  readonly language: (typeof LANGUAGES)[number];
  readonly theme: (typeof THEMES)[number];
  readonly turret: (typeof TURRETS)[number];
}

/** As it is; by keys at its head, as a reader edits; by `value`, as an author does. */
export const TEXTS = ['as it is', 'line typed', 'character deleted', 'line doubled', 'half'] as const;
/** That of the example; another blank; none of it. */
export const SETUPS = ['of the example', 'thick blank', 'empty'] as const;
export const LANGUAGES = ['en', 'zh', 'ru'] as const;
export const THEMES = ['light', 'dark'] as const;
export const TURRETS = ['front', 'rear'] as const;

/** What leaves no trace once it is over. */
export const DETOURS = ['zoomed and fitted', 'stepped', 'pointed', 'kept'] as const;

export type Step = { readonly to: State } | { readonly detour: (typeof DETOURS)[number] };

/** Numbers from 0 to 1 that a seed makes, the same everywhere (mulberry32). */
export function random(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A number of states that differ, beginning with programs one after the other as they are. */
export function pool(programs: readonly string[], size: number, next: () => number): readonly State[] {
  const one = <T>(list: readonly T[]): T => list[Math.floor(next() * list.length)] as T;
  const plain = { text: 'as it is', setup: 'of the example', language: 'en', theme: 'light', turret: 'rear' } as const;
  // Rough turning is what takes longest, the pattern after it what takes less: the pair that went wrong once.
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

/** The next step: mostly to another state of the pool, at times nothing that lasts. */
export function step(states: readonly State[], next: () => number): Step {
  if (next() < 0.2) return { detour: DETOURS[Math.floor(next() * DETOURS.length)] ?? 'stepped' };
  return { to: states[Math.floor(next() * states.length)] as State };
}
