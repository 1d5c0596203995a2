// A page that is one element, for frames: its program and its attributes are in the address, after `#`, each percent-encoded.
// `program` is the text of the program; which O number is run stands in `setup`. The program may also be a file, `src`.
import { GcodePlayground } from './element.js';

/** The page that the author of this copy names, in `<meta name="playground" content="…">`. */
const named = document.querySelector('meta[name="playground"]')?.content ?? '';
/** Attributes that name a folder of pages. */
const PAGES = ['rules', 'docs'];
const isFramed = window.top !== window;

const element = document.createElement('gcode-playground');
document.body.style.margin = '0';
// As high as the frame, which has its height from the page around.
element.style.setProperty('--playground-height', '100vh');

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
  // What stands in the address counts, also after the reader has changed the program.
  if (text !== null || !said.has('src')) element.value = text ?? '';
  document.documentElement.lang = element.language;
}

/** Where "Open in the playground" leads. Anyone can write an address, so it names a page of this host or of the named one, or none. */
function playground(said) {
  if (said === '' || (said !== null && isTrusted(said))) return said;
  if (said !== null)
    console.warn(
      `playground=${said} is ignored: it is not on ${location.origin}, and <meta name="playground"> does not name its host.`,
    );
  // Outside a frame this page is the playground.
  return isFramed ? named || null : '';
}

/** Where links to rule pages and documents lead: to this host or the named one, as `playground`. */
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

show();
if (!element.hasAttribute('loading')) element.setAttribute('loading', 'eager');
document.body.replaceChildren(element);
addEventListener('hashchange', show);
