// The page around the element: which program is shown, and when it is saved.
//
// In: the address (`#example`, or a program, see `linked.ts`), the browser's storage, the controls of the header, the
// examples (`gallery.ts`), of which only the current one is loaded before the first picture. Out: attributes and value
// of the element. Must not know: how the element works, or the content of a setup except for the name of its control.

import '../shell/element';
import './page.css';
import { make } from '../dom/dom';
import { acceptFiles } from '../dom/drop';
import type { GcodePlayground, OpenedProgram } from '../shell/element';
import type { ProgramContext } from '../editor/holder';
import type { ProgramFile } from '../editor/program-text';
import { folded } from '../files/line-ends';
import { AboveProgram } from './above';
import { Actions } from './actions';
import { Appearance } from './appearance';
import { ExampleList } from './example-list';
import { find, label } from './find';
import { FIRST_EXAMPLE, loadExample, type Example, type NoExample } from './gallery';
import type { Fault } from './link-bar';
import { inAddress, linkedProgram, type InAddress, type LinkedProgram } from './linked';
import type { Offline } from './offline';
import { OpenedLink } from './opened-link';
import { LANGUAGES, languageOf, type Language } from '../dom/language';
import { COMMON } from '../dom/words';
import { PAGE_WORDS } from './words';
import { isWorkOn, keepWorkOn, lastWorkOn, workOn, type FoundWork, type Work } from './task-work';
import { Keeping } from './keeping';
import {
  choices,
  forgetLast,
  keepChoices,
  lastEntry,
  LONGEST_IN_JOURNAL,
  LONGEST_KEPT,
  type Entry,
  type KeptProgram,
  type OwnProgram,
} from './storage';

const CONTROLS = [
  ['fanuc', 'FANUC'],
  ['gsk', 'GSK'],
  ['forum', 'Forum'],
] as const;
/** The origin of the program of a link; no example has this id. */
const OF_A_LINK = '#program';
/** The hints for a first visit. */
const HINTS = 'edit play pick';
/** Delay before a change is saved, together with later ones. */
const KEEP_AFTER_MS = 400;
/** How long the user must pause before a long program is saved: saving after each key would block the page. */
const KEEP_LONG_AFTER_MS = 1500;
/** The delay in browsers without `requestIdleCallback`. */
const IDLE_AFTER_MS = 1000;

/** Added to the document together with its first program, so that no other program is run before. */
const playground = document.createElement('gcode-playground') as GcodePlayground;
playground.loading = 'eager';
// This page is the playground itself, so the element needs no link to it.
playground.playground = '';
const controlSelect = find<HTMLSelectElement>('control');
const languageSelect = find<HTMLSelectElement>('language');
const openButton = find<HTMLButtonElement>('open');
const saveButton = find<HTMLButtonElement>('save');
const fileInput = find<HTMLInputElement>('file');
const settingsToggle = find<HTMLButtonElement>('settings-toggle');
const settings = find('settings');

let language: Language = languageOf(linkedProgram(location.hash)?.language ?? choices().language ?? navigator.language);
let example: Example | undefined;
/** A part was stored for an example that is compared with it. */
let isComparing = false;
/** The examples of this visit; undo can restore each of them. */
const shown = new Map<string, Example>();
/** Number of requests to show a program, so that a late answer to an earlier one can be dropped. */
let asked = 0;
/** Whether the initial address was read. */
let begun = false;
/** The link that each program of this tab started from; undo can restore a program of another link. */
const beganAs = new Map<string, string>();
let keepingSoon: ReturnType<typeof setTimeout> | undefined;
/** The text as last loaded or saved. */
let known = '';
/** Loaded once the page is settled. */
let offline: Offline | undefined;

/** What the page provides to its parts. */
const host = {
  playground,
  get language() {
    return language;
  },
  get example() {
    return example;
  },
  get program() {
    return programNow();
  },
  get asked() {
    return asked;
  },
  get keeping() {
    return ownPrograms;
  },
  keepNow,
  async show(program: OwnProgram): Promise<void> {
    await bringBack(program);
    keepSoon();
  },
  titleOf: (id: string) => shown.get(id)?.title[language],
  openList: () => actions.act('own-programs'),
  choose: (id: string) => void choose(id),
  missing(again: (() => void) | undefined): void {
    if (again !== undefined) above.showNotLoaded(again);
    else if (above.now.kind === 'not-loaded') above.show({ kind: 'example' });
  },
  startAfresh(): void {
    keepNow();
    forgetLast();
    load(example ?? FIRST_EXAMPLE);
  },
  openAgain(address: string, linked: LinkedProgram): void {
    keepNow();
    history.replaceState(null, '', address);
    loadLinked(linked);
  },
  bringBack: (program: OwnProgram) => void bringBack(program),
};
const above = new AboveProgram(host);
const examples = new ExampleList(host);
const appearance = new Appearance(playground);
const link = new OpenedLink(host);
const ownPrograms = new Keeping(host);
const actions = new Actions(find('actions'), host);

