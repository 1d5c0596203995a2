//! Parses tokens into blocks. Never fails: text that cannot be parsed becomes an error of its block, and
//! parsing continues.
//!
//! ```text
//! program  = { block ( LINE-END | ";" ) }
//! block    = "%" | { skip } [ ( "O" | ":" ) number [ name ] | [ "O" ] name ] [ "N" number ] contents
//! skip     = "/" [digit]
//! contents = { word | comment | skip } | macro | note
//! word     = [ "," ] letter [ sign ] ( number | expression )        blanks are allowed anywhere between
//!          | name                                                   after M98, G65, G66: the program that is called
//! name     = "<" … ">"
//! macro    = ( "#" | keyword ) …                                    up to the end of the block
//! keyword  = "IF" | "WHILE" | "GOTO" | "DO" | "END" | "THEN"
//!          | "POPEN" | "PCLOS" | "BPRNT" | "DPRNT" | "SETVN"
//! note     = "[" letter …                                           up to the end of the line: a comment
//! comment  = "(" … ")"
//! ```
//!
//! Terms: *Text* is anything that does not read as words of a block. It may contain *plain words*, letters
//! that can only be text. A *remark* is text without brackets that is meant as a comment. A *comment* is in
//! brackets, or a remark that the block keeps as a comment.
//!
//! In: text. Out: one [`Block`] at a time, in reused storage, so that a long program needs no more memory
//! than a short one. Knows which letters begin a word, but not what a word means.

use super::block::{Block, BlockKind, Value, Word};
use super::lexer::{Lexer, Number, TokenKind, is_between_blocks, is_blank};
use super::long_comment;
use super::lost_letter;
use super::misread::{self, Misread};
use super::plain_line::PlainLine;
use super::plain_words::{PlainWords, begins_as_sentence, begins_in_other_script};
use super::program_name;
use crate::limits::MAX_DIGITS;
use crate::message::{Diagnostic, Edit, Fix, Message, Repair, Severity, said, sort_by_place};
use crate::order;
use crate::parts::{Part, early};
use crate::source::shift::Shift;
use crate::source::{Span, line_end};

/// Most errors without a safe fix that are reported for one block; one mistake often affects the words after
/// it.
const FAULTS_PER_BLOCK: usize = 3;

/// Number of bytes at the start of a text in which the leader of the tape, the `%` after it and the first
/// program number are searched for.
pub const LEADER: usize = 1024;

/// The part of the module that reads blocks with errors.
pub const READS_FAULTS: Part = Part::Early;

early! {
    fn reclassify(parser: &Parser, block: &mut Block, after_semicolon: bool) {
        parser.reclassify(block, after_semicolon);
    }

    fn is_sentence(bytes: &[u8]) -> bool {
        begins_as_sentence(bytes)
    }

    fn report_misread(parser: &mut Parser, block: &mut Block, start: u32, misread: &Misread) {
        parser.report_misread(block, start, misread);
    }

    fn report_full_width(parser: &Parser, block: &mut Block, span: Span) {
        parser.report_full_width(block, span);
    }

    fn report_two_signs(parser: &Parser, block: &mut Block, span: Span, negative: bool) {
        parser.report_two_signs(block, span, negative);
    }

    fn report_second_point(parser: &Parser, block: &mut Block, span: Span) {
        parser.report_second_point(block, span);
    }

    fn read_comma_word(parser: &mut Parser, block: &mut Block, word: CommaWord, comma: Span, digits: Span) {
        parser.read_comma_word(block, word, comma, digits);
    }
}

/// The beginning of a word whose number contains a comma.
struct CommaWord {
    address: u8,
    /// Whether a comma precedes the letter, as in `,C2`.
    comma: bool,
    negative: bool,
    /// From its letter on.
    start: Span,
}

/// Whether the part `READS_FAULTS` is loaded; otherwise marks the block as unread.
fn require_fault_part(block: &mut Block) -> bool {
    block.is_unread |= !READS_FAULTS.is_loaded();
    !block.is_unread
}

/// Parses a program block by block.
#[derive(Clone, Debug)]
pub struct Parser<'a> {
    lexer: Lexer<'a>,
    line: u32,
    /// Whether a block with content was read.
    begun: bool,
    /// Whether it started within a text, after a block with content.
    follows_block: bool,
    /// Whether the next block follows a `;` on the same line.
    after_semicolon: bool,
    ended: bool,
    /// Whether the blocks are only examined: the leader is not searched for and safe fixes are not tested,
    /// because both parse text again.
    is_trial: bool,
}

impl<'a> Parser<'a> {
    /// Starts at the head of `text`.
    pub fn new(text: &'a [u8]) -> Self {
        Self::resume(text, Resume::default())
    }

    /// Continues at the position of another parser of the same text.
    pub fn resume(text: &'a [u8], at: Resume) -> Self {
        Self {
            lexer: Lexer::new(text, at.byte as usize),
            line: at.line,
            begun: at.begun,
            follows_block: at.is_inside && !at.begun && has_block_before(text, at.byte),
            after_semicolon: at.after_semicolon,
            ended: at.ended,
            is_trial: false,
        }
    }

    /// Moves to another position of the text.
    pub fn go_to(&mut self, at: Resume) {
        *self = Self::resume(self.lexer.text(), at);
    }

    /// The position of the next block.
    pub fn position(&self) -> Resume {
        Resume {
            byte: self.lexer.position() as u32,
            line: self.line,
            begun: self.begun,
            is_inside: self.follows_block,
            after_semicolon: self.after_semicolon,
            ended: self.ended,
        }
    }

    /// Reads the next block into `block`. Returns false at the end of the program.
    pub fn next_block(&mut self, block: &mut Block) -> bool {
        block.clear();
        if self.ended || self.lexer.peek_byte().is_none() {
            return false;
        }
        let start = self.lexer.position();
        let after_semicolon = self.after_semicolon;
        block.line = self.line;
        let end = self.read(block);
        block.span = Span::new(start, end);
        if !block.faults.is_empty() && require_fault_part(block) {
            reclassify(self, block, after_semicolon);
        }
        if block.kind == BlockKind::Percent && self.begun && !names_program(self.lexer.text(), block.span) {
            self.ended = true;
        }
        self.begun |= !block.is_empty() && block.kind != BlockKind::Percent;
        true
    }

    /// Whether a `%` has ended the program.
    pub fn ended(&self) -> bool {
        self.ended
    }

    /// The next line, if it is a plain one, without consuming it.
    #[inline]
    pub fn plain_line(&self) -> Option<PlainLine> {
        let is_inside = self.begun && !self.ended && !self.after_semicolon;
        PlainLine::read(self.lexer.text(), self.lexer.position()).filter(|_| is_inside)
    }

    /// Consumes a plain line and returns its number, from 0.
    #[inline]
    pub fn take(&mut self, line: &PlainLine) -> u32 {
        self.lexer.seek(line.span.end as usize + 1);
        self.line += 1;
        self.line - 1
    }

