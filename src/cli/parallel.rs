//! Runs work in parallel and delivers the results in order.

use std::collections::BTreeMap;
use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// Stack size in bytes of threads that parse shaders. Nesting is limited, so this suffices in debug
/// builds too; system defaults are as low as 1 MB.
pub const STACK: usize = 16 << 20;

/// Number of threads.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Runs `work` for all numbers below `count`, and passes each result to `deliver` in order, as soon as
/// the results before it were passed.
pub fn in_order<T: Send>(
    count: usize,
    work: &(impl Fn(usize) -> T + Sync),
    deliver: &mut impl FnMut(T) -> io::Result<()>,
) -> io::Result<()> {
    let threads = threads().min(count);
    if threads <= 1 {
        return (0..count).try_for_each(|number| deliver(work(number)));
    }
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::sync_channel(threads * 4);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let (next, sender) = (&next, sender.clone());
            let work = move || {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= count || sender.send((number, work(number))).is_err() {
                        return;
                    }
                }
            };
            let builder = std::thread::Builder::new().stack_size(STACK);
            builder.spawn_scoped(scope, work)?;
        }
        drop(sender);
        let mut waiting = BTreeMap::new();
        let mut due = 0;
        for (number, done) in receiver {
            waiting.insert(number, done);
            while let Some(done) = waiting.remove(&due) {
                deliver(done)?;
                due += 1;
            }
        }
        Ok(())
    })
}
