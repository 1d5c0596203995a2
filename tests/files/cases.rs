//! Files after the command line has written them, or has failed to: size limit, read-only folder, full file
//! system, links, pipes, devices, concurrent processes. `tests/files.rs` runs the cases natively,
//! `tests/npx/compare.rs` under Node.
//!
//! In: the program to test and a folder. A failing case panics. Linux only: the cases use `/dev/full`,
//! `setpriv`, `unshare` and `mount`.

use std::fs::{self, File, OpenOptions};
use std::io::{Read, Write};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::Duration;

/// A case; it panics on failure.
pub type Case = fn(&Bench);

/// All cases by name.
pub const CASES: [(&str, Case); 18] = [
    ("size limit", size_limit),
    ("size limit and hard link", size_limit_and_hard_link),
    ("closed folder", closed_folder),
    ("closed file", closed_file),
    ("full file system", full_file_system),
    ("file that is mounted", mounted_file),
    ("symbolic links", symbolic_links),
    ("dangling and endless links", dangling_and_endless_links),
    ("hard link", hard_link),
    ("pipes and devices", pipes_and_devices),
    ("standard output by its path", standard_output_by_path),
    ("two processes", two_processes),
    ("changed before `clean -o`", changed_before_clean),
    ("changed before `embed --fix`", changed_before_embed),
    ("changed list of known findings", changed_baseline),
    ("mode and owner", mode_and_owner),
    ("long name", long_name),
    ("output in place of an input", output_in_place_of_input),
];

/// A block with a fault that has a safe fix, and the fixed block. A comment makes it long, because the number
/// of fixes per program is limited.
const FAULTY: &str = "G01 X5O F0.1 (TURN THE DIAMETER, FACE THE SHOULDER AND CLEAR THE WORK)\n";
const FIXED: &str = "G01 X50 F0.1 (TURN THE DIAMETER, FACE THE SHOULDER AND CLEAR THE WORK)\n";

/// Limits the file size to 100 blocks of at most 1,024 bytes each.
const LIMITED: &str = "ulimit -f 100; exec \"$@\"";

/// The tested program, and the folder of one case.
pub struct Bench {
    program: PathBuf,
    folder: PathBuf,
}

impl Bench {
    /// An empty folder in a folder of scratch files.
    pub fn new(program: &Path, scratch: &Path, case: &str) -> Self {
        let folder = scratch.join(case.replace(|letter: char| !letter.is_ascii_alphanumeric(), "-"));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        Self { program: program.to_owned(), folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, content).expect(name);
        path
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect(name)
    }

    /// The names in the folder, which must not include a temporary file.
    fn names(&self) -> Vec<String> {
        let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("an entry").file_name();
        let entries = fs::read_dir(&self.folder).expect("the folder");
        let mut names: Vec<_> = entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// The program, started in the folder of the case.
    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command.args(arguments).current_dir(&self.folder).stdin(Stdio::null());
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().expect("the command line starts")
    }

    /// Runs the program as the arguments `"$@"` of a script.
    fn script(&self, script: &str, arguments: &[&str]) -> Output {
        self.under(&["sh", "-c", script, "sh"], arguments)
    }

    /// Starts the program via another one, such as a shell.
    fn under(&self, starter: &[&str], arguments: &[&str]) -> Output {
        let mut command = Command::new(starter[0]);
        command.args(&starter[1..]).arg(&self.program).args(arguments).current_dir(&self.folder);
        command.stdin(Stdio::null()).output().expect(starter[0])
    }

    /// The same without the permission of root to write everywhere.
    fn unprivileged(&self, arguments: &[&str]) -> Output {
        match is_root() {
            true => self.under(&["setpriv", "--bounding-set=-all", "--inh-caps=-all"], arguments),
            false => self.run(arguments),
        }
    }

