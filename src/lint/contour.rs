//! Contours of the multiple cycles: where they begin and end, and what is left.

use crate::cycles::Contour;
use crate::geometry::Point;
use crate::message::Message;
use crate::motion::Motion;
use crate::setup::Stock;

/// Lengths this near are the same, mm.
const NEAR: f64 = 0.001;
/// A pass of G73 deeper than this is too deep, mm: twice the usual 3 mm of roughing.
const DEEP: f64 = 6.0;

/// Remarks about the contour of G71 (`turning`) or G72. `both`: its first block names both axes.
pub fn remarks(
    code: &'static str,
    turning: bool,
    contour: &Contour,
    both: bool,
    stock: Option<Stock>,
) -> Vec<Message> {
    let (start, first, last) = (contour.start, contour.first, contour.last());
    let mut told = Vec::new();
    let (axis, own, other) =
        if turning { ('Z', start.z, first.z) } else { ('X', 2.0 * start.x, 2.0 * first.x) };
    if both && (own - other).abs() > NEAR {
        told.push(Message::ContourStartMoved { code, axis, start: own, first: other });
    }
    if let Some(stock) = stock.filter(|_| turning) {
        let outside = first.x < start.x;
        let end = 2.0 * last.x;
        if outside && start.x * 2.0 >= stock.diameter.mm() - NEAR && end < stock.diameter.mm() - NEAR {
            told.push(Message::ContourNotClosed { x: end, diameter: stock.diameter.mm() });
        }
    }
    told
}

/// Allowances of G73 (radius and length, mm) that point into the part: axis and address.
pub fn allowance_into_part(contour: &Contour, allowance: Point) -> Vec<(char, u8)> {
    let way = |from: f64, to: f64| if (to - from).abs() <= NEAR { 0.0 } else { (to - from).signum() };
    // From the start point into the part: across to where the contour begins, along to where it ends.
    let inward = Point::new(way(contour.start.x, contour.first.x), way(contour.start.z, contour.last().z));
    let mut told = Vec::new();
    if allowance.x * inward.x > NEAR {
        told.push(('U', b'U'));
    }
    if allowance.z * inward.z > NEAR {
        told.push(('W', b'W'));
    }
    told
}

/// The radius that cuts before have left of the bar all along a contour, mm; `None` where none has.
pub fn turned_before(contour: &Contour, stock: Stock, cuts: impl Iterator<Item = Motion>) -> Option<f64> {
    let along = |motion: &Motion| motion.kind.cuts() && (motion.to.x - motion.from.x).abs() <= NEAR;
    let places = || contour.pieces.iter().flat_map(|piece| [piece.from.z, piece.to.z]);
    let front = places().fold(contour.first.z, f64::max).min(stock.face);
    let back = places().fold(contour.first.z, f64::min);
    let covers = |motion: &Motion| {
        let (one, other) = (motion.from.z, motion.to.z);
        one.max(other) >= front - NEAR && one.min(other) <= back + NEAR
    };
    // A bore leaves the outside as it is.
    let start = contour.start.x.min(stock.diameter.radius());
    let outside = |motion: &Motion| motion.to.x > start / 2.0;
    cuts.filter(|cut| along(cut) && covers(cut) && outside(cut)).map(|cut| cut.to.x).reduce(f64::min)
}

/// Remarks about G73 in a bar: `relief` is the radius by which its first pass stands off, mm; `turned` the radius that cuts
/// before have left, if any.
pub fn pattern_remarks(
    contour: &Contour,
    relief: f64,
    stock: Option<Stock>,
    turned: impl FnOnce(Stock) -> Option<f64>,
) -> Option<Message> {
    let stock = stock?;
    let radius = stock.diameter.radius();
    if contour.first.x >= contour.start.x {
        return None;
    }
    let low = contour.pieces.iter().map(|piece| piece.to.x).fold(contour.first.x, f64::min);
    let mut depth = radius - (low + relief);
    if depth > DEEP {
        depth = turned(stock).map_or(radius, |turned| turned.min(radius)) - (low + relief);
    }
    if depth > DEEP {
        return Some(Message::PatternShallow { depth, relief });
    }
    let cutting = contour.pieces.iter().filter(|piece| piece.from.z < stock.face || piece.to.z < stock.face);
    let (mut whole, mut air) = (0.0, 0.0);
    for piece in cutting {
        let length = piece.from.distance(piece.to);
        let middle = (piece.from.x + piece.to.x) / 2.0 + relief;
        whole += length;
        air += if middle >= radius { length } else { 0.0 };
    }
    let share = (100.0 * air / whole).round();
    // Who stands off by no more than there is to remove means the whole of it.
    let needed = radius - low;
    (whole > 0.0 && share > 50.0 && relief > needed + NEAR).then_some(Message::PatternAir { share })
}
