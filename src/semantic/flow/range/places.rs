//! Where values are kept, and all that is ever put there.
//!
//! A place is a variable, or a member of a struct: all objects of one struct type share its places,
//! and all elements of an array are one place. So what a place may hold is a join over all writes,
//! whatever their order.

use crate::semantic::{
    Base, Direction, FunctionRef, Program, Resolution, Storage, Type, Variable, VariableId,
};
use crate::syntax::ast::*;

/// How many writes before a use are looked at.
const MAX_CHANGES: usize = 12;

/// Index of a place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct PlaceId(pub u32);

/// The components of a vector, in the order in which a swizzle names them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Components {
    index: [u8; 4],
    len: u8,
}

/// One write to a place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Write {
    /// What is put there.
    pub value: Written,
    /// The components that are written to; all, if none are named.
    pub to: Option<Components>,
}

/// What a write puts into a place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Written {
    /// The value of an expression.
    Value(ExprId),
    /// The place's own value, with an operator and an expression.
    Combined(BinaryOp, ExprId),
    /// The place's own value, and 1 more or less.
    Step(f64),
    /// What another place holds.
    Copy(PlaceId),
    /// Nobody knows.
    Unknown,
}

/// A write to a variable where it stands in the text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Change {
    /// Its last token: until then the old value is there.
    pub token: TokenId,
    /// The components that it writes to, a bit each.
    pub mask: u8,
    /// What it is.
    pub kind: ChangeKind,
}

/// The kinds of write in the text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ChangeKind {
    /// The declaration, with the first value.
    First(ExprId),
    /// An assignment to the variable, or to some of its components.
    Assigned(ExprId),
    /// Anything else.
    Other,
}

/// All places of a shader.
#[derive(Default, Debug)]
pub struct Places {
    writes: Vec<Vec<Write>>,
    /// By struct: the place of its first member.
    members: Vec<u32>,
    /// By variable: the writes in the text, in order.
    written_at: Vec<Vec<Change>>,
    /// By function: what it returns.
    returns: Vec<Vec<ExprId>>,
}

impl Components {
    /// Reads a swizzle.
    pub fn of_swizzle(text: &str) -> Option<Components> {
        let mut index = [0; 4];
        let mut len = 0;
        for (slot, c) in index.iter_mut().zip(text.chars()) {
            *slot = match c {
                'x' | 'r' | 's' => 0,
                'y' | 'g' | 't' => 1,
                'z' | 'b' | 'p' => 2,
                'w' | 'a' | 'q' => 3,
                _ => return None,
            };
            len += 1;
        }
        (text.chars().count() == len as usize).then_some(Components { index, len })
    }

    /// The component that the swizzle names at a position.
    pub fn at(self, position: u8) -> Option<u8> {
        let named = self.index.get(..self.len as usize)?;
        named.get(position as usize).copied()
    }

    /// The position at which the swizzle names a component.
    pub fn position(self, component: u8) -> Option<u8> {
        let named = self.index.get(..self.len as usize)?;
        named.iter().position(|i| *i == component).map(|p| p as u8)
    }

    /// A bit for each component that is named.
    pub fn mask(self) -> u8 {
        let named = self.index.get(..self.len as usize).unwrap_or(&[]);
        named.iter().fold(0, |mask, i| mask | 1 << i)
    }
}

/// Whether a member expression picks components of a vector, and which.
pub fn swizzle(program: &Program, object: ExprId, name: crate::syntax::Name) -> Option<Components> {
    let is_vector = program.ty(object).is_vector();
    is_vector
        .then(|| Components::of_swizzle(program.names.text(name)))
        .flatten()
}

