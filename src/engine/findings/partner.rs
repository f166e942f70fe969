//! Pairs vertex and fragment shaders, and reports link errors.

use super::stage::FileCheck;
use super::upgrade;
use crate::check_context::CheckContext;
use crate::shader::analysis::Analysis;
use crate::shader::input::SplitInput;
use crate::shader::reading::{PresumedCompleteness, Reading};
use crate::shader::shader_input::ShaderInput;
use crate::text::shader_file::shader_part;
use crate::text::stage_name::counterpart;
use shaderlint_detect::embed::{DocumentLanguage, Embedded, together};
use shaderlint_detect::kind::FileKind;
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_explain::link::link;
use shaderlint_explain::{Checked, analyze};
use shaderlint_lint::Settings;
use shaderlint_semantic::{Completeness, Function, Program, Stage, Unit};
use shaderlint_text::{Role, Sources};
use std::path::Path;
use std::sync::Arc;

/// How often the text of a page is linked on average at most: shaders may belong to several
/// programs.
const MAX_SHARED: usize = 16;

/// The name and text of the file with the other stage.
fn find(name: &str, context: CheckContext) -> Option<(String, Arc<str>)> {
    let (other, stage) = counterpart(name)?;
    // The fragment shader's check links both, but both must be known to convert one.
    let converts = context.options.settings.target_version().is_some();
    if stage == Stage::Vertex && context.file_access().is_checked(&other) && !converts {
        return None;
    }
    let text = context.files.load(Path::new(&other)).ok()?;
    Some((other, text))
}

/// Whether both stages are linked in the check of the other file, in the same run.
fn is_linked_there(name: &str, context: CheckContext) -> bool {
    let other = counterpart(name).filter(|(_, stage)| *stage == Stage::Vertex);
    other.is_some_and(|(other, _)| context.file_access().is_checked(&other))
}

/// Reads the other stage of a shader file, if there is one.
pub fn load(input: &mut SplitInput, name: &str, context: CheckContext) -> Option<ShaderInput> {
    let [part] = input.parts.as_slice() else {
        return None;
    };
    if !may_be_linked(part) || !input.embedded.is_empty() {
        return None;
    }
    let stage = part.reading()?.stage;
    let (name, text) = find(name, context)?;
    let problems = input.problems.len();
    let file =
        Arc::make_mut(&mut input.sources).add(name.as_str(), None, Role::User, text.clone())?;
    let made = shader_part(input, &name, file, &text, context);
    let mut others = input.parts.split_off(1);
    let other = others.pop().filter(|_| others.is_empty());
    // Errors in the other file are reported when that file is checked.
    let is_well = input.problems.len() == problems;
    input.problems.truncate(problems);
    made?;
    other.filter(|o| is_well && may_be_linked(o) && o.reading().is_some_and(|r| r.stage != stage))
}

/// Whether a shader file may be one stage of a program.
fn may_be_linked(part: &ShaderInput) -> bool {
    let is_complete = matches!(
        part.readings.presumed,
        PresumedCompleteness::Complete
            | PresumedCompleteness::CompleteIfDeclared
            | PresumedCompleteness::Unversioned
    );
    is_complete && part.may_be_program()
}

/// Links the shaders of a file, each with its partner, and reports errors.
pub fn link_all(file: &mut FileCheck) {
    let settings = &file.context.options.settings;
    let report = &mut file.report;
    let (sources, diagnostics) = (&report.sources, &mut report.diagnostics);
    if let (Some(other), [own]) = (&file.partner, file.parts.as_slice()) {
        let is_linked = is_linked_there(file.name, file.context);
        if !is_linked && !diagnostics.iter().any(keeps_from_linking) {
            link_stages(sources, own, other, diagnostics);
        }
        keep_pair(sources, own, other, settings, diagnostics);
        return;
    }
    if let ([one, other], true) = (file.parts.as_slice(), report.embedded.is_empty()) {
        let stage = |part: &ShaderInput| part.reading().map(|r| r.stage);
        if stage(one) != stage(other) {
            link_stages(sources, one, other, diagnostics);
            keep_pair(sources, one, other, settings, diagnostics);
        }
        return;
    }
    let embedded = &report.embedded;
    let document = report.file.and_then(|id| sources.file(id));
    let Some(document) = document.filter(|_| embedded.len() > 1) else {
        return;
    };
    let FileKind::Holds(language) = file.kind else {
        return;
    };
    let parts = programs(&file.parts, embedded);
    let whole = || (0..parts.len()).filter(|i| !embedded.get(*i).is_some_and(|e| e.is_part));
    // A document shows fragments of several programs.
    let only = match language {
        DocumentLanguage::Markdown | DocumentLanguage::Kdl => return,
        _ if whole().all(|i| parts.get(i).is_some_and(Option::is_some)) => {
            pair(&parts, &mut whole())
        }
        _ => None,
    };
    let mut pairs: Vec<(usize, usize)> = match only {
        Some(only) => vec![only],
        None => {
            let groups = together(language, &document.text, embedded);
            let pairs = groups.iter().map(|g| pair(&parts, &mut g.iter().copied()));
            pairs.flatten().collect()
        }
    };
    pairs.sort_unstable();
    pairs.dedup();
    let length = |i: usize| embedded.get(i).map_or(0, |e| e.code.len());
    let mut budget = MAX_SHARED * document.text.len();
    for (vertex, fragment) in pairs {
        let cost = length(vertex) + length(fragment);
        if cost > budget {
            return;
        }
        budget -= cost;
        let of = |i: usize| parts.get(i).copied().flatten();
        let (Some(vertex), Some(fragment)) = (of(vertex), of(fragment)) else {
            continue;
        };
        link_stages(sources, vertex, fragment, diagnostics);
        keep_pair(sources, vertex, fragment, settings, diagnostics);
    }
}

