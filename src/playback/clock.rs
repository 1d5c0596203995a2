//! The playback clock: converts between positions in the program and time.
//!
//! In: the motions and the machine. Out: a [`Clock`], which returns the position of the tool for a time of
//! the animation, and the machine time up to a position. If the time of a motion is unknown, the animation
//! uses a default rate; it never counts as known time. For rapids the time at the assumed rate is reported
//! separately. Must not know what is drawn.

use super::timing::{self, Total};
use crate::motion::{Motion, MotionKind, Motions};
use crate::setup::Machine;

/// Maximum duration of a rapid in the animation, seconds, because little happens during it.
const MAX_RAPID_SECONDS: f64 = 0.3;
/// Default rate of cuts with an unknown feed or spindle speed, mm/min.
const DEFAULT_CUTTING_RATE: f64 = 250.0;
/// Default rate of the C axis, degrees per second.
const DEFAULT_C_RATE: f64 = 120.0;
/// Number of motions between two cached readings.
const STRIDE: usize = 64;

/// A position in the program: the current motion; all earlier ones are finished.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Playhead {
    /// The motion.
    pub motion: usize,
    /// Fraction of the motion that is done: 0 at its start, 1 at its end.
    pub share: f64,
}

impl Playhead {
    /// The end of a motion.
    pub fn end_of(motion: usize) -> Self {
        Self { motion, share: 1.0 }
    }

    /// The start of the first motion.
    pub const START: Self = Self { motion: 0, share: 0.0 };
}

/// Times at a position of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// Time of the animation, seconds.
    pub animation_seconds: f64,
    /// Machine time.
    pub time: Total,
}

/// The clock of a program.
#[derive(Clone, Debug)]
pub struct Clock {
    machine: Machine,
    /// Cached readings: before every [`STRIDE`]th motion, and at the end.
    cached: Vec<Reading>,
    motions: usize,
}

impl Clock {
    /// Creates the clock of all motions.
    pub fn new(motions: &Motions, machine: &Machine) -> Self {
        let mut clock = Self { machine: *machine, cached: Vec::new(), motions: motions.len() };
        let mut reading = Reading::default();
        for (index, motion) in motions.iter().enumerate() {
            if index % STRIDE == 0 {
                clock.cached.push(reading);
            }
            reading.add(&motion, machine);
        }
        clock.cached.push(reading);
        clock
    }

    /// The machine whose rates are used.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The reading at the end of the program.
    pub fn total(&self) -> Reading {
        self.cached.last().copied().unwrap_or_default()
    }

    /// The reading at a position. `motions`: as passed to [`Clock::new`].
    pub fn at(&self, motions: &Motions, playhead: Playhead) -> Reading {
        let Playhead { motion, share } = playhead;
        if share >= 1.0 {
            return self.before(motions, motion + 1);
        }
        let mut reading = self.before(motions, motion);
        if share > 0.0 && motion < self.motions {
            let motion = motions.get(motion);
            reading.animation_seconds += share * animation_seconds(&motion, &self.machine);
            // The counts of motions with unknown time include a motion only when it is finished.
            let part = motion.first_part(share);
            match timing::seconds(&part, &self.machine) {
                Some(seconds) => reading.time.known += seconds,
                None if part.kind == MotionKind::Rapid => {
                    reading.time.assumed += timing::assumed_seconds(&part, &self.machine);
                }
                None => {}
            }
        }
        reading
    }

    /// The position at a time of the animation, in seconds; between two motions, the end of the first. For a
    /// program without motions, the end of motion 0, which does not exist. `motions`: as passed to
    /// [`Clock::new`].
    pub fn playhead_at(&self, motions: &Motions, animation_seconds: f64) -> Playhead {
        if animation_seconds >= self.total().animation_seconds {
            return Playhead::end_of(self.motions.saturating_sub(1));
        }
        if animation_seconds <= 0.0 || animation_seconds.is_nan() {
            return Playhead::START;
        }
        let index = self.cached.partition_point(|reading| reading.animation_seconds < animation_seconds) - 1;
        let mut reading = self.cached[index];
        for motion in index * STRIDE..self.motions {
            let before = reading.animation_seconds;
            reading.add(&motions.get(motion), &self.machine);
            if reading.animation_seconds >= animation_seconds {
                return Playhead {
                    motion,
                    share: (animation_seconds - before) / (reading.animation_seconds - before),
                };
            }
        }
        Playhead::end_of(self.motions.saturating_sub(1))
    }

