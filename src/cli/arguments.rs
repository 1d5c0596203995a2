//! The arguments of the command line.
//!
//! In: what is typed. Out: [`Command`]. What several commands take is in `options`.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::options::{
    ControlName, Destination, Form, Input, LanguageName, Texts, TurretName, ViewName, With,
};
use super::{clean, embed};
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
    Check {
        /// Programs; `-` reads standard input.
        #[arg(required = true)]
        files: Vec<PathBuf>,
        #[command(flatten)]
        with: With,
        #[command(flatten)]
        texts: Texts,
        #[command(flatten)]
        form: Form,
        /// Make all repairs that do not change what the program does, and write the files back;
        /// what is left is reported.
        #[arg(long)]
        fix: bool,
        /// The files are pages of a manual (Markdown, HTML or reStructuredText, by their endings): every program
        /// in them is checked, and messages name its place in the page.
        #[arg(long, conflicts_with = "fix")]
        markdown: bool,
        /// With `--fix`: print the repaired programs instead, and report what is left on standard error.
        #[arg(long, requires = "fix")]
        dry_run: bool,
    },
    /// Find the programs in a text (of a PDF, a slide, a forum) and write one of them out, cleaned.
    Clean(clean::Clean),
    /// Write a program as the element `<gcode-playground>` for a page, with its picture for readers without
    /// JavaScript; or check the pictures that pages have.
    Embed(embed::Embed),
    /// Print every motion as one JSON object a line.
    Motions(Input),
    /// Write the program out with every cycle, corner and compensation as plain moves.
    Expand {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        to: Destination,
    },
    /// Write plain moves that form a cycle as that cycle (the four moves of a G90, say);
    /// the motions stay the same.
    Rewrite {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        texts: Texts,
        #[command(flatten)]
        to: Destination,
    },
    /// List the codes that are supported.
    Codes {
        /// Only those of this control, as it writes them.
        #[arg(long, value_enum)]
        control: Option<ControlName>,
        #[command(flatten)]
        texts: Texts,
        #[command(flatten)]
        form: Form,
    },
    /// List the rules: slug, severity, code, alarm, category.
    Rules {
        /// A setup whose `rules` set severities.
        #[arg(long)]
        setup: Vec<PathBuf>,
        #[command(flatten)]
        texts: Texts,
        #[command(flatten)]
        form: Form,
    },
    /// Print what is left of the blank as JSON: the half-section as polygons of [z, x], x a diameter.
    Part(Input),
    /// Add up time, cutting length and extents for each tool.
    Summary {
        #[command(flatten)]
        input: Input,
        #[command(flatten)]
        form: Form,
    },
    /// Write a file for people or other programs: table, setup sheet, profile, solid.
    Export {
        /// What to write.
        #[arg(value_enum)]
        format: FileFormat,
        #[command(flatten)]
        input: Input,
        /// Language of the texts in `svg` and `card`, English when left out; the other formats take none.
        #[arg(long, visible_alias = "language", value_enum)]
        lang: Option<LanguageName>,
        #[command(flatten)]
        to: Destination,
    },
    /// Lay the parts of two programs over each other, and measure where they differ.
    Compare {
        /// The first program.
        first: PathBuf,
        /// The second program.
        second: PathBuf,
        #[command(flatten)]
        with: With,
        #[command(flatten)]
        form: Form,
        /// Where to write a picture of the differences, as SVG.
        #[arg(short, long)]
        output: Option<PathBuf>,
    },
    /// Draw the toolpath as SVG.
    Svg {
        #[command(flatten)]
        input: Input,
        /// The half-section, or the end face with what polar interpolation mills there.
        #[arg(long, value_enum, default_value = "section")]
        view: ViewName,
        /// Which side of the spindle the turret is on; X+ is drawn there. That of the setup when left out.
        #[arg(long, value_enum)]
        turret: Option<TurretName>,
        #[command(flatten)]
        to: Destination,
    },
}
