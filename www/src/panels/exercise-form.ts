// The form of an exercise whose answer is a given program with changes: end points to predict, blocks to order, gaps to
// fill.
//
// In: the exercise, the program in the editor, clicks in the section. Out: edits of that program, which is the answer.
// Must not know: how an answer is checked.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { ExerciseText } from '../protocol/protocol';
import type { Place, Shell } from './panel';

export interface ExerciseForm {
  readonly element: HTMLElement;
  /** The program that the learner begins with. */
  readonly begin: string;
  /** Shows the program of the editor after a change. */
  update(): void;
  /** A click in the section. Returns whether the form uses it. */
  takePlace(place: Place): boolean;
}

/** The form of an exercise; undefined if the learner writes in the editor only. */
export function formOf(exercise: ExerciseText, shell: Shell): ExerciseForm | undefined {
  const answer = new FormAnswer(exercise, shell);
  if (exercise.taskKind === 'predict') return new PointForm(exercise, answer, shell.language);
  if (exercise.taskKind === 'order') return new OrderForm(exercise, answer, shell.language);
  if (exercise.taskKind === 'blanks') return new GapForm(exercise, answer, shell.language);
  return undefined;
}

/** The program in the editor, without the setup comments after it: so its lines have the numbers of the exercise. */
class FormAnswer {
  readonly #shell: Shell;
  readonly #setup: string;
  #lastText: string | undefined;

  constructor(exercise: ExerciseText, shell: Shell) {
    this.#shell = shell;
    const setup = exercise.setup.trim();
    this.#setup = setup.startsWith('{') ? '' : `${setup}\n`;
  }

  /** Whether the text is another one than that of the last call. */
  get hasChanged(): boolean {
    const { text } = this.#shell.editor;
    const hasChanged = text !== this.#lastText;
    this.#lastText = text;
    return hasChanged;
  }

