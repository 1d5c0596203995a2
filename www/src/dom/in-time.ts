// What may never come is waited for no longer than somebody has patience.

/** What a promise gives, or that it has not come within so many milliseconds; one that fails fails here too. */
export async function inTime<T>(promise: Promise<T>, ms: number): Promise<T | 'late'> {
  return Promise.race([promise, new Promise<'late'>((done) => setTimeout(() => done('late'), ms))]);
}
