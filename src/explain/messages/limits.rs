//! Messages for [`LimitError`]: limits of the browser that GLSL itself does not have.

use super::*;

impl Explain for LimitError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use LimitError as E;
        let report = |message: &str| c.error(error::BROWSER_LIMIT, at, message);
        match self {
            E::Depth => report("code is nested too deeply for the browser")
                .note(
                    "the maximum depth is 256; nested statements and chained operators both count",
                )
                .help("split the expression, or move inner code into a function"),
            E::Size(name, size, limit) => {
                let name =
                    name.map_or("variable".to_string(), |name| format!("`{}`", c.text(name)));
                report(&format!(
                    "{name} needs {size} bytes; the browser allows less than {limit}"
                ))
                .help("store large tables in a texture")
            }
            E::Total(size, limit) => report(&format!(
                "all variables together need {size} bytes; the browser allows {limit}"
            )),
            E::Members => report("too many members in one struct or block")
                .note("the browser allows at most 16383"),
            E::Nesting => report("structs are nested too deeply")
                .note("WebGL allows at most 4 nesting levels (WebGL 1.0 section 6.20)"),
            E::Parameters => report("a function can have at most 255 parameters"),
            E::CallDepth => report("call depth exceeds 256")
                .note("the browser does not compile longer call chains"),
        }
    }
}
