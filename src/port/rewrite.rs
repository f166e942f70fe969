//! Rewrites `mainImage` as the `main` of a plain WebGL2 shader: the first parameter becomes the
//! output variable, the second `gl_FragCoord.xy`.
//!
//! The rewrite is used only if it provably draws the same image: the result is checked again, and
//! its `main` is proved to be equivalent to `mainImage` for all inputs. `--verify` compares pixels,
//! which shows equality only for the samples. Otherwise the reason is reported, and the pass keeps
//! the player's header.

use super::glsl::signed;
use super::{Composed, PassUnit, Project, Wrapper};
use shaderlint_explain::analyze_alone;
use shaderlint_flow::{Effects, ImageEntry, ShaderVersion, is_equivalent};
use shaderlint_ir::lower;
use shaderlint_semantic::{FunctionRef, Pass, Program, Stage, builtins::Builtins};
use shaderlint_syntax::ast::{
    Expr, ExprId, ExprKind, Extent, FunctionDecl, Param, QualifierKind, StmtKind, TokenId, TypeBase,
};
use shaderlint_text::{Edit, Role, Span, apply_edits};

/// Why a pass cannot be rewritten.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NotSafe {
    /// The span of the cause; empty if there is none.
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

/// The fragment shader of a pass, with `mainImage` rewritten as `main`.
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
    let rewriting = Rewriting::of(program, &main, unit.kind)?;
    let edits = &rewriting.edits;
    check_macros(program, &main, edits)?;
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
    let own = own.ok_or_else(|| not_safe(main.header, "`mainImage` is in Common"))?;
    let changed = apply_edits(&own.text, own.base, edits)
        .map_err(|_| not_safe(main.header, "the edits overlap"))?;
    text.push_str(&changed);
    prove(program, &main, &rewriting, &text)?;
    Ok(signed(project, text))
}

/// Checks the rewritten shader and proves that it is equivalent to the pass.
fn prove(program: &Program, main: &Main, how: &Rewriting, text: &str) -> Result<(), NotSafe> {
    let made = analyze_alone(text.to_string(), Role::User);
    let made = made.ok_or_else(|| not_safe(main.header, "the shader is too large"))?;
    if let Some(problem) = made.diagnostics.first() {
        let message = format!("the rewritten shader does not compile: {}", problem.message);
        return Err(not_safe(main.header, message));
    }
    let modules = [lower(program), lower(&made.program)];
    let effects = Effects::default();
    let [before, after] = [program, &made.program];
    let version = |program, module, entry| ShaderVersion {
        program,
        module,
        effects: &effects,
        entry,
    };
    let entry = main_image(program, main).map(|function| ImageEntry {
        function,
        is_cleared: how.clears,
        is_opaque: how.is_opaque,
    });
    let is_proved = entry.is_some() && {
        let [ours, theirs] = &modules;
        is_equivalent(version(before, ours, entry), version(after, theirs, None))
    };
    match is_proved {
        true => Ok(()),
        false => Err(not_safe(main.header, "equivalence could not be proved")),
    }
}

/// `mainImage` among the functions of the shader.
fn main_image(program: &Program, main: &Main) -> Option<FunctionRef> {
    let is_it = |id: &FunctionRef| {
        let function = program.function(*id);
        let definition = function.and_then(|f| program.tree.function(f.definition?));
        definition.is_some_and(|d| d.ident.token == main.decl.ident.token)
    };
    (0..program.functions.len() as u32)
        .map(FunctionRef)
        .find(is_it)
}

