//! Runs targets, on a thread with the same stack size as in the programs.

use crate::compute::compute;
use crate::counting::{Asked, Counting, asked};
use crate::generate::generate;
use crate::mutate::{Random, mutate, split};
use crate::targets::{Target, Texts};
use crate::texts::seeds;
use shaderlint::cli::STACK;
use std::panic::{catch_unwind, set_hook, take_hook};
use std::path::Path;
use std::sync::{Arc, Mutex, Once};
use std::time::{Duration, Instant};
use std::{fs, thread};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A check that allocates more memory in total is a failure.
const MAX_ASKED: Asked = Asked {
    times: 50_000_000,
    bytes: 8 << 30,
};
/// A check that takes longer ends the process: it cannot be interrupted.
const HANGS: Duration = Duration::from_secs(600);
/// Maximum number of runs for minimising a failing text.
const MINIMISING: u32 = 2_000;
/// Name of the threads whose panics are reported as failures, not printed.
const THROWING: &str = "throwing";

/// How long a target is fuzzed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Length {
    /// A multiple of the target's number of texts in a round.
    Rounds(u64),
    /// Texts until the time is over.
    Time(Duration),
}

/// The current text and its start time, for the watchdog.
type Current = Arc<Mutex<(Instant, String)>>;

/// Runs a target on mutated texts until the length is reached or one fails. Returns whether all
/// passed.
pub fn fuzz(target: &Target, length: Length, seed: u64) -> bool {
    apart(|current| throw_all(target, length, seed, current))
}

/// Runs a target on the text of a file. Returns whether it passed.
pub fn throw_file(target: &Target, file: &str) -> bool {
    let text = String::from_utf8_lossy(&fs::read(file).unwrap_or_default()).into_owned();
    let failure = apart(|current| throw(target, &text, current));
    println!(
        "{} {file}: {}",
        target.name,
        failure.as_deref().unwrap_or("passed")
    );
    failure.is_none()
}

/// Runs a closure on a watched thread whose panics print nothing.
fn apart<T: Send>(act: impl FnOnce(&Current) -> T + Send) -> T {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let print = take_hook();
        set_hook(Box::new(move |panic| {
            if thread::current().name() != Some(THROWING) {
                print(panic);
            }
        }));
    });
    let current: Current = Arc::new(Mutex::new((Instant::now(), String::new())));
    watch(current.clone());
    thread::scope(|scope| {
        let builder = thread::Builder::new()
            .name(THROWING.to_string())
            .stack_size(STACK);
        let thread = builder.spawn_scoped(scope, || act(&current));
        thread.expect("a thread").join().expect("an answer")
    })
}

/// Ends the process if one text takes far too long.
fn watch(current: Current) {
    thread::spawn(move || {
        loop {
            thread::sleep(Duration::from_secs(1));
            let Ok(now) = current.lock() else { return };
            if now.0.elapsed() > HANGS && !now.1.is_empty() {
                println!(
                    "timeout for a text of {} bytes: {}",
                    now.1.len(),
                    store("hang", &now.1)
                );
                std::process::exit(1);
            }
        }
    });
}

fn throw_all(target: &Target, length: Length, seed: u64, current: &Current) -> bool {
    let seeds = seeds();
    let mut random = Random::new(seed);
    let start = Instant::now();
    let mut count = 0;
    let is_enough = |count| match length {
        Length::Rounds(rounds) => count >= rounds * target.round,
        Length::Time(time) => start.elapsed() >= time,
    };
    while !is_enough(count) {
        let text = match target.texts {
            Texts::Broken => mutate(&mut random, &seeds),
            Texts::Programs => generate(seed + count).text,
            Texts::Computing => compute(seed + count).text,
        };
        if let Some(failure) = throw(target, &text, current) {
            let small = minimise(target, &text, current);
            let path = store(target.name, &small);
            println!(
                "{} failed on text {count} of seed {seed}: {failure}\n  {} bytes in {path}",
                target.name,
                small.len()
            );
            return false;
        }
        count += 1;
    }
    println!(
        "{}: {count} texts of seed {seed} from {} shaders in {:.1} s, all passed",
        target.name,
        seeds.len(),
        start.elapsed().as_secs_f32()
    );
    true
}

/// The failure of a target on a text, if any.
fn throw(target: &Target, text: &str, current: &Current) -> Option<String> {
    if let Ok(mut now) = current.lock() {
        *now = (Instant::now(), text.to_string());
    }
    let (asked, outcome) = asked(|| catch_unwind(|| (target.run)(text)));
    if let Ok(mut now) = current.lock() {
        now.1.clear();
    }
    match outcome {
        Ok(()) if asked.times > MAX_ASKED.times || asked.bytes > MAX_ASKED.bytes => {
            Some(format!("too much memory allocated: {asked:?}"))
        }
        Ok(()) => None,
        Err(panic) => {
            let message = panic.downcast_ref::<String>().cloned();
            let plain = || panic.downcast_ref::<&str>().map(|s| s.to_string());
            Some(message.or_else(plain).unwrap_or_default())
        }
    }
}

/// Removes tokens, halves first, as long as the text still fails.
fn minimise(target: &Target, text: &str, current: &Current) -> String {
    let mut left = MINIMISING;
    let mut tokens = split(text);
    let mut size = tokens.len() / 2;
    while size > 0 {
        let mut at = 0;
        while at < tokens.len() && left > 0 {
            left -= 1;
            let mut fewer = tokens.clone();
            fewer.drain(at..(at + size).min(tokens.len()));
            match throw(target, &fewer.concat(), current) {
                Some(_) => tokens = fewer,
                None => at += size,
            }
        }
        size /= 2;
    }
    tokens.concat()
}

/// Stores a failing text and returns its path.
fn store(name: &str, text: &str) -> String {
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| {
        (h ^ b as u64).wrapping_mul(0x100_0000_01b3)
    });
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("failures");
    let path = folder.join(format!("{name}-{hash:016x}.glsl"));
    let stored = fs::create_dir_all(&folder).and_then(|()| fs::write(&path, text));
    stored.map_or_else(
        |e| format!("(not stored: {e})"),
        |()| path.display().to_string(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::targets::TARGETS;

    /// Runs one round, the same in every run; `SHADERLINT_SEED` sets another seed.
    fn answers_all(name: &str) {
        let seed = std::env::var("SHADERLINT_SEED").map_or(1, |seed| seed.parse().unwrap());
        let target = TARGETS.iter().find(|t| t.name == name).unwrap();
        assert!(
            fuzz(target, Length::Rounds(1), seed),
            "SHADERLINT_SEED={seed}"
        );
    }

    macro_rules! targets {
        ($($name:ident)*) => {
            $(
                #[test]
                fn $name() {
                    answers_all(stringify!($name));
                }
            )*

            #[test]
            fn every_target_is_tested() {
                assert_eq!(TARGETS.map(|t| t.name), [$(stringify!($name)),*]);
            }
        };
    }

    targets! { lex parse format check edit link fix port programs run draw metamorphic }
}
