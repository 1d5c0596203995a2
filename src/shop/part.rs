//! The work as it is machined: what is left of the blank after each motion.
//!
//! In: the motions, and tools and blank as they are given or guessed. Out: the half-section at any moment. Material is
//! taken off in slices (`advance`), so that a long program holds nothing up; now and then the state is kept, so that any
//! moment is near one that is known.

use std::cell::RefCell;

use super::fitting::{Fitted, Fitting};
use super::region::Region;
use super::sweep::chords;
use super::tool::Action;
use crate::control::setup::Stock;
use crate::geometry::{Point, SAME};
use crate::motion::{Motion, MotionKind, Motions};

/// Most turns of a thread that are cut one by one; a finer one is cut as a whole.
const MOST_TURNS: f64 = 2000.0;

/// Corners of the pieces that wait to be taken off, at most.
const MOST_WAITING: usize = 1500;

/// Motions from one kept state to the next, at least.
const STRIDE: usize = 32;

/// Most corners of all states that are kept; beyond, every other one is dropped.
const MOST_KEPT: usize = 1_000_000;

/// The work under way.
#[derive(Clone, Debug, Default)]
pub struct Part {
    blank: Region,
    now: Region,
    /// Motions whose material is off, or waits in `waiting`.
    done: usize,
    /// Outlines that are still to be taken off `now`.
    waiting: Vec<Vec<Point>>,
    corners: usize,
    /// States on the way: so many motions were done.
    kept: Vec<(usize, Region)>,
    /// Corners of all of them.
    kept_corners: usize,
    /// Motions from one to the next, at least.
    stride: usize,
    /// The state that was asked for last: so many motions were done. The next one asked for is often a little later.
    last: RefCell<Option<(usize, Region)>>,
}

impl Part {
    /// The blank, before the first motion.
    pub fn new(stock: &Stock) -> Self {
        let (low, high) = (stock.bore / 2.0, stock.diameter / 2.0);
        let corners = [(low, stock.back()), (low, stock.face), (high, stock.face), (high, stock.back())];
        let blank = Region::inside(&corners.map(|(x, z)| Point::new(x, z)));
        Self { now: blank.clone(), blank, stride: STRIDE, ..Self::default() }
    }

    /// The blank.
    pub fn blank(&self) -> &Region {
        &self.blank
    }

    /// Motions that are done.
    pub fn done(&self) -> usize {
        self.done
    }

    /// Does the next motion with its tool.
    pub fn step(&mut self, motion: &Motion, tool: &Fitted) {
        let before = self.waiting.len();
        self.waiting.extend(cut(motion, tool));
        self.corners += self.waiting[before..].iter().map(Vec::len).sum::<usize>();
        self.done += 1;
        if self.corners > MOST_WAITING {
            self.settle();
        }
        if self.done >= self.kept.last().map_or(0, |last| last.0) + self.stride && !self.waiting.is_empty() {
            self.settle();
            self.keep();
        }
    }

    /// Keeps the state as it is now.
    fn keep(&mut self) {
        self.kept_corners += self.now.corners();
        self.kept.push((self.done, self.now.clone()));
        if self.kept_corners > MOST_KEPT {
            let mut odd = false;
            self.kept.retain(|_| {
                odd = !odd;
                odd
            });
            self.kept_corners = self.kept.iter().map(|state| state.1.corners()).sum();
            self.stride *= 2;
        }
    }

    /// Corners of what is left.
    pub fn corners(&self) -> usize {
        self.now.corners()
    }

    /// The work as it is now.
    pub fn now(&mut self) -> &Region {
        self.settle();
        &self.now
    }

    /// The work after all motions that are done.
    pub fn finished(&self) -> Region {
        let mut now = self.now.clone();
        now.cut(&self.waiting);
        now
    }

    /// The work when so many motions are done, and of the next one the fraction `share`.
    pub fn at(&self, motions: &Motions, fitting: &Fitting, count: usize, share: f64) -> Region {
        let count = count.min(self.done);
        let (from, mut region) = self.near(count);
        let mut outlines: Vec<Vec<Point>> = Vec::new();
        for motion in (from..count).map(|index| motions.get(index)) {
            outlines.extend(cut(&motion, fitting.tool(&motion)));
        }
        if !outlines.is_empty() {
            region.cut(&outlines);
        }
        self.last.replace(Some((count, region.clone())));
        if count < motions.len() && count < self.done && share > 0.0 {
            let motion = motions.get(count).first_part(share);
            let outlines = cut(&motion, fitting.tool(&motion));
            if !outlines.is_empty() {
                region.cut(&outlines);
            }
        }
        region
    }

    /// The latest known state that is not behind so many motions.
    fn near(&self, count: usize) -> (usize, Region) {
        let kept = self.kept.partition_point(|state| state.0 <= count).checked_sub(1);
        let from = kept.map_or(0, |index| self.kept[index].0);
        match (self.last.take().filter(|last| (from..=count).contains(&last.0)), kept) {
            (Some(last), _) => last,
            (None, Some(index)) => self.kept[index].clone(),
            (None, None) => (0, self.blank.clone()),
        }
    }

    fn settle(&mut self) {
        if !self.waiting.is_empty() {
            self.now.cut(&self.waiting);
            self.waiting.clear();
            self.corners = 0;
        }
    }
}

/// What a motion takes off, as outlines that may overlap.
pub fn cut(motion: &Motion, tool: &Fitted) -> Vec<Vec<Point>> {
    if !motion.kind.cuts() || motion.rotary.is_some() || tool.shape.action == Action::Live {
        return Vec::new();
    }
    let edge = &tool.shape.edge;
    if let (Action::Threading, MotionKind::Thread, Some(lead)) = (tool.shape.action, motion.kind, motion.lead)
    {
        let long = (motion.to.x - motion.from.x).abs().max((motion.to.z - motion.from.z).abs());
        let turns = long / lead.abs();
        if turns.is_finite() && turns <= MOST_TURNS {
            return (0..=(turns + SAME) as u32)
                .map(|turn| edge.at(motion.between(f64::from(turn) / turns.max(SAME))))
                .collect();
        }
    }
    match motion.arc() {
        Some(arc) => edge.along(&chords(&arc)).collect(),
        None => vec![edge.along_line(motion.from, motion.to)],
    }
}
