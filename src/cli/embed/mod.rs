//! `embed`: writes a program as the element for a page, including its picture; or checks and updates the
//! pictures in existing pages.
//!
//! In: a program and the attributes of its element, or pages. Out: HTML, or a block of HTML for Markdown;
//! outdated pictures in the pages, or the pages with updated pictures. Knows the attributes that affect the
//! picture; all others are passed on unchanged.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::configuration::Configurations;
use super::manual::attributes::{self, Fault};
use super::manual::{self, Attributes, Example, Holder, Markup};
use super::manual_page::{self, Base, Page};
use super::options::{Destination, LanguageName, ProgramOptions, TurretName};
use super::system::print_error_line;
use super::{
    NAME, Program, Status, counted, encoding, figure_options, print, read, run_text, save, save_apart, status,
};
use crate::export::figure::Subject;
use crate::limits;
use crate::message::Edit;
use crate::message::applied;
use crate::scene;
use crate::scene::svg::SvgOptions;
use crate::sentences::{Language, labels};
use crate::setup::profile;
use crate::source::LineIndex;
use crate::source::address::percent_encoded;

/// The arguments of `embed`.
#[derive(clap::Args)]
#[command(mut_arg("library", |library| library.hide(true)))]
pub(super) struct Embed {
    /// The program, where `-` reads standard input; with `--check` and `--fix` pages.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    look: Look,
    /// For a page in HTML, for Markdown, where an element would end at a blank line, for Markdown with JSX; or as a frame.
    #[arg(long, value_enum, default_value = "html")]
    format: MarkupName,
    /// With `--format frame`: the address of the folder of the element.
    #[arg(long, value_name = "ADDRESS", default_value = concat!("embed/", env!("CARGO_PKG_VERSION")))]
    host: String,
    #[command(flatten)]
    to: Destination,
    /// Report each picture in the pages that is not what its program draws now.
    #[arg(long, conflicts_with_all = OF_WRITING)]
    check: bool,
    /// Draw these pictures anew in the pages.
    #[arg(long, visible_alias = "update", conflicts_with_all = OF_WRITING, conflicts_with = "check")]
    fix: bool,
}

/// Options for writing an element. They conflict with `--check` and `--fix`, which read them from the page.
const OF_WRITING: [&str; 12] = [
    "setup",
    "control",
    "view",
    "lang",
    "turret",
    "caption",
    "program",
    "block_skip",
    "attribute",
    "format",
    "host",
    "output",
];

