//! What is known about a host, and its documentation page.

use super::limit::Limit;
use super::meaning::{Feed, FeedRow, Meanings, is_named};
use super::template::Template;
use std::collections::BTreeMap;
use std::fmt;

/// The version of GLSL that a host compiles shaders as.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum HostVersion {
    /// GLSL ES 1.00 or 3.00, as configured by its user.
    #[default]
    Any,
    /// The version in the shader's own `#version`; the host puts its declarations after that line.
    Own,
    /// Desktop GLSL, which is compiled as GLSL ES 3.00 instead.
    Desktop,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL ES 3.00.
    Es300,
}

impl fmt::Display for HostVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            HostVersion::Any => "GLSL ES 1.00 or 3.00, as configured",
            HostVersion::Own => "the `#version` of the shader",
            HostVersion::Desktop => "desktop GLSL, checked as GLSL ES 3.00",
            HostVersion::Es100 => "GLSL ES 1.00",
            HostVersion::Es300 => "GLSL ES 3.00, regardless of `#version`",
        })
    }
}

/// A version of GLSL that a host requires.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RequiredVersion {
    /// The text after `#version`.
    pub version: String,
    /// The release since which it requires it.
    pub since: String,
}

/// A site or library that runs or completes shaders.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Preset {
    /// The name in configurations and for `--host`; empty for a host written by a user.
    pub name: &'static str,
    /// The table of the chunks that it inserts; empty if it has none.
    pub chunks: String,
    /// Alternative names.
    pub aliases: Vec<String>,
    /// The name in prose.
    pub title: String,
    /// What a shader of this host is called in messages; empty if it is the title.
    pub reads: String,
    /// The host that this one extends: its declarations are put first.
    pub base: Option<&'static str>,
    /// The description, in Markdown paragraphs.
    pub about: String,
    /// The files or documents that the facts come from.
    pub source: String,
    /// npm packages that indicate this host; one that ends with `/` is a scope.
    pub packages: Vec<String>,
    /// Names that only this host declares; a trailing `*` matches any suffix.
    pub words: Vec<String>,
    /// JavaScript globals of this host in pages without modules.
    pub globals: Vec<String>,
    /// Files that it provides for includes, as in `#include <flutter/runtime_effect.glsl>`.
    pub files: Vec<String>,
    /// Its include syntax.
    pub includes: String,
    /// Its placeholders, each as `START...END`.
    pub holes: Vec<String>,
    /// The version that it compiles as.
    pub version: HostVersion,
    /// The context that compiles its shaders, `webgl1` or `webgl2`, with the extensions that it enables;
    /// empty if that is open.
    pub context: Vec<String>,
    /// The version without which shaders do not work in its current releases.
    pub required: Option<RequiredVersion>,
    /// Whether it declares no other names, so that an unknown name is an error.
    pub is_complete: bool,
    /// Whether it sets no other uniforms, so that a shader that declares others is not for it unless
    /// it uses a name that only this host has.
    pub sets_all: bool,
    /// JavaScript names that receive shaders to which the host adds nothing else, so that an
    /// unknown name in these is an error.
    pub complete: Vec<String>,
    /// JavaScript names that receive shaders to which the host adds nothing at all.
    pub bare: Vec<String>,
    /// The property next to a shader that determines its version, and its value for GLSL ES 3.00, after which a
    /// fragment shader declares its own output.
    pub glsl: Vec<String>,
    /// JavaScript names whose use means that such shaders are modified nevertheless.
    pub patched: Vec<String>,
    /// Names that it declares depending on what is drawn, with unknown types; a trailing `*`
    /// matches any suffix.
    pub also: Vec<String>,
    /// Names that earlier releases of its library declared.
    pub removed: Vec<RemovedName>,
    /// Whether it accepts shaders with a `#version` and replaces it by its own.
    pub takes_version: bool,
    /// Whether it accepts desktop GLSL as well.
    pub takes_desktop: bool,
    /// Whether comments and lines may come before the `#version` of its shaders, as in drivers other
    /// than those of browsers.
    pub takes_late_version: bool,
    /// Whether it removes annotations of declarations: `attribute vec3 position : POSITION;`.
    pub takes_annotations: bool,
    /// Whether it renames the declarations of a shader.
    pub renames: bool,
    /// Whether its declarations depend on the shader, so that a shader is checked in its completed
    /// form.
    pub composes: bool,
    /// Extensions of files that contain its passes.
    pub extensions: Vec<String>,
    /// Directives that it processes before compilation; a trailing `*` matches any suffix.
    pub directives: Vec<String>,
    /// Names that it defines as macros; their declarations in shaders are ignored.
    pub defined: Vec<String>,
    /// The functions that it calls.
    pub entries: Vec<String>,
    /// What it does not accept although WebGL2 does.
    pub limits: Vec<Limit>,
    /// The language of the application that sets the uniforms of a shader by their position, whatever
    /// their names are.
    pub setters: String,
    /// The number of programs that it runs, each of which reads the outputs of the others from the
    /// channels with their numbers; 0 if it runs a single shader.
    pub programs: usize,
    /// The text with `main` that it appends to shaders, in which `port_entry` is the function of its
    /// own that a shader defines; empty if it appends nothing, or calls `mainImage` only.
    pub main: String,
    /// How shaders are written for it.
    pub template: Option<Template>,
    /// Further evidence for this host in a shader.
    pub signs: Vec<TextSign>,
    /// Documentation of its names, from comments `/// The seconds since the start.`
    pub descriptions: BTreeMap<String, String>,
    /// The values of the names that it sets; those of its base come last.
    pub meanings: Meanings,
    /// The declarations that it puts before shaders.
    pub prelude: String,
    /// Offset in `prelude` at which its own part starts, after that of its base.
    pub own_start: usize,
}

