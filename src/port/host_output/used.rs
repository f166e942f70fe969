//! The inputs that the code of a pass uses, and where it uses them first.

use crate::{Input, InputKind, OutputId, ProjectPass};
use shaderlint_host::{Feed, is_named, shadertoy};
use shaderlint_semantic::{
    CallGraph, FunctionRef, Program, Resolution, Sampler, Storage, Structure, Variable, VariableId,
    channel,
};
use shaderlint_syntax::ast::ExprId;
use shaderlint_text::Span;

/// The value of an input of a pass.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum UsedValue {
    /// A uniform with a meaning.
    Known(Feed),
    /// The screen of the host, or an image that the user has not named.
    Screen,
    /// An image file.
    Image,
    /// The output of a pass.
    Output(OutputId),
    /// Anything else, such as a keyboard or sound.
    Other,
}

/// An input that the code of a pass names.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct UsedInput {
    pub(super) name: String,
    /// The GLSL type, with the size of an array.
    pub(super) ty: String,
    pub(super) value: UsedValue,
    /// The first use.
    pub(super) span: Span,
    /// Whether a use of it can run.
    pub(super) is_live: bool,
}

/// The uniforms that the code of a pass names, in the order of their declaration.
pub(super) fn used_inputs(program: &Program, pass: &ProjectPass) -> Vec<UsedInput> {
    let reached = reached(program);
    let structure = Structure::of(program);
    let mut uses: Vec<(VariableId, Span, bool)> = Vec::new();
    for (id, expr) in (0..).map(ExprId).zip(&program.tree.exprs) {
        let Resolution::Variable(variable) = program.expr(id).resolution else {
            continue;
        };
        let span = program.span(expr.extent);
        let is_uniform = program
            .variable(variable)
            .is_some_and(|v| v.storage == Storage::Uniform);
        if !is_uniform || !program.is_user(span) {
            continue;
        }
        let function = structure.function_of_expr(id);
        let is_live = function.is_none_or(|f| reached.get(f.0 as usize) == Some(&true));
        match uses.iter_mut().find(|(own, ..)| *own == variable) {
            Some((_, first, live)) if is_live && !*live => (*first, *live) = (span, true),
            Some(_) => {}
            None => uses.push((variable, span, is_live)),
        }
    }
    uses.sort_by_key(|(id, ..)| id.0);
    let inputs = uses.into_iter().filter_map(|(id, span, is_live)| {
        let variable = program.variable(id)?;
        let name = program.names.text(variable.name).to_string();
        Some(UsedInput {
            ty: program.type_name(variable.ty),
            value: value(program, pass, variable, &name),
            name,
            span,
            is_live,
        })
    });
    inputs.collect()
}

/// By function: whether `main` runs it.
fn reached(program: &Program) -> Vec<bool> {
    let name = program.names.get("main");
    let main = program.functions.iter().position(|f| Some(f.name) == name);
    let entry = FunctionRef(main.unwrap_or(usize::MAX) as u32);
    CallGraph::of(program).reached_from(entry)
}

fn value(program: &Program, pass: &ProjectPass, variable: &Variable, name: &str) -> UsedValue {
    let ty = program.type_name(variable.ty);
    if let Some(sampler) = variable.ty.element().as_sampler() {
        let is_it = |i: &&Input| match &i.uniform {
            Some(uniform) => uniform == name,
            None => channel(name) == Some(i.channel),
        };
        let input = pass.inputs.iter().find(is_it);
        return input.map_or(UsedValue::Other, |input| content(input, sampler));
    }
    let bound = pass.bound.uniforms.iter().find(|u| u.name == name);
    let of_player = || {
        let mut rows = shadertoy()?.meanings.feeds.iter();
        let row = rows.find(|r| is_named(&r.name, name) && r.types.contains(&ty))?;
        Some(row.feed)
    };
    let feed = bound.map(|u| u.source).or_else(of_player);
    feed.map_or(UsedValue::Other, UsedValue::Known)
}

fn content(input: &Input, sampler: Sampler) -> UsedValue {
    let is_unnamed = [&input.id, &input.src, &input.name]
        .iter()
        .all(|text| text.is_empty());
    match input.kind {
        InputKind::Buffer => UsedValue::Output(OutputId(input.id.clone())),
        InputKind::Texture if sampler == Sampler::Sampler2D => {
            match is_unnamed || input.id == OutputId::SCREEN {
                true => UsedValue::Screen,
                false => UsedValue::Image,
            }
        }
        _ => UsedValue::Other,
    }
}
