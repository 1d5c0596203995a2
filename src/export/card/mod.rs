//! The setup sheet: a page to print, with the blank, the tools, and an explanation of every block.
//!
//! In: a program, its motions and setup. Out: one self-contained HTML file. Rows are blocks in text order,
//! not in execution order: a block that is executed several times is described by its first execution.

mod here;
mod words;

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;

use crate::control::codes::{self, Function};
use crate::machine::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use crate::motion::{Feed, Motion, Motions, SpindleSpeed, Step};
use crate::playback::timing::{ASSUMED_RAPID, Total};
use crate::playback::totals::{ToolTotals, totals};
use crate::sentences::{Language, describe_motion, labels};
use crate::setup::dialect::{CodeList, FeedMode};
use crate::setup::{Blank, Setup, tool_word};
use crate::source::{Span, is_unprintable};
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Parser;
use crate::text::program_name::is_name;
use crate::units::{Diameter, Unit, number};
use here::here;
use words::{one_of, tool_kind, words};

/// Maximum number of blocks on a sheet: about a hundred pages.
const MAX_BLOCKS: usize = 4000;

/// Maximum number of motions for the drawing; with more, callers omit it, because it would be unreadable.
pub const MAX_DRAWN: usize = 20_000;

/// Maximum number of tools on a sheet.
const MAX_TOOLS: usize = 500;

/// Maximum number of motions of a block that are described individually; more are only counted.
const MAX_DESCRIBED: usize = 4;

/// Maximum number of speeds and feeds listed for a tool.
const MAX_RATES: usize = 4;

/// Input of a setup sheet.
pub struct Card<'a> {
    /// The program.
    pub text: &'a [u8],
    /// Its motions.
    pub motions: &'a Motions,
    /// The setup of the run.
    pub setup: &'a Setup,
    /// The G code list of the program.
    pub codes: CodeList,
    /// The unit for lengths.
    pub unit: Unit,
    /// The drawings for white paper, as SVG.
    pub drawings: &'a [String],
}

/// Allows no requests and no scripts.
const POLICY: &str = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n";

/// A row of the table of blocks.
#[derive(Debug, Default, PartialEq)]
struct Row {
    sequence: String,
    text: String,
    does: String,
    remark: String,
    time: String,
}

