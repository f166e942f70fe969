//! Hover texts in Markdown.

use super::bound::bound_at;
use super::document::{Document, Spot};
use super::index::{NameUse, Occurrence};
use super::library::entry;
use super::run::RunObservations;
use super::symbol::{Symbol, builtin_variable, declared_at, role};
use shaderlint_detect::embed::NameRole;
use shaderlint_diagnostic::count;
use shaderlint_flow::Bound;
use shaderlint_flow::ranges::Interval;
use shaderlint_host::Feed;
use shaderlint_lint::Facts;
use shaderlint_project::Files;
use shaderlint_project::bindings;
use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::interface::Interface;
use shaderlint_semantic::{
    BlockLayout, BlockMember, BuiltinId, Field, Program, Scalar, Stage, Storage, Type, Value,
};
use shaderlint_syntax::ast::{ExprId, ExprKind, StmtId};
use shaderlint_text::Span;
use shaderlint_text::number::rounded_count;

/// A hover text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hover {
    /// Span of the hovered code in the document.
    pub span: Span,
    /// The text in Markdown.
    pub text: String,
}

/// The hover at an offset, also in code that is not compiled; `seen` holds the results of sample
/// runs.
pub fn hover(
    document: &Document,
    offset: u32,
    seen: Option<&RunObservations>,
    files: &dyn Files,
) -> Option<Hover> {
    let compiled = document.compiled_at(offset, files);
    let seen = seen.filter(|_| std::ptr::eq(compiled, document));
    let document = compiled;
    let Some(spot) = document.spot(offset) else {
        let bound = bound_at(document, offset, files);
        let text = bound.declarations() + &bound.settings();
        let span = bound.span;
        return (!text.is_empty()).then_some(Hover { span, text });
    };
    let facts = spot.analysis.facts();
    let (span, text) = match spot.name() {
        Some(name) => {
            let mut text = of_name(&spot, &facts, name);
            if role(spot.program(), name.symbol) == NameRole::Input {
                text.push_str(&bound_at(document, offset, files).settings());
            }
            (name.span, text)
        }
        None => without_name(&spot, &facts, seen)?,
    };
    let span = document.report.in_input(span)?;
    (!text.is_empty()).then_some(Hover { span, text })
}

/// A fenced code block.
fn code(text: &str) -> String {
    format!("```glsl\n{text}\n```\n")
}

fn of_name(spot: &Spot, facts: &Facts, name: Occurrence) -> String {
    let program = spot.program();
    if let Symbol::Builtin(id) = name.symbol {
        return of_builtin(program, id, expr_at(program, name.span));
    }
    let own = name.symbol.name(program);
    let declaration = match name.symbol {
        Symbol::Variable(_) => builtin_variable(program, own),
        _ => None,
    };
    let declaration = declaration.unwrap_or_else(|| name.symbol.declaration(program));
    let mut text = code(&declaration);
    let expr = expr_at(program, name.span).filter(|_| name.access == NameUse::Read);
    match name.symbol {
        Symbol::Variable(_) | Symbol::Field(..) => {
            text.push_str(&of_value(facts, expr, Some(name)));
        }
        Symbol::Function(_) => text.push_str(&of_function(spot, facts, name)),
        Symbol::Macro(_) => text.push_str(&of_macro(program, name)),
        Symbol::Struct(_) | Symbol::MacroParameter(..) | Symbol::Builtin(_) => {}
    }
    text.push_str(&layout(program, name.symbol).unwrap_or_default());
    let description = declared_at(program, name.symbol).and_then(|at| comment_above(program, at));
    let is_given = declared_at(program, name.symbol).is_none_or(|at| !program.is_user(at));
    let description =
        description.or_else(|| entry(own).filter(|_| is_given).map(|e| e.text.clone()));
    let is_uniform = matches!(name.symbol, Symbol::Variable(id)
        if program.variable(id).is_some_and(|v| v.storage == Storage::Uniform));
    let meaning = || is_uniform.then(|| given(spot, own)).flatten();
    let description = description.or_else(|| meaning().map(str::to_string));
    if let Some(description) = description {
        text.push_str(&format!("\n{description}\n"));
    }
    text
}

