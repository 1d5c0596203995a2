// Help at a position in the program: replays the run up to the block there.
//
// In: a question about a position. Out: the answer, or undefined if the same asker has sent a newer question meanwhile,
// or there is a newer run. Must not know: the content of the answer.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { Asker, Help, HelpWanted } from '../protocol/protocol';

/** Blocks to replay before newer messages are processed. */
const BLOCKS = 20_000;

/** The pending questions of one program. */
interface Asked {
  readonly newest: Map<Asker, HelpWanted>;
  /** The question whose block is being searched for; one at a time for each program. */
  sought: HelpWanted | undefined;
}

const asked = new WeakMap<Playground, Asked>();

export function help(core: Playground, ask: HelpWanted): Help | undefined | Promise<Help | undefined> {
  const all = asked.get(core) ?? { newest: new Map<Asker, HelpWanted>(), sought: undefined };
  asked.set(core, all);
  all.newest.set(ask.by, ask);
  const other = all.sought;
  if (other !== undefined && all.newest.get(other.by) === other) return later();
  return begun() ? answer() : later();

  function begun(): boolean {
    all.sought = ask;
    const isThere =
      ask.about === 'motion'
        ? core.askMotion(ask.motion)
        : core.askBlock(ask.offset, ask.about === 'block' ? ask.time : undefined);
    return isThere || core.lookForAnswer(BLOCKS);
  }

  function answer(): Help {
    all.sought = undefined;
    switch (ask.about) {
      case 'word':
        return { asked: ask, word: core.wordHelp() };
      case 'block':
        return { asked: ask, word: core.wordHelp(), form: core.formHelp(), state: core.stateHelp() };
      case 'completion':
        return { asked: ask, completion: core.completionHelp(ask.askedFor) };
      case 'motion':
        return { asked: ask, explanation: core.explanation() };
    }
  }

  async function later(): Promise<Help | undefined> {
    for (;;) {
      await new Promise((done) => setTimeout(done));
      if (asked.get(core)?.newest.get(ask.by) !== ask) return undefined;
      const { sought } = all;
      if (
        sought === ask
          ? core.lookForAnswer(BLOCKS)
          : (sought === undefined || all.newest.get(sought.by) !== sought) && begun()
      )
        return answer();
    }
  }
}

/** Drops the questions of a closed program. */
export function forget(core: Playground): void {
  asked.delete(core);
}
