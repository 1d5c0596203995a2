//! Tools described in comments: `T0303 (GROOVE W=3)`, `(T7 VNMG CR:.016)`, `(резец проходной)`, `(切槽刀)`.
//!
//! In: the first lines of a program. Out: for each turret station the description in its comments, as a
//! [`Tool`] with missing values. It is a hint: inference tries it first and ignores it if the motions
//! contradict. Terms are in `terms`. A comment belongs to the tool it names, else to the T word in its line,
//! else to the T word before it, else to the one after it.

mod blank;
mod capitals;
mod numbers;
mod terms;

use crate::order;
use std::collections::BTreeMap;

use super::first_unit;
use super::ignored;
use super::notes::{self, HEAD};
use super::{DescribedStock, Side, Tool, ToolKind};
use crate::text::lexer;
use crate::units::{Diameter, Unit};

/// How a comment is related to a tool, the weakest relation first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Relation {
    /// Above the T word.
    Above,
    /// Between the T word and the first move.
    Below,
    /// In the line of the T word.
    Beside,
    /// The comment names the tool.
    Named,
}

/// The tools that comments at the head of a text describe, by turret station. For a bar stop or the like,
/// which does not cut, an empty [`Tool`]. `unit` is the unit of sizes if the text contains neither G20 nor
/// G21.
pub fn read(text: &[u8], unit: Unit) -> BTreeMap<u16, Tool> {
    let head = &text[..text.len().min(HEAD)];
    if memchr::memchr(b'(', head).is_none() {
        return BTreeMap::new();
    }
    let text = &*String::from_utf8_lossy(head);
    let unit = first_unit::unit_of(text.as_bytes()).unwrap_or(unit);
    let mut found: Vec<(Relation, u16, Tool)> = Vec::new();
    let mut above: Vec<Tool> = Vec::new();
    let mut station: Option<u16> = None;
    let mut has_long = false;
    for block in lexer::blocks(text.as_bytes()) {
        let Line { code, comments } = split(&text[block.start as usize..block.end as usize]);
        let called = tool_number(&code, &mut has_long);
        if called.is_some() {
            station = called;
        }
        for comment in comments.into_iter().filter(|comment| !is_note(comment)) {
            let tool = described(comment, unit);
            if tool == Tool::default() && !terms::handles_work(&capitals::in_capitals(comment)) {
                continue;
            }
            match (named(comment), station) {
                (Some(named), _) => found.push((Relation::Named, named, tool)),
                (None, Some(station)) if called.is_some() => found.push((Relation::Beside, station, tool)),
                (None, Some(station)) => {
                    found.push((Relation::Below, station, tool.clone()));
                    above.push(tool);
                }
                (None, None) => above.push(tool),
            }
        }
        if let Some(station) = called {
            found.extend(above.drain(..).map(|tool| (Relation::Above, station, tool)));
        } else if moves(&code) {
            above.clear();
            station = None;
        }
    }
    // In a program with comments below its T words, a comment above a T word belongs to the tool before.
    if found.iter().any(|(tie, ..)| *tie == Relation::Below) {
        found.retain(|(tie, ..)| *tie != Relation::Above);
    }
    order::by_key(&mut found, |(tie, ..)| std::cmp::Reverse(*tie));
    let mut tools: BTreeMap<u16, Tool> = BTreeMap::new();
    for (_, station, tool) in found {
        tools.entry(station).and_modify(|known| fill(known, &tool)).or_insert(tool);
    }
    tools
}

