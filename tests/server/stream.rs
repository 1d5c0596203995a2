//! The program itself, over standard input and output.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

use super::client::range;

/// A running server.
struct Running {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Running {
    fn new(arguments: &[&str]) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_gcode-playground"))
            .arg("server")
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it starts");
        let (input, output) = (child.stdin.take().expect("input"), child.stdout.take().expect("output"));
        Self { child, input, output: BufReader::new(output) }
    }

    fn send(&mut self, message: &Value) {
        let text = json!({"jsonrpc": "2.0"}).as_object().cloned().map(|mut whole| {
            whole.extend(message.as_object().cloned().unwrap_or_default());
            Value::Object(whole).to_string()
        });
        self.send_text(&text.expect("an object"));
    }

    fn send_text(&mut self, text: &str) {
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).expect("it reads");
        self.input.flush().expect("it reads");
    }

    /// The next message.
    fn receive(&mut self) -> Value {
        let mut length = None;
        loop {
            let mut line = String::new();
            assert!(self.output.read_line(&mut line).expect("a header") > 0, "the stream has ended");
            match line.trim_end().split_once(": ") {
                Some(("Content-Length", value)) => length = value.parse().ok(),
                Some(_) => {}
                None => break,
            }
        }
        let mut message = vec![0; length.expect("a length")];
        self.output.read_exact(&mut message).expect("a message");
        serde_json::from_slice(&message).expect("JSON")
    }

    fn begin(&mut self) {
        self.send(&json!({"id": 0, "method": "initialize", "params": {"capabilities": {}, "locale": "en"}}));
        assert_eq!(self.receive()["result"]["serverInfo"]["name"], "gcode-playground");
        self.send(&json!({"method": "initialized", "params": {}}));
    }

    /// Opens a document; returns its diagnostics.
    fn open(&mut self, uri: &str, text: &str) -> Vec<Value> {
        let document = json!({"uri": uri, "languageId": "gcode", "version": 1, "text": text});
        self.send(&json!({"method": "textDocument/didOpen", "params": {"textDocument": document}}));
        let told = self.receive();
        assert_eq!(
            (&told["method"], &told["params"]["uri"]),
            (&json!("textDocument/publishDiagnostics"), &json!(uri))
        );
        told["params"]["diagnostics"].as_array().expect("a list").clone()
    }

    /// Waits for the end; returns the exit status.
    fn end(mut self) -> Option<i32> {
        drop(self.input);
        self.child.wait().expect("it ends").code()
    }
}

/// A new folder with files, and the beginning of the addresses of its files.
fn folder(name: &str, files: &[(&str, &str)]) -> (PathBuf, String) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    for (name, text) in files {
        fs::write(folder.join(name), text).expect(name);
    }
    let path = folder.to_string_lossy().replace('\\', "/").replace(' ', "%20");
    (folder, format!("file:///{}", path.trim_start_matches('/')))
}

#[test]
fn an_editor_talks_to_the_program() {
    let mut server = Running::new(&[]);
    server.begin();
    let found = server.open("untitled:1", "M03 S500\nG00 X50 Z2\nG01 Z-30 F0.1\nG01 X\nM30\n");
    assert_eq!(found[0]["range"], range((3, 4), (3, 5)));
    server.send_text("not JSON");
    assert_eq!(server.receive()["error"]["code"], -32700);
    server.send(&json!({"id": "a", "method": "shutdown"}));
    let answer = server.receive();
    assert_eq!((&answer["id"], &answer["result"]), (&json!("a"), &Value::Null));
    server.send(&json!({"method": "exit"}));
    assert_eq!(server.end(), Some(0));
}

#[test]
fn the_exit_status_tells_how_the_session_ended() {
    let mut server = Running::new(&[]);
    server.begin();
    server.send(&json!({"method": "exit"}));
    assert_eq!(server.end(), Some(1), "without `shutdown`");
    assert_eq!(Running::new(&[]).end(), Some(0), "the client has gone");
    let mut server = Running::new(&[]);
    server.input.write_all(b"{}\n\n").expect("it reads");
    assert_eq!(server.end(), Some(2), "no frame");
    assert_eq!(Running::new(&["--setup", "there/is/no/such.json"]).end(), Some(2));
}

