//! A progress line on the terminal.

use std::io::{self, IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Delay before the line appears.
const PATIENCE: Duration = Duration::from_secs(1);
/// Interval between updates.
const PAUSE: Duration = Duration::from_millis(100);
/// Width of the bar in characters.
const WIDTH: u32 = 24;

/// A progress line, removed on drop.
pub struct Progress {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

struct Shared {
    done: AtomicU32,
    /// The current frame, and the last frame of the image.
    frames: [AtomicU32; 2],
    is_over: AtomicBool,
}

impl Progress {
    /// Shows how many of `total` images are drawn, if standard error is a terminal.
    pub fn new(total: u32) -> Progress {
        let is_shown = io::stderr().is_terminal();
        let shared = Arc::new(Shared {
            done: AtomicU32::new(0),
            frames: [AtomicU32::new(0), AtomicU32::new(0)],
            is_over: AtomicBool::new(false),
        });
        let own = shared.clone();
        Progress {
            shared,
            thread: is_shown.then(|| thread::spawn(move || show(&own, total))),
        }
    }

    /// Sets the current frame of those that an image depends on.
    pub fn frame(&self, frame: u32, last: u32) {
        let [own_frame, own_last] = &self.shared.frames;
        own_frame.store(frame, Ordering::Relaxed);
        own_last.store(last, Ordering::Relaxed);
    }

    /// Sets the number of images that are drawn.
    pub fn drew(&self, count: u32) {
        self.shared.done.store(count, Ordering::Relaxed);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.shared.is_over.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            // A panic of the thread has no consequences.
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
            let frames = shared.frames.each_ref().map(|n| n.load(Ordering::Relaxed));
            let done = shared.done.load(Ordering::Relaxed);
            let line = line([done, total], frames, start.elapsed());
            let _ = write!(io::stderr(), "\r{line}\x1b[K");
        }
    }
    if is_shown {
        let _ = write!(io::stderr(), "\r\x1b[K");
    }
}

/// The text of the line.
fn line([done, total]: [u32; 2], frames: [u32; 2], elapsed: Duration) -> String {
    let seconds = elapsed.as_secs();
    let (done, total, noun) = match (total, frames) {
        (0 | 1, [_, 0]) => return format!("drawing, {seconds} s"),
        (0 | 1, [frame, last]) => (frame, last, "frame "),
        _ => (done, total, ""),
    };
    let full = WIDTH * done.min(total) / total;
    let bar: String = (0..WIDTH)
        .map(|i| if i < full { '#' } else { '.' })
        .collect();
    format!("drawing [{bar}] {noun}{done} of {total}, {seconds} s")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_progress_line_shows_the_completed_share() {
        let second = Duration::from_secs(2);
        assert_eq!(line([0, 1], [0, 0], second), "drawing, 2 s");
        assert_eq!(
            line([3, 9], [0, 0], second),
            "drawing [########................] 3 of 9, 2 s"
        );
        assert_eq!(
            line([0, 1], [30, 60], second),
            "drawing [############............] frame 30 of 60, 2 s"
        );
    }
}
