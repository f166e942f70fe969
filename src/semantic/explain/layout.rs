//! What is wrong with a `layout(...)`.

use super::*;

impl Explain for LayoutError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use LayoutError as E;
        let say = |message: &str| c.error(error::INVALID_LAYOUT, at, message);
        match self {
            E::NotInWebgl(word) => say(&format!(
                "WebGL has no block layout `{}`; only `std140`",
                c.text(word)
            )),
            E::NoNumber => say("`location` needs a number: `location = 0`"),
            E::Unknown(word) => say(&format!("there is no layout `{}` here", c.text(word))),
            E::UnknownNumber(word) => {
                let word = c.text(word);
                let d = say(&format!("there is no layout `{word} = ...` here"));
                match word {
                    "binding" | "offset" => {
                        d.note("it comes with GLSL ES 3.10, which WebGL2 does not have")
                    }
                    _ => d,
                }
            }
            E::Negative => say("a location must not be negative"),
            E::OfBlock => say("this layout is for interface blocks"),
            E::NoLocationHere => say("no location can be given here")
                .note("only inputs of vertex shaders and outputs of fragment shaders have one (section 4.3.8)"),
            E::Twice => say("the location is given twice"),
            E::OutOfRange(location) => say(&format!("location {location} is out of range"))
                .note("a vertex shader has 16 inputs, at locations 0 to 15"),
            E::Shared => say("a location is for one variable only"),
            E::OfNothing => say("a declaration is missing behind these qualifiers"),
            E::NotUniform => say("a default layout can only be set for `uniform`"),
        }
    }
}
