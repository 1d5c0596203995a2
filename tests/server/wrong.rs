//! Random and wrong messages: no panic, and each request is answered exactly once.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::client::{Client, PART, range};
use super::edits::Random;

/// Methods, most of which the server has.
const METHODS: [&str; 31] = [
    "initialize",
    "textDocument/codeAction",
    "textDocument/codeLens",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/diagnostic",
    "textDocument/documentHighlight",
    "textDocument/documentLink",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/hover",
    "textDocument/inlayHint",
    "textDocument/prepareRename",
    "textDocument/references",
    "textDocument/rename",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/range",
    "textDocument/signatureHelp",
    "workspace/symbol",
    "codeAction/resolve",
    "textDocument/didOpen",
    "textDocument/didChange",
    "textDocument/didSave",
    "textDocument/didClose",
    "workspace/didChangeWatchedFiles",
    "workspace/didChangeConfiguration",
    "$/cancelRequest",
    "$/setTrace",
    "textDocument/formatting",
    "",
    "外",
];

/// Programs with jumps, calls, cycles and mistakes.
const PROGRAMS: [&str; 6] = [
    "",
    "O1\nG71 U2 R1\nG71 P10 Q20 U0.4 F0.3\nN10 G0 X30\nN20 G1 Z-10 U4\nG70 P10 Q20\nM30\n",
    "O1 (外😀\r\n#1=0\rWHILE[#1LT3]DO1\nG0 X[#1*10] W-1\n#1=#1+1\nEND1\nM98 P2 L3\nGOTO 5\nN5 M30\nO2\nU8\nM99 P5\n",
    "GO1 X5O Z–3 (\nN10 N10 G99999 X\n%\nO1\n%",
    "N10 GOTO 10\n",
    "(RULES NO-PROGRAM-END=OFF)\n(STOCK D=50 LENGTH=80)\nT0101\nG0 X46 Z2\nG0 Z-30\nG90 X40 Z-10 F0.1\nX30\n",
];

/// A value of any kind.
fn anything(random: &mut Random, depth: usize) -> Value {
    match random.below(if depth == 0 { 6 } else { 8 }) {
        0 => Value::Null,
        1 => json!(random.below(2) == 0),
        2 => json!(random.below(100) as i64 - 50),
        3 => json!([1e300, -0.5, 4_294_967_296_f64][random.below(3)]),
        4 => json!(["", "N20", "外", PART, "O2"][random.below(5)]),
        5 => json!(u64::MAX - random.below(3) as u64),
        6 => (0..random.below(4)).map(|_| anything(random, depth - 1)).collect(),
        _ => {
            let names =
                ["textDocument", "position", "range", "uri", "line", "text", "context", "query", "id"];
            let pairs =
                (0..random.below(4)).map(|_| (names[random.below(names.len())], anything(random, depth - 1)));
            Value::Object(pairs.map(|(name, value)| (name.to_owned(), value)).collect())
        }
    }
}

/// Parameters that fit any method.
fn fitting(random: &mut Random) -> Value {
    let place = |random: &mut Random| (random.below(14) as u32, random.below(30) as u32);
    let (start, end) = (place(random), place(random));
    let only = [json!(null), json!(["quickfix"]), json!(["source.fixAll"]), json!(["refactor"])];
    json!({
        "textDocument": {
            "uri": *random.of(&[PART, PART, PART, "file:///other.nc", "untitled:1"]),
            "version": 1, "languageId": "gcode", "text": *random.of(&PROGRAMS),
        },
        "position": {"line": start.0, "character": start.1},
        "range": range(start, end),
        "contentChanges": [{"range": range(start, end), "text": *random.of(&["", "N10 ", "\n", "X外", "G71"])}],
        "context": {"diagnostics": [], "only": random.of(&only), "includeDeclaration": true, "triggerKind": 1},
        "options": {"tabSize": 4, "insertSpaces": true},
        "newName": *random.of(&["N15", "20", "#101", "O3", "", "外"]),
        "query": "O",
        "id": random.below(10_000),
        "changes": [],
        "title": "a",
        "kind": *random.of(&["source.fixAll.gcode-playground", "refactor.rewrite.expand.gcode-playground", ""]),
        "data": {"address": PART},
    })
}

/// Parameters that fit, with one value replaced by another one.
fn almost_fitting(random: &mut Random) -> Value {
    let mut params = fitting(random);
    let names: Vec<String> =
        params.as_object().into_iter().flat_map(|object| object.keys().cloned()).collect();
    let name = random.of(&names).clone();
    params[name] = anything(random, 2);
    params
}

/// A message, or a text that is none.
fn message(random: &mut Random, id: i64) -> String {
    let params = match random.below(6) {
        0 => anything(random, 3),
        1 => almost_fitting(random),
        _ => fitting(random),
    };
    let method = *random.of(&METHODS);
    let is_notification = method.contains("/did") || method.starts_with("$/");
    let mut message = json!({"jsonrpc": "2.0", "method": method, "params": params});
    if !is_notification || random.below(20) == 0 {
        message["id"] = if random.below(10) == 0 { json!(id.to_string()) } else { json!(id) };
    }
    match random.below(40) {
        0 => anything(random, 3).to_string(),
        1 => {
            let text = message.to_string();
            let end = (0..=random.below(text.len())).rev().find(|end| text.is_char_boundary(*end));
            text[..end.unwrap_or(0)].to_owned()
        }
        2 => {
            message["method"] = anything(random, 1);
            message.to_string()
        }
        _ => message.to_string(),
    }
}

/// The id of a request; `None` if the text is no request.
fn id_of(text: &str) -> Option<Value> {
    let message = serde_json::from_str::<Value>(text).ok()?;
    let id = message.get("id").filter(|id| id.is_string() || id.is_i64() || id.is_u64())?.clone();
    let is_response =
        message.get("method").is_none() && (message.get("result").or(message.get("error"))).is_some();
    (!is_response).then_some(id)
}

#[test]
fn ten_thousand_random_messages_are_each_answered_once() {
    let mut random = Random(7);
    // Loops end soon.
    let mut client = Client::with_setup(r#"{"limits": {"repeatedBlocks": 1000, "rounds": 100}}"#);
    client.open(PROGRAMS[1]);
    client.received.clear();
    let mut open: BTreeMap<String, i64> = BTreeMap::new();
    for id in 1000..11_000 {
        let text = message(&mut random, id);
        if let Some(id) = id_of(&text) {
            *open.entry(id.to_string()).or_default() += 1;
        }
        client.send(&text);
        if random.below(3) > 0 {
            client.work();
        }
        if random.below(50) == 0 {
            let program = *random.of(&PROGRAMS);
            client.open(program);
        }
        for answer in client.received.drain(..).filter(|message| message.get("method").is_none()) {
            assert!(answer.get("result").is_some() != answer.get("error").is_some(), "{answer}");
            if !answer["id"].is_null() {
                *open.entry(answer["id"].to_string()).or_default() -= 1;
            }
        }
    }
    client.work();
    for answer in client.received.drain(..).filter(|message| message.get("method").is_none()) {
        *open.entry(answer["id"].to_string()).or_default() -= 1;
    }
    open.remove("null");
    open.retain(|_, left| *left != 0);
    assert!(open.is_empty(), "requests without their answer, or answers without a request: {open:?}");
}
