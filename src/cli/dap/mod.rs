//! `shaderlint dap`: a debugger over standard input and output.

use super::framing;
use super::image_file::decode;
use super::run::{Undrawable, read};
use crate::commands::run::{Loaded, position};
use crate::dap::{Adapter, Launch, ProgramSource};
use crate::diagnostic::Severity;
use crate::play::Decode;
use crate::project::Composed;
use crate::text::path::slashed;
use serde_json::Value;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::thread;
use std::time::Duration;

/// The time between attempts to do what can wait, while no message comes.
const PAUSE: Duration = Duration::from_millis(20);

/// Serves a client until it disconnects.
///
/// # Errors
/// If standard input holds no message, or standard output fails.
pub fn serve() -> io::Result<()> {
    let (sender, messages) = channel();
    let interrupt = Arc::<AtomicBool>::default();
    let arrived = interrupt.clone();
    thread::Builder::new()
        .name("input".to_string())
        .spawn(move || {
            let mut input = io::stdin().lock();
            loop {
                let body = framing::read_body(&mut input);
                let is_last = !matches!(body, Ok(Some(_)));
                if sender.send(body).is_err() || is_last {
                    return;
                }
                arrived.store(true, Ordering::Relaxed);
            }
        })?;
    let programs = DiskPrograms;
    let mut adapter = Adapter::new(&programs);
    while !adapter.is_done {
        let Some(body) = next(&messages, &mut adapter, &interrupt)? else {
            return Ok(());
        };
        let message: Value = serde_json::from_slice(&body)
            .map_err(|e| io::Error::new(io::ErrorKind::InvalidData, format!("not JSON: {e}")))?;
        write(adapter.handle(&message))?;
    }
    Ok(())
}

/// The next message. What can wait is done while there is none.
fn next(
    messages: &Receiver<io::Result<Option<Vec<u8>>>>,
    adapter: &mut Adapter<'_>,
    interrupt: &Arc<AtomicBool>,
) -> io::Result<Option<Vec<u8>>> {
    loop {
        interrupt.store(false, Ordering::Relaxed);
        match messages.try_recv() {
            Ok(body) => return body,
            Err(TryRecvError::Disconnected) => return Ok(None),
            Err(TryRecvError::Empty) => write(adapter.idle(interrupt))?,
        }
        // The message that has interrupted it may be one that was handled before.
        let is_done = !adapter.is_drawing() && !interrupt.load(Ordering::Relaxed);
        if is_done {
            return messages.recv().unwrap_or(Ok(None));
        }
        match messages.recv_timeout(PAUSE) {
            Ok(body) => return body,
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

fn write(messages: Vec<Value>) -> io::Result<()> {
    let mut output = io::stdout().lock();
    for message in messages {
        framing::write_body(&mut output, &message.to_string())?;
    }
    output.flush()
}

/// Programs on disk.
struct DiskPrograms;

impl ProgramSource for DiskPrograms {
    fn load(&self, launch: &Launch) -> Result<Loaded, String> {
        let path = Path::new(&launch.program);
        match read(path, launch.input.host.as_deref(), &launch.input.channels) {
            Ok(loaded) => Ok(loaded.shader),
            Err(Undrawable::Words(words)) => Err(words),
            Err(Undrawable::Errors(composed)) => Err(first_error(&composed)),
        }
    }

    fn decode(&self) -> Option<Decode> {
        Some(decode)
    }

    fn text(&self, path: &str) -> Option<String> {
        std::fs::read_to_string(path).ok()
    }

    fn threads(&self) -> usize {
        thread::available_parallelism().map_or(1, usize::from)
    }

    fn path(&self, path: &str) -> String {
        let known = Path::new(path).canonicalize();
        known.map_or_else(|_| slashed(path), slashed)
    }
}

/// The first error of a shader that cannot run.
fn first_error(composed: &Composed) -> String {
    let units = composed.units.iter().map(|unit| composed.analysis(unit));
    let mut found = units.flat_map(|checked| &checked.diagnostics);
    let error = found.find(|d| d.severity == Severity::Error);
    let message = error.map(|error| match position(&composed.sources, error.span) {
        Some(at) => format!("{at}: {}", error.message),
        None => error.message.clone(),
    });
    message.unwrap_or_else(|| "the shader has errors".to_string())
}
