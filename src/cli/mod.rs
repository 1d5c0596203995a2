//! The command line: arguments in, text or JSON out.
//!
//! Exit status 0: no error in the program; 1: errors found; 2: bad usage, or a file that cannot be read or
//! written. The same program runs natively and under Node; `system` hides the difference.

mod arguments;
mod change;
mod check;
mod clean;
mod compare;
mod configuration;
mod convert;
mod diff;
mod embed;
mod encoding;
mod explain;
mod export;
mod format;
mod grade;
mod inferred_stock;
mod manual;
mod manual_page;
mod markdown;
mod options;
mod renumber;
mod rewrite;
mod rule_page;
mod rules;
mod schema;
#[cfg(not(target_arch = "wasm32"))]
mod server;
mod status;
mod subprograms;
mod summary;
mod system;
mod target;
mod terminal;
mod unified;

use std::borrow::Cow;
use std::io::{self, ErrorKind, Write};
use std::path::Path;

#[cfg(not(target_arch = "wasm32"))]
use clap::CommandFactory;
use clap::Parser;
use serde::Serialize;

use crate::api;
use crate::export::figure::Subject;
use crate::export::file::FileFormat;
use crate::figures;
use crate::limits;
use crate::machine::SimulationResult;
use crate::message::{Kind, Levels};
use crate::run::{Analysis, Run};
use crate::scene;
use crate::scene::annotation::Annotation;
use crate::scene::face::Face;
use crate::scene::ruler::Scale;
use crate::scene::side::Side;
use crate::scene::surface_moves::SurfaceMoves;
use crate::scene::svg::SvgOptions;
use crate::scene::work::Work;
use crate::sentences::Language;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, GSystem};

use arguments::{Arguments, Command};
use configuration::Configurations;
use encoding::Encoding;
use options::{Format, Input, ProgramOptions, TurretName, ViewName};
pub use status::Status;
use system::{Stream, print_error_line};

/// A program after its run.
struct Program {
    name: String,
    /// UTF-8; spans of messages are byte offsets into it.
    text: Vec<u8>,
    /// Encoding of the file.
    encoding: Encoding,
    analysis: Analysis,
}

