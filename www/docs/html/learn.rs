//! Renders the Learn pages as HTML: short lessons with live elements.
//!
//! In: `www/learn`, with a folder of documents for each language and a folder of examples. Out: files by name: a
//! page for each document, and one style sheet. Must not know: the contents of the documents.
//!
//! The links of `index.md` give the order of the pages. A paragraph that is only a link to a program
//! (`[caption](../examples/moves.nc)`) becomes an element with that program, and a block quote is an exercise.
//! Links to rule files, programs of the gallery and other pages work in the repository and on the site.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd, html};

use super::site::{anchor, escaped, is_comment, plain};

/// The colours come first, so that the pages and the playground share them.
const STYLES: [&str; 3] =
    [include_str!("../../src/tokens.css"), include_str!("../../rules/rules.css"), include_str!("learn.css")];

/// Content-Security-Policy: the element and its files come from the host of the page.
const POLICY: &str = include_str!("learn-policy.html");

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
    learn: &'static str,
    languages: &'static str,
    pages: &'static str,
    next: &'static str,
    previous: &'static str,
}

const LANGUAGES: [Words; 3] = [
    Words {
        tag: "en",
        own_name: "English",
        playground: "G-code playground",
        learn: "Learn",
        languages: "Language",
        pages: "Pages",
        next: "Next",
        previous: "Previous",
    },
    Words {
        tag: "zh",
        own_name: "中文",
        playground: "G 代码演练场",
        learn: "学习",
        languages: "语言",
        pages: "各页",
        next: "下一页",
        previous: "上一页",
    },
    Words {
        tag: "ru",
        own_name: "Русский",
        playground: "Песочница G-кода",
        learn: "Обучение",
        languages: "Язык",
        pages: "Страницы",
        next: "Дальше",
        previous: "Назад",
    },
];

/// All files by name, or all mistakes in the documents.
pub fn files(folder: &Path) -> Result<BTreeMap<String, String>, String> {
    let mut files = BTreeMap::from([("learn.css".to_owned(), STYLES.concat())]);
    let mut mistakes = Vec::new();
    for words in &LANGUAGES {
        match Book::read(&folder.join(words.tag)) {
            Ok(book) => files.extend(book.files(words)),
            Err(found) => mistakes.push(found),
        }
    }
    if mistakes.is_empty() { Ok(files) } else { Err(mistakes.join("\n")) }
}

/// The pages of a language: first the list, then the others in its order.
struct Book {
    pages: Vec<Page>,
}

impl Book {
    fn read(folder: &Path) -> Result<Self, String> {
        let index = Page::read(folder, INDEX)?;
        let listed = index.links.clone();
        let mut pages = vec![index];
        for name in &listed {
            pages.push(Page::read(folder, name)?);
        }
        let documents = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        for path in documents.flatten().map(|entry| entry.path()) {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            if !pages.iter().any(|page| page.name == name) {
                return Err(format!("{} is not listed in {INDEX}.md", path.display()));
            }
        }
        Ok(Self { pages })
    }

    fn files(&self, words: &Words) -> Vec<(String, String)> {
        let names = |at: usize| format!("{}/{}.html", words.tag, self.pages[at].name);
        (0..self.pages.len()).map(|at| (names(at), self.html(at, words))).collect()
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
        out.push_str("<link rel=\"stylesheet\" href=\"../learn.css\">\n");
        if page.is_live {
            out.push_str("<script type=\"module\" src=\"../../element.js\"></script>\n");
        }
        for other in &LANGUAGES {
            let other = other.tag;
            let _ = writeln!(out, "<link rel=\"alternate\" hreflang=\"{other}\" href=\"../{other}/{file}\">");
        }
        out.push_str("</head>\n<body>\n<header>\n<nav>\n");
        let _ = writeln!(out, "<a href=\"../../index.html\">{}</a>", words.playground);
        let current = if at == 0 { " aria-current=\"page\"" } else { "" };
        let _ = writeln!(out, "<a href=\"{INDEX}.html\"{current}>{}</a>\n</nav>", words.learn);
        let _ = writeln!(out, "<nav aria-label=\"{}\">", words.languages);
        for Words { tag: other, own_name, .. } in &LANGUAGES {
            let _ = if *other == tag {
                writeln!(out, "<span aria-current=\"true\">{own_name}</span>")
            } else {
                let language = format!("lang=\"{other}\" hreflang=\"{other}\"");
                writeln!(out, "<a {language} href=\"../{other}/{file}\">{own_name}</a>")
            };
        }
        let _ = write!(out, "</nav>\n</header>\n<main>\n{}", page.body);
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
        out.push_str("</nav>\n</main>\n</body>\n</html>\n");
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
}

impl Page {
    fn read(folder: &Path, name: &str) -> Result<Self, String> {
        let path = folder.join(format!("{name}.md"));
        let at = |mistake: String| format!("{}: {mistake}", path.display());
        let text = fs::read_to_string(&path).map_err(|error| at(error.to_string()))?;
        Self::new(&text, name, folder).map_err(at)
    }

