//! The statements of the seed documents, and where each is shown: `tests/seed_statements/list.tsv`.
//!
//! In: the list, with a row for each statement, paraphrased. Out: the targets that do not exist. Targets:
//! `program ID` (of `tests/programs`, whose motions `tests/programs.rs` checks), `rule SLUG`,
//! `test FILE::NAME`, `fixture FILE`, `page NAME` or `page NAME#ANCHOR` (of the manual; a heading of its
//! English page), `open REASON` (not done). Each row has a page.
use crate::reference_pages::site;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const LIST: &str = "tests/seed_statements/list.tsv";

/// A statement of a seed document.
struct Row<'a> {
    seed: &'a str,
    says: &'a str,
    targets: Vec<&'a str>,
}

/// The rows of a list. The error names an invalid line.
fn rows(list: &str) -> Result<Vec<Row<'_>>, String> {
    let lines = list.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
    let row = |line| {
        let cells: Vec<&str> = str::split(line, '\t').collect();
        let &[seed, says, targets] = &cells[..] else {
            return Err(format!("not three cells: {line}"));
        };
        let targets = targets.split("; ").collect();
        Ok(Row { seed, says, targets })
    };
    lines.map(row).collect()
}

/// The reason why a target is invalid, if it is.
fn fault(target: &str) -> Option<String> {
    let (kind, name) = target.split_once(' ').unwrap_or((target, ""));
    let is_there = |path: String| Path::new(&path).is_file();
    let found = match kind {
        "program" => is_there(format!("tests/programs/{name}/motions.jsonl")),
        "rule" => is_there(format!("src/rules/{name}.md")),
        "test" => is_test(name),
        "fixture" => is_there(name.to_owned()),
        "page" => is_page(name),
        "open" => name.split_whitespace().count() >= 3,
        _ => return Some(format!("`{kind}` is no kind of target")),
    };
    (!found).then(|| format!("`{target}` is not there"))
}

/// Whether the manual has this page, and the English page the heading: `NAME` or `NAME#ANCHOR`.
fn is_page(name: &str) -> bool {
    let (page, wanted) = name.split_once('#').map_or((name, None), |(page, anchor)| (page, Some(anchor)));
    let Ok(text) = fs::read_to_string(format!("www/manual/en/{page}.md")) else { return false };
    wanted.is_none_or(|wanted| {
        let mut titles = text.lines().filter(|line| line.starts_with('#'));
        titles.any(|title| site::anchor(title.trim_start_matches('#').trim()) == wanted)
    })
}

/// Whether a file contains the named test: `FILE::NAME`.
fn is_test(name: &str) -> bool {
    let Some((file, function)) = name.split_once("::") else { return false };
    let Ok(text) = fs::read_to_string(file) else { return false };
    if file.ends_with(".ts") {
        return text.contains(&format!("test('{function}'"))
            || text.contains(&format!("test(\"{function}\""));
    }
    text.split("#[test]").skip(1).any(|rest| {
        let head = rest.split_once("fn ").map_or("", |(_, after)| after);
        head.strip_prefix(function).is_some_and(|after| after.starts_with('('))
    })
}

/// The faults in a list.
fn faults(list: &str) -> Vec<String> {
    let rows = match rows(list) {
        Ok(rows) => rows,
        Err(why) => return vec![why],
    };
    let mut faults = Vec::new();
    let mut known = BTreeMap::new();
    for row in &rows {
        if known.insert((row.seed, row.says), ()).is_some() {
            faults.push(format!("{}, {}: twice", row.seed, row.says));
        }
        let own = row.targets.iter().filter_map(|target| fault(target));
        faults.extend(own.map(|why| format!("{}, {}: {why}", row.seed, row.says)));
    }
    faults
}

#[test]
fn every_statement_of_the_seeds_is_shown_somewhere() {
    let list = fs::read_to_string(LIST).expect(LIST);
    assert_eq!(faults(&list), Vec::<String>::new());
    let rows = rows(&list).expect("rows");
    let of = |seed: &str| rows.iter().filter(|row| row.seed == seed).count();
    let counts = ["000", "001", "002", "003", "004"].map(of);
    assert!(counts.iter().all(|count| *count >= 10), "{counts:?}");
    assert_eq!(counts.iter().sum::<usize>(), rows.len(), "a row of another seed");
    let off_page = rows.iter().filter(|row| !row.targets.iter().any(|target| target.starts_with("page ")));
    let off_page: Vec<&str> = off_page.map(|row| row.says).collect();
    assert_eq!(off_page, Vec::<&str>::new(), "on no page of the manual");
    let open = rows.iter().filter(|row| row.targets.iter().any(|target| target.starts_with("open ")));
    for row in open {
        println!("open: {}, {}: {}", row.seed, row.says, row.targets.join("; "));
    }
}

/// The list names each program that is transcribed from a seed.
#[test]
fn every_program_of_the_seeds_is_on_the_list() {
    let list = fs::read_to_string(LIST).expect(LIST);
    let programs = fs::read_dir("tests/programs").expect("programs").flatten();
    let of_seeds = programs
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|id| id.starts_with("s0"));
    let missing: Vec<String> = of_seeds
        .filter(|id| !list.split(['\t', ';', '\n']).any(|target| target.trim() == format!("program {id}")))
        .collect();
    assert_eq!(missing, Vec::<String>::new());
}

#[test]
fn a_target_that_is_gone_is_found() {
    let target = |target: &str| faults(&format!("000\tSays something\t{target}")).len();
    for there in [
        "program s000-o0002",
        "rule thread-angle",
        "test tests/seed_statements.rs::a_target_that_is_gone_is_found",
        "page g90",
        "page g90#step-by-step",
    ] {
        assert_eq!(target(there), 0, "{there}");
    }
    for gone in [
        "program s000-o9999",
        "rule no-such-rule",
        "test tests/seed_statements.rs::a_target",
        "test tests/seed_statements.rs::rows",
        "test tests/no_such_file.rs::name",
        "page none",
        "page g90#none",
        "page www/docs/setup.md",
        "manual when to take G90",
        "open",
        "elsewhere",
    ] {
        assert_eq!(target(gone), 1, "{gone}");
    }
    assert_eq!(faults("000\tTwo cells").len(), 1);
    assert_eq!(faults("000\tA\trule thread-angle\n000\tA\trule thread-angle").len(), 1);
}
