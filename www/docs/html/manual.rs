//! Renders the manual as HTML: pages with figures, tables of words and live elements.
//!
//! In: `www/manual`, with a folder of documents for each language and a folder of examples. Out: files by name: a
//! page for each document, its figures, and one style sheet. Must not know: the contents of the documents.
//!
//! The links of `index.md` give the order of the pages. A paragraph with one of these only is replaced:
//!
//! * a link to a program (`[caption](../examples/moves.nc)`) becomes an element with that program,
//! * an image of a program (`![caption](../examples/g90.nc "cycle:4")`) becomes a figure ([`super::figure`]),
//! * `{form G71}` becomes the table of the words of a code, and `{codes G40 G41}` rows of codes with anchors
//!   ([`super::form`]),
//! * `{calculator r-of-g90}` becomes a calculator ([`super::calculator`]).
//!
//! The exercises for a page follow its text.
//!
//! A formula between `$$` is LaTeX and becomes MathML. A block quote is an exercise. Links to rule files, programs of the gallery and other pages work in the repository and
//! on the site. A page that a language lacks is shown in English.
//!
//! The headings of a page have the anchors of the English page in each language. A link to a heading or to a row of codes
//! (`g90.md#step-by-step`, `g71-g72.md#g71`) is therefore valid in each language.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

use gcode_playground::api::exercise::{ExerciseRead, ExerciseText};
use gcode_playground::sentences::Language;
use gcode_playground::source::address::percent_encoded;
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser as LatexParser, Storage, push_mathml};

use super::site::{anchor, escaped, is_comment, plain};
use super::{calculator, figure, form};

/// The colours come first, so that the pages and the playground share them.
const STYLES: [&str; 4] = [
    include_str!("../../src/tokens.css"),
    include_str!("../../rules/rules.css"),
    include_str!("pages.css"),
    include_str!("manual.css"),
];

/// Content-Security-Policy: the element and its files come from the host of the page.
const POLICY: &str = include_str!("manual-policy.html");

/// The language whose headings give the anchors.
const ENGLISH: &str = "en";

/// The licence of the text and the figures.
const LICENCE: &str = env!("CARGO_PKG_LICENSE");

/// The list of the pages of a language.
pub const INDEX: &str = "index";

/// The setup of all examples.
const SETUP: &str = "setup.json";

/// The groups of controls that the elements show.
const CONTROLS: &str = "problems views playback status tools help link";

/// The fixed texts of a language.
struct Words {
    tag: &'static str,
    own_name: &'static str,
    playground: &'static str,
    manual: &'static str,
    languages: &'static str,
    pages: &'static str,
    next: &'static str,
    previous: &'static str,
    licence: &'static str,
    in_english: &'static str,
    search: &'static str,
    nothing_found: &'static str,
    exercises: &'static str,
}

const LANGUAGES: [Words; 3] = [
    Words {
        tag: "en",
        own_name: "English",
        playground: "G-code playground",
        manual: "Manual",
        languages: "Language",
        pages: "Pages",
        next: "Next",
        previous: "Previous",
        licence: "Licence of text and figures: ",
        in_english: "",
        search: "Search the manual",
        nothing_found: "no results",
        exercises: "Exercises",
    },
    Words {
        tag: "zh",
        own_name: "中文",
        playground: "G 代码演练场",
        manual: "手册",
        languages: "语言",
        pages: "各页",
        next: "下一页",
        previous: "上一页",
        licence: "文字与插图的许可证：",
        in_english: "本页尚无中文版，以下为英文。",
        search: "搜索手册",
        nothing_found: "没有结果",
        exercises: "练习",
    },
    Words {
        tag: "ru",
        own_name: "Русский",
        playground: "Песочница G-кода",
        manual: "Руководство",
        languages: "Язык",
        pages: "Страницы",
        next: "Дальше",
        previous: "Назад",
        licence: "Лицензия текста и рисунков: ",
        in_english: "Этой страницы ещё нет на русском языке; ниже она на английском.",
        search: "Поиск по руководству",
        nothing_found: "ничего не найдено",
        exercises: "Упражнения",
    },
];

/// All files by name, or all mistakes in the documents. `exercises`: the folder of the course.
pub fn files(folder: &Path, exercises: &Path) -> Result<BTreeMap<String, String>, String> {
    let mut files = BTreeMap::from([("manual.css".to_owned(), STYLES.concat())]);
    let mut mistakes = Vec::new();
    for words in &LANGUAGES {
        match Book::read(&folder.join(words.tag), exercises, words) {
            Ok(book) => files.extend(book.files(words)),
            Err(found) => mistakes.push(found),
        }
    }
    if mistakes.is_empty() { Ok(files) } else { Err(mistakes.join("\n")) }
}

