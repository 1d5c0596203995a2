//! Reads the setup from comments of the program, which a control ignores:
//!
//! ```text
//! (STOCK D=65 BORE=18 LENGTH=80 FACE=1 GRIP=30)
//! (STOCK X=0 Z=2 X=30 Z=2 X=30 Z=-20)
//! (STOCK X=50 Z=-30 X=50 Z=-60 GRIP=15)
//! (TOOL T0101 TYPE=TURNING INSERT=CNMG120408 KR=95)
//! (TOOL T0303 TYPE=GROOVING WIDTH=3 REACH=12)
//! (TAILSTOCK Z=2 D=20)
//! (MACHINE RAPIDX=8000 RAPIDZ=12000 MAXSPEED=4000 TURRET=FRONT)
//! (START X=200 Z=200)
//! (DIALECT DECIMAL=LEASTINCREMENT)
//! (RULES CLASSROOM=WARNING NO-PROGRAM-END=OFF)
//! ```
//!
//! and `[BILLET X62 Z70`, the notation of class simulators for a bar of 62 mm, 70 mm long.
//!
//! In: the text of a program. Out: the settings in its first lines, and the words that cannot be read. A
//! comment that begins with one of these keywords, but has no `=` or several words without one, is prose.

use std::borrow::Cow;

use super::blank::PointReader;
use super::fields::{self, Entry, Field, Name, Unit, Value};
use super::first_unit;
use super::invalid::InvalidValue;
use super::nose_comment::{self, DescribedNose};
use super::{Blank, Machine, Position, Setup, Stock, Tailstock, Tool};
use crate::message::levels::{self, known};
use crate::message::{Diagnostic, Fix, Levels, Severity, said};
use crate::parts::{Part, early};
use crate::setup::dialect::DialectChoice;
use crate::source::Span;
use crate::units::{Diameter, read_number};

/// Number of bytes at the beginning of a text that are searched for notes.
pub const HEAD: usize = 1 << 16;

/// The settings in the comments of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Notes {
    /// The blank.
    pub stock: Option<Blank>,
    /// Tools by their T word in four digits.
    pub tools: Vec<(String, Tool)>,
    /// The tailstock.
    pub tailstock: Option<Tailstock>,
    /// The machine.
    pub machine: Option<Machine>,
    /// Position of the tip before the first block.
    pub start: Option<Position>,
    /// The control and its switches.
    pub dialect: DialectChoice,
    /// The severity of rules.
    pub rules: Levels,
    /// The noses of tools described by prose.
    pub noses: Vec<DescribedNose>,
    /// The words that cannot be read.
    pub unreadable: Vec<UnreadableWord>,
    /// The span of each note, with the beginning of its key in a setup, such as `stock.`.
    places: Vec<(String, Span)>,
}

/// A word of a note that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadableWord {
    /// The word.
    pub span: Span,
    /// The words that are accepted there.
    pub expected: Cow<'static, str>,
    /// The accepted word that its key is probably a misspelling of.
    pub nearest: Option<&'static str>,
}

impl UnreadableWord {
    /// The message about the word; its fix corrects the key.
    pub(super) fn diagnostic(&self, text: &[u8]) -> Diagnostic {
        let word = self.span.quote(text);
        let key = word.split('=').next().map_or(0, str::len) as u32;
        let told =
            Diagnostic::new(said::NoteWord { word, expected: self.expected.clone().into_owned() }, self.span);
        let key = Span { end: self.span.start + key, ..self.span };
        let fix = self.nearest.map(|nearest| Fix::write(key, nearest.to_owned()));
        Diagnostic { fixes: fix.into_iter().collect(), ..told }
    }
}

/// A word of a note: `KEY=value`, or a name alone.
pub(super) struct Word<'a> {
    key: String,
    value: &'a str,
    span: Span,
}

