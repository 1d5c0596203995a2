//! The words of a program, and edits of single words.

use gcode_playground::text::block::{Block, Value};
use gcode_playground::text::parser::Parser;

/// A word and its position.
#[derive(Clone, Debug)]
pub struct Word {
    /// The address in upper case; N and O are words too.
    pub address: char,
    /// The value, with its sign.
    pub value: f64,
    /// First byte, and end (exclusive).
    pub start: usize,
    pub end: usize,
    /// The block, counted from 0.
    pub block: usize,
}

/// A program split into words.
pub struct Words<'a> {
    pub text: &'a str,
    pub words: Vec<Word>,
    /// First byte and end of each block.
    pub blocks: Vec<(usize, usize)>,
}

impl<'a> Words<'a> {
    pub fn of(text: &'a str) -> Self {
        let mut parser = Parser::new(text.as_bytes());
        let mut block = Block::default();
        let (mut words, mut blocks) = (Vec::new(), Vec::new());
        while parser.next_block(&mut block) {
            let here = blocks.len();
            blocks.push((block.span.start as usize, block.span.end as usize));
            for word in &block.words {
                let Value::Number { number, negative } = word.value else { continue };
                let value = if negative { -number.value() } else { number.value() };
                let (start, end) = (word.span.start as usize, word.span.end as usize);
                words.push(Word { address: word.address as char, value, start, end, block: here });
            }
            if let Some(sequence) = block.sequence {
                let head = &text[block.span.start as usize..block.span.end as usize];
                if let Some(at) = head.find(['N', 'n']) {
                    let start = block.span.start as usize + at;
                    let digits = text[start + 1..].bytes().take_while(u8::is_ascii_digit).count();
                    let value = f64::from(sequence);
                    words.push(Word { address: 'N', value, start, end: start + 1 + digits, block: here });
                }
            }
        }
        words.sort_by_key(|word| word.start);
        Self { text, words, blocks }
    }

    /// The word as written.
    pub fn written(&self, word: &Word) -> &'a str {
        &self.text[word.start..word.end]
    }

    /// All words of a block except its sequence number.
    pub fn of_block(&self, block: usize) -> impl Iterator<Item = &Word> {
        self.words.iter().filter(move |word| word.block == block && word.address != 'N')
    }

    /// The word of an address in a block.
    pub fn find(&self, block: usize, address: char) -> Option<&Word> {
        self.of_block(block).find(|word| word.address == address)
    }

    /// Whether a block contains this G code.
    pub fn has_g(&self, block: usize, code: f64) -> bool {
        self.of_block(block).any(|word| word.address == 'G' && word.value == code)
    }

    /// The program with a range replaced, and the new range.
    pub fn replaced(&self, start: usize, end: usize, with: &str) -> (String, usize, usize) {
        let text = format!("{}{with}{}", &self.text[..start], &self.text[end..]);
        (text, start, start + with.len())
    }

    /// Replaces a word.
    pub fn rewritten(&self, word: &Word, with: &str) -> (String, usize, usize) {
        self.replaced(word.start, word.end, with)
    }

    /// Start and end of the line that contains a byte.
    pub fn line_at(&self, at: usize) -> (usize, usize) {
        let start = self.text[..at].rfind('\n').map_or(0, |found| found + 1);
        let end = self.text[at..].find('\n').map_or(self.text.len(), |found| at + found);
        (start, end)
    }
}