impl Card<'_> {
    /// Renders the sheet as HTML.
    pub fn html(&self, language: Language) -> String {
        let w = words(language);
        let (rows, more) = self.rows(language);
        let number = self.program_number();
        let title = [w.card, number.as_str()].join(" ");
        let mut page = Page { html: String::new() };
        let _ = write!(
            page.html,
            "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n{POLICY}<title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n",
            language.tag(),
            escaped(title.trim()),
        );
        let _ = writeln!(
            page.html,
            "<header><h1>{} <b>{}</b></h1><p class=\"sign\"><span>{}</span><span>{}</span></p></header>",
            escaped(w.card),
            escaped(&number),
            w.name,
            w.date,
        );
        let resolved = ResolvedSetup::new(self.motions, self.setup);
        self.metadata(&mut page, &resolved, language);
        for drawing in self.drawings {
            let _ = writeln!(page.html, "<figure>{drawing}</figure>");
        }
        self.tools(&mut page, &resolved, language);
        page.heading(w.program);
        page.begin_table("blocks", &["N", w.block, w.does, w.remark, &format!("{}, {}", w.time, w.seconds)]);
        for row in &rows {
            let block = format!("<code>{}</code>", escaped(&row.text));
            page.row([
                &escaped(&row.sequence),
                &block,
                &escaped(&row.does),
                &escaped(&row.remark),
                &row.time,
            ]);
        }
        page.end_table();
        if more > 0 {
            page.paragraph(&w.more_blocks.replace("{}", &more.to_string()));
        }
        page.html.push_str("</body>\n</html>\n");
        page.html
    }

    /// The O number of the run: the chosen one, or the first in the text.
    fn program_number(&self) -> String {
        let first = || blocks(self.text).find_map(|block| block.program);
        let number = self.setup.program.or_else(|| first().map(|program| program.0));
        number.map(program_name).unwrap_or_default()
    }

    fn metadata(&self, page: &mut Page, resolved: &ResolvedSetup, language: Language) {
        let w = words(language);
        let mut metadata = vec![(w.control, self.codes.name().to_owned())];
        if let Some((stock, basis)) = resolved.blank() {
            let measures = Measures { unit: self.unit, language };
            metadata.push((w.blank, blank(stock, basis, measures)));
            if let Some(grip) = stock.extents().grip {
                metadata.push((w.clamped, measures.length(grip)));
            }
        }
        if !self.motions.is_empty() {
            let start = self.motions.get_on_workpiece(0).from;
            let [x, z] =
                [Diameter::from_radius(start.x).mm(), start.z].map(|mm| number(mm / self.unit.millimetres()));
            metadata.push((w.start, format!("X{x} Z{z}")));
        }
        let (_, all) = totals(self.motions, &self.setup.machine);
        metadata.push((w.time, clock(&all.time)));
        page.html.push_str("<dl>");
        for (name, value) in metadata {
            let _ = write!(page.html, "<div><dt>{name}</dt><dd>{}</dd></div>", escaped(&value));
        }
        page.html.push_str("</dl>\n");
    }

    fn tools(&self, page: &mut Page, resolved: &ResolvedSetup, language: Language) {
        let (w, measures) = (words(language), Measures { unit: self.unit, language });
        let (tools, all) = totals(self.motions, &self.setup.machine);
        if tools.is_empty() {
            return;
        }
        page.heading(w.tools);
        page.begin_table("tools", &[w.tool, w.kind, w.nose, w.tip, w.speed_and_feed, w.time]);
        // A tool is described by its first cut. A T word without cuts, such as a cancelled offset, is not
        // listed.
        let mut uses: BTreeMap<(u16, u16), (Motion, Rates)> = BTreeMap::new();
        for motion in self.motions.iter().filter(|motion| motion.kind.cuts()) {
            let (_, rates) = uses.entry(motion.process.tool).or_insert_with(|| (motion, Rates::default()));
            rates.add(&motion, measures);
        }
        let mut cutting = tools.iter().filter_map(|own| Some((own, uses.get(&own.tool)?)));
        for (own, (first, rates)) in cutting.by_ref().take(MAX_TOOLS) {
            let [kind, nose, tip] = about(resolved.tool(first), measures).map(|text| escaped(&text));
            let rates = escaped(&rates.text());
            page.row([&tool_name(own.tool), &kind, &nose, &tip, &rates, &clock(&own.time)]);
        }
        page.row([w.total, "", "", "", "", &clock(&all.time)]);
        page.end_table();
        let more = cutting.count();
        if more > 0 {
            page.paragraph(&w.more_tools.replace("{}", &more.to_string()));
        }
        let ToolTotals { time, .. } = &all;
        if time.unknown_cuts > 0 {
            page.paragraph(&w.not_in_time.replace("{}", &time.unknown_cuts.to_string()));
        }
        if time.unknown_rapids > 0 {
            let in_unit = (ASSUMED_RAPID / self.unit.millimetres()).round() * self.unit.millimetres();
            let rate = measures.feed(in_unit, FeedMode::PerMinute);
            page.paragraph(&w.rapids_assumed.replace("{}", &rate));
        }
    }

    /// The rows of all blocks, and the number of omitted ones.
    fn rows(&self, language: Language) -> (Vec<Row>, usize) {
        let told = Told::new(self, language);
        let mut contours = Contours::new(&told);
        let mut rows = Vec::new();
        let mut more = 0;
        for block in blocks(self.text) {
            let in_contour = contours.line_of(&block, &told);
            let has_remark = !block.comments.is_empty();
            if block.kind == BlockKind::Percent
                || (block.is_empty() && block.sequence.is_none() && !has_remark)
            {
                continue;
            }
            if rows.len() < MAX_BLOCKS {
                rows.push(told.row(&block, in_contour));
            } else {
                more += 1;
            }
        }
        (rows, more)
    }
}

