// The measurements in the page: `measure.mjs` calls `measure(address of the program)`. Uses the public wasm interface
// only.
import init, { Drawn, Playground } from '../../../www/pkg/gcode_playground.js';
import { PART_FILES } from '../../../www/pkg/part-files.js';
import { loadPart } from '../../../www/pkg/parts.js';
import { median, time } from '../stopwatch.mjs';

const SIZE = { width: 1200, height: 800 };
/** Segments per path of the plain painter. */
const PER_PATH = 1000;
const FRAMES = 7;

/** Interprets and draws a program. Returns milliseconds by name. */
window.measure = async (address) => {
  const [text, wasm] = await Promise.all([fetch(address).then((response) => response.text()), init()]);
  for (const [part, files] of Object.entries(PART_FILES)) await loadPart(part, wasm, files);
  const fresh = interpreted(text);
  const settled = median(Array.from({ length: 5 }, () => {
    const again = interpreted(text);
    again.playground.free();
    return again.ms;
  }));
  const { playground } = fresh;
  const own = ownPainter(playground);
  const plain = plainPainter(playground);
  return { fresh: fresh.ms, settled, ...own, ...plain };
};

function interpreted(text) {
  const playground = new Playground();
  const ms = time(() => {
    const { written } = new TextEncoder().encodeInto(text, playground.textBuffer(text.length));
    playground.setTextFromBuffer(written);
    while (!playground.advance(1_000_000));
  });
  return { playground, ms };
}

/** Paints the whole picture in slices. Measures the total and the longest time that the page is blocked. */
function ownPainter(playground) {
  const canvas = new OffscreenCanvas(SIZE.width, SIZE.height);
  const measured = time(() => playground.fit('section'));
  playground.attachCanvas('section', canvas);
  playground.resize('section', SIZE.width, SIZE.height, 1);
  playground.fit('section');
  const whole = [];
  const slices = [];
  for (let frame = 0; frame < FRAMES; frame++) {
    playground.zoom('section', frame % 2 ? 1.01 : 1 / 1.01, SIZE.width / 2, SIZE.height / 2);
    let sum = 0;
    for (let more = true; more; ) {
      const slice = time(() => {
        more = playground.draw('section') !== Drawn.All;
        flush(canvas);
      });
      slices.push(slice);
      sum += slice;
    }
    whole.push(sum);
  }
  return { measured, picture: median(whole), slice: Math.max(...slices.slice(slices.length / FRAMES)) };
}

/** The same strokes as batches of Path2D, as written by hand: nothing is skipped or looked up. */
function plainPainter(playground) {
  const canvas = new OffscreenCanvas(SIZE.width, SIZE.height);
  const context = canvas.getContext('2d');
  const [origin, unit] = [playground.screenOf('section', 0, 0), playground.screenOf('section', 2, 1)];
  const [perZ, perX] = [unit[0] - origin[0], unit[1] - origin[1]];
  const paths = [];
  const building = time(() => {
    let [path, count] = [new Path2D(), 0];
    for (let index = 0; index < playground.chunkCount(); index++) {
      const { x, z } = playground.chunk(index);
      for (let at = 0; at < x.length; at++) {
        const [right, down] = [origin[0] + z[at] * perZ, origin[1] + x[at] * perX];
        path.lineTo(right, down);
        if (++count % PER_PATH === 0) {
          paths.push(path);
          path = new Path2D();
          path.moveTo(right, down);
        }
      }
    }
    paths.push(path);
  });
  const frames = Array.from({ length: FRAMES }, () => time(() => {
    context.clearRect(0, 0, SIZE.width, SIZE.height);
    for (const path of paths) context.stroke(path);
    flush(canvas);
  }));
  return { building, plain: median(frames) };
}

/** Waits until drawing has finished. */
function flush(canvas) {
  canvas.getContext('2d').getImageData(0, 0, 1, 1);
}
