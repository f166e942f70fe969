//! What names mean where (GLSL ES 3.00 section 4.2).

use super::program::VariableId;
use shaderlint_syntax::Name;
use std::ops::Deref;

/// What a name stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Binding {
    /// A variable.
    Variable(VariableId),
    /// One or more functions of the shader.
    Function,
    /// A struct, by its number.
    Struct(u32),
    /// An interface block, by its number; its name stands for nothing, but is taken.
    Block(u32),
    /// Something whose declaration was reported; fits everywhere.
    Error,
}

#[derive(Clone, Copy)]
struct Entry {
    binding: Binding,
    depth: u32,
}

/// What happens to scopes, in the order of the text.
#[derive(Clone, Copy, Debug)]
enum ScopeStep {
    Push,
    Pop,
    Declare(Name, Binding),
    DeclareGlobal(Name, Binding),
}

/// All that happened to the scopes of a shader, so that what a name stood for at some place can be
/// asked later.
#[derive(Default, Debug)]
pub struct ScopeLog(Vec<ScopeStep>);

/// How much had happened to the scopes at some place.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct ScopeMark(u32);

/// Scopes as they were at one place after the other.
pub struct PastScopes<'a> {
    log: &'a ScopeLog,
    at: ScopeMark,
    scopes: NameBindings,
}

impl<'a> PastScopes<'a> {
    /// The scopes before anything was declared.
    pub fn new(log: &'a ScopeLog) -> PastScopes<'a> {
        PastScopes {
            log,
            at: ScopeMark::default(),
            scopes: NameBindings::default(),
        }
    }

    /// Goes to a place. It is quickest in the order of the text.
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

    /// What names stand for at that place.
    pub fn bindings(&self) -> &NameBindings {
        &self.scopes
    }
}

/// The scopes of the place at hand, with all that happened to them.
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

    /// Declares a name in the innermost scope, hiding what it stood for outside.
    pub fn declare(&mut self, name: Name, binding: Binding) {
        self.step(ScopeStep::Declare(name, binding));
    }

    /// Declares a name at global scope, while inner scopes may be open.
    pub fn declare_global(&mut self, name: Name, binding: Binding) {
        self.step(ScopeStep::DeclareGlobal(name, binding));
    }

    /// How much has happened so far.
    pub fn mark(&self) -> ScopeMark {
        ScopeMark(self.log.0.len() as u32)
    }

    /// All that happened.
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

/// The bindings of all names, with the scopes that are open.
#[derive(Default)]
pub struct NameBindings {
    /// By name.
    entries: Vec<Option<Entry>>,
    /// What was hidden, to be put back when its scope ends.
    hidden: Vec<(Name, Option<Entry>)>,
    /// Length of `hidden` when each open scope began.
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

    /// Opens a scope.
    fn push(&mut self) {
        self.marks.push(self.hidden.len());
    }

    /// Closes the innermost scope.
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

    /// What a name stands for here.
    #[inline]
    pub fn get(&self, name: Name) -> Option<Binding> {
        self.entries
            .get(name.0 as usize)
            .copied()
            .flatten()
            .map(|e| e.binding)
    }

    /// What a name stands for if it was declared in the innermost scope itself.
    pub fn get_here(&self, name: Name) -> Option<Binding> {
        let entry = self.entries.get(name.0 as usize).copied().flatten()?;
        (entry.depth == self.depth()).then_some(entry.binding)
    }

    /// What a name stands for at global scope, if nothing hides it.
    pub fn get_global(&self, name: Name) -> Option<Binding> {
        let entry = self.entries.get(name.0 as usize).copied().flatten()?;
        if entry.depth == 0 {
            return Some(entry.binding);
        }
        let below = self.hidden.iter().find(|(n, _)| *n == name)?;
        below.1.filter(|e| e.depth == 0).map(|e| e.binding)
    }

    /// Declares a name in the innermost scope, hiding what it stood for outside.
    fn declare(&mut self, name: Name, binding: Binding) {
        let index = name.0 as usize;
        if self.entries.len() <= index {
            self.entries.resize(index + 64, None);
        }
        let entry = Entry {
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

    /// Declares a name at global scope, while inner scopes may be open.
    fn declare_global(&mut self, name: Name, binding: Binding) {
        if self.marks.is_empty() {
            return self.declare(name, binding);
        }
        let global = Entry { binding, depth: 0 };
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

    /// Every name that stands for something here, with what it stands for.
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
    fn inner_scopes_hide_outer_ones_until_they_end() {
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
