//! The command line: arguments in, text or JSON out.
//!
//! Exit status 0: no error in the program; 1: errors found; 2: bad usage or a file that cannot be read.

mod arguments;
mod clean;
mod compare;
mod embed;
mod encoding;
mod export;
mod fix;
mod inferred_stock;
mod manual;
mod manual_check;
mod options;
mod rewrite;
mod rules;
mod summary;
mod terminal;

use std::borrow::Cow;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use serde::Serialize;

use crate::api::{self, InFile, Places};
use crate::machine::SimulationResult;
use crate::message::{Diagnostic, Kind, Levels};
use crate::run::{Analysis, Run};
use crate::scene;
use crate::scene::face::Face;
use crate::scene::ruler::Scale;
use crate::scene::svg::SvgOptions;
use crate::sentences::Language;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, GSystem};
use crate::setup::profile;
use crate::source::LineIndex;

use arguments::{Arguments, Command};
use encoding::Encoding;
use fix::Target;
use options::{Format, Input, TurretName, ViewName, With};

/// A program that was read and run.
struct Program {
    name: String,
    /// As UTF-8: places in messages are counted in it.
    text: Vec<u8>,
    /// Of the file.
    encoding: Encoding,
    analysis: Analysis,
}

impl Program {
    /// The name of its file without folders, or with the innermost one where another file has the same name.
    fn name_beside(&self, other: &Program) -> String {
        let last = |name: &str, parts: usize| {
            let mut parts: Vec<&str> = name.rsplit(['/', '\\']).take(parts).collect();
            parts.reverse();
            parts.join("/")
        };
        let parts = if last(&self.name, 1) == last(&other.name, 1) { 2 } else { 1 };
        last(&self.name, parts)
    }
}

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    match run(Arguments::parse().command) {
        Ok(code) => code,
        Err(problem) => {
            eprintln!("gcode-playground: {problem}");
            ExitCode::from(2)
        }
    }
}

fn run(command: Command) -> Result<ExitCode, String> {
    match command {
        Command::Clean(clean) => {
            clean::run(&clean)?;
            Ok(ExitCode::SUCCESS)
        }
        Command::Check { files, with, texts, form, markdown: true, .. } => {
            manual_check::files(&files, &with, texts.language(), form.format)
        }
        Command::Check { files, with, texts, form, fix: true, dry_run, .. } => fix::files(
            &files,
            &with,
            texts.language(),
            form.format,
            if dry_run { Target::Output } else { Target::File },
        ),
        Command::Check { files, with, texts, form, .. } => {
            check(&files, &with, texts.language(), form.format)
        }
        Command::Embed(embed) => embed::run(&embed),
        Command::Motions(input) => {
            let program = program(&input)?;
            print(|out| {
                for row in api::motions(&program.analysis.motions, &program.analysis.setup.machine) {
                    write_row(out, &row)?;
                }
                Ok(())
            })?;
            Ok(status(&program.analysis))
        }
        Command::Expand { input, to } => {
            let program = program_run(&input, Run::traced)?;
            let expanded = crate::expand::write_out(&program.text, &program.analysis);
            save(to.file(), &encoded(&program, &expanded))?;
            Ok(status(&program.analysis))
        }
        Command::Rewrite { input, texts, to } => rewrite::write(&input, texts.language(), to.file()),
        Command::Codes { control, texts, form } => {
            let list = control.map(|name| CodeList::new(name.control(), GSystem::A));
            print(|out| codes(out, list, texts.language(), form.format))?;
            Ok(ExitCode::SUCCESS)
        }
        Command::Rules { setup, texts, form } => {
            let levels = setup_of(&With { setup, control: None })?.rules;
            print(|out| rules::write(out, &levels, texts.language(), form.format))?;
            Ok(ExitCode::SUCCESS)
        }
        Command::Part(input) => {
            let program = program(&input)?;
            let simulation = program.analysis.simulate();
            let finished = simulation.finished();
            if finished.is_none() {
                eprintln!(
                    "gcode-playground: {}: no part: {}",
                    program.name,
                    why_no_part(&program, &simulation)
                );
            }
            let part = finished.map(|region| api::Part::new(&region)).unwrap_or_default();
            print(|out| write_row(out, &part))?;
            Ok(status(&program.analysis))
        }
        Command::Summary { input, form } => {
            let program = program(&input)?;
            print(|out| {
                summary::write(out, &program.analysis, form.format)?;
                inferred_stock::write(out, &program, Language::English, form.format)
            })?;
            Ok(status(&program.analysis))
        }
        Command::Export { format, input, lang, to } => {
            let language = export::language(format, lang)?;
            let program = program_run(&input, |run| if format.needs_trace() { run.traced() } else { run })?;
            save(to.file(), &export::file(&program, format, language)?)?;
            Ok(status(&program.analysis))
        }
        Command::Compare { first, second, with, form, output } => {
            let read = |file: &Path| program_with(file, &with, |run| run);
            let programs = [read(&first)?, read(&second)?];
            let compared = compare::Compared::of([&programs[0], &programs[1]])
                .ok_or("there is nothing to compare: name a stock in the setup")?;
            print(|out| compared.write(out, form.format))?;
            if let Some(output) = output {
                save(Some(&output), compared.svg().as_bytes())?;
            }
            Ok(ExitCode::from(u8::from(programs.iter().any(|program| has_errors(&program.analysis)))))
        }
        Command::Svg { input, view, turret, to } => {
            let program = program(&input)?;
            let svg = svg(&program, view, turret)?;
            save(to.file(), svg.as_bytes())?;
            Ok(status(&program.analysis))
        }
    }
}