    /// Runs a script in a namespace where it may mount file systems. It exits with the status of the program.
    fn mounting(&self, script: &str, arguments: &[&str]) -> Output {
        let unshare = if is_root() { "-m" } else { "-Urm" };
        let may_mount = Command::new("unshare")
            .args([unshare, "sh", "-c", "mount -t tmpfs tmpfs /mnt"])
            .output()
            .expect("unshare");
        assert!(
            may_mount.status.success(),
            "file systems are tried where they can be mounted: as root, or where `unshare -Urm` works: {}",
            text(&may_mount.stderr)
        );
        self.under(&["unshare", unshare, "sh", "-c", script, "sh"], arguments)
    }
}

fn is_root() -> bool {
    fs::metadata("/proc/self").expect("/proc").uid() == 0
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Checks that a call failed with this message.
#[track_caller]
fn assert_refused(output: &Output, said: &str) {
    let error = text(&output.stderr);
    let shown = error.get(error.len().saturating_sub(1_000)..).unwrap_or(&error);
    assert!(error.contains(said), "{:?}: not {said}: {shown}", output.status);
    assert_eq!(output.status.code(), Some(2), "{shown}");
}

/// Checks that a call succeeded.
#[track_caller]
fn assert_done(output: &Output) {
    assert!(matches!(output.status.code(), Some(0 | 1)), "{:?}: {}", output.status, text(&output.stderr));
}

/// A program of about 150,000 bytes that repeats a block.
fn long(block: &str) -> String {
    format!("M03 S500\n{}M30\n", block.repeat(150_000 / block.len()))
}

/// A program with a single such block.
fn short(block: &str) -> String {
    format!("M03 S500\n{block}M30\n")
}

fn inode(path: &Path) -> u64 {
    fs::metadata(path).expect("a file").ino()
}

fn size_limit(bench: &Bench) {
    let program = long(FAULTY);
    bench.write("part.nc", &program);
    for script in [LIMITED, "trap '' XFSZ; ulimit -f 100; exec \"$@\""] {
        let output = bench.script(script, &["check", "--quiet", "--fix", "part.nc"]);
        assert_refused(&output, "part.nc: it would exceed the size limit for files");
        assert!(bench.text("part.nc") == program);
        assert_eq!(bench.names(), ["part.nc"]);
        for to in ["part.nc", "new.nc"] {
            let output = bench.script(script, &["expand", "part.nc", "-o", to]);
            assert_refused(&output, &format!("{to}: it would exceed the size limit for files"));
            assert!(bench.text("part.nc") == program);
            assert_eq!(bench.names(), ["part.nc"]);
        }
    }
}

/// The backup can be written, but the new content cannot: half of it is already in the file.
fn size_limit_and_hard_link(bench: &Bench) {
    bench.write("part.nc", long(FIXED));
    let old = short(FAULTY);
    let link = bench.write("old.nc", &old);
    fs::hard_link(&link, bench.path("link.nc")).expect("a link");
    let output = bench.script(LIMITED, &["expand", "part.nc", "-o", "link.nc"]);
    assert_refused(&output, "link.nc: it would exceed the size limit for files");
    assert_eq!((bench.text("old.nc"), bench.text("link.nc")), (old.clone(), old));
    assert_eq!(bench.names(), ["link.nc", "old.nc", "part.nc"]);
    assert_eq!(inode(&link), inode(&bench.path("link.nc")));
}

fn closed_folder(bench: &Bench) {
    fs::create_dir(bench.path("closed")).expect("a folder");
    let program = short(FAULTY);
    let part = bench.write("closed/part.nc", &program);
    let mode = |mode| fs::set_permissions(bench.path("closed"), fs::Permissions::from_mode(mode));
    mode(0o555).expect("a mode");
    let fixed = bench.unprivileged(&["check", "--fix", "closed/part.nc"]);
    let new = bench.unprivileged(&["expand", "closed/part.nc", "-o", "closed/new.nc"]);
    let names = fs::read_dir(bench.path("closed")).expect("a folder").count();
    mode(0o755).expect("a mode");
    assert_refused(&fixed, "closed/part.nc: its folder cannot be written: access is denied");
    assert_refused(&new, "closed/new.nc: its folder cannot be written: access is denied");
    assert_eq!((fs::read_to_string(part).expect("part.nc"), names), (program, 1));
}

/// A read-only file in a writable folder is not replaced.
fn closed_file(bench: &Bench) {
    let program = short(FAULTY);
    let part = bench.write("part.nc", &program);
    fs::set_permissions(&part, fs::Permissions::from_mode(0o444)).expect("a mode");
    let output = bench.unprivileged(&["check", "--fix", "part.nc"]);
    assert_refused(&output, "part.nc: access is denied");
    assert_eq!((bench.text("part.nc"), bench.names()), (program, vec!["part.nc".to_owned()]));
}

fn full_file_system(bench: &Bench) {
    let program = long(FAULTY);
    bench.write("part.nc", &program);
    bench.write("fixed.nc", long(FIXED));
    bench.write("old.nc", short(FAULTY));
    fs::create_dir(bench.path("disk")).expect("a folder");
    fs::create_dir(bench.path("after")).expect("a folder");
    let script = |before: &str| {
        format!(
            "mount -t tmpfs -o size=256k tmpfs disk && cp part.nc disk && {before}\n\"$@\"\nstatus=$?\ncp -a disk/. after; exit $status"
        )
    };
    let after = |name: &str| fs::read_to_string(bench.path("after").join(name)).expect(name);
    let clear = || {
        let names = fs::read_dir(bench.path("after")).expect("a folder").map(|entry| {
            let path = entry.expect("an entry").path();
            fs::remove_file(&path).expect("a file");
            path.file_name().expect("a name").to_string_lossy().into_owned()
        });
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    };
    // A file of 150,000 bytes next to another one.
    let output = bench.mounting(&script(":"), &["check", "--quiet", "--fix", "disk/part.nc"]);
    assert_refused(&output, "disk/part.nc: the disk is full");
    assert!(after("part.nc") == program);
    assert_eq!(clear(), ["part.nc"]);

    let output = bench.mounting(&script(":"), &["expand", "fixed.nc", "-o", "disk/new.nc"]);
    assert_refused(&output, "disk/new.nc: the disk is full");
    assert_eq!(clear(), ["part.nc"]);

    // There is room for the backup, but not for the new content.
    let linked = script("cp old.nc disk && ln disk/old.nc disk/link.nc");
    let output = bench.mounting(&linked, &["expand", "fixed.nc", "-o", "disk/link.nc"]);
    assert_refused(&output, "disk/link.nc: the disk is full");
    assert_eq!((after("old.nc"), after("link.nc")), (short(FAULTY), short(FAULTY)));
    assert_eq!(clear(), ["link.nc", "old.nc", "part.nc"]);

    // There is no room for the backup.
    let linked = script("ln disk/part.nc disk/link.nc");
    let output = bench.mounting(&linked, &["check", "--quiet", "--fix", "disk/link.nc"]);
    assert_refused(&output, "disk/link.nc: the disk is full");
    assert!(after("part.nc") == program && after("link.nc") == program);
    assert_eq!(clear(), ["link.nc", "part.nc"]);

    let read_only = script("mount -o remount,ro disk");
    let output = bench.mounting(&read_only, &["check", "--quiet", "--fix", "disk/part.nc"]);
    assert_refused(&output, "disk/part.nc: the disk can only be read");
    let output = bench.mounting(&read_only, &["expand", "fixed.nc", "-o", "disk/new.nc"]);
    assert_refused(&output, "disk/new.nc: its folder cannot be written: the disk can only be read");
    assert!(after("part.nc") == program);
    assert_eq!(clear(), ["part.nc"]);

    let output = bench.run(&["expand", "fixed.nc", "-o", "/dev/full"]);
    assert_refused(&output, "/dev/full: the disk is full");
    let output = bench.script("exec \"$@\" > /dev/full", &["expand", "fixed.nc"]);
    assert_refused(&output, "standard output: the disk is full");
}

/// As in a container that mounts one file of its host: it cannot be replaced by a rename.
fn mounted_file(bench: &Bench) {
    let part = bench.write("part.nc", short(FAULTY));
    bench.write("mounted.nc", "");
    let script = "mount --bind part.nc mounted.nc && exec \"$@\"";
    assert_done(&bench.mounting(script, &["check", "--fix", "mounted.nc"]));
    assert_eq!((bench.text("part.nc"), bench.text("mounted.nc")), (short(FIXED), String::new()));
    assert_eq!(bench.names(), ["mounted.nc", "part.nc"]);
    assert_eq!(fs::metadata(part).expect("part.nc").nlink(), 1);
}

fn symbolic_links(bench: &Bench) {
    fs::create_dir_all(bench.path("library/old")).expect("folders");
    let part = bench.path("library/old/part.nc");
    symlink("old/part.nc", bench.path("library/second.nc")).expect("a link");
    symlink(bench.path("library/second.nc"), bench.path("third.nc")).expect("a link");
    symlink("third.nc", bench.path("first.nc")).expect("a link");
    // `..` after a folder that is itself a link.
    symlink("library/old", bench.path("folder")).expect("a link");
    symlink("folder/../second.nc", bench.path("fourth.nc")).expect("a link");
    for call in [
        &["check", "--fix", "first.nc"][..],
        &["expand", "first.nc", "-o", "first.nc"],
        &["expand", "fourth.nc", "-o", "fourth.nc"],
    ] {
        let content = short(if call[0] == "check" { FAULTY } else { "G90 X20 Z-20 F0.2\n" });
        fs::write(&part, &content).expect("part.nc");
        fs::set_permissions(&part, fs::Permissions::from_mode(0o640)).expect("a mode");
        let before = inode(&part);
        assert_done(&bench.run(call));
        for name in ["first.nc", "third.nc", "fourth.nc", "library/second.nc", "folder"] {
            assert!(fs::symlink_metadata(bench.path(name)).expect(name).is_symlink(), "{name}");
        }
        assert_ne!(fs::read_to_string(&part).expect("part.nc"), content);
        assert_eq!(fs::metadata(&part).expect("part.nc").mode() & 0o7777, 0o640);
        assert_ne!(inode(&part), before, "a new file is renamed over the old one");
        assert_eq!(fs::read_dir(bench.path("library/old")).expect("a folder").count(), 1);
        assert_eq!(fs::read_dir(bench.path("library")).expect("a folder").count(), 2);
        assert_eq!(bench.names(), ["first.nc", "folder", "fourth.nc", "library", "third.nc"]);
    }
}

fn dangling_and_endless_links(bench: &Bench) {
    bench.write("part.nc", short(FIXED));
    fs::create_dir(bench.path("later")).expect("a folder");
    symlink("later/new.nc", bench.path("dangling.nc")).expect("a link");
    assert_done(&bench.run(&["expand", "part.nc", "-o", "dangling.nc"]));
    assert!(fs::symlink_metadata(bench.path("dangling.nc")).expect("a link").is_symlink());
    assert_eq!(bench.text("later/new.nc"), short(FIXED));

    symlink("gone/new.nc", bench.path("nowhere.nc")).expect("a link");
    let output = bench.run(&["expand", "part.nc", "-o", "nowhere.nc"]);
    assert_refused(&output, "nowhere.nc: no such file or folder");

    symlink("b.nc", bench.path("a.nc")).expect("a link");
    symlink("a.nc", bench.path("b.nc")).expect("a link");
    let output = bench.run(&["expand", "part.nc", "-o", "a.nc"]);
    assert_refused(&output, "a.nc: too many symbolic links");
    assert_refused(&bench.run(&["expand", "part.nc", "-o", "later"]), "later: a folder, not a file");
    assert_eq!(bench.names(), ["a.nc", "b.nc", "dangling.nc", "later", "nowhere.nc", "part.nc"]);
}

fn hard_link(bench: &Bench) {
    let part = bench.write("part.nc", short(FAULTY));
    fs::set_permissions(&part, fs::Permissions::from_mode(0o640)).expect("a mode");
    fs::hard_link(&part, bench.path("link.nc")).expect("a link");
    symlink("link.nc", bench.path("to-link.nc")).expect("a link");
    let before = inode(&part);
    assert_done(&bench.run(&["check", "--fix", "to-link.nc"]));
    assert_eq!((bench.text("part.nc"), bench.text("link.nc")), (short(FIXED), short(FIXED)));
    assert_eq!((inode(&part), inode(&bench.path("link.nc"))), (before, before));
    assert_eq!(fs::metadata(&part).expect("part.nc").mode() & 0o7777, 0o640);
    // Shorter content leaves nothing of the longer content. If one call names the file twice, it is fixed
    // once.
    fs::write(&part, long(FAULTY)).expect("part.nc");
    let fixed = bench.write("fixed.nc", short(FIXED));
    assert_done(&bench.run(&["expand", "fixed.nc", "-o", "link.nc"]));
    assert_eq!(bench.text("part.nc"), short(FIXED));
    fs::remove_file(fixed).expect("fixed.nc");
    // Two threads may write at the same time.
    for _ in 0..8 {
        fs::write(&part, long(FAULTY)).expect("part.nc");
        assert_done(&bench.run(&["check", "--quiet", "--fix", "."]));
        assert!(bench.text("part.nc") == long(FIXED));
    }
    assert_eq!(bench.names(), ["link.nc", "part.nc", "to-link.nc"]);
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().expect("mkfifo").success());
}