/// The start of the list of exercises.
const EXERCISES: &str = "<section class=\"exercises\">";

/// The address of the page of the playground.
const PAGE: &str = "../../index.html";

/// The files for the element without the page, whose `index.html` shows the program of its address: a link to a program
/// of the gallery contains the program, and there are no links to the page and its exercises. `programs`: the folder of
/// the gallery.
pub fn without_page(
    files: &BTreeMap<String, String>,
    programs: &Path,
) -> Result<BTreeMap<String, String>, String> {
    let changed = |(name, content): (&String, &String)| {
        let content =
            if name.ends_with(".html") { with_programs(content, programs)? } else { content.clone() };
        Ok((name.clone(), content))
    };
    files.iter().map(changed).collect()
}

fn with_programs(html: &str, programs: &Path) -> Result<String, String> {
    let html = &without(html, EXERCISES, "</section>\n");
    let link = format!("\"{PAGE}#");
    let mut parts = html.split(&link);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (id, rest) = part.split_once('"').unwrap_or((part, ""));
        let read = |file: &str| {
            let path = programs.join(id).join(file);
            fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
        };
        let [program, setup] = [read("program.nc")?, read(SETUP)?];
        let setup = setup.split_whitespace().collect::<Vec<_>>().join(" ");
        let [program, setup] = [&program, &setup].map(|text| percent_encoded(text));
        let _ = write!(out, "\"{PAGE}#program={program}&amp;setup={setup}\"{rest}");
    }
    Ok(without(&out, &format!("<a href=\"{PAGE}\">"), "</a>\n"))
}

/// A text without its first piece from `start` to `end`.
fn without(html: &str, start: &str, end: &str) -> String {
    let piece = html.split_once(start).and_then(|(before, rest)| Some((before, rest.split_once(end)?.1)));
    piece.map_or_else(|| html.to_owned(), |(before, after)| [before, after].concat())
}

