// Content of links, tested without a page: stored links stay valid forever, length of new links, broken and hostile
// links. `share.spec.ts` tests what the page does with them.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { LINK_LIMIT } from '../../www/src/files/link-limit';
import {
  makeLink as made,
  EMPTY_SHARED,
  parseLink,
  type LinkFault,
  type Shared,
} from '../../www/src/files/shared-link';
import { UNPACKED_LIMIT } from '../../www/src/files/packed-text';
import { plainTextLink } from '../../www/src/files/plain-text-link';
import { parseAddress as parseInPage, type AddressContent } from '../../www/src/page/linked';
import { chromiumTest as test, expect } from './engines';
import { random, randomShared, randomText, storedLinks, wellFormed } from './links';

const PROGRAMS = join(__dirname, '..', 'programs');

function read(path: string): string | null {
  try {
    return readFileSync(join(PROGRAMS, path), 'utf8');
  } catch {
    return null;
  }
}

/** Like the page, which loads the decompression when it is first needed. */
async function parseAddress(hash: string): Promise<AddressContent> {
  if (!hash.startsWith('#share=')) return parseInPage(hash);
  const opened = await parseLink(hash);
  return opened.kind === 'shared' ? { kind: 'linked', linked: opened.shared } : opened;
}

async function linkOf(shared: Shared): Promise<string> {
  const link = await made(shared);
  if (link.kind !== 'link') throw new Error(JSON.stringify(link));
  return link.link;
}

async function opened(hash: string): Promise<Shared> {
  const found = await parseAddress(hash);
  if (found.kind !== 'linked') throw new Error(`${hash.slice(0, 80)}: ${JSON.stringify(found)}`);
  return found.linked;
}

async function faultOf(hash: string): Promise<LinkFault['kind'] | 'not-loaded' | 'none'> {
  const found = await parseAddress(hash);
  return found.kind === 'fault' ? found.fault.kind : 'none';
}

/** A link with a valid checksum for any content. */
function forged(body: string): string {
  let crc = -1;
  for (const letter of Buffer.from(body, 'latin1')) {
    crc ^= letter;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ ((crc & 1) === 0 ? 0 : 0xedb88320);
  }
  return `#share=1.${body.length + 8}.${body}${(~crc >>> 0).toString(16).padStart(8, '0')}`;
}

const packedJson = (value: unknown): string =>
  forged(`z${deflateRawSync(JSON.stringify(value)).toString('base64url')}`);

test('every stored link still opens the same content', async () => {
  const stored = storedLinks();
  expect(new Set(stored.map(({ version }) => version))).toEqual(new Set([0, 1, 2, 3]));
  for (const { what, link, opens } of stored) expect(await opened(link), what).toEqual({ ...EMPTY_SHARED, ...opens });
});

test('a link to each program of the tests is at most 300 characters longer than its text, and opens it', async () => {
  let count = 0;
  for (const id of readdirSync(PROGRAMS)) {
    const text = read(join(id, 'program.nc'));
    if (text === null) continue;
    count++;
    const shared: Shared = {
      ...EMPTY_SHARED,
      text,
      setup: read(join(id, 'setup.json')),
      control: 'fanuc',
      language: 'ru',
      step: '12',
      view: 'playback',
    };
    const link = await linkOf(shared);
    expect(link.length, id).toBeLessThanOrEqual(300 + text.length);
    expect(await opened(link), id).toEqual(shared);
  }
  expect(count).toBeGreaterThan(50);
});

test('a link to random G-code characters is at most 300 characters longer than the text, with and without a setup', async () => {
  const next = random(7);
  for (let round = 0; round < 200; round++) {
    const length = Math.floor(next() ** 3 * 30_000);
    const letters = '0123456789.-+ABCDFGHIJKLMNOPQRSTUVWXYZ #[]()/=*;%\n';
    const text = Array.from({ length }, () => letters[Math.floor(next() * letters.length)]).join('');
    const shared = {
      ...EMPTY_SHARED,
      text,
      control: 'gsk',
      language: 'zh',
      step: 'line 99',
      setup: round % 2 === 0 ? null : '{"stock":{"diameter":60,"length":80}}',
    };
    const link = await linkOf(shared);
    expect(link.length).toBeLessThanOrEqual(300 + text.length);
    expect((await opened(link)).text).toBe(text);
  }
});

