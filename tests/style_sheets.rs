//! The style sheets of the page take colours, distances, text sizes, radii, layers and heights of controls from
//! the tokens.
//!
//! In: `www/src/tokens.css` and every other style sheet of `www/src`.

use crate::project;
use std::collections::BTreeSet;

const TOKENS: &str = "www/src/tokens.css";

/// Declarations with a literal that no token can replace: file, property, value.
const EXCEPTIONS: [(&str, &str, &str); 3] = [
    // In the units of the drawing.
    ("www/src/page/compare.css", "font", "12px var(--playground-font)"),
    ("www/src/panels/setup.css", "font-size", "9px"),
    // The rulers of the drawing.
    ("www/src/panels/labels.css", "inset", "0 0 max(26px, 1.625rem) max(46px, 2.875rem)"),
];

/// A declaration of a style sheet.
#[derive(Debug, PartialEq)]
struct Declaration {
    property: String,
    value: String,
}

/// The declarations of a style sheet, without its comments and selectors.
fn declarations(sheet: &str) -> Vec<Declaration> {
    let without_comments: String = sheet
        .split("/*")
        .enumerate()
        .map(|(at, part)| if at == 0 { part } else { part.split_once("*/").map_or("", |(_, after)| after) })
        .collect();
    let mut found = Vec::new();
    let mut start = 0;
    for (at, end) in without_comments.match_indices([';', '{', '}']) {
        let piece = &without_comments[start..at];
        start = at + 1;
        // Before a brace is a selector.
        if end == "{" {
            continue;
        }
        if let Some((property, value)) = piece.split_once(':') {
            found.push(Declaration { property: property.trim().into(), value: value.trim().into() });
        }
    }
    found
}

/// The words of a value: `calc(1rem + var(--x))` has `calc`, `1rem`, `+`, `var` and `--x`.
fn words(value: &str) -> impl Iterator<Item = &str> {
    value.split([' ', '(', ')', ',', '/', '\n']).filter(|word| !word.is_empty())
}

/// Whether a word is a length in pixels or in root text sizes, except the width of a line.
fn is_length(word: &str) -> bool {
    let number = word.strip_suffix("rem").or_else(|| word.strip_suffix("px"));
    number.is_some_and(|number| number.parse::<f64>().is_ok()) && !["1px", "-1px", "0rem"].contains(&word)
}

fn is_colour(word: &str) -> bool {
    let is_hex =
        word.strip_prefix('#').is_some_and(|digits| digits.chars().all(|digit| digit.is_ascii_hexdigit()));
    is_hex || ["rgb", "rgba", "hsl", "hsla", "oklch", "white", "black"].contains(&word)
}

/// Whether the distances of this property are on the scale.
fn is_distance(property: &str) -> bool {
    let families = ["padding", "margin", "inset", "scroll-padding", "scroll-margin"];
    let is_side = |family: &str| {
        property.strip_prefix(family).is_some_and(|side| side.is_empty() || side.starts_with('-'))
    };
    families.into_iter().any(is_side) || ["gap", "row-gap", "column-gap"].contains(&property)
}

/// The literals of a declaration that a token should replace.
fn literals(Declaration { property, value }: &Declaration) -> Vec<String> {
    let is_font = ["font", "font-size"].contains(&property.as_str());
    let is_radius = property.starts_with("border") && property.ends_with("radius");
    // Heights of buttons and fields: 28, 36 and 44 px.
    let is_height =
        |word: &str| property == "min-block-size" && ["1.75rem", "2.25rem", "2.75rem"].contains(&word);
    let mut found: Vec<String> = words(value)
        .filter(|word| {
            is_colour(word)
                || is_length(word) && (is_distance(property) || is_font || is_radius)
                || is_height(word)
        })
        .map(str::to_owned)
        .collect();
    if property == "z-index" && !value.starts_with("var(") {
        found.push(value.clone());
    }
    found
}

/// The custom properties of a kind that are declared (`before` is empty) or used (`before` is `var(`).
fn named<'a>(sheet: &'a str, before: &'a str) -> BTreeSet<&'a str> {
    let kinds = ["space-", "type-", "radius", "layer-", "control", "icon"];
    sheet
        .split(before)
        .skip(1)
        .filter_map(|rest| rest.split([')', ':', ',', ' ', ';']).next())
        .filter(|name| {
            let name = name.strip_prefix("--playground-").unwrap_or_default();
            // The text size of the user is a property of the element.
            name != "type-size" && kinds.iter().any(|kind| name.starts_with(kind))
        })
        .collect()
}

#[test]
fn style_sheets_take_their_values_from_the_tokens() {
    let declared = project::source(TOKENS);
    let declared =
        named(&declared, "\n  ").into_iter().chain(named(&declared, "\n    ")).collect::<BTreeSet<_>>();
    assert!(declared.len() > 20, "{declared:?}");
    let sheets: Vec<String> = project::files()
        .into_iter()
        .filter(|file| file.starts_with("www/src/") && file.ends_with(".css") && file != TOKENS)
        .collect();
    assert!(sheets.len() > 30, "{sheets:?}");
    let mut faults = Vec::new();
    for file in &sheets {
        let sheet = project::source(file);
        for declaration in declarations(&sheet) {
            let Declaration { property, value } = &declaration;
            if EXCEPTIONS.contains(&(file, property, value)) {
                continue;
            }
            let found = literals(&declaration);
            if !found.is_empty() {
                faults.push(format!("{file}: {property}: {value}: {}", found.join(", ")));
            }
        }
        let unknown: Vec<_> =
            named(&sheet, "var(").difference(&declared).copied().map(str::to_owned).collect();
        faults.extend(unknown.into_iter().map(|name| format!("{file}: {name} is no token")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn literals_are_found_in_declarations_alone() {
    let sheet = "/* 4px: no; */ a:hover > .b { margin: -0.35rem auto; border: 1px solid #fff; z-index: 3 }
        @media (width < 40rem) { .c { padding: calc(1rem + var(--playground-space-1)); inset: 1px 0 50%; min-block-size: 2.25rem; } }";
    let found: Vec<_> =
        declarations(sheet).iter().map(|each| (each.property.clone(), literals(each))).collect();
    let expected = [
        ("margin", vec!["-0.35rem"]),
        ("border", vec!["#fff"]),
        ("z-index", vec!["3"]),
        ("padding", vec!["1rem"]),
        ("inset", vec![]),
        ("min-block-size", vec!["2.25rem"]),
    ];
    let expected = expected.map(|(property, found)| {
        (property.to_owned(), found.into_iter().map(str::to_owned).collect::<Vec<_>>())
    });
    assert_eq!(found, expected);
    let font = Declaration { property: "font".into(), value: "0.8125rem/1.5 monospace".into() };
    assert_eq!(literals(&font), ["0.8125rem"]);
}