impl Places {
    /// Finds the places of a shader, and the writes to them.
    pub fn of(program: &Program, function_of: impl Fn(StmtId) -> Option<FunctionRef>) -> Places {
        let mut places = Places::default();
        let mut count = program.variables.len() as u32;
        for record in &program.structs {
            places.members.push(count);
            count += record.fields.len() as u32;
        }
        places.writes = vec![Vec::new(); count as usize];
        places.written_at = vec![Vec::new(); program.variables.len()];
        places.returns = vec![Vec::new(); program.functions.len()];
        places.declarations(program);
        for (i, expr) in program.tree.exprs.iter().enumerate() {
            places.expr(program, ExprId(i as u32), expr);
        }
        places.callers(program);
        for list in &mut places.written_at {
            list.sort_unstable_by_key(|c| c.token);
        }
        for (i, stmt) in program.tree.stmts.iter().enumerate() {
            if let StmtKind::Return(Some(value)) = stmt.kind
                && let Some(function) = function_of(StmtId(i as u32))
                && let Some(list) = places.returns.get_mut(function.0 as usize)
            {
                list.push(value);
            }
        }
        places
    }

    /// Which places code that is not understood may write to; it calls functions, and uses globals,
    /// of the names given.
    pub fn hidden(&self, program: &Program, is_named: impl Fn(&str) -> bool) -> Vec<bool> {
        let is_named = |name| is_named(program.names.text(name));
        let is_hidden = |variable: &Variable| match variable.function {
            Some(f) => {
                let is_param = matches!(variable.storage, Storage::Param(_));
                is_param && program.function(f).is_some_and(|f| is_named(f.name))
            }
            None => is_named(variable.name),
        };
        // Members of structs come behind the variables, and may be named in any way.
        let hidden = program.variables.iter().map(is_hidden);
        let hidden = hidden.chain(std::iter::repeat(true));
        hidden.take(self.writes.len()).collect()
    }

    /// All writes to a place.
    pub fn writes(&self, place: PlaceId) -> &[Write] {
        self.writes.get(place.0 as usize).map_or(&[], Vec::as_slice)
    }

    /// Whether a variable is written to at one of these tokens.
    pub fn is_written_in(&self, variable: VariableId, from: TokenId, to: TokenId) -> bool {
        let at = self.written_at.get(variable.0 as usize);
        let at = at.map_or(&[][..], Vec::as_slice);
        let first = at.partition_point(|c| c.token < from);
        at.get(first).is_some_and(|c| c.token < to)
    }

    /// The last write to a component of a variable that stands before a token.
    pub fn last_change(&self, variable: VariableId, component: u8, to: TokenId) -> Option<Change> {
        let all = self.written_at.get(variable.0 as usize)?;
        let before = all.get(..all.partition_point(|c| c.token < to))?;
        let touches = |c: &&Change| c.mask & 1 << component != 0;
        before.iter().rev().take(MAX_CHANGES).find(touches).copied()
    }

    /// Whether a variable is written to in the text, not counting its declaration.
    pub fn is_changed(&self, variable: VariableId) -> bool {
        let all = self.written_at.get(variable.0 as usize);
        all.is_some_and(|l| l.iter().any(|c| !matches!(c.kind, ChangeKind::First(_))))
    }

    /// What a function returns.
    pub fn returns(&self, function: FunctionRef) -> &[ExprId] {
        let list = self.returns.get(function.0 as usize);
        list.map_or(&[], Vec::as_slice)
    }

    /// The place of a member of a struct.
    pub fn member(&self, record: u32, field: u32) -> Option<PlaceId> {
        let first = self.members.get(record as usize)?;
        Some(PlaceId(first + field))
    }

    /// The place that an expression names, and which of its components; `None` for the components
    /// is all of them, or an element of an array.
    pub fn named(&self, program: &Program, expr: ExprId) -> Option<(PlaceId, Option<Components>)> {
        let expr = program.tree.unparen(expr);
        match program.tree.expr(expr).kind {
            ExprKind::Name(_) => Some((PlaceId(program.variable_of(expr)?.0), None)),
            ExprKind::Member(object, name) => match swizzle(program, object, name) {
                Some(components) => match self.named(program, object)? {
                    (place, None) => Some((place, Some(components))),
                    _ => None,
                },
                None => Some((self.field(program, object, name)?, None)),
            },
            ExprKind::Index(object, _) if program.ty(object).is_array() => {
                self.named(program, object)
            }
            _ => None,
        }
    }

