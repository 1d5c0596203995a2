//! Measures the language server on a program of 20 MB, natively. Part of `cargo xtask test --all` and
//! `cargo xtask bench`.
//!
//! In: the path of the report, optionally. Out: a table of the times from a request to its answer, with and
//! without an edit before it. Fails if a request about a place or the visible lines takes too long, or one
//! about the whole program.

#[path = "../server/client.rs"]
#[allow(dead_code, reason = "the tests use the rest of it")]
mod client;
#[path = "workload.rs"]
#[allow(dead_code, reason = "the other measurements use the rest of it")]
mod workload;

use std::fmt::Write;
use std::process::ExitCode;
use std::time::Instant;
use std::{env, fs};

use client::{Client, PART, at, range};
use serde_json::{Value, json};

/// Time limit for 95 % of the requests about a place or the visible lines, ms.
const MAX_AT_PLACE: f64 = 50.0;

/// Time limit for each request about the whole program, ms.
const MAX_WHOLE: f64 = 1000.0;

/// A busy machine may be slower by this factor.
const TOLERANCE: f64 = 1.5;

/// Number of places at which each request is measured.
const PLACES: u32 = 20;

/// Lines that an editor shows.
const VISIBLE: u32 = 60;

/// Attempts at a kind of request that is too slow: the machine may have been busy.
const ATTEMPTS: usize = 2;

/// The requests about a place.
const AT_PLACE: [&str; 3] = ["textDocument/hover", "textDocument/completion", "textDocument/signatureHelp"];

/// The requests about a block number.
const AT_NUMBER: [&str; 4] = [
    "textDocument/definition",
    "textDocument/references",
    "textDocument/documentHighlight",
    "textDocument/prepareRename",
];

/// The requests about the visible lines.
const VISIBLE_LINES: [&str; 3] =
    ["textDocument/semanticTokens/range", "textDocument/inlayHint", "textDocument/codeAction"];

/// The requests about the whole program.
const WHOLE: [&str; 8] = [
    "textDocument/diagnostic",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/semanticTokens/full",
    "textDocument/documentLink",
    "textDocument/codeLens",
    "textDocument/rename",
    "textDocument/formatting",
];

