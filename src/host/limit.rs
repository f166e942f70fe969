//! What a host does not accept in shaders although WebGL2 does.

use super::near::none_of;

macro_rules! limits {
    ($($variant:ident $name:literal $description:literal,)*) => {
        /// A part of the language that a host does not accept.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Limit {
            $(#[doc = $description] $variant,)*
        }

        impl Limit {
            /// All variants.
            pub const ALL: &[Limit] = &[$(Limit::$variant),*];

            /// The name in host files.
            pub fn name(self) -> &'static str {
                match self { $(Limit::$variant => $name,)* }
            }

            /// What is not accepted.
            pub fn description(self) -> &'static str {
                match self { $(Limit::$variant => $description,)* }
            }
        }
    };
}

limits! {
    Samplers "samplers" "samplers other than `sampler2D`",
    Lookups "lookups" "texture functions other than `texture` with two arguments",
    Varyings "varyings" "varyings",
    Blocks "blocks" "uniform blocks",
    Unsigned "unsigned" "unsigned integers",
    Numbers "numbers" "uniforms of integers and booleans",
}

impl Limit {
    /// The limit with a name in host files.
    pub(super) fn named(word: &str) -> Result<Limit, String> {
        let found = Limit::ALL.iter().copied().find(|l| l.name() == word);
        found.ok_or_else(|| {
            let names: Vec<&str> = Limit::ALL.iter().map(|l| l.name()).collect();
            none_of(word, &names)
        })
    }
}
