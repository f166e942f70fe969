//! Repetitions: whatever is repeated, twice as much of it is at most about twice the work.
//!
//! `repetitions.txt` holds what is repeated, one a line; besides, every example of every page is.

use super::Verdict::Refused;
use super::judge;
use shaderlint::cli::STACK;
use shaderlint::engine::{DialectChoice, NoFiles, Options, check};
use shaderlint::lint::{FenceKind, Page, Settings};
use shaderlint::report::{Format, Reporter};
use shaderlint::rules::RULES;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// Bytes of the larger text; the smaller is an eighth of it. `SHADERLINT_REPEATED` sets another: the
/// larger, the milder a square is seen.
const SIZE: usize = 12_000;
/// Most that the work on the larger text may be, in times the work on the smaller done eight times:
/// once is in line, eight times with the square.
const MAX_GROWTH: u32 = 2;
/// Work that is too little to be measured, whatever it is a multiple of.
const NEGLIGIBLE: Duration = Duration::from_millis(30);
/// How many findings of a text are printed.
const MAX_PRINTED: usize = 20;
/// How often the work is measured before it counts as too much.
const TRIES: usize = 5;

/// What stands around a text of one kind, and the name of a file that holds it.
fn frame(kind: &str) -> (String, &'static str, &'static str) {
    const MAIN: &str = "void mainImage(out vec4 o, in vec2 p) { o = vec4(p, 0.0, 1.0); }\n";
    const BODY: &str = "void mainImage(out vec4 o, in vec2 p) { float x = p.x; int n = int(p.y); \
        vec3 v = vec3(x); o = vec4(x);\n";
    match kind {
        "pass" => ("a.glsl".to_string(), "", MAIN),
        "body" => ("a.glsl".to_string(), BODY, "\n}\n"),
        "frag" => (
            "a.frag".to_string(),
            "#version 300 es\nprecision highp float;\n",
            "",
        ),
        "vert" => ("a.vert".to_string(), "#version 300 es\n", ""),
        "old" => ("a.frag".to_string(), "precision mediump float;\n", ""),
        ending => (format!("a.{ending}"), "", ""),
    }
}

/// A text that repeats what a pattern marks until it has about so many bytes, and a file's name.
fn repeat(kind: &str, pattern: &str, size: usize) -> (String, String) {
    let pattern = pattern.replace('↵', "\n");
    let segments: Vec<&str> = pattern.split(['«', '»']).collect();
    let marked = || segments.iter().skip(1).step_by(2);
    let length: usize = marked().map(|s| s.len() + 2 * s.matches('№').count()).sum();
    let count = size / length.max(1) + 1;
    let (name, before, behind) = frame(kind);
    let mut text = before.to_string();
    for (i, segment) in segments.iter().enumerate() {
        match i % 2 {
            0 => text.push_str(segment),
            _ => (0..count).for_each(|n| text.push_str(&segment.replace('№', &n.to_string()))),
        }
    }
    (name, text + behind)
}

/// What this thread has worked so far: the time that it had a processor, where the system tells,
/// so that it counts nothing what else the machine does.
fn worked() -> Option<Duration> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds = text.split(' ').next()?.parse().ok()?;
    Some(Duration::from_nanos(nanoseconds))
}

/// The work of checking a text and printing what is found.
fn work((name, text): &(String, String), options: &Options) -> Duration {
    let (before, start) = (worked(), Instant::now());
    let mut found = check(name, text, options, &NoFiles);
    if found.unread.is_none() {
        found.diagnostics.truncate(MAX_PRINTED);
        for format in [Format::Human, Format::Sarif] {
            let mut reporter = Reporter::new(format, std::io::sink(), false);
            reporter
                .file(name, &found.sources, &found.diagnostics)
                .unwrap();
            reporter.finish().unwrap();
        }
    }
    match (before, worked()) {
        (Some(before), Some(now)) => now.saturating_sub(before),
        _ => start.elapsed(),
    }
}

/// Whether the work on a repetition grows in line with its length; else by how much it grows.
fn growth(texts: &[(String, String); 2], options: &Options) -> Result<(), String> {
    let [mut small, mut large] = [Duration::MAX; 2];
    for _ in 0..TRIES {
        large = large.min(work(&texts[1], options));
        if large <= NEGLIGIBLE {
            return Ok(());
        }
        // The system tells in steps of some milliseconds.
        small = small.min((0..8).map(|_| work(&texts[0], options)).sum());
        if large <= small * MAX_GROWTH + NEGLIGIBLE {
            return Ok(());
        }
    }
    Err(format!("{small:?} became {large:?}"))
}

/// Checks that the work on every pattern grows in line, on as many threads as there are.
fn all_grow_in_line(patterns: &[(String, String)]) {
    let settings = Settings::new(RULES, &["all".to_string()], &[]).unwrap();
    let options = Options::new(DialectChoice::Auto, settings);
    let size = std::env::var("SHADERLINT_REPEATED").ok();
    let size = size.and_then(|s| s.parse().ok()).unwrap_or(SIZE);
    let next = std::sync::atomic::AtomicUsize::new(0);
    let problems = std::sync::Mutex::new(Vec::new());
    let one_after_the_other = || {
        while let Some((kind, pattern)) =
            patterns.get(next.fetch_add(1, std::sync::atomic::Ordering::Relaxed))
        {
            let texts = [size / 8, size].map(|size| repeat(kind, pattern, size));
            if let Err(problem) = growth(&texts, &options) {
                let line = format!("{kind} {pattern}: {problem}");
                problems.lock().unwrap().push(line);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            let builder = std::thread::Builder::new().stack_size(STACK);
            builder.spawn_scoped(scope, one_after_the_other).unwrap();
        }
    });
    let problems = problems.into_inner().unwrap();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn repetitions_are_read_in_line() {
    let patterns = include_str!("repetitions.txt").lines().filter_map(|line| {
        let (kind, pattern) = line.split_once(' ')?;
        let is_pattern = pattern.contains('«') && kind != "#";
        is_pattern.then(|| (kind.to_string(), pattern.to_string()))
    });
    let patterns: Vec<(String, String)> = patterns.collect();
    assert!(patterns.len() > 900, "{} patterns", patterns.len());
    all_grow_in_line(&patterns);
}

#[test]
fn examples_are_read_in_line() {
    let rules = Path::new(env!("CARGO_MANIFEST_DIR")).join("rules");
    let mut patterns = Vec::new();
    for folder in [rules.join("errors"), rules] {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|e| e != "md") || path.ends_with("README.md") {
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let page = Page::new(&text);
            let examples = page.fences.iter().filter(|f| f.kind == FenceKind::Bad);
            for fence in examples {
                let kind = fence.file.rsplit('.').next().unwrap_or("glsl");
                let code = &text[fence.range.clone()];
                // Once as they are, and once as functions of other names, so that rules run.
                patterns.push((kind.to_string(), format!("«{code}»")));
                let renamed = code.replace('(', "№(").replace("mainImage№(", "mainImage(");
                patterns.push((kind.to_string(), format!("«{renamed}»")));
            }
        }
    }
    assert!(patterns.len() > 200, "{} examples", patterns.len());
    all_grow_in_line(&patterns);
}

#[test]
fn a_tower_of_calls_is_read_where_it_stands() {
    let pattern = "#define F(x) x↵float f(float a) { return «F(»a«)»; }";
    judge(&repeat("pass", pattern, 1_000_000).1, Refused);
}
