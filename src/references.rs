//! The blocks of a program with a sequence number, and the words that refer to them: P and Q of G70 to G73,
//! M97, M98 and M99, and GOTO.
//!
//! In: a text and the codes of its control. Out: [`References`]: each numbered block, and where each reference
//! leads, also in blocks that are never executed. Follows the rules of `control::interpreter`. Must not know
//! who changes the numbers.

use std::collections::BTreeMap;

use crate::assist::names::{Kind, Name, Scope, calls, calls_own_program, computed, names};
use crate::control::codes;
use crate::control::program::{Labels, program_and_repeats};
use crate::order;
use crate::setup::dialect::{CodeList, Control};
use crate::source::Span;
use crate::text::block::Block;
use crate::text::parser::Parser;

/// The system variables with the sequence number of the last block (FANUC: #4114; of the block in progress: #4314).
const SEQUENCE_VARIABLES: [u32; 2] = [4114, 4314];

/// Maximum number of programs that call one program, as far as its M99 P is followed.
pub const MAX_CALLERS: usize = 100;

/// A block with a sequence number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numbered {
    /// Index of the block in the text, from 0; empty blocks count.
    pub block: usize,
    /// Index of its O program in the text.
    pub program: usize,
    /// The number.
    pub number: u32,
    /// The word `N10`, or the whole block if the word cannot be read.
    pub span: Span,
}

/// A word that refers to a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Index of its block in the text.
    pub block: usize,
    /// The word, or the number after GOTO.
    pub span: Span,
    /// The program that contains the block to which it leads.
    pub scope: Scope,
    /// Where it leads.
    pub target: Target,
}

/// Where a reference leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// To the block with a number in each of these programs: more than one for M99 P of a program that several
    /// programs call.
    Blocks {
        /// The number.
        number: u32,
        /// The programs.
        reached: Vec<Reached>,
    },
    /// To a block of a program that is not in the text.
    Elsewhere,
    /// Its number, or its program, is known only at run time, or it cannot be read.
    Computed,
    /// More than [`MAX_CALLERS`] programs call the program of M99 P.
    TooManyCallers,
}

/// The block of a program that a reference leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reached {
    /// Index of the program in the text.
    pub program: usize,
    /// Index of the block in the text; `None` if the program has no such block.
    pub block: Option<usize>,
}

/// The beginning of an O program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Head {
    /// Index of its first block in the text.
    pub block: usize,
    /// First byte of the block.
    pub at: u32,
}

/// The numbered blocks of a text, and the references to them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct References {
    /// The programs, in order; the first begins at the start of the text.
    pub programs: Vec<Head>,
    /// The blocks with a number, in order.
    pub numbered: Vec<Numbered>,
    /// The references, in order.
    pub references: Vec<Reference>,
    /// Variables that contain a sequence number: `#4114`.
    pub variables: Vec<Span>,
    /// Indices of `numbered`, sorted by program and number.
    by_number: Vec<usize>,
}

impl References {
    /// Reads a text.
    pub fn of(text: &[u8], codes: CodeList, control: Control) -> Self {
        let mut reading = Reading::new(text, codes);
        let unresolved = reading.read();
        let callers = reading.callers();
        let references = unresolved.into_iter().filter_map(|found| {
            let Unresolved { block, span, scope, .. } = found;
            let target = reading.target(&found, &callers, control)?;
            Some(Reference { block, span, scope, target })
        });
        let references = references.collect();
        let Reading { programs, numbered, variables, .. } = reading;
        let mut by_number: Vec<usize> = (0..numbered.len()).collect();
        order::by_key(&mut by_number, |index| (numbered[*index].program, numbered[*index].number));
        Self { programs, numbered, references, variables, by_number }
    }

    /// The blocks of a program with a number, in order.
    pub fn with_number(&self, program: usize, number: u32) -> impl Iterator<Item = &Numbered> {
        let key = |index: &usize| (self.numbered[*index].program, self.numbered[*index].number);
        let first = self.by_number.partition_point(|index| key(index) < (program, number));
        let own = self.by_number[first..].iter().take_while(move |index| key(index) == (program, number));
        own.map(|index| &self.numbered[*index])
    }

    /// Index of the program that contains a block.
    pub fn program_of(&self, block: usize) -> usize {
        self.programs.partition_point(|head| head.block <= block).saturating_sub(1)
    }
}

/// A reference before the whole text has been read.
struct Unresolved {
    block: usize,
    program: usize,
    /// First byte of its block.
    at: u32,
    span: Span,
    /// `None`: not a plain number.
    number: Option<u32>,
    scope: Scope,
    /// Whether it is the jump of a block of macro A, which may be a call instead.
    is_of_macro_a: bool,
}

/// A block that calls a program.
struct CallSite {
    program: usize,
    /// First byte of the block.
    at: u32,
    /// The value of P; `None` if it is not a plain number.
    called: Option<u32>,
}

/// A text while it is read.
struct Reading<'a> {
    text: &'a [u8],
    codes: CodeList,
    labels: Labels,
    /// First byte of each block.
    starts: Vec<u32>,
    programs: Vec<Head>,
    numbered: Vec<Numbered>,
    calls: Vec<CallSite>,
    /// The programs with M97, ascending.
    with_own_calls: Vec<usize>,
    variables: Vec<Span>,
}

impl<'a> Reading<'a> {
    fn new(text: &'a [u8], codes: CodeList) -> Self {
        Self {
            text,
            codes,
            labels: Labels::new(text),
            starts: Vec::new(),
            programs: vec![Head::default()],
            numbered: Vec::new(),
            calls: Vec::new(),
            with_own_calls: Vec::new(),
            variables: Vec::new(),
        }
    }

