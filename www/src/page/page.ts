// The page around the element: which program is shown, and when it is saved.
//
// In: the address (`#example`, or a program, see `linked.ts`), the browser's storage, the menus, the
// examples (`gallery.ts`), of which only the current one is loaded before the first picture. Out: attributes and value
// of the element. Must not know: how the element works, or the content of a setup except for the name of its control.

import '../shell/element';
import './page.css';
import { acceptFiles } from '../dom/drop';
import type { GcodePlayground, OpenedProgram } from '../shell/element';
import type { ProgramContext } from '../editor/text-store';
import type { ProgramFile } from '../editor/program-text';
import { foldLineEnds } from '../files/line-ends';
import { Intro } from './intro';
import { Actions } from './actions';
import { Appearance } from './appearance';
import { ExampleList } from './example-list';
import { find } from './find';
import { FIRST_EXAMPLE, loadExample, type Example, type ExampleFailure } from './gallery';
import type { Fault } from './link-bar';
import { hasWork, parseAddress, parsePlainLink, type AddressContent, type LinkedProgram } from './linked';
import type { Offline } from './offline';
import { OpenedLink } from './opened-link';
import { languageOf, type Language } from '../dom/language';
import { COMMON } from '../dom/words';
import { PAGE_WORDS } from './words';
import { isWorkOn, saveWorkOn, lastWorkOn, findWorkOn, type FoundWork, type Work } from './task-work';
import { ProgramSaver } from './program-saver';
import { saveCheck, type CheckedExercise, type ShownExercise } from './exercise-progress';
import {
  readChoices,
  clearLastEntry,
  saveChoices,
  readLastEntry,
  MAX_JOURNAL_LENGTH,
  MAX_SAVED_LENGTH,
  type Entry,
  type SavedProgram,
  type OwnProgram,
} from './storage';

/** The origin of the program of a link; no example has this id. */
const LINK_ORIGIN = '#program';
/** The hints for a first visit. */
const HINTS = 'play pick';
/** Delay before a change is saved, together with later ones. */
const SAVE_AFTER_MS = 400;
/** How long the user must pause before a long program is saved: saving after each key would block the page. */
const SAVE_LONG_AFTER_MS = 1500;
/** In a narrower window the drawing of a first lesson is fitted to the part: with the whole path the cut would be tiny. */
const MIN_WIDTH_FOR_WHOLE_PATH_PX = 740;
/** The delay in browsers without `requestIdleCallback`. */
const IDLE_AFTER_MS = 1000;

/** Added to the document together with its first program, so that no other program is run before. */
const playground = document.createElement('gcode-playground') as GcodePlayground;
playground.loading = 'eager';
// This page is the playground itself, so the element needs no link to it.
playground.playground = '';

let language: Language = languageOf(
  parsePlainLink(location.hash)?.language ?? readChoices().language ?? navigator.language,
);
let example: Example | undefined;
let exerciseTitle: string | undefined;
/** A part was stored for an example that is compared with it. */
let isComparing = false;
/** The examples of this visit; undo can restore each of them. */
const shownExamples = new Map<string, Example>();
/** Number of requests to show a program, so that a late answer to an earlier one can be dropped. */
let requestCount = 0;
/** Whether the initial address was read. */
let isStarted = false;
/** The link that each program of this tab started from; undo can restore a program of another link. */
const originLinks = new Map<string, string>();
let saveTimer: ReturnType<typeof setTimeout> | undefined;
/** The text as last loaded or saved. */
let savedText = '';
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
  get exerciseTitle() {
    return exerciseTitle;
  },
  get program() {
    return currentProgram();
  },
  get requestCount() {
    return requestCount;
  },
  get saver() {
    return saver;
  },
  saveNow,
  async show(program: OwnProgram): Promise<void> {
    await restoreProgram(program);
    scheduleSave();
  },
  async showNew(program: OwnProgram): Promise<void> {
    await restoreProgram(program);
    intro.show({ kind: 'example' });
    scheduleSave();
  },
  titleOf: (id: string) => shownExamples.get(id)?.title[language],
  openList: () => actions.run('own-programs'),
  openGallery: () => void examples.open(),
  choose: (id: string) => void choose(id),
  onGalleryMissing(retry: (() => void) | undefined): void {
    if (retry !== undefined) intro.showNotLoaded(retry);
    else if (intro.current.kind === 'not-loaded') intro.show({ kind: 'example' });
  },
  resetToExample(): void {
    saveNow();
    clearLastEntry();
    load(example ?? FIRST_EXAMPLE);
  },
  reopenLink(address: string, linked: LinkedProgram): void {
    saveNow();
    history.replaceState(null, '', address);
    loadLinked(linked);
  },
  restoreProgram: (program: OwnProgram) => void restoreProgram(program),
};
const intro = new Intro(host);
const examples = new ExampleList(host);
const appearance = new Appearance(playground, (chosen) => {
  language = chosen;
  saveChoices({ language });
  showLanguage();
});
const link = new OpenedLink(host);
const saver = new ProgramSaver(host);
const actions = new Actions(host);

