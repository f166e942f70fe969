//! The debugger without files, threads or transport: messages of the Debug Adapter Protocol in,
//! messages out.
//!
//! An [`Adapter`] debugs one pixel of one frame. Nothing is recorded while it runs: a run has the same
//! bits every time, so an earlier moment is reached by running again ([`timeline`]). A moment is the
//! number of statements that a pixel has started. The four pixels of its quad are the threads.
//!
//! Expressions are evaluated by the compiler: a copy of the program stores the value of the expression
//! before the statement, and is run to the same moment ([`evaluate`]).

mod adapter;
mod arguments;
mod breakpoints;
mod debuggee;
mod evaluate;
mod files;
mod insertion;
mod pending;
mod places;
mod scopes;
mod stepping;
mod timeline;
mod uninitialized;
mod value;

pub use adapter::Adapter;
pub use arguments::Launch;
pub use debuggee::ProgramSource;
