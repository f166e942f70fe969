//! `mainImage` as the `main` of a plain WebGL2 shader: its first parameter becomes the output
//! variable, its second `gl_FragCoord.xy`.
//!
//! That is done only where it draws the same picture; everywhere else the reason is told, and the
//! pass stays behind the player's header.

use super::glsl::signed;
use super::{Composed, PassUnit, Project, Wrapper};
use crate::semantic::{Pass, Program, Stage, builtins::Builtins};
use crate::syntax::ast::{
    Expr, ExprId, ExprKind, FunctionDecl, Param, QualifierKind, StmtKind, TokenId, TypeBase,
};
use crate::text::{Edit, Role, Span, apply_edits};

/// Why a pass cannot be rewritten.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NotSafe {
    /// Where the reason stands; empty where it stands nowhere.
    pub span: Span,
    /// The reason.
    pub message: String,
}

fn not_safe(span: Span, message: impl Into<String>) -> NotSafe {
    NotSafe {
        span,
        message: message.into(),
    }
}

/// The fragment shader of a pass, with `mainImage` made `main`.
pub fn rewrite(project: &Project, composed: &Composed, unit: &PassUnit) -> Result<String, NotSafe> {
    if unit.wrapper == Wrapper::Own {
        return Err(not_safe(Span::default(), "the pass has its own `main`"));
    }
    if !matches!(unit.kind, Pass::Image | Pass::Buffer) {
        return Err(not_safe(
            Span::default(),
            "only `mainImage` can be rewritten",
        ));
    }
    let analysis = composed.analysis(unit);
    if let Some(first) = analysis.diagnostics.first() {
        return Err(not_safe(first.span, "the pass does not compile"));
    }
    let program = &analysis.program;
    let main = find_main(program)?;
    check_names(program, &main)?;
    let edits = edits(program, &main, unit.kind)?;
    let (last, before) = unit
        .files
        .split_last()
        .ok_or_else(|| not_safe(Span::default(), "the pass has no code"))?;
    let mut text = header(composed, unit, &main);
    for file in before {
        if let Some(file) = composed.sources.file(*file)
            && file.role == Role::User
        {
            text.push_str(&file.text);
            text.push('\n');
        }
    }
    let own = composed.sources.file(*last);
    let own = own.filter(|f| {
        edits
            .iter()
            .all(|e| f.base <= e.span.start && e.span.end <= f.span().end)
    });
    let own = own.ok_or_else(|| not_safe(main.header, "`mainImage` stands in Common"))?;
    let changed = apply_edits(&own.text, own.base, &edits)
        .map_err(|_| not_safe(main.header, "its parts overlap"))?;
    text.push_str(&changed);
    Ok(signed(project, text))
}

/// What is known of `mainImage`.
struct Main<'a> {
    decl: &'a FunctionDecl,
    color: Param,
    coord: Param,
    color_name: &'a str,
    coord_name: &'a str,
    header: Span,
    open: Span,
    close: Span,
}

fn find_main<'a>(program: &'a Program) -> Result<Main<'a>, NotSafe> {
    let tree = &program.tree;
    let name = program.names.get("mainImage");
    let is_user = |d: &FunctionDecl| {
        let at = program.span(d.header).start;
        program
            .sources
            .file_at(at)
            .is_some_and(|f| f.role == Role::User)
    };
    let all: Vec<&FunctionDecl> = tree
        .functions
        .iter()
        .filter(|d| Some(d.ident.name) == name && is_user(d))
        .collect();
    let [decl] = all[..] else {
        return Err(not_safe(
            Span::default(),
            "`mainImage` is declared more than once",
        ));
    };
    let header = program.span(decl.header);
    let [color, coord] = tree.params(decl.params) else {
        return Err(not_safe(header, "`mainImage` has other parameters"));
    };
    let (Some(color_ident), Some(coord_ident), Some(body)) = (color.ident, coord.ident, decl.body)
    else {
        return Err(not_safe(header, "a parameter of `mainImage` has no name"));
    };
    let body = tree.stmt(body).extent;
    let is_direct = [body.first, body.last]
        .iter()
        .all(|t| program.token(*t).is_some_and(|t| t.is_direct()));
    if !program.is_direct(decl.header) || !is_direct {
        return Err(not_safe(header, "a macro makes `mainImage`"));
    }
    let plain = |p: &Param, wanted: &[QualifierKind]| {
        tree.qualifiers(p.qualifiers)
            .iter()
            .all(|q| wanted.contains(&q.kind))
            && p.arrays.len == 0
            && matches!(tree.ty(p.ty).base, TypeBase::Word(_))
    };
    if !plain(color, &[QualifierKind::Out]) || !plain(coord, &[QualifierKind::In]) {
        return Err(not_safe(header, "`mainImage` has unusual qualifiers"));
    }
    let span_of = |token: TokenId| program.token(token).map_or(Span::default(), |t| t.span);
    Ok(Main {
        decl,
        color: *color,
        coord: *coord,
        color_name: program.names.text(color_ident.name),
        coord_name: program.names.text(coord_ident.name),
        header,
        open: span_of(body.first),
        close: span_of(body.last),
    })
}

