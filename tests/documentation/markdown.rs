//! In: a Markdown document of the project. Out: what stands in it as code, and its prose. Tables and lists
//! that a test writes (`<!-- name -->` … `<!-- /name -->`) are left out: those tests hold them.
//!
//! It knows only the Markdown that the project's documents are written in.

/// A document, taken apart.
#[derive(Debug, Default)]
pub struct Document {
    /// Indented and fenced blocks, without their indent.
    pub blocks: Vec<String>,
    /// What stands between back quotes, line ends as blanks.
    pub spans: Vec<String>,
    /// The rest, line by line; a span is one `□`.
    pub prose: Vec<String>,
}

impl Document {
    /// Takes a document apart.
    pub fn read(text: &str) -> Self {
        let mut document = Document::default();
        let mut paragraphs = String::new();
        let mut block: Option<String> = None;
        let mut fenced = false;
        let mut after_blank = true;
        for line in without_generated(text).lines() {
            let fence = line.starts_with("```");
            let indented = line.strip_prefix("    ");
            if fence {
                fenced = !fenced;
                document.blocks.extend(block.take());
                if fenced {
                    block = Some(String::new());
                }
            } else if let (Some(block), true) = (&mut block, fenced) {
                *block += line;
                *block += "\n";
            } else if let (Some(code), true) = (indented, block.is_some() || after_blank) {
                let block = block.get_or_insert_default();
                *block += code;
                *block += "\n";
            } else if let (Some(block), true) = (&mut block, line.trim().is_empty()) {
                block.push('\n');
            } else {
                document.blocks.extend(block.take());
                paragraphs += line;
                paragraphs += "\n";
            }
            after_blank = line.trim().is_empty() || fence;
        }
        document.blocks.extend(block);
        document.blocks = document.blocks.iter().map(|block| block.trim_end().to_owned()).collect();
        let mut prose = String::new();
        for (at, part) in paragraphs.split('`').enumerate() {
            if at % 2 == 0 {
                prose += part;
            } else {
                document.spans.push(part.split_whitespace().collect::<Vec<_>>().join(" "));
                prose.push('□');
            }
        }
        document.prose = prose.lines().map(str::to_owned).collect();
        document
    }
}

/// The text without what lies between the marks of generated tables.
fn without_generated(text: &str) -> String {
    let mut kept = String::new();
    let mut until: Option<String> = None;
    for line in text.lines() {
        match &until {
            Some(end) if line == end => until = None,
            Some(_) => {}
            None => match line.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->")) {
                Some(name) => until = Some(format!("<!-- /{name} -->")),
                None => {
                    kept += line;
                    kept += "\n";
                }
            },
        }
    }
    assert!(until.is_none(), "{until:?} is missing");
    kept
}

#[test]
fn code_and_prose_are_told_apart() {
    let document = Document::read(
        "# A\n\nRun `a b`, or\n`c\nd`.\n\n    one\n\n      two\n\n* item\n    goes on\n\n```text\nthree\n```\n<!-- t -->\n`x`\n<!-- /t -->\nend\n",
    );
    assert_eq!(document.blocks, ["one\n\n  two", "three"]);
    assert_eq!(document.spans, ["a b", "c d"]);
    assert!(document.prose.contains(&"    goes on".to_owned()), "{:?}", document.prose);
    assert!(document.prose.contains(&"Run □, or".to_owned()), "{:?}", document.prose);
}
