//! Measures in a comment: `CR:.016`, `W=3`, `H4`, `Ø8.5`, `10MM`, `1/2"`, `35 DEG`.
//!
//! In: a comment in capitals and the unit of the program. Out: millimetres. A unit in the comment has
//! priority.

use crate::units::Unit;

/// A number with its context.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measure<'a> {
    pub value: f64,
    /// Whether it is written as a fraction.
    fraction: bool,
    /// The letters, and signs such as `Ø`, right before it, without `:`, `=`, points and blanks.
    pub before: &'a str,
    /// Letters and `"` after it.
    pub behind: &'a str,
    /// Letters after a unit: `DIA` in `3.0 IN DIA`.
    pub behind_unit: &'a str,
    /// Whether it follows letters without a blank and has no decimal point, like a counter (`GROOVE1`).
    glued: bool,
}

/// Plausible nose radii, widths of grooving inserts and diameters of drills, mm.
const NOSES: (f64, f64) = (0.05, 3.2);
const WIDTHS: (f64, f64) = (0.3, 20.0);
const DIAMETERS: (f64, f64) = (0.3, 100.0);

/// Words for drills, which are often followed by the diameter as a number alone: `DRILL 8`.
const DRILLS: [&str; 16] = [
    "DRILL",
    "BOHRER",
    "FORET",
    "СВЕРЛО",
    "СВЕРЛ",
    "WIERTLO",
    "WIERTŁO",
    "SVERLO",
    "VRTAK",
    "VRTÁK",
    "MATKAP",
    "BOR",
    "ドリル",
    "钻头",
    "鑽頭",
    "钻",
];

/// `CR:.016`, `R0.8`, `.031 TNR`.
pub fn nose_radius(text: &str, unit: Unit) -> Option<f64> {
    measures(text)
        .find(|own| {
            matches!(own.before, "CR" | "R" | "TNR" | "RE" | "RN") || own.behind == "TNR" || own.behind == "R"
        })
        .map(|own| own.in_millimetres(unit))
        .filter(in_range(NOSES))
}

/// The insert shape with a point angle: `35 DEG`, `80 DEGREE`, `55°`.
pub fn point_angle(text: &str) -> Option<&'static str> {
    measures(text)
        .filter(|own| own.behind.starts_with("DEG") || own.behind == "°" || own.behind.starts_with("GRAD"))
        .find_map(|own| {
            [(80.0, "C"), (55.0, "D"), (35.0, "V")]
                .into_iter()
                .find(|(angle, _)| *angle == own.value)
                .map(|(_, insert)| insert)
        })
}

/// Width of a grooving insert: `W=3`, `W.079`, `H4`, `3MM`, `GROOVE 6.3`.
pub fn width(text: &str, unit: Unit) -> Option<f64> {
    let named = measures(text).find(|own| {
        let before = own.before;
        matches!(before, "W" | "H" | "B")
            || ["WIDTH", "LARGURA", "BREITE", "ANCHO", "LARGHEZZA", "LARGEUR", "ШИРИН", "宽"]
                .iter()
                .any(|name| before.starts_with(name))
    });
    let behind = || measures(text).find(|own| own.behind == "W");
    let with_unit = || measures(text).find(|own| is_unit(own.behind));
    // A number alone that is not a name of the insert, a counter or another measure.
    let alone = || {
        measures(text).find(|own| {
            own.behind.is_empty() && own.before.len() > 2 && !own.before.contains('Ø') && !own.glued
        })
    };
    let own = named
        .or_else(behind)
        .or_else(with_unit)
        .or_else(|| if text.contains("GROOV") { alone() } else { None })?;
    Some(own.in_millimetres(unit)).filter(in_range(WIDTHS))
}

/// Diameter of a drill: `10MM`, `DIA. 10`, `Ø8`, `1/2"`, `.266" DRILL`, `39/64 DRILL`.
pub fn diameter(text: &str, unit: Unit) -> Option<f64> {
    let is_diameter = |own: &Measure| {
        let before = own.before.trim_start_matches("DE ");
        is_unit(own.behind)
            || own.fraction
            || matches!(before, "FI" | "PHI" | "Ф")
            // `钻头D8`
            || before.trim_start_matches(|letter: char| !letter.is_ascii()) == "D"
            || before.ends_with('Ø')
            || before.ends_with('⌀')
            || before.ends_with('Φ')
            || ["DIA", "DURCHM", "ДИАМ", "直径"].iter().any(|name| before.starts_with(name))
    };
    // `3/8 DRILL .550 DEPTH`
    let is_length = |own: &Measure| {
        ["DEPTH", "DEEP", "LOC", "L", "FL", "DEG", "X"].contains(&own.behind) || own.behind.starts_with("DEG")
    };
    let named = measures(text).find(|own| is_diameter(own) && !is_length(own));
    let before_drill = || {
        measures(text).find(|own| {
            own.behind.starts_with("DRILL")
                || own.behind == "DR"
                || (own.behind.is_empty()
                    && !own.glued
                    && (matches!(own.before, "BROCA" | "DE" | "MECHA" | "PUNTA")
                        || DRILLS.contains(&own.before) && !own.may_count(unit)))
        })
    };
    named.or_else(before_drill).map(|own| own.in_millimetres(unit)).filter(in_range(DIAMETERS))
}

