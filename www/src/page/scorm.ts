// A SCORM 1.2 package with one exercise, for a learning platform such as Moodle.
//
// In: an exercise, and the address of the published script `sco.js`. Out: a ZIP file with a page that contains the
// exercise; the element is loaded from the host of the script. Must not know: the learning platform.

import { strToU8, zipSync } from 'fflate';
import type { Language } from '../dom/language';
import { escapeHtml } from './embed-text';

export interface PackedExercise {
  readonly id: string;
  readonly title: string;
  /** The exercise file. */
  readonly text: string;
  readonly language: Language;
}

/** ZIP has no dates before 1980; a fixed one makes equal packages equal. */
const DATE = '1980-01-02T00:00:00';

export function scormPackage(exercise: PackedExercise, script: string): Uint8Array<ArrayBuffer> {
  const files = { 'imsmanifest.xml': manifest(exercise), 'index.html': page(exercise, script) };
  const bytes = Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)]));
  return new Uint8Array(zipSync(bytes, { mtime: DATE }));
}

function manifest({ id, title }: PackedExercise): string {
  const shown = escapeHtml(printable(title));
  return `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="gcode-playground-${escapeHtml(id)}" version="1.0" xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="organization">
    <organization identifier="organization">
      <title>${shown}</title>
      <item identifier="item" identifierref="exercise">
        <title>${shown}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="exercise" type="webcontent" adlcp:scormtype="sco" href="index.html">
      <file href="index.html"/>
    </resource>
  </resources>
</manifest>
`;
}

/** A text without the control characters that XML does not allow. */
function printable(text: string): string {
  return [...text].filter((character) => character >= ' ').join('');
}

function page({ title, text, language }: PackedExercise, script: string): string {
  const [shown, source, exercise] = [title, script, text].map(escapeHtml);
  return `<!doctype html>
<html lang="${language}">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>${shown}</title>
<style>body { margin: 0; } gcode-playground { --playground-height: 100vh; }</style>
<script type="module" src="${source}"></script>
<gcode-playground language="${language}" loading="eager" exercise="${exercise}"></gcode-playground>
</html>
`;
}
