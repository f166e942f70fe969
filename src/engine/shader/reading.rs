//! The possible readings of a text: as a complete shader, or as a shader fragment in each way in
//! which a host may complete it.

use super::chunks::{ExpandedText, with_chunks};
use super::prelude::{after_version, declares_output, prelude, with_host};
use crate::options::{DialectChoice, Options};
use shaderlint_detect::kind::has_main;
use shaderlint_diagnostic::{Diagnostic, Lack, Severity, error};
use shaderlint_explain::{Checked, analyze_chunk, analyze_within, confirm_unknown};
use shaderlint_host::{HostVersion, Preset, chunk_prelude, is_chunk, presets};
use shaderlint_project::chunks_in;
use shaderlint_semantic::snippet::is_body;
use shaderlint_semantic::{
    CHUNK_OUTPUT, Completeness, Dialect, Guess, GuessedKind, Pass, Stage, Unit, chunk_declarations,
    first_of_300, guess, needs_300,
};
use shaderlint_syntax::{ES_300, Feature, GlContext, Search, Version};
use shaderlint_text::{FileId, Role, Sources};
use std::cell::{LazyCell, OnceCell};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

/// One reading of a text.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The files to compile, in order.
    pub files: Vec<FileId>,
    /// Vertex or fragment stage.
    pub stage: Stage,
    /// ShaderToy pass or WebGL shader.
    pub dialect: Dialect,
    /// The context that compiles it.
    pub context: GlContext,
}

/// How complete a text is, before it is checked.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PresumedCompleteness {
    Complete,
    /// Complete, unless it uses names that it does not declare.
    CompleteIfDeclared,
    /// Complete, but only valid if a host writes `#version 300 es` before it.
    Unversioned,
    /// A shader fragment that a host completes.
    Chunk,
    /// A shader fragment with omissions.
    Excerpt,
}

/// A text and what is known about it before it is parsed.
#[derive(Clone, Debug)]
pub struct InputText {
    /// The files to compile, with includes.
    pub files: Vec<FileId>,
    /// The stage, if the context determines it.
    pub stage: Option<Stage>,
    /// The context of the text.
    pub surroundings: Surroundings,
    /// Whether a host is known to insert code.
    pub is_open: bool,
    /// Whether a program puts it together, in its own way.
    pub is_composed: bool,
    /// Whether the surrounding script compiles the text unchanged.
    pub is_compiled: bool,
    /// Whether the context is in GLSL ES 3.00.
    pub is_300: bool,
    /// Whether code is omitted inside.
    pub has_holes: bool,
    /// The directives that select it among the shaders of its text.
    pub macros: String,
}

/// The context of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Surroundings {
    /// A file with the extension of a stage, which is usually compiled unchanged.
    StageFile,
    /// A file with the extension of GLSL in general.
    File,
    /// The Common file of ShaderToy passes in its folder.
    CommonFile,
    /// An element of a page.
    Element,
    /// A string in a script, which may add code.
    Literal,
    /// Documentation that shows code.
    Shown,
}

/// A text and its possible readings.
#[derive(Clone, Debug)]
pub struct Readings {
    /// The readings, most likely first.
    pub all: Vec<Reading>,
    /// How complete the text is.
    pub presumed: PresumedCompleteness,
    /// The hosts that may complete it.
    pub hosts: Vec<String>,
    /// Whether a host renames what the text declares.
    pub renames: bool,
    /// Whether the hosts are known only from imports or packages.
    pub is_guessed: bool,
    /// Whether the list of names that the hosts declare is complete.
    pub are_hosts_complete: bool,
    /// Patterns of names that the hosts declare depending on the object that is drawn.
    pub declared_at_times: Vec<String>,
    /// Whether a shader for the hosts declares its own output; `None` if it shows that.
    pub has_own_output: Option<bool>,
    /// What a script writes to get GLSL ES 3.00, if it does not write `#version`.
    pub version_setting: Option<String>,
    text: InputText,
    guessed: Guess,
    needs_300: bool,
    chunks: Vec<String>,
    /// Whether it defines a function that only a host of it calls.
    pub is_called: bool,
    /// Names after `void`.
    procedures: Vec<String>,
}

