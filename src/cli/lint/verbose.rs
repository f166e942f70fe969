//! `-v`: what each file was read as, with which configuration, and what was passed over.

use super::super::command::complain;
use super::super::config::Configs;
use super::super::input::{InputFile, PassedOver};
use crate::engine::{Report, Shader, Wholeness};
use crate::host::shadertoy;
use crate::lint::{Proof, Unrun};
use crate::port::{Clues, Recognised, TextsBeside, recognise};
use crate::report::ReadAs;
use crate::semantic::Stage;
use std::path::Path;

/// Most names that are told of one shader.
const MAX_NAMES: usize = 20;

/// What one file was read as, and the configuration for it.
pub fn read(input: &InputFile, report: &Report, configs: &Configs) -> String {
    let here = std::env::current_dir().unwrap_or_default();
    let config = match configs.file_of(Path::new(&input.name)) {
        Some(file) => format!("{}", file.strip_prefix(&here).unwrap_or(&file).display()),
        None => "no configuration".to_string(),
    };
    let told = reading(&input.name, report, configs, Recognition::Always).read_as;
    format!("{}: read as {told}; {config}", input.name)
}

/// Which files are looked at once more to tell who runs them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Recognition {
    /// All.
    Always,
    /// Those that were checked as what their host makes of them: it takes as long as checking.
    WhereComposed,
}

/// What one file was read as.
pub fn reading(name: &str, report: &Report, configs: &Configs, recognition: Recognition) -> ReadAs {
    let shaders = match report.shaders.as_slice() {
        [] => "no shader".to_string(),
        all => {
            let told = all.iter().map(|s| told(s, report));
            let mut lines: Vec<(String, usize)> = Vec::new();
            // A page or a text may hold many of a kind.
            for line in told {
                match lines.iter_mut().find(|(l, _)| *l == line) {
                    Some((_, count)) => *count += 1,
                    None => lines.push((line, 1)),
                }
            }
            let lines = lines.into_iter().map(|(line, count)| match count {
                1 => line,
                n => format!("{n} times {line}"),
            });
            lines.collect::<Vec<_>>().join("; ")
        }
    };
    let is_composed = report.shaders.iter().any(|s| s.host.is_some());
    let is_asked = recognition == Recognition::Always || is_composed;
    let is_asked = is_asked && !configs.names_host();
    let shown = is_asked.then(|| recognised(name, report)).flatten();
    let read_as = match &shown {
        Some(found) => format!("{}: {shaders}", found.title_and_signs()),
        None => shaders,
    };
    let runs = |s: &Shader| match s.dialect.is_shadertoy() {
        true => shadertoy().map(|p| p.name),
        false => s.host.map(|p| p.name),
    };
    let mut hosts: Vec<&str> = report.shaders.iter().filter_map(runs).collect();
    if hosts.is_empty() {
        let given = configs.options(Path::new(name)).ok();
        let given = given.and_then(|o| o.host.preset.map(|p| p.name));
        let shown = shown.map(|found| found.host.name);
        hosts.extend(given.filter(|name| !name.is_empty()).or(shown));
    }
    hosts.dedup();
    ReadAs { hosts, read_as }
}

/// Who runs a shader file, and what shows it, as `shaderport` tells it. What ShaderToy's player runs
/// is told by its passes.
fn recognised(name: &str, report: &Report) -> Option<Recognised> {
    let file = report.file.and_then(|id| report.sources.file(id))?;
    if report.holds_shaders() || report.shaders.is_empty() {
        return None;
    }
    let title = Path::new(name).file_stem()?.to_string_lossy();
    let nothing = TextsBeside::new();
    let found = recognise(&Clues::beside(&file.text, &title, &nothing))?;
    (!found.signs.is_empty() && !found.is_player()).then_some(found)
}

/// What one shader was read as, and where rules did not look.
fn told(shader: &Shader, report: &Report) -> String {
    let file = shader.file.and_then(|id| report.sources.file(id));
    let stage = match shader.stage {
        Stage::Vertex => "vertex shader",
        Stage::Fragment => "fragment shader",
    };
    let kind = match shader.dialect.host().runs {
        Some(runs) => runs.to_string(),
        None => format!("{stage}, {}", shader.version.profile().name),
    };
    let part = file.and_then(|f| f.part.as_deref());
    let part = part.map_or(String::new(), |p| format!(" ({p})"));
    let unrun = match (shader.wholeness, &shader.unrun) {
        (_, Unrun::Nowhere) => String::new(),
        (_, Unrun::Functions { names, .. }) => format!(
            ", rules not run in `{}` for their errors",
            names.join("`, `")
        ),
        (Wholeness::Excerpt, Unrun::Everywhere) => ", an excerpt: rules not run".to_string(),
        (Wholeness::Part | Wholeness::Piece, Unrun::Everywhere) => {
            ", parts of which are elsewhere: rules not run".to_string()
        }
        (Wholeness::Whole, Unrun::Everywhere) => ", rules not run for its errors".to_string(),
    };
    // Of a file that is a shader its line begins with that.
    let host = shader.host.filter(|_| report.holds_shaders());
    let host = host.map_or(String::new(), |h| format!("{}: ", h.read_as()));
    format!("{host}{kind}{part}{unrun}{}", completed(shader))
}

/// Of a part: who completes it, and what it lacks.
fn completed(shader: &Shader) -> String {
    let mut told = String::new();
    if !shader.hosts.is_empty() {
        told.push_str(&format!(", for {}", shader.hosts.join(" or ")));
    }
    let names = &shader.holes;
    if !names.is_empty() {
        let first: Vec<&str> = names.iter().map(String::as_str).take(MAX_NAMES).collect();
        let more = match names.len().saturating_sub(MAX_NAMES) {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        told.push_str(&format!(", which declares `{}`{more}", first.join("`, `")));
    }
    for missing in &shader.missing {
        let places = missing.looked_in.join(", ");
        told.push_str(&format!(", `{}` {}", missing.path, missing.why));
        if !places.is_empty() {
            told.push_str(&format!(" (looked in {places})"));
        }
    }
    told
}

/// How it is known that what was fixed keeps the picture; nothing where nothing was fixed.
pub fn proofs(proofs: &[Proof]) -> Option<String> {
    let ways = [
        (Proof::SameCode, "by the same code"),
        (Proof::SameBits, "by the same bits wherever it was looked"),
        (Proof::Unknown, "not drawn to be compared"),
    ];
    let counts = ways.map(|(way, words)| (proofs.iter().filter(|p| **p == way).count(), words));
    let told = counts.iter().filter(|(count, _)| *count > 0);
    let told = told.map(|(count, words)| format!("{count} {words}"));
    (!proofs.is_empty()).then(|| format!("fixed: {}", told.collect::<Vec<_>>().join(", ")))
}

/// What folders hold that was not looked at.
pub fn passed_over(passed: &PassedOver) {
    for path in &passed.excluded {
        complain(&format!("{path}: skipped: the configuration leaves it out"));
    }
    for path in &passed.folders {
        complain(&format!("{path}: skipped: a folder that programs fill"));
    }
    for (path, reason) in &passed.made {
        complain(&format!("{path}: skipped: {reason}"));
    }
    if passed.others > 0 {
        let noun = if passed.others == 1 { "file" } else { "files" };
        let endings: Vec<&str> = passed.endings.iter().map(String::as_str).collect();
        complain(&format!(
            "{} {noun} skipped for the ending of the name ({}), besides what .gitignore names",
            passed.others,
            endings.join(", ")
        ));
    }
}
