//! Repairs of old ShaderToy code that depend on the player: fixes for errors that the language
//! alone cannot resolve.
//!
//! Each is attached to the error that it fixes, so that the same engine applies these and the fixes
//! of the errors themselves.

mod choice;

use super::dialect::PLACES;
use choice::choice;
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix, error};
use shaderlint_semantic::{EntryResult, Program, Scalar, Type, globals};
use shaderlint_syntax::ast::{
    DeclKind, ExprId, ExprKind, FunctionDecl, Item, Param, QualifierKind, TokenId, TypeBase,
};
use shaderlint_text::{Edit, Role, Span};

/// Attaches repairs to the errors of a pass.
pub fn add_repairs(program: &Program, errors: &mut [Diagnostic]) {
    let mut globals = None;
    for index in 0..errors.len() {
        let Some(found) = errors.get(index) else {
            return;
        };
        let Some(kind) = found.kind else { continue };
        let fix = match kind {
            // The language objects to the name, so renaming is the only fix.
            error::BUILTIN_REDEFINITION => found.fix.clone().map(|fix| Fix {
                applicability: Applicability::Safe,
                edits: own_uses(program, fix.edits),
                ..fix
            }),
            error::LEGACY_GLSL => match program.sources.text(found.span) {
                "varying" => varying(program, found.span).or_else(|| found.fix.clone()),
                _ => continue,
            },
            error::INVALID_QUALIFIER => initial(program, found.span),
            error::INVALID_LAYOUT => layout(program, found.span),
            error::UNSUPPORTED_OPERATION => choice(program, found.span),
            error::MAINIMAGE_SIGNATURE => signature(program, found.span),
            error::NOT_CONSTANT if globals.is_none() => {
                globals = late_values(program, errors);
                globals.clone()
            }
            _ => continue,
        };
        if let (Some(error), Some(fix)) = (errors.get_mut(index), fix) {
            error.fix = Some(fix);
        }
    }
}

/// The edits of a name that are of the shader's own functions: desktop GLSL lets them overload built-in ones.
fn own_uses(program: &Program, edits: Vec<Edit>) -> Vec<Edit> {
    let tree = &program.tree;
    // The checker rejects these functions, so that their types are taken from the text.
    let types = |function: &FunctionDecl| {
        let params = tree.params(function.params).iter();
        let types = params.map(|param| match tree.ty(param.ty).base {
            TypeBase::Word(word) => Type::of_word(word),
            _ => Type::ERROR,
        });
        types.collect::<Vec<Type>>()
    };
    let takes = |params: &[Type], args: &[ExprId]| {
        let fits = |(param, arg): (&Type, &ExprId)| {
            let ty = program.expr(*arg).ty;
            let is_whole = ty.scalar_kind() == Some(Scalar::Int);
            let is_unknown = ty.is_error() || param.is_error();
            *param == ty || is_unknown || is_whole && param.components() == ty.components()
        };
        params.len() == args.len() && params.iter().zip(args).all(fits)
    };
    let mut foreign = Vec::new();
    for expr in &tree.exprs {
        let ExprKind::Call(name, args) = expr.kind else {
            continue;
        };
        let own = tree.functions.iter().filter(|f| f.ident.name == name);
        let mut params = own.map(types);
        let args = tree.args(args);
        if !params.any(|params| takes(&params, args)) {
            foreign.extend(program.token(expr.extent.first).map(|t| t.spelled));
        }
    }
    let is_own = |edit: &Edit| !foreign.contains(&edit.span.start);
    edits.into_iter().filter(is_own).collect()
}

/// The entry function of the user: the one that the player calls, or `main`, or else the one that the
/// `main` of the host calls.
fn entry(program: &Program) -> Option<&FunctionDecl> {
    let name = program
        .dialect
        .host()
        .entry
        .map_or("main", |entry| entry.name);
    let name = program.names.get(name)?;
    let functions = &program.tree.functions;
    let is_own = |f: &&FunctionDecl| f.body.is_some() && is_user(program, program.span(f.header));
    let mut named = functions.iter().filter(|f| f.ident.name == name);
    if let Some(own) = named.clone().find(is_own) {
        return Some(own);
    }
    let main = named.next_back()?.extent;
    let calls = program
        .tree
        .exprs
        .iter()
        .filter(|e| main.contains(e.extent));
    let called = calls.filter_map(|e| match e.kind {
        ExprKind::Call(name, _) => Some(name),
        _ => None,
    });
    called.into_iter().find_map(|name| {
        let mut own = functions.iter().filter(is_own);
        own.find(|f| f.ident.name == name)
    })
}

fn is_user(program: &Program, span: Span) -> bool {
    let file = program.sources.file_at(span.start);
    file.is_some_and(|f| f.role == Role::User)
}

fn span_of(program: &Program, token: TokenId) -> Option<Span> {
    let token = program.token(token)?;
    token.is_direct().then_some(token.span)
}

