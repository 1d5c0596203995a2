//! Compares the command line under Node with the native one: `npx BIN` runs both and compares their output
//! byte by byte: standard output, standard error, exit status, files. Part of `cargo xtask test --all`.
//!
//! It makes every call of the reference, runs commands and formats on the programs of `tests/programs`, and
//! reads difficult files. The table in `options.md` lists the options with equal output; `UPDATE_EXPECT=1`
//! updates it. The cases of `tests/files.rs`, with failing writes, also run under Node.

#[path = "../documentation/calls.rs"]
mod calls;
// The cases depend on Linux.
#[cfg(target_os = "linux")]
#[path = "../files/cases.rs"]
mod cases;
#[path = "../documentation/usage.rs"]
mod usage;

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use expect_test::expect_file;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const TABLE: &str = "tests/npx/options.md";

/// Native only: a module has no threads to wait in, and shells complete installed programs only.
const NATIVE: [&str; 4] = ["--watch", "server", "completions", "man-page"];

const HEAD: &str = "# The command line natively and under Node\n\nEvery call of the reference was made twice, by the program that cargo builds and by the one of the npm package, and they wrote the same: standard\noutput, standard error, exit status and files, to the byte. `tests/npx/compare.rs` makes this table.\n\n| command | the same under Node | native only |\n|---|---|---|\n";

/// The output of a call.
#[derive(PartialEq, Eq)]
struct Written {
    status: Option<i32>,
    out: Vec<u8>,
    err: Vec<u8>,
    files: BTreeMap<PathBuf, Vec<u8>>,
}

struct Both {
    native: PathBuf,
    node: PathBuf,
    folder: PathBuf,
    calls: usize,
    different: Vec<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let node = env::args_os().nth(1).ok_or("which program of the npm package?")?;
    let native = env::current_exe()?
        .with_file_name("..")
        .join("gcode-playground")
        .with_extension(env::consts::EXE_EXTENSION);
    let folder = Path::new(ROOT).join("target/npx-files");
    let mut both = Both { native, node: fs::canonicalize(node)?, folder, calls: 0, different: Vec::new() };
    both.the_reference()?;
    both.the_programs()?;
    both.files_that_are_hard_to_read()?;
    #[cfg(target_os = "linux")]
    both.files_that_are_written();
    let table = both.table()?;
    println!("{} calls, {} different", both.calls, both.different.len());
    if !both.different.is_empty() {
        return Err(both.different.join("\n").into());
    }
    expect_file![Path::new(ROOT).join(TABLE)].assert_eq(&table);
    Ok(())
}

