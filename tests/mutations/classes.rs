//! Common faults, each applied at every word where it fits.
//!
//! In: a correct program. Out: programs with one fault each, and the expected place of the message. Lost,
//! duplicated and swapped blocks are in `blocks`.

use crate::blocks;
use crate::text::{Word, Words};

/// Expected place of the first message.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Overlaps these bytes of the changed text.
    At(usize, usize),
    /// The word after this byte is missing: at the block that contained it, or at the first block that needs
    /// it.
    Needed(usize, Need),
}

/// What the missing word is needed for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need {
    /// Any cut.
    Cut,
    /// The end of the text.
    End,
    /// The block of this G96 or P, Q.
    Word(usize, usize),
}

/// A program with a fault.
pub struct Mutant {
    pub text: String,
    pub place: Place,
}

impl Mutant {
    fn at((text, start, end): (String, usize, usize)) -> Self {
        Self { text, place: Place::At(start, end) }
    }
}

type Make = fn(&Words) -> Vec<Mutant>;

/// What is needed to detect a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// The program with the blank and the tools.
    Program,
    /// Often the drawing: the result is a valid program for another part.
    Drawing,
}

/// A kind of fault.
pub struct Class {
    pub name: &'static str,
    pub make: Make,
    /// Counts even if the motions stay the same: a control stops there.
    pub unseen: bool,
    pub known: Known,
}

const fn class(name: &'static str, make: Make) -> Class {
    Class { name, make, unseen: false, known: Known::Program }
}

const fn unseen(name: &'static str, make: Make) -> Class {
    Class { name, make, unseen: true, known: Known::Program }
}

const fn drawing(name: &'static str, make: Make) -> Class {
    Class { name, make, unseen: false, known: Known::Drawing }
}

/// All classes.
pub const CLASSES: &[Class] = &[
    class("dropped decimal point", dropped_point),
    class("letter O for 0", letter_o),
    class("letter l for 1", letter_l),
    class("doubled point", doubled_point),
    unseen("comma for point", comma_for_point),
    unseen("dash for minus", printed_minus),
    class("lost minus", missing_minus),
    class("address without number", no_number),
    class("number without address", no_address),
    class("unknown G", unknown_g),
    class("missing N of P/Q", missing_n),
    class("P and Q exchanged", exchanged),
    class("depth zero", depth_zero),
    class("depth negative", depth_negative),
    class("wrong R sign", wrong_r_sign),
    class("R not extended", r_not_extended),
    class("U for X", u_for_x),
    class("X for U", x_for_u),
    class("same word twice", twice),
    class("X with U", x_with_u),
    class("missing F", missing_f),
    class("missing S", missing_s),
    class("missing M03", missing_m03),
    class("missing feed mode", missing_feed_mode),
    class("G99 for G98", other_feed_mode),
    class("G96 in threading", surface_speed_in_thread),
    class("missing clamp", missing_clamp),
    class("arc radius too small", small_radius),
    class("arc without radius", no_radius),
    unseen("unclosed comment", unclosed_comment),
    unseen("full-width character", full_width),
    class("P/Q with a point", point_in_pq),
    class("wrong thread angle", thread_angle),
    class("allowance sign", allowance_sign),
    unseen("missing M30", missing_end),
    class("G00, G50 or T in G12.1", forbidden_in_polar),
    class("start inside the stock", start_inside),
    class("spindle too fast for the lead", fast_thread),
    class("missing subprogram", missing_program),
    class("another lead in a pass", another_lead),
    class("passes of a thread exchanged", passes_exchanged),
    class("lead ten times too small", lead_too_small),
    class("feed for lead", feed_for_lead),
    unseen("start angle in degrees", angle_in_degrees),
    class("another lead out of a tapped hole", tap_lead),
    class("K for J on the end face", centre_letter),
    unseen("word that its block does not read", unread_word),
    class("centre of an arc with the other sign", center_sign),
    class("dwell in the other unit", other_dwell),
    class("offset of another tool", other_offset),
    class("end of the program too early", early_end),
    class("value of a vacant variable", vacant_variable),
    class("spindle speed for cutting speed", turns_for_metres),
    class("feed ten times too large", feed_too_large),
    class("X and Z of a repeated place exchanged", axes_exchanged),
    unseen("start angle lost", angle_lost),
    class("depth of G71 ten times", depth_ten_times),
    class("pass ten times as deep", pass_too_deep),
    class("end far beyond the blank", end_behind_blank),
    class("contour roughed twice", blocks::roughed_twice),
    class("groove cut twice", blocks::doubled_groove),
    class("lost: start of the spindle", blocks::lost_spindle),
    class("spindle starts after the first cut", blocks::late_spindle),
    drawing("lost: code of a cycle", blocks::lost_cycle),
    drawing("lost: pass of a cycle", blocks::lost_pass),
    drawing("lost: rapid", blocks::lost_rapid),
    drawing("lost: cut", blocks::lost_cut),
    drawing("lost: setting", blocks::lost_setting),
    drawing("doubled: cycle or pass", blocks::doubled_cycle),
    drawing("doubled: move by increments", blocks::doubled_increment),
    drawing("swapped: cycles and passes", blocks::swapped_cycles),
    drawing("swapped: moves", blocks::swapped_moves),
    drawing("swapped: move and setting", blocks::swapped_settings),
];

