//! Reads the declarations of built-in functions and variables: GLSL, one to a line, with one blank
//! between words. They are read at every start, so that nothing is done here that they do not need.

use super::{BuiltinId, BuiltinStorage, BuiltinVariable, MAX_PARAMS, Overload};
use crate::semantic::types::{Sampler, Scalar, Type};
use crate::syntax::ast::QualifierKind;
use crate::syntax::{Version, WordClass, classify};

/// The declarations of a text, without the comments between them.
pub(super) fn declarations(text: &'static str) -> impl Iterator<Item = &'static str> {
    let lines = text.lines();
    lines.filter(|line| !line.is_empty() && !line.starts_with("//"))
}

/// What a word of the notation stands for: one type, or several in turn.
#[derive(Clone, Copy)]
enum Form {
    /// A type of the language.
    One(Type),
    /// Vectors from so many components on, up to four; one component is a scalar.
    Vectors(Scalar, u8),
    /// Every matrix.
    Matrices,
    /// One for each of `float`, `int` and `uint`.
    ByScalar([Type; 3]),
}

impl Form {
    fn of(word: &str) -> Option<Form> {
        use Sampler::*;
        use Scalar::*;
        let samplers = |all: [Sampler; 3]| Form::ByScalar(all.map(Type::sampler));
        Some(match word {
            "genType" => Form::Vectors(Float, 1),
            "genIType" => Form::Vectors(Int, 1),
            "genUType" => Form::Vectors(Uint, 1),
            "genBType" => Form::Vectors(Bool, 1),
            "vec" => Form::Vectors(Float, 2),
            "ivec" => Form::Vectors(Int, 2),
            "uvec" => Form::Vectors(Uint, 2),
            "bvec" => Form::Vectors(Bool, 2),
            "mat" => Form::Matrices,
            "gvec4" => Form::ByScalar([Float, Int, Uint].map(|s| Type::vector(s, 4))),
            "gsampler2D" => samplers([Sampler2D, Isampler2D, Usampler2D]),
            "gsampler3D" => samplers([Sampler3D, Isampler3D, Usampler3D]),
            "gsamplerCube" => samplers([SamplerCube, IsamplerCube, UsamplerCube]),
            "gsampler2DArray" => samplers([Sampler2DArray, Isampler2DArray, Usampler2DArray]),
            word => Form::One(type_named(word)?),
        })
    }

    /// How many types it stands for.
    fn count(self) -> u8 {
        match self {
            Form::One(_) => 1,
            Form::Vectors(_, first) => 5 - first,
            Form::Matrices => 9,
            Form::ByScalar(all) => all.len() as u8,
        }
    }

    fn get(self, variant: u8) -> Type {
        match self {
            Form::One(ty) => ty,
            Form::Vectors(scalar, first) => Type::vector(scalar, first + variant),
            Form::Matrices => Type::matrix(variant / 3 + 2, variant % 3 + 2),
            Form::ByScalar(all) => all.get(variant as usize).copied().unwrap_or(Type::ERROR),
        }
    }
}

/// What stands before the first such mark, and what behind it. The texts are short: a search that
/// starts as one through a long text does takes more time than it saves.
fn cut(text: &str, mark: u8) -> Option<(&str, &str)> {
    let at = text.bytes().position(|byte| byte == mark)?;
    Some((text.get(..at)?, text.get(at + 1..)?))
}

fn type_named(word: &str) -> Option<Type> {
    match classify(word, Version::Es300) {
        WordClass::Type(word) => Some(Type::of_word(word)),
        _ => None,
    }
}

/// A prototype in the notation of the texts.
pub(super) struct Prototype {
    /// The function's name.
    pub name: &'static str,
    returns: Form,
    params: [Form; MAX_PARAMS],
    count: u8,
    out: u8,
    constant: u8,
}

impl Prototype {
    /// Reads `returns name(type name, ...);`; `None` where a declaration is none of a function.
    pub fn read(line: &'static str) -> Option<Prototype> {
        let (head, mut list) = cut(line.strip_suffix(");")?, b'(')?;
        let (returns, name) = cut(head, b' ')?;
        let mut prototype = Prototype {
            name,
            returns: Form::of(returns)?,
            params: [Form::One(Type::VOID); MAX_PARAMS],
            count: 0,
            out: 0,
            constant: 0,
        };
        for slot in &mut prototype.params {
            let (param, others) = cut(list, b',').unwrap_or((list, ""));
            let (mut word, mut rest) = cut(param, b' ')?;
            let bit = 1 << prototype.count;
            match word {
                "out" => prototype.out |= bit,
                "const" => prototype.constant |= bit,
                _ => rest = "",
            }
            if let Some((ty, _)) = cut(rest, b' ') {
                word = ty;
            }
            *slot = Form::of(word)?;
            prototype.count += 1;
            if others.is_empty() {
                break;
            }
            list = others.strip_prefix(' ')?;
        }
        Some(prototype)
    }

    /// Adds the overloads that it stands for to those of its function.
    pub fn expand(&self, function: BuiltinId, overloads: &mut Vec<Overload>) {
        let forms = self.params.iter().chain([&self.returns]);
        let variants = forms.map(|form| form.count()).max().unwrap_or(1);
        overloads.reserve(variants.into());
        for variant in 0..variants {
            let overload = Overload {
                function,
                params: self.params.map(|form| form.get(variant)),
                count: self.count,
                out: self.out,
                constant: self.constant,
                returns: self.returns.get(variant),
            };
            // `min(genType, float)` and `min(genType, genType)` are one for scalars.
            let is_first = variant == 0;
            if !is_first || overloads.iter().all(|o| o.params() != overload.params()) {
                overloads.push(overload);
            }
        }
    }
}

/// Reads `storage precision type name[size] = value;`.
pub(super) fn read_variable(line: &'static str) -> Option<(&'static str, BuiltinVariable)> {
    let line = line.strip_suffix(';')?;
    let (declared, value) = line.split_once(" = ").unwrap_or((line, ""));
    let (head, name) = declared.rsplit_once(' ')?;
    let (name, size) = name.split_once('[').unwrap_or((name, ""));
    let (storage, rest) = head.split_once(' ')?;
    let storage = match storage {
        "in" => BuiltinStorage::In,
        "out" => BuiltinStorage::Out,
        "uniform" => BuiltinStorage::Uniform,
        "const" => BuiltinStorage::Const(value.parse().ok()?),
        _ => return None,
    };
    let array = size.strip_suffix(']').map_or(Some(0), |n| n.parse().ok())?;
    let (first, ty) = rest.split_once(' ').unwrap_or(("", rest));
    let precision = match first {
        "highp" => Some(QualifierKind::Highp),
        "mediump" => Some(QualifierKind::Mediump),
        _ => None,
    };
    let ty = match first {
        "struct" => None,
        _ => Some(type_named(ty)?.array_of(array)),
    };
    let variable = BuiltinVariable {
        ty,
        storage,
        precision,
    };
    Some((name, variable))
}
