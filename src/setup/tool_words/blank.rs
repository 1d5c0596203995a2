//! The blank as people name it in comments: `BRUT : PHI50 X 52MM`, `Ø55 BAR STOCK`, `毛坯 φ50×80`, `OD: 80MM | LENGTH: 120MM`.
//!
//! In: a comment in capitals. Out: its diameter and length, mm, where they are named. The inferred blank has them unless the
//! motions contradict.

use super::numbers::{Measure, measures};
use super::terms::{Form, is_named, kind};
use crate::setup::ToolKind;
use crate::setup::stock::DescribedStock;
use crate::units::{Diameter, Unit};
use Form::{Part, Stem, Word};

/// Terms for a blank.
#[rustfmt::skip]
const BLANKS: &[(Form, &str)] = &[
    (Part, "BARSTOCK"), (Word, "STOCK"), (Word, "BLANK"), (Stem, "BILLET"), (Word, "MATERIAL"), (Word, "MATL"), (Word, "ROUND BAR"),
    (Stem, "BRUT"), (Word, "MATERIAU"), (Word, "MATÉRIAU"), (Part, "ROHTEIL"), (Part, "ROHLING"), (Part, "ROHMATERIAL"),
    (Part, "RUNDSTANGE"), (Stem, "BARRA"), (Stem, "TOCHO"), (Stem, "TARUGO"), (Stem, "GREZZO"), (Stem, "PRĘT"), (Stem, "POLOTOVAR"),
    (Stem, "ЗАГОТОВ"), (Stem, "ПРУТОК"), (Stem, "ПРУТКА"), (Part, "毛坯"), (Part, "坯料"), (Part, "棒料"),
];

/// Terms with one of those in them that name no blank.
#[rustfmt::skip]
const OTHERS: &[(Form, &str)] = &[
    (Word, "STOCK PULL"), (Stem, "STOCK PULLER"), (Word, "STOCK STOP"), (Word, "STOCK TO"), (Stem, "STOCK ALLOW"), (Stem, "STOCK REMOV"),
    (Word, "STOCK LEFT"), (Word, "FACE STOCK"), (Stem, "LEAVE"), (Stem, "LEAVING"), (Stem, "REMOVE"), (Stem, "REMAINING"), (Word, "TOOL"),
    (Part, "余量"),
];

/// Terms for a round bar, beside which a number alone is its diameter.
const BARS: &[(Form, &str)] = &[
    (Part, "BARSTOCK"),
    (Word, "BAR STOCK"),
    (Word, "ROUND STOCK"),
    (Word, "ROUND BAR"),
    (Word, "MATERIAL"),
];

/// The sizes of the blank that a comment in capitals names.
pub(super) fn described(text: &str, unit: Unit) -> DescribedStock {
    let text = &*with_blanks(text);
    let is_tool = kind(text).is_some_and(|kind| kind != ToolKind::Turning);
    let is_other = || OTHERS.iter().any(|(form, term)| is_named(text, term, *form));
    let is_blank = || BLANKS.iter().any(|(form, term)| is_named(text, term, *form));
    let outside = || measures(text).find(|own| own.before == "OD");
    let along = || measures(text).find(is_length);
    if is_tool || is_other() {
        return DescribedStock::default();
    }
    if !is_blank() {
        // `OD: 80mm | LENGTH: 120mm` names both.
        let both = outside().zip(along());
        return both.map_or_else(DescribedStock::default, |(diameter, length)| DescribedStock {
            diameter: Some(Diameter::new(diameter.in_millimetres(unit))),
            length: Some(length.in_millimetres(unit)),
        });
    }
    let is_bar = || BARS.iter().any(|(form, term)| is_named(text, term, *form));
    let diameter = measures(text).find(is_diameter).or_else(|| {
        let sized = only(measures(text).filter(|own| own.is_inch()));
        sized.or_else(|| only(measures(text)).filter(|own| own.value.fract() != 0.0)).filter(|_| is_bar())
    });
    DescribedStock {
        diameter: diameter.map(|own| Diameter::new(own.in_millimetres(unit))),
        length: along().map(|own| own.in_millimetres(unit)),
    }
}

/// The only one of these.
fn only<'a>(mut all: impl Iterator<Item = Measure<'a>>) -> Option<Measure<'a>> {
    all.next().filter(|_| all.next().is_none())
}

fn is_diameter(own: &Measure) -> bool {
    let before = own.before;
    matches!(before, "PHI" | "FI" | "Ф" | "D" | "OD")
        || before.ends_with(['Ø', '⌀', 'Φ', '宽', '径'])
        || ["DIA", "DURCHM", "ДИАМ"]
            .iter()
            .any(|name| before.starts_with(name) || own.behind.starts_with(name))
}

fn is_length(own: &Measure) -> bool {
    ["LENGTH", "LONGUEUR", "LANGE", "LÄNGE", "LARGO", "COMPRIMENTO", "ДЛИН"]
        .iter()
        .any(|name| own.before.starts_with(name))
        || matches!(own.before, "L" | "LG" | "X")
        || own.before.ends_with(['长', '長'])
}

/// Blanks around the sign between diameter and length, an X for each: `50×80`, `50Х80`, `50*80`.
fn with_blanks(text: &str) -> String {
    let is_sign = |letter: char| matches!(letter, 'X' | 'Х' | '×' | '*');
    let mut apart = String::with_capacity(text.len());
    for (at, letter) in text.char_indices() {
        if !is_sign(letter) {
            apart.push(letter);
            continue;
        }
        let before =
            text[..at].trim_end().trim_end_matches("MM").trim_end_matches("ММ").trim_end_matches('"');
        let behind = text[at + letter.len_utf8()..].trim_start().trim_start_matches(['L', 'Ø', 'Φ']);
        let is_between = before.ends_with(|c: char| c.is_ascii_digit())
            && behind.starts_with(|c: char| c.is_ascii_digit());
        if is_between { apart.push_str(" X ") } else { apart.push(letter) }
    }
    apart
}
