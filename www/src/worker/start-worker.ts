// Starts a worker, whatever the origin of the page.
//
// In: the address of its script, a classic one. Out: the messages of the worker, or why it could not be started. A
// script of another origin, or any script in a sandboxed frame, is fetched and started from a blob URL: this needs
// `worker-src blob:` if there is a Content-Security-Policy, and is done only if the direct way fails. Must not know:
// the purpose of the worker.

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
const inMemory = new Map<string, Promise<string>>();
/** Scripts that could not be started: the browser's cache may contain a faulty copy. */
const failedBefore = new Set<string>();

export function startWorker<Event>(
  script: string,
  heard: (event: Event) => void,
  failed: (reason: string) => void,
): StartedWorker {
  let worker: Worker | undefined;
  /** Messages to repeat if the worker is started again; undefined after its first answer. */
  let said: unknown[] | undefined = [];
  let ended = false;
  const fail = (reason: unknown): void => {
    if (!ended) failed(reason instanceof Error ? reason.message : String(reason));
  };
  const started = (begun: Worker, closed: (reason: string) => void): void => {
    if (ended) {
      begun.terminate();
      return;
    }
    worker = begun;
    begun.onmessage = ({ data }: MessageEvent<Event>) => {
      said = undefined;
      heard(data);
    };
    begun.onerror = (error) => {
      if (said === undefined) fail(error.message || 'the worker has failed');
      else closed(error.message || `the worker ${script} could not be started`);
    };
    for (const message of said ?? []) begun.postMessage(message);
  };
  const notStarted = (reason: unknown): void => {
    inMemory.delete(script);
    failedBefore.add(script);
    fail(reason);
  };
  const fromMemory = (): void =>
    void fetched(script)
      .then((copy) => started(begin(copy), notStarted))
      .catch(notStarted);
  const direct = (): void => {
    try {
      // Some browsers throw if they reject the script, others report it later.
      started(begin(script), () => {
        worker?.terminate();
        worker = undefined;
        fromMemory();
      });
    } catch {
      fromMemory();
    }
  };
  // Fetching the script again also updates the browser's cache.
  if (failedBefore.has(script)) void fetched(script).then(direct, notStarted);
  else direct();
  return {
    post(message) {
      said?.push(message);
      worker?.postMessage(message);
    },
    end() {
      ended = true;
      worker?.terminate();
    },
  };
}

function begin(address: string): Worker {
  // Imports exist only in the development server.
  return new Worker(trusted(address), import.meta.env.DEV ? { type: 'module' } : undefined);
}

function trusted(address: string): string {
  if (typeof trustedTypes === 'undefined') return address;
  policy ??= trustedTypes.createPolicy(POLICY, { createScriptURL: (own) => own });
  // `Worker` accepts a `TrustedScriptURL`, but its type does not declare it.
  return policy.createScriptURL(address) as string;
}

function fetched(script: string): Promise<string> {
  const known = inMemory.get(script);
  if (known !== undefined) return known;
  const copy = load(script);
  inMemory.set(script, copy);
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
