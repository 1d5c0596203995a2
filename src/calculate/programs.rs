//! The programs that show the results of the calculators.
//!
//! In: the values of the fields and the results, in millimetres. Out: the lines of a program; `{}` is the place of the
//! blocks with the result. The blank is in a comment of the program, so it follows the values.

use super::{Outcome, Quantity, Writing};

/// A length, mm, without zeros at its end.
fn mm(value: f64) -> String {
    Writing::METRIC.value(Quantity::Length, value)
}

/// The comment with a solid bar.
fn bar(diameter: f64, length: f64) -> String {
    format!("(STOCK D={} LENGTH={} GRIP=20)", mm(diameter), mm(length + 20.0))
}

/// A program with a tool, from a start point: the blocks, and the way back.
fn cycle(stock: String, tool: &str, start: [f64; 2], blocks: &[String]) -> Vec<String> {
    let head = [stock, format!("(TOOL T0101 TYPE={tool})"), "T0101".into(), "G97 G99 S500 M03".into()];
    let there = [format!("G00 X{} Z{}", mm(start[0]), mm(start[1]))];
    let back = ["G00 Z100".into(), "X200".into(), "M30".into()];
    head.into_iter().chain(there).chain(blocks.iter().cloned()).chain(back).collect()
}

/// The place of the blocks, with a feed rate.
fn with_feed() -> Vec<String> {
    vec!["{} F0.2".into()]
}

/// The least distance to the work, mm.
const CLEAR: f64 = 2.0;

pub(super) fn cone(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[large, small, length] = values else { return Vec::new() };
    let [start, end] = [small, large].map(mm);
    let contour = [
        format!("G00 X{start}"),
        "G01 Z0 F0.2".into(),
        format!("X{end} Z{}", mm(-length)),
        format!("Z{}", mm(-length - 5.0)),
    ];
    let out = [format!("X{}", mm(large.max(small) + 2.0 * CLEAR))];
    let blocks: Vec<_> = contour.into_iter().chain(out).collect();
    cycle(bar(large.max(small) + 1.0, length + 10.0), "TURNING", [large.max(small) + 4.0, CLEAR], &blocks)
}

pub(super) fn r_of_g90(values: &[f64], outcome: &Outcome) -> Vec<String> {
    let (&[_, _, xe, ze, za], Some(&(.., start))) = (values, outcome.results.get(1)) else {
        return Vec::new();
    };
    let length = za.max(0.0) - ze.min(0.0) + 10.0;
    // R of an outside cone is negative if the cut runs toward the chuck.
    if start <= xe {
        return cycle(bar(xe, length), "TURNING", [xe + 2.0 * CLEAR, za], &with_feed());
    }
    let bore = (xe - 2.0 * CLEAR).max(1.0);
    let tube = format!("(STOCK D={} BORE={} LENGTH={})", mm(start + 20.0), mm(bore + CLEAR), mm(length));
    cycle(tube, "BORING", [bore, za], &with_feed())
}

pub(super) fn r_of_g94(values: &[f64], outcome: &Outcome) -> Vec<String> {
    let (&[x1, z1, xe, ze, xa], Some(&(.., outer))) = (values, outcome.results.get(1)) else {
        return Vec::new();
    };
    let bar = bar(x1.max(xe), 10.0 - z1.min(ze).min(0.0));
    cycle(bar, "TURNING", [xa, ze.max(outer) + CLEAR], &with_feed())
}

pub(super) fn passes_of_a_cone(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[xa, xe, ze, r, _] = values else { return Vec::new() };
    let bar = bar(xa.max(xe) - 2.0 * CLEAR, 10.0 - (ze + r).min(ze).min(0.0));
    cycle(bar, "TURNING", [xa, ze.max(ze + r) + CLEAR], &["F0.2".into(), "{}".into()])
}

/// A thread on a bar: the lead, and the Z of its start.
fn thread(diameter: f64, lead: f64, start: f64) -> Vec<String> {
    let end = mm(diameter - 1.2 * lead);
    let blocks = [format!("G92 X{end} Z-25 F{}", mm(lead))];
    let mut lines = cycle(bar(diameter, 45.0), "THREADING", [diameter + 6.0, start], &blocks);
    lines[3] = "G97 S200 M03".into();
    lines
}

pub(super) fn thread_speed(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[pitch, _] = values else { return Vec::new() };
    let mut lines = thread(30.0, pitch, 2.0 * pitch);
    lines[3] = "{} M03".into();
    lines
}

