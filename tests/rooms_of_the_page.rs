//! The layers of the TypeScript of the page, as listed in ARCHITECTURE.md: no import leads to a higher layer,
//! and imports form no circle.
//!
//! In: the list in ARCHITECTURE.md and the relative imports of every file of `www/src`, including worker
//! scripts.

use crate::circle;
use crate::project;
use std::collections::{BTreeMap, BTreeSet};

use circle::leading_into_circles;

/// The imports of each file. All paths are `layer/name`, without `.ts`.
type Imports = BTreeMap<String, BTreeSet<String>>;

/// The layers in the order of ARCHITECTURE.md, lowest first.
fn layers(architecture: &str) -> Vec<String> {
    let after = architecture.split("The layers of `www/src`").nth(1).expect("the list of layers");
    let rows = after.lines().skip_while(|line| !line.starts_with('|')).skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    rows.filter_map(|row| row.split('`').nth(1)).map(str::to_owned).collect()
}

/// The imports of a file from other files of the page: `from '…'`, `import '…'`, `import('…')`, including
/// worker scripts.
fn imports(file: &str, text: &str) -> BTreeSet<String> {
    let before = ["from '", "import '", "import('"];
    let quoted = before.iter().flat_map(|before| text.split(before).skip(1));
    quoted
        .filter_map(|rest| rest.split('\'').next())
        .filter(|path| path.starts_with('.'))
        .filter_map(|path| resolved(file, path))
        .collect()
}

/// A relative path as `layer/name`; `None` if it is not a TypeScript file of the page.
fn resolved(file: &str, path: &str) -> Option<String> {
    let mut parts: Vec<&str> = file.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop()?;
            }
            name => parts.push(name),
        }
    }
    let joined = parts.join("/");
    let other = [".css", ".json", ".js", ".wasm", "?inline"].iter().any(|ending| joined.ends_with(ending));
    (!other).then(|| joined.trim_end_matches("?worker&url").trim_end_matches(".ts").to_owned())
}

/// The violations of the import order.
fn faults(layers: &[String], files: &Imports) -> Vec<String> {
    let rank = |file: &str| {
        let layer = file.split_once('/').map_or("", |(layer, _)| layer);
        layers.iter().position(|known| known == layer)
    };
    let mut faults = Vec::new();
    for (file, imported) in files {
        let Some(own) = rank(file) else {
            faults.push(format!("{file} stands in no layer"));
            continue;
        };
        for other in imported {
            if !files.contains_key(other) {
                faults.push(format!("{file} imports {other}, which is not there"));
            } else if rank(other).is_none_or(|other| other > own) {
                faults.push(format!("{file} imports {other}, which is in a higher layer"));
            }
        }
    }
    let circle: Vec<String> = leading_into_circles(files.clone()).into_keys().collect();
    if !circle.is_empty() {
        faults.push(format!("a circle: {circle:?}"));
    }
    faults
}

fn files_of_the_page() -> Imports {
    let files = project::files();
    let scripts =
        files.iter().filter_map(|file| Some((file, file.strip_prefix("www/src/")?.strip_suffix(".ts")?)));
    scripts.map(|(file, name)| (name.to_owned(), imports(name, &project::source(file)))).collect()
}

#[test]
fn imports_of_the_page_lead_to_lower_layers_and_form_no_circle() {
    let architecture = project::source("ARCHITECTURE.md");
    let (layers, files) = (layers(&architecture), files_of_the_page());
    assert!(layers.len() > 5 && files.len() > 50, "{layers:?}, {} files", files.len());
    let known: BTreeSet<&str> = files.keys().filter_map(|file| Some(file.split_once('/')?.0)).collect();
    assert_eq!(known, layers.iter().map(String::as_str).collect(), "the folders of www/src are the layers");
    let faults = faults(&layers, &files);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A dialog is one file and one line: the shell knows the panels only by their lists, one for initial and one
/// for later loading, and no panel imports another.
#[test]
fn panels_are_known_by_their_list_alone() {
    let files = files_of_the_page();
    let lists = ["panels/index", "panels/further", "panels/with-playback", "panels/with-code"];
    let listed: BTreeSet<&String> = lists
        .iter()
        .flat_map(|list| &files[*list])
        .filter(|file| {
            file.starts_with("panels/") && *file != "panels/panel" && !lists.contains(&file.as_str())
        })
        .collect();
    assert!(listed.len() > 10, "{listed:?}");
    for (file, imported) in files.iter().filter(|(file, _)| !lists.contains(&file.as_str())) {
        let others: Vec<_> = imported.iter().filter(|other| listed.contains(other)).collect();
        assert!(others.is_empty(), "{file} imports the panels {others:?}");
        let from_outside = !file.starts_with("panels/");
        let inner: Vec<_> = imported.iter().filter(|other| other.starts_with("panels/")).collect();
        let known = [&lists[..], &["panels/panel"]].concat();
        assert!(
            !from_outside || inner.iter().all(|other| known.contains(&other.as_str())),
            "{file} imports {inner:?}"
        );
    }
}

#[test]
fn an_import_of_a_higher_layer_and_a_circle_are_found() {
    let order = ["dom", "panels"].map(str::to_owned);
    let page = |files: &[(&str, &str)]| {
        files.iter().map(|(file, text)| ((*file).to_owned(), imports(file, text))).collect::<Imports>()
    };
    let good = page(&[
        ("dom/make", ""),
        ("panels/help", "import type {\n  A,\n} from '../dom/make';\nconst later = import('./list');"),
        ("panels/list", "import './help.css';"),
    ]);
    assert_eq!(good["panels/help"].len(), 2);
    assert_eq!(faults(&order, &good), [""; 0]);
    let upward =
        page(&[("dom/make", "import script from '../panels/help.ts?worker&url';"), ("panels/help", "")]);
    assert_eq!(faults(&order, &upward), ["dom/make imports panels/help, which is in a higher layer"]);
    let round = page(&[("dom/a", "import { b } from './b';"), ("dom/b", "import type { A } from './a';")]);
    assert_eq!(faults(&order, &round), [r#"a circle: ["dom/a", "dom/b"]"#]);
    let astray = page(&[("dom.ts", "import './dom/none';")]);
    assert_eq!(faults(&order, &astray), ["dom.ts stands in no layer"]);
}
