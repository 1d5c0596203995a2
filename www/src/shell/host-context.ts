// The context of the program, which the attributes of the element contain: control, setup, switches and origin.
//
// In: the element, changes by the user, another context. Out: the context, the attributes merged into one setup, and the
// events of the element. Must not know: the text of the program, or how it is run.

import type { ProgramContext } from '../editor/text-store';
import type { SwitchState } from '../panels/panel';
import { mergeSetup, readSwitches } from './merged-setup';

/** The attributes, as properties of the element. */
type ContextHost = { -readonly [K in keyof ProgramContext]: ProgramContext[K] } & {
  /** Whether the page marks its programs with `origin`. */
  readonly marksPrograms: boolean;
};

interface HostContextEvents {
  /** The setup of a program of which only the text is known. */
  defaultSetup(): string | null;
  /** The program was replaced by another one, which may have the same context. */
  onReplaced(): void;
  /** Called for each merged setup. */
  onSwitches(switches: SwitchState): void;
  fire<Detail>(type: string, detail: Detail): void;
}

const EMPTY_CONTEXT: ProgramContext = { control: null, setup: null, blockSkip: null, program: null, origin: null };
const CONTEXT_KEYS = Object.keys(EMPTY_CONTEXT) as readonly (keyof ProgramContext)[];

export class HostContext {
  readonly #host: ContextHost;
  readonly #events: HostContextEvents;
  #setupError: string | undefined;

  constructor(host: ContextHost, events: HostContextEvents) {
    this.#host = host;
    this.#events = events;
  }

  get current(): ProgramContext {
    const { control, setup, blockSkip, program, origin } = this.#host;
    return { control, setup, blockSkip, program, origin };
  }

  /** The context of a program of which only the text is known: it runs on the user's own machine. */
  get neutral(): ProgramContext {
    return { ...EMPTY_CONTEXT, setup: this.#events.defaultSetup() };
  }

  /** Whether the page tells its programs apart: then a text that the user types can be another one, too. */
  get marksPrograms(): boolean {
    return this.#host.marksPrograms;
  }

  /** Another program has replaced the current one. */
  replace(context: ProgramContext): void {
    const before = this.current;
    // Only what changes: a page that has never set `origin` marks no programs.
    for (const key of CONTEXT_KEYS) if (context[key] !== before[key]) this.#host[key] = context[key];
    this.#events.onReplaced();
    this.#events.fire('gcode-context', context);
  }

  /** The attribute `setup`, JSON. */
  get setup(): string | null {
    return this.#host.setup;
  }

  /** The user has changed the setup, JSON. */
  changeSetup(setup: string | null): void {
    const host = this.#host;
    if (host.setup === setup && host.control === null) return;
    host.setup = setup;
    // The form has shown the control of the attribute, and the new setup contains it.
    host.control = null;
    this.#events.fire('gcode-setup', { setup });
  }

  /** The user has changed a switch. */
  setSwitches({ blockSkip, program }: { readonly blockSkip?: string; readonly program?: string }): void {
    const host = this.#host;
    if (blockSkip !== undefined) host.blockSkip = blockSkip;
    if (program !== undefined) host.program = program;
    this.#events.fire('gcode-switch', { blockSkip: host.blockSkip, program: host.program });
  }

  /** The setup merged with the other attributes, JSON; undefined if it is invalid. */
  mergedSetup(): string | undefined {
    const { control, setup, blockSkip, program } = this.#host;
    const merged = mergeSetup(setup, { control, blockSkip, program });
    this.#events.onSwitches(readSwitches(merged));
    this.#setupError = merged.kind === 'unreadable' ? merged.reason : undefined;
    return merged.kind === 'setup' ? merged.json : undefined;
  }

  /** Why the last merged setup is invalid. */
  get setupError(): string | undefined {
    return this.#setupError;
  }
}
