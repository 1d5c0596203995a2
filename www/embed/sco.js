// The script of a SCORM 1.2 package: the element of the page shows an exercise, and this script tells the learning
// platform its score and completion, and keeps the learner's program there.
import './element.js';

/** The platform is looked for in at most this many pages around this one, as the standard recommends. */
const MAX_LEVELS = 7;
/** Longest `cmi.suspend_data`, characters (SCORM 1.2, 3.4.7). A longer program is not kept. */
const MAX_KEPT = 4096;
/** Time without a change after which the program is kept, ms. */
const KEEP_AFTER_MS = 3000;

const element = document.querySelector('gcode-playground');
const api = platformAround(window) ?? (window.opener === null ? undefined : platformAround(window.opener));
const startedAt = Date.now();
let keepTimer;

/** The interface of the platform; undefined without one. */
function platformAround(page) {
  try {
    for (let level = 0; level <= MAX_LEVELS; level++) {
      if (page.API !== undefined && page.API !== null) return page.API;
      if (page.parent === page) return undefined;
      page = page.parent;
    }
  } catch {
    // A page of another origin.
  }
  return undefined;
}

function keepProgram() {
  clearTimeout(keepTimer);
  const isTooLong = element.value.length > MAX_KEPT;
  // An older program would replace the learner's work at the next visit.
  api.LMSSetValue('cmi.suspend_data', isTooLong ? '' : element.value);
  if (isTooLong) console.warn(`The platform keeps at most ${MAX_KEPT} characters: this program is not kept.`);
  api.LMSCommit('');
}

function onChecked({ detail: { passed, checks } }) {
  const share = checks.filter((check) => check.passed).length / Math.max(checks.length, 1);
  // All checks may be passed by a part that differs from the wanted one.
  const score = passed ? 100 : Math.min(Math.round(100 * share), 99);
  const wasPassed = api.LMSGetValue('cmi.core.lesson_status') === 'passed';
  // A later attempt never lowers the score.
  const best = Number(api.LMSGetValue('cmi.core.score.raw')) || 0;
  api.LMSSetValue('cmi.core.score.min', '0');
  api.LMSSetValue('cmi.core.score.max', '100');
  api.LMSSetValue('cmi.core.score.raw', String(Math.max(score, best)));
  api.LMSSetValue('cmi.core.lesson_status', passed || wasPassed ? 'passed' : 'incomplete');
  keepProgram();
}

/** A time span as `HHHH:MM:SS`. */
function span(ms) {
  const seconds = Math.floor(ms / 1000);
  const parts = [Math.floor(seconds / 3600), Math.floor(seconds / 60) % 60, seconds % 60];
  return parts.map((part, at) => String(part).padStart(at === 0 ? 4 : 2, '0')).join(':');
}

function finish() {
  keepProgram();
  api.LMSSetValue('cmi.core.session_time', span(Date.now() - startedAt));
  // Otherwise the next visit may start without the kept program.
  api.LMSSetValue('cmi.core.exit', 'suspend');
  api.LMSFinish('');
}

if (api !== undefined) {
  api.LMSInitialize('');
  const kept = api.LMSGetValue('cmi.suspend_data');
  if (kept !== '') element.value = kept;
  if (api.LMSGetValue('cmi.core.lesson_status') === 'not attempted')
    api.LMSSetValue('cmi.core.lesson_status', 'incomplete');
  api.LMSCommit('');
  element.addEventListener('gcode-checked', onChecked);
  element.addEventListener('gcode-change', () => {
    clearTimeout(keepTimer);
    keepTimer = setTimeout(keepProgram, KEEP_AFTER_MS);
  });
  addEventListener('pagehide', finish, { once: true });
  // A page that returns from the cache of the browser has ended its session.
  addEventListener('pageshow', ({ persisted }) => {
    if (persisted) location.reload();
  });
}