impl Program {
    /// The file name without folders, or with the innermost folder if `other` has the same file name.
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

/// Name of the command.
const NAME: &str = "gcode-playground";

/// Runs the command line of this process and returns its exit status.
pub fn main() -> Status {
    #[cfg(not(target_arch = "wasm32"))]
    system::report_size_limit();
    let done = match Arguments::try_parse_from(system::arguments()) {
        Ok(arguments) => run(arguments.command),
        Err(said) => return usage(&said),
    };
    done.unwrap_or_else(|problem| {
        print_error_line(format_args!("{NAME}: {problem}"));
        Status::Unusable
    })
}

/// Runs the command line under Node and sets the exit status of the process.
#[cfg(target_arch = "wasm32")]
pub fn main_in_node() {
    system::end(main() as u8);
}

/// Writes an error about the arguments, or the requested help.
fn usage(said: &clap::Error) -> Status {
    let (stream, status) = match said.use_stderr() {
        true => (Stream::Error, Status::Unusable),
        false => (Stream::Output, Status::Right),
    };
    let text = said.render();
    let plain = text.to_string();
    let is_coloured = system::is_terminal(stream)
        && system::variable("NO_COLOR").is_none()
        && !plain.contains(crate::source::is_unprintable);
    let text = if is_coloured {
        text.ansi().to_string().into()
    } else {
        terminal::without_commands(plain.as_bytes())
    };
    // A closed pipe is not an error.
    let _ = system::stream(stream).write_all(&text);
    status
}

fn run(command: Command) -> Result<Status, String> {
    match command {
        Command::Clean(clean) => {
            clean::run(&clean)?;
            Ok(Status::Right)
        }
        Command::Check(arguments) => check::run(&arguments),
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
        Command::Expand { input, destination } => {
            let program = program_run(&input, Run::traced)?;
            save(destination.file(), &export::expanded(&program))?;
            Ok(status(&program.analysis))
        }
        Command::Rewrite { input, texts, destination } => {
            rewrite::write(&input, texts.language(), destination.file())
        }
        Command::Format(format) => format::run(&format),
        Command::Renumber(renumber) => renumber::run(&renumber),
        Command::Convert(convert) => convert::run(&convert),
        Command::Codes { control, texts, form } => {
            let list = control.map(|name| CodeList::new(name.control(), GSystem::A));
            print(|out| codes(out, list, texts.language(), form.format))?;
            Ok(Status::Right)
        }
        Command::Rules { setup, texts, form } => {
            let levels =
                setup_of(Path::new("program"), &ProgramOptions { setup, ..ProgramOptions::default() })?.rules;
            print(|out| rules::write(out, &levels, texts.language(), form.format))?;
            Ok(Status::Right)
        }
        Command::Explain { rule, texts, format } => {
            let mut page = Vec::new();
            explain::write(&mut page, &rule, texts.language(), format)?
                .expect("memory takes all that is written");
            print(|out| out.write_all(&page))?;
            Ok(Status::Right)
        }
        Command::Schema { of } => {
            print(|out| writeln!(out, "{:#}", schema::schema(of)))?;
            Ok(Status::Right)
        }
        Command::Config(asked) => configuration::shown::run(&asked),
        #[cfg(not(target_arch = "wasm32"))]
        Command::Server(arguments) => server::run(&arguments),
        #[cfg(not(target_arch = "wasm32"))]
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), NAME, &mut script);
            print(|out| out.write_all(&script))?;
            Ok(Status::Right)
        }
        #[cfg(not(target_arch = "wasm32"))]
        Command::ManPage => {
            print(|out| clap_mangen::Man::new(Arguments::command()).render(out))?;
            Ok(Status::Right)
        }
        Command::Part(input) => {
            let program = program(&input)?;
            let simulation = program.analysis.simulate();
            let finished = simulation.finished();
            if finished.is_none() {
                print_error_line(format_args!(
                    "{NAME}: {}: no part: {}",
                    program.name,
                    why_no_part(&program, &simulation)
                ));
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
        Command::Export { format, input, lang, destination } => {
            let language = export::language(format, lang)?;
            let program = program_run(&input, |run| if format.needs_trace() { run.traced() } else { run })?;
            let file = export::file(&program, format, language)?;
            match format {
                FileFormat::Program => save(destination.file(), &file)?,
                _ => save_apart(destination.file(), &file)?,
            }
            Ok(status(&program.analysis))
        }
        Command::Compare { first, second, with, form, output } => {
            let read = |file: &Path| program_with(file, &with, |run| run);
            let programs = [read(&first)?, read(&second)?];
            let compared = compare::Compared::of([&programs[0], &programs[1]])
                .ok_or("there is nothing to compare: name a stock in the setup")?;
            print(|out| compared.write(out, form.format))?;
            if let Some(output) = output {
                save_apart(Some(&output), compared.svg().as_bytes())?;
            }
            Ok(Status::faulty_if(programs.iter().any(|program| has_errors(&program.analysis))))
        }
        Command::Diff(arguments) => diff::run(&arguments),
        Command::Grade(arguments) => grade::run(&arguments),
        Command::Target { input, destination } => {
            let program = program(&input)?;
            save_apart(destination.file(), target::blocks(&program)?.as_bytes())?;
            Ok(status(&program.analysis))
        }
        Command::Svg { input, view, turret, figure, print, destination } => {
            let program = program(&input)?;
            let svg = svg(&program, view, turret, figure, print)?;
            save_apart(destination.file(), svg.as_bytes())?;
            Ok(status(&program.analysis))
        }
    }
}

/// The reason why a program has no simulated part.
fn why_no_part(program: &Program, simulation: &SimulationResult) -> String {
    let Analysis { motions, diagnostics, .. } = &program.analysis;
    let told = crate::findings::diagnostics(simulation, motions, &Levels::default(), diagnostics);
    let why = told.iter().find(|told| told.message.kind() == Kind::Unsupported);
    why.map_or_else(
        || "nothing is turned".to_owned(),
        |told| told.message.sentence(Language::English).message,
    )
}

