// A promise with a timeout.

/** Resolves to `late` if the promise has not settled within `ms` milliseconds. Rejects if the promise rejects. */
export async function inTime<T>(promise: Promise<T>, ms: number): Promise<T | 'late'> {
  return Promise.race([promise, new Promise<'late'>((done) => setTimeout(() => done('late'), ms))]);
}
