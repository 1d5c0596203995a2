// What is said to the fields of the editor.

import type { StateEffect, StateEffectType } from '@codemirror/state';

/** The value of the last of these effects that is of a type; nothing where none is. */
export function lastOf<T>(effects: readonly StateEffect<unknown>[], type: StateEffectType<T>): T | undefined {
  return effects.filter((effect) => effect.is(type)).at(-1)?.value;
}