/// Renders a program as SVG.
fn svg(
    program: &Program,
    view: ViewName,
    turret: Option<TurretName>,
    figure: Option<Subject>,
    print: Option<u16>,
) -> Result<String, String> {
    let Analysis { motions, setup, .. } = &program.analysis;
    let turret = turret.map_or(setup.machine.turret, TurretName::turret);
    let simulation = program.analysis.simulate();
    let of_surface = |moves: &SurfaceMoves, work: Option<Work>, annotations: Vec<Annotation>| {
        let scale = Scale::of(program.analysis.unit);
        scene::svg::svg(
            &moves.scene(work.as_ref()),
            &on_paper(print, SvgOptions { width: 720.0, scale, annotations, ..SvgOptions::default() }),
        )
    };
    match view {
        ViewName::Section => {
            if let Some(chart) = export::speed_chart(program, |options| on_paper(print, options)) {
                return Ok(chart);
            }
            let options = SvgOptions {
                x_plus: turret.into(),
                ..figure_options(program, &simulation, figure, Language::English)
            };
            Ok(scene::svg::section(motions, Some(&simulation), &on_paper(print, options)))
        }
        ViewName::Face => {
            let face = Face::of(motions, &simulation)
                .ok_or_else(|| format!("{}: nothing is milled or drilled on the end face", program.name))?;
            let is_figure = matches!(figure, Some(Subject::Cycle { .. }));
            let annotations = if is_figure { figures::of_face(face.moves()) } else { Vec::new() };
            Ok(of_surface(face.moves(), face.work(&simulation, None), annotations))
        }
        ViewName::Side => {
            let side = Side::of(motions, &simulation)
                .ok_or_else(|| format!("{}: nothing is milled or drilled on the side", program.name))?;
            Ok(of_surface(side.moves(), side.work(&simulation, None), Vec::new()))
        }
    }
}

/// The options of a picture for paper, if its width on paper is given, mm.
fn on_paper(print: Option<u16>, options: SvgOptions) -> SvgOptions {
    match print {
        Some(width) => options.on_paper(f64::from(width)),
        None => options,
    }
}

/// The finished run of a program.
fn finished(program: &Program) -> Run {
    Run::finished(program.text.clone(), program.analysis.setup.clone())
}

/// The options of a section with the annotations of a figure.
fn figure_options(
    program: &Program,
    simulation: &SimulationResult,
    figure: Option<Subject>,
    language: Language,
) -> SvgOptions {
    let options = export::svg_options(program, language);
    match figure {
        None => options,
        Some(subject) => {
            subject.options(options, || finished(program), simulation, &program.analysis.motions)
        }
    }
}

/// Writes the table of supported codes, for one list of codes or for all.
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

/// The first cells of a table row, one for each list of codes, padded to the column widths.
fn cells<'a>(of: impl IntoIterator<Item = &'a str>) -> String {
    const WIDTHS: [usize; CodeList::ALL.len()] = [30, 8, 8, 4];
    of.into_iter()
        .zip(WIDTHS)
        .fold(String::from(" "), |line, (cell, width)| line + &format!(" {cell:<width$}"))
}

fn program(input: &Input) -> Result<Program, String> {
    program_run(input, |run| run)
}

/// Reads and runs a program; `begin` may modify the run before it starts.
fn program_run(input: &Input, begin: impl FnOnce(Run) -> Run) -> Result<Program, String> {
    program_with(&input.file, &input.with, begin)
}

/// Like [`program_run`], with file and setup options given separately.
fn program_with(
    file: &Path,
    with: &ProgramOptions,
    begin: impl FnOnce(Run) -> Run,
) -> Result<Program, String> {
    let configurations = Configurations::new(with)?;
    let setup = configurations.settings(file)?.setup.clone();
    let (name, text) = read(file)?;
    let (text, encoding) = encoding::decode(text);
    let joined = subprograms::join(&text, &configurations.libraries(file)?, setup.limits.text);
    let text = joined.map_or(text, |joined| joined.text);
    Ok(run_text(name, text, encoding, setup, begin))
}

/// Runs a program that was already read; `begin` may modify the run before it starts.
fn run_text(
    name: String,
    text: Vec<u8>,
    encoding: Encoding,
    setup: Setup,
    begin: impl FnOnce(Run) -> Run,
) -> Program {
    let mut program = run_at_control(name, text, encoding, setup, begin);
    program.analysis.check_at_machine();
    program
}

