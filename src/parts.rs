//! The parts of the wasm module: what every first picture needs, what some programs need before it, and the
//! rest.
//!
//! In: functions inside [`early`] or [`late`]. Out: in the module of the page their code, with the code and
//! data that only they use, is in a separate file. `cargo xtask` splits the linked module
//! (`xtask/src/parts.rs`), so there is one source, one memory and one state. In all other builds (native,
//! wasm-pack, tests) they are ordinary functions.
//!
//! The caller of such a function must make sure that its part has been loaded. The worker of the page uses
//! [`Part::is_loaded`] or the order of its messages for this. A call before that throws.

#[cfg(parts)]
use std::sync::atomic::AtomicPtr;
use std::sync::atomic::{AtomicU8, Ordering};

/// A part that is not in the initial module. The variants are in loading order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Part {
    /// Needed by some programs before their first picture: a setup, macros, hole cycles, the Y axis, tool
    /// nose radius compensation, corners, misread blocks, other controls. A run that needs it before it is
    /// loaded has no results, and restarts once it is loaded ([`Run::missing`](crate::run::Run::missing)).
    Early,
    /// The rest: material, collisions, lints, files, dialogs and tables. Loaded after [`Part::Early`].
    Late,
}

/// Number of loaded parts.
static LOADED: AtomicU8 = AtomicU8::new(0);

impl Part {
    /// All parts.
    pub const ALL: [Self; 2] = [Self::Early, Self::Late];

    /// The name in file names and in the page.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Early => "early",
            Self::Late => "late",
        }
    }

    /// Whether the functions of the part can be called.
    pub fn is_loaded(self) -> bool {
        cfg!(not(parts)) || LOADED.load(Ordering::Relaxed) > self as u8
    }

    /// Marks the part and those before it as loaded.
    pub fn loaded(self) {
        LOADED.fetch_max(self as u8 + 1, Ordering::Relaxed);
    }
}

/// Throws after a call of a function whose part has not been loaded, or a use of a language whose texts have
/// not been loaded.
#[cfg(parts)]
#[cold]
pub(crate) fn missing(part: &str) -> ! {
    wasm_bindgen::throw_val(js_sys::Error::new(part).into())
}

/// A slot for the functions of a file that belong to a part; filled once the part is loaded.
#[cfg(parts)]
pub(crate) struct Slot<T: 'static>(AtomicPtr<T>);

#[cfg(parts)]
impl<T> Slot<T> {
    pub(crate) const fn new() -> Self {
        Self(AtomicPtr::new(std::ptr::null_mut()))
    }

    pub(crate) fn fill(&self, functions: &'static T) {
        // Hidden from the optimiser, which would otherwise call the functions directly and so keep them in
        // the core module.
        let functions = std::hint::black_box(functions);
        self.0.store(std::ptr::from_ref(functions).cast_mut(), Ordering::Relaxed);
    }

    #[allow(unsafe_code)]
    pub(crate) fn functions(&self, part: Part) -> &'static T {
        // SAFETY: only `fill` writes to the slot, and it writes a reference with a static lifetime.
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

/// Puts the functions of a file into a part; use it at most once per file. In the module of the page they are
/// called through a table that `install` fills; only [`entry`] refers to them.
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

/// The function that installs a part, located in the part itself: `entry! { Early install_early { … } }`.
/// wasm-split splits the module here; it finds an entry by these names.
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

            // SAFETY: the imported function is `body`, which has the same signature.
            unsafe { import() }
        }
    };
}
#[cfg(parts)]
pub(crate) use entry;
