//! What the browser does not take, although the language allows it.

use super::*;

impl Explain for LimitError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use LimitError as E;
        let say = |message: &str| c.error(error::BROWSER_LIMIT, at, message);
        match self {
            E::Depth => say("this is too complex for the browser")
                .note("it takes code up to a depth of 256: nested statements and operators in a row both count")
                .help("split the expression, or move inner code into a function"),
            E::Size(name, size, limit) => {
                let name = name.map_or("this".to_string(), |name| format!("`{}`", c.text(name)));
                say(&format!("{name} takes {size} bytes; the browser allows less than {limit}"))
                    .help("keep large tables in a texture")
            }
            E::Total(size, limit) => say(&format!(
                "all variables together take {size} bytes, and the browser allows {limit}"
            )),
            E::Members => say("this has too many members").note("the browser takes 16383"),
            E::Nesting => say("structs are nested too deeply")
                .note("WebGL allows a depth of 4 (WebGL 1.0 section 6.20)"),
            E::Parameters => say("a function takes at most 255 parameters"),
            E::CallDepth => say("functions call functions to a depth of more than 256")
                .note("the browser takes no longer chains of calls"),
        }
    }
}
