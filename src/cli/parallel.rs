//! Several things done at a time, and told in their order.

use std::collections::BTreeMap;
use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// Stack of a thread that reads shaders, in bytes. What nests is bounded, so that this is enough in
/// debug builds too; what a system gives by itself differs, down to 1 MB.
pub const STACK: usize = 16 << 20;

/// How many things are done at a time.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Does the work of all numbers below `count`, and tells what came of it in their order, each as soon
/// as those before it are told.
pub fn in_order<T: Send>(
    count: usize,
    work: &(impl Fn(usize) -> T + Sync),
    tell: &mut impl FnMut(T) -> io::Result<()>,
) -> io::Result<()> {
    let threads = threads().min(count);
    if threads <= 1 {
        return (0..count).try_for_each(|number| tell(work(number)));
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
                tell(done)?;
                due += 1;
            }
        }
        Ok(())
    })
}
