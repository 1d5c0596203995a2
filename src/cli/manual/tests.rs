use super::*;

/// The programs and attributes of a page, with the page's text at the first character of each program.
fn programs(page: &str, markup: Markup) -> Vec<(String, Vec<(String, String)>)> {
    let found = examples(page.as_bytes(), markup);
    let program = |example: &Example| String::from_utf8_lossy(example.program.text()).into_owned();
    found.iter().map(|example| (program(example), example.attributes.0.clone())).collect()
}

fn texts(page: &str, markup: Markup) -> Vec<String> {
    programs(page, markup).into_iter().map(|(text, _)| text).collect()
}

fn attributes(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
    pairs.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
}

#[test]
fn fences_that_name_the_language_are_programs() {
    for info in ["gcode", "nc", "g-code", "CNC", "gcode,ignore", "{.gcode}", "{code-block} nc", " gcode  a"] {
        assert_eq!(texts(&format!("a\n```{info}\nG00 X1\n```\n"), Markup::Markdown), ["G00 X1\n"], "{info}");
    }
    for info in ["", "rust", "gcodes", "json gcode", "{code-block} c", "ncc"] {
        assert!(texts(&format!("```{info}\nG00 X1\n```\n"), Markup::Markdown).is_empty(), "{info}");
    }
}

#[test]
fn a_fence_has_the_attributes_of_its_line() {
    let page = "```gcode control=gsk block-skip=\"1,2\" setup='{\"program\": 2}' no-check\nG00\n```\n";
    let own = attributes(&[
        ("control", "gsk"),
        ("block-skip", "1,2"),
        ("setup", "{\"program\": 2}"),
        ("no-check", ""),
    ]);
    assert_eq!(programs(page, Markup::Markdown), [("G00\n".to_owned(), own)]);
    let page = "```{gcode-playground}\n:control: gsk\n:view: picture\nG00\n:b\n```\n";
    let own = attributes(&[("control", "gsk"), ("view", "picture")]);
    assert_eq!(programs(page, Markup::Markdown), [("G00\n:b\n".to_owned(), own)]);
}

#[test]
fn fences_are_found_wherever_markdown_has_them() {
    let page = "> ```gcode\n> G1\n>\n> G2\n> ```\n\n1. a\n\n   - ~~~~nc\n     G3\n     ~~~\n     G4\n     ~~~~\n\n\
                ````markdown\n```gcode\nno\n```\n````\n\n    ```gcode\n    no\n    ```\n\n```gcode\nG5\n\nG6";
    assert_eq!(texts(page, Markup::Markdown), ["G1\n\nG2\n", "G3\n~~~\nG4\n", "G5\n\nG6"]);
    let windows = page.replace('\n', "\r\n");
    let found: Vec<String> =
        texts(&windows, Markup::Markdown).iter().map(|text| text.replace("\r\n", "\n")).collect();
    assert_eq!(found, ["G1\n\nG2\n", "G3\n~~~\nG4\n", "G5\n\nG6"]);
    assert!(texts("---\ntitle: |\n  ```gcode\n---\ntext\n", Markup::Markdown).is_empty());
}

#[test]
fn every_byte_of_a_program_has_its_place_in_the_page() {
    let page = "é\r\n> ```gcode\r\n>  G00 X1\r\n> \tX2\r\n> ```\r\n<pre data-gcode-playground>\r\n  A&lt;B\r\n   C\r\n</pre>\r\n";
    let found = examples(page.as_bytes(), Markup::Markdown);
    assert_eq!(found.len(), 2);
    for (example, words) in found.iter().zip([&["G00", "X1", "X2"][..], &["A<B", "C"]]) {
        let text = String::from_utf8_lossy(example.program.text()).into_owned();
        for word in words {
            let at = text.find(word).unwrap_or_else(|| panic!("{word} in {text:?}"));
            let place = example.in_page(Span::new(at, at + word.len()));
            assert_eq!(place.quote(page.as_bytes()), word.replace('<', "&lt;"), "{text:?}");
        }
    }
    assert_eq!(found[1].program.text(), b"A<B\n C");
}

