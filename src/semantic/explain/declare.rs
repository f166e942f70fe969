//! What is wrong with declarations of variables.

use super::*;

impl Explain for DeclarationError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use DeclarationError as E;
        match self {
            E::Void => c.error(error::VOID_VALUE, at, "a variable cannot be `void`"),
            E::Sampler => c
                .error(
                    error::SAMPLER_RESTRICTION,
                    at,
                    "a sampler must be a `uniform` or a parameter",
                )
                .note("samplers cannot be copied into variables (section 4.1.7)"),
            E::NoValue(name) => {
                let message = format!("the constant `{}` has no value", c.text(name));
                c.error(error::NOT_CONSTANT, at, message)
            }
            E::Value(storage) => {
                let word = storage.name();
                let message = format!("a variable that is `{word}` cannot have an initial value");
                c.error(error::INVALID_QUALIFIER, at, message)
                    .note("its value comes from outside")
            }
        }
    }
}
