//! The dialects of GLSL that people write: what each site, tool and library declares, completes and
//! sets, as data, and how a text shows in which it is written.
//!
//! A dialect is a file here: the names that it sets and what they mean ([`FeedRow`],
//! [`TextureRow`], [`VaryingRow`]), what further shows it, and what goes around a text. Texts are
//! never printed anew: whatever a host puts around them goes before and behind.

mod bind;
mod bonzomatic;
mod bookofshaders;
mod clues;
mod complete;
mod feed;
mod glslsandbox;
mod isf;
mod kodelife;
mod kodi;
mod page;
#[cfg(feature = "cli")]
mod shadered;
mod shadertoy;
mod synthclipse;
mod three;
mod twigl;
mod vertex;
mod vertexshaderart;
mod vscode;

pub(super) use bind::bind;
pub use bind::{Bindings, MAX_CHANNELS, UniformData};
pub use clues::{Clues, Interfacing};
pub use complete::Completion;
pub(crate) use complete::best;
pub(super) use feed::PLACES;
pub use feed::{Feed, FeedRow, TextureRow, VaryingRow};
pub use vertex::VaryingValue;

use super::{Input, InputKind, OutputId, PassDraw, SamplerSettings, UniformControl};
use feed::is_named;
use shaderlint_semantic::{Pass, Program};
use shaderlint_text::{Role, SourceFile};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// What is known of a dialect.
pub struct DialectFacts {
    /// How options name it.
    pub name: &'static str,
    /// How people name it.
    pub title: &'static str,
    /// What its uniforms are given.
    pub feeds: &'static [FeedRow],
    /// What its samplers read.
    pub textures: &'static [TextureRow],
    /// What its varyings hold.
    pub varyings: &'static [VaryingRow],
    /// Whether its host declares these names, so that a text uses them undeclared.
    pub declares: bool,
    /// What else shows it.
    pub signs: fn(&Clues) -> Vec<Sign>,
    /// How a text becomes passes; `None` where ShaderToy's player runs it.
    pub plan: Option<fn(&Clues) -> Plan>,
}

impl fmt::Debug for DialectFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl PartialEq for DialectFacts {
    fn eq(&self, other: &DialectFacts) -> bool {
        self.name == other.name
    }
}

/// Something in a text that shows a dialect.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sign {
    /// What it is, as it is told.
    pub what: String,
    /// How much it tells; [`ENOUGH`] is enough.
    pub weight: u8,
}

impl Sign {
    /// A sign.
    pub fn new(what: impl Into<String>, weight: u8) -> Sign {
        Sign {
            what: what.into(),
            weight,
        }
    }
}

/// The passes that a text becomes.
#[derive(Default)]
pub struct Plan {
    /// They, in the order in which they are drawn.
    pub passes: Vec<PlannedPass>,
    /// What its head lets the user set.
    pub controls: Vec<UniformControl>,
    /// How they are drawn, where that is not usual: as many as there are passes, or none.
    pub draws: Vec<PassDraw>,
    /// What is to be told.
    pub notes: Vec<String>,
    /// The texts beside it that it asks for, and that have not been read.
    pub wanted: Vec<String>,
    /// What the head calls it, and who made it.
    pub credit: Option<Credit>,
    /// Whether the text is the description of a project, and no shader.
    pub is_description: bool,
}

/// Texts beside a text, by their paths from its folder; `None` where there is no such file.
pub type TextsBeside = BTreeMap<String, Option<Arc<str>>>;

/// What a text's head tells of its author.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Credit {
    /// Who made it.
    pub author: String,
    /// What they say of it.
    pub description: String,
}

/// A pass that a text becomes.
pub struct PlannedPass {
    /// What it draws.
    pub kind: Pass,
    /// Its name.
    pub name: String,
    /// What it writes to.
    pub output: OutputId,
    /// What may go around the text, the best first.
    pub candidates: Vec<Completion>,
    /// What its samplers read, where the text says it; by [`Input::uniform`].
    pub inputs: Vec<Input>,
}

impl Plan {
    /// A picture of one pass.
    pub fn picture(candidates: Vec<Completion>) -> Plan {
        Plan {
            passes: vec![PlannedPass {
                kind: Pass::Image,
                name: String::new(),
                output: OutputId(OutputId::IMAGE.to_string()),
                candidates,
                inputs: Vec::new(),
            }],
            ..Plan::default()
        }
    }
}

impl PlannedPass {
    /// A pass that draws into a buffer of a name.
    pub fn buffer(name: &str, candidates: Vec<Completion>) -> PlannedPass {
        PlannedPass {
            kind: Pass::Buffer,
            name: name.to_string(),
            output: OutputId::of_dialect(name),
            candidates,
            inputs: Vec::new(),
        }
    }

