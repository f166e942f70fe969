//! Which statements of a file ran in tests, and which branches were taken.

use rustc_hash::FxHashMap;
use shaderlint_engine::Analysis;
use shaderlint_exec::{Bytecode, Observations, statements};
use shaderlint_ir::{Module, Provenance, Step};
use shaderlint_semantic::{FunctionRef, Program};
use shaderlint_syntax::ast::Extent;
use shaderlint_text::Role;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// Line and column.
type LineColumn = (u32, u32);

/// What ran in a test, by place in the code of the shader.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct RunCounts {
    statements: FxHashMap<Extent, u64>,
    branches: FxHashMap<Provenance, [u64; 2]>,
}

/// What ran in all tests, by file.
#[derive(Clone, Default, Debug)]
pub struct Coverage {
    /// By path.
    pub files: BTreeMap<String, FileCoverage>,
}

/// What ran of a file.
#[derive(Clone, Debug)]
pub struct FileCoverage {
    /// The text.
    pub text: Arc<str>,
    /// How often each statement ran.
    pub statements: BTreeMap<LineColumn, u64>,
    /// How often each condition was true and false.
    pub branches: BTreeMap<LineColumn, [u64; 2]>,
    /// The functions.
    pub functions: BTreeMap<LineColumn, CoveredFunction>,
}

/// A function of a file.
#[derive(Clone, Debug)]
pub struct CoveredFunction {
    /// Its name.
    pub name: String,
    /// Its first statement.
    first: LineColumn,
}

impl RunCounts {
    /// Adds the counts of a run with [`CompileOptions::steps`](shaderlint_exec::CompileOptions::steps).
    pub(super) fn add(&mut self, code: &Bytecode, seen: &Observations) {
        for (extent, ran) in code.statements().iter().zip(&seen.statements) {
            *self.statements.entry(*extent).or_default() += ran.times;
        }
        for branch in &seen.branches {
            let [taken, skipped] = self.branches.entry(branch.at).or_default();
            *taken += branch.taken;
            *skipped += branch.skipped;
        }
    }
}

impl FileCoverage {
    /// How often each line ran: as often as the statement that ran most.
    pub fn lines(&self) -> BTreeMap<u32, u64> {
        let mut lines = BTreeMap::new();
        for (&(line, _), &count) in &self.statements {
            let most: &mut u64 = lines.entry(line).or_default();
            *most = count.max(*most);
        }
        lines
    }

    /// How often a function was called.
    pub fn calls(&self, function: &CoveredFunction) -> u64 {
        self.statements.get(&function.first).copied().unwrap_or(0)
    }
}

impl Coverage {
    /// Adds the files of a shader, of which nothing may have run. Tests and the files that only
    /// contain tests are left out.
    pub fn add_files(&mut self, analysis: &Analysis) {
        let program = &analysis.program;
        let module = analysis.module();
        let functions = (0..).map(FunctionRef).zip(&program.functions);
        for (id, function) in functions {
            if function.is_test(&program.names) || function.is_bench(&program.names) {
                continue;
            }
            let definition = function.definition.and_then(|id| program.tree.function(id));
            let Some(definition) = definition else {
                continue;
            };
            let Some((path, start)) = place(program, definition.extent) else {
                continue;
            };
            let own = statements(&program.tree, module, id);
            let places = own.iter().filter_map(|extent| place(program, *extent));
            let places: Vec<LineColumn> = places
                .filter(|(p, _)| *p == path)
                .map(|(_, at)| at)
                .collect();
            let branches = branches(program, module, id);
            let file = self.file(program, &path, definition.extent);
            if let Some(first) = places.first() {
                let name = program.names.text(function.name).to_string();
                let first = *first;
                let covered = CoveredFunction { name, first };
                file.functions.entry(start).or_insert(covered);
            }
            for place in places {
                file.statements.entry(place).or_default();
            }
            for (_, place) in branches.into_iter().filter(|(p, _)| *p == path) {
                file.branches.entry(place).or_default();
            }
        }
    }

    /// Adds what ran in a test of a shader.
    pub fn add(&mut self, analysis: &Analysis, counts: &RunCounts) {
        let program = &analysis.program;
        for (extent, times) in &counts.statements {
            let found = place(program, *extent);
            let slot =
                found.and_then(|(path, at)| self.files.get_mut(&path)?.statements.get_mut(&at));
            slot.into_iter().for_each(|slot| *slot += times);
        }
        for (origin, [taken, skipped]) in &counts.branches {
            let extent = origin.extent(&program.tree);
            let found = extent.and_then(|extent| place(program, extent));
            let slot =
                found.and_then(|(path, at)| self.files.get_mut(&path)?.branches.get_mut(&at));
            if let Some(slot) = slot {
                slot[0] += taken;
                slot[1] += skipped;
            }
        }
    }

    /// Adds what ran in other tests.
    pub fn join(&mut self, other: &Coverage) {
        for (path, more) in &other.files {
            let Some(file) = self.files.get_mut(path) else {
                self.files.insert(path.clone(), more.clone());
                continue;
            };
            for (place, count) in &more.statements {
                *file.statements.entry(*place).or_default() += count;
            }
            for (place, [taken, skipped]) in &more.branches {
                let own = file.branches.entry(*place).or_default();
                own[0] += taken;
                own[1] += skipped;
            }
            let functions = more.functions.iter();
            file.functions
                .extend(functions.map(|(place, function)| (*place, function.clone())));
        }
    }

    fn file(&mut self, program: &Program, path: &str, extent: Extent) -> &mut FileCoverage {
        let text = || {
            let file = program.sources.file_at(program.span(extent).start);
            file.map_or_else(Arc::default, |file| file.text.clone())
        };
        let known = self.files.entry(path.to_string());
        known.or_insert_with(|| FileCoverage {
            text: text(),
            statements: BTreeMap::new(),
            branches: BTreeMap::new(),
            functions: BTreeMap::new(),
        })
    }
}

/// The path and position of code under test.
fn place(program: &Program, extent: Extent) -> Option<(String, LineColumn)> {
    let start = program.span(extent).start;
    let file = program.sources.file_at(start)?;
    let stem = Path::new(&file.path).file_stem()?.to_str()?;
    if file.role != Role::User || stem.ends_with(".test") {
        return None;
    }
    let at = file.position(start);
    Some((file.path.to_string(), (at.line, at.column)))
}

/// The branches of a function.
fn branches(
    program: &Program,
    module: &Module,
    function: FunctionRef,
) -> Vec<(String, LineColumn)> {
    let body = module.function(function).and_then(|f| f.body);
    let steps = module.steps_in(body.map_or(&[][..], |body| module.steps(body)));
    let origins = steps.filter_map(|step| match step {
        Step::If { origin, .. } => origin.extent(&program.tree),
        _ => None,
    });
    origins
        .filter_map(|extent| place(program, extent))
        .collect()
}
