//! Messages for [`OutputError`].

use super::*;

impl Explain for OutputError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use OutputError as E;
        let report = |message: &str| c.error(error::OUTPUT_LOCATION, at, message);
        match self {
            E::Outside(name, count) => {
                let name = c.text(name);
                report(&format!(
                    "output `{name}` exceeds the {count} available locations"
                ))
            }
            E::Shared(name, other, location) => {
                let (name, first) = (c.text(name), c.text(other.name));
                report(&format!(
                    "outputs `{name}` and `{first}` share location {location}"
                ))
                .label(c.token_span(other.token), "other output")
            }
            E::NextToHostOutputs(name) => {
                let name = c.text(name);
                report(&format!(
                    "output `{name}` conflicts with ShaderToy's own output"
                ))
                .note("a ShaderToy pass has one output, the first parameter of its entry function")
            }
            E::NoLocation(name) => {
                let name = c.text(name);
                report(&format!("output `{name}` has no location"))
                    .note("each of several fragment outputs needs a location (section 4.3.8.2)")
                    .help(format!("use `layout(location = 0) out vec4 {name};`"))
            }
            E::ColorAndData(other) => {
                report("`gl_FragColor` and `gl_FragData` cannot both be used")
                    .label(c.token_span(other), "other use")
            }
        }
    }
}
