//! Tool nose radius compensation: G41, G42, G40.
//!
//! In: the programmed moves of one plane, one after the other. Out: the path of the imaginary tip while the
//! nose, a circle, rolls along the programmed path (FANUC 16/18-T B-62754EN p. 224). A move is emitted only
//! when the next one is known, because its end depends on the corner between them. Works in millimetres, in
//! any plane with a first axis `z` (to the right) and a second axis `x` (upwards): Z and the X radius for
//! turning, the virtual X and C of polar interpolation with tip 0. Knows nothing of words, blocks and offset
//! tables.
//!
//! Outside compensation the imaginary tip is at the programmed point. Inside, the *centre* of the nose
//! follows the path offset by the radius, and the tip is the centre minus [`Nose::vector`]. All geometry uses
//! the vector from a programmed point to the centre, as the control does; radius 0 returns the programmed
//! path exactly.

mod clearance;
mod corner;
mod path;
#[cfg(test)]
mod tests;

use crate::geometry::{Point, SAME};
use clearance::CenterPath;
use corner::{Corner, corner};
pub use path::{Element, Nose, Shape, Side, Travel, Vector};
use path::{Track, ZERO};

/// A move of the imaginary tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensated {
    /// The source element; for a move around a corner, the element after the corner.
    pub id: u32,
    /// Rapid or feed, as for the source element.
    pub travel: Travel,
    /// Start of the tip: the end of the previous move.
    pub from: Point,
    /// End of the tip.
    pub to: Point,
    /// A line, or an arc about a centre that is shifted like the tip.
    pub shape: Shape,
    /// The programmed end point; for a move around a corner, the corner.
    pub programmed: Point,
    /// Whether the move is programmed or inserted.
    pub made_by: MadeBy,
}

/// Whether a compensated move is in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MadeBy {
    /// A programmed element, shifted and lengthened or shortened.
    Program,
    /// Inserted by the control to lead the nose around a corner.
    Compensation,
}

/// Why an element cannot be compensated. The element is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompensationError {
    /// The element that is left out.
    pub id: u32,
    /// The reason.
    pub reason: Reason,
}

/// Why an element cannot be compensated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// Compensation starts or ends on an arc: PS0034.
    ArcAtSwitch,
    /// The offset paths of this element and the previous one do not meet: PS0033.
    NoIntersection {
        /// The previous element.
        before: u32,
    },
    /// The offset element would run against its programmed direction: a groove narrower than the nose, or an
    /// element shorter than the length that its corners remove. PS0041.
    Overcut {
        /// How far it would run backwards, mm.
        backwards: f64,
    },
    /// The nose would cut into this element or into one of the two before it: a valley whose sides touch, or
    /// a gap narrower than the nose. PS0041.
    CutsIn {
        /// How deep, mm.
        depth: f64,
    },
    /// The start or end of the arc equals its centre: PS0038.
    ArcCenter,
    /// The nose does not fit inside the arc: PS0041.
    ArcRadius {
        /// Programmed radius, mm; smaller than the nose radius.
        radius: f64,
    },
}

/// The compensated move of an element, or the reason why it is left out.
pub type Outcome = Result<Compensated, CompensationError>;

/// Compensation in force: from G41 or G42 until G40.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensator {
    side: Side,
    nose: Nose,
    /// Position of the tip after the last emitted move.
    tip: Point,
    stage: Stage,
    /// The cuts before the waiting element, latest first, each connected to the next without a gap.
    behind: [Option<Cut>; 2],
}

/// A programmed cut, with the path of the nose centre along it and around the corner at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cut {
    element: Element,
    paths: [Option<CenterPath>; 4],
}

/// Progress of compensation.
#[derive(Clone, Debug, PartialEq)]
enum Stage {
    /// Commanded, no move yet.
    Commanded,
    /// The start-up move, waiting for the next element.
    StartUp(Element),
    /// An element on the offset path, waiting for the next.
    Waiting(Waiting),
    /// Every element is emitted; the nose is beside the path.
    Idle,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Waiting {
    element: Element,
    /// The side when it was commanded.
    side: Side,
    begin: Begin,
}

/// Position of the centre at the start of an element: the vector from its programmed start, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    /// On the offset path of the element.
    OnPath(Vector),
    /// Where the previous element left it, because this one was not known yet (no look-ahead).
    OffPath,
}

impl Compensator {
    /// Starts compensation with the next move, with the tip on the programmed point `at`. The caller turns a
    /// negative radius into the other side.
    pub fn start(side: Side, nose: Nose, at: Point) -> Self {
        Self { side, nose, tip: at, stage: Stage::Commanded, behind: [None; 2] }
    }

