//! Pecking cycles: along Z with columns side by side in X (G74), and with the axes exchanged (G75).
//!
//! In: start point, end point, depth of a peck, distance of the columns. Out: the moves. The signs alone
//! determine the directions (seed 003; the steps of a column are those in GSK980TDb p. 119). Must not know
//! words: the units of P and Q are in `units`. Zero-length moves are kept: the code that stores motions drops
//! them.

use super::{Move, sign};
use crate::geometry::{Point, SAME};
use crate::motion::{MotionKind, Step};

/// Direction of the pecks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// G74: along Z; columns side by side in X.
    Face,
    /// G75: along X; columns side by side in Z.
    Radial,
}

impl Direction {
    /// The coordinates of a point or a displacement along the pecks and across them: X a radius, mm.
    pub fn along_and_across(self, point: Point) -> (f64, f64) {
        match self {
            Self::Face => (point.z, point.x),
            Self::Radial => (point.x, point.z),
        }
    }

    fn point(self, along: f64, across: f64) -> Point {
        match self {
            Self::Face => Point::new(across, along),
            Self::Radial => Point::new(along, across),
        }
    }
}

/// Whether the tool is relieved at the bottom of the first column: controls differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirstColumn {
    /// Like in every other column.
    WithRelief,
    /// No relief, as there is no space beside the column; nor in a single column.
    WithoutRelief,
}

/// The parameters in the two blocks of G74 or G75.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pecking {
    /// Bottom of the last column.
    pub end: Point,
    /// Depth of a peck, mm (X: radius), unsigned: Δk of G74, Δi of G75. `None` or zero: a single cut to the
    /// bottom, which some controls reject with PS0319.
    pub peck: Option<f64>,
    /// Distance of the columns, mm (X: radius), unsigned: Δi of G74, Δk of G75. Not needed for a single
    /// column.
    pub stepover: Option<f64>,
    /// e: retract after each peck, mm (X: radius); its sign is ignored.
    pub retract: f64,
    /// Δd: move sideways at the bottom, mm (X: radius), opposite to the direction of the columns. Signed for
    /// a single column: positive towards +X (G74) or +Z (G75). Zero for none.
    pub relief: f64,
    /// Whether the first column has a relief.
    pub first_column: FirstColumn,
}

/// Why there are no moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PeckingError {
    /// The relief is negative although the columns give its direction (PS0318).
    NegativeRelief,
    /// There are several columns but no distance (PS0319).
    NoStepover,
    /// The depth of a peck is negative (PS0320).
    NegativePeck,
    /// The distance of the columns is negative (PS0320).
    NegativeStepover,
    /// More moves than allowed.
    TooManyMoves,
}

/// Number of steps of at most `step` in `way`, at least one: the pecks of a column, or the columns after the
/// first. Both in mm, `step` positive; the result may be huge.
pub fn steps(way: f64, step: f64) -> f64 {
    ((way.abs() - SAME) / step).ceil().max(1.0)
}

/// G74 and G75: each column pecks down to the end, is relieved and returns; then a rapid to the next column,
/// and at last a rapid to the start point.
///
/// Every peck but the last ends at a multiple of its depth below the start, so feed moves after the first are
/// longer by the retract. The last peck ends exactly at the end point, and so does the last column.
pub fn peck(
    start: Point,
    direction: Direction,
    pecking: &Pecking,
    most_moves: usize,
) -> Result<Vec<Move>, PeckingError> {
    let (top, first) = direction.along_and_across(start);
    let (bottom, last) = direction.along_and_across(pecking.end);
    let (down, aside) = (sign(bottom - top), sign(last - first));
    let peck = given(pecking.peck, PeckingError::NegativePeck)?;
    let stepover = given(pecking.stepover, PeckingError::NegativeStepover)?;
    if aside != 0.0 && sign(pecking.relief) < 0.0 {
        return Err(PeckingError::NegativeRelief);
    }
    let pecks = peck.map_or(1.0, |peck| steps(bottom - top, peck));
    let (columns, stepover) = match stepover {
        _ if aside == 0.0 => (1.0, 0.0),
        Some(stepover) => (1.0 + steps(last - first, stepover), stepover),
        None => return Err(PeckingError::NoStepover),
    };
    // For each column: its pecks with retracts, the relief, the return, and the move to the column or to the
    // start point.
    let moves = columns * (2.0 * pecks + 2.0);
    if moves > most_moves as f64 {
        return Err(PeckingError::TooManyMoves);
    }
    let (pecks, columns) = (pecks as u32, columns as u32);
    let peck = peck.unwrap_or(0.0);
    let relief = if aside == 0.0 { pecking.relief } else { -aside * pecking.relief };

    let mut out = Vec::with_capacity(moves as usize);
    for column in 0..columns {
        let pass = column + 1;
        let across = match column {
            0 => first,
            _ if pass == columns => last,
            _ => first + aside * stepover * f64::from(column),
        };
        let mut push = |kind, step, along, across| {
            out.push(Move::new(kind, step, pass, direction.point(along, across)));
        };
        if column > 0 {
            push(MotionKind::Rapid, Step::Stepover, top, across);
        }
        for number in 1..pecks {
            let depth = top + down * peck * f64::from(number);
            push(MotionKind::Feed, Step::Cut, depth, across);
            push(MotionKind::Rapid, Step::Retract, depth - down * pecking.retract.abs(), across);
        }
        push(MotionKind::Feed, Step::Cut, bottom, across);
        let aside_now = match pecking.first_column {
            FirstColumn::WithoutRelief if column == 0 => across,
            FirstColumn::WithRelief | FirstColumn::WithoutRelief => across + relief,
        };
        if aside_now != across {
            push(MotionKind::Rapid, Step::Relief, bottom, aside_now);
        }
        push(MotionKind::Rapid, Step::Return, top, aside_now);
    }
    out.push(Move::new(MotionKind::Rapid, Step::Return, 0, start));
    Ok(out)
}

