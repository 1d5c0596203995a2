// Drives WebKitGTK's MiniBrowser on a separate display (Xvfb) over WebDriver, whose few commands are plain JSON.
import { type ChildProcess, execFile, spawn } from 'node:child_process';
import { mkdir, mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { promisify } from 'node:util';
import { BrowserCrashed, DocumentLeft, type Driver, type Tab } from './driver';
import { keyCode } from './keys';
import { png } from './picture';
import { program } from './programs';
import { type Relay, relay } from './relay';

/** Timeout for a response, ms; a script may take long. */
const TIMEOUT = 120_000;
const STARTS = 60_000;
/** Size of the display: large enough for the window and its toolbars. */
const SCREEN = '1600x1200x24';
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';
/**
 * Most tabs of one browser. All pages of 127.0.0.1 share a process, which grows by about 5 MB with each: to more than
 * 1 GB in a whole run. Then a page sometimes had no panels.
 */
const TABS = 40;

type Json = Record<string, unknown>;

/** Processes of one worker: the display and the driver. */
interface Machine {
  readonly display: string;
  readonly downloads: string;
  call(method: 'GET' | 'POST' | 'DELETE', path: string, body?: Json): Promise<unknown>;
}

export async function webkit(viewport: { width: number; height: number }, server: string): Promise<Driver> {
  const folder = await mkdtemp(join(tmpdir(), 'playground-webkit-'));
  const downloads = join(folder, 'downloads');
  await mkdir(downloads);
  await mkdir(join(folder, 'config'));
  await writeFile(join(folder, 'config', 'user-dirs.dirs'), `XDG_DOWNLOAD_DIR="${downloads}"\n`);
  const started: ChildProcess[] = [];
  const kill = (): void => started.forEach(end);
  process.once('exit', kill);
  try {
    const xvfb = start(
      program('PLAYGROUND_XVFB'),
      ['-displayfd', '3', '-screen', '0', SCREEN, '-nolisten', 'tcp', '-noreset'],
      {},
    );
    started.push(xvfb);
    const display = `:${await displayOf(xvfb)}`;
    const port = await freePort();
    const driver = start(program('PLAYGROUND_WEBKIT_DRIVER'), [`--port=${port}`], {
      DISPLAY: display,
      HOME: folder,
      XDG_CONFIG_HOME: join(folder, 'config'),
      XDG_CACHE_HOME: join(folder, 'cache'),
      XDG_DATA_HOME: join(folder, 'data'),
      LANG: 'en_US.UTF-8',
      LANGUAGE: 'en_US',
      GDK_BACKEND: 'x11',
      GTK_A11Y: 'none',
      NO_AT_BRIDGE: '1',
      // Without a graphics card, the DMA-BUF renderer makes ten frames per second instead of sixty.
      WEBKIT_DISABLE_DMABUF_RENDERER: process.env['WEBKIT_DISABLE_DMABUF_RENDERER'] ?? '1',
    });
    started.push(driver);
    const call = async (method: string, path: string, body?: Json): Promise<unknown> => {
      const answer = await fetch(`http://127.0.0.1:${port}${path}`, {
        method,
        ...(body === undefined ? {} : { body: JSON.stringify(body) }),
        signal: AbortSignal.timeout(TIMEOUT),
      }).catch((error: unknown) => {
        if (!(error instanceof Error) || error.name !== 'TimeoutError') throw error;
        kill();
        throw new Error(`WebKit: ${method} ${path}: no answer within ${TIMEOUT / 1000} s; the browser was ended`);
      });
      const { value } = (await answer.json()) as { value: unknown };
      if (!answer.ok) {
        const message = `WebKit: ${method} ${path}: ${JSON.stringify(value)}`;
        if (isCrash(value)) throw new BrowserCrashed(message);
        throw message.includes('before the unload event') ? new DocumentLeft(message) : new Error(message);
      }
      return value;
    };
    const machine: Machine = { display, downloads, call };
    await listening(machine, driver);
    let session = await begin(machine);
    let tabs = 0;
    return {
      open: async () => {
        if (++tabs > TABS) {
          await machine.call('DELETE', session.path);
          session = await begin(machine);
          tabs = 1;
        }
        for (const name of await readdir(downloads)) await rm(join(downloads, name));
        // A separate relay is a separate origin with empty storage.
        const tab = new WebKitTab(machine, session, session.window, await relay(server));
        await tab.resize(viewport.width, viewport.height);
        return tab;
      },
      close: async () => {
        process.off('exit', kill);
        await machine.call('DELETE', session.path).catch(() => undefined);
        await Promise.all(started.reverse().map(ended));
        await rm(folder, { recursive: true, force: true, maxRetries: 5 });
      },
    };
  } catch (error) {
    kill();
    throw error;
  }
}

/**
 * Whether the driver reports that the process of the page has ended: the current command has no result, and then the
 * session is deleted.
 */
function isCrash(value: unknown): boolean {
  const { error, message } = value as { error?: unknown; message?: unknown };
  const hasNoResult = message === '' || message === 'Could not parse script result';
  return error === 'invalid session id' || (error === 'unknown error' && hasNoResult);
}

/** Starts a program in its own process group, which ends together with this process in all cases. */
function start(path: string, args: readonly string[], environment: NodeJS.ProcessEnv): ChildProcess {
  return spawn('setpriv', ['--pdeathsig', 'KILL', path, ...args], {
    env: { ...process.env, ...environment },
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
    detached: true,
  });
}

/** Ends a program and its child processes. */
function end({ pid }: ChildProcess): void {
  try {
    if (pid !== undefined) process.kill(-pid, 'SIGKILL');
  } catch {
    // It has already ended.
  }
}

async function ended(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return;
  const gone = new Promise((resolve) => child.once('exit', resolve));
  end(child);
  await gone;
}

/** Display number that Xvfb chose: the first free one. */
async function displayOf(xvfb: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let output = '';
    const late = setTimeout(() => reject(new Error(`Xvfb named no display within ${STARTS / 1000} s`)), STARTS);
    xvfb.stdio[3]!.on('data', (data: Buffer) => {
      output += String(data);
      if (!output.endsWith('\n')) return;
      clearTimeout(late);
      resolve(output.trim());
    });
    xvfb.once('error', reject);
    xvfb.once('exit', (code) => reject(new Error(`Xvfb ended (${code}) before it named its display`)));
  });
}