    /// Examines a block with errors again: it may be text, or contain plain words.
    fn reclassify(&self, block: &mut Block, after_semicolon: bool) {
        let text = self.lexer.text();
        let may_lead = self.leads(block) && !self.is_trial;
        if may_lead && leader(text).is_some_and(|end| block.span.start < end) {
            return keep_as_comment(block, trimmed(text, block.span));
        }
        if let Some(remark) = marked_remark(text, block) {
            return self.keep_marked_remark(block, remark, after_semicolon);
        }
        if long_comment::continues(text, block.span) {
            return keep_as_comment(block, trimmed(text, block.span));
        }
        for fault in block.faults.iter_mut().filter(|fault| fault.message.is::<said::CommentOpen>()) {
            if let Some((ends, _)) = long_comment::over_lines(text, fault.span.start as usize) {
                *fault = over_lines(text, fault.span, &ends);
                continue;
            }
            // If the hidden text ends with a value (`(face X20`), the bracket may belong before it: an error.
            // With more text after the value (`(STOPS AT M01, IF ON`), it is a remark.
            let hidden = Span { start: fault.span.end, end: block.span.end };
            let groups = PlainWords::of(text, hidden, &[]).groups;
            let last = Span { start: groups.last().map_or(hidden.start, |group| group.end), ..hidden };
            if PlainWords::of(text, last, &[]).has_value {
                fault.severity = Severity::Error;
                fault.fixes.iter_mut().for_each(|fix| fix.safe = false);
            }
        }
        let plain = PlainWords::of(text, block.span, &block.comments);
        let unclear = block.is_broken() || block.words.is_empty();
        let is_text = !plain.has_value && !plain.is_ambiguous;
        // `; 其实N10 …` ("actually N10") is not a block either, but only the author knows what N10 means.
        let own = block.span.of(text);
        let has_sentence =
            !plain.has_value && plain.groups.iter().any(|group| group.of(text).contains(&b' '));
        let is_remark = is_text || has_sentence || begins_in_other_script(own) || begins_as_sentence(own);
        // `;(TURN (LONG CUT))`: it is a comment already, and its inner brackets are reported.
        let is_comment = block.words.is_empty()
            && block.faults.iter().any(|fault| fault.message.is::<said::CommentNested>())
            && block.faults.iter().all(|fault| fault.message.is::<said::CommentNested>());
        if after_semicolon && unclear && !is_comment && is_remark && reads_as_prose(block.span.of(text)) {
            return self.keep_as_remark(block, is_text);
        }
        if self.is_title(block, &plain, after_semicolon) {
            return match after_semicolon {
                true => self.keep_as_remark(block, is_text),
                false => self.report_as_text(block, &plain),
            };
        }
        if block.words.is_empty() && only_marks_outside_brackets(block.span.of(text)) {
            // `(FACE), (F0.3).`: only the punctuation between the comments is wrong, and one message reports
            // it.
            block.faults.truncate(1);
        }
        let prose = block.words.is_empty() || reads_as_prose(block.span.of(text));
        let whole = block.faults.len() > block.words.len().max(1) && prose;
        let only_text = plain.texts > 0 && block.is_broken();
        if plain.has_value || block.span.of(text).contains(&b'(') {
            self.report_plain_words(block, &plain, whole);
        } else if whole && (block.kind == BlockKind::Words || only_text) {
            self.report_as_text(block, &plain);
        }
        for fault in &mut block.faults {
            // `go`, `tool`, `toolO2`: letters that may be text are not certainly digits.
            let at = fault.span.start as usize;
            let is_axis = matches!(text.get(at).map(u8::to_ascii_uppercase), Some(b'X' | b'Z' | b'U' | b'W'));
            let is_letter = |at: usize| text.get(at).is_some_and(u8::is_ascii_alphabetic);
            let may_be_text = !is_axis || plain.texts > 0 || is_letter(fault.span.end as usize);
            let in_run = at > 0 && is_letter(at - 1) && is_letter(at);
            let is_letter_for_digit = fault.message.is::<said::LetterForDigit>();
            // `X–l0O`: its letter may be a digit of the word before.
            let may_go_on = is_letter_for_digit
                && matches!(text.get(at), Some(b'O' | b'o' | b'l'))
                && follows_word(text, block.span.start, at);
            // `WO 8`: its last letter may be the address of the number after it.
            let end = fault.span.end as usize;
            let may_be_address = is_letter_for_digit
                && matches!(text.get(end.wrapping_sub(1)), Some(b'O' | b'o' | b'l'))
                && precedes_number(&text[end..block.span.end as usize]);
            let is_guess = is_letter_for_digit && !self.has_digit(fault.span) && may_be_text;
            if in_run || is_guess || may_go_on || may_be_address {
                fault.fixes.iter_mut().for_each(|fix| fix.safe = false);
            }
        }
        keep_faults(&mut block.faults);
        self.offer_addresses(block);
        if !self.is_trial && self.is_worse_when_fixed(block, after_semicolon) {
            block.faults.iter_mut().flat_map(|fault| &mut fault.fixes).for_each(|fix| fix.safe = false);
        }
    }

    /// Whether a block may precede the program.
    fn leads(&self, block: &Block) -> bool {
        !self.begun && !self.follows_block && (block.span.start as usize) < LEADER
    }

    /// Whether a block with text can only be a remark, although it contains a code: `; G71 roughing` at the
    /// head of a line, or such a line before the first program number. A block with a position is not a
    /// remark.
    fn is_title(&self, block: &Block, plain: &PlainWords, after_semicolon: bool) -> bool {
        let text = self.lexer.text();
        let names_place = block.words.iter().any(|word| b"XZUW".contains(&word.address));
        let before = &text[..block.span.start as usize];
        let mut before = before.iter().rev().take_while(|byte| !matches!(byte, b'\n' | b'\r'));
        let is_remark = match after_semicolon {
            true => before.all(|&byte| byte == b';' || is_blank(byte)),
            false => self.leads(block) && has_program_number(&text[..text.len().min(LEADER)]),
        };
        let is_statement = block.kind != BlockKind::Words || block.program.is_some();
        is_remark && !plain.groups.is_empty() && !plain.is_ambiguous && !names_place && !is_statement
    }

    /// Whether applying the safe fixes would give the block more errors; then they are not safe.
    fn is_worse_when_fixed(&self, block: &Block, after_semicolon: bool) -> bool {
        let fixes = block.faults.iter().filter_map(|fault| fault.fixes.iter().find(|fix| fix.safe));
        let mut edits: Vec<&Edit> = fixes.flat_map(|fix| &fix.edits).collect();
        if edits.is_empty() {
            return false;
        }
        order::by_key(&mut edits, |edit| edit.span.start);
        let (text, mut fixed, mut at) = (self.lexer.text(), Vec::new(), block.span.start);
        for edit in edits.iter().filter(|edit| block.span.contains(edit.span)) {
            if edit.span.start >= at {
                fixed.extend_from_slice(Span { start: at, end: edit.span.start }.of(text));
                fixed.extend_from_slice(edit.text.as_bytes());
                at = edit.span.end;
            }
        }
        fixed.extend_from_slice(Span { start: at, end: block.span.end }.of(text));
        // Whether a percent sign ends the program depends on the text after it.
        const AFTER: usize = 256;
        let (end, rest) = (fixed.len(), &text[block.span.end as usize..]);
        fixed.extend_from_slice(&rest[..rest.len().min(AFTER)]);
        let begun = self.begun || self.follows_block;
        let here = Resume { begun, after_semicolon, ..Resume::default() };
        let mut trial = Parser { is_trial: true, ..Parser::resume(&fixed, here) };
        let errors = |block: &Block| block.faults.iter().filter(|fault| fault.is_error()).count();
        let (mut read, mut remaining_errors) = (Block::default(), 0);
        while (trial.position().byte as usize) < end && trial.next_block(&mut read) {
            remaining_errors += errors(&read);
        }
        remaining_errors > errors(block)
    }

    /// Reports a block without a value in one message. Putting all of it in brackets is a safe fix if its
    /// letters can only be text.
    fn report_as_text(&self, block: &mut Block, plain: &PlainWords) {
        let text = self.lexer.text();
        let span = trimmed(text, block.span);
        let quote = short_quote(text, span);
        block.words.clear();
        block.kind = BlockKind::Words;
        let cannot_be_words = is_decoration(span.of(text)) && !plain.is_ambiguous;
        let harmless = block.faults.iter().all(|fault| !fault.is_error()) || cannot_be_words;
        let severity = if harmless { Severity::Warning } else { Severity::Error };
        block.faults.clear();
        let diagnostic = Diagnostic::new(said::PlainText { text: quote }, span).with_severity(severity);
        let is_sure = !plain.is_ambiguous && (plain.texts > 0 || cannot_be_words);
        block.fault(in_brackets(text, diagnostic, is_sure));
    }

    /// Reports plain words. The rest is parsed without them: if it has no error, putting the words in
    /// brackets is a safe fix. A block of text that contains brackets gets one message, unless the rest has
    /// no error.
    fn report_plain_words(&self, block: &mut Block, plain: &PlainWords, whole: bool) {
        let is_text = !plain.has_value && whole;
        if plain.groups.is_empty() {
            return if is_text {
                self.report_as_text(block, plain)
            };
        }
        let mut rest = self.read_without(block, &plain.groups);
        let is_readable = rest.kind == BlockKind::Words && !rest.is_broken() && !plain.is_ambiguous;
        if is_text && !is_readable {
            return self.report_as_text(block, plain);
        }
        let text = self.lexer.text();
        for &group in &plain.groups {
            let quote = short_quote(text, group);
            // A warning: text that cannot be words does not stop the block.
            let diagnostic = match is_decoration(group.of(text)) {
                true => Diagnostic::new(said::NotUnderstood { text: quote }, group)
                    .with_severity(Severity::Warning),
                false => Diagnostic::new(said::PlainWords { text: quote }, group),
            };
            rest.fault(in_brackets(text, diagnostic, is_readable));
        }
        sort_by_place(&mut rest.faults);
        *block = rest;
    }

    /// Parses a block again, with blanks in place of some of its text.
    fn read_without(&self, block: &Block, left_out: &[Span]) -> Block {
        let start = block.span.start;
        let mut text = block.span.of(self.lexer.text()).to_vec();
        for span in left_out {
            text[(span.start - start) as usize..(span.end - start) as usize].fill(b' ');
        }
        let mut parser =
            Parser { lexer: Lexer::new(&text, 0), line: block.line, begun: self.begun, ..Parser::new(&text) };
        let mut rest = Block::default();
        parser.read(&mut rest);
        rest.shift(&Shift { from: 0, bytes: i64::from(start), lines: 0 });
        (rest.span, rest.line) = (block.span, block.line);
        rest
    }

