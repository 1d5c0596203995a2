// One measurement of a peer from npm, used as its documentation shows: `node tests/speed/peers/npm.mjs NAME FILE`. The
// result is kept until the clock has stopped. `rows` are segments, or lines if a peer only parses.
import { readFileSync } from 'node:fs';

const peers = { 'gcode-interpreter': interpreter, 'gcode-parser': parser, 'gcode-preview': preview, 'gcode-toolpath': toolpath, 'gcode-utils': utils, three };

const [name, file] = process.argv.slice(2);
const program = readFileSync(file, 'latin1');
console.warn = () => {};
const read = await peers[name]();
const begun = performance.now();
const { rows, kept } = read(program);
console.log(JSON.stringify({ ms: performance.now() - begun, rows, kept: kept === undefined }));

/** Calls a handler for each G word. */
async function interpreter() {
  const { default: module } = await import('gcode-interpreter');
  const Interpreter = module.default ?? module;
  return (text) => {
    let rows = 0;
    const move = () => void rows++;
    const kept = new Interpreter({ handlers: { G0: move, G1: move, G2: move, G3: move } }).loadFromStringSync(text);
    return { rows, kept };
  };
}

/** Returns the lines and their words. */
async function parser() {
  const { parseStringSync } = await import('gcode-parser');
  return (text) => {
    const kept = parseStringSync(text);
    return { rows: kept.length, kept };
  };
}

/**
 * A viewer of 3D prints. Its parser is not exported separately from its canvas, so the object is created without a
 * canvas.
 */
async function preview() {
  const { WebGLPreview } = await import('gcode-preview');
  return (text) => {
    const view = Object.create(WebGLPreview.prototype);
    const kept = [];
    Object.assign(view, {
      minLayerThreshold: 0.05,
      renderExtrusion: true,
      renderTravel: true,
      startLayer: 0,
      endLayer: Infinity,
      nonTravelmoves: ['g1', 'g01', 'g2', 'g02', 'g3', 'g03'],
      doRenderExtrusion: ({ extrusion, travel }) => kept.push(extrusion, travel),
    });
    view.clear();
    view.state = { x: 0, y: 0, z: 0, r: 0, e: 0, i: 0, j: 0, t: 0 };
    view.parser.parseGCode(text);
    view.layers.forEach((_, index) => view.renderLayer(index));
    return { rows: kept.reduce((sum, numbers) => sum + numbers.length, 0) / 6, kept };
  };
}

/** Calls a callback with the ends of each line and arc. */
async function toolpath() {
  const { default: module } = await import('gcode-toolpath');
  const Toolpath = module.default ?? module;
  return (text) => {
    const kept = [];
    const add = (modal, from, to, center) => kept.push({ motion: modal.motion, from, to, center });
    new Toolpath({ addLine: add, addArcCurve: add }).loadFromStringSync(text);
    return { rows: kept.length, kept };
  };
}

/** Operations; 500 lines per call, because its time grows with the square of the length. */
async function utils() {
  const { GcodeInterpreter } = await import('gcode-utils/dist/bundle.esm.js');
  return (text) => {
    const processor = GcodeInterpreter.createProcessor();
    const [lines, kept] = [text.split('\n'), []];
    for (let line = 0; line < lines.length; line += 500) {
      kept.push(...processor.processGcode(lines.slice(line, line + 500).join('\n')));
    }
    return { rows: kept.filter(({ operation }) => operation !== 'UNKNOWN').length, kept };
  };
}

/** The three.js loader of 3D prints: straight moves only. */
async function three() {
  const { GCodeLoader } = await import('three/examples/jsm/loaders/GCodeLoader.js');
  return (text) => {
    const kept = new GCodeLoader().parse(text);
    return { rows: kept.children.reduce((sum, { geometry }) => sum + geometry.attributes.position.count / 2, 0), kept };
  };
}
