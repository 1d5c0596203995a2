//! The formulas of the calculators.
//!
//! In: values in millimetres, in the order of the fields. Out: results, or the field with the wrong value. Formulas and
//! worked numbers: FANUC B-64304, GSK 980TD, ISO 68-1.

use std::f64::consts::PI;

use crate::threads::Thread;

use super::Quantity::{
    CuttingSpeed, Degrees, Diameter, Length, Number, PerTurn, Roughness, Speed, ThreadName,
};
use crate::control::codes::cycles::CycleBlock;
use crate::cycles::threading;

use super::{Block, Calculator, Fault, Field, Formula, Outcome, Quantity, Word, WordValue, Wrong, programs};

/// Most passes in a table.
const MAX_PASSES: usize = 200;

const fn field(name: &'static str, quantity: Quantity, example: f64) -> Field {
    Field { name, quantity, example }
}

/// All calculators.
pub const ALL: &[Calculator] = &[
    Calculator {
        name: "cone",
        fields: &[field("D", Diameter, 50.0), field("d", Diameter, 46.0), field("L", Length, 20.0)],
        formula: Formula::Numbers(cone),
        program: programs::cone,
    },
    Calculator {
        name: "r-of-g90",
        fields: &[
            field("x1", Diameter, 20.0),
            field("z1", Length, 0.0),
            field("Xe", Diameter, 40.0),
            field("Ze", Length, -25.0),
            field("Za", Length, 2.0),
        ],
        formula: Formula::Numbers(r_of_g90),
        program: programs::r_of_g90,
    },
    Calculator {
        name: "r-of-g94",
        fields: &[
            field("x1", Diameter, 50.0),
            field("z1", Length, -20.0),
            field("Xe", Diameter, 30.0),
            field("Ze", Length, 0.0),
            field("Xa", Diameter, 54.0),
        ],
        formula: Formula::Numbers(r_of_g94),
        program: programs::r_of_g94,
    },
    Calculator {
        name: "passes-of-a-cone",
        fields: &[
            field("Xa", Diameter, 54.0),
            field("Xe", Diameter, 30.0),
            field("Ze", Length, 0.0),
            field("R", Length, -24.0),
            field("n", Number, 4.0),
        ],
        formula: Formula::Numbers(passes_of_a_cone),
        program: programs::passes_of_a_cone,
    },
    Calculator {
        name: "thread-speed",
        fields: &[field("P", Length, 2.0), field("K", Speed, 80.0)],
        formula: Formula::Numbers(thread_speed),
        program: programs::thread_speed,
    },
    Calculator {
        name: "run-in",
        fields: &[field("n", Speed, 500.0), field("L", Length, 2.0), field("a", Number, 0.01)],
        formula: Formula::Numbers(run_in),
        program: programs::run_in,
    },
    Calculator {
        name: "thread-height",
        fields: &[field("D", Diameter, 30.0), field("P", Length, 2.0)],
        formula: Formula::Numbers(thread_height),
        program: programs::thread_height,
    },
    Calculator {
        name: "thread-by-name",
        fields: &[field("", ThreadName, 0.0), field("Za", Length, 4.0), field("Z", Length, -25.0)],
        formula: Formula::Thread(thread_by_name),
        program: programs::thread_by_name,
    },
    Calculator {
        name: "passes-of-g76",
        fields: &[
            field("X", Diameter, 33.8),
            field("Z", Length, -60.0),
            field("Za", Length, 10.0),
            field("k", Length, 2.4),
            field("Δd", Length, 0.7),
            field("Δdmin", Length, 0.1),
            field("d", Length, 0.1),
            field("a", Degrees, 60.0),
            field("F", Length, 4.0),
        ],
        formula: Formula::Numbers(passes_of_g76),
        program: programs::passes_of_g76,
    },
    Calculator {
        name: "passes-of-g71",
        fields: &[field("XA", Diameter, 41.0), field("XA′", Diameter, 0.0), field("Δd", Length, 2.0)],
        formula: Formula::Numbers(passes_of_g71),
        program: programs::passes_of_g71,
    },
    Calculator {
        name: "steps-of-g73",
        fields: &[field("D", Diameter, 36.0), field("X", Diameter, 0.0), field("d", Number, 10.0)],
        formula: Formula::Numbers(steps_of_g73),
        program: programs::steps_of_g73,
    },
    Calculator {
        name: "columns-of-g75",
        fields: &[field("W", Length, -12.0), field("Δk", Length, 2.9), field("w", Length, 3.0)],
        formula: Formula::Numbers(columns_of_g75),
        program: programs::columns_of_g75,
    },
    Calculator {
        name: "speed",
        fields: &[
            field("v", CuttingSpeed, 100.0),
            field("D", Diameter, 60.0),
            field("f", PerTurn, 0.1),
            field("r", Length, 0.2),
        ],
        formula: Formula::Numbers(speed),
        program: programs::speed,
    },
];

