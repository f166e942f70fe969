//! A shader that draws one of its values, as its author would write it.
//!
//! The value goes through a function that keeps it in a global variable, which the entry function
//! returns instead of its own colour. So the last value that a pixel computes is drawn, wherever it
//! is computed, as by `shaderlint run --show`.

use super::place::RefactorPlace;
use super::verify::{ChangedDocument, changed};
use crate::document::Document;
use crate::preview::preview_project;
use shaderlint_project::Files;
use shaderlint_semantic::{Direction, FunctionRef, Scalar, Stage, Storage, Type, VariableId};
use shaderlint_syntax::ast::*;
use shaderlint_text::{Edit, Span};
use std::collections::BTreeMap;

/// A document whose shader draws a value.
pub struct ShownValue {
    /// The changed document.
    pub document: Document,
    /// Number of the shader in it.
    pub shader: usize,
    /// The text of the value.
    pub text: String,
    /// Where it is in the original document.
    pub span: Span,
}

/// Draws the selected expression, or the variable at an empty selection. Numbers between the limits
/// are the colours from 0 to 1. `None` if nothing there has a value that can be drawn as a colour, or
/// if the shader cannot be played then.
pub fn shown_value(
    document: &Document,
    files: &dyn Files,
    selection: Span,
    limits: [f32; 2],
) -> Option<ShownValue> {
    let place = RefactorPlace::of(document, files, selection)?;
    let shader = document.spot(selection.start)?.shader;
    if place.program.stage != Stage::Fragment {
        return None;
    }
    let value = value(&place)?;
    let code = ShowCode {
        function: place.free_name("showValue"),
        color: place.free_name("shownColor"),
        limits,
    };
    let mut inserts = TextInserts::default();
    value.capture(&code, &mut inserts);
    output(&place, &code, &mut inserts)?;
    declare(&place, &value, &code, &mut inserts)?;
    let ChangedDocument { after, .. } = changed(&place, &inserts.edits(), &[])?;
    let is_valid = after
        .report
        .analyses
        .get(shader)
        .is_some_and(|a| !a.has_errors);
    let is_played = is_valid && preview_project(&after, shader).is_ok();
    is_played.then_some(ShownValue {
        document: after,
        shader,
        text: place.text(value.span)?.to_string(),
        span: document.report.in_input(value.span)?,
    })
}

/// What the changed shader has in addition.
struct ShowCode {
    /// The names.
    function: String,
    color: String,
    /// The numbers that are drawn as 0 and 1.
    limits: [f32; 2],
}

/// The value to draw.
struct DrawnValue {
    ty: Type,
    /// Its text: an expression, or the name of a variable.
    span: Span,
    capture: ValueCapture,
}

/// How a value is kept.
enum ValueCapture {
    /// The value of this text.
    Value(Span),
    /// A variable, after this expression has written it.
    After(Span, String),
    /// A parameter, at the start of a body.
    Start(u32, String),
}

impl DrawnValue {
    fn capture(&self, code: &ShowCode, inserts: &mut TextInserts) {
        let show = &code.function;
        match &self.capture {
            ValueCapture::Value(span) => inserts.around(*span, &format!("{show}("), ")"),
            ValueCapture::After(span, name) => {
                inserts.around(*span, "(", &format!(", {show}({name}))"));
            }
            ValueCapture::Start(at, name) => inserts.at(*at, &format!(" {show}({name});")),
        }
    }
}

/// Texts to insert, by address: those that end something, and those that start something.
#[derive(Default)]
struct TextInserts(BTreeMap<u32, (String, String)>);

impl TextInserts {
    /// Inserts texts around a span, and around what was inserted there before.
    fn around(&mut self, span: Span, before: &str, after: &str) {
        let (_, starts) = self.0.entry(span.start).or_default();
        starts.insert_str(0, before);
        let (ends, _) = self.0.entry(span.end).or_default();
        ends.push_str(after);
    }

    fn at(&mut self, address: u32, text: &str) {
        self.around(Span::at(address), text, "");
    }

    fn edits(self) -> Vec<Edit> {
        let all = self.0.into_iter();
        all.map(|(at, (ends, starts))| Edit::insert(at, ends + &starts))
            .collect()
    }
}

