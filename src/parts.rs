//! The parts of the module: what every first picture needs, and what a page loads after it, or when a program
//! has something to do with it.
//!
//! In: functions that are marked with [`in_part`]. Out: in the module of the page their code, with all code
//! and data that nothing else needs, stands in a file of its own: `cargo xtask` cuts the linked module there
//! (`xtask/src/parts.rs`), so there is one source, one memory and one state, and nothing is there twice.
//! Everywhere else (natively, under wasm-pack, in tests) they are functions like any other.
//!
//! Who calls such a function makes sure that its part has been loaded: the worker of the page does, by
//! [`Part::is_loaded`] or by the order of its messages. Until then a call throws.

use std::sync::atomic::{AtomicU8, Ordering};

/// A part that is not loaded with the module.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Part {
    /// What a program is run under: a setup as JSON or in its comments. Where there is one, it is loaded before
    /// the run begins; elsewhere not at all.
    Setup,
    /// What happens at the machine: material, collisions, lints, files.
    Machine,
    /// What the reader asks for: setup form, pasting, rewriting, expanding, tables.
    Tools,
    /// Compensation of the tool nose radius, and corners between moves. Loaded as `Seldom` is.
    Path,
    /// What few programs use: macros, hole cycles, the Y axis; and what recognises other controls. A run that needs it and has not got it gives nothing, and is
    /// begun again when it is there ([`Run::missing`](crate::run::Run::missing)).
    Seldom,
    /// The sentences in English.
    English,
    /// The sentences in Chinese.
    Chinese,
    /// The sentences in Russian.
    Russian,
}

/// A bit for each part that has been loaded.
static LOADED: AtomicU8 = AtomicU8::new(0);

impl Part {
    /// All parts.
    pub const ALL: [Self; 8] = [
        Self::Setup,
        Self::Machine,
        Self::Tools,
        Self::Path,
        Self::Seldom,
        Self::English,
        Self::Chinese,
        Self::Russian,
    ];

    /// Its name in file names and in the page.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Setup => "setup",
            Self::Machine => "machine",
            Self::Tools => "tools",
            Self::Path => "path",
            Self::Seldom => "seldom",
            Self::English => "en",
            Self::Chinese => "zh",
            Self::Russian => "ru",
        }
    }

    /// Whether its functions can be called.
    pub fn is_loaded(self) -> bool {
        cfg!(not(parts)) || LOADED.load(Ordering::Relaxed) & (1 << self as u8) != 0
    }

    /// Its functions can be called from now on.
    pub fn loaded(self) {
        LOADED.fetch_or(1 << self as u8, Ordering::Relaxed);
    }
}

/// Ends a call of a function whose part has not been loaded.
#[cfg(parts)]
#[cold]
pub(crate) fn missing(part: Part) -> ! {
    wasm_bindgen::throw_val(js_sys::Error::new(part.name()).into())
}

/// Puts the code of functions into a part: `in_part! { Machine "0001" fn name(argument: Type) -> Type { … } }`.
/// The number, four hexadecimal digits, is another one for each function.
macro_rules! in_part {
    ($($part:ident $number:literal
       $(#[$attribute:meta])*
       $visibility:vis fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)? $body:block)+) => {$(
        $(#[$attribute])*
        #[allow(clippy::too_many_arguments)]
        #[cfg(not(parts))]
        $visibility fn $name($($argument: $type),*) $(-> $result)? $body

        $(#[$attribute])*
        #[allow(unsafe_code, clippy::too_many_arguments)]
        #[allow(improper_ctypes, improper_ctypes_definitions, reason = "both sides are this crate")]
        #[cfg(parts)]
        $visibility fn $name($($argument: $type),*) $(-> $result)? {
            #[link(wasm_import_module = "parts")]
            unsafe extern "C" {
                #[link_name = concat!("__wasm_split_00", stringify!($part), "00_import_0000000000000000000000000000", $number)]
                fn import($($argument: $type),*) $(-> $result)?;
            }
            #[unsafe(export_name = concat!("__wasm_split_00", stringify!($part), "00_export_0000000000000000000000000000", $number))]
            extern "C" fn body($($argument: $type),*) $(-> $result)? $body

            if !crate::parts::Part::$part.is_loaded() {
                crate::parts::missing(crate::parts::Part::$part);
            }
            // SAFETY: what is imported is `body`, which has the same signature: cutting the module joins
            // the two by their number, and fails where one of them is missing.
            unsafe { import($($argument),*) }
        }
    )+};
}
pub(crate) use in_part;
