// Options that a project of playwright.config.ts sets.

export type EngineName = 'chromium' | 'firefox' | 'webkit';

/** Whether the page may use its service worker. Only tests of it need that; it would slow down the others. */
export interface TestOptions {
  storing: 'off' | 'on';
}

export interface WorkerOptions {
  engine: EngineName;
  /** URL of the server of the page. */
  server: string;
}
