//! The process of the client, which the server does not outlive.

use serde_json::Value;
use std::thread;
use std::time::Duration;

/// Time between two looks at the process.
const PAUSE: Duration = Duration::from_secs(2);

/// Calls `ended` when the process ends that the parameters of `initialize` name. Where the input
/// stays open, because another process holds it, nothing else would tell.
pub fn watch(params: &Value, ended: impl FnOnce() + Send + 'static) {
    let id = params.get("processId").and_then(Value::as_i64);
    let id = id.and_then(|id| i32::try_from(id).ok());
    let Some(id) = id.filter(|_| cfg!(unix)) else {
        return;
    };
    let watcher = thread::Builder::new().name("parent".to_string());
    // Without the thread, the end of the input still ends the server.
    let _ = watcher.spawn(move || {
        while is_alive(id) {
            thread::sleep(PAUSE);
        }
        ended();
    });
}

/// Whether a process exists.
#[cfg(unix)]
pub fn is_alive(id: i32) -> bool {
    use rustix::io::Errno;
    use rustix::process::{Pid, test_kill_process};
    // A process of another user exists, too.
    Pid::from_raw(id).is_some_and(|id| test_kill_process(id) != Err(Errno::SRCH))
}

/// Whether a process exists; where it is unknown, it counts as alive.
#[cfg(not(unix))]
pub fn is_alive(_: i32) -> bool {
    true
}
