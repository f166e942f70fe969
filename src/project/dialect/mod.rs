//! The code of hosts: everything that the data in their presets cannot express, and the detection
//! of hosts.
//!
//! The names that a host sets and their values are in its file (`src/host/presets`). A file here
//! contains further evidence for the host and the text that it adds. Texts are never reformatted: a
//! host only adds text before and after.

mod around;
mod bind;
mod bookofshaders;
mod clues;
mod complete;
mod isf;
#[cfg(feature = "cli")]
mod kodelife;
mod kodi;
mod shadertoy;
mod three;
mod twigl;
mod vertex;
mod vertexshaderart;
mod vscode;

pub use around::{
    has_no_chunks, imported_hosts, installed_hosts, installed_release, uses_installed,
};
pub use bind::bind;
pub use bind::{Bindings, MAX_CHANNELS, UniformData};
use clues::VersionAsked;
pub use clues::{Clues, HostsAround, Interfacing};
pub use complete::best;
pub use complete::{Completion, TextChange};
pub(crate) use shadertoy::framed;
pub(super) use vertex::PLACES;
pub use vertex::VaryingValue;

use super::{GatheredText, Input, InputKind, OutputId, PassDraw, SamplerSettings, UniformControl};
use complete::{completions_after, completions_of, declarations, has_images, modern, without_own};
use shaderlint_host::{
    Feed, HostVersion, OWN, Preset, TextSign, declared_in, is_named, is_one_name, preset, presets,
};
use shaderlint_semantic::{Pass, Program, Stage, guess};
use shaderlint_text::TextPiece;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The code of a host.
struct HostCode {
    /// The name of its preset.
    host: &'static str,
    /// Finds evidence in addition to the names that it sets.
    signs: fn(&Clues) -> Vec<Sign>,
    /// Splits a text into passes; `None` for ShaderToy's player.
    plan: Option<fn(&Clues) -> Plan>,
    /// Declares a uniform whose value and range are in the text; `None` if the host has no such.
    declare: Option<DeclareControl>,
}

/// Writes the declaration of a uniform with a control into a text with this offset for declarations.
/// Returns where it is inserted, and what.
type DeclareControl = fn(&str, usize, &UniformControl) -> Option<(usize, String)>;

/// The declaration of a uniform with a control, as a host reads it, for a text in which `at` is an
/// offset for declarations: where it is inserted, and what. `None` if the host sets no uniforms to
/// values in the text.
pub fn declared_control(
    host: &Preset,
    text: &str,
    at: usize,
    control: &UniformControl,
) -> Option<(usize, String)> {
    code_of(host)?.declare?(text, at, control)
}

/// Evidence for a host in a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sign {
    /// The evidence as shown in messages.
    pub what: String,
    /// The strength; a sum of [`ENOUGH`] is sufficient.
    pub weight: u8,
    /// Whether it is a syntax that only this host has, which makes it certain.
    pub is_form: bool,
}

impl Sign {
    /// Evidence that other hosts could share.
    pub fn new(what: impl Into<String>, weight: u8) -> Sign {
        Sign {
            what: what.into(),
            weight,
            is_form: false,
        }
    }

    /// A syntax that only one host has.
    pub fn form(what: impl Into<String>, weight: u8) -> Sign {
        Sign {
            is_form: true,
            ..Sign::new(what, weight)
        }
    }
}

/// The passes of a text.
#[derive(Default)]
pub struct Plan {
    /// The passes in the order in which they are drawn.
    pub passes: Vec<PlannedPass>,
    /// The controls that its header defines.
    pub controls: Vec<UniformControl>,
    /// Draw settings, one for each pass; empty for default settings.
    pub draws: Vec<PassDraw>,
    /// Notes for the user.
    pub notes: Vec<String>,
    /// Companion files that it refers to and that have not been read yet.
    pub requested: Vec<String>,
    /// Author and description in the header.
    pub credit: Option<Credit>,
    /// Whether the text is the description of a project and not a shader.
    pub is_description: bool,
}