fn pipes_and_devices(bench: &Bench) {
    bench.write("part.nc", long(FIXED));
    let path = bench.path("pipe");
    pipe(&path);
    symlink("pipe", bench.path("to-pipe")).expect("a link");
    for name in ["pipe", "to-pipe"] {
        let path = path.clone();
        let reader = thread::spawn(move || fs::read_to_string(path).expect("the pipe"));
        assert_done(&bench.run(&["expand", "part.nc", "-o", name]));
        assert!(reader.join().expect("a reader") == long(FIXED));
    }
    use std::os::unix::fs::FileTypeExt;
    assert!(fs::symlink_metadata(&path).expect("the pipe").file_type().is_fifo());
    // A reader that closes the pipe.
    let reader = thread::spawn(move || drop(File::open(path).expect("the pipe").read(&mut [0; 10])));
    assert_refused(&bench.run(&["expand", "part.nc", "-o", "pipe"]), "pipe: the reader has closed the pipe");
    reader.join().expect("a reader");
    assert_done(&bench.run(&["expand", "part.nc", "-o", "/dev/null"]));
    assert!(!fs::metadata("/dev/null").expect("/dev/null").is_file());
    assert_eq!(bench.names(), ["part.nc", "pipe", "to-pipe"]);
}

fn standard_output_by_path(bench: &Bench) {
    let program = short(FIXED);
    bench.write("part.nc", &program);
    symlink("/dev/stdout", bench.path("link")).expect("a link");
    for to in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "link"] {
        let output = bench.run(&["expand", "part.nc", "-o", to]);
        assert_done(&output);
        assert_eq!(text(&output.stdout), program, "{to}");
    }
    let output = bench.run(&["expand", "part.nc", "-o", "/dev/stderr"]);
    assert_eq!(text(&output.stderr), program);
    // The file keeps its earlier content, and later output is appended.
    let script = "(echo before; \"$@\"; echo after) > all.txt";
    assert_done(&bench.script(script, &["expand", "part.nc", "-o", "/dev/stdout"]));
    assert_eq!(bench.text("all.txt"), format!("before\n{program}after\n"));
    // Another descriptor of a file.
    assert_done(&bench.script("exec 3> third.txt; \"$@\"", &["expand", "part.nc", "-o", "/dev/fd/3"]));
    assert_eq!(bench.text("third.txt"), program);
    assert_eq!(bench.names(), ["all.txt", "link", "part.nc", "third.txt"]);
}

