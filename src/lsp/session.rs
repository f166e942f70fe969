//! The documents and the conversation with the client.

use super::answers::{Jobs, Lane, diagnostics_of};
use super::buffers::{OpenFiles, TextBuffer, changed};
use super::capabilities::{EXPLAIN, FIX_ALL, capabilities};
#[cfg(feature = "preview")]
use super::capabilities::{PREVIEW, WRITE_CHANNELS};
use super::client::{Client, UserSettings};
use super::configs::config_findings;
use super::pending_request::{PendingRequest, guarded};
#[cfg(feature = "preview")]
use super::preview;
use super::snapshot::{Answer, Failure, Snapshot};
use super::uri::path_of;
use super::workspace::Workspace;
use gen_lsp_types::*;
use lsp_server::{ErrorCode, Message, Notification as Sent, Request as Asked};
use lsp_server::{RequestId, Response};
use serde_json::{Value, json};
use shaderlint_engine::config::ConfigProblem;
use shaderlint_ide::Document;
use shaderlint_lint::Page;
use shaderlint_project::Files;
use shaderlint_rules::page;
use shaderlint_text::path::slashed;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Name of the configuration file.
const CONFIGURATION: &str = "shaderlint.toml";

/// A conversation with a client, from its first request to `exit`.
pub struct Session {
    jobs: Jobs,
    now: Snapshot,
    /// Messages for the client.
    outbox: Vec<Message>,
    /// Documents with findings to publish.
    unpublished: Vec<PathBuf>,
    /// Documents that changed since [`Session::take_changed`].
    changed: Vec<PathBuf>,
    /// Number of requests sent to the client.
    asked: u32,
    /// Whether the client sent `shutdown`.
    pub is_done: bool,
    /// The configurations with published findings.
    invalid: BTreeMap<PathBuf, ConfigProblem>,
    /// Whether configurations are to be looked at again.
    has_new_configs: bool,
}

/// The result of the request `initialize`.
pub fn initialized(params: &Value) -> Value {
    json!({
        "capabilities": capabilities(&Client::of(params)),
        "serverInfo": { "name": "shaderlint", "version": env!("CARGO_PKG_VERSION") },
    })
}

/// The workspace folders of a client.
fn folders(params: &Value) -> Vec<PathBuf> {
    let path = |uri: &Value| path_of(&Uri(uri.as_str()?.to_string()));
    match params.get("workspaceFolders").and_then(Value::as_array) {
        Some(all) => all
            .iter()
            .filter_map(|folder| path(folder.get("uri")?))
            .collect(),
        // Old clients send a single folder.
        None => params.get("rootUri").and_then(path).into_iter().collect(),
    }
}

impl Session {
    /// Starts after the answer to `initialize`. `workspace` gets the folders of the client.
    pub fn new(
        params: &Value,
        workspace: impl FnOnce(&[PathBuf]) -> Arc<dyn Workspace>,
    ) -> Session {
        let folders = folders(params);
        let now = Snapshot {
            client: Arc::new(Client::of(params)),
            settings: Arc::default(),
            files: OpenFiles {
                others: workspace(&folders),
                open: Arc::default(),
            },
            folders: Arc::new(folders),
            tokens: Arc::default(),
            state: 0,
            newest: Arc::new(AtomicU64::new(0)),
        };
        let mut session = Session {
            jobs: Jobs::new(),
            now,
            outbox: Vec::new(),
            unpublished: Vec::new(),
            changed: Vec::new(),
            asked: 0,
            is_done: false,
            invalid: BTreeMap::new(),
            has_new_configs: false,
        };
        session.greet(params.get("initializationOptions"));
        session
    }

    /// All documents as they are now.
    pub fn snapshot(&self) -> &Snapshot {
        &self.now
    }

    /// The messages for the client since the last call.
    pub fn take_messages(&mut self) -> Vec<Message> {
        std::mem::take(&mut self.outbox)
    }

    /// The documents that changed since the last call: their shaders may be run again.
    pub fn take_changed(&mut self) -> Vec<PathBuf> {
        std::mem::take(&mut self.changed)
    }

