//! Tool nose radius compensation: G41, G42, G40.
//!
//! In: the programmed moves of one plane, one after the other. Out: the same moves as the tip shows them
//! while the nose, a circle, rolls along the programmed path (FANUC 16/18-T B-62754EN p. 224). A move is
//! given out when the next one is known, for its end depends on the corner between them. Works in millimetres
//! in any plane whose first axis is called `z` (to the right) and whose second is called `x` (upwards): Z and
//! X radius for turning, the virtual X and C of polar interpolation with tip 0. Knows nothing of words,
//! blocks and offset tables.
//!
//! Outside compensation the imaginary tip is the programmed point; inside, the *centre* of the nose follows
//! the path offset by the radius, and the tip is the centre less [`Nose::vector`]. All geometry is done with
//! the vector from a programmed point to the centre there, as the control does; radius 0 gives the
//! programmed path back exactly.

mod clearance;
mod corner;
mod path;
#[cfg(test)]
mod tests;

use crate::geometry::{Point, SAME};
use clearance::Way;
use corner::{Corner, corner};
pub use path::{Element, Nose, Shape, Side, Travel, Vector};
use path::{Track, ZERO};

/// A move as the tip shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensated {
    /// The element it comes from; for a move around a corner, the one after the corner.
    pub id: u32,
    /// Rapid or feed, as the element it comes from.
    pub travel: Travel,
    /// Where the tip stands before it: where the last move ended.
    pub from: Point,
    /// Where the tip ends.
    pub to: Point,
    /// Straight, or an arc about a centre moved as the tip is.
    pub shape: Shape,
    /// The programmed end point; of a move around a corner, the corner.
    pub programmed: Point,
    /// Whether the program asks for it.
    pub made_by: MadeBy,
}

/// Whether a compensated move stands in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MadeBy {
    /// It is a programmed element, moved and lengthened or shortened.
    Program,
    /// The control puts it in, to lead the nose around a corner.
    Compensation,
}

/// Why an element cannot be compensated; it is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompensationError {
    /// The element that is left out.
    pub id: u32,
    /// What is wrong with it.
    pub reason: Reason,
}

/// What is wrong with an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// Compensation starts or ends on an arc: PS0034.
    ArcAtSwitch,
    /// The offset paths of this element and the one before do not meet: PS0033.
    NoIntersection {
        /// The element before.
        before: u32,
    },
    /// The offset element would run against its programmed direction: a groove narrower than the nose, an
    /// element shorter than what the corners take away. PS0041.
    Overcut {
        /// How far it would run backwards, mm.
        backwards: f64,
    },
    /// The nose would cut into this element or the one or two before it: a valley whose sides touch, a gap
    /// narrower than the nose. PS0041.
    CutsIn {
        /// How deep, mm.
        depth: f64,
    },
    /// The start or the end of the arc is its centre: PS0038.
    ArcCenter,
    /// The nose does not fit inside the arc: PS0041.
    ArcRadius {
        /// Programmed radius, mm, where it is smaller.
        radius: f64,
    },
}

/// What becomes of an element.
pub type Outcome = Result<Compensated, CompensationError>;

/// Compensation in force: from G41 or G42 until G40.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensator {
    side: Side,
    nose: Nose,
    /// Where the tip stands after what was given out.
    tip: Point,
    stage: Stage,
    /// The cuts before the element that waits, the latest first, each joined to the next without a gap.
    behind: [Option<Cut>; 2],
}

/// A programmed cut with the way that the centre of the nose took along it and around the corner at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cut {
    element: Element,
    ways: [Option<Way>; 4],
}

/// How far compensation has come.
#[derive(Clone, Debug, PartialEq)]
enum Stage {
    /// Commanded, no move yet.
    Commanded,
    /// The start-up move, waiting for the next element.
    StartUp(Element),
    /// An element on the offset path, waiting for the next.
    Waiting(Waiting),
    /// Every element was given out; the nose stands beside the path.
    Standing,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Waiting {
    element: Element,
    /// The side when it was commanded.
    side: Side,
    begin: Begin,
}

/// Where the centre stands when an element begins: the vector from its programmed start, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    /// On the offset path of the element.
    OnPath(Vector),
    /// Wherever an earlier element left it, for the control had not seen this one.
    Beside,
}

impl Compensator {
    /// Compensation from the next move on, with the tip at `at`, on the programmed point. A negative radius
    /// is for the caller to turn into the other side.
    pub fn start(side: Side, nose: Nose, at: Point) -> Self {
        Self { side, nose, tip: at, stage: Stage::Commanded, behind: [None; 2] }
    }