/// Companion files with what they include, by the paths that texts name them with; `None` for a
/// missing file.
pub type SiblingTexts = BTreeMap<String, Option<Arc<GatheredText>>>;

/// Credits in a header.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Credit {
    pub author: String,
    /// The author's description.
    pub description: String,
}

/// A pass of a text.
pub struct PlannedPass {
    pub kind: Pass,
    /// The name; empty for a single pass.
    pub name: String,
    /// The id of its output.
    pub output: OutputId,
    /// Candidates for the completed text, best first.
    pub candidates: Vec<Completion>,
    /// The inputs of its samplers that the text defines, identified by [`Input::uniform`].
    pub inputs: Vec<Input>,
    /// Whether its code is the text itself, and not a companion file or generated.
    pub is_of_text: bool,
    /// The files that its code was put together from.
    pub pieces: Vec<TextPiece>,
}

impl Plan {
    /// A plan with a single Image pass.
    pub fn image(candidates: Vec<Completion>) -> Plan {
        Plan {
            passes: vec![PlannedPass::image(candidates)],
            ..Plan::default()
        }
    }
}

impl PlannedPass {
    /// The Image pass.
    pub fn image(candidates: Vec<Completion>) -> PlannedPass {
        PlannedPass {
            kind: Pass::Image,
            name: String::new(),
            output: OutputId(OutputId::IMAGE.to_string()),
            candidates,
            inputs: Vec::new(),
            is_of_text: true,
            pieces: Vec::new(),
        }
    }

    /// A pass that draws into a named buffer.
    pub fn buffer(name: &str, candidates: Vec<Completion>) -> PlannedPass {
        PlannedPass {
            kind: Pass::Buffer,
            name: name.to_string(),
            output: OutputId::of_dialect(name),
            ..PlannedPass::image(candidates)
        }
    }

    /// An Image pass that copies a buffer.
    pub fn copy_of(name: &str) -> PlannedPass {
        let code = "precision highp float;\nuniform sampler2D port_buffer;\nuniform vec2 resolution;\n\
            void main() {\n    gl_FragColor = texture2D(port_buffer, gl_FragCoord.xy / resolution);\n}\n";
        PlannedPass {
            name: "Image".to_string(),
            inputs: vec![read_buffer("port_buffer", name)],
            is_of_text: false,
            ..PlannedPass::image(vec![Completion::bare(code)])
        }
    }
}

/// A sampler that reads a named buffer.
fn read_buffer(uniform: &str, buffer: &str) -> Input {
    Input {
        id: OutputId::of_dialect(buffer).0,
        ..sampled(uniform, InputKind::Buffer, ("linear", "clamp"))
    }
}

/// A sampler with a kind of input, filter and wrap mode.
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
    #[cfg(feature = "cli")]
    &kodelife::CODE,
    &kodi::CODE,
    &shadertoy::CODE,
    &three::CODE,
    &twigl::CODE,
    &vertexshaderart::CODE,
    &vscode::CODE,
];

fn code_of(host: &Preset) -> Option<&'static HostCode> {
    CODES.iter().copied().find(|code| code.host == host.name)
}

/// A host, and the hosts whose names have the same meaning everywhere: `webgl` and `shadertoy`.
fn with_usual(host: &Preset) -> impl Iterator<Item = &Preset> {
    let usual: [Option<&Preset>; 3] = [Some(host), preset("webgl"), preset("shadertoy")];
    usual.into_iter().flatten()
}

/// Splits a text of a host into passes; `None` for ShaderToy's player.
pub fn plan(host: &Preset, clues: &Clues) -> Option<Plan> {
    match code_of(host) {
        Some(code) => code.plan.map(|plan| plan(clues)),
        None => Some(match base_plan(host) {
            Some(plan) => plan_with_own(plan(clues), host, clues),
            None => usual_plan(host, clues),
        }),
    }
}

/// The plan function of the host that this one extends.
fn base_plan(host: &Preset) -> Option<fn(&Clues) -> Plan> {
    code_of(preset(host.base?)?)?.plan
}