    /// Renders a document of a folder, which is named after its language. HTML in it is an error, except comments, which are left out.
    pub fn new(text: &str, name: &str, folder: &Path) -> Result<Self, String> {
        let events: Vec<Event> = Parser::new_ext(text, Options::ENABLE_TABLES).collect();
        let mut page = Page {
            name: name.into(),
            title: String::new(),
            body: String::new(),
            is_live: false,
            links: vec![],
        };
        let mut shown = Vec::new();
        let mut at = 0;
        while let Some(event) = events.get(at) {
            at += 1;
            if let (Event::Start(Tag::Paragraph), Some((caption, program))) = (event, example(&events[at..]))
            {
                shown.push(Event::Html(element(&caption, program, folder)?.into()));
                page.is_live = true;
                let end = events[at..].iter().position(|event| *event == Event::End(TagEnd::Paragraph));
                at += end.unwrap_or_default() + 1;
                continue;
            }
            let rendered = match event {
                Event::Html(html) | Event::InlineHtml(html) if is_comment(html) => continue,
                Event::Html(html) | Event::InlineHtml(html) => {
                    return Err(format!("HTML is not supported: {}", html.trim_end()));
                }
                Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                    let title = plain(&events[at..], |end| matches!(end, TagEnd::Heading(_)));
                    let id = Some(anchor(&title).into());
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
        html::push_html(&mut page.body, shown.into_iter());
        if page.title.is_empty() { Err("no heading".to_owned()) } else { Ok(page) }
    }

    /// The address on the site of a link in the repository.
    fn address(&mut self, link: &str, folder: &Path) -> Result<String, String> {
        if link.starts_with("https://") {
            return Ok(link.to_owned());
        }
        if !folder.join(link).is_file() {
            return Err(format!("the link `{link}` leads nowhere"));
        }
        let stem = |text: &str| text.strip_suffix(".md").map(str::to_owned);
        let gallery = |text: &str| text.strip_suffix("/program.nc").map(str::to_owned);
        if let Some(rule) = link.strip_prefix("../../../src/rules/").and_then(stem) {
            return Ok(format!("../../rules/{}/{rule}.html", language(folder)));
        }
        if let Some(program) = link.strip_prefix("../../../tests/programs/").and_then(gallery) {
            return Ok(format!("../../index.html#{program}"));
        }
        match stem(link).filter(|page| !page.contains('/')) {
            Some(page) => {
                self.links.push(page.clone());
                Ok(format!("{page}.html"))
            }
            None => Err(format!("the link `{link}` is to nothing on the site")),
        }
    }
}

/// The language of the documents of a folder.
fn language(folder: &Path) -> Cow<'_, str> {
    folder.file_name().unwrap_or_default().to_string_lossy()
}

/// The caption and the program of a paragraph that is only a link to a program.
fn example<'a>(paragraph: &'a [Event]) -> Option<(String, &'a str)> {
    let [Event::Start(Tag::Link { dest_url, .. }), rest @ ..] = paragraph else { return None };
    let end = rest.iter().position(|event| *event == Event::End(TagEnd::Link))?;
    let is_alone = rest.get(end + 1) == Some(&Event::End(TagEnd::Paragraph));
    (is_alone && dest_url.ends_with(".nc")).then(|| (plain(&rest[..end], |_| false), &**dest_url))
}

/// The element with a program. Without JavaScript its text is shown.
fn element(caption: &str, program: &str, folder: &Path) -> Result<String, String> {
    let path = folder.join(program);
    let read = |path: &Path| fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()));
    let text = read(&path)?;
    let setup = read(&path.with_file_name(SETUP))?;
    let setup = setup.split_whitespace().collect::<Vec<_>>().join(" ");
    Ok(format!(
        "<gcode-playground language=\"{}\" controls=\"{CONTROLS}\" setup=\"{}\" caption=\"{}\">\n<pre>\n{}</pre>\n</gcode-playground>\n",
        language(folder),
        escaped(&setup),
        escaped(caption),
        escaped(&text),
    ))
}