    /// Applies the initial settings, and requests the others from the client.
    fn greet(&mut self, options: Option<&Value>) {
        if let Some(options) = options {
            self.set(options);
        }
        if self.now.client.watches {
            let all = "**/*.{glsl,vert,frag,vs,fs,vsh,fsh,glslv,glslf,shadertoy,json}";
            let watchers = [all, "**/shaderlint.toml", "**/.editorconfig"];
            let watchers = watchers.map(|pattern| json!({ "globPattern": pattern }));
            let registration = json!({
                "id": "files",
                "method": "workspace/didChangeWatchedFiles",
                "registerOptions": { "watchers": watchers },
            });
            self.ask(
                "client/registerCapability",
                json!({ "registrations": [registration] }),
            );
        }
        self.ask_settings();
    }

    fn ask_settings(&mut self) {
        if self.now.client.configurations {
            let params = json!({ "items": [{ "section": "shaderlint" }] });
            self.ask("workspace/configuration", params);
        }
    }

    fn ask(&mut self, method: &str, params: Value) {
        self.asked += 1;
        // The id contains the method, so that the response can be matched without a table.
        let id = RequestId::from(format!("{method}#{}", self.asked));
        self.send(Asked::new(id, method.to_string(), params));
    }

    fn send(&mut self, message: impl Into<Message>) {
        self.outbox.push(message.into());
    }

    fn notify<N: Notification>(&mut self, params: &N::Params) {
        self.send(Sent::new(N::METHOD.to_string(), params));
    }

    /// Reads a request. Returns the work of answering it, unless it was answered at once.
    pub fn request(&mut self, request: Asked) -> Option<PendingRequest> {
        let Asked { id, method, params } = request;
        match method.as_str() {
            "shutdown" if !self.is_done => {
                self.is_done = true;
                self.send(Response::new_ok(id, Value::Null));
            }
            _ if self.is_done => {
                let code = ErrorCode::InvalidRequest as i32;
                self.send(Response::new_err(
                    id,
                    code,
                    "the server was shut down".into(),
                ));
            }
            "workspace/executeCommand" => return self.command(id, &params),
            method => match self.jobs.get(method) {
                Some((lane, job)) => {
                    return Some(PendingRequest::new(id, lane, move |snapshot| {
                        Ok((job(snapshot, params)?, None))
                    }));
                }
                None => {
                    let code = ErrorCode::MethodNotFound as i32;
                    let message = format!("method `{method}` is not supported");
                    self.send(Response::new_err(id, code, message));
                }
            },
        }
        None
    }

    /// Reads a notification.
    pub fn notification(&mut self, sent: Sent) {
        let Sent { method, params } = sent;
        match method.as_str() {
            "textDocument/didOpen" => self.with(params, Session::opened),
            "textDocument/didChange" => self.with(params, Session::changed),
            "textDocument/didClose" => self.with(params, Session::closed),
            "workspace/didChangeConfiguration" => self.with(params, Session::configured),
            "workspace/didChangeWatchedFiles" => self.with(params, Session::watched),
            "workspace/didChangeWorkspaceFolders" => self.with(params, Session::moved),
            // Unknown notifications are not errors.
            _ => {}
        }
    }

    fn with<P: serde::de::DeserializeOwned>(&mut self, params: Value, act: fn(&mut Session, P)) {
        match serde_json::from_value(params) {
            Ok(params) => act(self, params),
            Err(error) => self.log(&error.to_string()),
        }
    }

    fn log(&mut self, message: &str) {
        self.notify::<LogMessageNotification>(&LogMessageParams {
            kind: MessageType::Warning,
            message: message.to_string(),
        });
    }

    /// Reads the answer of the client to a request.
    pub fn response(&mut self, response: Response) {
        let is_settings = response.id.to_string().contains("workspace/configuration");
        let result = response.response_result.ok().filter(|_| is_settings);
        if let Some(own) = result.as_ref().and_then(|all| all.get(0)) {
            self.set(own);
        }
    }

