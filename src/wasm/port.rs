//! The requests about ports.

use super::files::options_of;
use super::project::{ShaderText, load};
use super::result::RequestResult;
use serde::Deserialize;
use serde_json::json;
use shaderlint_commands::PortRequest;
use shaderlint_diagnostic::Severity;
use shaderlint_engine::config::Selection;
use shaderlint_engine::{Analysis, Report, analyze};
use shaderlint_ide::{FrameCost, frame_cost};
use shaderlint_port::{Destination, Target};
use shaderlint_port::{build, player_data as data_of};
use shaderlint_project::Composed;
use shaderlint_semantic::{Dialect, Pass};

/// A shader or export, and what it is ported to.
#[derive(Deserialize)]
pub struct PortParams {
    #[serde(flatten)]
    shader: ShaderText,
    #[serde(flatten)]
    request: PortRequest,
}

/// The number of errors in all passes.
fn errors(composed: &Composed) -> usize {
    let found = composed.units.iter().map(|unit| composed.analysis(unit));
    let found = found.flat_map(|analysis| &analysis.diagnostics);
    found.filter(|d| d.severity == Severity::Error).count()
}

/// `port`: the files as text, errors and remarks. Binary files, as SPIR-V, have no text.
pub fn port(PortParams { shader, request }: &PortParams) -> RequestResult {
    let (project, mut composed) = load(shader)?;
    composed.choose_sliders(request.sliders);
    let output = request.output.as_deref().ok_or("`output` is missing")?;
    let target = request.target(Target::Glsl)?;
    let order = request.order(target, Destination::File(output));
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
fn operations(shader: &ShaderText) -> (f64, bool) {
    let selection = Selection {
        run_samples: Some(0),
        ..Selection::default()
    };
    let files = shader.all_files();
    let options = options_of(&files, &shader.name, selection).unwrap_or_default();
    let mut reports: Vec<Report> = Vec::new();
    if shader.passes.is_empty() {
        reports.push(analyze(&shader.name, &shader.text, &options, &*files));
    }
    for (path, text) in &shader.passes {
        reports.push(analyze(&path.to_string_lossy(), text, &options, &*files));
    }
    let has_size = |analysis: &&Analysis| match analysis.program.dialect {
        Dialect::ShaderToy(pass) => matches!(pass, Pass::Image | Pass::Buffer),
        _ => true,
    };
    let analyses = reports.iter().flat_map(|report| &report.analyses);
    let costs = analyses.filter(has_size).map(frame_cost);
    costs.fold((0.0, false), |(sum, is_more), cost| match cost {
        FrameCost::PerPixel(count) => (sum + count, is_more),
        FrameCost::Exceeded(count) => (sum + count, true),
        FrameCost::Unknown => (sum, is_more),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn data(request: Value) -> RequestResult {
        player_data(&serde_json::from_value(request).unwrap())
    }

    const IMAGE: &str =
        "void mainImage(out vec4 c, in vec2 p) {\n    c = SCALE * texture(iChannel0, p);\n}\n";
    const BUFFER: &str =
        "void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(SCALE) * sin(p.x);\n}\n";

    #[test]
    fn passes_are_ported_together() {
        let passes = json!({
            "image.glsl": IMAGE, "common.glsl": "const float SCALE = 2.0;\n", "buffer_a.glsl": BUFFER,
        });
        let request = json!({ "name": "x", "passes": passes, "channels": ["0=buffer_a"] });
        let made = data(request).unwrap();
        assert_eq!(made["errors"], 0);
        let project = made["project"].as_str().unwrap();
        assert!(project.contains("\"buffer\""), "{project}");
        let alone = data(json!({ "name": "image.glsl", "text": BUFFER.replace("SCALE", "1.0") }));
        let (both, one) = (&made["operations"], &alone.unwrap()["operations"]);
        assert!(both.as_f64() > one.as_f64(), "{both} and {one}");
    }

    #[test]
    fn invalid_passes_are_reported() {
        let wrong = |request: Value| data(request).unwrap_err();
        let none = wrong(json!({ "name": "x", "passes": { "buffer_a.glsl": BUFFER } }));
        assert!(
            none.starts_with("no file defines the pass `image`"),
            "{none}"
        );
        let name = wrong(json!({ "name": "x", "passes": { "noise.glsl": BUFFER } }));
        assert!(
            name.starts_with("noise.glsl: the file name does not match a pass"),
            "{name}"
        );
        let passes = json!({ "image.glsl": BUFFER });
        let channel = wrong(json!({ "name": "x", "passes": passes, "channels": ["0=buffer_b"] }));
        assert!(
            channel.contains("the project has no pass `buffer_b`"),
            "{channel}"
        );
    }
}