/// Describes blocks.
struct Told<'a> {
    card: &'a Card<'a>,
    language: Language,
    /// Function of each code, and its index among the codes with the same function.
    functions: HashMap<String, (Function, usize)>,
    /// The motions of each block, by the block's first byte.
    motions: BTreeMap<u32, Vec<usize>>,
}

impl<'a> Told<'a> {
    fn new(card: &'a Card<'a>, language: Language) -> Self {
        let mut functions = HashMap::new();
        for row in codes::rows() {
            let list = CodeList::ALL.iter().position(|&list| list == card.codes).unwrap_or(0);
            for (index, code) in row.codes[list].split(' ').enumerate() {
                functions.insert(code.to_owned(), (row.function, index));
            }
        }
        let mut motions: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for index in 0..card.motions.len() {
            motions.entry(card.motions.span(index).start).or_default().push(index);
        }
        Self { card, language, functions, motions }
    }

    /// The function of a word that is a code, and its index among the codes with the same function.
    fn function(&self, word: &Word) -> Option<(Function, usize)> {
        spelled(word).and_then(|code| self.functions.get(&code).copied())
    }

    /// `in_contour`: how the block moves in a contour that a cycle reads.
    fn row(&self, block: &Block, in_contour: Option<Function>) -> Row {
        let text = self.card.text;
        let own: Vec<Motion> = self
            .motions
            .range(block.span.start..block.span.end.max(block.span.start + 1))
            .flat_map(|(_, motions)| motions.iter().map(|&index| self.card.motions.get(index)))
            .collect();
        let mut does = self.codes(block, &own);
        does.extend(self.moves(&own));
        if does.is_empty() {
            does.extend(in_contour.map(|function| function.describe(self.language).to_owned()));
        }
        let mut time = Total::default();
        for motion in &own {
            time.add(motion, &self.card.setup.machine);
        }
        let (sequence, written) = as_written(text, block);
        let remarks = block.comments.iter().map(|comment| remark(text, *comment));
        Row {
            sequence,
            text: written,
            does: does.join("; "),
            remark: remarks.collect::<Vec<_>>().join("; "),
            time: if time.known > 0.0 { format!("{:.1}", time.known) } else { String::new() },
        }
    }

    /// Descriptions of the codes of a block; codes of plain moves are described with the move.
    fn codes(&self, block: &Block, own: &[Motion]) -> Vec<String> {
        let mut told: Vec<String> = Vec::new();
        if block.kind == BlockKind::Macro {
            let written = as_written(self.card.text, block).1.to_ascii_uppercase();
            let function =
                match written.trim_start_matches(|c: char| c == '/' || c.is_ascii_digit()).chars().next() {
                    Some('I') => Function::If,
                    Some('G') => Function::Goto,
                    Some('W' | 'D' | 'E') => Function::While,
                    _ => Function::Variables,
                };
            told.push(function.describe(self.language).to_owned());
        }
        for word in &block.words {
            let Some((function, index)) = self.function(word) else {
                if let Some(tool) = self.tool(word) {
                    told.push(tool);
                }
                continue;
            };
            let by_move = matches!(
                function,
                Function::Rapid
                    | Function::Line
                    | Function::ArcClockwise
                    | Function::ArcCounterclockwise
                    | Function::Dwell
            );
            if by_move && own.iter().any(|motion| motion.cycle.is_none()) {
                continue;
            }
            told.push(
                here(function, block, own, self.language)
                    .or_else(|| one_of(function, index, self.language))
                    .unwrap_or_else(|| function.describe(self.language).replace('`', "")),
            );
        }
        told.dedup();
        told
    }

