//! Reserves WebAssembly memory ahead of need.
//!
//! A browser counts the memory of a module as memory of its garbage collector: beyond about 64 MB it collects
//! garbage at each growth, and the allocator grows the memory by 64 kB at a time. A long program would spend
//! most of its time on that.

#[cfg(target_arch = "wasm32")]
pub use wasm::{reserve, reserve_ahead};

/// Does nothing: an operating system provides memory in small pieces at no cost.
#[cfg(not(target_arch = "wasm32"))]
pub fn reserve_ahead() {}

/// Does nothing, like [`reserve_ahead`].
#[cfg(not(target_arch = "wasm32"))]
pub fn reserve(_bytes: usize) {}

#[cfg(target_arch = "wasm32")]
mod wasm {
    use std::arch::wasm32::memory_size;
    use std::hint::black_box;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Size of a page of WebAssembly memory, bytes.
    const PAGE: usize = 1 << 16;

    /// The memory grows by at least 1/`SHARE` of its size.
    const SHARE: usize = 8;

    /// Grows the memory by 1/`SHARE` of its size if it has grown since the last call.
    pub fn reserve_ahead() {
        static SEEN: AtomicUsize = AtomicUsize::new(0);
        let pages = memory_size::<0>();
        if pages <= SEEN.load(Ordering::Relaxed) {
            return;
        }
        reserve(pages / SHARE * PAGE);
        SEEN.store(memory_size::<0>(), Ordering::Relaxed);
    }

    /// Grows the memory in one step by `bytes` that will be needed soon, unless they are free already.
    pub fn reserve(bytes: usize) {
        let mut reserve: Vec<u8> = Vec::new();
        // The allocator keeps the memory after the drop. On failure, ignore the error: the program itself may
        // still fit.
        let _ = reserve.try_reserve_exact(bytes);
        drop(black_box(reserve));
    }
}
