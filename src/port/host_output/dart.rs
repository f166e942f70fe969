//! A Dart class that loads a fragment program of Flutter and sets its uniforms by their order.

use super::text::DeclaredUniform;
use crate::output::{File, file};
use std::path::Path;

/// The class for a shader, beside it.
pub(super) fn setters(shader: &Path, uniforms: &[DeclaredUniform]) -> File {
    let name = |part: Option<&std::ffi::OsStr>| {
        part.map_or(String::new(), |n| n.to_string_lossy().into_owned())
    };
    let file_name = name(shader.file_name());
    let class = class_name(&name(shader.file_stem()));
    let asset = file_name.replace('\\', "\\\\").replace('\'', "\\'");
    let asset = format!("'shaders/{}'", asset.replace('$', "\\$"));
    let (mut floats, mut samplers) = (0, 0);
    let mut methods = String::new();
    for uniform in uniforms {
        methods.push_str(&match uniform.ty.as_str() {
            "sampler2D" => {
                samplers += 1;
                sampler(uniform, samplers - 1)
            }
            ty => {
                let count = components(ty);
                floats += count;
                numbers(uniform, floats - count, count)
            }
        });
    }
    let shown = file_name.replace('`', "'");
    let text = format!(
        "import 'dart:ui' as ui;\n\n\
         /// The fragment program `{shown}` with its uniforms.\n\
         class {class} {{\n  \
         {class}(ui.FragmentProgram program) : shader = program.fragmentShader();\n\n  \
         /// Loads the program, which is listed in the section `shaders` of `pubspec.yaml`.\n  \
         static Future<{class}> load([String asset = {asset}]) async =>\n      \
         {class}(await ui.FragmentProgram.fromAsset(asset));\n\n  \
         /// For `Paint.shader` and `ImageFilter.shader`.\n  \
         final ui.FragmentShader shader;\n{methods}}}\n"
    );
    file(&shader.with_extension("dart"), text)
}

/// The number of floats of a type.
fn components(ty: &str) -> usize {
    let last = ty.chars().last().and_then(|c| c.to_digit(10));
    last.map_or(1, |count| count as usize)
}

/// The method that sets the floats of a uniform.
fn numbers(uniform: &DeclaredUniform, first: usize, count: usize) -> String {
    let names: &[&str] = match (count, uniform.name.to_ascii_lowercase().contains("size")) {
        (1, _) => &["value"],
        (2, true) => &["width", "height"],
        _ => &["x", "y", "z", "w"],
    };
    let names = names.get(..count).unwrap_or(names);
    let parameters: Vec<String> = names.iter().map(|n| format!("double {n}")).collect();
    let lines = names
        .iter()
        .zip(first..)
        .map(|(name, index)| format!("    shader.setFloat({index}, {name});\n"));
    format!(
        "\n  /// `{}`: {}.\n  void {}({}) {{\n{}  }}\n",
        uniform.name,
        uniform.about,
        method(&uniform.name),
        parameters.join(", "),
        lines.collect::<String>()
    )
}

/// The method that sets the image of a sampler.
fn sampler(uniform: &DeclaredUniform, index: usize) -> String {
    format!(
        "\n  /// `{}`: {}.\n  void {}(ui.Image image) {{\n    \
         shader.setImageSampler({index}, image);\n  }}\n",
        uniform.name,
        uniform.about,
        method(&uniform.name),
    )
}

/// The name of a setter: `setTime` for `uTime` and `iTime`.
fn method(name: &str) -> String {
    let mut rest = name.chars();
    let is_marked = matches!(rest.next(), Some('u' | 'i'))
        && rest.clone().next().is_some_and(char::is_uppercase);
    let base = match is_marked {
        true => rest.as_str().to_string(),
        false => capital(name),
    };
    format!("set{base}")
}

/// The name of a class for a file name: `OceanWavesShader` for `ocean-waves`.
fn class_name(stem: &str) -> String {
    let words = stem.split(|c: char| !c.is_ascii_alphanumeric());
    let name: String = words.map(capital).collect();
    let name = name.trim_start_matches(|c: char| c.is_ascii_digit());
    match name.ends_with("Shader") {
        true => name.to_string(),
        false => format!("{name}Shader"),
    }
}

fn capital(word: &str) -> String {
    let mut rest = word.chars();
    rest.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(rest).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_use_one_index_per_component() {
        let uniform = |name: &str, ty: &str| DeclaredUniform {
            name: name.to_string(),
            ty: ty.to_string(),
            about: "x".to_string(),
        };
        let all = [
            uniform("uSize", "vec2"),
            uniform("iChannel0", "sampler2D"),
            uniform("uTime", "float"),
            uniform("iMouse", "vec4"),
        ];
        let file = setters(Path::new("a/2-ocean waves.frag"), &all);
        assert_eq!(file.path, Path::new("a/2-ocean waves.dart"));
        let text = String::from_utf8(file.content).unwrap();
        for part in [
            "class OceanWavesShader {",
            "'shaders/2-ocean waves.frag'",
            "void setSize(double width, double height) {\n    shader.setFloat(0, width);",
            "void setChannel0(ui.Image image) {\n    shader.setImageSampler(0, image);",
            "void setTime(double value) {\n    shader.setFloat(2, value);",
            "void setMouse(double x, double y, double z, double w) {\n    shader.setFloat(3, x);",
            "shader.setFloat(6, w);",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
    }
}