fn positive(values: &[f64], fields: &[usize]) -> Result<(), Wrong> {
    match fields.iter().find(|&&at| values[at] <= 0.0) {
        Some(&at) => Err((at, Fault::NotPositive)),
        None => Ok(()),
    }
}

/// A whole number of passes.
fn passes(values: &[f64], at: usize, least: usize) -> Result<usize, Wrong> {
    let value = values[at];
    if value.fract() != 0.0 {
        Err((at, Fault::NotWhole))
    } else if value < least as f64 {
        Err((at, if least > 1 { Fault::TooFew } else { Fault::NotPositive }))
    } else if value > MAX_PASSES as f64 {
        Err((at, Fault::TooMany))
    } else {
        Ok(value as usize)
    }
}

fn results(results: Vec<(&'static str, Quantity, f64)>) -> Outcome {
    Outcome { results, ..Outcome::default() }
}

fn word(letter: u8, value: WordValue) -> Word {
    Word { letter, value }
}

fn block_of(code: &'static str, words: Vec<Word>) -> Block {
    Block { code, half: None, words }
}

/// A block of a multiple cycle.
fn half_of(code: &'static str, half: CycleBlock, words: Vec<Word>) -> Block {
    Block { code, half: Some(half), words }
}

/// Words with lengths.
fn lengths<const N: usize>(words: [(u8, f64); N]) -> Vec<Word> {
    words.map(|(letter, mm)| word(letter, WordValue::Length(mm))).into()
}

/// The taper C is the difference of the diameters over the length: C = (D − d) / L; half angle arctan(C / 2).
fn cone(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[large, small, length] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[0, 2])?;
    if small < 0.0 {
        return Err((1, Fault::Negative));
    }
    if large == small {
        return Err((1, Fault::SamePlace));
    }
    let taper = (large - small) / length;
    let half = (taper / 2.0).atan().to_degrees();
    Ok(results(vec![("1:", Number, 1.0 / taper), ("α/2", Degrees, half), ("α", Degrees, 2.0 * half)]))
}

/// The cone through (x1, z1) and the end of the cut, prolonged to the Z of the start point.
fn r_of_g90(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[x1, z1, xe, ze, za] = values else { return Err((0, Fault::NotPositive)) };
    if z1 == ze {
        return Err((1, Fault::SamePlace));
    }
    let r = (x1 - xe) / 2.0 * (za - ze) / (z1 - ze);
    let blocks = vec![block_of("G90", lengths([(b'X', xe), (b'Z', ze), (b'R', r)]))];
    Ok(Outcome { blocks, ..results(vec![("R", Length, r), ("X", Diameter, xe + 2.0 * r)]) })
}

/// The cone through (x1, z1) and the end of the cut, prolonged to the X of the start point.
fn r_of_g94(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[x1, z1, xe, ze, xa] = values else { return Err((0, Fault::NotPositive)) };
    if x1 == xe {
        return Err((0, Fault::SamePlace));
    }
    let r = (z1 - ze) * (xa - xe) / (x1 - xe);
    let blocks = vec![block_of("G94", lengths([(b'X', xe), (b'Z', ze), (b'R', r)]))];
    Ok(Outcome { blocks, ..results(vec![("R", Length, r), ("Z", Length, ze + r)]) })
}

