//! Messages for [`QualifierError`].

use crate::messages::*;
use shaderlint_text::Role;

impl Explain for QualifierError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use QualifierError as E;
        let report = |message: &str| c.error(error::INVALID_QUALIFIER, at, message);
        let written = c.sources.text(c.span(at));
        let word = c.sources.text(c.token_span(at.first));
        match self {
            E::Local => report(&format!("a local variable cannot be `{word}`")),
            E::NotGlobal => report(&format!("`{word}` is only allowed at global scope")),
            E::Later => {
                let message = format!("`{word}` requires `#version 300 es` here");
                c.error(error::NEEDS_WEBGL2, at, message)
                    .help("use `attribute` or `varying` in GLSL ES 1.00")
            }
            E::NoParameter => report("`inout` is only allowed on parameters"),
            E::NoAttribute => report("`attribute` is only allowed in vertex shaders"),
            E::Together => report("these qualifiers cannot be combined"),
            E::Twice => report(&format!("`{word}` repeats a qualifier of the same kind"))
                .note(ORDER)
                .fix(c.without_word(at.first)),
            E::InvariantLayout => report("`invariant` and `layout` cannot be combined").note(ORDER),
            E::Order => report(&format!("qualifier `{word}` is in the wrong order"))
                .note(ORDER)
                .fix(c.ordered_qualifiers(at)),
            E::Parameter => {
                let message = format!("a parameter cannot be `{written}` here");
                c.error(error::INVALID_PARAMETER, at, message)
                    .note("a parameter is `in`, `const in`, `out` or `inout` (section 4.6)")
            }
            E::Returned => report(&format!("a return type cannot be `{written}`")),
            E::Alone(storage) => report(&format!(
                "`{}` must be followed by `in` or `out`",
                storage.name()
            ))
            .note("only variables passed between stages are interpolated (section 4.3.9)"),
            E::Invariant => report("`invariant` is not allowed here").note(INVARIANT),
            E::InvariantVariable(name) => {
                report(&format!("`{}` cannot be `invariant`", c.text(name))).note(INVARIANT)
            }
            E::Afterwards => report("a redeclaration can only add `invariant`"),
            E::Undeclared(name) => {
                let message = format!("`{}` is not declared", c.text(name));
                c.error(error::UNDECLARED_NAME, at, message)
            }
            E::Incomplete(name) => {
                let name = c.text(name);
                let message = format!("declaration of `{name}` lacks a type or a name");
                c.error(error::SYNTAX_ERROR, at, message)
            }
            E::NoPrecision(ty) => report(&format!("`{}` cannot have a precision", c.name_of(ty))),
            E::MissingPrecision(ty) => c.missing_precision(ty, at),
            E::DefaultPrecision => {
                let scalar = match written.find("vec").or(written.find("mat")) {
                    Some(0) => Some("float"),
                    Some(1) if !written.starts_with('b') => Some("int"),
                    _ => None,
                };
                let fix = scalar.map(|scalar| {
                    let edits = vec![Edit::replace(c.span(at), scalar)];
                    Fix::suggestion(format!("use `{scalar}`"), edits)
                });
                report(&format!("cannot set a default precision for `{written}`"))
                    .note(
                        "only `float`, `int` and samplers have one; vectors follow `float` \
                         (section 4.5.4)",
                    )
                    .fix(fix)
            }
        }
    }
}

const ORDER: &str =
    "the order is: invariant, flat or smooth, layout, storage, precision (section 4.7)";
const INVARIANT: &str = "only outputs can be `invariant` (section 4.6.1)";

/// Place of a qualifier in [`ORDER`].
fn rank(kind: QualifierKind) -> u32 {
    use QualifierKind as Q;
    match kind {
        Q::Invariant => 0,
        Q::Flat | Q::Smooth => 1,
        Q::Layout(_) => 2,
        Q::Centroid => 3,
        Q::Lowp | Q::Mediump | Q::Highp => 5,
        _ => 4,
    }
}

impl ExplainContext<'_> {
    /// Sorts the qualifiers of the declaration that contains these tokens.
    fn ordered_qualifiers(&self, at: Extent) -> Option<Fix> {
        let has = |list: List| {
            let mut all = self.tree.qualifiers(list).iter();
            all.any(|q| q.extent.first <= at.first && at.first <= q.extent.last)
        };
        let list = self.tree.decls.iter().find_map(|d| match d.kind {
            DeclKind::Variables { qualifiers, .. } => Some(qualifiers).filter(|q| has(*q)),
            _ => None,
        })?;
        let mut all = self.tree.qualifiers(list).to_vec();
        let (first, last) = (all.first()?.extent, all.last()?.extent);
        let extent = Extent::new(first.first, last.last);
        if !self.is_direct(extent) {
            return None;
        }
        all.sort_by_key(|q| rank(q.kind));
        let words: Vec<&str> = all
            .iter()
            .map(|q| self.sources.text(self.span(q.extent)))
            .collect();
        let text = words.join(" ");
        let edits = vec![Edit::replace(self.span(extent), text.clone())];
        Some(Fix::safe(format!("use `{text}`"), edits))
    }

    fn missing_precision(&self, ty: Type, at: Extent) -> Diagnostic {
        let name = self.name_of(ty);
        let (line, why) = match ty.base {
            Base::Sampler(_) => (
                format!("precision highp {name};"),
                "only `sampler2D` and `samplerCube` have a default precision (section 4.5.4)",
            ),
            _ => (
                format!("precision highp {name};"),
                "a fragment shader has no default precision for `float` (section 4.5.4)",
            ),
        };
        let message = format!("missing precision for `{name}`");
        let d = self.error(error::MISSING_PRECISION, at, message).note(why);
        match self.line_after_version(at.first) {
            Some(place) => d.fix(Fix::safe(
                format!("add `{line}`"),
                vec![Edit::insert(place, format!("{line}\n"))],
            )),
            None => d.help(format!("add `{line}` at the top")),
        }
    }

    /// Position of the line after `#version` and the `#extension`s in the file of a token: where
    /// the first declaration is inserted.
    pub(crate) fn line_after_version(&self, token: TokenId) -> Option<u32> {
        let code = self.sources.code_at(self.token_span(token).start)?;
        if code.role == Role::Prelude {
            return None;
        }
        let file = Span::new(code.base, code.base + code.text.len() as u32);
        let inside = |span: &Span| file.contains(*span);
        let directives = self
            .tokens
            .version_span
            .iter()
            .chain(self.tokens.extensions.iter().map(|e| &e.span));
        let end = directives.filter(|s| inside(s)).map(|s| s.end).max();
        let Some(end) = end else {
            return Some(code.base);
        };
        let rest = code.text.get((end - code.base) as usize..)?;
        let newline = rest.find(['\n', '\r'])?;
        let width = if rest.get(newline..)?.starts_with("\r\n") {
            2
        } else {
            1
        };
        Some(end + newline as u32 + width)
    }
}
