//! Snippets of several words or blocks: the head of a program, a cycle with its contour, a loop.
//!
//! In: the control, its unit, the blank. Out: pieces of text, with placeholders. After a program head, the
//! snippets with their default texts run without messages.

use super::Query;
use super::form::g_of;
use super::hover::cuts_thread;
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::words::{CodeWord, Sample};
use crate::control::codes::{self, Compensation, G, Hole, MacroCall, MotionMode, Multiple};
use crate::control::modal::State;
use crate::control::words::Reading;
use crate::cycles::single::Single;
use crate::setup::dialect::{DecimalRule, Dialect, FeedMode, PqUnit};
use crate::text::block::{Block, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::{Diameter, Unit, number, read_number};

/// Clearance between the blank and the approach point, mm of diameter and mm along Z.
const CLEARANCE: f64 = 2.0;
/// Maximum distance of a tool that counts as near the face, mm.
const MAX_NEAR: f64 = 20.0;
/// From this lead, mm, the pull-out is half a lead: a whole one might reach beyond the start point.
const MIN_LEAD_FOR_SHORT_PULL_OUT: f64 = 2.8;
/// Number of bytes before the block that are searched for a thread.
const SEARCHED: usize = 1 << 16;
/// Spindle speed in the head of a program, rpm.
const SPEED: f64 = 800.0;

/// A piece of a snippet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Fixed text.
    Fixed(String),
    /// A placeholder, with its default text.
    Fill(String),
}

/// A snippet of several words or blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Snippet {
    /// Head of a program: number, modes, tool, spindle, approach.
    Head,
    /// End of a program: retract, stop.
    End,
    /// A multiple cycle: both blocks, and the contour if it has one.
    Cycle(Multiple),
    /// The second block of a multiple cycle.
    Second(Multiple),
    /// A single cycle.
    Pass(Single),
    /// Peck drilling.
    Drilling,
    /// A subprogram.
    Subprogram,
    /// Call of a subprogram.
    Call,
    /// Call of a macro.
    MacroCall,
    /// WHILE, DO, END.
    Loop,
    /// IF, GOTO.
    Condition,
}

impl Snippet {
    /// All snippets except the second blocks, in the order of the list.
    pub fn all() -> impl Iterator<Item = Self> {
        const CYCLES: [Multiple; 6] = [
            Multiple::RoughTurning,
            Multiple::RoughFacing,
            Multiple::Pattern,
            Multiple::Threading,
            Multiple::Grooving,
            Multiple::FacePecking,
        ];
        const OTHERS: [Snippet; 8] = [
            Snippet::Drilling,
            Snippet::Call,
            Snippet::Subprogram,
            Snippet::MacroCall,
            Snippet::Loop,
            Snippet::Condition,
            Snippet::End,
            Snippet::Head,
        ];
        let passes = Single::ALL.iter().copied().map(Self::Pass);
        CYCLES.into_iter().map(Self::Cycle).chain(passes).chain(OTHERS)
    }

    /// The code of the snippet; `None` for heads, ends and statements.
    pub fn code(self) -> Option<G> {
        Some(match self {
            Self::Cycle(cycle) | Self::Second(cycle) => G::Multiple(cycle),
            Self::Pass(cycle) => G::Motion(MotionMode::Cycle(cycle)),
            Self::Drilling => G::Hole(Hole::G83),
            Self::MacroCall => G::MacroCall(MacroCall::Once),
            Self::Head | Self::End | Self::Subprogram | Self::Call | Self::Loop | Self::Condition => {
                return None;
            }
        })
    }

    /// Whether the control has the code; `true` for a snippet without a code.
    pub fn is_supported(self, dialect: &Dialect) -> bool {
        self.code().is_none_or(|code| codes::written(code, dialect.code_list()).is_some())
    }

    /// The text of the snippet; `used`: the highest sequence number of the text.
    pub fn pieces(self, query: &Query, state: &State, used: u32) -> Vec<Piece> {
        let reading = Reading { unit: state.unit, decimal: query.dialect.decimal };
        let stock = query.setup.extents();
        let (blank, face) = (stock.map(|stock| stock.diameter.mm()), stock.map_or(0.0, |stock| stock.face));
        let (here, from) = (Diameter::from_radius(state.position.x).mm(), state.position.z);
        // If the tool is already near the work, the cut begins at its position.
        let is_near = (face..face + MAX_NEAR).contains(&from) && here > 2.0 * CLEARANCE;
        let outside = match (is_near, blank) {
            (true, Some(blank)) => blank.min(here - CLEARANCE),
            (true, None) => here - CLEARANCE,
            (false, blank) => blank.unwrap_or(50.0),
        };
        let reach = stock.map_or(30.0, |stock| (stock.length - stock.grip.unwrap_or(0.0)) / 2.0).min(30.0);
        let is_thread = self.code().is_some_and(cuts_thread);
        let mut writer = SnippetWriter {
            query,
            reading,
            feed_mode: state.feed_mode,
            outside,
            face,
            before: if is_near { from.min(face + CLEARANCE) } else { face + CLEARANCE },
            reach,
            lead: is_thread.then(|| lead_before(query, reading)).flatten().unwrap_or(match state.unit {
                Unit::Millimetre => 2.0,
                Unit::Inch => Unit::Inch.millimetres() / 16.0,
            }),
            sequences: (used + 10, used + 20),
            pieces: Vec::new(),
        };
        writer.snippet(self, state.unit);
        writer.pieces
    }
}

