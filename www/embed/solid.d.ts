import type { GcodePlayground, GcodePlaygroundEvents, GcodePlaygroundProps } from './element.js';

/** Solid sets a property with `prop:`, and listens to any event with `on:`. */
type SolidProps = {
  readonly [Name in keyof GcodePlaygroundProps as `prop:${Name & string}`]: GcodePlaygroundProps[Name];
} & {
  readonly [Event in keyof GcodePlaygroundEvents as `on:${Event}`]?: (event: GcodePlaygroundEvents[Event]) => void;
};

// The module that contains the namespace; `solid-js` only exports it again.
declare module 'solid-js/jsx-runtime' {
  namespace JSX {
    interface IntrinsicElements {
      'gcode-playground': HTMLAttributes<GcodePlayground> & GcodePlaygroundProps & SolidProps;
    }
  }
}
