//! Lints for tapers cut with G90 and G94.
//!
//! The first move of these cycles is a rapid, so the start point is outside the blank and the cut begins
//! before the cone of the drawing. R must be extended in proportion (seeds 001 and 004).

use crate::control::events::EventContext;
use crate::control::words::{Words, with_other_sign};
use crate::cycles::single::{self, Single, Work};
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::setup::Stock;
use crate::source::Span;
use crate::units::{Diameter, Unit};

/// Greatest distance of a cut beyond the back of the blank, mm.
const MAX_OVERRUN: f64 = 5.0;

/// A span longer than this, bytes, is a block and not the word of a taper.
const MAX_WORD_BYTES: usize = 12;

/// A start at most this far from the surface of a bar, mm (radius), belongs to outside work.
const NEAR_SURFACE: f64 = 10.0;

/// Lengths that differ by at most this are equal, mm.
const LENGTH_TOLERANCE: f64 = 0.001;

/// The possible meanings of an R that makes the cone a round number at the surface of the blank, but not
/// where the cut leaves the blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reading {
    /// The height of the cone on the drawing, not extended to the start point: the other numbers appear on no
    /// drawing.
    HeightOnDrawing,
    /// The same, or an R that was computed for the start point: the cone is a usual one, or its edge could be
    /// dimensioned.
    OrForStartPoint,
}

/// Reports a taper that looks like that of the drawing although the cut begins outside the blank. `span` is
/// its word, or the block if the taper is modal.
pub fn not_extended(
    cycle: Single,
    start: Point,
    end: Point,
    taper: f64,
    span: Span,
    at: &EventContext,
) -> Option<Diagnostic> {
    let (message, reading) = taper_not_extended(cycle, start, end, taper, at.bar()?)?;
    let needed = message.needed;
    let diagnostic = Diagnostic::new(message, span);
    if reading == Reading::OrForStartPoint {
        return Some(diagnostic.with_severity(Severity::Info));
    }
    if at.state.unit != Unit::Millimetre || span.len() >= MAX_WORD_BYTES {
        return Some(diagnostic);
    }
    let needed = crate::units::number((1000.0 * needed).round() / 1000.0);
    Some(diagnostic.with(Fix::write(span, format!("R{needed}"))))
}

/// Returns the message if R looks like the taper of the drawing although the cut begins outside the blank,
/// and how certain that is.
fn taper_not_extended(
    cycle: Single,
    start: Point,
    end: Point,
    taper: f64,
    stock: Stock,
) -> Option<(said::TaperNotExtended, Reading)> {
    if taper == 0.0 {
        return None;
    }
    // `wanted`: start of the cut; `part`: share of the cut between its end and the surface of the blank.
    let (wanted, part, scale, base, axis) = match cycle.work() {
        Work::Facing => {
            let surface = stock.diameter.radius();
            if start.x <= surface + LENGTH_TOLERANCE || end.x >= surface - LENGTH_TOLERANCE {
                return None;
            }
            (end.z + taper, (surface - end.x) / (start.x - end.x), 1.0, end.z, 'Z')
        }
        Work::Turning => {
            // A Z with a digit too many is reported separately: the taper is a consequence.
            let is_beyond = end.z < stock.back() - MAX_OVERRUN;
            if start.z <= stock.face + LENGTH_TOLERANCE || end.z >= stock.face - LENGTH_TOLERANCE || is_beyond
            {
                return None;
            }
            let diameter = |radius: f64| Diameter::from_radius(radius).mm();
            let part = (stock.face - end.z) / (start.z - end.z);
            (diameter(end.x + taper), part, diameter(1.0), diameter(end.x), 'X')
        }
        Work::Threading => return None,
    };
    let crossing = base + scale * taper * part;
    // The drawing may count from Z0 although the blank is slightly longer.
    let at_zero = match cycle.work() {
        Work::Turning if start.z > 0.0 && end.z < 0.0 => {
            Some(base + scale * taper * (-end.z / (start.z - end.z)))
        }
        _ => None,
    };
    let fits_drawing = is_tenth(crossing) || at_zero.is_some_and(is_tenth);
    let coarse = is_round(wanted) && !is_round(crossing);
    let fine = is_tenth(wanted) && !fits_drawing;
    let (height, length) = match cycle.work() {
        Work::Facing => (end.x - start.x, taper),
        Work::Turning | Work::Threading => (taper, end.z - start.z),
    };
    let other = is_hundredth(crossing) || is_usual_cone((height / length).abs());
    let reading = if other { Reading::OrForStartPoint } else { Reading::HeightOnDrawing };
    let diagnostic = said::TaperNotExtended { taper, needed: taper / part, crossing, wanted, axis };
    (coarse && !at_zero.is_some_and(is_round) || fine).then_some((diagnostic, reading))
}

/// Whether a drawing may state a cone by its slope (radius over length): a usual 1:n in the diameter (ISO
/// 1119), or a half or whole degree to the axis. R has three decimals, so the slope is as exact.
fn is_usual_cone(slope: f64) -> bool {
    const RATIOS: [f64; 13] = [3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 15.0, 16.0, 20.0, 30.0, 50.0];
    const DIGITS: f64 = 5e-4;
    let ratio = 1.0 / (2.0 * slope);
    let near = |value: f64, to: f64| (value - to).abs() <= DIGITS * to.max(1.0);
    let by_ratio = RATIOS.into_iter().any(|usual| near(ratio, usual));
    let degrees = slope.atan().to_degrees();
    by_ratio || near(2.0 * degrees, (2.0 * degrees).round())
}

