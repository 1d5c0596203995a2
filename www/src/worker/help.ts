// Help at a position in the program: replays the run up to the block there.
//
// In: a question about a position. Out: the answer, or undefined if the same asker has sent a newer question meanwhile,
// or there is a newer run. Must not know: the content of the answer.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { HelpClient, Help, HelpRequest } from '../protocol/protocol';

/** Blocks to replay before newer messages are processed. */
const BLOCKS_PER_SLICE = 20_000;

/** The pending questions of one program. */
interface PendingHelp {
  readonly newest: Map<HelpClient, HelpRequest>;
  /** The question whose block is being searched for; one at a time for each program. */
  current: HelpRequest | undefined;
}

const pendingByCore = new WeakMap<Playground, PendingHelp>();

export function answerHelp(core: Playground, request: HelpRequest): Help | undefined | Promise<Help | undefined> {
  const pending = pendingByCore.get(core) ?? { newest: new Map<HelpClient, HelpRequest>(), current: undefined };
  pendingByCore.set(core, pending);
  pending.newest.set(request.by, request);
  const other = pending.current;
  if (other !== undefined && pending.newest.get(other.by) === other) return answerLater();
  return start() ? answer() : answerLater();

  function start(): boolean {
    pending.current = request;
    const isReady =
      request.about === 'motion'
        ? core.askMotion(request.motion)
        : core.askBlock(request.offset, request.about === 'block' ? request.time : undefined);
    return isReady || core.lookForAnswer(BLOCKS_PER_SLICE);
  }

  function answer(): Help {
    pending.current = undefined;
    if (request.by === 'cursor') core.annotate(true);
    switch (request.about) {
      case 'word':
        return { request, word: core.wordHelp() };
      case 'block':
        return { request, word: core.wordHelp(), form: core.formHelp(), state: core.stateHelp() };
      case 'completion':
        return { request, completion: core.completionHelp(request.isExplicit) };
      case 'motion':
        return { request, explanation: core.explanation() };
    }
  }

  async function answerLater(): Promise<Help | undefined> {
    for (;;) {
      await new Promise((resolve) => setTimeout(resolve));
      if (pendingByCore.get(core)?.newest.get(request.by) !== request) return undefined;
      const { current } = pending;
      if (
        current === request
          ? core.lookForAnswer(BLOCKS_PER_SLICE)
          : (current === undefined || pending.newest.get(current.by) !== current) && start()
      )
        return answer();
    }
  }
}

/** Drops the questions of a closed program. */
export function dropQuestions(core: Playground): void {
  pendingByCore.delete(core);
}