/// A name that a library no longer declares for shaders.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RemovedName {
    /// The name.
    pub name: String,
    /// The first release without it.
    pub release: u32,
    /// What to do instead.
    pub advice: String,
}

/// Words that together indicate a host.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextSign {
    /// The words; the first is shown in messages.
    pub words: Vec<String>,
    /// The strength of the evidence.
    pub weight: u8,
}

/// An invalid line in the header of a host file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HeadError {
    /// Line number, from 1.
    pub line: usize,
    /// The error message.
    pub message: String,
}
impl Preset {
    /// The documentation page in Markdown.
    pub fn page(&self) -> String {
        let mut text = format!("# {}\n\n{}\n\n", self.title, self.about);
        let code = |words: &[String]| format!("`{}`", words.join("`, `"));
        let mut facts = Vec::new();
        if let Some(base) = self.base {
            facts.push(("Builds on", format!("[{base}]({base}.md)")));
        }
        if !self.aliases.is_empty() {
            facts.push(("Aliases", code(&self.aliases)));
        }
        facts.push(("Compiled as", self.version.to_string()));
        let undeclared = match self.is_complete {
            true => "are errors",
            false => "may come from the host",
        };
        facts.push(("Undeclared names", undeclared.to_string()));
        for (what, words) in [
            ("Entry points", &self.entries),
            ("Detected by package", &self.packages),
            ("Detected by name", &self.words),
            ("Detected by JavaScript global", &self.globals),
            ("Placeholders", &self.holes),
            ("Adds nothing to shaders for", &self.complete),
            ("Unless modified by", &self.patched),
            ("Compiles unchanged", &self.bare),
            ("Version set by", &self.glsl),
            ("May also declare", &self.also),
            ("Extensions of pass files", &self.extensions),
            ("Directives", &self.directives),
            ("Provides for includes", &self.files),
            ("Defines as macros", &self.defined),
        ] {
            if !words.is_empty() {
                facts.push((what, code(words)));
            }
        }
        if let Some(required) = &self.required {
            let text = format!("`#version {}` since {}", required.version, required.since);
            facts.push(("Requires", text));
        }
        if self.composes {
            facts.push(("Declarations", "depend on the shader".to_string()));
        }
        if !self.includes.is_empty() {
            facts.push(("Include syntax", format!("`{}`", self.includes)));
        }
        if !self.limits.is_empty() {
            let limits: Vec<&str> = self.limits.iter().map(|l| l.description()).collect();
            facts.push(("Does not accept", limits.join("; ")));
        }
        if self.template.is_some() {
            facts.push(("Written by", format!("`shaderport --target {}`", self.name)));
        }
        if !self.source.is_empty() {
            facts.push(("Source", self.source.clone()));
        }
        text.push_str("| | |\n|---|---|\n");
        for (what, value) in facts {
            text.push_str(&format!("| {what} | {value} |\n"));
        }
        text.push_str(&format!(
            "\nTo select it in `shaderlint.toml`:\n\n```toml\nhost = \"{}\"\n```\n",
            self.name
        ));
        text.push_str(&self.meanings.page(&self.descriptions));
        let prelude = self.prelude.get(self.own_start..).unwrap_or("").trim();
        if !prelude.is_empty() {
            text.push_str(
                "\n## Declarations\n\nThe host puts these before each shader:\n\n```glsl\n",
            );
            // Descriptions of names were taken out and left empty lines.
            for line in prelude.lines().filter(|line| !line.trim().is_empty()) {
                text.push_str(&format!("{line}\n"));
            }
            text.push_str("```\n");
        }
        text
    }