impl Readings {
    /// The only reading of a complete shader.
    pub fn of_complete(reading: Reading) -> Readings {
        let text = InputText {
            files: reading.files.clone(),
            stage: Some(reading.stage),
            surroundings: Surroundings::File,
            is_open: false,
            is_composed: false,
            is_compiled: false,
            is_300: false,
            has_holes: false,
            macros: String::new(),
        };
        let complete = PresumedCompleteness::Complete;
        let mut found = Readings::new(text, complete, Guess::default());
        found.all.push(reading);
        found
    }

    fn new(text: InputText, presumed: PresumedCompleteness, guessed: Guess) -> Readings {
        Readings {
            all: Vec::new(),
            presumed,
            hosts: Vec::new(),
            renames: false,
            is_guessed: false,
            are_hosts_complete: false,
            declared_at_times: Vec::new(),
            has_own_output: None,
            version_setting: None,
            text,
            guessed,
            needs_300: false,
            chunks: Vec::new(),
            is_called: false,
            procedures: Vec::new(),
        }
    }

    /// Determines the readings of a text. `None` if the address space is full.
    pub fn of(
        sources: &mut Sources,
        (code, mut guessed): (&str, Guess),
        mut text: InputText,
        options: &Options,
    ) -> Option<Readings> {
        // Included text is part of the text, and resolved includes are not directives any more.
        let joined = (text.files.len() > 1).then(|| code_of(sources, &text.files));
        if joined.is_some() || !text.macros.is_empty() {
            let all = joined.as_deref().unwrap_or(code);
            guessed = guess(&format!("{}{all}", text.macros));
            // Includes were resolved, so missing files are known; chunks of a host are left.
            guessed.is_completed &= !chunks_in(all).is_empty();
        }
        if !text.macros.is_empty() {
            let prelude = sources.add("", None, Role::Prelude, text.macros.as_str())?;
            text.files = after_version(sources, text.files, prelude)?;
        }
        let code = joined.as_deref().unwrap_or(code);
        let needs_300 = LazyCell::new(|| needs_300(code));
        let kind = kind_of(&guessed, &text, &needs_300, options.dialect);
        let presumed = presumed(kind, &guessed, &text, code, &needs_300, options.dialect);
        let needs_300 = text.is_300 || presumed != PresumedCompleteness::Complete && *needs_300;
        let mut found = Readings::new(text, presumed, guessed);
        found.needs_300 = needs_300;
        found.procedures = procedures(code);
        found.chunks = chunks_in(code).into_iter().map(|c| c.name).collect();
        found.chunks.retain(|name| is_chunk(name));
        if presumed == PresumedCompleteness::Chunk && is_body(code) {
            found.put_in_function(sources)?;
        }
        let given = options.host.preset.filter(|p| found.may_host(p));
        if let Some(preset) = given.filter(|_| !guessed.is_shadertoy()) {
            found.host(sources, &[preset], options)?;
            let is_all = guessed.has_main && preset.is_complete && !found.text.is_open;
            let is_all =
                is_all && !guessed.is_completed && presumed != PresumedCompleteness::Excerpt;
            if is_all {
                found.presumed = PresumedCompleteness::Complete;
            }
            return Some(found);
        }
        if !matches!(
            presumed,
            PresumedCompleteness::Chunk | PresumedCompleteness::Excerpt
        ) || kind.is_some_and(GuessedKind::is_complete)
        {
            found.all.push(found.as_it_is(sources, kind, options)?);
        }
        let may_be_part = matches!(
            presumed,
            PresumedCompleteness::CompleteIfDeclared | PresumedCompleteness::Unversioned
        );
        if found.all.is_empty() || may_be_part {
            found.complete(sources, None, options)?;
        }
        Some(found)
    }

    /// The readings of the text with the files that a script joins to it.
    pub fn with_files(
        &self,
        sources: &mut Sources,
        (files, is_open): (Vec<FileId>, bool),
        options: &Options,
    ) -> Option<Readings> {
        let text = InputText {
            files,
            is_open,
            ..self.text.clone()
        };
        Readings::of(sources, ("", self.guessed), text, options)
    }