impl<'a> Word<'a> {
    /// Its key in capitals; the whole word, if it has no value.
    pub(super) fn key(&self) -> &str {
        &self.key
    }

    /// Its value, if it has this key.
    pub(super) fn value_of(&self, key: &str) -> Option<&'a str> {
        Some(self.value).filter(|value| self.key == key && !value.is_empty())
    }

    /// Its place.
    pub(super) fn span(&self) -> Span {
        self.span
    }

    /// Whether it is a coordinate of a point of an outline.
    fn is_of_point(&self) -> bool {
        matches!(&*self.key, "X" | "Z")
    }
}

/// The first word of a note. The last keyword is in brackets, the others are in parentheses.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Keyword {
    Stock,
    Tool,
    Tailstock,
    Machine,
    Start,
    Dialect,
    Rules,
    Billet,
}

impl Keyword {
    const ALL: [Self; 8] = [
        Self::Stock,
        Self::Tool,
        Self::Tailstock,
        Self::Machine,
        Self::Start,
        Self::Dialect,
        Self::Rules,
        Self::Billet,
    ];

    const fn name(self) -> &'static str {
        match self {
            Self::Stock => "STOCK",
            Self::Tool => "TOOL",
            Self::Tailstock => "TAILSTOCK",
            Self::Machine => "MACHINE",
            Self::Start => "START",
            Self::Dialect => "DIALECT",
            Self::Rules => "RULES",
            Self::Billet => "BILLET",
        }
    }
}

/// The words of a stock note: of a bar or tube, and of an outline.
pub const STOCK_WORDS: [&str; 2] = ["D=, BORE=, LENGTH=, FACE=, GRIP=; X=, Z=, GRIP=", "X=, Z=, GRIP="];

/// The words of a tool note.
pub const TOOL_WORDS: &str = "TYPE=TURNING (BORING, GROOVING, THREADING, DRILL, TAP, ENDMILL), SIDE=OUTSIDE (INSIDE, FACE), INSERT=, R=, TIP=, KR=, POINT=, EDGE=, WIDTH=, D=, REACH=, SHANK=, ANGLE=, CUTTER=, OFFSETX=, OFFSETZ=, OFFSETR=, WEARX=, WEARZ=, WEARR=";

/// The words of a rules note.
pub const RULE_WORDS: &str = "CLASSROOM=OFF (INFO, WARNING, ERROR)";

/// The words of a note of the control's switches.
pub const DIALECT_WORDS: &str = "CONTROL=FANUC (GSK, FORUM), GSYSTEM=A (B, C), UNIT=MM (INCH), FEEDMODE=G99 (G98), DECIMAL=AUTO (CALCULATOR, LEASTINCREMENT), PQUNIT=AUTO (UM, MM), REFX=, REFZ=, RECOGNISE=TRUE (FALSE), STRICT=FALSE (TRUE), TYPEII=TRUE (FALSE), NEGATIVEARCR=OVER180 (ALARM)";

/// Most unknown rule names for which the nearest name is searched.
const NEAREST: usize = 20;

/// The words of a machine note.
pub const MACHINE_WORDS: &str = "RAPIDX=, RAPIDZ=, MAXSPEED=, THREADK=, XMIN=, XMAX=, ZMIN=, ZMAX=, TURRET=FRONT, TURRET=REAR, YAXIS=TRUE (FALSE)";

impl Notes {
    /// Reads the comments at the head of a text.
    pub fn read(text: &[u8]) -> Self {
        if Self::may_contain_notes(text) { read(text) } else { Self::default() }
    }

    /// Whether a text may have notes; only then reading them needs the part `Early` of the module. Never
    /// false if there are notes.
    pub fn may_contain_notes(text: &[u8]) -> bool {
        comments(text)
            .any(|comment| comment.keyword().is_some() || nose_comment::may_describe(comment.inside))
    }

