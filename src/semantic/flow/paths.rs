//! What happens on every path through a function: which variables have a value when they are read
//! and when the function is left, and whether its end is reached.
//!
//! What a loop may write counts as written behind it: whether it turns at all, and whether it finds
//! what it looks for, is seldom written in the text.

use super::{Structure, each_expr, each_operand};
use crate::semantic::flow::{root, swizzled};
use crate::semantic::{Direction, FunctionRef, Program, Resolution, Stage, Storage, VariableId};
use crate::syntax::ast::*;
use rustc_hash::FxHashMap;

/// How deep statements may nest; of a function with deeper ones nothing is said.
const MAX_DEPTH: u32 = 200;
/// All components, or the whole of what has none.
const ALL: u8 = 0xff;

/// A variable without a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unset {
    /// The variable.
    pub variable: VariableId,
    /// Where its value is missed.
    pub at: Extent,
    /// The components that are missing, a bit each.
    pub missing: u8,
    /// Whether nothing has written to them before.
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

/// What was found, by function.
#[derive(Default, Debug)]
pub struct Paths {
    by_function: FxHashMap<FunctionRef, Findings>,
}

impl Paths {
    /// Follows the paths through all functions of a shader.
    pub fn of(program: &Program, structure: &Structure) -> Paths {
        let mut paths = Paths::default();
        let mut walk = Walk {
            program,
            structure,
            set: vec![ALL; program.variables.len()],
            ever: vec![0; program.variables.len()],
            trail: Vec::new(),
            jumps: Vec::new(),
            outputs: Vec::new(),
            writes: Vec::new(),
            exit: 0,
            dead: false,
            too_deep: false,
            findings: Findings::default(),
        };
        let globals = global_outputs(program, structure);
        for (i, function) in program.functions.iter().enumerate() {
            let decl = function.definition.and_then(|d| program.tree.function(d));
            let Some((decl, body)) = decl.and_then(|d| Some((d, d.body?))) else {
                continue;
            };
            let id = FunctionRef(i as u32);
            let is_main = program.names.text(function.name) == "main";
            let globals = if is_main { globals.as_slice() } else { &[] };
            if let Some(findings) = walk.function(decl, body, globals) {
                paths.by_function.insert(id, findings);
            }
        }
        paths
    }

    /// What was found in a function.
    pub fn get(&self, function: FunctionRef) -> Option<&Findings> {
        self.by_function.get(&function)
    }
}

/// The outputs of a fragment shader that `main` alone writes to.
fn global_outputs(program: &Program, structure: &Structure) -> Vec<VariableId> {
    if program.stage != Stage::Fragment {
        return Vec::new();
    }
    let mut found: Vec<VariableId> = Vec::new();
    for (i, variable) in program.variables.iter().enumerate() {
        let is_output = variable.storage == Storage::Output;
        if is_output && (variable.token.is_some() || variable.written) {
            found.push(VariableId(i as u32));
        }
    }
    if found.is_empty() {
        return found;
    }
    let main = |f: FunctionRef| {
        let function = program.function(f);
        function.is_some_and(|f| program.names.text(f.name) == "main")
    };
    for (i, expr) in program.tree.exprs.iter().enumerate() {
        if matches!(expr.kind, ExprKind::Name(_)) {
            let id = ExprId(i as u32);
            let variable = program.variable_of(id);
            let is_elsewhere = structure.function_of_expr(id).is_some_and(|f| !main(f));
            found.retain(|v| Some(*v) != variable || !is_elsewhere);
        }
    }
    found
}

/// The states with which a loop or `switch` is left by `break`.
struct Jump {
    /// The trail when it began.
    mark: usize,
    /// The variables that differ from the beginning, on all paths so far; `None` without a path.
    exits: Option<FxHashMap<u32, u8>>,
}

