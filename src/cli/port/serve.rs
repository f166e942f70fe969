//! A server for one page, accessible from this machine only. `/` is the page, `/events` announces
//! new versions.

use super::report::print_note;
use crate::cli::command::{CLEAN, FAILED};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Longest request, in bytes.
const MAX_REQUEST: u64 = 16 * 1024;

/// Largest number of headers in a request.
const MAX_HEADERS: usize = 64;

/// How long a browser may take to complete its request.
const PATIENCE: Duration = Duration::from_secs(10);

/// How often an idle event stream is checked for a closed connection.
const PULSE: Duration = Duration::from_secs(10);

pub(super) struct PageServer {
    address: SocketAddr,
    shown: Arc<ShownPage>,
    thread: thread::JoinHandle<()>,
}

/// The current page, and the connections that wait for the next one.
#[derive(Default)]
struct ShownPage {
    page: Mutex<ServedPage>,
    changed: Condvar,
}

/// A version of the page.
#[derive(Clone, Default)]
struct ServedPage {
    version: String,
    content: Arc<Vec<u8>>,
    /// The error that prevents a newer version; empty if there is none.
    trouble: String,
}

impl PageServer {
    /// Listens on a port of the loopback interface, or on any free port if it is in use.
    pub(super) fn open(port: u16) -> Result<PageServer, String> {
        let bind = |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port));
        let opened = bind(port).or_else(|why| {
            print_note(&format!("cannot use port {port} ({why}); choosing another"));
            bind(0)
        });
        let listener = opened.map_err(|e| format!("cannot serve the page: {e}"))?;
        let address = listener.local_addr().map_err(|e| e.to_string())?;
        let shown = Arc::new(ShownPage::default());
        let for_all = Arc::clone(&shown);
        let thread = thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let shown = Arc::clone(&for_all);
                // A connection that is closed early needs no handling.
                thread::spawn(move || answer(&stream, address, &shown));
            }
        });
        Ok(PageServer {
            address,
            shown,
            thread,
        })
    }

    /// The URL of the page.
    pub(super) fn address(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// Replaces the page and makes open pages reload.
    pub(super) fn show(&self, version: &str, content: Vec<u8>) {
        *self.shown.page() = ServedPage {
            version: version.to_string(),
            content: Arc::new(content),
            trouble: String::new(),
        };
        self.shown.changed.notify_all();
    }

    /// Shows an error on open pages.
    pub(super) fn show_trouble(&self, trouble: &str) {
        self.shown.page().trouble = trouble.replace(['\r', '\n'], " ");
        self.shown.changed.notify_all();
    }

    /// Whether there is no page yet.
    pub(super) fn is_empty(&self) -> bool {
        self.shown.page().is_empty()
    }

    /// Serves until the process is terminated.
    pub(super) fn stay(self) -> u8 {
        match self.thread.join() {
            Ok(()) => CLEAN,
            Err(_) => FAILED,
        }
    }
}

impl ServedPage {
    /// Whether there is no page yet.
    fn is_empty(&self) -> bool {
        self.version.is_empty()
    }

    /// Whether both have the same version and the same error.
    fn shows(&self, other: &ServedPage) -> bool {
        self.version == other.version && self.trouble == other.trouble
    }
}

impl ShownPage {
    /// Locks the current page.
    fn page(&self) -> MutexGuard<'_, ServedPage> {
        self.page.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for the first page: a browser may connect before the first conversion is done.
    fn first(&self) -> ServedPage {
        let shown = self.changed.wait_while(self.page(), |p| p.is_empty());
        shown.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Waits until the page differs from a known one, or until the pulse interval has passed.
    fn next(&self, known: &ServedPage) -> ServedPage {
        let is_known = |page: &mut ServedPage| page.shows(known);
        let waited = self
            .changed
            .wait_timeout_while(self.page(), PULSE, is_known);
        waited.unwrap_or_else(PoisonError::into_inner).0.clone()
    }
}

/// A request of a browser.
struct Request {
    path: String,
    host: String,
}

fn answer(stream: &TcpStream, address: SocketAddr, shown: &ShownPage) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let Some(request) = read(stream)? else {
        return reply(stream, "400 Bad Request", "text/plain", b"bad request\n");
    };
    // Rejects DNS rebinding: another host name that resolves to this server.
    let port = address.port();
    let own = [format!("{address}"), format!("localhost:{port}")];
    if !own.contains(&request.host) {
        return reply(
            stream,
            "403 Forbidden",
            "text/plain",
            b"accessible from this machine only\n",
        );
    }
    match request.path.as_str() {
        "/" => {
            let page = shown.first();
            reply(stream, "200 OK", "text/html; charset=utf-8", &page.content)
        }
        "/events" => send_changes(stream, shown),
        _ => reply(stream, "404 Not Found", "text/plain", b"not found\n"),
    }
}

