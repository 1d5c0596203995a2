// Runs a script of a test before the worker's script.
import type { ChromiumPage } from './engines';

/** Runs a script in each worker of the page before the worker's own. */
export async function runBeforeWorker(page: ChromiumPage, script: string): Promise<void> {
  await page.route(/\/worker-[\w-]{8}\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `{ ${script} }\n${await response.text()}` });
  });
}
