//! In: the port and whether to open a browser. Out: the page, served by Vite on localhost until Ctrl-C. It
//! reloads after each change of a source.
//!
//! Here the interpreter is a single module, compiled quickly without optimisation. `package` builds the
//! optimised site.

use std::fs;
use std::net::{Ipv4Addr, Ipv6Addr, TcpListener, TcpStream};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant, SystemTime};
use std::{env, io};

use crate::bindgen::{self, For};
use crate::run::{self, Result, step};
use crate::setup::Setup;
use crate::wasm_std::Toolchain;
use crate::{native, package, parts};

/// Default port; the next free one is used if it is taken.
const PORT: u16 = 8017;

/// Number of ports to try.
const PORTS: u16 = 20;

/// The arguments of `cargo xtask play`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// The port to serve on. It is an error if this port is taken.
    pub port: Option<u16>,
    /// Whether to show the page.
    pub browser: Browser,
}

/// Whether to show the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Browser {
    /// Open it if there is a display.
    Open,
    /// Do not open it.
    Leave,
}

/// The profile in Cargo.toml.
const PROFILE: &str = "play";

/// Interval between checks of the sources.
const PAUSE: Duration = Duration::from_millis(300);

/// Time limit for the start of the server.
const MOST: Duration = Duration::from_secs(60);

/// The environment variable that passes the folder of these pages to Vite.
const DOCUMENTS: &str = "PLAYGROUND_DOCUMENTS";

/// `cargo xtask play`.
pub fn main(options: Options) -> Result {
    let start = Instant::now();
    let mut seen = changed(&sources());
    let setup = Setup::for_playing_while(compile)?;
    make_package()?;
    let port = free_port(options.port)?;
    let mut server = serve(&setup, port)?;
    let address = format!("http://localhost:{port}/");
    run::say(format_args!("ready after {}", run::pretty(start.elapsed())));
    run::say(format_args!("the playground is at {address}  (Ctrl-C stops it)"));
    if options.browser == Browser::Open && has_screen() {
        open(&address);
    }
    thread::spawn(|| documents().unwrap_or_else(run::say));
    loop {
        thread::sleep(PAUSE);
        if let Ok(Some(status)) = server.try_wait() {
            return Err(format!("the server has ended ({status})"));
        }
        let now = changed(&sources());
        if now != seen {
            seen = now;
            // The page stays unchanged until the sources compile again.
            compile(setup.toolchain).and_then(|()| make_package()).unwrap_or_else(run::say);
        }
    }
}

/// Compiles the interpreter.
fn compile(toolchain: Toolchain) -> Result {
    let mut cargo = run::command("cargo");
    toolchain.apply(&mut cargo);
    cargo.args(["rustc", "--lib", "--crate-type", "cdylib", "--profile", PROFILE, "--no-default-features"]);
    step("compiling the interpreter", cargo.args(["--target", "wasm32-unknown-unknown"])).map(drop)
}

/// Makes the package in `www/pkg` from the compiled interpreter.
fn make_package() -> Result {
    let folder = run::target().join("wasm32-unknown-unknown").join(PROFILE);
    let module = folder.join("gcode_playground.wasm");
    let package = run::www().join("pkg");
    let stamp = package.join(package::STAMP);
    let built = format!("{PROFILE} {:?}", fs::metadata(&module).and_then(|file| file.modified()).ok());
    if fs::read_to_string(&stamp).is_ok_and(|before| before == built) {
        return Ok(());
    }
    let bound = folder.join("package");
    bindgen::package(&module, "gcode_playground", &bound, For::Page)?;
    // The stamp is written last, so that the page does not reload an incomplete package.
    package::begin(&package)?;
    for entry in fs::read_dir(&bound).into_iter().flatten().flatten() {
        let (from, to) = (entry.path(), package.join(entry.file_name()));
        fs::copy(&from, &to).map_err(|error| format!("cannot write {}: {error}", to.display()))?;
    }
    for (name, text) in parts::whole() {
        package::write(&package.join(name), &text)?;
    }
    package::write(&package.join(".gitignore"), "*\n")?;
    package::write(&stamp, &built)
}

