//! Messages for [`SwitchError`].

use super::*;

impl Explain for SwitchError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use SwitchError as E;
        let report = |message: &str| c.error(error::INVALID_SWITCH, at, message);
        // A float is converted to an integer.
        let to_integer = |value| match c.ty(value) {
            Type::FLOAT => c.convert(value, Scalar::Int),
            _ => None,
        };
        match self {
            E::Selector(value) => {
                let name = c.name_of(c.ty(value));
                report(&format!("`switch` requires an integer, found `{name}`"))
                    .fix(to_integer(value))
            }
            E::Label(value) => {
                let name = c.name_of(c.ty(value));
                report(&format!("`case` label must be an integer, found `{name}`"))
                    .fix(to_integer(value))
            }
            E::NotConstant(value) => {
                let message = "`case` label must be a constant expression";
                c.explain_not_constant(c.error(error::NOT_CONSTANT, at, message), value)
            }
            E::LabelType(value, selector) => {
                let (expected, found) = (c.name_of(selector), c.name_of(c.ty(value)));
                let scalar = selector.scalar_kind().unwrap_or(Scalar::Int);
                report(&format!(
                    "expected `case` label of type `{expected}`, found `{found}`"
                ))
                .fix(c.convert(value, scalar))
            }
            E::Outside(word) => report(&format!("`{word}` must be directly inside a `switch`")),
            E::Twice(first) => {
                report("duplicate label in `switch`").label(c.token_span(first), "first label")
            }
            E::NothingBehind(dropped) => {
                let d = report("the last label of a `switch` has no statement");
                let d = match dropped {
                    Some(dropped) => d.label(c.span(dropped), "removed by the browser"),
                    None => d,
                };
                d.help("add `break;` after it")
            }
            E::BeforeLabels => report("statement before the first label of a `switch`"),
        }
    }
}