#[test]
fn a_program_with_subprograms_is_changed_up_to_its_end() {
    let (_, address) = folder("server end", &[("O2000.nc", "O2000\nG01 W-5 F0.1\nM99\n")]);
    let program = "%\nO1\nT0101 M03 S800\ng0 X50 Z2\nM98 P2000\nGOTO 10\nN10 X60\nM30\n%\n";
    for notes in ["", "GOTO 10\n", &"(these notes are longer than the subprogram)\nGOTO 10\n".repeat(3)] {
        let mut server = Running::new(&[]);
        server.begin();
        let uri = format!("{address}/part.nc");
        assert_eq!(server.open(&uri, &format!("{program}{notes}")), Vec::<Value>::new(), "O2000 is found");
        let document = json!({"uri": uri});
        let options = json!({"tabSize": 4, "insertSpaces": true});
        let params = json!({"textDocument": document, "options": options});
        server.send(&json!({"id": 1, "method": "textDocument/formatting", "params": params}));
        let formatted = server.receive();
        let edit = json!([{"range": range((3, 0), (3, 9)), "newText": "G00 X50 Z2"}]);
        assert_eq!(formatted["result"], edit, "{notes:?}: {formatted}");
        let params =
            json!({"textDocument": document, "position": {"line": 6, "character": 1}, "newName": "N20"});
        server.send(&json!({"id": 2, "method": "textDocument/rename", "params": params}));
        let renamed = server.receive();
        assert!(renamed["result"]["changes"][&uri].is_array(), "{notes:?}: {renamed}");
        assert_eq!(server.end(), Some(0));
    }
}

#[test]
fn messages_lead_to_the_folder_of_the_option() {
    let (_, address) =
        folder("server rules", &[("gcode-playground.toml", "rules-url = \"https://b.example\"\n")]);
    for (arguments, folder) in
        [(&[][..], "https://b.example"), (&["--rules-url", "https://a.example/r"], "https://a.example/r")]
    {
        let mut server = Running::new(arguments);
        server.begin();
        let found = server.open(&format!("{address}/part.nc"), "O1\nT0101 M3 S800\nG00 X50 Z2\n");
        let page = format!("{folder}/en/no-program-end.html");
        assert_eq!(found[0]["codeDescription"]["href"], page);
        assert_eq!(server.end(), Some(0));
    }
}

#[test]
fn configuration_and_subprograms_are_those_of_check() {
    let toml = "ignore = [\"no-program-end\"]\nlanguage = \"ru\"\n";
    let files = [("gcode-playground.toml", toml), ("O2000.nc", "O2000\nG01 W-5 F0.1\nM99\n")];
    let (folder, address) = folder("server files", &files);
    let mut server = Running::new(&[]);
    server.begin();
    let calling = "O1\nT0101 M3 S800\nG00 X50 Z2\nM98 P2000\nM30\n";
    assert_eq!(server.open(&format!("{address}/calling.nc"), calling), Vec::<Value>::new(), "O2000 is found");
    let calling = json!({"textDocument": {"uri": format!("{address}/calling.nc")}});
    server.send(&json!({"method": "textDocument/didClose", "params": calling}));
    assert_eq!(server.receive()["params"]["diagnostics"], json!([]));
    let without_end = "O1\nT0101 M3 S800\nG00 X50 Z2\n";
    assert_eq!(
        server.open(&format!("{address}/part.nc"), without_end),
        Vec::<Value>::new(),
        "the rule is off"
    );
    let toml = "language = \"ru\"\nrules-url = \"https://a.example/rules/\"\n";
    fs::write(folder.join("gcode-playground.toml"), toml).expect("a configuration");
    server.send(&json!({"method": "workspace/didChangeWatchedFiles", "params": {"changes": []}}));
    let told = server.receive();
    let found = &told["params"]["diagnostics"][0];
    assert_eq!(found["code"], "W-NO-END", "{told}");
    assert!(found["message"].as_str().is_some_and(|text| text.contains("программ")), "{found}");
    assert_eq!(found["codeDescription"]["href"], "https://a.example/rules/ru/no-program-end.html");
    fs::write(folder.join("gcode-playground.toml"), "colour = 3\n").expect("a configuration");
    server.send(&json!({"method": "workspace/didChangeWatchedFiles", "params": {"changes": []}}));
    let shown = server.receive();
    assert_eq!(shown["method"], "window/showMessage");
    assert!(shown["params"]["message"].as_str().is_some_and(|text| text.contains("colour")), "{shown}");
    assert_eq!(server.end(), Some(0));
}