start();

function start(): void {
  playground.id = 'playground';
  playground.setAttribute('hints', readChoices().hints ?? HINTS);
  const { split } = readChoices();
  if (split !== undefined) playground.setAttribute('split', split);
  // The element has the menus of the page and the title of the program.
  for (const part of ['title', 'program-menu', 'share-menu', 'more-menu']) playground.append(find(part));
  showLanguage();
  addListeners();
  void showInitialProgram().then(() => {
    if (!playground.isConnected) find('main').append(playground);
  });
}

/** Shows the program of a link in the address, the saved one, the example in the address, or the first one. */
async function showInitialProgram(): Promise<void> {
  const { found, work } = await readAddress('journal-first');
  isStarted = true;
  const entry = readLastEntry();
  const saved = entry === undefined ? undefined : { ...entry.program, id: entry.id };
  if (found.kind === 'linked') {
    const { linked } = found;
    if (work.kind === 'work') return showWork(work.work, linked);
    // The same text as in the link, but possibly with a changed setup.
    if (
      saved !== undefined &&
      entry !== undefined &&
      saved.example === '' &&
      foldLineEnds(saved.text) === foldLineEnds(linked.text)
    )
      return showWork({ program: saved, entry }, linked);
    loadLinked(linked);
    if (saved !== undefined && saved.text !== linked.text) intro.show({ kind: 'previous', program: saved });
    offerLater(work);
    return;
  }
  const id = location.hash.slice(1);
  const missing = await showWithoutLink(id, entry, saved);
  if (found.kind === 'fault') showFault(found.fault);
  else if (missing !== undefined && id !== '' && location.hash.slice(1) === id) showMissing(missing, id);
}

/** Reads the address and finds the user's work on its task; starts again if the address changes meanwhile. */
async function readAddress(
  last: 'journal-first' | 'from-list',
): Promise<{ readonly found: AddressContent; readonly work: FoundWork }> {
  for (;;) {
    const { hash } = location;
    const found = await parseAddress(hash);
    let work: FoundWork = { kind: 'none' };
    if (found.kind === 'linked' && hasWork(found.linked)) {
      const fromJournal = last === 'journal-first' ? lastWorkOn(hash) : undefined;
      work = fromJournal === undefined ? await findWorkOn(hash) : { kind: 'work', work: fromJournal };
    }
    if (location.hash === hash) return { found, work };
  }
}

/**
 * Shows the saved program, the example in the address, or the first one. Returns why the example in the address is not
 * shown.
 */
async function showWithoutLink(
  id: string,
  entry: Entry | undefined,
  saved: OwnProgram | undefined,
): Promise<ExampleFailure | undefined> {
  const loaded = await loadExample(id);
  const addressExample = typeof loaded === 'string' ? undefined : loaded;
  if (saved !== undefined && (addressExample === undefined || addressExample.id === saved.example)) {
    restore(saved, await loadStartExample(saved));
    saver.startEntry = entry;
  } else {
    if ((await showComparedPart(addressExample, ++requestCount)) === 'late') return undefined;
    load(addressExample ?? FIRST_EXAMPLE);
    if (saved !== undefined) intro.show({ kind: 'previous', program: saved });
  }
  return typeof loaded === 'string' ? loaded : undefined;
}

/** Reports an example that does not exist or could not be loaded; the program stays. */
function showMissing(reason: ExampleFailure, id: string): void {
  if (reason === 'unknown') showFault({ kind: 'unknown' });
  else intro.showNotLoaded(() => void choose(id));
}

/** The example that a saved program started from. */
async function loadStartExample(saved: SavedProgram): Promise<Example | undefined> {
  if (saved.example === '') return undefined;
  const startExample = await loadExample(saved.example);
  return typeof startExample === 'string' ? FIRST_EXAMPLE : startExample;
}

