// Values that leave the element unchangeable.
//
// In: plain objects and arrays. Out: the same, frozen. Must not know: their content.

/** Freezes a value and everything in it: the element still uses what it gives to the page. */
export function deepFreeze<T>(value: T): T {
  if (typeof value !== 'object' || value === null || Object.isFrozen(value)) return value;
  for (const inner of Object.values(value)) deepFreeze(inner);
  return Object.freeze(value);
}
