//! Scopes and name lookup (GLSL ES 3.00 section 4.2).

use super::program::VariableId;
use shaderlint_syntax::Name;
use std::ops::Deref;

/// What a name refers to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Binding {
    Variable(VariableId),
    /// One or more user-defined functions.
    Function,
    /// A struct, by index.
    Struct(u32),
    /// An interface block, by index; its name cannot be used or redeclared.
    Block(u32),
    /// A declaration with a reported error; accepted everywhere.
    Error,
}

#[derive(Clone, Copy)]
struct ScopeEntry {
    binding: Binding,
    depth: u32,
}

/// Scope operations in source order.
#[derive(Clone, Copy, Debug)]
enum ScopeStep {
    Push,
    Pop,
    Declare(Name, Binding),
    DeclareGlobal(Name, Binding),
}

/// Log of all scope operations of a shader, for later lookups at any position.
#[derive(Default, Debug)]
pub struct ScopeLog(Vec<ScopeStep>);

/// A position in a [`ScopeLog`].
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct ScopeMark(u32);

/// Replays a [`ScopeLog`] to look up names at earlier positions.
pub struct PastScopes<'a> {
    log: &'a ScopeLog,
    at: ScopeMark,
    scopes: NameBindings,
}

impl<'a> PastScopes<'a> {
    /// Starts before any declaration.
    pub fn new(log: &'a ScopeLog) -> PastScopes<'a> {
        PastScopes {
            log,
            at: ScopeMark::default(),
            scopes: NameBindings::default(),
        }
    }

    /// Moves to a position. Fastest in source order.
    pub fn go_to(&mut self, mark: ScopeMark) {
        if mark.0 < self.at.0 {
            *self = PastScopes::new(self.log);
        }
        let steps = self.log.0.get(self.at.0 as usize..mark.0 as usize);
        for step in steps.unwrap_or(&[]) {
            self.scopes.apply(*step);
        }
        self.at = mark;
    }

    /// The bindings at the current position.
    pub fn bindings(&self) -> &NameBindings {
        &self.scopes
    }
}

/// The current scopes and their log.
#[derive(Default)]
pub struct Scopes {
    bindings: NameBindings,
    log: ScopeLog,
}

impl Scopes {
    fn step(&mut self, step: ScopeStep) {
        self.log.0.push(step);
        self.bindings.apply(step);
    }

    /// Opens a scope.
    pub fn push(&mut self) {
        self.step(ScopeStep::Push);
    }

    /// Closes the innermost scope.
    pub fn pop(&mut self) {
        self.step(ScopeStep::Pop);
    }

    /// Declares a name in the innermost scope, shadowing outer declarations.
    pub fn declare(&mut self, name: Name, binding: Binding) {
        self.step(ScopeStep::Declare(name, binding));
    }

    /// Declares a name at global scope while inner scopes may be open.
    pub fn declare_global(&mut self, name: Name, binding: Binding) {
        self.step(ScopeStep::DeclareGlobal(name, binding));
    }

    /// The current position in the log.
    pub fn mark(&self) -> ScopeMark {
        ScopeMark(self.log.0.len() as u32)
    }

    /// The log of all operations.
    pub fn into_log(self) -> ScopeLog {
        self.log
    }
}

impl Deref for Scopes {
    type Target = NameBindings;

    fn deref(&self) -> &NameBindings {
        &self.bindings
    }
}

/// The current bindings of all names and the open scopes.
#[derive(Default)]
pub struct NameBindings {
    entries: Vec<Option<ScopeEntry>>,
    /// Shadowed bindings, restored when their scope ends.
    hidden: Vec<(Name, Option<ScopeEntry>)>,
    /// Length of `hidden` at the start of each open scope.
    marks: Vec<usize>,
}

impl NameBindings {
    fn apply(&mut self, step: ScopeStep) {
        match step {
            ScopeStep::Push => self.push(),
            ScopeStep::Pop => self.pop(),
            ScopeStep::Declare(name, binding) => self.declare(name, binding),
            ScopeStep::DeclareGlobal(name, binding) => self.declare_global(name, binding),
        }
    }

