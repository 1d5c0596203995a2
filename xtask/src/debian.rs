//! In: names of Debian packages. Out: the packages installed, if this is Debian and no password is needed.
//! Does not know what the packages are for.

use std::process::Command;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::run::{self, Result};

/// How a program gets administrator rights.
#[derive(Clone, Copy)]
enum Rights {
    Root,
    Sudo,
}

/// Whether packages may be installed.
static IS_ALLOWED: AtomicBool = AtomicBool::new(true);

/// Forbids installation from now on: a missing package is an error that names it.
pub fn forbid() {
    IS_ALLOWED.store(false, Ordering::Relaxed);
}

/// Whether packages may be installed, and no password is needed.
pub fn available() -> bool {
    IS_ALLOWED.load(Ordering::Relaxed) && rights().is_some()
}

/// A program that runs as administrator; `None` if this is not Debian or a password is needed.
pub fn privileged(program: &str) -> Option<Command> {
    Some(match rights()? {
        Rights::Root => run::command(program),
        Rights::Sudo => {
            let mut command = run::command("sudo");
            command.args(["-n", "env", "DEBIAN_FRONTEND=noninteractive", program]);
            command
        }
    })
}

/// Whether all these packages are installed.
pub fn installed(packages: &[&str]) -> bool {
    let mut query = run::command("dpkg-query");
    let states = run::ask(query.args(["--show", "--showformat", "${db:Status-Status}\n"]).args(packages));
    states.is_some_and(|states| states.lines().all(|state| state == "installed"))
}

/// Installs packages without their recommendations; `what` describes their purpose.
pub fn install(what: &str, packages: &[&str]) -> Result {
    static UPDATED: OnceLock<Result> = OnceLock::new();
    let apt = || privileged("apt-get").ok_or("no right to install Debian packages");
    let update = || run::quiet("refreshing Debian's list of packages", apt()?.arg("update"));
    UPDATED.get_or_init(update).clone()?;
    let mut command = apt()?;
    command.env("DEBIAN_FRONTEND", "noninteractive");
    command
        .args(["install", "-y", "--no-install-recommends", "-o", "DPkg::Lock::Timeout=300"])
        .args(packages);
    run::quiet(what, &mut command)
}

fn rights() -> Option<Rights> {
    static RIGHTS: OnceLock<Option<Rights>> = OnceLock::new();
    *RIGHTS.get_or_init(|| {
        if !is_debian() {
            None
        } else if run::ask(run::command("id").arg("-u")).as_deref() == Some("0") {
            Some(Rights::Root)
        } else if run::succeeds(run::command("sudo").args(["-n", "true"])) {
            Some(Rights::Sudo)
        } else {
            None
        }
    })
}

/// Debian itself, not its derivatives: the Ubuntu package `chromium`, for example, only refers to a snap.
fn is_debian() -> bool {
    std::fs::read_to_string("/etc/os-release").is_ok_and(|text| text.lines().any(|line| line == "ID=debian"))
}
