//! The value of an expression as far as the text tells it: constants, variables that nobody writes
//! to, and the largest argument that any call gives.

use super::CallGraph;
use super::calls::arguments;
use crate::semantic::{BuiltinId, Direction, Program, Resolution, Storage, Value, VariableId};
use crate::syntax::ast::*;

/// How far calls and variables are followed.
const MAX_DEPTH: u32 = 24;

/// Evaluates expressions as far as the text tells.
pub struct Estimate<'a> {
    program: &'a Program,
    calls: &'a CallGraph,
    /// By variable: where it is declared.
    initial: Vec<Option<ExprId>>,
    /// By variable: which parameter of its function it is.
    position: Vec<Option<u32>>,
}

impl<'a> Estimate<'a> {
    /// Prepares to evaluate expressions of a shader.
    pub fn new(program: &'a Program, calls: &'a CallGraph) -> Estimate<'a> {
        let tree = &program.tree;
        let mut initial = vec![None; program.variables.len()];
        for (declarator, variable) in tree.declarator_lists.iter().zip(&program.declared) {
            if let Some(slot) = variable.and_then(|v| initial.get_mut(v.0 as usize)) {
                *slot = declarator.init;
            }
        }
        let mut position = vec![None; program.variables.len()];
        for function in &tree.functions {
            for i in 0..function.params.len {
                let variable = program
                    .declared_params
                    .get((function.params.start + i) as usize);
                let slot = variable.copied().flatten();
                if let Some(slot) = slot.and_then(|v| position.get_mut(v.0 as usize)) {
                    *slot = Some(i);
                }
            }
        }
        Estimate {
            program,
            calls,
            initial,
            position,
        }
    }

    /// The expression that gives a variable its first value.
    pub fn initial(&self, variable: VariableId) -> Option<ExprId> {
        self.initial.get(variable.0 as usize).copied().flatten()
    }

    /// The value of a scalar, the largest where there may be several.
    pub fn value(&self, expr: ExprId) -> Option<f64> {
        self.value_at(expr, 0)
    }

    fn value_at(&self, expr: ExprId, depth: u32) -> Option<f64> {
        if depth > MAX_DEPTH {
            return None;
        }
        let program = self.program;
        if let Some(value) = program.scalar(expr) {
            return Some(number(value));
        }
        let value = |e| self.value_at(e, depth + 1);
        match program.tree.expr(expr).kind {
            ExprKind::Paren(inner) => value(inner),
            ExprKind::Unary(UnaryOp::Minus, inner) => value(inner).map(|v| -v),
            ExprKind::Name(_) => self.variable(program.variable_of(expr)?, depth),
            ExprKind::Binary(op, a, b) => arithmetic(op, value(a)?, value(b)?),
            ExprKind::Ternary(_, a, b) => Some(value(a)?.max(value(b)?)),
            ExprKind::Construct(_, args) => match program.tree.args(args) {
                &[one] => Some(value(one)?).map(|v| match program.ty(expr).scalar_kind() {
                    Some(s) if s.is_integer() => v.trunc(),
                    _ => v,
                }),
                _ => None,
            },
            ExprKind::Call(_, args) => {
                let args: Vec<Option<f64>> =
                    program.tree.args(args).iter().map(|&a| value(a)).collect();
                match (program.builtin_called(expr)?, args.as_slice()) {
                    // `min(iFrame, 0)` is zero: the other operand is there to keep the compiler
                    // from unrolling.
                    (BuiltinId::Min, &[Some(a), Some(b)]) => Some(a.min(b)),
                    (BuiltinId::Min, &[Some(a), None] | &[None, Some(a)]) => Some(a),
                    (BuiltinId::Max, &[Some(a), Some(b)]) => Some(a.max(b)),
                    (BuiltinId::Clamp, &[_, _, high]) => high,
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Where the value of an expression is given: the argument of the call that gives the largest,
    /// where it is a parameter, and itself otherwise.
    pub fn source(&self, expr: ExprId) -> ExprId {
        let mut at = expr;
        for _ in 0..MAX_DEPTH {
            let Some(arg) = self.largest_argument(at) else {
                break;
            };
            at = arg;
        }
        at
    }

    fn largest_argument(&self, expr: ExprId) -> Option<ExprId> {
        let id = self.program.variable_of(expr)?;
        let variable = self.program.variable(id)?;
        let position = self.position.get(id.0 as usize).copied().flatten()?;
        let calls = self.calls.calls_of(variable.function?);
        let args = calls.filter_map(|c| {
            let arg = *arguments(self.program, c.expr).get(position as usize)?;
            Some((self.value(arg)?, arg))
        });
        let largest = args.reduce(|most, next| if next.0 > most.0 { next } else { most });
        largest.map(|(_, arg)| arg)
    }

    fn variable(&self, id: VariableId, depth: u32) -> Option<f64> {
        let variable = self.program.variable(id)?;
        if variable.written {
            return None;
        }
        match variable.storage {
            Storage::Local | Storage::Global => self.value_at(self.initial(id)?, depth + 1),
            Storage::Param(Direction::In | Direction::ConstIn) => {
                let position = self.position.get(id.0 as usize).copied().flatten()?;
                let mut largest: Option<f64> = None;
                for call in self.calls.calls_of(variable.function?) {
                    let arg = *arguments(self.program, call.expr).get(position as usize)?;
                    let value = self.value_at(arg, depth + 1)?;
                    largest = Some(largest.map_or(value, |l| l.max(value)));
                }
                largest
            }
            _ => None,
        }
    }

    /// The variable that an expression counts up or down, and by how much: `i++`, `i += 2`,
    /// `i = i + 2`.
    pub fn step(&self, expr: ExprId) -> Option<(VariableId, f64)> {
        let program = self.program;
        match program.tree.expr(program.tree.unparen(expr)).kind {
            ExprKind::Postfix(op, e) => {
                let by = if op == PostfixOp::Increment {
                    1.0
                } else {
                    -1.0
                };
                Some((program.variable_of(e)?, by))
            }
            ExprKind::Unary(UnaryOp::Increment, e) => Some((program.variable_of(e)?, 1.0)),
            ExprKind::Unary(UnaryOp::Decrement, e) => Some((program.variable_of(e)?, -1.0)),
            ExprKind::Assign(Some(op), e, by) => {
                let by = match op {
                    BinaryOp::Add => self.value(by)?,
                    BinaryOp::Sub => -self.value(by)?,
                    _ => return None,
                };
                Some((program.variable_of(e)?, by))
            }
            ExprKind::Assign(None, e, value) => {
                let variable = program.variable_of(e)?;
                let is_it = |e| matches!(program.expr(program.tree.unparen(e)).resolution, Resolution::Variable(v) if v == variable);
                match program.tree.expr(program.tree.unparen(value)).kind {
                    ExprKind::Binary(BinaryOp::Add, a, b) if is_it(a) => {
                        Some((variable, self.value(b)?))
                    }
                    ExprKind::Binary(BinaryOp::Add, a, b) if is_it(b) => {
                        Some((variable, self.value(a)?))
                    }
                    ExprKind::Binary(BinaryOp::Sub, a, b) if is_it(a) => {
                        Some((variable, -self.value(b)?))
                    }
                    _ => None,
                }
            }
            ExprKind::Comma(a, b) => self.step(a).or_else(|| self.step(b)),
            _ => None,
        }
    }
}

fn number(value: Value) -> f64 {
    match value {
        Value::Bool(v) => v as u8 as f64,
        Value::Int(v) => v as f64,
        Value::Uint(v) => v as f64,
        Value::Float(v) => v as f64,
    }
}

fn arithmetic(op: BinaryOp, a: f64, b: f64) -> Option<f64> {
    let value = match op {
        BinaryOp::Add => a + b,
        BinaryOp::Sub => a - b,
        BinaryOp::Mul => a * b,
        BinaryOp::Div => a / b,
        _ => return None,
    };
    value.is_finite().then_some(value)
}
