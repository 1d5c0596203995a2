//! The blank described in comments: `BRUT : PHI50 X 52MM`, `Ø55 BAR STOCK`, `毛坯 φ50×80`,
//! `OD: 80MM | LENGTH: 120MM`.
//!
//! In: a comment in capitals. Out: its diameter and length, mm, if they are named. The inferred blank uses
//! them unless the motions contradict.

use super::numbers::{Measure, measures};
use super::terms::{MatchKind, kind, names_any, split_at_first};
use crate::setup::ToolKind;
use crate::setup::stock::DescribedStock;
use crate::units::{Diameter, Unit};
use MatchKind::{Part, Stem, Word};

/// Terms for a blank, except its material.
#[rustfmt::skip]
const BLANKS: &[(MatchKind, &str)] = &[
    (Part, "BARSTOCK"), (Word, "STOCK"), (Word, "BLANK"), (Stem, "BILLET"), (Word, "ROUND BAR"), (Stem, "BRUT"), (Part, "ROHTEIL"), (Part, "ROHLING"), (Part, "ROHMATERIAL"),
    (Part, "RUNDSTANGE"), (Stem, "BARRA"), (Stem, "TOCHO"), (Stem, "TARUGO"), (Stem, "GREZZO"), (Stem, "PRĘT"), (Word, "PRET"), (Stem, "SUROWK"), (Stem, "SURÓWK"),
    (Stem, "POLOTOVAR"),
    (Stem, "ЗАГОТОВ"), (Stem, "ПРУТОК"), (Stem, "ПРУТКА"), (Part, "毛坯"), (Part, "坯料"), (Part, "棒料"),
];

/// Terms for a material, which may be followed by a grade: `MATERIAL D2 STEEL`.
const MATERIALS: &[(MatchKind, &str)] =
    &[(Word, "MATERIAL"), (Word, "MATL"), (Word, "MATERIAU"), (Word, "MATÉRIAU")];

/// Terms that contain one of these words but do not mean a blank.
#[rustfmt::skip]
const OTHERS: &[(MatchKind, &str)] = &[
    (Word, "STOCK PULL"), (Stem, "STOCK PULLER"), (Word, "STOCK STOP"), (Word, "STOCK TO"), (Stem, "STOCK ALLOW"), (Stem, "STOCK REMOV"),
    (Word, "STOCK LEFT"), (Word, "FACE STOCK"), (Stem, "LEAVE"), (Stem, "LEAVING"), (Stem, "REMOVE"), (Stem, "REMAINING"), (Word, "TOOL"),
    (Word, "FINISH STOCK"), (Word, "FINISHING STOCK"), (Word, "STOCK FOR"), (Word, "STOCK ON"), (Word, "STOCK PER"), (Part, "余量"),
];

/// Terms for a round bar: a number beside them is its diameter.
const BARS: &[(MatchKind, &str)] = &[
    (Part, "BARSTOCK"),
    (Word, "BAR STOCK"),
    (Word, "ROUND STOCK"),
    (Word, "ROUND BAR"),
    (Word, "MATERIAL"),
];

/// Terms for sizes of a bar other than its diameter.
#[rustfmt::skip]
const OTHER_SIZES: &[(MatchKind, &str)] = &[
    (Part, "STICKOUT"), (Part, "STICK OUT"), (Stem, "OVERHANG"), (Stem, "PROTRU"), (Stem, "PROJECT"), (Stem, "WIDTH"), (Word, "WIDE"),
    (Stem, "THICK"), (Word, "THK"), (Stem, "LENGTH"), (Word, "LONG"), (Stem, "DEPTH"), (Word, "DEEP"), (Stem, "HEIGHT"), (Word, "WALL"),
];