    /// Adds fixes that insert a candidate address before a number without one. For a number with a blank, one
    /// more fix joins its digits.
    fn offer_addresses(&self, block: &mut Block) {
        let Block { faults, words, .. } = block;
        for fault in faults {
            let mut joined = None;
            let (number, at) = if fault.message.is::<said::AddressMissing>() {
                (short_quote(self.lexer.text(), fault.span), fault.span.start)
            } else if fault.message.is::<said::BlankInNumber>() {
                // `X100 50`: the letter of the second number may be lost.
                let written = fault.span.quote(self.lexer.text());
                let Some(blank) = written.find([' ', '\t']) else { continue };
                let second = written.get(blank..).unwrap_or_default().trim_start();
                joined = Some(Fix::write(fault.span, without_blanks(&written)));
                (second.to_owned(), fault.span.end - second.len() as u32)
            } else {
                continue;
            };
            let place = Span { start: at, end: at };
            let letters = lost_letter::candidates(&number, place, words);
            fault.fixes.extend(letters.into_iter().map(|letter| Fix::insert(at, letter.to_string())));
            fault.fixes.extend(joined);
        }
    }

    /// Reads the rest of the block and its end. Returns the byte where its text ends.
    fn read(&mut self, block: &mut Block) -> usize {
        loop {
            // Fast paths; `token` gives the same result.
            match self.lexer.peek_byte() {
                Some(b' ') => {
                    self.lexer.seek(self.lexer.position() + 1);
                    continue;
                }
                Some(b'\n') => {
                    let at = self.lexer.position();
                    self.lexer.seek(at + 1);
                    self.line += 1;
                    self.after_semicolon = false;
                    return at;
                }
                Some(b'A'..=b'Z' | b'a'..=b'z') => {
                    if let Some(plain) = self.lexer.plain_word() {
                        self.store(block, plain.letter, false, plain.negative, plain.number, plain.span);
                        continue;
                    }
                }
                _ => {}
            }
            if let Some(end) = self.token(block) {
                return end;
            }
        }
    }

    /// Reads one token and the tokens that belong to it. Returns the end of the block's text if the token
    /// ends the block.
    #[inline(never)]
    fn token(&mut self, block: &mut Block) -> Option<usize> {
        // Checked before the lexer joins consecutive full-width characters to one token: otherwise one token
        // would contain several words.
        const FULL_WIDTH: u8 = 0xEF;
        if self.lexer.peek_byte() == Some(FULL_WIDTH)
            && !block.is_full()
            && self.misread_word(block, self.lexer.position() as u32)
        {
            return None;
        }
        let Some(token) = self.lexer.next_token() else { return Some(self.lexer.position()) };
        match token.kind {
            TokenKind::Blank => {}
            TokenKind::LineEnd => {
                self.line += 1;
                self.after_semicolon = false;
                return Some(token.span.start as usize);
            }
            TokenKind::Semicolon => {
                self.after_semicolon = true;
                if token.span.len() > 1 {
                    self.full_width(block, token.span);
                }
                return Some(token.span.start as usize);
            }
            TokenKind::Comment => {
                block.comment(token.span);
                if !token.span.of(self.lexer.text())[0].is_ascii() {
                    self.full_width(block, token.span);
                }
            }
            TokenKind::NestedComment => {
                block.comment(token.span);
                // `(OD (80 DEG)`: the comment ends at the first `)`, as on a control.
                let text = token.span.of(self.lexer.text());
                if text[..text.len() - 1].contains(&b')') {
                    block.fault(Diagnostic::new(said::CommentNested, token.span));
                }
            }
            _ if block.is_full() => {}
            TokenKind::Letter(letter) => self.letter(block, letter, token.span, None),
            TokenKind::OpenComment => {
                block.comment(token.span);
                let end = Span { start: token.span.end, end: token.span.end };
                let fix = Fix::replace(Repair::CloseComment, end, ")");
                let opening = Span { start: token.span.start, end: token.span.start + 1 };
                block.fault(Diagnostic::new(said::CommentOpen, opening).with(fix));
            }
            TokenKind::Percent => self.percent(block, token.span),
            TokenKind::Slash => self.slash(block),
            TokenKind::Colon => self.letter(block, b'O', token.span, None),
            TokenKind::Comma => self.comma(block, token.span),
            TokenKind::Macro(b'[')
                if block.words.is_empty() && block.faults.is_empty() && self.letter_follows() =>
            {
                // `[BILLET X62 Z70`: the stock comment of CNC simulators used in schools. No control reads
                // it.
                self.skip_line();
                block.comment(Span { start: token.span.start, end: self.lexer.position() as u32 });
            }
            TokenKind::Macro(b'#') => self.macro_statement(block, token.span),
            TokenKind::Number(number) => self.lone_number(block, number, token.span),
            TokenKind::Unknown if self.program_name(block, token.span.start as usize, token.span.start) => {}
            TokenKind::Unknown if self.misread_word(block, token.span.start) => {}
            TokenKind::Minus | TokenKind::PrintedMinus | TokenKind::Plus if self.digit_follows() => {
                if let Some(TokenKind::Number(number)) = self.lexer.next_token().map(|next| next.kind) {
                    let span = Span { start: token.span.start, end: self.lexer.position() as u32 };
                    self.lone_number(block, number, span);
                }
            }
            TokenKind::Macro(_)
            | TokenKind::Plus
            | TokenKind::Minus
            | TokenKind::PrintedMinus
            | TokenKind::Unknown => {
                let quote = short_quote(self.lexer.text(), token.span);
                let harmless = is_decoration(token.span.of(self.lexer.text()));
                let severity = if harmless { Severity::Warning } else { Severity::Error };
                let message = said::NotUnderstood { text: quote };
                block.fault(Diagnostic::new(message, token.span).with_severity(severity));
            }
        }
        None
    }

    /// Reads the word of the letter that was consumed.
    fn letter(&mut self, block: &mut Block, letter: u8, first: Span, comma: Option<Span>) {
        if comma.is_none() && self.begins_keyword(letter, first) && !self.begins_remark(block, first) {
            return self.macro_statement(block, first);
        }
        if self.begins_function() {
            let end = self.skip_function(first);
            block.has_expressions = true;
            let span = Span { start: comma.unwrap_or(first).start, end };
            block.word(Word { address: letter, comma: comma.is_some(), value: Value::Expression, span });
            return;
        }
        if letter == b'O' && comma.is_none() && self.program_name(block, self.lexer.position(), first.start) {
            return;
        }
        let mut negative = false;
        let mut signs = 0;
        let mut after = self.lexer.position();
        let start = comma.unwrap_or(first);
        if comma.is_none() && self.misread_word(block, first.start) {
            return;
        }
        loop {
            let token = self.lexer.next_token();
            match token.map(|token| token.kind) {
                Some(TokenKind::Number(number)) => {
                    let span = start.to(token.map_or(first, |token| token.span));
                    if signs > 1 && require_fault_part(block) {
                        report_two_signs(self, block, span, negative);
                    }
                    return self.word(block, letter, comma.is_some(), negative, number, span);
                }
                Some(TokenKind::Blank) => {}
                Some(TokenKind::Plus) => signs += 1,
                Some(TokenKind::Minus) => {
                    signs += 1;
                    negative = true;
                }
                Some(TokenKind::PrintedMinus) => {
                    signs += 1;
                    negative = true;
                    let span = token.map_or(first, |token| token.span);
                    let message = said::PrintedMinus;
                    let fix = Fix::replace(Repair::Minus, span, "-");
                    block.fault(Diagnostic::new(message, span).with(fix));
                }
                Some(TokenKind::Macro(b'#' | b'[')) => {
                    let end = self.skip_expression(token.map_or(first, |token| token.span));
                    let span = Span { start: start.start, end };
                    block.has_expressions = true;
                    block.word(Word {
                        address: letter,
                        comma: comma.is_some(),
                        value: Value::Expression,
                        span,
                    });
                    return;
                }
                Some(TokenKind::Comma) if self.digit_follows() => {
                    let comma_span = token.map_or(first, |token| token.span);
                    let digits = self.lexer.next_token().map_or(comma_span, |token| token.span);
                    let word = CommaWord { address: letter, comma: comma.is_some(), negative, start };
                    return self.comma_word(block, word, comma_span, digits);
                }
                _ => break,
            }
            after = self.lexer.position();
        }
        self.lexer.seek(after);
        let message = said::NumberMissing { address: letter as char };
        block.fault(Diagnostic::new(message, start));
    }

