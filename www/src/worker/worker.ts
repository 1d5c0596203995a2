// The interpreter's own thread, shared by all elements of a page: the module, and a session for each element.
//
// In: where the files of its parts are, the module of the interpreter, then what the page says in its sessions. Out: what they report, and which of
// them the thread is at work for: one that hangs or fails takes the others down with it, and the page has to know which
// it was. Must not know: what is done in a session.

import init, { Playground } from '../../pkg/gcode_playground.js';
import type { FromWorker, PartFiles, SessionEvent, ToWorker } from '../protocol/protocol';
import { fetchPart } from '../../pkg/parts.js';
import { LateParts } from './parts';
import { mayNeedSetup, Session } from './session';

/** The first thing heard. This script may have an address from which no other is found. */
let files: PartFiles | undefined;
let parts: LateParts<Session> | undefined;
const sessions = new Map<number, Session>();
/** What came before the interpreter was loaded. */
const early: Exclude<ToWorker, { readonly kind: 'files' | 'core' | 'ping' }>[] = [];
/** Sessions that go on after the messages that have come by then. */
const slices = new MessageChannel();
/** The session that the page heard of last. */
let atWork: number | undefined;
let hasCrashed = false;

self.onmessage = ({ data: message }: MessageEvent<ToWorker>) => {
  if (message.kind === 'files') files = message.files;
  else if (message.kind === 'core') void load(message.module);
  else if (message.kind === 'ping') post({ kind: 'pong' });
  else if (parts === undefined) hearEarly(message);
  else hear(message, parts);
};
slices.port1.onmessage = ({ data }: MessageEvent<number>) => sessions.get(data)?.nextSlice();

async function load(module: WebAssembly.Module): Promise<void> {
  try {
    if (files === undefined) throw new Error('files');
    parts = new LateParts(await init({ module_or_path: module }), files, () => sessions.values());
  } catch (error) {
    post({ kind: 'load-failed', reason: describe(error) });
    return;
  }
  post({ kind: 'ready' });
  for (const message of early.splice(0)) hear(message, parts);
}

/** What is said to need another part has it fetched together with the interpreter. */
function hearEarly(message: (typeof early)[number]): void {
  early.push(message);
  if (message.kind === 'say' && files !== undefined && mayNeedSetup(message.what)) fetchPart(files.early);
}

function hear(message: (typeof early)[number], late: LateParts<Session>): void {
  if (hasCrashed) return;
  const { session } = message;
  if (message.kind === 'close') {
    sessions.get(session)?.close();
    sessions.delete(session);
    return;
  }
  (sessions.get(session) ?? open(session, late)).hear(message.what);
}

function open(id: number, late: LateParts<Session>): Session {
  const session = new Session(new Playground(), late, {
    queue: () => slices.port2.postMessage(id),
    tell: (event: SessionEvent, images) => post({ kind: 'event', session: id, event }, images),
    guarded(step) {
      if (hasCrashed || sessions.get(id) !== session) return;
      if (atWork !== id) {
        atWork = id;
        post({ kind: 'at-work', session: id });
      }
      try {
        step();
      } catch (error) {
        // A panic leaves the interpreter unusable: one report says so, and no further message is taken.
        hasCrashed = true;
        post({ kind: 'crashed', session: id, reason: describe(error) });
      }
    },
  });
  sessions.set(id, session);
  return session;
}

function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function post(event: FromWorker, images: ImageBitmap[] = []): void {
  self.postMessage(event, { transfer: images });
}
