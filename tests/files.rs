//! The command line loses no file when it writes one or fails to. `tests/npx/compare.rs` runs the same cases
//! under Node.
// The cases use `/dev/full`, `setpriv`, `unshare` and `mount`, which exist only on Linux.
#![cfg(target_os = "linux")]

#[path = "files/cases.rs"]
mod cases;

use std::panic::catch_unwind;
use std::path::Path;

use cases::{Bench, CASES};

#[test]
fn no_file_is_lost() {
    let program = Path::new(env!("CARGO_BIN_EXE_gcode-playground"));
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR")).join("files");
    let failed: Vec<_> = CASES
        .iter()
        .filter(|(name, case)| catch_unwind(|| case(&Bench::new(program, &scratch, name))).is_err())
        .map(|(name, _)| name)
        .collect();
    assert!(failed.is_empty(), "{failed:?}");
}