/// Adds the declarations of a host to a plan of its base.
fn plan_with_own(mut plan: Plan, host: &Preset, clues: &Clues) -> Plan {
    let own = without_own(&host.own_declarations(false), clues);
    let candidates = plan.passes.iter_mut().flat_map(|p| &mut p.candidates);
    for candidate in candidates.filter(|c| !c.before.is_empty()) {
        candidate.before = Arc::from(format!("{}{own}", candidate.before));
    }
    plan
}

/// The default plan: one pass, with the declarations of the host or unchanged.
fn usual_plan(host: &Preset, clues: &Clues) -> Plan {
    let mut candidates = Vec::new();
    if !host.prelude.trim().is_empty() || !host.main.is_empty() {
        let before = declarations(host, clues, false);
        candidates = completions_after(clues, &before, false);
        if host.version == HostVersion::Desktop && clues.asked == VersionAsked::Nothing {
            candidates = vec![Completion::after(modern(clues) + &before, clues.text)];
        }
    }
    if !host.main.is_empty() {
        let mut entries = host.entries.iter();
        let own = entries.clone().find(|entry| clues.declares(entry));
        let entry = own.or(entries.next()).map_or("", String::as_str);
        let main = host.main.replace("port_entry", entry);
        return Plan::image(candidates.into_iter().map(|c| c.with_main(&main)).collect());
    }
    let calls = host.entries.iter().any(|entry| entry == "mainImage");
    if calls && clues.has_word("mainImage") && !clues.guess.has_main {
        return Plan::image(
            candidates
                .into_iter()
                .map(Completion::calling_image)
                .collect(),
        );
    }
    candidates.extend(completions_of(clues));
    let mut plan = Plan::image(candidates);
    let is_old = matches!(clues.asked, VersionAsked::Nothing | VersionAsked::Es100);
    if let Some(required) = host.required.as_ref().filter(|_| is_old) {
        plan.notes.push(format!(
            "{} requires `#version {}`, which the shader lacks",
            required.since, required.version
        ));
    }
    if has_images(clues) {
        let note = "WebGL has no writable images: reading them returns 0";
        plan.notes.push(note.to_string());
    }
    plan
}

/// The sum of weights that identifies a host: one name of its own, or two that others use too.
pub const ENOUGH: u32 = 2;

/// A detected host and the evidence for it.
#[derive(Clone, Debug)]
pub struct Recognised {
    /// The host.
    pub host: &'static Preset,
    /// The evidence, strongest first.
    pub signs: Vec<Sign>,
    /// Another host with equally strong evidence.
    pub tied: Option<&'static Preset>,
}

impl PartialEq for Recognised {
    fn eq(&self, other: &Recognised) -> bool {
        self.host.name == other.host.name && self.signs == other.signs
    }
}

impl Recognised {
    /// A host given by the user.
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

/// Whether ShaderToy's player is the host.
pub fn is_player(host: &Preset) -> bool {
    code_of(host).is_some_and(|code| code.plan.is_none())
}

/// The host with the strongest evidence in a text. `None` only if there is no preset `webgl`
/// either.
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
    // Of equally likely hosts the first one is used, and the player only if it is the only one:
    // others run texts with its entry function too.
    found.sort_by_key(|(weight, host, _)| (std::cmp::Reverse(*weight), is_player(host)));
    let mut found = found.into_iter();
    let Some((weight, host, signs)) = found.next() else {
        let around = || {
            let mut hosts = (clues.around)().into_iter();
            hosts.find_map(|host| shown_around(host, clues))
        };
        return around().or_else(|| preset("webgl").map(Recognised::given));
    };
    // A syntax that only one host has decides.
    let has_form = |signs: &[Sign]| signs.iter().any(|sign| sign.is_form);
    let is_tied = |other: u32, more: &[Sign]| other == weight && has_form(more) >= has_form(&signs);
    let tied = found
        .next()
        .filter(|(other, _, more)| is_tied(*other, more));
    Some(Recognised {
        host,
        signs,
        tied: tied.map(|(_, host, _)| host),
    })
}

