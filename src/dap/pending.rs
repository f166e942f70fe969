//! The images that a frame depends on, while they are drawn.
//!
//! The first statements of a pixel need none of them, so the debugger stops there at once and draws them
//! in another thread.

use shaderlint_commands::run::Shot;
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::DrawInputs;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

/// The inputs of a draw, with the shot whose code they are for.
pub type ShotInputs = (Box<Shot>, DrawInputs);

/// The inputs of a frame that are not complete yet. The drawing stops when this is dropped.
pub struct PendingInputs {
    drawing: Option<Drawing>,
    cancelled: Arc<AtomicBool>,
}

enum Drawing {
    Thread(JoinHandle<Result<ShotInputs, String>>),
    /// They are drawn on demand, where there are no threads.
    Later(Box<Shot>, Moment),
}

impl PendingInputs {
    /// Starts to draw what a frame depends on.
    ///
    /// # Errors
    /// There is no thread for it.
    pub fn start(mut shot: Box<Shot>, moment: &Moment) -> Result<PendingInputs, String> {
        let cancelled = Arc::<AtomicBool>::default();
        let moment = moment.clone();
        let drawing = match cfg!(target_family = "wasm") {
            true => Drawing::Later(shot, moment),
            false => {
                shot.stop_on(cancelled.clone());
                let builder = thread::Builder::new().name("frames".to_string());
                let thread = builder.spawn(move || drawn(shot, &moment));
                Drawing::Thread(thread.map_err(|e| format!("cannot draw: {e}"))?)
            }
        };
        Ok(PendingInputs {
            drawing: Some(drawing),
            cancelled,
        })
    }

    /// Whether a thread is still drawing.
    pub fn is_drawing(&self) -> bool {
        matches!(&self.drawing, Some(Drawing::Thread(thread)) if !thread.is_finished())
    }

    /// Waits for the complete inputs.
    ///
    /// # Errors
    /// A message about a run that was stopped.
    pub fn complete(mut self) -> Result<ShotInputs, String> {
        let failed = || "the frames before cannot be drawn".to_string();
        match self.drawing.take() {
            Some(Drawing::Thread(thread)) => thread.join().map_err(|_| failed())?,
            Some(Drawing::Later(shot, moment)) => drawn(shot, &moment),
            None => Err(failed()),
        }
    }
}

impl Drop for PendingInputs {
    fn drop(&mut self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }
}

fn drawn(mut shot: Box<Shot>, moment: &Moment) -> Result<ShotInputs, String> {
    let inputs = shot.prepared(moment, &mut |_| {})?;
    Ok((shot, inputs))
}
