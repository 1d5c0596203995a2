// A promise with a timeout.

/** Resolves to `timeout` if the promise has not settled within `ms` milliseconds. Rejects if the promise rejects. */
export async function withTimeout<T>(promise: Promise<T>, ms: number): Promise<T | 'timeout'> {
  return Promise.race([promise, new Promise<'timeout'>((done) => setTimeout(() => done('timeout'), ms))]);
}
