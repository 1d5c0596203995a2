//! A small client of the language server: it sends messages as JSON and sorts what comes back.

use gcode_playground::sentences::Language;
use gcode_playground::server::host::{Host, NoFiles, Settings};
use gcode_playground::server::{Options, Server};
use gcode_playground::setup::Setup;
use serde_json::{Value, json};

/// The address of the usual document.
pub const PART: &str = "file:///part.nc";

/// A session with a server.
pub struct Client<H = NoFiles> {
    pub server: Server<H>,
    next: i64,
    version: i32,
    /// Notifications and requests of the server, in order.
    pub received: Vec<Value>,
}

impl Client {
    /// A session that has begun, with a client that can do the usual.
    pub fn new() -> Self {
        Self::with(usual_capabilities())
    }

    /// A session with a client of these capabilities.
    pub fn with(capabilities: Value) -> Self {
        Self::begun(NoFiles::default(), json!({"capabilities": capabilities}))
    }

    /// A session with a setup, as JSON, with all hints and lenses.
    pub fn with_setup(setup: &str) -> Self {
        let setup = Setup::from_json(setup).expect("a setup");
        let settings = Settings { setup, ..Settings::default() };
        let options = json!({"codeLens": true, "hints": ["code", "feed", "passes"]});
        let params = json!({"capabilities": usual_capabilities(), "initializationOptions": options});
        Self::begun(NoFiles { settings }, params)
    }

    /// A session with initialization options, in the language of a locale.
    pub fn with_options(options: Value, locale: &str) -> Self {
        let params =
            json!({"capabilities": usual_capabilities(), "initializationOptions": options, "locale": locale});
        Self::begun(NoFiles::default(), params)
    }

    /// A session in a language.
    pub fn in_language(locale: &str, option: Option<Language>) -> Self {
        let options = Options { language: option, ..Options::default() };
        let mut client = Self::waiting(NoFiles::default(), options);
        client.initialize(json!({"capabilities": usual_capabilities(), "locale": locale}));
        client
    }
}

impl<H: Host> Client<H> {
    /// A session before `initialize`.
    pub fn waiting(host: H, options: Options) -> Self {
        Self { server: Server::new(host, options), next: 0, version: 0, received: Vec::new() }
    }

    /// A session that has begun with these parameters.
    pub fn begun(host: H, params: Value) -> Self {
        let mut client = Self::waiting(host, Options::default());
        client.initialize(params);
        client
    }

    /// Initializes the session, and returns the result.
    pub fn initialize(&mut self, params: Value) -> Value {
        let result = self.request("initialize", params);
        self.notify("initialized", json!({}));
        result
    }

    /// Sends a request; returns its answer.
    pub fn answer(&mut self, method: &str, params: Value) -> Value {
        let id = self.begin(method, params);
        self.work();
        let at =
            self.received.iter().position(|message| message["id"] == id && message.get("method").is_none());
        self.received.remove(at.unwrap_or_else(|| panic!("{method} has no answer")))
    }

    /// Sends a request without waiting for its answer; returns its id.
    pub fn begin(&mut self, method: &str, params: Value) -> i64 {
        self.next += 1;
        let message = json!({"jsonrpc": "2.0", "id": self.next, "method": method, "params": params});
        self.send(&message.to_string());
        self.next
    }

    /// Sends a request; returns its result.
    #[track_caller]
    pub fn request(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        answer.get("result").cloned().unwrap_or_else(|| panic!("{method}: {answer}"))
    }

    /// Sends a request; returns the code of its error.
    #[track_caller]
    pub fn error(&mut self, method: &str, params: Value) -> i64 {
        let answer = self.answer(method, params);
        answer["error"]["code"].as_i64().unwrap_or_else(|| panic!("{method}: {answer}"))
    }

