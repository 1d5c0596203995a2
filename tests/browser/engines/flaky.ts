// Flaky tests: a test that fails once and passes in a retry indicates an intermittent fault of the page or of the test.
// They are listed at the end of the run. More than MAX_FLAKY of them fail the run.
import type { Reporter, TestCase, TestResult } from '@playwright/test/reporter';

/** Number of tests, of about 1,500 in three engines, that may need a retry before the run fails. */
const MAX_FLAKY = 2;

export default class Flaky implements Reporter {
  readonly #failed = new Map<TestCase, string>();
  readonly #flaky = new Map<string, string>();

  onTestEnd(test: TestCase, result: TestResult): void {
    if (result.status !== 'passed') this.#failed.set(test, result.error?.message ?? result.status);
    else if (this.#failed.has(test))
      this.#flaky.set(
        test
          .titlePath()
          .filter((part) => part !== '')
          .join(' › '),
        this.#failed.get(test) ?? '',
      );
  }

  async onEnd(): Promise<{ status: 'failed' } | undefined> {
    for (const [title, message] of this.#flaky)
      console.log(`\npassed only when tried again, look at it: ${title}\n  ${message}`);
    if (this.#flaky.size <= MAX_FLAKY) return undefined;
    console.log(`\n${this.#flaky.size} tests passed only when tried again; ${MAX_FLAKY} may.`);
    return { status: 'failed' };
  }

  printsToStdio(): boolean {
    return false;
  }
}
