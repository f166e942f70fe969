//! Values as scalars.

use serde::Serialize;
use shaderlint_semantic::{Program, Scalar, Type};
use shaderlint_text::number::shortest_decimal;

/// A scalar of a value.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[serde(untagged)]
pub enum TracedScalar {
    /// A finite number.
    Number(f64),
    /// `NaN`, `inf` or `-inf`.
    NotFinite(&'static str),
    /// A truth value.
    Truth(bool),
}

/// How many scalars are shown to people.
const SHOWN: usize = 16;

impl TracedScalar {
    fn of(kind: Scalar, bits: u32) -> TracedScalar {
        match kind {
            Scalar::Bool => TracedScalar::Truth(bits != 0),
            Scalar::Int => TracedScalar::Number(f64::from(bits as i32)),
            Scalar::Uint => TracedScalar::Number(f64::from(bits)),
            Scalar::Float => match f32::from_bits(bits) {
                n if n.is_nan() => TracedScalar::NotFinite("NaN"),
                f32::INFINITY => TracedScalar::NotFinite("inf"),
                f32::NEG_INFINITY => TracedScalar::NotFinite("-inf"),
                n => TracedScalar::Number(shortest_decimal(n)),
            },
        }
    }

    fn text(&self) -> String {
        match self {
            // Numbers have at most the digits of a `float`, or are integers.
            TracedScalar::Number(n) if n.abs() < 1e10 && (n.abs() >= 1e-5 || *n == 0.0) => {
                n.to_string()
            }
            TracedScalar::Number(n) => format!("{n:e}"),
            TracedScalar::NotFinite(word) => (*word).to_string(),
            TracedScalar::Truth(truth) => truth.to_string(),
        }
    }
}

/// The scalars of a value of this type, as many as there are bits.
pub fn scalars(program: &Program, ty: Type, bits: &[u32]) -> Vec<TracedScalar> {
    let mut kinds = Vec::new();
    add_kinds(program, ty, bits.len(), &mut kinds);
    let all = bits.iter().zip(kinds);
    all.map(|(bits, kind)| TracedScalar::of(kind, *bits))
        .collect()
}

/// Adds the kinds of the scalars of a type, until there are `most`.
fn add_kinds(program: &Program, ty: Type, most: usize, kinds: &mut Vec<Scalar>) {
    if ty.array > 0 {
        for _ in 0..ty.array {
            if kinds.len() >= most {
                return;
            }
            add_kinds(program, ty.element(), most, kinds);
        }
        return;
    }
    match (ty.numeric(), program.struct_of(ty)) {
        (Some((kind, columns, rows)), _) => {
            let count = usize::from(columns) * usize::from(rows);
            kinds.extend(std::iter::repeat_n(kind, count));
        }
        (None, Some(known)) => {
            for field in &known.fields {
                add_kinds(program, field.ty, most, kinds);
            }
        }
        (None, None) => {}
    }
}

/// Scalars as text.
pub fn shown(scalars: &[TracedScalar]) -> String {
    let mut words: Vec<String> = scalars.iter().take(SHOWN).map(TracedScalar::text).collect();
    if scalars.len() > SHOWN {
        words.push("...".to_string());
    }
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_printed_with_the_fewest_digits_that_identify_them() {
        let all = [
            0.1_f32,
            -0.0,
            1.0,
            3.0e-9,
            2.5e12,
            f32::NAN,
            f32::NEG_INFINITY,
        ];
        let all = all.map(|n| TracedScalar::of(Scalar::Float, n.to_bits()));
        assert_eq!(shown(&all), "0.1 -0 1 3e-9 2.5e12 NaN -inf");
        let others = [
            TracedScalar::of(Scalar::Int, u32::MAX),
            TracedScalar::of(Scalar::Uint, u32::MAX),
            TracedScalar::of(Scalar::Bool, u32::MAX),
        ];
        assert_eq!(shown(&others), "-1 4294967295 true");
        assert!(shown(&vec![TracedScalar::Truth(true); 17]).ends_with("..."));
    }
}
