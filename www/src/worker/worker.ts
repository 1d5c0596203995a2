// The worker, shared by all elements of a page: owns the module, and a session for each element.
//
// In: the addresses of the part files, the module, then messages for the sessions. Out: their events, and which session
// is being processed: if one hangs or fails, all are lost, and the page must know which one caused it. Must not know:
// the work of a session.

import init, { Playground } from '../../pkg/gcode_playground.js';
import type { FromWorker, PartFiles, SessionEvent, ToWorker } from '../protocol/protocol';
import { fetchPart } from '../../pkg/parts.js';
import { describe } from './describe';
import { LateParts } from './parts';
import { mayNeedSetup, Session } from './session';

/** The first message. The script cannot compute the addresses itself, since it may run from a blob URL. */
let files: PartFiles | undefined;
let parts: LateParts<Session> | undefined;
const sessions = new Map<number, Session>();
/** Messages that arrived before the interpreter was loaded. */
const queuedMessages: Exclude<ToWorker, { readonly kind: 'files' | 'core' | 'ping' }>[] = [];
/** Schedules slices of sessions after the messages that have arrived by then. */
const slices = new MessageChannel();
/** The session that was last reported to the page as active. */
let activeSession: number | undefined;
let hasCrashed = false;

self.onmessage = ({ data: message }: MessageEvent<ToWorker>) => {
  if (message.kind === 'files') files = message.files;
  else if (message.kind === 'core') void load(message.module);
  else if (message.kind === 'ping') post({ kind: 'pong' });
  else if (parts === undefined) queueEarly(message);
  else receive(message, parts);
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
  for (const message of queuedMessages.splice(0)) receive(message, parts);
}

/** Queues a message; fetches the part `early` in parallel with the interpreter if the message needs it. */
function queueEarly(message: (typeof queuedMessages)[number]): void {
  queuedMessages.push(message);
  if (message.kind === 'to-session' && files !== undefined && mayNeedSetup(message.content)) fetchPart(files.early);
}

function receive(message: (typeof queuedMessages)[number], lateParts: LateParts<Session>): void {
  if (hasCrashed) return;
  const { session } = message;
  if (message.kind === 'close') {
    sessions.get(session)?.close();
    sessions.delete(session);
    return;
  }
  (sessions.get(session) ?? openSession(session, lateParts)).receive(message.content);
}

function openSession(id: number, lateParts: LateParts<Session>): Session {
  const session = new Session(new Playground(), lateParts, {
    queue: () => slices.port2.postMessage(id),
    emit: (event: SessionEvent, images) => post({ kind: 'event', session: id, event }, images),
    runGuarded(step) {
      if (hasCrashed || sessions.get(id) !== session) return;
      if (activeSession !== id) {
        activeSession = id;
        post({ kind: 'active', session: id });
      }
      try {
        step();
      } catch (error) {
        // A panic leaves the interpreter unusable: report it once, and ignore all further messages.
        hasCrashed = true;
        post({ kind: 'crashed', session: id, reason: describe(error) });
      }
    },
  });
  sessions.set(id, session);
  return session;
}

function post(event: FromWorker, images: ImageBitmap[] = []): void {
  self.postMessage(event, { transfer: images });
}
