// A page that is one element, for frames: its program and its attributes are in the address, after `#`, each percent-encoded.
// `program` is the text of the program; which O number is run stands in `setup`. The program may also be a file, `src`.
import { GcodePlayground } from './element.js';

const element = document.createElement('gcode-playground');
document.body.style.margin = '0';
// As high as the frame, which has its height from the page around.
element.style.setProperty('--playground-height', '100vh');

function show() {
  const said = new URLSearchParams(location.hash.slice(1));
  for (const name of GcodePlayground.observedAttributes) {
    if (name === 'playground' && !said.has(name)) continue;
    const value = name === 'program' ? null : said.get(name);
    if (value === null) element.removeAttribute(name);
    else element.setAttribute(name, value);
  }
  const text = said.get('program');
  // What stands in the address counts, also after the reader has changed the program.
  if (text !== null || !said.has('src')) element.value = text ?? '';
  document.documentElement.lang = element.language;
}

// In a window of its own it is the playground.
if (window.top === window) element.setAttribute('playground', '');
show();
if (!element.hasAttribute('loading')) element.setAttribute('loading', 'eager');
document.body.replaceChildren(element);
addEventListener('hashchange', show);
