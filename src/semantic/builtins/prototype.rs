//! Parses the declarations of built-in functions and variables: GLSL, one per line. This happens at
//! compile time, so it costs nothing at startup and invalid declarations do not compile.
#![expect(
    clippy::panic,
    clippy::indexing_slicing,
    reason = "evaluated at compile time, where a wrong index does not compile"
)]

use super::overload::{BuiltinStorage, BuiltinVariable, MAX_PARAMS, Overload};
use super::table::BuiltinId;
use crate::types::{Sampler, Scalar, Type};
use shaderlint_syntax::TypeWord;
use shaderlint_syntax::ast::QualifierKind;

/// Number of built-in functions.
const FUNCTIONS: usize = BuiltinId::ALL.len();
/// Capacity for the overloads of all functions.
const MAX_OVERLOADS: usize = 640;
const MAX_VARIABLES: usize = 32;

/// Declarations of one or more texts, in their order.
#[derive(Clone, Copy)]
pub(super) struct Declared {
    overloads: [Overload; MAX_OVERLOADS],
    /// Number of overloads.
    pub count: usize,
    /// By function: index of its first overload, or the end.
    first: [usize; FUNCTIONS],
    variables: [(&'static str, BuiltinVariable); MAX_VARIABLES],
    pub variable_count: usize,
}

impl Declared {
    /// No declarations.
    pub const NOTHING: Declared = Declared {
        overloads: [Overload::NONE; MAX_OVERLOADS],
        count: 0,
        first: [MAX_OVERLOADS; FUNCTIONS],
        variables: [("", BuiltinVariable::NONE); MAX_VARIABLES],
        variable_count: 0,
    };

    /// Adds the declarations of a text in the notation described in `functions_300.glsl`.
    pub const fn and(mut self, text: &'static str) -> Declared {
        let mut words = PrototypeWords { rest: text };
        while words.skip() {
            self.declaration(&mut words);
        }
        self
    }

    const fn declaration(&mut self, words: &mut PrototypeWords) {
        let first = words.word();
        let storage = match first.as_bytes() {
            b"in" => BuiltinStorage::In,
            b"out" => BuiltinStorage::Out,
            b"uniform" => BuiltinStorage::Uniform,
            b"const" => BuiltinStorage::Const(0),
            _ => return self.expand(&Prototype::read(first, words)),
        };
        self.variables[self.variable_count] = read_variable(storage, words);
        self.variable_count += 1;
    }

    /// Adds all overloads of a prototype.
    const fn expand(&mut self, prototype: &Prototype) {
        let mut variants = prototype.returns.count();
        let mut i = 0;
        while i < MAX_PARAMS {
            let count = prototype.params[i].count();
            variants = if count > variants { count } else { variants };
            i += 1;
        }
        let mut variant = 0;
        while variant < variants {
            let mut overload = Overload {
                function: prototype.function,
                params: [Type::VOID; MAX_PARAMS],
                count: prototype.count,
                out: prototype.out,
                constant: prototype.constant,
                returns: prototype.returns.get(variant),
            };
            let mut i = 0;
            while i < MAX_PARAMS {
                overload.params[i] = prototype.params[i].get(variant);
                i += 1;
            }
            if !self.has(&overload) {
                let first = &mut self.first[overload.function as usize];
                *first = if self.count < *first {
                    self.count
                } else {
                    *first
                };
                self.overloads[self.count] = overload;
                self.count += 1;
            }
            variant += 1;
        }
    }

    /// Whether an equal overload exists: `min(genType, float)` and `min(genType, genType)` are the
    /// same for scalars.
    const fn has(&self, overload: &Overload) -> bool {
        let mut i = self.first[overload.function as usize];
        while i < self.count {
            let other = &self.overloads[i];
            let mut is_same = other.function as u8 == overload.function as u8;
            is_same &= other.count == overload.count;
            let mut k = 0;
            while k < MAX_PARAMS && is_same {
                is_same = k >= other.count as usize
                    || match (other.params[k].numeric(), overload.params[k].numeric()) {
                        (Some((s, c, r)), Some((scalar, columns, rows))) => {
                            s as u8 == scalar as u8 && c == columns && r == rows
                        }
                        _ => false,
                    };
                k += 1;
            }
            if is_same {
                return true;
            }
            i += 1;
        }
        false
    }

    /// By function: index of its first overload, with the total count as the last entry.
    pub const fn starts(&self) -> [u16; FUNCTIONS + 1] {
        let mut starts = [0; FUNCTIONS + 1];
        let mut i = 0;
        while i < self.count {
            starts[self.overloads[i].function as usize + 1] += 1;
            i += 1;
        }
        let mut i = 0;
        while i < FUNCTIONS {
            starts[i + 1] += starts[i];
            i += 1;
        }
        starts
    }

    /// All `N` overloads, grouped by function.
    pub const fn overloads<const N: usize>(&self) -> [Overload; N] {
        let mut sorted = [Overload::NONE; N];
        let mut next = self.starts();
        let mut i = 0;
        while i < N {
            let overload = self.overloads[i];
            let at = &mut next[overload.function as usize];
            sorted[*at as usize] = overload;
            *at += 1;
            i += 1;
        }
        sorted
    }

    /// All `N` variables.
    pub const fn variables<const N: usize>(&self) -> [(&'static str, BuiltinVariable); N] {
        let mut variables = [self.variables[0]; N];
        let mut i = 0;
        while i < N {
            variables[i] = self.variables[i];
            i += 1;
        }
        variables
    }
}

/// A text read word by word.
struct PrototypeWords {
    rest: &'static str,
}

impl PrototypeWords {
    /// Consumes this many bytes.
    const fn take(&mut self, len: usize) -> &'static str {
        let (taken, rest) = self.rest.split_at(len);
        self.rest = rest;
        taken
    }

    /// Skips whitespace and comments; returns whether more text follows.
    const fn skip(&mut self) -> bool {
        let bytes = self.rest.as_bytes();
        let mut at = 0;
        while at < bytes.len() && (bytes[at].is_ascii_whitespace() || bytes[at] == b'/') {
            if bytes[at] == b'/' {
                while bytes[at] != b'\n' {
                    at += 1;
                }
            }
            at += 1;
        }
        self.take(at);
        !self.rest.is_empty()
    }

    /// Reads the next word or number.
    const fn word(&mut self) -> &'static str {
        self.skip();
        let bytes = self.rest.as_bytes();
        let mut len = 0;
        while len < bytes.len() && (bytes[len].is_ascii_alphanumeric() || bytes[len] == b'_') {
            len += 1;
        }
        self.take(len)
    }

    /// Consumes a punctuation character if it is next.
    const fn eat(&mut self, mark: u8) -> bool {
        let is_next = self.skip() && self.rest.as_bytes()[0] == mark;
        self.take(is_next as usize);
        is_next
    }

    /// Consumes a punctuation character that must be next.
    const fn expect(&mut self, mark: u8) {
        if !self.eat(mark) {
            panic!("invalid declaration of a built-in function or variable");
        }
    }

    /// Reads the next number.
    const fn number(&mut self) -> i32 {
        let sign = if self.eat(b'-') { -1 } else { 1 };
        match i32::from_str_radix(self.word(), 10) {
            Ok(number) => sign * number,
            Err(_) => panic!("expected a number"),
        }
    }
}

/// The types that a word of the notation stands for.
#[derive(Clone, Copy)]
enum GenericType {
    One(Type),
    /// Vectors from this many components up to four; one component is a scalar.
    Vectors(Scalar, u8),
    Matrices,
    /// One type each for `float`, `int` and `uint`.
    ByScalar([Type; 3]),
}

impl GenericType {
    const fn of(word: &str) -> GenericType {
        use Sampler::*;
        use Scalar::*;
        const fn samplers(all: [Sampler; 3]) -> GenericType {
            let [float, int, uint] = all;
            GenericType::ByScalar([
                Type::sampler(float),
                Type::sampler(int),
                Type::sampler(uint),
            ])
        }
        match word.as_bytes() {
            b"genType" => GenericType::Vectors(Float, 1),
            b"genIType" => GenericType::Vectors(Int, 1),
            b"genUType" => GenericType::Vectors(Uint, 1),
            b"genBType" => GenericType::Vectors(Bool, 1),
            b"vec" => GenericType::Vectors(Float, 2),
            b"ivec" => GenericType::Vectors(Int, 2),
            b"uvec" => GenericType::Vectors(Uint, 2),
            b"bvec" => GenericType::Vectors(Bool, 2),
            b"mat" => GenericType::Matrices,
            b"gvec4" => GenericType::ByScalar([
                Type::vector(Float, 4),
                Type::vector(Int, 4),
                Type::vector(Uint, 4),
            ]),
            b"gsampler2D" => samplers([Sampler2D, Isampler2D, Usampler2D]),
            b"gsampler3D" => samplers([Sampler3D, Isampler3D, Usampler3D]),
            b"gsamplerCube" => samplers([SamplerCube, IsamplerCube, UsamplerCube]),
            b"gsampler2DArray" => samplers([Sampler2DArray, Isampler2DArray, Usampler2DArray]),
            _ => GenericType::One(type_named(word)),
        }
    }

