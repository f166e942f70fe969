//! The request `port`.

use super::result::RequestResult;
use serde::Deserialize;
use serde_json::json;
use shaderlint_diagnostic::Severity;
use shaderlint_port::naga::FirstRow;
use shaderlint_port::{Destination, MainChoice, Order, Project, Target};
use shaderlint_port::{add_stand_ins, build};
use shaderlint_text::kind::{Claim, FileKind, decide};
use std::path::Path;

/// A shader or export, and what it is ported to.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PortRequest {
    /// Name of the file.
    name: String,
    /// Contents of the file.
    text: String,
    /// Path of the output; its extension selects the target.
    output: String,
}

/// `port`: the files as text, errors and remarks. Binary files, as SPIR-V, have no text.
pub fn port(request: &PortRequest) -> RequestResult {
    let PortRequest { name, text, output } = request;
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let title = Path::new(name).file_stem().unwrap_or_default();
    let is_export = decide(name, text, Claim::None).kind == FileKind::Export;
    let mut project = match is_export {
        true => Project::from_json(text).map_err(|e| wrong(&e))?,
        false => Project::from_shader(&title.to_string_lossy(), text).map_err(|e| wrong(&e))?,
    };
    let composed = project.resolve(name).map_err(|e| wrong(&e))?;
    add_stand_ins(&mut project);
    let composed = project.renew(composed, name).map_err(|e| wrong(&e))?;
    let order = Order {
        target: Target::of_path(Path::new(output)).map_err(|e| format!("{output}: {e}"))?,
        main: MainChoice::default(),
        output: Destination::File(Path::new(output)),
        interface: false,
        first_row: FirstRow::default(),
        version: None,
    };
    let made = build(&project, &composed, order).map_err(|e| wrong(&e))?;
    let found = composed.units.iter().map(|unit| composed.analysis(unit));
    let found = found.flat_map(|analysis| &analysis.diagnostics);
    let errors = found.filter(|d| d.severity == Severity::Error).count();
    let files = made.files.into_iter().map(|file| {
        json!({ "path": file.path.to_string_lossy(), "text": String::from_utf8(file.content).ok() })
    });
    let remarks = made
        .remarks
        .iter()
        .map(|remark| remark.diagnostic().message);
    Ok(json!({
        "files": files.collect::<Vec<_>>(),
        "errors": errors,
        "remarks": remarks.collect::<Vec<_>>(),
    }))
}
