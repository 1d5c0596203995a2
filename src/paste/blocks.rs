//! Groups items into blocks, and records the text between consecutive blocks.
//!
//! In: items. Out: [`Blocks`]. A block ends where it ends on a control, and where a printed text lost the end
//! of block: before N, before a second axis word with the same letter, before a second code of the same
//! group.

use super::items::{Item, Kind, Word, slice};
use crate::control::codes;

/// Owner of an item that belongs to no block.
pub(super) const NO_BLOCK: u32 = u32::MAX;

/// Minimum number of consecutive sequence numbers that count as a column of a table.
const LONE_NUMBERS: usize = 3;

/// The text between a block and the previous one; spaces, bullets, line numbers and noise are ignored.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Gap {
    /// Number of text lines without a block.
    pub lines: usize,
    /// Length of the text on these lines, bytes.
    pub beyond: usize,
    /// Length of the text before the block on its own line, but after the previous block, bytes.
    pub before: usize,
    /// Whether both blocks are on one line.
    pub same_line: bool,
    /// Whether there is an ellipsis `…`, a deliberate omission.
    pub ellipsis: bool,
    /// Whether there is a `%`.
    pub percent: bool,
}

impl Gap {
    /// Whether the blocks are adjacent, apart from a line end or text after the first block.
    pub fn is_close(self) -> bool {
        self.lines == 0 && self.before == 0 && !self.ellipsis
    }

    /// Total length of the text, bytes.
    pub fn text(self) -> usize {
        self.beyond + self.before
    }
}

/// Items that form a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Block {
    /// The item range: first, and one past the last.
    pub first: usize,
    pub end: usize,
    /// Its program number.
    pub head: Option<u32>,
    /// Its sequence number.
    pub sequence: Option<f64>,
    /// Number of words other than O and N, and of macro statements.
    pub words: usize,
    /// Whether it programs a move.
    pub moves: bool,
    /// Whether it contains M02, M30 or M99.
    pub ends_program: bool,
    /// Whether it is only a program number within a sentence: the title of a table.
    pub table_head: bool,
    /// Whether it is a code mentioned in a sentence.
    pub mention: bool,
    /// Axis letters, as a bit set.
    axes: u32,
    /// Whether it contains a code of group 01.
    codes: bool,
    /// The last item that is a code of group 01 after an axis word.
    code_behind: Option<usize>,
    /// The text before it.
    pub gap: Gap,
}

/// The blocks of a text.
#[derive(Debug, Default)]
pub(super) struct Blocks {
    pub list: Vec<Block>,
    /// For each item, the index of its block.
    pub owner: Vec<u32>,
}

/// Groups the items of a text into blocks.
pub(super) fn assemble(text: &str, items: &[Item]) -> Blocks {
    let words = || items.iter().filter(|item| matches!(item.kind, Kind::Word(_)));
    let small = words().filter(|item| is_small(text, item)).count();
    let mut assembler = Assembler {
        text,
        items,
        in_capitals: words().count() > 2 * small,
        blocks: Blocks { list: Vec::new(), owner: vec![NO_BLOCK; items.len()] },
        open: false,
        reachable: false,
        tainted: false,
        gap: Gap::default(),
        on_line: 0,
        block_on_line: false,
    };
    for at in 0..items.len() {
        assembler.take(at);
    }
    let mut blocks = assembler.blocks;
    drop_columns(&mut blocks, items);
    for block in &mut blocks.list {
        block.mention = block.head.is_none() && is_mention(text, items, block);
        let followed = items.get(block.end).is_some_and(|next| next.kind == Kind::Prose);
        block.table_head = block.head.is_some() && block.words == 0 && block.gap.before > 0 && followed;
    }
    blocks
}

/// Whether a word begins with a lower-case letter.
fn is_small(text: &str, item: &Item) -> bool {
    slice(text, item.span).starts_with(|c: char| c.is_ascii_lowercase())
}