/// The sizes of the blank that a comment in capitals names.
pub(super) fn described(text: &str, unit: Unit) -> DescribedStock {
    let text = &*spelled_out(text);
    let is_tool = kind(text).is_some_and(|kind| kind != ToolKind::Turning);
    if is_tool || names_any(text, OTHERS) {
        return DescribedStock::default();
    }
    let said = |diameter: Option<Measure>, length: Option<Measure>| DescribedStock {
        diameter: diameter.map(|own| Diameter::new(own.in_millimetres(unit))),
        length: length.map(|own| own.in_millimetres(unit)),
    };
    let of_blank = split_at_first(text, BLANKS);
    if let Some(bar) = bar_alone(text) {
        return said(Some(bar), None);
    }
    let Some((_, behind)) = of_blank.or_else(|| split_at_first(text, MATERIALS)) else {
        // `OD: 80mm | LENGTH: 120mm` names both.
        let both = measures(text).find(|own| own.before == "OD").zip(measures(text).find(is_length));
        return both
            .map_or_else(DescribedStock::default, |(diameter, length)| said(Some(diameter), Some(length)));
    };
    // The comment may also name sizes of the part: those after the term are sizes of the blank.
    let all = || measures(behind).chain(measures(text));
    let in_plane = all().find(|own| own.before == "X").zip(all().find(|own| own.before == "Z"));
    let is_grade = |own: &Measure| of_blank.is_none() && own.before == "D" && own.is_digit();
    let alone = || {
        let sized = only(measures(text).filter(Measure::is_inch));
        let sized = sized.or_else(|| only(measures(text)).filter(|own| own.value.fract() != 0.0));
        sized.filter(|own| is_unnamed(own) && names_any(text, BARS) && !names_any(text, OTHER_SIZES))
    };
    let diameter = all().find(|own| is_diameter(own) && !is_grade(own)).or(in_plane.map(|(x, _)| x));
    // `3.0 IN DIA X 4.0 IN`: an X after another size is the sign between the two.
    let after_another = || measures(text).skip(1).find(|own| own.before == "X");
    // `BRUT: 50 X 52`.
    let before_sign = || {
        let mut sizes = measures(behind);
        sizes.next().filter(is_unnamed).filter(|_| sizes.next().is_some_and(|own| own.before == "LG"))
    };
    let length = all().find(is_length).or(in_plane.map(|(_, z)| z)).or_else(after_another);
    said(diameter.or_else(alone).or_else(before_sign), length)
}

/// `2.000 BAR`, `Ø50 BAR`, `2" BAR`: a size and the word, nothing else. `70 BAR` and `6.5 BAR` may be
/// pressures.
fn bar_alone(text: &str) -> Option<Measure<'_>> {
    let size = text.trim().strip_suffix("BAR")?.trim_end();
    let signs = ["MM", "INCH", "IN", "DIA", "\"", "Ø", "⌀"];
    let number = signs.iter().fold(size.to_owned(), |left, sign| left.replace(sign, ""));
    let is_number = number.chars().all(|sign| sign.is_ascii_digit() || matches!(sign, '.' | '/' | ' '));
    let has_sign = number.len() < size.len();
    let in_thousandths = number.split_once('.').is_some_and(|(_, decimals)| decimals.len() == 3);
    only(measures(size)).filter(|_| is_number && (has_sign || in_thousandths))
}

/// The only item, or `None` if there are several.
fn only<'a>(mut all: impl Iterator<Item = Measure<'a>>) -> Option<Measure<'a>> {
    all.next().filter(|_| all.next().is_none())
}

/// Whether the letters before a measure do not name it, or only name the blank.
fn is_unnamed(own: &Measure) -> bool {
    matches!(own.before, "" | "IS" | "OF" | "FROM" | "BAR" | "ROUND")
        || names_any(own.before, BLANKS)
        || names_any(own.before, MATERIALS)
}

fn is_diameter(own: &Measure) -> bool {
    let before = own.before;
    matches!(before, "PHI" | "FI" | "Ф" | "D" | "OD")
        || before.ends_with(['Ø', '⌀', 'Φ', '宽', '径'])
        || ["DIA", "DURCHM", "ДИАМ"]
            .iter()
            .any(|name| [before, own.behind, own.behind_unit].iter().any(|word| word.starts_with(name)))
}

fn is_length(own: &Measure) -> bool {
    ["LENGTH", "LONGUEUR", "LANGE", "LÄNGE", "LARGO", "COMPRIMENTO", "ДЛИН"]
        .iter()
        .any(|name| own.before.starts_with(name))
        || matches!(own.before, "L" | "LG" | "LEN")
        || [own.behind, own.behind_unit].contains(&"LONG")
        || own.before.ends_with(['长', '長'])
}

/// Replaces the sign between diameter and length (`50×80`, `50Х80`, `50*80`) by `LG`, and removes the minus
/// after Z, which is only the direction in which a blank extends.
fn spelled_out(text: &str) -> String {
    let is_sign = |letter: char| matches!(letter, 'X' | 'Х' | '×' | '*');
    let mut apart = String::with_capacity(text.len());
    for (at, letter) in text.char_indices() {
        if letter == '-' && text[..at].ends_with('Z') {
            continue;
        }
        if !is_sign(letter) {
            apart.push(letter);
            continue;
        }
        let before =
            text[..at].trim_end().trim_end_matches("MM").trim_end_matches("ММ").trim_end_matches('"');
        let behind = text[at + letter.len_utf8()..].trim_start().trim_start_matches(['L', 'Ø', 'Φ']);
        let is_between = before.ends_with(|c: char| c.is_ascii_digit())
            && behind.starts_with(|c: char| c.is_ascii_digit());
        if is_between { apart.push_str(" LG ") } else { apart.push(letter) }
    }
    apart
}