fn value(place: &RefactorPlace) -> Option<DrawnValue> {
    let program = place.program;
    let is_here = |e: &Expr| matches!(e.kind, ExprKind::Name(_)) && place.is_exact(e.extent);
    let named = || {
        let mut all = program.tree.exprs.iter();
        let at = all.position(|e| is_here(e) && program.span(e.extent).contains(place.selection));
        at.map(|at| ExprId(at as u32))
    };
    let Some(expr) = place.expr().or_else(named) else {
        return declared(place, place.variable()?);
    };
    let span = program.expr_span(expr);
    let ty = drawn(program.ty(expr))?;
    let own = |capture| Some(DrawnValue { ty, span, capture });
    // What is written has no value before.
    match written_by(place, expr) {
        None => own(ValueCapture::Value(span)),
        Some(write) => {
            let text = place.text(span)?.to_string();
            own(ValueCapture::After(program.expr_span(write), text))
        }
    }
}

/// The expression that writes to an expression, or to a part of it.
fn written_by(place: &RefactorPlace, expr: ExprId) -> Option<ExprId> {
    let (tree, structure) = (&place.program.tree, place.facts.structure());
    let mut inner = expr;
    loop {
        let outer = structure.parent(inner)?;
        match tree.expr(outer).kind {
            ExprKind::Paren(_) | ExprKind::Member(..) => inner = outer,
            ExprKind::Index(base, _) if base == inner => inner = outer,
            ExprKind::Assign(_, target, _) if target == inner => return Some(outer),
            ExprKind::Postfix(..) => return Some(outer),
            ExprKind::Unary(UnaryOp::Increment | UnaryOp::Decrement, _) => return Some(outer),
            _ => return None,
        }
    }
}

/// The value of a variable at its declaration.
fn declared(place: &RefactorPlace, id: VariableId) -> Option<DrawnValue> {
    let program = place.program;
    let variable = program.variable(id)?;
    let ty = drawn(variable.ty)?;
    let span = program.token(variable.token?)?.span;
    let capture = match variable.storage {
        Storage::Param(Direction::In | Direction::ConstIn | Direction::Inout) => {
            let body = place.definition(variable.function?)?.body?;
            let open = program.tree.stmt(body).extent.first;
            ValueCapture::Start(
                program.token(open)?.span.end,
                program.names.text(variable.name).to_string(),
            )
        }
        _ => {
            let init = program.declarator_of(id)?.init?;
            place
                .is_exact(program.tree.expr(init).extent)
                .then_some(())?;
            ValueCapture::Value(program.expr_span(init))
        }
    };
    Some(DrawnValue { ty, span, capture })
}

/// The type, if its values can be drawn: scalars and vectors.
fn drawn(ty: Type) -> Option<Type> {
    let (_, columns, _) = ty.numeric()?;
    (columns == 1 && ty.array == 0).then_some(ty)
}

/// The limits of numbers that are colours as they are.
pub const WITHIN: [f32; 2] = [0.0, 1.0];

/// A value as red, green and blue.
fn color(ty: Type, [least, most]: [f32; 2]) -> Option<String> {
    let (scalar, _, lanes) = ty.numeric()?;
    if scalar == Scalar::Float && [least, most] != WITHIN {
        let (vector, value, rest) = match lanes {
            1 => ("float", "value", ""),
            2 => ("vec2", "value", ", 0.0"),
            3 => ("vec3", "value", ""),
            _ => ("vec3", "value.rgb", ""),
        };
        let size = most - least;
        return Some(format!(
            "vec3(({value} - {vector}({least:?})) / {size:?}{rest})"
        ));
    }
    let vector = match lanes {
        1 => "vec3(value)",
        2 => "vec3(vec2(value), 0.0)",
        3 => "vec3(value)",
        _ => "vec4(value).rgb",
    };
    Some(match scalar {
        Scalar::Float | Scalar::Bool => vector.to_string(),
        // Neighbouring integers have different colours, and zero is black.
        Scalar::Int | Scalar::Uint if lanes == 1 => {
            "float(value) == 0.0 ? vec3(0.0) : 0.6 + 0.4 * \
            cos(2.4 * float(value) + vec3(0.0, 2.1, 4.2))"
                .to_string()
        }
        Scalar::Int | Scalar::Uint => format!("fract({vector} * 0.618)"),
    })
}

