// Starts a worker, whatever the origin of the page.
//
// In: the address of its script, a classic one. Out: the messages of the worker, or why it could not be started. A
// script of another origin, or any script in a sandboxed frame, is fetched and started from a blob URL: this needs
// `worker-src blob:` if there is a Content-Security-Policy, and is done only if the direct way fails. Must not know:
// the purpose of the worker.

import { describe } from './describe';

export interface StartedWorker {
  /** Queued until the worker has started. */
  post(message: unknown): void;
  end(): void;
}

/** The name of the Trusted Types policy, which a page's Content-Security-Policy has to allow. */
const POLICY = 'gcode-playground';
let policy: ScriptPolicy | undefined;

/** The used part of Trusted Types, which TypeScript's DOM types lack. */
interface ScriptPolicy {
  createScriptURL(address: string): unknown;
}
declare const trustedTypes: { createPolicy(name: string, rules: ScriptPolicy): ScriptPolicy } | undefined;

/** Blob URLs of fetched scripts: one request for all workers of a page. */
const blobUrls = new Map<string, Promise<string>>();
/** Scripts that could not be started: the browser's cache may contain a faulty copy. */
const failedBefore = new Set<string>();

export function startWorker<Event>(
  script: string,
  onMessage: (event: Event) => void,
  onFailure: (reason: string) => void,
): StartedWorker {
  let worker: Worker | undefined;
  /** Messages to repeat if the worker is started again; undefined after its first answer. */
  let unconfirmed: unknown[] | undefined = [];
  let isEnded = false;
  const fail = (reason: unknown): void => {
    if (!isEnded) onFailure(describe(reason));
  };
  const attach = (newWorker: Worker, onError: (reason: string) => void): void => {
    if (isEnded) {
      newWorker.terminate();
      return;
    }
    worker = newWorker;
    newWorker.onmessage = ({ data }: MessageEvent<Event>) => {
      unconfirmed = undefined;
      onMessage(data);
    };
    newWorker.onerror = (error) => {
      if (unconfirmed === undefined) fail(error.message || 'the worker has failed');
      else onError(error.message || `the worker ${script} could not be started`);
    };
    for (const message of unconfirmed ?? []) newWorker.postMessage(message);
  };
  const failToStart = (reason: unknown): void => {
    blobUrls.delete(script);
    failedBefore.add(script);
    fail(reason);
  };
  const startFromMemory = (): void =>
    void fetchScript(script)
      .then((copy) => attach(createWorker(copy), failToStart))
      .catch(failToStart);
  const startDirectly = (): void => {
    try {
      // Some browsers throw if they reject the script, others report it later.
      attach(createWorker(script), () => {
        worker?.terminate();
        worker = undefined;
        startFromMemory();
      });
    } catch {
      startFromMemory();
    }
  };
  // Fetching the script again also updates the browser's cache.
  if (failedBefore.has(script)) void fetchScript(script).then(startDirectly, failToStart);
  else startDirectly();
  return {
    post(message) {
      unconfirmed?.push(message);
      worker?.postMessage(message);
    },
    end() {
      isEnded = true;
      worker?.terminate();
    },
  };
}

function createWorker(address: string): Worker {
  // Imports exist only in the development server.
  return new Worker(trustedUrl(address), import.meta.env.DEV ? { type: 'module' } : undefined);
}

function trustedUrl(address: string): string {
  if (typeof trustedTypes === 'undefined') return address;
  policy ??= trustedTypes.createPolicy(POLICY, { createScriptURL: (url) => url });
  // `Worker` accepts a `TrustedScriptURL`, but its type does not declare it.
  return policy.createScriptURL(address) as string;
}

function fetchScript(script: string): Promise<string> {
  const existing = blobUrls.get(script);
  if (existing !== undefined) return existing;
  const copy = load(script);
  blobUrls.set(script, copy);
  return copy;
}

async function load(script: string): Promise<string> {
  const response = await fetch(script, {
    mode: 'cors',
    credentials: 'same-origin',
    cache: failedBefore.has(script) ? 'reload' : 'default',
  });
  if (!response.ok) throw new Error(`${script}: ${response.status}`);
  return URL.createObjectURL(new Blob([await response.text()], { type: 'text/javascript' }));
}
