//! The language server, one message after the other.

use super::files::MemoryFiles;
use super::result::RequestResult;
use super::workspace::SentWorkspace;
use gen_lsp_types::Uri;
use lsp_server::{ErrorCode, Message, Notification, Response};
use serde::Deserialize;
use serde_json::{Value, json};
use shaderlint_lsp::{Session, initialized, path_of, run_buffer};
use std::path::PathBuf;
use std::sync::Arc;

/// The notification that hands over files of the workspace.
const FILES: &str = "shaderlint/files";

/// A language server that answers at once. Shaders are run when the host asks for it.
#[derive(Default)]
pub struct InstantServer {
    /// The files of the workspace that are not open.
    files: Arc<MemoryFiles>,
    /// The conversation, after the request `initialize`.
    session: Option<Session>,
    /// Documents that changed since their shaders ran.
    changed: Vec<PathBuf>,
}

/// A file of the workspace that was read, changed or removed.
#[derive(Deserialize)]
struct SentFile {
    uri: Uri,
    /// `None` if it was removed.
    text: Option<String>,
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
            Message::Notification(sent) if sent.method == FILES => {
                let changes = take_files(&self.files, &sent.params)?;
                let method = "workspace/didChangeWatchedFiles".to_string();
                session.notification(Notification::new(method, json!({ "changes": changes })));
            }
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
                self.files = Arc::default();
                if let Some(options) = params.get("initializationOptions") {
                    take_files(&self.files, options)?;
                }
                let files = self.files.clone();
                let workspace =
                    |folders: &[PathBuf]| Arc::new(SentWorkspace::new(files, folders, site)) as _;
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

/// Takes the field `files` of an object. Returns the changes, as watchers report them.
fn take_files(files: &MemoryFiles, object: &Value) -> Result<Vec<Value>, String> {
    let Some(sent) = object.get("files") else {
        return Ok(Vec::new());
    };
    let sent = Vec::<SentFile>::deserialize(sent).map_err(|e| format!("files: {e}"))?;
    let changes = sent.into_iter().filter_map(|SentFile { uri, text }| {
        let was_there = files.put(path_of(&uri)?, text.as_deref());
        let kind = match (was_there, text) {
            (_, None) => 3,
            (false, Some(_)) => 1,
            (true, Some(_)) => 2,
        };
        Some(json!({ "uri": uri, "type": kind }))
    });
    Ok(changes.collect())
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

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// Opens a document. Returns the names of the findings that are published, by document.
    fn open(server: &mut InstantServer, name: &str, text: &str) -> Vec<(String, Vec<String>)> {
        let document = json!({
            "uri": format!("file:///{name}"), "languageId": "glsl", "version": 1, "text": text,
        });
        let params = json!({ "textDocument": document });
        send(server, "textDocument/didOpen", params)
    }

    fn send(server: &mut InstantServer, method: &str, params: Value) -> Vec<(String, Vec<String>)> {
        let sent = lsp_server::Notification::new(method.to_string(), params);
        let messages = server.message(sent.into()).unwrap();
        let published = messages.as_array().unwrap().iter();
        let published = published.filter(|m| m["method"] == "textDocument/publishDiagnostics");
        let found = published.map(|message| {
            let all = message["params"]["diagnostics"].as_array().unwrap();
            let names = all.iter().map(|d| d["code"].as_str().unwrap().to_string());
            let uri = message["params"]["uri"].as_str().unwrap();
            (uri.replace("file:///", ""), names.collect())
        });
        found.collect()
    }

    fn start(options: &Value) -> InstantServer {
        let mut server = InstantServer::default();
        let start = lsp_server::Request {
            id: 1.into(),
            method: "initialize".to_string(),
            params: json!({
                "capabilities": {},
                "initializationOptions": options,
                "workspaceFolders": [{ "uri": "file:///", "name": "all" }],
            }),
        };
        server.message(start.into()).unwrap();
        server
    }

    fn of(name: &str, found: &[&str]) -> (String, Vec<String>) {
        let found = found.iter().map(ToString::to_string);
        (name.to_string(), found.collect())
    }

    const IMAGE: &str = "void mainImage(out vec4 c, in vec2 p) {\n    c = tint(p);\n}\n";
    const COMMON: &str = "vec4 tint(vec2 p) {\n    return vec4(p, 0.0, 1.0);\n}\n";

    #[test]
    fn sent_files_are_used_until_they_are_opened() {
        let file = |text: Option<&str>| json!({ "uri": "file:///a/common.glsl", "text": text });
        let mut server = start(&json!({ "files": [file(Some(COMMON))] }));
        let found = open(&mut server, "a/image.glsl", IMAGE);
        assert_eq!(found, [of("a/image.glsl", &[])]);
        let mut put = |text| send(&mut server, FILES, json!({ "files": [file(text)] }));
        let wrong = COMMON.replace("vec2 p", "float p");
        let expected = ["constructor-arguments", "vector-size"];
        assert_eq!(put(Some(&wrong)), [of("a/image.glsl", &expected)]);
        assert_eq!(put(None), [of("a/image.glsl", &["undeclared-name"])]);
        let both = open(&mut server, "a/common.glsl", COMMON);
        assert_eq!(both, [of("a/common.glsl", &[]), of("a/image.glsl", &[])]);
        // The open document counts.
        let file = json!({ "files": [file(Some(&wrong))] });
        let sent = send(&mut server, FILES, file);
        assert!(sent.iter().all(|(_, found)| found.is_empty()), "{sent:?}");
    }

    #[test]
    #[cfg(feature = "port")]
    fn configurations_among_the_sent_files_apply() {
        let config =
            |text: &str| json!({ "files": [{ "uri": "file:///a/shaderlint.toml", "text": text }] });
        let mut server = start(&config("exclude = [\"image.glsl\"]"));
        let found = open(&mut server, "a/image.glsl", IMAGE);
        assert_eq!(found, [of("a/image.glsl", &[])]);
        let image = of("a/image.glsl", &["undeclared-name"]);
        let changed = send(&mut server, FILES, config("exclude = [\"other.glsl\"]"));
        assert_eq!(changed, std::slice::from_ref(&image));
    }

    #[test]
    fn open_documents_are_the_passes_of_a_folder() {
        let mut server = start(&json!({}));
        let unknown = of("image.glsl", &["undeclared-name"]);
        let found = open(&mut server, "image.glsl", IMAGE);
        assert_eq!(found, std::slice::from_ref(&unknown));
        let both = open(&mut server, "common.glsl", COMMON);
        assert_eq!(both, [of("common.glsl", &[]), of("image.glsl", &[])]);
        let change = json!({
            "textDocument": { "uri": "file:///common.glsl", "version": 2 },
            "contentChanges": [{ "text": COMMON.replace("vec2 p", "vec3 p").replace("(p, 0.0", "(p") }],
        });
        let changed = send(&mut server, "textDocument/didChange", change);
        let wrong = of("image.glsl", &["vector-size"]);
        assert_eq!(changed, [of("common.glsl", &[]), wrong]);
        let closed = json!({ "textDocument": { "uri": "file:///common.glsl" } });
        let closed = send(&mut server, "textDocument/didClose", closed);
        assert_eq!(closed, [of("common.glsl", &[]), unknown]);
    }
}
