//! Writes new sequence numbers, and the words that refer to them.
//!
//! In: a text, the codes of its control, and a [`Numbering`]. Out: the edits, or the first reason why the
//! numbers stay as they are, with its place. Numbers in comments stay. Each O program is numbered on its own,
//! because a search for a number stays in its program. Must not know files.

use crate::assist::names::Scope;
use crate::message::Edit;
use crate::order;
use crate::references::{MAX_CALLERS, Numbered, Reached, Reference, References, Target};
use crate::sentences::Language;
use crate::setup::dialect::{CodeList, Control};
use crate::source::{LineIndex, Span};
use crate::text::block::{Block, BlockKind};
use crate::text::lexer::{Lexer, TokenKind};
use crate::text::parser::Parser;

/// The new sequence numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbering {
    /// Ascending numbers.
    Ascending {
        /// The number of the first block of each program, at least 1.
        from: u32,
        /// The difference between the numbers of two blocks, at least 1.
        step: u32,
        /// The blocks that get a number.
        blocks: Blocks,
    },
    /// No numbers, except those that are referred to.
    Remove,
}

/// The blocks that get a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blocks {
    /// The blocks that have one.
    Numbered,
    /// These, and all others that contain a word or a macro statement, except `O` blocks and blocks that are not
    /// well formed.
    All,
}

/// A text to renumber.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The program, and the subprograms from other files after it.
    pub text: &'a [u8],
    /// Length of the program itself, bytes: the rest stays as it is.
    pub own: usize,
    /// The codes that it is read with.
    pub codes: CodeList,
    /// The control.
    pub control: Control,
}

/// The reason why the numbers stay as they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// The reason.
    pub reason: Reason,
    /// The word or block that it is about.
    pub span: Span,
}

/// A reason why the numbers stay as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// A reference is known only at run time.
    Computed,
    /// The text of a number is not plain digits.
    Unreadable,
    /// A block that is not well formed may contain references.
    NotWellFormed,
    /// There is no block with the number in the program that is searched.
    Missing {
        /// The number.
        number: u32,
    },
    /// Two blocks have a number that is referred to.
    Twice {
        /// The number.
        number: u32,
        /// The second block with it.
        second: Span,
    },
    /// M99 P leads to blocks of several programs, which get different numbers.
    SeveralCallers {
        /// The number.
        number: u32,
    },
    /// Too many programs call the program of M99 P.
    TooManyCallers {
        /// The largest number of programs.
        most: usize,
    },
    /// A subprogram of another file refers to the block.
    OtherFile {
        /// The number.
        number: u32,
    },
    /// A variable contains the sequence number.
    Variable,
    /// The new number is larger than the control allows.
    TooLarge {
        /// The largest number.
        most: u32,
    },
}