/** Loads an example that the user has selected, unless another one was requested since. */
async function choose(id: string): Promise<void> {
  const request = ++requestCount;
  const chosen = await loadExample(id);
  if (request !== requestCount) return;
  if (typeof chosen === 'string') {
    examples.show();
    return showMissing(chosen, id);
  }
  saveNow();
  if ((await showComparedPart(chosen, request)) === 'late') return;
  load(chosen);
  history.replaceState(null, '', `#${chosen.id}`);
}

/**
 * Runs the program that an example is compared with, and stores its part; `late` if another program was requested
 * since.
 */
async function showComparedPart(chosen: Example | undefined, request: number): Promise<'in-time' | 'late'> {
  const other = chosen?.compareWith === undefined ? undefined : await loadExample(chosen.compareWith);
  if (request !== requestCount) return 'late';
  if (other === undefined || typeof other === 'string') return 'in-time';
  load(other);
  if (!playground.isConnected) find('main').append(playground);
  await playground.settled;
  if (request !== requestCount) return 'late';
  playground.keepPart();
  isComparing = true;
  return 'in-time';
}

/** The program of a link has no example. */
function loadLinked(linked: LinkedProgram): void {
  requestCount++;
  load(undefined);
  const { text, control, setup, blockSkip, program, file } = linked;
  setProgram(
    { control, setup, blockSkip, program, origin: LINK_ORIGIN },
    { text, file: (file ?? undefined) as ProgramFile | undefined },
  );
  showAsLinked(linked);
  intro.show({ kind: 'example' });
}

/** Shows the user's version of the program of the link in the address. */
function showWork({ program, entry, revision }: Work, linked: LinkedProgram): void {
  const { id, text } = program;
  restore(program, undefined, LINK_ORIGIN);
  if (entry !== undefined) saver.startEntry = entry;
  if (revision !== undefined) saver.knownRevisions.set(id, revision);
  originLinks.set(id, location.hash);
  showAsLinked(linked);
  if (foldLineEnds(text) !== foldLineEnds(linked.text)) intro.show({ kind: 'linked', address: location.hash, linked });
}

/** Restores a program and saves the current one; if it is the work on the task in the address, it is shown as such. */
async function restoreProgram(program: OwnProgram): Promise<void> {
  const startExample = await loadStartExample(program);
  saveNow();
  const open = link.current;
  const { id } = program;
  if (id !== undefined && open !== undefined && hasWork(open.linked) && isWorkOn(open.address, id))
    showWork({ program: { ...program, id } }, open.linked);
  else restore(program, startExample);
}

/**
 * Offers the user's work on the task once it is found, unless the user has opened something else. Until then the
 * original task is shown.
 */
function offerLater(work: FoundWork): void {
  if (work.kind !== 'late') return;
  const request = requestCount;
  void work.pending.then((found) => {
    if (found !== undefined && request === requestCount) intro.offer(found.program);
  });
}

/** Applies the language, view and step of a link, and shows its bar. */
function showAsLinked(linked: LinkedProgram): void {
  if (linked.language !== null && languageOf(linked.language) !== language) {
    language = languageOf(linked.language);
    showLanguage();
  }
  exerciseTitle = undefined;
  link.opened(linked);
  examples.show();
}

function showFault(fault: Fault): void {
  saveNow();
  link.showFault(fault);
}

/** Puts a program with its context into the element; by default the switches follow the setup. */
function setProgram(
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
  savedText = playground.value;
}

/** For a first lesson: names what the picture shows, and shows the tool at the start point. */
function showLabels(of: Example | undefined): void {
  const hasLabels = of?.labels === true;
  playground.toggleAttribute('labels', hasLabels);
  playground.fit = hasLabels && innerWidth >= MIN_WIDTH_FOR_WHOLE_PATH_PX ? 'path' : null;
}

function endComparisonUnlessFor(chosen: Example | undefined): void {
  if (!isComparing || chosen?.compareWith !== undefined) return;
  isComparing = false;
  playground.endComparison();
}

function load(chosen: Example | undefined): void {
  cancelSave();
  endComparisonUnlessFor(chosen);
  link.end();
  saver.setId(undefined);
  example = chosen;
  showLabels(chosen);
  if (chosen !== undefined) {
    const { id, setup, program: text } = chosen;
    shownExamples.set(id, chosen);
    setProgram({ control: controlOf(setup), setup, origin: id }, { text, file: undefined });
    examples.show();
  }
  intro.show({ kind: 'example' });
}