/// The program is the same in every form that the element accepts.
#[test]
fn an_element_is_read_as_the_element_reads_itself() {
    let program = "#100=#1*2+#3*4\nIF[#100 LT 5](SMALL)\n(A<B & C)\nM98<SUB>\n\nM30";
    let escaped = escaped(program);
    for page in [
        format!("<pre data-gcode-playground>\n{escaped}\n</pre>"),
        format!("<gcode-playground>\n<pre>{escaped}</pre></gcode-playground>"),
        format!("<gcode-playground>{escaped}</gcode-playground>"),
        format!(
            "<gcode-playground><svg slot=fallback><svg/><text>no</text></svg>\n<!-- no -->{escaped}\n</gcode-playground>"
        ),
        format!(
            "<gcode-playground>no<pre slot='fallback'>no</pre><pre>\r\n{}</pre>no</gcode-playground>",
            escaped.replace('\n', "\r\n")
        ),
        format!("<script type='text/x-gcode' data-gcode-playground>\n{program}\n</script>"),
        format!("<SCRIPT TYPE=text/x-gcode>{program}</SCRIPT >"),
        format!(
            "<gcode-playground><pre>no</pre><script type=\"text/x-gcode\">{program}</script></gcode-playground>"
        ),
        format!(
            "<gcode-playground>{escaped}<script>no</script><style>no</style><template>no</template></gcode-playground>"
        ),
        format!(
            "<gcode-playground><pre>\n    {}\n\n</pre></gcode-playground>",
            escaped.replace('\n', "\n    ").replace("\n    \n", "\n\n")
        ),
    ] {
        assert_eq!(texts(&page, Markup::Html), [program], "{page}");
    }
    assert_eq!(texts("<pre>G00</pre><p slot=x>G00</p><script>G00</script>", Markup::Html), [""; 0]);
}

#[test]
fn attributes_of_elements_and_of_marked_blocks() {
    let of = |page: &str| programs(page, Markup::Html).remove(0).1;
    let own = attributes(&[("control", "gsk"), ("caption", "a \"b\" <c>"), ("readonly", "")]);
    assert_eq!(
        of("<gcode-playground CONTROL=gsk caption='a \"b\" &lt;c>' readonly>G</gcode-playground>"),
        own
    );
    assert_eq!(
        of(
            "<pre data-gcode-playground class=x data-control = \"gsk\" data-caption=\"a &quot;b&quot; &lt;c&gt;\" data-readonly>G</pre>"
        ),
        own
    );
    assert_eq!(
        of("<gcode-playground>G<script type=application/json> {\"program\": 2} </script></gcode-playground>"),
        attributes(&[("setup", "{\"program\": 2}")])
    );
}

#[test]
fn html_in_markdown_is_html() {
    let page = "a\n\n<pre data-gcode-playground data-control=\"gsk\">\nG00 *X1*\n\n[X2](Y)\n</pre>\n\n\
                before <gcode-playground view=\"picture\">G00 (A&lt;B)</gcode-playground> after\n\n\
                - <gcode-playground>\n  G01\n  X2\n  </gcode-playground>\n\n`<gcode-playground>no</gcode-playground>`\n";
    assert_eq!(texts(page, Markup::Markdown), ["G00 *X1*\n\n[X2](Y)", "G00 (A<B)", "G01\nX2"]);
    assert!(examples(page.as_bytes(), Markup::Markdown).iter().all(|example| example.is_closed));
}

#[test]
fn an_element_that_markdown_ends_is_told() {
    let closed = |page: &str, markup: Markup| -> Vec<bool> {
        examples(page.as_bytes(), markup).iter().map(|example| example.is_closed).collect()
    };
    let page = "<gcode-playground>\nG00\n\nG01\n</gcode-playground>\n";
    assert_eq!((closed(page, Markup::Markdown), closed(page, Markup::Html)), (vec![false], vec![true]));
    let page = "<gcode-playground>\n<pre>\nG00\n\nG01\n</pre>\n</gcode-playground>\n";
    assert_eq!(closed(page, Markup::Markdown), [false]);
    let page =
        "<pre data-gcode-playground>\nG00\n\nG01\n<svg slot=\"fallback\"><style></style></svg></pre>\nb\n";
    assert_eq!(
        (closed(page, Markup::Markdown), texts(page, Markup::Markdown)),
        (vec![true], vec!["G00\n\nG01".into()])
    );
    assert_eq!(
        closed("<gcode-playground>G<gcode-playground>G</gcode-playground>", Markup::Html),
        [false, true]
    );
    assert_eq!(closed("<script type=text/x-gcode>G00", Markup::Html), [false]);
}

