//! The main loop: reads messages, dispatches work to threads, and starts sample runs.

use super::pages::PageFiles;
use super::parent;
use super::workers::Worker;
use super::workspace::DiskWorkspace;
use crate::lsp::{Lane, PendingRequest, Session, Snapshot, initialized, run_buffer};
use lsp_server::{Connection, ErrorCode, Message, ProtocolError, RequestId, Response};
use serde_json::Value;
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::path::PathBuf;
use std::sync::atomic::Ordering;
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
    /// The client closed the connection, or has ended.
    Closed,
}

/// Requests of the worker thread, and whether the client cancelled them.
type Pending = Arc<Mutex<HashMap<RequestId, bool>>>;

struct Server {
    connection: Arc<Connection>,
    events: Receiver<Event>,
    sender: Sender<Event>,
    session: Session,
    /// Messages that were read but not handled.
    queue: VecDeque<Message>,
    /// When the documents are due for a sample run.
    due: BTreeMap<PathBuf, Instant>,
    pending: Pending,
    slow: Worker,
    runs: Worker,
    /// Whether the client closed the connection.
    is_closed: bool,
}

/// Serves a client. Returns whether it sent `shutdown` before `exit`.
///
/// # Errors
/// If the handshake is invalid.
pub fn serve(connection: Connection) -> Result<bool, ProtocolError> {
    let (id, params) = connection.initialize_start()?;
    if !params.is_object() {
        let code = ErrorCode::InvalidParams as i32;
        let answer = Response::new_err(id, code, "the parameters are not an object".to_string());
        let _ = connection.sender.send(answer.into());
        return Ok(false);
    }
    connection.initialize_finish(id, initialized(&params))?;
    let pages = Arc::new(PageFiles::default());
    let Ok(mut server) = Server::new(connection, &params, pages.clone()) else {
        return Ok(false);
    };
    let is_done = server.run();
    // A thread may still have a snapshot with them.
    pages.remove();
    Ok(is_done)
}

impl Server {
    fn new(
        connection: Connection,
        params: &Value,
        pages: Arc<PageFiles>,
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
        let closer = sender.clone();
        parent::watch(params, move || {
            let _ = closer.send(Event::Closed);
        });
        let session = Session::new(params, |folders| {
            Arc::new(DiskWorkspace::new(folders, pages))
        });
        Ok(Server {
            connection,
            events,
            sender,
            session,
            queue: VecDeque::new(),
            due: BTreeMap::new(),
            pending: Pending::default(),
            slow: Worker::start("requests")?,
            runs: Worker::start("runs")?,
            is_closed: false,
        })
    }

    fn send(&self, message: impl Into<Message>) {
        // A failure means that the client is gone, which the loop notices itself.
        let _ = self.connection.sender.send(message.into());
    }

    /// Runs until the client exits. Returns whether it sent `shutdown`.
    fn run(&mut self) -> bool {
        loop {
            self.flush();
            if self.queue.is_empty() {
                self.session.publish_findings();
                self.flush();
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
                Some(Message::Request(request)) => {
                    if let Some(work) = self.session.request(request) {
                        self.begin(work);
                    }
                }
                Some(Message::Notification(notification)) => {
                    if notification.method == "exit" {
                        return self.session.is_done;
                    }
                    self.session.notification(notification);
                }
                Some(Message::Response(response)) => self.session.response(response),
                None if self.is_closed => return self.session.is_done,
                None => {}
            }
        }
    }

    /// Sends what the session has to say, and schedules sample runs of documents that changed.
    fn flush(&mut self) {
        for message in self.session.take_messages() {
            self.send(message);
        }
        let at = Instant::now() + PAUSE;
        let changed = self.session.take_changed().into_iter();
        self.due.extend(changed.map(|path| (path, at)));
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
            Event::Ran(path, state) => self.session.ran(&path, state),
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
                self.send(cancelled(id));
            }
            // The worker may be handling it; an answer that was sent stays valid.
            None => {
                if let Some(is_cancelled) = lock(&self.pending).get_mut(&id) {
                    *is_cancelled = true;
                }
            }
        }
    }

    /// Answers a request, here or on the worker thread.
    fn begin(&self, work: PendingRequest) {
        let snapshot = self.session.snapshot().clone();
        match work.lane {
            Lane::Quick => {
                let (response, request) = work.answer(&snapshot);
                self.send(response);
                request.into_iter().for_each(|message| self.send(message));
            }
            Lane::Slow => self.later(work, snapshot),
        }
    }

    /// Handles a request on the worker thread. If documents change before, the client gets
    /// `ContentModified` and may ask again.
    fn later(&self, work: PendingRequest, snapshot: Snapshot) {
        let (connection, pending) = (self.connection.clone(), self.pending.clone());
        let id = work.id.clone();
        lock(&pending).insert(id.clone(), false);
        self.slow.give(move || {
            let is_cancelled = || lock(&pending).get(&id) == Some(&true);
            let is_needed = !is_cancelled() && !snapshot.is_stale();
            let answer = is_needed.then(|| work.answer(&snapshot));
            let was_cancelled = lock(&pending).remove(&id) == Some(true);
            let (response, request) = match answer {
                _ if was_cancelled => (cancelled(id), None),
                Some(answer) if !snapshot.is_stale() => answer,
                _ => (stale(id), None),
            };
            let _ = connection.sender.send(response.into());
            if let Some(request) = request {
                let _ = connection.sender.send(request);
            }
        });
    }

    /// Starts sample runs of documents that did not change for a while.
    fn start_runs(&mut self) {
        let now = Instant::now();
        let due = self.due.iter().filter(|(_, at)| **at <= now);
        let due: Vec<PathBuf> = due.map(|(path, _)| path.clone()).collect();
        for path in due {
            self.due.remove(&path);
            let Some(buffer) = self.session.to_run(&path) else {
                continue;
            };
            let (snapshot, sender) = (self.session.snapshot().clone(), self.sender.clone());
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