    /// The known hosts among those that may complete the text.
    pub fn presets(&self) -> impl Iterator<Item = &'static Preset> {
        presets().filter(|preset| self.hosts.contains(&preset.title))
    }

    /// The names of the chunks that the text includes and that some host has.
    pub fn chunks(&self) -> &[String] {
        &self.chunks
    }

    /// Whether the text may define a function without result of this name.
    pub fn defines(&self, name: &str) -> bool {
        self.procedures.iter().any(|own| own == name)
    }

    /// Whether the text has a `#version`.
    pub fn has_version(&self) -> bool {
        self.guessed.kind == Some(GuessedKind::Versioned)
    }

    /// Whether the text may start or end anywhere: scripts concatenate such pieces.
    fn is_piece(&self) -> bool {
        self.text.surroundings == Surroundings::Literal && !self.has_version()
    }

    /// Whether the text requires GLSL ES 3.00.
    pub fn needs_300(&self) -> bool {
        self.needs_300 || self.guessed.is_300
    }

    /// Whether a page or script passes the text on, and may change it before.
    pub fn is_handed_over(&self) -> bool {
        let around = self.text.surroundings;
        matches!(around, Surroundings::Element | Surroundings::Literal)
    }

    /// Whether an error is about a name that the host may declare. Text that is compiled unchanged
    /// gets no other version.
    fn may_lack(&self, d: &Diagnostic) -> bool {
        match d.lacks() {
            Some(Lack::Name) => true,
            Some(Lack::Setting) => !self.text.is_compiled || self.needs_300,
            Some(Lack::Output) | None => false,
        }
    }

    /// The range of the first token that requires GLSL ES 3.00, if the text is compiled unchanged
    /// and lacks `#version`.
    pub fn lacks_version(&self, code: &str) -> Option<Range<usize>> {
        let is_complete = self.guessed.has_main && !self.has_gaps() && !self.is_shown();
        let is_lacking = is_complete && self.hosts.is_empty() && !self.has_version();
        let is_lacking = is_lacking && !self.is_shadertoy();
        is_lacking.then(|| first_of_300(code)).flatten()
    }

    /// Whether the surrounding script compiles the text unchanged.
    pub fn is_compiled(&self) -> bool {
        self.text.is_compiled
    }

    /// Whether the text defines an entry function.
    pub fn holds_entry(&self) -> bool {
        self.guessed.has_main
    }

    /// Whether the text is documentation, which is not compiled.
    pub fn is_shown(&self) -> bool {
        self.text.surroundings == Surroundings::Shown
    }

    /// Whether the text is a vertex shader, by its content or its context.
    pub fn is_vertex(&self) -> bool {
        self.text.stage.or(self.guessed.stage) == Some(Stage::Vertex)
    }

    /// Whether an included file is missing.
    pub fn has_missing(&self) -> bool {
        self.text.is_open || self.text.has_holes
    }

    /// Treats the text as a fragment of a shader that a host composes.
    pub fn open(&mut self, host: &Preset, is_open: bool) {
        self.presumed = PresumedCompleteness::Chunk;
        self.hosts.push(host.title.clone());
        self.are_hosts_complete = host.is_complete;
        self.text.is_open = is_open;
    }

    /// Whether code is inserted, or missing, that is unknown.
    pub fn has_gaps(&self) -> bool {
        self.text.is_open
            || self.text.has_holes
            || self.guessed.is_completed
            || self.presumed == PresumedCompleteness::Excerpt
    }

    /// Whether the text is a ShaderToy pass.
    pub fn is_shadertoy(&self) -> bool {
        self.all.first().is_some_and(|r| r.dialect.is_shadertoy())
    }

    /// Whether a host accepts texts like this one.
    pub fn may_host(&self, preset: &Preset) -> bool {
        let takes_any = matches!(preset.version, HostVersion::Own | HostVersion::Any);
        !self.has_version() || takes_any || preset.takes_version
    }

    /// Whether a script may hand the text, as it is, to something that completes it.
    pub fn may_be_handed(&self) -> bool {
        self.holds_entry() && !self.has_version() && !self.is_shown() && !self.is_shadertoy()
    }

    /// Whether it is certain that no host adds anything to the text.
    pub fn is_unchanged(&self) -> bool {
        self.text.is_compiled && self.presumed == PresumedCompleteness::Complete
    }

    /// Reads a text to which a host adds nothing but the version, if that is 3.00, unless there are gaps in it.
    pub fn compile_unchanged(
        &mut self,
        sources: &mut Sources,
        (host, is_300): (&Preset, bool),
        options: &Options,
    ) -> Option<()> {
        if self.has_gaps() {
            return Some(());
        }
        let kind = match is_300 || self.guessed.kind == Some(GuessedKind::WebGl2) {
            true => GuessedKind::WebGl2,
            false => GuessedKind::WebGl1,
        };
        if let [key, new] = host.glsl.as_slice() {
            self.version_setting = Some(format!("{key}: {new}"));
        }
        self.all = vec![self.as_it_is(sources, Some(kind), options)?];
        self.presumed = PresumedCompleteness::Complete;
        self.text.is_compiled = true;
        if is_300 {
            // The host writes it.
            self.guessed.kind = Some(GuessedKind::Versioned);
            self.guessed.is_300 = true;
        }
        Some(())
    }

    /// Adds the readings as completed by these hosts.
    pub fn host(
        &mut self,
        sources: &mut Sources,
        presets: &[&Preset],
        options: &Options,
    ) -> Option<()> {
        self.all.clear();
        if self.presumed != PresumedCompleteness::Excerpt {
            self.presumed = PresumedCompleteness::Chunk;
        }
        self.are_hosts_complete = presets.iter().all(|p| p.is_complete);
        let also = presets.iter().flat_map(|p| p.also.iter().cloned());
        self.declared_at_times.extend(also);
        let code = code_of(sources, &self.text.files);
        self.text.is_open |= presets.iter().any(|p| p.fills(&code));
        let mut are_known = true;
        for preset in presets {
            let calls = |entry: &String| entry != "main" && self.defines(entry);
            self.is_called |= preset.entries.iter().any(calls);
            self.hosts.push(preset.title.clone());
            self.renames |= preset.renames;
            are_known &= self.complete(sources, Some(preset), options)?;
        }
        self.guessed.is_completed &= !are_known || guess(&without_chunks(code)).is_completed;
        Some(())
    }

    /// Adds the readings of a shader fragment, completed by a host or by an unknown one. Whether the host
    /// has all chunks that the text includes.
    fn complete(
        &mut self,
        sources: &mut Sources,
        preset: Option<&Preset>,
        options: &Options,
    ) -> Option<bool> {
        let code = code_of(sources, &self.text.files);
        let text = match preset.filter(|_| self.guessed.is_completed) {
            Some(host) => with_chunks(sources, &self.text.files, host)?,
            None => ExpandedText::of(&self.text.files),
        };
        self.declared_at_times.extend(text.once);
        for (version, stage) in self.ways(preset) {
            let declared = chunk_declarations(version, stage);
            let is_vertex = stage == Stage::Vertex;
            let mut own = preset.map_or(String::new(), |p| {
                prelude(p, &code, is_vertex, self.has_own_output)
            });
            if text.has_chunks {
                own.push_str(&chunk_prelude());
            }
            let writes = code.contains("gl_FragColor") && !own.contains("gl_FragColor");
            let has_own = || {
                self.has_own_output
                    .unwrap_or_else(|| declares_output(&code))
            };
            let may_write = writes && !has_own();
            let own = match may_write && !is_vertex && version.has(Feature::InOut) {
                true => CHUNK_OUTPUT.to_string() + &own,
                false => own,
            };
            let files = if self.has_version() {
                let prelude = sources.add("", None, Role::Prelude, declared + &own)?;
                after_version(sources, text.files.clone(), prelude)?
            } else {
                let first = version.profile().directive;
                let header = format!("{first}{declared}{own}");
                with_host(sources, Some(header), text.files.clone(), options)?
            };
            self.all.push(Reading {
                files,
                stage,
                dialect: Dialect::WebGl,
                context: GlContext::WEBGL2,
            });
        }
        Some(text.has_chunks && !text.is_open)
    }

    /// The versions and stages that a shader fragment may be compiled as, most likely first.
    fn ways(&self, preset: Option<&Preset>) -> Vec<(Version, Stage)> {
        let versions: &[Version] = match (preset.map(|p| p.version), self.guessed.kind) {
            (_, Some(GuessedKind::Versioned)) if self.guessed.is_300 => &[Version::Es300],
            (_, Some(GuessedKind::Versioned)) => &[Version::Es100],
            (Some(HostVersion::Es100), _) => &[Version::Es100],
            (Some(HostVersion::Es300), _) => &[Version::Es300],
            // Such a host converts one version to the other.
            (Some(HostVersion::Any), Some(GuessedKind::WebGl1)) => {
                &[Version::Es100, Version::Es300]
            }
            (Some(HostVersion::Any), _) => &[Version::Es300, Version::Es100],
            // It is complete but for its includes, which may be written for both versions.
            (None, Some(GuessedKind::WebGl1))
                if self.text.is_composed && self.guessed.has_precision =>
            {
                &[Version::Es100]
            }
            _ if self.needs_300 => &[Version::Es300],
            (_, Some(GuessedKind::WebGl1)) => &[Version::Es100, Version::Es300],
            _ => &[Version::Es300, Version::Es100],
        };
        let stages: &[Stage] = match self.text.stage.or(self.guessed.stage) {
            Some(Stage::Vertex) => &[Stage::Vertex],
            Some(Stage::Fragment) => &[Stage::Fragment],
            None => &[Stage::Fragment, Stage::Vertex],
        };
        let all = versions.iter().map(|v| stages.iter().map(|s| (*v, *s)));
        all.flatten().collect()
    }

    /// The reading of a text that no host completes, except for ShaderToy.
    fn as_it_is(
        &self,
        sources: &mut Sources,
        kind: Option<GuessedKind>,
        options: &Options,
    ) -> Option<Reading> {
        let (header, dialect) = match kind {
            Some(GuessedKind::ShaderToy(pass)) => {
                let own = self.text.files.iter();
                let own = own.filter_map(|id| Some(sources.code(*id)?.text));
                let header = pass
                    .host()
                    .prelude_beside([None; 4], &own.collect::<String>());
                (Some(header), Dialect::ShaderToy(pass))
            }
            Some(GuessedKind::WebGl2) => (Some(ES_300.directive.to_string()), Dialect::WebGl),
            _ => (None, Dialect::WebGl),
        };
        let stage = dialect.host().stage;
        let stage = stage.or(self.text.stage).or(self.guessed.stage);
        Some(Reading {
            files: with_host(sources, header, self.text.files.clone(), options)?,
            stage: stage.unwrap_or(Stage::Fragment),
            dialect,
            context: GlContext::WEBGL2,
        })
    }

    /// Puts statements into a function, as their host does.
    fn put_in_function(&mut self, sources: &mut Sources) -> Option<()> {
        let open = sources.add("", None, Role::Prelude, "void part_of_a_function() {\n")?;
        let close = sources.add("", None, Role::Prelude, "\n}\n")?;
        self.text.files.insert(0, open);
        self.text.files.push(close);
        Some(())
    }

    /// The readings as parts of a shader.
    pub fn into_parts(mut self) -> Readings {
        if self.presumed != PresumedCompleteness::Excerpt {
            self.presumed = PresumedCompleteness::Chunk;
        }
        self
    }

    /// The readings of a shader that defines these macros before.
    pub fn with_macros(&self, sources: &mut Sources, definitions: &str) -> Option<Readings> {
        let mut found = self.clone();
        for reading in &mut found.all {
            let prelude = sources.add("", None, Role::Prelude, definitions)?;
            let first = reading.files.first().and_then(|id| sources.code(*id))?;
            match first.role == Role::Prelude {
                true => reading.files.insert(1, prelude),
                false => {
                    let files = std::mem::take(&mut reading.files);
                    reading.files = after_version(sources, files, prelude)?;
                }
            }
        }
        Some(found)
    }

    /// Sets the context that compiles the text.
    pub fn set_context(&mut self, context: GlContext) {
        for reading in &mut self.all {
            reading.context = context;
        }
    }

    /// Checks the text in all readings, and returns the best result.
    pub fn check<'u>(&'u self, sources: &'u Arc<Sources>, infer_channels: bool) -> Option<Checked> {
        let completeness = match self.presumed {
            PresumedCompleteness::Complete
            | PresumedCompleteness::CompleteIfDeclared
            | PresumedCompleteness::Unversioned => Completeness::Complete,
            PresumedCompleteness::Chunk if self.is_piece() => Completeness::Piece,
            PresumedCompleteness::Chunk => Completeness::Chunk,
            PresumedCompleteness::Excerpt => Completeness::Excerpt,
        };
        let unit = |reading: &'u Reading, completeness: Completeness| Unit {
            sources,
            files: &reading.files,
            stage: reading.stage,
            dialect: reading.dialect,
            context: reading.context,
            infer_channels,
            completeness,
        };
        let mut search = Search::for_text();
        let mut all = self.all.as_slice();
        if completeness == Completeness::Complete {
            let (first, others) = all.split_first()?;
            let checked = analyze_within(&unit(first, completeness), &mut search);
            // Macros of the text itself are not names that a host has to declare.
            let code = OnceCell::new();
            let is_macro = |name: &str| {
                let code = code.get_or_init(|| code_of(sources, &first.files));
                !name.is_empty() && code.contains(&format!("define {name}"))
            };
            let is_lacking = |d: &Diagnostic| {
                let name = sources.text(d.span);
                self.may_lack(d) && !is_macro(name) && !is_miscased(d, name)
            };
            let lacks = checked.diagnostics.iter().any(is_lacking);
            let is_complete = match self.presumed {
                PresumedCompleteness::Unversioned => {
                    let wrong = checked.diagnostics.iter().filter(|d| is_error(d)).count();
                    let is_left = |d: &&Diagnostic| is_error(d) && d.lacks().is_none();
                    let left = |search: &mut Search, r: &&'u Reading, _| {
                        let with_version = analyze_within(&unit(r, completeness), search);
                        Some(with_version.diagnostics.iter().filter(is_left).count())
                    };
                    // Whether there are fewer errors with `#version 300 es`.
                    let tokens = checked.program.size();
                    let other = others.first();
                    search.fewest((wrong, 0), tokens, other, left).is_none()
                }
                PresumedCompleteness::CompleteIfDeclared => !lacks,
                _ => true,
            };
            if is_complete {
                return Some(checked);
            }
            all = others;
        }
        let completeness = match completeness {
            Completeness::Complete if self.is_piece() => Completeness::Piece,
            Completeness::Complete => Completeness::Chunk,
            completeness => completeness,
        };
        let units: Vec<Unit> = all.iter().map(|r| unit(r, completeness)).collect();
        analyze_chunk(&units, &mut search)
    }
}

