// Help at a place of the program: the run is gone through once more up to the block there.
//
// In: what is asked of which place. Out: the answer, or nothing where a newer question of the same asker has come meanwhile,
// or another run. Must not know: what is answered.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { Asker, Help, HelpWanted } from '../protocol/protocol';

/** Blocks that are gone through before newer messages are looked at. */
const BLOCKS = 20_000;

/** What is asked of one program. */
interface Asked {
  readonly newest: Map<Asker, HelpWanted>;
  /** The question that is being looked for; a program looks for one at a time. */
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

/** A program that is gone is not asked any more. */
export function forget(core: Playground): void {
  asked.delete(core);
}
