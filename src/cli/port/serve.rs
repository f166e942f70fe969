//! A server for one page, which only this machine reaches: `/` is the page, `/events` tells the page
//! when there is a newer one.

use super::report::tell;
use crate::cli::command::{CLEAN, FAILED};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Longest request, in bytes.
const MAX_REQUEST: u64 = 16 * 1024;

/// Most headers of a request.
const MAX_HEADERS: usize = 64;

/// How long a browser may be silent before its request is complete.
const PATIENCE: Duration = Duration::from_secs(10);

/// How often a browser that waits for news is asked whether it is still there.
const PULSE: Duration = Duration::from_secs(10);

/// A running server.
pub(super) struct PageServer {
    address: SocketAddr,
    shown: Arc<ShownPage>,
    thread: thread::JoinHandle<()>,
}

/// The page that is shown, and those who wait for the next.
#[derive(Default)]
struct ShownPage {
    page: Mutex<ServedPage>,
    changed: Condvar,
}

/// A page and what tells it from others.
#[derive(Clone, Default)]
struct ServedPage {
    version: String,
    content: Arc<Vec<u8>>,
    /// Why there is no newer one, though there should be.
    trouble: String,
}

impl PageServer {
    /// Listens at a port of the loopback device, or at any that is free where somebody else has it.
    pub(super) fn open(port: u16) -> Result<PageServer, String> {
        let bind = |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port));
        let opened = bind(port).or_else(|why| {
            tell(&format!("port {port} is taken ({why}); another will do"));
            bind(0)
        });
        let listener = opened.map_err(|e| format!("no page can be served: {e}"))?;
        let address = listener.local_addr().map_err(|e| e.to_string())?;
        let shown = Arc::new(ShownPage::default());
        let for_all = Arc::clone(&shown);
        let thread = thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let shown = Arc::clone(&for_all);
                // A browser that goes away in the middle is no matter.
                thread::spawn(move || answer(&stream, address, &shown));
            }
        });
        Ok(PageServer {
            address,
            shown,
            thread,
        })
    }

    /// What to type into a browser.
    pub(super) fn address(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// Shows a page from now on, and has those who look at an older one load it.
    pub(super) fn show(&self, version: &str, content: Vec<u8>) {
        *self.shown.page() = ServedPage {
            version: version.to_string(),
            content: Arc::new(content),
            trouble: String::new(),
        };
        self.shown.changed.notify_all();
    }

    /// Tells those who look at the page why it is not the newest.
    pub(super) fn tell(&self, trouble: &str) {
        self.shown.page().trouble = trouble.replace(['\r', '\n'], " ");
        self.shown.changed.notify_all();
    }

    /// Whether there is a page.
    pub(super) fn is_empty(&self) -> bool {
        self.shown.page().is_empty()
    }

    /// Serves until the process is ended.
    pub(super) fn stay(self) -> u8 {
        match self.thread.join() {
            Ok(()) => CLEAN,
            Err(_) => FAILED,
        }
    }
}

impl ServedPage {
    /// Whether it is none yet.
    fn is_empty(&self) -> bool {
        self.version.is_empty()
    }

    /// Whether there is nothing to tell to somebody who knows the other.
    fn says(&self, other: &ServedPage) -> bool {
        self.version == other.version && self.trouble == other.trouble
    }
}

impl ShownPage {
    /// The page as it is now, which nobody changes meanwhile.
    fn page(&self) -> MutexGuard<'_, ServedPage> {
        self.page.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The page, once there is one: a browser may be quicker than the first conversion.
    fn first(&self) -> ServedPage {
        let shown = self.changed.wait_while(self.page(), |p| p.is_empty());
        shown.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The page, once there is something to tell of it that is not known; after a while in any case.
    fn next(&self, known: &ServedPage) -> ServedPage {
        let is_known = |page: &mut ServedPage| page.says(known);
        let waited = self
            .changed
            .wait_timeout_while(self.page(), PULSE, is_known);
        waited.unwrap_or_else(PoisonError::into_inner).0.clone()
    }
}

/// What a browser asks for.
struct Request {
    path: String,
    host: String,
}

fn answer(stream: &TcpStream, address: SocketAddr, shown: &ShownPage) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let Some(request) = read(stream)? else {
        return reply(
            stream,
            "400 Bad Request",
            "text/plain",
            b"no request for a page\n",
        );
    };
    // Names of other hosts that lead here are a way for their pages to read this one.
    let port = address.port();
    let own = [format!("{address}"), format!("localhost:{port}")];
    if !own.contains(&request.host) {
        return reply(
            stream,
            "403 Forbidden",
            "text/plain",
            b"only for this machine\n",
        );
    }
    match request.path.as_str() {
        "/" => {
            let page = shown.first();
            reply(stream, "200 OK", "text/html; charset=utf-8", &page.content)
        }
        "/events" => tell_changes(stream, shown),
        _ => reply(
            stream,
            "404 Not Found",
            "text/plain",
            b"there is only the page\n",
        ),
    }
}

/// Reads the head of a request; `None` where it is none that a browser makes for a page.
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
    let is_whole = matches!(request.parse(&head), Ok(status) if status.is_complete());
    if !is_whole || request.method != Some("GET") {
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

/// Tells a page the version of the newest, whenever there is one, as server-sent events.
fn tell_changes(mut stream: &TcpStream, shown: &ShownPage) -> io::Result<()> {
    stream.write_all(
        b"HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\n\
          Connection: close\r\n\r\n",
    )?;
    let mut known = ServedPage::default();
    loop {
        let page = shown.next(&known);
        let (version, trouble) = (&page.version, &page.trouble);
        // Of a page that has gone away only the failing write tells.
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

    /// Everything that the server says to a request.
    fn ask(server: &PageServer, head: &str) -> String {
        let mut stream = TcpStream::connect(server.address).unwrap();
        let head = head.replace("HOST", &server.address.to_string());
        stream.write_all(head.as_bytes()).unwrap();
        let mut said = String::new();
        stream.read_to_string(&mut said).unwrap();
        said
    }

    #[test]
    fn only_the_page_is_served_and_only_to_this_machine() {
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
    fn a_browser_that_comes_before_the_first_page_gets_it() {
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
        let mut said = String::new();
        stream.read_to_string(&mut said).unwrap();
        assert!(said.ends_with("\r\n\r\nhello"), "{said}");
    }

    #[test]
    fn a_page_hears_of_the_next() {
        let server = PageServer::open(0).unwrap();
        server.show("1", Vec::new());
        let mut stream = TcpStream::connect(server.address).unwrap();
        let head = format!("GET /events HTTP/1.1\r\nHost: {}\r\n\r\n", server.address);
        stream.write_all(head.as_bytes()).unwrap();
        let mut news = BufReader::new(stream).lines().map(Result::unwrap);
        let mut next = || news.find_map(|l| l.strip_prefix("data: ").map(str::to_string));
        assert_eq!(next().as_deref(), Some("1"));
        assert_eq!(next().as_deref(), Some(""));
        server.tell("there is\nno such file");
        assert_eq!(next().as_deref(), Some("there is no such file"));
        server.show("2", Vec::new());
        assert_eq!(next().as_deref(), Some("2"));
        assert_eq!(next().as_deref(), Some(""), "the trouble is over");
    }
}