    /// The same compensation, with element numbers counted from `first`.
    pub fn counted_from(mut self, first: u32) -> Self {
        match &mut self.stage {
            Stage::StartUp(element) | Stage::Waiting(Waiting { element, .. }) => {
                element.id = element.id.wrapping_sub(first);
            }
            Stage::Commanded | Stage::Idle => {}
        }
        for cut in self.behind.iter_mut().flatten() {
            cut.element.id = cut.element.id.wrapping_sub(first);
        }
        self
    }

    /// The side of the following elements.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The nose in force.
    pub fn nose(&self) -> Nose {
        self.nose
    }

    /// Position of the tip after the last emitted move.
    pub fn tip(&self) -> Point {
        self.tip
    }

    /// Takes the next programmed element. Emits the previous one and the moves around the corner between
    /// them. Ignores a line without length.
    pub fn push(&mut self, element: Element, out: &mut impl FnMut(Outcome)) {
        if element.is_still() {
            return;
        }
        if let Err(reason) = self.acceptable(&element) {
            out(Err(CompensationError { id: element.id, reason }));
            return;
        }
        if self.end().is_some_and(|end| !end.is_same(element.from)) {
            self.flush(out);
        }
        let next = Track::new(&element, self.side);
        match std::mem::replace(&mut self.stage, Stage::Idle) {
            Stage::Commanded => self.stage = Stage::StartUp(element),
            Stage::StartUp(first) => {
                // Type A: perpendicular to the next element at its start (§4.2).
                let begin = next.start_normal() * self.nose.radius;
                self.emit(&first, begin, Shape::Line, MadeBy::Program, out);
                self.wait(element, Begin::OnPath(begin));
            }
            Stage::Idle => self.enter(element, out),
            Stage::Waiting(waiting) => {
                let found = corner(Track::new(&waiting.element, waiting.side), next, self.nose.radius)
                    .ok_or(Reason::NoIntersection { before: waiting.element.id })
                    .and_then(|corner| Ok((corner, self.clear_of(&waiting, &corner, &element)?)));
                match found {
                    Err(reason) => {
                        out(Err(CompensationError { id: element.id, reason }));
                        self.stage = Stage::Waiting(waiting);
                    }
                    Ok((corner, cut)) if self.finish(&waiting, corner.end, out) => {
                        for joint in [corner.around[0], corner.around[1], corner.begin] {
                            self.join(&element, joint, out);
                        }
                        self.behind = [cut, self.behind[0].filter(|_| cut.is_some())];
                        self.wait(element, Begin::OnPath(corner.begin));
                    }
                    Ok(_) => {
                        self.behind = [None; 2];
                        self.enter(element, out);
                    }
                }
            }
        }
    }

    /// No further element is known: end of program, start of a cycle, or two blocks without a move. The
    /// centre goes perpendicular to the end of the last element (§4.3); a later element begins there.
    pub fn flush(&mut self, out: &mut impl FnMut(Outcome)) {
        match std::mem::replace(&mut self.stage, Stage::Idle) {
            Stage::Commanded => self.stage = Stage::Commanded,
            Stage::StartUp(first) => {
                let end = Track::new(&first, self.side).end_normal() * self.nose.radius;
                self.emit(&first, end, Shape::Line, MadeBy::Program, out);
            }
            Stage::Waiting(waiting) => {
                let end = Track::new(&waiting.element, waiting.side).end_normal() * self.nose.radius;
                self.finish(&waiting, end, out);
            }
            Stage::Idle => {}
        }
        self.behind = [None; 2];
    }

    /// G41 after G42, or the reverse, without a G40: the following elements have the nose on the other side.
    /// The last element keeps its side, and the nose crosses the path between the two.
    pub fn change_side(&mut self, side: Side) {
        self.side = side;
    }

    /// G40: the last element ends with the centre perpendicular to its end. The move of the G40 block, if
    /// any, ends with the tip on the programmed point; without one the tip stays beside the path until the
    /// next move. If the block gives a `wall` (direction and length in mm, X as a radius), the last element
    /// ends where its offset path meets the offset path of the wall, which begins at the end of the element
    /// (FANUC 16-TC B-61804E 15.3.4).
    pub fn cancel(mut self, element: Option<Element>, wall: Option<Point>, out: &mut impl FnMut(Outcome)) {
        if let (Some(wall), Stage::Waiting(waiting)) = (wall, &self.stage) {
            let (waiting, from) = (*waiting, waiting.element.to);
            let wall = Element { from, to: from.moved(wall), shape: Shape::Line, ..waiting.element };
            // I0 K0 gives no direction.
            let track = (!wall.is_still()).then(|| Track::new(&wall, waiting.side));
            let meeting = track
                .and_then(|wall| corner(Track::new(&waiting.element, waiting.side), wall, self.nose.radius));
            if let Some(meeting) = meeting {
                self.stage = Stage::Idle;
                self.finish(&waiting, meeting.end, out);
            }
        }
        self.flush(out);
        let Some(element) = element else { return };
        match element.shape {
            Shape::Arc { .. } => out(Err(CompensationError { id: element.id, reason: Reason::ArcAtSwitch })),
            Shape::Line if self.tip == element.to => {}
            Shape::Line => {
                let beside = self.nose.offset();
                self.emit(&element, beside, Shape::Line, MadeBy::Program, out);
            }
        }
    }

