//! `#define SUM a + b` in a product, `#define SQ(x) x*x` of a sum.

use shaderlint_lint::expansion::{Expanded, expanded, expanded_inside, spelling};
use shaderlint_lint::prelude::*;
use shaderlint_syntax::Token;
use std::collections::BTreeMap;

rule! { macro_parentheses, Tidy, Warning, Recommended, Program(check) }

/// A macro call with tokens that operator precedence splits.
#[derive(Clone, Copy)]
struct Torn {
    call: Expanded,
    /// The tokens that should form one operand, but do not.
    unit: Extent,
    /// The operator that splits them.
    operator: TokenId,
    /// Whether they are an argument of the call rather than its whole expansion.
    is_argument: bool,
}

/// An operator between two operands.
#[derive(Clone, Copy)]
struct MacroOperator {
    at: TokenId,
    kind: TokenKind,
    binds: u8,
}

fn check(cx: &mut Context) {
    let program = cx.program;
    let holds_operator = |m: &Macro| !m.predefined && m.uses > 0 && m.body.len() > 1;
    if !program.tokens.macros.iter().any(holds_operator) {
        return;
    }
    // A macro is fixed in its definition, so it is reported once however often it is called.
    let mut by_macro: BTreeMap<(usize, bool), (Torn, usize)> = BTreeMap::new();
    let calls = expanded(program)
        .into_iter()
        .chain(expanded_inside(program));
    for call in calls {
        for torn in torn(program, call) {
            let entry = by_macro
                .entry((call.definition, torn.is_argument))
                .or_insert((torn, 0));
            entry.1 += 1;
        }
    }
    for (torn, count) in by_macro.into_values() {
        report(cx, torn, count);
    }
}

/// What is split in a call: the expansion, at an operator of the macro body, and the first of its
/// arguments that is split.
fn torn(program: &Program, call: Expanded) -> impl Iterator<Item = Torn> {
    let of = move |unit: Extent, is_argument: bool| {
        let is_own = |t: TokenId| is_argument || !is_of_argument(program, call, t);
        let operator = tearing(program, unit, is_own)?;
        Some(Torn {
            call,
            unit,
            operator,
            is_argument,
        })
    };
    let argument = arguments(program, call).find_map(|unit| of(unit, true));
    [of(call.extent, false), argument].into_iter().flatten()
}

/// Whether a token of an expansion comes from an argument of the call.
fn is_of_argument(program: &Program, call: Expanded, token: TokenId) -> bool {
    let definition = program.tokens.macros.get(call.definition);
    let takes_any = definition.is_some_and(|m| m.params.is_some());
    takes_any && program.token(token).is_some_and(|t| t.span != call.call)
}

/// The runs of tokens in an expansion that come from arguments of the call.
fn arguments(program: &Program, call: Expanded) -> impl Iterator<Item = Extent> {
    let is_argument = move |t: &TokenId| is_of_argument(program, call, *t);
    let mut at = call.extent.first;
    std::iter::from_fn(move || {
        let first = (at..=call.extent.last).find(is_argument)?;
        let end = (first..=call.extent.last).find(|t| !is_argument(t));
        at = end.unwrap_or(call.extent.last + 1);
        Some(Extent::new(first, at - 1))
    })
}

/// The operator next to a run of tokens that takes only part of it as its operand, so that the run
/// is a complete expression on its own but not in its context. Only operators accepted by `is_own`
/// are considered.
fn tearing(program: &Program, unit: Extent, is_own: impl Fn(TokenId) -> bool) -> Option<TokenId> {
    let kind = |at: TokenId| program.token(at).map(|t| t.kind);
    let mut own = operators(program, unit)?;
    own.retain(|o| is_own(o.at));
    let least = own.iter().map(|o| o.binds).min()?;
    let after = unit.last + 1;
    if let Some(next) = kind(after) {
        let is_part = matches!(next, TokenKind::Dot | TokenKind::LeftBracket);
        if is_part || binding(next).is_some_and(|b| b > least) {
            return Some(after);
        }
    }
    let before = unit.first.checked_sub(1)?;
    let symbol = kind(before)?;
    let is_sign = before
        .checked_sub(1)
        .and_then(kind)
        .is_none_or(|k| !ends_operand(k));
    let tears = |inner: TokenKind, binds: u8| match is_sign {
        true => match symbol {
            TokenKind::Minus => binds < PRODUCT,
            TokenKind::Not | TokenKind::Tilde => true,
            _ => false,
        },
        false => binding(symbol).is_some_and(|b| b >= binds) && !regroups(symbol, inner),
    };
    own.iter().any(|o| tears(o.kind, o.binds)).then_some(before)
}

