//! Fog that swallows everything.

use crate::diagnostic::{Fix, Severity};
use crate::lint::light::has_word;
use crate::lint::{Builtin, Check, Context, Group, Rule, RuleOption, Setting};
use crate::semantic::{BuiltinId, Program, VariableId};
use crate::syntax::ast::*;
use crate::text::Edit;

pub static RULE: Rule = Rule {
    name: "fog-unclamped",
    group: Group::Look,
    severity: Severity::Warning,
    default: false,
    options: &[RuleOption::Number(&MOST)],
    page: include_str!("fog_unclamped.md"),
    checks: &[Check::Builtin(check)],
};

static MOST: Setting<f64> = Setting::new("most", 0.7, "Thickest fog");

fn check(cx: &mut Context, call: &Builtin) {
    let (&[_, _, amount], BuiltinId::Mix) = (call.args, call.function) else {
        return;
    };
    let program = cx.program;
    let Some(variable) = program.variable_of(amount) else {
        return;
    };
    let name = program
        .variable(variable)
        .map_or("", |v| program.names.text(v.name));
    if !has_word(name, &["fog", "haze", "mist"]) || is_limited(program, variable) {
        return;
    }
    let most = cx.option(&MOST);
    let text = format!("clamp({}, 0.0, {most})", program.expr_text(amount));
    let extent = program.tree.expr(amount).extent;
    let fix = program.is_direct(extent).then(|| {
        let edit = Edit::replace(program.expr_span(amount), text.clone());
        Fix::suggestion(format!("write `{text}`"), vec![edit])
    });
    let finding = cx
        .report_expr(amount, format!("`{name}` is not limited"))
        .note("far away nothing is left but the fog's own colour");
    match fix {
        Some(fix) => finding.fix(fix),
        None => finding.help(format!("write `{text}`")),
    };
}

/// Whether a variable's value is limited where it is given.
fn is_limited(program: &Program, variable: VariableId) -> bool {
    let init = program.declarator_of(variable).and_then(|d| d.init);
    let mut values: Vec<ExprId> = init.into_iter().collect();
    for expr in &program.tree.exprs {
        if let ExprKind::Assign(_, target, value) = expr.kind
            && program.variable_of(target) == Some(variable)
        {
            values.push(value);
        }
    }
    // A parameter is given elsewhere.
    values.is_empty() || values.iter().any(|v| limits(program, *v))
}

fn limits(program: &Program, value: ExprId) -> bool {
    crate::lint::light::factors(program, value).iter().any(|f| {
        use BuiltinId::{Clamp, Min, Mix, Smoothstep};
        let function = program.builtin_called(*f);
        matches!(function, Some(Clamp | Min | Smoothstep | Mix))
    })
}
