// Asks the worker for help at a place of the program: the word there, and proposals.
//
// In: a place. Out: the help; undefined if there is none, or the text has changed meanwhile. Must not know: where the
// help is shown.

import type { Answer, CompletionHelp, Help, HelpRequest, WordHelp } from '../protocol/protocol';

const TRIES = 10;
/** Delays between tries, ms. The pointer still rests on a word, so that question is repeated for longer. */
const WORD_RETRY_MS = 100;
const COMPLETION_RETRY_MS = 20;

interface PlaceHelpSource {
  /** Changes with each change of the text. */
  revision(): number;
  ask(request: HelpRequest): Promise<Answer<'help'> | undefined>;
}

export async function wordAt(source: PlaceHelpSource, offset: number): Promise<WordHelp | undefined> {
  return (await helpAt(source, { by: 'pointer', about: 'word', offset }, WORD_RETRY_MS))?.word;
}

export async function completionAt(
  source: PlaceHelpSource,
  offset: number,
  isExplicit: boolean,
): Promise<CompletionHelp | undefined> {
  const request: HelpRequest = { by: 'completion', about: 'completion', offset, isExplicit };
  return (await helpAt(source, request, COMPLETION_RETRY_MS))?.completion;
}

/** Asks again if a new run discards the answer while the text is unchanged. */
async function helpAt(source: PlaceHelpSource, request: HelpRequest, delayMs: number): Promise<Help | undefined> {
  const revision = source.revision();
  for (let tries = 0; tries < TRIES && source.revision() === revision; tries++) {
    const help = await source.ask(request);
    if (help !== undefined) return help;
    await new Promise((done) => setTimeout(done, delayMs));
  }
  return undefined;
}