test('random Unicode text survives the round trip, and takes at most four thirds of its bytes', async () => {
  const next = random(11);
  for (let round = 0; round < 500; round++) {
    const shared = randomShared(next);
    const link = await linkOf(shared);
    const bytes = Buffer.byteLength(
      JSON.stringify([
        shared.text,
        shared.setup,
        shared.file,
        shared.task,
        shared.answerTo,
        shared.exerciseText,
        shared.name,
      ]),
    );
    expect(link.length).toBeLessThanOrEqual(300 + (bytes * 4) / 3);
    expect(await opened(link)).toEqual(shared);
  }
});

test('a plain-text URL survives the round trip', async () => {
  const next = random(13);
  for (let round = 0; round < 200; round++) {
    const shared = JSON.parse(
      wellFormed(JSON.stringify(randomShared(next))).replace(/\\ud[89a-f]../g, '\ufffd'),
    ) as Shared;
    const { text, setup, control, blockSkip, language, view, step, readonly } = shared;
    const inPlainText = { text, setup, control, blockSkip, program: null, language, view, step, readonly };
    expect(await opened(`#${plainTextLink(inPlainText)}`)).toEqual({ ...EMPTY_SHARED, ...inPlainText });
  }
});

test('line breaks and a full stop that mail programs add to a link are ignored', async () => {
  const shared = { ...EMPTY_SHARED, text: randomText(random(3), 400) };
  const link = await linkOf(shared);
  for (const changed of [
    `${link}.`,
    `${link}).`,
    `${link}&utm_source=mail`,
    link.replace(/(.{70})/g, '$1%0A'),
    link.replace(/(.{70})/g, '$1 '),
  ]) {
    expect((await opened(changed)).text, changed.slice(-20)).toBe(shared.text);
  }
});

test('a truncated link is reported, with the number of missing characters', async () => {
  for (const { link, version } of storedLinks()) {
    if (version === 0) continue;
    for (let length = '#share='.length; length < link.length; length++) {
      const found = await parseAddress(link.slice(0, length));
      expect(found, link.slice(0, length)).toMatchObject({ kind: 'fault', fault: { kind: 'cut' } });
      const missing = found.kind === 'fault' && found.fault.kind === 'cut' ? found.fault.missing : undefined;
      if (missing !== undefined) expect(missing).toBe(link.length - length);
    }
    // Without the prefix it is not a link of ours.
    for (let length = 2; length < '#share='.length; length++)
      expect(await faultOf(link.slice(0, length))).toBe('unknown');
  }
});

test('a link with any one character changed never opens another program', async () => {
  const next = random(5);
  for (const { link, version } of storedLinks()) {
    if (version === 0) continue;
    for (let at = 1; at < link.length; at++) {
      for (const other of ['A', '.', String.fromCharCode(33 + Math.floor(next() * 90))]) {
        const changed = link.slice(0, at) + other + link.slice(at + 1);
        if (changed === link) continue;
        expect(await faultOf(changed), changed).not.toBe('none');
      }
    }
  }
});

test('a link of a newer version is reported as such, also if this version cannot parse it', async () => {
  for (const hash of ['#share=4.17.anything', '#share=4', '#share=17.%7B%7D', '#share=999999.'])
    expect(await faultOf(hash), hash).toBe('newer');
  // A link with an unknown key is rejected, not opened in part.
  expect(await faultOf(packedJson({ p: 'G0 X1', z: 'new' }))).toBe('damaged');
});

