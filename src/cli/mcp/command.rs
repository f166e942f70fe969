//! Runs a command of this program in its own process.

use crate::cli::global::given;
use crate::engine::config::ConfigSource;
use std::ffi::OsString;
use std::fmt::Display;
use std::io;
use std::path::PathBuf;
use std::process::Stdio;
use std::sync::Arc;
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWriteExt};
use tokio::process::{Child, Command};
use tokio::sync::{Semaphore, oneshot};

/// Time limit of a command, about as long as clients wait.
const TIME_LIMIT: Duration = Duration::from_secs(60);
/// Maximum number of bytes kept of each output; a folder may have any number of findings.
const MAX_OUTPUT: u64 = 4 << 20;
/// Maximum number of parallel commands, each of which uses several threads.
const MAX_RUNNING: usize = 2;

/// The path of this program, and a limit on parallel commands.
pub struct OwnProgram {
    path: PathBuf,
    permits: Arc<Semaphore>,
}

/// The result of a command.
#[derive(Debug)]
pub struct CommandOutcome {
    /// Exit code: 0 for success, 1 for findings, 2 for failure.
    pub code: i32,
    /// Contents of standard output.
    pub out: String,
    /// Contents of standard error.
    pub err: String,
}

impl CommandOutcome {
    /// Both outputs; a command that fails may use either.
    pub fn message(&self) -> String {
        format!("{}{}", self.out, self.err)
    }
}

impl OwnProgram {
    /// Determines the path of this program.
    ///
    /// # Errors
    /// If the operating system does not provide it.
    pub fn new() -> io::Result<OwnProgram> {
        Ok(OwnProgram {
            path: std::env::current_exe()?,
            permits: Arc::new(Semaphore::new(MAX_RUNNING)),
        })
    }

    /// Runs a command with a text as its standard input. The command is stopped if the caller stops
    /// waiting.
    ///
    /// # Errors
    /// A message if the command cannot be started, exceeds the time limit or is killed by a signal.
    pub async fn run(&self, args: Vec<OsString>, input: &str) -> Result<CommandOutcome, String> {
        let permit = self.permits.clone().acquire_owned().await;
        let config = match given().source() {
            ConfigSource::File(file) => vec!["--config".into(), file.into()],
            ConfigSource::Nowhere => vec!["--no-config".into()],
            ConfigSource::Nearest => Vec::<OsString>::new(),
        };
        let child = Command::new(&self.path)
            .args(config.into_iter().chain(args))
            // The client's environment may force colours.
            .env("NO_COLOR", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .kill_on_drop(true)
            .spawn()
            .map_err(not_run)?;
        let (caller, cancel) = oneshot::channel();
        let input = input.to_string();
        // In its own task, because a stopped process must be waited for as well.
        let task = tokio::spawn(async move {
            let _permit = permit;
            ended(child, input, cancel).await
        });
        let outcome = task.await.map_err(not_run)?;
        drop(caller);
        outcome
    }
}

fn not_run(error: impl Display) -> String {
    format!("cannot run the command: {error}")
}

/// Waits for a process, and kills it on timeout or cancellation.
async fn ended(
    mut child: Child,
    input: String,
    cancel: oneshot::Receiver<()>,
) -> Result<CommandOutcome, String> {
    let why = tokio::select! {
        outcome = outcome(&mut child, input) => return outcome.map_err(not_run),
        () = tokio::time::sleep(TIME_LIMIT) => format!(
            "the command was stopped after {} s; request less at a time",
            TIME_LIMIT.as_secs()
        ),
        _ = cancel => "cancelled".to_string(),
    };
    child.kill().await.map_err(not_run)?;
    Err(why)
}

async fn outcome(child: &mut Child, input: String) -> io::Result<CommandOutcome> {
    let pipes = (child.stdin.take(), child.stdout.take(), child.stderr.take());
    let (Some(mut stdin), Some(stdout), Some(stderr)) = pipes else {
        return Err(io::Error::other("the process has no pipes"));
    };
    let feed = async move {
        // A command that stops reading reports the reason itself.
        let _ = stdin.write_all(input.as_bytes()).await;
    };
    let ((), out, err, status) = tokio::join!(feed, kept(stdout), kept(stderr), child.wait());
    let status = status?;
    let Some(code) = status.code() else {
        return Err(io::Error::other(format!(
            "the process was terminated: {status}"
        )));
    };
    Ok(CommandOutcome {
        code,
        out: out?,
        err: err?,
    })
}

/// Reads an output to its end and keeps the first [`MAX_OUTPUT`] bytes.
async fn kept(mut output: impl AsyncRead + Unpin) -> io::Result<String> {
    let mut bytes = Vec::new();
    (&mut output)
        .take(MAX_OUTPUT)
        .read_to_end(&mut bytes)
        .await?;
    tokio::io::copy(&mut output, &mut tokio::io::sink()).await?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