async function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number };
      server.close(() => resolve(port));
    });
  });
}

async function listening({ call }: Machine, driver: ChildProcess): Promise<void> {
  for (const last = Date.now() + STARTS; ; await pause(50)) {
    try {
      return void (await call('GET', '/status'));
    } catch (error) {
      if (driver.exitCode !== null || Date.now() > last)
        throw new Error('WebKitWebDriver does not start', { cause: error });
    }
  }
}

/** A browser with one window. */
interface Session {
  readonly path: string;
  readonly window: string;
  /** Handles of the known windows, and of the current one. */
  readonly windows: Set<string>;
  current: string;
}

async function begin(machine: Machine): Promise<Session> {
  const { sessionId } = (await machine.call('POST', '/session', {
    capabilities: {
      alwaysMatch: {
        timeouts: { script: TIMEOUT, pageLoad: 60_000, implicit: 0 },
        'webkitgtk:browserOptions': { binary: program('PLAYGROUND_MINIBROWSER'), args: ['--automation'] },
      },
    },
  })) as { sessionId: string };
  const path = `/session/${sessionId}`;
  const window = (await machine.call('GET', `${path}/window`)) as string;
  await firstLoad(machine, path);
  return { path, window, windows: new Set([window]), current: window };
}

/** On a busy machine, the first load of a session is sometimes lost: the page stays blank, or shows an error. */
async function firstLoad({ call }: Machine, path: string): Promise<void> {
  for (let tries = 0; tries < 20; tries++, await pause(100)) {
    await call('POST', `${path}/url`, { url: 'data:text/html,<title>ready</title>' }).catch(() => undefined);
    if ((await call('GET', `${path}/title`)) === 'ready') return;
  }
  throw new Error('WebKit: no page can be loaded');
}

class WebKitTab implements Tab {
  readonly downloads: string;

  constructor(
    private readonly machine: Machine,
    private readonly session: Session,
    private readonly window: string,
    private readonly relay: Relay,
  ) {
    this.downloads = machine.downloads;
  }

  private async call(method: 'GET' | 'POST' | 'DELETE', path: string, body?: Json): Promise<unknown> {
    if (this.session.current !== this.window) {
      await this.machine.call('POST', `${this.session.path}/window`, { handle: this.window });
      this.session.current = this.window;
    }
    return this.machine.call(method, `${this.session.path}${path}`, body);
  }

  async goto(address: string): Promise<void> {
    await this.call('POST', '/url', { url: this.relay.inFront(address) });
  }
  async reload(): Promise<void> {
    await this.call('POST', '/refresh', {});
  }
  async back(): Promise<void> {
    await this.call('POST', '/back', {});
  }
  async url(): Promise<string> {
    return this.relay.behind((await this.call('GET', '/url')) as string);
  }
  addInitScript(source: string): Promise<void> {
    this.relay.scripts.push(source);
    return Promise.resolve();
  }
  async evaluate(expression: string): Promise<unknown> {
    const script = `const told = arguments[arguments.length - 1];
      (async () => ({ value: await (${expression}) }))().then((all) => told(JSON.stringify(all)), (error) => told(JSON.stringify({ error: error + '\\n' + error?.stack })));`;
    const answer = JSON.parse((await this.call('POST', '/execute/async', { script, args: [] })) as string) as {
      value?: unknown;
      error?: string;
    };
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.value;
  }