impl Refused {
    /// Why the numbers stay. `text`: that of the [`Source`].
    pub fn reason(&self, text: &[u8], language: Language) -> String {
        let word = self.span.quote(text);
        let word = word.trim();
        let line = |span: Span| LineIndex::new(text).line_of(span.start) + 1;
        use Language::{Chinese, English, Russian};
        match (self.reason, language) {
            (Reason::Computed, English) => format!("`{word}` is known only at run time, so it cannot follow"),
            (Reason::Computed, Chinese) => format!("`{word}` 的值在运行时才能确定，无法同步更改"),
            (Reason::Computed, Russian) => format!("`{word}` известно только при выполнении"),
            (Reason::Unreadable, English) => format!("`{word}` is not written as plain digits"),
            (Reason::Unreadable, Chinese) => format!("`{word}` 中的顺序号不是只用数字写成的"),
            (Reason::Unreadable, Russian) => format!("номер в `{word}` записан не только цифрами"),
            (Reason::NotWellFormed, English) => {
                "this block is not well formed and may refer to a block".to_owned()
            }
            (Reason::NotWellFormed, Chinese) => "该程序段格式有误，可能引用了其他程序段".to_owned(),
            (Reason::NotWellFormed, Russian) => {
                "этот кадр записан неверно и может указывать на другой кадр".to_owned()
            }
            (Reason::Missing { number }, English) => {
                format!("`{word}` refers to N{number}, and no such block is there")
            }
            (Reason::Missing { number }, Chinese) => format!("`{word}` 指向 N{number}，但没有该程序段"),
            (Reason::Missing { number }, Russian) => {
                format!("`{word}` указывает на N{number}, а такого кадра нет")
            }
            (Reason::Twice { number, second }, English) => {
                format!("`{word}` refers to N{number}, which is there again in line {}", line(second))
            }
            (Reason::Twice { number, second }, Chinese) => {
                format!("`{word}` 指向 N{number}，但该顺序号出现两次，另一处在第 {} 行", line(second))
            }
            (Reason::Twice { number, second }, Russian) => {
                format!("`{word}` указывает на N{number}, а этот номер повторяется в строке {}", line(second))
            }
            (Reason::SeveralCallers { number }, English) => {
                format!("`{word}` refers to N{number} of several programs, which get different numbers")
            }
            (Reason::SeveralCallers { number }, Chinese) => {
                format!("`{word}` 指向多个程序中的 N{number}，而这些程序段的新顺序号各不相同")
            }
            (Reason::SeveralCallers { number }, Russian) => {
                format!(
                    "`{word}` указывает на N{number} в нескольких программах, а новые номера этих кадров различны"
                )
            }
            (Reason::TooManyCallers { most }, English) => {
                format!("`{word}` refers to blocks of more than {most} programs")
            }
            (Reason::TooManyCallers { most }, Chinese) => {
                format!("`{word}` 所指的程序段分布在 {most} 个以上的程序中")
            }
            (Reason::TooManyCallers { most }, Russian) => {
                format!("`{word}` указывает на кадры более чем {most} программ")
            }
            (Reason::OtherFile { number }, English) => {
                format!("a subprogram in another file refers to N{number}")
            }
            (Reason::OtherFile { number }, Chinese) => format!("另一文件中的子程序指向 N{number}"),
            (Reason::OtherFile { number }, Russian) => {
                format!("на N{number} указывает подпрограмма в другом файле")
            }
            (Reason::Variable, English) => {
                format!("`{word}` is the number of a block, which the program computes with")
            }
            (Reason::Variable, Chinese) => format!("`{word}` 的值是顺序号，程序会用到它"),
            (Reason::Variable, Russian) => {
                format!("`{word}` содержит номер кадра, и программа использует это значение")
            }
            (Reason::TooLarge { most }, English) => {
                format!("the number of this block would be above N{most}")
            }
            (Reason::TooLarge { most }, Chinese) => format!("该程序段的顺序号会超过 N{most}"),
            (Reason::TooLarge { most }, Russian) => format!("номер этого кадра был бы больше N{most}"),
        }
    }
}

/// The edits that renumber a text, sorted by position, not overlapping.
pub fn edits(source: Source, numbering: Numbering) -> Result<Vec<Edit>, Refused> {
    let found = References::of(source.text, source.codes, source.control);
    let checked = Checked::new(source, &found)?;
    match numbering {
        Numbering::Remove => checked.removed(),
        Numbering::Ascending { from, step, blocks } => {
            let others = if blocks == Blocks::All { unnumbered(source) } else { Vec::new() };
            checked.renumbered(&others, Steps { from, step })
        }
    }
}

/// The numbers of ascending blocks.
#[derive(Clone, Copy)]
struct Steps {
    from: u32,
    step: u32,
}

impl Steps {
    /// The number of the block at an index, from 0; `None` above `most`.
    fn at(self, index: usize, most: u32) -> Option<u32> {
        let steps = u32::try_from(index).ok()?.checked_mul(self.step)?;
        self.from.checked_add(steps).filter(|number| *number <= most)
    }
}

/// A block without a sequence number that can get one.
struct Unnumbered {
    /// Index of the block in the text.
    block: usize,
    /// Where its number is inserted.
    at: u32,
}

/// References that can follow new numbers.
struct Checked<'a> {
    source: Source<'a>,
    found: &'a References,
    /// Indices of the blocks that are referred to, ascending.
    targets: Vec<usize>,
}

impl<'a> Checked<'a> {
    fn new(source: Source<'a>, found: &'a References) -> Result<Self, Refused> {
        if let Some(span) = found.variables.first() {
            return Err(Refused { reason: Reason::Variable, span: *span });
        }
        let mut checked = Self { source, found, targets: Vec::new() };
        checked.refuse_unclear_blocks()?;
        for reference in &found.references {
            let blocks = checked.blocks_of(reference)?;
            checked.targets.extend(blocks.iter().filter_map(|reached| reached.block));
        }
        order::by_key(&mut checked.targets, |block| *block);
        Ok(checked)
    }

    /// A block that is not well formed may refer to a block by a word that cannot be read.
    fn refuse_unclear_blocks(&self) -> Result<(), Refused> {
        let text = &self.source.text[..self.source.own];
        let (mut parser, mut block) = (Parser::new(text), Block::default());
        while parser.next_block(&mut block) {
            if block.is_broken() && may_refer(text, &block) {
                return Err(Refused { reason: Reason::NotWellFormed, span: block.span });
            }
        }
        Ok(())
    }

