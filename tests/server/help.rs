//! Hover, completion, signatures, symbols, folding, tokens, hints and links. The values are worked out by
//! hand.

use gcode_playground::server::host::NoFiles;
use serde_json::{Value, json};

use super::client::{Client, PART, at, range, usual_capabilities};

/// From X50 Z-20, U4 leads to a diameter of 54 mm and W-5 to Z-25. U8 is executed twice.
const INCREMENTS: &str = "\
O1
T0101 M3 S800 G99
G00 X50 Z2
G01 Z-20 F0.2
U4
W-5
M98 P20002
M30
O2
U8
M99
";

#[test]
fn a_hover_explains_the_word() {
    let mut client = Client::new();
    client.open(INCREMENTS);
    let hover = client.at("textDocument/hover", 4, 1);
    assert_eq!(hover["range"], range((4, 0), (4, 2)));
    assert_eq!(hover["contents"]["kind"], "markdown");
    let text = hover["contents"]["value"].as_str().expect("a text");
    assert!(text.starts_with("**U4**: ") && text.contains("* From Ø50 mm to Ø54 mm."), "{text}");
    assert_eq!(
        client.at("textDocument/hover", 7, 99)["range"],
        range((7, 0), (7, 3)),
        "the word that ends there"
    );
    let mut plain = Client::with(json!({}));
    plain.open(INCREMENTS);
    let hover = plain.at("textDocument/hover", 4, 1);
    assert_eq!(hover["contents"]["kind"], "plaintext");
    assert!(hover["contents"]["value"].as_str().is_some_and(|text| text.starts_with("U4: ")), "{hover}");
}

/// G90: 32 mm and 6 mm at 800 × 0.2 = 160 mm/min, 6 mm and 32 mm at the assumed rapid of 8,000 mm/min:
/// 12 + 2.25 + 0.285 = 14.535 s; the next line, to X46: 12 + 3 + (8 + 32) / 8000 * 60 = 15.3 s.
const PASSES: &str = "O1\nT0101 M3 S800 G99\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nX46\nG00 X100 Z100\nM30\n";

#[test]
fn lenses_show_times_and_passes_on_request() {
    let mut client = Client::new();
    client.open(PASSES);
    assert_eq!(client.whole("textDocument/codeLens"), Value::Null, "off by default");
    let lenses = |locale: &str| {
        let mut client = Client::with_options(json!({"codeLens": true}), locale);
        client.open(PASSES);
        let lenses = client.whole("textDocument/codeLens");
        let row = |lens: &Value| {
            let line = lens["range"]["start"]["line"].as_u64().expect("a line");
            (line, lens["command"]["title"].as_str().expect("a title").to_owned())
        };
        lenses.as_array().expect("a list").iter().map(row).collect::<Vec<_>>()
    };
    let found = lenses("en");
    assert_eq!(found[1], (3, "2 passes, 0:29.8".to_owned()));
    assert_eq!((found.len(), found[0].0), (2, 1));
    // The approach is from an unknown place; the rapid to X100 Z100 adds less than a second.
    assert!(found[0].1.starts_with("0:3"), "{found:?}");
    assert_eq!(lenses("zh-cn")[1].1, "走刀 2 次，0:29.8");
    assert_eq!(lenses("ru")[1].1, "проходов: 2, 0:29.8");
}

#[test]
fn hints_and_lenses_are_requested_again_after_a_change_of_files() {
    let mut capabilities = usual_capabilities();
    capabilities["workspace"] =
        json!({"inlayHint": {"refreshSupport": true}, "codeLens": {"refreshSupport": true}});
    let params = json!({"capabilities": capabilities, "initializationOptions": {"codeLens": true}});
    let mut client = Client::begun(NoFiles::default(), params);
    client.open(PASSES);
    client.received.clear();
    client.notify("workspace/didChangeWatchedFiles", json!({"changes": []}));
    let methods = client.received.iter().filter_map(|message| message["method"].as_str());
    let asked: Vec<&str> = methods.filter(|method| method.ends_with("/refresh")).collect();
    assert_eq!(asked, ["workspace/inlayHint/refresh", "workspace/codeLens/refresh"]);
}