/// The exercises of the course in a language, in its order.
fn exercises(folder: &Path, words: &Words) -> Result<Vec<ExerciseText>, String> {
    let read = |file: &str| {
        let path = folder.join(file);
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    // The list contains strings only.
    let course = read("course.json")?;
    let language = Language::from_tag(words.tag);
    let ids = course.split('"').skip(1).step_by(2);
    ids.map(|id| match ExerciseRead::new(&read(&format!("{id}.md"))?, language) {
        ExerciseRead::Exercise(exercise) => Ok(*exercise),
        ExerciseRead::Fault { line, message } => Err(format!("{id}.md:{line}: {message}")),
    })
    .collect()
}

/// The pages of a language: first the list, then the others in its order.
struct Book {
    pages: Vec<Page>,
    exercises: Vec<ExerciseText>,
}

impl Book {
    fn read(folder: &Path, course: &Path, words: &Words) -> Result<Self, String> {
        let index = Page::read(folder, INDEX, words)?;
        let listed = index.links.clone();
        let mut pages = vec![index];
        for name in &listed {
            // The list by subject repeats pages of the way through.
            if !pages.iter().any(|page| page.name == *name) {
                pages.push(Page::read(folder, name, words)?);
            }
        }
        let documents = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        for path in documents.flatten().map(|entry| entry.path()) {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            if !pages.iter().any(|page| page.name == name) {
                return Err(format!("{} is not listed in {INDEX}.md", path.display()));
            }
        }
        let exercises = exercises(course, words)?;
        let chapters = exercises.iter().filter_map(|own| Some((own, own.chapter.as_ref()?)));
        for (exercise, chapter) in chapters {
            if !pages.iter().any(|page| page.name == *chapter) {
                return Err(format!("{}.md: the manual has no page `{chapter}`", exercise.id));
            }
        }
        Ok(Self { pages, exercises })
    }

    /// The exercises for a page; empty if there are none.
    fn exercises(&self, page: &Page, words: &Words) -> String {
        let own = self.exercises.iter().filter(|own| own.chapter.as_ref() == Some(&page.name));
        let items = own.map(|ExerciseText { id, title, .. }| {
            format!("<li><a href=\"{PAGE}#exercise={id}\">{}</a></li>\n", escaped(title))
        });
        let items: String = items.collect();
        match items.is_empty() {
            true => items,
            false => format!("{EXERCISES}\n<h2>{}</h2>\n<ul>\n{items}</ul>\n</section>\n", words.exercises),
        }
    }

    fn files(&self, words: &Words) -> Vec<(String, String)> {
        let names = |at: usize| format!("{}/{}.html", words.tag, self.pages[at].name);
        let pages = (0..self.pages.len()).map(|at| (names(at), self.html(at, words)));
        let figures = self.pages.iter().flat_map(|page| page.figures.iter().cloned());
        let sections =
            self.pages[1..].iter().flat_map(|page| page.sections.iter().map(move |own| (page, own)));
        let rows: Vec<String> = sections.enumerate().map(|(id, (page, own))| own.json(id, page)).collect();
        let search = (format!("{}/search.json", words.tag), format!("[{}]\n", rows.join(",\n")));
        pages.chain(figures).chain([search]).collect()
    }

    /// A page as HTML, with links to its neighbours.
    fn html(&self, at: usize, words: &Words) -> String {
        let page = &self.pages[at];
        let mut out = String::new();
        let (tag, file) = (words.tag, format!("{}.html", page.name));
        let _ = writeln!(out, "<!doctype html>\n<html lang=\"{tag}\">\n<head>\n<meta charset=\"utf-8\">");
        let _ = writeln!(out, "{}", POLICY.trim_end());
        out.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
        out.push_str("<meta name=\"color-scheme\" content=\"light dark\">\n");
        let _ = writeln!(out, "<title>{} · {}</title>", escaped(&page.title), words.playground);
        out.push_str("<link rel=\"stylesheet\" href=\"../manual.css\">\n");
        out.push_str("<script type=\"module\" src=\"../../search.js\"></script>\n");
        if page.is_live {
            out.push_str("<script type=\"module\" src=\"../../element.js\"></script>\n");
        }
        for other in &LANGUAGES {
            let other = other.tag;
            let _ = writeln!(out, "<link rel=\"alternate\" hreflang=\"{other}\" href=\"../{other}/{file}\">");
        }
        out.push_str("</head>\n<body>\n<header>\n<nav>\n");
        let _ = writeln!(out, "<a href=\"{PAGE}\">{}</a>", words.playground);
        let current = if at == 0 { " aria-current=\"page\"" } else { "" };
        let _ = writeln!(out, "<a href=\"{INDEX}.html\"{current}>{}</a>\n</nav>", words.manual);
        let _ = writeln!(out, "<nav aria-label=\"{}\">", words.languages);
        for Words { tag: other, own_name, .. } in &LANGUAGES {
            let _ = if *other == tag {
                writeln!(out, "<span aria-current=\"true\">{own_name}</span>")
            } else {
                let language = format!("lang=\"{other}\" hreflang=\"{other}\"");
                writeln!(out, "<a {language} href=\"../{other}/{file}\">{own_name}</a>")
            };
        }
        out.push_str("</nav>\n");
        let _ = writeln!(
            out,
            "<form class=\"search\" role=\"search\" data-none=\"{}\" hidden>\n<input type=\"search\" autocomplete=\"off\" \
             placeholder=\"{1}\" aria-label=\"{1}\">\n<output></output>\n<ul></ul>\n</form>",
            words.nothing_found, words.search
        );
        let _ = write!(out, "</header>\n<main>\n{}{}", page.body, self.exercises(page, words));
        let _ = writeln!(out, "<nav class=\"pages\" aria-label=\"{}\">", words.pages);
        let neighbours = [(at.checked_sub(1), "prev", words.previous), (Some(at + 1), "next", words.next)];
        for (at, relation, label) in neighbours {
            if let Some(Page { name, title, .. }) = at.and_then(|at| self.pages.get(at)) {
                let title = escaped(title);
                let _ = writeln!(
                    out,
                    "<a rel=\"{relation}\" href=\"{name}.html\"><small>{label}</small> {title}</a>"
                );
            }
        }
        let _ = writeln!(
            out,
            "</nav>\n</main>\n<footer>{}<span lang=\"en\">{LICENCE}</span></footer>\n</body>\n</html>",
            words.licence
        );
        out
    }
}

/// A rendered document.
pub struct Page {
    /// File stem.
    name: String,
    /// The text of its first heading.
    title: String,
    /// HTML.
    pub body: String,
    /// Whether it has an element.
    is_live: bool,
    /// The pages that it links to.
    pub links: Vec<String>,
    /// Its figures: name of the file, SVG.
    figures: Vec<(String, String)>,
    /// Its text by headings, for the search.
    sections: Vec<Section>,
}

/// The text under a heading.
#[derive(Default)]
struct Section {
    heading: String,
    anchor: String,
    text: String,
}

impl Section {
    /// A row of the list that the search reads.
    fn json(&self, id: usize, page: &Page) -> String {
        let anchor = if self.heading == page.title { "" } else { &self.anchor };
        let [name, anchor, title, heading, text] =
            [&page.name, anchor, &page.title, &self.heading, &self.text].map(quoted);
        format!(
            "{{\"id\":{id},\"page\":{name},\"anchor\":{anchor},\"title\":{title},\"heading\":{heading},\"text\":{text}}}"
        )
    }
}

/// A JSON string with blanks in place of line ends.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for word in text.split_whitespace() {
        if out.len() > 1 {
            out.push(' ');
        }
        out.push_str(&word.replace('\\', "\\\\").replace('"', "\\\""));
    }
    out.push('"');
    out
}