    /// The reading before a motion; the total after the last motion.
    fn before(&self, motions: &Motions, motion: usize) -> Reading {
        if motion >= self.motions {
            return self.total();
        }
        let index = motion / STRIDE;
        let mut reading = self.cached[index];
        for motion in index * STRIDE..motion {
            reading.add(&motions.get(motion), &self.machine);
        }
        reading
    }
}

impl Reading {
    fn add(&mut self, motion: &Motion, machine: &Machine) {
        self.animation_seconds += animation_seconds(motion, machine);
        self.time.add(motion, machine);
    }
}

/// Duration of a motion in the animation, seconds: its time, or a default.
fn animation_seconds(motion: &Motion, machine: &Machine) -> f64 {
    if let Some(seconds) = timing::seconds(motion, machine) {
        return if motion.kind == MotionKind::Rapid { seconds.min(MAX_RAPID_SECONDS) } else { seconds };
    }
    let turned = motion.rotary.map_or(0.0, |rotary| (rotary.to - rotary.from).abs() / DEFAULT_C_RATE);
    let length = motion.length();
    match motion.kind {
        MotionKind::Rapid => (60.0 * length / timing::ASSUMED_RAPID).max(turned).min(MAX_RAPID_SECONDS),
        _ => (60.0 * length / DEFAULT_CUTTING_RATE).max(turned),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::analyze;
    use crate::setup::Setup;

    /// The motions of a program, and their clock.
    pub(in crate::playback) fn run(text: &str) -> (Motions, Clock) {
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let clock = Clock::new(&analysis.motions, &analysis.setup.machine);
        (analysis.motions, clock)
    }

    #[test]
    fn known_times_are_kept_and_others_get_a_default_rate() {
        // 80 mm of rapid; 20 mm at 60 mm/min; a dwell of 2 s.
        let (motions, clock) = run("G98 G0 X100 Z0\nG0 Z80\nM3 S500\nG1 Z60 F60\nG4 X2\nM30\n");
        let count = motions.len();
        let feed = clock.at(&motions, Playhead::end_of(count - 2)).animation_seconds
            - clock.at(&motions, Playhead::end_of(count - 3)).animation_seconds;
        assert!((feed - 20.0).abs() < 1e-9);
        let whole = clock.total();
        assert!((whole.time.known - 22.0).abs() < 1e-9, "{whole:?}");
        assert!(whole.time.unknown_rapids > 0 && whole.animation_seconds > 22.0);
    }

    #[test]
    fn rapids_are_short_in_the_animation() {
        // 12 s of cutting; the two rapids of 200 mm each take little time in the animation.
        let (motions, clock) = run("G98 M3 S500\nG0 X200 Z200\nG0 X50 Z2\nG1 Z-10 F60\nG0 X200 Z200\nM30\n");
        let cut = motions.iter().position(|motion| motion.kind == MotionKind::Feed).expect("a cut");
        let before = clock.at(&motions, Playhead::end_of(cut - 1)).animation_seconds;
        let whole = clock.total().animation_seconds;
        assert!(before < 0.7 && whole - 12.0 < 1.0, "{before} {whole}");
    }

    #[test]
    fn playhead_at_accepts_any_number() {
        for text in ["", "M30\n", "G0 X50 Z2\nG1 Z-20 F0.2\nG4 X1\nM30\n"] {
            let (motions, clock) = run(text);
            for seconds in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 1e300, 5e-324] {
                let place = clock.playhead_at(&motions, seconds);
                assert!((0.0..=1.0).contains(&place.share), "{text:?} {seconds}: {place:?}");
                assert!(place.motion <= motions.len(), "{text:?} {seconds}: {place:?}");
            }
        }
    }

    #[test]
    fn every_place_is_found_again_by_its_seconds() {
        let text: String =
            (0..400).map(|i| format!("G1 X{} Z-{} F{}\n", 40 + i % 7, i, 50 + i % 90)).collect();
        let (motions, clock) = run(&format!("G98 M3 S900\nG0 X50 Z2\n{text}"));
        for motion in 0..motions.len() {
            for share in [0.25, 1.0] {
                let place = Playhead { motion, share };
                let found = clock.playhead_at(&motions, clock.at(&motions, place).animation_seconds);
                assert!(found.motion == motion && (found.share - share).abs() < 1e-6, "{place:?} {found:?}");
            }
            let end = Playhead::end_of(motion);
            assert_eq!(clock.playhead_at(&motions, clock.at(&motions, end).animation_seconds), end);
        }
        assert_eq!(clock.playhead_at(&motions, -1.0), Playhead::START);
        assert_eq!(clock.playhead_at(&motions, f64::INFINITY), Playhead::end_of(motions.len() - 1));
    }
}
