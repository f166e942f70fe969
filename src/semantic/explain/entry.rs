//! Messages for [`EntryError`].

use super::*;

impl Explain for EntryError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use EntryError as E;
        let missing =
            |message: &str| Diagnostic::error(error::MISSING_MAIN, c.start_of_shader(), message);
        let main = |message| {
            c.error(error::FUNCTION_MISMATCH, at, message)
                .help("declare it as `void main()`")
        };
        match self {
            E::Missing => missing("`main` function not found")
                .note("execution starts at `void main()` (section 6.1)"),
            E::MissingCalled(entry) => missing(&format!("`{}` function not found", entry.name))
                .note("ShaderToy calls it for every pixel or sample")
                .help(format!("define `{}`", entry.signature)),
            E::Unwrapped(output) => {
                let message = "`mainImage` is ShaderToy's entry point; WebGL2 calls `main`";
                c.wrap_main(c.error(error::UNWRAPPED_MAINIMAGE, at, message), output)
            }
            E::Signature(entry) => {
                let name = entry.name;
                let message = format!("`{name}` has the wrong signature for ShaderToy");
                c.error(error::MAINIMAGE_SIGNATURE, at, message)
                    .help(format!("declare it as `{}`", entry.signature))
            }
            E::MainParameters => main("`main` must not have parameters"),
            E::MainReturns => main("`main` must return `void`"),
        }
    }
}

impl ExplainContext<'_> {
    /// Where something that the shader lacks is reported: the start of its last file.
    fn start_of_shader(&self) -> Span {
        let end = self.tokens.tokens.last().map_or(0, |t| t.span.end);
        self.sources
            .code_at(end)
            .map_or(Span::default(), |f| Span::at(f.base))
    }

    /// Adds the `main` that calls `mainImage`.
    fn wrap_main(&self, d: Diagnostic, output: Option<Name>) -> Diagnostic {
        let end = self.tokens.tokens.last().map_or(0, |t| t.span.end);
        let output = output.map(|name| self.text(name).to_string());
        let mut text = String::from("\n");
        let name = output.unwrap_or_else(|| {
            text.push_str("out vec4 fragColor;\n");
            "fragColor".to_string()
        });
        text.push_str(&format!(
            "void main() {{\n    mainImage({name}, gl_FragCoord.xy);\n}}\n"
        ));
        d.help("use `shaderport` to convert it into a complete WebGL2 page")
            .fix(Fix::safe(
                "add a `main` that calls `mainImage`",
                vec![Edit::insert(end, text)],
            ))
    }
}