    fn set(&mut self, value: &Value) {
        match UserSettings::read(value) {
            Ok(Some(settings)) if *self.now.settings != settings => {
                self.now.settings = Arc::new(settings);
                self.renew();
            }
            Ok(_) => {}
            Err(message) => self.notify::<ShowMessageNotification>(&ShowMessageParams {
                kind: MessageType::Warning,
                message,
            }),
        }
    }

    fn configured(&mut self, params: DidChangeConfigurationParams) {
        match params.settings {
            Value::Null => self.ask_settings(),
            settings => self.set(&settings),
        }
    }

    /// The number of the next state.
    fn next_state(&mut self) -> u64 {
        self.now.state += 1;
        self.now.newest.store(self.now.state, Ordering::Relaxed);
        self.now.state
    }

    fn put(&mut self, buffer: TextBuffer) {
        let path = PathBuf::from(&buffer.path);
        Arc::make_mut(&mut self.now.files.open).insert(path.clone(), Arc::new(buffer));
        self.publish_later(path.clone());
        self.renew_users(&path);
    }

    fn publish_later(&mut self, path: PathBuf) {
        self.changed.push(path.clone());
        if !self.unpublished.contains(&path) {
            self.unpublished.push(path);
        }
    }

    /// Analyses the open documents again that depend on a file.
    fn renew_users(&mut self, path: &Path) {
        let changed = slashed(path);
        // The dependencies of a document without analysis are unknown: the worker may be computing
        // them from the old files.
        let uses = |buffer: &TextBuffer| {
            let known = buffer.known();
            let is_made_of =
                |d: &Arc<Document>| d.report.sources.files().iter().any(|f| f.path == changed);
            buffer.path != changed && known.is_none_or(is_made_of)
        };
        let open = self.now.files.open.values();
        let users: Vec<Arc<TextBuffer>> = open.filter(|b| uses(b)).cloned().collect();
        for user in users {
            self.again(&user);
        }
    }

    /// Analyses an open document again that did not change itself.
    fn again(&mut self, buffer: &TextBuffer) {
        let state = self.next_state();
        let next = buffer.next(buffer.version, buffer.text.clone(), state);
        let path = PathBuf::from(&buffer.path);
        Arc::make_mut(&mut self.now.files.open).insert(path.clone(), Arc::new(next));
        self.publish_later(path);
    }

    /// Analyses all open documents again, with configurations that are read again.
    fn renew(&mut self) {
        self.now.files.others = self.now.files.others.renewed(&self.now.folders);
        self.has_new_configs = true;
        let all: Vec<Arc<TextBuffer>> = self.now.files.open.values().cloned().collect();
        for buffer in all {
            self.again(&buffer);
        }
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let item = params.text_document;
        let state = self.next_state();
        let language = item.language_id.to_string();
        let buffer = TextBuffer::new(item.uri, language, item.version, item.text, state);
        let path = PathBuf::from(&buffer.path);
        let is_new = self.now.files.entry(&path).is_none();
        self.has_new_configs = true;
        self.put(buffer);
        if is_new {
            self.renew_others(&path);
        }
    }

    /// Analyses the other open documents again, which may include a file that exists since now, or
    /// no longer does.
    fn renew_others(&mut self, path: &Path) {
        let open = self.now.files.open.iter();
        let others = open.filter(|(other, _)| *other != path);
        let others: Vec<Arc<TextBuffer>> = others.map(|(_, buffer)| buffer.clone()).collect();
        for buffer in others {
            self.again(&buffer);
        }
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let id = params.text_document;
        let Ok(buffer) = self.now.buffer(&id.text_document_identifier.uri).cloned() else {
            return self.log("received a change of a document that is not open");
        };
        let text = changed(&buffer.text, params.content_changes, self.now.columns());
        let state = self.next_state();
        self.put(buffer.next(id.version, text.into(), state));
    }

    fn closed(&mut self, params: DidCloseTextDocumentParams) {
        let uri = params.text_document.uri;
        let Ok(buffer) = self.now.buffer(&uri).cloned() else {
            return;
        };
        self.next_state();
        let path = PathBuf::from(&buffer.path);
        Arc::make_mut(&mut self.now.files.open).remove(&path);
        self.now.sent_tokens().remove(&buffer.path);
        self.unpublished.retain(|p| *p != path);
        if !self.now.client.pulls {
            self.notify::<PublishDiagnosticsNotification>(&PublishDiagnosticsParams {
                uri,
                version: None,
                diagnostics: Vec::new(),
            });
        }
        // From now on the file on disk counts, if there is one.
        match self.now.files.entry(&path) {
            Some(_) => self.renew_users(&path),
            None => self.renew_others(&path),
        }
    }

