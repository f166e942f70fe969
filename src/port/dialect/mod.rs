//! What hosts do to a text that data cannot say, attached to them by their names, and how a text shows
//! who runs it.
//!
//! The names that a host sets and what they mean are in its file (`src/host/presets`). A file here
//! has what further shows it and what goes around a text. Texts are never printed anew: whatever a
//! host puts around them goes before and behind.

mod bind;
mod bookofshaders;
mod clues;
mod complete;
mod isf;
mod kodi;
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
use clues::VersionAsked;
pub use clues::{Clues, Interfacing};
pub(crate) use complete::best;
pub use complete::{Completion, TextChange};
pub(super) use vertex::PLACES;
pub use vertex::VaryingValue;

use super::{Input, InputKind, OutputId, PassDraw, SamplerSettings, UniformControl};
use complete::{completions_behind, completions_of, declarations, has_images, without_own};
use shaderlint_host::{Feed, Preset, TextSign, is_named, preset, presets};
use shaderlint_semantic::{Pass, Program, Stage};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What of a host is no data.
struct HostCode {
    /// Its name.
    host: &'static str,
    /// What shows it besides the names that it sets.
    signs: fn(&Clues) -> Vec<Sign>,
    /// How a text becomes passes; `None` where ShaderToy's player runs it.
    plan: Option<fn(&Clues) -> Plan>,
}

/// Something in a text that shows a dialect.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sign {
    /// What it is, as it is told.
    pub what: String,
    /// How much it tells; [`ENOUGH`] is enough.
    pub weight: u8,
    /// Whether it is a form that the texts of no other host have, which leaves no doubt.
    pub is_form: bool,
}

impl Sign {
    /// A sign.
    pub fn new(what: impl Into<String>, weight: u8) -> Sign {
        Sign {
            what: what.into(),
            weight,
            is_form: false,
        }
    }