/// Concurrent readers see either the whole old content or the whole new one.
fn two_processes(bench: &Bench) {
    let [old, new] = [FAULTY, FIXED].map(long);
    let part = bench.write("part.nc", &old);
    let mut running: Vec<Child> = (0..4)
        .map(|_| {
            let mut command = bench.command(&["check", "--quiet", "--fix", "part.nc"]);
            command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the command line")
        })
        .collect();
    while running.iter_mut().any(|child| child.try_wait().expect("a process").is_none()) {
        let now = fs::read_to_string(&part).expect("part.nc");
        assert!(now == old || now == new);
        thread::sleep(Duration::from_micros(500));
        // A full pipe would prevent it from ending.
        for child in &mut running {
            if let Some(mut error) = child.stderr.take() {
                thread::spawn(move || error.read_to_end(&mut Vec::new()));
            }
        }
    }
    for mut child in running {
        assert!(matches!(child.wait().expect("a process").code(), Some(0 | 1)));
    }
    assert!(bench.text("part.nc") == new);
    assert_eq!(bench.names(), ["part.nc"]);
}

/// Size of a pipe of Linux, bytes.
const PIPE: usize = 65_536;

const CHANGED: &str = "changed on disk after it was read, so it is not overwritten; run the command again";

/// Changes a file between the read and the write of a command. The command blocks at that point: its messages
/// fill the pipe, and the test reads only the first byte.
fn changed_meanwhile(bench: &Bench, arguments: &[&str], name: &str) {
    let mut command = bench.command(arguments);
    let (mut reader, writer) = std::io::pipe().expect("a pipe");
    command.stdout(writer.try_clone().expect("a pipe")).stderr(writer);
    let mut child = command.spawn().expect("the command line");
    // Close our copies of the write end.
    drop(command);
    reader.read_exact(&mut [0]).expect("the command says something");
    assert!(child.try_wait().expect("a process").is_none());
    let changed = "(CHANGED MEANWHILE)\nM30\n";
    bench.write(name, changed);
    let mut said = Vec::new();
    reader.read_to_end(&mut said).expect("the rest");
    assert!(said.len() > PIPE, "{} bytes do not fill the pipe", said.len());
    let output = Output { status: child.wait().expect("a process"), stdout: Vec::new(), stderr: said };
    assert_refused(&output, &format!("{name}: {CHANGED}"));
    assert_eq!((bench.text(name), bench.names()), (changed.to_owned(), vec![name.to_owned()]));
}