/// The sizes of the blank in comments at the head of a text, or in the lines before its first `%`; of each
/// size the first.
pub fn stock(text: &[u8], unit: Unit) -> DescribedStock {
    let text = &*String::from_utf8_lossy(&text[..text.len().min(HEAD)]);
    let unit = first_unit::unit_of(text.as_bytes()).unwrap_or(unit);
    let title = text.split_once('%').map_or("", |(title, _)| title);
    let mut known = DescribedStock::default();
    let comments = text.split('(').skip(1).filter_map(|rest| rest.split([')', '\n', '\r']).next());
    for comment in title.lines().filter(|line| !line.contains('(')).chain(comments) {
        if notes::is_note(comment)
            || is_note(comment)
            || !comment.contains(|letter: char| letter.is_ascii_digit())
        {
            continue;
        }
        let said = blank::described(&capitals::in_capitals(comment), unit);
        known.diameter = known.diameter.or(said.diameter);
        known.length = known.length.or(said.length);
    }
    known
}

/// The tool that a comment describes.
pub fn described(comment: &str, unit: Unit) -> Tool {
    let text = capitals::in_capitals(comment);
    // `INDICATE ID TURN SIDE` describes how the tool is measured.
    if text.contains("INDICATE") {
        return Tool::default();
    }
    let mut tool = terms::insert_tool(&text).unwrap_or_default();
    let kind = terms::kind(&text);
    // `14MM DRILL XCMT`: the word has priority over the insert.
    tool.kind = match (kind, tool.kind) {
        (Some(ToolKind::Turning), Some(of_insert)) => Some(of_insert),
        (Some(kind), _) => Some(kind),
        (None, of_insert) => of_insert,
    };
    tool.side = tool.side.or(terms::side(&text));
    match (tool.kind, tool.side) {
        (Some(ToolKind::Turning), Some(Side::Inside)) | (None, Some(Side::Inside)) => {
            tool.kind = Some(ToolKind::Boring);
        }
        _ => {}
    }
    if !matches!(tool.kind, Some(ToolKind::Grooving | ToolKind::Threading)) {
        tool.side = None;
    }
    let Some(kind) = tool.kind else { return Tool::default() };
    match kind {
        ToolKind::Turning | ToolKind::Boring => {
            tool.nose_radius = numbers::nose_radius(&text, unit).or(tool.nose_radius);
            tool.insert = tool.insert.or(numbers::point_angle(&text).map(str::to_owned));
        }
        ToolKind::Grooving => {
            tool.width = numbers::width(&text, unit).or(tool.width);
            tool.nose_radius = tool.nose_radius.or(numbers::nose_radius(&text, unit));
            tool.tip = terms::names_right_corner(&text).then_some(4);
        }
        ToolKind::Threading => {}
        ToolKind::Drill | ToolKind::Tap | ToolKind::Endmill => {
            tool = Tool {
                kind: Some(kind),
                diameter: numbers::diameter(&text, unit).map(Diameter::new),
                ..Tool::default()
            };
        }
    }
    // A radius larger than half the grooving insert cannot be that of a corner.
    let widest = tool.width.map_or(f64::INFINITY, |width| width / 2.0);
    tool.nose_radius = tool.nose_radius.filter(|&radius| radius <= widest);
    tool
}

/// Whether a comment tells the operator to flip the part and machine the other end. `is_at_stop`: the comment
/// is in the block of a stop.
pub fn flips_part(comment: &str, is_at_stop: bool) -> bool {
    !ignored::is_ignore_comment(comment.as_bytes())
        && terms::flips_part(&capitals::in_capitals(comment), is_at_stop)
}

/// Whether a comment is the number of the second operation, which means the same in the block of M00.
pub fn is_second_operation(comment: &str) -> bool {
    terms::is_second_operation(&capitals::in_capitals(comment))
}

/// Fills in missing values of a tool from another description, if both can be the same tool.
fn fill(known: &mut Tool, other: &Tool) {
    known.kind = known.kind.or(other.kind);
    if known.kind == other.kind {
        known.side = known.side.or(other.side);
        known.insert = known.insert.take().or_else(|| other.insert.clone());
        known.nose_radius = known.nose_radius.or(other.nose_radius);
        known.width = known.width.or(other.width);
        known.diameter = known.diameter.or(other.diameter);
        known.tip = known.tip.or(other.tip);
    }
}

