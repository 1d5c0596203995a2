//! The intended differences between the playground and LinuxCNC, with their reasons and with the rules that
//! distinguish them from bugs. Any other difference is a bug in one of the two.

use gcode_playground::message::{Message, Value, said};

use crate::contour::{Corner, InContour};
use crate::motion::Refusal;
use crate::program::Block;

/// An intended difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum KnownDifference {
    /// An arc whose end is slightly off the circle.
    ArcEnd,
    /// R slightly too small.
    ArcRadius,
    /// R with the same start and end point.
    ArcNowhere,
    /// R with I or K.
    RadiusAndCenter,
    /// F kept when its unit is programmed again.
    FeedKept,
    /// How compensation begins.
    StartUp,
    /// The path around an outer corner.
    OuterCorner,
    /// A corner of less than 0.05 rad.
    NearlyStraight,
    /// A corner of more than π − 0.05 rad.
    StraightBack,
    /// A short entry into compensation.
    ShortEntry,
    /// A full circle under compensation.
    CompensatedCircle,
    /// Offset paths that only touch, and elements of which nothing is left.
    ExactFit,
    /// An element too short for the nose that LinuxCNC does not detect.
    OvercutUnseen,
}

impl KnownDifference {
    /// All known differences, in the order of the table.
    pub const ALL: [Self; 13] = [
        Self::ArcEnd,
        Self::ArcRadius,
        Self::ArcNowhere,
        Self::RadiusAndCenter,
        Self::FeedKept,
        Self::StartUp,
        Self::OuterCorner,
        Self::NearlyStraight,
        Self::StraightBack,
        Self::ShortEntry,
        Self::CompensatedCircle,
        Self::ExactFit,
        Self::OvercutUnseen,
    ];

    /// Its name in the table.
    pub fn name(self) -> &'static str {
        match self {
            Self::ArcEnd => "arc end off the circle",
            Self::ArcRadius => "arc radius too small",
            Self::ArcNowhere => "R arc to where it starts",
            Self::RadiusAndCenter => "R with I or K",
            Self::FeedKept => "feed kept at G98 or G99",
            Self::StartUp => "start of compensation",
            Self::OuterCorner => "outer corner",
            Self::NearlyStraight => "nearly straight corner",
            Self::StraightBack => "straight back",
            Self::ShortEntry => "short entry",
            Self::CompensatedCircle => "circle before a corner",
            Self::ExactFit => "exact fit",
            Self::OvercutUnseen => "overcut not seen",
        }
    }

    /// What each side does, and why.
    pub fn explanation(self) -> &'static str {
        match self {
            Self::ArcEnd => {
                "ours refuses an end that is off by more than 0.01 mm (parameter 3410); LinuxCNC one that is off by \
                 more than 0.028 mm (0.0028 inch) and by more than a thousandth of the radius"
            }
            Self::ArcRadius => {
                "ours draws a half circle where R is too small by up to 0.01 mm; LinuxCNC up to 0.00127 mm"
            }
            Self::ArcNowhere => {
                "ours makes no motion and warns, as FANUC does; LinuxCNC stops, or draws a full circle where the two places \
 differ by binary rounding"
            }
            Self::RadiusAndCenter => "R overrides I and K on FANUC; LinuxCNC stops",
            Self::FeedKept => {
                "ours keeps F, and warns where its unit changes; LinuxCNC sets it to 0 at every G94 and G95 and stops at the \
                 next cut"
            }
            Self::StartUp => {
                "ours ends the entry move perpendicular to the next element (type A); LinuxCNC perpendicular to the \
                 entry move itself, then treats what follows as a corner"
            }
            Self::OuterCorner => {
                "ours goes on to where the offset paths meet (FANUC); LinuxCNC rolls around the corner on an arc; \
                 the elements themselves are compared"
            }
            Self::NearlyStraight => {
                "LinuxCNC takes a corner of less than 0.05 rad as none and goes straight between perpendicular points"
            }
            Self::StraightBack => {
                "where the path turns back, but for 0.05 rad, LinuxCNC may go around the other side, or finds no \
                 room; ours goes around or, if it is an inner corner, finds none"
            }
            Self::ShortEntry => "LinuxCNC wants an entry move longer than the nose radius; ours any length",
            Self::CompensatedCircle => {
                "under compensation LinuxCNC may take a full circle before a corner for an arc of no length, and stops"
            }
            Self::ExactFit => {
                "where offset paths at an inner corner only just touch, or corners take away just the whole of an element, \
                 ours goes on; in LinuxCNC binary rounding decides"
            }
            Self::OvercutUnseen => {
                "an element too short for the nose: ours raises PS0041; LinuxCNC looks only at an inner corner, before a \
                 straight element around an outer one and at G40, and else cuts it backwards"
            }
        }
    }
}

