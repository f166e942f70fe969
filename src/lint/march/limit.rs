//! Edits of the limit of a marching loop.

use super::loops::March;
use super::step_edit::DIGITS;
use crate::facts::Facts;
use shaderlint_flow::RayKind;
use shaderlint_semantic::{Program, VariableId};
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind};
use shaderlint_syntax::{Macro, MacroId, TokenKind};
use shaderlint_text::number::significant;
use shaderlint_text::{Edit, Span};

/// The edit that multiplies the literal limit of a loop, or the macro or constant that the limit is, if
/// that changes nothing but the number of steps; `None` for other limits.
pub fn limit_edit(facts: &Facts, march: &March, times: u32) -> Option<Edit> {
    let program = facts.program();
    let given = program.tree.unparen(march.looped.given?);
    let extent = program.tree.expr(given).extent;
    if program.is_direct(extent) && program.variable_of(given).is_none() {
        let text = raised(program, given, times)?;
        return Some(Edit::replace(program.expr_span(given), text));
    }
    let name = LimitName::of(program, given)?;
    let (word, value, span) = name.defined(program)?;
    let is_own = facts.own_file().is_some_and(|file| file.contains(span));
    // Besides its definition, all that the file says of it is about the number of steps.
    let is_sole = is_own && facts.count(word) as usize == 1 + name.limits(facts, march).len();
    let text = raised(program, value, times).filter(|_| is_sole)?;
    Some(Edit::replace(span, text))
}

/// A literal, several times as large.
fn raised(program: &Program, value: ExprId, times: u32) -> Option<String> {
    Some(match program.tree.expr(value).kind {
        ExprKind::Int(n) => n.checked_mul(i32::try_from(times).ok()?)?.to_string(),
        ExprKind::Uint(n) => format!("{}u", n.checked_mul(times)?),
        ExprKind::Float(n) => significant(f64::from(n) * f64::from(times), DIGITS),
        _ => return None,
    })
}

/// What a limit is called: a literal that a macro stands for, or a constant.
#[derive(Clone, Copy, PartialEq, Eq)]
enum LimitName {
    Macro(MacroId, ExprId),
    Constant(VariableId),
}

impl LimitName {
    fn of(program: &Program, limit: ExprId) -> Option<LimitName> {
        if let Some(constant) = program.variable_of(limit) {
            return Some(LimitName::Constant(constant));
        }
        Some(LimitName::Macro(macro_of(program, limit)?, limit))
    }

    /// Whether an expression is the name.
    fn is(self, program: &Program, expr: ExprId) -> bool {
        match self {
            LimitName::Macro(id, _) => macro_of(program, expr) == Some(id),
            LimitName::Constant(id) => program.variable_of(expr) == Some(id),
        }
    }

    /// The word, and the literal that it stands for, as an expression and where the definition has it.
    fn defined(self, program: &Program) -> Option<(&str, ExprId, Span)> {
        match self {
            LimitName::Macro(id, value) => {
                let definition = program.tokens.macros.get(id.0 as usize)?;
                let span = sole_token(definition)?;
                Some((program.names.text(definition.name), value, span))
            }
            LimitName::Constant(id) => {
                let variable = program.variable(id).filter(|v| v.is_const)?;
                let value = program.tree.unparen(program.declarator_of(id)?.init?);
                let is_direct = program.is_direct(program.tree.expr(value).extent);
                let word = program.names.text(variable.name);
                is_direct.then(|| (word, value, program.expr_span(value)))
            }
        }
    }

    /// The places where the name limits steps of this loop, or of others that more steps only complete:
    /// the limit of such a loop, or what its counter is compared with.
    fn limits(self, facts: &Facts, march: &March) -> Vec<Span> {
        let (program, tree) = (facts.program(), &facts.program().tree);
        let is_search = |other: &&March| {
            let ray = &other.ray;
            let searches = ray.kind == RayKind::Distance && ray.hit.is_some();
            let is_own = other.looped.stmt == march.looped.stmt;
            is_own || searches && !ray.accumulates && !ray.motion.is_counted
        };
        let all: Vec<&March> = facts.marches().iter().filter(is_search).collect();
        let counts = |expr: ExprId| {
            let counter = program.variable_of(expr);
            counter.is_some() && all.iter().any(|m| m.looped.counter == counter)
        };
        let given = all.iter().filter_map(|m| m.looped.given);
        let compared = tree.exprs.iter().filter_map(|expr| match expr.kind {
            ExprKind::Binary(op, a, b) if is_comparison(op) => Some((a, b)),
            _ => None,
        });
        let compared = compared.flat_map(|(a, b)| [(a, b), (b, a)]);
        let compared = compared.filter(|(_, other)| counts(*other));
        let mut places: Vec<Span> = given
            .chain(compared.map(|(own, _)| own))
            .map(|own| tree.unparen(own))
            .filter(|own| self.is(program, *own))
            .map(|own| program.expr_span(own))
            .collect();
        places.sort_unstable();
        places.dedup();
        places
    }
}

fn is_comparison(op: BinaryOp) -> bool {
    use BinaryOp::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
    matches!(
        op,
        Less | Greater | LessEqual | GreaterEqual | Equal | NotEqual
    )
}

/// The macro that the code calls for a literal.
fn macro_of(program: &Program, literal: ExprId) -> Option<MacroId> {
    let extent = program.tree.expr(literal).extent;
    let token = program.token(extent.first)?;
    let expansions = &program.tokens.expansions;
    let expansion = expansions.get(token.expansion as usize)?;
    let is_outermost = expansions.get(expansion.parent as usize).is_none();
    (extent.first == extent.last && is_outermost).then_some(expansion.definition)
}

/// The only token that an object-like macro stands for, besides parentheses.
fn sole_token(definition: &Macro) -> Option<Span> {
    let is_paren = |kind| matches!(kind, TokenKind::LeftParen | TokenKind::RightParen);
    let pieces = definition.body.iter().map(|piece| piece.token);
    let mut own = pieces.filter(|token| !is_paren(token.kind));
    let sole = own.next()?;
    let is_sole = own.next().is_none() && definition.params.is_none();
    (is_sole && sole.is_direct()).then_some(sole.span)
}
