//! Generates programs with exactly known results: integers, and floats that are small integers, so
//! that every conforming implementation draws the same bits. The same seed always gives the same
//! program.
//!
//! The programs avoid everything that the language leaves undefined, except integer division by
//! zero, for which all tested implementations give the same result. Loops end by their own
//! counters.
//!
//! `mod.rs` contains the state of a program, `expression.rs` expressions, `statement.rs` the rest.

mod expression;
mod statement;

use crate::mutate::Random;

/// A program with the values of its uniforms.
pub struct Computing {
    /// The source: GLSL ES 3.00, a fragment shader with one output of type `uvec4`.
    pub text: String,
    /// The value of the uniform `seeds`, an `ivec4`.
    pub seeds: [i32; 4],
    /// The value of the uniform `parts`, a `vec4`.
    pub parts: [f32; 4],
}

/// The program for a seed.
pub fn compute(seed: u64) -> Computing {
    let mut random = Random::new(seed);
    // The first random numbers of small seeds are similar.
    for _ in 0..8 {
        random.below(2);
    }
    let mut int = || random.below(1 << 20) as i32 - (1 << 19);
    let seeds = [int(), int(), int() % 9, int() % 3];
    let parts = [0; 4].map(|_| (int() % 33) as f32);
    let mut writer = Writer {
        random,
        variables: Vec::new(),
        records: Vec::new(),
        functions: Vec::new(),
        names: 0,
        loops: 0,
        is_breakable: false,
        is_main: false,
        returns: None,
        called: 0,
    };
    let text = writer.program();
    Computing { text, seeds, parts }
}

/// Scalar type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Bool,
    Int,
    Uint,
    Float,
}

/// A type: a scalar, vector, matrix or struct, or an array of these.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Type {
    kind: Kind,
    columns: usize,
    rows: usize,
    /// Index of a struct; the other fields are then unused.
    record: Option<usize>,
    /// Array length; 0 if it is not an array.
    array: usize,
}

impl Type {
    const fn vector(kind: Kind, rows: usize) -> Type {
        Type {
            kind,
            columns: 1,
            rows,
            record: None,
            array: 0,
        }
    }

    const fn scalar(kind: Kind) -> Type {
        Type::vector(kind, 1)
    }

    const fn matrix(columns: usize, rows: usize) -> Type {
        Type {
            columns,
            ..Type::vector(Kind::Float, rows)
        }
    }

    const fn array_of(self, array: usize) -> Type {
        Type { array, ..self }
    }

    const fn element(self) -> Type {
        self.array_of(0)
    }

    fn is_plain(self) -> bool {
        self.array == 0 && self.record.is_none()
    }

    /// Its name in GLSL; for an array including the size.
    fn name(self) -> String {
        let name = match (self.record, self.kind, self.columns, self.rows) {
            (Some(record), ..) => format!("S{record}"),
            (_, Kind::Bool, _, 1) => "bool".to_string(),
            (_, Kind::Int, _, 1) => "int".to_string(),
            (_, Kind::Uint, _, 1) => "uint".to_string(),
            (_, Kind::Float, 1, 1) => "float".to_string(),
            (_, Kind::Bool, _, n) => format!("bvec{n}"),
            (_, Kind::Int, _, n) => format!("ivec{n}"),
            (_, Kind::Uint, _, n) => format!("uvec{n}"),
            (_, Kind::Float, 1, n) => format!("vec{n}"),
            (_, Kind::Float, c, r) => format!("mat{c}x{r}"),
        };
        match self.array {
            0 => name,
            n => format!("{name}[{n}]"),
        }
    }
}

#[derive(Clone, Debug)]
struct Variable {
    name: String,
    ty: Type,
    is_written: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    In,
    Out,
    Inout,
}

#[derive(Clone, Debug)]
struct Function {
    name: String,
    params: Vec<(Way, Type)>,
    returns: Option<Type>,
    /// Length of its text including all callees.
    size: usize,
}

/// Longest text of a function including all callees, which a browser's compiler may inline.
const LONGEST: usize = 8000;

/// A program that is being generated.
struct Writer {
    random: Random,
    variables: Vec<Variable>,
    /// Member types of each struct.
    records: Vec<Vec<Type>>,
    functions: Vec<Function>,
    names: usize,
    /// Number of enclosing loops.
    loops: usize,
    /// Whether `break` is allowed here.
    is_breakable: bool,
    is_main: bool,
    /// Return type of the current function.
    returns: Option<Type>,
    /// Total text length of all functions called by the current function.
    called: usize,
}

impl Writer {
    fn below(&mut self, limit: usize) -> usize {
        self.random.below(limit)
    }

    /// True with probability `1 / n`.
    fn one_in(&mut self, n: usize) -> bool {
        self.random.below(n) == 0
    }

    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.random.below(all.len())]
    }

    fn new_name(&mut self, letter: char) -> String {
        self.names += 1;
        format!("{letter}{}", self.names)
    }

    fn declare(&mut self, name: &str, ty: Type, is_written: bool) {
        self.variables.push(Variable {
            name: name.to_string(),
            ty,
            is_written,
        });
    }

    /// A scalar or vector, rarely a matrix.
    fn plain_type(&mut self) -> Type {
        let kinds = [
            Kind::Int,
            Kind::Int,
            Kind::Uint,
            Kind::Float,
            Kind::Float,
            Kind::Bool,
        ];
        let kind = self.pick(&kinds);
        let rows = self.pick(&[1, 1, 1, 2, 3, 4]);
        match kind {
            Kind::Float if self.one_in(4) => {
                let columns = self.below(3) + 2;
                Type::matrix(columns, self.below(3) + 2)
            }
            _ => Type::vector(kind, rows),
        }
    }

    /// A type that a variable may have.
    fn value_type(&mut self) -> Type {
        let ty = match self.records.len() {
            n if n > 0 && self.one_in(7) => Type {
                record: Some(self.below(n)),
                ..Type::scalar(Kind::Int)
            },
            _ => self.plain_type(),
        };
        match self.below(7) {
            0 => ty.array_of(self.pick(&[2, 3, 4, 8])),
            _ => ty,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::targets::is_accepted;
    use shaderlint::semantic::Stage;

    #[test]
    fn generated_programs_compile() {
        for seed in 1..=300 {
            let program = compute(seed);
            let accepted = is_accepted(&program.text, Stage::Fragment);
            assert!(accepted, "seed {seed}:\n{}", program.text);
        }
    }
}
