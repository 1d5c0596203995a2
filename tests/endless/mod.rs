//! Programs that would take for ever, for the native tests, the wasm tests and the table of
//! `cargo xtask bench`: cycles with an amount that is far too small, loops and calls without an end, dear
//! work called again and again, and texts that are long and of no sense. And each limit with programs
//! just within it and beyond.

mod bounds;
mod cycles;
mod dear;
mod expressions;
mod loops;
mod paths;
mod signs;
mod texts;
mod work;

pub use bounds::bounds;
pub use cycles::endless;

/// Longest time a page may stand still, seconds.
pub const MOST_SECONDS: f64 = 1.0;

/// A program that never ends or is of no sense, and what must be said of it.
pub struct Hostile {
    /// What it is.
    pub name: String,
    /// Its setup.
    pub setup: &'static str,
    /// Its text, of about a megabyte at most.
    pub text: Vec<u8>,
    /// Code of the message.
    pub code: &'static str,
    /// Line of the message, from 1.
    pub line: u32,
}

/// All of them.
pub fn hostile() -> Vec<Hostile> {
    let mut all = loops::never_ending();
    all.extend(work::repeated_work());
    all.extend(dear::dear_cycles());
    all.extend(paths::long_paths());
    all.extend(expressions::deep_expressions());
    all.extend(texts::long_texts());
    all.extend(signs::one_sign());
    all
}

fn case(name: impl Into<String>, text: impl Into<Vec<u8>>, code: &'static str, line: u32) -> Hostile {
    Hostile { name: name.into(), setup: "{}", text: text.into(), code, line }
}

/// About a megabyte of a text again and again.
fn megabyte(of: &str) -> String {
    of.repeat((1 << 20) / of.len())
}

/// A text for each of the numbers from 1 until it is about a megabyte.
fn numbered(of: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for number in 1.. {
        if text.len() >= 1 << 20 {
            break;
        }
        text += &of(number);
    }
    text
}

/// Calls of a cycle after its head until the text is about a megabyte.
fn called(head: &str, call: &str) -> String {
    let mut text = head.to_owned();
    while text.len() < 1 << 20 {
        text += call;
    }
    text
}
