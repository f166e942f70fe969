//! What is wrong with a `switch`.

use super::*;

impl Explain for SwitchError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use SwitchError as E;
        let say = |message: &str| c.error(error::INVALID_SWITCH, at, message);
        // A number that is no integer becomes one.
        let to_integer = |value| match c.ty(value) {
            Type::FLOAT => c.convert(value, Scalar::Int),
            _ => None,
        };
        match self {
            E::Selector(value) => {
                let name = c.name_of(c.ty(value));
                say(&format!("`switch` wants an integer, not `{name}`")).fix(to_integer(value))
            }
            E::Label(value) => {
                let name = c.name_of(c.ty(value));
                say(&format!("a label must be an integer, not `{name}`")).fix(to_integer(value))
            }
            E::NotConstant(value) => {
                let message = "a label must be a constant expression";
                c.explain_not_constant(c.error(error::NOT_CONSTANT, at, message), value)
            }
            E::LabelType(value, selector) => {
                let (want, have) = (c.name_of(selector), c.name_of(c.ty(value)));
                let scalar = selector.scalar_kind().unwrap_or(Scalar::Int);
                say(&format!(
                    "the label is `{have}`, but `switch` compares `{want}`"
                ))
                .fix(c.convert(value, scalar))
            }
            E::Outside(word) => say(&format!("`{word}` can only stand directly in a `switch`")),
            E::Twice(first) => say("this label stands twice in the `switch`")
                .label(c.token_span(first), "the first one"),
            E::NothingBehind(dropped) => {
                let d = say("the last label of a `switch` has no statement");
                let d = match dropped {
                    Some(dropped) => {
                        d.label(c.span(dropped), "the browser drops this before it looks")
                    }
                    None => d,
                };
                d.help("put `break;` behind it")
            }
            E::BeforeLabels => say("this stands before the first label of the `switch`"),
        }
    }
}