/// Where a member of a uniform block is in its buffer.
fn layout(program: &Program, symbol: Symbol) -> Option<String> {
    let own = symbol.name(program);
    let interface = Interface::of(program);
    interface.blocks.iter().find_map(|block| {
        let fields = &program.structs.get(usize::from(block.record))?.fields;
        let has = |field: &Field| program.names.text(field.name) == own;
        let is_member = match symbol {
            Symbol::Field(id, _) => id == u32::from(block.record),
            Symbol::Variable(id) => {
                let is_uniform = program.variable(id)?.storage == Storage::Uniform;
                is_uniform && block.instance.is_none() && fields.iter().any(has)
            }
            _ => false,
        };
        let layout = BlockLayout::of(&interface, block).filter(|_| is_member)?;
        let name = program.names.text(block.name);
        let path = block.instance.map_or(String::new(), |_| format!("{name}.")) + own;
        let is_part = |m: &&BlockMember| {
            let rest = m.name.strip_prefix(&path);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']))
        };
        let mut parts = layout.members.iter().filter(is_part);
        let first = parts.next()?;
        let last = parts.next_back().unwrap_or(first);
        let (start, size) = (first.offset, last.offset + last.size - first.offset);
        Some(format!(
            "\noffset {start}, size {size} (`std140`, in bytes of `{name}`)\n"
        ))
    })
}

/// The documentation of the value that a host assigns to a uniform of this name.
fn given(spot: &Spot, name: &str) -> Option<&'static str> {
    let bound = bindings(spot.program(), spot.analysis.host);
    let uniform = bound.uniforms.iter().find(|u| u.name == name)?;
    let is_known = !matches!(uniform.source, Feed::Control | Feed::Identity);
    is_known.then(|| uniform.source.description())
}

/// The value or range of an expression, or of a constant.
fn of_value(facts: &Facts, expr: Option<ExprId>, name: Option<Occurrence>) -> String {
    let program = facts.program();
    let constant = match name.map(|n| n.symbol) {
        Some(Symbol::Variable(id)) => {
            let variable = program.variable(id);
            variable.map_or(&[][..], |v| program.pool.values(v.constant))
        }
        _ => &[],
    };
    let values = match expr {
        Some(expr) if constant.is_empty() => program.values(expr),
        _ => constant,
    };
    let ty = match (expr, name) {
        (Some(expr), _) => Some(program.ty(expr)),
        (None, Some(name)) => name.symbol.ty(program),
        (None, None) => None,
    };
    if !values.is_empty() {
        return format!(
            "\nconstant: {}{}\n",
            shown_values(ty, values),
            swatch(ty, values)
        );
    }
    let ranges: Vec<Interval> = expr.into_iter().flat_map(|e| facts.range(e)).collect();
    match shown_ranges(ty, &ranges) {
        Some(shown) => format!("\nrange here: {shown}\n"),
        None => String::new(),
    }
}

/// Maximum number of components that are listed.
const MOST_SHOWN: usize = 16;

/// The components of a constant as GLSL literals.
fn shown_values(ty: Option<Type>, values: &[Value]) -> String {
    let scalars: Vec<String> = values.iter().take(MOST_SHOWN).map(|v| shown(*v)).collect();
    let more = if values.len() > MOST_SHOWN {
        ", …"
    } else {
        ""
    };
    match ty.filter(|ty| !ty.is_scalar() && values.len() > 1) {
        Some(_) => format!("`({}{more})`", scalars.join(", ")),
        None => format!("`{}`", scalars.join(", ")),
    }
}

fn shown(value: Value) -> String {
    match value {
        Value::Bool(value) => value.to_string(),
        Value::Int(value) => value.to_string(),
        Value::Uint(value) => format!("{value}u"),
        Value::Float(value) => format!("{value:?}"),
    }
}

/// A colour swatch, if the value may be a colour.
fn swatch(ty: Option<Type>, values: &[Value]) -> String {
    let is_color = ty.is_some_and(|ty| {
        ty.is_vector() && ty.components() >= 3 && ty.scalar_kind() == Some(Scalar::Float)
    });
    let lanes: Vec<f32> = values.iter().take(3).map(|v| v.as_float()).collect();
    let is_shown = |lane: &f32| (0.0..=1.0).contains(lane);
    let [r, g, b] = lanes[..] else {
        return String::new();
    };
    if !is_color || !lanes.iter().all(is_shown) {
        return String::new();
    }
    let byte = |lane: f32| (lane * 255.0).round() as u8;
    let color = format!("%23{:02x}{:02x}{:02x}", byte(r), byte(g), byte(b));
    format!(
        " ![{}](data:image/svg+xml,<svg%20xmlns='http://www.w3.org/2000/svg'%20width='14'%20height='14'><rect%20width='14'%20height='14'%20fill='{color}'/></svg>)",
        color.replace("%23", "#")
    )
}