#[test]
fn jsx_has_blank_lines_and_texts_in_braces() {
    let page = "import X from 'x';\n\n<gcode-playground view=\"picture\" control={'gsk'} readonly>\n  <pre>{`\nG00 (A<B) `}</pre>\n</gcode-playground>\n\n\
                <gcode-playground caption={`a`}>{`\n  #100=#1*2\n\n  G01 \\`\n`}</gcode-playground>\n\n\
                ```gcode\nG02 {`}\n```\n\n<gcode-playground src='a.nc' />\n\n`<gcode-playground>no</gcode-playground>`\n\
                <gcode-playground dangerouslySetInnerHTML={{__html: '<pre>}</pre>'}} />\n";
    let found = programs(page, Markup::Mdx);
    let texts: Vec<&str> = found.iter().map(|(text, _)| text.as_str()).collect();
    assert_eq!(texts, ["G00 (A<B) ", "#100=#1*2\n\nG01 `", "G02 {`}\n", "", ""]);
    assert_eq!(found[0].1, attributes(&[("view", "picture"), ("control", "gsk"), ("readonly", "")]));
    assert_eq!(found[1].1, attributes(&[("caption", "a")]));
}

#[test]
fn directives_of_restructured_text_are_programs() {
    let page = "Title\n=====\n\n.. gcode-playground::\n   :control: gsk\n   :view: picture\n\n   G00 X1\n\n     X2\n\ntext\n\n\
                .. note::\n\n   .. code-block:: gcode\n      :linenos:\n\n      G01\n   more\n\n.. code-block:: python\n\n   .. code-block:: gcode\n\n      no\n\n\
                .. raw:: html\n\n   <gcode-playground control=\"forum\"><pre>\n   G02 A&lt;B\n\n   G03\n   </pre></gcode-playground>\n";
    let found = programs(page, Markup::Restructured);
    let texts: Vec<&str> = found.iter().map(|(text, _)| text.as_str()).collect();
    assert_eq!(texts, ["G00 X1\n\n  X2", "G01", "G02 A<B\n\nG03"]);
    assert_eq!(found[0].1, attributes(&[("control", "gsk"), ("view", "picture")]));
    assert_eq!(found[2].1, attributes(&[("control", "forum")]));
}

#[test]
fn the_ending_of_a_file_tells_how_it_is_written() {
    for (name, markup) in [
        ("a.md", Markup::Markdown),
        ("a.b/c", Markup::Markdown),
        ("<stdin>", Markup::Markdown),
        ("A.HTML", Markup::Html),
        ("a.rst", Markup::Restructured),
        ("a.mdx", Markup::Mdx),
    ] {
        assert_eq!(Markup::of(name), markup, "{name}");
    }
}

/// A page cut off at any byte is read to its end.
#[test]
fn no_page_is_too_broken_to_be_read() {
    let page = "> ```gcode a={'}\nG00\n> ```\n<gcode-playground a='{' b={`}><svg slot=fallback><text>&lt;</text></svg>{`G\\`}<pre>\nX&amp;\r\n</pre><script type=text/x-gcode>\n<!-- </script></gcode-playground>\n.. raw:: html\n\n  <pre data-gcode-playground>é</pre>\n";
    for markup in [Markup::Markdown, Markup::Mdx, Markup::Html, Markup::Restructured] {
        for start in 0..page.len() {
            for end in [page.len(), (start + 40).min(page.len())] {
                for example in examples(&page.as_bytes()[start..end], markup) {
                    let whole = example.in_page(Span::new(0, example.program.text().len()));
                    assert!(whole.end as usize <= end - start);
                }
            }
        }
    }
}
