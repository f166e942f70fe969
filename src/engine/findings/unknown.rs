//! The severity of undeclared names in texts that a host may complete.
//!
//! A text is complete if no host can add to it: then an undeclared name is an error. In an open
//! text it is a warning if it looks like a typo and appears nowhere else in the repository; all
//! others are listed in one info per file.

use super::removed;
use super::stage::{FileCheck, ShaderCheck, Unresolved};
use super::typo::{Vocabulary, is_typo, variables};
use crate::hosts::host::Hosts;
use crate::shader::reading::code_of;
use crate::shader::shader_input::ShaderInput;
use shaderlint_diagnostic::{Diagnostic, Fix, Lack, Severity, error};
use shaderlint_explain::{Checked, OTHER_OVERLOAD};
use shaderlint_host::{matches_any, was_in_chunk};
use shaderlint_project::required_names;
use shaderlint_semantic::{BuiltinId, Completeness};
use shaderlint_syntax::{DIRECTIVES, GlExtension};
use shaderlint_text::{Edit, Role, Sources, Span};
use std::cell::LazyCell;
use std::collections::BTreeSet;

/// Maximum number of names that an info lists.
const MAX_LISTED: usize = 12;

/// Adds undeclared names to the diagnostics of a shader if they are mistakes, and to `unresolved`
/// if a host may declare them.
pub fn decide_severity(shader: &mut ShaderCheck) {
    let (sources, part, hosts) = (shader.sources, shader.part, shader.hosts);
    let (checked, unresolved) = (&mut shader.checked, &mut *shader.unresolved);
    if part.readings.is_shown() {
        return;
    }
    let code = code_of(sources, part.reading().map_or(&[], |r| &r.files));
    let vocabulary = LazyCell::new(|| Vocabulary::of(&code));
    if !checked.program.tokens.undecided.is_empty() {
        report_inactive(checked, &vocabulary, hosts);
    }
    let required = required(sources, part, &code);
    if checked.completeness == Completeness::Complete {
        leave_directives(checked, hosts);
        lower_extensions(checked, hosts);
        if part.readings.is_shadertoy() && code.contains("uniform ") {
            lower_shared(checked, hosts, &vocabulary);
        }
        return leave_macros(checked, hosts, (part.is_joined, &required));
    }
    leave_overloads(checked, hosts);
    let mut unknown = checked.open.unknown.clone();
    let count = |word: &str| vocabulary.count(word);
    let mut removed = removed::take(&mut unknown, (sources, part), hosts, count);
    checked.diagnostics.append(&mut removed);
    leave_given(&mut unknown, checked, part);
    let is_required = |d: &Diagnostic| required.iter().any(|name| name == sources.text(d.span));
    let (modules, mut unknown): (Vec<_>, Vec<_>) = unknown.into_iter().partition(is_required);
    for d in &mut unknown {
        suggest(d, sources.text(d.span), &vocabulary);
    }
    let named = |d: &Diagnostic| sources.text(d.span).to_string();
    let names = unknown.iter().map(named).collect::<BTreeSet<_>>().len();
    let is_known = is_known(part);
    let is_typo = |d: &Diagnostic| {
        let word = sources.text(d.span);
        is_near(d, word) && vocabulary.count(word) == 1
    };
    let is_forgotten = |d: &Diagnostic| is_forgotten(sources.text(d.span), hosts);
    let openness = Openness::of(part, &unknown, names, is_typo, is_forgotten);
    let (mut mistakes, mut others): (Vec<Diagnostic>, Vec<Diagnostic>) =
        unknown.into_iter().partition(|d| {
            let word = sources.text(d.span);
            let count = vocabulary.count(word);
            match openness {
                Openness::Forgetful => !hosts.is_given(word),
                Openness::Open => is_near(d, word) && !hosts.is_used_outside(word, count),
                // A host that is known gives it no text from elsewhere.
                Openness::Complete if is_known => !hosts.may_be_declared_in_script(word, count),
                Openness::Closed | Openness::Complete => {
                    !hosts.may_be_declared_outside(word, count)
                }
            }
        });
    others.extend(modules);
    unresolved.first = unresolved.first.or(others.first().map(|d| d.span));
    unresolved.names.extend(others.iter().map(named));
    part.readings
        .confirm(sources, checked.completeness, &mut mistakes);
    for d in &mut mistakes {
        let word = sources.text(d.span);
        let count = vocabulary.count(word);
        // What only other shaders declare may still be meant by them.
        let is_sure = openness == Openness::Complete
            && (hosts.is_in_script(word, count) || !hosts.is_used_outside(word, count));
        if !is_sure {
            d.severity = Severity::Warning;
        }
    }
    checked.diagnostics.append(&mut mistakes);
    sort(&mut checked.diagnostics);
}

