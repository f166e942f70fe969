//! The repeated texts for measuring growth: the patterns in `repetitions.txt`, one per line, and
//! every example of every page.

use shaderlint::cli::STACK;
use shaderlint::engine::{DialectChoice, Options, check};
use shaderlint::lint::sample::SampleLimit;
use shaderlint::lint::{FenceKind, Page, Settings};
use shaderlint::project::NoFiles;
use shaderlint::report::{Format, Reporter};
use shaderlint::rules::RULES;
use std::fs;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Maximum number of printed findings per text.
const MAX_PRINTED: usize = 20;

/// The kind of a pattern, and its text.
pub type Pattern = (String, String);

/// A file name, and the text of the file.
pub type Input = (String, String);

/// The patterns of `repetitions.txt`.
pub fn listed() -> Vec<Pattern> {
    let patterns = include_str!("repetitions.txt").lines().filter_map(|line| {
        let (kind, pattern) = line.split_once(' ')?;
        let is_pattern = pattern.contains('«') && kind != "#";
        is_pattern.then(|| (kind.to_string(), pattern.to_string()))
    });
    let patterns: Vec<Pattern> = patterns.collect();
    assert!(patterns.len() > 900, "{} patterns", patterns.len());
    patterns
}

/// The examples of the pages as patterns.
pub fn examples() -> Vec<Pattern> {
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
                // Once unchanged, and once as functions with other names, so that rules run.
                patterns.push((kind.to_string(), format!("«{code}»")));
                let renamed = code.replace('(', "№(").replace("mainImage№(", "mainImage(");
                patterns.push((kind.to_string(), format!("«{renamed}»")));
            }
        }
    }
    assert!(patterns.len() > 200, "{} examples", patterns.len());
    patterns
}

/// The text before and after the repetitions of a kind, and the file name for it.
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
        extension => (format!("a.{extension}"), "", ""),
    }
}

/// A file name, and a text of about `size` bytes that repeats the marked part of a pattern.
pub fn repeat(kind: &str, pattern: &str, size: usize) -> Input {
    let pattern = pattern.replace('↵', "\n");
    let segments: Vec<&str> = pattern.split(['«', '»']).collect();
    let marked = || segments.iter().skip(1).step_by(2);
    let length: usize = marked().map(|s| s.len() + 2 * s.matches('№').count()).sum();
    let count = size / length.max(1) + 1;
    let (name, before, after) = frame(kind);
    let mut text = before.to_string();
    for (i, segment) in segments.iter().enumerate() {
        match i % 2 {
            0 => text.push_str(segment),
            _ => (0..count).for_each(|n| text.push_str(&segment.replace('№', &n.to_string()))),
        }
    }
    (name, text + after)
}

/// Checks a text and prints the findings.
pub fn report((name, text): &Input, options: &Options) {
    let mut found = check(name, text, options, &NoFiles);
    if found.unread.is_some() {
        return;
    }
    found.diagnostics.truncate(MAX_PRINTED);
    for format in [Format::Human, Format::Sarif] {
        let mut reporter = Reporter::new(format, std::io::sink(), false);
        let printed = reporter.file(name, &found.sources, &found.diagnostics);
        printed.unwrap();
        reporter.finish().unwrap();
    }
}

/// Calls `grows` for every pattern, repeated to `size` bytes and to an eighth of that, on all
/// cores; returns the problems that it reports. Shaders run within `limit`.
pub fn grown(
    patterns: &[Pattern],
    size: usize,
    limit: SampleLimit,
    grows: impl Fn(&[Input; 2], &Options) -> Option<String> + Sync,
) -> Vec<String> {
    let mut settings = Settings::new(RULES, &["all".to_string()], &[]).unwrap();
    settings.set_sample_limit(limit);
    let options = Options::new(DialectChoice::Auto, settings);
    let (next, problems) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let one_after_the_other = || {
        while let Some((kind, pattern)) = patterns.get(next.fetch_add(1, Ordering::Relaxed)) {
            let texts = [size / 8, size].map(|size| repeat(kind, pattern, size));
            if let Some(problem) = grows(&texts, &options) {
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
    problems.into_inner().unwrap()
}