    /// Reads a program name whose `<` is at byte `at`. `start` is the byte of the O or `:` before it, or `at`
    /// if there is none. At the head of a block it is the name of this program; after the code of a call it
    /// is the called program. Returns false if there is no name, or if a name is not allowed here.
    #[cold]
    fn program_name(&mut self, block: &mut Block, at: usize, start: u32) -> bool {
        let Some((number, end)) = program_name::read(self.lexer.text(), at) else { return false };
        let span = Span { start, end: end as u32 };
        let is_head = block.words.is_empty() && block.sequence.is_none() && block.faults.is_empty();
        let has_no_letter = start as usize == at;
        match block.program {
            None if is_head => block.program = Some((number, span)),
            Some(_) if is_head && block.second_name.is_none() && has_no_letter => {
                block.second_name = Some((number, span));
            }
            _ if block.words.iter().any(calls_program) && has_no_letter => {
                let number = Number { mantissa: u64::from(number), digits: MAX_DIGITS, ..Number::default() };
                block.word(Word {
                    address: b'P',
                    comma: false,
                    value: Value::Number { number, negative: false },
                    span,
                });
            }
            _ => return false,
        }
        self.lexer.seek(end);
        true
    }

    /// Stores a complete word, or reports the error in its number.
    fn word(
        &mut self,
        block: &mut Block,
        letter: u8,
        comma: bool,
        negative: bool,
        number: Number,
        span: Span,
    ) {
        let (mut number, mut span) = (number, span);
        // In `X1 0` the blank is in the number; in `N10 20` the second number has lost its letter.
        if letter != b'N' && self.blank_then_digit() {
            (number, span) = self.join_digits(block, span);
        }
        if number.points > 1 {
            if require_fault_part(block) {
                report_second_point(self, block, span);
            }
            return;
        }
        if number.digits == 0 && number.mantissa == 0 && !self.has_digit(span) {
            let message = said::NumberMissing { address: letter as char };
            block.fault(Diagnostic::new(message, span));
            return;
        }
        if number.digits > MAX_DIGITS {
            let quote = short_quote(self.lexer.text(), span);
            block.fault(Diagnostic::new(said::TooManyDigits { word: quote }, span));
            return;
        }
        self.store(block, letter, comma, negative, number, span);
    }

    /// Stores a correct word; O and N at the head of a block have their own fields.
    #[inline]
    fn store(
        &mut self,
        block: &mut Block,
        letter: u8,
        comma: bool,
        negative: bool,
        number: Number,
        span: Span,
    ) {
        let at_head = block.words.is_empty() && !comma && !negative && number.points == 0;
        match letter {
            // `G:00` is not a program number.
            b'O' if at_head
                && block.program.is_none()
                && block.sequence.is_none()
                && block.faults.is_empty() =>
            {
                block.program = Some((number.mantissa as u32, span));
            }
            b'N' if at_head && block.sequence.is_none() => block.sequence = Some(number.mantissa as u32),
            address => {
                block.word(Word { address, comma, value: Value::Number { number, negative }, span });
            }
        }
    }

    fn report_second_point(&self, block: &mut Block, span: Span) {
        let quote = span.quote(self.lexer.text());
        let fix = without_second_point(&quote);
        let diagnostic = Diagnostic::new(said::SecondPoint { word: quote }, span);
        block.fault(match fix {
            Some(text) => diagnostic
                .with(Fix::replace(Repair::Write { text: text.clone() }, span, &text).needs_confirmation()),
            None => diagnostic,
        });
    }

    /// Joins digits that blanks separate: a control ignores the blanks.
    fn join_digits(&mut self, block: &mut Block, span: Span) -> (Number, Span) {
        let mut end = span.end;
        while self.blank_then_digit() {
            let _blank = self.lexer.next_token();
            if let Some(token) = self.lexer.next_token() {
                end = token.span.end;
            }
        }
        let whole = Span { start: span.start, end };
        let written = whole.quote(self.lexer.text());
        let joined = without_blanks(&written);
        block.fault(Diagnostic::new(said::BlankInNumber { written, joined }, whole));
        (Number::read(whole.of(self.lexer.text())), whole)
    }

    /// Reads a number without an address. `00006`, the first word of a program, is a misread `O0006`.
    fn lone_number(&mut self, block: &mut Block, number: Number, span: Span) {
        let text = span.of(self.lexer.text());
        let at_head = !self.begun
            && !self.follows_block
            && block.words.is_empty()
            && block.sequence.is_none()
            && block.program.is_none();
        // Four digits, such as `0101`, may also be a tool.
        let may_be_program =
            |text: &[u8]| text.len() >= 5 && text[0] == b'0' && Number::read(&text[1..]).digits <= MAX_DIGITS;
        if at_head && number.points == 0 && number.mantissa > 0 && may_be_program(text) {
            let first = Span { start: span.start, end: span.start + 1 };
            let message = said::ZeroForO { number: span.quote(self.lexer.text()) };
            let fix = Fix::replace(Repair::LetterO, first, "O");
            block.fault(Diagnostic::new(message, first).with(fix));
            block.program = Some((number.mantissa as u32, span));
            return;
        }
        let quote = short_quote(self.lexer.text(), span);
        if !self.has_digit(span) {
            // A full stop after a remark.
            let message = said::NotUnderstood { text: quote };
            block.fault(Diagnostic::new(message, span).with_severity(Severity::Warning));
            return;
        }
        block.fault(Diagnostic::new(said::AddressMissing { number: quote }, span));
    }

    /// `Z,15`, `Z20,5`: a comma instead of the decimal point. The word is read as intended, so that its modal
    /// effect applies to the next blocks.
    #[cold]
    fn comma_word(&mut self, block: &mut Block, word: CommaWord, comma: Span, digits: Span) {
        if require_fault_part(block) {
            read_comma_word(self, block, word, comma, digits);
        }
    }

    fn read_comma_word(&mut self, block: &mut Block, word: CommaWord, comma: Span, digits: Span) {
        // `Z1,2,3`: a single word that cannot be read.
        let (mut end, mut goes_on) = (digits, false);
        while self.comma_and_number_follow() {
            goes_on = true;
            for _ in 0..2 {
                end = self.lexer.next_token().map_or(end, |token| token.span);
            }
        }
        let span = word.start.to(end);
        let written = span.quote(self.lexer.text());
        let number = written.trim_start_matches([',', '，']).replace([',', '，'], ".");
        let number = number.trim_start_matches(|sign: char| sign != '.' && !sign.is_ascii_digit());
        let number = Number::read(without_blanks(number).as_bytes());
        let diagnostic = Diagnostic::new(said::CommaForPoint { word: written.clone() }, span);
        if number.points > 1 || number.digits > MAX_DIGITS || goes_on {
            return block.fault(diagnostic);
        }
        let point = Fix::replace(Repair::DecimalPoint, comma, ".");
        if may_be_thousands(word.address, &written) {
            let whole = Fix::write(span, written.replace([',', '，'], ""));
            return block.fault(diagnostic.with(Fix { safe: false, ..point }).with(whole));
        }
        // `X40 ,2` may be `X40 ,C2` without its letter.
        let before = self.lexer.text()[..comma.start as usize].last();
        if before.is_some_and(u8::is_ascii_whitespace) {
            return block.fault(diagnostic.with(Fix { safe: false, ..point }));
        }
        block.fault(diagnostic.with(point));
        self.store(block, word.address, word.comma, word.negative, number, span);
    }

    /// Whether a comma is next, directly followed by a digit, a point or another comma.
    fn comma_and_number_follow(&self) -> bool {
        let rest = &self.lexer.text()[self.lexer.position()..];
        let after = rest.strip_prefix(b",").or_else(|| rest.strip_prefix("，".as_bytes()));
        after.is_some_and(|after| {
            matches!(after, [b'0'..=b'9' | b'.' | b',', ..]) || after.starts_with("，".as_bytes())
        })
    }

    /// `；`, `（外圆）`: a full-width character that a control does not know, with its ASCII form as the fix.
    #[cold]
    fn full_width(&self, block: &mut Block, span: Span) {
        if require_fault_part(block) {
            report_full_width(self, block, span);
        }
    }

    /// Reports a number with several signs. The fix keeps a minus if there is one.
    fn report_two_signs(&self, block: &mut Block, span: Span, negative: bool) {
        let word = span.quote(self.lexer.text());
        let sign_at = word.find(['-', '+', '–', '−', '－']).unwrap_or(1);
        let digits = word.find(|letter: char| letter.is_ascii_digit() || letter == '.').unwrap_or(word.len());
        let sign = if negative { "-" } else { "" };
        let fix = Fix::write(span, format!("{}{sign}{}", word[..sign_at].trim_end(), &word[digits..]));
        block.fault(Diagnostic::new(said::TwoSigns { word }, span).with(fix));
    }

    fn report_full_width(&self, block: &mut Block, span: Span) {
        // One mistake, one message; the fix of the first reveals the next.
        if block.faults.iter().any(|fault| fault.message.is::<said::FullWidth>()) {
            return;
        }
        let text = self.lexer.text();
        let word = span.quote(text);
        let plain: String = word
            .char_indices()
            .map(|(at, letter)| match letter {
                '（' if at == 0 => '(',
                '）' if at + letter.len_utf8() == word.len() => ')',
                '；' => ';',
                letter => letter,
            })
            .collect();
        let title = Repair::Write { text: plain.clone() };
        let fix = Fix::replace(title, span, &plain);
        let short = Span::new(0, plain.len());
        let (word, plain) = (short_quote(text, span), short_quote(plain.as_bytes(), short));
        block.fault(Diagnostic::new(said::FullWidth { word, plain }, span).with(fix));
    }

