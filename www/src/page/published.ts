// The addresses of the published files for other pages: the element, its frame, the script of a SCORM package.

import { pageAddress } from './linked';

/** Defined by the build. */
declare const PLAYGROUND_VERSION: string;

/** The address of a file in the folder that is named after the version, whose files never change. */
export function publishedFile(name: string): string {
  return new URL(`embed/${PLAYGROUND_VERSION}/${name}`, pageAddress()).href;
}
