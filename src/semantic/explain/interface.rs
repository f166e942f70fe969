//! Messages for [`InterfaceError`].

use super::*;

impl Explain for InterfaceError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use InterfaceError as E;
        let report = |message: &str| c.error(error::INTERFACE_TYPE, at, message);
        match self {
            E::Type(storage, ty) => report(&format!(
                "`{}` variables cannot have type `{}`",
                storage.name(),
                c.name_of(ty)
            )),
            E::Bool(storage) => report(&format!(
                "`{}` variables cannot have type `bool`",
                storage.name()
            )),
            E::Struct(storage) => {
                report(&format!("`{}` variables cannot be structs", storage.name()))
            }
            E::InputArray => report("a vertex shader input cannot be an array"),
            E::OutputMatrix => report("a fragment shader output cannot be a matrix"),
            E::NotFlat(storage) => {
                let word = if storage.is_input() { "in" } else { "out" };
                report(&format!(
                    "an integer passed between stages must be `flat {word}`"
                ))
            }
            E::ArrayOfStructs => report("an array of structs cannot be passed between stages"),
            E::ArrayInside => {
                report("a struct containing an array cannot be passed between stages")
            }
            E::StructInside => {
                report("a struct containing a struct cannot be passed between stages")
            }
            E::BoolInside => report("a struct containing a `bool` cannot be passed between stages"),
        }
    }
}
