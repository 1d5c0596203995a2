// The worker's half of comparing the program with another version.
//
// In: the `Playground` and the other text. Out: the differences, and a drawing of both. The other version runs in a
// temporary interpreter within time limits, so that the page never waits long. Must not know: how the differences are
// shown.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { DifferenceResult, OtherVersion } from '../protocol/protocol';

/** A program that takes longer is compared as far as it has run; a message reports that. */
const RUN_LIMIT_MS = 4_000;
const MACHINE_LIMIT_MS = 3_000;
const BLOCKS_PER_STEP = 20_000;
const MOTIONS_PER_STEP = 100;

export function computeDifference(core: Playground, { text, names: [first, second] }: OtherVersion): DifferenceResult {
  const other = core.another(text);
  try {
    const startedAt = performance.now();
    while (!other.advance(BLOCKS_PER_STEP)) {
      const elapsedMs = performance.now() - startedAt;
      if (elapsedMs > RUN_LIMIT_MS) other.stop(elapsedMs / 1000);
    }
    const machiningStartedAt = performance.now();
    while (!other.removeMaterial(MOTIONS_PER_STEP)) {
      if (performance.now() - machiningStartedAt > MACHINE_LIMIT_MS) other.stopMachining();
    }
    return { rows: core.differenceFrom(other), drawing: core.drawnWith(other, first, second) };
  } finally {
    other.free();
  }
}