pub(super) fn run_in(values: &[f64], outcome: &Outcome) -> Vec<String> {
    let (&[speed, lead, _], Some(&(.., way))) = (values, outcome.results.first()) else { return Vec::new() };
    let mut lines = thread(30.0, lead, way);
    lines[3] = format!("G97 S{} M03", mm(speed));
    lines
}

pub(super) fn thread_height(values: &[f64], outcome: &Outcome) -> Vec<String> {
    let (&[diameter, pitch], Some(&(.., height))) = (values, outcome.results.first()) else {
        return Vec::new();
    };
    let increments = |mm: f64| (1000.0 * mm).round();
    let core = mm(diameter - 2.0 * height);
    let blocks = [
        "G76 P010060 Q100 R0.05".into(),
        format!("G76 X{core} Z-25 P{} Q{} F{}", increments(height), increments(height / 3.0), mm(pitch)),
    ];
    let mut lines = cycle(bar(diameter, 45.0), "THREADING", [diameter + 6.0, 2.0 * pitch], &blocks);
    lines[3] = "G97 S200 M03".into();
    lines
}

pub(super) fn thread_by_name(values: &[f64], outcome: &Outcome) -> Vec<String> {
    let (&[_, start, end], Some(thread)) = (values, &outcome.thread) else { return Vec::new() };
    let bar = bar(thread.major.mm(), 20.0 - end.min(0.0));
    let mut lines = cycle(bar, "THREADING", [thread.major.mm() + 6.0, start], &["{}".into()]);
    lines[3] = "G97 S200 M03".into();
    lines
}

pub(super) fn passes_of_g76(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[x, z, start, height, ..] = values else { return Vec::new() };
    let top = x + 2.0 * height;
    let mut lines = cycle(bar(top, 20.0 - z.min(0.0)), "THREADING", [top + 6.0, start], &["{}".into()]);
    lines[3] = "G97 S200 M03".into();
    lines
}

/// A contour from the first to the second diameter.
fn contour(first: f64, last: f64) -> Vec<String> {
    vec![format!("N10 G00 X{}", mm(first)), "G01 Z-20 F0.1".into(), format!("N20 X{} Z-30", mm(last))]
}

pub(super) fn passes_of_g71(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[start, end, _] = values else { return Vec::new() };
    let mut blocks = vec!["{} R0.5".into(), "G71 P10 Q20 F0.2".into()];
    blocks.extend(contour(end, start));
    let stock = match start > end {
        true => bar(start, 40.0),
        false => format!("(STOCK D={} BORE={} LENGTH=60)", mm(end + 10.0), mm(start)),
    };
    let tool = if start > end { "TURNING" } else { "BORING" };
    cycle(stock, tool, [start, CLEAR], &blocks)
}

pub(super) fn steps_of_g73(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[blank, least, _] = values else { return Vec::new() };
    let mut blocks = vec!["{}".into(), "G73 P10 Q20 F0.2".into()];
    blocks.extend(contour(least, blank));
    cycle(bar(blank, 40.0), "TURNING", [blank + 2.0 * CLEAR, CLEAR], &blocks)
}

pub(super) fn columns_of_g75(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[width, _, blade] = values else { return Vec::new() };
    // The left corner of the insert is programmed: the groove begins a blade's width before it.
    let start = -5.0 - blade - width.max(0.0);
    let blocks = ["G75 R0.3".into(), "{} X30 P2000 F0.1".into()];
    let mut lines = cycle(bar(40.0, 20.0 + width.abs() + blade), "GROOVING", [44.0, start], &blocks);
    lines[1] = format!("(TOOL T0101 TYPE=GROOVING WIDTH={} REACH=10)", mm(blade));
    lines
}

pub(super) fn speed(values: &[f64], _: &Outcome) -> Vec<String> {
    let &[cutting, diameter, feed, _] = values else { return Vec::new() };
    let blocks = [
        format!("G96 S{}", mm(cutting)),
        format!("G01 Z-30 F{}", mm(feed)),
        format!("X{}", mm(diameter + 4.0)),
    ];
    let mut lines = cycle(bar(diameter + 1.0, 45.0), "TURNING", [diameter, CLEAR], &blocks);
    lines[3] = "{} M03".into();
    lines.insert(4, "G50 S3000".into());
    lines
}