/// Why there is no part of a program.
fn why_no_part(program: &Program, simulation: &SimulationResult) -> String {
    let Analysis { motions, diagnostics, .. } = &program.analysis;
    let told = crate::findings::diagnostics(simulation, motions, &Levels::default(), diagnostics);
    let why = told.iter().find(|told| told.message.kind() == Kind::Unsupported);
    why.map_or_else(|| "nothing is cut".to_owned(), |told| told.message.sentence(Language::English).message)
}

/// The picture of a program.
fn svg(program: &Program, view: ViewName, turret: Option<TurretName>) -> Result<String, String> {
    let Analysis { motions, setup, .. } = &program.analysis;
    let turret = turret.map_or(setup.machine.turret, TurretName::turret);
    let simulation = program.analysis.simulate();
    let scale = Scale::of(program.analysis.unit);
    match view {
        ViewName::Section => {
            let options =
                SvgOptions { x_plus: turret.into(), ..export::svg_options(program, Language::English) };
            Ok(scene::svg::section(motions, Some(&simulation), &options))
        }
        ViewName::Face => {
            let face = Face::of(motions, &simulation).ok_or_else(|| {
                format!("{}: nothing moves on the end face: there is no G12.1", program.name)
            })?;
            let work = face.work(&simulation, None);
            Ok(scene::svg::svg(
                &face.scene(work.as_ref()),
                &SvgOptions { width: 720.0, scale, ..SvgOptions::default() },
            ))
        }
    }
}

fn check(files: &[PathBuf], with: &With, language: Language, format: Format) -> Result<ExitCode, String> {
    let mut any_error = false;
    for file in files {
        let program = program_with(file, with, |run| run)?;
        any_error |= has_errors(&program.analysis);
        print(|out| {
            tell(out, &program, language, format)?;
            inferred_stock::write(out, &program, language, format)
        })?;
    }
    Ok(ExitCode::from(u8::from(any_error)))
}

/// Writes the messages of a program.
fn tell(out: &mut dyn Write, program: &Program, language: Language, format: Format) -> io::Result<()> {
    let places = Places { text: &program.text, lines: &LineIndex::new(&program.text) };
    tell_at(out, &program.name, places, &program.analysis.diagnostics, language, format)
}

/// Writes messages about places of a file.
fn tell_at(
    out: &mut dyn Write,
    name: &str,
    places: Places<'_>,
    found: &[Diagnostic],
    language: Language,
    format: Format,
) -> io::Result<()> {
    match format {
        Format::Json => found.iter().try_for_each(|diagnostic| {
            let row = places.diagnostic(diagnostic, language);
            write_row(out, &InFile { file: name, row })
        }),
        Format::Text => {
            let Places { text, lines } = places;
            out.write_all(terminal::render(name, text, lines, found, language).as_bytes())
        }
    }
}

