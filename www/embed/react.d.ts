import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type { GcodePlayground, GcodePlaygroundProps } from './element.js';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'gcode-playground': DetailedHTMLProps<HTMLAttributes<GcodePlayground>, GcodePlayground> & GcodePlaygroundProps;
    }
  }
}
