//! Who runs the shader, and what that host puts around it.

use super::builtins::Stage;
use super::types::Sampler;

/// The kinds of ShaderToy pass.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Pass {
    /// Draws the picture.
    Image,
    /// Draws into a buffer.
    Buffer,
    /// Draws a cube map.
    Cubemap,
    /// Computes sound.
    Sound,
    /// Put before every other pass; never runs alone.
    Common,
}

impl Pass {
    /// The function that the pass must define, if it must define one.
    pub const fn entry(self) -> Option<&'static str> {
        match self {
            Pass::Image | Pass::Buffer => Some("mainImage"),
            Pass::Cubemap => Some("mainCubemap"),
            Pass::Sound => Some("mainSound"),
            Pass::Common => None,
        }
    }

    /// How the entry is declared by the player.
    pub const fn signature(self) -> &'static str {
        match self {
            Pass::Image | Pass::Buffer => "void mainImage(out vec4 fragColor, in vec2 fragCoord)",
            Pass::Cubemap => {
                "void mainCubemap(out vec4 fragColor, in vec2 fragCoord, in vec3 rayOri, in vec3 rayDir)"
            }
            Pass::Sound => "vec2 mainSound(in int samp, float time)",
            Pass::Common => "",
        }
    }
}

/// Who runs the shader.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Dialect {
    /// ShaderToy's player, which puts a header before the pass.
    ShaderToy(Pass),
    /// A page that compiles the text as it stands.
    WebGl {
        /// Whether the text is a whole shader, with `main`, or a part to be included.
        whole: bool,
    },
}

/// The type of each channel of a pass; `None` where it is not known.
pub type Channels = [Option<Sampler>; 4];

/// The text that the ShaderToy player puts before a pass: the six lines of its renderer, then
/// uniforms, prototypes and `main`, in its own order (`effect.js`).
pub fn shadertoy_header(pass: Pass, channels: Channels) -> String {
    let mut text = String::from(
        "#version 300 es\n#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n\
         precision mediump sampler3D;\n#endif\n#define HW_PERFORMANCE 1\n",
    );
    let declare = |text: &mut String, kinds: &[Sampler]| {
        for (i, channel) in channels.iter().enumerate() {
            let sampler = channel
                .filter(|c| kinds.contains(c))
                .unwrap_or(Sampler::Sampler2D);
            text.push_str(&format!("uniform {} iChannel{i};\n", sampler.name()));
        }
    };
    const ALL: [Sampler; 3] = [Sampler::Sampler2D, Sampler::SamplerCube, Sampler::Sampler3D];
    match pass {
        Pass::Sound => {
            text.push_str(include_str!("builtins/shadertoy_sound.glsl"));
            declare(&mut text, &ALL[..2]);
            text.push_str(include_str!("builtins/shadertoy_sound_main.glsl"));
        }
        Pass::Common => {
            text.push_str(include_str!("builtins/shadertoy.glsl"));
            declare(&mut text, &ALL);
        }
        _ => {
            text.push_str(include_str!("builtins/shadertoy.glsl"));
            declare(&mut text, &ALL);
            if pass == Pass::Image {
                for (i, channel) in channels.iter().enumerate() {
                    let sampler = channel.unwrap_or(Sampler::Sampler2D).name();
                    text.push_str(&format!(
                        "uniform struct {{ {sampler} sampler; vec3 size; float time; int loaded; }} iCh{i};\n"
                    ));
                }
            }
            text.push_str(match pass {
                Pass::Image => include_str!("builtins/shadertoy_image.glsl"),
                Pass::Buffer => include_str!("builtins/shadertoy_buffer.glsl"),
                _ => include_str!("builtins/shadertoy_cubemap.glsl"),
            });
        }
    }
    text
}

/// The text that three.js puts before the shaders of a `ShaderMaterial`, in its own order
/// (`WebGLProgram.js`), without what only some materials have.
pub fn three_header(stage: Stage) -> String {
    let own = match stage {
        Stage::Vertex => include_str!("builtins/three_vertex.glsl"),
        Stage::Fragment => include_str!("builtins/three_fragment.glsl"),
    };
    let samplers = [
        "sampler2DArray",
        "sampler3D",
        "sampler2DShadow",
        "samplerCubeShadow",
    ];
    let mut text = String::from("#version 300 es\nprecision highp float;\nprecision highp int;\n");
    for sampler in samplers {
        text.push_str(&format!("precision highp {sampler};\n"));
    }
    text + own
}

impl Dialect {
    /// Whether the ShaderToy player runs it.
    pub const fn is_shadertoy(self) -> bool {
        matches!(self, Dialect::ShaderToy(_))
    }

