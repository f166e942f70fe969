//! Splits the text of a file into its shaders.

use super::shader_file::shader_part;
use super::{embedded, foreign};
use crate::check_context::CheckContext;
use crate::hosts::hosted;
use crate::options::Desktop;
use crate::shader::export::ExportText;
use crate::shader::input::SplitInput;
use crate::shader::shader_input::ShaderInput;
use shaderlint_detect::embed::extract_with;
use shaderlint_detect::kind::{Decision, FileKind, ShaderLanguage};
use shaderlint_project::{ModuleCache, Project, ProjectError, ScriptModules, compose};
use shaderlint_text::Role;
use std::fmt;
use std::sync::Arc;

/// Why a text was not checked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Unread {
    /// It is not a kind of file that is checked.
    Skipped(Decision),
    /// It is an invalid ShaderToy export.
    Export(ProjectError),
    /// It has the extension of GLSL, but contains none and cannot be parsed.
    NotGlsl,
    /// The text exceeds the address space of 4 GiB.
    TooLarge,
}

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unread::Skipped(decision) => decision.fmt(f),
            Unread::Export(error) => error.fmt(f),
            Unread::NotGlsl => f.write_str("the text is not GLSL"),
            Unread::TooLarge => f.write_str("the file is too large"),
        }
    }
}

/// Splits a text, whose kind was decided.
pub fn split(
    name: &str,
    text: &str,
    context: CheckContext,
    decision: Decision,
) -> Result<SplitInput, Unread> {
    let options = context.options;
    let mut input = SplitInput::default();
    match decision.kind {
        FileKind::Other => return Err(Unread::Skipped(decision)),
        FileKind::Foreign(_) if options.desktop == Desktop::Skip => {
            return Err(Unread::Skipped(decision));
        }
        FileKind::Export => {
            let project = match text.trim_start().starts_with('<') {
                true => Project::draft("", text, None).map_err(|_| Unread::Skipped(decision))?,
                false => Project::from_json(text).map_err(|e| no_project(e, text, decision))?,
            };
            let composed = compose(&project, name).ok_or(Unread::TooLarge)?;
            input.export = Some(ExportText::of(text, &project, &composed));
            input.sources = composed.sources;
            input.parts = composed
                .units
                .into_iter()
                .map(|unit| ShaderInput::of_pass(unit, project.host))
                .collect();
            return Ok(input);
        }
        FileKind::Shader | FileKind::Foreign(_) | FileKind::Holds(_) => {}
    }
    let file = Arc::make_mut(&mut input.sources).add(name, None, Role::User, text);
    let file = file.ok_or(Unread::TooLarge)?;
    input.file = Some(file);
    match decision.kind {
        FileKind::Holds(language) => {
            let read = ModuleCache::default();
            let modules = ScriptModules::new(name, context.file_access(), &read);
            input.embedded = extract_with(name, language, text, &modules);
            embedded::parts(&mut input, name, language, file, text, context)
        }
        FileKind::Shader
            if hosted::is_pass_of_another(text, options)
                && hosted::part(&mut input, name, (file, 0), text, context)
                    .ok_or(Unread::TooLarge)? =>
        {
            Some(())
        }
        FileKind::Foreign(ShaderLanguage::Desktop)
            if options.desktop == Desktop::Report
                && hosted::part(&mut input, name, (file, 0), text, context)
                    .ok_or(Unread::TooLarge)? =>
        {
            Some(())
        }
        FileKind::Foreign(language) if !foreign::is_ported(language, options) => {
            foreign::report_file(&mut input, file, text, language, &decision)
        }
        _ => shader_part(&mut input, name, file, text, context),
    }
    .ok_or(Unread::TooLarge)?;
    Ok(input)
}

/// JSON that is not an export is skipped, unless it mentions render passes.
fn no_project(error: ProjectError, text: &str, decision: Decision) -> Unread {
    let is_meant = text.contains("\"renderpass\"");
    match error {
        ProjectError::NotAnExport => Unread::Skipped(decision.no_export()),
        ProjectError::Json { .. } if !is_meant => Unread::Skipped(decision.no_export()),
        error => Unread::Export(error),
    }
}