impl Both {
    /// Makes a call with both programs; `prepare` writes the files and returns the arguments.
    fn call(&mut self, input: &[u8], prepare: impl Fn(&Path) -> Vec<String>) -> Result<(), Box<dyn Error>> {
        let mut written = Vec::new();
        let mut named = String::new();
        for program in [&self.native, &self.node] {
            let _ = fs::remove_dir_all(&self.folder);
            fs::create_dir_all(&self.folder)?;
            let arguments = prepare(&self.folder);
            named = arguments.join(" ");
            let mut child = Command::new(program)
                .current_dir(&self.folder)
                .args(&arguments)
                .env_remove("NO_COLOR")
                .stdin(Stdio::piped())
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()?;
            // A command that does not read its input closes the pipe.
            let _ = child.stdin.take().ok_or("no standard input")?.write_all(input);
            let output = child.wait_with_output()?;
            let mut files = BTreeMap::new();
            gather(&self.folder, &mut files)?;
            written.push(Written {
                status: output.status.code(),
                out: output.stdout,
                err: output.stderr,
                files,
            });
        }
        self.calls += 1;
        let (native, node) = (&written[0], &written[1]);
        if native != node {
            let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).chars().take(400).collect::<String>();
            let shown = |one: &Written| format!("{:?}\n{}\n{}", one.status, text(&one.out), text(&one.err));
            self.different.push(format!("{named}\nnative: {}\nNode: {}", shown(native), shown(node)));
        }
        Ok(())
    }

    /// Every call that the reference shows.
    fn the_reference(&mut self) -> Result<(), Box<dyn Error>> {
        for line in reference()? {
            for words in usage::calls(&line) {
                if !words.iter().any(|word| NATIVE.contains(&word.as_str())) {
                    self.call(calls::PROGRAM.as_bytes(), |folder| calls::arguments(&words, folder))?;
                }
            }
        }
        Ok(())
    }

    /// All programs, in all formats and languages; and each command on some of them.
    fn the_programs(&mut self) -> Result<(), Box<dyn Error>> {
        let programs = format!("{ROOT}/tests/programs");
        for format in ["text", "concise", "json", "sarif", "github", "gitlab", "rdjson", "junit", "markdown"]
        {
            for lang in ["en", "zh", "ru"] {
                let line = format!(
                    "check {programs} {ROOT}/tests/fixtures --extension nc,txt --format {format} --lang {lang}"
                );
                self.words(&line)?;
            }
        }
        let commands = [
            "motions",
            "expand",
            "rewrite --lang zh",
            "part",
            "summary",
            "svg",
            "svg --turret front",
            "export csv",
            "export dxf",
            "export stl",
            "export card --lang ru",
            "export program",
            "clean",
            "check --fix --dry-run",
            "embed",
            "embed --format mdx",
        ];
        let mut files = BTreeMap::new();
        gather(Path::new(&programs), &mut files)?;
        let files: Vec<_> =
            files.into_keys().filter(|file| file.extension().is_some_and(|ending| ending == "nc")).collect();
        for (file, command) in files.iter().zip(commands.iter().cycle()) {
            self.words(&format!("{command} {programs}/{}", file.display()))?;
        }
        if files.len() < commands.len() { Err("too few programs".into()) } else { Ok(()) }
    }

    fn words(&mut self, line: &str) -> Result<(), Box<dyn Error>> {
        self.call(b"", |_| line.split(' ').map(str::to_owned).collect())
    }

    /// Names, encodings and mistakes.
    fn files_that_are_hard_to_read(&mut self) -> Result<(), Box<dyn Error>> {
        let chinese = b"O1(\xcd\xe2\xd4\xb2\xb3\xb5\xcf\xf7)\r\nM3 S500\r\nG0 X\r\nGO1 X5O\r\nM30\r\n";
        let files: [(&str, &[u8]); 8] = [
            ("ü ß 外圆.nc", chinese),
            ("utf16.nc", b"\xff\xfeG\x00G\x00"),
            ("escape.nc", b"O1\nG0 X\x1b[31m50\x00\x07\nM30"),
            ("sub/old/O0002", b"\n\n"),
            (".gitignore", b"old/\n*.tap\n!kept.tap\n"),
            ("kept.tap", b"G7.7\n"),
            ("bad.toml", b"control = \"siemens\"\n"),
            ("setup.toml", b"[machine]\nrapidX = \"fast\"\n"),
        ];
        let lines = [
            "check .",
            "check . --fix",
            "check ./sub",
            "check sub/../kept.tap",
            "check gone.nc kept.tap also/gone.nc",
            "check kept.tap/x.nc",
            "motions sub",
            "motions kept.tap --setup gone.json",
            "motions kept.tap --setup setup.toml",
            "check kept.tap --config bad.toml",
            "check . --exclude {a",
            "check . --extension xyz",
            "check kept.tap --select nothing",
            "check kept.tap --severity unknown-g-code",
            "check kept.tap --color always",
            "check - --stdin-filename sub/x.nc",
            "check - --selection x",
            "nothing",
            "explain gone",
            "expand",
            "check kept.tap --output-file gone/out.txt",
            "clean .gitignore",
            "export stl kept.tap -o out.stl",
            "config sub/old/O0002",
            "check --write-baseline known.json .",
        ];
        for line in lines {
            self.call(b"O1\nG0 X\n", |folder| {
                fs::create_dir_all(folder.join("sub/old")).expect("a folder");
                for (name, content) in files {
                    fs::write(folder.join(name), content).expect(name);
                }
                line.split(' ').filter(|word| !word.is_empty()).map(str::to_owned).collect()
            })?;
        }
        Ok(())
    }

    /// No file is lost: the same cases as in `tests/files.rs`.
    #[cfg(target_os = "linux")]
    fn files_that_are_written(&mut self) {
        let scratch = Path::new(ROOT).join("target/npx-files");
        for (name, case) in cases::CASES {
            let bench = cases::Bench::new(&self.node, &scratch, name);
            if std::panic::catch_unwind(|| case(&bench)).is_err() {
                self.different.push(format!("{name}: a panic above says what failed"));
            }
        }
    }

    /// The table of options according to the help of both.
    fn table(&mut self) -> Result<String, Box<dyn Error>> {
        let commands: BTreeSet<String> =
            reference()?.iter().filter_map(|line| line.split(' ').next().map(str::to_owned)).collect();
        let (top, top_of_node) = (help(&self.native, &[])?, help(&self.node, &[])?);
        let mut table = HEAD.to_owned();
        for command in commands {
            let has = |text: &str| text.lines().any(|line| line.split_whitespace().next() == Some(&command));
            let own = options(&help(&self.native, &[&command])?);
            let of_node =
                if has(&top_of_node) { options(&help(&self.node, &[&command])?) } else { BTreeSet::new() };
            let only: Vec<_> = own.difference(&of_node).cloned().collect();
            let expected =
                |name: &String| NATIVE.contains(&name.as_str()) || NATIVE.contains(&command.as_str());
            if !has(&top) || !of_node.is_subset(&own) || !only.iter().all(expected) {
                self.different.push(format!("{command}: options {only:?}"));
            }
            let listed = |names: Vec<String>| {
                names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" ")
            };
            let (same, only) = match has(&top_of_node) {
                true => (listed(of_node.into_iter().collect()), listed(only)),
                false => (String::new(), "all of it".to_owned()),
            };
            table += &format!("| `{command}` | {same} | {only} |\n");
        }
        Ok(table)
    }
}

/// The usage lines in the reference, without the name of the program.
fn reference() -> Result<Vec<String>, Box<dyn Error>> {
    let text = fs::read_to_string(Path::new(ROOT).join("www/docs/command-line.md"))?;
    let lines = text.lines().filter_map(|line| Some(line.strip_prefix("    gcode-playground ")?.to_owned()));
    Ok(lines.collect())
}

fn help(program: &Path, words: &[&str]) -> Result<String, Box<dyn Error>> {
    let output = Command::new(program).args(words).arg("--help").output()?;
    Ok(String::from_utf8(output.stdout)?)
}

/// The long names of the options in a help.
fn options(help: &str) -> BTreeSet<String> {
    let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
    let words = lines.filter_map(|line| line.split([' ', ',', '[']).find(|word| word.starts_with("--")));
    words.map(str::to_owned).collect()
}

/// All files of a folder, recursively, by relative path.
fn gather(folder: &Path, files: &mut BTreeMap<PathBuf, Vec<u8>>) -> Result<(), Box<dyn Error>> {
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let content = fs::read(&path)?;
                files.insert(path.strip_prefix(folder)?.to_owned(), content);
            }
        }
    }
    Ok(())
}