    /// The stage that passes are written for.
    pub const fn default_stage(self) -> Stage {
        Stage::Fragment
    }
}

/// What a text seems to be written for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Guess {
    /// What the text itself tells; `None` where it tells nothing.
    pub kind: Option<Kind>,
    /// The stage, where the text tells it.
    pub stage: Option<Stage>,
}

/// What a text is written for, as far as its words tell.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Kind {
    /// A ShaderToy pass.
    ShaderToy(Pass),
    /// It has a `#version`.
    Versioned,
    /// It uses words of GLSL ES 1.00, and has no `#version`.
    WebGl1,
    /// It has a `main` and words of GLSL ES 3.00, but no `#version`.
    WebGl2,
}

/// Guesses by the words of a text what it is written for. A `#version` says most, then ShaderToy's
/// entry functions, then the words that only one version of the language has.
pub fn guess(text: &str) -> Guess {
    let has = |word: &str| text.contains(word);
    let mut seen = Seen::default();
    let any = [
        "version",
        "mainImage",
        "mainSound",
        "mainCubemap",
        "gl_",
        "attribute",
        "varying",
        "main",
        "texture",
    ];
    if any.iter().any(|w| has(w)) {
        seen.read(text);
    }
    let kind = if seen.version {
        Some(Kind::Versioned)
    } else if let Some(pass) = seen.pass {
        Some(Kind::ShaderToy(pass))
    } else if seen.old {
        Some(Kind::WebGl1)
    } else if seen.main {
        Some(if seen.new { Kind::WebGl2 } else { Kind::WebGl1 })
    } else {
        None
    };
    // Every pass of ShaderToy is a fragment shader, whatever it mentions.
    let stage = match kind {
        Some(Kind::ShaderToy(_)) => Some(Stage::Fragment),
        _ if seen.vertex => Some(Stage::Vertex),
        _ => None,
    };
    Guess { kind, stage }
}

/// Words that tell the stage. Behind a `#version` no other word tells anything.
const VERTEX_WORDS: [&str; 2] = ["attribute", "gl_Position"];

#[derive(Default)]
struct Seen {
    version: bool,
    pass: Option<Pass>,
    old: bool,
    new: bool,
    main: bool,
    vertex: bool,
}

impl Seen {
    fn read(&mut self, text: &str) {
        use crate::syntax::{Lexer, RawKind};
        let mut lexer = Lexer::new(text, 0);
        let mut behind_hash = false;
        let may_be_vertex = VERTEX_WORDS.iter().any(|w| text.contains(w));
        while may_be_vertex || !self.version {
            let token = lexer.next_token();
            match token.kind {
                RawKind::End => return,
                RawKind::Whitespace => continue,
                RawKind::Word => {
                    let word = text.get(token.span.start as usize..token.span.end as usize);
                    self.word(word.unwrap_or(""), behind_hash);
                }
                _ => {}
            }
            behind_hash = token.kind == RawKind::Hash;
        }
    }

    fn word(&mut self, word: &str, behind_hash: bool) {
        match word {
            "version" if behind_hash => self.version = true,
            "mainImage" => self.pass = Some(Pass::Image),
            "mainCubemap" if self.pass.is_none() => self.pass = Some(Pass::Cubemap),
            "mainSound" if self.pass.is_none() => self.pass = Some(Pass::Sound),
            "attribute" | "varying" | "gl_FragColor" | "gl_FragData" | "texture2D"
            | "textureCube" => {
                self.old = true;
                self.vertex |= word == "attribute";
            }
            "texture" | "texelFetch" | "textureLod" | "out" | "uint" | "flat" | "layout" => {
                self.new = true
            }
            "gl_Position" => self.vertex = true,
            "main" => self.main = true,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, kind: Option<Kind>) {
        assert_eq!(guess(text).kind, kind, "{text}");
    }

    #[test]
    fn the_words_of_a_text_tell_what_it_is_for() {
        check(
            "#version 300 es\nvoid mainImage(){} void main(){}",
            Some(Kind::Versioned),
        );
        check("\n  # version 100\n", Some(Kind::Versioned));
        check(
            "void mainImage(out vec4 c, vec2 f){}",
            Some(Kind::ShaderToy(Pass::Image)),
        );
        check("// mainImage\nfloat f(){return 1.;}", None);
        check("void main(){ gl_FragColor = vec4(1); }", Some(Kind::WebGl1));
        check(
            "out vec4 c; void main(){ c = vec4(1); }",
            Some(Kind::WebGl2),
        );
        check("float f(float x) { return x; }", None);
        assert_eq!(
            guess("void main(){gl_Position=vec4(0);}").stage,
            Some(Stage::Vertex)
        );
    }
}
