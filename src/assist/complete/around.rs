//! What the text around a place uses: numbers, tools, feeds and speeds.

use crate::assist::form::g_of;
use crate::control::codes::G;
use crate::setup::dialect::CodeList;
use crate::source::{Span, line_around};
use crate::text::block::{Block, BlockKind};
use crate::text::parser::{Parser, Resume};
use crate::text::program_name::is_name;

/// Bytes before and after a line that are looked through.
const FAR: usize = 256 * 1024;

/// What the text around a line uses, in the order of the text. Places are the first bytes of blocks.
#[derive(Default)]
pub struct Around {
    /// The sequence numbers, and where they are.
    pub sequences: Vec<(u32, u32)>,
    /// The programs, and where they are.
    pub programs: Vec<(u32, u32)>,
    /// The T words before the line, once each.
    pub tools: Vec<String>,
    /// The values of F and S before the line, once each, with their letters.
    pub rates: Vec<(u8, String)>,
    /// The last block before the line that has words.
    pub last: Option<u32>,
    /// A contour was roughed before the line, and not finished since.
    pub is_roughed: bool,
}

impl Around {
    /// What the text around a line uses; the line itself is not there yet.
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

    /// The highest sequence number; 0 where there is none.
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
