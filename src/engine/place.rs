//! Places of shaders as places of the text that holds them, and the other way.

use super::analysis::Analysis;
use super::document::Report;
use shaderlint_text::{Edit, Span};

impl Report {
    /// The address of what stands at an offset of the text of the input; `None` in an export outside
    /// of the code of its passes.
    pub fn address(&self, offset: u32) -> Option<u32> {
        if let Some(export) = &self.export {
            return export.address(&self.sources, offset);
        }
        let file = self.sources.file(self.file?)?;
        (offset <= file.span().len()).then(|| file.base + offset)
    }

    /// A stretch as one of the text of the input; `None` where it belongs to another file.
    pub fn in_input(&self, span: Span) -> Option<Span> {
        if let Some(export) = &self.export {
            return export.in_json(&self.sources, span);
        }
        let file = self.sources.file(self.file?)?.span();
        let is_inside = file.contains(span);
        is_inside.then(|| Span::new(span.start - file.start, span.end - file.start))
    }

    /// An edit as one of the text of the input; `None` where it belongs to another file, and where
    /// the language around the shader would read it otherwise.
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

    /// What is known of the shader whose code stands at an address: of the pass or stage itself where
    /// others read the same text before theirs.
    pub fn analysis_at(&self, address: u32) -> Option<&Analysis> {
        let code = self.sources.code_at(address)?;
        let end = code.base + code.text.len() as u32;
        let ends_here = |analysis: &&Analysis| {
            let last = analysis.program.tokens.tokens.last();
            last.is_some_and(|token| token.span.start == end)
        };
        // What passes share is no shader of its own: the first of them speaks for it.
        let reads = |analysis: &&Analysis| {
            let mut tokens = analysis.program.tokens.tokens.iter();
            tokens.any(|token| {
                (code.base..=end).contains(&token.span.start) && token.span.end > code.base
            })
        };
        let is_shared = self.export.is_some();
        let shared = || self.analyses.iter().find(reads).filter(|_| is_shared);
        self.analyses.iter().find(ends_here).or_else(shared)
    }
}