    /// `GO1`, `X2O0`, `Ｘ５０`: reads a word with letters instead of digits, or with full-width characters, as
    /// intended, so that its modal effect applies to the next blocks. Returns false and consumes nothing if
    /// the word at byte `start` is not such a word.
    #[inline]
    fn misread_word(&mut self, block: &mut Block, start: u32) -> bool {
        let text = self.lexer.text();
        let Some(misread) = misread::read(text, start as usize) else { return false };
        self.lexer.seek(start as usize + misread.len);
        if require_fault_part(block) {
            report_misread(self, block, start, &misread);
        }
        true
    }

    /// Reports a misread word, and stores it as intended.
    fn report_misread(&mut self, block: &mut Block, start: u32, misread: &Misread) {
        let text = self.lexer.text();
        let span = Span { start, end: start + misread.len as u32 };
        let word = span.quote(text);
        let (plain, address) = (&misread.plain, misread.address);
        let message: Message = match misread.letter {
            Some(letter) => {
                let digit = if letter.eq_ignore_ascii_case(&b'O') { "0" } else { "1" };
                said::LetterForDigit { word, digit }.into()
            }
            None => said::FullWidth { word, plain: plain.clone() }.into(),
        };
        let fix = Fix::replace(Repair::Write { text: plain.clone() }, span, plain);
        block.fault(Diagnostic::new(message, span).with(fix));
        let value = plain.get(1..).unwrap_or_default();
        let digits = value.trim_start_matches(['-', '+']);
        let negative = value.starts_with('-');
        let number = Number::read(digits.as_bytes());
        if number.points <= 1 && number.digits <= MAX_DIGITS {
            self.store(block, address, false, negative, number, span);
        } else if misread.letter.is_none() {
            // Full-width characters are a warning; a word that is too long is the same error as in ASCII.
            let word = span.quote(self.lexer.text());
            block.fault(match number.points {
                0 | 1 => Diagnostic::new(said::TooManyDigits { word }, span),
                _ => Diagnostic::new(said::SecondPoint { word }, span),
            });
        }
    }

    fn comma(&mut self, block: &mut Block, comma: Span) {
        let after = self.lexer.position();
        let mut token = self.lexer.next_token();
        if token.is_some_and(|token| token.kind == TokenKind::Blank) {
            token = self.lexer.next_token();
        }
        match token.map(|token| (token.kind, token.span)) {
            Some((TokenKind::Letter(letter), span)) => self.letter(block, letter, span, Some(comma)),
            Some((TokenKind::Number(_), span)) if self.ends_at(block.words.last(), comma) => {
                // `Z20,5`: the word was stored at its comma, and this number belongs to it.
                let Some(taken) = block.words.pop() else { return };
                let Word { address, comma: with_comma, value, span: start } = taken;
                let negative = matches!(value, Value::Number { negative: true, .. });
                let word = CommaWord { address, comma: with_comma, negative, start };
                self.comma_word(block, word, comma, span);
            }
            _ => {
                self.lexer.seek(after);
                let message = said::NotUnderstood { text: ",".into() };
                block.fault(Diagnostic::new(message, comma).with_severity(Severity::Warning));
            }
        }
    }

    /// Whether there are only blanks between a word and a place.
    fn ends_at(&self, word: Option<&Word>, place: Span) -> bool {
        let between = |word: &Word| Span { start: word.span.end, end: place.start }.of(self.lexer.text());
        word.is_some_and(|word| between(word).iter().all(|&byte| is_blank(byte)))
    }

    /// Reads a `%`. At the head of a block it is a separate block, after a program it ends the program, and
    /// elsewhere it is an error.
    fn percent(&mut self, block: &mut Block, span: Span) {
        if block.words.is_empty() && block.program.is_none() && block.sequence.is_none() {
            block.kind = BlockKind::Percent;
            // The rest of the line is not read.
            self.skip_line();
        } else if self.ends_tape() {
            self.skip_line();
            self.ended = true;
        } else {
            block.fault(Diagnostic::new(said::NotUnderstood { text: "%".into() }, span));
        }
    }

    /// Whether only another program, or its `%`, follows a percent sign: `M30%` as the last line of a file.
    fn ends_tape(&self) -> bool {
        const SEARCHED: usize = 200;
        let after = &self.lexer.text()[self.lexer.position()..];
        let line = line_end(after, 0);
        let next = after.iter().take(SEARCHED).find(|byte| !is_between_blocks(**byte));
        let alone = after[..line].iter().all(|byte| is_between_blocks(*byte));
        alone && next.is_none_or(|byte| matches!(byte, b'%' | b'O' | b'o' | b':'))
    }

    /// Reads the level of a `/`, which is 1 if it has none. After a word, the `/` applies to the words that
    /// follow.
    fn slash(&mut self, block: &mut Block) {
        let mut level = 1;
        if let Some(byte @ b'1'..=b'9') = self.lexer.peek_byte() {
            level = byte - b'0';
            let at = self.lexer.position();
            self.lexer.seek(at + 1);
        }
        if block.words.is_empty() {
            block.delete.get_or_insert(level);
        } else {
            block.optional.get_or_insert((block.words.len(), level));
        }
    }

    /// Whether a macro keyword begins at the letter that was consumed.
    #[inline]
    fn begins_keyword(&self, letter: u8, first: Span) -> bool {
        let keyword: &[u8] = match letter {
            b'I' => b"IF",
            b'W' => b"WHILE",
            b'G' => b"GOTO",
            b'D' => b"DO",
            b'E' => b"END",
            b'T' => b"THEN",
            b'P' if self.is_at(first, b"PCLOS") => return true,
            b'P' => b"POPEN",
            b'B' => b"BPRNT",
            b'S' => b"SETVN",
            _ => return false,
        };
        if letter == b'D' && self.is_at(first, b"DPRNT") {
            return true;
        }
        self.is_at(first, keyword)
    }

    /// Whether the keyword at the head of a block after `;` begins a remark: `; end of program`.
    fn begins_remark(&self, block: &mut Block, first: Span) -> bool {
        // Once for each block: the search continues to its end.
        let is_head = block.is_empty() && block.faults.is_empty() && !block.is_unread;
        if !self.after_semicolon || !is_head {
            return false;
        }
        if !READS_FAULTS.is_loaded() {
            block.is_unread = true;
            return false;
        }
        let rest = &self.lexer.text()[first.start as usize..];
        // Includes the `;` that ends the block: a lone keyword before it is not a remark.
        let end = memchr::memchr3(b';', b'\n', b'\r', rest)
            .map_or(rest.len(), |end| end + usize::from(rest[end] == b';'));
        is_sentence(&rest[..end])
    }

    /// Whether a keyword begins at a place.
    fn is_at(&self, first: Span, keyword: &[u8]) -> bool {
        let rest = &self.lexer.text()[first.start as usize..];
        rest.len() >= keyword.len() && rest[..keyword.len()].eq_ignore_ascii_case(keyword)
    }

    /// Whether the value of the address that was consumed begins with a function: `ROUND[`, `-SIN[`.
    #[inline]
    fn begins_function(&self) -> bool {
        let rest = &self.lexer.text()[self.lexer.position()..];
        let skipped = rest.iter().take_while(|byte| matches!(byte, b' ' | b'+' | b'-')).count();
        let rest = &rest[skipped..];
        let name = rest.iter().take(6).take_while(|byte| byte.is_ascii_alphabetic()).count();
        (2..=5).contains(&name) && rest.get(name) == Some(&b'[')
    }

    /// Skips the function in the value of an address; returns its end.
    fn skip_function(&mut self, first: Span) -> u32 {
        while let Some(byte) = self.lexer.peek_byte()
            && byte != b'['
        {
            self.lexer.seek(self.lexer.position() + 1);
        }
        match self.lexer.next_token() {
            Some(bracket) => self.skip_expression(bracket.span),
            None => first.end,
        }
    }

    /// Reads a macro statement, whose first token was consumed, up to the end of the block.
    fn macro_statement(&mut self, block: &mut Block, first: Span) {
        block.kind = BlockKind::Macro;
        block.statement = first.start;
        block.statement_end = first.end;
        while let Some(byte) = self.lexer.peek_byte() {
            if matches!(byte, b'\n' | b'\r' | b';') {
                break;
            }
            let Some(token) = self.lexer.next_token() else { break };
            match token.kind {
                TokenKind::Comment | TokenKind::NestedComment | TokenKind::OpenComment => {
                    block.comment(token.span);
                }
                TokenKind::Semicolon => {
                    self.lexer.seek(token.span.start as usize);
                    break;
                }
                TokenKind::Blank => {}
                _ => block.statement_end = token.span.end,
            }
        }
    }

