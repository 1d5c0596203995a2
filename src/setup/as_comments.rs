//! Writes a setup as comments at the head of a program, the notation that `notes` reads.
//!
//! In: a setup, and the text it is for. Out: the comment lines, and the changes that replace the existing
//! notes of the text by them. Settings without a note (other switches, limits) are not written.

use super::fields::{self, Field};
use super::notes::Notes;
use super::{Blank, Setup, Stock};
use crate::order;
use crate::source::{self, Span};

/// A replacement of a span of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The replaced span.
    pub span: Span,
    /// The new text.
    pub insert: String,
}

/// Most characters of a line with the points of an outline.
const WIDEST: usize = 64;

/// The notes for stock, tools, tailstock, machine, start, rules and switches of the control, one line each.
pub fn lines(setup: &Setup) -> Vec<String> {
    let mut lines = Vec::new();
    lines.extend(setup.stock.iter().flat_map(blank));
    for (name, tool) in &setup.tools {
        lines.extend(line(&format!("TOOL {name}"), fields::TOOL, tool));
    }
    lines.extend(setup.tailstock.and_then(|tailstock| line("TAILSTOCK", fields::TAILSTOCK, &tailstock)));
    lines.extend(line("MACHINE", fields::MACHINE, &setup.machine));
    lines.extend(setup.initial.and_then(|start| line("START", fields::START, &start)));
    lines.extend(line("DIALECT", fields::DIALECT, &setup.dialect));
    let rules: String = setup.rules.iter().map(|(name, level)| format!(" {name}={}", level.name())).collect();
    lines.extend((!rules.is_empty()).then(|| format!("(RULES{})", rules.to_ascii_uppercase())));
    lines
}

/// The note of a stock: `(STOCK D=65 LENGTH=80)`.
pub fn stock(stock: &Stock) -> String {
    line("STOCK", fields::STOCK, stock).unwrap_or_default()
}

/// The notes of a blank. An outline continues from line to line: `(STOCK X=0 Z=2 X=30 Z=2)`.
fn blank(blank: &Blank) -> Vec<String> {
    let Some(outline) = blank.outline() else { return vec![stock(&blank.extents())] };
    let points = outline.points().iter().map(|point| format!(" X={} Z={}", point.x.mm(), point.z));
    let grip = fields::values(fields::OUTLINED, &blank.extents())
        .map(|(field, value)| format!(" {}={value}", field.word))
        .collect::<Vec<_>>();
    let mut lines: Vec<String> = Vec::new();
    for words in points.chain(grip) {
        match lines.last_mut().filter(|line| line.len() + words.len() < WIDEST) {
            Some(line) => line.push_str(&words),
            None => lines.push(format!("(STOCK{words}")),
        }
    }
    lines.iter_mut().for_each(|line| line.push(')'));
    lines
}

/// A note; `None` if all values are defaults.
fn line<T>(head: &str, fields: &[Field<T>], own: &T) -> Option<String> {
    let words: String = fields::values(fields, own)
        .map(|(field, value)| format!(" {}={}", field.word, value.to_string().to_ascii_uppercase()))
        .collect();
    (!words.is_empty()).then(|| format!("({head}{words})"))
}

/// The changes that replace the notes of a text by `lines`, in the order of the text. The lines replace the
/// first note on a line of its own, or follow the O number. The remaining notes are removed.
pub fn changes(text: &[u8], lines: &[String]) -> Vec<Change> {
    let notes = Notes::read(text);
    let mut going: Vec<Span> = notes.spans().map(|inside| whole(text, inside)).collect();
    order::by_key(&mut going, |span| span.start);
    let written: String = lines.iter().map(|line| format!("{line}\n")).collect();
    let side_by_side = going.windows(2).all(|two| two[0].end == two[1].start);
    if side_by_side && going.iter().flat_map(|span| span.of(text)).eq(written.as_bytes()) {
        return Vec::new();
    }
    // The first note that has a line to itself is replaced by the new ones.
    let own_line = |span: &&Span| span.of(text).ends_with(b"\n") || span.of(text).ends_with(b"\r");
    let place = going.iter().find(own_line).map(|span| span.start);
    let mut changes: Vec<Change> = going
        .into_iter()
        .map(|span| Change {
            insert: if Some(span.start) == place { written.clone() } else { String::new() },
            span,
        })
        .collect();
    if place.is_none() && !lines.is_empty() {
        let at = after_number(text);
        let is_behind_line = at == 0 || matches!(text[at - 1], b'\n' | b'\r');
        let insert = if is_behind_line { written } else { format!("\n{written}") };
        let index = changes.partition_point(|change| (change.span.start as usize) < at);
        changes.insert(index, Change { span: Span::new(at, at), insert });
    }
    changes
}

