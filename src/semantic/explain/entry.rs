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
            E::Missing if c.main_in_another_case().is_some() => c
                .main_in_another_case()
                .unwrap_or_else(|| missing("`main` function not found")),
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
            E::MainParameters => {
                let d = main("`main` must not have parameters");
                d.fix(c.main_without_parameters(at))
            }
            E::MainReturns => main("`main` must return `void`").fix(c.main_without_value(at)),
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

    /// A function that differs from `main` by a letter or its case.
    fn main_in_another_case(&self) -> Option<Diagnostic> {
        let is_near = |name: &str| {
            let name = name.to_ascii_lowercase();
            strsim::damerau_levenshtein(&name, "main") <= 1
        };
        let mut functions = self.tree.functions.iter().filter(|f| f.body.is_some());
        let found = functions.find(|f| {
            is_near(self.text(f.ident.name)) && self.tree.ty(f.ty).base == TypeBase::Void
        })?;
        let token = self.token(found.ident.token);
        let name = self.text(found.ident.name);
        let message = format!("expected function `main`, found `{name}`");
        let d = Diagnostic::error(error::MISSING_MAIN, token.span, message)
            .note("execution starts at `void main()` (section 6.1)");
        let fix = || Fix::suggestion("use `main`", self.rename_all(found.ident.name, "main"));
        Some(d.fix(token.is_direct().then(fix)))
    }

    /// The function whose header these tokens are.
    fn function_at(&self, at: Extent) -> Option<&FunctionDecl> {
        let mut all = self.tree.functions.iter();
        all.find(|f| f.header.first <= at.first && at.first <= f.header.last)
    }

    /// `void main(out vec4 color, in vec2 p)`, as `mainImage` is declared: the parameters become an
    /// output and a variable.
    fn main_without_parameters(&self, at: Extent) -> Option<Fix> {
        let function = self.function_at(at)?;
        let body = self.tree.stmt(function.body?).extent;
        if self.stage != Stage::Fragment
            || !self.has(Feature::InOut)
            || !self.is_direct(function.header)
        {
            return None;
        }
        let (mut before, mut inside) = (String::new(), String::new());
        for param in self.tree.params(function.params) {
            let qualifiers = self.tree.qualifiers(param.qualifiers);
            let is_out = qualifiers.iter().any(|q| q.kind == QualifierKind::Out);
            let ty = self.sources.text(self.span(self.tree.ty(param.ty).extent));
            let name = self.text(param.ident?.name);
            match (is_out, ty) {
                (true, "vec4" | "vec3") => before += &format!("out {ty} {name};\n"),
                (false, "vec2") => inside += &format!("\n    vec2 {name} = gl_FragCoord.xy;"),
                _ => return None,
            }
        }
        let header = self.span(function.header);
        let edits = vec![
            Edit::replace(header, format!("{before}void main()")),
            Edit::insert(self.token_span(body.first).end, inside),
        ];
        Some(Fix::suggestion(
            "declare the output and read `gl_FragCoord`",
            edits,
        ))
    }

    /// `int main() { ...; return 0; }`
    fn main_without_value(&self, at: Extent) -> Option<Fix> {
        let function = self.function_at(at)?;
        let extent = function.extent;
        if !self.is_direct(extent) {
            return None;
        }
        let mut edits = vec![Edit::replace(
            self.span(self.tree.ty(function.ty).extent),
            "void",
        )];
        for stmt in &self.tree.stmts {
            let is_inside = extent.first <= stmt.extent.first && stmt.extent.last <= extent.last;
            let StmtKind::Return(Some(value)) = stmt.kind else {
                continue;
            };
            if !is_inside {
                continue;
            }
            // Only a value without effect is dropped.
            self.literal_token(value)?;
            let place = Span::new(
                self.token_span(stmt.extent.first).end,
                self.expr_span(value).end,
            );
            edits.push(Edit::delete(place));
        }
        Some(Fix::suggestion(
            "use `void`, and `return` without a value",
            edits,
        ))
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
