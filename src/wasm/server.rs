//! The language server, one message after the other.

use super::result::RequestResult;
use super::workspace::OpenWorkspace;
use lsp_server::{ErrorCode, Message, Response};
use serde_json::Value;
use shaderlint_lsp::{Session, initialized, run_buffer};
use std::path::PathBuf;
use std::sync::Arc;

/// A language server that answers at once. Shaders are run when the host asks for it.
#[derive(Default)]
pub struct InstantServer {
    /// The conversation, after the request `initialize`.
    session: Option<Session>,
    /// Documents that changed since their shaders ran.
    changed: Vec<PathBuf>,
}

impl InstantServer {
    /// Handles a message of the client. The result lists the messages for the client.
    pub fn message(&mut self, message: Message) -> RequestResult {
        let Some(session) = &mut self.session else {
            return self.initialize(message);
        };
        match message {
            Message::Request(request) => {
                if let Some(work) = session.request(request) {
                    let (response, request) = work.answer(session.snapshot());
                    let mut messages = session.take_messages();
                    messages.push(response.into());
                    messages.extend(request);
                    return listed(&messages);
                }
            }
            Message::Notification(sent) if sent.method == "exit" => self.session = None,
            Message::Notification(sent) => session.notification(sent),
            Message::Response(response) => session.response(response),
        }
        self.messages()
    }

    fn initialize(&mut self, message: Message) -> RequestResult {
        let request = match message {
            Message::Request(request) => request,
            // Nothing can be known of documents before.
            Message::Notification(_) | Message::Response(_) => return listed(&[]),
        };
        let (id, params) = (request.id, request.params);
        let response = match request.method.as_str() {
            "initialize" => {
                let site = params.pointer("/initializationOptions/site");
                let site = site.and_then(Value::as_str).map(str::to_string);
                let workspace = |_: &[PathBuf]| Arc::new(OpenWorkspace::new(site)) as _;
                self.session = Some(Session::new(&params, workspace));
                Response::new_ok(id, initialized(&params))
            }
            _ => {
                let code = ErrorCode::ServerNotInitialized as i32;
                Response::new_err(id, code, "the server is not initialised".to_string())
            }
        };
        let mut messages = vec![Message::from(response)];
        messages.extend(self.session.iter_mut().flat_map(Session::take_messages));
        listed(&messages)
    }

    /// Runs the shaders of documents that changed. The result lists the messages for the client.
    pub fn run_changed(&mut self) -> RequestResult {
        let Some(session) = &mut self.session else {
            return listed(&[]);
        };
        for path in std::mem::take(&mut self.changed) {
            if let Some(buffer) = session.to_run(&path) {
                run_buffer(session.snapshot(), &buffer);
                session.ran(&path, buffer.state);
            }
        }
        self.messages()
    }

    /// The messages for the client, with the findings of changed documents.
    fn messages(&mut self) -> RequestResult {
        let Some(session) = &mut self.session else {
            return listed(&[]);
        };
        session.publish_findings();
        for path in session.take_changed() {
            if !self.changed.contains(&path) {
                self.changed.push(path);
            }
        }
        listed(&session.take_messages())
    }
}

fn listed(messages: &[Message]) -> RequestResult {
    let all = messages.iter().map(|message| {
        let mut value = serde_json::to_value(message).map_err(|e| e.to_string())?;
        if let Some(fields) = value.as_object_mut() {
            fields.insert("jsonrpc".to_string(), "2.0".into());
        }
        Ok(value)
    });
    all.collect::<Result<Vec<_>, String>>().map(Value::from)
}
