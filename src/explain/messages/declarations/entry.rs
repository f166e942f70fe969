//! Messages for [`EntryError`].

use crate::messages::names::OUTPUT_NAMES;
use crate::messages::*;

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
            E::Missing if c.misspelled("main").is_some() => c
                .misspelled("main")
                .unwrap_or_else(|| missing("`main` function not found"))
                .note("execution starts at `void main()` (section 6.1)"),
            E::Missing => missing("`main` function not found")
                .note("execution starts at `void main()` (section 6.1)"),
            E::MissingCalled(entry) if c.misspelled(entry.name).is_some() => c
                .misspelled(entry.name)
                .unwrap_or_else(|| missing(&format!("`{}` function not found", entry.name)))
                .note("ShaderToy calls it for every pixel or sample"),
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
                let d = c.error(error::MAINIMAGE_SIGNATURE, at, message);
                match c.swapped_parameters(at) {
                    Some(fix) => d.fix(fix),
                    None => d.help(format!("declare it as `{}`", entry.signature)),
                }
            }
            E::MainParameters if c.called_entry().is_some() => {
                let name = c.called_entry().map_or("", |entry| entry.name);
                c.error(
                    error::FUNCTION_MISMATCH,
                    at,
                    "`main` must not have parameters",
                )
                .note(format!("the function that ShaderToy calls is `{name}`"))
                .fix(c.rename_header(at, name))
            }
            E::MainParameters => {
                let d = main("`main` must not have parameters");
                d.fix(
                    c.main_without_parameters(at)
                        .or_else(|| c.main_as_function(at)),
                )
            }
            E::MainReturns => main("`main` must return `void`")
                .fix(c.main_without_value(at).or_else(|| c.main_as_function(at))),
        }
    }
}

impl ExplainContext<'_> {
    /// Where something that the shader lacks is reported: the start of its last file.
    pub(crate) fn start_of_shader(&self) -> Span {
        let end = self.tokens.tokens.last().map_or(0, |t| t.span.end);
        self.sources
            .code_at(end)
            .map_or(Span::default(), |f| Span::at(f.base))
    }

    /// A function whose name differs from that of the entry point by its case and one letter.
    fn misspelled(&self, entry: &str) -> Option<Diagnostic> {
        let lower = entry.to_ascii_lowercase();
        let is_near =
            |name: &str| strsim::damerau_levenshtein(&name.to_ascii_lowercase(), &lower) <= 1;
        let mut functions = self.tree.functions.iter().filter(|f| f.body.is_some());
        let found = functions.find(|f| {
            is_near(self.text(f.ident.name)) && self.tree.ty(f.ty).base == TypeBase::Void
        })?;
        let token = self.token(found.ident.token);
        let name = self.text(found.ident.name);
        let message = format!("expected function `{entry}`, found `{name}`");
        let d = Diagnostic::error(error::MISSING_MAIN, token.span, message);
        Some(d.fix(self.rename_header(found.header, entry)))
    }

    /// The entry point that the host calls.
    fn called_entry(&self) -> Option<EntryPoint> {
        self.dialect.host().entry.filter(|e| e.is_called_by_host())
    }

    /// Gives the function with this header another name.
    fn rename_header(&self, header: Extent, name: &str) -> Option<Fix> {
        let ident = self.function_at(header)?.ident;
        if !self.token(ident.token).is_direct() {
            return None;
        }
        // The host's code may use the same name.
        let mut edits = self.rename_all(ident.name, name);
        edits.retain(|edit| self.sources.is_user(edit.span.start));
        Some(Fix::suggestion(format!("use `{name}`"), edits))
    }

    /// The function whose header these tokens are.
    fn function_at(&self, at: Extent) -> Option<&FunctionDecl> {
        let mut all = self.tree.functions.iter();
        all.find(|f| f.header.first <= at.first && at.first <= f.header.last)
    }

    /// `void mainImage(in vec2 p, out vec4 color)`: the parameters in the other order.
    fn swapped_parameters(&self, at: Extent) -> Option<Fix> {
        let function = self.function_at(at)?;
        let &[first, second] = self.tree.params(function.params) else {
            return None;
        };
        let spans = [first, second].map(|param| self.span(param.extent));
        let [a, b] = spans.map(|span| self.sources.text(span));
        let edits = vec![Edit::replace(spans[0], b), Edit::replace(spans[1], a)];
        let is_swapped =
            a.contains("vec2") && b.contains("vec4") && self.is_direct(function.header);
        is_swapped.then(|| Fix::suggestion("swap the parameters", edits))
    }

    /// `void main(out vec4 color, in vec2 p)`, as `mainImage` is declared: the parameters become an
    /// output and a variable.
    fn main_without_parameters(&self, at: Extent) -> Option<Fix> {
        let function = self.function_at(at)?;
        let body = self.tree.stmt(function.body?).extent;
        if self.stage != Stage::Fragment
            || !self.has(Feature::InOut)
            || !self.is_direct(function.header)
            || self.tree.ty(function.ty).base != TypeBase::Void
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

    /// `vec4 main(vec2 p) { return ...; }`: the function gets another name, and a new `main` writes
    /// its value to the output.
    fn main_as_function(&self, at: Extent) -> Option<Fix> {
        let function = self.function_at(at)?;
        if self.stage != Stage::Fragment || !self.has(Feature::InOut) {
            return None;
        }
        let written = |ty: TypeId| self.sources.text(self.span(self.tree.ty(ty).extent));
        let mut arguments = Vec::new();
        for param in self.tree.params(function.params) {
            let mut qualifiers = self.tree.qualifiers(param.qualifiers).iter();
            let is_out = qualifiers.any(|q| q.kind == QualifierKind::Out);
            (!is_out && written(param.ty) == "vec2").then(|| arguments.push("gl_FragCoord.xy"))?;
        }
        let is_free = |name: &&str| self.names.get(name).is_none();
        let name = ["shade", "shadePixel", "colorOfPixel"]
            .into_iter()
            .find(is_free)?;
        let call = format!("{name}({})", arguments.join(", "));
        let value = match written(function.ty) {
            "vec4" => call,
            "vec3" => format!("vec4({call}, 1.0)"),
            _ => return None,
        };
        let (output, declared) = match self.output_name() {
            Some(name) => (name, ""),
            None => {
                let name = OUTPUT_NAMES.split(' ').find(is_free)?;
                (name, name)
            }
        };
        let declared = match declared {
            "" => String::new(),
            name => format!("out vec4 {name};\n"),
        };
        let text = format!("\n\n{declared}void main() {{\n    {output} = {value};\n}}");
        let mut edits = self.rename_all(function.ident.name, name);
        edits.push(Edit::insert(self.span(function.extent).end, text));
        Some(Fix::suggestion(
            format!("rename it to `{name}` and add a `main` that calls it"),
            edits,
        ))
    }

    /// The name of the first declared output of type `vec4`.
    fn output_name(&self) -> Option<&str> {
        self.tree.decls.iter().find_map(|d| match d.kind {
            DeclKind::Variables {
                qualifiers,
                declarators,
                ty,
            } => {
                let mut qualifiers = self.tree.qualifiers(qualifiers).iter();
                let is_output = qualifiers.any(|q| q.kind == QualifierKind::Out)
                    && self.sources.text(self.span(self.tree.ty(ty).extent)) == "vec4";
                let first = self.tree.declarators(declarators).first()?;
                is_output.then(|| self.text(first.ident.name))
            }
            _ => None,
        })
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
