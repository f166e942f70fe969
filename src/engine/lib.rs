//! The linting engine: checks the text of a file and returns findings.
//!
//! A text is a complete shader or a shader fragment, which a host completes. The engine resolves
//! includes, containers (pages, scripts, exports) and configurations, so that front ends only read
//! files and print findings.
#![cfg_attr(test, allow(clippy::string_slice))]

mod check;
mod check_context;
pub mod config;
mod contracts;
mod findings;
mod fix;
mod hosts;
pub mod inputs;
mod options;
mod repair;
mod scripted;
mod shader;
mod text;

pub use check::{analyze, check, check_content};
pub use contracts::{contracts, known_contracts};
pub use findings::report::Report;
pub use fix::fix_text::fix_text;
pub use fix::format::{Formatting, format};
pub use fix::modernize::modernize;
pub use fix::offer::Offer;
pub use fix::verify::{Original, Verified, equal, verify};
pub use options::{Desktop, DialectChoice, HostNames, HostUniform, Options};
pub use repair::{Repairs, repair, repairable};
pub use scripted::{ScriptedValue, scripted, set_from_scripts};
pub use shader::analysis::Analysis;
pub use shader::shader_input::Shader;
pub use shaderlint_semantic::Completeness;
pub use text::split::Unread;
pub use text::stage_name::program_name;

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_project::NoFiles;
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