/// One mutant for each word that `change` can spell differently.
fn each(words: &Words, change: impl Fn(&Words, &Word) -> Option<String>) -> Vec<Mutant> {
    let changed = words.words.iter().filter_map(|word| {
        let with = change(words, word)?;
        Some(Mutant::at(words.rewritten(word, &with)))
    });
    changed.collect()
}

fn replace_first(words: &Words, word: &Word, from: char, to: &str) -> Option<String> {
    let written = words.written(word);
    let at = written.char_indices().skip(1).find(|found| found.1 == from)?.0;
    Some(format!("{}{to}{}", &written[..at], &written[at + 1..]))
}

fn dropped_point(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let axis = "XZUWRFIKCA".contains(word.address);
        axis.then(|| replace_first(words, word, '.', ""))?
    })
}

fn letter_o(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| replace_first(words, word, '0', "O"))
}

fn letter_l(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| replace_first(words, word, '1', "l"))
}

fn doubled_point(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| replace_first(words, word, '.', ".."))
}

fn comma_for_point(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let written = words.written(word);
        (!written.ends_with('.')).then(|| replace_first(words, word, '.', ","))?
    })
}

fn printed_minus(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| replace_first(words, word, '-', "–"))
}

fn missing_minus(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| replace_first(words, word, '-', ""))
}

fn no_number(words: &Words) -> Vec<Mutant> {
    each(words, |_, word| (word.address != 'N').then(|| word.address.to_string()))
}

fn no_address(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| (word.address != 'N').then(|| words.written(word)[1..].to_owned()))
}

fn unknown_g(words: &Words) -> Vec<Mutant> {
    each(words, |_, word| (word.address == 'G').then(|| format!("G{}37", word.value.trunc())))
        .into_iter()
        .collect()
}

const CONTOUR_CYCLES: [f64; 4] = [70.0, 71.0, 72.0, 73.0];

fn names_contour(words: &Words, word: &Word) -> bool {
    matches!(word.address, 'P' | 'Q') && CONTOUR_CYCLES.iter().any(|&code| words.has_g(word.block, code))
}

/// Removes the N word to which P or Q refers. The message is expected at the P or Q of the first cycle that
/// refers to it.
fn missing_n(words: &Words) -> Vec<Mutant> {
    let mut made = Vec::new();
    for n in words.words.iter().filter(|word| word.address == 'N') {
        let Some(named) = words.words.iter().find(|word| names_contour(words, word) && word.value == n.value)
        else {
            continue;
        };
        let (text, ..) = words.rewritten(n, "");
        let shift = if n.start < named.start { n.end - n.start } else { 0 };
        made.push(Mutant {
            text,
            place: Place::Needed(n.start, Need::Word(named.start - shift, named.end - shift)),
        });
    }
    made
}

/// Swaps P and Q of a block: only their letters, so that the blank between the words stays.
fn exchanged(words: &Words) -> Vec<Mutant> {
    let mut made = Vec::new();
    for block in 0..words.blocks.len() {
        if !(70..=76).any(|code| words.has_g(block, f64::from(code))) {
            continue;
        }
        let (Some(p), Some(q)) = (words.find(block, 'P'), words.find(block, 'Q')) else { continue };
        let (first, last) = if p.start < q.start { (p, q) } else { (q, p) };
        let swap = |word: &Word| {
            let letter = if word.address == 'P' { 'Q' } else { 'P' };
            format!("{letter}{}", &words.written(word)[1..])
        };
        let between = &words.text[first.end..last.start];
        let with = format!("{}{between}{}", swap(first), swap(last));
        made.push(Mutant::at(words.replaced(first.start, last.end, &with)));
    }
    made
}

