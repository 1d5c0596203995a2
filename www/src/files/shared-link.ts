// Reads and writes links: a program with its context, after the `#` of an address.
//
// In: a program with its context, or the part of an address from `#`. Out: the other one, or a fault. Links come from
// other people, so every field is validated. Must not know: the contents of a program or a setup.
//
//   #share=3.<packed>      version 3: an answer to an exercise, or an exercise; keys as in version 1
//   #share=2.<packed>      version 2: an answer with its task, or a task without a solution; keys as in version 1
//   #share=1.<packed>      version 1: a JSON object with the keys of `KEYS`, packed by `packed-text.ts`; null values are omitted
//   #program=…&setup=…     version 0, percent-encoded, as people and other programs write it; its other keys are the attributes of
//                          the element: control, block-skip, language, view, step, readonly
// All versions must remain readable: a change needs a new version. `tests/links.json` has links of each, with their
// contents. A link that version 1 can express is made in version 1, so that an older page can open it.

import { LINK_LIMIT } from './link-limit';
import { pack, unpack, UNPACKED_LIMIT } from './packed-text';

const VERSION = 3;

export interface Task {
  readonly sentence: string;
  /** Null: the link does not contain it. */
  readonly solution: string | null;
}

/** The exercise that a program is an answer to. */
export interface AnsweredExercise {
  readonly id: string;
  /** The checksum of its file, as in `ExerciseText`. */
  readonly version: string;
  /** Number of hints that the learner had opened. */
  readonly hints: number;
}

/** A program with its context; null: not given. */
export interface Shared {
  /** With its original line ends. */
  readonly text: string;
  /** JSON */
  readonly setup: string | null;
  readonly control: string | null;
  readonly blockSkip: string | null;
  /** The O number of the program to run. */
  readonly program: string | null;
  readonly language: string | null;
  readonly view: string | null;
  readonly step: string | null;
  readonly readonly: boolean;
  readonly file: { readonly name: string; readonly encoding: string } | null;
  /** A task: the text is the starting point for the student's program. */
  readonly task: Task | null;
  /** The task that the text is an answer to. At most one of `task` and `answerTo` is set. */
  readonly answerTo: Task | null;
  /** The exercise that the text is an answer to; then there is no task. */
  readonly exercise: AnsweredExercise | null;
  /** The text of an exercise file: the exercise to work on, or the exercise of an answer. */
  readonly exerciseText: string | null;
  /** Name of the student whose answer to a task or an exercise this is. */
  readonly name: string | null;
}

export const EMPTY_SHARED: Shared = {
  text: '',
  setup: null,
  control: null,
  blockSkip: null,
  program: null,
  language: null,
  view: null,
  step: null,
  readonly: false,
  file: null,
  task: null,
  answerTo: null,
  exercise: null,
  exerciseText: null,
  name: null,
};

export type LinkFault =
  | { readonly kind: 'too-long'; readonly length: number; readonly limit: number }
  | { readonly kind: 'unpacked-too-long'; readonly limit: number }
  | { readonly kind: 'newer'; readonly version: number }
  | { readonly kind: 'cut'; readonly missing: number | undefined }
  | { readonly kind: 'damaged' }
  | { readonly kind: 'browser-too-old' }
  /** None of the keys is known. */
  | { readonly kind: 'unknown' };

type ParsedLink =
  | { readonly kind: 'shared'; readonly shared: Shared }
  | { readonly kind: 'fault'; readonly fault: LinkFault };

/** The keys of all versions; `answer` belongs to version 2, the keys of an exercise to version 3. */
const KEYS = {
  text: 'p',
  setup: 's',
  control: 'c',
  blockSkip: 'k',
  program: 'o',
  language: 'l',
  view: 'v',
  step: 't',
  readonly: 'r',
  fileName: 'f',
  encoding: 'e',
  sentence: 'q',
  solution: 'a',
  name: 'n',
  answer: 'h',
  exercise: 'x',
  exerciseVersion: 'y',
  hints: 'w',
  exerciseText: 'm',
} as const;
const KNOWN_KEYS: ReadonlySet<string> = new Set(Object.values(KEYS));
/** Most characters of a text that is not a program, setup or sentence. */
const MAX_FIELD_LENGTH = 200;
/** Most characters of a name. */
export const NAME_LIMIT = 80;

export type MadeLink =
  | { readonly kind: 'link'; readonly link: string }
  /** The link would be too long to be read. */
  | { readonly kind: 'too-long'; readonly length: number; readonly limit: number };

/** Makes the part of an address from `#`. */
export async function makeLink(shared: Shared): Promise<MadeLink> {
  const {
    text,
    setup,
    control,
    blockSkip,
    program,
    language,
    view,
    step,
    file,
    answerTo,
    exercise,
    exerciseText,
    name,
  } = shared;
  const task = answerTo ?? shared.task;
  const version = exercise !== null || exerciseText !== null ? 3 : answerTo !== null || task?.solution === null ? 2 : 1;
  const entries = [
    [KEYS.text, text],
    [KEYS.setup, setup],
    [KEYS.control, control],
    [KEYS.blockSkip, blockSkip],
    [KEYS.program, program],
    [KEYS.language, language],
    [KEYS.view, view],
    [KEYS.step, step],
    [KEYS.readonly, shared.readonly ? 1 : null],
    [KEYS.fileName, file?.name ?? null],
    [KEYS.encoding, file?.encoding ?? null],
    [KEYS.sentence, task?.sentence ?? null],
    [KEYS.solution, task?.solution ?? null],
    [KEYS.name, name],
    [KEYS.answer, answerTo === null ? null : 1],
    [KEYS.exercise, exercise?.id ?? null],
    [KEYS.exerciseVersion, exercise?.version ?? null],
    [KEYS.hints, exercise === null ? null : String(exercise.hints)],
    [KEYS.exerciseText, exerciseText],
  ] as const;
  const json = JSON.stringify(Object.fromEntries(entries.filter(([, value]) => value !== null)));
  const characters = await pack(json);
  if (characters === undefined) return { kind: 'too-long', length: json.length, limit: UNPACKED_LIMIT };
  const link = `#share=${version}.${characters}`;
  return link.length > LINK_LIMIT
    ? { kind: 'too-long', length: link.length, limit: LINK_LIMIT }
    : { kind: 'link', link };
}

