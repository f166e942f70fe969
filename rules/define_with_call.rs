//! `#define SUN_DIR normalize(vec3(0.8, 0.4, -0.6))`.

use rustc_hash::FxHashMap;
use shaderlint_lint::prelude::*;

rule! { define_with_call, Tidy, Info, Strict, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    let macros = &program.tokens.macros;
    let is_candidate =
        |m: &&Macro| !m.predefined && m.params.is_none() && m.uses > 0 && holds_call(m);
    if !macros.iter().any(|m| is_candidate(&m)) {
        return;
    }
    let types = types(cx);
    for (i, definition) in macros.iter().enumerate() {
        let Some(&ty) = types.get(&(i as u32)) else {
            continue;
        };
        if !is_candidate(&definition) {
            continue;
        }
        let name = program.names.text(definition.name);
        let place = match definition.uses {
            1 => "where it is used".to_string(),
            uses => format!("at each of its {uses} uses"),
        };
        let fix = fix(cx, definition, ty);
        let type_name = program.type_name(ty);
        cx.report_span(
            definition.name_span,
            format!("`{name}` expands to a function call {place}"),
        )
        .note(format!(
            "the value is constant: a `const {type_name}` is evaluated once and checked at its \
            declaration"
        ))
        .fix(fix);
    }
}

/// Whether the body of a macro contains a function call.
fn holds_call(definition: &Macro) -> bool {
    let kinds: Vec<TokenKind> = definition.body.iter().map(|t| t.token.kind).collect();
    let call = [TokenKind::Identifier, TokenKind::LeftParen];
    kinds.windows(2).any(|pair| pair == call)
}

/// By index of a macro: the type of its expansion, if that is a complete call of a built-in
/// function with a constant value.
fn types(cx: &Context) -> FxHashMap<u32, Type> {
    let program = cx.program;
    let tokens = &program.tokens;
    let mut types = FxHashMap::default();
    for (i, expr) in program.tree.exprs.iter().enumerate() {
        let id = ExprId(i as u32);
        if !matches!(expr.kind, ExprKind::Call(..)) || !program.expr(id).is_const {
            continue;
        }
        let at = |t: u32| program.token(t).map(|t| t.expansion);
        let Some(expansion) = at(expr.extent.first) else {
            continue;
        };
        let Some(found) = tokens.expansions.get(expansion as usize) else {
            continue;
        };
        let before = expr.extent.first.checked_sub(1).and_then(at);
        let is_full_expansion = before != Some(expansion)
            && at(expr.extent.last + 1) != Some(expansion)
            && program.builtin_called(id).is_some();
        if is_full_expansion {
            types.insert(found.definition.0, program.ty(id));
        }
    }
    types
}

/// Replaces the `#define` with a constant.
fn fix(cx: &Context, definition: &Macro, ty: Type) -> Option<Fix> {
    let program = cx.program;
    let name = program.names.text(definition.name);
    let is_only = program
        .tokens
        .macros
        .iter()
        .filter(|m| m.name == definition.name)
        .count()
        == 1;
    let is_taken = program.variables.iter().any(|v| v.name == definition.name);
    if !is_only || is_taken || program.version != Version::Es300 {
        return None;
    }
    let (first, last) = (definition.body.first()?, definition.body.last()?);
    let value = first.token.span.to(last.token.span);
    let text = program.sources.text(value);
    let file = program.sources.file_at(definition.name_span.start)?;
    let before = file
        .text
        .get(..(definition.name_span.start - file.base) as usize)?;
    let hash = file.base + before.rfind('#')? as u32;
    if text.is_empty() || text.contains(['\n', '\\']) {
        return None;
    }
    let constant = format!("const {} {name} = {text};", program.type_name(ty));
    let edit = Edit::replace(Span::new(hash, value.end), constant);
    Some(Fix::suggestion(
        "replace the macro with a `const`",
        vec![edit],
    ))
}