    /// Sends a notification.
    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}).to_string());
        self.work();
    }

    /// Sends a text that need not be a message, and does no work.
    pub fn send(&mut self, text: &str) {
        let out = self.server.handle(text.as_bytes());
        self.receive(out);
    }

    /// Lets the server do all its work.
    pub fn work(&mut self) {
        while !self.server.is_idle() {
            let out = self.server.work();
            self.receive(out);
        }
    }

    fn receive(&mut self, out: Vec<String>) {
        let messages = out.iter().map(|text| serde_json::from_str::<Value>(text).expect("JSON"));
        for message in messages {
            assert_eq!(message["jsonrpc"], "2.0");
            self.received.push(message);
        }
    }

    // ---- documents --------------------------------------------------------------------------------------

    /// Opens the usual document; returns its diagnostics.
    pub fn open(&mut self, text: &str) -> Vec<Value> {
        self.open_as(PART, text);
        self.diagnostics(PART)
    }

    /// Opens a document.
    pub fn open_as(&mut self, uri: &str, text: &str) {
        let document =
            json!({"uri": uri, "languageId": "gcode", "version": self.next_version(), "text": text});
        self.notify("textDocument/didOpen", json!({"textDocument": document}));
    }

    /// Changes the usual document.
    pub fn change(&mut self, changes: Value) {
        let document = json!({"uri": PART, "version": self.next_version()});
        self.notify("textDocument/didChange", json!({"textDocument": document, "contentChanges": changes}));
    }

    fn next_version(&mut self) -> i32 {
        self.version += 1;
        self.version
    }

    /// The diagnostics of a document that were sent last.
    pub fn diagnostics(&self, uri: &str) -> Vec<Value> {
        let mut sent = self.received.iter().filter(|message| {
            message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == uri
        });
        let last = sent.next_back().expect("diagnostics were sent");
        last["params"]["diagnostics"].as_array().expect("a list").clone()
    }

    /// A request about a position of the usual document; returns its result.
    #[track_caller]
    pub fn at(&mut self, method: &str, line: u32, character: u32) -> Value {
        self.request(method, at(line, character))
    }

    /// A request about the whole usual document; returns its result.
    #[track_caller]
    pub fn whole(&mut self, method: &str) -> Value {
        self.request(method, json!({"textDocument": {"uri": PART}}))
    }
}

/// The parameters of a request about a position of the usual document.
pub fn at(line: u32, character: u32) -> Value {
    json!({"textDocument": {"uri": PART}, "position": {"line": line, "character": character}})
}

/// A range of the protocol.
pub fn range(from: (u32, u32), to: (u32, u32)) -> Value {
    let position = |(line, character): (u32, u32)| json!({"line": line, "character": character});
    json!({"start": position(from), "end": position(to)})
}

/// What most editors can do.
pub fn usual_capabilities() -> Value {
    json!({
        "textDocument": {
            "hover": {"contentFormat": ["markdown", "plaintext"]},
            "completion": {"completionItem": {"snippetSupport": true}},
            "signatureHelp": {"signatureInformation": {"parameterInformation": {"labelOffsetSupport": true}}},
            "documentSymbol": {"hierarchicalDocumentSymbolSupport": true},
            "publishDiagnostics": {"relatedInformation": true},
        },
    })
}

/// The byte at a position with UTF-16 columns, counted here as the protocol describes it. A line behind the
/// last one is the end of the text.
pub fn byte_at(text: &str, position: &Value) -> usize {
    let number = |name: &str| position[name].as_u64().expect("a number") as usize;
    if number("line") > lines(text).count() {
        return text.len();
    }
    let start: usize = lines(text).take(number("line")).map(str::len).sum();
    let mut units = 0;
    for (at, letter) in text[start..].char_indices() {
        if units >= number("character") {
            return start + at;
        }
        units += letter.len_utf16();
    }
    text.len()
}

/// The lines of a text with their ends: LF, CR LF or CR.
pub fn lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let end = rest.find(['\r', '\n'])?;
        let end = end + if rest[end..].starts_with("\r\n") { 2 } else { 1 };
        let (line, behind) = rest.split_at(end);
        rest = behind;
        Some(line)
    })
}

/// A text with the edits of the usual document in an edit of the workspace.
pub fn edited(text: &str, edit: &Value) -> String {
    let edits = edit["changes"][PART].as_array().expect("edits");
    let mut spans: Vec<(usize, usize, &str)> = edits
        .iter()
        .map(|edit| {
            let byte = |end: &str| byte_at(text, &edit["range"][end]);
            (byte("start"), byte("end"), edit["newText"].as_str().expect("a text"))
        })
        .collect();
    spans.sort_unstable();
    let mut text = text.to_owned();
    for (start, end, new) in spans.into_iter().rev() {
        text.replace_range(start..end, new);
    }
    text
}