/// The declaration of `mainImage`.
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
        return Err(not_safe(header, "`mainImage` has unexpected parameters"));
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
        return Err(not_safe(header, "a macro defines `mainImage`"));
    }
    let plain = |p: &Param, allowed: &[QualifierKind]| {
        tree.qualifiers(p.qualifiers)
            .iter()
            .all(|q| allowed.contains(&q.kind))
            && p.arrays.len == 0
            && matches!(tree.ty(p.ty).base, TypeBase::Word(_))
    };
    if !plain(color, &[QualifierKind::Out]) || !plain(coord, &[QualifierKind::In]) {
        return Err(not_safe(header, "`mainImage` has unexpected parameters"));
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

/// Checks that the names that become global are not used otherwise.
fn check_names(program: &Program, main: &Main) -> Result<(), NotSafe> {
    let name = program.names.get(main.color_name);
    let in_user_text =
        |token: Option<TokenId>| token.and_then(|t| program.token(t)).map(|t| t.span);
    for variable in &program.variables {
        if Some(variable.name) == name && variable.function.is_none() {
            let span = in_user_text(variable.token).unwrap_or(main.header);
            let message = format!("`{}` is already a global variable", main.color_name);
            return Err(not_safe(span, message));
        }
    }
    let is_taken = program.functions.iter().any(|f| Some(f.name) == name)
        || program.structs.iter().any(|s| s.name == name)
        || Builtins::of(program.version, Stage::Fragment)
            .function(main.color_name)
            .is_some();
    if is_taken {
        let message = format!("`{}` is already a function or struct", main.color_name);
        return Err(not_safe(main.header, message));
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
            "the code calls `mainImage` or `st_assert`",
        ));
    }
    Ok(())
}