impl Page {
    fn read(folder: &Path, name: &str, words: &Words) -> Result<Self, String> {
        let own = folder.join(format!("{name}.md"));
        if own.is_file() {
            return Self::read_file(&own, name, folder);
        }
        println!("{} is not translated", own.display());
        let folder = folder.with_file_name(ENGLISH);
        let english = Self::read_file(&folder.join(format!("{name}.md")), name, &folder)?;
        let note = format!("<p class=\"note\">{}</p>\n", words.in_english);
        Ok(Self { body: format!("{note}<div lang=\"en\">\n{}</div>\n", english.body), ..english })
    }

    fn read_file(path: &Path, name: &str, folder: &Path) -> Result<Self, String> {
        let at = |mistake: String| format!("{}: {mistake}", path.display());
        let text = fs::read_to_string(path).map_err(|error| at(error.to_string()))?;
        if language(folder) == ENGLISH {
            return Self::new(&text, name, folder).map_err(at);
        }
        Self::with_headings(&text, &english(folder, name)?, name, folder).map_err(at)
    }

    /// Renders an English document of a folder. HTML in it is an error, except comments, which are left out.
    pub fn new(text: &str, name: &str, folder: &Path) -> Result<Self, String> {
        Self::with_headings(text, text, name, folder)
    }