/// A comment with its parentheses, and with its whole line if that contains nothing else, otherwise with the
/// blanks before it.
fn whole(text: &[u8], inside: Span) -> Span {
    let (mut start, mut end) = (inside.start as usize - 1, inside.end as usize);
    end += usize::from(matches!(text.get(end), Some(b')' | b']')));
    let line_start = source::line_around(text, start).start as usize;
    let line_end = source::after_line_end(text, source::line_end(text, end));
    let before = text[line_start..start].trim_ascii();
    let behind = text[end..line_end].trim_ascii();
    if before.is_empty() && behind.is_empty() {
        return Span::new(line_start, line_end);
    }
    while start > line_start && matches!(text[start - 1], b' ' | b'\t') {
        start -= 1;
    }
    if before.is_empty() {
        end += text[end..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    }
    Span::new(start, end)
}

/// The first place after `%` and the O number of a program.
fn after_number(text: &[u8]) -> usize {
    let (mut at, mut behind) = (0, 0);
    for _ in 0..20 {
        let line = source::line_around(text, at);
        at = source::after_line_end(text, line.end as usize);
        match line.of(text).trim_ascii() {
            [] => {}
            [b'%', ..] => behind = at,
            [b'O' | b'o' | b':', b'0'..=b'9', ..] => return at,
            _ => break,
        }
    }
    behind
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the changed text, and that reading it again gives the setup that was written.
    #[track_caller]
    fn check(before: &str, setup: &str, after: &str) {
        let setup = Setup::from_json(setup).expect("a setup");
        let lines = lines(&setup);
        let mut text = before.as_bytes().to_vec();
        for change in changes(before.as_bytes(), &lines).into_iter().rev() {
            text.splice(change.span.start as usize..change.span.end as usize, change.insert.into_bytes());
        }
        assert_eq!(String::from_utf8_lossy(&text), after);
        let notes = Notes::read(&text);
        assert_eq!(notes.unreadable, []);
        assert_eq!(notes.applied_to(Setup::default()), setup);
        assert_eq!(changes(&text, &lines), []);
    }

    const BAR: &str = r#"{"stock": {"diameter": 65, "length": 80}}"#;

    #[test]
    fn notes_stand_behind_the_number() {
        check("%\nO1 (PART)\nG0 X1\n", BAR, "%\nO1 (PART)\n(STOCK D=65 LENGTH=80)\nG0 X1\n");
        check("G0 X1\n", BAR, "(STOCK D=65 LENGTH=80)\nG0 X1\n");
        check("", BAR, "(STOCK D=65 LENGTH=80)\n");
        check("O1", BAR, "O1\n(STOCK D=65 LENGTH=80)\n");
        check("(A BAR)\nO1\n", BAR, "(STOCK D=65 LENGTH=80)\n(A BAR)\nO1\n");
    }

    #[test]
    fn notes_take_the_place_of_notes() {
        check(
            "O1\n(STOCK D=1 LENGTH=1)\nM3 (START X=9)\n  (TOOL T1 R=3)\nG0 X1",
            BAR,
            "O1\n(STOCK D=65 LENGTH=80)\nM3\nG0 X1",
        );
        check("O1 [BILLET X62 Z70\nG0 X1\n", BAR, "O1\n(STOCK D=65 LENGTH=80)\nG0 X1\n");
        check("(START X=9) G0 X1\n", BAR, "(STOCK D=65 LENGTH=80)\nG0 X1\n");
        check("O1\n(STOCK D=1 LENGTH=1)\n(START X=9)\nG0\n", "{}", "O1\nG0\n");
    }

    #[test]
    fn an_outline_is_written_in_short_lines() {
        check(
            "O1\n(STOCK X=1 Z=2)\n(STOCK X=3 Z=-4)\nG0 X1\n",
            r#"{"stock": {"outline": [[0, 2], [30.5, 2], [30.5, -20], [50, -30.25], [50, -60], [40, -60.125]], "grip": 15}}"#,
            "O1\n(STOCK X=0 Z=2 X=30.5 Z=2 X=30.5 Z=-20 X=50 Z=-30.25 X=50 Z=-60)\n(STOCK X=40 Z=-60.125 GRIP=15)\nG0 X1\n",
        );
    }

    #[test]
    fn everything_is_written() {
        check(
            "",
            r#"{"stock": {"diameter": 65.5, "bore": 18, "face": 1, "length": 80, "grip": 30},
                "tools": {"T0101": {"type": "turning", "insert": "CNMG120408", "enteringAngle": 95},
                          "T0303": {"type": "grooving", "side": "inside", "width": 3, "noseRadius": 0.2, "tip": 2}},
                "tailstock": {"z": 2, "diameter": 20},
                "machine": {"rapidX": 8000, "maxSpeed": 4000, "travel": {"zMin": -300.5}, "turret": "front"},
                "initial": {"x": 150, "z": 20}, "rules": {"no-program-end": "off", "classroom": "warning"}}"#,
            "(STOCK D=65.5 BORE=18 LENGTH=80 FACE=1 GRIP=30)\n\
             (TOOL T0101 TYPE=TURNING INSERT=CNMG120408 KR=95)\n\
             (TOOL T0303 TYPE=GROOVING SIDE=INSIDE R=0.2 TIP=2 WIDTH=3)\n\
             (TAILSTOCK Z=2 D=20)\n\
             (MACHINE RAPIDX=8000 MAXSPEED=4000 ZMIN=-300.5 TURRET=FRONT)\n\
             (START X=150 Z=20)\n\
             (RULES CLASSROOM=WARNING NO-PROGRAM-END=OFF)\n",
        );
    }
}