/// By embedded shader of a page: its shader, if it may be a stage of a program.
fn programs<'p>(parts: &'p [ShaderInput], embedded: &[Embedded]) -> Vec<Option<&'p ShaderInput>> {
    let mut all = vec![None; embedded.len()];
    for part in parts.iter().filter(|part| part.may_be_program()) {
        let place = part.embedded.and_then(|index| all.get_mut(index));
        if let Some(place) = place {
            *place = Some(part);
        }
    }
    all
}

/// The vertex and the fragment shader, if there is one of each.
fn pair(
    parts: &[Option<&ShaderInput>],
    members: &mut dyn Iterator<Item = usize>,
) -> Option<(usize, usize)> {
    let (mut vertex, mut fragment) = (None, None);
    for index in members {
        let slot = match parts.get(index).copied().flatten()?.reading()?.stage {
            Stage::Vertex => &mut vertex,
            Stage::Fragment => &mut fragment,
        };
        if slot.replace(index).is_some() {
            return None;
        }
    }
    Some((vertex?, fragment?))
}

/// Links a vertex and a fragment shader.
fn link_stages(
    sources: &Arc<Sources>,
    one: &ShaderInput,
    other: &ShaderInput,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let (vertex, fragment) = match one.reading().map(|r| r.stage) {
        Some(Stage::Vertex) => (one, other),
        _ => (other, one),
    };
    // Fragments may have several versions; a host uses the same version for both stages.
    let mut fragments = None;
    for (of_vertex, own) in programs_of(sources, vertex) {
        let all = || programs_of(sources, fragment).collect::<Vec<_>>();
        for (of_fragment, reading) in fragments.get_or_insert_with(all) {
            let starts_with_user = |r: &Reading| {
                let first = r.files.first().and_then(|id| sources.code(*id));
                first.is_some_and(|c| c.role == Role::User)
            };
            let has_versions = starts_with_user(own) && starts_with_user(reading);
            if of_vertex.program.version == of_fragment.program.version || has_versions {
                let found = link(&of_vertex.program, &of_fragment.program);
                let is_known = !of_vertex.lacks_names && !of_fragment.lacks_names;
                // A name that is not declared may assign a varying.
                diagnostics.extend(found.into_iter().filter(|d| is_known || is_error(d)));
                return;
            }
        }
    }
}

/// Keeps the stages of a program in one version.
fn keep_pair(
    sources: &Arc<Sources>,
    one: &ShaderInput,
    other: &ShaderInput,
    settings: &Settings,
    diagnostics: &mut [Diagnostic],
) {
    if settings.target_version().is_none() {
        return;
    }
    let program = |part: &ShaderInput| {
        if let Some(analysis) = &part.analysis {
            return Some(analysis.program.clone());
        }
        let reading = part.reading()?;
        Some(Arc::new(complete(sources, reading).program))
    };
    let (Some(one), Some(other)) = (program(one), program(other)) else {
        return;
    };
    let pair = match one.stage {
        Stage::Vertex => (&*one, &*other),
        Stage::Fragment => (&*other, &*one),
    };
    upgrade::keep_pair(pair, settings, diagnostics);
}

fn is_error(d: &Diagnostic) -> bool {
    d.severity == Severity::Error
}

/// Whether an error prevents linking: undeclared names do not affect the interface between stages.
fn keeps_from_linking(d: &Diagnostic) -> bool {
    is_error(d) && !d.is(error::UNDECLARED_NAME)
}

/// A shader, checked as a complete one.
fn complete(sources: &Arc<Sources>, reading: &Reading) -> Checked {
    analyze(&Unit {
        sources,
        files: &reading.files,
        stage: reading.stage,
        dialect: reading.dialect,
        context: reading.context,
        infer_channels: false,
        completeness: Completeness::Complete,
    })
}

/// A stage that may be linked.
struct LinkedStage {
    program: Arc<Program>,
    /// Whether it uses names that it does not declare.
    lacks_names: bool,
}

/// The readings of a shader in which it is complete and has no errors except unknown names.
fn programs_of<'p>(
    sources: &'p Arc<Sources>,
    part: &'p ShaderInput,
) -> impl Iterator<Item = (LinkedStage, &'p Reading)> {
    let readings = part.may_be_program().then_some(&part.readings.all);
    let readings = readings.into_iter().flatten().enumerate();
    let is_closed = part.missing.is_empty() && !part.readings.has_gaps();
    readings.filter_map(move |(index, reading)| {
        // A complete shader was checked in its first reading.
        let is_checked = |a: &&Analysis| index == 0 && a.completeness == Completeness::Complete;
        let checked = part.analysis.as_ref().filter(is_checked);
        let stage = match checked.filter(|a| !a.has_errors) {
            Some(analysis) => LinkedStage {
                program: analysis.program.clone(),
                lacks_names: false,
            },
            None => {
                let checked = complete(sources, reading);
                let mut found = checked.diagnostics.iter().filter(|d| is_error(d));
                let lacks_names = found.next().is_some();
                if checked.diagnostics.iter().any(keeps_from_linking) || lacks_names && !is_closed {
                    return None;
                }
                LinkedStage {
                    program: Arc::new(checked.program),
                    lacks_names,
                }
            }
        };
        let program = &stage.program;
        let is_main = |f: &Function| f.definition.is_some() && program.names.text(f.name) == "main";
        let has_main = program.functions.iter().any(is_main);
        has_main.then_some((stage, reading))
    })
}