/// The ranges of the components, if at least one is known.
fn shown_ranges(ty: Option<Type>, ranges: &[Interval]) -> Option<String> {
    let is_integer = ty
        .and_then(|ty| ty.scalar_kind())
        .is_some_and(Scalar::is_integer);
    let shown = |range: &Interval| match range {
        range if range.is_any() => "any number".to_string(),
        range if is_integer => range.of_integer(),
        range => range.to_string(),
    };
    let is_bool = ty.and_then(|ty| ty.scalar_kind()) == Some(Scalar::Bool);
    if is_bool || ranges.iter().all(Interval::is_any) {
        return None;
    }
    let all: Vec<String> = ranges.iter().map(shown).collect();
    let first = all.first()?;
    Some(match all.iter().all(|s| s == first) {
        true => first.clone(),
        false => {
            let named = "xyzw".chars().zip(&all);
            let each: Vec<String> = named.map(|(lane, s)| format!("`{lane}` {s}")).collect();
            each.join(", ")
        }
    })
}

fn of_function(spot: &Spot, facts: &Facts, name: Occurrence) -> String {
    let Symbol::Function(id) = name.symbol else {
        return String::new();
    };
    let program = spot.program();
    if program.function(id).is_none_or(|f| f.definition.is_none()) {
        return String::new();
    }
    let work = facts.work();
    let calls = facts.calls().graph.calls_of(id).len();
    let times = match calls {
        0 if facts.entry() == Some(id) => match program.stage {
            Stage::Vertex => "runs once per vertex".to_string(),
            Stage::Fragment => "runs once per pixel".to_string(),
        },
        0 => "never called".to_string(),
        n => count(n, "call site"),
    };
    let cost = operations(work.operations(id));
    format!("\nabout {cost} per call; {times}\n")
}

/// Formats a number of operations.
pub fn operations(count: f64) -> String {
    let plural = if count == 1.0 { "" } else { "s" };
    format!("{} operation{plural}", rounded_count(count))
}

/// The expansion of a macro call.
fn of_macro(program: &Program, name: Occurrence) -> String {
    /// Maximum length of an expansion.
    const MOST: usize = 400;
    let tokens = &program.tokens;
    let called = tokens.expansions.iter().zip(0..);
    let mut called = called.filter(|(e, _)| e.call.start == name.span.start);
    let Some((_, number)) = called.next() else {
        return String::new();
    };
    let is_inside = |mut expansion: u32| {
        while let Some(own) = tokens.expansions.get(expansion as usize) {
            if expansion == number {
                return true;
            }
            expansion = own.parent;
        }
        false
    };
    let mut text = String::new();
    for token in tokens.tokens.iter().filter(|t| is_inside(t.expansion)) {
        let spelled = program.sources.code_at(token.spelled);
        let word = spelled.and_then(|code| {
            let rest = code.text.get((token.spelled - code.base) as usize..)?;
            let end = shaderlint_syntax::Lexer::new(rest, 0).next_token().span.end;
            rest.get(..end as usize)
        });
        if !text.is_empty() {
            text.push(' ');
        }
        text.push_str(word.unwrap_or(""));
        if text.len() > MOST {
            text.push_str(" …");
            break;
        }
    }
    if text.is_empty() {
        return String::new();
    }
    format!("\nexpands to\n{}", code(&text))
}

fn of_builtin(program: &Program, id: BuiltinId, expr: Option<ExprId>) -> String {
    let builtins = Builtins::of(program.version, program.stage);
    let called = expr.and_then(|e| program.overload_called(e));
    let (_, overloads) = builtins.overloads_of(id);
    let mut text = String::new();
    if let Some(overload) = called.or(overloads.first()) {
        text.push_str(&code(&super::signature::builtin_head(overload)));
    }
    if called.is_none() && overloads.len() > 1 {
        text.push_str(&format!("\noverloads: {}\n", overloads.len()));
    }
    if let Some(entry) = entry(id.name()) {
        text.push_str(&format!("\n{}\n", entry.text));
    }
    text
}

/// The expression with its name at a span.
pub(super) fn expr_at(program: &Program, span: Span) -> Option<ExprId> {
    let tree = &program.tree;
    let all = tree.exprs.iter().zip(0..);
    let mut found = all.filter(|(expr, _)| {
        let token = match expr.kind {
            ExprKind::Name(_) | ExprKind::Call(..) | ExprKind::Construct(..) => expr.extent.first,
            ExprKind::Member(..) => expr.extent.last,
            _ => return false,
        };
        program
            .token(token)
            .is_some_and(|t| t.spelled == span.start)
    });
    found.next().map(|(_, id)| ExprId(id))
}

