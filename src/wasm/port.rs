//! The requests about ports.

use super::result::RequestResult;
use serde::Deserialize;
use serde_json::json;
use shaderlint_diagnostic::Severity;
use shaderlint_engine::config::{Selection, options};
use shaderlint_engine::{Analysis, NoFiles, analyze};
use shaderlint_ide::{FrameCost, frame_cost};
use shaderlint_port::naga::FirstRow;
use shaderlint_port::{Composed, Destination, MainChoice, Order, Project, Target};
use shaderlint_port::{add_stand_ins, build, player_data as data_of};
use shaderlint_semantic::{Dialect, Pass};
use shaderlint_text::kind::{Claim, FileKind, decide};
use std::path::Path;

/// A shader or export.
#[derive(Deserialize)]
pub struct ShaderText {
    /// Name of the file.
    name: String,
    /// Contents of the file.
    text: String,
}

/// A shader or export, and what it is ported to.
#[derive(Deserialize)]
pub struct PortRequest {
    #[serde(flatten)]
    shader: ShaderText,
    /// Path of the output; its extension selects the target.
    output: String,
}

/// The passes of a shader, with stand-ins for media that only ShaderToy has.
fn load(ShaderText { name, text }: &ShaderText) -> Result<(Project, Composed), String> {
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
    Ok((project, composed))
}

/// The number of errors in all passes.
fn errors(composed: &Composed) -> usize {
    let found = composed.units.iter().map(|unit| composed.analysis(unit));
    let found = found.flat_map(|analysis| &analysis.diagnostics);
    found.filter(|d| d.severity == Severity::Error).count()
}

/// `port`: the files as text, errors and remarks. Binary files, as SPIR-V, have no text.
pub fn port(PortRequest { shader, output }: &PortRequest) -> RequestResult {
    let (project, composed) = load(shader)?;
    let order = Order {
        target: Target::of_path(Path::new(output)).map_err(|e| format!("{output}: {e}"))?,
        main: MainChoice::default(),
        output: Destination::File(Path::new(output)),
        interface: false,
        first_row: FirstRow::default(),
        version: None,
        poster: None,
    };
    let made = build(&project, &composed, order);
    let made = made.map_err(|e| format!("{}: {e}", shader.name))?;
    let files = made.files.into_iter().map(|file| {
        let text = String::from_utf8(file.content).ok();
        json!({ "path": file.path.to_string_lossy(), "text": text })
    });
    let remarks = made.remarks.iter();
    let remarks = remarks.map(|remark| remark.diagnostic().message);
    Ok(json!({
        "files": files.collect::<Vec<_>>(),
        "errors": errors(&composed),
        "remarks": remarks.collect::<Vec<_>>(),
    }))
}

/// `playerData`: the data for the player as JSON, the number of errors, and the number of operations per
/// pixel of a frame, as far as they were counted: `isMore` if a shader does not end within the budget.
pub fn player_data(shader: &ShaderText) -> RequestResult {
    let (project, composed) = load(shader)?;
    let errors = errors(&composed);
    let (operations, is_more) = match errors {
        0 => operations(shader),
        _ => (0.0, false),
    };
    Ok(json!({
        "project": data_of(&project, &composed),
        "errors": errors,
        "operations": operations,
        "isMore": is_more,
    }))
}

/// The operations per pixel of all passes that have the size of the canvas, and whether there are more.
fn operations(ShaderText { name, text }: &ShaderText) -> (f64, bool) {
    let selection = Selection {
        run_samples: Some(0),
        ..Selection::default()
    };
    let options = options(None, &[], &selection).unwrap_or_default();
    let report = analyze(name, text, &options, &NoFiles);
    let has_size = |analysis: &&Analysis| match analysis.program.dialect {
        Dialect::ShaderToy(pass) => matches!(pass, Pass::Image | Pass::Buffer),
        _ => true,
    };
    let costs = report.analyses.iter().filter(has_size).map(frame_cost);
    costs.fold((0.0, false), |(sum, is_more), cost| match cost {
        FrameCost::PerPixel(count) => (sum + count, is_more),
        FrameCost::Exceeded(count) => (sum + count, true),
        FrameCost::Unknown => (sum, is_more),
    })
}