start();

function start(): void {
  for (const [value, text] of CONTROLS) controlSelect.append(make('option', { value }, text));
  for (const tag of LANGUAGES)
    languageSelect.append(make('option', { value: tag, lang: tag }, PAGE_WORDS[tag].languageName));
  playground.id = 'playground';
  playground.setAttribute('hints', choices().hints ?? HINTS);
  const { split } = choices();
  if (split !== undefined) playground.setAttribute('split', split);
  showLanguage();
  listen();
  void begin().then(() => {
    if (!playground.isConnected) find('main').append(playground);
  });
}

/** Shows the program of a link in the address, the saved one, the example in the address, or the first one. */
async function begin(): Promise<void> {
  const { found, work } = await lookUp('last-at-once');
  begun = true;
  const entry = lastEntry();
  const kept = entry === undefined ? undefined : { ...entry.program, id: entry.id };
  if (found.kind === 'linked') {
    const { linked } = found;
    if (work.kind === 'work') return showWork(work.work, linked);
    // The same text as in the link, but possibly with a changed setup.
    if (kept !== undefined && entry !== undefined && kept.example === '' && folded(kept.text) === folded(linked.text))
      return showWork({ program: kept, entry }, linked);
    loadLinked(linked);
    if (kept !== undefined && kept.text !== linked.text) above.show({ kind: 'kept', program: kept });
    offerLater(work);
    return;
  }
  const id = location.hash.slice(1);
  const missing = await beginWithoutLink(id, entry, kept);
  if (found.kind === 'fault') showFault(found.fault);
  else if (missing !== undefined && id !== '' && location.hash.slice(1) === id) showMissing(missing, id);
}

/** Reads the address and finds the user's work on its task; starts again if the address changes meanwhile. */
async function lookUp(
  last: 'last-at-once' | 'as-listed',
): Promise<{ readonly found: InAddress; readonly work: FoundWork }> {
  for (;;) {
    const { hash } = location;
    const found = await inAddress(hash);
    let work: FoundWork = { kind: 'none' };
    if (found.kind === 'linked' && found.linked.task !== null) {
      const atOnce = last === 'last-at-once' ? lastWorkOn(hash) : undefined;
      work = atOnce === undefined ? await workOn(hash) : { kind: 'work', work: atOnce };
    }
    if (location.hash === hash) return { found, work };
  }
}

/**
 * Shows the saved program, the example in the address, or the first one. Returns why the example in the address is not
 * shown.
 */
async function beginWithoutLink(
  id: string,
  entry: Entry | undefined,
  kept: OwnProgram | undefined,
): Promise<NoExample | undefined> {
  const loaded = await loadExample(id);
  const named = typeof loaded === 'string' ? undefined : loaded;
  if (kept !== undefined && (named === undefined || named.id === kept.example)) {
    restore(kept, await keptExample(kept));
    ownPrograms.began = entry;
  } else {
    if ((await layUnder(named, ++asked)) === 'late') return undefined;
    load(named ?? FIRST_EXAMPLE);
    if (kept !== undefined) above.show({ kind: 'kept', program: kept });
  }
  return typeof loaded === 'string' ? loaded : undefined;
}

/** Reports an example that does not exist or could not be loaded; the program stays. */
function showMissing(reason: NoExample, id: string): void {
  if (reason === 'unknown') showFault({ kind: 'unknown' });
  else above.showNotLoaded(() => void choose(id));
}

/** The example that a saved program started from. */
async function keptExample(kept: KeptProgram): Promise<Example | undefined> {
  if (kept.example === '') return undefined;
  const began = await loadExample(kept.example);
  return typeof began === 'string' ? FIRST_EXAMPLE : began;
}