    /// `T0101`: the tool that is changed to.
    fn tool(&self, word: &Word) -> Option<String> {
        let number = word_number(word).filter(|_| word.address == b'T')?.integer()?;
        let w = words(self.language);
        let (station, offset) = if number < 100 { (number, number) } else { (number / 100, number % 100) };
        Some(format!("{} {station}, {} {offset}", w.its_tool, w.offset))
    }

    fn moves(&self, own: &[Motion]) -> Vec<String> {
        let w = words(self.language);
        let count = |template: &str, count: u64| template.replace("{}", &count.to_string());
        let passes = own.iter().filter_map(|motion| motion.cycle).map(|step| step.pass);
        let (low, high) = (passes.clone().filter(|&pass| pass > 0).min(), passes.max().unwrap_or(0));
        let told = |motion: &Motion| describe_motion(motion, None, self.card.unit, self.language);
        match low {
            Some(low) if low < high => vec![count(w.passes, u64::from(high - low) + 1)],
            Some(_) => {
                // One pass of a modal cycle: the cut describes it.
                let cut = own.iter().find(|motion| motion.cycle.is_some_and(|step| step.step == Step::Cut));
                cut.or(own.first()).map(told).into_iter().collect()
            }
            None if own.len() > MAX_DESCRIBED => vec![count(w.moves, own.len() as u64)],
            None => own.iter().map(told).collect(),
        }
    }
}

/// The contours that G70 to G73 read: their blocks make no motions.
#[derive(Default)]
struct Contours {
    /// First and last sequence number of each.
    named: Vec<(u32, u32)>,
    /// The last sequence number of the contour that the text is in.
    last: Option<u32>,
    /// The move that is modal there.
    modal: Option<Function>,
}

impl Contours {
    fn new(told: &Told) -> Self {
        let named = blocks(told.card.text).filter_map(|block| {
            let reads = |word: &Word| {
                matches!(
                    told.function(word),
                    Some((
                        Function::Finishing
                            | Function::RoughTurning
                            | Function::RoughFacing
                            | Function::Pattern,
                        _
                    ))
                )
            };
            let number = |address: u8| {
                let word = block.words.iter().find(|word| word.address == address)?;
                u32::try_from(word_number(word)?.integer()?).ok()
            };
            block.words.iter().any(reads).then_some(())?;
            Some((number(b'P')?, number(b'Q')?))
        });
        Self { named: named.collect(), ..Self::default() }
    }

    /// How a block moves in a contour. The blocks come in text order.
    fn line_of(&mut self, block: &Block, told: &Told) -> Option<Function> {
        if let Some(contour) = self.named.iter().find(|(first, _)| block.sequence == Some(*first)) {
            (self.last, self.modal) = (Some(contour.1), None);
        }
        let last = self.last?;
        for (function, _) in block.words.iter().filter_map(|word| told.function(word)) {
            if let Function::Rapid | Function::Line | Function::ArcClockwise | Function::ArcCounterclockwise =
                function
            {
                self.modal = Some(function);
            }
        }
        if block.sequence == Some(last) {
            self.last = None;
        }
        self.modal.filter(|_| block.words.iter().any(|word| b"XZUW".contains(&word.address)))
    }
}

/// The HTML file being written.
struct Page {
    html: String,
}

impl Page {
    fn heading(&mut self, text: &str) {
        let _ = writeln!(self.html, "<h2>{}</h2>", escaped(text));
    }

    fn paragraph(&mut self, text: &str) {
        let _ = writeln!(self.html, "<p>{}</p>", escaped(text));
    }

    fn begin_table(&mut self, class: &str, heads: &[&str]) {
        let cells: String =
            heads.iter().map(|head| format!("<th scope=\"col\">{}</th>", escaped(head))).collect();
        let _ = writeln!(self.html, "<table class=\"{class}\">\n<thead><tr>{cells}</tr></thead>\n<tbody>");
    }

