// What a project of playwright.config.ts says.

export type EngineName = 'chromium' | 'firefox' | 'webkit';

export interface WorkerOptions {
  engine: EngineName;
  /** Where the page is served. */
  server: string;
}
