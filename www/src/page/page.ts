// The page around the element: header, gallery, the reader's choices, and what is kept between visits.
//
// In: the address (`#example`, or a program, see `linked.ts`), the browser's store, the header's controls, the
// examples (`gallery.ts`), of which only the one that is shown is loaded before the first picture.
// Out: attributes and the value of the element; the sentence above the program. Must not know: how the
// element works inside, or what a setup holds beyond the name of its control.

import '../shell/element';
import './page.css';
import { icon, make, name } from '../dom/dom';
import { acceptFiles } from '../dom/drop';
import type { GcodePlayground, OpenedProgram } from '../shell/element';
import type { ProgramContext } from '../editor/holder';
import type { ProgramFile } from '../editor/program-text';
import { FIRST_EXAMPLE, loadExample, loadSubjects, type Example, type Subject } from './gallery';
import type { GalleryDialog } from './gallery-dialog';
import { linkedProgram, type LinkedProgram } from './linked';
import { LANGUAGES, languageOf, type Language } from '../dom/language';
import { COMMON } from '../dom/words';
import { PAGE_WORDS } from './words';
import { choices, forgetProgram, keepChoices, keepProgram, keptProgram, type KeptProgram } from './storage';

const CONTROLS = [
  ['fanuc', 'FANUC'],
  ['gsk', 'GSK'],
  ['forum', 'Forum'],
] as const;
/** Whose the program of a link is; no example is called so. */
const OF_A_LINK = '#program';
const THEMES = ['auto', 'light', 'dark'] as const;
/** Percent of the size that the browser is set to. */
const TEXT_SIZES = ['87.5', '100', '125', '150', '200'] as const;
/** For who is here for the first time. */
const HINTS = 'edit play pick';
/** How long the reader must pause before the program is kept. */
const KEEP_AFTER_MS = 400;
/** Browsers keep about five million units for a page; a longer program would only make it stand still. */
const KEPT_LENGTH = 2_000_000;

type Above =
  | { readonly kind: 'example' | 'restored' | 'not-loaded' }
  | { readonly kind: 'kept'; readonly program: KeptProgram }
  /** The reader has changed the program that the address held. */
  | { readonly kind: 'linked'; readonly address: string; readonly linked: LinkedProgram };

/** It comes into the page with its first program, so that nothing else is run before. */
const playground = document.createElement('gcode-playground') as GcodePlayground;
playground.loading = 'eager';
const intro = find('intro');
const exampleSelect = find<HTMLSelectElement>('example');
const galleryButton = find<HTMLButtonElement>('gallery');
const controlSelect = find<HTMLSelectElement>('control');
const languageSelect = find<HTMLSelectElement>('language');
const themeSelect = find<HTMLSelectElement>('theme');
const textSizeSelect = find<HTMLSelectElement>('text-size');
const openButton = find<HTMLButtonElement>('open');
const saveButton = find<HTMLButtonElement>('save');
const fileInput = find<HTMLInputElement>('file');
const settingsToggle = find<HTMLButtonElement>('settings-toggle');
const settings = find('settings');

let language: Language = languageOf(linkedProgram(location.hash)?.language ?? choices().language ?? navigator.language);
let example: Example | undefined;
/** The list of examples in the language of the page, once it is there. */
let subjects: readonly Subject[] = [];
/** A part was kept for an example that is compared with it. */
let isComparing = false;
/** The examples that were shown: undo can bring each of them back. */
const shown = new Map<string, Example>();
let gallery: GalleryDialog | undefined;
/** Counts what was asked to be shown, so that what is loaded can come too late. */
let asked = 0;
let above: Above = { kind: 'example' };
/** What the lines above the program were made of. */
let aboveShown: readonly unknown[] = [];
let keeping: ReturnType<typeof setTimeout> | undefined;
/** The text as it was last loaded or kept. */
let known = '';

start();

function start(): void {
  const theme = THEMES.find((known) => known === choices().theme) ?? 'auto';
  galleryButton.append(icon('gallery'));
  for (const [value, text] of CONTROLS) controlSelect.append(make('option', { value }, text));
  for (const tag of LANGUAGES) languageSelect.append(make('option', { value: tag, lang: tag }, PAGE_WORDS[tag].languageName));
  for (const value of THEMES) themeSelect.append(make('option', { value }));
  for (const value of TEXT_SIZES) textSizeSelect.append(make('option', { value }, `${value} %`));
  playground.id = 'playground';
  playground.append(intro);
  playground.setAttribute('hints', choices().hints ?? HINTS);
  const { split, textSize } = choices();
  if (split !== undefined) playground.setAttribute('split', split);
  showTextSize(TEXT_SIZES.find((known) => known === textSize) ?? '100');
  showTheme(theme);
  showLanguage();
  listen();
  void begin().then(() => {
    if (!playground.isConnected) find('main').append(playground);
  });
}