    /// End of the waiting element, if any.
    fn end(&self) -> Option<Point> {
        match &self.stage {
            Stage::StartUp(element) => Some(element.to),
            Stage::Waiting(waiting) => Some(waiting.element.to),
            Stage::Commanded | Stage::Idle => None,
        }
    }

    /// Whether an element can be compensated at all, regardless of its neighbours.
    fn acceptable(&self, element: &Element) -> Result<(), Reason> {
        let Shape::Arc { center, .. } = element.shape else { return Ok(()) };
        if self.stage == Stage::Commanded {
            return Err(Reason::ArcAtSwitch);
        }
        let radius = element.from.distance(center).min(element.to.distance(center));
        if radius <= SAME {
            return Err(Reason::ArcCenter);
        }
        if Track::new(element, self.side).offset_radius(radius, self.nose.radius) <= SAME {
            return Err(Reason::ArcRadius { radius });
        }
        Ok(())
    }

    fn wait(&mut self, element: Element, begin: Begin) {
        self.stage = Stage::Waiting(Waiting { element, side: self.side, begin });
    }

    /// Checks that the nose does not cut in: along a waiting element and around the corner at its end it must
    /// keep clear of the next element, around the corner also of the elements before, and the previous cut
    /// must keep clear of the next one. Rapids cut no contour, and a nose that changes sides crosses the
    /// path; both are not checked. Returns the cut that the waiting element becomes, if it is one.
    fn clear_of(&self, waiting: &Waiting, corner: &Corner, next: &Element) -> Result<Option<Cut>, Reason> {
        let element = waiting.element;
        let cuts = element.travel == Travel::Feed && next.travel == Travel::Feed && waiting.side == self.side;
        let Some(along) = self.path_along(waiting, corner.end).filter(|_| cuts) else { return Ok(None) };
        let ends = [corner.end, corner.around[0], corner.around[1], corner.begin];
        let [end, first, second, last] = ends.map(|vector| vector.from(element.to));
        let around = [(end, first), (first, second), (second, last)]
            .map(|(from, to)| (!from.is_same(to)).then_some(CenterPath::straight(from, to)));
        let before = self.behind.iter().flatten().take(1).flat_map(|cut| cut.paths).flatten();
        let beside = around.into_iter().flatten();
        let contour = [Some(element), self.behind[0].map(|cut| cut.element)];
        let radius = self.nose.radius;
        let opens = !self.closes(&element) && !self.closes(next) && !next.to.is_same(element.from);
        let into_next = before.chain([along]).filter(|_| opens).chain(beside.clone()).map(|way| (way, *next));
        let into_contour =
            beside.flat_map(|way| contour.into_iter().flatten().map(move |element| (way, element)));
        let depths =
            into_next.chain(into_contour).filter_map(|(way, element)| way.gouge_depth(&element, radius));
        match depths.reduce(f64::max) {
            Some(depth) => Err(Reason::CutsIn { depth }),
            None => Ok(Some(Cut { element, paths: [Some(along), around[0], around[1], around[2]] })),
        }
    }

    /// Whether a contour that ends with this element ends where it began. The moves that approach and leave
    /// it are beside both ends, and belong to no contour.
    fn closes(&self, element: &Element) -> bool {
        let begins = self.behind.iter().flatten().map(|cut| cut.element.from);
        begins.chain([element.from]).any(|begin| begin.is_same(element.to))
    }

    /// The path of the centre along a waiting element that ends at `end`, relative to its programmed end.
    /// `None` if the element was not known in advance, or would run backwards.
    fn path_along(&self, waiting: &Waiting, end: Vector) -> Option<CenterPath> {
        let Waiting { element, side, begin: Begin::OnPath(begin) } = *waiting else { return None };
        let length = Track::new(&element, side).length_between(begin, end);
        let shape = if length > 2.0 * SAME { element.shape } else { Shape::Line };
        (length >= -SAME).then(|| CenterPath {
            from: begin.from(element.from),
            to: end.from(element.to),
            shape,
        })
    }

    /// Begins an element that was not known when the previous one ended: a line goes straight from the
    /// position of the nose to its end; a straight move leads to the start of an arc.
    fn enter(&mut self, element: Element, out: &mut impl FnMut(Outcome)) {
        let stands = Vector::between(element.from, self.tip) + self.nose.offset();
        let begin = Track::new(&element, self.side).start_normal() * self.nose.radius;
        if (stands - begin).length() <= SAME {
            self.wait(element, Begin::OnPath(begin));
        } else if element.shape == Shape::Line {
            self.wait(element, Begin::OffPath);
        } else {
            self.join(&element, begin, out);
            self.wait(element, Begin::OnPath(begin));
        }
    }

