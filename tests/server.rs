//! The language server, asked as an editor asks it: lifecycle, messages, fixes, help, navigation and
//! renaming.
#[path = "server/client.rs"]
mod client;
#[path = "server/edits.rs"]
mod edits;
#[path = "server/help.rs"]
mod help;
#[path = "server/numbers.rs"]
mod numbers;
#[path = "server/stream.rs"]
mod stream;
#[path = "server/wrong.rs"]
mod wrong;

use client::{Client, PART, at, edited, range, usual_capabilities};
use gcode_playground::analyze;
use gcode_playground::sentences::Language;
use gcode_playground::server::Options;
use gcode_playground::server::host::NoFiles;
use gcode_playground::setup::Setup;
use serde_json::{Value, json};

/// The X in line 4 has no number.
const FAULTY: &str = "M03 S500\nG00 X50 Z2\nG01 Z-30 F0.1\nG01 X\nM30\n";

// ---- lifecycle ------------------------------------------------------------------------------------

#[test]
fn a_session_has_a_begin_and_an_end() {
    let mut client = Client::waiting(NoFiles::default(), Options::default());
    assert_eq!(client.error("textDocument/hover", at(0, 0)), -32002, "before `initialize`");
    assert_eq!(client.error("shutdown", Value::Null), -32002);
    let result = client.initialize(json!({"capabilities": {}}));
    assert_eq!(result["serverInfo"]["name"], "gcode-playground");
    let capabilities = &result["capabilities"];
    assert_eq!(capabilities["positionEncoding"], "utf-16");
    assert_eq!(capabilities["textDocumentSync"]["change"], 2, "incremental");
    assert_eq!(capabilities.get("diagnosticProvider"), None, "this client does not ask for diagnostics");
    assert_eq!(client.error("initialize", json!({"capabilities": {}})), -32600, "a second time");
    assert_eq!(client.request("shutdown", Value::Null), Value::Null);
    assert_eq!(client.error("textDocument/hover", at(0, 0)), -32600, "after `shutdown`");
    assert_eq!(client.server.exit_status(), None);
    client.notify("exit", Value::Null);
    assert_eq!(client.server.exit_status(), Some(0));
}

#[test]
fn an_exit_without_shutdown_is_an_error() {
    let mut client = Client::new();
    client.notify("exit", Value::Null);
    assert_eq!(client.server.exit_status(), Some(1));
}

#[test]
fn what_is_not_understood_is_answered_as_the_protocol_says() {
    let mut client = Client::new();
    client.open(FAULTY);
    assert_eq!(client.error("textDocument/implementation", at(0, 0)), -32601);
    assert_eq!(client.error("$/unknown", Value::Null), -32601);
    assert_eq!(client.error("textDocument/hover", json!({"position": 3})), -32602);
    assert_eq!(client.error("textDocument/hover", Value::Null), -32602);
    let other = json!({"textDocument": {"uri": "file:///other.nc"}, "position": {"line": 0, "character": 0}});
    assert_eq!(client.error("textDocument/hover", other), -32602, "not open");
    client.received.clear();
    client.send("{");
    client.notify("textDocument/unknown", json!({"a": 1}));
    client.notify("textDocument/didOpen", json!([1]));
    let expected = json!([{"code": -32700, "id": null}]);
    let found =
        client.received.iter().map(|message| json!({"code": message["error"]["code"], "id": message["id"]}));
    assert_eq!(Value::from_iter(found), expected);
}

