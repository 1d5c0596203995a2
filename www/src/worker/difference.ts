// The worker's half of comparing the program with another version.
//
// In: the `Playground` and the other text. Out: the differences, and a drawing of both. The other version runs in a
// temporary interpreter within time limits, so that the page never waits long. Must not know: how the differences are
// shown.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { Differed, OtherVersion } from '../protocol/protocol';

/** A program that takes longer is compared as far as it has run; a message reports that. */
const RUN_LIMIT_MS = 4_000;
const MACHINE_LIMIT_MS = 3_000;
const BLOCKS = 20_000;
const MOTIONS = 100;

export function difference(core: Playground, { text, names: [first, second] }: OtherVersion): Differed {
  const other = core.another(text);
  try {
    const begun = performance.now();
    while (!other.advance(BLOCKS)) {
      const took = performance.now() - begun;
      if (took > RUN_LIMIT_MS) other.stop(took / 1000);
    }
    const ran = performance.now();
    while (!other.removeMaterial(MOTIONS)) {
      if (performance.now() - ran > MACHINE_LIMIT_MS) other.stopMachining();
    }
    return { rows: core.differenceFrom(other), drawing: core.drawnWith(other, first, second) };
  } finally {
    other.free();
  }
}