/// Formats a length; without a decimal point only if the meaning is the same.
pub fn written(mm: f64, reading: Reading) -> String {
    let mut text = number(mm / reading.unit.millimetres());
    if reading.decimal == DecimalRule::LeastIncrement && !text.contains('.') && text != "0" {
        text.push('.');
    }
    text
}

/// Formats a lead, which has up to six decimals: 12 threads per inch are F0.083333.
fn lead(mm: f64, reading: Reading) -> String {
    let short = written(mm, reading);
    let exact = format!("{:.6}", mm / reading.unit.millimetres());
    let exact = exact.trim_end_matches('0').trim_end_matches('.');
    if exact.len() > short.trim_end_matches('.').len() { exact.to_owned() } else { short }
}

/// The lead of the last thread before the block, mm: of a block that cuts one, or of a comment such as `M20X1.5`.
fn lead_before(query: &Query, reading: Reading) -> Option<f64> {
    let end = (query.block.span.start as usize).min(query.text.len());
    let searched = &query.text[end.saturating_sub(SEARCHED)..end];
    let line = if searched.len() < end { searched.iter().position(|&byte| byte == b'\n')? + 1 } else { 0 };
    let begin = Resume::inside((end - searched.len() + line) as u32, 0);
    let mut parser = Parser::resume(query.text, begin);
    let mut block = Block::default();
    let mut lead = None;
    while parser.next_block(&mut block) && (block.span.start as usize) < end {
        let comments = block.comments.iter().map(|span| String::from_utf8_lossy(span.of(query.text)));
        lead = comments.rev().find_map(|comment| lead_in(&comment)).or(lead);
        let threads = |word: &Word| g_of(word, query.codes).is_some_and(cuts_thread);
        if block.words.iter().any(threads) {
            let word = block.words.iter().find(|word| word.address == b'F' && !word.comma);
            lead = word.and_then(|word| reading.feed(word)).filter(|&lead| lead > 0.0).or(lead);
        }
    }
    lead
}

/// The lead in a designation such as `M20X1.5`.
fn lead_in(comment: &str) -> Option<f64> {
    let words = comment.split(|char: char| !char.is_ascii_alphanumeric() && char != '.');
    words.rev().find_map(|word| {
        let (diameter, lead) = word.strip_prefix(['M', 'm'])?.split_once(['X', 'x'])?;
        let (diameter, lead) = (read_number(diameter)?, read_number(lead)?);
        (diameter > 0.0 && (0.2..=diameter / 4.0).contains(&lead)).then_some(lead)
    })
}

/// Writes the pieces of a snippet.
struct SnippetWriter<'a> {
    query: &'a Query<'a>,
    reading: Reading,
    feed_mode: FeedMode,
    /// Diameter at which the cut begins, mm: of the blank, or less if the tool is already closer.
    outside: f64,
    /// Z of the face of the blank, mm.
    face: f64,
    /// Z in front of the face, mm: at most the Z of the tool.
    before: f64,
    /// Length of the cut along Z, mm.
    reach: f64,
    /// Lead of a thread, mm.
    lead: f64,
    /// Unused sequence numbers for a contour.
    sequences: (u32, u32),
    pieces: Vec<Piece>,
}