    /// What a shader of this host is called in messages.
    pub fn read_as(&self) -> &str {
        match self.reads.is_empty() {
            true => &self.title,
            false => &self.reads,
        }
    }

    /// The declarations for a stage.
    pub fn declarations(&self, is_vertex: bool) -> String {
        for_stage(&self.prelude, is_vertex)
    }

    /// The declarations for a stage, without those of the base.
    pub fn own_declarations(&self, is_vertex: bool) -> String {
        for_stage(self.prelude.get(self.own_start..).unwrap_or(""), is_vertex)
    }

    /// Whether a text contains one of the host's placeholders.
    pub fn fills(&self, text: &str) -> bool {
        let is_word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | ':' | '.' | ' ');
        let mut holes = self.holes.iter().filter_map(|h| h.split_once("..."));
        holes.any(|(start, end)| {
            text.match_indices(start).any(|(at, _)| {
                let inside = text.get(at + start.len()..).unwrap_or("");
                let length = inside.find(|c| !is_word(c)).unwrap_or(inside.len());
                let (word, after) = inside.split_at(length);
                !word.trim().is_empty() && (after.starts_with(end) || word.ends_with(end))
            })
        })
    }

    /// Whether an npm package of this name indicates the host.
    pub fn is_package(&self, package: &str) -> bool {
        self.packages.iter().any(|own| match own.strip_suffix('/') {
            Some(scope) => package
                .strip_prefix(scope)
                .is_some_and(|rest| rest.starts_with('/')),
            None => package == own,
        })
    }

    /// Whether a script uses the host through its JavaScript global.
    pub fn is_used_in(&self, script: &str) -> bool {
        self.globals.iter().any(|g| {
            let uses = script.match_indices(g.as_str());
            let is_separate = |(at, _): (usize, &str)| {
                let before = script.get(..at).and_then(|b| b.chars().next_back());
                let after = script.get(at + g.len()..).unwrap_or("");
                after.starts_with('.') && !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
            };
            uses.into_iter().any(is_separate)
        })
    }

    /// Whether it accepts shaders with a desktop `#version`.
    pub fn runs_desktop(&self) -> bool {
        self.takes_desktop || matches!(self.version, HostVersion::Own | HostVersion::Desktop)
    }

    /// Whether it declares names, so that shaders use them undeclared.
    pub fn declares(&self) -> bool {
        self.meanings.has_declared()
    }

    /// Whether a shader in a script gets no other names from the host.
    pub fn is_complete_in(&self, script: &str) -> bool {
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let is_whole = |(at, word): (usize, &str)| {
            let before = script.get(..at).and_then(|t| t.chars().next_back());
            let after = script.get(at + word.len()..).and_then(|t| t.chars().next());
            !before.is_some_and(is_word) && !after.is_some_and(is_word)
        };
        let uses = |name: &String| script.match_indices(name.as_str()).any(is_whole);
        let patches = |name: &String| script.contains(name.as_str());
        self.is_complete || self.complete.iter().any(uses) && !self.patched.iter().any(patches)
    }

    /// Whether what a shader is handed to gives it no other names.
    pub fn is_complete_for(&self, receiver: &str) -> bool {
        self.is_complete || self.complete.iter().any(|name| name == receiver)
    }

    /// Whether a name, and a type if it has one, is one that the host sets.
    pub fn sets(&self, name: &str, ty: &str) -> bool {
        let names = &self.meanings;
        let is_feed = |r: &FeedRow| is_named(&r.name, name) && r.types.iter().any(|t| t == ty);
        names.feeds.iter().any(is_feed)
            || names
                .textures
                .iter()
                .any(|r| is_named(&r.name, name) && ty == "sampler2D")
            || names.varyings.iter().any(|r| r.name == name && r.ty == ty)
    }

    /// Whether its declarations define a macro.
    pub fn defines(&self, name: &str) -> bool {
        let mut lines = self.prelude.lines();
        lines.any(|line| line.starts_with("#define ") && declared_in(line) == Some(name))
    }

    /// Whether a file with this extension can contain a pass.
    pub fn has_extension(&self, extension: &str) -> bool {
        self.extensions.iter().any(|own| own == extension)
    }

    /// Whether only this host declares a name.
    pub fn has_word(&self, name: &str) -> bool {
        matches_any(&self.words, name)
    }
}

