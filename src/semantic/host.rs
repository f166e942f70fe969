//! Hosts: who runs a shader, the text added to it, and the entry function that it must define.

use super::builtins::Stage;
use super::dialect::{Channels, Dialect, Pass};
use super::types::Sampler;

/// A host that runs shaders.
#[derive(Debug)]
pub struct Host {
    /// Display name of what it runs; `None` if stage and version describe it.
    pub runs: Option<&'static str>,
    /// Name of the host in notes.
    pub called: &'static str,
    /// The stage of all shaders that it runs; `None` if it runs both.
    pub stage: Option<Stage>,
    /// The function that every shader must define.
    pub entry: Option<EntryPoint>,
    /// Whether it ignores the alpha of the output.
    pub hides_alpha: bool,
    /// Renamed identifiers: old name, current name, year of the change.
    pub renamed: &'static [(&'static str, &'static str, &'static str)],
    prelude: &'static [PreludePiece],
    /// Number of lines of the original prelude; `__LINE__` continues from it.
    lines: usize,
}

/// Entry function of a shader.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EntryPoint {
    /// Name of the function.
    pub name: &'static str,
    /// Declaration, as shown in messages.
    pub signature: &'static str,
    /// How it returns its result.
    pub result: EntryResult,
}

/// How an entry function returns its result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EntryResult {
    /// By writing to outputs of the shader.
    Outputs,
    /// By its first parameter, which the host copies to its own output.
    Parameter,
    /// As the return value.
    Returned,
}

/// Whether a function of this name may be an entry function: it is `main` or called by a host. The
/// host determines its parameters.
pub fn starts_a_shader(name: &str) -> bool {
    matches!(
        name,
        "main" | "mainImage" | "mainCubemap" | "mainSound" | "mainVR"
    )
}

/// The index of the ShaderToy channel with this name.
pub fn channel(name: &str) -> Option<u8> {
    match name.strip_prefix("iChannel")?.as_bytes() {
        [digit @ b'0'..=b'3'] => Some(digit - b'0'),
        _ => None,
    }
}

impl EntryPoint {
    /// Whether the host declares the function and calls it from its own `main`.
    pub fn is_called_by_host(self) -> bool {
        self.result != EntryResult::Outputs
    }
}

