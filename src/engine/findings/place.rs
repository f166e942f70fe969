//! Maps positions in shaders to positions in the file that contains them, and back.

use super::report::Report;
use crate::shader::analysis::Analysis;
use shaderlint_detect::embed::Embedded;
use shaderlint_text::{Edit, Span};

impl Report {
    /// The address of an offset in the input; `None` in an export outside of the code of its
    /// passes.
    pub fn address(&self, offset: u32) -> Option<u32> {
        if let Some(export) = &self.export {
            return export.address(&self.sources, offset);
        }
        let file = self.sources.file(self.file?)?;
        (offset <= file.span().len()).then(|| file.base + offset)
    }

    /// A span in the input; `None` if it belongs to another file.
    pub fn in_input(&self, span: Span) -> Option<Span> {
        if let Some(export) = &self.export {
            return export.in_json(&self.sources, span);
        }
        let file = self.sources.file(self.file?)?.span();
        let is_inside = file.contains(span);
        is_inside.then(|| Span::new(span.start - file.start, span.end - file.start))
    }

    /// An edit of the input; `None` if it belongs to another file, or if the surrounding language
    /// would change its meaning.
    pub fn edit_of_input(&self, edit: &Edit) -> Option<Edit> {
        if let Some(export) = &self.export {
            return export.edit(&self.sources, edit);
        }
        let file = self.sources.file(self.file?)?;
        let edit = Edit {
            span: self.in_input(edit.span)?,
            text: edit.text.clone(),
        };
        let is_admitted = !self.holds_others
            || (self.embedded.iter()).any(|shader| shader.admits(&file.text, &edit));
        is_admitted.then_some(edit)
    }

    /// The analysis of the shader that contains an address. Text that other shaders include belongs
    /// to its own pass or stage.
    pub fn analysis_at(&self, address: u32) -> Option<&Analysis> {
        let code = self.sources.code_at(address)?;
        let end = code.base + code.text.len() as u32;
        let ends_here = |analysis: &&Analysis| {
            let last = analysis.program.tokens.tokens.last();
            last.is_some_and(|token| token.span.start == end)
        };
        // Common code is not a shader of its own: the first pass that includes it is used. A shader
        // that was composed for its host ends in the host's text.
        let reads = |analysis: &&Analysis| {
            let mut tokens = analysis.program.tokens.tokens.iter();
            tokens.any(|token| {
                (code.base..=end).contains(&token.span.start) && token.span.end > code.base
            })
        };
        let is_composed = self.embedded.is_empty() && self.analyses.len() == 1;
        let is_shared = self.export.is_some() || is_composed;
        // A script may insert text into a shader.
        let offset = self.file.and_then(|id| self.sources.file(id));
        let offset = offset.map_or(0, |file| address.saturating_sub(file.base) as usize);
        let is_inside = |e: &Embedded| (e.start..=e.end()).contains(&offset);
        let is_shared = is_shared || self.embedded.iter().any(is_inside);
        let shared = || self.analyses.iter().find(reads).filter(|_| is_shared);
        self.analyses.iter().find(ends_here).or_else(shared)
    }
}