/// The variable and the function that keep the value, before what uses them.
fn declare(
    place: &RefactorPlace,
    value: &DrawnValue,
    code: &ShowCode,
    inserts: &mut TextInserts,
) -> Option<()> {
    let program = place.program;
    let entry = place.definition(own_entry(place)?)?;
    let at = |address: u32| {
        let (_, item) = place.item_at(address)?;
        Some(program.span(item).start)
    };
    let first = at(value.span.start)?.min(program.span(entry.extent).start);
    let ShowCode {
        function,
        color: shown,
        limits,
    } = code;
    let (ty, color) = (program.type_name(value.ty), color(value.ty, *limits)?);
    let text = format!(
        "vec4 {shown} = vec4(0.0, 0.0, 0.0, 1.0); {ty} {function}({ty} value) {{ {shown}.rgb = {color}; return value; }} "
    );
    inserts.at(first, &text);
    Some(())
}

/// The entry function of the user's text: that of the shader, or what the host's own calls.
fn own_entry(place: &RefactorPlace) -> Option<FunctionRef> {
    let program = place.program;
    let is_own = |id: FunctionRef| {
        let definition = place.definition(id);
        definition.is_some_and(|d| program.is_user(program.span(d.header)))
    };
    let entry = place.facts.entry()?;
    let calls = place.facts.calls().all.iter();
    let called = calls.filter(|call| call.caller == Some(entry));
    let mut all = [entry].into_iter().chain(called.map(|call| call.callee));
    all.find(|id| is_own(*id))
}

/// The edits that make the entry function output the kept colour, wherever it returns.
fn output(place: &RefactorPlace, code: &ShowCode, inserts: &mut TextInserts) -> Option<()> {
    let program = place.program;
    let entry = own_entry(place)?;
    let own = place.definition(entry)?;
    let returns = program.function(entry)?.returns;
    let shown = |lanes: u8| match lanes {
        4 => Some(code.color.clone()),
        3 => Some(format!("{}.rgb", code.color)),
        _ => None,
    };
    let lanes = |ty: Type| match ty.numeric() {
        Some((Scalar::Float, 1, lanes)) if ty.array == 0 => Some(lanes),
        _ => None,
    };
    let end = match returns.is_void() {
        true => {
            let (name, lanes) = target(place, own, lanes)?;
            format!("{name} = {};", shown(lanes)?)
        }
        false => String::new(),
    };
    for (stmt, id) in program.tree.stmts.iter().zip(0..) {
        let StmtKind::Return(value) = stmt.kind else {
            continue;
        };
        if place.facts.structure().function_of(StmtId(id)) != Some(entry) {
            continue;
        }
        place.is_exact(stmt.extent).then_some(())?;
        let span = program.span(stmt.extent);
        match value {
            None => {
                inserts.around(span, &format!("{{ {end} "), " }");
            }
            Some(value) => {
                let value = program.expr_span(value);
                let shown = shown(lanes(returns)?)?;
                inserts.around(value, "(", &format!(", {shown})"));
            }
        }
    }
    let close = program.token(program.tree.stmt(own.body?).extent.last)?;
    inserts.at(close.span.start, &end);
    Some(())
}

/// What an entry function without a result writes its colour to, and its number of components.
fn target(
    place: &RefactorPlace,
    entry: &FunctionDecl,
    lanes: impl Fn(Type) -> Option<u8>,
) -> Option<(String, u8)> {
    let program = place.program;
    let mut all = program.variables.iter();
    let first = program.tree.params(entry.params).first();
    if let Some(ident) = first.and_then(|param| param.ident) {
        let parameter = all.find(|v| v.token == Some(ident.token))?;
        let is_out = matches!(
            parameter.storage,
            Storage::Param(Direction::Out | Direction::Inout)
        );
        let name = program.names.text(parameter.name).to_string();
        return Some((name, lanes(parameter.ty)?)).filter(|_| is_out);
    }
    for builtin in ["gl_FragColor", "gl_FragData"] {
        if place.code()?.text.contains(builtin) {
            let index = if builtin == "gl_FragData" { "[0]" } else { "" };
            return Some((format!("{builtin}{index}"), 4));
        }
    }
    let output = all.find(|v| v.storage == Storage::Output && lanes(v.ty) > Some(2))?;
    let name = program.names.text(output.name).to_string();
    Some((name, lanes(output.ty)?))
}
