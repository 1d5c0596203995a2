import type { GcodePlaygroundProps } from './element.js';

declare module 'preact' {
  namespace JSX {
    interface IntrinsicElements {
      'gcode-playground': IntrinsicElements['div'] & GcodePlaygroundProps;
    }
  }
}