    fn push(&mut self) {
        self.marks.push(self.hidden.len());
    }

    fn pop(&mut self) {
        let mark = self.marks.pop().unwrap_or(0);
        while self.hidden.len() > mark {
            if let Some((name, before)) = self.hidden.pop()
                && let Some(entry) = self.entries.get_mut(name.0 as usize)
            {
                *entry = before;
            }
        }
    }

    /// Number of open scopes; 0 at global scope.
    pub fn depth(&self) -> u32 {
        self.marks.len() as u32
    }

    /// The binding of a name at this point.
    #[inline]
    pub fn get(&self, name: Name) -> Option<Binding> {
        self.entries
            .get(name.0 as usize)
            .copied()
            .flatten()
            .map(|e| e.binding)
    }

    /// The binding of a name if it was declared in the innermost scope.
    pub fn get_here(&self, name: Name) -> Option<Binding> {
        let entry = self.entries.get(name.0 as usize).copied().flatten()?;
        (entry.depth == self.depth()).then_some(entry.binding)
    }

    /// The binding of a name at global scope, if it is not shadowed.
    pub fn get_global(&self, name: Name) -> Option<Binding> {
        let entry = self.entries.get(name.0 as usize).copied().flatten()?;
        if entry.depth == 0 {
            return Some(entry.binding);
        }
        let below = self.hidden.iter().find(|(n, _)| *n == name)?;
        below.1.filter(|e| e.depth == 0).map(|e| e.binding)
    }

    /// Declares a name in the innermost scope, shadowing outer declarations.
    fn declare(&mut self, name: Name, binding: Binding) {
        let index = name.0 as usize;
        if self.entries.len() <= index {
            self.entries.resize(index + 64, None);
        }
        let entry = ScopeEntry {
            binding,
            depth: self.depth(),
        };
        if let Some(slot) = self.entries.get_mut(index) {
            let before = slot.replace(entry);
            if !self.marks.is_empty() && before.is_none_or(|b| b.depth != entry.depth) {
                self.hidden.push((name, before));
            }
        }
    }

    /// Declares a name at global scope while inner scopes may be open.
    fn declare_global(&mut self, name: Name, binding: Binding) {
        if self.marks.is_empty() {
            return self.declare(name, binding);
        }
        let global = ScopeEntry { binding, depth: 0 };
        if let Some((_, before)) = self.hidden.iter_mut().find(|(n, _)| *n == name) {
            *before = Some(global);
            return;
        }
        let index = name.0 as usize;
        if self.entries.len() <= index {
            self.entries.resize(index + 64, None);
        }
        if let Some(slot) = self.entries.get_mut(index)
            && slot.is_none_or(|e| e.depth == 0)
        {
            *slot = Some(global);
        }
    }

    /// All names with a binding at this point.
    pub fn visible(&self) -> impl Iterator<Item = (Name, Binding)> {
        self.entries
            .iter()
            .enumerate()
            .filter_map(|(i, e)| e.map(|e| (Name(i as u32), e.binding)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_scopes_shadow_outer_ones_until_they_end() {
        let mut scopes = Scopes::default();
        let (a, b) = (Name(3), Name(4));
        scopes.declare(a, Binding::Struct(1));
        scopes.push();
        assert_eq!(scopes.get_here(a), None);
        scopes.declare(a, Binding::Struct(2));
        scopes.declare(b, Binding::Function);
        scopes.declare(a, Binding::Struct(3));
        assert_eq!(scopes.get(a), Some(Binding::Struct(3)));
        assert_eq!(scopes.get_global(a), Some(Binding::Struct(1)));
        let inside = scopes.mark();
        scopes.pop();
        assert_eq!(scopes.get(a), Some(Binding::Struct(1)));
        assert_eq!(scopes.get(b), None);
        let after = scopes.mark();
        let log = scopes.into_log();
        let mut past = PastScopes::new(&log);
        past.go_to(after);
        assert_eq!(past.bindings().get(b), None);
        past.go_to(inside);
        assert_eq!(past.bindings().get(b), Some(Binding::Function));
        assert_eq!(past.bindings().depth(), 1);
    }
}
