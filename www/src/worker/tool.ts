// The worker's answers about the tool: moves it, and returns its position.
//
// In: the interpreter and a question. Out: the readout. Must not know: how the tool moves.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { Questions } from '../protocol/protocol';

type ToolQuestion = 'play' | 'seek' | 'seek-block' | 'step' | 'go-to' | 'readout';

export const toolAnswers: {
  readonly [K in ToolQuestion]: (core: Playground, args: Questions[K]['args']) => Questions[K]['answer'];
} = {
  play(core, { from, seconds, pace, pauseConditions }) {
    if (from === 'start') core.seek(0);
    const factor = pace.kind === 'times' ? pace.factor : core.animationSeconds() / pace.seconds;
    const heldBy = core.play(
      seconds * factor,
      pauseConditions.stops,
      pauseConditions.eachBlock,
      Uint32Array.from(pauseConditions.lines),
    );
    return { place: core.readout(), heldBy };
  },
  seek(core, { share }) {
    if (share === undefined) core.showWhole();
    else core.seek(share);
    return core.readout();
  },
  'seek-block': (core, { offset }) => {
    core.seekBlock(offset);
    return core.readout();
  },
  step(core, { unit, direction }) {
    core.step(unit, direction);
    return core.readout();
  },
  'go-to'(core, { motion }) {
    core.goTo(motion);
    return core.readout();
  },
  readout: (core) => core.readout(),
};
