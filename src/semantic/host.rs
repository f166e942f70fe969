//! Hosts: who runs a shader, the text added to it, and the entry function that it must define.

use super::builtins::Stage;
use super::dialect::{Channels, Dialect, Pass};
use super::types::Sampler;
use shaderlint_syntax::{RawKind, written_tokens};

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
    /// The pieces of the text that it adds before a shader, with `sampler2D` for each channel.
    prelude: &'static [&'static str],
    /// The types that its channels may have.
    channels: &'static [Sampler],
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

/// The first six lines added by ShaderToy's renderer.
const RENDERER: &str = "#version 300 es\n#ifdef GL_ES\nprecision highp float;\n\
    precision highp int;\nprecision mediump sampler3D;\n#endif\n#define HW_PERFORMANCE 1\n";
const UNIFORMS: &str = include_str!("builtins/shadertoy.glsl");
const CHANNELS: &str = include_str!("builtins/shadertoy_channels.glsl");

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
    channels: &[],
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
    channels: &[Sampler::Sampler2D, Sampler::SamplerCube, Sampler::Sampler3D],
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
        include_str!("builtins/shadertoy_channel_structs.glsl"),
        include_str!("builtins/shadertoy_image.glsl"),
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
        include_str!("builtins/shadertoy_buffer.glsl"),
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
        include_str!("builtins/shadertoy_cubemap.glsl"),
    ],
    lines: 30,
    ..PLAYER
};
static SOUND: Host = Host {
    runs: Some("ShaderToy sound"),
    entry: Some(MAIN_SOUND),
    prelude: &[
        RENDERER,
        include_str!("builtins/shadertoy_sound.glsl"),
        CHANNELS,
        include_str!("builtins/shadertoy_sound_main.glsl"),
    ],
    channels: &[Sampler::Sampler2D, Sampler::SamplerCube],
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
    /// Whether it adds declarations, and sets no uniforms but its own.
    pub const fn declares_uniforms(&self) -> bool {
        !self.prelude.is_empty()
    }

    /// The text added before a shader with channels of these types. It has as many lines as the
    /// host's own, so that `__LINE__` has the same values.
    pub fn prelude(&self, channels: Channels) -> String {
        let mut text = self.prelude.concat();
        for (i, channel) in channels.iter().enumerate() {
            let sampler = channel.filter(|c| self.channels.contains(c));
            let Some(sampler) = sampler.filter(|c| *c != Sampler::Sampler2D) else {
                continue;
            };
            for (before, after) in [
                ("uniform ", format!(" iChannel{i};")),
                (
                    "uniform struct { ",
                    format!(" sampler; vec3 size; float time; int loaded; }} iCh{i};"),
                ),
            ] {
                let declared = |ty: &str| format!("{before}{ty}{after}");
                text = text.replace(&declared("sampler2D"), &declared(sampler.name()));
            }
        }
        let missing = self.lines.saturating_sub(text.lines().count());
        text.push_str(&"\n".repeat(missing));
        text
    }

    /// The text added before a file that may declare uniforms of the host itself, as programs that
    /// play such files need it. The lines of these uniforms are empty.
    pub fn prelude_beside(&self, channels: Channels, code: &str) -> String {
        let text = self.prelude(channels);
        let own = uniforms_in(code);
        if own.is_empty() {
            return text;
        }
        let is_own = |line: &str| match &uniforms_in(line)[..] {
            [uniform] => own.iter().any(|own| own.name == uniform.name),
            _ => false,
        };
        let lines = text.lines().map(|line| {
            if is_own(line) {
                "\n".to_string()
            } else {
                format!("{line}\n")
            }
        });
        lines.collect()
    }

    /// Whether the host sets a uniform with this name and type. It decides what samplers read.
    pub fn sets(&self, name: &str, ty: &str) -> bool {
        let is_sampler = |ty: &str| ty.starts_with("sampler");
        let all = uniforms_in(&self.prelude([None; 4]));
        let mut named = all.iter().filter(|uniform| uniform.name == name);
        named.any(|uniform| uniform.ty == ty || is_sampler(&uniform.ty) && is_sampler(ty))
    }
}

/// A uniform in a text.
struct NamedUniform {
    /// The type, with array sizes.
    ty: String,
    name: String,
}

/// The uniforms that a text declares, except under conditions.
fn uniforms_in(code: &str) -> Vec<NamedUniform> {
    let mut found = Vec::new();
    if !code.contains("uniform") {
        return found;
    }
    let mut conditions = 0_usize;
    let mut is_directive = false;
    // The words of the current declaration after `uniform`.
    let mut words: Option<Vec<&str>> = None;
    for (kind, _, word) in written_tokens(code) {
        match kind {
            RawKind::Hash => is_directive = true,
            RawKind::Whitespace | RawKind::Newline => {}
            RawKind::Word if std::mem::take(&mut is_directive) => match word {
                "if" | "ifdef" | "ifndef" => conditions += 1,
                "endif" => conditions = conditions.saturating_sub(1),
                _ => {}
            },
            RawKind::Word if word == "uniform" => words = (conditions == 0).then(Vec::new),
            _ if word == ";" => {
                if let Some([ty, name, dims @ ..]) = words.take().as_deref() {
                    found.push(NamedUniform {
                        ty: format!("{ty}{}", dims.concat()),
                        name: (*name).to_string(),
                    });
                }
            }
            _ if matches!(word, "lowp" | "mediump" | "highp") => {}
            _ => words.iter_mut().for_each(|words| words.push(word)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniforms_that_a_file_declares_itself_are_left_out() {
        let code = "uniform highp vec3 iResolution;\nuniform samplerCube iChannel1;\n\
            #ifdef OTHER\nuniform vec4 iMouse;\n#endif\n";
        let all = IMAGE.prelude([None; 4]);
        let left = IMAGE.prelude_beside([None; 4], code);
        let lines = all.lines().zip(left.lines());
        let gone: Vec<&str> = lines.filter(|(a, b)| a != b).map(|(a, _)| a).collect();
        assert_eq!(gone.len(), 2, "{gone:?}");
        assert!(
            gone[0].contains("iResolution") && gone[1].contains("iChannel1"),
            "{gone:?}"
        );
        assert_eq!(all.lines().count(), left.lines().count());
        let sets = [
            ("iTime", "float"),
            ("iTime", "int"),
            ("iChannel0", "sampler3D"),
        ];
        assert_eq!(
            sets.map(|(name, ty)| IMAGE.sets(name, ty)),
            [true, false, true]
        );
        assert!(IMAGE.sets("iChannelTime", "float[4]"));
    }

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
