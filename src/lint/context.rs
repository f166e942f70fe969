//! What a rule gets to check a shader and report findings.

use super::facts::Facts;
use super::option::{OptionType, Setting};
use super::rule::Rule;
use super::settings::Settings;
use shaderlint_diagnostic::{Diagnostic, Fix, Label, Origin, Severity};
use shaderlint_exec::FaultKind;
use shaderlint_flow::PartMask;
use shaderlint_flow::ranges::{Interval, Side};
use shaderlint_ir::OpId;
use shaderlint_semantic::{Program, VariableId};
use shaderlint_syntax::ast::{ExprId, ExprKind, Extent};
use shaderlint_text::Span;

/// A shader, its facts, and the list of findings.
pub struct Context<'a, 'p> {
    /// The checked shader.
    pub program: &'p Program,
    /// Analyses of the whole shader.
    pub facts: &'a Facts<'p>,
    pub(super) settings: &'a Settings,
    pub(super) rule: &'static Rule,
    pub(super) severity: Severity,
    pub(super) diagnostics: &'a mut Vec<Diagnostic>,
}

/// Builder for a finding, which is already in the list.
pub struct Finding<'a> {
    program: &'a Program,
    diagnostic: &'a mut Diagnostic,
}

impl<'p> Context<'_, 'p> {
    /// The value of an option of the rule.
    pub fn option<T: OptionType>(&self, setting: &Setting<T>) -> T {
        self.settings.option(self.rule, setting)
    }

    /// Code with an operator, in parentheses if it needs them as a replacement for an expression.
    pub fn in_place_of(&self, expr: ExprId, code: String) -> String {
        let parent = self.facts.structure().parent(expr);
        let kind = parent.map(|p| self.program.tree.expr(p).kind);
        match kind {
            Some(
                ExprKind::Binary(..)
                | ExprKind::Unary(..)
                | ExprKind::Postfix(..)
                | ExprKind::Member(..)
                | ExprKind::Index(..)
                | ExprKind::Method(..),
            ) => format!("({code})"),
            _ => code,
        }
    }

    /// Whether an expression is written in the text itself, outside any macro call.
    pub fn is_direct(&self, expr: ExprId) -> bool {
        self.program.is_direct(self.program.tree.expr(expr).extent)
    }

    /// A suggestion to write `text` instead of an expression that is not in a macro call.
    pub fn suggest(&self, expr: ExprId, text: impl Into<String>) -> Option<Fix> {
        let span = self.program.expr_span(expr);
        self.is_direct(expr)
            .then(|| Fix::suggested_replacement(span, text))
    }

    /// The name of a variable, with those of its components or its field that a mask contains, if that is not
    /// all of it.
    pub fn name_of_parts(&self, id: VariableId, mask: PartMask) -> String {
        let Some(variable) = self.program.variable(id) else {
            return String::new();
        };
        let name = self.program.name_in_text(variable).to_string();
        if let Some(found) = self.program.struct_of(variable.ty) {
            let only = found.fields.get(mask.trailing_zeros() as usize);
            return match only.filter(|_| mask.count_ones() == 1) {
                Some(field) => format!("{name}.{}", self.program.names.text(field.name)),
                None => name,
            };
        }
        let parts = "xyzw".chars().enumerate();
        let parts = parts.filter(|(i, _)| mask & 1 << i != 0);
        let parts: String = parts.map(|(_, letter)| letter).collect();
        match variable.ty.is_vector() && parts.len() < variable.ty.components() as usize {
            true => format!("{name}.{parts}"),
            false => name,
        }
    }

    /// Reports a finding at a node.
    pub fn report(&mut self, extent: Extent, message: impl Into<String>) -> Finding<'_> {
        let span = self.program.span(extent);
        let macros = self.program.macros_at(extent.first);
        let finding = self.report_span(span, message);
        finding.diagnostic.macros = macros;
        finding
    }

    /// Reports a finding at an expression.
    pub fn report_expr(&mut self, expr: ExprId, message: impl Into<String>) -> Finding<'_> {
        let extent = self.program.tree.expr(expr).extent;
        self.report(extent, message)
    }

    /// Reports a finding at an expression whose range extends too far on one side, with a label where that
    /// end comes from.
    pub fn report_range(
        &mut self,
        expr: ExprId,
        (range, side): (&Interval, Side),
        message: impl Into<String>,
    ) -> Finding<'_> {
        let reason = self.facts.reason(expr, range, side);
        let program = self.program;
        let finding = self.report_expr(expr, message);
        match reason {
            Some((place, words)) if place == program.expr_span(expr) => finding.mark(words),
            Some((place, words)) => finding.label(place, words),
            None => finding,
        }
    }

    /// Reports a finding at the source of an operation.
    pub fn report_op(&mut self, op: OpId, message: impl Into<String>) -> Finding<'_> {
        let origin = self.facts.module().provenance(op);
        let extent = origin.extent(&self.program.tree);
        self.report(extent.unwrap_or_default(), message)
    }

    /// Checks the last finding against a sample run: adds a note with the evidence, and lowers the
    /// severity to info if the fault never occurred at its expression.
    pub fn confirm_by_sampling(&mut self, expr: ExprId, kinds: &[FaultKind]) {
        let op = self.facts.module().op_of(expr);
        self.facts.mark_reported(op);
        let Some(op) = op else { return };
        let verdict = self.facts.verdict(op, kinds);
        let (Some(last), Some(verdict)) = (self.diagnostics.last_mut(), verdict) else {
            return;
        };
        if !verdict.is_confirmed {
            last.severity = last.severity.min(Severity::Info);
        }
        last.notes.push(verdict.words);
    }

    /// Reports a finding about the whole image, at the name of the entry function.
    pub fn report_image(&mut self, message: impl Into<String>) -> Finding<'_> {
        let program = self.program;
        let entry = self.facts.entry().and_then(|f| program.function(f));
        let decl = entry.and_then(|f| program.tree.function(f.definition?));
        let name = decl.and_then(|d| program.token(d.ident.token));
        self.report_span(name.map_or(Span::default(), |t| t.span), message)
    }

    /// Reports a finding at a span.
    #[expect(clippy::indexing_slicing, reason = "the last one was just pushed")]
    pub fn report_span(&mut self, span: Span, message: impl Into<String>) -> Finding<'_> {
        let diagnostic =
            Diagnostic::new(self.rule.name, Origin::Rule, self.severity, span, message);
        self.diagnostics.push(diagnostic);
        let last = self.diagnostics.len() - 1;
        Finding {
            program: self.program,
            diagnostic: &mut self.diagnostics[last],
        }
    }
}

impl Finding<'_> {
    /// Sets the primary label.
    pub fn mark(self, message: impl Into<String>) -> Self {
        self.diagnostic.label = message.into();
        self
    }

    /// Adds a secondary label, if there is a span and it is in the user's text.
    pub fn label(self, span: impl Into<Option<Span>>, message: impl Into<String>) -> Self {
        if let Some(span) = span.into().filter(|span| self.program.is_user(*span)) {
            self.diagnostic.labels.push(Label {
                span,
                message: message.into(),
            });
        }
        self
    }

    /// Adds a note: a rule of the language, or evidence.
    pub fn note(self, note: impl Into<String>) -> Self {
        self.diagnostic.notes.push(note.into());
        self
    }

    /// Adds a help: what to edit.
    pub fn help(self, help: impl Into<String>) -> Self {
        self.diagnostic.help.push(help.into());
        self
    }

    /// Lowers the severity to info.
    pub fn lower(self) -> Self {
        self.diagnostic.severity = self.diagnostic.severity.min(Severity::Info);
        self
    }

    /// Sets the fix; its title is printed as a help.
    pub fn fix(self, fix: impl Into<Option<Fix>>) -> Self {
        self.diagnostic.set_fix(fix.into());
        self
    }
}