    /// Skips a macro expression whose first token was consumed; returns its end.
    fn skip_expression(&mut self, first: Span) -> u32 {
        let mut depth = u32::from(first.of(self.lexer.text()) == b"[");
        let mut end = first.end;
        loop {
            let after = self.lexer.position();
            let Some(token) = self.lexer.next_token() else { return end };
            match token.kind {
                TokenKind::LineEnd
                | TokenKind::Semicolon
                | TokenKind::Comment
                | TokenKind::NestedComment
                | TokenKind::OpenComment => {
                    self.lexer.seek(after);
                    return end;
                }
                TokenKind::Macro(b'[') => depth += 1,
                TokenKind::Macro(b']') => depth = depth.saturating_sub(1),
                TokenKind::Letter(_) if depth == 0 => {
                    self.lexer.seek(after);
                    return end;
                }
                TokenKind::Blank => continue,
                _ => {}
            }
            end = token.span.end;
        }
    }

    /// Turns text after a `;` that does not read as words into a remark.
    fn keep_as_remark(&self, block: &mut Block, is_sure: bool) {
        let text = self.lexer.text();
        let remark = trimmed(text, block.span);
        keep_as_comment(block, remark);
        let diagnostic =
            Diagnostic::new(said::TextAfterSemicolon { text: short_quote(text, remark) }, remark);
        block.fault(in_brackets(text, diagnostic, is_sure));
    }

    /// Parses a block without the remark after its `//` or arrow.
    fn keep_marked_remark(&self, block: &mut Block, remark: Span, after_semicolon: bool) {
        let text = self.lexer.text();
        let Span { start: byte, .. } = block.span;
        let begun = self.begun || self.follows_block;
        let here = Resume { byte, line: block.line, begun, after_semicolon, ..Resume::default() };
        let mut own =
            Parser { is_trial: self.is_trial, ..Parser::resume(&text[..remark.start as usize], here) };
        let mut rest = Block::default();
        own.next_block(&mut rest);
        (rest.span, rest.line) = (block.span, block.line);
        let diagnostic = Diagnostic::new(said::TextAfterSlashes { text: short_quote(text, remark) }, remark);
        let plain = PlainWords::of(text, remark, &[]);
        let is_sure = !plain.has_value && !plain.is_ambiguous;
        rest.comment(remark);
        rest.fault(in_brackets_without(&MARKS, text, diagnostic, is_sure));
        *block = rest;
    }

    /// Moves to the end of the line.
    fn skip_line(&mut self) {
        while !matches!(self.lexer.peek_byte(), None | Some(b'\n' | b'\r')) {
            self.lexer.seek(self.lexer.position() + 1);
        }
    }

    fn letter_follows(&self) -> bool {
        self.lexer.peek_byte().is_some_and(|byte| byte.is_ascii_alphabetic())
    }

    fn digit_follows(&self) -> bool {
        matches!(self.lexer.peek_byte(), Some(b'0'..=b'9'))
    }

    #[inline]
    fn blank_then_digit(&self) -> bool {
        if !matches!(self.lexer.peek_byte(), Some(b' ' | b'\t')) {
            return false;
        }
        let rest = &self.lexer.text()[self.lexer.position()..];
        let next = rest.iter().find(|byte| !matches!(byte, b' ' | b'\t'));
        matches!(next, Some(b'0'..=b'9' | b'.'))
    }

    fn has_digit(&self, span: Span) -> bool {
        span.of(self.lexer.text()).iter().any(u8::is_ascii_digit)
    }
}

/// The position of a parser, from which it can continue later.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Resume {
    /// Next byte.
    pub byte: u32,
    /// Its line, from 0.
    pub line: u32,
    begun: bool,
    is_inside: bool,
    after_semicolon: bool,
    ended: bool,
}

impl Resume {
    /// The first byte of a line within a text. A parser that starts there reads the blocks before it only to tell
    /// whether there are any.
    pub fn inside(byte: u32, line: u32) -> Self {
        Self { byte, line, is_inside: true, ..Self::default() }
    }

    /// The same position after a change of the text.
    pub fn shifted(mut self, shift: &Shift) -> Self {
        (self.byte, self.line) = (shift.byte(self.byte), shift.line(self.line, self.byte));
        self
    }

    /// Whether nothing of the line was read.
    pub fn begins_line(&self) -> bool {
        !self.after_semicolon
    }
}

/// Whether a block with content precedes a byte.
fn has_block_before(text: &[u8], byte: u32) -> bool {
    if byte as usize >= LEADER {
        return true;
    }
    let mut parser = Parser::new(text);
    let mut block = Block::default();
    while !parser.begun && parser.position().byte < byte && parser.next_block(&mut block) {}
    parser.begun
}

/// Start of the first `%` of a text, if the text before it is the leader of the tape, which a control skips
/// (B-64484EN, program components). Only text before a program counts as a leader: a program with mistakes
/// and a single `%` at its end is parsed.
fn leader(text: &[u8]) -> Option<u32> {
    let head = &text[..text.len().min(LEADER)];
    let sign = head.iter().position(|&byte| byte == b'%')?;
    let begins_line =
        head[..sign].iter().rev().find(|&&byte| !is_blank(byte)).is_some_and(|&byte| is_between_blocks(byte));
    let precedes_program = head[sign..].iter().any(|&byte| byte != b'%' && !is_between_blocks(byte));
    if !begins_line || !precedes_program {
        return None;
    }
    let is_text =
        |block: &Block| block.is_broken() && (block.words.is_empty() || reads_as_prose(block.span.of(text)));
    let leads = |block: &Block| block.program.is_none() && (block.is_empty() || is_text(block));
    all_blocks(&text[..sign], leads).then_some(sign as u32)
}

/// Whether one of the lines begins with a program number.
fn has_program_number(head: &[u8]) -> bool {
    let is_number = |line: &[u8]| matches!(line.trim_ascii_start(), [b'O' | b'o' | b':', b'0'..=b'9', ..]);
    head.split(|byte| matches!(byte, b'\n' | b'\r')).any(is_number)
}

/// Whether the first `%` of a text follows a lone program number. A control skips the number and runs the
/// blocks after `%`.
fn names_program(text: &[u8], sign: Span) -> bool {
    let before = &text[..sign.start as usize];
    if before.len() > LEADER || before.contains(&b'%') {
        return false;
    }
    all_blocks(before, |block| {
        block.words.is_empty() && block.faults.is_empty() && block.kind == BlockKind::Words
    })
}

/// Whether a predicate holds for all blocks of a text, parsed as a trial.
fn all_blocks(text: &[u8], holds: impl Fn(&Block) -> bool) -> bool {
    let (mut parser, mut block) = (Parser { is_trial: true, ..Parser::new(text) }, Block::default());
    while parser.next_block(&mut block) {
        if !holds(&block) {
            return false;
        }
    }
    true
}

/// Whether the comma of a word may separate thousands: `S1,200`, `F1,200`, `P1,500`.
fn may_be_thousands(address: u8, written: &str) -> bool {
    let Some((before, after)) = written.split_once([',', '，']) else { return false };
    let whole = before.trim_start_matches(|sign: char| !sign.is_ascii_digit());
    let is_group = after.len() == 3 && after.bytes().all(|byte| byte.is_ascii_digit());
    matches!(address, b'F' | b'P' | b'Q' | b'S')
        && is_group
        && whole.len() <= 3
        && !whole.starts_with('0')
        && !whole.is_empty()
}

/// Characters of the marks in front of remarks, and blanks.
const MARKS: [char; 11] = ['/', '<', '>', '=', '-', '←', '→', '⇐', '⇒', ' ', '\t'];

/// The span from the `//` or the arrow of a block to its end, if text follows: a comment in the style of C,
/// or `<-- Rapid`.
fn marked_remark(text: &[u8], block: &Block) -> Option<Span> {
    let own = block.span.of(text);
    let is_inside = |at: u32| block.comments.iter().any(|own| own.start <= at && at < own.end);
    let begins = |(at, pair): (usize, &[u8])| {
        // Unicode arrows share their first two bytes.
        let is_mark = matches!(pair, b"//" | b"<-" | b"->" | b"=>" | b"<=" | b"\xE2\x86" | b"\xE2\x87");
        (is_mark && !is_inside(block.span.start + at as u32)).then_some((at, pair == b"//"))
    };
    let (at, is_slashed) = own.windows(2).enumerate().find_map(begins)?;
    let shaft = own[..at].iter().rev().take_while(|byte| !is_slashed && b"-=<".contains(byte)).count();
    let start = block.span.start + (at - shaft) as u32;
    let remark = trimmed(text, Span { start, ..block.span });
    let after = String::from_utf8_lossy(remark.of(text));
    let after = after.trim_start_matches(MARKS).as_bytes();
    let is_text = match is_slashed {
        true => begins_as_sentence(after) || begins_in_other_script(after),
        // After `[` or `#`, the mark may belong to a macro expression.
        false => reads_as_prose(after) && !own[..at].iter().any(|byte| b"[#".contains(byte)),
    };
    is_text.then_some(remark)
}