/// The table of supported codes: of one list, or of all.
fn codes(out: &mut dyn Write, only: Option<CodeList>, language: Language, format: Format) -> io::Result<()> {
    let table = api::codes(only.unwrap_or_default(), language);
    if format == Format::Text {
        let shown = if only.is_some() { 1 } else { table.columns.len() };
        let names = table.columns[..shown].iter().map(|column| column.name);
        writeln!(out, "{}", cells(names).trim_end())?;
    }
    let mut section = "";
    for row in table.rows {
        if only.is_some_and(|list| row.codes(list).is_empty()) {
            continue;
        }
        if format == Format::Json {
            write_row(out, &row)?;
            continue;
        }
        if section != row.section {
            if !section.is_empty() {
                writeln!(out)?;
            }
            section = row.section;
            writeln!(out, "{section}")?;
        }
        let codes = match only {
            Some(list) => cells([row.codes(list)]),
            None => cells(CodeList::ALL.map(|list| row.printed(list))),
        };
        let comma = if row.note.is_empty() { "" } else { "; " };
        writeln!(out, "{codes} {}{comma}{}", row.does, row.note)?;
    }
    Ok(())
}

/// The first cells of a line of the table, one for each list of codes.
fn cells<'a>(of: impl IntoIterator<Item = &'a str>) -> String {
    const WIDTHS: [usize; CodeList::ALL.len()] = [30, 8, 8, 4];
    of.into_iter()
        .zip(WIDTHS)
        .fold(String::from(" "), |line, (cell, width)| line + &format!(" {cell:<width$}"))
}

fn program(input: &Input) -> Result<Program, String> {
    program_run(input, |run| run)
}

/// Reads and runs a program; `begin` may change how.
fn program_run(input: &Input, begin: impl FnOnce(Run) -> Run) -> Result<Program, String> {
    program_with(&input.file, &input.with, begin)
}

/// The same with a file and a setup of their own.
fn program_with(file: &Path, with: &With, begin: impl FnOnce(Run) -> Run) -> Result<Program, String> {
    let setup = setup_of(with)?;
    let (name, text) = read(file)?;
    let (text, encoding) = encoding::decode(text);
    Ok(run_text(name, text, encoding, setup, begin))
}

/// Runs a program that was read; `begin` may change how.
fn run_text(
    name: String,
    text: Vec<u8>,
    encoding: Encoding,
    setup: Setup,
    begin: impl FnOnce(Run) -> Run,
) -> Program {
    let mut run = begin(Run::new(text.clone(), setup));
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    Program { name, text, encoding, analysis }
}

/// The setup that is named.
fn setup_of(with: &With) -> Result<Setup, String> {
    let mut setup = profile::joined(&setup_texts(with)?)?;
    if let Some(control) = with.control {
        setup.dialect.control = Some(control.control());
    }
    Ok(setup)
}

/// The setups that are named, as JSON; each can be read.
fn setup_texts(with: &With) -> Result<Vec<String>, String> {
    let mut setups = Vec::new();
    for path in &with.setup {
        let at = |error: String| format!("{}: {error}", path.display());
        let json = std::fs::read_to_string(path).map_err(|error| at(error.to_string()))?;
        Setup::from_json(&json).map_err(at)?;
        setups.push(json);
    }
    Ok(setups)
}

/// A text made from a program, in the encoding of the program's file.
fn encoded<'a>(program: &Program, text: &'a str) -> Cow<'a, [u8]> {
    program.encoding.encode(text).unwrap_or_else(|| {
        let (name, encoding) = (&program.name, program.encoding.name());
        eprintln!(
            "gcode-playground: {name}: not every character has a place in {encoding}: written as UTF-8"
        );
        Cow::Borrowed(text.as_bytes())
    })
}

fn read(file: &Path) -> Result<(String, Vec<u8>), String> {
    if file == Path::new("-") {
        let mut text = Vec::new();
        io::stdin().read_to_end(&mut text).map_err(|error| format!("standard input: {error}"))?;
        return Ok(("<stdin>".into(), text));
    }
    let name = file.display().to_string();
    let text = std::fs::read(file).map_err(|error| format!("{name}: {error}"))?;
    Ok((name, text))
}

/// Writes to a file, or to standard output.
fn save(path: Option<&Path>, content: &[u8]) -> Result<(), String> {
    match path {
        None => print(|out| out.write_all(content)),
        Some(path) => std::fs::write(path, content).map_err(|error| format!("{}: {error}", path.display())),
    }
}

/// Writes to standard output; a reader that went away (`| head`) is no error.
fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), String> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(format!("standard output: {error}")),
        _ => Ok(()),
    }
}

fn write_row(out: &mut dyn Write, row: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *out, row)?;
    out.write_all(b"\n")
}

fn has_errors(analysis: &Analysis) -> bool {
    analysis.diagnostics.iter().any(|diagnostic| diagnostic.is_error())
}

fn status(analysis: &Analysis) -> ExitCode {
    ExitCode::from(u8::from(has_errors(analysis)))
}
