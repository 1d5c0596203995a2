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
import { loaded, whenOnline } from '../dom/network';
import type { GcodePlayground, OpenedProgram } from '../shell/element';
import type { ProgramContext } from '../editor/holder';
import type { ProgramFile } from '../editor/program-text';
import { Actions } from './actions';
import { FIRST_EXAMPLE, loadExample, loadSubjects, type Example, type Subject } from './gallery';
import type { GalleryDialog } from './gallery-dialog';
import type { Fault, InBar, LinkBar } from './link-bar';
import { inAddress, isWorkOn, keepWorkOn, linkedProgram, type LinkedProgram } from './linked';
import type { Offline } from './offline';
import { LANGUAGES, languageOf, type Language } from '../dom/language';
import { COMMON } from '../dom/words';
import { PAGE_WORDS } from './words';
import { Keeping } from './keeping';
import type { PageHost } from './page-host';
import { choices, forgetLast, keepChoices, lastEntry, LONGEST_IN_JOURNAL, LONGEST_KEPT, type Entry, type KeptProgram, type OwnProgram } from './storage';

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
/** How long a change waits to be kept, with all that is typed meanwhile. */
const KEEP_AFTER_MS = 400;
/** How long the reader must pause before a long program is kept: the page would stand still with each key. */
const KEEP_LONG_AFTER_MS = 1500;
/** Where a browser does not say when it has nothing to do. */
const IDLE_AFTER_MS = 1000;

type Above =
  | { readonly kind: 'example' | 'restored' }
  /** The network is missing; what is tried again when it is there. */
  | { readonly kind: 'not-loaded'; readonly again: () => void }
  | { readonly kind: 'kept'; readonly program: OwnProgram }
  /** The reader has changed the program that the address held. */
  | { readonly kind: 'linked'; readonly address: string; readonly linked: LinkedProgram; readonly kept?: OwnProgram };

/** It comes into the page with its first program, so that nothing else is run before. */
const playground = document.createElement('gcode-playground') as GcodePlayground;
playground.loading = 'eager';
// It is the playground.
playground.playground = '';
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
/** The link that was opened last, and the address that holds it. */
let link: { readonly address: string; readonly linked: LinkedProgram } | undefined;
/** Loaded with the first link that has more to say than its program. */
let bar: LinkBar | undefined;
let inBar: InBar | undefined;
/** Which of the reader's own programs this is. */
let ownPrograms: Keeping | undefined;
/** Once the header is there. */
let actions: Actions | undefined;
/** Once the page is settled. */
let offline: Offline | undefined;
/** Counts what was asked to be shown, so that what is loaded can come too late. */
let asked = 0;
let above: Above = { kind: 'example' };
/** What the lines above the program were made of. */
let aboveShown: readonly unknown[] = [];
let keepingSoon: ReturnType<typeof setTimeout> | undefined;
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
  const host: PageHost = {
    playground,
    get language() { return language; },
    get example() { return example; },
    get program() { return programNow(); },
    get keeping() { return keeping; },
    async show(program) {
      const began = await keptExample(program);
      keepNow();
      restore(program, began);
      keepSoon();
    },
  };
  const keeping = new Keeping({
    playground,
    get language() { return language; },
    get program() { return programNow(); },
    titleOf: (id) => shown.get(id)?.title[language],
    show: host.show,
    keepNow,
    openList: () => void import('./own-programs-dialog').then(({ openOwnPrograms }) => openOwnPrograms(host)),
  });
  ownPrograms = keeping;
  actions = new Actions(find('actions'), host);
  showLanguage();
  listen();
  void begin().then(() => {
    if (!playground.isConnected) find('main').append(playground);
  });
}

/** The program of the address, the kept one, the example of the address, or the first one. */
async function begin(): Promise<void> {
  const found = await inAddress(location.hash);
  const entry = lastEntry();
  const kept = entry === undefined ? undefined : { ...entry.program, id: entry.id };
  if (found.kind === 'linked') {
    const { linked } = found;
    const isSame = kept !== undefined && inUnits(kept.text) === inUnits(linked.text);
    // The program of the link, perhaps under another setup, or what the reader has made of its task.
    if (kept !== undefined && kept.example === '' && (isSame || (linked.task !== null && isWorkOn(location.hash)))) {
      restoreLast(kept, undefined, entry);
      playground.origin = OF_A_LINK;
      showAsLinked(linked);
      if (!isSame) showAbove({ kind: 'linked', address: location.hash, linked });
      return;
    }
    loadLinked(linked);
    if (kept !== undefined && kept.text !== linked.text) showAbove({ kind: 'kept', program: kept });
    return;
  }
  await beginWithoutLink(entry, kept);
  if (found.kind === 'fault') showFault(found.fault);
}