/// The message about a comment over several lines. `ends`: the ends of its lines, except the last. The fix
/// puts each line in brackets.
fn over_lines(text: &[u8], open: Span, ends: &[u32]) -> Diagnostic {
    let edits = ends.iter().flat_map(|&end| {
        let close = end - u32::from(text[end as usize - 1] == b'\r');
        [(close, ")"), (end + 1, "(")]
            .map(|(at, text)| Edit { span: Span { start: at, end: at }, text: text.to_owned() })
    });
    let fix = Fix { title: Repair::CloseComment, safe: false, edits: edits.collect() };
    Diagnostic::new(said::CommentOverLines, open).with(fix)
}

/// Makes a block a comment.
fn keep_as_comment(block: &mut Block, remark: Span) {
    let (span, line) = (block.span, block.line);
    block.clear();
    (block.span, block.line) = (span, line);
    block.comment(remark);
}

/// Whether text cannot be words: a line of dashes or commas, text in another script, or a comment with a
/// bracket too many. Only such text may be treated as a remark, because other text may contain a lost sign.
fn is_decoration(bytes: &[u8]) -> bool {
    const LETTERS: usize = 4;
    let rule =
        bytes.len() > 1 && bytes.iter().all(|byte| matches!(byte, b'-' | b'_' | b'=' | b'*' | b' ' | b','));
    let foreign = bytes.iter().filter(|byte| !byte.is_ascii()).count() >= LETTERS
        && !bytes.iter().any(|byte| byte.is_ascii_alphanumeric() || *byte == b'?')
        && !String::from_utf8_lossy(bytes).contains(|sign: char| {
            sign.is_numeric() || sign.is_alphanumeric() && misread::is_full_width(sign)
        });
    // `(FACE) ROUGH), (TURN)`: a comment with a bracket too many.
    let bracketed = bytes.first() == Some(&b'(') && bytes.last() == Some(&b')');
    rule || foreign || bracketed
}

/// Whether a line consists of comments and punctuation.
fn only_marks_outside_brackets(bytes: &[u8]) -> bool {
    let mut outside = true;
    let mut remarks = false;
    for byte in bytes {
        match byte {
            b'(' if outside => (outside, remarks) = (false, true),
            b')' if !outside => outside = true,
            b',' | b'.' | b':' | b'-' | b'!' | b'?' => {}
            byte if outside && !byte.is_ascii_whitespace() => return false,
            _ => {}
        }
    }
    remarks && outside
}

/// Whether some bytes look like text rather than words of a block: three consecutive letters, or a character
/// that is not ASCII.
fn reads_as_prose(bytes: &[u8]) -> bool {
    !bytes.is_ascii() || bytes.windows(3).any(|run| run.iter().all(u8::is_ascii_alphabetic))
}

/// `X12..5` and `X12.8.` with one point; `None` if either point may be intended: `X1.2.5`.
fn without_second_point(word: &str) -> Option<String> {
    let first = word.find('.')?;
    let (head, tail) = word.split_at_checked(first + 1)?;
    let rest = tail.replace('.', "");
    let sure = tail.starts_with('.') || tail.find('.') == Some(tail.len() - 1);
    sure.then(|| format!("{head}{rest}"))
}

/// Adds a fix that puts a remark in brackets, unless it contains brackets.
fn in_brackets(text: &[u8], diagnostic: Diagnostic, is_sure: bool) -> Diagnostic {
    in_brackets_without(&[], text, diagnostic, is_sure)
}

/// Adds a fix that puts a remark in brackets without the characters `signs` at its head, unless nothing is
/// left or it contains brackets.
fn in_brackets_without(signs: &[char], text: &[u8], diagnostic: Diagnostic, is_sure: bool) -> Diagnostic {
    match std::str::from_utf8(diagnostic.span.of(text)).map(|remark| remark.trim_start_matches(signs)) {
        Ok(remark) if !remark.is_empty() && !remark.contains(['(', ')', '（', '）']) => {
            let fix = Fix { safe: is_sure, ..Fix::write(diagnostic.span, format!("({remark})")) };
            diagnostic.with(fix)
        }
        _ => diagnostic,
    }
}

/// Whether a block with this word calls a program: M98, M198, G65, G66.
fn calls_program(word: &Word) -> bool {
    let Value::Number { number, negative: false } = word.value else { return false };
    matches!((word.address, number.integer()), (b'M', Some(98 | 198)) | (b'G', Some(65 | 66)))
}

/// Drops surplus errors. Errors with a safe fix are all kept: otherwise applying a fix would show an error
/// that was dropped here, and the fix would seem to cause it.
fn keep_faults(faults: &mut Vec<Diagnostic>) {
    let mut others = 0;
    faults.retain(|fault| {
        let is_sure = fault.fixes.iter().any(|fix| fix.safe);
        others += usize::from(!is_sure);
        is_sure || others <= FAULTS_PER_BLOCK
    });
}

/// Whether a letter or digit of the block precedes a place, with only blanks and signs between.
fn follows_word(text: &[u8], block: u32, at: usize) -> bool {
    let before = String::from_utf8_lossy(&text[block as usize..at]);
    before.chars().rev().find(|&sign| !is_blank_or_sign(sign)).is_some_and(char::is_alphanumeric)
}

/// Whether the rest of a block begins with a number, after blanks and signs.
fn precedes_number(rest: &[u8]) -> bool {
    let is_between = |sign: char| is_blank_or_sign(sign) || sign.is_control();
    String::from_utf8_lossy(rest).chars().find(|&sign| !is_between(sign)).is_some_and(char::is_numeric)
}

/// Whether a character may be between a letter and its digits: a blank, a point or a sign, including
/// typographic ones.
fn is_blank_or_sign(sign: char) -> bool {
    sign.is_whitespace() || matches!(sign, '+' | '-' | '.' | '\u{2212}' | '\u{2013}' | '\u{ff0d}')
}

/// The span without blanks at either end.
fn trimmed(text: &[u8], span: Span) -> Span {
    let bytes = span.of(text);
    let front = bytes.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let back = bytes.iter().rev().take_while(|byte| byte.is_ascii_whitespace()).count();
    if front + back >= bytes.len() {
        return span;
    }
    Span { start: span.start + front as u32, end: span.end - back as u32 }
}

/// A text without its ASCII white space.
fn without_blanks(written: &str) -> String {
    written.chars().filter(|letter| !letter.is_ascii_whitespace()).collect()
}

/// Maximum length of a quotation of the program in a message, in characters.
const QUOTE_LENGTH: usize = 40;

