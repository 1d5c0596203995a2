// The page around the element: header, gallery, the reader's choices, and what is kept between visits.
//
// In: the address (`#example`, or a program, see `linked.ts`), the browser's store, the header's controls.
// Out: attributes and the value of the element; the sentence above the program. Must not know: how the
// element works inside, or what a setup holds beyond the name of its control.

import '../shell/element';
import './page.css';
import { make } from '../dom/dom';
import type { GcodePlayground, OpenedProgram } from '../shell/element';
import type { ProgramContext } from '../editor/holder';
import type { ProgramFile } from '../editor/program-text';
import { exampleOf, examples, type Example } from './gallery';
import { linkedProgram, type LinkedProgram } from './linked';
import { LANGUAGES, languageOf, type Language } from '../dom/language';
import { PAGE_WORDS } from './words';
import { choices, forgetProgram, keepChoices, keepProgram, keptProgram, type KeptProgram } from './storage';

const FIRST_EXAMPLE = 's000-o0002';
const CONTROLS = [
  ['fanuc', 'FANUC'],
  ['gsk', 'GSK'],
  ['forum', 'Forum'],
] as const;
/** Whose the program of a link is; no example is called so. */
const OF_A_LINK = '#program';
const THEMES = ['auto', 'light', 'dark'] as const;
/** How long the reader must pause before the program is kept. */
const KEEP_AFTER_MS = 400;
/** Browsers keep about five million units for a page; a longer program would only make it stand still. */
const KEPT_LENGTH = 2_000_000;

type Above =
  | { readonly kind: 'example' }
  | { readonly kind: 'restored' }
  | { readonly kind: 'kept'; readonly program: KeptProgram }
  /** The reader has changed the program that the address held. */
  | { readonly kind: 'linked'; readonly address: string; readonly linked: LinkedProgram };

const playground = find<GcodePlayground>('playground');
const intro = find('intro');
const exampleSelect = find<HTMLSelectElement>('example');
const controlSelect = find<HTMLSelectElement>('control');
const languageSelect = find<HTMLSelectElement>('language');
const themeSelect = find<HTMLSelectElement>('theme');
const openButton = find<HTMLButtonElement>('open');
const saveButton = find<HTMLButtonElement>('save');
const fileInput = find<HTMLInputElement>('file');
const settingsToggle = find<HTMLButtonElement>('settings-toggle');
const settings = find('settings');

let language: Language = languageOf(linkedProgram(location.hash)?.language ?? choices().language ?? navigator.language);
let example: Example | undefined;
let above: Above = { kind: 'example' };
/** What the lines above the program were made of. */
let aboveShown: readonly unknown[] = [];
let keeping: ReturnType<typeof setTimeout> | undefined;
/** The text as it was last loaded or kept. */
let known = '';

start();

function start(): void {
  const theme = THEMES.find((known) => known === choices().theme) ?? 'auto';
  for (const [value, text] of CONTROLS) controlSelect.append(make('option', { value }, text));
  for (const tag of LANGUAGES) languageSelect.append(make('option', { value: tag, lang: tag }, PAGE_WORDS[tag].languageName));
  for (const value of THEMES) themeSelect.append(make('option', { value }));
  showTheme(theme);
  showLanguage();
  listen();
  begin();
}

/** The program of the address, the kept one, the example of the address, or the first one. */
function begin(): void {
  const linked = linkedProgram(location.hash);
  if (linked !== undefined) {
    const kept = keptProgram();
    // The program of the link, perhaps under another setup.
    if (kept !== undefined && kept.example === '' && inUnits(kept.text) === inUnits(linked.text)) {
      restore(kept);
      playground.origin = OF_A_LINK;
      return;
    }
    loadLinked(linked);
    if (kept !== undefined && kept.text !== linked.text) showAbove({ kind: 'kept', program: kept });
    return;
  }
  const asked = exampleOf(location.hash.slice(1));
  const kept = keptProgram();
  if (kept !== undefined && (asked === undefined || asked.id === kept.example)) {
    restore(kept);
    return;
  }
  load(asked ?? exampleOf(FIRST_EXAMPLE) ?? examples[0]);
  if (kept !== undefined) showAbove({ kind: 'kept', program: kept });
}

/** A program of the reader's own choice is no example. */
function loadLinked({ text, setup }: LinkedProgram): void {
  load(undefined);
  put({ control: controlOf(setup ?? '{}'), setup, origin: OF_A_LINK }, { text, file: undefined });
  showExamples();
  showAbove({ kind: 'example' });
}

