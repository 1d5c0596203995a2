//! Determines what the words of a block belong to: a move, one of the blocks of a cycle, a call.
//!
//! In: a block, the state before it, the codes of the control. Out: its [`Form`], by the same rules as
//! `control::interpreter`.

use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{self, G, Hole, M, MotionMode, Multiple};
use crate::control::modal::State;
use crate::control::words::{letters_of, plain};
use crate::setup::dialect::CodeList;
use crate::text::block::{Block, Value, Word};

/// What the words of a block belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A move, or a pass of a single cycle (group 01). `own`: the block contains the code.
    Motion {
        /// The modal code in force.
        mode: MotionMode,
        /// Whether the block contains the code.
        own: bool,
    },
    /// A hole cycle.
    Hole {
        /// The cycle.
        hole: Hole,
        /// Whether the block contains the code.
        own: bool,
    },
    /// G70 to G76.
    Multiple(Multiple, CycleBlock),
    /// A one-shot code.
    OneShot(G),
    /// G65, G66.
    MacroCall,
    /// M97, M98, M99, M198.
    Call(M),
    /// A macro statement.
    Macro,
    /// A block that cannot be executed.
    Nothing,
}

impl Form {
    /// The form of a block executed in a state.
    pub fn of(block: &Block, state: &State, list: CodeList) -> Self {
        if block.kind == crate::text::block::BlockKind::Macro {
            return Self::Macro;
        }
        if block.words.is_empty() {
            return Self::Nothing;
        }
        let (mut motion, mut hole, mut one_shot, mut off) = (None, None, None, false);
        for word in &block.words {
            match g_of(word, list) {
                Some(G::MacroCall(_)) => return Self::MacroCall,
                Some(G::Motion(mode)) => (motion, off) = (Some(mode), true),
                Some(G::Hole(own)) => hole = Some(own),
                Some(G::NoHole) => off = true,
                Some(
                    code @ (G::Dwell
                    | G::CheckHome
                    | G::Home
                    | G::FromHome
                    | G::OtherHome
                    | G::Machine
                    | G::Data
                    | G::Setting
                    | G::LocalFrame
                    | G::ExtendedFrame
                    | G::Polar(_)
                    | G::Cylinder
                    | G::Multiple(_)
                    | G::NotSupported),
                ) => one_shot = Some(code),
                _ => {}
            }
        }
        let call = block.words.iter().find_map(|word| m_of(word).filter(|code| is_call(*code)));
        match (one_shot, hole, call) {
            (Some(G::Multiple(cycle)), ..) => Self::Multiple(cycle, cycle_block(cycle, block)),
            (Some(code), ..) => Self::OneShot(code),
            (None, Some(hole), _) => Self::Hole { hole, own: true },
            (None, None, Some(call)) => Self::Call(call),
            (None, None, None) => match state.hole.filter(|_| !off) {
                Some(memory) => Self::Hole { hole: memory.kind, own: false },
                None => Self::Motion { mode: motion.unwrap_or(state.motion), own: motion.is_some() },
            },
        }
    }
}

/// The G code of a word in a code list.
pub fn g_of(word: &Word, list: CodeList) -> Option<G> {
    let Value::Number { number, .. } = word.value else { return None };
    let key = number.tenths().filter(|_| word.address == b'G' && !word.comma)?;
    codes::g_code(key, list).map(|found| found.code)
}

/// The M code of a word.
pub fn m_of(word: &Word) -> Option<M> {
    let number =
        plain(word).filter(|number| word.address == b'M' && *number >= 0.0 && number.fract() == 0.0)?;
    codes::m_code(number as u64)
}

fn is_call(code: M) -> bool {
    matches!(code, M::Call | M::LocalCall | M::Return)
}

/// Which block of a multiple cycle it is, decided by its words.
pub fn cycle_block(cycle: Multiple, block: &Block) -> CycleBlock {
    cycle.spec().block(letters_without_comma(block))
}

/// Letters of the words that follow no comma, as the bits of [`letters`](crate::control::words::letters).
pub fn letters_without_comma(block: &Block) -> u32 {
    letters_of(block.words.iter().filter(|word| !word.comma))
}
