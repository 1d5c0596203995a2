// Starts a worker, wherever the page around stands.
//
// In: the address of its script, which is a classic one. Out: what the worker says, or why it could not be started. A
// script of another origin, or of any where the page is in a sandboxed frame, is fetched and started from memory: this needs
// `worker-src blob:` where there is a policy, and is done only where the direct way is closed. Must not know: what the worker is for.

export interface StartedWorker {
  /** Kept until the worker is there. */
  post(message: unknown): void;
  end(): void;
}

/** A policy that requires trusted types has to allow one by this name. */
const POLICY = 'gcode-playground';
let policy: ScriptPolicy | undefined;

/** What is used of Trusted Types, which the library of types does not have yet. */
interface ScriptPolicy {
  createScriptURL(address: string): unknown;
}
declare const trustedTypes: { createPolicy(name: string, rules: ScriptPolicy): ScriptPolicy } | undefined;

/** Scripts that were fetched, as addresses in memory: one request for all workers of a page. */
const inMemory = new Map<string, Promise<string>>();
/** Scripts that could not be started: the browser's cache may hold a copy with a fault. */
const failedBefore = new Set<string>();

export function startWorker<Event>(
  script: string,
  heard: (event: Event) => void,
  failed: (reason: string) => void,
): StartedWorker {
  let worker: Worker | undefined;
  /** What a worker that is begun again has to hear; nothing once one has answered. */
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
      // Some browsers say at once that they do not take it, others later.
      started(begin(script), () => {
        worker?.terminate();
        worker = undefined;
        fromMemory();
      });
    } catch {
      fromMemory();
    }
  };
  // A fetch that reloads the script puts it in the cache.
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
  // Only where the script is not built are there imports in it.
  return new Worker(trusted(address), import.meta.env.DEV ? { type: 'module' } : undefined);
}

function trusted(address: string): string {
  if (typeof trustedTypes === 'undefined') return address;
  policy ??= trustedTypes.createPolicy(POLICY, { createScriptURL: (own) => own });
  // `Worker` takes it where it is wanted; the type of its first parameter does not say so.
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