/** A program with its context; the switches are as the setup has them. */
function put(
  { control, setup, origin, blockSkip = null, program = null }: Partial<ProgramContext> & Pick<ProgramContext, 'control' | 'setup' | 'origin'>,
  opened: OpenedProgram,
): void {
  playground.origin = origin;
  playground.setup = setup;
  playground.blockSkip = blockSkip;
  playground.program = program;
  playground.control = control;
  playground.opened = opened;
  known = playground.value;
  showControl();
}

function load(chosen: Example | undefined): void {
  clearTimeout(keeping);
  keeping = undefined;
  example = chosen;
  if (chosen !== undefined) {
    const { id, setup, program: text } = chosen;
    put({ control: controlOf(setup), setup, origin: id }, { text, file: undefined });
    showExamples();
  }
  showAbove({ kind: 'example' });
}

/** Another program has taken the place of the one before, or undo has brought it back. */
function followOrigin(): void {
  showControl();
  const now = exampleOf(playground.origin ?? undefined);
  if (now === example) return;
  example = now;
  // The address names the example as long as it is one.
  history.replaceState(null, '', now === undefined ? location.pathname + location.search : `#${now.id}`);
  showExamples();
  showAbove({ kind: 'example' });
}

function restore(kept: KeptProgram): void {
  clearTimeout(keeping);
  keeping = undefined;
  example = kept.example === '' ? undefined : (exampleOf(kept.example) ?? exampleOf(FIRST_EXAMPLE) ?? examples[0]);
  const { text, file, setup, blockSkip = null, program = null } = kept;
  // A file that was kept before setups were is no example.
  const unsaid = file === undefined ? (example?.setup ?? null) : null;
  put({
    control: kept.control === '' ? null : kept.control,
    setup: setup === undefined ? unsaid : setup === '' ? null : setup,
    origin: example?.id ?? null, blockSkip, program,
  }, { text, file: file as ProgramFile | undefined });
  showExamples();
  showAbove({ kind: 'restored' });
}

function listen(): void {
  exampleSelect.addEventListener('change', () => {
    const chosen = exampleOf(exampleSelect.value);
    keepNow();
    load(chosen);
    if (chosen !== undefined) history.replaceState(null, '', `#${chosen.id}`);
  });
  window.addEventListener('hashchange', () => {
    const linked = linkedProgram(location.hash);
    if (linked !== undefined) {
      keepNow();
      loadLinked(linked);
      return;
    }
    const asked = exampleOf(location.hash.slice(1));
    if (asked === undefined || asked === example) return;
    keepNow();
    load(asked);
  });
  controlSelect.addEventListener('change', () => {
    playground.control = controlSelect.value;
    keepSoon();
  });
  languageSelect.addEventListener('change', () => {
    language = languageOf(languageSelect.value);
    keepChoices({ language });
    showLanguage();
  });
  themeSelect.addEventListener('change', () => {
    keepChoices({ theme: themeSelect.value });
    showTheme(themeSelect.value);
  });
  openButton.addEventListener('click', () => fileInput.click());
  saveButton.addEventListener('click', () => playground.saveFile());
  fileInput.addEventListener('change', () => {
    const file = fileInput.files?.[0];
    if (file !== undefined) void playground.openFile(file);
    fileInput.value = '';
  });
  settingsToggle.addEventListener('click', () => {
    const open = settings.classList.toggle('open');
    settingsToggle.setAttribute('aria-expanded', String(open));
  });
  playground.addEventListener('gcode-change', () => {
    // What is said of the example is not said of the reader's own file.
    showAbove(above);
    keepSoon();
  });
  playground.addEventListener('gcode-context', followOrigin);
  // A program that something else has put in has its own context, too.
  playground.addEventListener('gcode-report', followOrigin);
  playground.addEventListener('gcode-switch', keepSoon);
  playground.addEventListener('gcode-setup', () => {
    showControl();
    keepSoon();
  });
  window.addEventListener('pagehide', keepNow);
}

// ---- keeping --------------------------------------------------------------------------------------

function keepSoon(): void {
  clearTimeout(keeping);
  keeping = setTimeout(keepNow, KEEP_AFTER_MS);
}

/** Keeps what waits to be kept; a program that is the example again needs no keeping. */
function keepNow(): void {
  if (playground.length > KEPT_LENGTH) {
    clearTimeout(keeping);
    keeping = undefined;
    forgetProgram();
    return;
  }
  const text = playground.value;
  if (keeping === undefined && text === known) return;
  clearTimeout(keeping);
  keeping = undefined;
  known = text;
  const id = example?.id ?? '';
  const { file, setup, blockSkip, program } = playground;
  const asItCame = file === undefined && setup === example?.setup && blockSkip === null && program === null;
  if (asItCame && text === example?.program && controlSelect.value === controlOf(example.setup)) forgetProgram();
  else {
    leaveLink(text);
    keepProgram({
      text: playground.opened.text, example: id, control: playground.control ?? '', setup: setup ?? '',
      ...(file === undefined ? {} : { file }),
      ...(blockSkip === null ? {} : { blockSkip }),
      ...(program === null ? {} : { program }),
    });
  }
}

