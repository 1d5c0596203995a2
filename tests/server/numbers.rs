//! Definition, references, highlights and renaming of numbers.

use serde_json::{Value, json};

use super::client::{Client, PART, at, edited, range};

/// A contour from N10 to N20 that G71 and G70 name.
const CONTOUR: &str = "\
O1
T0101 M3 S800
G0 X52 Z2
G71 U2 R1
G71 P10 Q20 U0.4 W0.1 F0.3
N10 G0 X30
G1 Z-10 F0.1
N20 X50 Z-20
G70 P10 Q20
M30
";

fn places(list: &Value) -> Vec<Value> {
    list.as_array().expect("a list").iter().map(|one| one["range"].clone()).collect()
}

#[test]
fn a_number_leads_to_its_block() {
    let mut client = Client::new();
    client.open(CONTOUR);
    assert_eq!(
        client.at("textDocument/definition", 4, 6),
        json!([{"uri": PART, "range": range((5, 0), (5, 3))}])
    );
    assert_eq!(
        client.at("textDocument/definition", 5, 1),
        json!([{"uri": PART, "range": range((5, 0), (5, 3))}])
    );
    assert_eq!(client.at("textDocument/definition", 2, 0), json!([]), "no number");
}

#[test]
fn a_program_is_found_in_another_document() {
    let mut client = Client::new();
    client.open("O1\nM98 P2000\nM30\n");
    client.open_as("file:///sub.nc", "(a)\nO2000 (SUB)\nM99\n");
    let found = client.at("textDocument/definition", 1, 6);
    assert_eq!(found, json!([{"uri": "file:///sub.nc", "range": range((1, 0), (1, 11))}]));
}

#[test]
fn all_uses_of_a_number_are_found() {
    let mut client = Client::new();
    client.open(CONTOUR);
    let all = [range((4, 4), (4, 7)), range((5, 0), (5, 3)), range((8, 4), (8, 7))];
    let mut params = at(5, 2);
    params["context"] = json!({"includeDeclaration": true});
    assert_eq!(places(&client.request("textDocument/references", params.clone())), all);
    params["context"] = json!({"includeDeclaration": false});
    assert_eq!(places(&client.request("textDocument/references", params)), [all[0].clone(), all[2].clone()]);
    let highlights = client.at("textDocument/documentHighlight", 8, 5);
    assert_eq!(places(&highlights), all);
    let kinds: Vec<_> =
        highlights.as_array().expect("a list").iter().map(|one| one["kind"].as_u64()).collect();
    assert_eq!(kinds, [Some(2), Some(3), Some(2)], "read, written, read");
}

/// Renames the number at a position of the usual document.
fn rename(client: &mut Client, line: u32, character: u32, new: &str) -> Value {
    let mut params = at(line, character);
    params["newName"] = json!(new);
    client.answer("textDocument/rename", params)
}

#[test]
fn a_rename_changes_the_block_and_all_words_that_name_it() {
    let mut client = Client::new();
    client.open(CONTOUR);
    let word = client.at("textDocument/prepareRename", 5, 2);
    assert_eq!(word, json!({"range": range((5, 0), (5, 3)), "placeholder": "N10"}));
    let after = CONTOUR.replace("N10", "N15").replace("P10", "P15");
    for (line, character) in [(5, 2), (4, 5), (8, 7)] {
        let answer = rename(&mut client, line, character, "N15");
        assert_eq!(edited(CONTOUR, &answer["result"]), after);
    }
    assert_eq!(client.at("textDocument/prepareRename", 2, 1), Value::Null, "no number");
}

#[test]
fn a_rename_is_refused_with_its_reason() {
    let refused = |text: &str, line: u32, character: u32, new: &str| {
        let mut client = Client::new();
        client.open(text);
        let answer = rename(&mut client, line, character, new);
        assert_eq!(answer["error"]["code"], -32803, "{answer}");
        answer["error"]["message"].as_str().expect("a sentence").to_owned()
    };
    assert_eq!(refused(CONTOUR, 5, 1, "N20"), "line 5 uses this number already");
    assert_eq!(refused(CONTOUR, 5, 1, "ten"), "enter a number: N20");
    let jump = "O1\n#1=10\nGOTO #1\nN10 M30\n";
    assert_eq!(refused(jump, 3, 1, "N20"), "line 3 computes a number that may be this one");
    assert_eq!(refused("G00 X50\nM30\n", 0, 6, "5"), "there is no number here that can be renamed");
}

/// The line end of a call with a letter of macro A: P is the number of a block.
#[test]
fn a_jump_of_macro_a_follows_its_block() {
    let text = "O1\nG65 H80 P30\nG0 X1\nN30 M30\n";
    let mut client = Client::with_setup(r#"{"dialect": {"control": "gsk"}}"#);
    client.open(text);
    let answer = rename(&mut client, 3, 1, "N40");
    assert_eq!(edited(text, &answer["result"]), "O1\nG65 H80 P40\nG0 X1\nN40 M30\n");
}