    /// A form that the texts of one host have alone.
    pub fn form(what: impl Into<String>, weight: u8) -> Sign {
        Sign {
            is_form: true,
            ..Sign::new(what, weight)
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
    /// Whether it is the text itself, and neither one beside it nor one that was made for it.
    pub is_of_text: bool,
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
                is_of_text: true,
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
            is_of_text: true,
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
            is_of_text: false,
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

static CODES: &[&HostCode] = &[
    &bookofshaders::CODE,
    &isf::CODE,
    &kodi::CODE,
    #[cfg(feature = "cli")]
    &shadered::CODE,
    &shadertoy::CODE,
    &synthclipse::CODE,
    &three::CODE,
    &twigl::CODE,
    &vertexshaderart::CODE,
    &vscode::CODE,
];

fn code_of(host: &Preset) -> Option<&'static HostCode> {
    CODES.iter().copied().find(|code| code.host == host.name)
}

/// A host, and those whose names mean the same wherever they occur: a page, and ShaderToy.
fn with_usual(host: &Preset) -> impl Iterator<Item = &Preset> {
    let usual: [Option<&Preset>; 3] = [Some(host), preset("webgl"), preset("shadertoy")];
    usual.into_iter().flatten()
}

/// The passes that a text of a host becomes; `None` where ShaderToy's player runs it.
pub(super) fn plan(host: &Preset, clues: &Clues) -> Option<Plan> {
    match code_of(host) {
        Some(code) => code.plan.map(|plan| plan(clues)),
        None => Some(match base_plan(host) {
            Some(plan) => plan_with_own(plan(clues), host, clues),
            None => usual_plan(host, clues),
        }),
    }
}

/// How a text becomes passes for the host that one builds on.
fn base_plan(host: &Preset) -> Option<fn(&Clues) -> Plan> {
    code_of(preset(host.base?)?)?.plan
}

/// A plan of a host's base, with what the host declares besides.
fn plan_with_own(mut plan: Plan, host: &Preset, clues: &Clues) -> Plan {
    let own = without_own(&host.own_declarations(false), clues);
    let candidates = plan.passes.iter_mut().flat_map(|p| &mut p.candidates);
    for candidate in candidates.filter(|c| !c.before.is_empty()) {
        candidate.before = Arc::from(format!("{}{own}", candidate.before));
    }
    plan
}

/// One pass: the text behind what its host declares, and as it stands.
fn usual_plan(host: &Preset, clues: &Clues) -> Plan {
    let mut candidates = Vec::new();
    if !host.prelude.trim().is_empty() {
        let before = declarations(host, clues, false);
        candidates = completions_behind(clues, &before, false);
    }
    let calls = host.entries.iter().any(|entry| entry == "mainImage");
    if calls && clues.has_word("mainImage") && !clues.guess.has_main {
        return Plan::picture(
            candidates
                .into_iter()
                .map(Completion::calling_image)
                .collect(),
        );
    }
    candidates.extend(completions_of(clues));
    let mut plan = Plan::picture(candidates);
    if has_images(clues) {
        let note = "WebGL has no images that shaders write to: what is read of them is 0";
        plan.notes.push(note.to_string());
    }
    plan
}

/// How much evidence makes a dialect: a name of its own, or two that others use, too.
pub const ENOUGH: u32 = 2;

/// Who runs a text, and why that is thought.
#[derive(Debug)]
pub struct Recognised {
    /// The host.
    pub host: &'static Preset,
    /// What shows it, the strongest first.
    pub signs: Vec<Sign>,
    /// Another host for which as much speaks.
    pub tied: Option<&'static Preset>,
}

impl Recognised {
    /// What the user says.
    pub fn given(host: &'static Preset) -> Recognised {
        Recognised {
            host,
            signs: Vec::new(),
            tied: None,
        }
    }

    /// Whether ShaderToy's player runs the text.
    pub fn is_player(&self) -> bool {
        is_player(self.host)
    }
}

fn is_player(host: &Preset) -> bool {
    code_of(host).is_some_and(|code| code.plan.is_none())
}

/// The host that a text is written for: the one for which the most speaks. `None` where there is not
/// even a page, the host of all others.
pub fn recognise(clues: &Clues) -> Option<Recognised> {
    let mut found: Vec<(u32, &'static Preset, Vec<Sign>)> = Vec::new();
    let is_desktop = matches!(clues.asked, VersionAsked::Desktop(_));
    for host in presets().filter(|h| !is_desktop || h.runs_desktop()) {
        let signs = signs(host, clues);
        let weight = weight(&signs);
        if weight >= ENOUGH {
            found.push((weight, host, signs));
        }
    }
    // Of those for which as much speaks the first is taken, and the player only where it is alone:
    // others run texts with its entry, too.
    found.sort_by_key(|(weight, host, _)| (std::cmp::Reverse(*weight), is_player(host)));
    let mut found = found.into_iter();
    let Some((weight, host, signs)) = found.next() else {
        return preset("webgl").map(Recognised::given);
    };
    let tied = found.next().filter(|(other, ..)| *other == weight);
    Some(Recognised {
        host,
        signs,
        tied: tied.map(|(_, host, _)| host),
    })
}

/// A text of a host that WebGL does not compile as it stands, and what it becomes.
#[derive(Debug)]
pub struct Hosted {
    /// Who runs it.
    pub recognised: Recognised,
    /// The text, and what goes around it.
    pub completion: Completion,
    /// The texts beside it that it asks for, and that have not been read.
    pub wanted: Vec<String>,
}

impl Hosted {
    /// Whether there is no doubt of the host: the user names it, or the text has a form of its own.
    pub fn is_sure(&self) -> bool {
        let signs = &self.recognised.signs;
        signs.is_empty() || signs.iter().any(|sign| sign.is_form)
    }

    /// What is changed in a piece of the text, so that it can be compiled there.
    pub fn changes(&self, piece: &str) -> Vec<TextChange> {
        match self.completion.before.is_empty() {
            true => Vec::new(),
            false => complete::changes(piece, self.recognised.host),
        }
    }
}

/// Whether a text may be of a host that composes a shader of it; asked before more is done to know.
pub fn may_be_composed(text: &str) -> bool {
    // What tells passes of the player's from those of its likes are directives.
    if text.contains("mainImage") && !vscode::may_have_directives(text) {
        return false;
    }
    let nothing = TextsBeside::new();
    let clues = Clues::unread(text, "", &nothing);
    let mut hosts = presets().filter(|h| h.composes);
    hosts.any(|h| weight(&signs(h, &clues)) >= ENOUGH)
}

/// What becomes of a text that a known host runs: the one that the user names, or that the text
/// shows. `None` where nothing shows one.
pub fn hosted(clues: &Clues, given: Option<&'static Preset>) -> Option<Hosted> {
    let recognised = match given {
        Some(host) => Recognised::given(host),
        None => recognise(clues).filter(|found| !found.signs.is_empty())?,
    };
    let host = recognised.host;
    let plan = plan(host, clues)?;
    let draws_vertices = plan.draws.iter().any(|d| d.has_vertices);
    if plan.is_description || clues.guess.stage == Some(Stage::Vertex) && !draws_vertices {
        return None;
    }
    let own = plan.passes.into_iter().rfind(|pass| pass.is_of_text)?;
    let completion = best(own.candidates)?;
    // Places are those of the text only where it is all of it; what directives put in is told apart.
    let is_text = *complete::changed(clues.text, &completion.changes) == *completion.code;
    (is_text || !host.directives.is_empty()).then_some(Hosted {
        recognised,
        completion,
        wanted: plan.wanted,
    })
}

/// Whether a host other than ShaderToy's player calls ShaderToy's entry.
pub fn calls_entry(host: &Preset) -> bool {
    !is_player(host) && host.entries.iter().any(|entry| entry == "mainImage")
}

/// What a checked shader is given that is whole, or that ShaderToy's player completes. `given` is who
/// runs it, as the user says.
pub fn bindings(program: &Program, given: Option<&'static Preset>) -> Bindings {
    let text = own_text(program);
    let clues = Clues::checked(&text, program);
    let given = given.map(Recognised::given);
    let Some(recognised) = given.or_else(|| recognise(&clues)) else {
        return Bindings::default();
    };
    let mut bound = bind(program, recognised.host, (&[], &[]), None, None);
    // What a host declares it sets itself.
    bound.controls.retain(|c| clues.declares(&c.name));
    let is_own = |name: &str, source| source != Feed::Control || clues.declares(name);
    bound.uniforms.retain(|u| is_own(&u.name, u.source));
    bound.zeros.retain(|name| clues.declares(name));
    bound
}

/// The texts of the user that a program was made of: of a page, those of this shader alone.
fn own_text(program: &Program) -> Cow<'_, str> {
    let mut texts: Vec<&str> = Vec::new();
    let mut last = 0..0;
    for token in &program.tokens.tokens {
        let start = token.span.start;
        if last.contains(&start) || !program.is_user(token.span) {
            continue;
        }
        let Some(code) = program.sources.code_at(start) else {
            continue;
        };
        last = code.base..code.base + code.text.len() as u32;
        if !texts.iter().any(|t| std::ptr::eq(*t, code.text)) {
            texts.push(code.text);
        }
    }
    match texts.as_slice() {
        [text] => Cow::Borrowed(*text),
        texts => Cow::Owned(texts.join("\n")),
    }
}

/// How much signs tell together.
fn weight(signs: &[Sign]) -> u32 {
    signs.iter().map(|s| u32::from(s.weight)).sum()
}

/// What speaks for a host, the strongest first.
fn signs(host: &Preset, clues: &Clues) -> Vec<Sign> {
    let mut found = code_of(host).map_or(Vec::new(), |code| (code.signs)(clues));
    let has = |sign: &&TextSign| sign.words.iter().all(|w| clues.has_word(w));
    found.extend(host.signs.iter().filter(has).map(|sign| {
        let first = sign.words.first().map_or("", String::as_str);
        Sign::new(format!("`{first}`"), sign.weight)
    }));
    let declares = host.declares();
    let shows = |name: &str, types: &dyn Fn(&str) -> bool| {
        let is_row = |d: &&Interfacing| is_named(name, &d.name) && types(&d.ty);
        let declared = clues.uniforms.iter().chain(&clues.inputs).find(is_row);
        match declared {
            Some(d) => Some(d.name.clone()),
            None if declares => {
                let free = clues.free_words(|w| is_named(name, w));
                free.first().map(|w| w.to_string())
            }
            None => None,
        }
    };
    let names = &host.meanings;
    for row in names.feeds.iter().filter(|r| r.weight > 0) {
        let name = shows(&row.name, &|ty| row.types.iter().any(|own| own == ty));
        found.extend(name.map(|n| Sign::new(format!("`{n}`"), row.weight)));
    }
    for row in names.textures.iter().filter(|r| r.weight > 0) {
        let name = shows(&row.name, &|ty| SAMPLERS.contains(&ty));
        found.extend(name.map(|n| Sign::new(format!("`{n}`"), row.weight)));
    }
    for row in names.varyings.iter().filter(|r| r.weight > 0) {
        let name = shows(&row.name, &|ty| row.ty == ty);
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
        let tied = self.tied.map_or(String::new(), |other| {
            format!(
                "; as much speaks for {}: `--host {}` insists",
                other.read_as(),
                other.name
            )
        });
        format!("read as {}{tied}", self.title_and_signs())
    }

    /// Who runs the text, and what shows it.
    pub fn title_and_signs(&self) -> String {
        let title = self.host.read_as();
        let signs: Vec<&str> = self.signs.iter().map(|s| s.what.as_str()).take(4).collect();
        match signs.as_slice() {
            [] => title.to_string(),
            signs => format!("{title}, by {}", signs.join(", ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The dialect that a text is taken for.
    #[track_caller]
    fn check(text: &str, dialect: &str) {
        let found = recognise(&Clues::of(text)).unwrap();
        assert_eq!(found.host.name, dialect, "{:?}\n{text}", found.signs);
        assert_eq!(found.tied, None, "{text}");
    }

    #[test]
    fn what_speaks_for_two_dialects_is_told() {
        let text = "precision highp float;\nuniform vec3 spectrum;\nvarying vec2 surfacePosition;\n\
            void main() { gl_FragColor = vec4(surfacePosition, spectrum.xy); }";
        let found = recognise(&Clues::of(text)).unwrap();
        let told = found.told();
        assert!(told.ends_with("`--host kodelife` insists"), "{told}");
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
        for host in presets() {
            for ty in host.meanings.feeds.iter().flat_map(|r| &r.types) {
                let element = ty.split('[').next().unwrap_or(ty);
                assert!(TypeWord::named(element).is_some(), "{}: {ty}", host.name);
            }
            let mut varyings = host.meanings.varyings.iter();
            assert!(varyings.all(|r| TypeWord::named(&r.ty).is_some()));
        }
        assert!(CODES.iter().all(|code| preset(code.host).is_some()));
    }
}