    /// Whether the notes of a text can be read now: there are none, or the part that reads them is loaded.
    pub fn can_be_read(text: &[u8]) -> bool {
        Part::Early.is_loaded() || !Self::may_contain_notes(text)
    }

    /// The setup with its values overridden by the notes.
    pub fn applied_to(&self, setup: Setup) -> Setup {
        if self.places.is_empty() && self.noses.is_empty() { setup } else { applied(self, setup) }
    }

    /// The diagnostics of the notes; `invalid` are the invalid values of the whole setup.
    pub fn diagnostics(&self, invalid: Vec<InvalidValue>, text: &[u8]) -> Vec<Diagnostic> {
        if self.unreadable.is_empty() && invalid.is_empty() {
            Vec::new()
        } else {
            reported(self, invalid, text)
        }
    }

    /// Whether these are the notes of a text.
    pub fn match_text(&self, text: &[u8]) -> bool {
        if Self::may_contain_notes(text) { match_text(self, text) } else { *self == Self::default() }
    }

    /// Reads a note that begins at byte `start` of a text.
    fn note(&mut self, keyword: Keyword, inside: &str, start: usize, text: &[u8]) {
        let words = words(inside, start);
        let Some((_, rest)) = words.split_first() else { return };
        if keyword == Keyword::Billet {
            return self.billet(inside, start);
        }
        if !has_value(inside) {
            return;
        }
        let whole = Span::new(start, start + inside.len());
        match keyword {
            Keyword::Billet => {}
            Keyword::Stock => {
                let before = self.stock.take().filter(|_| self.continues_stock(start, text));
                let before = before.filter(|before| before.outline().is_some());
                let has_grip_alone = || rest.iter().all(|word| word.key == "GRIP");
                let blank = if rest.iter().any(Word::is_of_point) || before.is_some() && has_grip_alone() {
                    self.outlined(rest, before)
                } else {
                    self.bar(rest).into()
                };
                self.stock = Some(blank);
                self.add_place("stock.", whole);
            }
            Keyword::Tool => self.tool(rest, whole),
            Keyword::Tailstock => {
                let mut tailstock = Tailstock { z: 0.0, diameter: Diameter::new(20.0) };
                self.fill(rest, fields::TAILSTOCK, &mut tailstock, "Z=, D=");
                self.tailstock = Some(tailstock);
                self.add_place("tailstock.", whole);
            }
            Keyword::Machine => {
                let mut machine = Machine::default();
                self.fill(rest, fields::MACHINE, &mut machine, MACHINE_WORDS);
                self.machine = Some(machine);
                self.add_place("machine.", whole);
            }
            Keyword::Start => {
                let mut position = Setup::default().start();
                self.fill(rest, fields::START, &mut position, "X=, Z=");
                self.start = Some(position);
                self.add_place("initial.", whole);
            }
            Keyword::Dialect => {
                let mut dialect = DialectChoice::default();
                self.fill(rest, fields::DIALECT, &mut dialect, DIALECT_WORDS);
                self.dialect = dialect;
                self.add_place("dialect.", whole);
            }
            Keyword::Rules => {
                rest.iter().for_each(|word| self.rule(word));
                self.add_place("rules.", whole);
            }
        }
    }

    fn bar(&mut self, words: &[Word]) -> Stock {
        let mut stock = Stock {
            diameter: Diameter::default(),
            bore: Diameter::default(),
            face: 0.0,
            length: 0.0,
            grip: None,
        };
        self.fill(words, fields::STOCK, &mut stock, STOCK_WORDS[0]);
        stock
    }

    /// Whether a note follows a stock note, with nothing but sequence numbers between them.
    fn continues_stock(&self, start: usize, text: &[u8]) -> bool {
        let between = |byte: &u8| {
            byte.is_ascii_whitespace()
                || byte.is_ascii_digit()
                || matches!(byte, b'(' | b')' | b';' | b'N' | b'n')
        };
        let last = self.places.last().filter(|place| place.0 == "stock.");
        last.is_some_and(|(_, span)| text[span.end as usize..start].iter().all(between))
    }

