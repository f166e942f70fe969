//! Messages for [`DeclarationError`].

use super::*;

impl Explain for DeclarationError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use DeclarationError as E;
        match self {
            E::Void => c.error(error::VOID_VALUE, at, "a variable cannot have type `void`"),
            E::Sampler => c
                .error(
                    error::SAMPLER_RESTRICTION,
                    at,
                    "a sampler must be a `uniform` or a function parameter",
                )
                .note("samplers cannot be copied into variables (section 4.1.7)"),
            E::NoValue(name) => {
                let message = format!("constant `{}` has no initializer", c.text(name));
                c.error(error::NOT_CONSTANT, at, message)
            }
            E::Value(storage) => {
                let word = storage.name();
                let message = format!("`{word}` variables cannot have an initializer");
                c.error(error::INVALID_QUALIFIER, at, message)
                    .note("only `const` and unqualified variables accept an initializer")
            }
        }
    }
}
