//! Messages for [`LayoutError`].

use super::*;

impl Explain for LayoutError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use LayoutError as E;
        let report = |message: &str| c.error(error::INVALID_LAYOUT, at, message);
        match self {
            E::NotInWebgl(word) => report(&format!(
                "WebGL does not support block layout `{}`; use `std140`",
                c.text(word)
            )),
            E::NoNumber => report("`location` needs a number: `location = 0`"),
            E::Unknown(word) => report(&format!("unknown layout qualifier `{}`", c.text(word))),
            E::UnknownNumber(word) => {
                let word = c.text(word);
                let d = report(&format!("unknown layout qualifier `{word} = ...`"));
                match word {
                    "binding" | "offset" => {
                        d.note("it was added in GLSL ES 3.10, which WebGL2 does not support")
                    }
                    _ => d,
                }
            }
            E::Negative => report("`location` cannot be negative"),
            E::OfBlock => report("this layout qualifier is only allowed on interface blocks"),
            E::NoLocationHere => report("`location` is not allowed here").note(
                "only vertex shader inputs and fragment shader outputs have one (section 4.3.8)",
            ),
            E::Twice => report("`location` is specified twice"),
            E::OutOfRange(location) => report(&format!("location {location} is out of range"))
                .note("a vertex shader has 16 input locations, 0 to 15"),
            E::Shared => report("`location` can only apply to a single variable"),
            E::OfNothing => report("expected a declaration after these qualifiers"),
            E::NotUniform => report("a default layout can only be set for `uniform`"),
        }
    }
}
