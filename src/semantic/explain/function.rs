//! What is wrong with functions: their headers, and their declarations together.

use super::*;

impl Explain for FunctionError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use FunctionError as E;
        let parameter = |message| c.error(error::INVALID_PARAMETER, at, message);
        let array = |message| c.error(error::INVALID_ARRAY, at, message);
        let mismatch = |message: &str| c.error(error::FUNCTION_MISMATCH, at, message);
        match self {
            E::Local => {
                let message = "a function cannot be declared inside a function";
                c.error(error::LOCAL_FUNCTION, at, message)
                    .note("move the declaration out (section 4.2.4)")
            }
            E::PrototypeTwice(name) => mismatch(&format!("`{}` is declared twice", c.text(name)))
                .note("GLSL ES 1.00 section 4.2.7 allows one prototype only"),
            E::DefinedTwice(name, first) => {
                let name = c.text(name);
                let message =
                    format!("the function `{name}` is defined twice with the same parameters");
                let d = c.error(error::REDEFINITION, at, message);
                c.with_declaration(d, first, "first defined here")
            }
            E::NoReturn(name, wanted) => {
                let (name, wanted) = (c.text(name), c.name_of(wanted));
                let message = format!("`{name}` returns nothing, although it is `{wanted}`");
                let note = format!("somewhere in it must be a `return` with a `{wanted}`");
                c.error(error::MISSING_RETURN, at, message).note(note)
            }
            E::VoidParameter => c
                .error(error::VOID_VALUE, at, "a parameter cannot be `void`")
                .note("only `f(void)`, for no parameter at all, is allowed"),
            E::StructParameter => parameter("a struct cannot be declared in a parameter"),
            E::UnsizedParameter => parameter("an array parameter needs a size"),
            E::OutSampler => parameter("a sampler cannot be an `out` parameter"),
            E::ReturnsSampler => {
                let message = "a function cannot return a sampler";
                c.error(error::SAMPLER_RESTRICTION, at, message)
            }
            E::ReturnsUnsized => array("an array that is returned needs a size"),
            E::ReturnsArray => array("GLSL ES 1.00 functions cannot return arrays"),
            E::ReturnsArrayInside => {
                array("GLSL ES 1.00 functions cannot return structs that hold arrays")
            }
            E::Builtin(name) => c.builtin_name(name, at),
            E::ReturnType(known, returns, other) => {
                let other = c.name_of(other);
                let (name, returns) = (c.function_name(known), c.name_of(returns));
                c.label_other(
                    known,
                    mismatch(&format!(
                        "`{name}` returns `{returns}` here, but `{other}` in another declaration"
                    )),
                )
            }
            E::Directions(known) => {
                let name = c.function_name(known);
                c.label_other(
                    known,
                    mismatch(&format!(
                        "the parameters of `{name}` are qualified otherwise in another declaration"
                    )),
                )
            }
        }
    }
}

impl<'a> ExplainContext<'a> {
    pub(super) fn function_name(&self, function: FunctionRef) -> &'a str {
        let function = self.functions.get(function.0 as usize);
        function.map_or("", |f| self.text(f.name))
    }

    /// The token of its name, where it is first declared.
    pub(super) fn function_token(&self, function: FunctionRef) -> Option<TokenId> {
        let function = self.functions.get(function.0 as usize)?;
        let decl = self.tree.function(function.declaration)?;
        Some(decl.ident.token)
    }

    fn label_other(&self, known: FunctionRef, d: Diagnostic) -> Diagnostic {
        self.with_declaration(d, self.function_token(known), "the other one")
    }

    fn builtin_name(&self, name: Name, at: Extent) -> Diagnostic {
        let text = self.text(name);
        let to = self.free_function_name(text);
        let edits = self.rename_all(name, &to);
        let d = self
            .error(error::BUILTIN_REDEFINITION, at, format!("`{text}` is a built-in function"))
            .note("GLSL ES 3.00 lets no function take such a name, whatever its parameters (section 6.1)");
        match edits.is_empty() {
            true => d.help(format!("rename it, to `{to}` for example")),
            false => d.fix(Fix::suggestion(format!("rename it to `{to}`"), edits)),
        }
    }

    fn free_function_name(&self, text: &str) -> String {
        let mut chars = text.chars();
        let first = chars.next().map(|c| c.to_ascii_uppercase()).unwrap_or('F');
        let base = format!("my{first}{}", chars.as_str());
        self.names.unused(&base)
    }
}
