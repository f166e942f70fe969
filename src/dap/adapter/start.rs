//! Requests about the session as a whole.

use super::reply::{DebugAnswer, Reply};
use super::session::DebugSession;
use super::{Adapter, read};
use crate::arguments::{DebugArguments, Launch, Reload, SetBreakpoints};
use crate::debuggee::{Debuggee, front};
use serde_json::{Value, json};

/// The faults that a client can choose to stop at: filter, label, and whether it is on by default.
pub const FILTERS: [(&str, &str, bool); 7] = [
    ("nan", "NaN is computed", false),
    ("infinite", "An infinity is computed", false),
    ("division", "Division by zero", false),
    ("index", "Index out of range", true),
    ("undefined", "Undefined result", false),
    ("uninitialized", "An uninitialised variable is read", false),
    ("exhausted", "A loop runs out of iterations", false),
];

/// What the adapter can do, apart from its filters.
const CAPABILITIES: &str = include_str!("capabilities.json");

impl Adapter<'_> {
    pub(super) fn initialize(&mut self, arguments: &Value) -> DebugAnswer {
        let starts = |name: &str| {
            let is_one = arguments.get(name).and_then(Value::as_bool);
            u32::from(is_one.unwrap_or(true))
        };
        self.client.first_line = starts("linesStartAt1");
        self.client.first_column = starts("columnsStartAt1");
        let progress = arguments.get("supportsProgressReporting");
        self.client.shows_progress = progress.and_then(Value::as_bool).unwrap_or(false);
        let filters = FILTERS.map(|(filter, label, is_default)| {
            json!({ "filter": filter, "label": label, "default": is_default })
        });
        let mut body: Value = serde_json::from_str(CAPABILITIES).unwrap_or_default();
        if let Some(fields) = body.as_object_mut() {
            fields.insert("exceptionBreakpointFilters".to_string(), json!(filters));
        }
        Ok(Reply {
            body,
            events: vec![("initialized", Value::Null)],
        })
    }

    pub(super) fn launch(&mut self, arguments: &Value) -> DebugAnswer {
        let launch: Launch = read(arguments)?;
        let session = self.start(launch)?;
        let notes = session.notes();
        self.session = Some(session);
        let mut events = notes;
        if self.client.is_configured {
            events.extend(self.first_stop());
        }
        Ok(Reply::events(events))
    }

    /// Loads a program, with the breakpoints that the client has set.
    fn start(&self, launch: Launch) -> Result<DebugSession, String> {
        if launch.program.is_empty() {
            return Err("`program` is missing: the shader, export or folder of passes".to_string());
        }
        let pixel = launch.pixel(&front(self.programs))?;
        let loaded = self.programs.load(&launch)?;
        let debuggee = Debuggee::start(loaded, &launch, self.programs)?;
        let mut session = DebugSession::of(debuggee, (launch, pixel), self.programs)?;
        session.first_line = self.client.first_line;
        for set in &self.client.breakpoints {
            session.set(&self.client, self.programs, set);
        }
        session.filters.clone_from(&self.client.filters);
        Ok(session)
    }

    pub(super) fn configured(&mut self) -> DebugAnswer {
        self.client.is_configured = true;
        let events = self.first_stop();
        Ok(Reply::events(events))
    }

    /// Stops at the entry, or runs to the first breakpoint.
    fn first_stop(&mut self) -> Vec<super::reply::DebugEvent> {
        let Some(session) = &mut self.session else {
            return Vec::new();
        };
        if session.launch.stop_on_entry.unwrap_or(true) {
            return vec![session.stopped("entry", None)];
        }
        match session.resume(&DebugArguments::default()) {
            Ok(reply) => reply.events,
            Err(message) => vec![super::reply::output("stderr", &message)],
        }
    }

    pub(super) fn set_breakpoints(&mut self, set: SetBreakpoints) -> DebugAnswer {
        self.client
            .breakpoints
            .retain(|known| known.source != set.source);
        let body = match &mut self.session {
            Some(session) => session.set(&self.client, self.programs, &set),
            // Verified when the program is known.
            None => {
                let lines = set.breakpoints.iter().map(|given| given.line);
                lines
                    .map(|line| json!({ "verified": false, "line": line }))
                    .collect()
            }
        };
        self.client.breakpoints.push(set);
        Ok(Reply::with(json!({ "breakpoints": body })))
    }

    pub(super) fn set_filters(&mut self, filters: Vec<String>) -> DebugAnswer {
        if let Some(session) = &mut self.session {
            session.filters.clone_from(&filters);
        }
        self.client.filters = filters;
        Ok(Reply::with(Value::Null))
    }

    /// Reads the program again, and goes to the same execution of the same line.
    pub(super) fn reload(&mut self, arguments: &Value) -> DebugAnswer {
        let old = self.session.as_mut().ok_or("no program is running")?;
        let mark = old.mark();
        let launch = match arguments.get("arguments") {
            Some(changed) => read(changed)?,
            None => {
                let changed: Reload = read(arguments)?;
                let mut launch = old.launch.clone();
                launch.text = changed.text.or(launch.text);
                launch.passes = changed.passes.unwrap_or(launch.passes);
                let channels = launch.input.channels;
                launch.input.channels = changed.channels.unwrap_or(channels);
                launch
            }
        };
        let mut session = self.start(launch)?;
        session.go_to_mark(&mark);
        let events = vec![session.stopped("goto", Some("the program was read again"))];
        self.session = Some(session);
        Ok(Reply::events(events))
    }

    /// Goes to another pixel, time, frame or pass.
    pub(super) fn moved(&mut self, asked: &DebugArguments) -> DebugAnswer {
        let old = self.session.as_mut().ok_or("no program is running")?;
        let mark = old.mark();
        let mut launch = old.launch.clone();
        let request = &mut launch.request;
        request.pixel = asked.pixel.or(request.pixel);
        if asked.time.is_some() || asked.frame.is_some() {
            (request.time, request.frame) = (asked.time, asked.frame);
        }
        if asked.pass.is_some() {
            request.pass.clone_from(&asked.pass);
        }
        let is_same_frame = asked.time.is_none() && asked.frame.is_none() && asked.pass.is_none();
        let event = match is_same_frame {
            true => {
                old.show_pixel(launch.pixel(&front(self.programs))?)?;
                old.go_to_mark(&mark);
                old.stopped("goto", Some("at another pixel"))
            }
            false => {
                let mut session = self.start(launch)?;
                session.go_to_mark(&mark);
                let event = session.stopped("goto", Some("in another frame or pass"));
                self.session = Some(session);
                event
            }
        };
        Ok(Reply::events(vec![event]))
    }

    pub(super) fn image(&mut self, asked: &DebugArguments) -> DebugAnswer {
        let threads = self.programs.threads();
        let session = self.session.as_mut().ok_or("no program is running")?;
        session.image(asked, threads)
    }

    pub(super) fn end(&mut self, command: &str) -> Reply {
        self.session = None;
        self.is_done = command == "disconnect";
        Reply::events(vec![("terminated", Value::Null)])
    }
}