fn changed_before_clean(bench: &Bench) {
    // The number of listed repairs is limited; each line of the list contains the name.
    let name = "a-shaft-with-a-thread-and-two-grooves.nc";
    bench.write(name, format!("O0001\n{}M30\n", "G00 X30 Z–3\n".repeat(3_000)));
    changed_meanwhile(bench, &["clean", name, "-o", name], name);
}

fn changed_before_embed(bench: &Bench) {
    let element = |attribute: &str| {
        format!(
            "<pre data-gcode-playground{attribute}>\nG00 X1 Z1\nM30\n<svg slot=\"fallback\"></svg></pre>\n\n"
        )
    };
    bench.write("page.md", element("") + &element(" data-setup=\"{\"").repeat(3_000));
    changed_meanwhile(bench, &["embed", "--fix", "page.md"], "page.md");
}

/// The program is a pipe, which is opened after the baseline has been read.
fn changed_baseline(bench: &Bench) {
    bench.write("known.json", "[]\n");
    let path = bench.path("part.nc");
    pipe(&path);
    let call = ["check", "--quiet", "--baseline", "known.json", "--write-baseline", "known.json", "part.nc"];
    let mut command = bench.command(&call);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command line");
    let mut program = OpenOptions::new().write(true).open(path).expect("the pipe");
    bench.write("known.json", "[ ]\n");
    program.write_all(b"G7.7\nM30\n").expect("a program");
    drop(program);
    assert_refused(&child.wait_with_output().expect("output"), &format!("known.json: {CHANGED}"));
    assert_eq!(bench.text("known.json"), "[ ]\n");
    assert_eq!(bench.names(), ["known.json", "part.nc"]);
}