    /// A blank with an outline. If `before` has an outline, the points continue it.
    fn outlined(&mut self, words: &[Word], before: Option<Blank>) -> Blank {
        let mut grip = before.as_ref().and_then(|before| before.extents().grip);
        let outline = before.as_ref().and_then(Blank::outline);
        let mut reader = outline.map_or_else(PointReader::default, PointReader::after);
        let mut last: Option<&Word> = None;
        let mut is_whole = true;
        for word in words {
            let value = match Entry::Number(Unit::Millimetre).read(word.value) {
                Ok(Value::Number(value)) => Some(value),
                _ => None,
            };
            let is_read = match (&*word.key, value) {
                ("GRIP", Some(value)) => {
                    grip = Some(value);
                    true
                }
                ("X", Some(value)) => reader.add('X', value).is_ok(),
                ("Z", Some(value)) => reader.add('Z', value).is_ok(),
                _ => false,
            };
            if !is_read {
                self.refuse_of_outline(word);
                is_whole = false;
            }
            if word.is_of_point() {
                last = Some(word);
            }
            // Later points would be consequences.
            if !is_whole && word.is_of_point() {
                break;
            }
        }
        let read = reader.end();
        // An X without its Z.
        if let (Err(_), true, Some(word)) = (&read, is_whole, last) {
            self.refuse_of_outline(word);
        }
        Blank::with_outline(read.unwrap_or_default(), grip)
    }

    fn refuse_of_outline(&mut self, word: &Word) {
        self.unreadable.push(UnreadableWord {
            span: word.span,
            expected: STOCK_WORDS[1].into(),
            nearest: nearest(&word.key, std::iter::once("GRIP")),
        });
    }

    fn tool(&mut self, words: &[Word], whole: Span) {
        let expected = "T and four digits, such as T0101";
        let Some((name, rest)) = words.split_first() else { return };
        let Some(key) = tool_name(&name.key) else {
            self.unreadable.push(UnreadableWord {
                span: name.span,
                expected: expected.into(),
                nearest: None,
            });
            return;
        };
        let mut tool = Tool::default();
        self.fill(rest, fields::TOOL, &mut tool, TOOL_WORDS);
        self.add_place(&format!("tools.{key}."), whole);
        self.tools.push((key, tool));
    }

    fn rule(&mut self, word: &Word) {
        let name = known(&word.key);
        if let (Some(name), Some(level)) = (name, Severity::named(word.value)) {
            self.rules.set(name, level);
            return;
        }
        let may_look = self.unreadable.len() < NEAREST;
        let nearest = if name.is_none() && may_look { levels::nearest(&word.key) } else { None };
        let name = name.or(nearest);
        let expected = name.map(|name| format!("{}=OFF (INFO, WARNING, ERROR)", name.to_ascii_uppercase()));
        let expected = expected.map_or(RULE_WORDS.into(), Cow::from);
        self.unreadable.push(UnreadableWord { span: word.span, expected, nearest });
    }

    fn add_place(&mut self, key: &str, span: Span) {
        self.places.push((key.to_owned(), span));
    }

    /// The spans of the notes, without parentheses.
    pub fn spans(&self) -> impl Iterator<Item = Span> {
        self.places.iter().map(|place| place.1)
    }

    /// Whether a note sets this key of a setup, such as `stock.` or `tools.T0101.`.
    pub fn names(&self, key: &str) -> bool {
        self.places.iter().any(|place| place.0 == key)
    }

    /// `[BILLET X62 Z70`: diameter and length; the face is at Z0.
    fn billet(&mut self, inside: &str, start: usize) {
        let mut words = inside.split_ascii_whitespace().skip(1);
        let mut number = |letter: [char; 2]| words.next()?.strip_prefix(letter).and_then(read_number);
        if let (Some(diameter), Some(length)) = (number(['X', 'x']), number(['Z', 'z'])) {
            self.add_place("stock.", Span::new(start, start + inside.len()));
            let (diameter, bore) = (Diameter::new(diameter), Diameter::default());
            self.stock = Some(Stock { diameter, bore, face: 0.0, length, grip: None }.into());
        }
    }