    const fn count(self) -> u8 {
        match self {
            GenericType::One(_) => 1,
            GenericType::Vectors(_, first) => 5 - first,
            GenericType::Matrices => 9,
            GenericType::ByScalar(all) => all.len() as u8,
        }
    }

    const fn get(self, variant: u8) -> Type {
        match self {
            GenericType::One(ty) => ty,
            GenericType::Vectors(scalar, first) => Type::vector(scalar, first + variant),
            GenericType::Matrices => Type::matrix(variant / 3 + 2, variant % 3 + 2),
            GenericType::ByScalar(all) => all[variant as usize],
        }
    }
}

const fn type_named(word: &str) -> Type {
    match TypeWord::named(word) {
        Some(word) => Type::of_word(word),
        None => panic!("expected a type"),
    }
}

/// A prototype in the notation of the declaration texts.
struct Prototype {
    function: BuiltinId,
    returns: GenericType,
    params: [GenericType; MAX_PARAMS],
    count: u8,
    out: u8,
    constant: u8,
}

impl Prototype {
    /// Reads `name(type name, ...);` after the return type.
    const fn read(returns: &str, words: &mut PrototypeWords) -> Prototype {
        let Some(function) = BuiltinId::named(words.word()) else {
            panic!("no row of the table has this name");
        };
        let mut prototype = Prototype {
            function,
            returns: GenericType::of(returns),
            params: [GenericType::One(Type::VOID); MAX_PARAMS],
            count: 0,
            out: 0,
            constant: 0,
        };
        words.expect(b'(');
        loop {
            let mut word = words.word();
            let bit = 1 << prototype.count;
            match word.as_bytes() {
                b"out" => prototype.out |= bit,
                b"const" => prototype.constant |= bit,
                _ => {}
            }
            if (prototype.out | prototype.constant) & bit != 0 {
                word = words.word();
            }
            prototype.params[prototype.count as usize] = GenericType::of(word);
            prototype.count += 1;
            words.word();
            if !words.eat(b',') {
                break;
            }
        }
        words.expect(b')');
        words.expect(b';');
        prototype
    }
}

/// Reads `precision type name[size] = value;` after the storage qualifier.
const fn read_variable(
    storage: BuiltinStorage,
    words: &mut PrototypeWords,
) -> (&'static str, BuiltinVariable) {
    let mut word = words.word();
    let precision = match word.as_bytes() {
        b"highp" => Some(QualifierKind::Highp),
        b"mediump" => Some(QualifierKind::Mediump),
        b"lowp" => Some(QualifierKind::Lowp),
        _ => None,
    };
    if precision.is_some() {
        word = words.word();
    }
    let is_struct = matches!(word.as_bytes(), b"struct");
    if is_struct {
        // The members are listed in the text only for readers.
        while !words.eat(b'}') {
            words.take(1);
        }
    }
    let name = words.word();
    let size = if words.eat(b'[') { words.number() } else { 0 };
    if size > 0 {
        words.expect(b']');
    }
    let storage = match storage {
        BuiltinStorage::Const(_) => {
            words.expect(b'=');
            BuiltinStorage::Const(words.number())
        }
        storage => storage,
    };
    words.expect(b';');
    let ty = match is_struct {
        true => None,
        false => Some(type_named(word).array_of(size as u32)),
    };
    let variable = BuiltinVariable {
        ty,
        storage,
        precision,
    };
    (name, variable)
}
