//! The parts of the module: what every first picture needs, what some programs need before it, and the rest.
//!
//! In: functions inside of [`early`] or [`late`]. Out: in the module of the page their code, with the code
//! and data that only they use, is in a separate file: `cargo xtask` cuts the linked module there
//! (`xtask/src/parts.rs`), so there is one source, one memory and one state. Everywhere else (natively, under
//! wasm-pack, in tests) they are functions like any other.
//!
//! The caller of such a function makes sure that its part has been loaded: the worker of the page does, by
//! [`Part::is_loaded`] or by the order of its messages. Until then a call throws.

#[cfg(parts)]
use std::sync::atomic::AtomicPtr;
use std::sync::atomic::{AtomicU8, Ordering};

/// A part that is not loaded with the module, in the order in which they are loaded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Part {
    /// What some programs need before their first picture: a setup, macros, hole cycles, the Y axis, compensation of the
    /// nose radius, corners, misread blocks, other controls. A run that needs it and has not got it gives nothing, and
    /// begins again when it is loaded ([`Run::missing`](crate::run::Run::missing)).
    Early,
    /// The rest: material, collisions, lints, files, dialogs and tables. Loaded after [`Part::Early`].
    Late,
}

/// How many parts have been loaded.
static LOADED: AtomicU8 = AtomicU8::new(0);

impl Part {
    /// All parts.
    pub const ALL: [Self; 2] = [Self::Early, Self::Late];

    /// Its name in file names and in the page.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Early => "early",
            Self::Late => "late",
        }
    }

    /// Whether its functions can be called.
    pub fn is_loaded(self) -> bool {
        cfg!(not(parts)) || LOADED.load(Ordering::Relaxed) > self as u8
    }

    /// Marks it and the parts before it as loaded.
    pub fn loaded(self) {
        LOADED.fetch_max(self as u8 + 1, Ordering::Relaxed);
    }
}

/// Ends a call of a function whose part has not been loaded, or of a language without its texts.
#[cfg(parts)]
#[cold]
pub(crate) fn missing(part: &str) -> ! {
    wasm_bindgen::throw_val(js_sys::Error::new(part).into())
}

/// The functions of a file that are in a part, once it has been loaded.
#[cfg(parts)]
pub(crate) struct Slot<T: 'static>(AtomicPtr<T>);

#[cfg(parts)]
impl<T> Slot<T> {
    pub(crate) const fn new() -> Self {
        Self(AtomicPtr::new(std::ptr::null_mut()))
    }

    pub(crate) fn fill(&self, functions: &'static T) {
        // Hidden from the optimiser: if it knew the functions, it would call them directly, and they would be in the core.
        let functions = std::hint::black_box(functions);
        self.0.store(std::ptr::from_ref(functions).cast_mut(), Ordering::Relaxed);
    }

    #[allow(unsafe_code)]
    pub(crate) fn functions(&self, part: Part) -> &'static T {
        // SAFETY: `fill` is the only one that writes, and writes a reference that is valid for ever.
        unsafe { self.0.load(Ordering::Relaxed).as_ref() }.unwrap_or_else(|| missing(part.name()))
    }
}

/// Puts functions into the part [`Part::Early`]; see [`in_part`].
macro_rules! early {
    ($($functions:tt)+) => { crate::parts::in_part! { Early $($functions)+ } };
}
pub(crate) use early;

/// Puts functions into the part [`Part::Late`]; see [`in_part`].
macro_rules! late {
    ($($functions:tt)+) => { crate::parts::in_part! { Late $($functions)+ } };
}
pub(crate) use late;

/// Puts the functions of a file into a part, once in a file. In the module of the page they are called through a table, which
/// `install` fills in: nothing but [`entry`] refers to them.
macro_rules! in_part {
    ($part:ident $(
       $(#[$attribute:meta])*
       $visibility:vis fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)? $body:block)+) => {
        $(
            $(#[$attribute])*
            #[allow(clippy::too_many_arguments)]
            #[cfg(not(parts))]
            $visibility fn $name($($argument: $type),*) $(-> $result)? $body

            $(#[$attribute])*
            #[allow(clippy::too_many_arguments)]
            #[cfg(parts)]
            $visibility fn $name($($argument: $type),*) $(-> $result)? {
                (FUNCTIONS.functions(crate::parts::Part::$part).$name)($($argument),*)
            }
        )+

        #[cfg(parts)]
        #[allow(clippy::type_complexity)]
        struct Functions {
            $($name: fn($($type),*) $(-> $result)?,)+
        }

        #[cfg(parts)]
        static FUNCTIONS: crate::parts::Slot<Functions> = crate::parts::Slot::new();

        #[cfg(parts)]
        pub(crate) fn install() {
            $(
                #[allow(clippy::too_many_arguments)]
                fn $name($($argument: $type),*) $(-> $result)? $body
            )+
            FUNCTIONS.fill(&Functions { $($name),+ });
        }
    };
}
pub(crate) use in_part;

/// The function that installs a part, in the part itself: `entry! { Early install_early { … } }`. wasm-split cuts the module
/// here; it finds an entry by these names.
#[cfg(parts)]
macro_rules! entry {
    ($part:ident $name:ident $body:block) => {
        #[allow(unsafe_code)]
        fn $name() {
            #[link(wasm_import_module = "parts")]
            unsafe extern "C" {
                #[link_name = concat!("__wasm_split_00", stringify!($part), "00_import_00000000000000000000000000000000")]
                fn import();
            }
            #[unsafe(export_name = concat!("__wasm_split_00", stringify!($part), "00_export_00000000000000000000000000000000"))]
            extern "C" fn body() $body

            // SAFETY: what is imported is `body`, which has the same signature.
            unsafe { import() }
        }
    };
}
#[cfg(parts)]
pub(crate) use entry;