impl Readings {
    /// Keeps those names that are unknown in all readings.
    pub fn confirm(
        &self,
        sources: &Arc<Sources>,
        completeness: Completeness,
        unknown: &mut Vec<Diagnostic>,
    ) {
        let others = self.all.iter().skip(1).map(|reading| Unit {
            sources,
            files: &reading.files,
            stage: reading.stage,
            dialect: reading.dialect,
            context: reading.context,
            infer_channels: false,
            completeness,
        });
        confirm_unknown(&others.collect::<Vec<_>>(), unknown);
    }
}

/// The names of the functions without result that a text may define.
fn procedures(code: &str) -> Vec<String> {
    let name = |text: &str| {
        let name = text.trim_start();
        let end = name.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        name.get(..end.unwrap_or(name.len()))
            .unwrap_or("")
            .to_string()
    };
    code.split("void ").skip(1).map(name).collect()
}

/// The names that a text lacks; `None` if it is complete and without errors.
pub fn lacking(checked: &Checked) -> Option<BTreeSet<String>> {
    let Checked {
        program,
        diagnostics,
        open,
        ..
    } = checked;
    if !open.is_any && !diagnostics.iter().any(is_error) {
        return None;
    }
    let undeclared = diagnostics
        .iter()
        .filter(|d| d.lacks() == Some(Lack::Name))
        .map(|d| program.sources.text(d.span).to_string());
    Some(open.names.iter().cloned().chain(undeclared).collect())
}

