//! Functions and constants that many shaders use although GLSL does not have them: definitions to insert
//! where one is missing.
//!
//! Each function stands in a file of its name, with the overloads that are called so, as code of
//! GLSL ES 1.00 that 3.00 accepts as well, or has built in. The files are texts of their own under the
//! 0BSD licence, so that what is inserted obliges nobody to anything.

macro_rules! files {
    ($($folder:ident: $($name:ident)*;)*) => {
        &[$($((
            stringify!($name),
            include_str!(concat!(stringify!($folder), "/", stringify!($name), ".glsl")),
        )),*),*]
    };
}

/// The texts of the functions by name.
#[rustfmt::skip]
const FUNCTIONS: &[(&str, &str)] = files! {
    color: ACESFilm aces aces_approx hsl2rgb hsv2rgb luma luminance pal palette rgb2hsv sRGB;
    distance: sdBox sdCappedCylinder sdCapsule sdCircle sdCylinder sdHexPrism sdHexagon sdOctahedron
        sdPlane sdRoundBox sdRoundCone sdSegment sdSphere sdTorus;
    hash: hash hash11 hash12 hash13 hash2 hash21 hash22 hash23 hash3 hash31 hash32 hash33 hash41 hash42
        hash43 hash44 rand random;
    math: checker cmul dot2 map remap saturate tanh_approx;
    noise: cellular cnoise fade fbm gnoise mod289 noise permute snoise taylorInvSqrt voronoi worley;
    rotation: erot rot rotX rotY rotZ rotate rotate2d rotateX rotateY rotateZ setCamera;
    shapes: opIntersection opRep opSmoothIntersection opSmoothSubtraction opSmoothUnion opSubtraction opU
        opUnion pmax pmin smax smin;
    webgl1: cosh inverse round sinh tanh transpose trunc;
};

/// The constants, each with its comment.
const CONSTANTS: &str = include_str!("constants.glsl");

/// A definition that can be inserted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LibraryDefinition {
    /// Name of the function or constant.
    pub name: &'static str,
    /// Type of the value.
    pub ty: &'static str,
    /// Types of the parameters; none for a constant.
    pub params: Vec<&'static str>,
    /// What it does, as a sentence.
    pub about: &'static str,
    /// The code, with the comment that belongs to it.
    pub text: &'static str,
}

/// All names of functions.
pub fn function_names() -> impl Iterator<Item = &'static str> {
    FUNCTIONS.iter().map(|(name, _)| *name)
}

/// What the functions of a name do, as a sentence; empty for an unknown name.
pub fn about(name: &str) -> &'static str {
    let found = FUNCTIONS.iter().find(|(known, _)| *known == name);
    let head = found.and_then(|(_, text)| text.lines().next());
    head.unwrap_or("").trim_start_matches("// ")
}

/// The functions with a name, or with one that differs in the case of letters only.
pub fn functions(name: &str) -> Vec<LibraryDefinition> {
    let exact = FUNCTIONS.iter().find(|(known, _)| *known == name);
    let alike = || {
        FUNCTIONS
            .iter()
            .find(|(known, _)| known.eq_ignore_ascii_case(name))
    };
    let found = exact.or_else(alike);
    found.map_or(Vec::new(), |(name, text)| overloads(name, text))
}

/// The constant with a name, or with one that differs in the case of letters only.
pub fn constant(name: &str) -> Option<LibraryDefinition> {
    let mut lines = CONSTANTS.lines();
    while let Some(comment) = lines.next() {
        let text = lines.next()?;
        let mut words = text.split_whitespace().skip(1);
        let (ty, known) = (words.next()?, words.next()?);
        if known.eq_ignore_ascii_case(name) {
            return Some(LibraryDefinition {
                name: known,
                ty,
                params: Vec::new(),
                about: comment.trim_start_matches("// "),
                text,
            });
        }
    }
    None
}

impl LibraryDefinition {
    /// The code under another name.
    pub fn named(&self, name: &str) -> String {
        match name == self.name {
            true => self.text.to_string(),
            false => self
                .text
                .replacen(&format!(" {}", self.name), &format!(" {name}"), 1),
        }
    }

    /// The functions of the library that this one calls, those that they call first.
    pub fn called(&self) -> Vec<LibraryDefinition> {
        let mut all = Vec::new();
        self.add_called(&mut all);
        all
    }

    fn add_called(&self, all: &mut Vec<LibraryDefinition>) {
        let body = self.text.split_once('{').map_or("", |(_, body)| body);
        let words = body.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
        for (name, text) in FUNCTIONS {
            if *name == self.name || !words.clone().any(|word| word == *name) {
                continue;
            }
            let overloads = overloads(name, text);
            // Calls pass on the first parameter, if the types of overloads differ in it.
            let is_same = |d: &&LibraryDefinition| d.params.first() == self.params.first();
            let meant: Vec<&LibraryDefinition> =
                match overloads.iter().filter(is_same).take(1).next() {
                    Some(one) => vec![one],
                    None => overloads.iter().collect(),
                };
            for definition in meant {
                definition.add_called(all);
                if !all.contains(definition) {
                    all.push(definition.clone());
                }
            }
        }
    }
}

/// The overloads in a text: after its head, each with a comment and a blank line before it.
fn overloads(name: &'static str, text: &'static str) -> Vec<LibraryDefinition> {
    let parts = text.trim_end().split("\n\n").skip(1);
    parts.filter_map(|text| overload(name, text)).collect()
}

fn overload(name: &'static str, text: &'static str) -> Option<LibraryDefinition> {
    let (comment, code) = text.split_once('\n')?;
    let (ty, rest) = code.split_once(' ')?;
    let params = rest.split_once('(')?.1.split_once(')')?.0;
    let first_word = |param: &'static str| param.trim().split(' ').next();
    Some(LibraryDefinition {
        name,
        ty,
        params: params.split(',').filter_map(first_word).collect(),
        about: comment.trim_start_matches("// "),
        text,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_has_a_licence_and_documented_functions_of_its_name() {
        for (name, text) in FUNCTIONS {
            let mut lines = text.lines();
            assert!(lines.next().unwrap().starts_with("// "), "{name}");
            assert_eq!(
                lines.next(),
                Some("// SPDX-License-Identifier: 0BSD"),
                "{name}"
            );
            let found = overloads(name, text);
            assert!(!found.is_empty(), "{name}");
            for d in found {
                assert!(d.text.starts_with("// ") && d.text.ends_with('}'), "{name}");
                let head = format!("\n{} {name}({}", d.ty, d.params[0]);
                assert!(d.text.contains(&head), "{head}");
            }
        }
    }

    #[test]
    fn called_functions_come_before_their_callers() {
        let fbm = &functions("fbm")[0];
        let called: Vec<String> = fbm.called().iter().map(|d| d.name.to_string()).collect();
        assert_eq!(called, ["hash12", "noise"]);
        assert_eq!(
            functions("rot")[0].named("Rot").lines().nth(1),
            Some("mat2 Rot(float angle) {")
        );
    }

    #[test]
    fn constants_are_found_in_any_case() {
        let pi = constant("pi").unwrap();
        assert_eq!(pi.named("pi"), "const float pi = 3.14159265359;");
        assert_eq!(constant("speed"), None);
    }
}