/** The program of the address, the kept one, the example of the address, or the first one. */
async function begin(): Promise<void> {
  const linked = linkedProgram(location.hash);
  if (linked !== undefined) {
    const kept = keptProgram();
    // The program of the link, perhaps under another setup.
    if (kept !== undefined && kept.example === '' && inUnits(kept.text) === inUnits(linked.text)) {
      restore(kept, undefined);
      playground.origin = OF_A_LINK;
      return;
    }
    loadLinked(linked);
    if (kept !== undefined && kept.text !== linked.text) showAbove({ kind: 'kept', program: kept });
    return;
  }
  const named = await loadExample(location.hash.slice(1));
  const kept = keptProgram();
  if (kept !== undefined && (named === undefined || named.id === kept.example)) {
    restore(kept, await keptExample(kept));
    return;
  }
  if ((await layUnder(named, ++asked)) === 'late') return;
  load(named ?? FIRST_EXAMPLE);
  if (kept !== undefined) showAbove({ kind: 'kept', program: kept });
}

/** The example a kept program began as. */
async function keptExample(kept: KeptProgram): Promise<Example | undefined> {
  return kept.example === '' ? undefined : ((await loadExample(kept.example)) ?? FIRST_EXAMPLE);
}

/** Loads the example the reader has asked for, unless another one has been asked for since. */
async function choose(id: string): Promise<void> {
  const own = ++asked;
  const chosen = await loadExample(id);
  if (own !== asked) return;
  if (chosen === undefined) {
    showExamples();
    showAbove({ kind: 'not-loaded' });
    return;
  }
  keepNow();
  if ((await layUnder(chosen, own)) === 'late') return;
  load(chosen);
  history.replaceState(null, '', `#${chosen.id}`);
}

/** Runs the program whose part an example is compared with, and keeps that part; something else may have been asked for since. */
async function layUnder(chosen: Example | undefined, own: number): Promise<'in-time' | 'late'> {
  const other = chosen?.compareWith === undefined ? undefined : await loadExample(chosen.compareWith);
  if (own !== asked) return 'late';
  if (other === undefined) return 'in-time';
  load(other);
  if (!playground.isConnected) find('main').append(playground);
  await playground.settled;
  if (own !== asked) return 'late';
  playground.keepPart();
  isComparing = true;
  return 'in-time';
}

