//! What has a value on the way to a point, and how ways come together.

use rustc_hash::FxHashMap;
use shaderlint_semantic::VariableId;
use shaderlint_syntax::ast::Extent;

/// A variable without a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unset {
    /// The variable.
    pub variable: VariableId,
    /// Where its value is missed.
    pub at: Extent,
    /// The components or members that are missing, a bit each.
    pub missing: Parts,
    /// Whether nothing has written to them before; of an output: whether nothing ever does.
    pub always: bool,
    /// Whether a condition stands between the declaration and here, which may well tell whether
    /// there is a value.
    pub guarded: bool,
}

/// What was found in a function.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct Findings {
    /// Variables that are read before they are written to.
    pub reads: Vec<Unset>,
    /// Parameters and outputs that the function leaves without a value.
    pub outputs: Vec<Unset>,
    /// Whether its end may be reached.
    pub reaches_end: bool,
}

/// Parts of a variable, a bit each: the components of a vector, the members of a struct; one bit for
/// what has none, and the last for all members behind it.
pub type Parts = u32;

/// All parts.
pub(super) const ALL: Parts = Parts::MAX;

/// What differs from a point of the trail on one way from there, by variable.
pub(super) type Path = FxHashMap<u32, Parts>;

/// By variable: the components that have a value on every path to here.
pub(super) struct State {
    set: Vec<Parts>,
    /// The variables that changed, and what they were.
    trail: Vec<(u32, Parts)>,
    /// Whether no path leads here.
    pub dead: bool,
}

impl State {
    /// Everything has a value.
    pub fn new(variables: usize) -> State {
        State {
            set: vec![ALL; variables],
            trail: Vec::new(),
            dead: false,
        }
    }

    /// The components of a variable that have a value.
    pub fn get(&self, variable: VariableId) -> Parts {
        self.at(variable.0)
    }

    fn at(&self, variable: u32) -> Parts {
        self.set.get(variable as usize).copied().unwrap_or(ALL)
    }

    /// Sets which components of a variable have a value.
    pub fn put(&mut self, variable: VariableId, value: Parts) {
        self.put_at(variable.0, value);
    }

    fn put_at(&mut self, variable: u32, value: Parts) {
        if let Some(slot) = self.set.get_mut(variable as usize)
            && *slot != value
        {
            self.trail.push((variable, *slot));
            *slot = value;
        }
    }

    /// A point to come back to.
    pub fn mark(&self) -> usize {
        self.trail.len()
    }

    /// Goes back to what was known at a point.
    pub fn undo(&mut self, mark: usize) {
        while self.trail.len() > mark
            && let Some((variable, old)) = self.trail.pop()
        {
            if let Some(slot) = self.set.get_mut(variable as usize) {
                *slot = old;
            }
        }
    }

    /// The path from a point to here, if there is one.
    pub fn path(&self, mark: usize) -> Option<Path> {
        let since = self.trail.get(mark..).unwrap_or(&[]);
        (!self.dead).then(|| since.iter().map(|(v, _)| (*v, self.at(*v))).collect())
    }

    /// What a variable was at a point.
    pub fn before(&self, mark: usize, variable: u32) -> Parts {
        let since = self.trail.get(mark..).unwrap_or(&[]);
        let first = since.iter().find(|(v, _)| *v == variable);
        first.map_or_else(|| self.at(variable), |(_, old)| *old)
    }

    /// Goes back to a point, and takes on the states of the paths that come from there: a variable
    /// has a value if it has one on all of them.
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
        // What lost its value on another path.
        for path in others {
            for (&variable, &value) in path.iter().filter(|(v, _)| !first.contains_key(*v)) {
                self.put_at(variable, self.at(variable) & value);
            }
        }
    }
}