/// A host of the program around a text as its host, if the text uses a name that the host declares
/// and that no other evidence explains.
fn shown_around(host: &'static Preset, clues: &Clues) -> Option<Recognised> {
    let declared = host.declarations(false);
    let mut names = declared.lines().filter_map(declared_in);
    let name = names.find(|name| clues.is_lacking(name))?;
    let package = host.packages.first();
    let mut signs = vec![Sign::new(format!("`{name}`"), OWN)];
    signs.extend(package.map(|package| Sign::new(format!("the package `{package}`"), 0)));
    Some(Recognised {
        host,
        signs,
        tied: None,
    })
}

/// A text of a host in completed form.
#[derive(Debug)]
pub struct Hosted {
    /// The host and the evidence for it.
    pub recognised: Recognised,
    /// The completed text.
    pub completion: Completion,
    /// Companion files that it refers to and that have not been read yet.
    pub requested: Vec<String>,
}

impl Hosted {
    /// Whether the host is certain: given by the user, or identified by its own syntax.
    pub fn is_sure(&self) -> bool {
        let signs = &self.recognised.signs;
        signs.is_empty() || signs.iter().any(|sign| sign.is_form)
    }

    /// The changes to a part of the text that allow it to be compiled.
    pub fn changes(&self, piece: &str) -> Vec<TextChange> {
        match self.completion.before.is_empty() {
            true => Vec::new(),
            false => complete::changes(piece, self.recognised.host),
        }
    }
}

/// A quick test for whether the declarations for a text may depend on it.
pub fn may_be_composed(text: &str) -> bool {
    // Only directives and names of their own distinguish passes of other hosts from those of the
    // player.
    let has_name = |host: &Preset| host.words.iter().any(|word| text.contains(word.as_str()));
    if text.contains("mainImage")
        && !guess(text).has_main
        && !asks_for_desktop(text)
        && !vscode::may_have_directives(text)
        && !presets().any(|host| host.composes && calls_entry(host) && has_name(host))
    {
        return false;
    }
    let nothing = SiblingTexts::new();
    let clues = Clues::unread(text, "", &nothing);
    let mut hosts = presets().filter(|h| h.composes);
    hosts.any(|h| weight(&signs(h, &clues)) >= ENOUGH)
}

/// Completes a text for a host: the one given by the user, or a detected one. `None` if no host is
/// detected.
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
    // Positions are valid only if the completed code is the changed text; inserted directives are
    // tracked separately.
    let is_text = *complete::changed(clues.text, &completion.changes) == *completion.code;
    (is_text || !host.directives.is_empty()).then_some(Hosted {
        recognised,
        completion,
        requested: plan.requested,
    })
}

/// Whether the `#version` of a text asks for desktop GLSL.
pub fn asks_for_desktop(text: &str) -> bool {
    matches!(clues::version_of(text), VersionAsked::Desktop(_))
}

/// Whether a text says itself what its channels read, as VS Code Shader Toy has it.
pub fn has_directives(text: &str) -> bool {
    vscode::may_have_directives(text) && vscode::has_directives(text)
}

/// Whether a host other than ShaderToy's player calls `mainImage`.
pub fn calls_entry(host: &Preset) -> bool {
    !is_player(host) && host.entries.iter().any(|entry| entry == "mainImage")
}

/// The values for a checked shader that is complete, or that ShaderToy's player completes. `given`
/// is the host given by the user.
pub fn bindings(program: &Program, given: Option<&'static Preset>) -> Bindings {
    let text = own_text(program);
    let clues = Clues::checked(&text, program);
    let given = given.map(Recognised::given);
    let Some(recognised) = given.or_else(|| recognise(&clues)) else {
        return Bindings::default();
    };
    let mut bound = bind(program, recognised.host, (&[], &[]), None, None);
    // The host itself sets the names that it declares.
    bound.controls.retain(|c| clues.declares(&c.name));
    let is_own = |name: &str, source| source != Feed::Control || clues.declares(name);
    bound.uniforms.retain(|u| is_own(&u.name, u.source));
    bound.zeros.retain(|name| clues.declares(name));
    bound
}

