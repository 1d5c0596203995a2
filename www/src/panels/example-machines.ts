// The machines that the page offers before the user keeps any: a small lathe of each kind of control. Their values are
// examples: the user enters the values of the real machine.
//
// Out: names, and setups as JSON. Must not know: where a chosen machine is stored.

import type { Language } from '../dom/language';
import { words } from '../dom/words';

export const EXAMPLE_MACHINE_IDS = ['fanuc', 'fanuc-inch', 'gsk'] as const;
export type ExampleMachineId = (typeof EXAMPLE_MACHINE_IDS)[number];

export interface ExampleMachine {
  readonly dialect: { readonly control: 'fanuc' | 'gsk'; readonly unit?: 'inch' };
  /** Lengths in mm, X as a diameter; rates in mm/min, speed in rpm. */
  readonly machine: {
    readonly rapidX: number;
    readonly rapidZ: number;
    readonly maxSpeed: number;
    readonly travel: { readonly xMin: number; readonly xMax: number; readonly zMin: number; readonly zMax: number };
    readonly turret?: 'front';
  };
}

export const EXAMPLE_MACHINES: Readonly<Record<ExampleMachineId, ExampleMachine>> = {
  // A slant bed with a chuck of 165 mm.
  fanuc: {
    dialect: { control: 'fanuc' },
    machine: {
      rapidX: 20_000,
      rapidZ: 24_000,
      maxSpeed: 5000,
      travel: { xMin: -40, xMax: 320, zMin: -320, zMax: 320 },
    },
  },
  // A toolroom lathe: rapids of 400 and 500 in/min, travel of 13 in (X, a diameter) and 30 in.
  'fanuc-inch': {
    dialect: { control: 'fanuc', unit: 'inch' },
    machine: {
      rapidX: 10_160,
      rapidZ: 12_700,
      maxSpeed: 3000,
      travel: { xMin: -25.4, xMax: 304.8, zMin: -508, zMax: 254 },
    },
  },
  // A flat bed of 750 mm with a tool post in front.
  gsk: {
    dialect: { control: 'gsk' },
    machine: {
      rapidX: 4000,
      rapidZ: 8000,
      maxSpeed: 2000,
      travel: { xMin: -20, xMax: 300, zMin: -500, zMax: 250 },
      turret: 'front',
    },
  },
};

export function isExampleMachine(id: string): id is ExampleMachineId {
  return Object.hasOwn(EXAMPLE_MACHINES, id);
}

export function exampleMachineName(id: ExampleMachineId, language: Language): string {
  return WORDS[language].names[id];
}

const WORDS = words({
  en: {
    names: {
      fanuc: 'Small lathe, FANUC',
      'fanuc-inch': 'Small lathe in inches, FANUC',
      gsk: 'Small lathe, GSK 980TD',
    },
  },
  zh: {
    names: { fanuc: '小型车床，FANUC', 'fanuc-inch': '小型英制车床，FANUC', gsk: '小型车床，GSK 980TD' },
  },
  ru: {
    names: {
      fanuc: 'Малый станок, FANUC',
      'fanuc-inch': 'Малый дюймовый станок, FANUC',
      gsk: 'Малый станок, GSK 980TD',
    },
  },
});