/// Route 1: R grows pass by pass, so all of the depth is at B. Route 2: the whole R, and the end moves along Z, with the
/// same depth everywhere; `t` is this depth at right angles to the cone.
fn passes_of_a_cone(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[xa, xe, ze, r, _] = values else { return Err((0, Fault::NotPositive)) };
    let count = passes(values, 4, 1)?;
    if xa == xe {
        return Err((0, Fault::SamePlace));
    }
    if r == 0.0 {
        return Err((3, Fault::SamePlace));
    }
    let step = r.abs() / count as f64;
    let half = ((xa - xe).abs() / 2.0 / r.abs()).atan();
    let outward = -r.signum();
    let tapers = (1..=count).map(|pass| r * pass as f64 / count as f64);
    let rows = tapers.clone().enumerate().map(|(pass, taper)| {
        let left = (count - pass - 1) as f64;
        vec![(pass + 1) as f64, taper, step, 0.0, ze + outward * step * left, step]
    });
    let blocks = tapers.clone().enumerate().map(|(pass, taper)| match pass {
        0 => Block { code: "G94", half: None, words: lengths([(b'X', xe), (b'Z', ze), (b'R', taper)]) },
        _ => Block { code: "", half: None, words: lengths([(b'Z', ze), (b'R', taper)]) },
    });
    Ok(Outcome {
        results: vec![
            ("ΔZ", Length, step),
            ("t", Length, step * half.sin()),
            ("α/2", Degrees, half.to_degrees()),
        ],
        columns: vec![
            ("i", Number),
            ("R", Length),
            ("B", Length),
            ("E", Length),
            ("Z", Length),
            ("B, E", Length),
        ],
        rows: rows.collect(),
        blocks: blocks.collect(),
        thread: None,
    })
}

/// n = 1200 / P − K, a limit of older controls.
fn thread_speed(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[pitch, margin] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[0])?;
    let speed = 1200.0 / pitch - margin;
    if speed <= 0.0 {
        return Err((1, Fault::TooLarge));
    }
    let blocks = vec![block_of("G97", vec![word(b'S', WordValue::Number(speed.floor()))])];
    Ok(Outcome { blocks, ..results(vec![("n", Speed, speed)]) })
}

/// δ2 = n · L / 1800 and δ1 = δ2 · (−1 − ln a), where a is the permitted error of the lead.
fn run_in(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[speed, lead, error] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[0, 1, 2])?;
    // From 1/e on, no run-in is needed.
    if error >= (-1.0f64).exp() {
        return Err((2, Fault::TooLarge));
    }
    let (before, out) = (threading::run_in(speed, lead, error), threading::run_out(speed, lead));
    Ok(results(vec![("δ1", Length, before), ("δ2", Length, out)]))
}

/// Thread with 60° (ISO 68-1): outside 17/24 H with a rounded root or 3/4 H with a flat root, inside 5/8 H.
fn thread_height(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[diameter, pitch] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[0, 1])?;
    let triangle = pitch * 3.0f64.sqrt() / 2.0;
    let [round, flat, inside] = [17.0 / 24.0, 3.0 / 4.0, 5.0 / 8.0].map(|share| share * triangle);
    if 2.0 * flat >= diameter {
        return Err((1, Fault::TooLarge));
    }
    Ok(results(vec![
        ("k", Length, round),
        ("X", Diameter, diameter - 2.0 * round),
        ("k 3/4 H", Length, flat),
        ("X 3/4 H", Diameter, diameter - 2.0 * flat),
        ("k 5/8 H", Length, inside),
        ("X 5/8 H", Diameter, diameter - 2.0 * inside),
    ]))
}

