//! `void mainImage(vec4 color, vec2 coord)`: a colour that never reaches the caller.

use shaderlint_lint::prelude::*;

rule! { mainimage_qualifiers, Webgl2, Warning, Recommended, Function(check) }

fn check(cx: &mut Context, id: FunctionRef) {
    let program = cx.program;
    let Some(function) = program.function(id) else {
        return;
    };
    let definition = function.definition.and_then(|d| program.tree.function(d));
    let (Some(color), Some(definition)) = (function.params.first(), definition) else {
        return;
    };
    let is_lost = color.ty == Type::vector(Scalar::Float, 4)
        && function.returns.is_void()
        // Other hosts return the colour in another parameter.
        && !function.params.iter().any(|p| p.direction.writes());
    if program.names.text(function.name) != "mainImage" || !is_lost {
        return;
    }
    let Some(param) = program.tree.params(definition.params).first() else {
        return;
    };
    let qualifiers = program.tree.qualifiers(param.qualifiers);
    let direction = qualifiers
        .iter()
        .find(|q| q.kind == QualifierKind::In)
        .map(|q| q.extent);
    let edit = match direction {
        Some(extent) => Edit::replace(program.span(extent), "out"),
        None => Edit::insert(program.span(param.extent).start, "out "),
    };
    let is_plain = color.direction == Direction::In && program.is_direct(param.extent);
    let has_prototype = function.declaration != function.definition.unwrap_or(function.declaration);
    let fix =
        (is_plain && !has_prototype).then(|| Fix::suggestion("declare it as `out`", vec![edit]));
    let extent = Extent::new(param.extent.first, param.extent.last);
    cx.report(
        extent,
        "`mainImage` cannot return its colour: the parameter is not `out`",
    )
    .note("without `out`, the function writes to a local copy that the caller never sees")
    .fix(fix);
}