fn mode_and_owner(bench: &Bench) {
    let part = bench.path("part.nc");
    let is_kept = |owner: Option<(u32, u32)>, mode: u32, run: &dyn Fn() -> Output| {
        bench.write("part.nc", short(FAULTY));
        if let Some((user, group)) = owner {
            std::os::unix::fs::chown(&part, Some(user), Some(group)).expect("an owner");
        }
        fs::set_permissions(&part, fs::Permissions::from_mode(mode)).expect("a mode");
        let before = fs::metadata(&part).expect("part.nc");
        assert_done(&run());
        let after = fs::metadata(&part).expect("part.nc");
        assert_eq!(bench.text("part.nc"), short(FIXED));
        assert_eq!(
            (after.mode(), after.uid(), after.gid()),
            (before.mode(), before.uid(), before.gid()),
            "{mode:o}"
        );
        assert_eq!(bench.names(), ["part.nc"]);
        before.ino() == after.ino()
    };
    let fix = || bench.run(&["check", "--fix", "part.nc"]);
    for mode in [0o600, 0o664, 0o755, 0o4755] {
        assert!(!is_kept(None, mode, &fix));
    }
    if is_root() {
        for mode in [0o600, 0o6755] {
            assert!(!is_kept(Some((1234, 4321)), mode, &fix));
        }
        // A new file cannot get the same owner, so the old file is overwritten.
        let unprivileged = || bench.unprivileged(&["check", "--fix", "part.nc"]);
        assert!(is_kept(Some((1234, 4321)), 0o666, &unprivileged));
    }
    let output = bench.script("umask 027; exec \"$@\"", &["expand", "part.nc", "-o", "new.nc"]);
    assert_done(&output);
    assert_eq!(fs::metadata(bench.path("new.nc")).expect("new.nc").mode() & 0o7777, 0o640);
}