/** Loads an example that the user has selected, unless another one was requested since. */
async function choose(id: string): Promise<void> {
  const own = ++asked;
  const chosen = await loadExample(id);
  if (own !== asked) return;
  if (typeof chosen === 'string') {
    examples.show();
    return showMissing(chosen, id);
  }
  keepNow();
  if ((await layUnder(chosen, own)) === 'late') return;
  load(chosen);
  history.replaceState(null, '', `#${chosen.id}`);
}

/**
 * Runs the program that an example is compared with, and stores its part; `late` if another program was requested
 * since.
 */
async function layUnder(chosen: Example | undefined, own: number): Promise<'in-time' | 'late'> {
  const other = chosen?.compareWith === undefined ? undefined : await loadExample(chosen.compareWith);
  if (own !== asked) return 'late';
  if (other === undefined || typeof other === 'string') return 'in-time';
  load(other);
  if (!playground.isConnected) find('main').append(playground);
  await playground.settled;
  if (own !== asked) return 'late';
  playground.keepPart();
  isComparing = true;
  return 'in-time';
}

/** The program of a link has no example. */
function loadLinked(linked: LinkedProgram): void {
  asked++;
  load(undefined);
  const { text, control, setup, blockSkip, program, file } = linked;
  put(
    { control, setup, blockSkip, program, origin: OF_A_LINK },
    { text, file: (file ?? undefined) as ProgramFile | undefined },
  );
  showAsLinked(linked);
  examples.show();
  above.show({ kind: 'example' });
}

/** Shows the user's version of the program of the link in the address. */
function showWork({ program, entry, revision }: Work, linked: LinkedProgram): void {
  const { id, text } = program;
  restore(program, undefined, OF_A_LINK);
  if (entry !== undefined) ownPrograms.began = entry;
  if (revision !== undefined) ownPrograms.known.set(id, revision);
  beganAs.set(id, location.hash);
  showAsLinked(linked);
  if (folded(text) !== folded(linked.text)) above.show({ kind: 'linked', address: location.hash, linked });
}

/** Restores a program and saves the current one; if it is the work on the task in the address, it is shown as such. */
async function bringBack(program: OwnProgram): Promise<void> {
  const began = await keptExample(program);
  keepNow();
  const open = link.inAddress;
  const { id } = program;
  if (id !== undefined && open !== undefined && open.linked.task !== null && isWorkOn(open.address, id))
    showWork({ program: { ...program, id } }, open.linked);
  else restore(program, began);
}

/**
 * Offers the user's work on the task once it is found, unless the user has opened something else. Until then the
 * original task is shown.
 */
function offerLater(work: FoundWork): void {
  if (work.kind !== 'late') return;
  const own = asked;
  void work.coming.then((found) => {
    if (found !== undefined && own === asked) above.offer(found.program);
  });
}

/** Applies the language, view and step of a link, and shows its bar. */
function showAsLinked(linked: LinkedProgram): void {
  if (linked.language !== null && languageOf(linked.language) !== language) {
    language = languageOf(linked.language);
    showLanguage();
  }
  link.opened(linked);
}

function showFault(fault: Fault): void {
  keepNow();
  link.showFault(fault);
}

/** Puts a program with its context into the element; by default the switches follow the setup. */
function put(
  {
    control,
    setup,
    origin,
    blockSkip = null,
    program = null,
  }: Partial<ProgramContext> & Pick<ProgramContext, 'control' | 'setup' | 'origin'>,
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
  waitNoLonger();
  endComparisonUnlessOf(chosen);
  link.end();
  ownPrograms.takes(undefined);
  example = chosen;
  if (chosen !== undefined) {
    const { id, setup, program: text } = chosen;
    shown.set(id, chosen);
    put({ control: controlOf(setup), setup, origin: id }, { text, file: undefined });
    examples.show();
  }
  above.show({ kind: 'example' });
}