/// The hover of other code: components, loops, operators.
fn without_name(
    spot: &Spot,
    facts: &Facts,
    seen: Option<&RunObservations>,
) -> Option<(Span, String)> {
    let program = spot.program();
    let tokens = &program.tokens.tokens;
    let touches = |span: Span| span.start <= spot.address && spot.address <= span.end;
    let near = tokens
        .iter()
        .zip(0..)
        .filter(|(t, _)| t.is_direct() && touches(t.span));
    let (token, id) = near.max_by_key(|(t, _)| t.span.start)?;
    let stmts = program.tree.stmts.iter().zip(0..);
    let mut loops = stmts.filter(|(s, _)| s.kind.is_loop() && s.extent.first == id);
    if let Some((_, stmt)) = loops.next() {
        return Some((token.span, of_loop(facts, StmtId(stmt), seen)?));
    }
    // The smallest expression with the token as its operator.
    let all = program.tree.exprs.iter().zip(0..);
    let around = all.filter(|(e, _)| e.extent.first <= id && id <= e.extent.last);
    let (expr, number) = around.min_by_key(|(e, _)| e.extent.last - e.extent.first)?;
    let number = ExprId(number);
    let ty = program.ty(number);
    if ty.is_error() || ty.is_void() {
        return None;
    }
    let text = program.expr_text(number);
    let shown = text.lines().next().unwrap_or("");
    let dots = if shown.len() < text.len() { " …" } else { "" };
    let mut description = code(&format!("{} // {shown}{dots}", program.type_name(ty)));
    if matches!(expr.kind, ExprKind::Construct(..)) && token.span == program.span(expr.extent) {
        return None;
    }
    description.push_str(&of_value(facts, Some(number), None));
    Some((program.expr_span(number), description))
}

fn of_loop(facts: &Facts, stmt: StmtId, seen: Option<&RunObservations>) -> Option<String> {
    let known = facts.loops().get(stmt)?;
    let mut text = match known.bound {
        Bound::Exact(n) if known.ends_early => format!("at most {}", count(n, "iteration")),
        Bound::Exact(n) => count(n, "iteration"),
        Bound::AtMost(n) => format!("at most {}", count(n, "iteration")),
        Bound::Ends => "finite; the number of iterations is unknown".to_string(),
        Bound::Open => "no bound on the number of iterations is known".to_string(),
    };
    text.push('\n');
    if let Some(seen) = seen.and_then(|s| s.loops.get(&stmt)) {
        text.push_str(&format!("\n{seen}\n"));
    }
    Some(text)
}

/// The comment directly above a declaration, or after it on the same line.
fn comment_above(program: &Program, at: Span) -> Option<String> {
    let file = program.sources.file_at(at.start)?;
    let lines = file.lines();
    let line = lines.line(at.start - file.base);
    // A parameter or a later declarator has no comment of its own.
    let start = lines.start(line)? as usize;
    let before = file.text.get(start..(at.start - file.base) as usize)?;
    if before.contains(['(', '{', ',', ';']) {
        return None;
    }
    let mut description: Vec<String> = Vec::new();
    let mut above = line;
    let comments = &program.tokens.comments;
    for comment in comments.iter().rev().filter(|c| c.end <= at.start) {
        if !file.span().contains(*comment) {
            break;
        }
        let first = lines.line(comment.start - file.base);
        let last = lines.line(comment.end - file.base);
        // The comment is alone on its lines, directly above what follows.
        let start = lines.start(first)?;
        let before = file
            .text
            .get(start as usize..(comment.start - file.base) as usize)?;
        if last + 1 != above || !before.trim().is_empty() {
            break;
        }
        description.push(plain(program.sources.text(*comment)));
        above = first;
    }
    description.reverse();
    let after = comments.iter().find(|c| {
        c.start >= at.end && file.span().contains(**c) && lines.line(c.start - file.base) == line
    });
    if description.is_empty()
        && let Some(after) = after
    {
        description.push(plain(program.sources.text(*after)));
    }
    let description = description.join("\n");
    let has_words = description.chars().any(char::is_alphabetic);
    has_words.then_some(description)
}

/// The text of a comment without its delimiters.
fn plain(comment: &str) -> String {
    let inner = comment.strip_prefix("//").or_else(|| {
        let inner = comment.strip_prefix("/*")?;
        Some(inner.strip_suffix("*/").unwrap_or(inner))
    });
    let lines = inner.unwrap_or(comment).lines();
    let lines = lines.map(|l| l.trim().trim_start_matches(['*', '/', '!']).trim());
    let escaped = lines.map(|l| l.replace('<', "&lt;"));
    escaped.collect::<Vec<_>>().join("  \n").trim().to_string()
}
