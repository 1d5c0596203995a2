//! Edits of a document: after any sequence of edits, each answer equals the answer for the same text in a new document.

use serde_json::{Value, json};

use super::client::{Client, PART, byte_at, lines, range};

/// Pieces of text that edits insert.
const PIECES: [&str; 16] = [
    "G01 X10. Z-5.\n",
    "X",
    "Z-3.",
    "(外圆)",
    "😀",
    "\r\n",
    "\n",
    "\r",
    "N10 ",
    "GOTO 10\n",
    "#1=2\n",
    "M30\n",
    "O2\n",
    "G00 U4. W-1.\n",
    ";",
    "%\n",
];

/// A generator of numbers that are the same in each run.
pub struct Random(pub u64);

impl Random {
    /// A number below `most`, which is not 0.
    pub fn below(&mut self, most: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % most
    }

    /// One of a list.
    pub fn of<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }
}

/// A position in a text with UTF-16 columns, sometimes outside of the text.
fn position(random: &mut Random, text: &str) -> Value {
    let count = lines(text).count() + 1;
    json!({"line": random.below(count + 1), "character": random.below(20)})
}

/// The byte at a position; one behind the end of a line is at the end of the line.
fn byte_within(text: &str, position: &Value) -> usize {
    let byte = byte_at(text, position);
    let line = position["line"].as_u64().expect("a line") as usize;
    if line > lines(text).count() {
        return byte;
    }
    let start: usize = lines(text).take(line).map(str::len).sum();
    let end = text[start..].find(['\r', '\n']).map_or(text.len(), |length| start + length);
    byte.min(end)
}

/// Applies a random change to a text; returns it as a message.
fn change(random: &mut Random, text: &mut String) -> Value {
    if random.below(20) == 0 {
        *text = (0..4).map(|_| *random.of(&PIECES)).collect();
        return json!({"text": text});
    }
    let (mut start, mut end) = (position(random, text), position(random, text));
    if byte_within(text, &end) < byte_within(text, &start) {
        std::mem::swap(&mut start, &mut end);
    }
    let insert: String = (0..random.below(4)).map(|_| *random.of(&PIECES)).collect();
    let bytes = byte_within(text, &start)..byte_within(text, &end);
    text.replace_range(bytes, &insert);
    json!({"range": {"start": start, "end": end}, "text": insert})
}

/// A client whose numbers without a decimal point never count otherwise, and whose loops end soon.
fn client() -> Client {
    Client::with_setup(r#"{"dialect": {"decimal": "calculator"}, "limits": {"repeatedBlocks": 1000}}"#)
}

/// The answers about the usual document.
fn told(client: &mut Client) -> Value {
    let tokens = client.whole("textDocument/semanticTokens/full");
    let symbols = client.whole("textDocument/documentSymbol");
    let lenses = client.whole("textDocument/codeLens");
    let hints = json!({"textDocument": {"uri": PART}, "range": range((0, 0), (100, 0))});
    let hints = client.request("textDocument/inlayHint", hints);
    json!([client.diagnostics(PART), tokens, symbols, lenses, hints])
}

#[test]
fn edits_in_any_order_equal_the_whole_text() {
    for seed in 0..60 {
        let mut random = Random(seed);
        let mut text: String = (0..30).map(|_| *random.of(&PIECES)).collect();
        let mut client = client();
        client.open(&text);
        for round in 0..12 {
            let changes: Vec<Value> =
                (0..1 + random.below(3)).map(|_| change(&mut random, &mut text)).collect();
            client.change(json!(changes));
            let mut anew = self::client();
            anew.open(&text);
            assert_eq!(told(&mut client), told(&mut anew), "seed {seed}, round {round}: {text:?}");
        }
    }
}

#[test]
fn a_change_that_cannot_be_read_changes_nothing() {
    let mut client = Client::new();
    client.open("G00 X50\nM30\n");
    for wrong in [
        json!([{"range": {"start": 3}, "text": "X"}]),
        json!([{"range": [], "text": "X"}]),
        json!([{"text": 7}]),
        json!([7]),
        json!({}),
    ] {
        client.change(wrong);
    }
    let tokens = client.whole("textDocument/semanticTokens/full");
    assert_eq!(tokens["data"], json!([[0, 0, 3, 1, 0], [0, 4, 3, 3, 0], [1, 0, 3, 2, 0]].concat()));
}
