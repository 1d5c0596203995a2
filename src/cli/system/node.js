// The system interface under Node, the counterpart of `native.rs`.
//
// In: paths, bytes. Out: bytes, names; Node errors with their `code`, and `EFBIG` for a file that is too
// large. All calls are synchronous: the command line has no other work.

import {
  closeSync, constants, fstatSync, fsyncSync, ftruncateSync, openSync, readFileSync, readSync, readdirSync, realpathSync, statSync, writeSync,
} from 'node:fs';
import { resolve } from 'node:path';
import { isatty } from 'node:tty';

export { closeSync, fchmodSync, fchownSync, readlinkSync, renameSync, unlinkSync } from 'node:fs';

const CHUNK = 65_536;

export function argumentsTyped() {
  return ['gcode-playground', ...process.argv.slice(2)];
}

export function environmentVariable(name) {
  return process.env[name];
}

export function readFile(path, most) {
  const file = openSync(path, 'r');
  try {
    const found = fstatSync(file);
    if (found.isDirectory()) throw coded('EISDIR');
    if (found.size > most) throw coded('EFBIG');
    // A pipe, for example, has no length.
    return found.isFile() ? readFileSync(file) : readWithin(file, most);
  } finally {
    closeSync(file);
  }
}

export function readHead(path, most) {
  const file = openSync(path, 'r');
  try {
    const bytes = Buffer.allocUnsafe(Math.min(most, fstatSync(file).size));
    let length = 0;
    for (let read = -1; read !== 0 && length < bytes.length; length += read) read = readSync(file, bytes, length);
    return bytes.subarray(0, length);
  } finally {
    closeSync(file);
  }
}

export function readStandardInput(most) {
  return readWithin(0, most);
}

/** Reads a stream of unknown length; stops one byte past the limit. */
function readWithin(file, most) {
  const chunks = [];
  let length = 0;
  while (length <= most) {
    const chunk = Buffer.allocUnsafe(Math.min(CHUNK, most + 1 - length));
    const read = whenReady(() => readSync(file, chunk), 'EOF');
    if (read === 0) return Buffer.concat(chunks);
    chunks.push(chunk.subarray(0, read));
    length += read;
  }
  throw coded('EFBIG');
}

/** Creates a file that does not exist yet. */
export function createFile(path, mode) {
  return openSync(path, 'wx', mode);
}

/** Opens an existing file for writing. */
export function openToWrite(path) {
  return openSync(path, constants.O_WRONLY);
}

/** Replaces the whole content of a file, and flushes it to the disk. */
export function writeWhole(descriptor, bytes) {
  for (let at = 0; at < bytes.length;) at += writeSync(descriptor, bytes, at, bytes.length - at, at);
  ftruncateSync(descriptor, bytes.length);
  fsyncSync(descriptor);
}

/** Writes to a device, a pipe, or the path of a file descriptor. */
export function writeDirectly(path, bytes) {
  const file = openSync(path, constants.O_WRONLY | constants.O_TRUNC);
  try {
    writeTo(file, bytes);
  } finally {
    closeSync(file);
  }
}

/** Flushes a folder to the disk. */
export function flushFolder(path) {
  const folder = openSync(path, 'r');
  try {
    fsyncSync(folder);
  } finally {
    closeSync(folder);
  }
}

export function writeTo(descriptor, bytes) {
  for (let from = 0; from < bytes.length;) from += whenReady(() => writeSync(descriptor, bytes, from));
}

/** Repeats a call until the stream is ready: a non-blocking pipe reports `EAGAIN`. */
function whenReady(call, end) {
  for (;;) {
    try {
      return call();
    } catch (error) {
      if (error.code === end) return 0;
      if (error.code !== 'EAGAIN') throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1);
    }
  }
}

export function kindOf(path) {
  return kindNamed(statSync(path));
}

/** Mode, user, group, number of hard links, device, inode number. */
export function factsOf(path) {
  const { mode, uid, gid, nlink, dev, ino } = statSync(path, { bigint: true });
  return BigUint64Array.of(mode, uid, gid, nlink, dev, ino);
}

export function canonicalPath(path) {
  return realpathSync.native(path);
}

/** Name and type of each entry, alternating. */
export function entriesOf(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => [entry.name, kindNamed(entry)]);
}

export function absolutePath(path) {
  return resolve(path);
}

export function isTerminal(descriptor) {
  return isatty(descriptor);
}

export function endWith(status) {
  process.exitCode = status;
}

function kindNamed(found) {
  if (found.isFile()) return 'file';
  return found.isDirectory() ? 'folder' : 'other';
}

function coded(code) {
  return Object.assign(new Error(code), { code });
}
