//! In: the port and whether to open a browser. Out: the page, built and served on localhost until Ctrl-C.
//! It is all one process: to stop it is to stop the server.

use std::env;
use std::process::{Command, Stdio};
use std::time::Instant;

use crate::package;
use crate::run::{self, Result};
use crate::serve::Server;
use crate::setup::Setup;

/// The port where none is asked for, or the first free one after it.
const PORT: u16 = 8017;

/// How many ports are tried.
const PORTS: u16 = 20;

/// The arguments of `cargo xtask play`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Where to serve; if this port is taken, it is an error.
    pub port: Option<u16>,
    /// Whether the page is shown.
    pub browser: Browser,
}

/// Whether the page is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Browser {
    /// Where there is a screen.
    Open,
    /// Not at all.
    Leave,
}

/// `cargo xtask play`.
pub fn main(options: Options) -> Result {
    let start = Instant::now();
    let setup = Setup::for_building()?;
    package::site(&setup)?;
    let server = bind(options.port)?;
    let address = format!("http://localhost:{}/", server.port);
    run::say(format_args!("ready after {}", run::pretty(start.elapsed())));
    run::say(format_args!("the playground is at {address}  (Ctrl-C stops it)"));
    if options.browser == Browser::Open && has_screen() {
        open(&address);
    }
    server.serve(&run::www().join("dist"));
    Ok(())
}

fn bind(port: Option<u16>) -> Result<Server> {
    let mut tried = match port {
        Some(port) => port..=port,
        None => PORT..=PORT + (PORTS - 1),
    };
    let range = tried.clone();
    tried.find_map(|port| Server::bind(port).ok()).ok_or_else(|| match port {
        Some(port) => format!("port {port} of localhost is taken: try another with --port"),
        None => {
            format!("all ports from {} to {} are taken: name one with --port", range.start(), range.end())
        }
    })
}

fn has_screen() -> bool {
    let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    !set("CI") && (cfg!(any(windows, target_os = "macos")) || set("DISPLAY") || set("WAYLAND_DISPLAY"))
}

/// Shows the address in the user's browser. If that fails, the address has been printed anyhow.
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