struct Assembler<'a> {
    text: &'a str,
    items: &'a [Item],
    /// Whether most words of the text are in capitals.
    in_capitals: bool,
    blocks: Blocks,
    /// Whether the last block can be extended.
    open: bool,
    /// Whether further words on the line may still belong to the last block.
    reachable: bool,
    /// Whether the line is a format with placeholders, whose codes do not count.
    tainted: bool,
    gap: Gap,
    /// Length of the text on this line since its last block, bytes.
    on_line: usize,
    /// Whether there is a block on this line.
    block_on_line: bool,
}

impl Assembler<'_> {
    fn take(&mut self, at: usize) {
        let item = self.items[at];
        match item.kind {
            Kind::Word(word) => self.word(at, word),
            Kind::Comment => {
                if self.open || self.reachable {
                    self.own(at);
                } else if self.on_line == 0 && !self.tainted {
                    self.begin(at);
                } else {
                    self.text(item);
                }
            }
            Kind::Macro => {
                let goes_on =
                    self.open && self.last().is_some_and(|block| block.words == 0 && block.head.is_none());
                if !goes_on {
                    self.begin(at);
                }
                self.own(at);
                self.count(1);
            }
            Kind::Slash => {
                if !self.open {
                    self.begin(at);
                }
                self.own(at);
            }
            Kind::Semicolon => {
                self.tainted = false;
                if self.open || self.reachable {
                    self.own(at);
                }
                self.open = false;
            }
            Kind::LineEnd => self.line_end(),
            Kind::Percent => {
                self.close();
                self.gap.percent = true;
            }
            Kind::Bullet if slice(self.text, item.span) == "|" => {}
            Kind::Bullet => {
                if self.last().is_some_and(|block| block.words > 0 || block.head.is_some()) {
                    self.open = false;
                }
            }
            Kind::LineNumber => {}
            Kind::Ellipsis => {
                self.close();
                self.gap.ellipsis = true;
            }
            Kind::Foreign if self.open => self.own(at),
            Kind::Placeholder => {
                self.discard_block();
                self.tainted = true;
                self.text(item);
            }
            Kind::Noise => {
                self.trim();
                self.close();
            }
            Kind::Comma => {}
            Kind::Mark => {
                let ends =
                    slice(self.text, item.span).contains(['.', ':', '!', '?', '。', '：', '！', '？', '—']);
                if ends {
                    self.close();
                }
            }
            Kind::Letter | Kind::Prose | Kind::Foreign => {
                self.tainted = false;
                self.text(item);
            }
        }
    }

    fn last(&mut self) -> Option<&mut Block> {
        self.blocks.list.last_mut()
    }

    fn close(&mut self) {
        self.open = false;
        self.reachable = false;
    }

    /// Handles text that belongs to no block.
    fn text(&mut self, item: Item) {
        if self.open && self.last().is_some_and(|block| is_remark(block)) {
            self.discard_block();
        }
        self.close();
        self.on_line += item.span.len();
    }

    fn line_end(&mut self) {
        self.close();
        self.tainted = false;
        if !self.block_on_line && self.on_line > 0 {
            self.gap.lines += 1;
            self.gap.beyond += self.on_line;
        }
        self.on_line = 0;
        self.block_on_line = false;
    }

    /// Starts a block with an item.
    fn begin(&mut self, at: usize) {
        let mut gap = self.gap;
        gap.same_line = self.block_on_line;
        gap.before = self.on_line;
        self.gap = Gap::default();
        self.on_line = 0;
        self.block_on_line = true;
        self.blocks.list.push(Block { first: at, end: at, gap, ..Block::default() });
        self.open = true;
        self.own(at);
    }

    fn own(&mut self, at: usize) {
        self.blocks.owner[at] = self.blocks.list.len() as u32 - 1;
        if let Some(block) = self.last() {
            block.end = at + 1;
        }
        self.reachable = true;
    }

    fn count(&mut self, words: usize) {
        if let Some(block) = self.last() {
            block.words += words;
        }
    }

    /// Removes the last block, which turned out not to be one.
    fn discard_block(&mut self) {
        if !self.open {
            return;
        }
        if let Some(block) = self.blocks.list.pop() {
            self.blocks.owner[block.first..block.end].fill(NO_BLOCK);
            let bytes = self.items[block.end - 1].span.end - self.items[block.first].span.start;
            self.on_line += block.gap.before + bytes as usize;
            self.block_on_line = block.gap.same_line;
            self.gap = Gap { before: 0, same_line: false, ..block.gap };
        }
        self.close();
    }

    /// Before noise: removes lower-case words at the end of an open block in capitals, since they belong to
    /// the noise.
    fn trim(&mut self) {
        if !self.open {
            return;
        }
        let small = |item: &Item| is_small(self.text, item);
        let Some(block) = self.blocks.list.last() else { return };
        let (first, mut end) = (block.first, block.end);
        if small(&self.items[first]) {
            if end == first + 1 && self.in_capitals {
                self.discard_block();
            }
            return;
        }
        while end > first + 1
            && matches!(self.items[end - 1].kind, Kind::Word(_))
            && small(&self.items[end - 1])
        {
            end -= 1;
            self.blocks.owner[end] = NO_BLOCK;
        }
        let gap = block.gap;
        let mut again = Block { first, end, gap, ..Block::default() };
        for at in first..end {
            note(&mut again, self.items, at);
        }
        // A single letter and digit before noise also count as noise.
        let first_letter = match self.items[first].kind {
            Kind::Word(word) => word.letter,
            _ => b'G',
        };
        let weak = end == first + 1 && !b"GMTSNOXZUW".contains(&first_letter);
        if let Some(block) = self.last() {
            *block = again;
        }
        if weak {
            self.discard_block();
        }
    }

    fn word(&mut self, at: usize, word: Word) {
        let item = self.items[at];
        if self.tainted {
            return self.text(item);
        }
        if word.letter == b'O' {
            let number = word.value >= 1.0 && word.value < 1e8 && word.value.fract() == 0.0;
            let small = slice(self.text, item.span).starts_with('o') && self.block_on_line;
            if !number || small {
                // Within a block it is probably noise, which `trim` removes if more noise follows.
                return if self.open { self.own(at) } else { self.text(item) };
            }
        }
        if self.open && self.splits_before(word) {
            self.open = false;
        }
        if self.open && self.splits_earlier(word) {
            self.split_at_code();
        }
        if self.open {
            self.own(at);
        } else {
            self.begin(at);
        }
        let items = self.items;
        if let Some(block) = self.last() {
            note(block, items, at);
        }
    }

    fn splits_before(&mut self, word: Word) -> bool {
        let Some(block) = self.last() else { return false };
        match word.letter {
            b'N' => block.words > 0 || block.sequence.is_some() || block.head.is_some(),
            b'O' => !is_remark(block),
            b'G' => is_group_1(word) && block.codes && block.axes != 0,
            _ => repeats(block, word) && block.code_behind.is_none(),
        }
    }

    /// Whether the block should have ended before a code it already contains: `Z0 G90 X62 Z-43`.
    fn splits_earlier(&mut self, word: Word) -> bool {
        self.last().is_some_and(|block| repeats(block, word) && block.code_behind.is_some())
    }

    fn split_at_code(&mut self) {
        let items = self.items;
        let Some(block) = self.last() else { return };
        let Some(at) = block.code_behind else { return };
        let (first, end, gap) = (block.first, block.end, block.gap);
        let mut before = Block { first, end: at, gap, ..Block::default() };
        (first..at).for_each(|at| note(&mut before, items, at));
        *block = before;
        let mut after =
            Block { first: at, end, gap: Gap { same_line: true, ..Gap::default() }, ..Block::default() };
        (at..end).for_each(|at| note(&mut after, items, at));
        self.blocks.list.push(after);
        let number = self.blocks.list.len() as u32 - 1;
        for owner in &mut self.blocks.owner[at..end] {
            if *owner != NO_BLOCK {
                *owner = number;
            }
        }
    }
}