/// The depth of cut: U of G71, W of G72, P and Q of G74 to G76, the number of passes of G73.
fn is_depth(words: &Words, word: &Word) -> bool {
    let has = |code| words.has_g(word.block, code);
    let names = words.find(word.block, 'P').is_some();
    match word.address {
        'U' => has(71.0) && !names,
        'W' => has(72.0) && !names,
        'R' => has(73.0) && !names,
        'D' => has(71.0) || has(72.0) || has(73.0),
        'P' => has(75.0) || (has(76.0) && words.find(word.block, 'X').is_some()),
        'Q' => has(74.0) || (has(76.0) && words.find(word.block, 'X').is_some()),
        _ => false,
    }
}

fn depth_zero(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| is_depth(words, word).then(|| format!("{}0", word.address)))
}

fn depth_negative(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        is_depth(words, word).then(|| format!("{}-{}", word.address, &words.written(word)[1..]))
    })
}

/// The single cycle in force at a block.
fn single_cycle(words: &Words, block: usize) -> Option<u32> {
    let group_01 = [0.0, 1.0, 2.0, 3.0, 32.0, 34.0, 90.0, 92.0, 94.0];
    let mut last = words
        .words
        .iter()
        .filter(|word| word.block <= block && word.address == 'G' && group_01.contains(&word.value));
    let code = last.next_back()?.value as u32;
    let has_setting = [50.0, 28.0, 4.0, 30.0].iter().any(|&code| words.has_g(block, code));
    ((90..=94).contains(&code) && !has_setting).then_some(code)
}

/// R of a taper or an arc with the opposite sign.
fn wrong_r_sign(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let arc = words.has_g(word.block, 2.0) || words.has_g(word.block, 3.0);
        let thread = words.has_g(word.block, 76.0) && words.find(word.block, 'X').is_some();
        let fits = single_cycle(words, word.block).is_some() || arc || thread;
        (word.address == 'R' && word.value != 0.0 && fits).then(|| {
            let number = &words.written(word)[1..];
            match number.strip_prefix('-') {
                Some(rest) => format!("R{rest}"),
                None => format!("R-{number}"),
            }
        })
    })
}

/// R as in the drawing, although the cut begins outside of the blank. Only where R was extended.
fn r_not_extended(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let cycle = single_cycle(words, word.block)?;
        // Previous tool position: the last X and Z outside the cycle.
        let place = |address: char| {
            let mut before = words.words.iter().filter(|other| {
                other.address == address
                    && other.block < word.block
                    && single_cycle(words, other.block).is_none()
            });
            before.next_back().map(|other| other.value)
        };
        if word.address != 'R' || word.value == 0.0 {
            return None;
        }
        let share = match cycle {
            // From the surface of the blank instead of the start point, if that gives a round number.
            94 => {
                let (start, end) = (place('X')?, words.find(word.block, 'X')?.value);
                (2..=40).map(|step| start - f64::from(step) / 2.0).find_map(|surface| {
                    let share = (surface - end) / (start - end);
                    (share > 0.2 && is_round(word.value * share) && !is_round(word.value))
                        .then_some(share)
                        .or_else(|| (share > 0.2 && surface == 50.0).then_some(share))
                })?
            }
            90 => {
                let (start, end) = (place('Z')?, words.find(word.block, 'Z')?.value);
                let share = -end / (start - end);
                (share > 0.2 && share < 1.0).then_some(share)?
            }
            _ => return None,
        };
        let drawn = (1000.0 * word.value * share).round() / 1000.0;
        (is_round(drawn) && !steeper_pass_follows(words, word, drawn)).then(|| format!("R{drawn}"))
    })
}

/// Whether the next pass has the same ends and a greater R than `taper`: then the pass at `word` changes nothing in the part.
fn steeper_pass_follows(words: &Words, word: &Word, taper: f64) -> bool {
    let Some(next) = words.words.iter().find(|other| other.block > word.block).map(|next| next.block) else {
        return false;
    };
    let value = |block: usize, address: char| words.find(block, address).map(|found| found.value);
    let is_other =
        |address: char| value(next, address).is_some_and(|end| value(word.block, address) != Some(end));
    let steeper = value(next, 'R').is_some_and(|other| other * taper > taper * taper);
    steeper && !['G', 'X', 'Z', 'U', 'W'].into_iter().any(is_other)
}