/// Reads the head of a request; `None` if it is not a valid GET request.
fn read(stream: &TcpStream) -> io::Result<Option<Request>> {
    let mut head = Vec::new();
    let mut lines = BufReader::new(stream.take(MAX_REQUEST));
    while !head.ends_with(b"\r\n\r\n") {
        if lines.read_until(b'\n', &mut head)? == 0 {
            return Ok(None);
        }
    }
    let mut headers = [httparse::EMPTY_HEADER; MAX_HEADERS];
    let mut request = httparse::Request::new(&mut headers);
    let is_complete = matches!(request.parse(&head), Ok(status) if status.is_complete());
    if !is_complete || request.method != Some("GET") {
        return Ok(None);
    }
    let mut all = request.headers.iter();
    let host = all.find(|h| h.name.eq_ignore_ascii_case("host"));
    let host = host.map_or(String::new(), |h| {
        String::from_utf8_lossy(h.value).into_owned()
    });
    let path = request.path.unwrap_or("");
    let path = path.split('?').next().unwrap_or("").to_string();
    Ok(Some(Request { path, host }))
}

fn reply(mut stream: &TcpStream, status: &str, kind: &str, content: &[u8]) -> io::Result<()> {
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\
         Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n\
         Cross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n\r\n",
        content.len()
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(content)
}

/// Announces each new version to a page, as server-sent events.
fn send_changes(mut stream: &TcpStream, shown: &ShownPage) -> io::Result<()> {
    stream.write_all(
        b"HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\n\
          Connection: close\r\n\r\n",
    )?;
    let mut known = ServedPage::default();
    loop {
        let page = shown.next(&known);
        let (version, trouble) = (&page.version, &page.trouble);
        // A closed connection is detected only by a failing write.
        let news = match (*version == known.version, *trouble == known.trouble) {
            (true, true) => ": still there\n\n".to_string(),
            (false, _) => format!("data: {version}\n\nevent: trouble\ndata: {trouble}\n\n"),
            (true, false) => format!("event: trouble\ndata: {trouble}\n\n"),
        };
        stream.write_all(news.as_bytes())?;
        known = page;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The server's complete response to a request.
    fn ask(server: &PageServer, head: &str) -> String {
        let mut stream = TcpStream::connect(server.address).unwrap();
        let head = head.replace("HOST", &server.address.to_string());
        stream.write_all(head.as_bytes()).unwrap();
        let mut response = String::new();
        stream.read_to_string(&mut response).unwrap();
        response
    }

    #[test]
    fn only_the_page_is_served_and_only_to_localhost() {
        let server = PageServer::open(0).unwrap();
        assert!(server.is_empty());
        server.show("1", b"hello".to_vec());
        let page = ask(&server, "GET / HTTP/1.1\r\nHost: HOST\r\n\r\n");
        assert!(page.starts_with("HTTP/1.1 200 ") && page.ends_with("\r\n\r\nhello"));
        let status = |head: &str| ask(&server, head).get(9..12).map(str::to_string);
        let refused = [
            ("GET / HTTP/1.1\r\nHost: elsewhere.example\r\n\r\n", "403"),
            ("GET / HTTP/1.1\r\n\r\n", "403"),
            ("GET /etc/passwd HTTP/1.1\r\nHost: HOST\r\n\r\n", "404"),
            ("POST / HTTP/1.1\r\nHost: HOST\r\n\r\n", "400"),
            ("nonsense\r\n\r\n", "400"),
        ];
        for (head, expected) in refused {
            assert_eq!(status(head).as_deref(), Some(expected), "{head}");
        }
    }

    #[test]
    fn a_request_before_the_first_page_waits_for_it() {
        let server = PageServer::open(0).unwrap();
        let mut stream = TcpStream::connect(server.address).unwrap();
        let head = format!("GET / HTTP/1.1\r\nHost: {}\r\n\r\n", server.address);
        stream.write_all(head.as_bytes()).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_millis(100)))
            .unwrap();
        let early = stream.read(&mut [0; 1]).unwrap_err().kind();
        assert!(matches!(
            early,
            io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut
        ));
        server.show("1", b"hello".to_vec());
        stream.set_read_timeout(None).unwrap();
        let mut response = String::new();
        stream.read_to_string(&mut response).unwrap();
        assert!(response.ends_with("\r\n\r\nhello"), "{response}");
    }

    #[test]
    fn an_open_page_is_notified_of_the_next_version() {
        let server = PageServer::open(0).unwrap();
        server.show("1", Vec::new());
        let mut stream = TcpStream::connect(server.address).unwrap();
        let head = format!("GET /events HTTP/1.1\r\nHost: {}\r\n\r\n", server.address);
        stream.write_all(head.as_bytes()).unwrap();
        let mut news = BufReader::new(stream).lines().map(Result::unwrap);
        let mut next = || news.find_map(|l| l.strip_prefix("data: ").map(str::to_string));
        assert_eq!(next().as_deref(), Some("1"));
        assert_eq!(next().as_deref(), Some(""));
        server.show_trouble("there is\nno such file");
        assert_eq!(next().as_deref(), Some("there is no such file"));
        server.show("2", Vec::new());
        assert_eq!(next().as_deref(), Some("2"));
        assert_eq!(next().as_deref(), Some(""), "the trouble is over");
    }
}
