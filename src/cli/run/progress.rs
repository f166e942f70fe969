//! A line on the terminal while something takes long.

use std::io::{self, IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// How long nothing is said.
const PATIENCE: Duration = Duration::from_secs(1);
/// How often the line is written anew.
const PAUSE: Duration = Duration::from_millis(100);
/// How many characters the bar has.
const WIDTH: u32 = 24;

/// A line that goes away with this.
pub struct Progress {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

struct Shared {
    done: AtomicU32,
    is_over: AtomicBool,
}

impl Progress {
    /// Shows how many of some pictures are drawn, where standard error is a terminal.
    pub fn new(total: u32) -> Progress {
        let shared = Arc::new(Shared {
            done: AtomicU32::new(0),
            is_over: AtomicBool::new(false),
        });
        let own = shared.clone();
        let is_shown = io::stderr().is_terminal();
        Progress {
            shared,
            thread: is_shown.then(|| thread::spawn(move || show(&own, total))),
        }
    }

    /// Counts a picture.
    pub fn step(&self) {
        self.shared.done.fetch_add(1, Ordering::Relaxed);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.shared.is_over.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            // Whatever became of it, nothing depends on it.
            let _ = thread.join();
        }
    }
}

fn show(shared: &Shared, total: u32) {
    let start = Instant::now();
    let mut is_shown = false;
    while !shared.is_over.load(Ordering::Relaxed) {
        thread::park_timeout(PAUSE);
        if start.elapsed() >= PATIENCE && !shared.is_over.load(Ordering::Relaxed) {
            is_shown = true;
            let line = line(shared.done.load(Ordering::Relaxed), total, start.elapsed());
            let _ = write!(io::stderr(), "\r{line}\x1b[K");
        }
    }
    if is_shown {
        let _ = write!(io::stderr(), "\r\x1b[K");
    }
}

/// What is said after a time.
fn line(done: u32, total: u32, elapsed: Duration) -> String {
    let seconds = elapsed.as_secs();
    if total < 2 {
        return format!("drawing, {seconds} s");
    }
    let full = WIDTH * done.min(total) / total;
    let bar: String = (0..WIDTH)
        .map(|i| if i < full { '#' } else { '.' })
        .collect();
    format!("drawing [{bar}] {done} of {total}, {seconds} s")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_tells_how_far_it_is() {
        let second = Duration::from_secs(2);
        assert_eq!(line(0, 1, second), "drawing, 2 s");
        assert_eq!(
            line(3, 9, second),
            "drawing [########................] 3 of 9, 2 s"
        );
    }
}