    /// The blocks that a reference leads to, as far as they or the reference are in the program itself.
    fn blocks_of<'r>(&self, reference: &'r Reference) -> Result<&'r [Reached], Refused> {
        let refused = |reason| Err(Refused { reason, span: reference.span });
        let is_own = self.is_own(reference.span);
        let (number, reached) = match &reference.target {
            Target::Computed if !is_own && reference.scope == Scope::Own => return Ok(&[]),
            Target::Computed => return refused(Reason::Computed),
            Target::TooManyCallers => return refused(Reason::TooManyCallers { most: MAX_CALLERS }),
            Target::Elsewhere => return Ok(&[]),
            Target::Blocks { number, reached } => (*number, reached),
        };
        if !is_own && !reached.iter().any(|reached| self.is_own_program(reached.program)) {
            return Ok(&[]);
        }
        for program in reached {
            let mut blocks = self.found.with_number(program.program, number);
            match (blocks.next(), blocks.next()) {
                (None, _) => return refused(Reason::Missing { number }),
                (Some(_), Some(second)) => {
                    return refused(Reason::Twice { number, second: second.span });
                }
                (Some(_), None) => {}
            }
        }
        Ok(reached)
    }

    fn is_own_program(&self, program: usize) -> bool {
        self.found.programs.get(program).is_some_and(|head| (head.at as usize) < self.source.own)
    }

    fn is_own(&self, span: Span) -> bool {
        span.end as usize <= self.source.own
    }

    fn is_target(&self, block: &Numbered) -> bool {
        self.targets.binary_search(&block.block).is_ok()
    }

    /// The numbered blocks of the program itself.
    fn own_blocks(&self) -> impl Iterator<Item = &'a Numbered> {
        let own = self.source.own;
        self.found.numbered.iter().filter(move |block| block.span.end as usize <= own)
    }

    /// Removes the numbers that nothing refers to, with the blanks after them.
    fn removed(&self) -> Result<Vec<Edit>, Refused> {
        let text = self.source.text;
        let edit = |block: &Numbered| {
            let after = &text[block.span.end as usize..];
            let blanks = after.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
            if after.get(blanks).is_some_and(|byte| begins_head(*byte)) {
                return None;
            }
            let span = Span { end: block.span.end + blanks as u32, ..block.span };
            let removed = digits(text, block.span, block.number).map(|_| Edit { span, text: String::new() });
            Some(removed)
        };
        self.own_blocks().filter(|block| !self.is_target(block)).filter_map(edit).collect()
    }

    fn renumbered(&self, unnumbered: &[Unnumbered], steps: Steps) -> Result<Vec<Edit>, Refused> {
        let numbers = self.new_numbers(unnumbered, steps)?;
        let mut edits = Vec::new();
        for block in self.own_blocks() {
            let span = digits(self.source.text, block.span, block.number)?;
            edits.extend(self.written(span, numbers.of(block.block).unwrap_or(block.number)));
        }
        for reference in &self.found.references {
            edits.extend(self.reference(reference, &numbers)?);
        }
        let width = self.width();
        edits.extend(unnumbered.iter().filter_map(|block| {
            let text = format!("N{:0width$} ", numbers.of(block.block)?);
            Some(Edit { span: Span { start: block.at, end: block.at }, text })
        }));
        order::by_key(&mut edits, |edit| edit.span.start);
        Ok(edits)
    }

    /// The new numbers of the blocks of the program itself.
    fn new_numbers(&self, unnumbered: &[Unnumbered], steps: Steps) -> Result<Numbers, Refused> {
        let most = self.source.control.largest_sequence();
        let numbered = self.own_blocks().map(|block| (block.block, block.span));
        let others = unnumbered.iter().map(|block| (block.block, Span { start: block.at, end: block.at }));
        let mut blocks: Vec<(usize, Span)> = numbered.chain(others).collect();
        order::by_key(&mut blocks, |(block, _)| *block);
        let (mut numbers, mut program, mut index) = (Vec::new(), 0, 0);
        for (block, span) in blocks {
            let own = self.found.program_of(block);
            if own != program {
                (program, index) = (own, 0);
            }
            let refused = || Refused { reason: Reason::TooLarge { most }, span };
            numbers.push((block, steps.at(index, most).ok_or_else(refused)?));
            index += 1;
        }
        Ok(Numbers(numbers))
    }

    /// The edit of a reference.
    fn reference(&self, reference: &Reference, numbers: &Numbers) -> Result<Option<Edit>, Refused> {
        let Target::Blocks { number, reached } = &reference.target else { return Ok(None) };
        let number = *number;
        let refused = |reason| Refused { reason, span: reference.span };
        let new = |reached: &Reached| reached.block.and_then(|block| numbers.of(block)).unwrap_or(number);
        let mut wanted = reached.iter().map(new);
        let Some(first) = wanted.next() else { return Ok(None) };
        if wanted.any(|other| other != first) {
            return Err(refused(Reason::SeveralCallers { number }));
        }
        match self.is_own(reference.span) {
            true => Ok(self.written(digits(self.source.text, reference.span, number)?, first)),
            false if first == number => Ok(None),
            false => {
                let target = reached.first().and_then(|reached| reached.block);
                let block = self.own_blocks().find(|block| Some(block.block) == target);
                let span = block.map_or(reference.span, |block| block.span);
                Err(Refused { reason: Reason::OtherFile { number }, span })
            }
        }
    }

    /// The edit that writes a number with at least as many digits, if the old one begins with a zero.
    fn written(&self, span: Span, number: u32) -> Option<Edit> {
        let old = span.of(self.source.text);
        let width = if old.starts_with(b"0") { old.len() } else { 0 };
        let text = format!("{number:0width$}");
        (text.as_bytes() != old).then_some(Edit { span, text })
    }

    /// The number of digits of new numbers: that of the first number, if it begins with a zero.
    fn width(&self) -> usize {
        let first = self.own_blocks().next();
        let digits = first.and_then(|block| digits(self.source.text, block.span, block.number).ok());
        let written = digits.map(|span| span.of(self.source.text)).filter(|old| old.starts_with(b"0"));
        written.map_or(0, <[u8]>::len)
    }
}