/** The address has changed: shows its program; the current one is saved and offered for restoring. */
async function followAddress(): Promise<void> {
  // `begin` reads the initial address.
  if (!begun) return;
  const own = ++asked;
  keepNow('address-stays');
  const { found, work } = await lookUp('as-listed');
  if (own !== asked) return;
  const from = link.last;
  if (found.kind === 'fault') return showFault(found.fault);
  if (found.kind === 'linked') {
    const { linked } = found;
    keepNow('address-stays');
    const { id } = ownPrograms;
    const before: OwnProgram = { ...programNow(), ...(id === undefined ? {} : { id }) };
    const untouched = [linked.text, from?.linked.text, shown.get(before.example)?.program];
    const offered = untouched.includes(before.text) ? undefined : before;
    if (work.kind === 'work') {
      // The text in the editor is newer.
      const isHere = work.work.program.id === id;
      showWork(isHere ? { program: { ...before, id } } : work.work, linked);
      if (!isHere && offered !== undefined) above.offer(offered);
      return;
    }
    loadLinked(linked);
    if (offered !== undefined) above.show({ kind: 'kept', program: offered });
    offerLater(work);
    return;
  }
  const id = location.hash.slice(1);
  if (id !== '' && id !== example?.id) void choose(id);
}

/** Another program has replaced the current one, or undo has restored it. */
function followOrigin(): void {
  showControl();
  const now = shown.get(playground.origin ?? '');
  if (now === example) return;
  ownPrograms.replaced(playground.length > LONGEST_KEPT ? undefined : playground.opened.text);
  example = now;
  endComparisonUnlessOf(now);
  // The address names the example while one is shown.
  history.replaceState(null, '', now === undefined ? location.pathname + location.search : `#${now.id}`);
  examples.show();
  above.show({ kind: 'example' });
}

function restore(kept: OwnProgram, began: Example | undefined, origin: string | null = began?.id ?? null): void {
  asked++;
  waitNoLonger();
  endComparisonUnlessOf(began);
  link.end();
  ownPrograms.takes(kept.id);
  if (kept.id !== undefined) ownPrograms.remember(kept.id, kept.text);
  example = began;
  if (began !== undefined) shown.set(began.id, began);
  const { text, file, setup, blockSkip = null, program = null } = kept;
  // A file that was saved before setups were saved is not an example.
  const unsaid = file === undefined ? (example?.setup ?? null) : null;
  put(
    {
      control: kept.control === '' ? null : kept.control,
      setup: setup === undefined ? unsaid : setup === '' ? null : setup,
      origin,
      blockSkip,
      program,
    },
    { text, file: file as ProgramFile | undefined },
  );
  examples.show();
  above.show({ kind: 'restored' });
}

function listen(): void {
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
  playground.addEventListener('gcode-split', (event) =>
    keepChoices({ split: (event as CustomEvent<{ readonly split: string }>).detail.split }),
  );
  // The element handles what is dropped on it; elsewhere the browser would leave the page.
  acceptFiles(
    document.documentElement,
    {
      hint: () => COMMON[language].dropHere,
      dropped: (file) => void playground.openFile(file),
    },
    'left-over',
  );
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
    // The description of the example is removed when a file is opened.
    above.showAgain();
    keepSoon();
  });
  playground.addEventListener('gcode-hint', (event) => {
    keepChoices({ hints: (event as CustomEvent<{ readonly left: string }>).detail.left });
  });
  playground.addEventListener('gcode-context', () => {
    ownPrograms.replaced(playground.length > LONGEST_KEPT ? undefined : playground.opened.text);
    followOrigin();
  });
  // A program put in by a script has its own context, too.
  playground.addEventListener('gcode-report', followOrigin);
  playground.addEventListener('gcode-switch', keepSoon);
  playground.addEventListener('gcode-setup', () => {
    showControl();
    keepSoon();
  });
  window.addEventListener('pagehide', () => keepNow());
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') keepNow();
  });
  playground.addEventListener('gcode-settled', () => void ownPrograms.session().catch(() => undefined), { once: true });
  // After the first picture, so as not to delay it.
  playground.addEventListener('gcode-settled', () => void storePage(), { once: true });
}

async function storePage(): Promise<void> {
  await new Promise((idle) =>
    'requestIdleCallback' in window ? requestIdleCallback(idle) : setTimeout(idle, IDLE_AFTER_MS),
  );
  const part = await import('./offline').catch(() => undefined);
  offline =
    part &&
    new part.Offline({
      playground,
      get language() {
        return language;
      },
      keep() {
        keepNow();
        return isKept() ? 'kept' : 'not-kept';
      },
    });
}

// ---- keeping --------------------------------------------------------------------------------------

/** Cancels a pending save. */
function waitNoLonger(): void {
  clearTimeout(keepingSoon);
  keepingSoon = undefined;
  ownPrograms.longComes = false;
}