    /// Puts each word into its field, and keeps the words that are unknown.
    fn fill<T>(&mut self, words: &[Word], fields: &[Field<T>], own: &mut T, expected: &'static str) {
        for word in words {
            let is_intended =
                |field: &&Field<T>| word.key == field.word || (word.key == "L" && field.name == Name::Length);
            let read = fields.iter().find(is_intended).map(|field| (field, field.entry.read(word.value)));
            match read {
                Some((field, Ok(value))) => (field.set)(own, &value),
                read => {
                    let known = fields.iter().map(|field| field.word);
                    let nearest = if read.is_none() { nearest(&word.key, known) } else { None };
                    self.unreadable.push(UnreadableWord {
                        span: word.span,
                        expected: expected.into(),
                        nearest,
                    });
                }
            }
        }
    }
}

early! {
    fn read(text: &[u8]) -> Notes {
        let mut notes = Notes::default();
        let mut unit = None;
        for comment in comments(text) {
            let Ok(inside) = std::str::from_utf8(comment.inside) else { continue };
            if let Some(keyword) = comment.keyword() {
                notes.note(keyword, inside, comment.start, text);
            } else if nose_comment::may_describe(comment.inside) {
                let head = || first_unit::unit_of(&text[..text.len().min(HEAD)]);
                notes.noses.extend(nose_comment::read(inside, *unit.get_or_insert_with(head)));
            }
        }
        notes
    }

    fn match_text(notes: &Notes, text: &[u8]) -> bool {
        *notes == read(text)
    }

    fn applied(notes: &Notes, setup: Setup) -> Setup {
        let mut tools = setup.tools;
        tools.extend(notes.tools.iter().cloned());
        Setup {
            stock: notes.stock.clone().or(setup.stock),
            tailstock: notes.tailstock.or(setup.tailstock),
            machine: notes.machine.unwrap_or(setup.machine),
            initial: notes.start.or(setup.initial),
            dialect: fields::over(fields::DIALECT, setup.dialect, &notes.dialect),
            rules: setup.rules.with(&notes.rules).with(&setup.forced_rules),
            tools,
            described_noses: notes.noses.clone(),
            ..setup
        }
    }

    fn reported(notes: &Notes, invalid: Vec<InvalidValue>, text: &[u8]) -> Vec<Diagnostic> {
        let words = notes.unreadable.iter().map(|fault| fault.diagnostic(text));
        let values = invalid.into_iter().filter_map(|fault| {
            let places = || notes.places.iter().filter(|place| fault.key.starts_with(&place.0));
            let span = places().next_back().map_or(Span::new(0, 0), |place| place.1);
            // One mistake, one message: an invalid value that results from an unreadable word is not
            // reported.
            let is_unreadable = |span: Span| notes.unreadable.iter().any(|fault| span.contains(fault.span));
            let is_consequence = places().any(|place| is_unreadable(place.1));
            (!is_consequence).then(|| Diagnostic::new(fault.message(), span))
        });
        words.chain(values).collect()
    }
}

/// A comment of a program, or text in brackets.
struct Comment<'a> {
    /// The opening parenthesis or bracket.
    opened_by: u8,
    /// Position of the byte after it.
    start: usize,
    inside: &'a [u8],
}

