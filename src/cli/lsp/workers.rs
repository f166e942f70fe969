//! Threads for what may take long: requests that look at many files, and runs of shaders.

use super::super::parallel::STACK;
use super::buffers::{Ran, TextBuffer};
use super::snapshot::Snapshot;
use crate::ide::{Document, run};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::thread;

/// Something to be done.
pub type Task = Box<dyn FnOnce() + Send>;

/// A thread that does one thing after another.
pub struct Worker {
    queue: Sender<Task>,
}

impl Worker {
    /// Starts a thread. It ends when the worker is dropped and nothing is left to do.
    ///
    /// # Errors
    /// Where the system gives none.
    pub fn start(name: &str) -> std::io::Result<Worker> {
        let (queue, work) = channel::<Task>();
        let builder = thread::Builder::new().name(name.to_string());
        builder.stack_size(STACK).spawn(move || {
            for work in work {
                // A fault of this program costs one answer, never those behind it.
                let _ = catch_unwind(AssertUnwindSafe(work));
            }
        })?;
        Ok(Worker { queue })
    }

    /// Hands something to be done to the thread.
    pub fn give(&self, work: impl FnOnce() + Send + 'static) {
        // The thread lives as long as its queue.
        let _ = self.queue.send(Box::new(work));
    }
}

/// Runs the shaders of a text.
pub fn run_buffer(snapshot: &Snapshot, buffer: &Arc<TextBuffer>) {
    let options = snapshot.options(&snapshot.full, buffer);
    let text = buffer.text.clone();
    let document = Document::new(&buffer.path, text, options, &snapshot.files);
    let seen = document.report.analyses.iter().map(run).collect();
    let ran = Ran {
        document: Arc::new(document),
        seen,
    };
    // Nobody else runs this state.
    let _ = buffer.ran.set(ran);
}