/// A block: the pieces of its code in capitals, and its comments.
struct Line<'a> {
    code: Vec<String>,
    comments: Vec<&'a str>,
}

fn split(line: &str) -> Line<'_> {
    let (mut code, mut comments, mut rest) = (Vec::new(), Vec::new(), line);
    while let Some((before, behind)) = rest.split_once('(') {
        code.push(before.to_ascii_uppercase());
        let (comment, behind) = behind.split_once(')').unwrap_or((behind, ""));
        comments.push(comment);
        rest = behind;
    }
    code.push(rest.to_ascii_uppercase());
    Line { code, comments }
}

/// The station of the last T word with three digits or more. A shorter T word calls a station if it is beside
/// M06, until `has_long`: a longer one was read.
fn tool_number(code: &[String], has_long: &mut bool) -> Option<u16> {
    let all = |letter: &'static [&'static str]| {
        code.iter().flat_map(move |piece| numbers::after_letters(piece, letter))
    };
    *has_long |= all(&["T"]).any(|digits| digits.len() > 2);
    let changes_tool = all(&["M"]).any(|digits| digits.parse() == Ok(6));
    let calls = |digits: &&str| digits.len() > 2 || changes_tool && !*has_long;
    all(&["T"]).filter(calls).filter_map(station).last()
}

/// The station that the comment itself names: `T0303`, `T7`, `TOOL 3`.
fn named(comment: &str) -> Option<u16> {
    const WORDS: [&str; 8] =
        ["TOOL", "FERRAMENTA", "HERRAMIENTA", "WERKZEUG", "UTENSILE", "OUTIL", "ИНСТРУМЕНТ", "T"];
    let text = capitals::in_capitals(comment);
    let is_size = |digits: &&str| {
        let end = digits.as_ptr() as usize - text.as_ptr() as usize + digits.len();
        let rest = text[end..].trim_start();
        let is_unit = |unit: &&str| {
            rest.strip_prefix(*unit).is_some_and(|after| !after.starts_with(char::is_alphanumeric))
        };
        let has_fraction =
            rest.strip_prefix('.').is_some_and(|after| after.starts_with(|c: char| c.is_ascii_digit()));
        rest.starts_with('"') || has_fraction || ["MM", "IN", "INCH"].iter().any(is_unit)
    };
    let mut numbers = numbers::after_letters(&text, &WORDS).filter(|digits| !is_size(digits));
    numbers.find_map(station).filter(|&number| number > 0)
}

fn station(digits: &str) -> Option<u16> {
    let number: u32 = digits.parse().ok()?;
    u16::try_from(match digits.len() {
        0..=2 => number,
        3 | 4 => number / 100,
        _ => number / 1000,
    })
    .ok()
}

/// Whether a comment is a setup note (`TOOL T0101 TYPE=TURNING`), which is read elsewhere, or names rules
/// (`IGNORE RULE=THREAD-ANGLE`).
fn is_note(comment: &str) -> bool {
    let mut words = comment.split_ascii_whitespace();
    let is_of_tool = words.next().is_some_and(|word| word.eq_ignore_ascii_case("TOOL"));
    is_of_tool && comment.contains('=') || ignored::is_ignore_comment(comment.as_bytes())
}

/// Whether a block moves an axis.
fn moves(code: &[String]) -> bool {
    let is_axis = |byte: u8| matches!(byte, b'X' | b'Z' | b'U' | b'W');
    let goes_home = code.iter().any(|piece| piece.contains("G28") || piece.contains("G30"));
    let mut pairs = code.iter().flat_map(|piece| piece.as_bytes().windows(2));
    !goes_home && pairs.any(|pair| is_axis(pair[0]) && matches!(pair[1], b'0'..=b'9' | b'.' | b'-' | b'#'))
}

#[cfg(test)]
mod tests;