/// A piece of the text that a host adds before a shader.
#[derive(Debug)]
enum PreludePiece {
    Text(&'static str),
    /// The four channel uniforms, each with one of these types.
    Channels(&'static [Sampler]),
    /// A struct for each channel.
    ChannelStructs,
}

/// The first six lines added by ShaderToy's renderer.
const RENDERER: PreludePiece = PreludePiece::Text(
    "#version 300 es\n#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n\
     precision mediump sampler3D;\n#endif\n#define HW_PERFORMANCE 1\n",
);
const UNIFORMS: PreludePiece = PreludePiece::Text(include_str!("builtins/shadertoy.glsl"));
const CHANNELS: PreludePiece =
    PreludePiece::Channels(&[Sampler::Sampler2D, Sampler::SamplerCube, Sampler::Sampler3D]);

const MAIN: EntryPoint = EntryPoint {
    name: "main",
    signature: "void main()",
    result: EntryResult::Outputs,
};
const MAIN_IMAGE: EntryPoint = EntryPoint {
    name: "mainImage",
    signature: "void mainImage(out vec4 fragColor, in vec2 fragCoord)",
    result: EntryResult::Parameter,
};
const MAIN_CUBEMAP: EntryPoint = EntryPoint {
    name: "mainCubemap",
    signature: "void mainCubemap(out vec4 fragColor, in vec2 fragCoord, in vec3 rayOri, in vec3 rayDir)",
    result: EntryResult::Parameter,
};
const MAIN_SOUND: EntryPoint = EntryPoint {
    name: "mainSound",
    signature: "vec2 mainSound(in int samp, float time)",
    result: EntryResult::Returned,
};

/// A web page, which compiles the text as it is or completes it first.
static PAGE: Host = Host {
    runs: None,
    called: "the host",
    stage: None,
    entry: Some(MAIN),
    hides_alpha: false,
    renamed: &[],
    prelude: &[],
    lines: 0,
};

/// Common to all ShaderToy passes: ShaderToy adds a header in the order of its `effect.js`: the
/// renderer's lines, then uniforms, prototypes and `main`.
const PLAYER: Host = Host {
    runs: None,
    called: "ShaderToy",
    stage: Some(Stage::Fragment),
    entry: None,
    hides_alpha: false,
    renamed: &[("iGlobalTime", "iTime", "2017")],
    prelude: &[],
    lines: 0,
};

static IMAGE: Host = Host {
    runs: Some("ShaderToy image"),
    entry: Some(MAIN_IMAGE),
    hides_alpha: true,
    prelude: &[
        RENDERER,
        UNIFORMS,
        CHANNELS,
        PreludePiece::ChannelStructs,
        PreludePiece::Text(include_str!("builtins/shadertoy_image.glsl")),
    ],
    lines: 53,
    ..PLAYER
};
static BUFFER: Host = Host {
    runs: Some("ShaderToy buffer"),
    entry: Some(MAIN_IMAGE),
    prelude: &[
        RENDERER,
        UNIFORMS,
        CHANNELS,
        PreludePiece::Text(include_str!("builtins/shadertoy_buffer.glsl")),
    ],
    lines: 27,
    ..PLAYER
};
static CUBEMAP: Host = Host {
    runs: Some("ShaderToy cube map"),
    entry: Some(MAIN_CUBEMAP),
    prelude: &[
        RENDERER,
        UNIFORMS,
        CHANNELS,
        PreludePiece::Text(include_str!("builtins/shadertoy_cubemap.glsl")),
    ],
    lines: 30,
    ..PLAYER
};
static SOUND: Host = Host {
    runs: Some("ShaderToy sound"),
    entry: Some(MAIN_SOUND),
    prelude: &[
        RENDERER,
        PreludePiece::Text(include_str!("builtins/shadertoy_sound.glsl")),
        PreludePiece::Channels(&[Sampler::Sampler2D, Sampler::SamplerCube]),
        PreludePiece::Text(include_str!("builtins/shadertoy_sound_main.glsl")),
    ],
    lines: 20,
    ..PLAYER
};
static COMMON: Host = Host {
    runs: Some("ShaderToy common code"),
    prelude: &[RENDERER, UNIFORMS, CHANNELS],
    // As for an Image pass.
    lines: 53,
    ..PLAYER
};

impl Pass {
    /// ShaderToy as the host of passes of this kind.
    pub fn host(self) -> &'static Host {
        match self {
            Pass::Image => &IMAGE,
            Pass::Buffer => &BUFFER,
            Pass::Cubemap => &CUBEMAP,
            Pass::Sound => &SOUND,
            Pass::Common => &COMMON,
        }
    }
}

impl Dialect {
    /// Who runs the shader.
    pub fn host(self) -> &'static Host {
        match self {
            Dialect::ShaderToy(pass) => pass.host(),
            Dialect::WebGl => &PAGE,
        }
    }
}

impl Host {
    /// The text added before a shader with channels of these types. It has as many lines as the
    /// host's own, so that `__LINE__` has the same values.
    pub fn prelude(&self, channels: Channels) -> String {
        let mut text = String::new();
        for piece in self.prelude {
            match piece {
                PreludePiece::Text(piece) => text.push_str(piece),
                PreludePiece::Channels(kinds) => {
                    for (i, channel) in channels.iter().enumerate() {
                        let sampler = channel
                            .filter(|c| kinds.contains(c))
                            .unwrap_or(Sampler::Sampler2D);
                        text.push_str(&format!("uniform {} iChannel{i};\n", sampler.name()));
                    }
                }
                PreludePiece::ChannelStructs => {
                    for (i, channel) in channels.iter().enumerate() {
                        let sampler = channel.unwrap_or(Sampler::Sampler2D).name();
                        text.push_str(&format!(
                            "uniform struct {{ {sampler} sampler; vec3 size; float time; int loaded; }} iCh{i};\n"
                        ));
                    }
                }
            }
        }
        let missing = self.lines.saturating_sub(text.lines().count());
        text.push_str(&"\n".repeat(missing));
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The header lengths of ShaderToy, counted in its code and confirmed on the site.
    #[test]
    fn passes_have_the_line_numbers_of_shadertoy() {
        let all = [
            (Pass::Image, 54),
            (Pass::Buffer, 28),
            (Pass::Cubemap, 31),
            (Pass::Sound, 21),
        ];
        for (pass, first) in all {
            let prelude = pass.host().prelude([None; 4]);
            assert!(prelude.ends_with('\n'));
            assert_eq!(prelude.lines().count() + 1, first, "{pass:?}");
        }
    }
}
