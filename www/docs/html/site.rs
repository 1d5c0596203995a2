//! Renders the reference as HTML.
//!
//! In: the documents of `www/docs`. Out: files by name: plain HTML without scripts, and one style sheet,
//! based on the style sheet of the rule pages. Must not know: the contents of the documents.
//!
//! A link from one document to another (`setup.md#fields`) becomes a link between the pages
//! (`setup.html#fields`), so links work in the repository and on the site. Headings get the same anchors as
//! in the repository.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

/// The colours come first, so that the pages and the playground share them.
const STYLES: [&str; 4] = [
    include_str!("../../src/tokens.css"),
    include_str!("../../rules/rules.css"),
    include_str!("pages.css"),
    include_str!("docs.css"),
];

/// Content-Security-Policy of the rule pages: no scripts.
const POLICY: &str = include_str!("../../rules/policy.html");

/// All files by name, or all errors in the documents.
pub fn files(folder: &Path) -> Result<BTreeMap<String, String>, String> {
    let documents = documents(folder).map_err(|error| format!("www/docs: {error}"))?;
    let mut mistakes = Vec::new();
    let mut pages = Vec::new();
    for (name, text) in &documents {
        match Page::new(text) {
            Ok(page) => pages.push((name, page)),
            Err(mistake) => mistakes.push(format!("{name}.md: {mistake}")),
        }
    }
    let anchors: BTreeMap<_, _> = pages.iter().map(|(name, page)| (name.as_str(), &page.anchors)).collect();
    for (name, page) in &pages {
        let broken = page.links.iter().filter(|link| !leads_somewhere(name, link, &anchors));
        mistakes.extend(broken.map(|link| format!("{name}.md: the link `{link}` leads nowhere")));
    }
    if !mistakes.is_empty() {
        return Err(mistakes.join("\n"));
    }
    let list: Vec<_> = pages.iter().map(|(name, page)| (file_name(name), page.title.as_str())).collect();
    let mut files = BTreeMap::from([("docs.css".to_owned(), STYLES.concat())]);
    files.extend(pages.iter().map(|(name, page)| (file_name(name), page.html(&file_name(name), &list))));
    Ok(files)
}

/// Each document: file stem and text.
fn documents(folder: &Path) -> io::Result<BTreeMap<String, String>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "md") {
            let name = path.file_stem().map(Path::new).map(|stem| stem.display().to_string());
            found.insert(name.unwrap_or_default(), fs::read_to_string(&path)?);
        }
    }
    Ok(found)
}

/// File name of a document on the site.
fn file_name(document: &str) -> String {
    if document == "README" { "index.html".to_owned() } else { format!("{document}.html") }
}

/// Pages beside the reference that it links to.
const BESIDE: [&str; 1] = ["../parts.html"];

/// Whether a link leads to the web, to a page beside the reference, or to an existing document and anchor.
fn leads_somewhere(from: &str, link: &str, anchors: &BTreeMap<&str, &BTreeSet<String>>) -> bool {
    if link.starts_with("https://") || BESIDE.contains(&link) {
        return true;
    }
    let (file, anchor) = link.split_once('#').map_or((link, None), |(file, anchor)| (file, Some(anchor)));
    let document = if file.is_empty() { Some(from) } else { file.strip_suffix(".md") };
    let there = document.and_then(|document| anchors.get(document));
    there.is_some_and(|there| anchor.is_none_or(|anchor| there.contains(anchor)))
}

/// A parsed document.
struct Page<'a> {
    /// The text of its first heading.
    title: String,
    events: Vec<Event<'a>>,
    /// The anchors of its headings.
    anchors: BTreeSet<String>,
    /// Targets of its links, as written.
    links: Vec<String>,
}

