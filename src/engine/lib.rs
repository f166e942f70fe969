//! The linting engine: checks the text of a file and returns findings.
//!
//! A text is a complete shader or a shader fragment, which a host completes. The engine resolves
//! includes, containers (pages, scripts, exports) and configurations, so that front ends only read
//! files and print findings.
#![cfg_attr(test, allow(clippy::string_slice))]

mod analysis;
mod assumption;
mod check;
mod check_context;
pub mod config;
mod document;
mod embedded;
mod export;
mod file_cache;
mod files;
mod fix;
mod foreign;
mod format;
mod group;
mod host;
mod hosted;
mod inactive;
mod include;
mod input;
pub mod inputs;
mod leading_blanks;
mod look;
mod modernize;
mod offer;
mod options;
mod partner;
mod place;
mod prelude;
mod reading;
mod repair;
mod repository;
mod required;
mod shader;
mod shader_input;
mod typo;
mod unknown;
mod upgrade;
mod verify;
mod version;

pub use analysis::Analysis;
pub use document::{Report, Unread};
pub use file_cache::FileCache;
pub use files::{Dependency, FileType, Files, LoadError, MAX_LOADED, NoFiles};
pub use fix::fix_text;
pub use format::{Formatting, format};
pub use include::{Absence, FileMoves, MissingInclude, moved_includes};
pub use modernize::modernize;
pub use offer::Offer;
pub use options::{Desktop, DialectChoice, HostNames, HostUniform, Includes, Options};
pub use partner::program_name;
pub use repair::{Repairs, repair, repairable};
pub use shader_input::Shader;
pub use shaderlint_semantic::Completeness;
pub use verify::{Original, Verified, equal, verify};

use check_context::{CheckContext, Keep};
use shaderlint_text::{Content, Encoding};

/// Checks a text. `name` is its path: the extension selects the kind of file, and includes are
/// resolved in its folder.
///
/// ```
/// use shaderlint_engine::{NoFiles, Options, check};
///
/// let text = "void mainImage(out vec4 color, in vec2 place) {\n    color = vec3(1.0);\n}\n";
/// let report = check("image.glsl", text, &Options::default(), &NoFiles);
/// let [finding] = &report.diagnostics[..] else {
///     panic!("one finding")
/// };
/// assert_eq!(finding.rule, "vector-size");
/// let file = report.sources.file_at(finding.span.start).unwrap();
/// assert_eq!(file.position(finding.span.start).line, 2);
/// ```
pub fn check(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let context = CheckContext::new(options, files);
    document::check_text(name, text, Encoding::Utf8, context)
}

/// Checks the decoded bytes of a file. The encoding may be a finding.
pub fn check_content(
    name: &str,
    content: &Content,
    options: &Options,
    files: &dyn Files,
) -> Report {
    let context = CheckContext::new(options, files);
    document::check_text(name, &content.text, content.encoding, context)
}

/// Checks a text and keeps the analyses of its shaders in [`Report::analyses`].
pub fn analyze(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let context = CheckContext {
        keep: Keep::Programs,
        ..CheckContext::new(options, files)
    };
    document::check_text(name, text, Encoding::Utf8, context)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::path::PathBuf;
    use std::sync::Arc;

    #[test]
    fn includes_are_read_from_an_in_memory_file_map() {
        let shader = "#version 300 es\nprecision highp float;\n#include \"lib/noise.glsl\"\n\
            out vec4 color;\nvoid main() { color = vec4(noise(2.0)); }\n";
        let noise = "float noise(float x) { return fract(sin(x)); }\n";
        let noise: (PathBuf, Arc<str>) = ("/lib/noise.glsl".into(), noise.into());
        let files = BTreeMap::from([noise]);
        let report = analyze("a.frag", shader, &Options::default(), &files);
        assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
        let [analysis] = &report.analyses[..] else {
            panic!("one shader")
        };
        assert!(!analysis.has_errors && analysis.completeness == Completeness::Complete);
        assert!(!analysis.module().functions.is_empty());
        let alone = check("a.frag", shader, &Options::default(), &NoFiles);
        assert_eq!(alone.shaders[0].missing[0].path, "lib/noise.glsl");
        assert!(alone.analyses.is_empty());
    }
}
