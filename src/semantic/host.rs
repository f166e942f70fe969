//! Hosts: who runs a shader, what stands around its text there, and what it has to define.

use super::builtins::Stage;
use super::dialect::{Channels, Dialect, Pass};
use super::types::Sampler;

/// Who runs a shader.
#[derive(Debug)]
pub struct Host {
    /// What it runs, as people call it; `None` where the stage and the version say it.
    pub runs: Option<&'static str>,
    /// How notes call it.
    pub called: &'static str,
    /// The stage of all that it runs, if there is one alone.
    pub stage: Option<Stage>,
    /// The function that every shader must define.
    pub entry: Option<EntryPoint>,
    /// Whether it shows the result without its alpha.
    pub hides_alpha: bool,
    /// Names that it had in former times: the old one, what it is called now, and since when.
    pub renamed: &'static [(&'static str, &'static str, &'static str)],
    prelude: &'static [Piece],
    /// How many lines that has: `__LINE__` goes on counting behind them.
    lines: usize,
}

/// The function at which a shader starts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EntryPoint {
    /// Its name.
    pub name: &'static str,
    /// How it is declared.
    pub signature: &'static str,
    /// Where what it computes goes.
    pub result: EntryResult,
}

/// Where what an entry computes goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EntryResult {
    /// To outputs of the shader.
    Outputs,
    /// To its first parameter, which the host writes to its own output.
    Parameter,
    /// It is returned to the host.
    Returned,
}

/// Whether a shader may start at a function of this name: it is `main`, or a host calls it. What
/// parameters it takes, the host says.
pub fn starts_a_shader(name: &str) -> bool {
    matches!(
        name,
        "main" | "mainImage" | "mainCubemap" | "mainSound" | "mainVR"
    )
}

/// The number of the channel that ShaderToy's player gives this name.
pub fn channel(name: &str) -> Option<u8> {
    match name.strip_prefix("iChannel")?.as_bytes() {
        [digit @ b'0'..=b'3'] => Some(digit - b'0'),
        _ => None,
    }
}

impl EntryPoint {
    /// Whether the host's text declares the function, and calls it from a `main` of its own.
    pub fn is_called_by_host(self) -> bool {
        self.result != EntryResult::Outputs
    }
}

/// A part of what a host puts before a shader.
#[derive(Debug)]
enum Piece {
    Text(&'static str),
    /// The four channels, each of one of these types.
    Channels(&'static [Sampler]),
    /// A struct for each channel.
    ChannelStructs,
}

/// The six lines that the renderer of ShaderToy's player puts first.
const RENDERER: Piece = Piece::Text(
    "#version 300 es\n#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n\
     precision mediump sampler3D;\n#endif\n#define HW_PERFORMANCE 1\n",
);
const UNIFORMS: Piece = Piece::Text(include_str!("builtins/shadertoy.glsl"));
const CHANNELS: Piece =
    Piece::Channels(&[Sampler::Sampler2D, Sampler::SamplerCube, Sampler::Sampler3D]);

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

/// A page, which compiles the text as it stands or completes it first.
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

/// What all passes of ShaderToy have: its player puts a header before them, in the order of its
/// `effect.js`: the renderer's lines, then uniforms, prototypes and `main`.
const PLAYER: Host = Host {
    runs: None,
    called: "the ShaderToy player",
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
        Piece::ChannelStructs,
        Piece::Text(include_str!("builtins/shadertoy_image.glsl")),
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
        Piece::Text(include_str!("builtins/shadertoy_buffer.glsl")),
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
        Piece::Text(include_str!("builtins/shadertoy_cubemap.glsl")),
    ],
    lines: 30,
    ..PLAYER
};
static SOUND: Host = Host {
    runs: Some("ShaderToy sound"),
    entry: Some(MAIN_SOUND),
    prelude: &[
        RENDERER,
        Piece::Text(include_str!("builtins/shadertoy_sound.glsl")),
        Piece::Channels(&[Sampler::Sampler2D, Sampler::SamplerCube]),
        Piece::Text(include_str!("builtins/shadertoy_sound_main.glsl")),
    ],
    lines: 20,
    ..PLAYER
};
static COMMON: Host = Host {
    runs: Some("ShaderToy common code"),
    prelude: &[RENDERER, UNIFORMS, CHANNELS],
    // As in an Image.
    lines: 53,
    ..PLAYER
};

impl Pass {
    /// ShaderToy's player, as it runs passes of this kind.
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
    /// The text that it puts before a shader whose channels are of these types. It has as many lines
    /// as the host's own, so that a shader's `__LINE__` is what it is there.
    pub fn prelude(&self, channels: Channels) -> String {
        let mut text = String::new();
        for piece in self.prelude {
            match piece {
                Piece::Text(piece) => text.push_str(piece),
                Piece::Channels(kinds) => {
                    for (i, channel) in channels.iter().enumerate() {
                        let sampler = channel
                            .filter(|c| kinds.contains(c))
                            .unwrap_or(Sampler::Sampler2D);
                        text.push_str(&format!("uniform {} iChannel{i};\n", sampler.name()));
                    }
                }
                Piece::ChannelStructs => {
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

    /// The lines of ShaderToy's own headers, counted in its player and asked of it.
    #[test]
    fn the_first_line_of_a_pass_has_the_number_that_it_has_on_the_site() {
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