/// The dimensions of the standard, and the outside thread with G76: the first depth is a third of the height.
fn thread_by_name(thread: &Thread, values: &[f64]) -> Result<Outcome, Wrong> {
    let &[_, start, end] = values else { return Err((0, Fault::UnknownThread)) };
    if start == end {
        return Err((2, Fault::SamePlace));
    }
    let Thread { pitch, lead, angle, outside, inside, .. } = *thread;
    let ratio = thread.taper.map_or(0.0, |taper| taper.ratio);
    // A taper pipe thread has its core diameter at the end of the pipe, Z0, and grows toward the chuck.
    let core = outside.core.mm() - ratio * end;
    let increments = |letter: u8, mm: f64| word(letter, WordValue::Increments(mm));
    let mut first = vec![word(b'P', WordValue::Packed(angle)), increments(b'Q', 0.1)];
    first.extend(lengths([(b'R', 0.05)]));
    let mut second = lengths([(b'X', core), (b'Z', end)]);
    if ratio != 0.0 {
        second.extend(lengths([(b'R', -(start - end) * ratio / 2.0)]));
    }
    second.extend([
        increments(b'P', outside.height),
        increments(b'Q', outside.height / 3.0),
        word(b'F', WordValue::PerTurn(lead)),
    ]);
    Ok(Outcome {
        results: vec![
            ("D", Diameter, thread.major.mm()),
            ("P", Length, pitch),
            ("F", Length, lead),
            ("a", Degrees, angle),
            ("k", Length, outside.height),
            ("X", Diameter, core),
            ("k", Length, inside.height),
            ("D1", Diameter, inside.hole.mm()),
        ],
        blocks: vec![half_of("G76", CycleBlock::First, first), half_of("G76", CycleBlock::Second, second)],
        ..Outcome::default()
    })
}

/// Depth of pass n: Δd√n, at least Δdmin more than the pass before, then k − d and k. The start moves along the flank.
fn passes_of_g76(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[x, z, start, height, first, least, last, angle, lead] = values else {
        return Err((0, Fault::NotPositive));
    };
    positive(values, &[3, 4, 8])?;
    if let Some(at) = [5, 6, 7].into_iter().find(|&at| values[at] < 0.0) {
        return Err((at, Fault::Negative));
    }
    if last >= height {
        return Err((6, Fault::TooLarge));
    }
    if first > height - last {
        return Err((4, Fault::TooLarge));
    }
    let flank = (angle / 2.0).to_radians().tan();
    let (mut depths, mut depth) = (Vec::new(), 0.0f64);
    while depth < height - last {
        let square = first * ((depths.len() + 1) as f64).sqrt();
        depth = square.max(depth + least).min(height - last);
        depths.push(depth);
        if depths.len() >= MAX_PASSES {
            return Err((4, Fault::TooMany));
        }
    }
    if last > 0.0 {
        depths.push(height);
    }
    let rows = depths.iter().enumerate().map(|(pass, depth)| {
        vec![(pass + 1) as f64, *depth, x + 2.0 * (height - depth), start - depth * flank]
    });
    let increments = |letter: u8, mm: f64| word(letter, WordValue::Increments(mm));
    let mut first_block = vec![word(b'P', WordValue::Packed(angle)), increments(b'Q', least)];
    first_block.extend(lengths([(b'R', last)]));
    let mut second = lengths([(b'X', x), (b'Z', z)]);
    second.extend([increments(b'P', height), increments(b'Q', first), word(b'F', WordValue::PerTurn(lead))]);
    let blocks =
        vec![half_of("G76", CycleBlock::First, first_block), half_of("G76", CycleBlock::Second, second)];
    let results = vec![("n", Number, depths.len() as f64), ("X", Diameter, x + 2.0 * height)];
    let columns = vec![("n", Number), ("D", Length), ("X", Diameter), ("Z", Length)];
    Ok(Outcome { results, columns, rows: rows.collect(), blocks, thread: None })
}

/// The levels between A and A′; a level at A′ itself belongs to the cut along the contour.
fn passes_of_g71(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[start, end, step] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[2])?;
    let depth = (start - end).abs() / 2.0;
    if depth == 0.0 {
        return Err((1, Fault::SamePlace));
    }
    let levels = ((depth / step) - 1e-9).floor().max(0.0);
    if levels > MAX_PASSES as f64 {
        return Err((2, Fault::TooMany));
    }
    let blocks = vec![half_of("G71", CycleBlock::First, lengths([(b'U', step)]))];
    Ok(Outcome { blocks, ..results(vec![("n", Number, levels), ("Δr", Length, depth - levels * step)]) })
}