/// The declarations for one of the stages.
fn for_stage(prelude: &str, is_vertex: bool) -> String {
    let stage = match is_vertex {
        true => "VERTEX_SHADER",
        false => "FRAGMENT_SHADER",
    };
    format!("#define {stage} 1\n{prelude}\n#undef {stage}\n")
}

/// Whether a name matches one of several patterns; a trailing `*` matches any suffix.
pub fn matches_any(all: &[String], name: &str) -> bool {
    all.iter().any(|own| match own.strip_suffix('*') {
        Some(beginning) => name.starts_with(beginning),
        None => name == own,
    })
}

impl Preset {
    /// Whether a value never changes although ShaderToy would change it: the mouse of a host without
    /// one, which stays 0 as it is until the first click.
    pub fn rests(&self, feed: Feed) -> bool {
        let is_set = || self.meanings.feeds.iter().any(|row| row.feed == feed);
        feed == Feed::Mouse && self.setters.is_empty() && !is_set()
    }

    /// Applies the description of a user to a known host.
    pub fn over(mut self, base: &Preset) -> Preset {
        self.put_after(base);
        self.is_complete &= base.is_complete;
        self.version = base.version;
        self.base = Some(base.name);
        if self.entries.is_empty() {
            self.entries = base.entries.clone();
        }
        self
    }

    fn put_after(&mut self, base: &Preset) {
        self.own_start = base.prelude.len() + 1;
        self.prelude = format!("{}\n{}", base.prelude, self.prelude);
        self.meanings.inherit(&base.meanings);
        for (name, description) in &base.descriptions {
            let own = self.descriptions.entry(name.clone());
            own.or_insert_with(|| description.clone());
        }
    }

    /// Inherits from the base. Evidence for the base is not evidence for this host.
    pub(super) fn build_on(&mut self, base: &Preset, given: &GivenFacts) {
        self.put_after(base);
        if !given.version {
            self.version = base.version;
        }
        if !given.names {
            self.is_complete = base.is_complete;
        }
        if self.includes.is_empty() {
            self.includes = base.includes.clone();
        }
        if self.entries.is_empty() {
            self.entries = base.entries.clone();
        }
        if self.chunks.is_empty() {
            self.chunks = base.chunks.clone();
        }
        if self.context.is_empty() {
            self.context = base.context.clone();
        }
        self.holes.extend(base.holes.iter().cloned());
        self.removed.extend(base.removed.iter().cloned());
    }
}

/// The name that a line declares.
pub fn declared_in(line: &str) -> Option<&str> {
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let line = line.trim_start();
    if let Some(rest) = line.strip_prefix("#define ") {
        return rest.split(|c| !is_name(c)).next();
    }
    let line = line.strip_prefix("layout").map_or(line, |rest| {
        rest.split_once(')').map_or(rest, |(_, after)| after)
    });
    let end = line.find([';', '(', '[', '=', '{'])?;
    let head = line.get(..end)?.trim_end();
    head.rsplit(|c| !is_name(c))
        .next()
        .filter(|n| !n.is_empty())
}

/// Facts that are given in the header and therefore not inherited from the base.
#[derive(Default)]
pub(super) struct GivenFacts {
    pub(super) version: bool,
    pub(super) names: bool,
}

impl GivenFacts {
    pub(super) fn note(&mut self, key: &str) {
        self.version |= key == "version";
        self.names |= key == "names";
    }
}
