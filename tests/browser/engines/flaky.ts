// A test that fails once and passes when it is tried again has found something: a fault of the page that shows only
// sometimes, or a fault of the test. It is named at the end of the run, to be looked at. More than MOST of them fail it.
import type { Reporter, TestCase, TestResult } from '@playwright/test/reporter';

/** This many tests of about 1,500 in three engines may need a second attempt before the run has failed. */
const MOST = 2;

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
    if (this.#flaky.size <= MOST) return undefined;
    console.log(`\n${this.#flaky.size} tests passed only when tried again; ${MOST} may.`);
    return { status: 'failed' };
  }

  printsToStdio(): boolean {
    return false;
  }
}