impl<'a> Page<'a> {
    /// Parses a document. HTML in it is an error, except comments, which are left out.
    fn new(text: &'a str) -> Result<Self, String> {
        let mut page =
            Page { title: String::new(), events: Vec::new(), anchors: BTreeSet::new(), links: Vec::new() };
        let events: Vec<_> = Parser::new_ext(text, Options::ENABLE_TABLES).collect();
        for (at, event) in events.iter().enumerate() {
            match event {
                Event::Html(html) | Event::InlineHtml(html) if !is_comment(html) => {
                    return Err(format!("HTML is not supported: {}", html.trim_end()));
                }
                Event::Html(_) | Event::InlineHtml(_) => {}
                Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                    let title = plain(&events[at..], |end| matches!(end, TagEnd::Heading(_)));
                    let id = anchor(&title);
                    if page.title.is_empty() {
                        page.title = title;
                    }
                    if !page.anchors.insert(id.clone()) {
                        return Err(format!("two headings have the anchor `{id}`"));
                    }
                    let (level, classes, attrs) = (*level, classes.clone(), attrs.clone());
                    page.events.push(Event::Start(Tag::Heading {
                        level,
                        id: Some(id.into()),
                        classes,
                        attrs,
                    }));
                }
                Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                    page.links.push(dest_url.to_string());
                    let (link_type, title, id) = (*link_type, title.clone(), id.clone());
                    let dest_url = on_site(dest_url);
                    page.events.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
                }
                // Wide code scrolls in its own box, which can have the keyboard focus.
                Event::Start(Tag::CodeBlock(_)) => {
                    page.events.push(Event::Html("<pre tabindex=\"0\"><code>".into()));
                }
                Event::End(TagEnd::CodeBlock) => page.events.push(Event::Html("</code></pre>\n".into())),
                Event::Start(Tag::Table(_)) => {
                    page.events.push(Event::Html("<div class=\"table\" tabindex=\"0\">\n".into()));
                    page.events.push(event.clone());
                }
                Event::End(TagEnd::Table) => {
                    page.events.push(event.clone());
                    page.events.push(Event::Html("</div>\n".into()));
                }
                // Mark Chinese and Russian terms, for screen readers and fonts.
                Event::Text(text) if language(text).is_some() => {
                    let language = language(text).unwrap_or_default();
                    page.events.push(Event::InlineHtml(format!("<span lang=\"{language}\">").into()));
                    page.events.push(event.clone());
                    page.events.push(Event::InlineHtml("</span>".into()));
                }
                _ => page.events.push(event.clone()),
            }
        }
        if page.title.is_empty() { Err("no heading".to_owned()) } else { Ok(page) }
    }

    /// The page as HTML, with a list of all pages.
    fn html(&self, own: &str, list: &[(String, &str)]) -> String {
        let mut out = String::from("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
        out.push_str(POLICY);
        out.push_str(
            "\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n",
        );
        let title = escaped(&self.title);
        let _ = writeln!(out, "<title>{title} · G-code playground</title>");
        out.push_str("<link rel=\"stylesheet\" href=\"docs.css\">\n</head>\n<body>\n<header>\n<nav>\n");
        out.push_str("<a href=\"../index.html\">G-code playground</a>\n");
        out.push_str("<a href=\"../rules/en/index.html\">All rules</a>\n</nav>\n");
        out.push_str("<nav aria-label=\"Reference\">\n");
        for (file, title) in list {
            let current = if file == own { " aria-current=\"page\"" } else { "" };
            let _ = writeln!(out, "<a href=\"{file}\"{current}>{}</a>", escaped(title));
        }
        out.push_str("</nav>\n</header>\n<main>\n");
        let mut body = String::new();
        html::push_html(&mut body, self.events.iter().cloned());
        // The Content-Security-Policy forbids style attributes.
        for side in ["left", "center", "right"] {
            body = body.replace(&format!(" style=\"text-align: {side}\""), &format!(" class=\"{side}\""));
        }
        out.push_str(&body);
        out.push_str("</main>\n</body>\n</html>\n");
        out
    }
}

pub fn is_comment(html: &str) -> bool {
    let html = html.trim();
    html.is_empty() || html.starts_with("<!--") && html.ends_with("-->")
}

/// The text of the events up to an end, without formatting.
pub fn plain(events: &[Event], is_end: impl Fn(&TagEnd) -> bool) -> String {
    let inside = events.iter().take_while(|event| !matches!(event, Event::End(end) if is_end(end)));
    inside
        .filter_map(|event| match event {
            Event::Text(text) | Event::Code(text) => Some(text.as_ref()),
            _ => None,
        })
        .collect()
}