/// Δi is the excess on the radius, and each of d passes moves by Δi / (d − 1).
fn steps_of_g73(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[blank, least, _] = values else { return Err((0, Fault::NotPositive)) };
    let count = passes(values, 2, 2)?;
    if blank <= least {
        return Err((0, Fault::TooSmall));
    }
    let relief = (blank - least) / 2.0;
    let mut words = lengths([(b'U', relief)]);
    words.push(word(b'R', WordValue::Number(count as f64)));
    let blocks = vec![half_of("G73", CycleBlock::First, words)];
    Ok(Outcome {
        blocks,
        ..results(vec![("Δi", Length, relief), ("t", Length, relief / (count as f64 - 1.0))])
    })
}

/// Columns of G75 along W with the step Δk, cut by a blade of width w.
fn columns_of_g75(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[width, step, blade] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[1, 2])?;
    let columns = (width.abs() / step - 1e-9).ceil() + 1.0;
    if columns > MAX_PASSES as f64 {
        return Err((1, Fault::TooMany));
    }
    if step > blade {
        return Err((1, Fault::TooLarge));
    }
    let mut words = lengths([(b'W', width)]);
    words.push(word(b'Q', WordValue::Increments(step)));
    let blocks = vec![half_of("G75", CycleBlock::Second, words)];
    let results = vec![
        ("n", Number, columns),
        ("w − Δk", Length, blade - step),
        ("|W| + w", Length, width.abs() + blade),
    ];
    Ok(Outcome { results, blocks, ..Outcome::default() })
}

/// n = 1000 v / (π D); theoretical roughness Rt = f² / (8 r).
fn speed(values: &[f64]) -> Result<Outcome, Wrong> {
    let &[cutting, diameter, feed, radius] = values else { return Err((0, Fault::NotPositive)) };
    positive(values, &[0, 1, 2, 3])?;
    let speed = 1000.0 * cutting / (PI * diameter);
    let roughness = 1000.0 * feed * feed / (8.0 * radius);
    let blocks = vec![block_of("G97", vec![word(b'S', WordValue::Number(speed.round()))])];
    Ok(Outcome { blocks, ..results(vec![("n", Speed, speed), ("Rt", Roughness, roughness)]) })
}

#[cfg(test)]
mod tests {
    use super::super::{THREAD, Writing};
    use super::*;

    /// The results of a calculator, rounded to three decimals.
    fn values(name: &str, fields: &[f64]) -> Vec<f64> {
        let own = Calculator::find(name).expect("a calculator");
        assert_eq!(own.fields.len(), fields.len(), "{name}");
        let outcome = own.compute(fields, "").expect("results");
        outcome.results.iter().map(|(.., value)| (1000.0 * value).round() / 1000.0).collect()
    }

    fn text_of(outcome: &Outcome) -> String {
        outcome.blocks.iter().map(|block| Writing::METRIC.block(block)).collect::<Vec<_>>().join("\n")
    }

    fn block(name: &str, fields: &[f64]) -> String {
        let outcome = Calculator::find(name).expect("a calculator").compute(fields, "").expect("results");
        text_of(&outcome)
    }

    #[test]
    fn cones() {
        assert_eq!(values("cone", &[50.0, 46.0, 20.0]), [5.0, 5.711, 11.421]);
        assert_eq!(values("cone", &[30.0, 20.0, 30.0]), [3.0, 9.462, 18.925]);
        assert_eq!(values("cone", &[50.0, 30.0, 20.0]), [1.0, 26.565, 53.13]);
    }