/// The attributes of the element.
#[derive(clap::Args)]
struct Look {
    /// What the element shows.
    #[arg(long, value_enum)]
    view: Option<ElementView>,
    /// Language of the element and of its picture.
    #[arg(long, visible_alias = "language", value_enum)]
    lang: Option<LanguageName>,
    /// Which side of the spindle the turret is drawn on. Default: that of the setup.
    #[arg(long, value_enum)]
    turret: Option<TurretName>,
    /// A line under the element, and under its picture.
    #[arg(long)]
    caption: Option<String>,
    /// The O number to run.
    #[arg(long)]
    program: Option<u32>,
    /// The levels of block skip that are on, such as `1,2`.
    #[arg(long, value_delimiter = ',', value_parser = clap::value_parser!(u8).range(1..=9))]
    block_skip: Vec<u8>,
    /// Another attribute of the element, passed on as it is: `step=4`, `readonly`. May be given more than once.
    #[arg(long, value_name = "NAME=VALUE", value_parser = attribute)]
    attribute: Vec<(String, String)>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ElementView {
    All,
    Picture,
    Playback,
    Code,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MarkupName {
    Html,
    Markdown,
    Mdx,
    Frame,
}

/// The name of a value on the command line.
fn name_of(value: &impl ValueEnum) -> String {
    value.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
}

/// Parses `name=value`, or a name alone.
fn attribute(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    let name = name.to_ascii_lowercase();
    let is_name = name.starts_with(|letter: char| letter.is_ascii_lowercase())
        && name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '-');
    if !is_name {
        return Err("an attribute has a name of letters, digits and hyphens".to_owned());
    }
    Ok((name, value.to_owned()))
}

/// Runs `embed`.
pub(super) fn run(embed: &Embed) -> Result<Status, String> {
    if embed.check || embed.fix {
        return pages(&embed.files, embed.fix);
    }
    if !embed.with.library.is_empty() {
        return Err("`--library`: an element contains one program only".to_owned());
    }
    let [file] = embed.files.as_slice() else {
        return Err("one program at a time becomes an element".to_owned());
    };
    let attributes = attributes(embed)?;
    let (name, bytes) = read(file)?;
    let (text, _) = encoding::decode(bytes);
    let text = String::from_utf8_lossy(&text).replace("\r\n", "\n").replace('\r', "\n");
    let text = text.trim_start_matches('\u{feff}');
    if text.contains('\0') {
        return Err(format!("{name}: the program contains NUL characters, which a page cannot hold"));
    }
    let own = Attributes::of(&attributes);
    let setup = Base::none().setup(&own)?;
    let program = run_text(name, text.as_bytes().to_vec(), encoding::Encoding::Utf8, setup, |run| run);
    let is_drawn = own.get("view") != Some("code") && embed.format != MarkupName::Frame;
    let picture = is_drawn.then(|| picture(&program, &own));
    let page = match embed.format {
        MarkupName::Html => html(&attributes, text, picture),
        MarkupName::Markdown => markdown(&attributes, text, picture),
        MarkupName::Mdx => mdx(&attributes, text, picture),
        MarkupName::Frame => frame(&embed.host, &attributes, text),
    };
    save_apart(embed.to.file(), page.as_bytes())?;
    Ok(status(&program.analysis))
}

/// The attributes of the element, in the order of the reference.
fn attributes(embed: &Embed) -> Result<Vec<(String, String)>, String> {
    let Embed { with, look, .. } = embed;
    let mut attributes: Vec<(String, String)> = Vec::new();
    let mut put = |name: &str, value: Option<String>| {
        attributes.extend(value.map(|value| (name.to_owned(), value)));
    };
    put("view", look.view.as_ref().map(name_of));
    put("control", with.control.as_ref().map(name_of));
    let setups = Configurations::new(with)?.setups();
    profile::joined(&setups)?;
    put("setup", (!setups.is_empty()).then(|| profile::joined_text(&setups)));
    let levels: Vec<String> = look.block_skip.iter().map(u8::to_string).collect();
    put("block-skip", (!levels.is_empty()).then(|| levels.join(",")));
    put("program", look.program.map(|number| number.to_string()));
    put("language", look.lang.as_ref().map(name_of));
    put("turret", look.turret.as_ref().map(name_of));
    put("caption", look.caption.clone());
    for (name, value) in &look.attribute {
        if attributes.iter().any(|(own, _)| own == name) {
            return Err(format!("the attribute `{name}` is given twice"));
        }
        if embed.format == MarkupName::Frame && !attributes::is_of_the_element(name) {
            return Err(format!("a frame has no attribute `{name}`"));
        }
        if attributes::is_handler(name) {
            return Err(format!("`{name}` is an event handler, not an attribute of the element"));
        }
        match attributes::fault(name, value) {
            None => attributes.push((name.clone(), value.clone())),
            Some(Fault::Name) => return Err(format!("the element has no attribute `{name}`")),
            Some(Fault::Value { expected }) => {
                return Err(format!("`{name}={value}` is not understood; expected: {expected}"));
            }
        }
    }
    Ok(attributes)
}

/// Draws the picture of a program with the attributes of its element.
fn picture(program: &Program, attributes: &Attributes) -> String {
    let language = match attributes.get("language") {
        Some("zh") => Language::Chinese,
        Some("ru") => Language::Russian,
        _ => Language::English,
    };
    let turret = match attributes.get("turret") {
        Some("front") => TurretName::Front.turret(),
        Some("rear") => TurretName::Rear.turret(),
        _ => program.analysis.setup.machine.turret,
    };
    // The element draws the cycle or the part; the word at the cursor is chosen by the reader.
    let figure = match attributes.get("annotate") {
        Some("cycle") => Some(Subject::Cycle { line: None }),
        Some("part") => Some(Subject::Part),
        _ => None,
    };
    let simulation = program.analysis.simulate();
    let mut options =
        SvgOptions { x_plus: turret.into(), ..figure_options(program, &simulation, figure, language) };
    let caption = attributes.get("caption").filter(|caption| !caption.is_empty());
    if let (Some(under), Some(caption)) = (&mut options.caption, caption) {
        caption.clone_into(&mut under.title);
    }
    let svg = scene::svg::section(&program.analysis.motions, Some(&simulation), &options);
    // Limits the width to that of the column.
    svg.replacen("<svg ", r#"<svg slot="fallback" style="max-width:100%;height:auto" "#, 1)
}

/// The element for a page in HTML.
fn html(attributes: &[(String, String)], text: &str, picture: Option<String>) -> String {
    let tag = tag("gcode-playground", "", attributes);
    let picture = picture.unwrap_or_default();
    format!("{tag}\n{picture}<pre>\n{}</pre>\n</gcode-playground>\n", manual::escaped(text))
}

/// The element for a page in Markdown, as a `pre`, which may contain blank lines. The picture is in the last
/// line, because the end of its style sheet ends the HTML block.
fn markdown(attributes: &[(String, String)], text: &str, picture: Option<String>) -> String {
    let tag = tag("pre data-gcode-playground", "data-", attributes);
    let end = if text.ends_with('\n') { "" } else { "\n" };
    let picture = picture.map_or(String::new(), |picture| in_one_line(&picture));
    format!("{tag}\n{}{end}{picture}</pre>\n", manual::escaped(text))
}

/// The element for a page in MDX, where `{` and `<` begin JSX: program and picture are JavaScript strings.
/// The program is indented like the content of a tag, because MDX removes up to two spaces from each line.
fn mdx(attributes: &[(String, String)], text: &str, picture: Option<String>) -> String {
    let tag = tag("gcode-playground", "", attributes);
    let picture = picture.map_or(String::new(), |picture| {
        let html = manual::quoted(&in_one_line(&picture));
        format!("  <div slot=\"fallback\" dangerouslySetInnerHTML={{{{__html: `{html}`}}}} />\n")
    });
    let indented = |line: &str| if line.is_empty() { "\n".to_owned() } else { format!("  {line}\n") };
    let lines: String =
        manual::quoted(text.strip_suffix('\n').unwrap_or(text)).split('\n').map(indented).collect();
    format!("{tag}\n{picture}  <pre>{{`\n{lines}  `}}</pre>\n</gcode-playground>\n")
}

/// An `iframe` of the page in the element's folder, with attributes and program in its address. The number of
/// the program to run is in the setup, because there `program` is the text of the program.
fn frame(host: &str, attributes: &[(String, String)], text: &str) -> String {
    let mut said: Vec<(&str, String)> = Vec::new();
    let mut setups: Vec<String> = Vec::new();
    let mut title = "";
    for (name, value) in attributes {
        match name.as_str() {
            "setup" => setups.push(value.clone()),
            "program" => setups.push(format!("{{\"program\":{value}}}")),
            name => said.push((name, percent_encoded(value))),
        }
        if name == "caption" {
            title = value;
        }
    }
    if !setups.is_empty() {
        said.push(("setup", percent_encoded(&profile::joined_text(&setups))));
    }
    said.push(("program", percent_encoded(text.trim_end_matches('\n'))));
    let said: Vec<String> = said.iter().map(|(name, value)| format!("{name}={value}")).collect();
    let host = manual::escaped(host.trim_end_matches('/')).replace('"', "&quot;");
    let title = manual::escaped(if title.is_empty() { "G-code" } else { title }).replace('"', "&quot;");
    let address = format!("{host}/index.html#{}", said.join("&amp;"));
    format!(
        "<iframe sandbox=\"allow-scripts\" title=\"{title}\" width=\"100%\" height=\"480\"\n  src=\"{address}\">\n</iframe>\n"
    )
}

/// A start tag with attributes.
fn tag(start: &str, prefix: &str, attributes: &[(String, String)]) -> String {
    let mut tag = format!("<{start}");
    for (name, value) in attributes {
        tag += &format!(" {prefix}{name}");
        if !value.is_empty() {
            let value = manual::escaped(value).replace('"', "&quot;").replace('\r', "&#13;");
            tag += &format!("=\"{}\"", value.replace('\n', "&#10;"));
        }
    }
    tag + ">"
}

fn in_one_line(picture: &str) -> String {
    picture.lines().map(str::trim).collect()
}

/// Counts of the pages.
#[derive(Default)]
struct Counts {
    elements: usize,
    pictures: usize,
    old: usize,
    faulty: usize,
}

/// Checks the pictures of pages; with `fix`, updates outdated ones.
fn pages(files: &[PathBuf], fix: bool) -> Result<Status, String> {
    let mut counts = Counts::default();
    for file in files {
        let page = Page::read(file, limits::TEXT_BUFFER as u64)?;
        let told = InPage { page: &page, lines: &LineIndex::new(&page.text) };
        let mut edits = Vec::new();
        print(|out| {
            for example in page.examples().iter().filter(|example| example.holder != Holder::Code) {
                counts.elements += 1;
                edits.extend(look_at(out, &told, example, fix, &mut counts)?);
            }
            Ok(())
        })?;
        if !edits.is_empty() {
            let text = applied(&page.text, &edits);
            let text = String::from_utf8_lossy(&text);
            // Characters that the encoding of the page lacks cannot come from a picture: its captions are
            // also in the page.
            let bytes = page.encoding.encode(&text).unwrap_or(text.as_bytes().into());
            save(Some(file.as_path()).filter(|file| *file != Path::new("-")), &bytes)?;
        }
    }
    let Counts { elements, pictures, old, faulty } = counts;
    let what = if fix { "drawn anew" } else { "out of date" };
    let (elements, pictures) = (counted(elements, "element"), counted(pictures, "picture"));
    print_error_line(format_args!("{NAME}: {elements}, {pictures}, {old} {what}"));
    Ok(Status::faulty_if(faulty > 0 || old > 0 && !fix))
}

/// A page and its line index.
struct InPage<'a> {
    page: &'a Page,
    lines: &'a LineIndex,
}

impl InPage<'_> {
    /// Writes a message about an element.
    fn note(&self, out: &mut dyn Write, example: &Example, message: &str) -> io::Result<()> {
        let (line, column) = self.page.place(self.lines, example.at);
        writeln!(out, "{}:{line}:{column}: {message}", self.page.name)
    }
}

