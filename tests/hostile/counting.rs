//! Counts the allocations of a thread: a measure of work that is the same on every machine and in
//! every run.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The system's allocator with counters.
pub struct Counting;

/// Allocations of a thread.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Asked {
    /// Number of allocations.
    pub times: u64,
    /// Total number of allocated bytes, freed or not.
    pub bytes: u64,
}

thread_local! {
    static ASKED: Cell<Asked> = const { Cell::new(Asked { times: 0, bytes: 0 }) };
}

fn count(bytes: usize) {
    // Neither can fail nor allocate: the cell is const-initialised and has no destructor.
    ASKED.with(|asked| {
        let Asked { times, bytes: sum } = asked.get();
        asked.set(Asked {
            times: times + 1,
            bytes: sum + bytes as u64,
        });
    });
}

// SAFETY: All methods forward to the system's allocator; counting does not touch allocated memory.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: Guaranteed by the caller.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: Guaranteed by the caller.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size);
        // SAFETY: Guaranteed by the caller.
        unsafe { System.realloc(pointer, layout, size) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: Guaranteed by the caller.
        unsafe { System.dealloc(pointer, layout) }
    }
}

/// Runs a closure; returns the allocations of this thread during the run and the result.
pub fn asked<T>(work: impl FnOnce() -> T) -> (Asked, T) {
    let before = ASKED.get();
    let done = work();
    let now = ASKED.get();
    let asked = Asked {
        times: now.times - before.times,
        bytes: now.bytes - before.bytes,
    };
    (asked, done)
}