  get lines(): readonly string[] {
    const { text } = this.#shell.editor;
    const own = text.trimEnd().endsWith(this.#setup.trim())
      ? text.slice(0, text.lastIndexOf(this.#setup.trim()))
      : text;
    return own.trimEnd().split('\n');
  }

  withSetup(lines: readonly string[]): string {
    return `${lines.join('\n')}\n${this.#setup}`;
  }

  set lines(lines: readonly string[]) {
    const { editor } = this.#shell;
    const [before, after] = [editor.text, this.withSetup(lines)];
    if (before === after) return;
    const most = Math.min(before.length, after.length);
    let from = 0;
    while (from < most && before[from] === after[from]) from++;
    let same = 0;
    while (same < most - from && before[before.length - 1 - same] === after[after.length - 1 - same]) same++;
    this.#lastText = after;
    editor.change([{ from, to: before.length - same, text: after.slice(from, after.length - same) }]);
    this.#shell.commitEdit();
  }
}

/** The lines of a program without blank lines at its end. */
const linesOf = ({ program }: ExerciseText): readonly string[] => program.trimEnd().split('\n');

const field = (name: string): HTMLInputElement =>
  make('input', { type: 'text', autocomplete: 'off', spellcheck: false, 'aria-label': name });

// ---- end points to predict --------------------------------------------------------------------------

interface PointRow {
  /** From 1. */
  readonly line: number;
  readonly element: HTMLElement;
  readonly x: HTMLInputElement;
  readonly z: HTMLInputElement;
}

/** From the first point that is missing, the blocks are comments, so the picture does not show the answer. */
class PointForm implements ExerciseForm {
  readonly element: HTMLElement;
  readonly begin: string;
  readonly #answer: FormAnswer;
  readonly #program: readonly string[];
  readonly #rows: readonly PointRow[];
  #active: PointRow | undefined;

  constructor(exercise: ExerciseText, answer: FormAnswer, language: Language) {
    const texts = WORDS[language];
    this.#answer = answer;
    this.#program = linesOf(exercise);
    this.#rows = exercise.predict.map((line) => this.#row(line, texts));
    this.element = make(
      'div',
      { className: 'exercise-form' },
      make('p', {}, texts.predict),
      make('ol', {}, ...this.#rows.map((row) => row.element)),
    );
    this.begin = answer.withSetup(this.#written());
  }

  #row(line: number, texts: Texts): PointRow {
    const [x, z] = ['X', 'Z'].map((axis) => field(texts.endPoint(axis, line))) as [HTMLInputElement, HTMLInputElement];
    const code = make('code', {}, this.#program[line - 1] ?? '');
    const number = make('span', { className: 'exercise-line' }, String(line));
    const row = {
      line,
      x,
      z,
      element: make('li', {}, number, code, make('label', {}, 'X', x), make('label', {}, 'Z', z)),
    };
    for (const input of [x, z]) {
      input.addEventListener('input', () => this.#write());
      input.addEventListener('focus', () => {
        this.#active = row;
      });
    }
    return row;
  }

  update(): void {
    if (!this.#answer.hasChanged) return;
    const { lines } = this.#answer;
    for (const { line, x, z } of this.#rows) {
      const point = pointOf(lines[line - 1] ?? '');
      [x.value, z.value] = point ?? ['', ''];
    }
  }

  takePlace({ x, z }: Place): boolean {
    const missing = this.#rows.filter((row) => !isAnswered(row));
    const [first] = missing;
    const row =
      this.#active !== undefined && (first === undefined || missing.includes(this.#active)) ? this.#active : first;
    if (row === undefined) return false;
    // The section is drawn on both sides of the axis.
    const point = [Math.abs(x), z].map((value) => String(Number(value.toFixed(3))));
    [row.x.value, row.z.value] = point as [string, string];
    this.#active = this.#rows.find((other) => other.line > row.line && !isAnswered(other));
    this.#write();
    return true;
  }

  #write(): void {
    this.#answer.lines = this.#written();
  }

  /** The program with the points in the predicted lines. */
  #written(): string[] {
    const rows = new Map(this.#rows.map((row) => [row.line, row]));
    const firstMissing = this.#rows.find((row) => !isAnswered(row))?.line ?? Infinity;
    const last = this.#program.length;
    return this.#program.map((block, index) => {
      const line = index + 1;
      if (line >= firstMissing && line < last) return `(${block.replace(/[()]/g, ' ')})`;
      const row = rows.get(line);
      return row === undefined ? block : withPoint(block, numberIn(row.x) ?? '', numberIn(row.z) ?? '');
    });
  }
}

/** The number in a field as a program writes it; undefined if there is none. */
function numberIn({ value }: HTMLInputElement): string | undefined {
  const text = value.trim().replace(',', '.').replace('−', '-');
  return /^[-+]?(\d+\.?\d*|\.\d+)$/.test(text) ? text : undefined;
}

const isAnswered = ({ x, z }: PointRow): boolean => numberIn(x) !== undefined && numberIn(z) !== undefined;

/** X and Z of a block; undefined if it lacks one, or has a distance. */
function pointOf(block: string): [string, string] | undefined {
  const code = block.replace(/\([^)]*\)/g, '');
  const [x, z] = [/X\s*([-+]?[\d.]+)/i, /Z\s*([-+]?[\d.]+)/i].map((word) => word.exec(code)?.[1]);
  return x === undefined || z === undefined || /[UW]/i.test(code) ? undefined : [x, z];
}

/** A block with a point in place of its coordinates and distances. */
function withPoint(block: string, x: string, z: string): string {
  const all = block.replace(/\([^)]*\)/g, '').match(/[A-Z][^A-Z]*/gi) ?? [];
  const kept = all.map((word) => word.trim()).filter((word) => !/^[XZUW]/i.test(word));
  const isCode = (word: string): boolean => /^[NG]/i.test(word);
  return [...kept.filter(isCode), `X${x}`, `Z${z}`, ...kept.filter((word) => !isCode(word))].join(' ');
}

// ---- blocks to order --------------------------------------------------------------------------------

class OrderForm implements ExerciseForm {
  readonly element: HTMLElement;
  readonly begin: string;
  readonly #answer: FormAnswer;
  readonly #texts: Texts;
  readonly #list = make('ol', { className: 'exercise-order' });

  constructor(exercise: ExerciseText, answer: FormAnswer, language: Language) {
    this.#answer = answer;
    this.#texts = WORDS[language];
    this.begin = answer.withSetup(linesOf(exercise));
    this.element = make('div', { className: 'exercise-form' }, make('p', {}, this.#texts.order), this.#list);
  }

  update(): void {
    if (!this.#answer.hasChanged) return;
    const { lines } = this.#answer;
    this.#list.replaceChildren(...lines.map((line, at) => this.#item(line, at, lines.length)));
  }

  takePlace(): boolean {
    return false;
  }

  #item(line: string, at: number, count: number): HTMLElement {
    const button = (direction: 'up' | 'down', to: number): HTMLButtonElement => {
      const name = this.#texts[direction](line);
      const disabled = to < 0 || to >= count;
      const arrow = direction === 'up' ? '↑' : '↓';
      const button = make('button', { type: 'button', disabled, 'aria-label': name, title: name }, arrow);
      button.addEventListener('click', () => {
        this.#move(at, to);
        // The button of the moved block, so that the next press moves it on.
        const moved = this.#list.children[to]?.querySelectorAll('button')[direction === 'up' ? 0 : 1];
        moved?.focus();
      });
      return button;
    };
    const handle = make('span', { className: 'exercise-handle', 'aria-hidden': 'true' }, '≡');
    const item = make('li', {}, handle, make('code', {}, line), button('up', at - 1), button('down', at + 1));
    handle.addEventListener('pointerdown', (event) => this.#drag(event, item, at));
    return item;
  }

  /** Moves a block with the pointer; the program changes when it is released. */
  #drag(event: PointerEvent, item: HTMLElement, from: number): void {
    event.preventDefault();
    // Not the item: an element that is moved loses the capture.
    const list = this.#list;
    list.setPointerCapture(event.pointerId);
    item.classList.add('is-dragged');
    const end = new AbortController();
    const { signal } = end;
    const follow = ({ clientY }: PointerEvent): void => {
      const others = [...list.children].filter((other) => other !== item);
      const next = others.find((other) => {
        const { top, height } = other.getBoundingClientRect();
        return clientY < top + height / 2;
      });
      if (item.nextElementSibling === (next ?? null)) return;
      list.insertBefore(item, next ?? null);
      // At the border of the panel the list scrolls.
      item.scrollIntoView({ block: 'nearest' });
    };
    const release = (): void => {
      end.abort();
      item.classList.remove('is-dragged');
      this.#move(from, [...list.children].indexOf(item));
    };
    list.addEventListener('pointermove', follow, { signal });
    list.addEventListener('lostpointercapture', release, { signal });
  }

  #move(from: number, to: number): void {
    const lines = [...this.#answer.lines];
    lines.splice(to, 0, ...lines.splice(from, 1));
    this.#answer.lines = lines;
    this.#list.replaceChildren(...lines.map((line, at) => this.#item(line, at, lines.length)));
  }
}

// ---- gaps to fill -----------------------------------------------------------------------------------

/** A gap in a program. */
const GAP = '__';

interface GapRow {
  /** From 0. */
  readonly line: number;
  /** The text before the first gap, between two gaps, and after the last one. */
  readonly pieces: readonly string[];
  readonly inputs: readonly HTMLInputElement[];
}

class GapForm implements ExerciseForm {
  readonly element: HTMLElement;
  readonly begin: string;
  readonly #answer: FormAnswer;
  readonly #rows: readonly GapRow[];

  constructor(exercise: ExerciseText, answer: FormAnswer, language: Language) {
    const texts = WORDS[language];
    this.#answer = answer;
    const lines = linesOf(exercise);
    this.begin = answer.withSetup(lines);
    this.#rows = lines.flatMap((text, line) => (text.includes(GAP) ? [this.#row(text, line, texts)] : []));
    this.element = make(
      'div',
      { className: 'exercise-form' },
      make('p', {}, texts.blanks),
      make('ol', {}, ...this.#rows.map((row) => itemOf(row))),
    );
  }

  #row(text: string, line: number, texts: Texts): GapRow {
    const pieces = text.split(GAP);
    const inputs = pieces.slice(1).map((_, at) => {
      const letter = /([A-Z])\s*$/i.exec(pieces[at] ?? '')?.[1] ?? '';
      return field(texts.gap(letter, line + 1));
    });
    const row = { line, pieces, inputs };
    for (const input of inputs) input.addEventListener('input', () => this.#write(row));
    return row;
  }

  update(): void {
    if (!this.#answer.hasChanged) return;
    const { lines } = this.#answer;
    for (const { line, pieces, inputs } of this.#rows) {
      const values = valuesIn(lines[line] ?? '', pieces);
      for (const [at, input] of inputs.entries()) input.value = values[at] ?? '';
    }
  }

  takePlace(): boolean {
    return false;
  }

  #write({ line, pieces, inputs }: GapRow): void {
    const lines = [...this.#answer.lines];
    const fill = (piece: string, at: number): string =>
      piece + (inputs[at] === undefined ? '' : inputs[at].value.trim() || GAP);
    lines[line] = pieces.map(fill).join('');
    this.#answer.lines = lines;
  }
}

function itemOf({ line, pieces, inputs }: GapRow): HTMLElement {
  const parts = pieces.flatMap((piece, at) => [piece, ...inputs.slice(at, at + 1)]);
  return make('li', {}, make('span', { className: 'exercise-line' }, String(line + 1)), make('code', {}, ...parts));
}

/** What a block has in the gaps between the pieces; empty if it is another block, or has the gap itself. */
function valuesIn(block: string, pieces: readonly string[]): readonly string[] {
  const quoted = (piece: string): string => piece.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const found = new RegExp(`^${pieces.map(quoted).join('(.*?)')}$`).exec(block.trim());
  return (found ?? []).slice(1).map((value) => (value === GAP ? '' : value));
}

type Texts = (typeof WORDS)['en'];

const WORDS = words({
  en: {
    predict: 'Enter the end point of each block in absolute coordinates, or click it in the drawing.',
    endPoint: (axis: string, line: number) => `${axis} at the end of line ${line}`,
    order: 'Drag the blocks into order, or use the arrows.',
    up: (block: string) => `Move up: ${block}`,
    down: (block: string) => `Move down: ${block}`,
    blanks: 'Fill the gaps here or in the program.',
    gap: (letter: string, line: number) => `Gap ${letter} in line ${line}`,
  },
  zh: {
    predict: '请输入每个程序段终点的绝对坐标，或在图中点击终点。',
    endPoint: (axis, line) => `第 ${line} 行终点的 ${axis}`,
    order: '请拖动程序段排序，或使用箭头。',
    up: (block) => `上移：${block}`,
    down: (block) => `下移：${block}`,
    blanks: '请在此处或程序中填写空格。',
    gap: (letter, line) => `第 ${line} 行 ${letter} 的空格`,
  },
  ru: {
    predict: 'Введите конечную точку каждого кадра в абсолютных координатах или щёлкните её на чертеже.',
    endPoint: (axis, line) => `${axis} в конце строки ${line}`,
    order: 'Перетащите кадры в нужном порядке или пользуйтесь стрелками.',
    up: (block) => `Вверх: ${block}`,
    down: (block) => `Вниз: ${block}`,
    blanks: 'Заполните пропуски здесь или в программе.',
    gap: (letter, line) => `Пропуск ${letter} в строке ${line}`,
  },
});
