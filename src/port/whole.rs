//! Whole WebGL2 fragment shaders, which bring their own uniforms and `main`.
//!
//! They are compiled as they stand. What a page can feed them is what ShaderToy's player feeds its
//! own, under its names or those that are usual elsewhere.

use super::{Input, InputKind};
use crate::semantic::{Program, Storage, Variable, channel};
use serde::Serialize;

/// A uniform that the player sets.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Known {
    /// Its name in the shader.
    pub name: String,
    /// What ShaderToy calls it.
    pub means: &'static str,
    /// How many numbers it takes.
    pub size: u8,
}

/// What a whole shader needs and no page of ours gives.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unsupported {
    /// The line, from 1; 0 where it is the whole shader.
    pub line: usize,
    /// What it needs.
    pub message: String,
}

impl std::fmt::Display for Unsupported {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            0 => f.write_str(&self.message),
            line => write!(f, "line {line}: {}", self.message),
        }
    }
}

/// What ShaderToy calls a uniform, what others call it, and the types that it may have, each with
/// how many numbers that takes.
type Names = (
    &'static str,
    &'static [&'static str],
    &'static [(&'static str, u8)],
);

const UNIFORMS: &[Names] = &[
    (
        "iResolution",
        &["iResolution", "u_resolution", "uResolution", "resolution"],
        &[("vec2", 2), ("vec3", 3)],
    ),
    (
        "iTime",
        &["iTime", "u_time", "uTime", "time", "iGlobalTime"],
        &[("float", 1)],
    ),
    (
        "iMouse",
        &["iMouse", "u_mouse", "uMouse", "mouse"],
        &[("vec2", 2), ("vec4", 4)],
    ),
    ("iTimeDelta", &["iTimeDelta", "u_delta"], &[("float", 1)]),
    ("iFrameRate", &["iFrameRate"], &[("float", 1)]),
    ("iSampleRate", &["iSampleRate"], &[("float", 1)]),
    ("iDate", &["iDate", "u_date"], &[("vec4", 4)]),
];

/// Names of the inputs that are taken for the place in the picture, from 0 to 1.
pub(super) const PLACES: [&str; 9] = [
    "vUv",
    "vUV",
    "v_uv",
    "uv",
    "vTexCoord",
    "v_texCoord",
    "v_texcoord",
    "texCoord",
    "texcoord",
];

/// The channels of a whole shader, which a page has to feed.
pub(super) fn inputs(program: &Program) -> Result<Vec<Input>, Unsupported> {
    let mut inputs = Vec::new();
    for variable in &program.variables {
        let (Some(token), Storage::Uniform | Storage::Input) = (variable.token, variable.storage)
        else {
            continue;
        };
        let place = program.token(token).map_or(0, |t| t.span.start);
        let needs = |message: String| Unsupported {
            line: program
                .sources
                .file_at(place)
                .map_or(0, |f| f.position(place).line as usize),
            message,
        };
        match channel_of(program, variable) {
            Some(input) => inputs.push(input),
            None => judge(program, variable).map_err(needs)?,
        }
    }
    Ok(inputs)
}

/// Whether the player can feed a variable.
fn judge(program: &Program, variable: &Variable) -> Result<(), String> {
    let name = program.names.text(variable.name);
    let ty = program.type_name(variable.ty);
    if variable.storage == Storage::Input {
        return match PLACES.contains(&name) && ty == "vec2" {
            true => Ok(()),
            false => Err(format!(
                "nothing gives the input `{name}`; a page only knows the place in the picture, \
                 as `in vec2 vUv`"
            )),
        };
    }
    let is_list = matches!(
        (name, ty.as_str()),
        ("iChannelTime", "float[4]") | ("iChannelResolution", "vec3[4]")
    );
    match is_list || (name, ty.as_str()) == ("iFrame", "int") || known(program, variable).is_some()
    {
        true => Ok(()),
        false => Err(format!(
            "nothing sets the uniform `{ty} {name}`; a page knows those of ShaderToy, such as \
             `vec3 iResolution` and `float iTime`"
        )),
    }
}

fn known(program: &Program, variable: &Variable) -> Option<Known> {
    let name = program.names.text(variable.name);
    let ty = program.type_name(variable.ty);
    let (means, _, types) = UNIFORMS
        .iter()
        .find(|(_, names, _)| names.contains(&name))?;
    let (_, size) = types.iter().find(|(t, _)| *t == ty)?;
    Some(Known {
        name: name.to_string(),
        means,
        size: *size,
    })
}

/// A channel, if the uniform is one.
fn channel_of(program: &Program, variable: &Variable) -> Option<Input> {
    let name = program.names.text(variable.name);
    let number = channel(name)?;
    let kind = match program.type_name(variable.ty).as_str() {
        "sampler2D" => InputKind::Texture,
        "samplerCube" => InputKind::Cubemap,
        "sampler3D" => InputKind::Volume,
        _ => return None,
    };
    Some(Input::empty(number, kind))
}

/// The uniforms that go by other names or types than the player's own.
pub(super) fn uniforms(program: &Program) -> Vec<Known> {
    let is_uniform = |v: &&Variable| v.storage == Storage::Uniform && v.token.is_some();
    let all = program.variables.iter().filter(is_uniform);
    all.filter_map(|v| known(program, v)).collect()
}

/// The vertex shader that gives the inputs of a whole shader.
pub(super) fn vertex(program: &Program) -> String {
    let is_input = |v: &&Variable| v.storage == Storage::Input && v.token.is_some();
    let names = program.variables.iter().filter(is_input);
    let names: Vec<&str> = names.map(|v| program.names.text(v.name)).collect();
    let declared: String = names.iter().map(|n| format!("out vec2 {n};\n")).collect();
    let set: String = names
        .iter()
        .map(|n| format!("    {n} = 0.5 + 0.5 * pos;\n"))
        .collect();
    format!(
        "#version 300 es\nlayout(location = 0) in vec2 pos;\n{declared}void main() {{\n    \
         gl_Position = vec4(pos, 0.0, 1.0);\n{set}}}\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::port::{Project, ShaderError, Wrapper};

    const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 c;\n";

    #[test]
    fn known_uniforms_are_taken() {
        let code = format!(
            "{HEAD}uniform vec2 u_resolution;\nuniform samplerCube iChannel1;\nin vec2 vUv;\n\
             uniform float unused;\nvoid main() {{ c = vec4(vUv / u_resolution, 0, 1); }}\n"
        );
        let Err(ShaderError::Unsupported(error)) = Project::from_shader("", &code) else {
            panic!("nothing sets `unused`")
        };
        assert_eq!(error.line, 7);
        let project = Project::from_shader("", &code.replace("unused", "iTime")).unwrap();
        let pass = &project.passes[0];
        assert_eq!(pass.wrapper, Wrapper::Own);
        assert_eq!(pass.inputs[0].kind, InputKind::Cubemap);
    }
}