/// Nothing else may go by the names that become global.
fn check_names(program: &Program, main: &Main) -> Result<(), NotSafe> {
    let name = program.names.get(main.color_name);
    let in_user_text =
        |token: Option<TokenId>| token.and_then(|t| program.token(t)).map(|t| t.span);
    for variable in &program.variables {
        if Some(variable.name) == name && variable.function.is_none() {
            let span = in_user_text(variable.token).unwrap_or(main.header);
            let message = format!("`{}` is a global name already", main.color_name);
            return Err(not_safe(span, message));
        }
    }
    let is_taken = program.functions.iter().any(|f| Some(f.name) == name)
        || program.structs.iter().any(|s| s.name == name)
        || Builtins::of(program.version, Stage::Fragment)
            .function(main.color_name)
            .is_some();
    if is_taken {
        let message = format!("`{}` is the name of something else too", main.color_name);
        return Err(not_safe(main.header, message));
    }
    for word in [
        "main",
        "void",
        "gl_FragCoord",
        "out",
        "vec4",
        "vec2",
        "highp",
    ] {
        let macros = &program.tokens.macros;
        let is_macro = macros.iter().find(|m| program.names.text(m.name) == word);
        if is_macro.is_some() {
            return Err(not_safe(main.header, format!("`{word}` is a macro")));
        }
    }
    let functions = &program.functions;
    let called = program.calls.iter().find(|c| {
        let callee = functions.get(c.callee.0 as usize);
        callee.is_some_and(|f| matches!(program.names.text(f.name), "mainImage" | "st_assert"))
            && program.span(program.tree.expr(c.expr).extent).start >= first_user(program)
    });
    if let Some(call) = called {
        return Err(not_safe(
            program.expr_span(call.expr),
            "the player's functions are called",
        ));
    }
    Ok(())
}

/// The address of the first text of the user.
fn first_user(program: &Program) -> u32 {
    let files = program.sources.files();
    files
        .iter()
        .find(|f| f.role == Role::User)
        .map_or(0, |f| f.base)
}

/// The edits that make `mainImage` the `main`.
fn edits(program: &Program, main: &Main, kind: Pass) -> Result<Vec<Edit>, NotSafe> {
    let tree = &program.tree;
    let body = main.decl.body.map(|b| tree.stmt(b));
    let inside = |extent: crate::syntax::ast::Extent| {
        body.is_some_and(|b| b.extent.first <= extent.first && extent.last <= b.extent.last)
    };
    let mut start = String::new();
    let mut end = String::new();
    if kind == Pass::Image {
        let jump = tree
            .stmts
            .iter()
            .find(|s| matches!(s.kind, StmtKind::Return(_)) && inside(s.extent));
        if let Some(jump) = jump {
            let message = "it returns early, and ShaderToy makes the picture opaque at the end";
            return Err(not_safe(program.span(jump.extent), message));
        }
        end = format!("    {}.a = 1.0;\n", main.color_name);
    }
    let variable = |param: &Param| {
        let at = param.ident?.token;
        program.variables.iter().find(|v| v.token == Some(at))
    };
    // A part of the output that is read before it is written is 0, as in a parameter.
    if !is_only_assigned(program, main) {
        start.push_str(&format!("\n    {} = vec4(0.0);", main.color_name));
    }
    let mut edits = vec![Edit::replace(main.header, "void main()")];
    match variable(&main.coord) {
        Some(coord) if !coord.written => match direct_uses(program, main) {
            Some(uses) => edits.extend(
                uses.into_iter()
                    .map(|s| Edit::replace(s, "gl_FragCoord.xy")),
            ),
            None => start.push_str(&format!(
                "\n    vec2 {} = gl_FragCoord.xy;",
                main.coord_name
            )),
        },
        _ => start.push_str(&format!(
            "\n    vec2 {} = gl_FragCoord.xy;",
            main.coord_name
        )),
    }
    if !start.is_empty() {
        edits.push(Edit::insert(main.open.end, start));
    }
    if !end.is_empty() {
        let line = tree_line_start(program, main.close);
        let text = if line { end } else { format!("\n{end}") };
        edits.push(Edit::insert(main.close.start, text));
    }
    Ok(edits)
}