    /// The place of `object.name`, where the object is a struct.
    pub fn field(
        &self,
        program: &Program,
        object: ExprId,
        name: crate::syntax::Name,
    ) -> Option<PlaceId> {
        let Base::Struct(id) = program.ty(object).base else {
            return None;
        };
        let fields = &program.structs.get(id as usize)?.fields;
        let field = fields.iter().position(|f| f.name == name)?;
        self.member(id, field as u32)
    }

    fn add(&mut self, place: PlaceId, value: Written, to: Option<Components>) {
        if let Some(list) = self.writes.get_mut(place.0 as usize) {
            list.push(Write { value, to });
        }
    }

    fn declarations(&mut self, program: &Program) {
        let tree = &program.tree;
        for (declarator, variable) in tree.declarator_lists.iter().zip(&program.declared) {
            if let (Some(init), &Some(variable)) = (declarator.init, variable) {
                self.add(PlaceId(variable.0), Written::Value(init), None);
                let first = Change {
                    token: declarator.extent.last,
                    mask: 0xff,
                    kind: ChangeKind::First(init),
                };
                self.note(variable, first);
            }
        }
        for (i, variable) in program.variables.iter().enumerate() {
            let from_host = matches!(variable.storage, Storage::Uniform | Storage::Input);
            if from_host {
                self.add(PlaceId(i as u32), Written::Unknown, None);
                self.host_struct(program, variable.ty, 0);
            }
        }
    }

    /// What nobody in the shader calls may be called with anything.
    fn callers(&mut self, program: &Program) {
        let mut is_called = vec![false; program.functions.len()];
        for call in &program.calls {
            if let Some(slot) = is_called.get_mut(call.callee.0 as usize) {
                *slot = true;
            }
        }
        for (i, variable) in program.variables.iter().enumerate() {
            let is_in = matches!(
                variable.storage,
                Storage::Param(Direction::In | Direction::ConstIn | Direction::Inout)
            );
            let function = variable.function.map_or(0, |f| f.0 as usize);
            if is_in && is_called.get(function) != Some(&true) {
                self.add(PlaceId(i as u32), Written::Unknown, None);
            }
        }
    }

    /// The members of what a host fills in are unknown.
    fn host_struct(&mut self, program: &Program, ty: Type, depth: u32) {
        let (Base::Struct(id) | Base::Block(id)) = ty.base else {
            return;
        };
        let Some(record) = program.structs.get(id as usize).filter(|_| depth < 8) else {
            return;
        };
        for (i, field) in record.fields.iter().enumerate() {
            if let Some(place) = self.member(id, i as u32) {
                if matches!(self.writes(place), [first, ..] if first.value == Written::Unknown) {
                    return;
                }
                if let Some(list) = self.writes.get_mut(place.0 as usize) {
                    list.insert(
                        0,
                        Write {
                            value: Written::Unknown,
                            to: None,
                        },
                    );
                }
                self.host_struct(program, field.ty, depth + 1);
            }
        }
    }

    fn note(&mut self, variable: VariableId, change: Change) {
        if let Some(list) = self.written_at.get_mut(variable.0 as usize) {
            list.push(change);
        }
    }