fn is_round(length: f64) -> bool {
    (2.0 * length - (2.0 * length).round()).abs() < 1e-6
}

fn plain_axis(words: &Words, word: &Word) -> bool {
    let other_use = [50.0, 4.0, 28.0, 30.0, 10.0, 52.0].iter().any(|&code| words.has_g(word.block, code));
    !other_use
}

fn u_for_x(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        (word.address == 'X' && plain_axis(words, word)).then(|| format!("U{}", &words.written(word)[1..]))
    })
}

fn x_for_u(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        (word.address == 'U' && plain_axis(words, word)).then(|| format!("X{}", &words.written(word)[1..]))
    })
}

/// Duplicates a word with a slightly larger value.
fn twice(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let written = words.written(word);
        let other = word.value + 1.0;
        ("XZUWRFSPQIK".contains(word.address)).then(|| format!("{written} {}{other}", word.address))
    })
}

fn x_with_u(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let other = match word.address {
            'X' if words.find(word.block, 'U').is_none() => 'U',
            'Z' if words.find(word.block, 'W').is_none() => 'W',
            _ => return None,
        };
        plain_axis(words, word).then(|| format!("{} {other}2", words.written(word)))
    })
}

fn missing(words: &Words, need: Need, fits: impl Fn(&Word) -> bool) -> Vec<Mutant> {
    let gone = words.words.iter().filter(|word| fits(word));
    gone.map(|word| {
        let (text, start, _) = words.rewritten(word, "");
        Mutant { text, place: Place::Needed(start, need) }
    })
    .collect()
}

fn missing_f(words: &Words) -> Vec<Mutant> {
    missing(words, Need::Cut, |word| word.address == 'F')
}

fn missing_s(words: &Words) -> Vec<Mutant> {
    missing(words, Need::Cut, |word| word.address == 'S' && !words.has_g(word.block, 50.0))
}

fn missing_m03(words: &Words) -> Vec<Mutant> {
    missing(words, Need::Cut, |word| word.address == 'M' && matches!(word.value, 3.0 | 4.0))
}

fn missing_feed_mode(words: &Words) -> Vec<Mutant> {
    missing(words, Need::Cut, |word| word.address == 'G' && matches!(word.value, 98.0 | 99.0))
}

fn other_feed_mode(words: &Words) -> Vec<Mutant> {
    let mut made = each(words, |_, word| match (word.address, word.value) {
        ('G', 98.0) => Some("G99".to_owned()),
        ('G', 99.0) => Some("G98".to_owned()),
        _ => None,
    });
    // The message is at the code, or at the first feed or cut that it changes.
    for mutant in &mut made {
        if let Place::At(start, _) = mutant.place {
            mutant.place = Place::Needed(start, Need::Cut);
        }
    }
    made
}

fn surface_speed_in_thread(words: &Words) -> Vec<Mutant> {
    let mut made = each(words, |words, word| {
        let is_thread = |other: &&Word| {
            other.start > word.start
                && other.address == 'G'
                && matches!(other.value, 1.0 | 2.0 | 3.0 | 90.0 | 94.0 | 32.0 | 34.0 | 92.0 | 76.0)
        };
        let next = words.words.iter().find(is_thread)?.value;
        (word.address == 'G' && word.value == 97.0 && matches!(next, 32.0 | 34.0 | 76.0 | 92.0))
            .then(|| "G96".to_owned())
    });
    for mutant in &mut made {
        if let Place::At(start, _) = mutant.place {
            mutant.place = Place::Needed(start, Need::Cut);
        }
    }
    made
}

fn missing_clamp(words: &Words) -> Vec<Mutant> {
    let mut made = Vec::new();
    for word in words.words.iter().filter(|word| word.address == 'S' && words.has_g(word.block, 50.0)) {
        let css = words
            .words
            .iter()
            .find(|other| other.address == 'G' && other.value == 96.0 && other.start > word.start);
        let Some(css) = css else { continue };
        let g50 = words.of_block(word.block).find(|other| other.address == 'G' && other.value == 50.0);
        let start = g50.map_or(word.start, |g50| g50.start.min(word.start));
        let (text, at, _) = words.replaced(start, word.end, "");
        let shift = word.end - start;
        made.push(Mutant { text, place: Place::Needed(at, Need::Word(css.start - shift, css.end - shift)) });
    }
    made
}