  private async keys(...actions: Json[]): Promise<void> {
    await this.call('POST', '/actions', { actions: [{ type: 'key', id: 'keyboard', actions }] });
  }
  keyDown(key: string): Promise<void> {
    return this.keys({ type: 'keyDown', value: keyCode(key) });
  }
  keyUp(key: string): Promise<void> {
    return this.keys({ type: 'keyUp', value: keyCode(key) });
  }
  typeKeys(text: string): Promise<void> {
    const values = Array.from(text, (each) => (each === '\n' ? keyCode('Enter') : each));
    return this.keys(
      ...values.flatMap((value) => [
        { type: 'keyDown', value },
        { type: 'keyUp', value },
      ]),
    );
  }
  private async pointer(...actions: Json[]): Promise<void> {
    await this.call('POST', '/actions', {
      actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }],
    });
  }
  mouseMove(x: number, y: number): Promise<void> {
    return this.pointer({ type: 'pointerMove', duration: 0, x, y });
  }
  mouseDown(): Promise<void> {
    return this.pointer({ type: 'pointerDown', button: 0 });
  }
  mouseUp(): Promise<void> {
    return this.pointer({ type: 'pointerUp', button: 0 });
  }
  click(x: number, y: number, times: number): Promise<void> {
    const once = [
      { type: 'pointerDown', button: 0 },
      { type: 'pointerUp', button: 0 },
    ];
    return this.pointer(
      { type: 'pointerMove', duration: 0, x, y },
      ...Array.from({ length: times }, () => once).flat(),
    );
  }
  /**
   * Repeats the action until an event with a distance arrives: the driver sometimes loses it. In some sessions it sends
   * none at all; the event is then dispatched by a script.
   */
  async wheel(x: number, y: number, deltaX: number, deltaY: number): Promise<void> {
    await this.evaluate(`(
      globalThis.wheelArrived ??= addEventListener(
        'wheel',
        ({ deltaX, deltaY }) => { if (deltaX !== 0 || deltaY !== 0) globalThis.wheelArrived = true; },
        { capture: true },
      ) ?? false,
      globalThis.wheelArrived = false
    )`);
    for (let tries = 0; tries < 4; tries++) {
      await this.call('POST', '/actions', {
        actions: [{ type: 'wheel', id: 'wheel', actions: [{ type: 'scroll', x, y, deltaX, deltaY, duration: 0 }] }],
      });
      for (let waits = 0; waits < 20; waits++) {
        if ((await this.evaluate('globalThis.wheelArrived')) === true) return;
        await pause(25);
      }
    }
    await this.evaluate(`(() => {
      let target = document.elementFromPoint(${x}, ${y});
      for (let inner; (inner = target?.shadowRoot?.elementFromPoint(${x}, ${y}) ?? target) !== target; ) target = inner;
      const at = { clientX: ${x}, clientY: ${y}, deltaX: ${deltaX}, deltaY: ${deltaY} };
      return target?.dispatchEvent(new WheelEvent('wheel', { bubbles: true, cancelable: true, composed: true, ...at }));
    })()`);
  }
  async chooseFile(expression: string, path: string): Promise<void> {
    const input = (await this.call('POST', '/execute/sync', { script: `return ${expression}`, args: [] })) as Record<
      string,
      string
    >;
    await this.call('POST', `/element/${input[ELEMENT]}/value`, { text: path });
  }

  async resize(width: number, height: number): Promise<void> {
    let seen: [number, number] = [0, 0];
    let [barsWide, barsHigh] = [0, 0];
    for (let tries = 0; tries < 20; tries++, await pause(50)) {
      await this.call('POST', '/window/rect', { x: 0, y: 0, width: width + barsWide, height: height + barsHigh });
      seen = (await this.evaluate('[innerWidth, innerHeight]')) as [number, number];
      if (seen[0] === width && seen[1] === height) return;
      // The toolbars take the rest. The window may have its new size before the page has.
      const window = (await this.call('GET', '/window/rect')) as { width: number; height: number };
      [barsWide, barsHigh] = [Math.max(window.width - seen[0], 0), Math.max(window.height - seen[1], 0)];
    }
    throw new Error(`WebKit: the page does not become ${width} × ${height} but ${seen.join(' × ')}`);
  }
  async screenshot(): Promise<Buffer> {
    const { height: outer } = (await this.call('GET', '/window/rect')) as { height: number };
    const [width, height] = (await this.evaluate('[innerWidth, innerHeight]')) as [number, number];
    // WebDriver's own screenshot hangs.
    const { stdout } = await promisify(execFile)(
      program('PLAYGROUND_XWD'),
      ['-root', '-silent', '-display', this.machine.display],
      {
        encoding: 'buffer',
        maxBuffer: 64 * 1024 * 1024,
        timeout: 20_000,
      },
    );
    return png(stdout, { top: outer - height, width, height });
  }
  async opened(): Promise<Tab | undefined> {
    const handles = (await this.call('GET', '/window/handles')) as string[];
    const handle = handles.find((each) => !this.session.windows.has(each));
    if (handle === undefined) return undefined;
    this.session.windows.add(handle);
    return new WebKitTab(this.machine, this.session, handle, this.relay);
  }
  async errors(): Promise<string[]> {
    return (await this.evaluate('globalThis.errorsOfPage?.splice(0) ?? []')) as string[];
  }
  async close(): Promise<void> {
    if (this.window === this.session.window) {
      await this.call('POST', '/url', { url: 'about:blank' });
      this.relay.close();
    } else {
      await this.call('DELETE', '/window');
      this.session.windows.delete(this.window);
    }
  }
}
