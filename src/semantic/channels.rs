//! Infers the types of ShaderToy's channels from the lookups in the code.

use super::dialect::Channels;
use super::program::{Program, Resolution};
use super::types::{Base, Sampler, Type};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::{Expr, ExprId, ExprKind};

/// Types that a channel can have. If two fit equally many lookups, the first wins.
const CANDIDATES: [Sampler; 3] = [Sampler::Sampler2D, Sampler::SamplerCube, Sampler::Sampler3D];

/// For each channel the type that most of its lookups fit, in a shader checked with channels of any
/// type. `None` if the channel is not used.
pub fn needed_channels(program: &Program) -> Channels {
    let mut fits = [[0_u32; CANDIDATES.len()]; 4];
    let names = [0, 1, 2, 3].map(|i| program.names.get(&format!("iChannel{i}")));
    for expr in &program.tree.exprs {
        let ExprKind::Call(name, list) = expr.kind else {
            continue;
        };
        let args = program.tree.args(list);
        for (position, arg) in args.iter().enumerate() {
            let Some(channel) = channel_of(program, *arg, names) else {
                continue;
            };
            let of_channel = fits.get_mut(channel).into_iter().flatten();
            for (count, candidate) in of_channel.zip(CANDIDATES) {
                *count += u32::from(may_take(program, name, args, position, candidate));
            }
        }
    }
    fits.map(|counts| {
        let most = counts.into_iter().max().filter(|most| *most > 0)?;
        let mut all = counts.into_iter().zip(CANDIDATES);
        all.find(|(count, _)| *count == most).map(|(_, c)| c)
    })
}

/// The channel that an expression names.
fn channel_of(program: &Program, expr: ExprId, names: [Option<Name>; 4]) -> Option<usize> {
    let Expr {
        kind: ExprKind::Name(name),
        ..
    } = program.tree.expr(program.tree.unparen(expr))
    else {
        return None;
    };
    let Resolution::Variable(id) = program.expr(program.tree.unparen(expr)).resolution else {
        return None;
    };
    let is_global = program.variable(id).is_some_and(|v| v.function.is_none());
    let channel = names.iter().position(|n| *n == Some(*name));
    channel.filter(|_| is_global)
}

/// Whether a function of this name accepts these arguments if the one at `position` is such a
/// sampler.
fn may_take(
    program: &Program,
    name: Name,
    args: &[ExprId],
    position: usize,
    sampler: Sampler,
) -> bool {
    let fits = |param: Type, (at, arg): (usize, &ExprId)| {
        let arg = program.expr(*arg).ty;
        match at == position {
            true => param == Type::sampler(sampler),
            false => param == arg || arg.base == Base::Error,
        }
    };
    let takes = |params: &mut dyn ExactSizeIterator<Item = Type>| {
        params.len() == args.len() && params.zip(args.iter().enumerate()).all(|(p, a)| fits(p, a))
    };
    let of_name = program.functions.iter().filter(|f| f.name == name);
    if of_name
        .into_iter()
        .any(|f| takes(&mut f.params.iter().map(|p| p.ty)))
    {
        return true;
    }
    let builtins = program.builtins();
    let Some(function) = builtins.function(program.names.text(name)) else {
        return false;
    };
    let (_, overloads) = builtins.overloads_of(function);
    overloads
        .iter()
        .any(|o| takes(&mut o.params().iter().copied()))
}