/// The user's text in some files, concatenated.
pub fn code_of(sources: &Sources, files: &[FileId]) -> String {
    let codes = files.iter().filter_map(|id| sources.code(*id));
    let own = codes.filter(|c| c.role == Role::User);
    own.map(|c| c.text).collect::<Vec<_>>().join("\n")
}

/// The code of a text without the directives for chunks of its host.
fn without_chunks(mut code: String) -> String {
    for chunk in chunks_in(&code) {
        code.replace_range(chunk.range.clone(), &" ".repeat(chunk.range.len()));
    }
    code
}

/// The kind of a text: what it is written for.
fn kind_of(
    guessed: &Guess,
    text: &InputText,
    needs_300: &LazyCell<bool, impl FnOnce() -> bool>,
    choice: DialectChoice,
) -> Option<GuessedKind> {
    match choice {
        DialectChoice::Shadertoy => Some(match guessed.kind {
            Some(GuessedKind::ShaderToy(pass)) => GuessedKind::ShaderToy(pass),
            _ => GuessedKind::ShaderToy(Pass::Common),
        }),
        DialectChoice::Webgl1 => Some(GuessedKind::WebGl1),
        DialectChoice::Webgl2 if guessed.kind == Some(GuessedKind::Versioned) => {
            Some(GuessedKind::Versioned)
        }
        DialectChoice::Webgl2 => Some(GuessedKind::WebGl2),
        DialectChoice::Auto => match guessed.kind {
            // The file of a stage is compiled unchanged: without `#version` it is GLSL ES 1.00.
            Some(GuessedKind::WebGl2)
                if text.surroundings == Surroundings::StageFile && !**needs_300 =>
            {
                Some(GuessedKind::WebGl1)
            }
            None if text.surroundings == Surroundings::CommonFile => {
                Some(GuessedKind::ShaderToy(Pass::Common))
            }
            kind => kind,
        },
    }
}