/// The subprogram cuts 32 mm at 160 mm/min, in 12 s, with the first tool; the second one moves 32 mm at rapid.
const CALLED: &str = "\
O1
T0101 M3 S800 G99
M98 P2
T0202
G00 X62 Z2
M30
O2
G00 X62 Z2
G01 Z-30 F0.2
M99
";

#[test]
fn the_time_of_a_subprogram_is_that_of_the_tool_in_use() {
    let mut client = Client::with_options(json!({"codeLens": true}), "en");
    client.open(CALLED);
    let lenses = client.whole("textDocument/codeLens");
    assert_eq!(lenses.as_array().map(Vec::len), Some(2), "{lenses}");
    let title = |index: usize| lenses[index]["command"]["title"].as_str().expect("a title");
    // With the approach from the position at power-on.
    assert!(["0:12", "0:13"].contains(&&title(0)[..4]), "{lenses}");
    assert_eq!(title(1), "0:00.2");
}

/// Line, character and label of the hints in a range.
fn hints(client: &mut Client, range: Value) -> Vec<(u64, u64, String)> {
    let params = json!({"textDocument": {"uri": PART}, "range": range});
    let hints = client.request("textDocument/inlayHint", params);
    let row = |hint: &Value| {
        let number = |name: &str| hint["position"][name].as_u64().expect("a number");
        (number("line"), number("character"), hint["label"].as_str().expect("a label").to_owned())
    };
    hints.as_array().expect("a list").iter().map(row).collect()
}

#[test]
fn codes_feeds_and_passes_are_hints_on_request() {
    let with = |options: Value, locale: &str| {
        let mut client = Client::with_options(options, locale);
        client.open(PASSES);
        hints(&mut client, range((0, 0), (7, 0)))
    };
    assert_eq!(with(json!({}), "en"), [], "off by default");
    let row = |line, character, label: &str| (line, character, label.to_owned());
    let all = json!({"hints": ["code", "feed", "passes"]});
    // F0.2 at 800 rpm is 160 mm/min.
    let expected = [row(3, 3, "1 pass"), row(3, 17, "160 mm/min"), row(4, 0, "G90")];
    assert_eq!(with(all.clone(), "en"), expected);
    let expected = [row(3, 3, "走刀 1 次"), row(3, 17, "160 mm/min"), row(4, 0, "G90")];
    assert_eq!(with(all, "zh-cn"), expected);
    assert_eq!(with(json!({"hints": ["code"]}), "en"), [row(4, 0, "G90")]);
}

#[test]
fn hints_show_where_increments_lead() {
    let mut client = Client::new();
    client.open(INCREMENTS);
    let all = hints(&mut client, range((0, 0), (11, 0)));
    assert_eq!(all, [(4, 2, "X54".to_owned()), (5, 3, "Z-25".to_owned())]);
    assert_eq!(hints(&mut client, range((5, 0), (5, 0))), [(5, 3, "Z-25".to_owned())]);
    client.change(json!([{"range": range((4, 1), (4, 2)), "text": "10"}]));
    assert_eq!(hints(&mut client, range((4, 0), (4, 0))), [(4, 3, "X60".to_owned())]);
}

