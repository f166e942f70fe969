//! The comparisons of a failed test, with the values of their operands.

use super::invocation::Invocation;
use super::quad::draw_quad;
use shaderlint_exec::{CompileOptions, Probe};
use shaderlint_ir::OpId;
use shaderlint_semantic::{BuiltinId, FunctionRef, Program, Scalar, Type};
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind};
use shaderlint_text::Span;

/// Maximum number of comparisons reported for a test.
const MAX_CONDITIONS: usize = 8;
/// Maximum number of values reported for a comparison.
const MAX_VALUES: usize = 6;

/// A comparison, or a call that returns a boolean.
#[derive(Clone, PartialEq, Debug)]
pub struct SeenCondition {
    /// Span of the expression.
    pub at: Span,
    /// Result: `true`, `false`, or `bvec2(true, false)`.
    pub answer: String,
    /// The values of the operands or arguments.
    pub values: Vec<SeenValue>,
    /// The largest difference of the arguments of `approx`.
    pub difference: Option<String>,
}

/// An expression and its value.
#[derive(Clone, PartialEq, Debug)]
pub struct SeenValue {
    /// Span of the expression.
    pub at: Span,
    /// Value as GLSL source text.
    pub value: String,
}

/// A test at a pixel.
struct TestedPixel<'a> {
    invocation: &'a Invocation<'a>,
    pixel: [u32; 2],
}

/// The conditions of a test that a pixel evaluated.
pub fn seen(invocation: &Invocation<'_>, pixel: [u32; 2]) -> Vec<SeenCondition> {
    let program: &Program = &invocation.analysis.program;
    let look = TestedPixel { invocation, pixel };
    let mut found = Vec::new();
    for (id, parts) in conditions(program, invocation.case.function) {
        if found.len() == MAX_CONDITIONS {
            break;
        }
        let Some(answer) = look.value(id) else {
            continue;
        };
        let difference = match &parts[..] {
            [a, b, ..] if is_approx(program, id) => look.difference(*a, *b),
            _ => None,
        };
        let mut shown = Vec::new();
        for part in parts {
            sides(program, part, &mut shown);
        }
        shown.truncate(MAX_VALUES);
        let values = shown.into_iter().filter_map(|id| {
            let at = program.expr_span(id);
            let value = look.value(id)?;
            Some(SeenValue { at, value })
        });
        found.push(SeenCondition {
            at: program.expr_span(id),
            answer,
            values: values.collect(),
            difference,
        });
    }
    found
}

/// Whether an expression calls the function `approx` of tests.
fn is_approx(program: &Program, call: ExprId) -> bool {
    let called = program.calls.iter().find(|c| c.expr == call);
    let function = called.and_then(|c| program.function(c.callee));
    function.is_some_and(|f| program.names.text(f.name) == "approx")
}

/// The comparisons and boolean calls in a function, in source order, with their operands.
fn conditions(program: &Program, function: FunctionRef) -> Vec<(ExprId, Vec<ExprId>)> {
    let tree = &program.tree;
    let definition = program.function(function).and_then(|f| f.definition);
    let Some(definition) = definition.and_then(|id| tree.function(id)) else {
        return Vec::new();
    };
    let all = (0..tree.exprs.len() as u32).map(ExprId);
    let own = all.filter(|id| definition.extent.contains(tree.expr(*id).extent));
    let asked = own.filter_map(|id| {
        let parts = match tree.expr(id).kind {
            ExprKind::Binary(op, left, right) if op.compares() => vec![left, right],
            ExprKind::Call(_, args) if asks(program, id) => tree.args(args).to_vec(),
            _ => return None,
        };
        Some((id, parts))
    });
    let mut asked: Vec<_> = asked.collect();
    asked.sort_by_key(|(id, _)| program.expr_span(*id).start);
    asked
}

/// Whether a call returns a boolean and has no boolean arguments, unlike `all`.
fn asks(program: &Program, call: ExprId) -> bool {
    let is_bool = |id: ExprId| program.ty(id).scalar_kind() == Some(Scalar::Bool);
    let args = match program.tree.expr(call).kind {
        ExprKind::Call(_, args) => program.tree.args(args),
        _ => &[],
    };
    is_bool(call) && !args.is_empty() && !args.iter().all(|arg| is_bool(*arg))
}