    fn expr(&mut self, program: &Program, id: ExprId, expr: &Expr) {
        match expr.kind {
            ExprKind::Assign(op, target, value) => {
                let value = match op {
                    None => Written::Value(value),
                    Some(op) => Written::Combined(op, value),
                };
                let kind = ChangeKind::Assigned(id);
                self.write(program, target, value, expr.extent.last, kind);
            }
            ExprKind::Unary(op, target) if op.assigns() => {
                let by = if op == UnaryOp::Increment { 1.0 } else { -1.0 };
                let kind = ChangeKind::Other;
                self.write(program, target, Written::Step(by), expr.extent.last, kind);
            }
            ExprKind::Postfix(op, target) => {
                let by = if op == PostfixOp::Increment {
                    1.0
                } else {
                    -1.0
                };
                let kind = ChangeKind::Other;
                self.write(program, target, Written::Step(by), expr.extent.last, kind);
            }
            ExprKind::Call(_, args) => match program.expr(id).resolution {
                Resolution::Function(callee) => self.call(program, callee, args),
                Resolution::Struct(record) => {
                    for (i, &arg) in program.tree.args(args).iter().enumerate() {
                        if let Some(place) = self.member(record, i as u32) {
                            self.add(place, Written::Value(arg), None);
                        }
                    }
                }
                Resolution::Builtin(_) => {
                    let Some(overload) = program.overload_called(id).filter(|o| o.out != 0) else {
                        return;
                    };
                    for (i, &arg) in program.tree.args(args).iter().enumerate() {
                        if overload.writes(i) {
                            let (last, kind) = (expr.extent.last, ChangeKind::Other);
                            self.write(program, arg, Written::Unknown, last, kind);
                        }
                    }
                }
                _ => {}
            },
            _ => {}
        }
    }

    /// A write to what an expression names. `token` is the last of the write: until then the old
    /// value is there.
    fn write(
        &mut self,
        program: &Program,
        target: ExprId,
        value: Written,
        token: TokenId,
        kind: ChangeKind,
    ) {
        let named = self.named(program, target);
        if let Some(variable) = root(program, target) {
            let is_whole = named.is_some_and(|(place, _)| place.0 == variable.0)
                && !program.ty(target).is_array()
                && !matches!(program.tree.expr(target).kind, ExprKind::Index(..));
            let mask = match named {
                Some((_, Some(to))) if is_whole => to.mask(),
                _ => 0xff,
            };
            let kind = if is_whole { kind } else { ChangeKind::Other };
            self.note(variable, Change { token, mask, kind });
        }
        if let Some((place, to)) = named {
            self.add(place, value, to);
        } else if let Some(place) = self.around(program, target) {
            self.add(place, Written::Unknown, None);
        }
    }

    /// The innermost place that an expression names a part of.
    fn around(&self, program: &Program, expr: ExprId) -> Option<PlaceId> {
        let mut expr = program.tree.unparen(expr);
        loop {
            if let Some((place, _)) = self.named(program, expr) {
                return Some(place);
            }
            let (ExprKind::Member(inner, _) | ExprKind::Index(inner, _)) =
                program.tree.expr(expr).kind
            else {
                return None;
            };
            expr = program.tree.unparen(inner);
        }
    }

    /// A call gives its arguments to the parameters, and takes back what those hold in the end.
    fn call(&mut self, program: &Program, callee: FunctionRef, args: List) {
        let Some(function) = program.function(callee) else {
            return;
        };
        let decl = function.definition.and_then(|d| program.tree.function(d));
        for (i, &arg) in program.tree.args(args).iter().enumerate() {
            let variable = decl.and_then(|d| {
                let at = d.params.start as usize + i;
                program.declared_params.get(at).copied().flatten()
            });
            let Some(direction) = function.params.get(i).map(|p| p.direction) else {
                continue;
            };
            if let Some(variable) = variable.filter(|_| direction != Direction::Out) {
                self.add(PlaceId(variable.0), Written::Value(arg), None);
            }
            if direction.writes() {
                let value = variable.map_or(Written::Unknown, |v| Written::Copy(PlaceId(v.0)));
                let token = program.tree.expr(arg).extent.last;
                self.write(program, arg, value, token, ChangeKind::Other);
            }
        }
    }
}

/// The variable that an expression names a part of.
pub fn root(program: &Program, expr: ExprId) -> Option<VariableId> {
    let mut expr = program.tree.unparen(expr);
    while let ExprKind::Member(inner, _) | ExprKind::Index(inner, _) = program.tree.expr(expr).kind
    {
        expr = program.tree.unparen(inner);
    }
    program.variable_of(expr)
}