    /// Renders a document of a folder, which is named after its language, with the anchors of the English document. A
    /// difference between the headings of both is an error.
    pub fn with_headings(text: &str, english: &str, name: &str, folder: &Path) -> Result<Self, String> {
        let mut ids = headings(english)?.into_iter();
        let events: Vec<Event> =
            Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_MATH).collect();
        let mut page = Page {
            name: name.into(),
            title: String::new(),
            body: String::new(),
            is_live: false,
            links: vec![],
            figures: vec![],
            sections: vec![],
        };
        let mut shown = Vec::new();
        let mut at = 0;
        while let Some(event) = events.get(at) {
            at += 1;
            page.collect(event);
            if *event == Event::Start(Tag::Paragraph)
                && let Some(end) =
                    events[at..].iter().position(|event| *event == Event::End(TagEnd::Paragraph))
                && let Some(html) = page.special(&events[at..at + end], folder)?
            {
                shown.push(Event::Html(html.into()));
                at += end + 1;
                continue;
            }
            let rendered = match event {
                Event::Html(html) | Event::InlineHtml(html) if is_comment(html) => continue,
                Event::Html(html) | Event::InlineHtml(html) => {
                    return Err(format!("HTML is not supported: {}", html.trim_end()));
                }
                Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                    let title = plain(&events[at..], |end| matches!(end, TagEnd::Heading(_)));
                    let anchor = match ids.next() {
                        Some((of_english, id)) if of_english == *level => id,
                        _ => return Err(format!("the English page has no such heading: `{title}`")),
                    };
                    let id = Some(anchor.clone().into());
                    page.sections.push(Section { heading: title.clone(), anchor, text: String::new() });
                    if page.title.is_empty() {
                        page.title = title;
                    }
                    let (level, classes, attrs) = (*level, classes.clone(), attrs.clone());
                    Event::Start(Tag::Heading { level, id, classes, attrs })
                }
                Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                    let address = page.address(dest_url, folder)?;
                    let (link_type, title, id) = (*link_type, title.clone(), id.clone());
                    Event::Start(Tag::Link { link_type, dest_url: address.into(), title, id })
                }
                Event::Code(code) => {
                    Event::InlineHtml(format!("<code lang=\"en\">{}</code>", escaped(code)).into())
                }
                Event::DisplayMath(formula) => Event::Html(mathml(formula)?.into()),
                Event::Start(Tag::CodeBlock(_)) => {
                    Event::Html("<pre lang=\"en\" tabindex=\"0\"><code>".into())
                }
                Event::End(TagEnd::CodeBlock) => Event::Html("</code></pre>\n".into()),
                Event::Start(Tag::Table(_)) => {
                    shown.push(Event::Html("<div class=\"table\" tabindex=\"0\">\n".into()));
                    event.clone()
                }
                Event::End(TagEnd::Table) => {
                    shown.push(event.clone());
                    Event::Html("</div>\n".into())
                }
                _ => event.clone(),
            };
            shown.push(rendered);
        }
        if let Some((_, id)) = ids.next() {
            return Err(format!("the heading `{id}` of the English page is missing"));
        }
        html::push_html(&mut page.body, shown.into_iter());
        if page.title.is_empty() { Err("no heading".to_owned()) } else { Ok(page) }
    }

    /// Adds the text of an event to its section.
    fn collect(&mut self, event: &Event) {
        match event {
            Event::Text(text) | Event::Code(text) if !text.starts_with('{') => {
                if let Some(section) = self.sections.last_mut() {
                    section.text.push_str(text);
                }
            }
            Event::SoftBreak | Event::End(TagEnd::Paragraph | TagEnd::Item | TagEnd::TableCell) => {
                if let Some(section) = self.sections.last_mut() {
                    section.text.push(' ');
                }
            }
            _ => {}
        }
    }

    /// A paragraph that is an element, a figure or a table; `None` for any other.
    fn special(&mut self, paragraph: &[Event], folder: &Path) -> Result<Option<String>, String> {
        let language = language_of(folder);
        if let Some((caption, program)) = example(paragraph) {
            self.is_live = true;
            return element(&caption, program, folder).map(Some);
        }
        if let [Event::Start(Tag::Image { dest_url, title, .. }), caption @ .., Event::End(TagEnd::Image)] =
            paragraph
        {
            let path = folder.join(&**dest_url);
            let svg = figure::draw(&path, &setup_of(&path)?, title, language)?;
            let stem = if path.ends_with("program.nc") { path.parent().unwrap_or(&path) } else { &path };
            let stem = stem.file_stem().unwrap_or_default().to_string_lossy();
            let name = format!("figures/{stem}-{}-{}.svg", title.replace(':', "-"), language.tag());
            let html = figure_of(&name, &svg, caption);
            self.figures.push((name, svg));
            return Ok(Some(html));
        }
        if let [Event::Text(text)] = paragraph
            && let Some(directive) = text.strip_prefix('{').and_then(|text| text.strip_suffix('}'))
        {
            let mut names = directive.split_whitespace();
            return match names.next() {
                Some("form") => form::table(names.next().unwrap_or_default(), language).map(Some),
                Some("calculator") => {
                    self.is_live = true;
                    calculator::html(names.next().unwrap_or_default(), CONTROLS, language).map(Some)
                }
                Some("codes") => form::rows(&names.collect::<Vec<_>>(), language).map(Some),
                _ => Err(format!("there is no directive `{text}`")),
            };
        }
        Ok(None)
    }

    /// The address on the site of a link in the repository.
    fn address(&mut self, link: &str, folder: &Path) -> Result<String, String> {
        if link.starts_with("https://") {
            return Ok(link.to_owned());
        }
        let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
        if !folder.join(file).is_file() {
            return Err(format!("the link `{link}` leads nowhere"));
        }
        let stem = |text: &str| text.strip_suffix(".md").map(str::to_owned);
        let gallery = |text: &str| text.strip_suffix("/program.nc").map(str::to_owned);
        if let Some(rule) = link.strip_prefix("../../../src/rules/").and_then(stem) {
            return Ok(format!("../../rules/{}/{rule}.html", language(folder)));
        }
        if let Some(program) = link.strip_prefix("../../../tests/programs/").and_then(gallery) {
            return Ok(format!("{PAGE}#{program}"));
        }
        match stem(file).filter(|page| !page.contains('/')) {
            Some(page) if anchor.is_empty() => {
                self.links.push(page.clone());
                Ok(format!("{page}.html"))
            }
            Some(page) if anchors(&english(folder, &page)?)?.iter().any(|known| known == anchor) => {
                self.links.push(page.clone());
                Ok(format!("{page}.html#{anchor}"))
            }
            Some(_) => Err(format!("the link `{link}` leads to no heading and no code")),
            None => Err(format!("the link `{link}` is to nothing on the site")),
        }
    }
}

