//! What is wrong with the outputs of a fragment shader.

use super::*;

impl Explain for OutputError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use OutputError as E;
        let say = |message: &str| c.error(error::OUTPUT_LOCATION, at, message);
        match self {
            E::Outside(name, count) => {
                let name = c.text(name);
                say(&format!(
                    "the output `{name}` lies outside the {count} that there are"
                ))
            }
            E::Shared(name, other, location) => {
                let (name, first) = (c.text(name), c.text(other.name));
                say(&format!(
                    "the outputs `{name}` and `{first}` share location {location}"
                ))
                .label(c.token_span(other.token), "the other output")
            }
            E::BesideHosts(name) => {
                let name = c.text(name);
                say(&format!(
                    "the output `{name}` stands beside that of the player"
                ))
                .note("a ShaderToy pass has one output, the first parameter of its entry function")
            }
            E::NoLocation(name) => {
                let name = c.text(name);
                say(&format!("the output `{name}` has no location"))
                    .note("where a fragment shader has several outputs, each needs one (section 4.3.8.2)")
                    .help(format!("write `layout(location = 0) out vec4 {name};`"))
            }
            E::ColorAndData(other) => say("`gl_FragColor` and `gl_FragData` cannot both be used")
                .label(c.token_span(other), "the other one"),
        }
    }
}
