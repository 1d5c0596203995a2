// What a project of playwright.config.ts says.

export type EngineName = 'chromium' | 'firefox' | 'webkit';

/** Whether the page may store itself for use without a network; only tests of that need it, the others would only be slower. */
export interface TestOptions {
  storing: 'off' | 'on';
}

export interface WorkerOptions {
  engine: EngineName;
  /** Where the page is served. */
  server: string;
}