/// Like [`run_text`], but without the machine stage.
fn run_at_control(
    name: String,
    text: Vec<u8>,
    encoding: Encoding,
    setup: Setup,
    begin: impl FnOnce(Run) -> Run,
) -> Program {
    let mut run = begin(Run::new(text.clone(), setup));
    while !run.advance(usize::MAX) {}
    Program { name, text, encoding, analysis: run.into_analysis() }
}

/// The setup for a program: its configuration, overridden by the options.
fn setup_of(file: &Path, with: &ProgramOptions) -> Result<Setup, String> {
    Ok(Configurations::new(with)?.settings(file)?.setup.clone())
}

/// Encodes text derived from a program in the encoding of the program's file.
fn encoded<'a>(program: &Program, text: &'a str) -> Cow<'a, [u8]> {
    program.encoding.encode(text).unwrap_or_else(|| {
        let (name, encoding) = (&program.name, program.encoding.name());
        print_error_line(format_args!(
            "{NAME}: {name}: not every character has a place in {encoding}: written as UTF-8"
        ));
        Cow::Borrowed(text.as_bytes())
    })
}

/// Reads a file, or standard input.
fn read(file: &Path) -> Result<(String, Vec<u8>), String> {
    read_within(file, limits::TEXT_BUFFER as u64)
}

/// Reads a file, or standard input, of at most `most` bytes. A larger file is refused before it is read.
fn read_within(file: &Path, most: u64) -> Result<(String, Vec<u8>), String> {
    let is_standard_input = file == Path::new("-");
    let name = if is_standard_input { "standard input".to_owned() } else { terminal::printable_name(file) };
    let read = if is_standard_input { system::read_standard_input(most) } else { system::read(file, most) };
    match read {
        Ok(text) => Ok((if is_standard_input { "<stdin>".to_owned() } else { name }, text)),
        Err(error) if error.kind() == ErrorKind::FileTooLarge => {
            Err(format!("{name}: more than {} MB, the most that a program may have", most >> 20))
        }
        Err(error) => Err(format!("{name}: {}", system::reason(&error))),
    }
}

/// Writes a program or another file to `path`, or to standard output if `None`. On a terminal, control
/// characters are masked; everywhere else the output is byte for byte.
fn save(path: Option<&Path>, content: &[u8]) -> Result<(), String> {
    let stream = path.map_or(Some(Stream::Output), system::standard);
    match (stream, path) {
        (Some(stream), _) if system::is_terminal(stream) => print_to(stream, |out| out.write_all(content)),
        (None, Some(path)) => system::write(path, content),
        _ => print_bytes(stream.unwrap_or(Stream::Output), |out| out.write_all(content)),
    }
}

/// Like [`save`], for pictures, tables and reports: never overwrites a file that this command has read.
fn save_apart(path: Option<&Path>, content: &[u8]) -> Result<(), String> {
    match path.filter(|path| system::was_read(path)) {
        Some(path) => {
            Err(format!("{}: is read by this command, so nothing else is written into it", path.display()))
        }
        None => save(path, content),
    }
}

/// Writes to standard output, with the control characters of programs masked.
fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), String> {
    print_to(Stream::Output, write)
}

/// Like [`print()`], for any stream.
fn print_to(to: Stream, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), String> {
    // `BufWriter` passes on whole writes, so no UTF-8 character is split.
    print_bytes(to, |out| {
        let mut out = io::BufWriter::with_capacity(1 << 16, terminal::Masked(out));
        write(&mut out)?;
        out.flush()
    })
}

/// Writes bytes unchanged to a stream; a closed pipe (`| head`) is not an error.
fn print_bytes(to: Stream, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), String> {
    let mut out = io::BufWriter::with_capacity(1 << 16, system::stream(to));
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("standard output: {}", system::reason(&error)))
        }
        _ => Ok(()),
    }
}

/// `1 program`, `2 programs`.
fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn write_row(out: &mut dyn Write, row: &impl Serialize) -> io::Result<()> {
    writeln!(out, "{}", terminal::json(row)?)
}

fn has_errors(analysis: &Analysis) -> bool {
    analysis.diagnostics.iter().any(|diagnostic| diagnostic.is_error())
}

fn status(analysis: &Analysis) -> Status {
    Status::faulty_if(has_errors(analysis))
}
