//! Texture coordinates that are discontinuous between neighbouring pixels.

use shaderlint_flow::Jump;
use shaderlint_lint::prelude::*;

rule! { texture_seam, Portability, Info, Recommended, Program(check) }

/// Reports each discontinuity at the first lookup that it reaches.
fn check(cx: &mut Context) {
    let program = cx.program;
    let has_pixels = program.stage == Stage::Fragment && cx.facts.entry().is_some();
    let is_sound = program.dialect == Dialect::ShaderToy(Pass::Sound);
    if !has_pixels || is_sound {
        return;
    }
    let module = cx.facts.module();
    let ops = (0..).map(OpId).zip(&module.ops);
    let lookups = ops.filter(|(_, op)| match op.kind {
        OpKind::Builtin(function, _) => {
            function.kind().is_texture() && function.kind().takes_derivatives()
        }
        _ => false,
    });
    let mut reported: Vec<OpId> = Vec::new();
    for (op, _) in lookups {
        let found = place_of(cx, op).and_then(|place| {
            let place_op = module.op_of(place)?;
            let jump = (0..2).find_map(|lane| cx.facts.jump(place_op, lane))?;
            Some((place, jump))
        });
        let Some((place, jump)) = found.filter(|(_, jump)| !reported.contains(&jump.call)) else {
            continue;
        };
        reported.push(jump.call);
        // Rounding makes coarse pixels on purpose, mostly from a texture without mipmaps.
        let is_known = cx.facts.around.mipmapped.contains(&Some(true));
        let is_seam = matches!(
            jump.function,
            BuiltinId::Atan | BuiltinId::Fract | BuiltinId::Mod
        );
        if !is_known && (!is_seam || is_stepped(cx, jump.call)) {
            continue;
        }
        report(cx, place, jump);
    }
}

/// The coordinates of a lookup that may select a smaller mipmap level.
fn place_of(cx: &Context, lookup: OpId) -> Option<ExprId> {
    let program = cx.program;
    let Provenance::Expr(call) = cx.facts.module().provenance(lookup) else {
        return None;
    };
    let ExprKind::Call(_, args) = program.tree.expr(call).kind else {
        return None;
    };
    let &[_, place, ..] = program.tree.args(args) else {
        return None;
    };
    // Directions into a cube map have no seam.
    let is_flat = program.ty(place).components() == 2;
    (is_flat && cx.facts.chooses_level(lookup)).then_some(place)
}

fn report(cx: &mut Context, place: ExprId, jump: Jump) {
    let origin = cx.facts.module().provenance(jump.call);
    let Some(extent) = origin.extent(&cx.program.tree) else {
        return;
    };
    let at = cx.program.span(extent);
    let name = jump.function.name();
    let how = match jump.function {
        BuiltinId::Atan => format!("`{name}` wraps from π to -π"),
        _ => format!("`{name}` is discontinuous"),
    };
    cx.report_expr(place, "texture coordinates are discontinuous between neighbouring pixels")
        .label(at, how)
        .note("if the texture has mipmaps, the GPU selects its smallest level at the jump, which draws a thin line")
        .help("pass continuous gradients to `textureGrad`, or choose the level with `textureLod`");
}

/// Whether the argument of a call is rounded: a table with a value for each cell is read.
fn is_stepped(cx: &Context, call: OpId) -> bool {
    let module = cx.facts.module();
    let OpKind::Builtin(_, list) = module.op(call).kind else {
        return false;
    };
    let mut operands = module.operands(list).iter();
    operands.any(|operand| {
        let mut lanes = 0..module.ty(*operand).components();
        lanes.any(|lane| cx.facts.jump(*operand, lane).is_some())
    })
}