/// Whether a block contains only comments.
fn is_remark(block: &Block) -> bool {
    block.words == 0 && block.head.is_none() && block.sequence.is_none()
}

fn axis_bit(word: Word) -> u32 {
    match word.letter {
        b'X' | b'Z' | b'U' | b'W' => 1 << (word.letter - b'A'),
        _ => 0,
    }
}

fn repeats(block: &Block, word: Word) -> bool {
    block.axes & axis_bit(word) != 0
}

/// Whether a word is a code of group 01, of which a block contains only one.
fn is_group_1(word: Word) -> bool {
    word.letter == b'G' && u64::try_from(word.tenths()).is_ok_and(codes::is_of_motion_group)
}

/// Updates the properties of a block with an item.
fn note(block: &mut Block, items: &[Item], at: usize) {
    match items[at].kind {
        Kind::Word(word) => match word.letter {
            b'O' if block.head.is_none() && block.words == 0 => block.head = Some(word.value as u32),
            b'O' => {}
            b'N' if block.sequence.is_none() => block.sequence = Some(word.value),
            _ => {
                block.words += 1;
                if is_group_1(word) {
                    block.codes = true;
                    if block.axes != 0 {
                        block.code_behind = Some(at);
                    }
                }
                block.axes |= axis_bit(word);
                block.moves = block.axes != 0;
                block.ends_program |= word.letter == b'M' && matches!(word.tenths(), 20 | 300 | 990);
            }
        },
        Kind::Macro => block.words += 1,
        _ => {}
    }
}