struct Walk<'x> {
    program: &'x Program,
    structure: &'x Structure,
    /// By variable: the components that have a value on every path to here.
    set: Vec<u8>,
    /// By variable: the components that were written to anywhere so far.
    ever: Vec<u8>,
    /// The variables that changed, and what they were.
    trail: Vec<(u32, u8)>,
    jumps: Vec<Jump>,
    /// Variables that must have a value when the function is left.
    outputs: Vec<VariableId>,
    /// All writes in the function so far.
    writes: Vec<(VariableId, u8)>,
    /// The last condition behind which the function, a loop or a `switch` may have been left.
    exit: TokenId,
    /// Whether no path leads here.
    dead: bool,
    too_deep: bool,
    findings: Findings,
}

impl Walk<'_> {
    fn function(
        &mut self,
        decl: &FunctionDecl,
        body: StmtId,
        globals: &[VariableId],
    ) -> Option<Findings> {
        self.trail.clear();
        self.jumps.clear();
        self.writes.clear();
        self.exit = 0;
        self.dead = false;
        self.too_deep = false;
        self.outputs = globals.to_vec();
        let from = decl.params.start as usize;
        let params = self
            .program
            .declared_params
            .get(from..from + decl.params.len as usize);
        for variable in params.unwrap_or(&[]).iter().flatten() {
            let storage = self.program.variable(*variable).map(|v| v.storage);
            if storage == Some(Storage::Param(Direction::Out)) {
                self.outputs.push(*variable);
            }
        }
        for variable in self.outputs.clone() {
            self.assign(variable.0, 0);
        }
        self.stmt(body, 0);
        let last = self.program.tree.stmt(body).extent.last;
        self.findings.reaches_end = !self.dead;
        self.leave(Extent::token(last));
        self.undo(0);
        let findings = std::mem::take(&mut self.findings);
        (!self.too_deep).then_some(findings)
    }

    fn value(&self, variable: u32) -> u8 {
        self.set.get(variable as usize).copied().unwrap_or(ALL)
    }

    fn assign(&mut self, variable: u32, value: u8) {
        if let Some(slot) = self.set.get_mut(variable as usize)
            && *slot != value
        {
            self.trail.push((variable, *slot));
            *slot = value;
        }
    }

    /// Goes back to what was known at a point of the trail.
    fn undo(&mut self, mark: usize) {
        while self.trail.len() > mark
            && let Some((variable, old)) = self.trail.pop()
        {
            if let Some(slot) = self.set.get_mut(variable as usize) {
                *slot = old;
            }
        }
    }

    /// What changed since a point of the trail.
    fn changes(&self, mark: usize) -> FxHashMap<u32, u8> {
        let since = self.trail.get(mark..).unwrap_or(&[]);
        since.iter().map(|(v, _)| (*v, self.value(*v))).collect()
    }

    /// Goes back to a point of the trail, and takes on the states of the paths that come from
    /// there: a variable has a value if it has one on all of them.
    fn join(&mut self, mark: usize, paths: Vec<FxHashMap<u32, u8>>) {
        self.undo(mark);
        self.dead = paths.is_empty();
        let Some((first, others)) = paths.split_first() else {
            return;
        };
        for (&variable, &value) in first {
            let start = self.value(variable);
            let other = |p: &FxHashMap<u32, u8>| p.get(&variable).copied().unwrap_or(start);
            let all = others.iter().fold(value, |all, p| all & other(p));
            self.assign(variable, all);
        }
        // What lost its value on another path.
        for path in others {
            for (&variable, &value) in path.iter().filter(|(v, _)| !first.contains_key(*v)) {
                let all = self.value(variable) & value;
                self.assign(variable, all);
            }
        }
    }

    /// The path that ends here, if one does.
    fn path(&self, mark: usize) -> Option<FxHashMap<u32, u8>> {
        (!self.dead).then(|| self.changes(mark))
    }

    fn stmt(&mut self, id: StmtId, depth: u32) {
        if depth > MAX_DEPTH {
            self.too_deep = true;
        }
        if self.too_deep {
            return;
        }
        let tree = &self.program.tree;
        let stmt = tree.stmt(id);
        match stmt.kind {
            StmtKind::Block(body) => {
                for &inner in tree.block(body) {
                    self.stmt(inner, depth + 1);
                }
            }
            StmtKind::If {
                condition,
                then,
                otherwise,
            } => {
                self.expr(condition);
                let known = self.program.scalar(condition).map(|v| v.as_bool());
                let mark = self.trail.len();
                let was_dead = self.dead;
                self.stmt(then, depth + 1);
                let mut paths = Vec::new();
                paths.extend(self.path(mark).filter(|_| known != Some(false)));
                self.undo(mark);
                self.dead = was_dead;
                if let Some(otherwise) = otherwise {
                    self.stmt(otherwise, depth + 1);
                }
                paths.extend(self.path(mark).filter(|_| known != Some(true)));
                if paths.len() == 1 && !was_dead {
                    self.exit = stmt.extent.first;
                }
                self.join(mark, paths);
            }
            StmtKind::For {
                init,
                condition,
                step,
                body,
            } => {
                self.stmt(init, depth + 1);
                self.turn(condition, body, step, depth);
            }
            StmtKind::While { condition, body } => self.turn(Some(condition), body, None, depth),
            StmtKind::Do { body, condition } => {
                let (mark, before) = (self.begin(), self.writes.len());
                self.stmt(body, depth + 1);
                self.expr(condition);
                let is_endless = self.is_true(condition);
                let path = self.path(mark).filter(|_| !is_endless);
                self.end(mark, path);
                self.keep(before);
            }
            StmtKind::Switch { selector, body } => self.switch(selector, body, depth),
            StmtKind::Break => {
                let mark = self.jumps.last().map_or(0, |j| j.mark);
                self.jump(mark);
            }
            StmtKind::Continue | StmtKind::Discard => self.dead = true,
            StmtKind::Return(value) => {
                value.into_iter().for_each(|e| self.expr(e));
                self.leave(stmt.extent);
                self.dead = true;
            }
            StmtKind::Decl(decl) => self.declare(decl, stmt),
            _ => each_expr(tree, stmt, |e| self.expr(e)),
        }
    }

    fn declare(&mut self, decl: DeclId, stmt: &Stmt) {
        let tree = &self.program.tree;
        each_expr(tree, stmt, |e| self.expr(e));
        let Some(DeclKind::Variables { declarators, .. }) = tree.decl(decl).map(|d| d.kind) else {
            return;
        };
        let from = declarators.start as usize;
        let variables = self
            .program
            .declared
            .get(from..from + declarators.len as usize);
        let variables = variables.unwrap_or(&[]);
        for (declarator, variable) in tree.declarators(declarators).iter().zip(variables) {
            if let (None, Some(variable)) = (declarator.init, variable) {
                self.assign(variable.0, 0);
            }
        }
    }

    fn is_true(&self, condition: ExprId) -> bool {
        self.program.scalar(condition).is_some_and(|v| v.as_bool())
    }

    fn begin(&mut self) -> usize {
        let mark = self.trail.len();
        self.jumps.push(Jump { mark, exits: None });
        mark
    }

    /// What a loop wrote on some path stays written behind it.
    fn keep(&mut self, before: usize) {
        for i in before..self.writes.len() {
            if let Some(&(variable, mask)) = self.writes.get(i) {
                let value = self.value(variable.0) | mask;
                self.assign(variable.0, value);
            }
        }
    }

    /// Ends a loop or `switch`, which is left by `break`, or on one more path.
    fn end(&mut self, mark: usize, path: Option<FxHashMap<u32, u8>>) {
        let jump = self.jumps.pop();
        let mut paths: Vec<_> = path.into_iter().collect();
        paths.extend(jump.and_then(|j| j.exits));
        self.join(mark, paths);
    }

    /// A `break`.
    fn jump(&mut self, mark: usize) {
        if self.dead {
            return;
        }
        self.dead = true;
        let changes = self.changes(mark);
        // What it was when the loop began is its oldest entry in the trail.
        let since = self.trail.get(mark..).unwrap_or(&[]);
        let start: FxHashMap<u32, u8> = since.iter().rev().copied().collect();
        let set = &self.set;
        let at_start = |v: u32| {
            let now = set.get(v as usize).copied().unwrap_or(ALL);
            start.get(&v).copied().unwrap_or(now)
        };
        let Some(jump) = self.jumps.last_mut() else {
            return;
        };
        let Some(exits) = &mut jump.exits else {
            jump.exits = Some(changes);
            return;
        };
        for (&variable, value) in exits.iter_mut() {
            *value &= changes
                .get(&variable)
                .copied()
                .unwrap_or_else(|| at_start(variable));
        }
        for (&variable, &value) in &changes {
            exits
                .entry(variable)
                .or_insert_with(|| at_start(variable) & value);
        }
    }

    fn turn(&mut self, condition: Option<StmtId>, body: StmtId, step: Option<ExprId>, depth: u32) {
        let mut is_endless = condition.is_none();
        if let Some(condition) = condition {
            self.stmt(condition, depth + 1);
            if let StmtKind::Expr(e) = self.program.tree.stmt(condition).kind {
                is_endless = self.is_true(e);
            }
        }
        let (mark, before) = (self.begin(), self.writes.len());
        let was_dead = self.dead;
        self.stmt(body, depth + 1);
        step.into_iter().for_each(|e| self.expr(e));
        let path = match self.path(mark) {
            // No turn comes to its end, but the loop may not turn at all.
            None if !was_dead => Some(FxHashMap::default()),
            path => path,
        };
        self.end(mark, path.filter(|_| !is_endless));
        self.keep(before);
    }

    fn switch(&mut self, selector: ExprId, body: List, depth: u32) {
        self.expr(selector);
        let mark = self.begin();
        let was_dead = self.dead;
        let mut has_default = false;
        for &inner in self.program.tree.block(body) {
            let kind = self.program.tree.stmt(inner).kind;
            if matches!(kind, StmtKind::Case(_) | StmtKind::Default) {
                // A label is reached from the top too.
                has_default |= kind == StmtKind::Default;
                self.undo(mark);
                self.dead = was_dead;
            }
            self.stmt(inner, depth + 1);
        }
        let path = match self.path(mark) {
            _ if !has_default && !was_dead => Some(FxHashMap::default()),
            path => path,
        };
        self.end(mark, path);
    }

    /// The function is left: what it must give has a value, or not.
    fn leave(&mut self, at: Extent) {
        if self.dead {
            return;
        }
        for variable in self.outputs.clone() {
            let needed = self.needed(variable);
            let missing = needed & !self.value(variable.0);
            let is_told = self.findings.outputs.iter().any(|u| u.variable == variable);
            if missing != 0 && !is_told {
                let ever = self.ever.get(variable.0 as usize).copied().unwrap_or(0);
                self.findings.outputs.push(Unset {
                    variable,
                    at,
                    missing,
                    always: ever & missing == 0,
                    guarded: false,
                });
            }
        }
    }

    /// The components of a variable, or one bit for anything that has none.
    fn needed(&self, variable: VariableId) -> u8 {
        match self.program.variable(variable).map(|v| v.ty) {
            Some(ty) if ty.is_vector() => (1 << ty.components()) - 1,
            _ => 1,
        }
    }

    /// Looks at an expression in the order of evaluation, which is that of the numbers.
    fn expr(&mut self, root: ExprId) {
        if self.dead {
            return;
        }
        let tree = &self.program.tree;
        let mut first = root;
        loop {
            let mut inner = None;
            each_operand(tree, tree.expr(first), |e| inner = inner.or(Some(e)));
            match inner {
                Some(e) => first = e,
                None => break,
            }
        }
        for i in first.0..=root.0 {
            let id = ExprId(i);
            match tree.expr(id).kind {
                ExprKind::Name(_) => self.name(id),
                ExprKind::Assign(_, target, _) => self.write(target),
                ExprKind::Call(_, args) => {
                    for (i, &arg) in tree.args(args).iter().enumerate() {
                        if self.direction(id, i).writes() {
                            self.write(arg);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// How a call passes an argument.
    fn direction(&self, call: ExprId, position: usize) -> Direction {
        match self.program.expr(call).resolution {
            Resolution::Function(callee) => {
                let function = self.program.function(callee);
                let param = function.and_then(|f| f.params.get(position));
                param.map_or(Direction::In, |p| p.direction)
            }
            Resolution::Builtin(_) => match self.program.overload_called(call) {
                Some(overload) if overload.writes(position) => Direction::Out,
                _ => Direction::In,
            },
            _ => Direction::In,
        }
    }

    fn write(&mut self, target: ExprId) {
        let program = self.program;
        let Some(variable) = root(program, target) else {
            return;
        };
        let mask = match program.tree.expr(program.tree.unparen(target)).kind {
            ExprKind::Member(object, name) if program.variable_of(object).is_some() => {
                swizzled(program, object, name).unwrap_or(ALL)
            }
            _ => ALL,
        };
        if let Some(slot) = self.ever.get_mut(variable.0 as usize) {
            *slot |= mask;
        }
        self.writes.push((variable, mask));
        let value = self.value(variable.0) | mask;
        self.assign(variable.0, value);
    }

    /// Whether a condition stands between a variable's declaration and its use.
    fn is_guarded(&self, variable: VariableId, at: ExprId) -> bool {
        let token = self.program.variable(variable).and_then(|v| v.token);
        let declared = token.unwrap_or(0);
        if self.exit > declared {
            return true;
        }
        let tree = &self.program.tree;
        let here = tree.expr(at).extent.first;
        let stmt = self.structure.stmt_of(at).into_iter();
        let around = stmt.flat_map(|s| self.structure.outwards(s));
        around
            .map(|s| tree.stmt(s))
            .take_while(|s| s.extent.first > declared)
            .any(|s| match s.kind {
                StmtKind::If { then, .. } => tree.stmt(then).extent.first <= here,
                StmtKind::Switch { .. } => true,
                _ => false,
            })
    }

    /// A variable is named: it is read, unless it is only written to.
    fn name(&mut self, id: ExprId) {
        let program = self.program;
        let tree = &program.tree;
        let Some(variable) = program.variable_of(id) else {
            return;
        };
        let value = self.value(variable.0);
        if value == ALL {
            return;
        }
        let mut needed = self.needed(variable);
        let mut outer = id;
        while let Some(parent) = self.structure.parent(outer) {
            match tree.expr(parent).kind {
                ExprKind::Paren(_) => {}
                ExprKind::Member(object, name) => {
                    if let Some(components) = swizzled(program, object, name)
                        && program.variable_of(object) == Some(variable)
                    {
                        needed = components;
                    }
                }
                ExprKind::Index(object, _) if object == outer => {
                    // Which component it is, the text does not tell.
                    needed = if value == 0 { needed } else { 0 };
                }
                ExprKind::Assign(None, target, _) if target == outer => return,
                ExprKind::Method(..) => return,
                ExprKind::Call(_, args) => {
                    let position = tree.args(args).iter().position(|&a| a == outer);
                    let direction = position.map(|i| self.direction(parent, i));
                    if direction == Some(Direction::Out) {
                        return;
                    }
                    break;
                }
                _ => break,
            }
            outer = parent;
        }
        let missing = needed & !value;
        if missing == 0 {
            return;
        }
        let ever = self.ever.get(variable.0 as usize).copied().unwrap_or(0);
        self.findings.reads.push(Unset {
            variable,
            at: tree.expr(id).extent,
            missing,
            always: ever & missing == 0,
            guarded: self.is_guarded(variable, id),
        });
        // Once is enough.
        self.assign(variable.0, ALL);
    }
}