    /// The picture: what a buffer holds, as it is.
    pub fn copy_of(name: &str) -> PlannedPass {
        let code = "precision highp float;\nuniform sampler2D port_buffer;\nuniform vec2 resolution;\n\
            void main() {\n    gl_FragColor = texture2D(port_buffer, gl_FragCoord.xy / resolution);\n}\n";
        PlannedPass {
            kind: Pass::Image,
            name: "Picture".to_string(),
            output: OutputId(OutputId::IMAGE.to_string()),
            candidates: vec![Completion::bare(code)],
            inputs: vec![read_buffer("port_buffer", name)],
        }
    }
}

/// What a sampler reads of a buffer of a name.
fn read_buffer(uniform: &str, buffer: &str) -> Input {
    Input {
        id: OutputId::of_dialect(buffer).0,
        ..sampled(uniform, InputKind::Buffer, ("linear", "clamp"))
    }
}

/// What a sampler reads, and with which filter and wrap.
fn sampled(uniform: &str, kind: InputKind, how: (&str, &str)) -> Input {
    Input {
        uniform: Some(uniform.to_string()),
        sampler: SamplerSettings {
            filter: how.0.to_string(),
            wrap: how.1.to_string(),
            vflip: kind != InputKind::Cubemap,
        },
        ..Input::empty(0, kind)
    }
}

/// All dialects, those with the most of their own first.
pub static DIALECTS: &[&DialectFacts] = &[
    #[cfg(feature = "cli")]
    &shadered::FACTS,
    &synthclipse::FACTS,
    &vscode::FACTS,
    &vertexshaderart::FACTS,
    &isf::FACTS,
    &glslsandbox::FACTS,
    &bonzomatic::FACTS,
    &bookofshaders::FACTS,
    &kodelife::FACTS,
    &twigl::FACTS,
    &three::FACTS,
    &kodi::FACTS,
    &page::FACTS,
    &shadertoy::FACTS,
];

/// The dialect of a name.
pub fn dialect_named(name: &str) -> Option<&'static DialectFacts> {
    DIALECTS.iter().copied().find(|d| d.name == name)
}

/// How much evidence makes a dialect: a name of its own, or two that others use, too.
pub const ENOUGH: u32 = 2;

/// What was recognised.
#[derive(Debug)]
pub struct Recognised {
    /// The dialect.
    pub dialect: &'static DialectFacts,
    /// What shows it, the strongest first.
    pub signs: Vec<Sign>,
    /// Another dialect for which as much speaks.
    pub tied: Option<&'static DialectFacts>,
}

