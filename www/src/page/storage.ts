// What the browser remembers between visits: the last program of this page, and the reader's choices.
//
// In and out: plain values. A browser that refuses to store (private mode, full) is no error: nothing is
// kept. Must not know: what a program is.

export interface KeptProgram {
  /** With the line ends of its file, if it is one's. */
  readonly text: string;
  /** The example it began as. */
  readonly example: string;
  readonly control: string;
  readonly file?: { readonly name: string; readonly encoding: string };
  /** The setup as the element's attribute; empty when it has none. */
  readonly setup?: string;
  /** The switches, as the element's attributes. */
  readonly blockSkip?: string;
  readonly program?: string;
}

export interface Choices {
  readonly language?: string;
  readonly theme?: string;
  /** The hints that are still to be shown. */
  readonly hints?: string;
  /** The share of the program in the width, percent. */
  readonly split?: string;
  /** The size of the type, percent. */
  readonly textSize?: string;
}

const PROGRAM = `gcode-playground:program:${location.pathname}`;
const CHOICES = 'gcode-playground:choices';

export function keptProgram(): KeptProgram | undefined {
  const kept = read(PROGRAM);
  const fields = ['text', 'example', 'control'] as const;
  if (!fields.every((field) => typeof kept[field] === 'string')) return undefined;
  const { text, example, control, file, setup, blockSkip, program } = kept as unknown as KeptProgram;
  return {
    text, example, control,
    ...(typeof file?.name === 'string' && typeof file.encoding === 'string' ? { file } : {}),
    ...(typeof setup === 'string' ? { setup } : {}),
    ...(typeof blockSkip === 'string' ? { blockSkip } : {}),
    ...(typeof program === 'string' ? { program } : {}),
  };
}

export function keepProgram(program: KeptProgram): void {
  write(PROGRAM, program);
}

export function forgetProgram(): void {
  try {
    localStorage.removeItem(PROGRAM);
  } catch {
    // Nothing was kept.
  }
}

export function choices(): Choices {
  return read(CHOICES) as Choices;
}

export function keepChoices(change: Choices): void {
  write(CHOICES, { ...choices(), ...change });
}

function read(key: string): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : {};
  } catch {
    return {};
  }
}

function write(key: string, value: unknown): void {
  try {
    localStorage.setItem(key, JSON.stringify(value));
  } catch {
    // The program stays in the editor; it is only not remembered.
  }
}
