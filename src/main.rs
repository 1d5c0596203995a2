//! The command line: `check`, `motions` and `svg`.
//!
//! In: files and options. Out: text or JSON on standard output; exit status 0 without errors, 1 where the
//! program has errors, 2 for bad usage or a file that cannot be read. Knows no G-code.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    gcode_playground::cli::main()
}

#[cfg(target_arch = "wasm32")]
fn main() {}