/// The dialect that a text is written in: the one for which the most speaks.
pub fn recognise(clues: &Clues) -> Recognised {
    let mut found: Vec<(u32, &'static DialectFacts, Vec<Sign>)> = Vec::new();
    for dialect in DIALECTS.iter().copied() {
        let signs = signs(dialect, clues);
        let weight = signs.iter().map(|s| u32::from(s.weight)).sum();
        if weight >= ENOUGH {
            found.push((weight, dialect, signs));
        }
    }
    // Stable: of those for which as much speaks, the first of the list is taken.
    found.sort_by_key(|(weight, ..)| std::cmp::Reverse(*weight));
    let mut found = found.into_iter();
    let Some((weight, dialect, signs)) = found.next() else {
        return Recognised {
            dialect: &page::FACTS,
            signs: Vec::new(),
            tied: None,
        };
    };
    let tied = found.next().filter(|(other, ..)| *other == weight);
    Recognised {
        dialect,
        signs,
        tied: tied.map(|(_, dialect, _)| dialect),
    }
}

/// What a checked shader is given that is whole, or that ShaderToy's player completes.
pub fn bindings(program: &Program) -> Bindings {
    let is_user = |f: &&SourceFile| f.role == Role::User;
    let text = program.sources.files().iter().find(is_user);
    let clues = Clues::checked(text.map_or("", |f| &f.text), program);
    let mut bound = bind(program, recognise(&clues).dialect, (&[], &[]), None, None);
    // What a host declares it sets itself.
    bound.controls.retain(|c| clues.declares(&c.name));
    let is_own = |name: &str, source| source != Feed::Control || clues.declares(name);
    bound.uniforms.retain(|u| is_own(&u.name, u.source));
    bound.zeros.retain(|name| clues.declares(name));
    bound
}

/// What speaks for a dialect, the strongest first.
fn signs(dialect: &DialectFacts, clues: &Clues) -> Vec<Sign> {
    let mut found = (dialect.signs)(clues);
    let shows = |name: &str, types: &[&str]| {
        let is_row = |d: &&Interfacing| is_named(name, &d.name) && types.contains(&d.ty.as_str());
        let declared = clues.uniforms.iter().chain(&clues.inputs).find(is_row);
        match declared {
            Some(d) => Some(d.name.clone()),
            None if dialect.declares => {
                let free = clues.free_words(|w| is_named(name, w));
                free.first().map(|w| w.to_string())
            }
            None => None,
        }
    };
    let feeds = dialect.feeds.iter().map(|r| (r.name, r.types, r.weight));
    let textures = dialect.textures.iter();
    let textures = textures.map(|r| (r.name, SAMPLERS, r.weight));
    for (name, types, weight) in feeds.chain(textures).filter(|(.., w)| *w > 0) {
        found.extend(shows(name, types).map(|n| Sign::new(format!("`{n}`"), weight)));
    }
    for row in dialect.varyings.iter().filter(|r| r.weight > 0) {
        let name = shows(row.name, &[row.ty]);
        found.extend(name.map(|n| Sign::new(format!("`{n}`"), row.weight)));
    }
    found.dedup();
    found.sort_by_key(|s| std::cmp::Reverse(s.weight));
    found
}

/// The types of samplers that hold pictures. Desktops have lines of one dimension, too.
const SAMPLERS: &[&str] = &["sampler2D", "samplerCube", "sampler3D", "sampler1D"];

impl Recognised {
    /// What is told of it: what it was taken for, and why.
    pub fn told(&self) -> String {
        let title = self.dialect.title;
        let signs: Vec<&str> = self.signs.iter().map(|s| s.what.as_str()).take(4).collect();
        let why = match signs.as_slice() {
            [] => String::new(),
            signs => format!(", by {}", signs.join(", ")),
        };
        let tied = self.tied.map_or(String::new(), |other| {
            format!(
                "; as much speaks for {}: `--from {}` insists",
                other.title, other.name
            )
        });
        format!("read as {title}{why}{tied}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The dialect that a text is taken for.
    #[track_caller]
    fn check(text: &str, dialect: &str) {
        let found = recognise(&Clues::of(text));
        assert_eq!(found.dialect.name, dialect, "{:?}\n{text}", found.signs);
        assert_eq!(found.tied, None, "{text}");
    }

    #[test]
    fn what_speaks_for_two_dialects_is_told() {
        let text = "precision highp float;\nuniform vec3 spectrum;\nvarying vec2 surfacePosition;\n\
            void main() { gl_FragColor = vec4(surfacePosition, spectrum.xy); }";
        let found = recognise(&Clues::of(text));
        let told = found.told();
        assert!(told.ends_with("`--from kodelife` insists"), "{told}");
    }

    #[test]
    fn names_of_its_own_make_a_dialect() {
        let old = |head: &str| {
            format!("precision mediump float;\n{head}\nvoid main() {{ gl_FragColor = vec4(1.0); }}")
        };
        check(
            &old("uniform float time; uniform vec2 resolution;"),
            "glsl-sandbox",
        );
        check(&old("varying vec2 surfacePosition;"), "glsl-sandbox");
        check(
            &old("uniform float u_time; uniform vec2 u_resolution;"),
            "book-of-shaders",
        );
        check(
            &old("uniform float time; uniform vec3 spectrum;"),
            "kodelife",
        );
        check(&old("varying vec2 vUv; uniform float uTime;"), "three");
        check(&old("uniform vec2 r; uniform float t;"), "twigl");
        check(
            "void main() { gl_FragColor = vec4(vUv, cameraPosition.xy); }",
            "three",
        );
        check(
            "#version 410 core\nuniform float fGlobalTime;\nout vec4 c;\nvoid main() { c = vec4(fGlobalTime); }",
            "bonzomatic",
        );
        check("o=vec4(FC.xy/r,sin(t),1);", "twigl");
        check("void main(){o=vec4(gl_FragCoord.xy/r,sin(t),1);}", "twigl");
    }

    #[test]
    fn common_names_make_none() {
        let image = |body: &str| format!("void mainImage(out vec4 o, in vec2 u) {{ {body} }}");
        check(
            &image("float time = iTime; vec2 resolution = iResolution.xy; o = vec4(time);"),
            "shadertoy",
        );
        check(
            &image("float t = iTime; vec2 r = iResolution.xy; o = vec4(u / r, t, 1);"),
            "shadertoy",
        );
        check(
            "#define R iResolution\n#define T iTime\nvoid mainImage(out vec4 o, vec2 u) { o = vec4(u / R.xy, T, 1); }",
            "shadertoy",
        );
        check(
            "uniform float time;\nvoid main() { gl_FragColor = vec4(time); }",
            "webgl",
        );
        check(
            "uniform int time; uniform vec4 resolution;\nvoid main() { gl_FragColor = resolution; }",
            "webgl",
        );
        check(
            "void main() { float r = 1.0, t = 2.0; gl_FragColor = vec4(r, t, 0.0, 1.0); }",
            "webgl",
        );
        check(
            "varying vec2 vUv;\nvoid main() { gl_FragColor = vec4(vUv, 0.0, 1.0); }",
            "webgl",
        );
    }

    #[test]
    fn every_row_names_types_of_glsl() {
        use shaderlint_syntax::TypeWord;
        for dialect in DIALECTS {
            for ty in dialect.feeds.iter().flat_map(|r| r.types) {
                let element = ty.split('[').next().unwrap_or(ty);
                assert!(TypeWord::named(element).is_some(), "{}: {ty}", dialect.name);
            }
            let varyings = dialect.varyings.iter();
            assert!(varyings.clone().all(|r| TypeWord::named(r.ty).is_some()));
            assert_eq!(dialect_named(dialect.name), Some(*dialect));
        }
    }
}
