//! Messages over standard input and output.
//!
//! Invalid messages are answered with an error, as JSON-RPC 2.0 section 5.1 requires. After a
//! header that cannot be read, the start of the next message is unknown, and the connection ends.

use super::super::framing::{read_body, write_body};
use lsp_server::{Connection, ErrorCode, Message, Notification};
use serde_json::{Value, json};
use std::io::{self, BufRead, Write};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};

/// The notification after which nothing is written. No message of a server has this method.
const LAST: &str = "";

/// The threads that read and write.
pub struct Transport {
    writer: JoinHandle<io::Result<()>>,
    /// Ends the writer, also if other threads have messages left.
    last: Box<dyn FnOnce() + Send>,
    /// Why reading ended, unless the input did.
    broken: Arc<Mutex<Option<io::Error>>>,
}

/// Connects standard input and output.
///
/// # Errors
/// If the system cannot start a thread.
pub fn stdio() -> io::Result<(Connection, Transport)> {
    let (server, client) = Connection::memory();
    let Connection { sender, receiver } = client;
    let writer =
        thread::Builder::new()
            .name("writer".to_string())
            .spawn(move || -> io::Result<()> {
                let is_last =
                    |m: &Message| matches!(m, Message::Notification(n) if n.method == LAST);
                for message in receiver.iter().take_while(|m| !is_last(m)) {
                    message.write(&mut io::stdout().lock())?;
                }
                Ok(())
            })?;
    let broken: Arc<Mutex<Option<io::Error>>> = Arc::default();
    let failed = broken.clone();
    thread::Builder::new()
        .name("input".to_string())
        .spawn(move || {
            let mut input = io::stdin().lock();
            let done = read_all(&mut input, &mut io::stdout(), &mut |message| {
                let is_exit = matches!(&message, Message::Notification(n) if n.method == "exit");
                sender.send(message).is_ok() && !is_exit
            });
            if let (Err(error), Ok(mut broken)) = (done, failed.lock()) {
                *broken = Some(error);
            }
        })?;
    let out = server.sender.clone();
    let last = Box::new(move || {
        // A failure means that the writer has ended already.
        let _ = out.send(Notification::new(LAST.to_string(), Value::Null).into());
    });
    let transport = Transport {
        writer,
        last,
        broken,
    };
    Ok((server, transport))
}

impl Transport {
    /// Waits until everything is written that was sent so far.
    ///
    /// # Errors
    /// If standard input held no message, or standard output failed.
    pub fn finish(self) -> io::Result<()> {
        (self.last)();
        let written = self.writer.join();
        if let Some(error) = self.broken.lock().ok().and_then(|mut b| b.take()) {
            return Err(error);
        }
        written.unwrap_or(Ok(()))
    }
}

/// Reads messages until the input ends, or until `take` returns false.
fn read_all(
    input: &mut impl BufRead,
    output: &mut impl Write,
    take: &mut impl FnMut(Message) -> bool,
) -> io::Result<()> {
    loop {
        let body = match read_body(input) {
            Ok(Some(body)) => body,
            Ok(None) => return Ok(()),
            Err(error) => {
                answer(output, ErrorCode::ParseError, &error.to_string())?;
                return Err(error);
            }
        };
        match serde_json::from_slice(&body) {
            Ok(message) => {
                if !take(message) {
                    return Ok(());
                }
            }
            Err(error) if error.is_data() => {
                answer(
                    output,
                    ErrorCode::InvalidRequest,
                    "not a message of JSON-RPC 2.0",
                )?;
            }
            Err(error) => answer(output, ErrorCode::ParseError, &format!("not JSON: {error}"))?,
        }
    }
}

/// Answers input that has no id.
fn answer(output: &mut impl Write, code: ErrorCode, message: &str) -> io::Result<()> {
    let error = json!({ "code": code as i32, "message": message });
    let text = json!({ "jsonrpc": "2.0", "id": null, "error": error }).to_string();
    write_body(output, &text)?;
    output.flush()
}