/// Removes sequence numbers that form a separate column: a table that was extracted column by column.
fn drop_columns(blocks: &mut Blocks, items: &[Item]) {
    let bare = |block: &Block| {
        block.words == 0 && block.head.is_none() && block.sequence.is_some() && block.end == block.first + 1
    };
    let mut at = 0;
    let mut gone = vec![false; blocks.list.len()];
    while at < blocks.list.len() {
        let mut end = at;
        while end < blocks.list.len()
            && bare(&blocks.list[end])
            && (end == at || (blocks.list[end].gap.same_line && blocks.list[end].gap.is_close()))
        {
            end += 1;
        }
        if end - at >= LONE_NUMBERS {
            gone[at..end].fill(true);
        }
        at = end.max(at + 1);
    }
    if !gone.contains(&true) {
        return;
    }
    let mut kept: Vec<Block> = Vec::with_capacity(blocks.list.len());
    let mut carried = Gap::default();
    for (number, block) in std::mem::take(&mut blocks.list).into_iter().enumerate() {
        let range = block.first..block.end;
        if gone[number] {
            blocks.owner[range].fill(NO_BLOCK);
            carried.lines += block.gap.lines;
            carried.beyond += block.gap.text() + items[block.first].span.len();
            continue;
        }
        for owner in &mut blocks.owner[range] {
            if *owner == number as u32 {
                *owner = kept.len() as u32;
            }
        }
        let mut gap = block.gap;
        gap.lines += carried.lines;
        gap.beyond += carried.beyond;
        carried = Gap::default();
        kept.push(Block { gap, ..block });
    }
    blocks.list = kept;
}

/// Whether a block is a code mentioned in a sentence: letters or punctuation of the sentence touch it.
fn is_mention(text: &str, items: &[Item], block: &Block) -> bool {
    let touches = |c: char| {
        (c.is_alphabetic() && !c.is_ascii()) || matches!(c, '、' | '—' | '“' | '”' | '«' | '»' | '～')
    };
    let (first, last) = (items[block.first], items[block.end - 1]);
    if is_remark(block) || block.words == 0 {
        return false;
    }
    let before = text[..first.span.start as usize].chars().next_back().is_some_and(touches);
    let after = text[last.span.end as usize..].chars().next().is_some_and(touches);
    before
        || (after
            && block.words == 1
            && matches!(last.kind, Kind::Word(word) if !b"XZUW".contains(&word.letter)))
}
