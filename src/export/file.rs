//! Exports a file of any format, for the page and the command line.
//!
//! In: a format, an analysed program, a language. Out: the bytes of the file. For a new format, add a variant
//! to [`FileFormat`]; the compiler reports what else it needs. Must not know: path and name of the file.

use super::card::{self, Card};
use super::{csv, dxf, stl};
use crate::figures;
use crate::machine::SimulationResult;
use crate::machine::region::Region;
use crate::motion::Motions;
use crate::run::Run;
use crate::scene::annotation::Annotation;
use crate::scene::camera::XPlus;
use crate::scene::ruler::Scale;
use crate::scene::svg::{Caption, Contents, Ground, Passes, SvgOptions, section, svg};
use crate::sentences::{Language, labels};
use crate::setup::Setup;
use crate::setup::dialect::CodeList;
use crate::units::Unit;

/// What can be written as a file. Its name on the command line and in JavaScript is
/// the variant in lower case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(all(feature = "cli", any(not(target_arch = "wasm32"), feature = "npx")), derive(clap::ValueEnum))]
#[cfg_attr(target_arch = "wasm32", derive(serde::Deserialize, tsify::Tsify), serde(rename_all = "lowercase"))]
pub enum FileFormat {
    /// The drawing, as SVG.
    Svg,
    /// All motions, as a table.
    Csv,
    /// The setup sheet, as HTML that prints well.
    Card,
    /// The profile of the part, for drawing programs.
    Dxf,
    /// The part as a solid, for other programs.
    Stl,
    /// The program with every cycle expanded.
    Program,
}

impl FileFormat {
    /// The suffix of the file name, after the name of the program.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Svg => ".svg",
            Self::Csv => ".csv",
            Self::Card => "-setup-sheet.html",
            Self::Dxf => ".dxf",
            Self::Stl => ".stl",
            Self::Program => "-plain.nc",
        }
    }

    /// Whether the file contains texts in a language.
    pub fn has_texts(self) -> bool {
        match self {
            Self::Svg | Self::Card => true,
            Self::Csv | Self::Dxf | Self::Stl | Self::Program => false,
        }
    }

    /// Whether [`Exportable::expanded`] is called, which needs a run with a trace of the executed blocks.
    pub fn needs_trace(self) -> bool {
        match self {
            Self::Program => true,
            Self::Svg | Self::Csv | Self::Card | Self::Dxf | Self::Stl => false,
        }
    }
}

/// An analysed program, as needed for exports. Expensive results are computed on demand.
pub trait Exportable {
    /// Its text.
    fn text(&self) -> &[u8];
    /// All its motions.
    fn motions(&self) -> &Motions;
    /// The setup of the run.
    fn setup(&self) -> &Setup;
    /// The G code list that it was read with.
    fn codes(&self) -> CodeList;
    /// The machine simulation, with all material removed.
    fn simulation(&self) -> Option<&SimulationResult>;
    /// The program with every cycle expanded, in the encoding of the file to write.
    fn expanded(&self) -> Vec<u8>;
    /// The finished run, to execute blocks of it again.
    fn finished_run(&self) -> Run;
    /// The unit for lengths; tables of numbers use mm anyway.
    fn unit(&self) -> Unit;
    /// The direction of X+ in drawings.
    fn x_plus(&self) -> XPlus;
}

/// Exports a file; `None` if it needs a part and there is none.
pub fn file(format: FileFormat, program: &impl Exportable, language: Language) -> Option<Vec<u8>> {
    match format {
        FileFormat::Svg => {
            let chart = speed_chart(program, |options| options);
            Some(chart.unwrap_or_else(|| drawing(program, &svg_options(program, language))).into_bytes())
        }
        FileFormat::Csv => Some(csv::csv(program.motions(), &program.setup().machine).into_bytes()),
        FileFormat::Card => Some(card(program, language).into_bytes()),
        FileFormat::Dxf => dxf::dxf(&part(program)?, &dimensions(program)).map(String::into_bytes),
        FileFormat::Stl => stl::stl(&part(program)?),
        FileFormat::Program => Some(program.expanded()),
    }
}

