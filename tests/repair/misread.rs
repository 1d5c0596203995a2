//! Faults of text recognition and manual copying, at random places of a program.
//!
//! In: a correct program. Out: the program with one fault, and the line of the fault.

/// Pseudo-random numbers, the same in every run (SplitMix64).
pub struct Random(pub u64);

impl Random {
    /// A number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) % end as u64) as usize
    }

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }
}

/// Digits, and characters that look like them.
const DIGITS: [(char, &[&str]); 10] = [
    ('0', &["O", "o", "Q", "D", "º", "°", "()"]),
    ('1', &["l", "I", "i", "|", "!"]),
    ('2', &["Z", "z"]),
    ('3', &["E", "З"]),
    ('4', &["A"]),
    ('5', &["S", "s"]),
    ('6', &["G", "b", "б"]),
    ('7', &["T", "?"]),
    ('8', &["B"]),
    ('9', &["g", "q"]),
];

/// Letters, and characters that look like them.
const LETTERS: [(char, &[&str]); 12] = [
    ('G', &["6", "C"]),
    ('S', &["5", "$"]),
    ('Z', &["2", "7"]),
    ('X', &["×", "Х", "K"]),
    ('O', &["0"]),
    ('B', &["8"]),
    ('T', &["7", "Т"]),
    ('M', &["N", "М"]),
    ('F', &["P", "E"]),
    ('U', &["V", "0"]),
    ('I', &["1", "l"]),
    ('R', &["A", "P"]),
];

/// Text after a block.
const WORDS: [&str; 27] = [
    "retract",
    "home",
    "rpm",
    "mm",
    "ok",
    "tool",
    "TOOL CHANGE",
    "finish pass",
    "rough to size",
    "go",
    "GO HOME",
    "safe.",
    "“safe”",
    "3mm",
    "2nd",
    "退刀",
    "отвод",
    "Fläche",
    "face and turn",
    "shift",
    "done",
    "end",
    "AND",
    "(slow) now",
    "semi-finish",
    "Z",
    "no coolant",
];

/// A program with a fault, and the line of the fault.
pub struct Fault {
    pub class: &'static str,
    pub text: String,
    pub line: usize,
}

/// One fault at a random place; `None` if the class does not fit the line.
pub fn fault(text: &str, random: &mut Random) -> Option<Fault> {
    type Misread = fn(&str, &mut Random) -> Option<String>;
    const CLASSES: [(&str, Misread); 21] = [
        ("letter for a digit", |line, random| misread(line, random, &DIGITS)),
        ("letters for all digits of a word", all_digits),
        ("digit for a letter", |line, random| misread(line, random, &LETTERS)),
        ("full-width character", full_width),
        ("full-width line", |line, _| Some(line.chars().map(wide).collect())),
        ("printed dash", |line, random| {
            let dash = random
                .of(&["\u{2212}", "\u{2013}", "\u{2014}", "\u{ff0d}", "\u{2010}", "--", "- ", "~", "_"]);
            replaced(line, random, |sign| (sign == '-').then(|| dash.to_owned()))
        }),
        ("blank in a number", |line, random| {
            insert(line, random, " ", |before, after| before.is_ascii_digit() && after.is_ascii_digit())
        }),
        ("blank after a letter", |line, random| {
            insert(line, random, " ", |before, _| before.is_ascii_alphabetic())
        }),
        ("blank lost", |line, random| replaced(line, random, |sign| (sign == ' ').then(String::new))),
        ("comma for a point", |line, random| {
            let mark = random.of(&[",", " ,", ", ", "，", "·", ":", ";", "..", " ."]);
            replaced(line, random, |sign| (sign == '.').then(|| mark.to_owned()))
        }),
        ("comma word misread", |line, random| {
            replaced(line, random, |sign| (sign == ',').then(|| ".".to_owned()))
        }),
        ("sign after a letter", |line, random| {
            let sign = random.of(&["=", ":", "= ", "º", "°", "*"]);
            insert(line, random, sign, |before, after| before.is_ascii_alphabetic() && after.is_ascii_digit())
        }),
        ("text after the block", |line, random| Some(format!("{line} {}", random.of(&WORDS)))),
        ("text before the block", |line, random| Some(format!("{} {line}", random.of(&WORDS)))),
        ("text in the block", |line, random| {
            let word = format!(" {}", random.of(&WORDS));
            insert(line, random, &word, |_, after| after == ' ')
        }),
        ("text without a blank", |line, random| Some(format!("{line}{}", random.of(&WORDS)))),
        ("bracket lost", |line, random| replaced(line, random, |sign| (sign == ')').then(String::new))),
        ("bracket misread", |line, random| {
            replaced(line, random, |sign| match sign {
                '(' => Some("（".into()),
                ')' => Some("）".into()),
                _ => None,
            })
        }),
        ("number lost", |line, random| {
            let at = place(line, random, |before, after| {
                before.is_ascii_alphabetic() && (after.is_ascii_digit() || after == '-')
            })?;
            let rest = line[at..]
                .trim_start_matches(|sign: char| sign.is_ascii_digit() || matches!(sign, '-' | '.'));
            Some(format!("{}{rest}", &line[..at]))
        }),
        ("letter lost", |line, random| {
            replaced(line, random, |sign| sign.is_ascii_alphabetic().then(String::new))
        }),
        ("character of control", |line, random| {
            Some(format!("{line}{}", random.of(&["\u{c}", "\u{1a}", "\0", "\u{b}", "\u{7f}", "\u{a0}"])))
        }),
    ];
    let lines: Vec<&str> = text.lines().collect();
    let line = random.below(lines.len());
    let (class, make) = CLASSES[random.below(CLASSES.len())];
    let with = make(lines[line], random).filter(|with| with != lines[line])?;
    let mut all: Vec<&str> = lines;
    all[line] = &with;
    Some(Fault { class, text: all.join("\n") + "\n", line })
}

