//! Versions of the language as data: what each has, and how it is called.

use super::names::Version;

/// Something that one version of the language has and another has not.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Feature {
    /// Unsigned integers: `uint`, `1u`.
    UnsignedIntegers,
    /// Operators on integers and their bits: `%`, `<<`, `&`, `~`.
    IntegerOperators,
    /// The suffix `f` of numbers.
    FloatSuffix,
    /// Arrays, and structs that hold them, as values: constructed, assigned, compared, returned.
    ArrayValues,
    /// Interface blocks.
    Blocks,
    /// Variables that are `in` or `out`, in the place of `attribute`, `varying` and the language's
    /// own outputs.
    InOut,
    /// Loops and indices of any form, without the limits of GLSL ES 1.00 Appendix A.
    FreeControlFlow,
    /// Any number of prototypes of one function.
    RepeatedPrototypes,
    /// Functions with the name of a built-in one, and other parameters.
    OverloadedBuiltins,
    /// Global variables that start at the value of a uniform or of another global.
    LooseInitializers,
    /// The operator `,` between constants gives a constant.
    ConstantComma,
    /// Inputs of fragment shaders that are `invariant`, as the outputs are that they come from.
    InvariantInputs,
    /// What extensions added to GLSL ES 1.00.
    CoreExtensions,
    /// Samplers of integers, of layers, of depth and of volumes.
    SamplerTypes,
    /// Lookups that are called alike for all samplers: `texture`, in the place of `texture2D` and
    /// its kin.
    OverloadedLookups,
    /// Integers that do not fit into 32 bits are errors.
    IntegerLimit,
    /// Locations for the attributes that nothing reads.
    UnreadAttributes,
}

/// What one version of the language is.
#[derive(Debug)]
pub struct LanguageProfile {
    /// The version.
    pub version: Version,
    /// As people call it.
    pub name: &'static str,
    /// What `__VERSION__` stands for.
    pub number: u32,
    /// The line that asks for it, with its line break; empty where it is what a text without is.
    pub directive: &'static str,
    /// The section of its specification that lists the reserved words.
    pub reserved_words: &'static str,
    features: u32,
}

const fn features(all: &[Feature]) -> u32 {
    let mut bits = 0;
    let mut rest = all;
    while let [first, behind @ ..] = rest {
        bits |= 1 << *first as u32;
        rest = behind;
    }
    bits
}

impl LanguageProfile {
    /// Whether the version has something.
    pub const fn has(&self, feature: Feature) -> bool {
        self.features >> feature as u32 & 1 != 0
    }
}

/// GLSL ES 1.00, as WebGL limits it.
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
        Feature::CoreExtensions,
        Feature::SamplerTypes,
        Feature::OverloadedLookups,
        Feature::IntegerLimit,
        Feature::UnreadAttributes,
    ]),
};

impl Version {
    /// The newest version.
    pub const NEWEST: Version = Version::Es300;

    /// What the version is.
    pub const fn profile(self) -> &'static LanguageProfile {
        match self {
            Version::Es100 => &ES_100,
            Version::Es300 => &ES_300,
        }
    }

    /// Whether the version has something.
    pub const fn has(self, feature: Feature) -> bool {
        self.profile().has(feature)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_have_what_their_profiles_list() {
        for version in [Version::Es100, Version::Es300] {
            assert_eq!(version.profile().version, version);
        }
        assert!(Version::Es300.has(Feature::ArrayValues));
        assert!(!Version::Es100.has(Feature::ArrayValues));
        assert!(Version::Es100.has(Feature::ConstantComma));
        assert!(!Version::Es300.has(Feature::ConstantComma));
    }
}