/** The address has changed: shows its program; the current one is saved and offered for restoring. */
async function onAddressChanged(): Promise<void> {
  // `showInitialProgram` reads the initial address.
  if (!isStarted) return;
  const request = ++requestCount;
  saveNow('keep-address');
  const { found, work } = await readAddress('from-list');
  if (request !== requestCount) return;
  const from = link.last;
  if (found.kind === 'fault') return showFault(found.fault);
  if (found.kind === 'linked') {
    const { linked } = found;
    saveNow('keep-address');
    const { id } = saver;
    const before: OwnProgram = { ...currentProgram(), ...(id === undefined ? {} : { id }) };
    const originals = [linked.text, from?.linked.text, shownExamples.get(before.example)?.program];
    const offered = originals.includes(before.text) ? undefined : before;
    if (work.kind === 'work') {
      // The text in the editor is newer.
      const isCurrent = work.work.program.id === id;
      showWork(isCurrent ? { program: { ...before, id } } : work.work, linked);
      if (!isCurrent && offered !== undefined) intro.offer(offered);
      return;
    }
    loadLinked(linked);
    if (offered !== undefined) intro.show({ kind: 'previous', program: offered });
    offerLater(work);
    return;
  }
  const id = location.hash.slice(1);
  if (id !== '' && id !== example?.id) void choose(id);
}

/** Another program has replaced the current one, or undo has restored it. */
function onOriginChanged(): void {
  const now = shownExamples.get(playground.origin ?? '');
  if (now === example) return;
  saver.onTextReplaced(playground.length > MAX_SAVED_LENGTH ? undefined : playground.opened.text);
  example = now;
  showLabels(now);
  endComparisonUnlessFor(now);
  // The address names the example while one is shown.
  history.replaceState(null, '', now === undefined ? location.pathname + location.search : `#${now.id}`);
  examples.show();
  intro.show({ kind: 'example' });
}

function restore(
  saved: OwnProgram,
  startExample: Example | undefined,
  origin: string | null = startExample?.id ?? null,
): void {
  requestCount++;
  cancelSave();
  endComparisonUnlessFor(startExample);
  link.end();
  saver.setId(saved.id);
  if (saved.id !== undefined) saver.remember(saved.id, saved.text);
  example = startExample;
  showLabels(startExample);
  if (startExample !== undefined) shownExamples.set(startExample.id, startExample);
  const { text, file, setup, blockSkip = null, program = null } = saved;
  // A file that was saved before setups were saved is not an example.
  const defaultSetup = file === undefined ? (example?.setup ?? null) : null;
  setProgram(
    {
      control: saved.control === '' ? null : saved.control,
      setup: setup === undefined ? defaultSetup : setup === '' ? null : setup,
      origin,
      blockSkip,
      program,
    },
    { text, file: file as ProgramFile | undefined },
  );
  examples.show();
  intro.show({ kind: 'restored' });
}

function addListeners(): void {
  window.addEventListener('hashchange', () => void onAddressChanged());
  playground.addEventListener('gcode-split', (event) =>
    saveChoices({ split: (event as CustomEvent<{ readonly split: string }>).detail.split }),
  );
  document.addEventListener('keydown', (event) => {
    if (event.key.toLowerCase() !== 'k' || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
    event.preventDefault();
    void import('./palette').then(
      ({ openPalette }) => openPalette(playground.commands, language),
      () => undefined,
    );
  });
  // The element handles what is dropped on it; elsewhere the browser would leave the page.
  acceptFiles(
    document.documentElement,
    {
      hint: () => COMMON[language].dropHere,
      onDrop: (file) => void playground.openFile(file),
    },
    'unhandled',
  );
  playground.addEventListener('gcode-change', () => {
    // The description of the example is removed when a file is opened.
    intro.refresh();
    examples.show();
    scheduleSave();
  });
  playground.addEventListener('gcode-hint', (event) => {
    saveChoices({ hints: (event as CustomEvent<{ readonly left: string }>).detail.left });
  });
  playground.addEventListener('gcode-context', () => {
    saver.onTextReplaced(playground.length > MAX_SAVED_LENGTH ? undefined : playground.opened.text);
    onOriginChanged();
  });
  // A program put in by a script has its own context, too.
  playground.addEventListener('gcode-report', onOriginChanged);
  playground.addEventListener('gcode-exercise', (event) => {
    const { title, program } = (event as CustomEvent<ShownExercise>).detail;
    exerciseTitle = title;
    examples.show();
    // The learner has not changed it.
    if (link.begins(program)) {
      cancelSave();
      savedText = program;
    }
    link.exerciseShown();
  });
  playground.addEventListener('gcode-checked', (event) => {
    const { detail } = event as CustomEvent<CheckedExercise>;
    // The check of an answer that a learner has handed in is not the reader's own progress.
    if ((link.current?.linked.exercise ?? null) === null) saveCheck(detail);
    link.checked(detail);
  });
  playground.addEventListener('gcode-switch', scheduleSave);
  playground.addEventListener('gcode-setup', scheduleSave);
  window.addEventListener('pagehide', () => saveNow());
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') saveNow();
  });
  playground.addEventListener('gcode-settled', () => void saver.session().catch(() => undefined), { once: true });
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
      save() {
        saveNow();
        return isSaved() ? 'saved' : 'not-saved';
      },
    });
}