/// How complete a text is, by its content.
fn presumed(
    kind: Option<GuessedKind>,
    guessed: &Guess,
    text: &InputText,
    code: &str,
    needs_300: &LazyCell<bool, impl FnOnce() -> bool>,
    choice: DialectChoice,
) -> PresumedCompleteness {
    if text.has_holes {
        return PresumedCompleteness::Excerpt;
    }
    let is_literal = text.surroundings == Surroundings::Literal;
    match kind {
        _ if choice != DialectChoice::Auto => PresumedCompleteness::Complete,
        _ if text.is_open || text.is_composed || guessed.is_completed => {
            PresumedCompleteness::Chunk
        }
        // A literal that contains only the head of a shader is concatenated with others.
        Some(GuessedKind::Versioned) if is_literal && !has_main(code) => {
            PresumedCompleteness::Chunk
        }
        Some(_) if text.surroundings == Surroundings::Shown => {
            PresumedCompleteness::CompleteIfDeclared
        }
        Some(kind) if kind.is_complete() => PresumedCompleteness::Complete,
        Some(GuessedKind::WebGl1) if is_literal && !text.is_compiled => PresumedCompleteness::Chunk,
        Some(GuessedKind::WebGl1) if guessed.has_main => {
            let is_supplied = match text.stage.or(guessed.stage) {
                Some(Stage::Vertex) => guessed.has_attribute,
                _ => guessed.has_precision,
            };
            match is_supplied {
                true if **needs_300 => PresumedCompleteness::Unversioned,
                true => PresumedCompleteness::Complete,
                false => PresumedCompleteness::CompleteIfDeclared,
            }
        }
        _ => PresumedCompleteness::Chunk,
    }
}

/// Whether an unknown type is one of GLSL in other capitals: `Float`.
fn is_miscased(d: &Diagnostic, name: &str) -> bool {
    let edit = d.fix.as_ref().and_then(|fix| fix.edits.first());
    d.is(error::UNKNOWN_TYPE) && edit.is_some_and(|e| e.text.eq_ignore_ascii_case(name))
}

fn is_error(diagnostic: &Diagnostic) -> bool {
    diagnostic.severity == Severity::Error
}
