//! What is wrong with what passes between stages.

use super::*;

impl Explain for InterfaceError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use InterfaceError as E;
        let say = |message: &str| c.error(error::INTERFACE_TYPE, at, message);
        match self {
            E::Type(storage, ty) => say(&format!(
                "`{}` cannot be `{}`",
                storage.name(),
                c.name_of(ty)
            )),
            E::Bool(storage) => say(&format!("`{}` cannot be `bool`", storage.name())),
            E::Struct(storage) => say(&format!("`{}` cannot be a struct", storage.name())),
            E::InputArray => say("an input of a vertex shader cannot be an array"),
            E::OutputMatrix => say("an output of a fragment shader cannot be a matrix"),
            E::NotFlat(storage) => {
                let word = storage.name();
                say(&format!(
                    "an integer that is passed between stages must be `flat {word}`"
                ))
            }
            E::ArrayOfStructs => say("an array of structs cannot be passed between stages"),
            E::ArrayInside => say("a struct that holds an array cannot be passed between stages"),
            E::StructInside => say("a struct that holds a struct cannot be passed between stages"),
            E::BoolInside => say("a struct that holds a `bool` cannot be passed between stages"),
        }
    }
}
