use proptest::prelude::*;

use super::*;

/// The program as the element reads it: line ends are LF, without blank lines around it and common
/// indentation.
fn taken(text: &str) -> String {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    // JavaScript's definition of white space.
    let blank = |letter: char| letter == '\u{feff}' || letter.is_whitespace() && letter != '\u{85}';
    let is_blank = |line: &&str| line.chars().all(blank);
    let lines: Vec<&str> = text.split('\n').collect();
    let first = lines.iter().position(|line| !is_blank(line)).unwrap_or(lines.len());
    let last = lines.iter().rposition(|line| !is_blank(line)).map_or(first, |last| last + 1);
    let lines = &lines[first..last];
    let indent = |line: &str| line.chars().take_while(|letter| blank(*letter)).count();
    let common = lines.iter().filter(|line| !is_blank(line)).map(|line| indent(line)).min().unwrap_or(0);
    let lines: Vec<String> = lines.iter().map(|line| line.chars().skip(common).collect()).collect();
    lines.join("\n")
}

fn only(page: &str, markup: Markup) -> Example {
    let mut found = manual::examples(page.as_bytes(), markup);
    assert_eq!(found.len(), 1, "{page}");
    let example = found.remove(0);
    assert!(example.is_closed, "{page}");
    example
}

fn text_of(example: &Example) -> String {
    String::from_utf8_lossy(example.program.text()).into_owned()
}

const PICTURE: &str = "<svg slot=\"fallback\" class=\"lathe\">\n<title>A&lt;B</title>\n<style>\n.a { b: c }\n@media d {\n.e { f: g }\n}\n</style>\n<svg x=\"1\">\n<path d=\"M0 0\"/>\n</svg>\n</svg>\n";

/// Programs with characters that could break a page.
fn program() -> impl Strategy<Value = String> {
    let pieces = [
        "G00 X1",
        "#100=#1*2",
        "IF[#1 LT 5]",
        "(A<B",
        "M98<SUB>",
        "\n",
        "\n\n",
        "\r\n",
        "\r",
        " ",
        "\t",
        "    ",
        "&lt;",
        "&",
        "&amp;",
        "</pre>",
        "</style>",
        "</script>",
        "</gcode-playground>",
        "<!--",
        "-->",
        "```",
        "`",
        "*",
        "_",
        "[a](b)",
        "> ",
        "- ",
        "1. ",
        "<svg slot=\"fallback\">",
        "{",
        "}",
        "%",
        "\u{feff}",
        "\u{85}",
        "\u{3000}",
        "直径",
        "\\",
        "\"",
        "'",
        "<![CDATA[",
        "]]>",
        "<?",
        "$$",
        "|",
        "~~~",
        "=====",
    ];
    let piece =
        prop_oneof![4 => prop::sample::select(pieces.to_vec()).prop_map(str::to_owned), 1 => "[^\\x00]{0,3}"];
    prop::collection::vec(piece, 0..30).prop_map(|pieces| pieces.concat())
}

proptest! {
    #[test]
    fn a_program_comes_out_of_a_page_as_it_went_in(text in program(), caption in "[^\\x00]{0,8}") {
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        let attributes = vec![
            ("caption".to_owned(), caption.clone()),
            ("setup".to_owned(), "{\"program\": 2}".to_owned()),
        ];
        for picture in [None, Some(PICTURE.to_owned())] {
            let page = html(&attributes, &text, picture.clone());
            let in_markdown = markdown(&attributes, &text, picture.clone());
            let between = format!("# Title\n\nBefore:\n\n{in_markdown}\n*After*\n");
            let in_mdx = format!("# Title\n\nBefore:\n\n{}\n*After*\n", mdx(&attributes, &text, picture.clone()));
            let in_quotation = format!("> {}\n", in_markdown.trim_end().replace('\n', "\n> "));
            for (page, markup) in [
                (&page, Markup::Html),
                (&page.replace('\n', "\r\n"), Markup::Html),
                (&in_markdown, Markup::Html),
                (&between, Markup::Markdown),
                (&between.replace('\n', "\r\n"), Markup::Markdown),
                (&in_quotation, Markup::Markdown),
                (&in_mdx, Markup::Mdx),
                (&in_mdx.replace('\n', "\r\n"), Markup::Mdx),
            ] {
                let example = only(page, markup);
                prop_assert_eq!(text_of(&example), taken(&text), "{}", page);
                prop_assert_eq!(example.attributes.get("setup"), Some("{\"program\": 2}"));
                // Browsers normalise the line ends of a page; in an attribute they are character references.
                prop_assert_eq!(example.attributes.get("caption"), Some(caption.as_str()));
                let there = example.picture.as_ref().map(|there| in_one_line(&String::from_utf8_lossy(there.text())));
                prop_assert_eq!(there, picture.as_deref().map(in_one_line));
            }
        }
    }
}

/// A block of Markdown is converted to the same HTML.
#[test]
fn markdown_passes_the_block_on() {
    let text = "O1 (A<B & *C*)\n\n#100=#1*2\n\n    G00 X1\n</style>\n</pre>\nM30\n";
    let block = markdown(&[("view".to_owned(), "picture".to_owned())], text, Some(PICTURE.to_owned()));
    let mut page = String::new();
    let parser = pulldown_cmark::Parser::new(&block);
    for event in parser {
        match event {
            pulldown_cmark::Event::Html(text) => page.push_str(&text),
            pulldown_cmark::Event::Start(_) | pulldown_cmark::Event::End(_) => {}
            other => panic!("{other:?} in {block}"),
        }
    }
    assert_eq!(page, block);
    assert!(block.ends_with("</svg></pre>\n") && block.matches("</style>").count() == 1, "{block}");
}

#[test]
fn names_of_attributes_are_names() {
    assert_eq!(attribute("step=4"), Ok(("step".to_owned(), "4".to_owned())));
    assert_eq!(attribute("READONLY"), Ok(("readonly".to_owned(), String::new())));
    assert_eq!(attribute("a=b=c"), Ok(("a".to_owned(), "b=c".to_owned())));
    for text in ["", "=1", "1a=1", "on click=1", "a>b"] {
        assert!(attribute(text).is_err(), "{text}");
    }
}

#[test]
fn a_frame_has_all_of_it_in_its_address() {
    let own = |name: &str, value: &str| (name.to_owned(), value.to_owned());
    let attributes =
        [own("view", "playback"), own("program", "2"), own("caption", "a \"b\""), own("readonly", "")];
    let frame = frame("https://example.org/embed/", &attributes, "O2 (A&B + 100%)\nG00 X1\n");
    assert_eq!(
        frame,
        "<iframe sandbox=\"allow-scripts\" title=\"a &quot;b&quot;\" width=\"100%\" height=\"480\"\n  \
         src=\"https://example.org/embed/index.html#view=playback&amp;caption=a%20%22b%22&amp;readonly=&amp;\
         setup=%7B%22program%22%3A2%7D&amp;program=O2%20%28A%26B%20%2B%20100%25%29%0AG00%20X1\">\n</iframe>\n"
    );
}