#[test]
fn completion_proposes_values_and_replaces_what_was_typed() {
    let mut client = Client::with_setup(r#"{"stock": {"diameter": 40, "length": 60}}"#);
    client.open("O1\nT0101 M3 S800 F0.2\nG00 X42 Z2\nG01 X\n");
    let list = client.at("textDocument/completion", 3, 5);
    let items = list["items"].as_array().expect("a list");
    let labels: Vec<&str> = items.iter().filter_map(|item| item["label"].as_str()).collect();
    assert_eq!(labels, ["X40", "X42", "X0"], "the blank, the tool, the axis");
    assert_eq!(items[0]["textEdit"], json!({"range": range((3, 4), (3, 5)), "newText": "X40"}));
    assert_eq!((&items[0]["sortText"], &items[1]["sortText"]), (&json!("0000"), &json!("0001")));
    client.change(json!([{"range": range((3, 5), (3, 5)), "text": "30 "}]));
    let mut params = at(3, 8);
    params["context"] = json!({"triggerKind": 3});
    assert_eq!(client.request("textDocument/completion", params), Value::Null, "nobody asked for a list");
}

#[test]
fn a_cycle_is_a_snippet_with_fields() {
    let text = "O1\nT0101 M3 S800 F0.2\nG00 X42 Z2\nrough\n";
    let item = |client: &mut Client| {
        client.open(text);
        let list = client.at("textDocument/completion", 3, 5);
        let mut items = list["items"].as_array().expect("a list").clone().into_iter();
        items.find(|item| item["label"].as_str().is_some_and(|label| label.starts_with("G71"))).expect("G71")
    };
    let snippet = item(&mut Client::new());
    assert_eq!((&snippet["insertTextFormat"], &snippet["kind"]), (&json!(2), &json!(15)));
    assert_eq!(snippet["filterText"], "rough", "or the client would drop it");
    assert!(
        snippet["textEdit"]["newText"].as_str().is_some_and(|text| text.starts_with("G71 U${1:")),
        "{snippet}"
    );
    let plain = item(&mut Client::with(json!({})));
    assert_eq!(plain.get("insertTextFormat"), None);
    assert!(plain["textEdit"]["newText"].as_str().is_some_and(|text| !text.contains('$')), "{plain}");
}

#[test]
fn a_signature_marks_the_word_at_the_cursor() {
    let mut client = Client::new();
    client.open("O1\nT0101 M3 S800\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nM30\n");
    let help = client.at("textDocument/signatureHelp", 3, 6);
    let signature = &help["signatures"][0];
    let label = signature["label"].as_str().expect("a label");
    assert!(label.starts_with("G90 [X/U] [Z/W]"), "of a modal cycle all words can be left out: {label}");
    assert_eq!((&help["activeSignature"], &help["activeParameter"]), (&json!(0), &json!(0)));
    assert_eq!(signature["parameters"][1]["label"], json!([10, 15]), "[Z/W]");
    assert_eq!(client.at("textDocument/signatureHelp", 3, 10)["activeParameter"], 1);
    assert_eq!(client.at("textDocument/signatureHelp", 4, 3), Value::Null, "M30 has no words");
}

const TWO_PROGRAMS: &str = "O1 (A)\nT0101\nG0 X1\nM98 P2\nM30\nO2 (B)\nM99\n";

#[test]
fn symbols_are_nested_as_in_the_outline() {
    let mut client = Client::new();
    client.open(TWO_PROGRAMS);
    let symbols = client.whole("textDocument/documentSymbol");
    let tool = json!({
        "name": "T0101", "kind": 5, "range": range((1, 0), (4, 3)), "selectionRange": range((1, 0), (1, 5)),
    });
    let expected = json!([
        {"name": "O1", "detail": "A", "kind": 2, "range": range((0, 0), (4, 3)),
         "selectionRange": range((0, 0), (0, 6)), "children": [tool]},
        {"name": "O2", "detail": "B", "kind": 2, "range": range((5, 0), (6, 3)), "selectionRange": range((5, 0), (5, 6))},
    ]);
    assert_eq!(symbols, expected);
    let mut flat = Client::with(json!({}));
    flat.open(TWO_PROGRAMS);
    let symbols = flat.whole("textDocument/documentSymbol");
    let names: Vec<_> = symbols.as_array().expect("a list").iter().map(|symbol| &symbol["name"]).collect();
    assert_eq!(names, ["O1", "T0101", "O2"]);
    assert_eq!(symbols[1]["location"], json!({"uri": PART, "range": range((1, 0), (1, 5))}));
}

#[test]
fn programs_and_tools_can_be_folded() {
    let mut client = Client::new();
    client.open(TWO_PROGRAMS);
    let folds = client.whole("textDocument/foldingRange");
    let lines = |fold: &Value| (fold["startLine"].as_u64(), fold["endLine"].as_u64());
    let lines: Vec<_> = folds.as_array().expect("a list").iter().map(lines).collect();
    assert_eq!(lines, [(Some(0), Some(4)), (Some(1), Some(4)), (Some(5), Some(6))]);
}

#[test]
fn programs_of_all_documents_are_found() {
    let mut client = Client::new();
    client.open(TWO_PROGRAMS);
    client.open_as("file:///shaft.nc", "O2000 (SHAFT)\nM99\n");
    let found = |client: &mut Client, query: &str| {
        let found = client.request("workspace/symbol", json!({"query": query}));
        let name = |symbol: &Value| symbol["name"].as_str().expect("a name").to_owned();
        found.as_array().expect("a list").iter().map(name).collect::<Vec<_>>()
    };
    assert_eq!(found(&mut client, "O2"), ["O2", "O2000"]);
    assert_eq!(found(&mut client, "shaft"), ["O2000"]);
    assert_eq!(found(&mut client, "").len(), 3);
    assert_eq!(found(&mut client, "X"), Vec::<String>::new());
}

#[test]
fn tokens_are_relative_to_each_other() {
    let mut client = Client::new();
    client.open("G00 X1 (外)\nN10 M30\n");
    // Line, start, length, type (keyword, variable, comment; label, function), modifiers.
    let expected =
        [[0, 0, 3, 1, 0], [0, 4, 2, 3, 0], [0, 3, 3, 0, 0], [1, 0, 3, 5, 0], [0, 4, 3, 2, 0]].concat();
    assert_eq!(client.whole("textDocument/semanticTokens/full")["data"], json!(expected));
    let params = json!({"textDocument": {"uri": PART}, "range": range((1, 2), (1, 3))});
    let part = client.request("textDocument/semanticTokens/range", params);
    assert_eq!(part["data"], json!([[1, 0, 3, 5, 0], [0, 4, 3, 2, 0]].concat()), "whole lines");
}

#[test]
fn tokens_of_a_long_text_are_sent_in_parts_only() {
    let mut client = Client::new();
    let text = "G01 X10. Z-5.\n".repeat((2 << 20) / 14 + 1);
    client.open(&text);
    assert_eq!(client.whole("textDocument/semanticTokens/full"), Value::Null);
    let params = json!({"textDocument": {"uri": PART}, "range": range((70_000, 0), (70_000, 1))});
    let part = client.request("textDocument/semanticTokens/range", params);
    let expected = [[70_000, 0, 3, 1, 0], [0, 4, 4, 3, 0], [0, 5, 4, 3, 0]].concat();
    assert_eq!(part["data"], json!(expected));
}

#[test]
fn rules_in_comments_lead_to_their_pages() {
    let text = "(RULES NO-PROGRAM-END=OFF CLASSROOM=WARNING)\nG00 X50\nM30\n";
    let mut client = Client::with_options(json!({"pages": "https://example.org"}), "en");
    client.open(text);
    let target = "https://example.org/rules/en/no-program-end.html";
    assert_eq!(
        client.whole("textDocument/documentLink"),
        json!([{"range": range((0, 7), (0, 21)), "target": target}])
    );
    let mut without = Client::new();
    without.open(text);
    assert_eq!(without.whole("textDocument/documentLink"), json!([]));
    assert_eq!(without.error("textDocument/documentLink", at(0, 0)["position"].clone()), -32602);
}
