//! How a text was interpreted.

use shaderlint_engine::{Completeness, Options, Report, Shader};
use shaderlint_host::shadertoy;
use shaderlint_lint::SkippedRules;
use shaderlint_project::{Files, Recognised, open_file};
use shaderlint_report::ReadAs;
use shaderlint_semantic::Stage;

/// Maximum number of names listed for one shader.
const MAX_NAMES: usize = 20;

/// Which files are parsed again to detect their host.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Recognition {
    /// All files.
    Always,
    /// Only files whose shaders a host composes: detection takes as long as checking.
    WhereComposed,
    /// None: the user names the host.
    Never,
}

/// How one file was interpreted.
pub fn reading(
    name: &str,
    report: &Report,
    (options, files): (&Options, &dyn Files),
    recognition: Recognition,
) -> ReadAs {
    let shaders = match report.shaders.as_slice() {
        [] => match report.language {
            Some(language) => format!("not checked: {}", language.shader()),
            None => "no shader".to_string(),
        },
        all => {
            let text = all.iter().map(|s| describe(s, report));
            let mut lines: Vec<(String, usize)> = Vec::new();
            // A page or a document may contain many shaders of the same kind.
            for line in text {
                match lines.iter_mut().find(|(l, _)| *l == line) {
                    Some((_, count)) => *count += 1,
                    None => lines.push((line, 1)),
                }
            }
            let lines = lines.into_iter().map(|(line, count)| match count {
                1 => line,
                n => format!("{n} x {line}"),
            });
            lines.collect::<Vec<_>>().join("; ")
        }
    };
    let is_asked = match recognition {
        Recognition::Always => true,
        Recognition::WhereComposed => report.shaders.iter().any(|s| s.host.is_some()),
        Recognition::Never => false,
    };
    let shown = is_asked
        .then(|| recognised(name, report, options, files))
        .flatten();
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
        let given = options.host.preset.map(|p| p.name);
        let shown = shown.map(|found| found.host.name);
        hosts.extend(given.filter(|name| !name.is_empty()).or(shown));
    }
    hosts.dedup();
    ReadAs {
        hosts: hosts.into_iter().map(str::to_string).collect(),
        read_as,
    }
}

/// The host of a shader file and the signs that show it. `None` for ShaderToy shaders, which are
/// described by their passes.
fn recognised(
    name: &str,
    report: &Report,
    options: &Options,
    files: &dyn Files,
) -> Option<Recognised> {
    let file = report.file.and_then(|id| report.sources.file(id))?;
    if report.holds_shaders() || report.shaders.is_empty() {
        return None;
    }
    let opened = open_file(name, &file.text, None, options.file_access(files)).ok()?;
    opened.project.recognised.filter(|found| !found.is_player())
}

/// How one shader was interpreted, and where rules were skipped.
fn describe(shader: &Shader, report: &Report) -> String {
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
    let skipped = match (shader.completeness, &shader.skipped) {
        (_, SkippedRules::Nowhere) => String::new(),
        (_, SkippedRules::Functions { names, .. }) if names.is_empty() => String::new(),
        (completeness, SkippedRules::Functions { names, .. }) => {
            let cause = match completeness {
                Completeness::Complete => "because of errors",
                _ => "because of errors or unknown names",
            };
            format!(", rules skipped `{}` {cause}", names.join("`, `"))
        }
        (Completeness::Excerpt, SkippedRules::Everywhere) => ", excerpt: rules skipped".to_string(),
        (Completeness::Chunk | Completeness::Piece, SkippedRules::Everywhere) => {
            ", incomplete: rules skipped".to_string()
        }
        (Completeness::Complete, SkippedRules::Everywhere) => {
            ", rules skipped because of errors".to_string()
        }
    };
    // For a file that is one shader, `recognised` already names the host.
    let host = shader
        .host
        .filter(|_| report.holds_shaders() || report.file.is_none());
    let host = host.map_or(String::new(), |h| format!("{}: ", h.read_as()));
    format!("{host}{kind}{part}{skipped}{}", completed(shader))
}

/// For a shader fragment: its hosts, the release of its chunks, the names they declare, and missing includes.
fn completed(shader: &Shader) -> String {
    let mut text = String::new();
    if !shader.hosts.is_empty() {
        text.push_str(&format!(", for {}", shader.hosts.join(" or ")));
    }
    if let Some(release) = shader.release {
        text.push_str(&format!(", chunks of r{release}"));
    }
    let names = &shader.holes;
    if !names.is_empty() {
        let first: Vec<&str> = names.iter().map(String::as_str).take(MAX_NAMES).collect();
        let more = match names.len().saturating_sub(MAX_NAMES) {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        text.push_str(&format!(
            ", names from the host: `{}`{more}",
            first.join("`, `")
        ));
    }
    for missing in &shader.missing {
        let places = missing.looked_in.join(", ");
        text.push_str(&format!(", `{}` {}", missing.path, missing.why));
        if !places.is_empty() {
            text.push_str(&format!(" (searched in {places})"));
        }
    }
    text
}
