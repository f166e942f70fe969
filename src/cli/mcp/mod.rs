//! `shaderlint mcp`: a Model Context Protocol server over standard input and output.
//!
//! Each tool runs a command of this program in its own process, so answers match the command line,
//! a crash affects one call only, and calls can time out or be cancelled.

mod answer;
mod command;
mod input;
mod server;
mod tools;

use rmcp::ServiceExt;
use rmcp::service::ServerInitializeError;
use rmcp::transport::stdio_pipes;
use server::ToolServer;
use std::io;

/// Serves a client until it closes standard input.
///
/// # Errors
/// If standard input or output fails, or the handshake is invalid.
pub fn serve() -> io::Result<()> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    let served = runtime.block_on(async {
        let running = match ToolServer::new()?.serve(stdio_pipes()).await {
            Ok(running) => running,
            // The client closed the connection before the handshake.
            Err(ServerInitializeError::ConnectionClosed(_)) => return Ok(()),
            Err(error) => return Err(io::Error::other(error)),
        };
        running.waiting().await.map_err(io::Error::other)?;
        Ok(())
    });
    // A pending read of standard input must not keep the process alive.
    runtime.shutdown_background();
    served
}
