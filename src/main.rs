//! The command line, natively and as a module for Node.
//!
//! In: files and options. Out: text or JSON on standard output; exit status 0 without errors, 1 if a program
//! has errors, 2 for bad usage or a file that cannot be read or written. Contains no knowledge of G-code.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> gcode_playground::cli::Status {
    gcode_playground::cli::main()
}

#[cfg(all(target_arch = "wasm32", feature = "npx"))]
fn main() {
    gcode_playground::cli::main_in_node();
}

#[cfg(all(target_arch = "wasm32", not(feature = "npx")))]
fn main() {}