/// Checks that inserted names are not macros, and that `__LINE__` is not used.
fn check_macros(program: &Program, main: &Main, edits: &[Edit]) -> Result<(), NotSafe> {
    let words: Vec<&str> = edits
        .iter()
        .flat_map(|e| e.text.split(|c: char| !c.is_alphanumeric() && c != '_'))
        .collect();
    for definition in &program.tokens.macros {
        let name = program.names.text(definition.name);
        if name == "__LINE__" && definition.predefined && definition.uses > 0 {
            let message = "`__LINE__` would change";
            return Err(not_safe(main.header, message));
        }
        if !definition.predefined && words.contains(&name) {
            return Err(not_safe(
                definition.name_span,
                format!("`{name}` is a macro"),
            ));
        }
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

/// The edits that turn `mainImage` into `main`.
struct Rewriting {
    edits: Vec<Edit>,
    /// Whether the output is set to zero at the start.
    clears: bool,
    /// Whether alpha is set to 1.0 at the end.
    is_opaque: bool,
}

impl Rewriting {
    fn of(program: &Program, main: &Main, kind: Pass) -> Result<Rewriting, NotSafe> {
        let is_opaque = kind == Pass::Image;
        let jump = jump_of(program, main);
        if let (true, Some(jump)) = (is_opaque, jump) {
            let message = "early return skips ShaderToy's opaque alpha";
            return Err(not_safe(program.span(jump), message));
        }
        // A component of the output that is read before it is written is 0, as in a parameter.
        let clears = !is_only_assigned(program, main)
            || jump.is_some()
            || !is_assigned_at_last(program, main);
        let mut start = String::new();
        if clears {
            start.push_str(&format!("\n    {} = vec4(0.0);", main.color_name));
        }
        let mut edits = vec![Edit::replace(main.header, "void main()")];
        let coord = main.coord.ident.map(|i| i.token);
        let coord = program.variables.iter().find(|v| v.token == coord);
        let uses = coord.filter(|c| !c.written);
        let uses = uses.and_then(|_| direct_uses(program, main));
        let has_local = uses.is_none();
        for span in uses.into_iter().flatten() {
            edits.push(Edit::replace(span, "gl_FragCoord.xy"));
        }
        if has_local {
            let name = main.coord_name;
            start.push_str(&format!("\n    vec2 {name} = gl_FragCoord.xy;"));
        }
        if !start.is_empty() {
            edits.push(Edit::insert(main.open.end, start));
        }
        if is_opaque {
            let end = format!("    {}.a = 1.0;\n", main.color_name);
            let text = match tree_line_start(program, main.close) {
                true => end,
                false => format!("\n{end}"),
            };
            edits.push(Edit::insert(main.close.start, text));
        }
        Ok(Rewriting {
            edits,
            clears,
            is_opaque,
        })
    }
}

/// The first `return` in `mainImage`.
fn jump_of(program: &Program, main: &Main) -> Option<Extent> {
    let tree = &program.tree;
    let body = tree.stmt(main.decl.body?).extent;
    let mut jumps = tree.stmts.iter().filter(|s| {
        let extent = s.extent;
        matches!(s.kind, StmtKind::Return(_))
            && body.first <= extent.first
            && extent.last <= body.last
    });
    jumps.next().map(|s| s.extent)
}

/// Whether an expression is the output.
fn is_color(program: &Program, main: &Main, id: ExprId) -> bool {
    let variable = program.variable_of(id).and_then(|v| program.variable(v));
    variable.is_some_and(|v| v.token == main.color.ident.map(|i| i.token))
}

/// Whether a top-level statement of the body assigns the complete output.
fn is_assigned_at_last(program: &Program, main: &Main) -> bool {
    let tree = &program.tree;
    let Some(StmtKind::Block(body)) = main.decl.body.map(|b| tree.stmt(b).kind) else {
        return false;
    };
    tree.block(body).iter().any(|id| match tree.stmt(*id).kind {
        StmtKind::Expr(expr) => {
            matches!(tree.expr(expr).kind, ExprKind::Assign(None, to, _) if is_color(program, main, to))
        }
        _ => false,
    })
}

/// Whether every use of the output is an assignment of all its components.
fn is_only_assigned(program: &Program, main: &Main) -> bool {
    let exprs = &program.tree.exprs;
    let is_name = |i: &usize| {
        let id = ExprId(*i as u32);
        matches!(program.tree.expr(id).kind, ExprKind::Name(_)) && is_color(program, main, id)
    };
    let uses = (0..exprs.len()).filter(is_name).count();
    let is_assigned =
        |e: &&Expr| matches!(e.kind, ExprKind::Assign(None, to, _) if is_color(program, main, to));
    uses == exprs.iter().filter(is_assigned).count()
}

/// Whether a position is the first on its line.
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

/// The uses of the second parameter; `None` if one comes from a macro, so that the name must be
/// kept.
fn direct_uses(program: &Program, main: &Main) -> Option<Vec<Span>> {
    let ident = main.coord.ident?;
    let id = (0..)
        .map(shaderlint_semantic::VariableId)
        .take(program.variables.len());
    let id = id.into_iter().find(|id| {
        program
            .variable(*id)
            .is_some_and(|v| v.token == Some(ident.token))
    })?;
    let mut spans = Vec::new();
    for (expr, info) in program.tree.exprs.iter().zip(&program.exprs) {
        if info.resolution != shaderlint_semantic::Resolution::Variable(id) {
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

/// Version, precisions, the uniforms that the code mentions, and the output.
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

#[cfg(test)]
mod tests {
    use crate::{Project, rewrite};
    use shaderlint_text::each_case;

    /// The rewritten Image pass, or the reason why it was not rewritten.
    fn rewritten(code: &str) -> Result<String, String> {
        let mut project = Project::draft("", code, None).unwrap();
        let composed = project.resolve("").unwrap();
        rewrite(&project, &composed, &composed.units[0]).map_err(|e| e.message)
    }

    #[test]
    fn equivalent_main_functions_are_rewritten() {
        each_case(include_str!("rewrites.txt"), |code, expected| {
            let text = rewritten(&format!("{code}\n"));
            let is_whole = text.as_ref().is_ok_and(|t| t.contains("void main()"));
            let found = text.map_or_else(|reason| reason, |_| "rewritten".to_string());
            assert_eq!(
                (found.as_str(), is_whole),
                (expected, expected == "rewritten"),
                "{code}"
            );
        });
    }
}