test('hostile links are refused: wrong types, missing fields, no JSON, no stream, no base64', async () => {
  const bodies: unknown[] = [
    null,
    1,
    'G0',
    [],
    {},
    { p: 1 },
    { p: null },
    { p: ['G0'] },
    { p: 'G0', s: {} },
    { p: 'G0', r: true },
    { p: 'G0', r: 'x' },
    { p: 'G0', c: 'x'.repeat(201) },
    { p: 'G0', f: 'name' },
    { p: 'G0', e: 'utf-8' },
    { p: 'G0', q: 'a task without a solution' },
    { p: 'G0', a: 7 },
    { p: 'G0', q: 'a version 2 answer', a: 'G1', h: 1 },
    { p: 'G0', n: 7 },
    { p: 'G0', n: null },
    { p: 'G0', n: ['Anna'] },
    { p: 'G0', n: 'x'.repeat(81) },
    { p: 'G0', __proto__x: '' },
    { p: 'G0', constructor: 'x' },
    { s: '{}' },
  ];
  for (const body of bodies) expect(await faultOf(packedJson(body)), JSON.stringify(body)).toBe('damaged');
  // Version 2 is only for links that version 1 cannot express.
  for (const body of [{ p: 'G0' }, { p: 'G0', q: '', a: '' }, { p: 'G0', h: 1 }, { p: 'G0', q: 'a', h: 2 }])
    expect(await faultOf(packedJson(body).replace('=1.', '=2.')), JSON.stringify(body)).toBe('damaged');
  // Version 3 has an exercise with all its keys, and no task.
  const exercise = { p: 'G0', x: 'pin', y: '0123456789abcdef', w: '0' };
  expect(await faultOf(packedJson(exercise))).toBe('damaged');
  for (const body of [
    { p: 'G0' },
    { p: 'G0', x: 'pin' },
    { ...exercise, x: '../pin' },
    { ...exercise, x: 'p'.repeat(65) },
    { ...exercise, y: '0123' },
    { ...exercise, w: '10' },
    { ...exercise, w: 1 },
    { ...exercise, q: 'task', a: 'G1' },
    { ...exercise, q: 'task', h: 1 },
    { p: '', m: 'no head' },
    { p: '', m: '---', q: 'task' },
  ])
    expect(await faultOf(packedJson(body).replace('=1.', '=3.')), JSON.stringify(body)).toBe('damaged');
  expect(await faultOf(forged(`z${deflateRawSync('{"p":"G0","__proto__":{"p":"G1"}}').toString('base64url')}`))).toBe(
    'damaged',
  );
  for (const body of [
    'z',
    'b',
    'x',
    'q123',
    'z!!!!',
    'b%%%',
    `z${Buffer.from('no stream').toString('base64url')}`,
    `b${Buffer.from('{"p":').toString('base64url')}`,
    `b${Buffer.from([0xff, 0xfe]).toString('base64url')}`,
  ]) {
    expect(await faultOf(forged(body)), body).toBe('damaged');
  }
  for (const hash of [
    '#share=',
    '#share=x',
    '#share=-1.',
    '#share=0.12.b',
    '#share=1.-5.b',
    '#share=1.5.bAAAA',
    '#share=1.999999999999.b',
    '#share=1.8.b0000000',
  ])
    expect(await faultOf(hash), hash).not.toBe('none');
});

test('a name of 80 characters survives the round trip', async () => {
  for (const name of ['Anna', '李'.repeat(80), '<img src=x onerror=alert(1)>', '\u202e\n'])
    expect(await opened(await linkOf({ ...EMPTY_SHARED, text: 'G0 X1', name }))).toEqual({
      ...EMPTY_SHARED,
      text: 'G0 X1',
      name,
    });
  expect((await opened(packedJson({ p: 'G0', n: 'x'.repeat(80) }))).name).toHaveLength(80);
});

test('decompression of a small link stops at the size limit', async () => {
  const bomb = forged(`z${deflateRawSync(Buffer.alloc(300_000_000, 'A'), { level: 9 }).toString('base64url')}`);
  expect(bomb.length).toBeLessThan(LINK_LIMIT);
  const before = process.memoryUsage().arrayBuffers;
  expect(await faultOf(bomb)).toBe('unpacked-too-long');
  expect(process.memoryUsage().arrayBuffers - before).toBeLessThan(50_000_000);
});

test('a link that could not be opened is not created', async () => {
  const next = random(17);
  const noise = Array.from({ length: 1_200_000 }, () => String.fromCharCode(33 + Math.floor(next() * 90))).join('');
  expect(await made({ ...EMPTY_SHARED, text: noise })).toMatchObject({ kind: 'too-long', limit: LINK_LIMIT });
  expect(await made({ ...EMPTY_SHARED, text: 'G1 X1\n'.repeat(600_000) })).toMatchObject({
    kind: 'too-long',
    limit: UNPACKED_LIMIT,
  });
  const long = 'G1 X1\n'.repeat(500_000);
  expect((await opened(await linkOf({ ...EMPTY_SHARED, text: long }))).text).toBe(long);
});

test('a URL of two million characters is rejected without parsing', async () => {
  for (const hash of [
    `#share=1.${'A'.repeat(2_000_000)}`,
    `#share=1.1999999.z${'A'.repeat(2_000_000)}`,
    `#program=${'A'.repeat(2_000_000)}`,
    `#${'%20'.repeat(700_000)}`,
  ]) {
    expect(await faultOf(hash)).toBe('too-long');
  }
  const opened = await parseLink(`#share=1.${'A'.repeat(2_000_000)}`);
  expect(opened).toMatchObject({ kind: 'fault', fault: { limit: LINK_LIMIT } });
});