impl Comment<'_> {
    /// The keyword that may make it a note.
    fn keyword(&self) -> Option<Keyword> {
        let inside = self.inside.trim_ascii_start();
        let ends = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'=';
        let word = &inside[..inside.iter().position(ends).unwrap_or(inside.len())];
        let stands_here = |keyword: &Keyword| match keyword {
            Keyword::Billet => self.opened_by == b'[',
            _ => self.opened_by == b'(' && memchr::memchr(b'=', inside).is_some(),
        };
        let named = Keyword::ALL.into_iter().find(|own| own.name().as_bytes().eq_ignore_ascii_case(word));
        named.filter(stands_here).filter(|_| !is_prose(&inside[word.len()..]))
    }
}

/// Whether the text of a comment is read as settings.
pub fn is_note(inside: &str) -> bool {
    let comment = Comment { opened_by: b'(', start: 0, inside: inside.as_bytes() };
    comment.keyword().is_some() && has_value(inside)
}

/// Whether a word after the first one sets a value: `D=65`.
fn has_value(inside: &str) -> bool {
    let mut words = inside.split_ascii_whitespace().skip(1);
    words.any(|word| word.split_once('=').is_some_and(|(_, value)| !value.is_empty()))
}

/// Whether the first word of a comment is followed by prose, despite an `=`: `(START SPINDLE, D=1.7)`,
/// `(MACHINE THE OD, D=40)`. A single unknown word before the settings is a mistake.
fn is_prose(rest: &[u8]) -> bool {
    let mut words = rest.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).peekable();
    let Some([first, second, .., last]) = words.peek() else { return false };
    let is_word = first.is_ascii_alphabetic() && second.is_ascii_alphabetic();
    let ends_clause = *last == b',';
    let (mut bare, mut all) = (0, 0);
    let mut begins_bare = None;
    for word in words {
        let is_bare = !word.contains(&b'=');
        begins_bare.get_or_insert(is_bare);
        bare += usize::from(is_bare);
        all += 1;
    }
    is_word && begins_bare == Some(true) && (ends_clause || 2 * bare > all)
}

/// The comments and brackets at the head of a text, each closed by the next closing one or the end of its
/// line.
fn comments(text: &[u8]) -> impl Iterator<Item = Comment<'_>> {
    let head = &text[..text.len().min(HEAD)];
    let mut at = 0;
    std::iter::from_fn(move || {
        let start = at + memchr::memchr2(b'(', b'[', &head[at..])? + 1;
        let ends = |byte: &u8| matches!(byte, b'(' | b')' | b'[' | b']' | b'\n' | b'\r' | b';');
        at = head[start..].iter().position(ends).map_or(head.len(), |length| start + length);
        Some(Comment { opened_by: head[start - 1], start, inside: &head[start..at] })
    })
}

/// The known word that a word is probably a misspelling of: one letter too many, missing or different, or two
/// letters swapped.
fn nearest(key: &str, known: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    const SHORTEST: usize = 3;
    const LONGEST: usize = 32;
    let near = known
        .filter(|word| word.len() >= SHORTEST && key.len() <= LONGEST)
        .map(|word| (strsim::osa_distance(key, word), word));
    near.filter(|(edits, word)| *edits <= word.len() / 3).min().map(|(_, word)| word)
}

/// The name of a tool in four digits: T1 is tool 1 with offset 1. `None` if `word` is not a T word.
pub fn tool_name(word: &str) -> Option<String> {
    let digits = word.trim().strip_prefix(['T', 't']).filter(|digits| is_number(digits))?;
    Some(if digits.len() <= 2 { format!("T{digits:0>2}{digits:0>2}") } else { format!("T{digits:0>4}") })
}

fn is_number(digits: &str) -> bool {
    (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// The words of a comment that begins at byte `start`.
pub(super) fn words(inside: &str, start: usize) -> Vec<Word<'_>> {
    let offset = |part: &str| start + (part.as_ptr() as usize - inside.as_ptr() as usize);
    let parts = inside.split_ascii_whitespace();
    parts
        .map(|part| {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            Word {
                key: key.to_ascii_uppercase(),
                value,
                span: Span::new(offset(part), offset(part) + part.len()),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests;
