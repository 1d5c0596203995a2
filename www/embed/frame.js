// A page for frames that contains a single element. The address has its program and attributes after `#`, each
// percent-encoded. `program` is the text of the program; the O number to run is in `setup`. Instead, `src` may name a
// program file. With `height=auto` the page reports the height of the element to the page around the frame.
import { GcodePlayground } from './element.js';

/** The playground of this copy's publisher, from `<meta name="playground" content="…">`. */
const named = document.querySelector('meta[name="playground"]')?.content ?? '';
/** Attributes that name a folder of pages. */
const PAGES = ['rules', 'docs', 'manual'];
const isFramed = window.top !== window;

const element = document.createElement('gcode-playground');
document.body.style.margin = '0';
// As high as the frame, whose height is set by the host page, unless it is the height of the contents.
element.style.setProperty('--playground-height', '100vh');
new ResizeObserver(tellHeight).observe(element);

function show() {
  const said = new URLSearchParams(location.hash.slice(1));
  for (const name of GcodePlayground.observedAttributes) {
    const value =
      name === 'program'
        ? null
        : name === 'playground'
          ? playground(said.get(name))
          : PAGES.includes(name)
            ? pages(name, said.get(name))
            : said.get(name);
    if (value === null) element.removeAttribute(name);
    else element.setAttribute(name, value);
  }
  const text = said.get('program');
  // The address takes precedence, even if the user has changed the program.
  if (text !== null || !said.has('src')) element.value = text ?? '';
  document.documentElement.lang = element.language;
}

/**
 * The target of "Open in the playground". Anyone can write an address, so only this host and the host of `named` are
 * allowed.
 */
function playground(said) {
  if (said === '' || (said !== null && isTrusted(said))) return said;
  if (said !== null)
    console.warn(
      `playground=${said} is ignored: it is not on ${location.origin}, and <meta name="playground"> does not name its host.`,
    );
  // Outside a frame this page is the playground.
  return isFramed ? named || null : '';
}

/** The target of links to rule pages and documents, restricted in the same way. */
function pages(name, said) {
  if (said === null || said === '' || isTrusted(said)) return said;
  console.warn(
    `${name}=${said} is ignored: it is not on ${location.origin}, and <meta name="playground"> does not name its host.`,
  );
  return null;
}

function isTrusted(address) {
  try {
    const [{ protocol, origin }, other] = [address, named].map((each) => new URL(each, document.baseURI));
    return /^https?:$/.test(protocol) && (origin === location.origin || origin === other.origin);
  } catch {
    return false;
  }
}

/** Anyone may know the height, so the message is for any origin. */
function tellHeight() {
  if (!isFramed || element.height !== 'auto') return;
  const height = Math.ceil(element.getBoundingClientRect().height);
  window.parent.postMessage({ type: 'gcode-playground:height', height }, '*');
}

/** The verdict contains no text of the learner, so this message is for any origin, too. */
function tellCheck({ detail }) {
  if (isFramed) window.parent.postMessage({ type: 'gcode-playground:checked', ...detail }, '*');
}

element.addEventListener('gcode-checked', tellCheck);
show();
if (!element.hasAttribute('loading')) element.setAttribute('loading', 'eager');
document.body.replaceChildren(element);
addEventListener('hashchange', show);
