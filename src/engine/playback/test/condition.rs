//! The comparisons of a failed test, with the values of their operands.

use super::quad::{SIZE, draw_quad};
use crate::Analysis;
use crate::playback::{Moment, Scene};
use shaderlint_exec::{CompileOptions, Probe};
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
}

/// An expression and its value.
#[derive(Clone, PartialEq, Debug)]
pub struct SeenValue {
    /// Span of the expression.
    pub at: Span,
    /// Value as GLSL source text.
    pub value: String,
}

/// A test at a time and a pixel.
struct TestedPixel<'a> {
    analysis: &'a Analysis,
    test: FunctionRef,
    time: f64,
    pixel: [u32; 2],
}

/// The conditions of a test that a pixel evaluated.
pub fn seen(
    analysis: &Analysis,
    test: FunctionRef,
    time: f64,
    pixel: [u32; 2],
) -> Vec<SeenCondition> {
    let program: &Program = &analysis.program;
    let look = TestedPixel {
        analysis,
        test,
        time,
        pixel,
    };
    let mut found = Vec::new();
    for (id, parts) in conditions(program, test) {
        if found.len() == MAX_CONDITIONS {
            break;
        }
        let Some(answer) = look.value(id) else {
            continue;
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
        });
    }
    found
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
            ExprKind::Binary(op, left, right) if compares(op) => vec![left, right],
            ExprKind::Call(_, args) if asks(program, id) => tree.args(args).to_vec(),
            _ => return None,
        };
        Some((id, parts))
    });
    let mut asked: Vec<_> = asked.collect();
    asked.sort_by_key(|(id, _)| program.expr_span(*id).start);
    asked
}

const fn compares(op: BinaryOp) -> bool {
    use BinaryOp::*;
    matches!(
        op,
        Less | Greater | LessEqual | GreaterEqual | Equal | NotEqual
    )
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
    /// The last value of an expression at the pixel, if it was evaluated.
    fn value(&self, id: ExprId) -> Option<String> {
        let Analysis { program, .. } = self.analysis;
        let module = self.analysis.module();
        let options = CompileOptions {
            entry: Some(self.test),
            probe: Some(Probe::Value(module.op_of(program.tree.unparen(id))?)),
            ..CompileOptions::default()
        };
        let scene = Scene::of(program, self.analysis.host, module, &options).ok()?;
        let draw = scene.draw(SIZE, &Moment::at(self.time));
        let (sampled, at) = draw_quad(&draw, self.pixel)?;
        let [.., value, reached] = &sampled.outputs[..] else {
            return None;
        };
        let slots = &scene.code.outputs;
        let ty = slots.get(slots.len().checked_sub(2)?)?.ty;
        let is_reached = reached.get(at)?[0] != 0;
        is_reached.then(|| written(program, ty, *value.get(at).unwrap_or(&[0; 4])))
    }
}

/// A value as GLSL source text; only the first four components are shown.
fn written(program: &Program, ty: Type, bits: [u32; 4]) -> String {
    let count = ty.components().max(1) * ty.array.max(1);
    let one = |bits: u32| match ty.scalar_kind() {
        Some(Scalar::Bool) => (bits != 0).to_string(),
        Some(Scalar::Int) => (bits as i32).to_string(),
        Some(Scalar::Uint) => format!("{bits}u"),
        Some(Scalar::Float) | None => format!("{:?}", f32::from_bits(bits)),
    };
    let shown: Vec<String> = bits.into_iter().take(count as usize).map(one).collect();
    let rest = if count > 4 { ", ..." } else { "" };
    match &shown[..] {
        [one] => one.clone(),
        all => format!("{}({}{rest})", program.type_name(ty), all.join(", ")),
    }
}
