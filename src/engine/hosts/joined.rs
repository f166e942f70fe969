//! Shaders that scripts put together from several files: `program(["common.frag", "own.frag"])`.

use super::host::Hosts;
use super::webgl::context;
use crate::shader::reading::lacking;
use crate::shader::shader_input::ShaderInput;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_explain::Checked;
use shaderlint_project::{Hushed, spread};
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// Maximum number of lists that a shader is checked with.
const MAX_LISTS: usize = 4;

/// Reads a file that lacks names together with the files that a script joins to it, if it lacks less then and
/// nothing contradicts.
pub fn join(
    sources: &mut Arc<Sources>,
    part: &mut ShaderInput,
    alone: &Checked,
    hosts: &Hosts,
    hushed: &mut Hushed,
) -> Option<Checked> {
    let readings = &part.readings;
    let is_candidate = part.embedded.is_none()
        && part.host.is_none()
        && readings.holds_entry()
        && !readings.is_shadertoy()
        && lacking(alone).is_some_and(|names| !names.is_empty());
    if !is_candidate {
        return None;
    }
    let file = sources.file_id_at(sources.files().first()?.base)?;
    let text = sources.file(file)?.text.clone();
    let access = hosts.context().file_access();
    let options = hosts.context().options;
    let mut fewest = flaws(alone, file);
    let mut best = None;
    for joined in hosts.joined().iter().take(MAX_LISTS) {
        // `#version` must come first.
        if readings.has_version() && !joined.before.is_empty() {
            continue;
        }
        let mut all = sources.clone();
        let found = spread(&mut all, (hosts.name(), file, &text), joined, access)?;
        let files = (found.files, found.is_open);
        let mut with = readings.with_files(Arc::make_mut(&mut all), files, options)?;
        with.set_context(context(&all, &with, hosts, options, &[]));
        let checked = with.check(&all, part.infer_channels)?;
        let now = flaws(&checked, file);
        if now < fewest || best.is_none() && now == fewest {
            fewest = now;
            part.is_joined = joined.is_all;
            best = Some((all, with, found.missing, found.hushed, checked));
        }
    }
    let (all, with, missing, others, checked) = best?;
    (*sources, part.readings, part.missing) = (all, with, missing);
    hushed.extend(others);
    Some(checked)
}

/// The number of errors in the file itself, and of names that it lacks.
fn flaws(checked: &Checked, file: FileId) -> usize {
    let sources = &checked.program.sources;
    let is_own = |d: &&Diagnostic| sources.file_id_at(d.span.start) == Some(file);
    let all = checked.diagnostics.iter().filter(is_own);
    let errors = all.filter(|d| d.severity == Severity::Error).count();
    errors + checked.open.names.len()
}