/// Drops names that a host or an inactive group declares, and what scripts insert.
fn leave_given(unknown: &mut Vec<Diagnostic>, checked: &Checked, part: &ShaderInput) {
    if unknown.is_empty() {
        return;
    }
    let sources = &checked.program.sources;
    let optional = Optional::of(checked);
    unknown.retain(|d| {
        let word = sources.text(d.span);
        // Which release of the host completes the text, with which functions, is not known.
        let is_call = sources.text(Span::new(d.span.end, d.span.end + 1)) == "(";
        let has_host = !part.readings.hosts.is_empty();
        let was_given = is_call && has_host && was_in_chunk(word);
        // Programs set macros for chunks of a library.
        let is_macro = part.is_of_library && !word.contains(|c: char| c.is_ascii_lowercase());
        let was_given = was_given || is_macro;
        let is_given = was_given || matches_any(&part.readings.declared_at_times, word);
        is_word(word) && !is_given && !optional.declares(word)
    });
}

/// Drops warnings about calls of own functions that other files may overload.
fn leave_overloads(checked: &mut Checked, hosts: &Hosts) {
    let program = &checked.program;
    let sources = &program.sources;
    let own = |span: Span, name: &str| {
        let file = sources.file_id_at(span.start);
        let mut all = program.functions.iter();
        all.any(|f| {
            let declared = program.tree.function(f.declaration);
            let token = declared.and_then(|d| program.token(d.ident.token));
            let is_here = token.is_some_and(|t| sources.file_id_at(t.span.start) == file);
            is_here && program.names.text(f.name) == name
        })
    };
    let is_open = |d: &Diagnostic| {
        let labels = d.labels.iter().map(|l| sources.text(l.span));
        let callee = sources.text(d.span).split('(').next();
        let mut names = labels.chain(callee.map(|text| text.rsplit(' ').next().unwrap_or(text)));
        names.any(|name| own(d.span, name) && hosts.may_be_overloaded(name))
    };
    let is_unsure = |d: &Diagnostic| d.notes.iter().any(|note| note == OTHER_OVERLOAD);
    checked
        .diagnostics
        .retain(|d| d.severity != Severity::Warning || !is_unsure(d) || !is_open(d));
}

/// Drops errors about directives that a program of the repository mentions: it reads them.
fn leave_directives(checked: &mut Checked, hosts: &Hosts) {
    let sources = &checked.program.sources;
    let is_read = |d: &Diagnostic| {
        let code = sources.code_at(d.span.start);
        let line = code.and_then(|c| c.text.get((d.span.start - c.base) as usize..));
        let line = line.and_then(|rest| rest.trim_start().strip_prefix('#'));
        let word = line.map_or("", str::trim_start);
        let end = word.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let word = word.get(..end.unwrap_or(word.len())).unwrap_or("");
        !DIRECTIVES.contains(&word) && hosts.is_written_by_program("#", word)
    };
    checked
        .diagnostics
        .retain(|d| !d.is(error::BAD_DIRECTIVE) || d.fix.is_some() || !is_read(d));
}

/// Lowers errors about functions of extensions, if a program of the repository writes the directive.
fn lower_extensions(checked: &mut Checked, hosts: &Hosts) {
    let program = &checked.program;
    let (sources, version) = (&program.sources, program.version);
    let missing = checked.diagnostics.iter_mut();
    for d in missing.filter(|d| d.is(error::NEEDS_WEBGL2)) {
        let added_by = GlExtension::that_adds(sources.text(d.span), version);
        let directives = added_by.map_or(&[][..], |extension| extension.facts().directives);
        let is_written = |name: &&&str| hosts.is_written_by_program("#extension ", name);
        if let Some(name) = directives.iter().find(is_written) {
            d.severity = Severity::Warning;
            d.notes.push(format!(
                "right if a program adds `#extension {name} : enable`"
            ));
        }
    }
}

