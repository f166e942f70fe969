//! `x > 0.5 && x < 0.2`, `k != 1 || k != 2`.

use shaderlint_lint::prelude::*;

rule! { contradiction, Tidy, Warning, Recommended, Binary(check) }

/// Longest chain of `&&` or `||` that is analysed.
const MAX_CHAIN: usize = 32;

/// One condition of a chain that compares a subject with a constant: the values for which it holds.
#[derive(Clone, Copy)]
struct Term {
    expr: ExprId,
    subject: ExprId,
    is: Set,
}

/// An interval of numbers with open or closed ends, or all numbers but one.
#[derive(Clone, Copy)]
struct Set {
    lo: f64,
    hi: f64,
    without_lo: bool,
    without_hi: bool,
    /// All numbers but `lo`, which equals `hi`.
    is_all_but: bool,
}

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let tree = &program.tree;
    let is_and = match e.op {
        BinaryOp::And => true,
        BinaryOp::Or => false,
        _ => return,
    };
    let is_op = |id: ExprId| matches!(tree.expr(id).kind, ExprKind::Binary(op, ..) if op == e.op);
    let is_inner = cx.facts.structure().parent(e.id).is_some_and(is_op);
    if is_inner || !cx.is_direct(e.id) {
        return;
    }
    let mut terms: Vec<Term> = Vec::new();
    for id in chain(tree, e) {
        // `a || b` fails where both fail.
        let Some(term) = term(program, id, is_and) else {
            continue;
        };
        let is_same = |other: &&Term| {
            let [a, b] = [other.subject, term.subject].map(|s| tree.expr(s).extent);
            same_code(program, a, b) && other.is.misses(&term.is)
        };
        let before = terms.iter().find(is_same).copied();
        terms.push(term);
        let Some(before) = before.filter(|_| !cx.facts.effects().has(term.subject)) else {
            continue;
        };
        if !is_and && is_test_for_nan(program, &before, &term) {
            continue;
        }
        report(cx, e.id, before.expr, id, is_and);
        return;
    }
}

fn report(cx: &mut Context, condition: ExprId, before: ExprId, term: ExprId, is_and: bool) {
    let program = cx.program;
    let [first, second] = [before, term].map(|t| program.expr_text(t).to_string());
    let (place, label) = (program.expr_span(before), program.expr_span(term));
    let message = match is_and {
        true => format!("`{first}` and `{second}` are never both true"),
        false => format!("`{first} || {second}` is always true"),
    };
    let other = if is_and { "||" } else { "&&" };
    cx.report_expr(condition, message)
        .label(place, "first condition")
        .label(label, "second condition")
        .help(format!("did you mean `{other}`?"));
}

/// The conditions of a chain, from left to right.
fn chain(tree: &Tree, e: &BinaryExpr) -> Vec<ExprId> {
    let mut all = vec![e.right];
    let mut at = e.left;
    while let ExprKind::Binary(op, left, right) = tree.expr(tree.unparen(at)).kind {
        if op != e.op || all.len() >= MAX_CHAIN {
            break;
        }
        all.push(right);
        at = left;
    }
    all.push(at);
    all.reverse();
    all
}

/// The set for which a comparison with a constant gives `truth`.
fn term(program: &Program, expr: ExprId, mut truth: bool) -> Option<Term> {
    let tree = &program.tree;
    let mut at = tree.unparen(expr);
    while let ExprKind::Unary(UnaryOp::Not, inner) = tree.expr(at).kind {
        at = tree.unparen(inner);
        truth = !truth;
    }
    let ExprKind::Binary(op, left, right) = tree.expr(at).kind else {
        return None;
    };
    let scalar = program
        .ty(left)
        .scalar_kind()
        .filter(|_| program.ty(left).is_scalar())?;
    let (subject, op, value) = match (program.scalar(left), program.scalar(right)) {
        (None, Some(value)) => (left, op, value),
        (Some(value), None) => (right, flipped(op), value),
        _ => return None,
    };
    let op = if truth { op } else { negated(op)? };
    let set = Set::of(op, value.as_number())?;
    let is = match scalar {
        Scalar::Int | Scalar::Uint => set.of_integers(),
        _ => set,
    };
    Some(Term {
        expr,
        subject: tree.unparen(subject),
        is,
    })
}

/// Whether two conditions cover every number and fail only for NaN: `x < 0.0 || x >= 0.0`.
fn is_test_for_nan(program: &Program, a: &Term, b: &Term) -> bool {
    let is_float = program.ty(a.subject).scalar_kind() == Some(Scalar::Float);
    // Both are negated already.
    is_float
        && !(a.is.is_single() && b.is.is_single())
        && (a.is.lo == b.is.hi || a.is.hi == b.is.lo)
}

impl Set {
    fn of(op: BinaryOp, value: f64) -> Option<Set> {
        let (below, above) = (f64::NEG_INFINITY, f64::INFINITY);
        let (lo, hi) = match op {
            BinaryOp::Less | BinaryOp::LessEqual => (below, value),
            BinaryOp::Greater | BinaryOp::GreaterEqual => (value, above),
            BinaryOp::Equal | BinaryOp::NotEqual => (value, value),
            _ => return None,
        };
        Some(Set {
            lo,
            hi,
            without_lo: op == BinaryOp::Greater,
            without_hi: op == BinaryOp::Less,
            is_all_but: op == BinaryOp::NotEqual,
        })
    }

    /// The same set of integers with closed ends: `x > 1` is `x >= 2`.
    fn of_integers(self) -> Set {
        Set {
            lo: if self.without_lo {
                self.lo + 1.0
            } else {
                self.lo
            },
            hi: if self.without_hi {
                self.hi - 1.0
            } else {
                self.hi
            },
            without_lo: false,
            without_hi: false,
            ..self
        }
    }

    fn is_single(&self) -> bool {
        self.lo == self.hi && !self.is_all_but
    }

    /// Whether the two sets have no number in common.
    fn misses(&self, other: &Set) -> bool {
        match (self.is_all_but, other.is_all_but) {
            (true, true) => false,
            (true, false) => other.is_single() && other.lo == self.lo,
            (false, true) => self.is_single() && self.lo == other.lo,
            (false, false) => self.ends_before(other) || other.ends_before(self),
        }
    }

    fn ends_before(&self, other: &Set) -> bool {
        let is_open = self.without_hi || other.without_lo;
        self.hi < other.lo || (self.hi == other.lo && is_open)
    }
}

fn flipped(op: BinaryOp) -> BinaryOp {
    match op {
        BinaryOp::Less => BinaryOp::Greater,
        BinaryOp::LessEqual => BinaryOp::GreaterEqual,
        BinaryOp::Greater => BinaryOp::Less,
        BinaryOp::GreaterEqual => BinaryOp::LessEqual,
        op => op,
    }
}

fn negated(op: BinaryOp) -> Option<BinaryOp> {
    Some(match op {
        BinaryOp::Less => BinaryOp::GreaterEqual,
        BinaryOp::LessEqual => BinaryOp::Greater,
        BinaryOp::Greater => BinaryOp::LessEqual,
        BinaryOp::GreaterEqual => BinaryOp::Less,
        BinaryOp::Equal => BinaryOp::NotEqual,
        BinaryOp::NotEqual => BinaryOp::Equal,
        _ => return None,
    })
}