/// The facts about an error that only one side reports.
pub struct Refused<'a> {
    /// The block with the error.
    pub block: Block,
    /// Its position in a contour under compensation.
    pub contour: Option<InContour>,
    /// Smallest tolerance of LinuxCNC for arc ends in the active unit, mm.
    pub arc_end_tolerance: f64,
    /// Whether G98 or G99 came without F, and no F since.
    pub feed_unsaid: bool,
    /// Slugs of our warnings at the block.
    pub remarks: &'a [&'static str],
}

/// The known difference, if ours reports an error and LinuxCNC does not.
pub fn refused_by_ours(refusal: &Refusal, refused: &Refused) -> Option<KnownDifference> {
    let message = &refusal.message;
    if message.is::<said::ArcEndOffCircle>() {
        let (start, end) = (length(message, "start_radius")?, length(message, "end_radius")?);
        let allowed = refused.arc_end_tolerance.max(start.max(end) * 0.001);
        return (start > 0.001 && end > 0.001 && (start - end).abs() <= allowed + 1e-6)
            .then_some(KnownDifference::ArcEnd);
    }
    let overcut = message.is::<said::CompensationOvercut>();
    if !overcut && !message.is::<said::CompensationNoIntersection>() {
        return None;
    }
    let at = refused.contour?;
    if at.before == Corner::Back || at.after == Corner::Back {
        return Some(KnownDifference::StraightBack);
    }
    let unseen = match at.after {
        Corner::Straight | Corner::Near | Corner::Outer => true,
        Corner::Open => at.unfinished,
        Corner::Inner | Corner::Back => false,
    };
    (overcut && at.before == Corner::Inner && unseen).then_some(KnownDifference::OvercutUnseen)
}

/// A length argument of a message, mm.
fn length(message: &Message, name: &str) -> Option<f64> {
    message.arguments().into_iter().find_map(|(own, value)| match value {
        Value::Length(length) | Value::Number(length) if own == name => Some(length),
        _ => None,
    })
}

/// The known difference, if LinuxCNC reports an error and ours does not.
pub fn refused_by_linuxcnc(message: &str, refused: &Refused) -> Option<KnownDifference> {
    let center = match refused.block {
        Block::Arc { center, .. } => Some(center),
        _ => None,
    };
    let says = |part: &str| message.to_lowercase().contains(part);
    if says("zero feed rate") && refused.feed_unsaid {
        return Some(KnownDifference::FeedKept);
    }
    if says("entry move is not greater than the tool radius") {
        return Some(KnownDifference::ShortEntry);
    }
    if says("gouging") {
        return gouging(refused.contour?);
    }
    let center = center?;
    if says("mixed radius") && center.r.is_some() && (center.i.is_some() || center.k.is_some()) {
        Some(KnownDifference::RadiusAndCenter)
    } else if center.r.is_some() && refused.remarks.contains(&"arc-without-way") {
        Some(KnownDifference::ArcNowhere)
    } else if says("radius too small") && center.r.is_some() {
        // If R is too small by more than 0.01 mm, ours reports an error as well.
        Some(KnownDifference::ArcRadius)
    } else {
        None
    }
}

/// The known difference, if only LinuxCNC finds no room for the nose.
fn gouging(at: InContour) -> Option<KnownDifference> {
    let corners = [at.last_but_one, at.before];
    if at.index <= 2 && at.entry != Corner::Straight {
        // The element after the entry begins at another point, and the rest of it may be too short for the
        // next corner.
        Some(KnownDifference::StartUp)
    } else if at.after_circle {
        Some(KnownDifference::CompensatedCircle)
    } else if corners.contains(&Corner::Back) {
        Some(KnownDifference::StraightBack)
    } else if at.fits_exactly && matches!(at.before, Corner::Inner | Corner::Open) {
        Some(KnownDifference::ExactFit)
    } else if corners.contains(&Corner::Near) {
        // The element turns slightly too far between its perpendicular points.
        Some(KnownDifference::NearlyStraight)
    } else if corners.contains(&Corner::Outer) && corners.contains(&Corner::Inner) {
        // Ours extends the previous element to the intersection of the offset paths at its outer corner, so
        // enough of it remains after the inner corner shortens it.
        Some(KnownDifference::OuterCorner)
    } else {
        None
    }
}