/// The expressions to show for an operand: itself, and for a distance its arguments.
fn sides(program: &Program, side: ExprId, shown: &mut Vec<ExprId>) {
    let tree = &program.tree;
    let side = tree.unparen(side);
    let text = program.expr_text(side);
    let is_name = text.starts_with(|c: char| c == '_' || c.is_alphabetic())
        && text.chars().all(|c| c == '_' || c.is_alphanumeric())
        && !matches!(text, "true" | "false");
    let is_literal = program.expr(side).constant.is_known() && !is_name;
    if is_literal || shown.iter().any(|id| program.expr_text(*id) == text) {
        return;
    }
    shown.push(side);
    let function = program.builtin_called(side);
    let measures = [BuiltinId::Abs, BuiltinId::Length, BuiltinId::Distance];
    let args = match tree.expr(side).kind {
        ExprKind::Call(_, args) if function.is_some_and(|f| measures.contains(&f)) => args,
        _ => return,
    };
    for &arg in tree.args(args) {
        match tree.expr(tree.unparen(arg)).kind {
            ExprKind::Binary(BinaryOp::Sub, left, right) => {
                sides(program, left, shown);
                sides(program, right, shown);
            }
            _ => sides(program, arg, shown),
        }
    }
}

impl TestedPixel<'_> {
    /// The value of an expression at the pixel, if it was evaluated.
    fn value(&self, id: ExprId) -> Option<String> {
        let program = &self.invocation.analysis.program;
        let op = self.op(id)?;
        let (ty, bits) = self.scalars(Probe::Value(op))?;
        Some(written(program, ty, bits))
    }

    fn op(&self, id: ExprId) -> Option<OpId> {
        let analysis = self.invocation.analysis;
        analysis.module().op_of(analysis.program.tree.unparen(id))
    }

    /// Four scalars of an expression, with its type.
    fn scalars(&self, probe: Probe) -> Option<(Type, [u32; 4])> {
        let options = CompileOptions {
            probe: Some(probe),
            ..CompileOptions::default()
        };
        let scene = self.invocation.scene(&options).ok()?;
        let (sampled, at) = draw_quad(&self.invocation.draw(&scene), self.pixel)?;
        let [.., value, reached] = &sampled.outputs[..] else {
            return None;
        };
        let slots = &scene.code.outputs;
        let ty = slots.get(slots.len().checked_sub(2)?)?.ty;
        let is_reached = reached.get(at)?[0] != 0;
        is_reached.then(|| (ty, *value.get(at).unwrap_or(&[0; 4])))
    }

    /// All components of a float, vector or matrix.
    fn floats(&self, id: ExprId) -> Option<(Type, Vec<f32>)> {
        let op = self.op(id)?;
        let (ty, _) = self.scalars(Probe::Value(op))?;
        let count = ty.components();
        let mut all = Vec::new();
        for from in (0..count).step_by(4) {
            let (_, bits) = self.scalars(Probe::Part(op, from))?;
            all.extend(bits.map(f32::from_bits));
        }
        all.truncate(count as usize);
        let is_float = ty.scalar_kind() == Some(Scalar::Float);
        is_float.then_some((ty, all))
    }

    /// The largest difference between the components of two values: `differs by 0.013 in .y`.
    fn difference(&self, a: ExprId, b: ExprId) -> Option<String> {
        let ((ty, a), (_, b)) = (self.floats(a)?, self.floats(b)?);
        let gaps = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
        // NaN is the largest difference.
        let (at, gap) = gaps.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        let (_, columns, rows) = ty.numeric()?;
        let (column, row) = (at / usize::from(rows), at % usize::from(rows));
        let component = || ["x", "y", "z", "w"].get(row).copied().unwrap_or("x");
        let place = match (columns, rows) {
            (1, 1) => String::new(),
            (1, _) => format!(" in .{}", component()),
            _ => format!(" in [{column}].{}", component()),
        };
        Some(format!("differs by {gap:?}{place}"))
    }
}

/// A value as GLSL source text; only the first four components are shown.
fn written(program: &Program, ty: Type, bits: [u32; 4]) -> String {
    let count = ty.components().max(1) * ty.array.max(1);
    let scalar = ty.scalar_kind().unwrap_or(Scalar::Float);
    let one = |bits: u32| scalar.literal(bits);
    let shown: Vec<String> = bits.into_iter().take(count as usize).map(one).collect();
    let rest = if count > 4 { ", ..." } else { "" };
    match &shown[..] {
        [one] => one.clone(),
        all => format!("{}({}{rest})", program.type_name(ty), all.join(", ")),
    }
}
