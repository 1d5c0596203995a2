//! A language server: the messages of a program, fixes, help, navigation and renaming, in any editor that
//! speaks the Language Server Protocol 3.17.
//!
//! In: the messages of a client, as texts. Out: the messages of the server, as texts. Has no transport, no
//! files and no threads: [`Server::handle`] takes a message, and [`Server::work`] answers requests in
//! slices, so that a request can be cancelled and a message about an older text is never sent after a newer
//! one. The files come from a [`Host`]. Must not know streams.

mod actions;
mod capabilities;
mod client;
mod completion;
mod context;
mod diagnostics;
mod document;
mod formatting;
mod hinting;
mod hints;
pub mod host;
mod hover;
mod lenses;
mod links;
mod message;
mod navigation;
mod positions;
mod rename;
mod rewritten;
mod signature;
mod symbols;
mod tasks;
mod tokens;

use std::collections::VecDeque;
use std::task::Poll;

use gen_lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    DidSaveTextDocumentParams, MessageType, PublishDiagnosticsParams, ShowMessageParams,
    TextDocumentContentChangePartial, TextDocumentItem, Uri,
};
use serde_json::{Value, json};

use crate::sentences::Language;
use client::Client;
use context::{Context, Documents, not_open};
use document::{Document, Need};
use host::{Host, Settings};
use message::{Failure, Id, Incoming, Reason};
use tasks::{Subject, Task};

/// Options of a server.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The language of all texts; otherwise that of the configuration, or else that of the client.
    pub language: Option<Language>,
    /// The address of the folder with the rule pages; otherwise that of the client, or else of the configuration.
    pub rules_url: Option<String>,
}

/// What a server has to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pending {
    /// Nothing, before the next message.
    Nothing,
    /// Diagnostics. They can wait a moment for the next message: the user may be typing.
    Diagnostics,
    /// Answers to requests.
    Answers,
}

/// The phase of a session.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// Before `initialize`.
    New,
    /// Between `initialize` and `shutdown`.
    Running,
    /// After `shutdown`.
    ShutDown,
    /// After `exit`; whether `shutdown` came before it.
    Ended(bool),
}

/// A language server.
pub struct Server<H> {
    host: H,
    options: Options,
    phase: Phase,
    client: Client,
    documents: Documents,
    /// Requests that are not answered yet, in order.
    tasks: VecDeque<Task>,
    /// Number of requests sent to the client.
    asked: u64,
    /// The last fault of a configuration that was shown.
    shown: Option<String>,
}

impl<H: Host> Server<H> {
    /// A server that waits for `initialize`.
    pub fn new(host: H, options: Options) -> Self {
        Self {
            host,
            options,
            phase: Phase::New,
            client: Client::default(),
            documents: Documents::new(),
            tasks: VecDeque::new(),
            asked: 0,
            shown: None,
        }
    }

    /// Takes a message of the client, and returns the messages that can be sent immediately. Never fails: a
    /// text that is no message is answered with an error.
    pub fn handle(&mut self, text: &[u8]) -> Vec<String> {
        match message::read(text) {
            Ok(Incoming::Request(id, method, params)) => self.request(id, &method, params),
            Ok(Incoming::Notification(method, params)) => self.notification(&method, params),
            Ok(Incoming::Response) => Vec::new(),
            Err((id, failure)) => vec![message::answer(id, Err(failure))],
        }
    }

    /// What there is to do.
    pub fn pending(&self) -> Pending {
        let has_changed = || self.publishes() && self.documents.values().any(Document::is_to_publish);
        match () {
            () if !self.tasks.is_empty() => Pending::Answers,
            () if has_changed() => Pending::Diagnostics,
            () => Pending::Nothing,
        }
    }

    /// Whether there is nothing to do before the next message.
    pub fn is_idle(&self) -> bool {
        self.pending() == Pending::Nothing
    }

