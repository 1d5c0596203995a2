//! The pages of the reference: each document of `www/docs` becomes one, and all links between them are valid.
#[path = "../www/docs/html/site.rs"]
pub mod site;

use std::fs;
use std::path::Path;

const DOCUMENTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/docs");

#[test]
fn every_document_becomes_a_page_that_all_pages_list() {
    let files = site::files(Path::new(DOCUMENTS)).unwrap_or_else(|mistakes| panic!("{mistakes}"));
    let names = fs::read_dir(DOCUMENTS).expect("www/docs").flatten().map(|entry| entry.file_name());
    let documents: Vec<_> =
        names.filter_map(|name| name.to_string_lossy().strip_suffix(".md").map(str::to_owned)).collect();
    assert!(documents.len() >= 8, "{documents:?}");
    assert_eq!(files.len(), documents.len() + 1, "a page for each document, and the style sheet");
    let pages = files.iter().filter(|(name, _)| name.ends_with(".html"));
    for (name, page) in pages {
        for document in &documents {
            let file = if document == "README" { "index" } else { document };
            assert!(page.contains(&format!("<a href=\"{file}.html\"")), "{name} does not list {file}.html");
        }
        assert!(!page.contains(".md\"") && !page.contains(".md#"), "{name} links to a document");
    }
}

#[test]
fn every_row_of_every_table_is_on_its_page() {
    let files = site::files(Path::new(DOCUMENTS)).unwrap_or_else(|mistakes| panic!("{mistakes}"));
    let mut rows = 0;
    for (name, page) in files.iter().filter(|(name, _)| name.ends_with(".html")) {
        let document = name.replace("index.html", "README.html").replace(".html", ".md");
        let text = fs::read_to_string(Path::new(DOCUMENTS).join(document)).expect("a document");
        let written = text.lines().filter(|line| line.starts_with('|') && !line.starts_with("|--")).count();
        assert_eq!(page.matches("<tr>").count(), written, "{name}");
        rows += written;
    }
    assert!(rows > 200, "{rows}");
    assert!(files["command-line.html"].contains("<pre tabindex=\"0\"><code>cargo install --path ."));
}