#[test]
fn a_request_can_be_cancelled_and_is_given_up_when_its_document_changes() {
    let mut client = Client::new();
    client.open(FAULTY);
    client.received.clear();
    let first = client.begin("textDocument/hover", at(1, 5));
    let second = client.begin("textDocument/hover", at(1, 5));
    client.send(&json!({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": first}}).to_string());
    assert_eq!(
        client.received,
        [json!({
            "jsonrpc": "2.0", "id": first,
            "error": {"code": -32800, "message": "the client has cancelled the request"},
        })]
    );
    client.received.clear();
    client.change(json!([{"text": "M30\n"}]));
    assert_eq!(
        (&client.received[0]["id"], &client.received[0]["error"]["code"]),
        (&json!(second), &json!(-32801))
    );
    client.notify("$/cancelRequest", json!({"id": second}));
    client.notify("$/cancelRequest", json!({}));
    let answers = client.received.iter().filter(|message| message.get("id").is_some());
    assert_eq!(answers.count(), 1, "each request has one answer");
}

#[test]
fn a_long_request_is_answered_in_slices_and_can_be_cancelled() {
    // More blocks than one slice has.
    let text = format!("GOTO 1\nN1\n{}M30\n", "G1 X10. Z-5. F.1\n".repeat(250_000));
    let mut client = Client::new();
    client.open(&text);
    let rename =
        json!({"textDocument": {"uri": PART}, "position": {"line": 1, "character": 1}, "newName": "N5"});
    let format = json!({"textDocument": {"uri": PART}, "options": {"tabSize": 4, "insertSpaces": true}});
    for (method, params) in [("textDocument/formatting", format), ("textDocument/rename", rename)] {
        client.received.clear();
        let id = client.begin(method, params.clone());
        assert!(client.server.work().is_empty(), "{method} takes more than one slice");
        assert!(!client.server.is_idle(), "{method} waits");
        client.notify("$/cancelRequest", json!({"id": id}));
        assert_eq!(
            (&client.received[0]["id"], &client.received[0]["error"]["code"]),
            (&json!(id), &json!(-32800))
        );
        assert_eq!(client.received.len(), 1, "{method} has one answer");
        // Settings that change between two slices: the answer begins again.
        let id = client.begin(method, params);
        client.server.work();
        client.notify("workspace/didChangeConfiguration", json!({"settings": {}}));
        let answer = client.received.iter().find(|message| message["id"] == id).expect("an answer");
        assert!(answer["result"].is_array() || answer["result"].is_object(), "{method}: {answer}");
    }
}

// ---- messages -------------------------------------------------------------------------------------

#[test]
fn a_message_is_at_the_place_of_its_word() {
    let mut client = Client::new();
    let found = client.open(FAULTY);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0]["range"], range((3, 4), (3, 5)));
    assert_eq!((&found[0]["severity"], &found[0]["source"]), (&json!(1), &json!("gcode-playground")));
    assert!(
        found[0]["message"].as_str().expect("a text").to_lowercase().contains("no number"),
        "{}",
        found[0]
    );
    assert_eq!(found[0].get("codeDescription"), None, "no site is known");
    client.change(json!([{"range": range((3, 5), (3, 5)), "text": "40"}]));
    assert_eq!(client.diagnostics(PART), Vec::<Value>::new());
    client.notify("textDocument/didClose", json!({"textDocument": {"uri": PART}}));
    assert_eq!(client.diagnostics(PART), Vec::<Value>::new());
    assert_eq!(client.error("textDocument/hover", at(0, 0)), -32602, "closed");
}

#[test]
fn columns_count_utf_16_units_or_bytes() {
    let text = FAULTY.replace("G01 X\n", "(外😀) G01 X\n");
    // Units: ( 1, 外 1, 😀 2, ) 1, blank 1, `G01 ` 4: X is at 10. Bytes: 1 + 3 + 4 + 1 + 1 + 4 = 14.
    for (encodings, kind, column) in [
        (json!(["utf-8", "utf-16"]), "utf-8", 14),
        (json!(["utf-16", "utf-32"]), "utf-16", 10),
        (json!(["utf-32"]), "utf-16", 10),
    ] {
        let mut client = Client::waiting(NoFiles::default(), Options::default());
        let result =
            client.initialize(json!({"capabilities": {"general": {"positionEncodings": encodings}}}));
        assert_eq!(result["capabilities"]["positionEncoding"], kind);
        let found = client.open(&text);
        assert_eq!(found[0]["range"], range((3, column), (3, column + 1)), "{kind}");
        client.change(json!([{"range": range((3, column), (3, column + 1)), "text": "Z-31"}]));
        assert_eq!(client.diagnostics(PART), Vec::<Value>::new(), "{kind}");
    }
}

#[test]
fn a_client_that_asks_for_diagnostics_is_sent_none() {
    let mut capabilities = usual_capabilities();
    capabilities["textDocument"]["diagnostic"] = json!({});
    capabilities["workspace"] = json!({"diagnostics": {"refreshSupport": true}});
    let mut client = Client::waiting(NoFiles::default(), Options::default());
    let result = client.initialize(json!({"capabilities": capabilities}));
    assert_eq!(result["capabilities"]["diagnosticProvider"]["interFileDependencies"], true);
    client.open_as(PART, FAULTY);
    assert_eq!(client.received, Vec::<Value>::new());
    let report = client.whole("textDocument/diagnostic");
    assert_eq!((&report["kind"], &report["items"][0]["range"]), (&json!("full"), &range((3, 4), (3, 5))));
    client.notify("workspace/didChangeWatchedFiles", json!({"changes": []}));
    assert_eq!(client.received[0]["method"], "workspace/diagnostic/refresh");
}

#[test]
fn a_message_names_the_other_block() {
    // G71 can mean two blocks N20.
    let text = "O1\nT0101 M3 S800\nG0 X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X30\nG1 Z-10\nN20 X50\nN20 X52\nG0 X100\nM30\n";
    let mut client = Client::new();
    let found = client.open(text);
    let twice = found.iter().find(|one| one["relatedInformation"].is_array()).expect("another block");
    let related = &twice["relatedInformation"][0];
    assert_eq!(related["location"], json!({"uri": PART, "range": range((8, 0), (8, 7))}));
    assert_eq!(related["message"], "line 9");
}

#[test]
fn a_message_leads_to_the_page_of_its_rule() {
    let params = json!({
        "capabilities": usual_capabilities(),
        "locale": "ru",
        "initializationOptions": {"pages": "https://example.org/play/"},
    });
    let mut client = Client::begun(NoFiles::default(), params);
    let found = client.open(FAULTY);
    let address = "https://example.org/play/rules/ru/number-missing.html";
    assert_eq!(found[0]["codeDescription"], json!({"href": address}));
}

#[test]
fn messages_are_in_the_language_of_the_option_or_else_of_the_user() {
    let message = |locale: &str, option: Option<Language>| {
        let mut client = Client::in_language(locale, option);
        client.open(FAULTY)[0]["message"].as_str().expect("a text").to_owned()
    };
    assert!(message("zh-cn", None).contains('地'), "Chinese");
    assert!(message("ru", None).to_lowercase().contains("адрес"), "Russian");
    assert!(message("de", None).to_lowercase().contains("no number"), "English");
    assert!(message("zh-cn", Some(Language::Russian)).to_lowercase().contains("адрес"), "Russian");
}

// ---- actions --------------------------------------------------------------------------------------

/// The actions at a range of the usual document.
fn actions(client: &mut Client, line: u32, only: &[&str]) -> Vec<Value> {
    let context = match only {
        [] => json!({"diagnostics": []}),
        only => json!({"diagnostics": [], "only": only}),
    };
    let params =
        json!({"textDocument": {"uri": PART}, "range": range((line, 0), (line, 0)), "context": context});
    client.request("textDocument/codeAction", params).as_array().expect("a list").clone()
}

#[test]
fn each_fix_is_an_action_and_all_safe_fixes_are_one() {
    let text = "GO1 X50 Z-2 F0.1 (FACE\nM30\n";
    let mut client = Client::new();
    client.open(text);
    let fixes = actions(&mut client, 0, &["quickfix"]);
    let after: Vec<String> = fixes.iter().map(|fix| edited(text, &fix["edit"])).collect();
    assert!(after.contains(&"G01 X50 Z-2 F0.1 (FACE\nM30\n".to_owned()), "{after:?}");
    assert!(fixes.iter().all(|fix| fix["kind"] == "quickfix" && fix["diagnostics"][0]["range"].is_object()));
    let all = actions(&mut client, 1, &["source.fixAll"]);
    assert_eq!((all.len(), &all[0]["title"]), (1, &json!("Fix all safe problems")));
    assert_eq!(edited(text, &all[0]["edit"]), "G01 X50 Z-2 F0.1 (FACE)\nM30\n");
    client.open("G01 X50 F0.1\nM30\n");
    assert_eq!(actions(&mut client, 0, &["source"]), Vec::<Value>::new(), "nothing to fix");
}

#[test]
fn line_ends_stay_and_edits_name_the_version() {
    let text = "GO1 X50 Z-2 F0.1\r\nG1 X60 (OUT\r\nM30\r\n";
    let mut capabilities = usual_capabilities();
    let mut client = Client::with(capabilities.clone());
    client.open(text);
    let all = actions(&mut client, 0, &["source.fixAll.gcode-playground"]);
    assert_eq!(edited(text, &all[0]["edit"]), "G01 X50 Z-2 F0.1\r\nG1 X60 (OUT)\r\nM30\r\n");
    capabilities["workspace"] = json!({"workspaceEdit": {"documentChanges": true}});
    capabilities["textDocument"]["codeAction"] = json!({"resolveSupport": {"properties": ["edit"]}});
    let mut client = Client::with(capabilities);
    client.open(text);
    let all = actions(&mut client, 0, &["source.fixAll"]);
    assert_eq!(all[0].get("edit"), None, "made when it is chosen");
    let resolved = client.request("codeAction/resolve", all[0].clone());
    let change = &resolved["edit"]["documentChanges"][0];
    assert_eq!(change["textDocument"], json!({"uri": PART, "version": 1}));
    assert_eq!(change["edits"].as_array().map(Vec::len), Some(2), "one for each changed line");
}

#[test]
fn plain_moves_are_offered_as_a_cycle() {
    // The four moves of G90 X50 Z-30: to the diameter, the cut, out at feed, back.
    let text =
        "O1\nT0101 M3 S800 G99\nG00 X62 Z2\nG00 X50\nG01 Z-30 F0.2\nG01 X62\nG00 Z2\nG00 X100 Z100\nM30\n";
    let mut client = Client::new();
    client.open(text);
    let offers = actions(&mut client, 4, &["refactor.rewrite"]);
    assert_eq!(offers.len(), 1, "{offers:?}");
    assert!(offers[0]["title"].as_str().expect("a title").contains("G90"), "{}", offers[0]);
    assert!(
        edited(text, &offers[0]["edit"]).contains("G90 X50 Z-30 F0.2"),
        "{}",
        edited(text, &offers[0]["edit"])
    );
    assert_eq!(actions(&mut client, 8, &["refactor"]), Vec::<Value>::new(), "elsewhere");
}

/// A program with a cycle; G90 makes four moves.
const WITH_CYCLE: &str = "O1\nT0101 M3 S800 G99\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nG00 X100 Z100\nM30\n";

#[test]
fn cycles_are_expanded_to_plain_moves() {
    let moves = |text: &str| {
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let motions = analysis.motions.iter();
        motions.map(|motion| (motion.kind, motion.from, motion.to)).collect::<Vec<_>>()
    };
    for line_end in ["\n", "\r\n"] {
        let text = WITH_CYCLE.replace('\n', line_end);
        let mut client = Client::new();
        client.open(&text);
        let offers = actions(&mut client, 0, &["refactor.rewrite.expand"]);
        assert_eq!(offers.len(), 1, "{offers:?}");
        assert_eq!(offers[0]["title"], "Expand the program to plain moves");
        let after = edited(&text, &offers[0]["edit"]);
        // The cycle stays as a comment.
        assert!(!after.contains("\nG90") && after.contains("\nG01 X50. Z-30. F0.2"), "{after}");
        assert_eq!(after.matches('\n').count(), after.matches(line_end).count(), "{after:?}");
        assert!(!after.contains("\r\r"), "{after:?}");
        assert_eq!(moves(&after), moves(&text));
    }
    let mut client = Client::new();
    client.open("O1\nG00 X62 Z2\nM30\n");
    assert_eq!(actions(&mut client, 0, &["refactor.rewrite.expand"]), Vec::<Value>::new(), "no cycle");
}

#[test]
fn the_expansion_is_made_when_it_is_chosen() {
    let mut capabilities = usual_capabilities();
    capabilities["textDocument"]["codeAction"] = json!({"resolveSupport": {"properties": ["edit"]}});
    let mut client = Client::with(capabilities);
    client.open(WITH_CYCLE);
    let offers = actions(&mut client, 0, &["refactor"]);
    assert_eq!((offers.len(), offers[0].get("edit")), (1, None));
    let resolved = client.request("codeAction/resolve", offers[0].clone());
    assert!(edited(WITH_CYCLE, &resolved["edit"]).contains("\nG01 X50. Z-30. F0.2"), "{resolved}");
}

#[test]
fn a_program_is_formatted_as_by_the_command() {
    let options = json!({"textDocument": {"uri": PART}, "options": {"tabSize": 4, "insertSpaces": true}});
    let text = "O1\r\ng0x50z2(外圆)\r\nG1 Z-30F.2\r\nM30\r\n";
    let mut client = Client::new();
    client.open(text);
    let edits = client.request("textDocument/formatting", options.clone());
    let after = edited(text, &json!({"changes": {PART: edits}}));
    assert_eq!(after, "O1\r\nG00 X50 Z2 (外圆)\r\nG01 Z-30 F.2\r\nM30\r\n");
    client.open(&after);
    assert_eq!(client.request("textDocument/formatting", options.clone()), json!([]), "the second time");
    client.open("%_N_PART_MPF\nN10 G0 X50 Z2\nn20 g1 x40 f.2\nM30\n");
    let answer = client.answer("textDocument/formatting", options);
    assert_eq!(answer["error"]["message"], "not formatted: it is a program for another control");
}