/// The folder of the rule pages, the reference and the pages of the manual.
fn documents_folder() -> PathBuf {
    run::target().join("documents")
}

/// Writes the rule pages, the reference and the pages of the manual.
fn documents() -> Result {
    let folder = documents_folder();
    step(
        "writing the pages of the rules",
        native::rule_pages(native::Beside::Nothing)?.arg(folder.join("rules")),
    )?;
    step(
        "writing the reference and the pages of the manual",
        native::reference(native::Beside::Nothing)?.arg(folder),
    )?;
    Ok(())
}

/// Starts Vite. It exits with this process, because its standard input is closed then.
fn serve(setup: &Setup, port: u16) -> Result<Child> {
    let mut vite = setup.command("node");
    vite.current_dir(run::www()).args([
        "node_modules/vite/bin/vite.js",
        "--host",
        "localhost",
        "--strictPort",
    ]);
    vite.args(["--clearScreen", "false", "--logLevel", "warn", "--port", &port.to_string()]);
    vite.env(DOCUMENTS, documents_folder()).env_remove("CI").stdin(Stdio::piped());
    let mut server = vite.spawn().map_err(|error| format!("cannot start Vite: {error}"))?;
    let start = Instant::now();
    while !answers(port) {
        if let Ok(Some(status)) = server.try_wait() {
            return Err(format!("Vite has ended ({status})"));
        }
        if start.elapsed() > MOST {
            return Err(format!("Vite does not answer on port {port}"));
        }
        thread::sleep(Duration::from_millis(50));
    }
    Ok(server)
}

fn answers(port: u16) -> bool {
    TcpStream::connect(("localhost", port)).is_ok()
}

/// The files from which the interpreter is compiled.
fn sources() -> [PathBuf; 3] {
    ["src", "Cargo.toml", "Cargo.lock"].map(|name| run::root().join(name))
}

/// The time of the latest change in files and folders.
fn changed(paths: &[PathBuf]) -> Option<SystemTime> {
    let of = |path: &PathBuf| {
        let time = fs::metadata(path).and_then(|file| file.modified()).ok();
        let within: Vec<PathBuf> =
            fs::read_dir(path).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
        time.max(changed(&within))
    };
    paths.iter().filter_map(of).max()
}

fn free_port(port: Option<u16>) -> Result<u16> {
    let mut tried = match port {
        Some(port) => port..=port,
        None => PORT..=PORT + (PORTS - 1),
    };
    let range = tried.clone();
    tried.find(|&port| is_free(port)).ok_or_else(|| match port {
        Some(port) => format!("port {port} of localhost is taken: try another with --port"),
        None => {
            format!("all ports from {} to {} are taken: name one with --port", range.start(), range.end())
        }
    })
}

/// Whether a port is free for both address families of `localhost`.
fn is_free(port: u16) -> bool {
    let is_taken = |error: &io::Error| error.kind() == io::ErrorKind::AddrInUse;
    let addresses = [(Ipv4Addr::LOCALHOST, port).into(), (Ipv6Addr::LOCALHOST, port).into()];
    addresses.iter().all(|address: &std::net::SocketAddr| {
        !TcpListener::bind(address).is_err_and(|error| is_taken(&error))
    })
}

fn has_screen() -> bool {
    let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    !set("CI") && (cfg!(any(windows, target_os = "macos")) || set("DISPLAY") || set("WAYLAND_DISPLAY"))
}

/// Opens the address in the browser of the user. A failure is ignored, since the address has been printed.
fn open(address: &str) {
    let mut command = if cfg!(windows) {
        let mut command = Command::new("rundll32");
        command.arg("url.dll,FileProtocolHandler");
        command
    } else {
        Command::new(if cfg!(target_os = "macos") { "open" } else { "xdg-open" })
    };
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let _ = command.spawn();
}
