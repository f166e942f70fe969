//! Types, functions and values of other languages, with their GLSL equivalents. In GLSL these are
//! ordinary identifiers, so a word counts as foreign only where it is not declared.

use super::names::{TypeWord, Version, WordClass, classify};
use rustc_hash::FxHashMap;
use std::sync::OnceLock;

/// GLSL equivalent of a foreign word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Meaning {
    /// A GLSL type.
    Type(&'static str),
    /// A placeholder for an inferred type, such as `auto`; GLSL needs the type of the initializer.
    Inferred,
    /// A GLSL function with the same arguments.
    Function(&'static str),
    /// GLSL code with `$1` to `$4` for the arguments, and the number of arguments.
    Code(&'static str, usize),
    /// As `Code`, but not equivalent in every case; the last string explains the difference.
    Nearly(&'static str, usize, &'static str),
    /// GLSL code that must be a statement.
    Statement(&'static str, usize),
    /// A GLSL expression.
    Value(&'static str),
    /// A null value; 0 is the closest equivalent.
    Zero,
    /// No equivalent: prints or asserts something, so the statement can be removed.
    Silent,
    /// A namespace; its members are plain names in GLSL.
    Namespace,
    /// No equivalent; the string explains why or what to use.
    Absent(&'static str),
}

/// A word of another language.
#[derive(Clone, Copy, Debug)]
pub struct Foreign {
    /// Name of the language for messages.
    pub language: &'static str,
    /// What to use in GLSL.
    pub meaning: Meaning,
}

use Meaning::*;

impl Meaning {
    /// Parses a meaning, such as `code ($1 * $2)`. There are as many arguments as the highest number
    /// in it.
    fn read(text: &'static str) -> Option<Meaning> {
        let (kind, rest) = text.split_once(' ').unwrap_or((text, ""));
        let is_used = |number: &usize| rest.contains(&format!("${number}"));
        let count = (1..=4).rev().find(is_used).unwrap_or(0);
        Some(match kind {
            "type" => Type(rest),
            "inferred" => Inferred,
            "function" => Function(rest),
            "code" => Code(rest, count),
            "nearly" => {
                let (code, difference) = rest.split_once(" | ")?;
                Nearly(code, count, difference)
            }
            "statement" => Statement(rest, count),
            "value" => Value(rest),
            "zero" => Zero,
            "silent" => Silent,
            "namespace" => Namespace,
            "absent" => Absent(rest),
            _ => return None,
        })
    }
}

/// The name of each language, in order of priority, and its words as indented lines
/// `WORDS = MEANING`.
const LANGUAGES: &str = include_str!("foreign_words.txt");

/// All words by name; a word of several languages belongs to the first.
fn words() -> &'static FxHashMap<&'static str, Foreign> {
    static WORDS: OnceLock<FxHashMap<&str, Foreign>> = OnceLock::new();
    WORDS.get_or_init(|| {
        let mut all = FxHashMap::default();
        let mut language = "";
        for line in LANGUAGES.lines() {
            let Some((words, meaning)) = line.split_once(" = ") else {
                language = line;
                continue;
            };
            for word in words.split_whitespace() {
                if let Some(meaning) = Meaning::read(meaning) {
                    all.entry(word).or_insert(Foreign { language, meaning });
                }
            }
        }
        all
    })
}

/// Looks up a word of another language.
pub fn foreign(word: &str, version: Version) -> Option<Foreign> {
    if word.is_empty() {
        return None;
    }
    if let Some(found) = words().get(word) {
        return Some(*found);
    }
    if let Some((language, ty)) = foreign_type(word, version) {
        let meaning = Type(ty);
        return Some(Foreign { language, meaning });
    }
    let plain = word.strip_suffix('f').filter(|w| SUFFIXED.contains(w))?;
    let function = SUFFIXED.iter().find(|w| **w == plain)?;
    Some(Foreign {
        language: "C",
        meaning: Function(function),
    })
}

/// Functions that C spells with the suffix `f`.
#[rustfmt::skip]
const SUFFIXED: &[&str] = &[
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "pow", "exp", "exp2", "log", "log2", "sqrt", "floor", "ceil", "round", "trunc", "mix", "clamp",
    "step", "sign",
];

/// Scalar types from which other languages form the names of vectors and matrices.
#[rustfmt::skip]
const SCALARS: &[(&str, &str)] = &[
    ("float", "float"), ("half", "float"), ("fixed", "float"), ("real", "float"), ("double", "float"),
    ("min16float", "float"), ("min10float", "float"), ("packed_float", "float"), ("Vector", "float"),
    ("vector", "float"), ("Vec", "float"), ("Color", "float"), ("int", "int"), ("short", "int"), ("long", "int"),
    ("min16int", "int"), ("uint", "uint"), ("min16uint", "uint"), ("ushort", "uint"), ("bool", "bool"),
];

/// Parses composed type names such as `float3`, `half4x4`, `vec3f` and `Vec3`.
fn foreign_type(word: &str, version: Version) -> Option<(&'static str, &'static str)> {
    let known = |text: &str| match classify(text, version) {
        WordClass::Type(word) => Some(word.name()),
        _ => None,
    };
    let starts_with_digit = |w: &&str| w.starts_with(|c: char| c.is_ascii_digit());
    let rest = word.strip_prefix("vec").or(word.strip_prefix("mat"));
    if let Some(rest) = rest.filter(starts_with_digit) {
        // `vec3f`, `vec3i`, `mat4x4f`
        let (size, suffix) = rest.split_at_checked(rest.len().checked_sub(1)?)?;
        let prefix = match suffix {
            "f" | "h" | "d" => "",
            "i" => "i",
            "u" => "u",
            "b" => "b",
            _ => return None,
        };
        return Some(("WGSL", known(&format!("{prefix}{}{size}", word.get(..3)?))?));
    }
    let digits = word.find(|c: char| c.is_ascii_digit() && c != '1' && c != '0')?;
    if let Some((_, scalar)) = SCALARS
        .iter()
        .find(|(s, _)| {
            word.strip_prefix(s)
                .is_some_and(|r| !r.is_empty() && r.len() <= 3)
        })
        .filter(|(s, _)| s.len() == digits || s.contains('1'))
    {
        let size = word
            .rsplit(|c: char| c.is_ascii_alphabetic() && c != 'x')
            .next()?;
        let prefix = match *scalar {
            "float" => "",
            other => other.get(..1)?,
        };
        let text = match size.split_once('x') {
            // HLSL states rows before columns.
            Some((rows, columns)) => format!("mat{columns}x{rows}"),
            None => format!("{prefix}vec{size}"),
        };
        return Some(("HLSL", known(&text)?));
    }
    None
}

/// The GLSL type that `word` matches if letter case is ignored.
pub fn type_in_another_case(word: &str, version: Version) -> Option<TypeWord> {
    TypeWord::ALL
        .iter()
        .copied()
        .find(|t| t.name().eq_ignore_ascii_case(word))
        .filter(|t| matches!(classify(t.name(), version), WordClass::Type(_)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::each_case;

    #[test]
    fn every_meaning_can_be_read() {
        for (_, meaning) in LANGUAGES.lines().filter_map(|line| line.split_once(" = ")) {
            assert!(Meaning::read(meaning).is_some(), "{meaning}");
        }
    }

    #[test]
    fn types_of_other_languages_map_to_glsl_types() {
        each_case(include_str!("foreign.txt"), |word, expected| {
            let found = foreign(word, Version::Es300).map(|f| match f.meaning {
                Type(t) | Function(t) | Value(t) | Code(t, _) | Nearly(t, ..) | Statement(t, _) => {
                    t
                }
                _ => "?",
            });
            assert_eq!(found.unwrap_or("none"), expected, "{word}");
        });
    }
}