fn small_radius(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let arc = words.has_g(word.block, 2.0) || words.has_g(word.block, 3.0);
        (arc && word.address == 'R').then(|| format!("R{}", (word.value * 50.0).round() / 1000.0))
    })
}

fn no_radius(words: &Words) -> Vec<Mutant> {
    let mut made = Vec::new();
    for block in 0..words.blocks.len() {
        if !(words.has_g(block, 2.0) || words.has_g(block, 3.0)) {
            continue;
        }
        let centre: Vec<&Word> = words.of_block(block).filter(|word| "RIK".contains(word.address)).collect();
        let (Some(first), Some(last)) = (centre.first(), centre.last()) else { continue };
        let (text, start, _) = words.replaced(first.start, last.end, "");
        let (_, end) = words.blocks[block];
        let place = Place::At(words.blocks[block].0, end - (last.end - first.start));
        debug_assert!(start <= end);
        made.push(Mutant { text, place });
    }
    made
}

fn unclosed_comment(words: &Words) -> Vec<Mutant> {
    let mut made = Vec::new();
    for (at, _) in words.text.match_indices(')') {
        let (line, _) = words.line_at(at);
        let Some(open) = words.text[line..at].rfind('(') else { continue };
        let (text, ..) = words.replaced(at, at + 1, "");
        made.push(Mutant { text, place: Place::At(line + open, at) });
    }
    made
}

/// The first digit, point or minus after the letter, replaced by its full-width form.
fn full_width(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let written = words.written(word);
        let (at, old) = written.char_indices().nth(1)?;
        let twin = char::from_u32(old as u32 + 0xFEE0)?;
        (word.address != 'N').then(|| format!("{}{twin}{}", &written[..at], &written[at + 1..]))
    })
}

fn point_in_pq(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let written = words.written(word);
        (matches!(word.address, 'P' | 'Q') && !written.contains('.')).then(|| format!("{written}."))
    })
}

fn thread_angle(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let first = words.has_g(word.block, 76.0) && words.find(word.block, 'X').is_none();
        let written = words.written(word);
        (first && word.address == 'P' && written.len() == 7).then(|| format!("{}50", &written[..5]))
    })
}

fn allowance_sign(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let allowance = matches!(word.address, 'U' | 'W')
            && words.find(word.block, 'P').is_some()
            && CONTOUR_CYCLES[1..].iter().any(|&code| words.has_g(word.block, code));
        (allowance && word.value != 0.0).then(|| {
            let number = &words.written(word)[1..];
            match number.strip_prefix('-') {
                Some(rest) => format!("{}{rest}", word.address),
                None => format!("{}-{number}", word.address),
            }
        })
    })
}

fn missing_end(words: &Words) -> Vec<Mutant> {
    missing(words, Need::End, |word| word.address == 'M' && matches!(word.value, 2.0 | 30.0))
}

fn forbidden_in_polar(words: &Words) -> Vec<Mutant> {
    let mut inside = false;
    let mut made = Vec::new();
    for block in 0..words.blocks.len() {
        if words.has_g(block, 12.1) || words.has_g(block, 112.0) {
            inside = true;
            continue;
        }
        if words.has_g(block, 13.1) || words.has_g(block, 113.0) {
            inside = false;
        }
        if !inside {
            continue;
        }
        let (start, _) = words.blocks[block];
        for insert in ["G50 S1000", "T0202"] {
            let (text, from, to) = words.replaced(start, start, &format!("{insert}\n"));
            made.push(Mutant { text, place: Place::At(from, to - 1) });
        }
        for word in words.of_block(block).filter(|word| word.address == 'G' && word.value == 1.0) {
            made.push(Mutant::at(words.rewritten(word, "G00")));
        }
    }
    made
}