/// New numbers by the index of the block, ascending.
struct Numbers(Vec<(usize, u32)>);

impl Numbers {
    fn of(&self, block: usize) -> Option<u32> {
        let at = self.0.binary_search_by_key(&block, |(index, _)| *index).ok()?;
        Some(self.0[at].1)
    }
}

/// The digits in the text of a number.
fn digits(text: &[u8], span: Span, number: u32) -> Result<Span, Refused> {
    let refused = Refused { reason: Reason::Unreadable, span };
    let bytes = span.of(text);
    let first = bytes.iter().position(u8::is_ascii_digit).ok_or(refused.clone())?;
    let count = bytes[first..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let found = Span::new(span.start as usize + first, span.start as usize + first + count);
    let is_alone = bytes[first + count..].iter().all(|byte| matches!(byte, b'.' | b'0'));
    match found.quote(text).parse() {
        Ok(written) if u32::eq(&written, &number) && is_alone => Ok(found),
        _ => Err(refused),
    }
}

/// Whether a word that begins with this byte would be read differently at the head of a block: a program or
/// sequence number, a name, `%`, a number.
fn begins_head(byte: u8) -> bool {
    matches!(byte, b'O' | b'o' | b'N' | b'n' | b':' | b'<' | b'%' | b'.' | b'0'..=b'9')
}

/// Whether a block contains P or Q with a value outside its comments.
fn may_refer(text: &[u8], block: &Block) -> bool {
    let lexer = Lexer::new(&text[..block.span.end as usize], block.span.start as usize);
    let mut tokens = lexer.filter(|token| token.kind != TokenKind::Blank).peekable();
    while let Some(token) = tokens.next() {
        let has_value = |kind| matches!(kind, TokenKind::Number(_) | TokenKind::Macro(b'#' | b'['));
        let is_followed = tokens.peek().is_some_and(|next| has_value(next.kind));
        if is_followed && matches!(token.kind, TokenKind::Letter(b'P' | b'Q')) {
            return true;
        }
    }
    false
}

/// The blocks of the program itself that can get a number.
fn unnumbered(source: Source) -> Vec<Unnumbered> {
    let text = &source.text[..source.own];
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let (mut found, mut index) = (Vec::new(), 0);
    while parser.next_block(&mut block) {
        let is_well_formed = block.faults.is_empty() && !block.is_unread;
        let is_head = block.program.is_some() || block.sequence.is_some();
        if is_well_formed && !is_head && !block.is_empty() && block.kind != BlockKind::Percent {
            found.push(Unnumbered { block: index, at: after_slash(text, &block) });
        }
        index += 1;
    }
    found
}

/// The first byte of a block after blanks and slashes with their levels.
fn after_slash(text: &[u8], block: &Block) -> u32 {
    let mut lexer = Lexer::new(&text[..block.span.end as usize], block.span.start as usize);
    loop {
        let at = lexer.position();
        match lexer.next_token().map(|token| token.kind) {
            Some(TokenKind::Blank) => {}
            Some(TokenKind::Slash) => {
                if matches!(lexer.peek_byte(), Some(b'1'..=b'9')) {
                    lexer.seek(lexer.position() + 1);
                }
            }
            _ => return at as u32,
        }
    }
}