/// The operators of a run of tokens outside all brackets, if the run is a complete expression.
fn operators(program: &Program, unit: Extent) -> Option<Vec<MacroOperator>> {
    use TokenKind::*;
    let mut found = Vec::new();
    let mut open = 0_u32;
    let mut was_operand = false;
    for at in unit.first..=unit.last {
        let kind = program.token(at)?.kind;
        let is_closing = matches!(kind, RightParen | RightBracket);
        match kind {
            LeftParen | LeftBracket => open += 1,
            _ if is_closing => open = open.checked_sub(1)?,
            Semicolon | LeftBrace | RightBrace | End | Bad => return None,
            _ if open > 0 => continue,
            Plus | Minus | Not | Tilde | Increment | Decrement if !was_operand => continue,
            Increment | Decrement => {}
            Dot if was_operand => {}
            _ if ends_operand(kind) => {
                if was_operand {
                    return None;
                }
            }
            _ => found.push(MacroOperator {
                at,
                kind,
                binds: binding(kind).filter(|_| was_operand)?,
            }),
        }
        was_operand = ends_operand(kind);
    }
    (open == 0 && was_operand).then_some(found)
}

const fn ends_operand(kind: TokenKind) -> bool {
    use TokenKind::*;
    matches!(
        kind,
        Identifier
            | Int
            | Uint
            | Float
            | True
            | False
            | Type
            | RightParen
            | RightBracket
            | Increment
            | Decrement
    )
}

/// Precedence of `*`.
const PRODUCT: u8 = 12;

/// Precedence of a binary operator: higher binds tighter (GLSL ES 3.00 section 5.1).
const fn binding(kind: TokenKind) -> Option<u8> {
    use TokenKind::*;
    Some(match kind {
        Star | Slash | Percent => PRODUCT,
        Plus | Minus => 11,
        ShiftLeft | ShiftRight => 10,
        Less | Greater | LessEqual | GreaterEqual => 9,
        EqualEqual | NotEqual => 8,
        And => 7,
        Xor => 6,
        Or => 5,
        AndAnd => 4,
        XorXor => 3,
        OrOr => 2,
        Question | Colon => 1,
        _ => return None,
    })
}

/// Whether `a outer (b inner c)` equals `a outer b inner c`, apart from rounding.
const fn regroups(outer: TokenKind, inner: TokenKind) -> bool {
    use TokenKind::*;
    matches!(
        (outer, inner),
        (Plus, Plus | Minus)
            | (Star, Star | Slash)
            | (AndAnd, AndAnd)
            | (OrOr, OrOr)
            | (XorXor, XorXor)
            | (And, And)
            | (Or, Or)
            | (Xor, Xor)
            | (Question | Colon, _)
    )
}

fn report(cx: &mut Context, torn: Torn, count: usize) {
    let program = cx.program;
    let Some(definition) = program.tokens.macros.get(torn.call.definition) else {
        return;
    };
    let name = program.names.text(definition.name);
    let operator = program.token(torn.operator);
    let operator = operator.map_or("", |t| spelling(program, t));
    let unit: String = (torn.unit.first..=torn.unit.last)
        .filter_map(|t| program.token(t))
        .map(|t| spelling(program, t))
        .collect();
    let (message, title) = match torn.is_argument {
        true => (
            format!("macro `{name}` needs parentheses: `{operator}` splits its argument `{unit}`"),
            "add parentheses around each parameter in the macro body",
        ),
        false => (
            format!("macro `{name}` needs parentheses: `{operator}` splits its expansion `{unit}`"),
            "add parentheses around the macro body",
        ),
    };
    let place = definition.name_span;
    let fix = program
        .is_user(place)
        .then(|| edits(definition, torn.is_argument));
    let fix = fix.flatten().map(|e| Fix::suggestion(title, e));
    let mut finding = cx
        .report_span(torn.call.call, message)
        .label(place, "expands without parentheses");
    if count > 1 {
        finding = finding.note(format!("{count} calls of `{name}` are affected"));
    }
    finding.fix(fix);
}

/// Inserts parentheses around the macro body, or around its parameters.
fn edits(definition: &Macro, parameters: bool) -> Option<Vec<Edit>> {
    let body = &definition.body;
    let around = |first: &Token, last: &Token| {
        [
            Edit::insert(first.span.start, "("),
            Edit::insert(last.span.end, ")"),
        ]
    };
    if !parameters {
        let (first, last) = (body.first()?, body.last()?);
        return Some(around(&first.token, &last.token).to_vec());
    }
    let kind = |at: Option<usize>| at.and_then(|i| body.get(i)).map(|p| p.token.kind);
    let is_alone = |at: usize| {
        use TokenKind::{Comma, LeftParen, RightParen};
        matches!(kind(at.checked_sub(1)), Some(LeftParen | Comma))
            && matches!(kind(Some(at + 1)), Some(RightParen | Comma))
    };
    let parameters = body
        .iter()
        .enumerate()
        .filter(|(_, p)| !p.token.is_direct());
    let torn = parameters.filter(|(at, _)| !is_alone(*at));
    Some(torn.flat_map(|(_, p)| around(&p.token, &p.token)).collect())
}
