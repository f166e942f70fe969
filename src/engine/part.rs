//! One shader of an input.

use super::World;
use super::analysis::Analysis;
use super::document::Read;
use super::foreign;
use super::host::Hosts;
use super::include::{MissingInclude, is_common, spread};
use super::options::{DialectChoice, HostUniform, Options};
use super::reading::{InputText, Reading, Readings, Standing, Surroundings, lacking};
use crate::diagnostic::{Diagnostic, Severity, error};
use crate::lint::{Allows, Judged, Settings, Unrun, keep_comments, lint_within};
use crate::port::PassUnit;
use crate::rules::RULES;
use crate::semantic::{Checked, Dialect, Guess, GuessedKind, Stage, Wholeness, guess};
use crate::syntax::{Lexer, RawKind, Version, WordClass, classify};
use crate::text::embed::{Embedder, mask};
use crate::text::kind::ending;
use crate::text::{FileId, Role, Sources};
use std::collections::BTreeSet;
use std::sync::Arc;

/// One shader of an input.
pub struct Part {
    /// The ways to read it.
    pub readings: Readings,
    /// Whether its channels may be of any type.
    pub infer_channels: bool,
    /// The page or script around it.
    pub embedder: Embedder,
    /// What it includes and is not found.
    pub missing: Vec<MissingInclude>,
    /// What came of checking it, where that is kept.
    pub analysis: Option<Analysis>,
}

/// Whether what is known of a shader is kept.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Keep {
    /// Only what is said of it.
    Findings,
    /// All of it.
    Programs,
}

impl Part {
    /// A pass of an export.
    pub fn of_pass(unit: PassUnit) -> Part {
        let reading = Reading {
            files: unit.files,
            stage: Stage::Fragment,
            dialect: Dialect::ShaderToy(unit.kind),
        };
        Part {
            readings: Readings::whole(reading),
            infer_channels: false,
            embedder: Embedder::default(),
            missing: Vec::new(),
            analysis: None,
        }
    }

    /// The likeliest way to read it.
    pub fn reading(&self) -> Option<&Reading> {
        self.readings.all.first()
    }

    /// Whether it may be linked with another stage.
    pub fn may_be_program(&self) -> bool {
        self.readings.standing != Standing::Excerpt
            && self.reading().is_some_and(|r| !r.dialect.is_shadertoy())
    }
}

