//! The arguments of the command line.
//!
//! In: the arguments of the process. Out: [`Command`]. Options that several commands share are in `options`.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::options::{
    ControlName, Destination, Input, LanguageName, LanguageOptions, OutputFormat, PageFormat, ProgramOptions,
    TurretName, ViewName,
};
use super::schema::SchemaOf;
#[cfg(not(target_arch = "wasm32"))]
use super::server;
use super::{check, clean, configuration, convert, diff, embed, format, grade, renumber};
use crate::export::figure::Subject;
use crate::export::file::FileFormat;

/// A lathe G-code playground: toolpaths and messages for FANUC and GSK turning programs.
#[derive(Parser)]
#[command(version)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Check programs and report what is wrong with them.
    Check(check::Check),
    /// Find the programs in a text (of a PDF, a slide, a forum) and print one of them, cleaned up.
    Clean(clean::Clean),
    /// Write a program as the element `<gcode-playground>` for a page, with its picture for readers without
    /// JavaScript; or check the pictures that pages have.
    Embed(embed::Embed),
    /// Print every motion as one JSON object per line.
    Motions(Input),
    /// Write the program out with every cycle, corner and compensation as plain moves.
    Expand {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        destination: Destination,
    },
    /// Replace plain moves that form a cycle with the cycle, for example the four moves of G90. The motions
    /// stay the same.
    Rewrite {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        texts: LanguageOptions,
        #[command(flatten)]
        destination: Destination,
    },
    /// Format spaces, letter case and leading zeros of G and M codes. The motions stay the same.
    Format(format::Format),
    /// Write new sequence numbers (N); P, Q, GOTO and M99 P are updated. The motions stay the same.
    Renumber(renumber::Renumber),
    /// Write coordinates or arcs in another form: U and W as X and Z, R as I and K, or back. The motions stay
    /// the same.
    Convert(convert::Convert),
    /// List the codes that are supported.
    Codes {
        /// Only those of this control, as it writes them.
        #[arg(long, value_enum)]
        control: Option<ControlName>,
        #[command(flatten)]
        texts: LanguageOptions,
        #[command(flatten)]
        form: OutputFormat,
    },
    /// List the rules: slug, severity, code, alarm, category.
    Rules {
        /// A setup whose `rules` set severities.
        #[arg(long)]
        setup: Vec<PathBuf>,
        #[command(flatten)]
        texts: LanguageOptions,
        #[command(flatten)]
        form: OutputFormat,
    },
    /// Explain a rule: what it looks at, why, and what to do, with an example.
    Explain {
        /// Its name, or the code that its messages show (`PS0010`).
        rule: String,
        #[command(flatten)]
        texts: LanguageOptions,
        /// Text for people, one JSON object for each rule, or Markdown for a page.
        #[arg(long, value_enum, default_value = "text")]
        format: PageFormat,
    },
    /// Print the JSON Schema of a setup or of a configuration, for editors.
    Schema {
        /// The kind of file.
        of: SchemaOf,
    },
    /// Show the effective settings for a program, and the file or option each one comes from.
    Config(configuration::shown::Config),
    /// Run a language server (LSP) on standard input and output.
    #[cfg(not(target_arch = "wasm32"))]
    Server(server::Serve),
    /// Print the completion script of a shell.
    #[cfg(not(target_arch = "wasm32"))]
    Completions {
        /// The shell.
        #[arg(value_enum)]
        shell: clap_complete::Shell,
    },
    /// Print the manual page, as `man` reads it.
    #[cfg(not(target_arch = "wasm32"))]
    ManPage,
    /// Print the finished part as JSON: the half-section as polygons of [z, x], x a diameter.
    Part(Input),
    /// Print the time, cutting length and extents for each tool, and in total.
    Summary {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        form: OutputFormat,
    },
    /// Export a program as a table, setup sheet, profile or solid.
    Export {
        /// What to write.
        #[arg(value_enum)]
        format: FileFormat,
        #[command(flatten)]
        input: Input,
        /// Language of the texts in `svg` and `card`, English by default; not allowed with other formats.
        #[arg(long, visible_alias = "language", value_enum)]
        lang: Option<LanguageName>,
        #[command(flatten)]
        destination: Destination,
    },
    /// Compare the parts of two programs, and measure the differences.
    Compare {
        /// The first program.
        first: PathBuf,
        /// The second program.
        second: PathBuf,
        #[command(flatten)]
        with: ProgramOptions,
        #[command(flatten)]
        form: OutputFormat,
        /// Where to write a picture of the differences, as SVG.
        #[arg(short, long)]
        output: Option<PathBuf>,
    },
    /// Compare two versions of a program: the changed blocks, and how each changes the motions.
    Diff(diff::Diff),
    /// Run the answers to an exercise, and list which make the required part and pass its checks.
    Grade(grade::Grade),
    /// Write the target part of an exercise from a program: its outline with tolerances, and its setup.
    Target {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        destination: Destination,
    },
    /// Draw the toolpath as SVG.
    Svg {
        #[command(flatten)]
        input: Input,
        /// The half-section, or the end face with what is milled there under polar interpolation or along Y, and drilled; or the side, unrolled.
        #[arg(long, value_enum, default_value = "section")]
        view: ViewName,
        /// Which side of the spindle the turret is on; X+ is drawn there. Default: that of the setup.
        #[arg(long, value_enum)]
        turret: Option<TurretName>,
        /// Dimensions and letters over the half-section: `cycle` or `cycle:LINE`, `part`, `nose`, or `word:LINE:COLUMN`.
        #[arg(long, value_parser = Subject::parse)]
        figure: Option<Subject>,
        /// Draw for a printed page, in black and without rulers; the value is the width on paper in mm.
        #[arg(long, value_parser = clap::value_parser!(u16).range(40..=400))]
        print: Option<u16>,
        #[command(flatten)]
        destination: Destination,
    },
}
