//! Heap reserved ahead of need, in a browser.
//!
//! A browser counts the memory of a module as its own garbage collector's: beyond some 64 MB it collects
//! at each growth, and the allocator grows the memory by 64 kB at a time. A long program would spend
//! most of its time on that.

#[cfg(target_arch = "wasm32")]
pub use wasm::{reserve, reserve_ahead};

/// Nothing: a system gives memory in small pieces at no cost.
#[cfg(not(target_arch = "wasm32"))]
pub fn reserve_ahead() {}

/// Nothing, as [`reserve_ahead`].
#[cfg(not(target_arch = "wasm32"))]
pub fn reserve(_bytes: usize) {}

#[cfg(target_arch = "wasm32")]
mod wasm {
    use std::arch::wasm32::memory_size;
    use std::hint::black_box;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Bytes of a page of wasm memory.
    const PAGE: usize = 1 << 16;

    /// The memory grows by at least one part in so many.
    const SHARE: usize = 8;

    /// Grows the memory by a good part of what there is, if it has grown since the last time.
    pub fn reserve_ahead() {
        static SEEN: AtomicUsize = AtomicUsize::new(0);
        let pages = memory_size::<0>();
        if pages <= SEEN.load(Ordering::Relaxed) {
            return;
        }
        reserve(pages / SHARE * PAGE);
        SEEN.store(memory_size::<0>(), Ordering::Relaxed);
    }

    /// Grows the memory at once by so many bytes that are about to be needed, if they are not there.
    pub fn reserve(bytes: usize) {
        let mut reserve: Vec<u8> = Vec::new();
        // What the allocator was given once, it keeps. Where there is no more, the
        // program itself may still fit.
        let _ = reserve.try_reserve_exact(bytes);
        drop(black_box(reserve));
    }
}
