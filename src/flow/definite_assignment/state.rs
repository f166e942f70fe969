//! The assigned components of each variable on the current path, and their join.

use rustc_hash::FxHashMap;
use shaderlint_semantic::VariableId;
use shaderlint_syntax::ast::Extent;
use shaderlint_text::SetAt;

/// A variable that may be read, or left by a function, before it is assigned.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UnassignedVariable {
    /// The variable.
    pub variable: VariableId,
    /// Where its value is needed.
    pub at: Extent,
    /// Bit mask of the unassigned components or members.
    pub missing: PartMask,
    /// Whether nothing was assigned to them before on any path; for an output, anywhere in the
    /// function.
    pub always: bool,
    /// Whether a condition is between the declaration and this point; it may well imply that the
    /// variable is assigned.
    pub guarded: bool,
}

/// The findings in a function.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct AssignmentFindings {
    /// Variables that are read before they are assigned.
    pub reads: Vec<UnassignedVariable>,
    /// Variables that are read after a loop that assigns them on some path only.
    pub loop_reads: Vec<UnassignedVariable>,
    /// `out` parameters and outputs that are unassigned when the function returns.
    pub outputs: Vec<UnassignedVariable>,
    /// Whether the end of the body is reachable.
    pub reaches_end: bool,
}

/// Bit mask of the parts of a variable: the components of a vector or the members of a struct.
/// Other types use one bit; the last bit is shared by all further members.
pub type PartMask = u32;

pub(super) const ALL: PartMask = PartMask::MAX;

/// The variables that differ from a point of the trail, with their assigned parts.
pub(super) type Path = FxHashMap<u32, PartMask>;

/// By variable: the components that are assigned on every path to the current point.
pub(super) struct AssignmentState {
    set: Vec<PartMask>,
    /// Undo log: the changed variables with their previous state.
    trail: Vec<(u32, PartMask)>,
    /// Whether the current point is unreachable.
    pub dead: bool,
}

impl AssignmentState {
    /// A state in which every variable is assigned.
    pub fn new(variables: usize) -> AssignmentState {
        AssignmentState {
            set: vec![ALL; variables],
            trail: Vec::new(),
            dead: false,
        }
    }

    /// The assigned components of a variable.
    pub fn get(&self, variable: VariableId) -> PartMask {
        self.at(variable.0)
    }

    fn at(&self, variable: u32) -> PartMask {
        self.set.get(variable as usize).copied().unwrap_or(ALL)
    }

    /// Sets the assigned components of a variable.
    pub fn put(&mut self, variable: VariableId, value: PartMask) {
        self.put_at(variable.0, value);
    }

    fn put_at(&mut self, variable: u32, value: PartMask) {
        if let Some(slot) = self.set.get_mut(variable as usize)
            && *slot != value
        {
            self.trail.push((variable, *slot));
            *slot = value;
        }
    }

    /// The current point, for [`AssignmentState::undo`].
    pub fn mark(&self) -> usize {
        self.trail.len()
    }

    /// Rolls back to a point.
    pub fn undo(&mut self, mark: usize) {
        while self.trail.len() > mark
            && let Some((variable, old)) = self.trail.pop()
        {
            self.set.set_at(variable as usize, old);
        }
    }

    /// The difference between a point and the current state; `None` if the current point is
    /// unreachable.
    pub fn path(&self, mark: usize) -> Option<Path> {
        let since = self.trail.get(mark..).unwrap_or(&[]);
        (!self.dead).then(|| since.iter().map(|(v, _)| (*v, self.at(*v))).collect())
    }

    /// The state of a variable at a point.
    pub fn before(&self, mark: usize, variable: u32) -> PartMask {
        let since = self.trail.get(mark..).unwrap_or(&[]);
        let first = since.iter().find(|(v, _)| *v == variable);
        first.map_or_else(|| self.at(variable), |(_, old)| *old)
    }

    /// Rolls back to a point and joins the paths from there: a component is assigned if it is on
    /// all of them.
    pub fn join(&mut self, mark: usize, paths: &[Path]) {
        self.undo(mark);
        self.dead = paths.is_empty();
        let Some((first, others)) = paths.split_first() else {
            return;
        };
        for (&variable, &value) in first {
            let start = self.at(variable);
            let other = |p: &Path| p.get(&variable).copied().unwrap_or(start);
            let all = others.iter().fold(value, |all, p| all & other(p));
            self.put_at(variable, all);
        }
        // Variables that became unassigned on another path only.
        for path in others {
            for (&variable, &value) in path.iter().filter(|(v, _)| !first.contains_key(*v)) {
                self.put_at(variable, self.at(variable) & value);
            }
        }
    }
}