/// Halves the last X of a rapid before a cycle, so that it is far inside the blank.
fn start_inside(words: &Words) -> Vec<Mutant> {
    let cycles = [71.0, 72.0, 73.0, 75.0, 90.0, 92.0, 94.0, 76.0];
    let mut made = Vec::new();
    for block in 1..words.blocks.len() {
        let starts = |block: usize, code: f64| words.has_g(block, code);
        if !cycles.iter().any(|&code| starts(block, code) && !starts(block - 1, code)) {
            continue;
        }
        let mut before = words.words.iter().filter(|word| word.address == 'X' && word.block < block);
        let Some(x) = before.next_back() else { continue };
        let end = words.words.iter().find(|word| word.address == 'X' && word.block >= block);
        if end.is_some_and(|end| end.value >= x.value) || !words.has_g(x.block, 0.0) {
            continue;
        }
        let half = (x.value / 2.0 * 10.0).round() / 10.0;
        let (text, start, stop) = words.rewritten(x, &format!("X{half}"));
        // The rapid that enters the blank, or the cycle that starts there.
        let shift = |at: usize| at + stop - start - (x.end - x.start);
        // Multiple repetitive cycles can have two blocks.
        let last = (block..words.blocks.len()).take_while(|&next| {
            cycles.iter().any(|&code| words.has_g(block, code) && words.has_g(next, code))
        });
        let ((from, _), (_, to)) = (words.blocks[block], words.blocks[last.last().unwrap_or(block)]);
        if made.last().is_none_or(|made: &Mutant| made.text != text) {
            let place = Place::Needed(start, Need::Word(shift(from), shift(to)));
            made.push(Mutant { text, place });
        }
    }
    made
}

fn fast_thread(words: &Words) -> Vec<Mutant> {
    let mut made = each(words, |words, word| {
        let is_cut = |other: &&Word| {
            other.start > word.start
                && (other.address == 'S'
                    || other.address == 'G'
                        && matches!(other.value, 1.0 | 2.0 | 3.0 | 90.0 | 94.0 | 32.0 | 34.0 | 92.0 | 76.0))
        };
        let next = words.words.iter().find(is_cut)?;
        let thread = next.address == 'G' && matches!(next.value, 32.0 | 34.0 | 76.0 | 92.0);
        (word.address == 'S' && thread && !words.has_g(word.block, 50.0)).then(|| "S3000".to_owned())
    });
    for mutant in &mut made {
        if let Place::At(start, _) = mutant.place {
            mutant.place = Place::Needed(start, Need::Cut);
        }
    }
    made
}

fn missing_program(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let call = words.of_block(word.block).any(|other| {
            (other.address == 'M' && other.value == 98.0) || (other.address == 'G' && other.value == 65.0)
        });
        (call && word.address == 'P').then(|| "P7777".to_owned())
    })
}

/// The blocks of each G92 and of its further passes.
fn threads(words: &Words) -> Vec<Vec<usize>> {
    let mut threads: Vec<Vec<usize>> = Vec::new();
    let mut goes_on = false;
    for block in 0..words.blocks.len() {
        let has_code = words.of_block(block).any(|word| matches!(word.address, 'G' | 'M' | 'T'));
        if words.has_g(block, 92.0) && words.find(block, 'F').is_some() {
            threads.push(vec![block]);
            goes_on = true;
        } else if has_code || words.find(block, 'X').is_none() {
            goes_on = false;
        } else if let Some(thread) = threads.last_mut().filter(|_| goes_on) {
            thread.push(block);
        }
    }
    threads
}

/// Halves the lead of a later pass.
fn another_lead(words: &Words) -> Vec<Mutant> {
    let passes = threads(words).into_iter().flat_map(|thread| {
        let lead = words.find(thread[0], 'F').map_or(1.0, |word| word.value);
        thread.into_iter().skip(1).map(move |block| (block, lead))
    });
    let mutants = passes.filter_map(|(block, lead)| {
        let end = words.of_block(block).last()?.end;
        let (text, start, end) = words.replaced(end, end, &format!(" F{}", lead / 2.0));
        Some(Mutant { text, place: Place::At(start + 1, end) })
    });
    mutants.collect()
}

/// Swaps the diameters of two consecutive passes: the second one removes nothing.
fn passes_exchanged(words: &Words) -> Vec<Mutant> {
    let threads = threads(words);
    let pairs = threads.iter().flat_map(|thread| thread.windows(2));
    let mutants = pairs.filter_map(|pair| {
        let (first, second) = (words.find(pair[0], 'X')?, words.find(pair[1], 'X')?);
        let (first_text, second_text) = (words.written(first), words.written(second));
        if first.value == second.value {
            return None;
        }
        let (between, rest) = (&words.text[first.end..second.start], &words.text[second.end..]);
        let head = format!("{}{second_text}{between}", &words.text[..first.start]);
        let place = Place::At(head.len(), head.len() + first_text.len());
        Some(Mutant { text: format!("{head}{first_text}{rest}"), place })
    });
    mutants.collect()
}