/// Compares the picture of an element with a new drawing; returns the edit that updates it, if needed.
fn look_at(
    out: &mut dyn Write,
    told: &InPage<'_>,
    example: &Example,
    fix: bool,
    counts: &mut Counts,
) -> io::Result<Option<Edit>> {
    let language = Language::English;
    if !example.is_closed {
        counts.faulty += 1;
        told.note(out, example, labels::element_not_closed(language))?;
        return Ok(None);
    }
    let Some(there) = &example.picture else { return Ok(None) };
    counts.pictures += 1;
    if example.attributes.get("src").is_some_and(|address| !address.is_empty()) {
        return Ok(None);
    }
    let setup = match Base::none().setup(&example.attributes) {
        Ok(setup) => setup,
        Err(reason) => {
            counts.faulty += 1;
            told.note(out, example, &labels::setup_unreadable(&reason, language))?;
            return Ok(None);
        }
    };
    let program = manual_page::run(&told.page.name, example, setup);
    let now = picture(&program, &example.attributes);
    let before = String::from_utf8_lossy(there.text());
    if in_one_line(&now) == in_one_line(&before) {
        return Ok(None);
    }
    counts.old += 1;
    if !fix {
        let name = &told.page.name;
        let said = labels::picture_out_of_date(language);
        told.note(out, example, &format!("{said}. To draw it anew: gcode-playground embed --fix {name}"))?;
        return Ok(None);
    }
    let is_html = told.page.markup == Markup::Html && before.contains('\n');
    let end = if before.contains("\r\n") { "\r\n" } else { "\n" };
    let text = if is_html { now.trim_end().replace('\n', end) } else { in_one_line(&now) };
    let text = if example.picture_is_quoted { manual::quoted(&text) } else { text };
    let whole = there.in_page(crate::source::Span::new(0, there.text().len()));
    Ok(Some(Edit { span: whole, text }))
}

#[cfg(test)]
mod tests;