    fn watched(&mut self, params: DidChangeWatchedFilesParams) {
        let mut is_wide = false;
        for event in params.changes {
            let Some(path) = path_of(&event.uri) else {
                continue;
            };
            let name = path.file_name().unwrap_or_default();
            is_wide |= name == CONFIGURATION || name == ".editorconfig";
            // A file that is created or deleted may affect includes.
            is_wide |= event.kind != FileChangeType::Changed;
            if !self.now.files.open.contains_key(&path) {
                self.renew_users(&path);
            }
        }
        if is_wide {
            self.renew();
        }
    }

    fn moved(&mut self, params: DidChangeWorkspaceFoldersParams) {
        let mut folders = self.now.folders.to_vec();
        let missing = params.event.removed.iter().filter_map(|f| path_of(&f.uri));
        let missing: Vec<PathBuf> = missing.collect();
        folders.retain(|folder| !missing.contains(folder));
        folders.extend(params.event.added.iter().filter_map(|f| path_of(&f.uri)));
        self.now.folders = Arc::new(folders);
        self.renew();
    }

    /// Publishes the findings about configurations that changed, and a message about each that is
    /// invalid now.
    fn publish_configs(&mut self) {
        if !std::mem::take(&mut self.has_new_configs) {
            return;
        }
        let open: Vec<PathBuf> = self.now.files.open.keys().cloned().collect();
        let found = self.now.workspace().invalid_configs(&open).into_iter();
        let found = found
            .map(|finding| (finding.path.clone(), finding))
            .collect();
        let before = std::mem::replace(&mut self.invalid, found);
        let paths: BTreeSet<PathBuf> = before.keys().chain(self.invalid.keys()).cloned().collect();
        for path in paths {
            let finding = self.invalid.get(&path).cloned();
            if before.get(&path) == finding.as_ref() {
                continue;
            }
            let name = slashed(&path);
            let params = config_findings(&self.now, &name, finding.as_ref());
            self.notify::<PublishDiagnosticsNotification>(&params);
            if let Some(finding) = finding {
                let line = finding
                    .at
                    .map_or(String::new(), |(line, _)| format!(":{line}"));
                let message = format!("{name}{line}: {}", finding.message);
                self.notify::<ShowMessageNotification>(&ShowMessageParams {
                    kind: MessageType::Error,
                    message,
                });
            }
        }
    }

    /// Publishes the findings of changed documents, unless the client requests them.
    pub fn publish_findings(&mut self) {
        self.publish_configs();
        let unpublished = std::mem::take(&mut self.unpublished);
        if self.now.client.pulls {
            return;
        }
        for path in unpublished {
            if let Some(buffer) = self.now.files.open.get(&path).cloned() {
                self.publish(&buffer);
            }
        }
    }

    fn publish(&mut self, buffer: &TextBuffer) {
        if let Ok(params) = guarded(|| Ok(diagnostics_of(&self.now, buffer))) {
            self.notify::<PublishDiagnosticsNotification>(&params);
        }
    }

    /// The open document at a path, if its shaders should be run.
    pub fn to_run(&self, path: &Path) -> Option<Arc<TextBuffer>> {
        let buffer = self.now.files.open.get(path)?;
        let is_run = self.now.settings.run && !self.now.leaves_out(buffer);
        is_run.then(|| buffer.clone())
    }

    /// A sample run finished, or was dropped because the document changed.
    pub fn ran(&mut self, path: &Path, state: u64) {
        let Some(buffer) = self.now.files.open.get(path).cloned() else {
            return;
        };
        if buffer.state != state {
            return;
        }
        if buffer.ran.get().is_none() {
            // Another document changed: run this one again.
            self.changed.push(path.to_path_buf());
            return;
        }
        if !self.now.client.pulls {
            self.publish(&buffer);
        } else if self.now.client.refreshes_diagnostics {
            self.ask("workspace/diagnostic/refresh", Value::Null);
        }
        if self.now.client.refreshes_hints {
            self.ask("workspace/inlayHint/refresh", Value::Null);
            self.ask("workspace/codeLens/refresh", Value::Null);
        }
    }