function keepSoon(): void {
  const isLong = playground.length > LONGEST_IN_JOURNAL;
  ownPrograms.longComes = isLong;
  if (isLong) clearTimeout(keepingSoon);
  else if (keepingSoon !== undefined) return;
  keepingSoon = setTimeout(() => keepNow(), isLong ? KEEP_LONG_AFTER_MS : KEEP_AFTER_MS);
}

/** Saves pending changes; an unchanged example is not saved. */
function keepNow(address: 'follows' | 'address-stays' = 'follows'): void {
  if (playground.length > LONGEST_KEPT) return waitNoLonger();
  const text = playground.value;
  if (keepingSoon === undefined && text === known) return;
  waitNoLonger();
  known = text;
  const { file, setup, blockSkip, program } = playground;
  const asItCame = file === undefined && setup === example?.setup && blockSkip === null && program === null;
  if (asItCame && text === example?.program && controlSelect.value === controlOf(example.setup)) {
    // Update the saved program in the list, if the user has returned to the unchanged example.
    if (ownPrograms.id !== undefined) ownPrograms.keep(programNow());
    forgetLast();
  } else {
    if (address === 'follows') leaveLink(text);
    ownPrograms.keep(programNow());
    keepAsWork();
  }
}

/** Whether the current program is found again when the page is reopened. */
function isKept(): boolean {
  const { text } = playground.opened;
  const came = example?.program ?? link.inAddress?.linked.text;
  return lastEntry()?.program.text === text || (came !== undefined && folded(came) === playground.value);
}

/** The current program with its context, to be saved. */
function programNow(): KeptProgram {
  const { file, setup, blockSkip, program } = playground;
  return {
    text: playground.opened.text,
    example: example?.id ?? '',
    control: playground.control ?? '',
    setup: setup ?? '',
    ...(file === undefined ? {} : { file }),
    ...(blockSkip === null ? {} : { blockSkip }),
    ...(program === null ? {} : { program }),
  };
}

/** Removes the link from the address once the text differs from it, so that a later visit shows the saved program. */
function leaveLink(text: string): void {
  const before = above.now;
  if (before.kind === 'linked' && folded(before.linked.text) === text) {
    // The address may already have changed to another one that is about to be shown.
    if (location.hash === '') history.replaceState(null, '', before.address);
    above.show({ kind: 'example' });
  }
  const open = link.inAddress;
  if (open === undefined || folded(open.linked.text) === text) return;
  const isOfLink = playground.origin === OF_A_LINK;
  // The link of a task stays in the address: a later visit finds the task and the work on it.
  if (!isOfLink || open.linked.task === null) history.replaceState(null, '', location.pathname + location.search);
  const { now } = above;
  if (isOfLink && now.kind !== 'linked')
    above.show({ kind: 'linked', ...open, ...(now.kind === 'kept' ? { kept: now.program } : {}) });
}

/** Records the program as the work on the task it started from. */
function keepAsWork(): void {
  const { id } = ownPrograms;
  const { last } = link;
  if (id === undefined || last === undefined || playground.origin !== OF_A_LINK) return;
  const began = beganAs.get(id) ?? last.address;
  beganAs.set(id, began);
  if (last.linked.task !== null && began === last.address) keepWorkOn(began, id);
}

// ---- showing --------------------------------------------------------------------------------------

function showLanguage(): void {
  const texts = PAGE_WORDS[language];
  document.documentElement.lang = language;
  find('title').textContent = texts.title;
  playground.language = language;
  languageSelect.value = language;
  label(controlSelect, texts.control);
  label(languageSelect, texts.language);
  appearance.showLanguage(language);
  openButton.textContent = texts.openFile;
  saveButton.textContent = texts.saveFile;
  settingsToggle.textContent = texts.settings;
  actions.showLanguage();
  offline?.showLanguage();
  link.showLanguage();
  ownPrograms.showLanguage();
  examples.showLanguage();
  above.showAgain();
}

/** Selects the control that runs the program: the user's choice, or that of the setup. */
function showControl(): void {
  controlSelect.value = playground.control ?? controlOf(playground.setup ?? '{}');
}

function controlOf(setup: string): string {
  try {
    const parsed = Object(JSON.parse(setup)) as { readonly dialect?: { readonly control?: string } };
    return parsed.dialect?.control ?? 'fanuc';
  } catch {
    // The interpreter reports a faulty setup.
    return 'fanuc';
  }
}