impl SnippetWriter<'_> {
    fn fixed(&mut self, text: &str) {
        match self.pieces.last_mut() {
            Some(Piece::Fixed(before)) => before.push_str(text),
            _ => self.pieces.push(Piece::Fixed(text.to_owned())),
        }
    }

    fn fill(&mut self, text: impl Into<String>) {
        self.pieces.push(Piece::Fill(text.into()));
    }

    fn code(&mut self, code: G) {
        let code = codes::written(code, self.query.codes).unwrap_or_default();
        self.fixed(&code);
    }

    /// Writes a word with a length in mm as a placeholder; rounded to a short number if the program is in
    /// inches.
    fn length(&mut self, letter: &str, mm: f64) {
        let round = match self.reading.unit {
            Unit::Millimetre => mm,
            Unit::Inch => {
                let inches: f64 = mm / Unit::Inch.millimetres();
                let steps_per_inch = if inches.abs() < 0.1 { 1000.0 } else { 100.0 };
                (inches * steps_per_inch).round() / steps_per_inch * Unit::Inch.millimetres()
            }
        };
        self.fixed(&format!(" {letter}"));
        self.fill(written(round, self.reading));
    }

    /// The feed of a cut: mm per revolution, or per minute at [`SPEED`].
    fn feed(&mut self, mm: f64) {
        match self.feed_mode {
            FeedMode::PerTurn => self.length("F", mm),
            FeedMode::PerMinute => self.length("F", mm * SPEED),
        }
    }

    /// Writes P or Q, which take no decimal point, with a length as a placeholder.
    fn depth(&mut self, letter: &str, mm: f64) {
        if self.query.dialect.pq_unit == PqUnit::Mm {
            return self.length(letter, mm);
        }
        self.fixed(&format!(" {letter}"));
        let increments = mm / self.reading.unit.millimetres() / self.reading.unit.increment();
        self.fill(number(increments.round()));
    }

    /// Writes a word with a length in mm as a placeholder, rounded to the increment.
    fn exact(&mut self, letter: &str, mm: f64) {
        self.fixed(&format!(" {letter}"));
        let step = self.reading.unit.increment() * self.reading.unit.millimetres();
        self.fill(written((mm / step).round() * step, self.reading));
    }

    /// The height of the thread, mm, in whole increments: 0.65 of its lead, if the blank is thick enough.
    fn thread_height(&self) -> f64 {
        let step = self.reading.unit.increment() * self.reading.unit.millimetres();
        ((0.65 * self.lead).min(self.outside / 4.0) / step).round() * step
    }

    /// A depth rounded to a hundredth of a millimetre or a thousandth of an inch.
    fn round_depth(&self, mm: f64) -> f64 {
        let step = 10.0 * self.reading.unit.increment() * self.reading.unit.millimetres();
        (mm / step).round().max(1.0) * step
    }

    /// A diameter up to `most` mm smaller than the blank, but at least half of it.
    fn inward(&self, most: f64) -> f64 {
        self.outside - most.min((self.outside / 2.0).floor())
    }

    /// Z after a fraction of the length of the cut, mm.
    fn along(&self, part: f64) -> f64 {
        let way = self.reach * part;
        self.face - if way < 2.0 { way } else { way.round() }
    }

    fn line(&mut self) {
        self.fixed("\n");
    }

    // ---- text of each snippet ---------------------------------------------------------------------------

    fn snippet(&mut self, snippet: Snippet, unit: Unit) {
        match snippet {
            Snippet::Head => self.head(unit),
            Snippet::End => self.end(),
            Snippet::Cycle(cycle) => {
                self.block(cycle, CycleBlock::First);
                self.line();
                self.block(cycle, CycleBlock::Second);
                self.contour(cycle);
            }
            Snippet::Second(cycle) => self.block(cycle, CycleBlock::Second),
            Snippet::Pass(cycle) => self.pass(cycle),
            Snippet::Drilling => {
                self.code(G::Hole(Hole::G83));
                self.fixed(" X0");
                self.length("Z", self.along(2.0 / 3.0));
                self.depth("Q", 5.0);
                self.feed(0.1);
                self.line();
                self.code(G::NoHole);
            }
            Snippet::Subprogram => {
                self.fixed("O");
                self.fill("2000");
                self.line();
                self.fill("");
                self.fixed("\nM99");
            }
            Snippet::Call => {
                self.fixed("M98 P");
                self.fill("2000");
            }
            Snippet::MacroCall => {
                self.code(G::MacroCall(MacroCall::Once));
                self.fixed(" P");
                self.fill("9000");
                self.fixed(" A");
                self.fill("1.");
            }
            Snippet::Loop => {
                self.fixed("#100=");
                self.fill("0");
                self.fixed("\nWHILE [#100 LT ");
                self.fill("5");
                self.fixed("] DO1\n");
                self.fill("");
                self.fixed("\n#100=#100+");
                self.fill("1");
                self.fixed("\nEND1");
            }
            Snippet::Condition => {
                self.fixed("IF [#");
                self.fill("100");
                self.fixed(" GT ");
                self.fill("0");
                let target = self.sequences.0;
                self.fixed(&format!("] GOTO {target}\n"));
                self.fill("");
                self.fixed(&format!("\nN{target}"));
            }
        }
    }

    fn head(&mut self, unit: Unit) {
        self.fixed("O");
        self.fill("0001");
        self.line();
        for (code, after) in [
            (G::Unit(unit), " "),
            (G::Compensation(Compensation::Off), " "),
            (G::Feed(FeedMode::PerTurn), "\n"),
        ] {
            self.code(code);
            self.fixed(after);
        }
        self.fixed("T");
        self.fill("0101");
        self.line();
        self.code(G::ConstantSpeed);
        self.fixed(" S");
        self.fill(number(SPEED));
        self.fixed(" M03\n");
        self.code(G::Motion(MotionMode::Rapid));
        self.length("X", self.outside + CLEARANCE);
        self.length("Z", self.face + CLEARANCE);
    }

    fn end(&mut self) {
        self.code(G::Motion(MotionMode::Rapid));
        self.length("X", self.outside + 50.0);
        self.length("Z", self.face + 100.0);
        self.fixed("\nM05\nM30");
    }

    /// A block of a multiple cycle.
    fn block(&mut self, cycle: Multiple, block: CycleBlock) {
        self.code(G::Multiple(cycle));
        self.words(cycle.spec().words(block));
    }

    /// The words of a block that have a sample.
    fn words(&mut self, words: &[CodeWord]) {
        for word in words {
            if let Some(sample) = word.sample {
                self.sample(char::from(word.letters[0]), sample);
            }
        }
    }

    /// A word with its sample.
    fn sample(&mut self, letter: char, sample: Sample) {
        let letter = letter.to_string();
        match sample {
            Sample::Length(mm) => self.length(&letter, mm),
            Sample::Depth(mm) => self.depth(&letter, mm),
            Sample::Feed(mm) => self.feed(mm),
            Sample::Digits(digits) => {
                self.fixed(&format!(" {letter}"));
                self.fill(digits);
            }
            Sample::First => self.fixed(&format!(" {letter}{}", self.sequences.0)),
            Sample::Last => self.fixed(&format!(" {letter}{}", self.sequences.1)),
            Sample::Smaller(mm) => self.length(&letter, self.outside - mm),
            Sample::Behind(mm) => self.length(&letter, self.face - mm),
            Sample::Inward(most) => self.length(&letter, self.inward(most)),
            Sample::Along(part) => self.length(&letter, self.along(part)),
            Sample::Lead => {
                self.fixed(&format!(" {letter}"));
                self.fill(lead(self.lead, self.reading));
            }
            Sample::ThreadRoot => self.exact(&letter, self.outside - 2.0 * self.thread_height()),
            Sample::ThreadHeight => self.depth(&letter, self.thread_height()),
            Sample::ThreadFirst => {
                self.depth(&letter, self.round_depth((0.2 * self.lead).min(self.thread_height() / 2.0)))
            }
            Sample::ThreadPacked => {
                self.fixed(&format!(" {letter}"));
                // Two finishing passes, and a pull-out over one lead where the start point is that far away.
                self.fill(if self.lead < MIN_LEAD_FOR_SHORT_PULL_OUT { "021060" } else { "020560" });
            }
        }
    }

    /// The contour of a cycle, and the block that finishes it.
    fn contour(&mut self, cycle: Multiple) {
        let (first, last) = self.sequences;
        let (rapid, line) = (MotionMode::Rapid, MotionMode::Line);
        let move_block = |writer: &mut Self, head: &str, mode: MotionMode| {
            writer.fixed(&format!("\n{head}"));
            writer.code(G::Motion(mode));
        };
        let (from, to) = (format!("N{first} "), format!("N{last} "));
        match cycle {
            Multiple::RoughTurning | Multiple::Pattern => {
                move_block(self, &from, rapid);
                // Pattern repeating (G73) is for a blank that is already close to the contour.
                self.length("X", self.inward(if cycle == Multiple::Pattern { 8.0 } else { 20.0 }));
                move_block(self, "", line);
                self.length("Z", self.along(2.0 / 3.0));
                move_block(self, &to, line);
                self.lengths(&[("X", self.outside + CLEARANCE), ("Z", self.along(1.0))]);
            }
            Multiple::RoughFacing => {
                move_block(self, &from, rapid);
                self.length("Z", self.along(1.0 / 3.0));
                move_block(self, "", line);
                self.length("X", self.inward(20.0));
                move_block(self, &to, line);
                self.length("Z", self.before);
            }
            _ => return,
        }
        self.line();
        self.block(Multiple::Finishing, CycleBlock::Second);
    }

    fn pass(&mut self, cycle: Single) {
        self.code(G::Motion(MotionMode::Cycle(cycle)));
        self.words(cycle.spec().words);
    }

    fn lengths(&mut self, words: &[(&str, f64)]) {
        for &(letter, mm) in words {
            self.length(letter, mm);
        }
    }
}