/// Whether a drawing may contain this length at all: a multiple of a hundredth of a millimetre.
fn is_hundredth(length: f64) -> bool {
    (length * 100.0 - (length * 100.0).round()).abs() <= 0.01
}

/// Reports a taper with an odd shape: see [`odd_shape`].
pub fn shape(
    cycle: Single,
    start: Point,
    end: Point,
    taper: f64,
    words: &Words,
    address: u8,
    at: &EventContext,
) -> Option<Diagnostic> {
    let (word, span) = (words.quote(at.text, address), words.span(address));
    let message = odd_shape(cycle, start, end, taper, &word, at.bar())?;
    let fix = message.is::<said::TaperNarrows>().then(|| Fix::write(span, with_other_sign(&word)));
    Some(Diagnostic { fixes: fix.into_iter().collect(), ..Diagnostic::new(message, span) })
}

/// The odd shape of a taper (R and ends as radii and lengths, mm): it begins beyond the axis, or becomes
/// narrower towards the chuck, as only an undercut does.
fn odd_shape(
    cycle: Single,
    start: Point,
    end: Point,
    taper: f64,
    word: &str,
    stock: Option<Stock>,
) -> Option<Message> {
    if cycle.work() == Work::Facing || taper == 0.0 || end.z >= start.z {
        return None;
    }
    // A cut that begins beyond the start point is reported elsewhere.
    if single::begins_beyond_start(end.x - start.x, taper) {
        return None;
    }
    let begin = end.x + taper;
    if begin < -LENGTH_TOLERANCE && end.x > 0.0 {
        return Some(
            said::TaperCrossesAxis { word: word.into(), x: Diameter::from_radius(begin).mm() }.into(),
        );
    }
    let way = end.x - start.x;
    let outside = match way {
        way if way < -LENGTH_TOLERANCE => true,
        way if way > LENGTH_TOLERANCE => false,
        // The end has the diameter of the start: outside work if that is at the surface of a bar.
        _ if stock.is_some_and(|stock| {
            start.x > stock.bore.radius() + LENGTH_TOLERANCE
                && start.x >= stock.diameter.radius() - NEAR_SURFACE
        }) =>
        {
            true
        }
        _ => return None,
    };
    let narrows = if outside { taper > LENGTH_TOLERANCE } else { taper < -LENGTH_TOLERANCE };
    narrows.then(|| said::TaperNarrows { word: word.into() }.into())
}

/// Whether a drawing might contain this length: a multiple of a tenth of a millimetre.
fn is_tenth(length: f64) -> bool {
    (length * 10.0 - (length * 10.0).round()).abs() <= 10.0 * LENGTH_TOLERANCE
}

/// Whether a drawing would contain this length: a multiple of half a millimetre.
fn is_round(length: f64) -> bool {
    (length * 2.0 - (length * 2.0).round()).abs() <= 2.0 * LENGTH_TOLERANCE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Diameter;

    const STOCK: Stock = Stock {
        diameter: Diameter::new(50.0),
        bore: Diameter::new(0.0),
        face: 0.0,
        length: 60.0,
        grip: None,
    };

    #[test]
    fn seed_004_needs_r_minus_24_from_x54() {
        let (start, end) = (Point::new(27.0, 5.0), Point::new(15.0, 0.0));
        let Some((said::TaperNotExtended { needed, crossing, wanted, .. }, Reading::HeightOnDrawing)) =
            taper_not_extended(Single::Facing, start, end, -20.0, STOCK)
        else {
            panic!("R-20 from X54 must be diagnostic")
        };
        assert!((needed + 24.0).abs() < 1e-9 && (crossing + 16.6667).abs() < 1e-3 && wanted == -20.0);
        assert_eq!(taper_not_extended(Single::Facing, start, end, -24.0, STOCK), None);
    }

    #[test]
    fn a_usual_cone_may_have_been_worked_out_for_the_start_point() {
        // 1:5 over 23 mm, computed for the start point: X46 at the face.
        let reading = |taper: f64, from: f64| {
            let (start, end) = (Point::new(30.0, from), Point::new(25.0, -20.0));
            taper_not_extended(Single::Turning, start, end, taper, STOCK).map(|diagnostic| diagnostic.1)
        };
        assert_eq!(reading(-2.3, 3.0), None);
        // 1:5 over 25 mm, round at both ends only for the start point.
        assert_eq!(reading(-2.5, 5.0), None);
        assert_eq!(reading(-3.0, 2.0), Some(Reading::HeightOnDrawing));
        // The edge at X45.2 could be dimensioned.
        assert_eq!(reading(-3.0, 5.0), Some(Reading::OrForStartPoint));
        // 2 mm in the diameter over 24 mm are 1:12.
        assert_eq!(reading(-1.0, 4.0), Some(Reading::OrForStartPoint));
    }

    #[test]
    fn a_start_at_the_blank_needs_no_extension() {
        let (start, end) = (Point::new(25.0, 5.0), Point::new(15.0, 0.0));
        assert_eq!(taper_not_extended(Single::Facing, start, end, -20.0, STOCK), None);
    }
}