/** The kept program, the example of the address, or the first one. */
async function beginWithoutLink(entry: Entry | undefined, kept: OwnProgram | undefined): Promise<void> {
  const named = await loadExample(location.hash.slice(1));
  if (kept !== undefined && (named === undefined || named.id === kept.example)) {
    restoreLast(kept, await keptExample(kept), entry);
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
    showNotLoaded(() => void choose(id));
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

function restoreLast(kept: OwnProgram, began: Example | undefined, entry: Entry | undefined): void {
  restore(kept, began);
  if (ownPrograms !== undefined) ownPrograms.began = entry;
}

/** A program of the reader's own choice is no example. */
function loadLinked(linked: LinkedProgram): void {
  asked++;
  load(undefined);
  const { text, control, setup, blockSkip, program, file } = linked;
  put({ control, setup, blockSkip, program, origin: OF_A_LINK }, { text, file: (file ?? undefined) as ProgramFile | undefined });
  showAsLinked(linked);
  showExamples();
  showAbove({ kind: 'example' });
}

/** Language, view and step of a link, and what it says beside its program. */
function showAsLinked(linked: LinkedProgram): void {
  link = { address: location.hash, linked };
  if (linked.language !== null && languageOf(linked.language) !== language) {
    language = languageOf(linked.language);
    showLanguage();
  }
  const { readonly } = linked;
  playground.setAttribute('view', linked.view ?? 'all');
  playground.readonly = readonly;
  playground.step = linked.step;
  if (linked.task !== null) showInBar({ kind: 'task', linked });
  else if (readonly || playground.view !== 'all') showInBar({ kind: 'only-shown' });
}

/** What a link has said beside its program does not reach the next one. */
function endLinked(): void {
  playground.step = null;
  playground.view = 'all';
  playground.readonly = false;
  showInBar(undefined);
}

function showFault(fault: Fault): void {
  keepNow();
  showInBar({ kind: 'fault', fault });
}

function showInBar(what: InBar | undefined): void {
  inBar = what;
  if (bar !== undefined) return bar.show(what, language);
  if (what === undefined) return;
  void import('./link-bar').then(({ LinkBar }) => {
    bar ??= new LinkBar(find('main'), endLinked);
    bar.show(inBar, language);
  }, () => undefined);
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
  clearTimeout(keepingSoon);
  keepingSoon = undefined;
  endComparisonUnlessOf(chosen);
  endLinked();
  ownPrograms?.takes(undefined);
  example = chosen;
  if (chosen !== undefined) {
    const { id, setup, program: text } = chosen;
    shown.set(id, chosen);
    put({ control: controlOf(setup), setup, origin: id }, { text, file: undefined });
    showExamples();
  }
  showAbove({ kind: 'example' });
}

/** The address is another one; what it replaces is kept, and offered. */
async function followAddress(): Promise<void> {
  const own = ++asked;
  const found = await inAddress(location.hash);
  if (own !== asked) return;
  const from = link;
  if (found.kind === 'fault') return showFault(found.fault);
  if (found.kind === 'linked') {
    keepNow();
    const before = programNow();
    loadLinked(found.linked);
    const untouched = [found.linked.text, from?.linked.text, shown.get(before.example)?.program];
    if (!untouched.includes(before.text)) showAbove({ kind: 'kept', program: before });
    return;
  }
  const id = location.hash.slice(1);
  if (id !== '' && id !== example?.id) void choose(id);
}

/** Another program has taken the place of the one before, or undo has brought it back. */
function followOrigin(): void {
  showControl();
  const now = shown.get(playground.origin ?? '');
  if (now === example) return;
  ownPrograms?.replaced(playground.length > LONGEST_KEPT ? undefined : playground.opened.text);
  example = now;
  endComparisonUnlessOf(now);
  // The address names the example as long as it is one.
  history.replaceState(null, '', now === undefined ? location.pathname + location.search : `#${now.id}`);
  showExamples();
  showAbove({ kind: 'example' });
}

function restore(kept: OwnProgram, began: Example | undefined): void {
  asked++;
  clearTimeout(keepingSoon);
  keepingSoon = undefined;
  endComparisonUnlessOf(began);
  endLinked();
  ownPrograms?.takes(kept.id);
  if (kept.id !== undefined) ownPrograms?.remember(kept.id, kept.text);
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
  window.addEventListener('hashchange', () => void followAddress());
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
  playground.addEventListener('gcode-context', () => {
    ownPrograms?.replaced(playground.length > LONGEST_KEPT ? undefined : playground.opened.text);
    followOrigin();
  });
  // A program that something else has put in has its own context, too.
  playground.addEventListener('gcode-report', followOrigin);
  playground.addEventListener('gcode-switch', keepSoon);
  playground.addEventListener('gcode-setup', () => {
    showControl();
    keepSoon();
  });
  window.addEventListener('pagehide', keepNow);
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') keepNow();
  });
  playground.addEventListener('gcode-settled', () => void ownPrograms?.session().catch(() => undefined), { once: true });
  // Where there is little room it scrolls, by keys as well.
  new ResizeObserver(() => {
    if (intro.scrollHeight > intro.clientHeight) intro.tabIndex = 0;
    else intro.removeAttribute('tabindex');
  }).observe(intro);
  // Nothing of the first picture waits for it.
  playground.addEventListener('gcode-settled', () => void storePage(), { once: true });
}