/// Finds what is to be said of a shader, and says what was looked at; of one with errors also what
/// was judged at all.
pub fn check_part(
    sources: &mut Arc<Sources>,
    part: &mut Part,
    hosts: &Hosts,
    options: &Options,
    keep: Keep,
    allows: &mut Allows,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<(Shader, Option<Judged>)> {
    let mut checked = understand(sources, part, hosts, options)?;
    let told = tell_part(
        sources,
        part,
        &mut checked,
        &options.settings,
        allows,
        diagnostics,
    )?;
    if keep == Keep::Programs {
        part.analysis = Some(Analysis::new(checked, told.0.has_errors));
    }
    Some(told)
}

/// Checks a shader. Where it lacks something, its host is looked for first.
fn understand(
    sources: &mut Arc<Sources>,
    part: &mut Part,
    hosts: &Hosts,
    options: &Options,
) -> Option<Checked> {
    let is_open = options.dialect == DialectChoice::Auto
        && options.host.preset.is_none()
        && !part.readings.is_shadertoy();
    let checked = part.readings.check(sources, part.infer_channels)?;
    let lacking = lacking(&checked).filter(|_| is_open);
    let (presets, is_sure) = lacking.map_or((Vec::new(), true), |lacking| {
        hosts.of(&lacking, &part.readings)
    });
    if presets.is_empty() {
        return Some(checked);
    }
    drop(checked);
    part.readings
        .host(Arc::make_mut(sources), &presets, options)?;
    part.readings.is_guessed = !is_sure;
    part.readings.check(sources, part.infer_channels)
}

/// Runs the rules over a shader that was checked, and gathers what is to be said.
fn tell_part(
    sources: &Sources,
    part: &Part,
    checked: &mut Checked,
    settings: &Settings,
    allows: &mut Allows,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<(Shader, Option<Judged>)> {
    let wholeness = checked.wholeness;
    let known = diagnostics.len();
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    let errors = checked.diagnostics.iter().filter(is_error).count();
    allows.expect(&checked.program, RULES, &mut checked.diagnostics);
    let mut left_out = 0;
    // Where something is open, no rule knows enough.
    let unrun = if !checked.open.is_any && wholeness != Wholeness::Excerpt {
        let mut found = Vec::new();
        let (program, errors) = (&checked.program, &checked.diagnostics);
        let unrun = lint_within(program, part.embedder, errors, RULES, settings, &mut found);
        if unrun != Unrun::Everywhere {
            allows.apply(&checked.program, RULES, &mut found);
        }
        if let Unrun::Functions { broken, .. } = &unrun {
            allows.excuse(broken);
        }
        found.retain(|d| sources.is_user(d.span.start));
        if wholeness != Wholeness::Whole {
            // What a host makes of it is not known well enough to write anything unasked.
            foreign::ask_first(&mut found);
        }
        found.sort_by_key(|d| (d.span.start, d.span.end));
        left_out = found.len().saturating_sub(MAX_FINDINGS);
        found.truncate(MAX_FINDINGS);
        diagnostics.append(&mut found);
        unrun
    } else {
        Unrun::Everywhere
    };
    keep_under_hosts(sources, &part.readings, &mut checked.diagnostics);
    if wholeness != Wholeness::Whole {
        // The program around a part knows its names.
        let names = checked.diagnostics.iter_mut();
        let renamed = names.filter(|d| d.rule == error::RESERVED_WORD);
        renamed.for_each(|d| foreign::ask_first(std::slice::from_mut(d)));
    }
    diagnostics.append(&mut checked.diagnostics);
    let own = diagnostics.get_mut(known..).unwrap_or(&mut []);
    if wholeness != Wholeness::Whole {
        let hosts: Arc<[String]> = part.readings.hosts.as_slice().into();
        own.iter_mut().for_each(|d| d.part = Some(hosts.clone()));
    }
    if own.iter().any(|d| d.fix.is_some()) {
        let mut comments = checked.program.tokens.comments.clone();
        comments.sort();
        for diagnostic in own {
            keep_comments(sources, &comments, diagnostic);
        }
    }
    let program = &checked.program;
    let judged = (errors > 0).then(|| Judged::of(program));
    let own = |id: &&FileId| sources.code(**id).is_some_and(|c| c.role == Role::User);
    let shader = Shader {
        missing: part.missing.clone(),
        file: part.reading()?.files.iter().rev().find(own).copied(),
        stage: program.stage,
        dialect: program.dialect,
        version: program.version,
        wholeness,
        unrun,
        has_errors: errors > 0,
        left_out,
        size: program.size(),
        holes: std::mem::take(&mut checked.open.names),
        hosts: part.readings.hosts.clone(),
    };
    Some((shader, judged))
}

/// Keeps what is wrong even if the hosts give other names, or are not the ones that were guessed.
fn keep_under_hosts(sources: &Sources, readings: &Readings, diagnostics: &mut Vec<Diagnostic>) {
    if readings.renames {
        diagnostics.retain(|d| d.rule != error::RESERVED_WORD);
    }
    if readings.is_guessed && !readings.needs_300() {
        // Where only the project speaks for a host, the text may go by another way, as GLSL ES 1.00.
        diagnostics.retain(|d| {
            let word = classify(sources.text(d.span), Version::Es100);
            let is_free = d.rule == error::RESERVED_WORD && word == WordClass::Plain;
            d.rule != error::BUILTIN_REDEFINITION && !is_free
        });
    }
}

/// What was read as one shader, and how far rules looked at it.
#[derive(Clone, Debug)]
pub struct Shader {
    /// Its last file.
    pub file: Option<FileId>,
    /// The stage.
    pub stage: Stage,
    /// How many tokens and macro calls it has.
    pub size: usize,
    /// Who runs it.
    pub dialect: Dialect,
    /// The version of the language.
    pub version: Version,
    /// How much of it is at hand.
    pub wholeness: Wholeness,
    /// Where no rule looked.
    pub unrun: Unrun,
    /// Whether the browser would refuse it as it stands.
    pub has_errors: bool,
    /// Findings of the rules that are not kept, since there are too many.
    pub left_out: usize,
    /// What its host has to declare.
    pub holes: BTreeSet<String>,
    /// The hosts that are thought to complete it.
    pub hosts: Vec<String>,
    /// What it includes and is not found.
    pub missing: Vec<MissingInclude>,
}

/// Most findings of the rules in one shader; whoever mends these sees the next.
const MAX_FINDINGS: usize = 500;

/// Makes the one shader of a shader file. `None` where it is too large.
pub(super) fn shader_part(
    read: &mut Read,
    name: &str,
    file: FileId,
    text: &str,
    world: World,
) -> Option<()> {
    let options = world.options;
    let extension = ending(name);
    let stage = match extension.as_str() {
        "vert" | "vs" | "vsh" => Some(Stage::Vertex),
        "frag" | "fs" | "fsh" => Some(Stage::Fragment),
        _ => None,
    };
    let told = guess(text);
    let masked = match may_be_template(text, &told, options) {
        true => mask(text),
        false => None,
    };
    let has_holes = masked.is_some();
    let (files, is_open, missing) = match masked {
        Some(code) => (
            vec![Arc::make_mut(&mut read.sources).embed(file, 0, code)?],
            true,
            Vec::new(),
        ),
        None => {
            let own = spread(read, name, file, text, world)?;
            (own.files, own.is_open, own.missing)
        }
    };
    let about = InputText {
        files,
        stage,
        surroundings: match stage {
            _ if is_common(name, text, world) => Surroundings::CommonFile,
            Some(_) => Surroundings::StageFile,
            None => Surroundings::File,
        },
        is_open,
        is_300: false,
        has_holes,
    };
    let readings = Readings::of(
        Arc::make_mut(&mut read.sources),
        (text, told),
        about,
        options,
    )?;
    let first = readings.all.first()?;
    read.parts.push(Part {
        infer_channels: first.dialect.is_shadertoy(),
        readings,
        embedder: Embedder::default(),
        missing,
        analysis: None,
    });
    Some(())
}

/// Whether a program may fill holes in a shader file. In a text that shows itself to be whole only
/// what has no meaning in GLSL and two ends is one.
fn may_be_template(text: &str, told: &Guess, options: &Options) -> bool {
    let is_whole = told.kind.is_some_and(GuessedKind::is_whole);
    let has_ends = ["${", "{{", "<%", "{%"].iter().any(|s| text.contains(s));
    options.dialect == DialectChoice::Auto && (has_ends || !is_whole)
}

/// Puts what the host declares where it belongs: before the text, but behind `#version`.
pub fn with_host(
    sources: &mut Sources,
    header: Option<String>,
    own: Vec<FileId>,
    options: &Options,
) -> Option<Vec<FileId>> {
    let declared = declarations(sources, &own, &options.host.uniforms);
    let Some(header) = header else {
        if declared.is_empty() {
            return Some(own);
        }
        let prelude = sources.add("", None, Role::Prelude, declared)?;
        return behind_version(sources, own, prelude);
    };
    let mut files = vec![sources.add("", None, Role::Prelude, header + &declared)?];
    files.extend(own);
    Some(files)
}

/// Declares the host's uniforms, without those that the shader declares itself.
fn declarations(sources: &Sources, own: &[FileId], uniforms: &[HostUniform]) -> String {
    let texts = || own.iter().filter_map(|id| Some(sources.code(*id)?.text));
    let mut text = String::new();
    for uniform in uniforms {
        let HostUniform { name, ty, size } = uniform;
        if texts().any(|code| declares(code, name)) {
            continue;
        }
        let precision = if ty.starts_with('b') { "" } else { "highp " };
        let size = size.map_or(String::new(), |s| format!("[{s}]"));
        text.push_str(&format!("uniform {precision}{ty} {name}{size};\n"));
    }
    text
}

/// Whether a text declares a uniform of this name.
fn declares(code: &str, name: &str) -> bool {
    if !code.contains(name) {
        return false;
    }
    let mut lexer = Lexer::new(code, 0);
    let mut in_uniform = false;
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        match (token.kind, code.get(range).unwrap_or("")) {
            (RawKind::End, _) => return false,
            (RawKind::Word, "uniform") => in_uniform = true,
            (RawKind::Word, word) if in_uniform && word == name => return true,
            (_, ";") => in_uniform = false,
            _ => {}
        }
    }
}

/// Puts a prelude behind the line with `#version`, or in front where there is none.
pub fn behind_version(
    sources: &mut Sources,
    own: Vec<FileId>,
    prelude: FileId,
) -> Option<Vec<FileId>> {
    let mut own = own.into_iter();
    let first = own.next()?;
    let code = sources.code(first)?;
    let (text, base) = (code.text.to_string(), code.base);
    let mut files = Vec::new();
    match version_end(&text) {
        None => files.extend([prelude, first]),
        Some(behind) => {
            let file = sources.file_id_at(base)?;
            let offset = (base - sources.file(file)?.base) as usize;
            files.push(sources.embed(file, offset, text.get(..behind)?)?);
            files.push(prelude);
            files.push(sources.embed(file, offset + behind, text.get(behind..)?)?);
        }
    }
    files.extend(own);
    Some(files)
}

/// Where the line behind `#version` starts.
fn version_end(text: &str) -> Option<usize> {
    let mut lexer = Lexer::new(text, 0);
    let mut after_hash = false;
    let mut seen = false;
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        match token.kind {
            RawKind::End => return None,
            RawKind::Newline if seen => return Some(range.end),
            RawKind::Hash => after_hash = true,
            RawKind::Word => {
                seen |= after_hash && text.get(range) == Some("version");
                after_hash = false;
            }
            _ => {}
        }
    }
}
