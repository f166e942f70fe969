//! The results of requests, and what a client has announced.

use crate::arguments::SetBreakpoints;
use serde_json::{Value, json};

/// What a client announced about itself and about breakpoints; kept when the program is reloaded.
#[derive(Default)]
pub struct ClientState {
    /// 1 if the first line or column is 1.
    pub first_line: u32,
    pub first_column: u32,
    pub breakpoints: Vec<SetBreakpoints>,
    /// The filters of faults.
    pub filters: Vec<String>,
    pub is_configured: bool,
    pub shows_progress: bool,
}

/// What a request leads to: the body of its answer, and events.
pub struct Reply {
    pub body: Value,
    pub events: Vec<DebugEvent>,
}

/// An event: its name and body.
pub type DebugEvent = (&'static str, Value);

/// The answer to a request, or a message about what is wrong.
pub type DebugAnswer = Result<Reply, String>;

impl Reply {
    pub fn with(body: Value) -> Reply {
        Reply {
            body,
            events: Vec::new(),
        }
    }

    pub fn events(events: Vec<DebugEvent>) -> Reply {
        Reply {
            body: Value::Null,
            events,
        }
    }
}

/// An event with output.
pub fn output(category: &str, text: &str) -> DebugEvent {
    let body = json!({ "category": category, "output": format!("{text}\n") });
    ("output", body)
}
