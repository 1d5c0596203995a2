//! Programs that would run forever, for the native tests, the wasm tests and the table of
//! `cargo xtask bench`: cycles with a far too small step, endless loops and calls, expensive work called
//! repeatedly, and long texts without meaning. Also programs just within and just beyond each limit.

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

/// Longest time that a page may be blocked, seconds.
pub const MAX_SECONDS: f64 = 1.0;

/// A program that never ends or has no meaning, and the expected message.
pub struct Hostile {
    /// Its description.
    pub name: String,
    /// Its setup.
    pub setup: &'static str,
    /// Its text, about a megabyte at most.
    pub text: Vec<u8>,
    /// Code of the message.
    pub code: &'static str,
    /// Line of the message, counted from 1.
    pub line: u32,
}

/// All hostile programs.
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

/// A text repeated to about a megabyte.
fn megabyte(of: &str) -> String {
    of.repeat((1 << 20) / of.len())
}

/// A text for each number from 1 up, until the total is about a megabyte.
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

/// A head, and calls of a cycle until the text is about a megabyte.
fn called(head: &str, call: &str) -> String {
    let mut text = head.to_owned();
    while text.len() < 1 << 20 {
        text += call;
    }
    text
}