/// The text of a span, shortened to [`QUOTE_LENGTH`].
pub(crate) fn short_quote(text: &[u8], span: Span) -> String {
    let end = span.end.min(span.start + 4 * QUOTE_LENGTH as u32);
    let quote = Span { start: span.start, end }.quote(text);
    if quote.chars().count() <= QUOTE_LENGTH && end == span.end {
        return quote;
    }
    let short: String = quote.chars().take(QUOTE_LENGTH - 1).collect();
    short + "…"
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Words, then errors, of each block: `X-5` or `!number-missing`.
    fn read(text: &str) -> Vec<String> {
        let mut parser = Parser::new(text.as_bytes());
        let mut block = Block::default();
        let mut found = Vec::new();
        while parser.next_block(&mut block) {
            let mut parts: Vec<String> = Vec::new();
            parts.extend(block.delete.map(|level| format!("/{level}")));
            parts.extend(block.program.map(|(number, _)| format!("O{number}")));
            parts.extend(block.sequence.map(|number| format!("N{number}")));
            for word in &block.words {
                let comma = if word.comma { "," } else { "" };
                let value = match word.value {
                    Value::Number { number, negative: false } => number.value().to_string(),
                    Value::Number { number, negative: true } => format!("-{}", number.value()),
                    Value::Expression => "#".into(),
                };
                parts.push(format!("{comma}{}{value}", word.address as char));
            }
            match block.kind {
                BlockKind::Percent => parts.push("%".into()),
                BlockKind::Macro => parts.push("macro".into()),
                BlockKind::Words => {}
            }
            parts.extend(block.faults.iter().map(|fault| format!("!{}", fault.message.slug())));
            found.push(parts.join(" "));
        }
        found
    }

    #[test]
    fn blocks_end_at_lines_and_semicolons() {
        assert_eq!(read("G0X1;Z2\r\nX3\rX4"), ["G0 X1", "Z2", "X3", "X4"]);
        assert_eq!(read("G0 X1;\n(only a remark);"), ["G0 X1", "", ""]);
    }

    #[test]
    fn words_may_be_written_in_many_ways() {
        assert_eq!(read("g94x30z0r-20f0.1"), ["G94 X30 Z0 R-20 F0.1"]);
        assert_eq!(read("X 26 Z - 5. F +.2"), ["X26 Z-5 F0.2"]);
        assert_eq!(read("N010 G01 (in) X5,C2 ,R 1"), ["N10 G1 X5 ,C2 ,R1"]);
        assert_eq!(read("/2 M98 P8001"), ["/2 M98 P8001"]);
        assert_eq!(read("O0002 (DEMO)"), ["O2"]);
        assert_eq!(read(":1234"), ["O1234"]);
        assert_eq!(read("\u{feff}G00\tX1\u{1a}"), ["G0 X1"]);
    }

    #[test]
    fn a_control_joins_digits_across_blanks() {
        assert_eq!(read("X1 0.5"), ["X10.5 !blank-in-number"]);
        assert_eq!(read("G00 3.7347"), ["G3.7347 !blank-in-number"]);
    }

    #[test]
    fn the_tape_begins_and_ends_with_percent() {
        assert_eq!(read("%leader\nG0 X1\n%\nnever read"), ["%", "G0 X1", "%"]);
        assert_eq!(read("O90 (CONE)\n%\nG0 X1\n%\nnever read"), ["O90", "%", "G0 X1", "%"]);
        assert_eq!(read("%\nO90\n%\nnever read"), ["%", "O90", "%"]);
    }

    #[test]
    fn each_fault_is_reported_once() {
        assert_eq!(read("X-12.8."), ["!second-decimal-point"]);
        assert_eq!(read("X-11.Z"), ["X-11 !number-missing"]);
        assert_eq!(read("G01 Z,15"), ["G1 Z0.15 !comma-for-point"]);
        assert_eq!(read("Z20,5"), ["Z20.5 !comma-for-point"]);
        assert_eq!(read("Z-20,5 X3"), ["Z-20.5 X3 !comma-for-point"]);
        assert_eq!(read("G1 X20 ,C1,5"), ["G1 X20 ,C1.5 !comma-for-point"]);
        assert_eq!(read("GO1 X5"), ["G1 X5 !letter-for-digit"]);
        assert_eq!(read("GO\nX5"), ["G0 !letter-for-digit", "X5"]);
        assert_eq!(read("X123456789"), ["!too-many-digits"]);
        assert_eq!(read("X"), ["!number-missing"]);
        assert_eq!(read("X-"), ["!number-missing"]);
        assert_eq!(read("X."), ["!number-missing"]);
        assert_eq!(read("Z–20"), ["Z-20 !printed-minus"]);
        assert_eq!(read("Z--20 X+-3"), ["Z-20 X-3 !minus-not-allowed !minus-not-allowed"]);
        assert_eq!(read("Z -20 X+3"), ["Z-20 X3"]);
        assert_eq!(read("00006;\nN10 X1"), ["O6 !zero-for-letter-o", "", "N10 X1"]);
        assert_eq!(read("hello world"), ["!text-outside-comment"]);
        assert_eq!(read("G0 (open"), ["G0 !comment-not-closed"]);
        assert_eq!(read("G0 (a(b)c) X1"), ["G0 X1 !comment-in-comment"]);
    }

    #[test]
    fn text_after_a_semicolon_is_a_remark() {
        assert_eq!(read("G0 X1; rough the face"), ["G0 X1", "!text-after-semicolon"]);
        for remark in [
            "turn to Z-50 (F0.2)",
            "Aproximação em X",
            "Posição intermediária",
            "Insert: CNMG 12 04 08",
            "start oil",
            "Inch units.",
        ] {
            assert_eq!(read(&format!("G0 X1; {remark}")), ["G0 X1", "!text-after-semicolon"], "{remark}");
        }
        for remark in [
            "End of program",
            "End",
            "if needed",
            "do not change",
            "Tool 1",
            "ID bore",
            "OD finish",
            "to home",
        ] {
            assert_eq!(read(&format!("G0 X1; {remark}")), ["G0 X1", "!text-after-semicolon"], "{remark}");
        }
        for word in ["S1,200", "F1,200", "P1,500"] {
            assert_eq!(read(&format!("G0 {word}")), ["G0 !comma-for-point"], "{word}");
        }
        assert_eq!(read("F0,200 Z1,250"), ["F0.2 Z1.25 !comma-for-point !comma-for-point"]);
        for remark in ["XZ Plane selection (LATHE)", "🔧 Facing", "✂️ Turning"] {
            assert_eq!(read(&format!("G0 X1; {remark}")), ["G0 X1", "!text-after-semicolon"], "{remark}");
        }
        assert_eq!(read("G0 X1 // facing, no change in X5"), ["G0 X1 !text-after-semicolon"]);
        assert_eq!(read("// facing"), ["!text-after-semicolon"]);
        for (block, fault) in
            [("G1 X40,5", "comma-for-point"), ("G0 X5O", "letter-for-digit"), ("G0 Z", "number-missing")]
        {
            let told = read(&format!("{block} // feed in")).concat();
            assert!(told.contains(fault) && told.contains("text-after-semicolon"), "{told}");
        }
        assert_eq!(read("G0 X50 turn Z2. // feed in").len(), 1);
        for block in [
            "GOl X20",
            "X20 turn",
            "IF[#1EQ1]GOTO2",
            "END1",
            "WHILE #1",
            "IF #1 EQ 2 GOTO 3",
            "DO 1",
            "XO Z2",
        ] {
            let told = read(&format!("G0 X1; {block}")).concat();
            assert!(!told.contains("text-after-semicolon"), "{told}");
        }
        assert_eq!(read("G0 X1; 粗车"), ["G0 X1", "!text-after-semicolon"]);
        // A block with errors is not a remark: a lost sign must not be hidden.
        assert_eq!(
            read("G98; Z?20.0 F100")[1],
            "F100 !number-missing !character-not-understood !address-missing"
        );
    }

    #[test]
    fn macro_statements_and_class_notes_are_recognised() {
        assert_eq!(read("#1=2\nIF[#1 EQ 2]GOTO 10\nX#1 Z[#2+1] F1"), ["macro", "macro", "X# Z# F1"]);
        assert_eq!(read("[BILLET X62 Z70\nG0 X1"), ["", "G0 X1"]);
    }

    #[test]
    fn a_block_reads_the_same_from_its_line_as_from_the_head() {
        let text = "O0001\nN20 M08 coolant on\nM30\n";
        let words = |at: Resume, before: usize| -> Vec<u8> {
            let mut parser = Parser::resume(text.as_bytes(), at);
            let mut block = Block::default();
            (0..=before).for_each(|_| assert!(parser.next_block(&mut block)));
            block.words.iter().map(|word| word.address).collect()
        };
        assert_eq!(words(Resume::default(), 1), b"M");
        assert_eq!(words(Resume::inside(6, 1), 0), b"M");
    }

    /// Text before the program number is no block, from the head and from its own line.
    #[test]
    fn a_title_reads_the_same_from_its_line_as_from_the_head() {
        let text = b"G71 ROUGHING\nG70 FINISH\nO0001\nG00 X1\nM30\n";
        let mut parser = Parser::new(text);
        let (mut first, mut second) = (Block::default(), Block::default());
        assert!(parser.next_block(&mut first) && parser.next_block(&mut second));
        let mut own = Block::default();
        assert!(Parser::resume(text, Resume::inside(13, 1)).next_block(&mut own));
        assert_eq!((own.words.len(), own.comments.len()), (second.words.len(), second.comments.len()));
    }

    #[test]
    fn a_comment_in_a_comment_ends_an_expression() {
        let mut parser = Parser::new(b"X#1 (A (B)) Z2");
        let mut block = Block::default();
        assert!(parser.next_block(&mut block));
        let addresses: Vec<u8> = block.words.iter().map(|word| word.address).collect();
        assert_eq!((&addresses[..], block.comments.len()), (&b"XZ"[..], 1));
    }

    #[test]
    fn the_fast_way_reads_the_same_as_the_tokens() {
        for text in ["X1", "x-1.25 ", "Z.5Y", "F5.", "G00000001", "N1\t", "R-0"] {
            let plain = Lexer::new(text.as_bytes(), 0).plain_word().expect(text);
            let tokens: Vec<crate::text::lexer::Token> = Lexer::new(text.as_bytes(), 0).collect();
            assert_eq!(tokens[0].kind, TokenKind::Letter(plain.letter));
            assert_eq!(tokens[1].kind == TokenKind::Minus, plain.negative);
            let TokenKind::Number(number) = tokens[1 + usize::from(plain.negative)].kind else {
                panic!("{text}")
            };
            assert_eq!((number.value(), number.points), (plain.number.value(), plain.number.points));
        }
        for text in ["X1 0", "X1.2.3", "X", "X-", "X.", "X123456789"] {
            assert_eq!(Lexer::new(text.as_bytes(), 0).plain_word(), None, "{text}");
        }
    }
}