async function storePage(): Promise<void> {
  await new Promise((idle) => ('requestIdleCallback' in window ? requestIdleCallback(idle) : setTimeout(idle, IDLE_AFTER_MS)));
  const part = await import('./offline').catch(() => undefined);
  offline = part && new part.Offline({
    playground,
    get language() { return language; },
    keep() {
      keepNow();
      return isKept() ? 'kept' : 'not-kept';
    },
  });
}

// ---- keeping --------------------------------------------------------------------------------------

function keepSoon(): void {
  const isLong = playground.length > LONGEST_IN_JOURNAL;
  if (isLong) clearTimeout(keepingSoon);
  else if (keepingSoon !== undefined) return;
  keepingSoon = setTimeout(keepNow, isLong ? KEEP_LONG_AFTER_MS : KEEP_AFTER_MS);
}

/** Keeps what waits to be kept; a program that is the example again needs no keeping. */
function keepNow(): void {
  if (playground.length > LONGEST_KEPT) {
    clearTimeout(keepingSoon);
    keepingSoon = undefined;
    return;
  }
  const text = playground.value;
  if (keepingSoon === undefined && text === known) return;
  clearTimeout(keepingSoon);
  keepingSoon = undefined;
  known = text;
  const { file, setup, blockSkip, program } = playground;
  const asItCame = file === undefined && setup === example?.setup && blockSkip === null && program === null;
  if (asItCame && text === example?.program && controlSelect.value === controlOf(example.setup)) {
    // The list has what it was until now, and has it again where the reader has come back to it.
    if (ownPrograms?.id !== undefined) ownPrograms.keep(programNow());
    forgetLast();
  } else {
    leaveLink(text);
    ownPrograms?.keep(programNow());
  }
}

/** Who opens the page again finds the program as it is. */
function isKept(): boolean {
  const { text } = playground.opened;
  const came = example?.program ?? (link?.address === location.hash ? link.linked.text : undefined);
  return lastEntry()?.program.text === text || (came !== undefined && inUnits(came) === playground.value);
}

/** The program with its context, as it is kept. */
function programNow(): KeptProgram {
  const { file, setup, blockSkip, program } = playground;
  return {
    text: playground.opened.text, example: example?.id ?? '', control: playground.control ?? '', setup: setup ?? '',
    ...(file === undefined ? {} : { file }),
    ...(blockSkip === null ? {} : { blockSkip }),
    ...(program === null ? {} : { program }),
  };
}

/** The address holds the program of a link until the text is another one: who comes back then finds what was kept. */
function leaveLink(text: string): void {
  if (above.kind === 'linked' && inUnits(above.linked.text) === text) {
    history.replaceState(null, '', above.address);
    showAbove({ kind: 'example' });
  }
  const isOfLink = playground.origin === OF_A_LINK && link?.address === location.hash;
  const isWork = isOfLink && link?.linked.task !== null;
  // Who comes back finds the task, and the work on it.
  keepWorkOn(isWork ? link?.address : undefined);
  if (link === undefined || link.address !== location.hash || inUnits(link.linked.text) === text) return;
  const { address, linked } = link;
  if (!isWork) history.replaceState(null, '', location.pathname + location.search);
  if (isOfLink && above.kind !== 'linked') showAbove({ kind: 'linked', address, linked, ...(above.kind === 'kept' ? { kept: above.program } : {}) });
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
  const tooLong = playground.length > LONGEST_KEPT;
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
      keepNow();
      forgetLast();
      load(example ?? FIRST_EXAMPLE);
    }));
  }
  if (what.kind === 'linked') {
    lines.push(offer(texts.linked, texts.asLinked, () => {
      keepNow();
      history.replaceState(null, '', what.address);
      loadLinked(what.linked);
    }));
  }
  const kept = what.kind === 'kept' ? what.program : what.kind === 'linked' ? what.kept : undefined;
  if (kept !== undefined) {
    lines.push(offer(texts.kept, texts.bringBack, () => void keptExample(kept).then((began) => {
      keepNow();
      restore(kept, began);
    })));
  }
  if (what.kind === 'not-loaded') lines.push(offer(texts.exampleNotLoaded, texts.tryAgain, what.again));
  intro.replaceChildren(...lines);
  intro.hidden = lines.length === 0;
}

/** Once the network is back it is tried again, unless the reader has gone on to something else. */
function showNotLoaded(again: () => void): void {
  const said: Above = { kind: 'not-loaded', again };
  const [own, { value }] = [asked, playground];
  showAbove(said);
  whenOnline(() => {
    if (above === said && own === asked && playground.value === value) again();
  });
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
  actions?.showLanguage();
  offline?.showLanguage();
  if (bar !== undefined) bar.language = language;
  ownPrograms?.showLanguage();
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
  const [list, dialog] = await Promise.all([listExamples(), loaded(() => import('./gallery-dialog')).catch(() => undefined)]);
  if (list.length === 0 || dialog === undefined) {
    showNotLoaded(() => void openGallery());
    return;
  }
  if (above.kind === 'not-loaded') showAbove({ kind: 'example' });
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
