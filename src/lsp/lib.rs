//! The language server without files, threads, clocks or transport: messages in, messages out.
//!
//! [`Session`] keeps the documents. Documents are immutable: each request is answered by a
//! [`Snapshot`] of all documents at the time of its arrival, on whatever thread. The front end
//! provides the other files and their options as a [`Workspace`], and decides when shaders are run.
#![cfg_attr(test, allow(clippy::string_slice))]

mod answers;
mod buffers;
mod capabilities;
mod client;
mod configs;
mod diagnostics;
mod new_file;
mod pending_request;
mod position;
#[cfg(feature = "preview")]
mod preview;
mod run;
mod session;
mod snapshot;
mod uri;
mod workspace;

pub use answers::{Lane, name_uses};
pub use buffers::TextBuffer;
pub use pending_request::PendingRequest;
pub use run::run_buffer;
pub use session::{Session, initialized};
pub use snapshot::Snapshot;
pub use uri::{path_of, uri_of};
pub use workspace::{SampleRuns, Workspace, WorkspaceConfigs};