/** A program of the reader's own choice is no example. */
function loadLinked({ text, setup }: LinkedProgram): void {
  asked++;
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

function endComparisonUnlessOf(chosen: Example | undefined): void {
  if (!isComparing || chosen?.compareWith !== undefined) return;
  isComparing = false;
  playground.endComparison();
}

function load(chosen: Example | undefined): void {
  clearTimeout(keeping);
  keeping = undefined;
  endComparisonUnlessOf(chosen);
  example = chosen;
  if (chosen !== undefined) {
    const { id, setup, program: text } = chosen;
    shown.set(id, chosen);
    put({ control: controlOf(setup), setup, origin: id }, { text, file: undefined });
    showExamples();
  }
  showAbove({ kind: 'example' });
}

/** Another program has taken the place of the one before, or undo has brought it back. */
function followOrigin(): void {
  showControl();
  const now = shown.get(playground.origin ?? '');
  if (now === example) return;
  example = now;
  endComparisonUnlessOf(now);
  // The address names the example as long as it is one.
  history.replaceState(null, '', now === undefined ? location.pathname + location.search : `#${now.id}`);
  showExamples();
  showAbove({ kind: 'example' });
}

function restore(kept: KeptProgram, began: Example | undefined): void {
  asked++;
  clearTimeout(keeping);
  keeping = undefined;
  endComparisonUnlessOf(began);
  example = began;
  if (began !== undefined) shown.set(began.id, began);
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
  exampleSelect.addEventListener('change', () => void choose(exampleSelect.value));
  galleryButton.addEventListener('click', () => void openGallery());
  // The list of examples comes after the first picture, or when somebody looks for it.
  for (const [target, event] of [[playground, 'gcode-settled'], [exampleSelect, 'pointerdown'], [exampleSelect, 'focus']] as const) {
    target.addEventListener(event, listExamples, { once: true });
  }
  window.addEventListener('hashchange', () => {
    const linked = linkedProgram(location.hash);
    if (linked !== undefined) {
      keepNow();
      loadLinked(linked);
      return;
    }
    const id = location.hash.slice(1);
    if (id !== '' && id !== example?.id) void choose(id);
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
  textSizeSelect.addEventListener('change', () => {
    keepChoices({ textSize: textSizeSelect.value });
    showTextSize(textSizeSelect.value);
  });
  playground.addEventListener('gcode-split', (event) => keepChoices({ split: (event as CustomEvent<{ readonly split: string }>).detail.split }));
  // The element takes what is dropped on it; beside it the browser would leave the page.
  acceptFiles(document.documentElement, {
    hint: () => COMMON[language].dropHere,
    dropped: (file) => void playground.openFile(file),
  }, 'left-over');
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
  playground.addEventListener('gcode-hint', (event) => {
    keepChoices({ hints: (event as CustomEvent<{ readonly left: string }>).detail.left });
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
    if (example.added !== undefined) lines.push(make('p', { className: 'added' }, texts.added(example.added)));
  }
  if (tooLong) lines.push(make('p', { className: 'kept' }, texts.tooLongToKeep));
  if (what.kind === 'restored') {
    lines.push(offer(texts.restored, texts.startAfresh, () => {
      forgetProgram();
      load(example ?? FIRST_EXAMPLE);
    }));
  }
  if (what.kind === 'linked') {
    lines.push(offer(texts.linked, texts.asLinked, () => {
      history.replaceState(null, '', what.address);
      loadLinked(what.linked);
    }));
  }
  if (what.kind === 'kept') {
    lines.push(offer(texts.kept, texts.bringBack, () => void keptExample(what.program).then((began) => restore(what.program, began))));
  }
  if (what.kind === 'not-loaded') lines.push(make('p', { className: 'kept' }, texts.exampleNotLoaded));
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
  name(galleryButton, texts.gallery);
  label(controlSelect, texts.control);
  label(languageSelect, texts.language);
  label(themeSelect, texts.theme);
  label(textSizeSelect, texts.textSize);
  for (const option of themeSelect.options) option.textContent = texts.themes[option.value as (typeof THEMES)[number]];
  openButton.textContent = texts.openFile;
  saveButton.textContent = texts.saveFile;
  settingsToggle.textContent = texts.settings;
  if (subjects.length > 0) void listExamples();
  showExamples();
  showAbove(above);
}

/** The list, once it is there; until then the one that is shown. */
function showExamples(): void {
  const options = subjects.map(({ subject, examples }) => {
    const group = make('optgroup', { label: subject });
    group.append(...examples.map(({ id, title }) => make('option', { value: id }, title)));
    return group;
  });
  const listed = subjects.some(({ examples }) => examples.some(({ id }) => id === example?.id));
  const alone = example === undefined
    ? make('option', { value: '', hidden: true }, PAGE_WORDS[language].ownProgram)
    : make('option', { value: example.id, hidden: subjects.length > 0 }, example.title[language]);
  exampleSelect.replaceChildren(...(listed ? [] : [alone]), ...options);
  exampleSelect.value = example?.id ?? '';
}

/** Loads the list in the language of the page; the reader can go on without it. */
async function listExamples(): Promise<readonly Subject[]> {
  const tag = language;
  try {
    const list = await loadSubjects(tag);
    if (tag === language && subjects !== list) {
      subjects = list;
      showExamples();
    }
    return list;
  } catch {
    return [];
  }
}

async function openGallery(): Promise<void> {
  const [list, dialog] = await Promise.all([listExamples(), import('./gallery-dialog').catch(() => undefined)]);
  if (list.length === 0 || dialog === undefined) {
    showAbove({ kind: 'not-loaded' });
    return;
  }
  if (gallery === undefined) {
    gallery = new dialog.GalleryDialog((id) => void choose(id));
    document.body.append(gallery.element);
  }
  gallery.open(list, language, example?.id ?? '');
}

function showTheme(theme: string): void {
  themeSelect.value = theme;
  document.documentElement.dataset['theme'] = theme;
  playground.theme = theme;
}

/** All of the page is measured by it, the drawing's words included. */
function showTextSize(percent: string): void {
  textSizeSelect.value = percent;
  document.documentElement.style.fontSize = percent === '100' ? '' : `${percent}%`;
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
