// Rules of the list of own programs, without a browser: retention of earlier states, default names, and validation of
// files and stored values.
import { chromiumTest as test, expect } from './engines';
import type * as Rules from '../../www/src/page/own-programs';
import type * as Storage from '../../www/src/page/storage';

const [SECOND, MINUTE, HOUR, DAY] = [1000, 60_000, 3_600_000, 86_400_000];
const NOW = Date.UTC(2026, 10, 25, 12, 0, 30);
const PROGRAM = { text: 'G0 X1', example: '', control: '' };

let rules: typeof Rules;
let storage: typeof Storage;

test.beforeAll(async () => {
  const items = new Map<string, string>();
  const localStorage = new Proxy(
    {
      getItem: (key: string) => items.get(key) ?? null,
      setItem: (key: string, value: string) => void items.set(key, value),
      removeItem: (key: string) => void items.delete(key),
    },
    { ownKeys: () => [...items.keys()], getOwnPropertyDescriptor: () => ({ enumerable: true, configurable: true }) },
  );
  Object.assign(globalThis, { location: { pathname: '/' }, localStorage });
  storage = await import('../../www/src/page/storage');
  rules = await import('../../www/src/page/own-programs');
});

/** Ages of the retained states, if there is one state every `apart` up to `oldest`. */
function keptAges(apart: number, oldest: number): number[] {
  const states = Array.from({ length: Math.floor(oldest / apart) }, (_, i) => ({ time: NOW - i * apart, length: 10 }));
  const gone = new Set(rules.statesToDelete(states, NOW));
  return states.filter((state) => !gone.has(state)).map(({ time }) => NOW - time);
}

test('all states of the last ten minutes are kept, then one per ten minutes of a day, then one per day', () => {
  const recent = keptAges(15 * SECOND, 10 * MINUTE);
  expect(recent).toHaveLength(40);
  const ofToday = keptAges(MINUTE, 8 * HOUR).filter((age) => age >= 10 * MINUTE);
  expect(ofToday.length).toBeGreaterThanOrEqual(47);
  expect(ofToday.length).toBeLessThanOrEqual(48);
  const before = keptAges(HOUR, 60 * DAY).filter((age) => age >= DAY);
  expect(before.length).toBeGreaterThanOrEqual(59);
  expect(before.length).toBeLessThanOrEqual(60);
});

test('at most a hundred states and a limited number of characters are kept, and the newest have priority', () => {
  const states = Array.from({ length: 500 }, (_, i) => ({ time: NOW - i * SECOND, length: 10 }));
  const left = states.filter((state) => !rules.statesToDelete(states, NOW).includes(state));
  expect(left).toEqual(states.slice(0, rules.LIMITS.states));
  expect(rules.LIMITS.states).toBe(100);
  const long = states.slice(0, 10).map((state) => ({ ...state, length: rules.LIMITS.stateUnits / 4 }));
  expect(long.filter((state) => !rules.statesToDelete(long, NOW).includes(state))).toEqual(long.slice(0, 4));
});

test('a text becomes a new state when the last one is 15 seconds old', () => {
  expect(rules.shouldKeepState([], NOW)).toBe(true);
  expect(rules.shouldKeepState([{ time: NOW - 14 * SECOND, length: 1 }], NOW)).toBe(false);
  expect(
    rules.shouldKeepState(
      [
        { time: NOW - 15 * SECOND, length: 1 },
        { time: NOW - DAY, length: 1 },
      ],
      NOW,
    ),
  ).toBe(true);
});

test('a program is named after its file, its example, its number and comment, or its first line', () => {
  const name = (text: string, file?: string, title?: string) =>
    rules.nameOf(
      { ...PROGRAM, text, ...(file === undefined ? {} : { file: { name: file, encoding: 'utf-8' } }) },
      title,
    );
  expect(name('O0011 (SHAFT)\nG0', 'part.nc', 'Example')).toBe('part.nc');
  expect(name('O0011 (SHAFT)\nG0', undefined, 'Turning')).toBe('Turning');
  expect(name('%\nO0011 (SHAFT)\nG0')).toBe('O0011 SHAFT');
  expect(name('%\r\nO0011\r\n(SHAFT)')).toBe('O0011');
  expect(name('\n  G00 X1  \nG1')).toBe('G00 X1');
  expect(name(' \n')).toBe('');
  expect([...name(`(${'長'.repeat(500)})`)]).toHaveLength(rules.LIMITS.name);
  expect(rules.uniqueName('Shaft (2)', ['Shaft', 'Shaft (2)'])).toBe('Shaft (3)');
});