/// Removes a `layout` that desktop GLSL accepts and WebGL2 does not: the stages match by name.
fn layout(program: &Program, at: Span) -> Option<Fix> {
    let all = globals(program).flat_map(|(qualifiers, _)| qualifiers);
    let found = all
        .filter(|q| matches!(q.kind, QualifierKind::Layout(_)))
        .find(|q| program.span(q.extent).contains(at))?;
    let next = span_of(program, found.extent.last + 1)?;
    let removed = Span::new(program.span(found.extent).start, next.start);
    let is_complete = program.is_direct(found.extent);
    is_complete.then(|| Fix::safe("remove the `layout` qualifier", vec![Edit::delete(removed)]))
}

/// Removes the initial value of a uniform, which desktop GLSL accepts: the page has a control with
/// that initial value.
fn initial(program: &Program, at: Span) -> Option<Fix> {
    let (_, declarator) = globals(program).find(|(qualifiers, d)| {
        let is_uniform = qualifiers.iter().any(|q| q.kind == QualifierKind::Uniform);
        is_uniform && d.init.is_some() && program.span(d.extent) == at
    })?;
    let sizes = program.tree.arrays(declarator.arrays);
    let last = sizes
        .last()
        .map_or(declarator.ident.token, |s| s.extent.last);
    let from = span_of(program, last)?.end;
    let edit = Edit::delete(Span::new(from, at.end));
    Some(Fix::safe(
        "remove the initial value; the page sets it",
        vec![edit],
    ))
}

/// Replaces a `varying` in ShaderToy code, which no vertex shader of the player writes, if its name
/// means the position in the image.
fn varying(program: &Program, word: Span) -> Option<Fix> {
    if !program.dialect.is_shadertoy() {
        return None;
    }
    program.tree.items.iter().find_map(|item| {
        let Item::Decl(id) = item else { return None };
        let decl = program.tree.decl(*id)?;
        let DeclKind::Variables { declarators, .. } = decl.kind else {
            return None;
        };
        let declaration = program.span(decl.extent);
        let [declarator] = program.tree.declarators(declarators) else {
            return None;
        };
        let name = program.names.text(declarator.ident.name);
        if !declaration.contains(word) || !program.is_direct(decl.extent) || !PLACES.contains(&name)
        {
            return None;
        }
        let line = format!("#define {name} (gl_FragCoord.xy / iResolution.xy)");
        let title = format!("define `{name}` as the position in the image");
        Some(Fix::safe(title, vec![Edit::replace(declaration, line)]))
    })
}

/// Corrects the qualifiers and parameters of the entry function.
fn signature(program: &Program, header: Span) -> Option<Fix> {
    let entry = program.dialect.host().entry?;
    let mut functions = program.tree.functions.iter();
    let decl = functions.find(|f| program.span(f.header) == header)?;
    let params = program.tree.params(decl.params);
    let mut edits = Vec::new();
    // Older sound shaders had only the time as a parameter.
    if let (EntryResult::Returned, [time]) = (entry.result, params) {
        let at = span_of(program, time.extent.first)?.start;
        edits.push(Edit::insert(at, "in int, "));
    }
    for (i, param) in params.iter().enumerate() {
        let expected = match (i, entry.result) {
            (0, EntryResult::Parameter) => "out",
            _ => "in",
        };
        edits.extend(direct(program, param, expected)?);
    }
    let title = format!("declare it as `{}`", entry.signature);
    (!edits.is_empty()).then(|| Fix::safe(title, edits))
}

/// Gives a parameter a direction. The inner `None` means that it already has it.
fn direct(program: &Program, param: &Param, expected: &str) -> Option<Option<Edit>> {
    use QualifierKind::{In, Inout, Out};
    let mut qualifiers = program.tree.qualifiers(param.qualifiers).iter();
    let found = qualifiers.find(|q| matches!(q.kind, In | Inout | Out));
    Some(match found {
        Some(q) => {
            let span = span_of(program, q.extent.first)?;
            (program.sources.text(span) != expected).then(|| Edit::replace(span, expected))
        }
        None if expected == "in" => None,
        None => {
            let at = span_of(program, param.extent.first)?.start;
            Some(Edit::insert(at, format!("{expected} ")))
        }
    })
}

/// Moves the non-constant initial values of global variables to the start of the entry function.
fn late_values(program: &Program, errors: &[Diagnostic]) -> Option<Fix> {
    let main = entry(program)?;
    let is_late = |init| {
        let extent = program.tree.expr(init).extent;
        let span = program
            .tokens
            .place(&program.sources, extent.first, extent.last);
        let mut errors = errors.iter();
        errors.any(|e| e.is(error::NOT_CONSTANT) && e.span == span)
    };
    let edits = shaderlint_semantic::late_values(program, main, is_late)?;
    let title = "assign the non-constant values at the start of the entry function";
    (!edits.is_empty()).then(|| Fix::safe(title, edits))
}
