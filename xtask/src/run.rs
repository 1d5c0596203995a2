//! In: a command and a description of its purpose. Out: the command is run and timed; if it fails, the error
//! names it in a message with instructions. Does not know the commands themselves.

use std::fmt::Display;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, ScopedJoinHandle};
use std::time::{Duration, Instant};
use std::{env, fs, io, iter};

/// A result with an error message for the user.
pub type Result<T = ()> = std::result::Result<T, String>;

/// The root folder of the repository.
pub fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here).to_path_buf()
}

/// The folder of the page and its npm package.
pub fn www() -> PathBuf {
    root().join("www")
}

/// The target folder of cargo.
pub fn target() -> PathBuf {
    root().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Prints one plain line for the user on standard error.
pub fn say(line: impl Display) {
    eprintln!("xtask: {line}");
}

/// A time as shown in the log: `0.4 s`, `12 s`, `3 min 05 s`.
pub fn pretty(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 9.95 {
        format!("{seconds:.1} s")
    } else if seconds < 99.5 {
        format!("{seconds:.0} s")
    } else {
        let whole = seconds.round() as u64;
        format!("{} min {:02} s", whole / 60, whole % 60)
    }
}

/// A program that starts in the root of the repository, without the environment variables of the surrounding
/// `cargo xtask`: an inherited `CARGO` would select the wrong cargo if toolchains are mixed.
pub fn command(program: impl AsRef<std::ffi::OsStr>) -> Command {
    let mut command = Command::new(program);
    command.current_dir(root()).env_remove("CARGO");
    command
}

/// `npm`, with its name on Windows.
pub fn npm() -> Command {
    let mut command = command(if cfg!(windows) { "npm.cmd" } else { "npm" });
    command.current_dir(www());
    command
}

/// Runs a step of a command: prints its description, its output and its duration.
pub fn step(name: &str, command: &mut Command) -> Result<Duration> {
    say(format_args!("{name} ({})", shown(command)));
    let start = Instant::now();
    let status = command.status().map_err(|error| not_started(command, &error))?;
    let time = start.elapsed();
    if status.success() {
        say(format_args!("{name}: done in {}", pretty(time)));
        Ok(time)
    } else {
        Err(format!(
            "{name}: failed after {} ({status})\n  the command was: {}",
            pretty(time),
            shown(command)
        ))
    }
}

/// Runs a step of the set-up: prints its description, and its output only if it fails.
pub fn quiet(what: &str, command: &mut Command) -> Result {
    say(format_args!("{what} …"));
    let start = Instant::now();
    let output = capture(command)?;
    if output.status.success() {
        say(format_args!("{what}: done in {}", pretty(start.elapsed())));
        return Ok(());
    }
    let text =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).trim_end().to_owned());
    Err(format!(
        "{what}: failed ({})\n  the command was: {}\n{}",
        output.status,
        shown(command),
        text.join("\n")
    ))
}

/// Runs `act` on each item, in parallel on all processors. No further item is started after a failure.
pub fn for_each<T: Sync>(items: &[T], act: impl Fn(&T) -> Result + Sync) -> Result {
    let next = AtomicUsize::new(0);
    let work = || {
        let outcome = iter::from_fn(|| items.get(next.fetch_add(1, Ordering::Relaxed))).try_for_each(&act);
        if outcome.is_err() {
            next.store(items.len(), Ordering::Relaxed);
        }
        outcome
    };
    let processors = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        let workers: Vec<_> = (0..processors).map(|_| scope.spawn(work)).collect();
        workers.into_iter().try_for_each(joined)
    })
}

/// Runs two tasks in parallel, neither of which uses all processors. Their outputs are mixed.
pub fn both<One: Send, Other>(
    one: impl FnOnce() -> Result<One> + Send,
    other: impl FnOnce() -> Result<Other>,
) -> Result<(One, Other)> {
    thread::scope(|scope| {
        let one = scope.spawn(one);
        let other = other();
        Ok((joined(one)?, other?))
    })
}

/// The result of a thread.
pub fn joined<T>(task: ScopedJoinHandle<'_, Result<T>>) -> Result<T> {
    task.join().unwrap_or_else(|_| Err("a step ended unexpectedly".to_owned()))
}

/// The trimmed standard output of a program; `None` if it cannot be started or fails.
pub fn ask(command: &mut Command) -> Option<String> {
    let output = capture(command).ok().filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Whether a program exists and succeeds; its output is discarded.
pub fn succeeds(command: &mut Command) -> bool {
    capture(command).is_ok_and(|output| output.status.success())
}

/// The command as typed in a shell.
pub fn shown(command: &Command) -> String {
    let mut line = Path::new(command.get_program()).display().to_string();
    for argument in command.get_args() {
        line.push(' ');
        line.push_str(&argument.to_string_lossy());
    }
    line
}

/// Runs a program and returns its output.
pub fn capture(command: &mut Command) -> Result<Output> {
    command.stdin(Stdio::null()).output().map_err(|error| not_started(command, &error))
}

/// Copies a file.
pub fn copy(from: &Path, to: &Path) -> Result {
    fs::copy(from, to).map(drop).map_err(|error| cannot("copy", from, &error))
}

/// The error message for a file that cannot be read, written or copied.
pub fn cannot(act: &str, path: &Path, error: &io::Error) -> String {
    format!("cannot {act} {}: {error}", path.display())
}

/// The error message for a program that cannot be started.
pub fn not_started(command: &Command, error: &std::io::Error) -> String {
    format!("cannot start `{}`: {error}", shown(command))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_read_well() {
        let check = |millis, text: &str| assert_eq!(pretty(Duration::from_millis(millis)), text);
        check(432, "0.4 s");
        check(9_940, "9.9 s");
        check(9_960, "10 s");
        check(99_400, "99 s");
        check(185_000, "3 min 05 s");
    }

    #[test]
    fn a_failing_step_names_itself_and_its_command_and_shows_what_was_said() {
        let message = quiet("reading nothing", command("cargo").arg("no-such-command")).unwrap_err();
        assert!(message.starts_with("reading nothing: failed"), "{message}");
        assert!(message.contains("the command was: cargo no-such-command\n"), "{message}");
        assert!(message.contains("error: no such command"), "{message}");
    }
}
