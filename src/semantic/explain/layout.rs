//! Messages for [`LayoutError`].

use super::*;

impl Explain for LayoutError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use LayoutError as E;
        let say = |message: &str| c.error(error::INVALID_LAYOUT, at, message);
        match self {
            E::NotInWebgl(word) => say(&format!(
                "WebGL does not support block layout `{}`; use `std140`",
                c.text(word)
            )),
            E::NoNumber => say("`location` needs a number: `location = 0`"),
            E::Unknown(word) => say(&format!("unknown layout qualifier `{}`", c.text(word))),
            E::UnknownNumber(word) => {
                let word = c.text(word);
                let d = say(&format!("unknown layout qualifier `{word} = ...`"));
                match word {
                    "binding" | "offset" => {
                        d.note("it was added in GLSL ES 3.10, which WebGL2 does not support")
                    }
                    _ => d,
                }
            }
            E::Negative => say("`location` cannot be negative"),
            E::OfBlock => say("this layout qualifier is only allowed on interface blocks"),
            E::NoLocationHere => say("`location` is not allowed here").note(
                "only vertex shader inputs and fragment shader outputs have one (section 4.3.8)",
            ),
            E::Twice => say("`location` is specified twice"),
            E::OutOfRange(location) => say(&format!("location {location} is out of range"))
                .note("a vertex shader has 16 input locations, 0 to 15"),
            E::Shared => say("`location` can only apply to a single variable"),
            E::OfNothing => say("expected a declaration after these qualifiers"),
            E::NotUniform => say("a default layout can only be set for `uniform`"),
        }
    }
}