    fn command(&mut self, id: RequestId, params: &Value) -> Option<PendingRequest> {
        let command = params.get("command").and_then(Value::as_str).unwrap_or("");
        let first = params.get("arguments").and_then(|all| all.get(0));
        let first = first.and_then(Value::as_str).unwrap_or("").to_string();
        let second = params.get("arguments").and_then(|all| all.get(1)).cloned();
        let act: fn(&Snapshot, &TextBuffer, Value) -> Answer<(&'static str, Value)> = match command
        {
            EXPLAIN => {
                let answer = self.explain(&first);
                return Some(PendingRequest::new(id, Lane::Quick, |_| {
                    Ok((answer?, None))
                }));
            }
            #[cfg(feature = "preview")]
            PREVIEW => show,
            #[cfg(feature = "preview")]
            WRITE_CHANNELS => write_channels,
            FIX_ALL => apply_all,
            other => {
                let failure = Failure::invalid(format!("unknown command `{other}`"));
                return Some(PendingRequest::new(id, Lane::Quick, |_| Err(failure)));
            }
        };
        Some(PendingRequest::new(id, Lane::Slow, move |snapshot| {
            let buffer = snapshot.buffer(&Uri(first))?;
            let (method, params) = act(snapshot, buffer, second.unwrap_or_default())?;
            let id = RequestId::from(format!("{method}#{}", buffer.state));
            let request = Asked::new(id, method.to_string(), params);
            Ok((Value::Null, Some(request)))
        }))
    }

    /// Shows the documentation of a rule, and returns its text.
    fn explain(&mut self, rule: &str) -> Answer<Value> {
        let Some(text) = page(rule) else {
            return Err(Failure::invalid(format!("unknown rule `{rule}`")));
        };
        let uri = self.now.workspace().page(rule);
        match uri.filter(|_| self.now.client.shows_documents) {
            Some(uri) => self.ask(
                "window/showDocument",
                json!({ "uri": uri, "takeFocus": true }),
            ),
            None => self.notify::<ShowMessageNotification>(&ShowMessageParams {
                kind: MessageType::Info,
                message: format!("{rule}: {}", Page::new(text).summary),
            }),
        }
        Ok(text.into())
    }
}

/// Writes the preview page of a document to a file, for the browser. `shown` is the number of the
/// shader, a position in it, the range of a value, or null.
#[cfg(feature = "preview")]
fn show(snapshot: &Snapshot, buffer: &TextBuffer, shown: Value) -> Answer<(&'static str, Value)> {
    let html = preview::page(snapshot, buffer, preview::ShownShader::read(shown))?.html;
    let uri = snapshot.workspace().write_page("preview.html", &html);
    let uri = uri.ok_or_else(|| Failure::refused("cannot write the preview page"))?;
    Ok((
        "window/showDocument",
        json!({ "uri": uri, "external": true }),
    ))
}

/// The edit that writes the inputs that a preview assumes. `shown` is as for [`show`].
#[cfg(feature = "preview")]
fn write_channels(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    shown: Value,
) -> Answer<(&'static str, Value)> {
    let shown = preview::ShownShader::read(shown);
    let edit = preview::write_channels(snapshot, buffer, shown)?;
    let params = json!({ "label": "Write channels.toml", "edit": edit });
    Ok(("workspace/applyEdit", params))
}

/// The edit that applies all safe fixes of a document.
fn apply_all(snapshot: &Snapshot, buffer: &TextBuffer, _: Value) -> Answer<(&'static str, Value)> {
    let action = super::answers::fix_all(snapshot, buffer);
    let action = action.ok_or_else(|| Failure::refused("no safe fixes available"))?;
    let params = json!({ "label": action.title, "edit": action.edit });
    Ok(("workspace/applyEdit", params))
}
