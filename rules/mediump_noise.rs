//! Hashes and time in half precision.

use crate::diagnostic::Severity;
use crate::lint::light::{factors, has_word};
use crate::lint::{Check, Context, Group, Rule, RuleOption, Setting};
use crate::semantic::{BuiltinId, Program, Scalar, Stage, Storage};
use crate::syntax::TypeWord;
use crate::syntax::ast::*;
use crate::text::Span;

pub static RULE: Rule = Rule {
    name: "mediump-noise",
    group: Group::Portability,
    severity: Severity::Warning,
    default: true,
    options: &[RuleOption::Number(&FACTOR)],
    page: include_str!("mediump_noise.md"),
    checks: &[Check::Program(check)],
};

static FACTOR: Setting<f64> = Setting::new(
    "factor",
    1000.0,
    "Smallest factor before a `fract` that makes it a hash",
);

fn check(cx: &mut Context) {
    let program = cx.program;
    if program.stage != Stage::Fragment {
        return;
    }
    let mut precision: Option<(QualifierKind, Extent)> = None;
    for item in &program.tree.items {
        let Item::Decl(id) = item else { continue };
        if let Some(decl) = program.tree.decl(*id)
            && let DeclKind::Precision {
                precision: kind,
                ty,
            } = decl.kind
            && program.tree.ty(ty).base == TypeBase::Word(TypeWord::Float)
        {
            precision = Some((kind, decl.extent));
        }
    }
    let Some((QualifierKind::Mediump | QualifierKind::Lowp, extent)) = precision else {
        return;
    };
    let Some((place, what)) = hash(cx).or_else(|| time(program)) else {
        return;
    };
    cx.report(extent, format!("too few digits for {what}"))
        .label(place, "it stands here")
        .note("on phones it has 10 bits behind the point: noise turns into stripes, and time stands still after seconds")
        .help("write `precision highp float;`");
}

/// `fract(x * 43758.5453)`
fn hash(cx: &Context) -> Option<(Span, &'static str)> {
    let program = cx.program;
    let limit = cx.option(&FACTOR);
    let exprs = program.tree.exprs.iter().enumerate();
    let mut fracts = exprs.filter_map(|(i, e)| match e.kind {
        ExprKind::Call(_, args) => {
            let id = ExprId(i as u32);
            let is_fract = program.builtin_called(id) == Some(BuiltinId::Fract);
            is_fract.then_some((id, *program.tree.args(args).first()?))
        }
        _ => None,
    });
    let found = fracts.find(|(_, arg)| {
        factors(program, *arg).iter().any(|f| {
            let value = program.scalar(*f);
            value.is_some_and(|v| v.as_float().abs() as f64 >= limit)
        })
    });
    found.map(|(id, _)| (program.expr_span(id), "a hash"))
}

/// A uniform that counts the seconds.
fn time(program: &Program) -> Option<(Span, &'static str)> {
    let used = program.variables.iter().find(|v| {
        let is_number = v.ty.scalar_kind() == Some(Scalar::Float) && v.ty.components() == 1;
        let name = program.names.text(v.name);
        v.storage == Storage::Uniform && v.read && is_number && has_word(name, &["time", "seconds"])
    })?;
    let token = program.token(used.token?)?;
    Some((token.span, "a time that runs on"))
}
