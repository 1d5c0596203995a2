//! Splits the text of any control into statements of words, names and remarks.
//!
//! In: the head of a text. Out: one [`Statement`] at a time, in reused storage. More tolerant than
//! `text::parser`, which parses FANUC's grammar: here `CYCLE95(`, `R1=10` and `L X+10 FMAX` are not errors.
//! Must not know the meaning of codes.

use crate::source::Span;
use crate::text::lexer::{Lexer, Number, Token, TokenKind};

/// Most words of a statement that are kept.
const MAX_WORDS: usize = 16;
/// Most names of a statement that are kept.
const MAX_NAMES: usize = 4;

/// A letter and the number after it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Word {
    /// The letter, upper-case.
    pub letter: u8,
    /// Its number; `None` in `X#1`, `T="…"`, `L X+10`.
    pub number: Option<Number>,
    /// Whether the number has a `+` or `-`.
    pub signed: bool,
    /// Whether the sign is `-`.
    pub negative: bool,
    /// Whether `=` follows: `R1=`, `X=`.
    pub assigned: bool,
    /// Letter, sign, number and `=`.
    pub span: Span,
}

/// Two or more consecutive letters, with the digits after them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Name {
    /// Letters and digits.
    pub span: Span,
    /// Whether `=` follows.
    pub assigned: bool,
    /// Whether `(` follows.
    pub called: bool,
}

/// A line, or the part of it before or after a `;`.
#[derive(Clone, Debug, Default)]
pub struct Statement {
    /// All its bytes, without blanks around it.
    pub span: Span,
    /// Whether it follows a `;` on its line: a remark on many controls, the next block on FANUC's.
    pub after_semicolon: bool,
    /// The first `(…)` of the statement.
    pub remark: Option<Span>,
    /// The `#<` of a variable with a name.
    pub named_variable: Option<Span>,
    words: [Word; MAX_WORDS],
    word_count: usize,
    names: [Name; MAX_NAMES],
    name_count: usize,
}

impl Statement {
    /// The words that were kept.
    pub fn words(&self) -> &[Word] {
        &self.words[..self.word_count]
    }

    /// The names that were kept.
    pub fn names(&self) -> &[Name] {
        &self.names[..self.name_count]
    }

    /// The first word with a letter.
    pub fn word(&self, letter: u8) -> Option<&Word> {
        self.words().iter().find(|word| word.letter == letter)
    }

    /// Whether there is a word with a letter.
    pub fn has(&self, letter: u8) -> bool {
        self.word(letter).is_some()
    }

    /// Whether there is a word with each of these letters.
    pub fn has_all(&self, letters: &[u8]) -> bool {
        letters.iter().all(|&letter| self.has(letter))
    }

    /// Whether there is a word with any of these letters.
    pub fn has_any(&self, letters: &[u8]) -> bool {
        letters.iter().any(|&letter| self.has(letter))
    }

    /// The numbers of all words with a letter, in tenths (`G33.1` is 331), with their places.
    pub fn codes(&self, letter: u8) -> impl Iterator<Item = (u32, Span)> {
        self.words().iter().filter(move |word| word.letter == letter).filter_map(|word| {
            let tenths = word.number?.tenths()?;
            Some((u32::try_from(tenths).ok()?, word.span))
        })
    }

    fn clear(&mut self, start: usize) {
        *self = Self { span: Span::new(start, start), ..Self::default() };
    }

    fn push_word(&mut self, word: Word) {
        if self.word_count < MAX_WORDS {
            self.words[self.word_count] = word;
            self.word_count += 1;
        }
    }

    fn push_name(&mut self, name: Name) {
        if self.name_count < MAX_NAMES {
            self.names[self.name_count] = name;
            self.name_count += 1;
        }
    }
}

/// Reads a text statement by statement.
pub struct Statements<'a> {
    lexer: Lexer<'a>,
    after_semicolon: bool,
}

impl<'a> Statements<'a> {
    /// Starts at the head of `text`.
    pub fn new(text: &'a [u8]) -> Self {
        Self { lexer: Lexer::new(text, 0), after_semicolon: false }
    }

    /// Reads the next statement into `statement`. Returns false at the end of the text.
    pub fn read(&mut self, statement: &mut Statement) -> bool {
        statement.clear(self.lexer.position());
        statement.after_semicolon = self.after_semicolon;
        if self.lexer.peek_byte().is_none() {
            return false;
        }
        let mut begun = false;
        while let Some(token) = self.lexer.next_token() {
            match token.kind {
                TokenKind::LineEnd | TokenKind::Semicolon => {
                    self.after_semicolon = token.kind == TokenKind::Semicolon;
                    return true;
                }
                TokenKind::Blank => continue,
                TokenKind::Letter(_) if self.letter_follows() => {
                    let name = self.name(token);
                    statement.push_name(name);
                }
                TokenKind::Letter(letter) => {
                    let word = self.word(letter, token);
                    statement.push_word(word);
                }
                TokenKind::Comment | TokenKind::NestedComment | TokenKind::OpenComment => {
                    statement.remark.get_or_insert(token.span);
                }
                TokenKind::Macro(b'#') if self.lexer.peek_byte() == Some(b'<') => {
                    let end = self.lexer.position() + 1;
                    statement.named_variable.get_or_insert(Span::new(token.span.start as usize, end));
                }
                _ => {}
            }
            if !begun {
                begun = true;
                statement.span.start = token.span.start;
            }
            statement.span.end = self.lexer.position() as u32;
        }
        true
    }

    fn letter_follows(&self) -> bool {
        self.lexer.peek_byte().is_some_and(|byte| byte.is_ascii_alphabetic())
    }

    /// Reads the rest of a name after its first letter.
    fn name(&mut self, first: Token) -> Name {
        let mut end = self.lexer.position();
        let text = self.lexer.text();
        while text.get(end).is_some_and(u8::is_ascii_alphanumeric) {
            end += 1;
        }
        self.lexer.seek(end);
        let called = text.get(end) == Some(&b'(');
        let span = Span::new(first.span.start as usize, end);
        Name { span, assigned: self.after_equals().is_some(), called }
    }

    /// Reads the sign and number after a letter.
    fn word(&mut self, letter: u8, first: Token) -> Word {
        let mut word = Word { letter, span: first.span, ..Word::default() };
        self.skip_blanks();
        let before_sign = self.lexer.position();
        if matches!(self.lexer.peek_byte(), Some(b'+' | b'-')) {
            word.signed = true;
            word.negative = self.lexer.peek_byte() == Some(b'-');
            self.lexer.seek(before_sign + 1);
            self.skip_blanks();
        }
        if matches!(self.lexer.peek_byte(), Some(b'0'..=b'9' | b'.')) {
            if let Some(Token { kind: TokenKind::Number(number), span }) = self.lexer.next_token() {
                word.number = Some(number);
                word.span.end = span.end;
            }
        } else {
            (word.signed, word.negative) = (false, false);
            self.lexer.seek(before_sign);
        }
        if let Some(end) = self.after_equals() {
            word.assigned = true;
            word.span.end = end as u32;
            self.lexer.seek(end);
        }
        word
    }

    fn skip_blanks(&mut self) {
        while matches!(self.lexer.peek_byte(), Some(b' ' | b'\t')) {
            self.lexer.seek(self.lexer.position() + 1);
        }
    }

    /// End of the `=` that follows, if any.
    fn after_equals(&self) -> Option<usize> {
        let at = self.lexer.position();
        match self.lexer.text().get(at..)? {
            [b'=', ..] => Some(at + 1),
            [b' ', b'=', ..] => Some(at + 2),
            _ => None,
        }
    }
}
