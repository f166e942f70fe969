//! The main loop: reads messages, maintains the documents, dispatches work, publishes findings.

use super::super::config::{ConfigArgs, ConfigSource, Configs, Exclusion, FILE};
use super::super::disk::Disk;
use super::answers::{Jobs, Lane, diagnostics_of};
use super::buffers::{OpenFiles, TextBuffer, changed};
use super::capabilities::{EXPLAIN, FIX_ALL, PREVIEW, capabilities};
use super::client::{Client, UserSettings};
use super::pages::PageFiles;
use super::preview;
use super::snapshot::{Answer, Failure, Snapshot};
use super::uri::path_of;
use super::workers::{Worker, run_buffer};
use crate::engine::config::Selection;
use crate::ide::Document;
use crate::lint::Page;
use crate::rules::page;
use gen_lsp_types::*;
use lsp_server::{Connection, ErrorCode, Message, Notification as Sent, Request as Asked};
use lsp_server::{ProtocolError, RequestId, Response};
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Delay between the last change and a sample run.
const PAUSE: Duration = Duration::from_millis(300);

/// An event of the main loop.
enum Event {
    /// A message from the client.
    Message(Message),
    /// The sample run of a document in this state has finished.
    Ran(PathBuf, u64),
    /// The client closed the connection.
    Closed,
}

/// Requests of the worker thread, and whether the client cancelled them.
type Pending = Arc<Mutex<HashMap<RequestId, bool>>>;

struct Server {
    connection: Arc<Connection>,
    events: Receiver<Event>,
    sender: Sender<Event>,
    jobs: Jobs,
    now: Snapshot,
    /// Messages that were read but not handled.
    queue: VecDeque<Message>,
    /// Documents with findings to publish.
    unreported_faults: Vec<PathBuf>,
    /// When the documents are due for a sample run.
    due: BTreeMap<PathBuf, Instant>,
    pending: Pending,
    slow: Worker,
    runs: Worker,
    /// Number of requests sent to the client.
    asked: u32,
    /// Whether the client sent `shutdown`.
    is_done: bool,
    /// Whether the client closed the connection.
    is_closed: bool,
}

/// Serves a client. Returns whether it sent `shutdown` before `exit`.
///
/// # Errors
/// If the handshake is invalid.
pub fn serve(connection: Connection) -> Result<bool, ProtocolError> {
    let (id, params) = connection.initialize_start()?;
    let params: InitializeParams = match serde_json::from_value(params) {
        Ok(params) => params,
        Err(error) => {
            let code = ErrorCode::InvalidParams as i32;
            let answer = Response::new_err(id, code, error.to_string());
            let _ = connection.sender.send(answer.into());
            return Ok(false);
        }
    };
    let client = Client::of(&params);
    let result = json!({
        "capabilities": capabilities(&client),
        "serverInfo": { "name": "shaderlint", "version": env!("CARGO_PKG_VERSION") },
    });
    connection.initialize_finish(id, result)?;
    let Ok(mut server) = Server::new(connection, client, &params) else {
        return Ok(false);
    };
    server.greet(params.initialization_options.as_ref());
    Ok(server.run())
}

/// The options for checking files in some folders.
fn configs(folders: &[PathBuf], run_samples: Option<u32>) -> Arc<Configs> {
    Arc::new(Configs::new(ConfigArgs {
        given: Selection {
            run_samples,
            ..Selection::default()
        },
        source: ConfigSource::Nearest,
        exclusion: Exclusion::Named,
        paths: folders.to_vec(),
    }))
}

/// The workspace folders of a client.
fn folders(params: &InitializeParams) -> Vec<PathBuf> {
    let folders = &params.workspace_folders_initialize_params.workspace_folders;
    match folders {
        Some(WorkspaceFolders::WorkspaceFolderList(all)) => all
            .iter()
            .filter_map(|folder| path_of(&folder.uri))
            .collect(),
        // Old clients send a single folder.
        _ => {
            #[expect(deprecated, reason = "old clients send nothing else")]
            let root = params.root_uri.as_ref();
            root.and_then(path_of).into_iter().collect()
        }
    }
}