/// Lowers errors about names of other files in a pass that declares uniforms, which a program other than
/// ShaderToy's sets.
fn lower_shared(checked: &mut Checked, hosts: &Hosts, vocabulary: &Vocabulary) {
    let sources = &checked.program.sources;
    let missing = checked.diagnostics.iter_mut();
    for d in missing.filter(|d| d.lacks() == Some(Lack::Name)) {
        let word = sources.text(d.span);
        if hosts.is_used_outside(word, vocabulary.count(word)) {
            d.severity = Severity::Warning;
        }
    }
}

/// Leaves open what a script defines as a macro of a complete shader, which its host inserts after
/// `#version`, and lowers errors about functions of files that a script may put before it.
fn leave_macros(checked: &mut Checked, hosts: &Hosts, (is_joined, required): (bool, &[String])) {
    let sources = &checked.program.sources;
    let is_macro = |d: &Diagnostic| {
        let name = sources.text(d.span);
        let is_given = || {
            hosts.is_given(name)
                || hosts.is_written_by_program("'", name)
                || required.iter().any(|own| own == name)
        };
        d.lacks() == Some(Lack::Name) && is_given()
    };
    let all = std::mem::take(&mut checked.diagnostics);
    let (macros, others): (Vec<_>, Vec<_>) = all.into_iter().partition(is_macro);
    checked.diagnostics = others;
    let is_call = |d: &Diagnostic| sources.text(Span::new(d.span.end, d.span.end + 1)) == "(";
    let missing = checked.diagnostics.iter_mut();
    // A typo is none.
    let is_missing =
        |d: &&mut Diagnostic| d.lacks() == Some(Lack::Name) && d.fix.is_none() && is_call(d);
    for d in missing.filter(is_missing) {
        if !is_joined && hosts.may_be_joined(sources.text(d.span)) {
            d.severity = Severity::Warning;
            d.notes.push(
                "a text without `main` declares it: right if a script puts both together"
                    .to_string(),
            );
        }
    }
    if !macros.is_empty() {
        let names = macros.iter().map(|d| sources.text(d.span).to_string());
        checked.open.names.extend(names);
        checked.open.unknown.extend(macros);
        checked.completeness = Completeness::Chunk;
    }
}

fn sort(diagnostics: &mut [Diagnostic]) {
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
}

/// The groups of a text that its host may activate.
struct Optional<'p>(Vec<Vocabulary<'p>>);

impl<'p> Optional<'p> {
    fn of(checked: &'p Checked) -> Optional<'p> {
        let program = &checked.program;
        let tokens = &program.tokens;
        let sources = &program.sources;
        // The chunks of a host have names.
        let is_of_chunk = |span: &Span| {
            let file = sources.file_at(span.start);
            file.is_some_and(|f| f.role == Role::Prelude && !f.path.is_empty())
        };
        let is_own = |span: &&Span| match sources.is_user(span.start) {
            true => tokens.is_undecided(**span),
            false => is_of_chunk(span),
        };
        let groups = tokens.inactive.iter().filter(is_own);
        Optional(
            groups
                .map(|g| Vocabulary::of(program.sources.text(*g)))
                .collect(),
        )
    }

    fn declares(&self, word: &str) -> bool {
        self.0.iter().any(|group| group.declares(word))
    }
}

/// What a host may add to a text.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Openness {
    /// No declarations.
    Complete,
    /// None of the names that it lacks: scripts set them, or other shaders declare them for themselves.
    Forgetful,
    /// Nothing that is known: it has an entry function, and declares all names except one.
    Closed,
    /// Any declarations.
    Open,
}

impl Openness {
    /// Of a text with undeclared names; `names` is how many different ones they are.
    fn of(
        part: &ShaderInput,
        unknown: &[Diagnostic],
        names: usize,
        is_typo: impl Fn(&Diagnostic) -> bool,
        is_forgotten: impl Fn(&Diagnostic) -> bool,
    ) -> Openness {
        let readings = &part.readings;
        if !readings.holds_entry() && !readings.is_called || readings.has_gaps() {
            return Openness::Open;
        }
        // A text in which all undeclared names are typos needs no host.
        if is_known(part) || unknown.iter().all(is_typo) {
            Openness::Complete
        } else if unknown.iter().all(is_forgotten) {
            Openness::Forgetful
        } else if names == 1 {
            Openness::Closed
        } else {
            Openness::Open
        }
    }
}