    /// Does a part of the pending work, at most a fraction of a second as a rule, and returns the messages
    /// to send. Call it until the server is idle, and whenever no message of the client is waiting.
    pub fn work(&mut self) -> Vec<String> {
        match self.pending() {
            Pending::Answers => self.work_on_task(),
            Pending::Diagnostics => self.publish(),
            Pending::Nothing => Vec::new(),
        }
    }

    /// The exit status of the process, once the client has sent `exit`: 0 if it sent `shutdown` before,
    /// otherwise 1.
    pub fn exit_status(&self) -> Option<u8> {
        match self.phase {
            Phase::Ended(was_shut_down) => Some(u8::from(!was_shut_down)),
            Phase::New | Phase::Running | Phase::ShutDown => None,
        }
    }

    // ---- requests ---------------------------------------------------------------------------------------

    fn request(&mut self, id: Id, method: &str, params: Value) -> Vec<String> {
        match self.begin(id.clone(), method, params) {
            Ok(result) => {
                result.into_iter().map(|result| message::answer(Some(id.clone()), Ok(result))).collect()
            }
            Err(failure) => vec![message::answer(Some(id), Err(failure))],
        }
    }

    /// Begins a request. Returns its result if it is available immediately.
    fn begin(&mut self, id: Id, method: &str, params: Value) -> Result<Option<Value>, Failure> {
        match (self.phase, method) {
            (Phase::New, "initialize") => self.initialize(&params).map(Some),
            (Phase::New, _) => Err(Failure::new(Reason::ServerNotInitialized, "`initialize` comes first")),
            (Phase::Running, "shutdown") => {
                self.phase = Phase::ShutDown;
                Ok(Some(Value::Null))
            }
            (Phase::Running, "initialize") => {
                Err(Failure::new(Reason::InvalidRequest, "`initialize` was sent before"))
            }
            (Phase::Running, _) => self.wait(id, method, params).map(|()| None),
            (Phase::ShutDown | Phase::Ended(_), _) => {
                Err(Failure::new(Reason::InvalidRequest, "the server is shut down"))
            }
        }
    }

    fn initialize(&mut self, params: &Value) -> Result<Value, Failure> {
        if !params.is_object() {
            return Err(Failure::new(Reason::InvalidParams, "the parameters are an object"));
        }
        self.client = Client::read(params);
        if self.options.rules_url.is_some() {
            self.client.rules_url = self.options.rules_url.clone();
        }
        self.phase = Phase::Running;
        serde_json::to_value(capabilities::initialize_result(&self.client))
            .map_err(|error| Failure::new(Reason::RequestFailed, error.to_string()))
    }

    /// Adds a request to those that wait for their answer.
    fn wait(&mut self, id: Id, method: &str, params: Value) -> Result<(), Failure> {
        let unknown = || Failure::new(Reason::MethodNotFound, format!("there is no method `{method}`"));
        let task = tasks::task(id, method, params).ok_or_else(unknown)??;
        if let Some(Subject { uri, .. }) = task.subject.as_ref().filter(|subject| !self.has(&subject.uri)) {
            return Err(not_open(uri));
        }
        self.tasks.push_back(task);
        Ok(())
    }

    fn has(&self, uri: &Uri) -> bool {
        self.documents.contains_key(uri.as_ref())
    }

    /// Continues the first of the waiting requests.
    fn work_on_task(&mut self) -> Vec<String> {
        let subject = self.tasks.front().and_then(|task| task.subject.clone());
        if !subject.is_none_or(|subject| self.prepare(subject.uri.as_ref(), subject.need)) {
            return Vec::new();
        }
        let Some(mut task) = self.tasks.pop_front() else { return Vec::new() };
        match (task.answer)(&self.context()) {
            Poll::Ready(result) => vec![message::answer(Some(task.id), result)],
            Poll::Pending => {
                self.tasks.push_front(task);
                Vec::new()
            }
        }
    }

    /// Prepares a document in one slice; returns true once it is ready.
    fn prepare(&mut self, address: &str, need: Need) -> bool {
        let Self { host, client, documents, .. } = self;
        let document = documents.get_mut(address);
        document.is_none_or(|document| document.prepare(address, host, need, client))
    }

