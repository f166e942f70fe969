//! The requests about ports.

use super::result::RequestResult;
use super::workspace::MemoryFiles;
use serde::Deserialize;
use serde_json::json;
use shaderlint_diagnostic::Severity;
use shaderlint_engine::config::{Selection, options};
use shaderlint_engine::{Analysis, Report, analyze};
use shaderlint_ide::{FrameCost, frame_cost};
use shaderlint_port::naga::FirstRow;
use shaderlint_port::{ChannelOrder, Composed, Destination, MainChoice, Order, PassFile, PassRole};
use shaderlint_port::{Project, Target};
use shaderlint_port::{add_stand_ins, build, player_data as data_of};
use shaderlint_semantic::{Dialect, Pass};
use shaderlint_text::kind::{Claim, FileKind, decide};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A shader or export, or the passes of a project.
#[derive(Deserialize)]
pub struct ShaderText {
    /// Name of the file, or of the project.
    name: String,
    /// Contents of the file.
    #[serde(default)]
    text: String,
    /// The passes of a project by file name, such as `buffer_a.glsl`, instead of a text.
    #[serde(default)]
    passes: BTreeMap<PathBuf, String>,
    /// The inputs of channels, as after `--channel`: `buffer_a.0=keyboard`.
    #[serde(default)]
    channels: Vec<String>,
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
fn load(shader: &ShaderText) -> Result<(Project, Composed), String> {
    let name = &shader.name;
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let mut project = draft(shader)?;
    let composed = project.resolve(name).map_err(|e| wrong(&e))?;
    for text in &shader.channels {
        let order = ChannelOrder::read(text).map_err(|e| format!("{text}: {e}"))?;
        let put = project.put(&order, None);
        put.map_err(|e| format!("{text}: {e}"))?;
    }
    add_stand_ins(&mut project);
    let composed = project.renew(composed, name).map_err(|e| wrong(&e))?;
    Ok((project, composed))
}

/// The project of a shader, an export or a folder of passes, as the command line reads them.
fn draft(shader: &ShaderText) -> Result<Project, String> {
    let ShaderText { name, text, .. } = shader;
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let title = Path::new(name).file_stem().unwrap_or_default();
    let title = title.to_string_lossy();
    if !shader.passes.is_empty() {
        let files = shader.passes.iter().map(pass_file);
        let files = files.collect::<Result<Vec<_>, _>>()?;
        return Project::from_parts(&title, files).map_err(|e| e.to_string());
    }
    let is_export = decide(name, text, Claim::None).kind == FileKind::Export;
    match is_export {
        true => Project::from_json(text).map_err(|e| wrong(&e)),
        false => Project::from_shader(&title, text).map_err(|e| wrong(&e)),
    }
}

/// A file whose name says which pass it is.
fn pass_file((path, code): (&PathBuf, &String)) -> Result<PassFile, String> {
    let stem = path.file_stem().unwrap_or_default();
    let role = PassRole::of_name(&stem.to_string_lossy());
    let file = path.to_string_lossy().into_owned();
    Ok(PassFile {
        role: role.ok_or_else(|| format!("{file}: the file name does not match a pass"))?,
        file,
        code: code.as_str().into(),
    })
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
fn operations(
    ShaderText {
        name, text, passes, ..
    }: &ShaderText,
) -> (f64, bool) {
    let selection = Selection {
        run_samples: Some(0),
        ..Selection::default()
    };
    let options = options(None, &[], &selection).unwrap_or_default();
    let files = MemoryFiles::new(passes);
    let mut reports: Vec<Report> = Vec::new();
    if passes.is_empty() {
        reports.push(analyze(name, text, &options, &files));
    }
    for (path, text) in passes {
        reports.push(analyze(&path.to_string_lossy(), text, &options, &files));
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
    fn what_is_wrong_with_passes_is_reported() {
        let wrong = |request: Value| data(request).unwrap_err();
        let none = wrong(json!({ "name": "x", "passes": { "buffer_a.glsl": BUFFER } }));
        assert!(
            none.starts_with("no file defines the pass `image`"),
            "{none}"
        );
        let name = wrong(json!({ "name": "x", "passes": { "noise.glsl": BUFFER } }));
        assert_eq!(name, "noise.glsl: the file name does not match a pass");
        let passes = json!({ "image.glsl": BUFFER });
        let channel = wrong(json!({ "name": "x", "passes": passes, "channels": ["0=buffer_b"] }));
        assert!(
            channel.contains("the project has no pass `buffer_b`"),
            "{channel}"
        );
    }
}
