//! `shaderlint lsp`: a language server over standard input and output.
//!
//! The loop reads what the client says and answers what is quick. What may take longer has a thread,
//! and shaders are run on another, after a pause. Texts are never changed: each request is answered
//! by the state of all texts at the time at which it came.

mod answers;
mod buffers;
mod capabilities;
mod client;
mod diagnostics;
mod pages;
mod position;
mod preview;
mod server;
mod snapshot;
mod uri;
mod workers;

use lsp_server::Connection;
use std::io;

/// Serves a client until it says that it is done. Whether it said so before it went.
///
/// # Errors
/// Where standard input or output fails.
pub fn serve() -> io::Result<bool> {
    let (connection, threads) = Connection::stdio();
    let done = server::serve(connection).unwrap_or(false);
    threads.join()?;
    Ok(done)
}
