//! Complete shaders, which are translated by naga as they are, whatever their uniforms mean.

use super::args::PortArgs;
use super::read::read_text;
use super::report::report;
use super::save::OutputPlace;
use crate::cli::command::{CLEAN, FINDINGS};
use crate::port::{CompleteShaders, File, complete_shaders, translate_shaders};
use crate::semantic::Stage;
use crate::text::path::slashed;
use std::path::PathBuf;

/// The complete shaders that the arguments name; `None` if a target other than naga's is requested,
/// or options require a project.
pub(super) fn load(args: &PortArgs) -> Result<Option<CompleteShaders>, String> {
    let is_asked = args.repair || args.diff || args.source.host.is_some();
    let is_plain = args.pass.is_empty() && args.source.channels.is_empty() && !is_asked;
    // Only regular files can be read twice.
    let are_files = args.input.iter().all(|path: &PathBuf| path.is_file());
    if args.target()?.language().is_none() || !is_plain || !are_files {
        return Ok(None);
    }
    let mut files = Vec::new();
    for path in &args.input {
        let stage = match path.extension().and_then(|e| e.to_str()) {
            Some("vert" | "vs" | "vsh") => Some(Stage::Vertex),
            Some("frag" | "fs" | "fsh") => Some(Stage::Fragment),
            _ => None,
        };
        files.push((slashed(path), read_text(path)?, stage));
    }
    Ok(complete_shaders(files).filter(|all| !all.shaders.is_empty()))
}

/// Translates the shaders. Returns the files and the exit code.
pub(super) fn build_output(
    args: &PortArgs,
    all: &CompleteShaders,
) -> Result<(Vec<File>, u8), String> {
    let target = args.target()?;
    let name = all.shaders.first().map_or("", |s| &s.path);
    let place = OutputPlace::of(args.request.output.as_deref(), target, name);
    let order = args.order(target, place.output(), None, None);
    let made = translate_shaders(order, all).map_err(|e| e.to_string())?;
    let found = all.shaders.iter().flat_map(|s| &s.checked.diagnostics);
    let summary = report(&all.sources, found, &made.remarks).map_err(|e| e.to_string())?;
    Ok(match summary.errors {
        0 => (made.files, CLEAN),
        _ => (Vec::new(), FINDINGS),
    })
}
