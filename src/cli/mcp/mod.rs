//! `shaderlint mcp`: the commands as tools for programs, in the Model Context Protocol over standard
//! input and output.
//!
//! A tool runs a command of this program in a process of its own. So an answer is the command line's,
//! a failure costs one call alone, and a call that takes too long or is cancelled can be ended.

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
/// Where standard input or output fails, or does not begin as the protocol has it.
pub fn serve() -> io::Result<()> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    let served = runtime.block_on(async {
        let running = match ToolServer::new()?.serve(stdio_pipes()).await {
            Ok(running) => running,
            // Somebody who only looked whether there is a server.
            Err(ServerInitializeError::ConnectionClosed(_)) => return Ok(()),
            Err(error) => return Err(io::Error::other(error)),
        };
        running.waiting().await.map_err(io::Error::other)?;
        Ok(())
    });
    // A read of standard input that nobody waits for must not keep the process.
    runtime.shutdown_background();
    served
}