/// The anchor of a heading, as repositories make it: lower case, hyphens for spaces, no other signs.
pub fn anchor(title: &str) -> String {
    let kept = title.chars().filter(|letter| letter.is_alphanumeric() || [' ', '-', '_'].contains(letter));
    kept.flat_map(char::to_lowercase).map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

/// A link between documents as a link between pages.
fn on_site<'a>(link: &CowStr<'a>) -> CowStr<'a> {
    let (file, anchor) = link.find('#').map_or((&link[..], ""), |at| link.split_at(at));
    match file.strip_suffix(".md") {
        Some(document) if !file.contains("://") => format!("{}{anchor}", file_name(document)).into(),
        _ => link.clone(),
    }
}

/// The language of a text that is not English. Capital letters alone are the name of a standard.
fn language(text: &str) -> Option<&'static str> {
    let mut letters = text.chars();
    letters.find_map(|letter| match letter {
        '\u{4e00}'..='\u{9fff}' => Some("zh"),
        'а'..='я' | 'ё' => Some("ru"),
        _ => None,
    })
}

pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_and_anchors_work_in_both_forms() {
        let page =
            Page::new("# A `b`: c\n\n[d](setup.md#numbers) [e](#a-b-c) [f](https://example.org/g.md)\n")
                .unwrap();
        let html = page.html("a.html", &[("a.html".to_owned(), "A")]);
        for part in [
            "<h1 id=\"a-b-c\">A <code>b</code>: c</h1>",
            "href=\"setup.html#numbers\"",
            "href=\"#a-b-c\"",
            "href=\"https://example.org/g.md\"",
            "<a href=\"a.html\" aria-current=\"page\">A</a>",
        ] {
            assert!(html.contains(part), "{part} is missing in\n{html}");
        }
        assert_eq!(on_site(&"README.md".into()).as_ref(), "index.html");
    }

    #[test]
    fn a_link_that_leads_nowhere_is_found() {
        let own = BTreeSet::from(["fields".to_owned()]);
        let anchors = BTreeMap::from([("setup", &own)]);
        for link in ["setup.md", "setup.md#fields", "#fields", "https://example.org", "../parts.html"] {
            assert!(leads_somewhere("setup", link, &anchors), "{link}");
        }
        for link in
            ["setup.md#field", "#field", "codes.md", "setup.html", "../setup.md", "http://example.org"]
        {
            assert!(!leads_somewhere("setup", link, &anchors), "{link}");
        }
    }

    #[test]
    fn html_is_refused_and_comments_are_left_out() {
        assert!(Page::new("# A\n\n<b>c</b>\n").is_err());
        assert!(Page::new("no heading\n").is_err());
        assert!(Page::new("# A\n\n## A\n").is_err());
        let page = Page::new("# A\n\n<!-- table -->\n| a |\n|---|\n| b |\n<!-- /table -->\n").unwrap();
        let html = page.html("a.html", &[]);
        assert!(html.contains("<td>b</td>") && !html.contains("<!--"), "{html}");
    }

    #[test]
    fn a_page_has_a_policy_and_no_inline_styles() {
        let page = Page::new("# A\n\n| a | b | c |\n|:--|:-:|--:|\n| 1 | 2 | 3 |\n").unwrap();
        let html = page.html("a.html", &[]);
        for part in
            ["content=\"default-src 'none'; ", "<td class=\"center\">2</td>", "<td class=\"right\">3</td>"]
        {
            assert!(html.contains(part), "{part} is missing in\n{html}");
        }
        assert!(!html.contains(" style="), "{html}");
    }

    #[test]
    fn other_languages_are_marked() {
        let page =
            Page::new("# A\n\n| a | b | c |\n|---|---|---|\n| 程序段 | кадр | ISO 2806, ГОСТ 20523 |\n")
                .unwrap();
        let html = page.html("a.html", &[]);
        for part in [
            "<td><span lang=\"zh\">程序段</span></td>",
            "<span lang=\"ru\">кадр</span>",
            "<td>ISO 2806, ГОСТ 20523</td>",
        ] {
            assert!(html.contains(part), "{part} is missing in\n{html}");
        }
    }
}