fn main() -> ExitCode {
    let report = env::args().nth(1);
    let text = program();
    let mut session = Session::open(&text);
    let mut table = format!(
        "### Requests to the language server about a program of {:.0} MB, {} lines\n\n\
         | request | ms, median | 95 % | after an edit, median | 95 % |\n|---|---:|---:|---:|---:|\n",
        text.len() as f64 / 1e6,
        text.lines().count()
    );
    let mut slow = Vec::new();
    let requests =
        AT_PLACE.iter().chain(&AT_NUMBER).chain(&VISIBLE_LINES).map(|method| (*method, PLACES, MAX_AT_PLACE));
    for (method, count, most) in requests.chain(WHOLE.map(|method| (method, 3, MAX_WHOLE))) {
        let [asked, edited] = [false, true].map(|edits| session.measured(method, count, edits, most));
        let [name, median, high, after, high_after] = [
            method.trim_start_matches("textDocument/").to_owned(),
            shown(asked.median()),
            shown(asked.high()),
            shown(edited.median()),
            shown(edited.high()),
        ];
        let row = format!("| `{name}` | {median} | {high} | {after} | {high_after} |");
        println!("{row}");
        table.push_str(&row);
        table.push('\n');
        if asked.high().max(edited.high()) > TOLERANCE * most {
            slow.push(format!("{method}: {high} ms, after an edit {high_after} ms; {most} ms are allowed"));
        }
    }
    if let Some(memory) = peak_memory() {
        let _ = writeln!(table, "\nThe process uses {memory:.0} MB at most.");
    }
    if let Some(path) = report
        && let Err(error) = fs::write(&path, &table)
    {
        slow.push(format!("cannot write {path}: {error}"));
    }
    slow.iter().for_each(|problem| eprintln!("{problem}"));
    if slow.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// A program of 20 MB, as a CAM system writes it: plain lines with a tool every ten thousand lines, then ten thousand
/// passes of G90. It has no call, jump or contour: after one, an answer at a place replays the program from its start.
fn program() -> String {
    let mut text = String::from("O1 (LONG)\n");
    for (index, line) in workload::plain(960_000).lines().filter(|line| *line != "M30").enumerate() {
        if index % 10_000 == 5_000 {
            let tool = index / 10_000 % 9 + 1;
            let _ = writeln!(text, "N{} T0{tool}0{tool}", index / 10 + 100);
        }
        text.push_str(line);
        text.push('\n');
    }
    text.push_str(&workload::boxes(10_000));
    text
}

/// The times of a kind of request, ms, in ascending order.
struct Times(Vec<f64>);

impl Times {
    fn median(&self) -> f64 {
        self.0[self.0.len() / 2]
    }

    /// The 95th percentile.
    fn high(&self) -> f64 {
        self.0[(self.0.len() * 95).div_ceil(100) - 1]
    }
}

/// A session with the program open.
struct Session {
    client: Client,
    /// The lines that begin with `G1 X` and a digit.
    lines: Vec<u32>,
    /// The lines that begin with a block number.
    numbers: Vec<u32>,
    /// Number of lines that were used.
    used: usize,
}

impl Session {
    fn open(text: &str) -> Self {
        let mut capabilities = client::usual_capabilities();
        // Messages are requested, so that they do not delay other answers.
        capabilities["textDocument"]["diagnostic"] = json!({});
        let options = json!({"codeLens": true, "hints": ["code", "feed", "passes"]});
        let params = json!({"capabilities": capabilities, "initializationOptions": options});
        let mut client = Client::begun(gcode_playground::server::host::NoFiles::default(), params);
        client.open_as(PART, text);
        client.whole("textDocument/diagnostic");
        let starting = |start: &str| {
            (0..).zip(text.lines()).filter(|(_, line)| line.starts_with(start)).map(|(at, _)| at).collect()
        };
        Self { client, lines: starting("G1 X"), numbers: starting("N"), used: 0 }
    }

    /// The best of some attempts at a kind of request.
    fn measured(&mut self, method: &str, count: u32, edits: bool, most: f64) -> Times {
        let mut best = self.times(method, count, edits);
        for _ in 1..ATTEMPTS {
            if best.high() > most {
                let again = self.times(method, count, edits);
                best = if again.high() < best.high() { again } else { best };
            }
        }
        best
    }

    fn times(&mut self, method: &str, count: u32, edits: bool) -> Times {
        let mut times: Vec<f64> = (0..count).map(|_| self.time(method, edits)).collect();
        times.sort_unstable_by(f64::total_cmp);
        Times(times)
    }

    /// Time from a request to its answer, ms, with the work of the client; with the edit of a digit before it.
    fn time(&mut self, method: &str, edits: bool) -> f64 {
        self.used += 1;
        // A large step visits lines all over the program.
        let at_line = |lines: &[u32]| lines[self.used * 39_916_801 % (lines.len() - VISIBLE as usize)];
        let line = at_line(&self.lines);
        let number = at(at_line(&self.numbers), 1);
        let params = match method {
            "textDocument/rename" => with(number, "newName", json!("N7")),
            _ if WHOLE.contains(&method) => {
                json!({"textDocument": {"uri": PART}, "options": {"tabSize": 4, "insertSpaces": true}})
            }
            "textDocument/references" => with(number, "context", json!({"includeDeclaration": true})),
            _ if AT_NUMBER.contains(&method) => number,
            _ if AT_PLACE.contains(&method) => at(line, 4),
            "textDocument/codeAction" => with(visible(line), "context", json!({"diagnostics": []})),
            _ => visible(line),
        };
        let watch = Instant::now();
        if edits {
            let text = (self.used % 10).to_string();
            self.client.change(json!([{"range": range((line, 4), (line, 5)), "text": text}]));
        }
        // Some places cannot be renamed.
        let answer = self.client.answer(method, params);
        let time = watch.elapsed().as_secs_f64() * 1e3;
        assert!(answer.get("error").is_none() || method == "textDocument/rename", "{method}: {answer}");
        time
    }
}

fn with(mut params: Value, name: &str, value: Value) -> Value {
    params[name] = value;
    params
}

/// The parameters of a request about the lines that an editor shows.
fn visible(line: u32) -> Value {
    json!({"textDocument": {"uri": PART}, "range": range((line, 0), (line + VISIBLE, 0))})
}

fn shown(time: f64) -> String {
    if time < 9.95 { format!("{time:.1}") } else { format!("{time:.0}") }
}

/// The most memory that the process has used, MB; known on Linux.
fn peak_memory() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.trim().trim_end_matches("kB").trim().parse().ok()?;
    Some(kilobytes / 1e3)
}
