//! Runs random programs, in the language that lathe controls and LinuxCNC share, in the playground and in
//! LinuxCNC's stand-alone interpreter, and compares the motions. Started by `cargo xtask compare-linuxcnc`.
//!
//! In: the number of programs, and a seed. Out: statistics, a table of intended differences, and exit code 0;
//! or the smallest program with an unintended difference, both outputs, and exit code 1; or exit code 2 if
//! the command line is invalid or LinuxCNC is missing.
//!
//! Flow: `generate` → `translate` → `motion` (ours) and `rs274` → `canon` (theirs) → `compare`, with `known`.

mod canon;
mod compare;
mod contour;
mod generate;
mod known;
mod motion;
mod program;
mod random;
mod rs274;
mod shrink;
mod translate;

use std::collections::BTreeMap;
use std::env;
use std::process::ExitCode;
use std::time::Instant;

use compare::{Comparison, compare};
use generate::Language;
use known::KnownDifference;
use program::Program;
use random::Random;
use rs274::Rs274;

const USAGE: &str = "\
cargo xtask compare-linuxcnc [--programs N] [--seed N] [--frame-origins]

  --programs N      how many (10000)
  --seed N          which ones (1)
  --frame-origins   with origins of G54 to G59 set by G10 L2, which the playground does not carry out yet
";

/// Number of programs in a batch.
const AT_A_TIME: usize = 500;

/// The parsed command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Options {
    programs: usize,
    seed: u64,
    language: Language,
}

fn main() -> ExitCode {
    let words: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    if words.iter().any(|word| matches!(*word, "help" | "--help" | "-h")) {
        print!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    let ready = parse(&words).map_err(|message| format!("{message}\n\n{USAGE}"));
    let ready = ready.and_then(|options| Ok((options, Rs274::find()?)));
    let (options, rs274) = match ready {
        Ok(ready) => ready,
        Err(message) => {
            eprintln!("compare-linuxcnc: {message}");
            return ExitCode::from(2);
        }
    };
    match run(options, &rs274) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("\ncompare-linuxcnc: {message}");
            ExitCode::FAILURE
        }
    }
}

fn parse(words: &[&str]) -> Result<Options, String> {
    let mut options = Options { programs: 10_000, seed: 1, language: Language::default() };
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let mut number = || {
            let number = words.next().ok_or_else(|| format!("{word} wants a number"))?;
            number.parse::<u64>().map_err(|_| format!("`{number}` is no number"))
        };
        match *word {
            "--programs" => options.programs = number()? as usize,
            "--seed" => options.seed = number()?,
            "--frame-origins" => options.language.frame_origins = true,
            other => return Err(format!("`{other}` is not understood")),
        }
    }
    Ok(options)
}

/// The results of all comparisons.
#[derive(Default)]
struct Tally {
    programs: usize,
    blocks: usize,
    same: usize,
    compensated: usize,
    known: BTreeMap<KnownDifference, usize>,
    both_refuse: BTreeMap<&'static str, usize>,
}

fn run(options: Options, rs274: &Rs274) -> Result<(), String> {
    let begun = Instant::now();
    let mut tally = Tally::default();
    while tally.programs < options.programs {
        let end = options.programs.min(tally.programs + AT_A_TIME);
        let programs: Vec<Program> = (tally.programs..end)
            .map(|index| generate::program(&mut Random::new(options.seed, index as u64), options.language))
            .collect();
        let theirs = rs274.run(&programs)?;
        for (program, theirs) in programs.iter().zip(&theirs) {
            let comparison = compare(program, &motion::ours(program)?, theirs);
            if comparison.failure.is_some() {
                return Err(failure(program, &comparison, tally.programs, options, rs274)?);
            }
            tally.add(program, &comparison);
        }
    }
    tally.print();
    println!("\nseed {}, {:.1} s", options.seed, begun.elapsed().as_secs_f64());
    Ok(())
}

impl Tally {
    fn add(&mut self, program: &Program, comparison: &Comparison) {
        self.programs += 1;
        self.blocks += program.blocks.len();
        self.same += comparison.same;
        self.compensated += comparison.compensated;
        for difference in &comparison.known {
            *self.known.entry(*difference).or_default() += 1;
        }
        if let Some(slug) = comparison.both_refuse {
            *self.both_refuse.entry(slug).or_default() += 1;
        }
    }

    fn print(&self) {
        println!("{:>8} programs, {} blocks", self.programs, self.blocks);
        println!(
            "{:>8} motions are the same, and {} elements under compensation",
            self.same, self.compensated
        );
        println!("\nrefused by both:");
        for (slug, count) in &self.both_refuse {
            println!("{count:>8} {slug}");
        }
        println!("\nknown differences:");
        for difference in KnownDifference::ALL {
            let count = self.known.get(&difference).copied().unwrap_or(0);
            println!("{count:>8} {}: {}", difference.name(), difference.explanation());
        }
    }
}

/// The smallest program with the same failure, with both outputs.
fn failure(
    program: &Program,
    comparison: &Comparison,
    index: usize,
    options: Options,
    rs274: &Rs274,
) -> Result<String, String> {
    let kind = |comparison: &Comparison| comparison.failure.as_ref().map(|failure| failure.what.clone());
    let wanted = kind(comparison);
    let both = |program: &Program| -> Result<_, String> {
        let mut theirs = rs274.run(std::slice::from_ref(program))?;
        Ok((motion::ours(program)?, theirs.pop().unwrap_or_default()))
    };
    let smallest = shrink::shrink(program, |candidate| {
        both(candidate).is_ok_and(|(ours, theirs)| kind(&compare(candidate, &ours, &theirs)) == wanted)
    });
    let (ours, theirs) = both(&smallest)?;
    let found = compare(&smallest, &ours, &theirs).failure.ok_or("the difference is gone on a second run")?;
    let mut text = format!(
        "program {index} of seed {}: {} differs in block {}\n{}\n\n--- ours\n{}{}\n\n",
        options.seed,
        found.what,
        found.block,
        found.detail,
        translate::ours(&smallest),
        translate::setup(&smallest),
    );
    for (block, motions) in &ours.motions {
        for motion in motions {
            text += &format!("block {block:<3} {motion:?}\n");
        }
    }
    if let Some((block, refusal)) = &ours.refused {
        text += &format!("block {block:<3} refused: {}, {:?}\n", refusal.slug, refusal.message);
    }
    text += &format!("\n--- LinuxCNC\n{}\n{}\n", translate::linuxcnc(&smallest, 0), theirs.lines.join("\n"));
    if let Some((block, message)) = &theirs.refused {
        text += &format!("block {block:<3} refused: {message}\n");
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn command_lines() {
        let options = |programs, seed| Options { programs, seed, language: Language::default() };
        assert_eq!(parse(&[]), Ok(options(10_000, 1)));
        assert_eq!(parse(&["--seed", "7", "--programs", "3"]), Ok(options(3, 7)));
        assert!(parse(&["--frame-origins"]).unwrap().language.frame_origins);
        assert!(parse(&["--seed"]).is_err());
        assert!(parse(&["--seed", "x"]).is_err());
        assert!(parse(&["more"]).is_err());
    }
}