/// Each F of a thread that one of these codes cuts, spelled differently.
fn each_lead(words: &Words, codes: &[f64], change: impl Fn(f64) -> Option<String>) -> Vec<Mutant> {
    each(words, |words, word| {
        let is_thread = codes.iter().any(|&code| words.has_g(word.block, code));
        (word.address == 'F' && is_thread).then(|| change(word.value))?
    })
}

/// Not for G32, which is also used for tapping: expanded hole cycles have any lead.
fn lead_too_small(words: &Words) -> Vec<Mutant> {
    each_lead(words, &[92.0, 76.0], |lead| (lead < 2.0).then(|| format!("F{}", lead / 10.0)))
}

/// F in mm/min, as for turning, instead of the lead.
fn feed_for_lead(words: &Words) -> Vec<Mutant> {
    each_lead(words, &[32.0, 92.0, 76.0], |_| Some("F600".to_owned()))
}

fn angle_in_degrees(words: &Words) -> Vec<Mutant> {
    let passes = threads(words).concat();
    each(words, |words, word| {
        let is_start = words.has_g(word.block, 32.0) || passes.contains(&word.block);
        (word.address == 'Q' && is_start && word.value >= 1000.0).then(|| format!("Q{}", word.value / 1000.0))
    })
}

/// A tap leaves its hole with half the lead of its entry.
fn tap_lead(words: &Words) -> Vec<Mutant> {
    let is_tap = |block: usize| {
        let on_axis = words.find(block, 'X').is_none() && words.find(block, 'U').is_none();
        words.has_g(block, 32.0) && on_axis
    };
    each(words, |words, word| {
        let reverses =
            |block: usize| words.of_block(block).any(|word| word.address == 'M' && word.value == 4.0);
        let out = word.address == 'F' && is_tap(word.block) && word.block > 0 && reverses(word.block - 1);
        out.then(|| format!("F{}", word.value / 2.0))
    })
}

/// The centre of an arc on the end face, with the letter used for turning.
fn centre_letter(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let is_arc = words.has_g(word.block, 2.0) || words.has_g(word.block, 3.0);
        let written = words.written(word);
        (word.address == 'J' && is_arc && word.value != 0.0).then(|| format!("K{}", &written[1..]))
    })
}

/// Adds letters of other blocks to a move.
fn unread_word(words: &Words) -> Vec<Mutant> {
    let moves = (0..words.blocks.len()).filter(|&block| {
        let codes = || words.of_block(block).filter(|word| matches!(word.address, 'G' | 'M'));
        let is_move = |word: &Word| word.address == 'G' && word.value <= 3.0;
        codes().next().is_some() && codes().all(is_move) && words.find(block, 'Z').is_some()
    });
    let mutants = moves.filter_map(|block| {
        let end = words.of_block(block).last()?.end;
        Some(Mutant::at(words.replaced(end, end, " Q2")))
    });
    mutants.collect()
}

/// I or K of an arc with the opposite sign.
fn center_sign(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let arc = words.has_g(word.block, 2.0) || words.has_g(word.block, 3.0);
        // A full circle ends at its start, whatever its centre.
        let is_full = words.find(word.block, 'C').is_some();
        let is_center = matches!(word.address, 'I' | 'K') && arc && !is_full && word.value != 0.0;
        let number = &words.written(word)[1..];
        is_center.then(|| match number.strip_prefix('-') {
            Some(rest) => format!("{}{rest}", word.address),
            None => format!("{}-{number}", word.address),
        })
    })
}

/// Swaps seconds and milliseconds.
fn other_dwell(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| match word.address {
        _ if !words.has_g(word.block, 4.0) => None,
        'X' | 'U' => Some(format!("{}{}", word.address, 1000.0 * word.value)),
        'P' if word.value >= 1000.0 => Some(format!("P{}", word.value / 1000.0)),
        _ => None,
    })
}

/// A tool with the next offset number, in programs with several tools.
fn other_offset(words: &Words) -> Vec<Mutant> {
    let is_tool = |word: &&Word| word.address == 'T' && word.value >= 100.0 && word.value % 100.0 > 0.0;
    let mut tools: Vec<f64> = words.words.iter().filter(is_tool).map(|word| word.value).collect();
    tools.sort_by(f64::total_cmp);
    tools.dedup();
    if tools.len() < 4 {
        return Vec::new();
    }
    each(words, |_, word| is_tool(&word).then(|| format!("T{:04}", word.value + 1.0)))
}