/** A value of each JSON type. */
const ANY: readonly unknown[] = [undefined, null, true, 0, -1, 1e300, NaN, '', 'x', [], [[]], {}, { text: 1 }];

test('stored values of any type are read without an exception, and values of a wrong type are dropped', () => {
  for (const of of ANY) {
    for (const key of [
      'gcode-playground:choices',
      'gcode-playground:last:/',
      'gcode-playground:program:/',
      'gcode-playground:journal:/:0123456789abcdef:0123456789abcdef',
    ]) {
      localStorage.setItem(key, JSON.stringify(of) ?? 'undefined');
      expect(
        () => [storage.readChoices(), storage.readLastEntry(), storage.readJournal()],
        `${key} ${JSON.stringify(of)}`,
      ).not.toThrow();
    }
    for (const field of ['language', 'theme', 'hints', 'split', 'textSize', 'description']) {
      localStorage.setItem('gcode-playground:choices', JSON.stringify({ [field]: of }));
      expect(storage.readChoices()).toEqual(typeof of === 'string' ? { [field]: of } : {});
    }
    for (const field of ['text', 'example', 'control', 'file', 'setup', 'blockSkip', 'program']) {
      const read = storage.parseProgram({ ...PROGRAM, [field]: of });
      for (const [name, value] of Object.entries(read ?? {}))
        expect(typeof value, `${name} of ${JSON.stringify(of)}`).toBe(name === 'file' ? 'object' : 'string');
    }
    for (const field of [
      'id',
      'name',
      'namedBy',
      'created',
      'changed',
      'revision',
      'tab',
      'seen',
      'length',
      'words',
      'picture',
    ]) {
      const read = rules.parseRow({ id: '0123456789abcdef', [field]: of });
      for (const [name, value] of Object.entries(read ?? {}))
        expect(typeof value).toBe(
          ['id', 'name', 'namedBy', 'tab', 'words'].includes(name)
            ? 'string'
            : name === 'picture' || name === 'seen'
              ? 'object'
              : 'number',
        );
    }
    for (const field of ['id', 'name', 'namedBy', 'created', 'changed', 'program', 'states']) {
      const filed = {
        id: '0123456789abcdef',
        name: 'a',
        namedBy: 'program',
        created: 1,
        changed: 1,
        program: PROGRAM,
        states: [{ time: 1, program: PROGRAM }],
        [field]: of,
      };
      const read = rules.parseExportFile(
        JSON.stringify({ format: 'gcode-playground programs', version: 1, programs: [filed] }),
      );
      expect(read.kind).toBe('programs');
    }
    expect(rules.parseExportFile(JSON.stringify(of) ?? '').kind).toBe('another-format');
  }
});

test('a program from a file is added beside one with the same id and another text', () => {
  const filed = {
    id: '0123456789abcdef',
    name: 'a',
    namedBy: 'program',
    created: 1,
    changed: 1,
    program: PROGRAM,
    states: [],
  } as const;
  expect(rules.importMode(filed, undefined)).toBe('new');
  expect(rules.importMode(filed, { ...PROGRAM })).toBe('duplicate');
  expect(rules.importMode(filed, { ...PROGRAM, control: 'gsk' })).toBe('copy');
  const back = rules.parseExportFile(rules.toExportFile([filed]));
  expect(back).toEqual({ kind: 'programs', programs: [filed], unreadable: 0 });
});

test('the words for the search are found in linear time', () => {
  const start = performance.now();
  expect(rules.searchWords(`${'('.repeat(49_000)}\nG71 M3`)).toBe('G71 M3');
  expect(performance.now() - start).toBeLessThan(1000);
});