    /// Writes a table row; the cells are HTML already.
    fn row<const N: usize>(&mut self, cells: [&str; N]) {
        let cells: String = cells.iter().map(|cell| format!("<td>{cell}</td>")).collect();
        let _ = writeln!(self.html, "<tr>{cells}</tr>");
    }

    fn end_table(&mut self) {
        self.html.push_str("</tbody>\n</table>\n");
    }
}

/// Formats an O number.
pub(super) fn program_name(number: u32) -> String {
    // The number of a named program is internal.
    if is_name(number) { String::new() } else { format!("O{number:04}") }
}

/// The blocks of a text.
pub(super) fn blocks(text: &[u8]) -> impl Iterator<Item = Block> + '_ {
    let mut parser = Parser::new(text);
    std::iter::from_fn(move || {
        let mut block = Block::default();
        parser.next_block(&mut block).then_some(block)
    })
}

/// A G or M word in the spelling of the table of codes: `G01`, `G12.1`.
fn spelled(word: &Word) -> Option<String> {
    let number = word_number(word)?;
    match (word.address, word.comma) {
        (b'G', false) => {
            let tenths = number.tenths()?;
            let decimal = if tenths % 10 > 0 { format!(".{}", tenths % 10) } else { String::new() };
            Some(format!("G{:02}{decimal}", tenths / 10))
        }
        (b'M', false) => Some(format!("M{:02}", number.integer()?)),
        (b'C' | b'R' | b'A', true) => Some(format!(",{}", char::from(word.address))),
        _ => None,
    }
}

fn word_number(word: &Word) -> Option<crate::text::lexer::Number> {
    match word.value {
        Value::Number { number, .. } => Some(number),
        Value::Expression => None,
    }
}

/// The sequence number of a block as written, and the rest of the block without comments and surrounding
/// spaces.
fn as_written(text: &[u8], block: &Block) -> (String, String) {
    let mut bytes = block.span.of(text).to_vec();
    for comment in &block.comments {
        let from = comment.start.saturating_sub(block.span.start) as usize;
        let to = (comment.end.saturating_sub(block.span.start) as usize).min(bytes.len());
        bytes[from.min(to)..to].fill(b' ');
    }
    let written = String::from_utf8_lossy(&bytes);
    let written = written.trim().trim_end_matches(';');
    let rest = match written.strip_prefix(['N', 'n']).filter(|_| block.sequence.is_some()) {
        Some(rest) => rest.trim_start_matches(|c: char| c.is_ascii_digit()),
        None => written,
    };
    let sequence = &written[..written.len() - rest.len()];
    (sequence.to_owned(), rest.split_whitespace().collect::<Vec<_>>().join(" "))
}

pub(super) fn remark(text: &[u8], comment: Span) -> String {
    comment.quote(text).trim_matches(|c: char| "();（）".contains(c) || c.is_whitespace()).to_owned()
}

/// Formats measures in the unit and the language of a sheet.
#[derive(Clone, Copy)]
struct Measures {
    unit: Unit,
    language: Language,
}

impl Measures {
    /// Formats a length in mm, without the unit.
    fn bare(self, mm: f64) -> String {
        number(mm / self.unit.millimetres())
    }

    /// Formats a length in mm.
    fn length(self, mm: f64) -> String {
        [&self.bare(mm), " ", labels::length(self.unit, self.language)].concat()
    }

    /// Formats a feed in mm/rev or mm/min.
    fn feed(self, mm: f64, mode: FeedMode) -> String {
        [&self.bare(mm), " ", labels::feed_unit(mode, self.unit, self.language)].concat()
    }
}