/** `hash` begins with `#share=`. */
export async function parseLink(hash: string): Promise<ParsedLink> {
  // Mail programs break long lines.
  const body = hash.length > LINK_LIMIT ? hash : hash.replace(/^#share=/, '').replace(/\s|%20|%0[AD]/gi, '');
  if (body.length > LINK_LIMIT) return fault({ kind: 'too-long', length: body.length, limit: LINK_LIMIT });
  const version = /^(\d{1,6})(?:\.|$)/.exec(body);
  if (version === null) return fault(body === '' ? { kind: 'cut', missing: undefined } : { kind: 'damaged' });
  if (Number(version[1]) > VERSION) return fault({ kind: 'newer', version: Number(version[1]) });
  if (Number(version[1]) < 1) return fault({ kind: 'damaged' });
  const found = await unpack(body.slice(version[0].length));
  switch (found.kind) {
    case 'text': {
      const shared = parseShared(found.text, Number(version[1]));
      return shared === undefined ? fault({ kind: 'damaged' }) : { kind: 'shared', shared };
    }
    case 'cut':
      return fault(found);
    case 'damaged':
      return fault(found);
    case 'too-long':
      return fault({ kind: 'unpacked-too-long', limit: found.limit });
    case 'unsupported':
      return fault({ kind: 'browser-too-old' });
  }
}

function fault(fault: LinkFault): ParsedLink {
  return { kind: 'fault', fault };
}

/** Undefined if a field is invalid, or unknown in this version. */
function parseShared(json: string, version: number): Shared | undefined {
  let parsed: unknown;
  try {
    parsed = JSON.parse(json);
  } catch {
    return undefined;
  }
  if (typeof parsed !== 'object' || parsed === null || Array.isArray(parsed)) return undefined;
  const fields = new Map<string, unknown>(Object.entries(parsed));
  const flags = [fields.get(KEYS.readonly), fields.get(KEYS.answer)] as const;
  fields.delete(KEYS.readonly);
  fields.delete(KEYS.answer);
  if (flags.some((flag) => flag !== undefined && flag !== 1)) return undefined;
  const [isReadonly, isAnswer] = [flags[0] === 1, flags[1] === 1];
  for (const [key, value] of fields) if (!KNOWN_KEYS.has(key) || typeof value !== 'string') return undefined;
  const field = (key: keyof typeof KEYS): string | null => (fields.get(KEYS[key]) as string | undefined) ?? null;
  const shortFields = [
    field('control'),
    field('blockSkip'),
    field('program'),
    field('language'),
    field('view'),
    field('step'),
    field('encoding'),
  ];
  const [text, solution, fileName, encoding, name] = [
    field('text'),
    field('solution'),
    field('fileName'),
    field('encoding'),
    field('name'),
  ];
  if (
    text === null ||
    shortFields.some((text) => (text?.length ?? 0) > MAX_FIELD_LENGTH) ||
    (fileName === null) !== (encoding === null)
  )
    return undefined;
  if ((name?.length ?? 0) > NAME_LIMIT) return undefined;
  const sentence = field('sentence');
  const task: Task | null = sentence === null && solution === null ? null : { sentence: sentence ?? '', solution };
  if (isAnswer && task === null) return undefined;
  const exercise = parseExercise([field('exercise'), field('exerciseVersion'), field('hints')]);
  const exerciseText = field('exerciseText');
  const isOfExercise = exercise !== null || exerciseText !== null;
  if (exercise === undefined || isOfExercise !== (version === 3) || (isOfExercise && task !== null)) return undefined;
  if (exerciseText !== null && !exerciseText.startsWith('---')) return undefined;
  if ((isAnswer || task?.solution === null) !== (version === 2)) return undefined;
  return {
    text,
    setup: field('setup'),
    control: field('control'),
    blockSkip: field('blockSkip'),
    program: field('program'),
    language: field('language'),
    view: field('view'),
    step: field('step'),
    readonly: isReadonly,
    file: fileName === null || encoding === null ? null : { name: fileName, encoding },
    task: isAnswer ? null : task,
    answerTo: isAnswer ? task : null,
    exercise,
    exerciseText,
    name,
  };
}

/** The id, version and hints of an exercise; null: none is given; undefined: one is invalid. */
function parseExercise(fields: readonly (string | null)[]): AnsweredExercise | null | undefined {
  const [id, version, hints] = fields;
  if (fields.every((field) => field === null)) return null;
  const isValid =
    /^[a-z0-9-]{1,64}$/.test(id ?? '') && /^[0-9a-f]{16}$/.test(version ?? '') && /^\d$/.test(hints ?? '');
  return isValid ? { id: id ?? '', version: version ?? '', hints: Number(hints) } : undefined;
}