/// The setup sheet, with a drawing unless it would have too many strokes, and the part with its dimensions.
fn card(program: &impl Exportable, language: Language) -> String {
    let motions = program.motions();
    let options = SvgOptions {
        ground: Ground::Paper,
        caption: Some(caption(String::new(), language)),
        ..svg_options(program, language)
    };
    let path = (motions.len() <= card::MAX_DRAWN).then(|| drawing(program, &options));
    let drawings: Vec<String> = path.into_iter().chain(part_drawing(program)).collect();
    let card = Card {
        text: program.text(),
        motions,
        setup: program.setup(),
        codes: program.codes(),
        unit: program.unit(),
        drawings: &drawings,
    };
    card.html(language)
}

/// The finished part with its dimensions, for paper; `None` if there are none.
fn part_drawing(program: &impl Exportable) -> Option<String> {
    let options = SvgOptions {
        annotations: dimensions(program),
        contents: Contents::Part,
        x_plus: program.x_plus(),
        scale: Scale { unit: program.unit(), symbol: "" },
        ..SvgOptions::default()
    };
    (!options.annotations.is_empty()).then(|| drawing(program, &options.on_paper(PART_WIDTH)))
}

/// The dimensions of the finished part.
fn dimensions(program: &impl Exportable) -> Vec<Annotation> {
    let simulation = program.simulation();
    simulation.map_or_else(Vec::new, |simulation| figures::of_finished(simulation, program.motions()))
}

/// Width of the chart of speeds, CSS pixels.
const CHART_WIDTH: f64 = 720.0;
/// Width of the drawing of the part on paper, mm.
const PART_WIDTH: f64 = 160.0;

/// The drawing of the half-section.
fn drawing(program: &impl Exportable, options: &SvgOptions) -> String {
    section(program.motions(), program.simulation(), options)
}

/// The chart of the speeds of a program without motions; `None` if it moves or sets no cutting speed. `adapt`: changes the
/// options of the picture.
pub fn speed_chart(
    program: &impl Exportable,
    adapt: impl FnOnce(SvgOptions) -> SvgOptions,
) -> Option<String> {
    if !program.motions().is_empty() {
        return None;
    }
    let (chart, annotations) = figures::of_speeds(&mut program.finished_run())?;
    let scale = Scale::of(program.unit());
    let options = SvgOptions { width: CHART_WIDTH, scale, annotations, ..SvgOptions::default() };
    Some(svg(&chart.moves().scene(None), &adapt(options)))
}

/// Options for the drawing of a program, with its title and a legend.
pub fn svg_options(program: &impl Exportable, language: Language) -> SvgOptions {
    let unit = program.unit();
    SvgOptions {
        x_plus: program.x_plus(),
        scale: Scale { unit, symbol: labels::unit_of_ruler(unit, language) },
        caption: Some(caption(title(program), language)),
        passes: Passes::Apart,
        ..SvgOptions::default()
    }
}

/// The caption of a drawing.
pub fn caption(title: String, language: Language) -> Caption {
    Caption { title, legend: labels::legend(language) }
}

/// The number of the program, and the name in its first comment.
fn title(program: &impl Exportable) -> String {
    let (text, chosen) = (program.text(), program.setup().program);
    let head = card::blocks(text).find_map(|block| {
        let (number, _) =
            block.program.filter(|(number, _)| chosen.is_none_or(|chosen| chosen == *number))?;
        let name = block.comments.first().map(|comment| card::remark(text, *comment));
        Some(card::program_name(number) + " " + &name.unwrap_or_default())
    });
    head.unwrap_or_default().trim_end().to_owned()
}

fn part(program: &impl Exportable) -> Option<Region> {
    program.simulation()?.finished()
}
