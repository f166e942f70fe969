//! Threads for slow work: requests that read many files, and sample runs.

use super::super::parallel::STACK;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Sender, channel};
use std::thread;

/// A unit of work.
pub type Task = Box<dyn FnOnce() + Send>;

/// A thread that runs tasks one after another.
pub struct Worker {
    queue: Sender<Task>,
}

impl Worker {
    /// Starts a thread, which ends when the worker is dropped and no task is left.
    ///
    /// # Errors
    /// If the system cannot start a thread.
    pub fn start(name: &str) -> std::io::Result<Worker> {
        let (queue, work) = channel::<Task>();
        let builder = thread::Builder::new().name(name.to_string());
        builder.stack_size(STACK).spawn(move || {
            for work in work {
                // A panic loses the result of one task only.
                let _ = catch_unwind(AssertUnwindSafe(work));
            }
        })?;
        Ok(Worker { queue })
    }

    /// Queues a task.
    pub fn give(&self, work: impl FnOnce() + Send + 'static) {
        // The thread lives as long as its queue.
        let _ = self.queue.send(Box::new(work));
    }
}