impl Server {
    fn new(
        connection: Connection,
        client: Client,
        params: &InitializeParams,
    ) -> std::io::Result<Server> {
        let connection = Arc::new(connection);
        let (sender, events) = channel();
        let (reader, from) = (sender.clone(), connection.clone());
        std::thread::Builder::new()
            .name("reader".to_string())
            .spawn(move || {
                for message in &from.receiver {
                    if reader.send(Event::Message(message)).is_err() {
                        return;
                    }
                }
                let _ = reader.send(Event::Closed);
            })?;
        let folders = folders(params);
        let now = Snapshot {
            client: Arc::new(client),
            settings: Arc::default(),
            files: OpenFiles {
                disk: Arc::new(Disk::new()),
                open: Arc::default(),
            },
            quick: configs(&folders, Some(0)),
            full: configs(&folders, None),
            folders: Arc::new(folders),
            pages: Arc::new(PageFiles::default()),
            tokens: Arc::default(),
            state: 0,
            newest: Arc::new(AtomicU64::new(0)),
        };
        Ok(Server {
            connection,
            events,
            sender,
            jobs: Jobs::new(),
            now,
            queue: VecDeque::new(),
            unreported_faults: Vec::new(),
            due: BTreeMap::new(),
            pending: Pending::default(),
            slow: Worker::start("requests")?,
            runs: Worker::start("runs")?,
            asked: 0,
            is_done: false,
            is_closed: false,
        })
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
        self.send(Asked::new(id, method.to_string(), params).into());
    }

    fn send(&self, message: Message) {
        // A failure means that the client is gone, which the loop notices itself.
        let _ = self.connection.sender.send(message);
    }

    fn notify<N: Notification>(&self, params: &N::Params) {
        self.send(Sent::new(N::METHOD.to_string(), params).into());
    }

    /// Runs until the client exits. Returns whether it sent `shutdown`.
    fn run(&mut self) -> bool {
        loop {
            if self.queue.is_empty() {
                self.publish_findings();
                self.start_runs();
                match self.wait() {
                    Some(event) => self.take(event),
                    None => continue,
                }
            }
            // Reads everything that has arrived, because requests may be cancelled already.
            while let Ok(event) = self.events.try_recv() {
                self.take(event);
            }
            match self.queue.pop_front() {
                Some(Message::Request(request)) => self.request(request),
                Some(Message::Notification(notification)) => {
                    if notification.method == "exit" {
                        return self.is_done;
                    }
                    self.notification(notification);
                }
                Some(Message::Response(response)) => self.response(response),
                None if self.is_closed => return self.is_done,
                None => {}
            }
        }
    }

    /// The next event; `None` if a sample run is due.
    fn wait(&self) -> Option<Event> {
        let first = self.due.values().min();
        match first {
            None => Some(self.events.recv().unwrap_or(Event::Closed)),
            Some(at) => {
                let left = at.saturating_duration_since(Instant::now());
                match self.events.recv_timeout(left) {
                    Ok(event) => Some(event),
                    Err(RecvTimeoutError::Timeout) => None,
                    Err(RecvTimeoutError::Disconnected) => Some(Event::Closed),
                }
            }
        }
    }

    fn take(&mut self, event: Event) {
        match event {
            Event::Message(Message::Notification(sent)) if sent.method == "$/cancelRequest" => {
                self.cancel(&sent.params);
            }
            Event::Message(message) => self.queue.push_back(message),
            Event::Ran(path, state) => self.ran(&path, state),
            Event::Closed => self.is_closed = true,
        }
    }

