//! shaderlint and shaderport as a WebAssembly module without imports.
//!
//! The host writes a [`ModuleRequest`] as JSON into the memory that [`request`] returns, calls [`answer`],
//! and reads as many bytes as [`length`] says: `{"result": ...}` or `{"error": "message"}`.
//! `js/index.js` does that. A panic ends the instance; the host then starts another one.
#![cfg_attr(test, allow(clippy::string_slice))]

#[cfg(feature = "port")]
mod debug;
mod files;
mod instance;
#[cfg(feature = "port")]
mod port;
#[cfg(feature = "port")]
mod project;
mod requests;
mod result;
#[cfg(feature = "port")]
mod run;
mod server;
mod workspace;

pub use instance::Instance;
pub use requests::ModuleRequest;

use std::cell::RefCell;

/// An instance, and the memory that messages pass through.
#[derive(Default)]
struct Memory {
    instance: Instance,
    message: Vec<u8>,
}

thread_local! {
    static MEMORY: RefCell<Memory> = RefCell::default();
}

/// Makes room for a request of `length` bytes. Returns where it has to be written.
#[expect(unsafe_code, reason = "the host finds the function by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn request(length: usize) -> *mut u8 {
    MEMORY.with_borrow_mut(|memory| {
        memory.message.clear();
        memory.message.resize(length, 0);
        memory.message.as_mut_ptr()
    })
}

/// Answers the request. Returns where the answer is.
#[expect(unsafe_code, reason = "the host finds the function by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    MEMORY.with_borrow_mut(|memory| {
        memory.message = memory.instance.answer(&memory.message);
        memory.message.as_ptr()
    })
}

/// The length of the answer in bytes.
#[expect(unsafe_code, reason = "the host finds the function by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn length() -> usize {
    MEMORY.with_borrow(|memory| memory.message.len())
}