    fn context(&self) -> Context<'_> {
        Context { documents: &self.documents, client: &self.client, language: self.options.language }
    }

    /// Answers the waiting requests that `is_meant` accepts with an error.
    fn give_up(&mut self, reason: Reason, is_meant: impl Fn(&Task) -> bool) -> Vec<String> {
        let tasks = std::mem::take(&mut self.tasks).into_iter();
        let (given_up, kept): (VecDeque<Task>, _) = tasks.partition(is_meant);
        self.tasks = kept;
        let message = match reason {
            Reason::RequestCancelled => "the client has cancelled the request",
            _ => "the document has changed",
        };
        let answer = |task: Task| message::answer(Some(task.id), Err(Failure::new(reason, message)));
        given_up.into_iter().map(answer).collect()
    }

    // ---- notifications ----------------------------------------------------------------------------------

    fn notification(&mut self, method: &str, params: Value) -> Vec<String> {
        if method == "exit" {
            self.phase = Phase::Ended(self.phase == Phase::ShutDown);
        }
        if self.phase != Phase::Running {
            return Vec::new();
        }
        match method {
            "initialized" => self.watch(),
            "$/cancelRequest" => {
                let id = message::cancelled(params);
                self.give_up(Reason::RequestCancelled, |task| Some(&task.id) == id.as_ref())
            }
            "textDocument/didOpen" => tasks::read(params).map_or_else(ignored, |params| self.open(params)),
            "textDocument/didChange" => self.change(params),
            "textDocument/didSave" => tasks::read(params).map_or_else(ignored, |params| self.save(&params)),
            "textDocument/didClose" => tasks::read(params).map_or_else(ignored, |params| self.close(params)),
            "workspace/didChangeWatchedFiles" | "workspace/didChangeConfiguration" => self.look_again(),
            _ => Vec::new(),
        }
    }

    /// The text of a request to the client.
    fn ask(&mut self, method: &str, params: Value) -> String {
        self.asked += 1;
        message::request(self.asked, method, params)
    }

    /// Asks the client to tell when a configuration or a setup changes.
    fn watch(&mut self) -> Vec<String> {
        if !self.client.watches_files {
            return Vec::new();
        }
        let watchers = ["**/gcode-playground.toml", "**/*.{toml,json,dxf}"];
        let watchers = watchers.map(|pattern| json!({"globPattern": pattern}));
        let registration = json!({
            "id": "files",
            "method": "workspace/didChangeWatchedFiles",
            "registerOptions": {"watchers": watchers},
        });
        vec![self.ask("client/registerCapability", json!({"registrations": [registration]}))]
    }

    fn open(&mut self, params: DidOpenTextDocumentParams) -> Vec<String> {
        let TextDocumentItem { uri, version, text, .. } = params.text_document;
        let mut out = self.outdated(uri.as_ref());
        let (settings, shown) = self.settings(uri.as_ref());
        out.extend(shown);
        self.documents.insert(uri.0, Document::new(text, version, settings));
        out
    }

    /// Applies changes in their order. A change that cannot be read is left out.
    fn change(&mut self, mut params: Value) -> Vec<String> {
        let changes = params.get_mut("contentChanges").map(Value::take);
        if let Some(params) = params.as_object_mut() {
            params.insert("contentChanges".to_owned(), json!([]));
        }
        let Ok(params) = tasks::read::<DidChangeTextDocumentParams>(params) else { return Vec::new() };
        let uri = params.text_document.text_document_identifier.uri;
        let Some(document) = self.documents.get_mut(uri.as_ref()) else { return Vec::new() };
        document.version = params.text_document.version;
        let Some(Value::Array(changes)) = changes else { return Vec::new() };
        for change in changes {
            apply(document, change, self.client.encoding);
        }
        self.outdated(uri.as_ref())
    }

    fn save(&mut self, params: &DidSaveTextDocumentParams) -> Vec<String> {
        let Some(document) = self.documents.get_mut(params.text_document.uri.as_ref()) else {
            return Vec::new();
        };
        document.infer_again();
        // A saved program can be a subprogram of another one.
        self.documents.values_mut().for_each(Document::join_again);
        self.refreshed()
    }

    fn close(&mut self, params: DidCloseTextDocumentParams) -> Vec<String> {
        let uri = params.text_document.uri;
        if self.documents.remove(uri.as_ref()).is_none() {
            return Vec::new();
        }
        let mut out = self.outdated(uri.as_ref());
        if self.publishes() {
            let params = PublishDiagnosticsParams { uri, version: None, diagnostics: Vec::new() };
            out.push(message::notification("textDocument/publishDiagnostics", params));
        }
        out
    }

    /// Reads configurations and setups again.
    fn look_again(&mut self) -> Vec<String> {
        self.host.forget();
        let addresses: Vec<String> = self.documents.keys().cloned().collect();
        let mut out = Vec::new();
        for address in addresses {
            let (settings, shown) = self.settings(&address);
            out.extend(shown);
            if let Some(document) = self.documents.get_mut(&address) {
                document.set_settings(settings);
            }
        }
        out.extend(self.refreshed());
        out
    }

    /// Gives up the requests about a document that has changed.
    fn outdated(&mut self, address: &str) -> Vec<String> {
        let is_about =
            |task: &Task| task.subject.as_ref().is_some_and(|subject| subject.uri.as_ref() == address);
        self.give_up(Reason::ContentModified, is_about)
    }

    /// The settings of a document, and the message about a fault in them, which is shown once.
    fn settings(&mut self, address: &str) -> (Settings, Option<String>) {
        match self.host.settings(address) {
            Ok(settings) => (settings, None),
            Err(fault) if self.shown.as_ref() == Some(&fault) => (Settings::default(), None),
            Err(fault) => {
                let params = ShowMessageParams { kind: MessageType::Error, message: fault.clone() };
                self.shown = Some(fault);
                (Settings::default(), Some(message::notification("window/showMessage", params)))
            }
        }
    }

    // ---- diagnostics ------------------------------------------------------------------------------------

    /// Whether diagnostics are sent without being asked for.
    fn publishes(&self) -> bool {
        self.phase == Phase::Running && !self.client.pulls_diagnostics
    }

    /// Continues with the first document whose messages have changed.
    fn publish(&mut self) -> Vec<String> {
        let changed = self.documents.iter().find(|(_, document)| document.is_to_publish());
        let Some(address) = changed.map(|(address, _)| address.clone()) else { return Vec::new() };
        if !self.prepare(&address, Need::Messages) {
            return Vec::new();
        }
        let asked = self.context().asked(&address.as_str().into());
        let params = asked.ok().map(|asked| diagnostics::published(&asked));
        if let Some(document) = self.documents.get_mut(&address) {
            document.set_published();
        }
        params
            .into_iter()
            .map(|params| message::notification("textDocument/publishDiagnostics", params))
            .collect()
    }

    /// Tells the client to ask again for what depends on files.
    fn refreshed(&mut self) -> Vec<String> {
        let client = &self.client;
        let requests = [
            (client.pulls_diagnostics && client.refreshes_diagnostics, "workspace/diagnostic/refresh"),
            (client.refreshes_hints, "workspace/inlayHint/refresh"),
            (client.shows_lenses && client.refreshes_lenses, "workspace/codeLens/refresh"),
        ];
        let wanted = requests.into_iter().filter(|(is_wanted, _)| *is_wanted);
        wanted.map(|(_, method)| self.ask(method, Value::Null)).collect()
    }
}

/// Applies a change to a document.
fn apply(document: &mut Document, mut change: Value, encoding: positions::Encoding) {
    if change.get("range").is_some_and(|range| !range.is_null()) {
        if let Ok(change) = tasks::read::<TextDocumentContentChangePartial>(change) {
            document.edit(&change, encoding);
        }
    } else if let Some(Value::String(text)) = change.get_mut("text").map(Value::take) {
        document.set_text(text);
    }
}

/// A notification with wrong parameters has no effect.
fn ignored(_: Failure) -> Vec<String> {
    Vec::new()
}