    fn cancel(&mut self, params: &Value) {
        let id = match params.get("id") {
            Some(Value::Number(number)) => number.as_i64().and_then(|n| i32::try_from(n).ok()),
            Some(Value::String(text)) => {
                return self.cancel_id(RequestId::from(text.clone()));
            }
            _ => None,
        };
        if let Some(id) = id {
            self.cancel_id(RequestId::from(id));
        }
    }

    fn cancel_id(&mut self, id: RequestId) {
        let is_it = |m: &Message| matches!(m, Message::Request(r) if r.id == id);
        match self.queue.iter().position(is_it) {
            Some(at) => {
                self.queue.remove(at);
                self.send(cancelled(id).into());
            }
            // The worker may be handling it; an answer that was sent stays valid.
            None => {
                if let Some(is_cancelled) = lock(&self.pending).get_mut(&id) {
                    *is_cancelled = true;
                }
            }
        }
    }

    fn request(&mut self, request: Asked) {
        let Asked { id, method, params } = request;
        match method.as_str() {
            "shutdown" if !self.is_done => {
                self.is_done = true;
                self.send(Response::new_ok(id, Value::Null).into());
            }
            _ if self.is_done => {
                let code = ErrorCode::InvalidRequest as i32;
                self.send(Response::new_err(id, code, "the server was shut down".into()).into());
            }
            "workspace/executeCommand" => self.command(id, params),
            method => match self.jobs.get(method) {
                Some((Lane::Quick, job)) => {
                    let answer = guarded(|| job(&self.now, params));
                    self.send(response(id, answer).into());
                }
                Some((Lane::Slow, job)) => {
                    self.later(id, move |snapshot| job(snapshot, params));
                }
                None => {
                    let code = ErrorCode::MethodNotFound as i32;
                    let message = format!("method `{method}` is not supported");
                    self.send(Response::new_err(id, code, message).into());
                }
            },
        }
    }

    /// Handles a request on the worker thread. If documents change before, the client gets
    /// `ContentModified` and may ask again.
    fn later(&self, id: RequestId, job: impl FnOnce(&Snapshot) -> Answer<Value> + Send + 'static) {
        self.later_with_request(id, |snapshot| Ok((job(snapshot)?, None)));
    }

    /// Handles a request on the worker thread, then sends a request to the client. The order
    /// matters: what the client does next may make the answer stale.
    fn later_with_request(
        &self,
        id: RequestId,
        job: impl FnOnce(&Snapshot) -> Answer<(Value, Option<Asked>)> + Send + 'static,
    ) {
        let snapshot = self.now.clone();
        let (connection, pending) = (self.connection.clone(), self.pending.clone());
        lock(&pending).insert(id.clone(), false);
        self.slow.give(move || {
            let is_cancelled = || lock(&pending).get(&id) == Some(&true);
            let is_needed = !is_cancelled() && !snapshot.is_stale();
            let answer = is_needed.then(|| guarded(|| job(&snapshot)));
            let was_cancelled = lock(&pending).remove(&id) == Some(true);
            let (response, request) = match answer {
                _ if was_cancelled => (cancelled(id), None),
                Some(Ok((value, request))) if !snapshot.is_stale() => {
                    (response(id, Ok(value)), request)
                }
                Some(Err(failure)) if !snapshot.is_stale() => (response(id, Err(failure)), None),
                _ => (stale(id), None),
            };
            let _ = connection.sender.send(response.into());
            if let Some(request) = request {
                let _ = connection.sender.send(request.into());
            }
        });
    }

    fn notification(&mut self, sent: Sent) {
        let Sent { method, params } = sent;
        match method.as_str() {
            "textDocument/didOpen" => self.with(params, Server::opened),
            "textDocument/didChange" => self.with(params, Server::changed),
            "textDocument/didClose" => self.with(params, Server::closed),
            "workspace/didChangeConfiguration" => self.with(params, Server::configured),
            "workspace/didChangeWatchedFiles" => self.with(params, Server::watched),
            "workspace/didChangeWorkspaceFolders" => self.with(params, Server::moved),
            // Unknown notifications are not errors.
            _ => {}
        }
    }