/// The name of the temporary file does not depend on that of the target.
fn long_name(bench: &Bench) {
    let name = format!("{}.nc", "x".repeat(252));
    bench.write(&name, short(FAULTY));
    assert_done(&bench.run(&["check", "--fix", &name]));
    assert_eq!((bench.text(&name), bench.names()), (short(FIXED), vec![name.clone()]));
    let output = bench.run(&["expand", &name, "-o", &format!("x{name}")]);
    assert_refused(&output, "the name is too long or not allowed");
}

/// A program may replace itself; a picture or a report may not replace it.
fn output_in_place_of_input(bench: &Bench) {
    let cycle = "M03 S500\nG00 X30 Z2\nG90 X20 Z-20 F0.2\nM30\n";
    bench.write("part.nc", cycle);
    symlink("part.nc", bench.path("link.nc")).expect("a link");
    let said = "is read by this command, so nothing else is written into it";
    for call in
        ["svg part.nc", "export csv part.nc", "export dxf part.nc", "embed part.nc", "diff part.nc part.nc"]
    {
        for to in ["part.nc", "./part.nc", "link.nc"] {
            let arguments: Vec<&str> = call.split(' ').chain(["-o", to]).collect();
            assert_refused(&bench.run(&arguments), &format!("{to}: {said}"));
        }
    }
    fs::hard_link(bench.path("part.nc"), bench.path("hard.nc")).expect("a link");
    for to in ["part.nc", "link.nc", "hard.nc"] {
        for option in ["--output-file", "--write-baseline"] {
            let output = bench.run(&["check", "part.nc", option, to]);
            assert_refused(&output, &format!("{to}: is checked, so nothing else is written into it"));
        }
    }
    assert_eq!(bench.text("part.nc"), cycle);
    fs::remove_file(bench.path("hard.nc")).expect("hard.nc");
    assert_done(&bench.run(&["expand", "part.nc", "-o", "link.nc"]));
    assert!(bench.text("part.nc").contains("(G90 PASS 1)"));
    // Standard input is read before the file is written.
    let script = "exec \"$@\" < part.nc";
    assert_done(&bench.script(script, &["expand", "-", "-o", "part.nc"]));
    assert!(bench.text("part.nc").ends_with("M30\n"));
    assert_eq!(bench.names(), ["link.nc", "part.nc"]);
}
