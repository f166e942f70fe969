//! Precision qualifiers (GLSL ES 3.00 section 4.5).

use super::super::form::*;
use rustc_hash::FxHashMap;
use shaderlint_semantic::{Base, Program, Sampler, Scalar, Stage, Type, Variable as Declared};
use shaderlint_syntax::ast::{List, QualifierKind};
use std::rc::Rc;

/// The default precisions in the current scope.
#[derive(Clone)]
pub(super) struct DefaultPrecisions {
    float: Precision,
    int: Precision,
    /// Default precisions set for samplers, the latest last; otherwise `lowp`.
    samplers: Rc<Vec<(Sampler, Precision)>>,
}

impl DefaultPrecisions {
    /// The predefined default precisions of a stage (section 4.5.4).
    pub fn new(stage: Stage) -> DefaultPrecisions {
        let (float, int) = match stage {
            Stage::Vertex => (Precision::High, Precision::High),
            Stage::Fragment => (Precision::None, Precision::Medium),
        };
        DefaultPrecisions {
            float,
            int,
            samplers: Rc::default(),
        }
    }

    /// The default precision of a type.
    pub fn default_of(&self, ty: Type) -> Precision {
        match ty.base {
            Base::Numeric { scalar, .. } => match scalar {
                Scalar::Float => self.float,
                Scalar::Int | Scalar::Uint => self.int,
                Scalar::Bool => Precision::None,
            },
            Base::Sampler(sampler) => {
                let set = self.samplers.iter().rev().find(|(s, _)| *s == sampler);
                set.map_or(Precision::Low, |(_, precision)| *precision)
            }
            _ => Precision::None,
        }
    }

    /// The precision given by qualifiers, or else the default of the type.
    pub fn declared(&self, program: &Program, qualifiers: List, ty: Type) -> Precision {
        let given = program.tree.qualifiers(qualifiers).iter();
        let given = given.rev().find_map(|q| of_qualifier(q.kind));
        given.unwrap_or_else(|| self.default_of(ty))
    }

    /// Applies a `precision` statement.
    pub fn set(&mut self, ty: Type, precision: Precision) {
        match ty.base {
            Base::Sampler(sampler) => Rc::make_mut(&mut self.samplers).push((sampler, precision)),
            _ => match ty.scalar_kind() {
                Some(Scalar::Float) => self.float = precision,
                Some(Scalar::Int) => self.int = precision,
                _ => {}
            },
        }
    }
}

/// The precision that a qualifier specifies.
pub(super) fn of_qualifier(kind: QualifierKind) -> Option<Precision> {
    match kind {
        QualifierKind::Lowp => Some(Precision::Low),
        QualifierKind::Mediump => Some(Precision::Medium),
        QualifierKind::Highp => Some(Precision::High),
        _ => None,
    }
}

/// The precision of a built-in variable.
pub(super) fn of_language(variable: &Declared, program: &Program) -> Precision {
    let is_number = matches!(
        variable.ty.element().scalar_kind(),
        Some(Scalar::Float | Scalar::Int | Scalar::Uint)
    );
    if variable.token.is_some() || !is_number {
        return Precision::None;
    }
    program
        .builtin_precision(variable.name)
        .map_or(Precision::High, |q| {
            of_qualifier(q).unwrap_or(Precision::High)
        })
}

/// By function: the precision of its return value.
pub(super) type Returned = FxHashMap<shaderlint_semantic::FunctionRef, Precision>;

/// The precision of an operation's value: the highest precision of its operands.
pub(super) fn of_operation(module: &Module, returned: &Returned, kind: OpKind) -> Precision {
    let of = |id: OpId| module.op(id).precision;
    match kind {
        OpKind::Const(_) | OpKind::Undef | OpKind::Unknown | OpKind::Store(..) => Precision::None,
        OpKind::Load(place) => {
            let variable = module.variable(module.place(place).variable);
            variable.map_or(Precision::None, |v| v.precision)
        }
        OpKind::Unary(_, a)
        | OpKind::Convert(a)
        | OpKind::Splat(a)
        | OpKind::Swizzle(a, _)
        | OpKind::Extract(a, _)
        | OpKind::ExtractComputed { base: a, .. } => of(a),
        OpKind::Same { .. } => Precision::None,
        OpKind::Binary(operator, ..) if operator.compares() => Precision::None,
        OpKind::Binary(Binary::ShiftLeft | Binary::ShiftRight, a, _) => of(a),
        OpKind::Binary(_, a, b) | OpKind::MatrixProduct(a, b) => of(a).max(of(b)),
        OpKind::Select {
            then, otherwise, ..
        } => of(then).max(of(otherwise)),
        OpKind::Compose(list) | OpKind::Builtin(_, list) => {
            let operands = module.operands(list).iter();
            operands.map(|o| of(*o)).max().unwrap_or_default()
        }
        OpKind::Call(function, _) => {
            let set = returned.get(&function);
            set.copied().unwrap_or_default()
        }
        OpKind::Returned(call, parameter) => of_parameter(module, call, parameter),
    }
}

fn of_parameter(module: &Module, call: OpId, parameter: u32) -> Precision {
    let OpKind::Call(function, _) = module.op(call).kind else {
        return module.op(call).precision;
    };
    let function = module.function(function);
    let all = function.map_or(&[][..], |f| module.parameters(f));
    let variable = all.get(parameter as usize);
    let variable = variable.and_then(|v| module.variable(*v));
    variable.map_or(Precision::None, |v| v.precision)
}
