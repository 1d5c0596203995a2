//! In: words. Out: those that hunspell does not know. A missing hunspell or dictionary fails the test.

use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Stdio};
use std::thread;

/// How to install it.
const INSTALL: &str = "`cargo xtask setup` installs hunspell with its dictionaries, as does \
                       `apt-get install hunspell hunspell-en-gb hunspell-ru`";

/// The words missing in a dictionary, in alphabetical order.
pub fn unknown<'a>(dictionary: &str, words: impl Iterator<Item = &'a String>) -> Vec<String> {
    let lines = words.fold(String::new(), |lines, word| lines + word + "\n");
    let mut hunspell = Command::new("hunspell");
    hunspell.args(["-l", "-i", "UTF-8", "-d", dictionary]);
    hunspell.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut hunspell = hunspell.spawn().unwrap_or_else(|error| panic!("hunspell: {error}. {INSTALL}"));
    let mut input = hunspell.stdin.take().expect("a pipe");
    // In a separate thread: hunspell writes while it reads, and a full pipe would block both.
    let writing = thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = hunspell.wait_with_output().expect("the output of hunspell");
    let problem = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && problem.is_empty(), "hunspell -d {dictionary}: {problem} {INSTALL}");
    writing.join().expect("no panic").expect("hunspell reads all words");
    let unknown: BTreeSet<_> = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    unknown.into_iter().collect()
}