/// The names of modules of glslify that are not found.
fn required(sources: &Sources, part: &ShaderInput, code: &str) -> Vec<String> {
    let directives = part
        .missing
        .iter()
        .map(|missing| sources.text(missing.span));
    directives.chain([code]).flat_map(required_names).collect()
}

/// Whether a name is a macro of scripts, or one that no host declares.
fn is_forgotten(word: &str, hosts: &Hosts) -> bool {
    hosts.is_given(word) || hosts.is_forgotten(word)
}

/// Whether all that the hosts of a text add to it is known.
fn is_known(part: &ShaderInput) -> bool {
    match part.readings.hosts.is_empty() {
        _ if part.is_of_library => true,
        true => part.embedder.hands_over,
        false => part.readings.are_hosts_complete,
    }
}

/// Suggests a declared name if the checker found none: the declaration may be in code that was not
/// parsed.
fn suggest(d: &mut Diagnostic, word: &str, vocabulary: &Vocabulary) {
    if d.fix.is_none() && d.labels.is_empty() {
        d.fix = vocabulary.nearest(word).map(|near| meant(d.span, near));
    }
}

fn meant(span: Span, near: &str) -> Fix {
    let edits = vec![Edit::replace(span, near)];
    Fix::suggestion(format!("did you mean `{near}`?"), edits)
}

/// Reports typos in inactive `#if` groups that the host may activate.
fn report_inactive(checked: &mut Checked, vocabulary: &Vocabulary, hosts: &Hosts) {
    let program = &checked.program;
    let (sources, tokens) = (&program.sources, &program.tokens);
    let groups = tokens
        .inactive
        .iter()
        .filter(|span| sources.is_user(span.start) && tokens.is_undecided(**span));
    for group in groups {
        for (at, word) in variables(sources.text(*group)) {
            let is_known = program.names.get(word).is_some()
                || BuiltinId::named(word).is_some()
                || vocabulary.count(word) != 1;
            let near = || vocabulary.nearest(word);
            let Some(near) = (!is_known).then(near).flatten() else {
                continue;
            };
            if hosts.is_used_outside(word, 1) {
                continue;
            }
            let start = group.start + at as u32;
            let span = Span::new(start, start + word.len() as u32);
            let message = format!("`{word}` is not declared");
            let d = Diagnostic::of(error::UNDECLARED_NAME, Severity::Warning, span, message);
            checked.diagnostics.push(d.fix(Some(meant(span, near))));
        }
    }
    sort(&mut checked.diagnostics);
}

fn is_word(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Whether a name looks like a typo of a declared name, or is declared but not visible.
fn is_near(d: &Diagnostic, word: &str) -> bool {
    let near = d.fix.as_ref().and_then(|f| f.edits.first());
    !d.labels.is_empty() || near.is_some_and(|edit| is_typo(word, &edit.text))
}

/// Adds one info about the names that the hosts of a file have to declare.
pub fn list_unresolved(file: &mut FileCheck) {
    file.report.diagnostics.extend(file.unresolved.report());
}

impl Unresolved {
    /// The info about these names.
    fn report(&self) -> Option<Diagnostic> {
        let count = self.names.len();
        let listed: Vec<String> = self
            .names
            .iter()
            .take(MAX_LISTED)
            .map(|n| format!("`{n}`"))
            .collect();
        let more = count - listed.len();
        let message = match (self.names.first()?, more) {
            (name, _) if count == 1 => format!("`{name}` is not declared in this file"),
            (_, 0) => format!(
                "{count} names are not declared in this file: {}",
                listed.join(", ")
            ),
            (_, more) => format!(
                "{count} names are not declared in this file: {} and {more} more",
                listed.join(", ")
            ),
        };
        let d = Diagnostic::of(error::UNDECLARED_NAME, Severity::Info, self.first?, message);
        Some(d.note("names that a shader fragment does not declare must be declared by its host"))
    }
}