fn wide(sign: char) -> char {
    if sign.is_ascii_graphic() { char::from_u32(sign as u32 + 0xFEE0).unwrap_or(sign) } else { sign }
}

fn full_width(line: &str, random: &mut Random) -> Option<String> {
    replaced(line, random, |sign| sign.is_ascii_graphic().then(|| wide(sign).to_string()))
}

/// Replaces one of the characters for which `with` has a replacement.
fn replaced(line: &str, random: &mut Random, with: impl Fn(char) -> Option<String>) -> Option<String> {
    let fitting: Vec<(usize, char)> = line.char_indices().filter(|(_, sign)| with(*sign).is_some()).collect();
    let (at, sign) = *fitting.get(random.below(fitting.len().max(1)))?;
    Some(format!("{}{}{}", &line[..at], with(sign)?, &line[at + sign.len_utf8()..]))
}

fn misread(line: &str, random: &mut Random, table: &[(char, &'static [&'static str])]) -> Option<String> {
    let choice = random.below(64);
    replaced(line, random, |sign| {
        let (_, read) = table.iter().find(|(right, _)| *right == sign)?;
        Some(read[choice % read.len()].to_owned())
    })
}

/// Replaces all digits of a word that look like a letter.
fn all_digits(line: &str, random: &mut Random) -> Option<String> {
    let at = place(line, random, |before, after| before.is_ascii_alphabetic() && after.is_ascii_digit())?;
    let len = line[at..].bytes().take_while(u8::is_ascii_digit).count();
    let read = |digit: char| DIGITS.iter().find(|(right, _)| *right == digit).map_or("", |(_, read)| read[0]);
    Some(format!(
        "{}{}{}",
        &line[..at],
        line[at..at + len].chars().map(read).collect::<String>(),
        &line[at + len..]
    ))
}

/// A random position between two characters that fit.
fn place(line: &str, random: &mut Random, fits: impl Fn(char, char) -> bool) -> Option<usize> {
    let pairs = line.char_indices().zip(line.char_indices().skip(1));
    let places: Vec<usize> =
        pairs.filter(|((_, before), (_, after))| fits(*before, *after)).map(|(_, (at, _))| at).collect();
    places.get(random.below(places.len().max(1))).copied()
}

fn insert(line: &str, random: &mut Random, with: &str, fits: impl Fn(char, char) -> bool) -> Option<String> {
    let at = place(line, random, fits)?;
    Some(format!("{}{with}{}", &line[..at], &line[at..]))
}