    fn with<P: serde::de::DeserializeOwned>(&mut self, params: Value, act: fn(&mut Server, P)) {
        match serde_json::from_value(params) {
            Ok(params) => act(self, params),
            Err(error) => self.log(&error.to_string()),
        }
    }

    fn log(&self, message: &str) {
        self.notify::<LogMessageNotification>(&LogMessageParams {
            kind: MessageType::Warning,
            message: message.to_string(),
        });
    }

    fn response(&mut self, response: Response) {
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
        self.due.insert(path.clone(), Instant::now() + PAUSE);
        if !self.unreported_faults.contains(&path) {
            self.unreported_faults.push(path);
        }
    }

    /// Analyses the open documents again that depend on a file.
    fn renew_users(&mut self, path: &Path) {
        let changed = path.to_string_lossy().replace('\\', "/");
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
        let folders = self.now.folders.clone();
        self.now.quick = configs(&folders, Some(0));
        self.now.full = configs(&folders, None);
        let all: Vec<Arc<TextBuffer>> = self.now.files.open.values().cloned().collect();
        for buffer in all {
            self.again(&buffer);
        }
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let item = params.text_document;
        let state = self.next_state();
        let language = item.language_id.to_string();
        self.put(TextBuffer::new(
            item.uri,
            language,
            item.version,
            item.text,
            state,
        ));
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
        self.due.remove(&path);
        self.unreported_faults.retain(|p| *p != path);
        if !self.now.client.pulls {
            self.notify::<PublishDiagnosticsNotification>(&PublishDiagnosticsParams {
                uri,
                version: None,
                diagnostics: Vec::new(),
            });
        }
        // From now on the file on disk counts.
        self.renew_users(&path);
    }

