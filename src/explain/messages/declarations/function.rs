//! Messages for [`FunctionError`].

use crate::messages::*;

impl Explain for FunctionError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use FunctionError as E;
        let parameter = |message| c.error(error::INVALID_PARAMETER, at, message);
        let array = |message| c.error(error::INVALID_ARRAY, at, message);
        let mismatch = |message: &str| c.error(error::FUNCTION_MISMATCH, at, message);
        match self {
            E::Local => {
                let message = "a function cannot be declared inside another function";
                c.error(error::LOCAL_FUNCTION, at, message)
                    .note("functions can only be declared at global scope (section 4.2.4)")
            }
            E::PrototypeTwice(name) => mismatch(&format!("`{}` is declared twice", c.text(name)))
                .note("GLSL ES 1.00 allows only one prototype per function (section 4.2.7)"),
            E::DefinedTwice(name, first) => {
                let name = c.text(name);
                let message =
                    format!("function `{name}` is defined twice with the same parameters");
                let d = c.error(error::REDEFINITION, at, message);
                let d = c.with_declaration(d, first, "first defined here");
                let copy = first.and_then(|first| c.identical_copy(first, at.first));
                match copy {
                    Some(copy) => d
                        .note("both definitions are identical")
                        .fix(Fix::suggestion(
                            "remove this copy",
                            vec![Edit::delete(copy)],
                        )),
                    None => d,
                }
            }
            E::NoReturn(name, returned) => c.no_return(name, returned, at),
            E::VoidParameter => c
                .error(error::VOID_VALUE, at, "a parameter cannot have type `void`")
                .note("`void` is only allowed in `f(void)`, a function without parameters"),
            E::StructParameter => parameter("a struct cannot be declared in a parameter list"),
            E::UnsizedParameter => parameter("an array parameter needs a size"),
            E::OutSampler => parameter("a sampler cannot be an `out` parameter"),
            E::ReturnsSampler => {
                let message = "a function cannot return a sampler";
                c.error(error::SAMPLER_RESTRICTION, at, message)
            }
            E::ReturnsUnsized => array("an array return type needs a size"),
            E::ReturnsArray => array("GLSL ES 1.00 functions cannot return arrays"),
            E::ReturnsArrayInside => {
                array("GLSL ES 1.00 functions cannot return structs that contain arrays")
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
                        "parameter qualifiers of `{name}` differ from another declaration"
                    )),
                )
            }
        }
    }
}

impl<'a> ExplainContext<'a> {
    /// A function of type `returned` that returns nothing. `at` contains its name.
    fn no_return(&self, name: Name, returned: Type, at: Extent) -> Diagnostic {
        let (name, expected) = (self.text(name), self.name_of(returned));
        let message = format!("`{name}` must return `{expected}`, but no path returns a value");
        let d = self
            .error(error::MISSING_RETURN, at, message)
            .note("a function that is not `void` needs a `return` with a value (section 6.1)");
        match self.last_value(at, returned) {
            Some(value) => {
                let edits = vec![Edit::insert(value.start, "return ")];
                d.label(value, "this value is not returned")
                    .fix(Fix::suggestion("add `return`", edits))
            }
            None => d,
        }
    }

    /// The value that the last statement of a function computes and drops, if the function returns its
    /// type. `at` contains the name of the function.
    fn last_value(&self, at: Extent, expected: Type) -> Option<Span> {
        let mut functions = self.tree.functions.iter();
        let function =
            functions.find(|f| f.body.is_some() && at.contains(Extent::token(f.ident.token)))?;
        let StmtKind::Block(body) = self.tree.stmt(function.body?).kind else {
            return None;
        };
        let last = self.tree.block(body).last()?;
        let StmtKind::Expr(value) = self.tree.stmt(*last).kind else {
            return None;
        };
        let is_value = !matches!(self.tree.expr(value).kind, ExprKind::Assign(..));
        let extent = self.tree.expr(value).extent;
        let is_it = is_value && self.ty(value) == expected && self.is_direct(extent);
        is_it.then(|| self.expr_span(value))
    }

    /// The text of the second of two functions if both consist of the same tokens.
    fn identical_copy(&self, first: TokenId, second: TokenId) -> Option<Span> {
        let around = |token: TokenId| {
            let mut all = self.tree.functions.iter().filter(|f| f.body.is_some());
            all.find(|f| f.extent.first <= token && token <= f.extent.last)
        };
        let (first, second) = (around(first)?.extent, around(second)?.extent);
        let len = second.last - second.first;
        let is_equal = |i: TokenId| {
            let (a, b) = (self.token(first.first + i), self.token(second.first + i));
            (a.kind, a.value) == (b.kind, b.value)
        };
        let is_copy =
            first != second && first.last - first.first == len && self.affords(len as usize);
        if !is_copy || !self.is_direct(second) || !(0..=len).all(is_equal) {
            return None;
        }
        // With the blank lines before it.
        let span = self.span(second);
        let before = self.token_span(second.first.checked_sub(1)?);
        let gap = Span::new(before.end, span.start);
        let is_blank = before.end <= span.start && self.sources.text(gap).trim().is_empty();
        Some(if is_blank { gap.to(span) } else { span })
    }

    pub(in crate::messages) fn function_name(&self, function: FunctionRef) -> &'a str {
        let function = self.functions.get(function.0 as usize);
        function.map_or("", |f| self.text(f.name))
    }

    /// The name in the first declaration of a function.
    pub(in crate::messages) fn function_token(&self, function: FunctionRef) -> Option<TokenId> {
        let function = self.functions.get(function.0 as usize)?;
        let decl = self.tree.function(function.declaration)?;
        Some(decl.ident.token)
    }

    fn label_other(&self, known: FunctionRef, d: Diagnostic) -> Diagnostic {
        self.with_declaration(d, self.function_token(known), "other declaration")
    }

    fn builtin_name(&self, name: Name, at: Extent) -> Diagnostic {
        let text = self.text(name);
        let to = self.names.unused(&own_name(text));
        let edits = self.rename_all(name, &to);
        let d = self
            .error(
                error::BUILTIN_REDEFINITION,
                at,
                format!("cannot redefine built-in function `{text}`"),
            )
            .note("GLSL ES 3.00 does not allow redefining or overloading a built-in (section 6.1)");
        match edits.is_empty() {
            true => d.help(format!("rename it, for example to `{to}`")),
            false => d.fix(Fix::suggestion(format!("rename it to `{to}`"), edits)),
        }
    }
}
