//! Counts what a thread asks the allocator for: a measure of work that is the same on every machine and
//! in every run.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The system's allocator, which counts.
pub struct Counting;

/// What a thread has asked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Asked {
    /// How often.
    pub times: u64,
    /// How many bytes in all, whether they were given back or not.
    pub bytes: u64,
}

thread_local! {
    static ASKED: Cell<Asked> = const { Cell::new(Asked { times: 0, bytes: 0 }) };
}

fn count(bytes: usize) {
    // Neither can fail nor allocate: the cell is constant and has nothing to drop.
    ASKED.with(|asked| {
        let Asked { times, bytes: sum } = asked.get();
        asked.set(Asked {
            times: times + 1,
            bytes: sum + bytes as u64,
        });
    });
}

// SAFETY: All of it is the system's allocator; counting touches no memory that is allocated.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: As promised by the caller.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: As promised by the caller.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size);
        // SAFETY: As promised by the caller.
        unsafe { System.realloc(pointer, layout, size) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: As promised by the caller.
        unsafe { System.dealloc(pointer, layout) }
    }
}

/// What this thread asks for while something is done, and what comes of it.
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