fn in_range((low, high): (f64, f64)) -> impl Fn(&f64) -> bool {
    move |value| (low..=high).contains(value)
}

impl Measure<'_> {
    /// Whether it may be a tool number, as in `DRILL 2`, rather than a measure.
    fn may_count(&self, unit: Unit) -> bool {
        let is_whole = self.value.fract() == 0.0;
        is_whole && (unit == Unit::Inch || self.value < 3.0)
    }

    /// Whether it is one digit right after letters.
    pub fn is_digit(&self) -> bool {
        self.glued && self.value < 10.0
    }

    /// Whether its unit is the inch, or it is a fraction.
    pub fn is_inch(&self) -> bool {
        self.fraction || matches!(self.behind, "\"" | "IN" | "INCH" | "''")
    }

    /// Its length, mm; `unit` is used if it has no unit.
    pub fn in_millimetres(&self, unit: Unit) -> f64 {
        let own = match self.behind {
            "MM" | "ММ" | "毫米" => Unit::Millimetre,
            "\"" | "IN" | "INCH" | "''" => Unit::Inch,
            _ if self.fraction => Unit::Inch,
            _ => unit,
        };
        self.value * own.millimetres()
    }
}

/// The digits that follow one of some words in a text, possibly with blanks and `#` between.
pub fn after_letters<'a>(text: &'a str, words: &'a [&str]) -> impl Iterator<Item = &'a str> {
    words.iter().flat_map(move |word| {
        text.match_indices(word).filter_map(move |(at, _)| {
            let is_within = text[..at].chars().next_back().is_some_and(char::is_alphanumeric);
            let rest = &text[at + word.len()..];
            let rest = if word.len() > 1 { rest.trim_start_matches([' ', '#', '.', ':']) } else { rest };
            let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
            // `N1T0909`: a T word may follow a number without a blank.
            let follows_number = word.len() == 1 && text[..at].ends_with(|c: char| c.is_ascii_digit());
            (digits > 0 && (!is_within || follows_number)).then(|| &rest[..digits])
        })
    })
}

/// All numbers of a comment, except parts of a name (`CNMG432`, `N2A`) and counters (`#5`).
pub(super) fn measures(text: &str) -> impl Iterator<Item = Measure<'_>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = text.get(at..)?;
            let start = at + rest.find(|c: char| c.is_ascii_digit() || c == '.')?;
            let length = text[start..]
                .bytes()
                .take_while(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'/' | b','))
                .count();
            at = start + length;
            if let Some(found) = measure(text, start, at) {
                return Some(found);
            }
        }
    })
}

fn measure(text: &str, start: usize, end: usize) -> Option<Measure<'_>> {
    let written = text[start..end].trim_end_matches(['.', ',', '/']);
    let number = |text: &str| crate::units::read_number(&text.replace(',', "."));
    let (value, fraction) = match written.split_once('/') {
        Some((above, below)) => (number(above)? / number(below).filter(|&below| below > 0.0)?, true),
        None => (number(written)?, false),
    };
    let lead = text[..start].trim_end_matches([' ', ':', '=', '.']);
    let is_letter = |c: char| c.is_alphabetic() || matches!(c, 'Ø' | '⌀' | 'Φ');
    let from =
        lead.char_indices().rev().take_while(|(_, c)| is_letter(*c)).last().map_or(lead.len(), |(at, _)| at);
    let tail = text[end..].trim_start_matches(' ');
    let signs = tail.chars().take_while(|c| matches!(c, '"' | '\'' | '°')).map(char::len_utf8).sum();
    let behind = &tail[..if signs > 0 { signs } else { letters(tail) }];
    let next = tail[behind.len()..].trim_start_matches(' ');
    let behind_unit = if is_unit(behind) { &next[..letters(next)] } else { "" };
    // `16ER1.5` and `N2A4` are names.
    let is_name = lead.len() == start && from < start && lead[..from].ends_with(|c: char| c.is_ascii_digit());
    let counts = text[..start].ends_with(['#', '-']) || is_name;
    let glued = lead.len() == start && from < start && !written.contains(['.', ',', '/']);
    (!counts).then_some(Measure { value, fraction, before: &lead[from..], behind, behind_unit, glued })
}

/// Length of the letters at the head of a text, bytes.
fn letters(text: &str) -> usize {
    text.find(|c: char| !c.is_alphabetic()).unwrap_or(text.len())
}

fn is_unit(text: &str) -> bool {
    matches!(text, "MM" | "\"" | "IN" | "INCH" | "''" | "ММ" | "毫米")
}
