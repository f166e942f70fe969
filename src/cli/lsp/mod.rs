//! `shaderlint lsp`: a language server over standard input and output.
//!
//! The main loop reads messages and handles quick requests. Slow requests run on a worker thread,
//! and sample runs on another one after a pause. Documents are immutable: each request uses a
//! snapshot of all documents at the time of its arrival.

mod pages;
mod parent;
mod references;
mod server;
mod transport;
mod workers;
mod workspace;

pub use references::{ReferencesArgs, references};

use std::io;

/// Serves a client until it exits. Returns whether it sent `shutdown` before.
///
/// # Errors
/// If standard input holds no message, or standard output fails.
pub fn serve() -> io::Result<bool> {
    let (connection, transport) = transport::stdio()?;
    let done = server::serve(connection).unwrap_or(false);
    transport.finish()?;
    Ok(done)
}