    #[test]
    fn tapers_from_the_real_start() {
        assert_eq!(values("r-of-g90", &[20.0, 0.0, 40.0, -25.0, 2.0]), [-10.8, 18.4]);
        assert_eq!(values("r-of-g90", &[46.0, 0.0, 50.0, -20.0, 3.0]), [-2.3, 45.4]);
        assert_eq!(values("r-of-g90", &[30.0, 0.0, 20.0, -30.0, 3.0]), [5.5, 31.0]);
        assert_eq!(block("r-of-g90", &[20.0, 0.0, 40.0, -25.0, 2.0]), "G90 X40 Z-25 R-10.8");
        assert_eq!(values("r-of-g94", &[50.0, -20.0, 30.0, 0.0, 54.0])[0], -24.0);
        assert_eq!(values("r-of-g94", &[50.0, -20.0, 30.0, 0.0, 50.0])[0], -20.0);
        assert_eq!(values("r-of-g94", &[80.0, -10.0, 20.0, 0.0, 85.0])[0], -10.833);
        assert_eq!(block("r-of-g94", &[50.0, -20.0, 30.0, 0.0, 54.0]), "G94 X30 Z0 R-24");
    }

    /// On the cone 1:1, 24 mm along Z and 12 mm on the radius: a step of 5 mm along Z is 2.236 mm deep.
    #[test]
    fn routes_of_a_cone() {
        let own = Calculator::find("passes-of-a-cone").expect("a calculator");
        let outcome = own.compute(&[54.0, 30.0, 0.0, -24.0, 4.0], "").expect("results");
        let tapers: Vec<f64> = outcome.rows.iter().map(|row| row[1]).collect();
        assert_eq!(tapers, [-6.0, -12.0, -18.0, -24.0]);
        let places: Vec<f64> = outcome.rows.iter().map(|row| row[4]).collect();
        assert_eq!(places, [18.0, 12.0, 6.0, 0.0]);
        assert_eq!(text_of(&outcome), "G94 X30 Z0 R-6\nZ0 R-12\nZ0 R-18\nZ0 R-24");
        assert_eq!(values("passes-of-a-cone", &[50.0, 30.0, 0.0, -20.0, 4.0]), [5.0, 2.236, 26.565]);
    }

    #[test]
    fn threads() {
        assert_eq!(values("thread-speed", &[1.5, 80.0]), [720.0]);
        assert_eq!(values("thread-speed", &[2.0, 80.0]), [520.0]);
        assert_eq!(values("thread-speed", &[4.0, 80.0]), [220.0]);
        assert_eq!(values("run-in", &[500.0, 2.0, 0.01]), [2.003, 0.556]);
        assert_eq!(values("run-in", &[500.0, 2.0, 0.02]), [1.618, 0.556]);
        assert_eq!(values("run-in", &[200.0, 4.0, 0.01])[1], 0.444);
        let heights = values("thread-height", &[30.0, 2.0]);
        assert_eq!([heights[0], heights[2], heights[4]], [1.227, 1.299, 1.083]);
        let heights = values("thread-height", &[38.6, 4.0]);
        assert_eq!([heights[0], heights[2], heights[4]], [2.454, 2.598, 2.165]);
    }

    /// M30×2 (ISO 724): core 30 − 2.4537 = 27.546, hole 30 − 2.1651 = 27.835. 1/2-14 NPT: taper 1/16, so R over 24 mm
    /// is 0.75 mm, and its diameter grows by 20/16 = 1.25 mm over 20 mm.
    #[test]
    fn threads_by_name() {
        let own = Calculator::find("thread-by-name").expect("a calculator");
        let outcome = own.compute(&[0.0, 4.0, -25.0], "m30x2").expect("a thread");
        let values: Vec<f64> = outcome.results.iter().map(|own| (1000.0 * own.2).round() / 1000.0).collect();
        assert_eq!(values, [30.0, 2.0, 2.0, 60.0, 1.227, 27.546, 1.083, 27.835]);
        assert_eq!(text_of(&outcome), "G76 P010060 Q100 R0.05\nG76 X27.546 Z-25 P1227 Q409 F2");
        let at = |end: f64| own.compute(&[0.0, 4.0, end], "1/2-14 NPT").expect("a thread");
        let core = |outcome: &Outcome| outcome.results[5].2;
        assert!((core(&at(-20.0)) - core(&at(0.0)) - 1.25).abs() < 1e-9);
        assert!(text_of(&at(-20.0)).contains(" R-0.75 "), "{}", text_of(&at(-20.0)));
        assert_eq!(own.compute(&[0.0, 4.0, -25.0], "M31.7"), Err((0, Fault::UnknownThread)));
    }

