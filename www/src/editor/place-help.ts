// Asks the worker for help at a place of the program: the word there, and proposals.
//
// In: a place. Out: the help; undefined if there is none, or the text has changed meanwhile. Must not know: where the
// help is shown.

import type { Answer, CompletionHelp, Help, HelpRequest, WordHelp } from '../protocol/protocol';

const TRIES = 10;
/** Delays between tries, ms. The pointer still rests on a word, so that question is repeated for longer. */
const WORD_RETRY_MS = 100;
const COMPLETION_RETRY_MS = 20;

export interface HelpSource {
  /** `revision` changes with each change of the text. */
  readonly editor: { readonly revision: number };
  ask(about: 'help', request: HelpRequest): Promise<Answer<'help'> | undefined>;
  /** Runs pending edits now. */
  flush(): void;
}

/** The word at an offset. */
export async function wordAt(source: HelpSource, offset: number): Promise<WordHelp | undefined> {
  return (await helpAt(source, { by: 'pointer', about: 'word', offset }, WORD_RETRY_MS))?.word;
}

/** The proposals at an offset; `isExplicit`: the user has requested them. */
export async function completionAt(
  source: HelpSource,
  offset: number,
  isExplicit: boolean,
): Promise<CompletionHelp | undefined> {
  source.flush();
  const request: HelpRequest = { by: 'completion', about: 'completion', offset, isExplicit };
  return (await helpAt(source, request, COMPLETION_RETRY_MS))?.completion;
}

/** Asks again if a new run discards the answer while the text is unchanged. */
async function helpAt(source: HelpSource, request: HelpRequest, delayMs: number): Promise<Help | undefined> {
  const { revision } = source.editor;
  for (let tries = 0; tries < TRIES && source.editor.revision === revision; tries++) {
    const help = await source.ask('help', request);
    if (help !== undefined) return help;
    await new Promise((done) => setTimeout(done, delayMs));
  }
  return undefined;
}
