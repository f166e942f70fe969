//! What the selected name refers to.

use super::place::RefactorPlace;
use crate::index::{Index, NameUse, Occurrence};
use crate::symbol::Symbol;
use shaderlint_semantic::VariableId;
use shaderlint_syntax::ast::*;

impl RefactorPlace<'_> {
    /// The name at the selection, which is in it or touches it.
    pub fn name(&self) -> Option<Occurrence> {
        let spot = self.document.spot(self.document_offset()?)?;
        let found = spot.name()?;
        found.span.contains(self.selection).then_some(found)
    }

    fn document_offset(&self) -> Option<u32> {
        let span = self.document.report.in_input(self.selection)?;
        Some(span.start)
    }

    /// The variable whose name is selected.
    pub fn variable(&self) -> Option<VariableId> {
        match self.name()?.symbol {
            Symbol::Variable(id) => Some(id),
            _ => None,
        }
    }

    /// The declaration of a variable, if it declares nothing else and has an initial value.
    pub fn only_declarator(&self, variable: VariableId) -> Option<(&Declaration, ExprId)> {
        let tree = &self.program.tree;
        let declarator = self.program.declarator_of(variable)?;
        let is_its = |d: &&Declaration| match d.kind {
            DeclKind::Variables { declarators, .. } => {
                matches!(tree.declarators(declarators), [one] if one.ident == declarator.ident)
            }
            _ => false,
        };
        let decl = tree.decls.iter().find(is_its)?;
        let is_exact = self.program.is_direct(Extent::token(decl.extent.first))
            && self.program.is_direct(Extent::token(decl.extent.last));
        Some((decl, declarator.init.filter(|_| is_exact)?))
    }

    /// All expressions that mention a variable; `None` if a macro, or code that is not compiled,
    /// mentions it.
    pub fn mentions(&self, variable: VariableId) -> Option<Vec<ExprId>> {
        let all = self.facts.mentions().all(variable);
        let extent = |e: &ExprId| self.program.tree.expr(*e).extent;
        let is_direct = all.iter().all(|e| self.program.is_direct(extent(e)));
        let spot = self.document.spot(self.document_offset()?)?;
        let index: &Index = spot.index();
        let mut named = index.named(Symbol::Variable(variable));
        let is_seen = named.all(|o| o.access != NameUse::Unseen);
        (is_direct && is_seen).then(|| all.to_vec())
    }
}