/// Inserts M30 before a moving block in the middle.
fn early_end(words: &Words) -> Vec<Mutant> {
    let all = words.blocks.len();
    let moves = (all / 2..all).filter(|&block| {
        words.find(block, 'X').is_some() && words.find(block, 'Z').is_some() && words.has_g(block, 0.0)
    });
    let mutants = moves.map(|block| {
        let (start, end) = words.blocks[block];
        let (text, ..) = words.replaced(start, start, "M30\n");
        Mutant { text, place: Place::At(start + 4, end + 4) }
    });
    mutants.collect()
}

fn vacant_variable(words: &Words) -> Vec<Mutant> {
    let cycles = [28.0, 30.0, 50.0, 4.0, 10.0, 52.0, 65.0, 70.0, 71.0, 72.0, 73.0, 74.0, 75.0, 76.0];
    each(words, |words, word| {
        let other_use = cycles.iter().any(|&code| words.has_g(word.block, code));
        (word.address == 'Z' && !other_use).then(|| "Z#33".to_owned())
    })
}

fn turns_for_metres(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        (word.address == 'S' && words.has_g(word.block, 96.0)).then(|| "S2500".to_owned())
    })
}

/// F of cuts under G99, too large.
fn feed_too_large(words: &Words) -> Vec<Mutant> {
    let threads = [32.0, 33.0, 34.0, 76.0, 84.0, 92.0];
    each(words, |words, word| {
        let is_thread = threads.iter().any(|&code| words.has_g(word.block, code));
        let is_feed = word.address == 'F' && (0.1..0.5).contains(&word.value) && !is_thread;
        is_feed.then(|| format!("F{}", 10.0 * word.value))
    })
}

/// A point that at least three blocks name; one of them has X and Z swapped.
fn axes_exchanged(words: &Words) -> Vec<Mutant> {
    let place = |block: usize| {
        let plain = words.of_block(block).all(|word| "GXZMNST".contains(word.address));
        let other_use = [28.0, 30.0, 50.0, 4.0, 10.0, 52.0].iter().any(|&code| words.has_g(block, code));
        let (x, z) = (words.find(block, 'X')?, words.find(block, 'Z')?);
        (plain && !other_use && x.value != z.value && x.end <= z.start).then_some((x, z))
    };
    let places: Vec<_> = (0..words.blocks.len()).filter_map(place).collect();
    let often = places.iter().filter(|(x, z)| {
        places
            .iter()
            .filter(|(other_x, other_z)| (other_x.value, other_z.value) == (x.value, z.value))
            .count()
            > 2
    });
    let mutants = often.map(|(x, z)| {
        let between = &words.text[x.end..z.start];
        let with = format!("X{}{between}Z{}", &words.written(z)[1..], &words.written(x)[1..]);
        Mutant::at(words.replaced(x.start, z.end, &with))
    });
    mutants.collect()
}

/// Removes the start angle from a pass of a multiple-start thread.
fn angle_lost(words: &Words) -> Vec<Mutant> {
    let passes = threads(words).concat();
    let mut made = each(words, |_, word| {
        (word.address == 'Q' && passes.contains(&word.block) && word.value >= 1000.0).then(String::new)
    });
    for mutant in &mut made {
        if let Place::At(start, _) = mutant.place {
            mutant.place = Place::Needed(start, Need::Cut);
        }
    }
    made
}

/// The infeed of G71 and G72 multiplied by ten: U2 as U20.
fn depth_ten_times(words: &Words) -> Vec<Mutant> {
    let mut made = each(words, |words, word| {
        let is_infeed = is_depth(words, word) && matches!(word.address, 'U' | 'W');
        (is_infeed && word.value >= 1.0).then(|| format!("{}{}", word.address, 10.0 * word.value))
    });
    for mutant in &mut made {
        if let Place::At(start, _) = mutant.place {
            mutant.place = Place::Needed(start, Need::Cut);
        }
    }
    made
}

/// A pass of G90 that cuts nearly to the axis: X46 as X4.6.
fn pass_too_deep(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let is_pass = single_cycle(words, word.block) == Some(90) && word.address == 'X';
        (is_pass && word.value >= 20.0).then(|| format!("X{}", word.value / 10.0))
    })
}

/// The end of a pass of G90 multiplied by ten: Z-30 as Z-300.
fn end_behind_blank(words: &Words) -> Vec<Mutant> {
    each(words, |words, word| {
        let is_pass = single_cycle(words, word.block) == Some(90) && word.address == 'Z';
        (is_pass && word.value <= -10.0).then(|| format!("Z{}", 10.0 * word.value))
    })
}