    /// Seed 003, example 6.
    #[test]
    fn passes_of_a_thread() {
        let fields = [33.8, -60.0, 10.0, 2.4, 0.7, 0.1, 0.1, 60.0, 4.0];
        let outcome =
            Calculator::find("passes-of-g76").expect("a calculator").compute(&fields, "").expect("results");
        let column = |at: usize| -> Vec<f64> {
            outcome.rows.iter().map(|row| (1000.0 * row[at]).round() / 1000.0).collect()
        };
        let depths = [0.7, 0.99, 1.212, 1.4, 1.565, 1.715, 1.852, 1.98, 2.1, 2.214, 2.3, 2.4];
        assert_eq!(column(1), depths);
        let ends = [37.2, 36.62, 36.175, 35.8, 35.47, 35.171, 34.896, 34.64, 34.4, 34.173, 34.0, 33.8];
        assert_eq!(column(2), ends);
        assert_eq!((column(3)[0], column(3)[11]), (9.596, 8.614));
        assert_eq!(text_of(&outcome), "G76 P010060 Q100 R0.1\nG76 X33.8 Z-60 P2400 Q700 F4");
    }

    #[test]
    fn contours_grooves_and_speeds() {
        assert_eq!(values("passes-of-g71", &[41.0, 0.0, 2.0]), [10.0, 0.5]);
        assert_eq!(values("passes-of-g71", &[40.0, 0.0, 2.0]), [9.0, 2.0]);
        assert_eq!(values("steps-of-g73", &[36.0, 0.0, 10.0]), [18.0, 2.0]);
        assert_eq!(values("columns-of-g75", &[-12.0, 2.9, 3.0]), [6.0, 0.1, 15.0]);
        assert_eq!(values("speed", &[100.0, 60.0, 0.1, 0.2]), [530.516, 6.25]);
        assert_eq!(values("speed", &[100.0, 60.0, 0.3, 0.2])[1], 56.25);
    }

    #[test]
    fn a_value_that_cannot_be_names_its_field() {
        for (name, fields, wrong) in [
            ("cone", &[50.0, 46.0, 0.0][..], (2, Fault::NotPositive)),
            ("cone", &[50.0, 50.0, 20.0], (1, Fault::SamePlace)),
            ("r-of-g90", &[20.0, -25.0, 40.0, -25.0, 2.0], (1, Fault::SamePlace)),
            ("passes-of-a-cone", &[54.0, 30.0, 0.0, -24.0, 2.5], (4, Fault::NotWhole)),
            ("thread-speed", &[30.0, 80.0], (1, Fault::TooLarge)),
            ("run-in", &[500.0, 2.0, 0.5], (2, Fault::TooLarge)),
            ("passes-of-g76", &[33.8, -60.0, 10.0, 2.4, 3.0, 0.1, 0.1, 60.0, 4.0], (4, Fault::TooLarge)),
            ("passes-of-g76", &[33.8, -60.0, 10.0, 2.4, 0.001, 0.0, 0.1, 60.0, 4.0], (4, Fault::TooMany)),
            ("columns-of-g75", &[-12.0, 3.5, 3.0], (1, Fault::TooLarge)),
        ] {
            let found = Calculator::find(name).expect("a calculator").compute(fields, "");
            assert_eq!(found, Err(wrong), "{name} {fields:?}");
        }
    }

    #[test]
    fn each_calculator_accepts_its_examples() {
        for own in ALL {
            let examples: Vec<f64> = own.fields.iter().map(|field| field.example).collect();
            assert!(own.compute(&examples, THREAD).is_ok(), "{}", own.name);
        }
    }
}