    fn watched(&mut self, params: DidChangeWatchedFilesParams) {
        let mut is_wide = false;
        for event in params.changes {
            let Some(path) = path_of(&event.uri) else {
                continue;
            };
            let name = path.file_name().unwrap_or_default();
            is_wide |= name == FILE || name == ".editorconfig";
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

    /// Publishes the findings of changed documents, unless the client requests them.
    fn publish_findings(&mut self) {
        let unreported_faults = std::mem::take(&mut self.unreported_faults);
        if self.now.client.pulls {
            return;
        }
        for path in unreported_faults {
            let Some(buffer) = self.now.files.open.get(&path) else {
                continue;
            };
            if let Ok(params) = guarded(|| Ok(diagnostics_of(&self.now, buffer))) {
                self.notify::<PublishDiagnosticsNotification>(&params);
            }
        }
    }

    /// Starts sample runs of documents that did not change for a while.
    fn start_runs(&mut self) {
        let now = Instant::now();
        let due: Vec<PathBuf> = self
            .due
            .iter()
            .filter(|(_, at)| **at <= now)
            .map(|(path, _)| path.clone())
            .collect();
        for path in due {
            self.due.remove(&path);
            let Some(buffer) = self.now.files.open.get(&path).cloned() else {
                continue;
            };
            if !self.now.settings.run || self.now.leaves_out(&buffer) {
                continue;
            }
            let (snapshot, sender) = (self.now.clone(), self.sender.clone());
            self.runs.give(move || {
                let newest = snapshot.newest.load(Ordering::Relaxed);
                // If the document changed in the meantime, its next state is already due.
                if newest == snapshot.state || buffer.state == newest {
                    run_buffer(&snapshot, &buffer);
                }
                let _ = sender.send(Event::Ran(path, buffer.state));
            });
        }
    }

    /// A sample run finished, or was dropped because the document changed.
    fn ran(&mut self, path: &Path, state: u64) {
        let Some(buffer) = self.now.files.open.get(path) else {
            return;
        };
        if buffer.state != state {
            return;
        }
        if buffer.ran.get().is_none() {
            // Another document changed: run this one again.
            self.due.insert(path.to_path_buf(), Instant::now() + PAUSE);
            return;
        }
        if !self.now.client.pulls {
            if let Ok(params) = guarded(|| Ok(diagnostics_of(&self.now, buffer))) {
                self.notify::<PublishDiagnosticsNotification>(&params);
            }
        } else if self.now.client.refreshes_diagnostics {
            self.ask("workspace/diagnostic/refresh", Value::Null);
        }
        if self.now.client.refreshes_hints {
            self.ask("workspace/inlayHint/refresh", Value::Null);
            self.ask("workspace/codeLens/refresh", Value::Null);
        }
    }

    fn command(&mut self, id: RequestId, params: Value) {
        let command = params
            .get("command")
            .and_then(Value::as_str)
            .unwrap_or("")
            .to_string();
        let first = params.get("arguments").and_then(|all| all.get(0)).cloned();
        let first = first
            .and_then(|v| v.as_str().map(str::to_string))
            .unwrap_or_default();
        match command.as_str() {
            EXPLAIN => {
                let answer = self.explain(&first);
                self.send(response(id, answer).into());
            }
            PREVIEW | FIX_ALL => {
                let is_preview = command == PREVIEW;
                self.later_with_request(id, move |snapshot| {
                    let buffer = snapshot.buffer(&Uri(first))?;
                    let (method, params) = match is_preview {
                        true => show(snapshot, buffer)?,
                        false => apply_all(snapshot, buffer)?,
                    };
                    let id = RequestId::from(format!("{method}#{}", buffer.state));
                    let request = Asked::new(id, method.to_string(), params);
                    Ok((Value::Null, Some(request)))
                });
            }
            other => {
                let failure = Failure::invalid(format!("unknown command `{other}`"));
                self.send(response(id, Err(failure)).into());
            }
        }
    }

    /// Shows the documentation of a rule, and returns its text.
    fn explain(&mut self, rule: &str) -> Answer<Value> {
        let Some(text) = page(rule) else {
            return Err(Failure::invalid(format!("unknown rule `{rule}`")));
        };
        let uri = self.now.pages.uri(rule);
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

/// Writes the preview page of a document to a file, for the browser.
fn show(snapshot: &Snapshot, buffer: &TextBuffer) -> Answer<(&'static str, Value)> {
    let html = preview::page(snapshot, buffer)?;
    let uri = snapshot.pages.write_anew("preview.html", &html);
    let uri = uri.ok_or_else(|| Failure::refused("cannot write the preview page"))?;
    Ok((
        "window/showDocument",
        json!({ "uri": uri, "external": true }),
    ))
}

/// The edit that applies all safe fixes of a document.
fn apply_all(snapshot: &Snapshot, buffer: &TextBuffer) -> Answer<(&'static str, Value)> {
    let action = super::answers::fix_all(snapshot, buffer);
    let action = action.ok_or_else(|| Failure::refused("no safe fixes available"))?;
    let params = json!({ "label": action.title, "edit": action.edit });
    Ok(("workspace/applyEdit", params))
}

/// Runs a handler; a panic loses one answer only.
fn guarded<T>(work: impl FnOnce() -> Answer<T>) -> Answer<T> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        Err(Failure {
            code: ErrorCode::InternalError,
            message: "internal error: shaderlint crashed on this request; please report it"
                .to_string(),
        })
    })
}

fn response(id: RequestId, answer: Answer<Value>) -> Response {
    match answer {
        Ok(result) => Response::new_ok(id, result),
        Err(failure) => Response::new_err(id, failure.code as i32, failure.message),
    }
}

fn cancelled(id: RequestId) -> Response {
    Response::new_err(
        id,
        ErrorCode::RequestCanceled as i32,
        "cancelled".to_string(),
    )
}

fn stale(id: RequestId) -> Response {
    let message = "the document has changed".to_string();
    Response::new_err(id, ErrorCode::ContentModified as i32, message)
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner())
}