fn blank(blank: &Blank, basis: Basis, measures: Measures) -> String {
    let w = words(measures.language);
    let stock = blank.extents();
    let diameter = measures.bare(stock.diameter.mm());
    let mut text = ["Ø", &diameter, ", ", w.length, " ", &measures.length(stock.length)].concat();
    if stock.bore.mm() > 0.0 {
        let _ = write!(text, ", {} Ø{}", w.bore, measures.bare(stock.bore.mm()));
    }
    if stock.face != 0.0 {
        let _ = write!(text, ", {}{}", w.face, measures.bare(stock.face));
    }
    if blank.outline().is_some() {
        let _ = write!(text, ", {}", w.outline);
    }
    if basis == Basis::Inferred {
        let _ = write!(text, " ({})", w.inferred);
    }
    text
}

/// Kind, nose radius and tip of a tool.
fn about(resolved_tool: &ResolvedTool, measures: Measures) -> [String; 3] {
    let (w, language) = (words(measures.language), measures.language);
    let tool = &resolved_tool.tool;
    let mut kind = tool.kind.map(|kind| tool_kind(kind, tool.working_side(), language)).unwrap_or_default();
    let more = [
        tool.insert.clone().filter(|_| resolved_tool.basis == Basis::Given),
        tool.width.map(|width| measures.length(width)),
        (tool.diameter.or(resolved_tool.assumed_diameter()))
            .map(|diameter| format!("Ø{}", measures.bare(diameter.mm()))),
    ];
    for more in more.into_iter().flatten() {
        kind = [kind, more].join(" ").trim().to_owned();
    }
    if resolved_tool.basis == Basis::Unknown {
        return ["–", "–", "–"].map(str::to_owned);
    }
    if resolved_tool.basis == Basis::Inferred {
        return [format!("{kind} ({})", w.inferred), "–".into(), "–".into()];
    }
    let nose = tool.nose();
    let nose = if nose > 0.0 { measures.length(nose) } else { "–".into() };
    [kind, nose, tool.tip_direction().to_string()]
}

/// The different speeds and feeds of the cuts of a tool, at most [`MAX_RATES`], with a mark if there are
/// more.
#[derive(Default)]
struct Rates {
    found: Vec<String>,
    /// Speed, feed and lead of the last cut.
    last: Option<(SpindleSpeed, Feed, Option<f64>)>,
}

impl Rates {
    fn add(&mut self, motion: &Motion, measures: Measures) {
        let own = (motion.process.speed, motion.process.feed, motion.lead);
        if self.found.len() > MAX_RATES || self.last.replace(own) == Some(own) {
            return;
        }
        let (w, unit) = (words(measures.language), measures.unit);
        let speed = match motion.process.speed {
            SpindleSpeed::Constant(0.0) => None,
            SpindleSpeed::Constant(speed) => Some(format!("{} {}", number(speed), w.per_minute)),
            SpindleSpeed::Surface { speed } => {
                let speed = number(speed / unit.surface_metres());
                Some([&speed, " ", labels::surface_speed(unit, measures.language)].concat())
            }
        };
        let feed = match (motion.lead, motion.process.feed) {
            (Some(lead), _) => Some(measures.feed(lead, FeedMode::PerTurn)),
            (None, Feed::Unset) => None,
            (None, Feed::PerTurn(feed)) => Some(measures.feed(feed, FeedMode::PerTurn)),
            (None, Feed::PerMinute(feed)) => Some(measures.feed(feed, FeedMode::PerMinute)),
        };
        let rate = [speed, feed].into_iter().flatten().collect::<Vec<_>>().join(", ");
        if !rate.is_empty() && !self.found.contains(&rate) {
            let is_room = self.found.len() < MAX_RATES;
            self.found.push(if is_room { rate } else { "…".into() });
        }
    }

    fn text(&self) -> String {
        if self.found.is_empty() { "–".into() } else { self.found.join("; ") }
    }
}

fn tool_name((station, offset): (u16, u16)) -> String {
    if station == 0 { "–".into() } else { tool_word((station, offset)) }
}

