// Tests whose browser crashed are tried again; other tests are not. In: a test and its failure. Out: a record in the
// output folder, because a failure also ends the worker.
import type { TestInfo } from '@playwright/test';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { BrowserCrashed } from './driver';

const folder = ({ project }: TestInfo): string => join(project.outputDir, 'crashes');
const record = (test: TestInfo): string => join(folder(test), `${test.testId}-${test.repeatEachIndex}`);

/** Records the failure if the browser crashed. */
export function noteCrash(test: TestInfo, error: unknown): void {
  if (!(error instanceof BrowserCrashed)) return;
  mkdirSync(folder(test), { recursive: true });
  writeFileSync(record(test), error.message);
}

/** @throws At a second try, unless the browser crashed during the first one. */
export function refuseSecondTry(test: TestInfo): void {
  if (test.retry > 0 && !existsSync(record(test)))
    throw new Error('It failed at its first try, and the browser did not crash.');
}