    /// Emits a waiting element whose centre ends at `end`, relative to its programmed end. Returns whether it
    /// could.
    fn finish(&mut self, waiting: &Waiting, end: Vector, out: &mut impl FnMut(Outcome)) -> bool {
        let element = &waiting.element;
        let begin = match waiting.begin {
            Begin::OnPath(begin) => begin,
            Begin::OffPath => {
                self.emit(element, end, Shape::Line, MadeBy::Program, out);
                return true;
            }
        };
        let length = Track::new(element, waiting.side).length_between(begin, end);
        if length < -SAME {
            let reason = Reason::Overcut { backwards: -length };
            out(Err(CompensationError { id: element.id, reason }));
            return false;
        }
        let contour = self.behind.iter().flatten().map(|cut| cut.element);
        let cuts = element.travel == Travel::Feed && !self.closes(element);
        let way = self.path_along(waiting, end).filter(|_| cuts);
        let depths = contour.filter_map(|before| way?.gouge_depth(&before, self.nose.radius));
        if let Some(depth) = depths.reduce(f64::max) {
            out(Err(CompensationError { id: element.id, reason: Reason::CutsIn { depth } }));
            return false;
        }
        let shape = match element.shape {
            Shape::Arc { center, turn } if length > 2.0 * SAME => {
                Shape::Arc { center: self.shown(center, ZERO), turn }
            }
            // An arc that the corners remove completely has no length, and must not look like a full circle.
            Shape::Arc { .. } | Shape::Line => Shape::Line,
        };
        self.emit(element, end, shape, MadeBy::Program, out);
        true
    }

    /// Adds a straight move around the corner before `element`, unless the tip is already there.
    fn join(&mut self, element: &Element, joint: Vector, out: &mut impl FnMut(Outcome)) {
        let corner = Element { to: element.from, ..*element };
        if !self.shown(corner.to, joint).is_same(self.tip) {
            self.emit(&corner, joint, Shape::Line, MadeBy::Compensation, out);
        }
    }

    /// Emits a move that ends with the centre at `end`, relative to the programmed end of `element`.
    fn emit(
        &mut self,
        element: &Element,
        end: Vector,
        shape: Shape,
        made_by: MadeBy,
        out: &mut impl FnMut(Outcome),
    ) {
        let to = self.shown(element.to, end);
        let Element { id, travel, to: programmed, .. } = *element;
        out(Ok(Compensated { id, travel, from: self.tip, to, shape, programmed, made_by }));
        self.tip = to;
    }

    /// Position of the tip when the centre is at `vector` from a programmed point.
    fn shown(&self, programmed: Point, vector: Vector) -> Point {
        (vector - self.nose.offset()).from(programmed)
    }
}

/// Compensates a whole path: compensation starts with the first element, from the tip at `from`, and the last
/// element ends perpendicular. Stops at the first error.
pub fn compensate_path(
    side: Side,
    nose: Nose,
    from: Point,
    path: &[Element],
) -> Result<Vec<Compensated>, CompensationError> {
    let mut compensator = Compensator::start(side, nose, from);
    let mut moves = Vec::with_capacity(path.len());
    let mut fault = None;
    let mut keep = |outcome: Outcome| match outcome {
        Ok(compensated) => moves.push(compensated),
        Err(found) => {
            fault.get_or_insert(found);
        }
    };
    for element in path {
        compensator.push(*element, &mut keep);
    }
    compensator.flush(&mut keep);
    fault.map_or(Ok(moves), Err)
}

/// An axis of a single cycle. Compensation shifts a cut along one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// G90: the cut is deeper or shallower.
    X,
    /// G94: the cut is further left or right.
    Z,
}

/// Shift, mm, of the tip path of a G90 or G94 cut from `from` to `to` along an axis, so that the nose touches
/// the programmed line (§4.4). 0 for a cylinder or face cut with the matching tip. `None` if the line is
/// parallel to that axis, or has no length.
pub fn cycle_shift(side: Side, nose: Nose, from: Point, to: Point, along: Axis) -> Option<f64> {
    if from.is_same(to) {
        return None;
    }
    let line = Element { id: 0, travel: Travel::Feed, from, to, shape: Shape::Line };
    let normal = Track::new(&line, side).start_normal();
    let component = match along {
        Axis::X => normal.x,
        Axis::Z => normal.z,
    };
    let outwards = nose.radius * (1.0 - normal.dot(nose.vector()));
    (component.abs() > SAME).then(|| outwards / component)
}