    /// The same with the numbers of its elements counted from `first`.
    pub fn counted_from(mut self, first: u32) -> Self {
        match &mut self.stage {
            Stage::StartUp(element) | Stage::Waiting(Waiting { element, .. }) => {
                element.id = element.id.wrapping_sub(first);
            }
            Stage::Commanded | Stage::Standing => {}
        }
        for cut in self.behind.iter_mut().flatten() {
            cut.element.id = cut.element.id.wrapping_sub(first);
        }
        self
    }

    /// The side of the elements to come.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The nose in force.
    pub fn nose(&self) -> Nose {
        self.nose
    }

    /// Where the tip stands after the moves given out so far.
    pub fn tip(&self) -> Point {
        self.tip
    }

    /// The next programmed element. Gives out the one before, and the moves around the corner between them. A
    /// straight element without length is no move and is ignored.
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
        match std::mem::replace(&mut self.stage, Stage::Standing) {
            Stage::Commanded => self.stage = Stage::StartUp(element),
            Stage::StartUp(first) => {
                // Type A: perpendicular to the next element at its start (§4.2).
                let begin = next.start_normal() * self.nose.radius;
                self.give(&first, begin, Shape::Line, MadeBy::Program, out);
                self.wait(element, Begin::OnPath(begin));
            }
            Stage::Standing => self.enter(element, out),
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

    /// No further element is known: end of program, start of a cycle, two blocks without a move. The centre
    /// goes perpendicular to the end of the last element (§4.3); a later element begins from there.
    pub fn flush(&mut self, out: &mut impl FnMut(Outcome)) {
        match std::mem::replace(&mut self.stage, Stage::Standing) {
            Stage::Commanded => self.stage = Stage::Commanded,
            Stage::StartUp(first) => {
                let end = Track::new(&first, self.side).end_normal() * self.nose.radius;
                self.give(&first, end, Shape::Line, MadeBy::Program, out);
            }
            Stage::Waiting(waiting) => {
                let end = Track::new(&waiting.element, waiting.side).end_normal() * self.nose.radius;
                self.finish(&waiting, end, out);
            }
            Stage::Standing => {}
        }
        self.behind = [None; 2];
    }

    /// G41 for G42 or back without a G40: the elements to come have the nose on the other side. The last
    /// element keeps its own; the nose crosses the path between the two.
    pub fn change_side(&mut self, side: Side) {
        self.side = side;
    }

    /// G40: the last element ends with the centre perpendicular to its end; the move of the G40 block,
    /// if it has one, ends with the tip on the programmed point. Without one the tip stays beside the
    /// path until the next move. Where the block names a `wall` by its direction, radius and length in mm, the last element ends
    /// where its offset path meets that of the wall, which begins at its end (FANUC 16-TC B-61804E 15.3.4).
    pub fn cancel(mut self, element: Option<Element>, wall: Option<Point>, out: &mut impl FnMut(Outcome)) {
        if let (Some(wall), Stage::Waiting(waiting)) = (wall, &self.stage) {
            let (waiting, from) = (*waiting, waiting.element.to);
            let wall = Element { from, to: from.moved(wall), shape: Shape::Line, ..waiting.element };
            // I0 K0 names no direction.
            let track = (!wall.is_still()).then(|| Track::new(&wall, waiting.side));
            let meeting = track
                .and_then(|wall| corner(Track::new(&waiting.element, waiting.side), wall, self.nose.radius));
            if let Some(meeting) = meeting {
                self.stage = Stage::Standing;
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
                self.give(&element, beside, Shape::Line, MadeBy::Program, out);
            }
        }
    }

    /// Where the last element ends, if one waits.
    fn end(&self) -> Option<Point> {
        match &self.stage {
            Stage::StartUp(element) => Some(element.to),
            Stage::Waiting(waiting) => Some(waiting.element.to),
            Stage::Commanded | Stage::Standing => None,
        }
    }

    /// Whether an element can be compensated, whatever its neighbours are.
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

    /// Whether the nose, on its way along a waiting element and around the corner at its end, keeps clear of
    /// the next element, and on the way around of those before; whether the cut before keeps clear of the
    /// next. Rapids cut no contour, and a nose that changes its side crosses the path. The cut that the
    /// waiting element becomes, if it is one.
    fn clear_of(&self, waiting: &Waiting, corner: &Corner, next: &Element) -> Result<Option<Cut>, Reason> {
        let element = waiting.element;
        let cuts = element.travel == Travel::Feed && next.travel == Travel::Feed && waiting.side == self.side;
        let Some(along) = self.way_along(waiting, corner.end).filter(|_| cuts) else { return Ok(None) };
        let ends = [corner.end, corner.around[0], corner.around[1], corner.begin];
        let [end, first, second, last] = ends.map(|vector| vector.from(element.to));
        let around = [(end, first), (first, second), (second, last)]
            .map(|(from, to)| (!from.is_same(to)).then_some(Way::straight(from, to)));
        let before = self.behind.iter().flatten().take(1).flat_map(|cut| cut.ways).flatten();
        let beside = around.into_iter().flatten();
        let contour = [Some(element), self.behind[0].map(|cut| cut.element)];
        let radius = self.nose.radius;
        let opens = !self.closes(&element) && !self.closes(next) && !next.to.is_same(element.from);
        let into_next = before.chain([along]).filter(|_| opens).chain(beside.clone()).map(|way| (way, *next));
        let into_contour =
            beside.flat_map(|way| contour.into_iter().flatten().map(move |element| (way, element)));
        let depths =
            into_next.chain(into_contour).filter_map(|(way, element)| way.cuts_into(&element, radius));
        match depths.reduce(f64::max) {
            Some(depth) => Err(Reason::CutsIn { depth }),
            None => Ok(Some(Cut { element, ways: [Some(along), around[0], around[1], around[2]] })),
        }
    }

    /// Whether a contour ends with this element where it began. What leads to it and away from it lies beside
    /// both of its ends, and is no contour.
    fn closes(&self, element: &Element) -> bool {
        let begins = self.behind.iter().flatten().map(|cut| cut.element.from);
        begins.chain([element.from]).any(|begin| begin.is_same(element.to))
    }

    /// The way of the centre along a waiting element that ends at `end` from its programmed end; none for one
    /// that the control had not seen, or that would run backwards.
    fn way_along(&self, waiting: &Waiting, end: Vector) -> Option<Way> {
        let Waiting { element, side, begin: Begin::OnPath(begin) } = *waiting else { return None };
        let length = Track::new(&element, side).length_between(begin, end);
        let shape = if length > 2.0 * SAME { element.shape } else { Shape::Line };
        (length >= -SAME).then(|| Way { from: begin.from(element.from), to: end.from(element.to), shape })
    }

    /// Begins an element the control had not seen when the one before ended: a line goes straight from where
    /// the nose stands to its own end; to an arc a straight move leads.
    fn enter(&mut self, element: Element, out: &mut impl FnMut(Outcome)) {
        let stands = Vector::between(element.from, self.tip) + self.nose.offset();
        let begin = Track::new(&element, self.side).start_normal() * self.nose.radius;
        if (stands - begin).length() <= SAME {
            self.wait(element, Begin::OnPath(begin));
        } else if element.shape == Shape::Line {
            self.wait(element, Begin::Beside);
        } else {
            self.join(&element, begin, out);
            self.wait(element, Begin::OnPath(begin));
        }
    }

    /// Gives out a waiting element whose centre ends at `end` from its programmed end;
    /// returns whether it could.
    fn finish(&mut self, waiting: &Waiting, end: Vector, out: &mut impl FnMut(Outcome)) -> bool {
        let element = &waiting.element;
        let begin = match waiting.begin {
            Begin::OnPath(begin) => begin,
            Begin::Beside => {
                self.give(element, end, Shape::Line, MadeBy::Program, out);
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
        let way = self.way_along(waiting, end).filter(|_| cuts);
        let depths = contour.filter_map(|before| way?.cuts_into(&before, self.nose.radius));
        if let Some(depth) = depths.reduce(f64::max) {
            out(Err(CompensationError { id: element.id, reason: Reason::CutsIn { depth } }));
            return false;
        }
        let shape = match element.shape {
            Shape::Arc { center, turn } if length > 2.0 * SAME => {
                Shape::Arc { center: self.shown(center, ZERO), turn }
            }
            // An arc the corners take away whole has no length, and must not look like a full circle.
            Shape::Arc { .. } | Shape::Line => Shape::Line,
        };
        self.give(element, end, shape, MadeBy::Program, out);
        true
    }

    /// A straight move around the corner before `element`, if the tip does not stand there already.
    fn join(&mut self, element: &Element, joint: Vector, out: &mut impl FnMut(Outcome)) {
        let corner = Element { to: element.from, ..*element };
        if !self.shown(corner.to, joint).is_same(self.tip) {
            self.give(&corner, joint, Shape::Line, MadeBy::Compensation, out);
        }
    }

    /// Gives out a move that ends with the centre at `end` from the programmed end of `element`.
    fn give(
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

    /// The tip when the centre is at `vector` from a programmed point.
    fn shown(&self, programmed: Point, vector: Vector) -> Point {
        (vector - self.nose.offset()).from(programmed)
    }
}

/// A whole path at once: compensation starts with its first element, from the tip at `from`, and its last
/// element ends perpendicular. The first fault ends it.
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

/// An axis of a single cycle; compensation moves a cut along one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// G90: the cut lies deeper or less deep.
    X,
    /// G94: the cut lies further left or right.
    Z,
}

/// How far, mm, the tip path of a G90 or G94 cut from `from` to `to` is moved along an axis so that the nose
/// touches the programmed line (§4.4); 0 for a cylinder or face cut with the matching tip. `None` when the
/// line runs along that axis, or has no length.
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