/// A length that must not be negative; zero counts as missing.
fn given(length: Option<f64>, negative: PeckingError) -> Result<Option<f64>, PeckingError> {
    match length {
        Some(length) if sign(length) < 0.0 => Err(negative),
        Some(length) if sign(length) > 0.0 => Ok(Some(length)),
        _ => Ok(None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::listing::{MANY, Map, at, check};

    /// The groove of seed 003, example 5.
    fn groove() -> Pecking {
        Pecking {
            end: at(30.0, 10.0),
            peck: Some(3.0),
            stepover: Some(2.9),
            retract: 1.0,
            relief: 0.0,
            first_column: FirstColumn::WithRelief,
        }
    }

    #[test]
    fn seed_003_example_4_drills() {
        let start = at(0.0, 2.0);
        let drill = Pecking { end: at(0.0, -12.0), peck: Some(5.0), stepover: None, ..groove() };
        let moves = peck(start, Direction::Face, &drill, MANY).unwrap();
        check(start, &moves, "#1 F(0,-3) R(0,-2) F(0,-8) R(0,-7) F(0,-12) R(0,2)");
    }

    #[test]
    fn seed_003_example_5_grooves() {
        let start = at(42.0, 22.0);
        let moves = peck(start, Direction::Radial, &groove(), MANY).unwrap();
        check(
            start,
            &moves,
            "
            #1 F(36,22) R(38,22) F(30,22) R(42,22)
            #2 R(42,19.1) F(36,19.1) R(38,19.1) F(30,19.1) R(42,19.1)
            #3 R(42,16.2) F(36,16.2) R(38,16.2) F(30,16.2) R(42,16.2)
            #4 R(42,13.3) F(36,13.3) R(38,13.3) F(30,13.3) R(42,13.3)
            #5 R(42,10.4) F(36,10.4) R(38,10.4) F(30,10.4) R(42,10.4)
            #6 R(42,10) F(36,10) R(38,10) F(30,10) R(42,10)
            #0 R(42,22)
            ",
        );
        let steps: Vec<Step> = moves[4..9].iter().map(|step| step.step).collect();
        assert_eq!(steps, [Step::Stepover, Step::Cut, Step::Retract, Step::Cut, Step::Return]);
    }

    #[test]
    fn relief_goes_against_the_columns() {
        let start = at(20.0, 1.0);
        let face =
            Pecking { end: at(10.0, -4.0), peck: Some(5.0), stepover: Some(3.0), relief: 0.5, ..groove() };
        let moves = peck(start, Direction::Face, &face, MANY).unwrap();
        check(
            start,
            &moves,
            "
            #1 F(20,-4) R(21,-4) R(21,1)
            #2 R(14,1) F(14,-4) R(15,-4) R(15,1)
            #3 R(10,1) F(10,-4) R(11,-4) R(11,1)
            #0 R(20,1)
            ",
        );
        let face = Pecking { first_column: FirstColumn::WithoutRelief, ..face };
        let moves = peck(start, Direction::Face, &face, MANY).unwrap();
        check(
            start,
            &moves,
            "
            #1 F(20,-4) R(20,1)
            #2 R(14,1) F(14,-4) R(15,-4) R(15,1)
            #3 R(10,1) F(10,-4) R(11,-4) R(11,1)
            #0 R(20,1)
            ",
        );
    }

    #[test]
    fn a_single_column_is_relieved_as_signed() {
        let start = at(20.0, 1.0);
        for (relief, expected) in [
            (-0.5, "#1 F(10,1) R(10,0.5) R(20,0.5)\n#0 R(20,1)"),
            (0.5, "#1 F(10,1) R(10,1.5) R(20,1.5)\n#0 R(20,1)"),
        ] {
            let single = Pecking { end: at(10.0, 1.0), peck: Some(9.0), stepover: None, relief, ..groove() };
            check(start, &peck(start, Direction::Radial, &single, MANY).unwrap(), expected);
        }
    }

    #[test]
    fn without_a_peck_the_cut_goes_down_in_one() {
        let start = at(0.0, 2.0);
        for depth in [None, Some(0.0), Some(14.0), Some(1e9)] {
            let drill = Pecking { end: at(0.0, -12.0), peck: depth, stepover: None, ..groove() };
            check(start, &peck(start, Direction::Face, &drill, MANY).unwrap(), "#1 F(0,-12) R(0,2)");
        }
    }

    #[test]
    fn pecked_drilling_ends_where_straight_drilling_ends() {
        let deepest = |moves: &[Move]| moves.iter().map(|step| step.to.z).fold(f64::INFINITY, f64::min);
        for depth in 1..400 {
            let drill = Pecking {
                end: at(0.0, -12.3),
                peck: Some(f64::from(depth) * 0.1),
                stepover: None,
                ..groove()
            };
            let moves = peck(at(0.0, 2.0), Direction::Face, &drill, MANY).unwrap();
            assert_eq!(deepest(&moves), -12.3);
            let cuts: Vec<f64> =
                moves.iter().filter(|step| step.step == Step::Cut).map(|step| step.to.z).collect();
            assert!(cuts.windows(2).all(|pair| pair[1] < pair[0] - SAME), "{depth}: {cuts:?}");
            assert_eq!(moves.last().unwrap().to, at(0.0, 2.0));
        }
    }

    #[test]
    fn columns_are_no_farther_apart_than_told_and_the_last_is_at_the_end() {
        for stepover in 1..150 {
            let wide = Pecking { stepover: Some(f64::from(stepover) * 0.1), ..groove() };
            let moves = peck(at(42.0, 22.0), Direction::Radial, &wide, MANY).unwrap();
            let mut columns: Vec<f64> =
                moves.iter().filter(|step| step.step == Step::Cut).map(|step| step.to.z).collect();
            columns.dedup();
            assert_eq!((columns[0], *columns.last().unwrap()), (22.0, 10.0));
            for pair in columns.windows(2) {
                let apart = pair[0] - pair[1];
                assert!(apart > SAME && apart <= f64::from(stepover) * 0.1 + SAME, "{columns:?}");
            }
        }
    }

    #[test]
    fn mirrored_and_exchanged_cycles_make_mirrored_and_exchanged_moves() {
        let (start, plain) = (Point::new(21.0, 22.0), Pecking { relief: 0.3, ..groove() });
        let moves = peck(start, Direction::Radial, &plain, MANY).unwrap();
        let maps: [(Map, Direction); 4] = [
            (|point| Point::new(-point.x, point.z), Direction::Radial),
            (|point| Point::new(point.x, -point.z), Direction::Radial),
            (|point| Point::new(-point.x, -point.z), Direction::Radial),
            (|point| Point::new(point.z, point.x), Direction::Face),
        ];
        for (map, direction) in maps {
            let mirrored = Pecking { end: map(plain.end), ..plain };
            let others = peck(map(start), direction, &mirrored, MANY).unwrap();
            assert_eq!(moves.len(), others.len());
            for (plain, other) in moves.iter().zip(&others) {
                assert_eq!(Move { to: map(plain.to), ..*plain }, *other);
            }
        }
    }

    #[test]
    fn faults() {
        let with = |pecking: Pecking| peck(at(42.0, 22.0), Direction::Radial, &pecking, MANY).unwrap_err();
        assert_eq!(with(Pecking { relief: -0.1, ..groove() }), PeckingError::NegativeRelief);
        assert_eq!(with(Pecking { stepover: None, ..groove() }), PeckingError::NoStepover);
        assert_eq!(with(Pecking { stepover: Some(0.0), ..groove() }), PeckingError::NoStepover);
        assert_eq!(with(Pecking { peck: Some(-3.0), ..groove() }), PeckingError::NegativePeck);
        assert_eq!(with(Pecking { stepover: Some(-2.9), ..groove() }), PeckingError::NegativeStepover);
    }

    #[test]
    fn too_many_moves_answer_at_once() {
        for (end, depth) in [(at(-2e9, -2e9), 0.001), (at(-1e300, 10.0), 1e-5)] {
            let deep = Pecking { end, peck: Some(depth), stepover: Some(0.001), ..groove() };
            let fault = peck(at(42.0, 22.0), Direction::Radial, &deep, MANY).unwrap_err();
            assert_eq!(fault, PeckingError::TooManyMoves);
        }
        // The limit counts a relief in each column.
        assert!(peck(at(42.0, 22.0), Direction::Radial, &groove(), 36).is_ok());
        let fault = peck(at(42.0, 22.0), Direction::Radial, &groove(), 35).unwrap_err();
        assert_eq!(fault, PeckingError::TooManyMoves);
    }
}