/// The user's text of a program; for a document with several shaders, only the text of this one.
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

/// The total strength of the evidence.
fn weight(signs: &[Sign]) -> u32 {
    signs.iter().map(|s| u32::from(s.weight)).sum()
}

/// The evidence for a host, strongest first.
fn signs(host: &Preset, clues: &Clues) -> Vec<Sign> {
    let mut found = code_of(host).map_or(Vec::new(), |code| (code.signs)(clues));
    let has = |sign: &&TextSign| sign.words.iter().all(|w| clues.has_word(w));
    found.extend(host.signs.iter().filter(has).map(|sign| {
        let first = sign.words.first().map_or("", String::as_str);
        Sign::new(format!("`{first}`"), sign.weight)
    }));
    let words = clues.free_words(|word| host.has_word(word)).into_iter();
    match host.composes {
        true => found.extend(words.map(|w| Sign::form(format!("`{w}`"), OWN))),
        false if is_player(host) => {}
        false => {
            let words = words.filter(|w| clues.is_lacking(w));
            found.extend(words.map(|w| Sign::new(format!("`{w}`"), OWN)));
        }
    }
    let declares = host.declares();
    let shows = |name: &str, types: &dyn Fn(&str) -> bool| {
        let is_row = |d: &&Interfacing| is_named(name, &d.name) && types(&d.ty);
        let declared = clues.uniforms.iter().chain(&clues.inputs).find(is_row);
        match declared {
            Some(d) => Some(d.name.clone()),
            None if declares && is_one_name(name) => clues.is_free(name).then(|| name.to_string()),
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
    let is_set = |u: &Interfacing| host.sets(&u.name, &u.ty);
    if host.sets_all && !clues.uniforms.iter().all(is_set) {
        found.retain(|sign| sign.weight >= OWN);
    }
    found.dedup();
    found.sort_by_key(|s| std::cmp::Reverse(s.weight));
    found
}

/// The types of samplers for images. Desktop GLSL also has one-dimensional textures.
const SAMPLERS: &[&str] = &["sampler2D", "samplerCube", "sampler3D", "sampler1D"];

impl Recognised {
    /// The note about the detected host and the evidence.
    pub fn summary(&self) -> String {
        let tied = self.tied.map_or(String::new(), |other| {
            format!(
                "; {} matches equally well: use `--host {}` to choose it",
                other.read_as(),
                other.name
            )
        });
        format!("read as {}{tied}", self.title_and_signs())
    }

    /// The host and the evidence for it.
    pub fn title_and_signs(&self) -> String {
        let title = self.host.read_as();
        let mut signs: Vec<&str> = Vec::new();
        for sign in &self.signs {
            // A name may be evidence both as a word and by its meaning.
            if signs.len() < 4 && !signs.contains(&sign.what.as_str()) {
                signs.push(&sign.what);
            }
        }
        match signs.as_slice() {
            [] => title.to_string(),
            signs => format!("{title} (found {})", signs.join(", ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::each_case;

    #[test]
    fn ambiguous_dialects_are_reported() {
        let text = "precision highp float;\nuniform vec3 spectrum;\nvarying vec2 surfacePosition;\n\
            void main() { gl_FragColor = vec4(surfacePosition, spectrum.xy); }";
        let found = recognise(&Clues::of(text)).unwrap();
        let summary = found.summary();
        assert!(
            summary.ends_with("use `--host kodelife` to choose it"),
            "{summary}"
        );
    }

    #[test]
    fn dialects_are_recognised_by_their_own_names() {
        each_case(include_str!("recognised.txt"), |text, dialect| {
            let found = recognise(&Clues::of(text)).unwrap();
            assert_eq!(found.host.name, dialect, "{:?}\n{text}", found.signs);
            assert_eq!(found.tied, None, "{text}");
        });
    }

    #[test]
    fn every_meaning_has_valid_glsl_types() {
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