// ---- saving ---------------------------------------------------------------------------------------

/** Cancels a pending save. */
function cancelSave(): void {
  clearTimeout(saveTimer);
  saveTimer = undefined;
  saver.isLongPending = false;
}

function scheduleSave(): void {
  const isLong = playground.length > MAX_JOURNAL_LENGTH;
  saver.isLongPending = isLong;
  if (isLong) clearTimeout(saveTimer);
  else if (saveTimer !== undefined) return;
  saveTimer = setTimeout(() => saveNow(), isLong ? SAVE_LONG_AFTER_MS : SAVE_AFTER_MS);
}

/** Saves pending changes; an unchanged example is not saved. */
function saveNow(address: 'update-address' | 'keep-address' = 'update-address'): void {
  if (playground.length > MAX_SAVED_LENGTH) return cancelSave();
  const text = playground.value;
  if (saveTimer === undefined && text === savedText) return;
  cancelSave();
  savedText = text;
  const { file, setup, blockSkip, program } = playground;
  const isUnchanged = file === undefined && setup === example?.setup && blockSkip === null && program === null;
  if (isUnchanged && text === example?.program && currentControl() === controlOf(example.setup)) {
    // Update the saved program in the list, if the user has returned to the unchanged example.
    if (saver.id !== undefined) saver.save(currentProgram());
    clearLastEntry();
  } else {
    if (address === 'update-address') removeLinkFromAddress(text);
    saver.save(currentProgram());
    saveAsWork();
  }
}

/** Whether the current program is found again when the page is reopened. */
function isSaved(): boolean {
  const { text } = playground.opened;
  const original = example?.program ?? link.current?.linked.text;
  return (
    readLastEntry()?.program.text === text || (original !== undefined && foldLineEnds(original) === playground.value)
  );
}

/** The current program with its context, to be saved. */
function currentProgram(): SavedProgram {
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
function removeLinkFromAddress(text: string): void {
  const before = intro.current;
  if (before.kind === 'linked' && foldLineEnds(before.linked.text) === text) {
    // The address may already have changed to another one that is about to be shown.
    if (location.hash === '') history.replaceState(null, '', before.address);
    intro.show({ kind: 'example' });
  }
  const open = link.current;
  if (open === undefined || foldLineEnds(open.linked.text) === text) return;
  const isOfLink = isFromLink();
  // The link of a task stays in the address: a later visit finds the task and the work on it.
  if (!isOfLink || !hasWork(open.linked)) history.replaceState(null, '', location.pathname + location.search);
  const { current } = intro;
  if (isOfLink && current.kind !== 'linked')
    intro.show({ kind: 'linked', ...open, ...(current.kind === 'previous' ? { previous: current.program } : {}) });
}

/** Whether the program is that of the link in the address, or an answer to its exercise, also a pasted one. */
function isFromLink(): boolean {
  return playground.origin === LINK_ORIGIN || link.current?.linked.exerciseToDo !== undefined;
}

/** Records the program as the work on the task it started from. */
function saveAsWork(): void {
  const { id } = saver;
  const { last } = link;
  if (id === undefined || last === undefined || !isFromLink()) return;
  const originLink = originLinks.get(id) ?? last.address;
  originLinks.set(id, originLink);
  if (hasWork(last.linked) && originLink === last.address) saveWorkOn(originLink, id);
}

// ---- showing --------------------------------------------------------------------------------------

function showLanguage(): void {
  const texts = PAGE_WORDS[language];
  document.documentElement.lang = language;
  find('page-title').textContent = texts.title;
  playground.language = language;
  appearance.showLanguage(language);
  actions.showLanguage();
  offline?.showLanguage();
  link.showLanguage();
  saver.showLanguage();
  examples.show();
  intro.refresh();
}

/** The control that runs the program: that of the program's context, or that of the setup. */
function currentControl(): string {
  return playground.control ?? controlOf(playground.setup ?? '{}');
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