/** The address holds the program of a link until the text is another one: who comes back then finds what was kept. */
function leaveLink(text: string): void {
  if (above.kind === 'linked' && inUnits(above.linked.text) === text) {
    history.replaceState(null, '', above.address);
    showAbove({ kind: 'example' });
  }
  const linked = linkedProgram(location.hash);
  if (linked === undefined || inUnits(linked.text) === text) return;
  const address = location.hash;
  history.replaceState(null, '', location.pathname + location.search);
  if (playground.origin === OF_A_LINK) showAbove({ kind: 'linked', address, linked });
}

/** As the editor has it: each line end counts one. */
function inUnits(text: string): string {
  return text.replace(/\r\n?/g, '\n');
}

// ---- showing --------------------------------------------------------------------------------------

function showAbove(what: Above): void {
  above = what;
  const texts = PAGE_WORDS[language];
  const lines: HTMLElement[] = [];
  const own = playground.file !== undefined;
  const tooLong = playground.length > KEPT_LENGTH;
  // This follows each key, and all of the page would be laid out again.
  const shown = [what, language, example, own, tooLong];
  if (shown.every((one, i) => one === aboveShown[i])) return;
  aboveShown = shown;
  if (example !== undefined && !own) {
    lines.push(make('h2', {}, example.title[language]), make('p', {}, example.shows[language]));
  }
  if (tooLong) lines.push(make('p', { className: 'kept' }, texts.tooLongToKeep));
  if (what.kind === 'example' && !own) lines.push(make('p', { className: 'hint' }, texts.hint));
  if (what.kind === 'restored') {
    lines.push(offer(texts.restored, texts.startAfresh, () => {
      forgetProgram();
      load(example ?? exampleOf(FIRST_EXAMPLE) ?? examples[0]);
    }));
  }
  if (what.kind === 'linked') {
    lines.push(offer(texts.linked, texts.asLinked, () => {
      history.replaceState(null, '', what.address);
      loadLinked(what.linked);
    }));
  }
  if (what.kind === 'kept') lines.push(offer(texts.kept, texts.bringBack, () => restore(what.program)));
  intro.replaceChildren(...lines);
  intro.hidden = lines.length === 0;
}

function offer(news: string, action: string, accepted: () => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'link' }, action);
  button.addEventListener('click', accepted);
  return make('p', { className: 'kept' }, `${news} · `, button);
}

function showLanguage(): void {
  const texts = PAGE_WORDS[language];
  document.documentElement.lang = language;
  document.title = texts.title;
  find('title').textContent = texts.title;
  playground.language = language;
  languageSelect.value = language;
  label(exampleSelect, texts.example);
  label(controlSelect, texts.control);
  label(languageSelect, texts.language);
  label(themeSelect, texts.theme);
  for (const option of themeSelect.options) option.textContent = texts.themes[option.value as (typeof THEMES)[number]];
  openButton.textContent = texts.openFile;
  saveButton.textContent = texts.saveFile;
  settingsToggle.textContent = texts.settings;
  showExamples();
  showAbove(above);
}

function showExamples(): void {
  const own = make('option', { value: '', hidden: true }, PAGE_WORDS[language].ownProgram);
  exampleSelect.replaceChildren(
    ...(example === undefined ? [own] : []),
    ...examples.map(({ id, title: titles }) => make('option', { value: id }, titles[language])),
  );
  exampleSelect.value = example?.id ?? '';
}

function showTheme(theme: string): void {
  themeSelect.value = theme;
  document.documentElement.dataset['theme'] = theme;
  playground.theme = theme;
}

/** Which control the program is run on; the setup decides where the reader has chosen none. */
function showControl(): void {
  controlSelect.value = playground.control ?? controlOf(playground.setup ?? '{}');
}

function label(select: HTMLSelectElement, text: string): void {
  const caption = select.previousElementSibling;
  if (caption !== null) caption.textContent = text;
}

function controlOf(setup: string): string {
  try {
    const parsed = Object(JSON.parse(setup)) as { readonly dialect?: { readonly control?: string } };
    return parsed.dialect?.control ?? 'fanuc';
  } catch {
    // The interpreter says what is wrong with the setup of an address.
    return 'fanuc';
  }
}

function find<E extends HTMLElement = HTMLElement>(id: string): E {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no #${id}`);
  return element as E;
}
