//! Collects what the text around a place uses: numbers, tools, feeds and speeds.

use crate::assist::form::g_of;
use crate::control::codes::G;
use crate::setup::dialect::CodeList;
use crate::source::{Span, line_around};
use crate::text::block::{Block, BlockKind};
use crate::text::parser::{Parser, Resume};
use crate::text::program_name::is_name;

/// Number of bytes scanned before and after a line.
const FAR: usize = 256 * 1024;

/// Numbers and values in the text around a line, in text order. Offsets are the first bytes of blocks.
#[derive(Default)]
pub struct Around {
    /// Sequence numbers, with their offsets.
    pub sequences: Vec<(u32, u32)>,
    /// Programs, with their offsets.
    pub programs: Vec<(u32, u32)>,
    /// Different T words before the line.
    pub tools: Vec<String>,
    /// Different values of F and S before the line, with their letters.
    pub rates: Vec<(u8, String)>,
    /// The last block with words before the line.
    pub last: Option<u32>,
    /// Whether a contour before the line was roughed but not finished.
    pub is_roughed: bool,
}

impl Around {
    /// Scans the text around a line, excluding the line itself.
    pub fn of(text: &[u8], line: Span, codes: CodeList) -> Self {
        let end = text.len().min(line.end as usize + FAR);
        let from = (line.start as usize).saturating_sub(FAR);
        let from = line_around(text, from).start;
        let mut parser = Parser::resume(&text[..end], Resume::inside(from, 0));
        let (mut around, mut block) = (Self::default(), Block::default());
        while parser.next_block(&mut block) {
            let at = block.span.start;
            if at >= line.start && at <= line.end {
                continue;
            }
            around.sequences.extend(block.sequence.map(|number| (number, at)));
            around.programs.extend(
                block.program.filter(|(number, _)| !is_name(*number)).map(|(number, _)| (number, at)),
            );
            if at < line.start && !block.words.is_empty() && block.kind != BlockKind::Macro {
                around.take_words(text, &block, codes);
                around.last = Some(at);
            }
        }
        around
    }

    /// The highest sequence number; 0 if there is none.
    pub fn last_sequence(&self) -> u32 {
        self.sequences.iter().map(|&(number, _)| number).max().unwrap_or(0)
    }

    fn take_words(&mut self, text: &[u8], block: &Block, codes: CodeList) {
        for word in &block.words {
            match word.address {
                b'T' => {
                    let tool = word.span.quote(text);
                    if !self.tools.contains(&tool) {
                        self.tools.push(tool);
                    }
                }
                b'F' | b'S' => {
                    let quoted = word.span.quote(text);
                    let rate = (word.address, quoted.get(1..).unwrap_or_default().to_owned());
                    self.rates.retain(|other| *other != rate);
                    self.rates.push(rate);
                }
                b'G' => {
                    if let Some(G::Multiple(cycle)) = g_of(word, codes) {
                        self.is_roughed = cycle.is_roughing();
                    }
                }
                _ => {}
            }
        }
    }
}