/// Whether every use of the output gives all of it a value.
fn is_only_assigned(program: &Program, main: &Main) -> bool {
    let token = main.color.ident.map(|i| i.token);
    let is_color = |id: ExprId| {
        let variable = program.variable_of(id).and_then(|v| program.variable(v));
        variable.is_some_and(|v| v.token == token)
    };
    let exprs = &program.tree.exprs;
    let is_name = |i: &usize| {
        let id = ExprId(*i as u32);
        matches!(program.tree.expr(id).kind, ExprKind::Name(_)) && is_color(id)
    };
    let uses = (0..exprs.len()).filter(is_name).count();
    let is_assigned = |e: &&Expr| matches!(e.kind, ExprKind::Assign(None, to, _) if is_color(to));
    uses == exprs.iter().filter(is_assigned).count()
}

/// Whether only blanks stand before a place on its line.
fn tree_line_start(program: &Program, span: Span) -> bool {
    let Some(file) = program.sources.file_at(span.start) else {
        return false;
    };
    let before = file
        .text
        .get(..(span.start - file.base) as usize)
        .unwrap_or("");
    before
        .rsplit(['\n', '\r'])
        .next()
        .is_some_and(|line| line.is_empty())
}

/// The uses of the second parameter; `None` where one comes through a macro, so that the name must
/// stay.
fn direct_uses(program: &Program, main: &Main) -> Option<Vec<Span>> {
    let ident = main.coord.ident?;
    let id = (0..)
        .map(crate::semantic::VariableId)
        .take(program.variables.len());
    let id = id.into_iter().find(|id| {
        program
            .variable(*id)
            .is_some_and(|v| v.token == Some(ident.token))
    })?;
    let mut spans = Vec::new();
    for (expr, info) in program.tree.exprs.iter().zip(&program.exprs) {
        if info.resolution != crate::semantic::Resolution::Variable(id) {
            continue;
        }
        if !matches!(expr.kind, ExprKind::Name(_)) {
            continue;
        }
        let token = program.token(expr.extent.first)?;
        if !token.is_direct() {
            return None;
        }
        spans.push(token.span);
    }
    Some(spans)
}

/// Version, precisions, the uniforms that the code names, and the output.
fn header(composed: &Composed, unit: &PassUnit, main: &Main) -> String {
    let prelude = unit.files.first().and_then(|f| composed.sources.file(*f));
    let mut text = String::from(
        "#version 300 es\nprecision highp float;\nprecision highp int;\n\
         precision mediump sampler3D;\n#define HW_PERFORMANCE 1\n",
    );
    let users: Vec<&str> = unit
        .files
        .iter()
        .filter_map(|f| composed.sources.file(*f))
        .filter(|f| f.role == Role::User)
        .map(|f| &*f.text)
        .collect();
    for line in prelude.map_or("", |p| &*p.text).lines() {
        let Some(rest) = line.strip_prefix("uniform ") else {
            continue;
        };
        let name = rest.rsplit(' ').next().unwrap_or("");
        let name = name.split(['[', ';']).next().unwrap_or("");
        if users.iter().any(|text| text.contains(name)) {
            text.push_str(line);
            text.push('\n');
        }
    }
    text.push_str(&format!("out vec4 {};\n\n", main.color_name));
    text
}
