//! Versions of GLSL ES and the features of each.

use super::names::Version;

/// A feature that only some versions of the language have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Feature {
    /// Unsigned integers: `uint`, `1u`.
    UnsignedIntegers,
    /// Integer and bitwise operators: `%`, `<<`, `&`, `~`.
    IntegerOperators,
    /// The suffix `f` of float literals.
    FloatSuffix,
    /// Arrays, and structs that contain them, as values: construction, assignment, comparison,
    /// return.
    ArrayValues,
    /// Uniform and other interface blocks.
    Blocks,
    /// `in` and `out` variables instead of `attribute`, `varying` and the built-in outputs.
    InOut,
    /// Loops and indices without the restrictions of GLSL ES 1.00 Appendix A.
    FreeControlFlow,
    /// More than one prototype of the same function.
    RepeatedPrototypes,
    /// User overloads of built-in functions with other parameters.
    OverloadedBuiltins,
    /// Global variables initialised with a uniform or another global variable.
    LooseInitializers,
    /// The comma operator of two constants is a constant expression.
    ConstantComma,
    /// `invariant` inputs of fragment shaders, which must match the vertex outputs.
    InvariantInputs,
    /// Integer, array, shadow and 3D samplers.
    SamplerTypes,
    /// Overloaded lookups such as `texture` instead of `texture2D` and related functions.
    OverloadedLookups,
    /// Integers that do not fit in 32 bits are errors.
    IntegerLimit,
    /// Attributes that are never read still use a location.
    UnreadAttributes,
}

/// Description of one version of the language.
#[derive(Debug)]
pub struct LanguageProfile {
    /// The version described.
    pub version: Version,
    /// Display name, e.g. `GLSL ES 3.00`.
    pub name: &'static str,
    /// Value of `__VERSION__`.
    pub number: u32,
    /// The `#version` line including its line break; empty for the version used without a
    /// directive.
    pub directive: &'static str,
    /// Section of the specification that lists the reserved words.
    pub reserved_words: &'static str,
    features: u32,
}

const fn features(all: &[Feature]) -> u32 {
    let mut bits = 0;
    let mut rest = all;
    while let [first, after @ ..] = rest {
        bits |= 1 << *first as u32;
        rest = after;
    }
    bits
}

impl LanguageProfile {
    /// Whether the version supports a feature.
    pub const fn has(&self, feature: Feature) -> bool {
        self.features >> feature as u32 & 1 != 0
    }
}

/// GLSL ES 1.00 as restricted by WebGL.
pub static ES_100: LanguageProfile = LanguageProfile {
    version: Version::Es100,
    name: "GLSL ES 1.00",
    number: 100,
    directive: "",
    reserved_words: "section 3.7",
    features: features(&[
        Feature::OverloadedBuiltins,
        Feature::LooseInitializers,
        Feature::ConstantComma,
        Feature::InvariantInputs,
    ]),
};

/// GLSL ES 3.00.
pub static ES_300: LanguageProfile = LanguageProfile {
    version: Version::Es300,
    name: "GLSL ES 3.00",
    number: 300,
    directive: "#version 300 es\n",
    reserved_words: "section 3.8",
    features: features(&[
        Feature::UnsignedIntegers,
        Feature::IntegerOperators,
        Feature::FloatSuffix,
        Feature::ArrayValues,
        Feature::Blocks,
        Feature::InOut,
        Feature::FreeControlFlow,
        Feature::RepeatedPrototypes,
        Feature::SamplerTypes,
        Feature::OverloadedLookups,
        Feature::IntegerLimit,
        Feature::UnreadAttributes,
    ]),
};

impl Version {
    /// The newest supported version.
    pub const NEWEST: Version = Version::Es300;

    /// The description of this version.
    pub const fn profile(self) -> &'static LanguageProfile {
        match self {
            Version::Es100 => &ES_100,
            Version::Es300 => &ES_300,
        }
    }

    /// Whether the version supports a feature.
    pub const fn has(self, feature: Feature) -> bool {
        self.profile().has(feature)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_have_the_features_of_their_profile() {
        for version in [Version::Es100, Version::Es300] {
            assert_eq!(version.profile().version, version);
        }
        assert!(Version::Es300.has(Feature::ArrayValues));
        assert!(!Version::Es100.has(Feature::ArrayValues));
        assert!(Version::Es100.has(Feature::ConstantComma));
        assert!(!Version::Es300.has(Feature::ConstantComma));
    }
}