/// The language of the documents of a folder.
fn language(folder: &Path) -> Cow<'_, str> {
    folder.file_name().unwrap_or_default().to_string_lossy()
}

fn language_of(folder: &Path) -> Language {
    let tag = language(folder);
    Language::ALL.into_iter().find(|language| language.tag() == tag).unwrap_or(Language::English)
}

/// The English document of a page.
fn english(folder: &Path, name: &str) -> Result<String, String> {
    let path = folder.with_file_name(ENGLISH).join(format!("{name}.md"));
    fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The headings of a document: level and anchor.
fn headings(text: &str) -> Result<Vec<(HeadingLevel, String)>, String> {
    let events: Vec<Event> = Parser::new_ext(text, Options::ENABLE_TABLES).collect();
    let mut found: Vec<(HeadingLevel, String)> = Vec::new();
    for (at, event) in events.iter().enumerate() {
        if let Event::Start(Tag::Heading { level, .. }) = event {
            let id = anchor(&plain(&events[at..], |end| matches!(end, TagEnd::Heading(_))));
            if found.iter().any(|(_, known)| *known == id) {
                return Err(format!("two headings have the anchor `{id}`"));
            }
            found.push((*level, id));
        }
    }
    Ok(found)
}

/// The anchors of a document: its headings, and its rows of codes.
fn anchors(text: &str) -> Result<Vec<String>, String> {
    let directives = text.lines().filter_map(|line| line.strip_prefix("{codes ")?.strip_suffix('}'));
    let codes = directives.flat_map(form::names_of).map(form::anchor);
    Ok(headings(text)?.into_iter().map(|(_, id)| id).chain(codes).collect())
}

/// The caption and the program of a paragraph that is only a link to a program.
fn example<'a>(paragraph: &'a [Event]) -> Option<(String, &'a str)> {
    let [Event::Start(Tag::Link { dest_url, .. }), caption @ .., Event::End(TagEnd::Link)] = paragraph else {
        return None;
    };
    let is_alone = !caption.iter().any(|event| matches!(event, Event::End(TagEnd::Link)));
    (is_alone && dest_url.ends_with(".nc")).then(|| (plain(caption, |_| false), &**dest_url))
}

/// A formula in LaTeX as MathML.
fn mathml(formula: &str) -> Result<String, String> {
    let storage = Storage::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut out = String::new();
    push_mathml(&mut out, LatexParser::new(formula, &storage), config).map_err(|error| error.to_string())?;
    if out.contains("<merror") { Err(format!("the formula `{formula}` is not valid LaTeX")) } else { Ok(out) }
}

/// A figure with its caption. Its size is given, so that the text does not move when it is loaded.
fn figure_of(name: &str, svg: &str, caption: &[Event]) -> String {
    let size = |attribute: &str| {
        let from = svg.split(&format!(" {attribute}=\"")).nth(1).unwrap_or_default();
        from.split('"').next().unwrap_or_default().to_owned()
    };
    let (width, height) = (size("width"), size("height"));
    let alternative = escaped(&plain(caption, |_| false));
    let mut html = String::new();
    html::push_html(&mut html, caption.iter().cloned());
    format!(
        "<figure>\n<img src=\"../{name}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\" alt=\"{alternative}\">\n\
         <figcaption>{html}</figcaption>\n</figure>\n"
    )
}

/// The setup beside a program.
fn setup_of(program: &Path) -> Result<String, String> {
    let path = program.with_file_name(SETUP);
    fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The element with a program. Without JavaScript its text is shown.
fn element(caption: &str, program: &str, folder: &Path) -> Result<String, String> {
    let path = folder.join(program);
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let setup = setup_of(&path)?;
    let setup = setup.split_whitespace().collect::<Vec<_>>().join(" ");
    Ok(format!(
        "<gcode-playground language=\"{}\" controls=\"{CONTROLS}\" setup=\"{}\" caption=\"{}\">\n<pre>\n{}</pre>\n</gcode-playground>\n",
        language(folder),
        escaped(&setup),
        escaped(caption),
        escaped(&text),
    ))
}
