//! The entry point of a shader: `main`, or the function that its host calls.

use crate::checker::*;
use crate::dialect::Pass;
use crate::host::EntryPoint;

/// An error in the entry point of a shader.
#[derive(Clone, Copy, Debug)]
pub enum EntryError {
    /// A shader without `main`.
    Missing,
    /// A shader without the function that its host calls.
    MissingCalled(EntryPoint),
    /// A shader without `main`, but with `mainImage`; and its first output.
    Unwrapped(Option<Name>),
    /// An entry point with another signature than its host calls.
    Signature(EntryPoint),
    /// A `main` with parameters.
    MainParameters,
    /// A `main` that does not return `void`.
    MainReturns,
}

impl Checker<'_> {
    /// Checks that the entry point is defined.
    pub(in crate::checker) fn check_entry(&mut self) {
        match self.dialect.host().entry {
            Some(entry) if entry.is_called_by_host() => self.check_called_entry(entry),
            Some(entry) if !self.defines(entry.name) && !self.main_was_unreadable() => {
                self.missing_main();
            }
            _ => {}
        }
    }

    /// Whether `main` may be in text with syntax errors.
    fn main_was_unreadable(&self) -> bool {
        self.syntax_errors && self.names.get("main").is_some()
    }

    fn missing_main(&mut self) {
        let image = Pass::Image.host().entry.map(|e| e.name);
        let is_image = |f: &&Function| image == Some(self.text(f.name));
        let found = self.functions.iter().find(is_image);
        let decl = found.and_then(|f| self.tree.function(f.definition?));
        match decl {
            Some(decl) => {
                let output = self.outputs.first().map(|o| o.ident.name);
                self.reject(decl.header, EntryError::Unwrapped(output));
            }
            None => self.reject(Extent::default(), EntryError::Missing),
        }
    }

    /// Checks that the entry point that a host declares and calls is defined with its signature.
    fn check_called_entry(&mut self, entry: EntryPoint) {
        let name = entry.name;
        let is_entry = |f: &&Function| self.text(f.name) == name;
        let entry_point = self.functions.iter().find(is_entry);
        if entry_point.is_none_or(|f| f.definition.is_some()) {
            return;
        }
        let other = self
            .functions
            .iter()
            .filter(is_entry)
            .find_map(|f| self.tree.function(f.definition?));
        if let Some(other) = other {
            return self.wrong_entry(other);
        }
        let unreadable = self.syntax_errors
            && self.names.get(name).is_some_and(|n| {
                self.tokens.tokens.iter().any(|t| {
                    t.kind == TokenKind::Identifier && t.value == n.0 && !self.in_prelude(t.span)
                })
            });
        // A `main` with parameters is reported, and may be meant.
        if unreadable
            || self.has_main_with_parameters()
            || self.unknown_functions.iter().any(|&n| self.text(n) == name)
        {
            return;
        }
        self.reject(Extent::default(), EntryError::MissingCalled(entry));
    }

    fn has_main_with_parameters(&self) -> bool {
        let mains = self.tree.functions.iter();
        let mut mains = mains.filter(|f| self.text(f.ident.name) == "main");
        mains.any(|f| self.has_parameters(f))
    }

    fn has_parameters(&self, decl: &FunctionDecl) -> bool {
        let mut params = self.tree.params(decl.params).iter();
        params.any(|p| self.tree.ty(p.ty).base != TypeBase::Void)
    }

    fn in_prelude(&self, span: Span) -> bool {
        self.sources
            .file_at(span.start)
            .is_some_and(|f| f.role == Role::Prelude)
    }

    fn defines(&self, name: &str) -> bool {
        let functions = self.functions.iter().filter(|f| f.definition.is_some());
        functions.into_iter().any(|f| self.text(f.name) == name)
    }

    /// Whether a function is the entry point of the host.
    pub(in crate::checker) fn is_entry(&self, name: Name) -> bool {
        let entry = self.dialect.host().entry;
        entry.is_some_and(|e| e.name == self.text(name))
    }

    pub(super) fn wrong_entry(&mut self, decl: &FunctionDecl) {
        // An error in the header is the cause.
        let is_reported = self.problems.iter().any(|p| decl.header.contains(p.at));
        if let Some(entry) = self.dialect.host().entry.filter(|_| !is_reported) {
            self.reject(decl.header, EntryError::Signature(entry));
        }
    }

    pub(super) fn check_main(&mut self, decl: &FunctionDecl, returns: Type) {
        if self.text(decl.ident.name) != "main" {
            return;
        }
        let problem = if self.has_parameters(decl) {
            EntryError::MainParameters
        } else if !returns.is_void() && !returns.is_error() {
            EntryError::MainReturns
        } else {
            return;
        };
        self.reject(decl.header, problem);
    }
}
