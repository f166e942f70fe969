//! A command of this program, in a process of its own.

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

/// How long a command may take. Clients wait for about as long.
const TIME_LIMIT: Duration = Duration::from_secs(60);
/// Most bytes that are kept of each output: a folder may have any number of findings.
const MAX_OUTPUT: u64 = 4 << 20;
/// How many commands run at once. They have several threads themselves.
const MAX_RUNNING: usize = 2;

/// This program.
pub struct OwnProgram {
    path: PathBuf,
    turns: Arc<Semaphore>,
}

/// What came of a command.
#[derive(Debug)]
pub struct CommandOutcome {
    /// Its exit code: 0, or 1 where there is something to be mended, or 2 where it failed.
    pub code: i32,
    /// What it said on standard output.
    pub out: String,
    /// What it said on standard error.
    pub err: String,
}

impl CommandOutcome {
    /// All that it said: of a command that fails, some of it may stand on either output.
    pub fn said(&self) -> String {
        format!("{}{}", self.out, self.err)
    }
}

impl OwnProgram {
    /// This program.
    ///
    /// # Errors
    /// Where the system does not say what it is.
    pub fn new() -> io::Result<OwnProgram> {
        Ok(OwnProgram {
            path: std::env::current_exe()?,
            turns: Arc::new(Semaphore::new(MAX_RUNNING)),
        })
    }

    /// Runs a command, with a text as its standard input. It is ended when nobody waits for it any
    /// more.
    ///
    /// # Errors
    /// In words, where it cannot be started, does not end in time, or is ended by the system.
    pub async fn run(&self, args: Vec<OsString>, input: &str) -> Result<CommandOutcome, String> {
        let turn = self.turns.clone().acquire_owned().await;
        let child = Command::new(&self.path)
            .args(args)
            // Colours are for terminals, whatever the client's environment says.
            .env("NO_COLOR", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .kill_on_drop(true)
            .spawn()
            .map_err(not_run)?;
        let (caller, gone) = oneshot::channel();
        let input = input.to_string();
        // A task of its own, for a process that is ended has to be waited for too.
        let task = tokio::spawn(async move {
            let _turn = turn;
            ended(child, input, gone).await
        });
        let outcome = task.await.map_err(not_run)?;
        drop(caller);
        outcome
    }
}

fn not_run(error: impl Display) -> String {
    format!("the command cannot be run: {error}")
}

/// What came of a process, which has ended then, in one way or another.
async fn ended(
    mut child: Child,
    input: String,
    gone: oneshot::Receiver<()>,
) -> Result<CommandOutcome, String> {
    let why = tokio::select! {
        outcome = outcome(&mut child, input) => return outcome.map_err(not_run),
        () = tokio::time::sleep(TIME_LIMIT) => format!(
            "the command was ended after {} s; ask for less at a time",
            TIME_LIMIT.as_secs()
        ),
        _ = gone => "it was cancelled".to_string(),
    };
    child.kill().await.map_err(not_run)?;
    Err(why)
}

async fn outcome(child: &mut Child, input: String) -> io::Result<CommandOutcome> {
    let pipes = (child.stdin.take(), child.stdout.take(), child.stderr.take());
    let (Some(mut stdin), Some(stdout), Some(stderr)) = pipes else {
        return Err(io::Error::other("it has no pipes"));
    };
    let feed = async move {
        // A command that does not read all of it says why itself.
        let _ = stdin.write_all(input.as_bytes()).await;
    };
    let ((), out, err, status) = tokio::join!(feed, kept(stdout), kept(stderr), child.wait());
    let status = status?;
    let Some(code) = status.code() else {
        return Err(io::Error::other(format!("it ended by itself: {status}")));
    };
    Ok(CommandOutcome {
        code,
        out: out?,
        err: err?,
    })
}

/// The first [`MAX_OUTPUT`] bytes of an output, which is read to its end.
async fn kept(mut output: impl AsyncRead + Unpin) -> io::Result<String> {
    let mut bytes = Vec::new();
    (&mut output)
        .take(MAX_OUTPUT)
        .read_to_end(&mut bytes)
        .await?;
    tokio::io::copy(&mut output, &mut tokio::io::sink()).await?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