/// Formats a time as minutes and seconds; a dash if it is unknown.
fn clock(time: &Total) -> String {
    let seconds = time.estimated().round();
    if seconds <= 0.0 {
        return "–".into();
    }
    format!("{}:{:02}", (seconds / 60.0).floor(), seconds % 60.0)
}

fn escaped(text: &str) -> String {
    let text = text.replace(is_unprintable, "?");
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

const STYLE: &str = include_str!("card.css");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;

    fn html(text: &str, language: Language) -> String {
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let (motions, setup, codes) = (&analysis.motions, &analysis.setup, analysis.codes);
        let unit = analysis.unit;
        Card { text: text.as_bytes(), motions, setup, codes, unit, drawings: &[] }.html(language)
    }

    const PROGRAM: &str = "%\nO0012 (PIN <A>)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)\nN10 G50 S2000\n\
        N20 G0 X42 Z2 T0101 M3 S800 M8 (START)\nN30 G71 U2 R1\nN40 G71 P50 Q70 U0.4 W0.1 F0.25\nN50 G0 X20\n\
        N60 G1 Z-15 F0.1\nN70 X42\nN80 G70 P50 Q70\nN90 M09\nN100 M30\n%\n";

    #[test]
    fn a_row_for_each_block() {
        let page = html(PROGRAM, Language::English);
        for wanted in [
            "<h1>Setup sheet <b>O0012</b></h1>",
            "PIN &lt;A&gt;",
            "<td>N20</td><td><code>G0 X42 Z2 T0101 M3 S800 M8</code></td><td>tool 1, offset 1; spindle forward; coolant on; ",
            "<td>START</td>",
            "rough turning",
            " passes",
            "coolant off",
            "program end",
            "<td>T0101</td><td>turning tool CNMG120408</td><td>0.8 mm</td><td>3</td><td>800 rpm, 0.25 mm/rev; 800 rpm, 0.1 mm/rev</td>",
        ] {
            assert!(page.contains(wanted), "{wanted} in\n{page}");
        }
        assert_eq!(page.matches("<tr>").count(), page.matches("</tr>").count());
    }

    /// The sheet of an inch program uses inches everywhere, even if the setup was entered in mm.
    #[test]
    fn the_card_of_an_inch_program_is_in_inches() {
        let program = "O1\n(STOCK D=50.8 LENGTH=101.6)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)\nG20 G99\n\
            T0101\nG96 S500 M3\nG0 X2.1 Z.1\nG1 X1.5 F.01\nZ-1.\nG98 G1 X2. F5.\nG0 X4. Z4.\nM30\n";
        let page = html(program, Language::English);
        for wanted in [
            "<dd>Ø2, length 4 in</dd>",
            "<td>0.0315 in</td>",
            "500 ft/min, 0.01 in/rev; 500 ft/min, 5 in/min",
            "feed to X1.5 Z-1",
            "315 in/min is assumed",
        ] {
            assert!(page.contains(wanted), "{wanted} in\n{page}");
        }
        assert!(!page.contains(" mm"), "{page}");
        assert!(html(program, Language::Russian).contains("Ø2, длина 4 дюйма"));
        assert!(html(PROGRAM, Language::Russian).contains("<td>0.8 мм</td>"));
    }

    /// The operator clamps the blank and moves the tool to the start.
    #[test]
    fn the_sheet_names_the_clamping_length_and_the_start() {
        let program = "O1\n(STOCK D=60 LENGTH=80 GRIP=25.4)\nG50 X150 Z100\nT0101\nM3 S500\nG0 X50 Z2\n\
            G1 Z-20 F0.2\nG0 X150 Z100\nM30\n";
        let page = html(program, Language::English);
        assert!(page.contains("<dt>Clamping length</dt><dd>25.4 mm</dd>"), "{page}");
        assert!(page.contains("<dt>Start of the tool</dt><dd>X150 Z100</dd>"), "{page}");
    }

    /// The table's description of a block.
    fn does(page: &str, block: &str) -> String {
        let row = page.lines().find(|line| line.contains(&format!("<code>{block}</code>")));
        row.and_then(|row| row.split("<td>").nth(3)).unwrap_or_default().replace("</td>", "")
    }

    /// A code with several meanings is described by its meaning in the block.
    #[test]
    fn a_code_is_described_by_what_it_does_here() {
        let program = "G50 S2000\nG50 X100 Z100\nT0101 M3 S500\nG0 X42 Z2\nG90 X40 Z-20 F0.2\nG90 X40 Z-20 R-2\n\
            G94 X20 Z0\nG94 X20 Z-1 R-3\nG92 X39 Z-10 F2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G0 X20\n\
            G1 Z-15\nN20 X42\nG74 R1\nG74 Z-12 Q5000 F0.1\nG28 U0 W0\nM24\nM30\n";
        let page = html(program, Language::English);
        for (block, wanted) in [
            ("G50 S2000", "maximum spindle speed"),
            ("G50 X100 Z100", "set coordinates"),
            ("G90 X40 Z-20 F0.2", "turning cycle, straight;"),
            ("G90 X40 Z-20 R-2", "turning cycle, taper;"),
            ("G94 X20 Z0", "facing cycle, straight;"),
            ("G94 X20 Z-1 R-3", "facing cycle, taper;"),
            ("G92 X39 Z-10 F2", "threading cycle, straight;"),
            ("G71 U2 R1", "values for rough turning"),
            ("G71 P10 Q20 U0.4 W0.1 F0.25", "rough turning;"),
            ("G74 R1", "values for pecking"),
            ("G74 Z-12 Q5000 F0.1", "peck drilling;"),
            ("M24", "thread pull-out off"),
        ] {
            let said = does(&page, block);
            assert!(said.starts_with(wanted), "{block}: {said:?} in\n{page}");
        }
        assert!(does(&html(program, Language::Chinese), "G90 X40 Z-20 R-2").starts_with("锥面切削循环"));
        assert!(does(&html(program, Language::Russian), "G50 S2000").starts_with("наибольшая частота"));
    }

    /// The blocks of a contour without a code make no motions, and move as the last code of the contour says.
    #[test]
    fn each_block_of_a_contour_is_described() {
        let program = "T0101 M3 S500\nG0 X42 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G0 X20\nG1 Z-15\n\
            G2 X30 Z-20 R5\nG1 X34\nN15 W-10\nN20 X42\nG70 P10 Q20\nX60\nM30\n";
        let page = html(program, Language::English);
        for (block, wanted) in [
            ("G0 X20", "rapid"),
            ("G2 X30 Z-20 R5", "arc, clockwise"),
            ("W-10", "straight cut"),
            ("X42", "straight cut"),
        ] {
            let said = does(&page, block);
            assert!(said.starts_with(wanted), "{block}: {said:?} in\n{page}");
        }
        // Behind the contour, a block is described by its motion.
        assert!(!does(&page, "X60").starts_with("straight cut"), "{page}");
        assert!(does(&html(program, Language::Chinese), "W-10").starts_with("直线插补"));
        assert!(does(&html(program, Language::Russian), "X42").starts_with("прямая"));
    }

    #[test]
    fn every_language() {
        assert!(html(PROGRAM, Language::Chinese).contains("主轴正转"));
        assert!(html(PROGRAM, Language::Russian).contains("прямое вращение шпинделя"));
    }

    #[test]
    fn any_text_makes_a_card() {
        for text in [
            "",
            "%",
            "(",
            ")(",
            "O",
            "N",
            "N5 (",
            "G1 X#1",
            "/2 IF [1 EQ 1] GOTO 5",
            "\u{feff}; G01 X\u{ff11}",
        ] {
            assert!(html(text, Language::English).ends_with("</html>\n"), "{text}");
        }
    }
}
