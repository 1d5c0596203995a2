// The script of the worker, with something of a test before it.
import type { ChromiumPage } from './engines';

/** Runs a script in each worker of the page before the worker's own. */
export async function runBeforeWorker(page: ChromiumPage, script: string): Promise<void> {
  await page.route(/\/worker-[\w-]{8}\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `{ ${script} }\n${await response.text()}` });
  });
}
