//! Trials: an edited copy of a shader is checked, and its findings are mapped back to the original.

use shaderlint_diagnostic::{Diagnostic, Fix};
use shaderlint_semantic::Unit;
use shaderlint_text::{Edit, FileId, Sources, Span, apply_edits};
use std::sync::Arc;

/// A range of text that is equal in the copy and the original.
struct Stretch {
    copy: u32,
    original: u32,
    len: u32,
}

/// An edited copy of a shader's files.
pub(super) struct EditedUnit {
    pub sources: Arc<Sources>,
    pub files: Vec<FileId>,
    /// In order of addresses in the copy.
    stretches: Vec<Stretch>,
}

impl EditedUnit {
    /// Applies the edits; `None` if they do not match the text.
    pub fn new(unit: &Unit, edits: &[Edit]) -> Option<EditedUnit> {
        let mut sources = Sources::new();
        let mut copy = EditedUnit {
            sources: Arc::default(),
            files: Vec::new(),
            stretches: Vec::new(),
        };
        for &id in unit.files {
            let code = unit.sources.code(id)?;
            let end = code.base + code.text.len() as u32;
            let mut own: Vec<Edit> = edits
                .iter()
                .filter(|e| code.base <= e.span.start && e.span.end <= end)
                .cloned()
                .collect();
            own.sort_by_key(|e| e.span);
            let text = apply_edits(code.text, code.base, &own).ok()?;
            let file = unit.sources.file_at(code.base)?;
            let added = sources.add(file.path.clone(), file.part.clone(), file.role, text)?;
            let base = sources.file(added)?.base;
            copy.files.push(added);
            copy.note_stretches(base, code.base, end, &own);
        }
        copy.sources = Arc::new(sources);
        Some(copy)
    }

    fn note_stretches(&mut self, base: u32, from: u32, end: u32, edits: &[Edit]) {
        let (mut at, mut original) = (base, from);
        for edit in edits {
            let len = edit.span.start - original;
            self.stretches.push(Stretch {
                copy: at,
                original,
                len,
            });
            at += len + edit.text.len() as u32;
            original = edit.span.end;
        }
        self.stretches.push(Stretch {
            copy: at,
            original,
            len: end - original,
        });
    }

    /// The edited shader.
    pub fn unit<'a>(&'a self, unit: &Unit) -> Unit<'a> {
        Unit {
            sources: &self.sources,
            files: &self.files,
            stage: unit.stage,
            dialect: unit.dialect,
            context: unit.context,
            infer_channels: unit.infer_channels,
            completeness: unit.completeness,
        }
    }

    /// Maps an address in the copy to the original; inserted text maps to the insertion point.
    fn address(&self, address: u32) -> u32 {
        let after = self.stretches.partition_point(|s| s.copy <= address);
        match after.checked_sub(1).and_then(|i| self.stretches.get(i)) {
            Some(s) => s.original + (address - s.copy).min(s.len),
            None => address,
        }
    }

    fn span(&self, span: Span) -> Span {
        Span::new(self.address(span.start), self.address(span.end))
    }

    /// Maps a finding in the copy to the original.
    pub fn back(&self, mut d: Diagnostic) -> Diagnostic {
        d.span = self.span(d.span);
        for label in &mut d.labels {
            label.span = self.span(label.span);
        }
        for used in &mut d.macros {
            used.call = self.span(used.call);
            if !used.definition.is_empty() {
                used.definition = self.span(used.definition);
            }
        }
        if let Some(fix) = &mut d.fix {
            self.fix_back(fix);
        }
        d
    }

    fn fix_back(&self, fix: &mut Fix) {
        for edit in &mut fix.edits {
            edit.span = self.span(edit.span);
        }
    }
}