    /// Reads all blocks; returns their references.
    fn read(&mut self) -> Vec<Unresolved> {
        let (mut parser, mut block) = (Parser::new(self.text), Block::default());
        let (mut begun, mut found) = (false, Vec::new());
        while parser.next_block(&mut block) {
            // The first program may begin without a number.
            if block.program.is_some() && begun {
                self.programs.push(Head { block: self.starts.len(), at: block.span.start });
            }
            begun |= !block.is_empty();
            self.starts.push(block.span.start);
            self.take(&block, &mut found);
        }
        found
    }

    fn take(&mut self, block: &Block, found: &mut Vec<Unresolved>) {
        let (index, program, at) = (self.starts.len() - 1, self.programs.len() - 1, block.span.start);
        let is_of_macro_a = codes::macro_a(block).is_some();
        let unresolved = |span, number, scope| Unresolved {
            block: index,
            program,
            at,
            span,
            number,
            scope,
            is_of_macro_a,
        };
        let before = self.numbered.len();
        for named in names(self.text, block, self.codes) {
            match named.name {
                Name::Sequence(number) if named.defines => {
                    self.numbered.push(Numbered { block: index, program, number, span: named.span });
                }
                Name::Sequence(number) => found.push(unresolved(named.span, Some(number), named.scope)),
                Name::Variable(number) if SEQUENCE_VARIABLES.contains(&number) => {
                    self.variables.push(named.span);
                }
                Name::Program(_) | Name::Variable(_) => {}
            }
        }
        // A text that is no block may contain an N that reads as a number.
        if let Some(number) = block.sequence.filter(|_| self.numbered.len() == before && !block.is_broken()) {
            self.numbered.push(Numbered { block: index, program, number, span: block.span });
        }
        let computed = computed(self.text, block, self.codes);
        let computed = computed.into_iter().filter(|found| found.kind == Kind::Sequence);
        found.extend(computed.map(|found| unresolved(found.span, None, found.scope)));
        let called = calls(self.text, block, self.codes);
        self.calls.extend(called.into_iter().map(|called| CallSite { program, at, called }));
        if calls_own_program(self.text, block, self.codes) && self.with_own_calls.last() != Some(&program) {
            self.with_own_calls.push(program);
        }
    }

    /// The program that contains a byte.
    fn program_at(&self, byte: u32) -> usize {
        self.programs.partition_point(|head| head.at <= byte).saturating_sub(1)
    }

    /// First byte of the program that P calls.
    fn head_of(&self, called: u32) -> Option<u32> {
        let packed = || self.labels.program(program_and_repeats(called.into()).0);
        self.labels.program(called).or_else(packed).map(|head| head.byte)
    }

    /// The calls of each program: the first one in each calling program.
    fn callers(&self) -> Callers {
        let mut callers = Callers::default();
        for site in &self.calls {
            let to = match site.called.map(|called| self.head_of(called)) {
                Some(Some(head)) => callers.of.entry(self.program_at(head)).or_default(),
                Some(None) => continue,
                None => &mut callers.of_any,
            };
            if to.last().is_none_or(|last| self.program_at(*last) != site.program) {
                to.push(site.at);
            }
        }
        callers
    }

    /// `None`: a call, not a reference.
    fn target(&self, found: &Unresolved, callers: &Callers, control: Control) -> Option<Target> {
        let Some(number) = found.number else { return Some(Target::Computed) };
        if found.is_of_macro_a && control != Control::Gsk && self.labels.program(number).is_some() {
            return None;
        }
        let from = match found.scope {
            Scope::Own => vec![found.at],
            Scope::Called(called) => match self.head_of(called) {
                Some(head) => vec![head],
                None => return Some(Target::Elsewhere),
            },
            Scope::Caller => match self.callers_of(found, number, callers) {
                Some(callers) => callers,
                None => return Some(Target::TooManyCallers),
            },
        };
        let mut reached: Vec<Reached> = from.into_iter().map(|from| self.reached(number, from)).collect();
        reached.dedup();
        Some(Target::Blocks { number, reached })
    }

    /// The block with a number in the program that contains byte `from`.
    fn reached(&self, number: u32, from: u32) -> Reached {
        let block = self.labels.find(number, from).map(|at| at.byte);
        let block = block.map(|byte| self.starts.partition_point(|start| *start < byte));
        Reached { program: self.program_at(from), block }
    }

    /// A byte in each program to which M99 P may return: its own if no other program calls it, or if M97 does.
    /// `None` if there are too many.
    fn callers_of(&self, found: &Unresolved, number: u32, callers: &Callers) -> Option<Vec<u32>> {
        let known = callers.of.get(&found.program).into_iter().flatten().copied();
        // A number that is not known may be that of any other program.
        let others = callers.of_any.iter().copied().filter(|at| self.program_at(*at) != found.program);
        let mut all: Vec<u32> = known.chain(others).take(MAX_CALLERS + 1).collect();
        let is_called_by_itself = self.with_own_calls.binary_search(&found.program).is_ok()
            && self.reached(number, found.at).block.is_some();
        if all.is_empty() || is_called_by_itself {
            all.push(found.at);
        }
        (all.len() <= MAX_CALLERS).then_some(all)
    }
}

/// The first bytes of the blocks that call a program, one for each calling program.
#[derive(Default)]
struct Callers {
    /// By index of the called program.
    of: BTreeMap<usize, Vec<u32>>,
    /// Calls of a program whose number is not a plain number.
    of_any: Vec<u32>,
}
