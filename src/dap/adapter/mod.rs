//! The requests of the Debug Adapter Protocol.
//!
//! <https://microsoft.github.io/debug-adapter-protocol/specification>. Requests that begin with
//! `shaderlint/` are additions, described in `docs/debugging.md`.

mod inspect;
mod motion;
mod reply;
mod session;
mod set;
mod sources;
mod start;

use super::arguments::DebugArguments;
use super::debuggee::ProgramSource;
use super::stepping::StepKind;
use reply::{ClientState, DebugAnswer, DebugEvent, Reply};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use session::DebugSession;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A debugger for one client.
pub struct Adapter<'p> {
    programs: &'p dyn ProgramSource,
    session: Option<DebugSession>,
    /// What the client asked before a program was launched.
    client: ClientState,
    /// The number of the last message.
    sequence: u64,
    /// Whether the client has disconnected.
    pub is_done: bool,
    /// The number of the progress that the client shows.
    progress: Option<u64>,
}

/// A request.
#[derive(Deserialize)]
struct DebugRequest {
    #[serde(default)]
    seq: u64,
    #[serde(default)]
    command: String,
    #[serde(default)]
    arguments: Value,
}

impl<'p> Adapter<'p> {
    /// An adapter that reads programs in this way.
    pub fn new(programs: &'p dyn ProgramSource) -> Adapter<'p> {
        Adapter {
            programs,
            session: None,
            client: ClientState {
                first_line: 1,
                first_column: 1,
                ..ClientState::default()
            },
            sequence: 0,
            is_done: false,
            progress: None,
        }
    }

    /// Whether another thread draws, so that [`Adapter::idle`] will have more to do.
    pub fn is_drawing(&self) -> bool {
        let session = self.session.as_ref();
        session.is_some_and(|session| session.debuggee.is_drawing())
    }

    /// Handles a message. Returns the messages for the client.
    pub fn handle(&mut self, message: &Value) -> Vec<Value> {
        let Ok(request) = DebugRequest::deserialize(message) else {
            return Vec::new();
        };
        if message.get("type").and_then(Value::as_str) != Some("request") {
            return Vec::new();
        }
        let answer = self.answer(&request);
        let (body, events, error) = match answer {
            Ok(reply) => (reply.body, reply.events, None),
            Err(message) => (Value::Null, self.still(&request.command), Some(message)),
        };
        let mut response = json!({
            "type": "response",
            "request_seq": request.seq,
            "command": request.command,
            "success": error.is_none(),
        });
        if let Some(fields) = response.as_object_mut() {
            if let Some(message) = error {
                let is_shown = is_asked_by_user(&request.command);
                let shown = json!({ "id": 1, "format": message, "showUser": is_shown });
                fields.insert("message".to_string(), message.into());
                fields.insert("body".to_string(), json!({ "error": shown }));
            } else if !body.is_null() {
                fields.insert("body".to_string(), body);
            }
        }
        let events = self.sent(events);
        let mut messages: Vec<Value> = std::iter::once(response).chain(events).collect();
        self.number(&mut messages);
        messages
    }

    /// Work that can wait until no message does, and ends soon after `interrupt` is set. Returns the messages
    /// for the client.
    pub fn idle(&mut self, interrupt: &Arc<AtomicBool>) -> Vec<Value> {
        let threads = self.programs.threads();
        let events = match &mut self.session {
            Some(session) if self.client.is_configured => session.count_hits((threads, interrupt)),
            _ => Vec::new(),
        };
        let mut messages = self.sent(events);
        self.number(&mut messages);
        messages
    }

    /// Events as messages, with that of a progress which begins or ends.
    fn sent(&mut self, mut events: Vec<DebugEvent>) -> Vec<Value> {
        let is_drawing = self.client.shows_progress && self.is_drawing();
        match self.progress {
            None if is_drawing => {
                self.progress = Some(self.sequence);
                let title = "Drawing the frames and passes before";
                let body = json!({ "progressId": self.sequence.to_string(), "title": title });
                events.push(("progressStart", body));
            }
            Some(id) if !is_drawing => {
                self.progress = None;
                events.push(("progressEnd", json!({ "progressId": id.to_string() })));
            }
            _ => {}
        }
        let events = events.into_iter();
        let messages =
            events.map(|(event, body)| json!({ "type": "event", "event": event, "body": body }));
        messages.collect()
    }

    /// After a step that failed: the program did not move. Some clients would otherwise assume that it
    /// runs, and send no further steps.
    fn still(&self, command: &str) -> Vec<DebugEvent> {
        let session = self.session.as_ref();
        let session = session.filter(|_| MOTIONS.contains(&command));
        session.map_or(Vec::new(), |session| vec![session.stopped("pause", None)])
    }

    fn number(&mut self, messages: &mut [Value]) {
        for message in messages {
            self.sequence += 1;
            if let Some(fields) = message.as_object_mut() {
                fields.insert("seq".to_string(), self.sequence.into());
            }
        }
    }

    fn answer(&mut self, request: &DebugRequest) -> DebugAnswer {
        match request.command.as_str() {
            "initialize" => return self.initialize(&request.arguments),
            "launch" => return self.launch(&request.arguments),
            "attach" => return Err("there is nothing to attach to; use `launch`".to_string()),
            "setBreakpoints" => return self.set_breakpoints(read(&request.arguments)?),
            "setExceptionBreakpoints" => {
                return self.set_filters(read::<DebugArguments>(&request.arguments)?.filters);
            }
            "setFunctionBreakpoints" => return Ok(Reply::with(json!({ "breakpoints": [] }))),
            "configurationDone" => return self.configured(),
            "restart" | "shaderlint/reload" => return self.reload(&request.arguments),
            "disconnect" | "terminate" => return Ok(self.end(&request.command)),
            _ => {}
        }
        let asked: DebugArguments = read(&request.arguments)?;
        match request.command.as_str() {
            "shaderlint/pixel" => return self.moved(&asked),
            "shaderlint/image" => return self.image(&asked),
            _ => {}
        }
        let session = self.session.as_mut().ok_or("no program is running")?;
        let client = &self.client;
        match request.command.as_str() {
            "threads" => Ok(session.threads()),
            "stackTrace" => session.stack(client, &asked),
            "scopes" => session.scopes(&asked),
            "variables" => session.variables(&asked),
            "evaluate" => session.evaluate(&asked),
            "source" => session.source(&asked),
            "loadedSources" => Ok(session.loaded_sources()),
            "breakpointLocations" => session.breakpoint_locations(client, self.programs, &asked),
            "exceptionInfo" => Ok(session.exception()),
            "dataBreakpointInfo" => Ok(session.data_breakpoint(&asked)),
            "setDataBreakpoints" => Ok(session.set_data_breakpoints(&asked)),
            "continue" => session.resume(&asked),
            "reverseContinue" => session.reverse(&asked),
            "next" => session.step(&asked, StepKind::Over),
            "stepIn" => session.step(&asked, StepKind::In),
            "stepOut" => session.step(&asked, StepKind::Out),
            "stepBack" if asked.granularity == "instruction" => {
                session.step(&asked, StepKind::BackIn)
            }
            "stepBack" => session.step(&asked, StepKind::Back),
            "shaderlint/stepBackIn" => session.step(&asked, StepKind::BackIn),
            "shaderlint/stepBackOut" => session.step(&asked, StepKind::BackOut),
            "shaderlint/nextIteration" => session.step(&asked, StepKind::NextIteration),
            "shaderlint/written" => session.written(&asked),
            "pause" => Ok(Reply::with(Value::Null)),
            other => Err(format!("unknown request `{other}`")),
        }
    }
}

/// Whether a client shows the error of a request in a message: not that of one that it sends unasked,
/// which a step may have outdated, nor of one whose errors it shows in place.
fn is_asked_by_user(command: &str) -> bool {
    matches!(command, "launch" | "attach" | "restart") || MOTIONS.contains(&command)
}

/// The motions of the protocol.
const MOTIONS: [&str; 6] = [
    "continue",
    "reverseContinue",
    "next",
    "stepIn",
    "stepOut",
    "stepBack",
];

/// Reads the arguments of a request.
fn read<T: DeserializeOwned + Default>(arguments: &Value) -> Result<T, String> {
    match arguments {
        Value::Null => Ok(T::default()),
        given => T::deserialize(given).map_err(|e| format!("wrong arguments: {e}")),
    }
}
