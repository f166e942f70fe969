//! Messages for members, components and elements that do not exist.

use crate::messages::*;
use shaderlint_semantic::typing::{LENGTH, SWIZZLES};
use shaderlint_syntax::{Meaning, foreign};
use shaderlint_text::SetAt;

/// Most members of a struct that a message lists.
const MAX_LISTED: usize = 12;

impl ExplainContext<'_> {
    /// A member that its object does not have.
    pub(super) fn explain_member(
        &self,
        id: ExprId,
        object: ExprId,
        mismatch: TypeMismatch,
    ) -> Diagnostic {
        let token = self.tree.expr(id).extent.last;
        let ExprKind::Member(_, name) = self.tree.expr(id).kind else {
            return self.explain_no_elements(id, self.ty(object));
        };
        let text = self.text(name);
        match mismatch {
            TypeMismatch::Letters(ty) => self.bad_swizzle(text, token, &self.name_of(ty)),
            TypeMismatch::Component(ty, letter) => self.no_such_component(id, object, ty, letter),
            TypeMismatch::Field(record) => match self.structs.get(record as usize) {
                Some(record) => self.no_such_field(id, object, record, name),
                None => self.no_members(object, text, token),
            },
            TypeMismatch::ArrayMember => {
                let message = format!("arrays have no member `{text}`");
                let d = self.error_at(error::NO_SUCH_FIELD, token, message);
                match text {
                    LENGTH if self.token(token).is_direct() => {
                        let edit = Edit::insert(self.token_span(token).end, "()");
                        d.fix(Fix::safe("use `.length()`", vec![edit]))
                    }
                    LENGTH => d.help("use `.length()`"),
                    _ if self.is_direct(self.tree.expr(object).extent) => {
                        let first = format!("{}[0]", self.expr_text(object));
                        let edit = Edit::insert(self.expr_span(object).end, "[0]");
                        d.fix(Fix::suggestion(
                            format!("use an element: `{first}.{text}`"),
                            vec![edit],
                        ))
                    }
                    _ => d.help("index an element first: `a[0]`"),
                }
            }
            _ => self.no_members(object, text, token),
        }
    }

    /// A component of a scalar, a matrix or a sampler, which have none.
    fn no_members(&self, object: ExprId, text: &str, token: TokenId) -> Diagnostic {
        let ty = self.ty(object);
        let message = format!("`{}` has no component `{text}`", self.name_of(ty));
        let d = self.error_at(error::INVALID_SWIZZLE, token, message);
        match ty.numeric() {
            Some((scalar, 1, 1)) => d
                .note("only vectors have components; GLSL ES has no `.x` on scalars")
                .fix(self.repeated(object, text, token, scalar)),
            Some(_) => d.help(
                "use `m[0]` for a column of a matrix, and `m[0].x` or `m[0][0]` for an element",
            ),
            None => d,
        }
    }

    /// `x.xxx` of a scalar, as in HLSL, is a vector of it.
    fn repeated(&self, object: ExprId, text: &str, token: TokenId, of: Scalar) -> Option<Fix> {
        let is_first = |set: &&&str| text.chars().all(|c| set.starts_with(c));
        SWIZZLES.iter().find(is_first)?;
        let place = self.expr_span(object);
        let extent = Extent {
            last: token,
            ..self.tree.expr(object).extent
        };
        let rest = Span::new(place.end, self.token_span(token).end);
        let value = self.expr_text(object);
        if text.len() > 4 || !self.is_direct(extent) {
            return None;
        }
        if text.len() == 1 {
            return Some(Fix::safe(
                format!("use `{value}`"),
                vec![Edit::delete(rest)],
            ));
        }
        let open = format!("{}(", self.name_of(Type::vector(of, text.len() as u8)));
        let title = format!("use `{open}{value})`");
        let edits = vec![Edit::insert(place.start, open), Edit::replace(rest, ")")];
        Some(Fix::safe(title, edits))
    }

    /// A component of a swizzle beyond the size of the vector.
    fn no_such_component(&self, id: ExprId, object: ExprId, ty: Type, letter: usize) -> Diagnostic {
        let token = self.tree.expr(id).extent.last;
        let ExprKind::Member(_, name) = self.tree.expr(id).kind else {
            return self.explain_no_elements(id, ty);
        };
        let text = self.text(name);
        let rows = ty.components() as u8;
        let of = self.name_of(ty);
        let has = "xyzw".get(..rows as usize).unwrap_or("");
        let letters: Vec<String> = has.chars().map(|c| format!("`{c}`")).collect();
        let letters = letters.join(", ");
        let letter = text.chars().nth(letter).unwrap_or(' ');
        let message = format!("`{of}` has no component `{letter}`");
        let d = self
            .error_at(error::SWIZZLE_OUT_OF_RANGE, token, message)
            .mark(format!("`{of}` has {letters}"));
        let d = match self.tree.expr(self.tree.unparen(object)).kind {
            ExprKind::Member(..) => {
                let shown = self.expr_text(object);
                d.note(format!(
                    "the swizzle `{shown}` is a `{of}` with the components {letters}"
                ))
            }
            _ => d,
        };
        let fix = self.lack_of_components(id, object, text, rows);
        d.fix(fix.or_else(|| self.fix_swizzle(text, rows, token)))
    }

    /// `v.xyz` of a vector with two components, `v.xyzw` of one with three: adds the missing ones.
    fn lack_of_components(&self, id: ExprId, object: ExprId, text: &str, rows: u8) -> Option<Fix> {
        let size = text.len() as u8;
        let is_complete = SWIZZLES.iter().any(|set| set.starts_with(text));
        let is_written = self.token(self.tree.expr(id).extent.last + 1).kind == TokenKind::Equal;
        let scalar = self.ty(object).scalar_kind()?;
        let is_requested = self
            .expected_size(id)
            .is_none_or(|expected| expected == size);
        let is_direct = self.is_direct(self.tree.expr(id).extent);
        if !is_complete || size < rows + 1 || size < 2 || is_written || !is_requested || !is_direct
        {
            return None;
        }
        let name = self.name_of(Type::vector(scalar, size));
        let added = ExplainContext::added_components(scalar, rows, size);
        let written = format!("{name}({}{added})", self.expr_text(object));
        let edits = vec![Edit::replace(self.expr_span(id), written.clone())];
        Some(Fix::suggestion(format!("use `{written}`"), edits))
    }

    fn bad_swizzle(&self, text: &str, token: TokenId, of: &str) -> Diagnostic {
        let d = self.error_at(
            error::INVALID_SWIZZLE,
            token,
            format!("invalid swizzle `{text}` on `{of}`"),
        );
        let letters = |set: &str| text.chars().any(|c| set.contains(c));
        let sets = SWIZZLES.iter().filter(|s| letters(s)).count();
        if text.chars().all(|c| "xyzwrgbastpq".contains(c)) && sets > 1 {
            d.note("`xyzw`, `rgba` and `stpq` cannot be mixed (section 5.5)")
                .fix(self.in_one_set(text, token))
        } else if text.len() > 4 {
            d.note("a swizzle has at most four components (section 5.5)")
        } else if text == LENGTH {
            d.help("use `length(v)`")
        } else {
            d.note("the components are `xyzw`, `rgba` or `stpq` (section 5.5)")
        }
    }

    /// Writes a swizzle with the letters of its first one.
    fn in_one_set(&self, text: &str, token: TokenId) -> Option<Fix> {
        let set = SWIZZLES
            .iter()
            .find(|set| text.starts_with(|c| set.contains(c)))?;
        let place = |c: char| SWIZZLES.iter().find_map(|set| set.find(c));
        let letters = text.chars().map(|c| set.chars().nth(place(c)?));
        let letters: String = letters.collect::<Option<_>>()?;
        let edits = vec![Edit::replace(self.token_span(token), letters.clone())];
        Some(Fix::suggestion(format!("use `.{letters}`"), edits))
    }

    /// An index on a type without elements.
    pub(super) fn explain_no_elements(&self, id: ExprId, ty: Type) -> Diagnostic {
        let message = format!("`{}` cannot be indexed", self.name_of(ty));
        self.error_expr(error::INVALID_INDEX, id, message)
            .note("only arrays, vectors and matrices can be indexed (section 5.7)")
    }

    /// An index that is not an integer.
    pub(super) fn explain_index(&self, index: ExprId, ty: Type) -> Diagnostic {
        let name = self.name_of(ty);
        let d = self.error_expr(
            error::INVALID_INDEX,
            index,
            format!("index must be an integer, found `{name}`"),
        );
        let fix = match ty {
            Type::FLOAT => self.convert(index, Scalar::Int),
            _ => None,
        };
        d.fix(fix)
    }

    /// An unknown method; the only one is `length()` of arrays.
    pub(crate) fn explain_method(
        &self,
        id: ExprId,
        object: ExprId,
        name: Name,
        args: List,
    ) -> Diagnostic {
        let (ty, text) = (self.ty(object), self.text(name));
        let message = if text != LENGTH {
            format!("unknown method `{text}`; the only method is `length()` on arrays")
        } else if args.len > 0 {
            "`length()` accepts no arguments".to_string()
        } else {
            let of = self.name_of(ty);
            format!("`.length()` requires an array, found `{of}`")
        };
        let d = self.error_expr(error::NOT_A_FUNCTION, id, message);
        let d = match ty.is_vector() && text == LENGTH {
            true => d.note("a vector has a fixed number of components"),
            false => d,
        };
        let fix = self.method_as_call(id, object, name, args);
        let fix = fix.or_else(|| {
            let is_size =
                matches!(text, "size" | "count" | "len") && ty.is_array() && args.len == 0;
            let is_direct = self.is_direct(self.tree.expr(id).extent);
            let start = self.expr_span(object).end + 1;
            let name = Span::new(start, start + text.len() as u32);
            (is_size && is_direct && self.sources.text(name) == text)
                .then(|| Fix::safe("use `length()`", vec![Edit::replace(name, LENGTH)]))
        });
        let fix = fix.or_else(|| {
            let is_swizzle = ty.is_vector() && typing::components(text).is_some();
            let after = self.expr_span(object).end + 1 + text.len() as u32;
            let is_direct = self.is_direct(self.tree.expr(id).extent) && args.len == 1;
            let edits = vec![Edit::insert(after, " * ")];
            (is_swizzle && is_direct).then(|| Fix::suggestion("add `*` to multiply", edits))
        });
        d.fix(fix)
    }

    /// `v.f(a)` becomes `f(v, a)`, where there is such a function.
    fn method_as_call(&self, id: ExprId, object: ExprId, name: Name, args: List) -> Option<Fix> {
        let text = self.text(name);
        // `texture.Sample(state, uv)` in HLSL; the state comes first.
        let is_sampler = matches!(self.ty(object).base, Base::Sampler(_));
        let skipped = usize::from(is_sampler && args.len > 1);
        let function = match foreign(text, self.version).map(|f| f.meaning) {
            Some(Meaning::Function(function)) => function,
            _ if skipped > 0 && args.len > 2 => BuiltinId::TextureLod.name(),
            _ if skipped > 0 && self.has(Feature::InOut) => BuiltinId::Texture.name(),
            _ if skipped > 0 => BuiltinId::Texture2D.name(),
            _ if self.builtins.function(text).is_some() => text,
            _ if self.functions_named(name).next().is_some() => text,
            _ => return None,
        };
        let span = self.expr_span(object);
        let end = match self.tree.args(args).get(skipped) {
            Some(&first) => Span::new(span.end, self.expr_span(first).start),
            None => Span::new(span.end, self.expr_span(id).end),
        };
        let edits = vec![
            Edit::insert(span.start, format!("{function}(")),
            Edit::replace(end, if args.len > 0 { ", " } else { ")" }),
        ];
        let more = if args.len > 0 { ", ..." } else { "" };
        self.is_direct(self.tree.expr(id).extent).then(|| {
            Fix::suggestion(
                format!("use `{function}({}{more})`", self.expr_text(object)),
                edits,
            )
        })
    }

    /// A member that a struct does not have.
    fn no_such_field(&self, id: ExprId, object: ExprId, record: &Struct, name: Name) -> Diagnostic {
        let token = self.tree.expr(id).extent.last;
        let text = self.text(name);
        let of = self.name_of(self.ty(object));
        let message = format!("`{of}` has no member `{text}`");
        let d = self.error_at(error::NO_SUCH_FIELD, token, message);
        let d = self.with_declaration(d, Some(record.token), "declared here");
        let fields = || record.fields.iter().map(|f| self.text(f.name));
        let near = fields()
            .filter(|f| f.len().abs_diff(text.len()) <= 2)
            .take_while(|f| self.affords(f.len() * text.len()))
            .map(|f| (strsim::damerau_levenshtein(f, text), f))
            .filter(|(distance, _)| *distance <= 2)
            .min();
        if let Some((_, near)) = near {
            let edit = Edit::replace(self.token_span(token), near);
            return d.fix(Fix::suggestion(
                format!("did you mean `{near}`?"),
                vec![edit],
            ));
        }
        let listed = fields().take(MAX_LISTED).map(|f| format!("`{f}`"));
        let list = listed.collect::<Vec<_>>().join(", ");
        d.note(match record.fields.len().saturating_sub(MAX_LISTED) {
            0 => format!("available members: {list}"),
            more => format!("available members: {list} and {more} more"),
        })
    }

    /// Replaces components that the vector does not have, or that repeat where they must not: by
    /// the one at the same position of `xyzw`, else by an unused one.
    pub(crate) fn fix_swizzle(&self, text: &str, rows: u8, token: TokenId) -> Option<Fix> {
        let letters = SWIZZLES
            .iter()
            .find(|set| text.chars().all(|c| set.contains(c)))?;
        let has = letters.get(..rows as usize)?;
        let mut out: Vec<Option<char>> = Vec::new();
        for c in text.chars() {
            let is_free = has.contains(c) && !out.contains(&Some(c));
            let repeats = text.chars().all(|c| has.contains(c));
            out.push(Some(c).filter(|&c| if repeats { is_free } else { has.contains(c) }));
        }
        for at in 0..out.len() {
            if out.get(at).is_some_and(Option::is_some) {
                continue;
            }
            let own = match out.len() {
                1 => has.chars().last(),
                _ => has.chars().nth(at),
            };
            let own = own.filter(|&c| !out.contains(&Some(c)));
            let free = own.or_else(|| has.chars().find(|&c| !out.contains(&Some(c))));
            let letter = free.or(has.chars().last());
            out.set_at(at, letter);
        }
        let replaced: String = out.into_iter().flatten().collect();
        let edits = vec![Edit::replace(self.token_span(token), replaced.clone())];
        Some(Fix::suggestion(format!("use `.{replaced}`"), edits))
    }

    /// A member of a comma expression that is a struct containing samplers.
    pub(crate) fn explain_member_after_comma(&self, id: ExprId) -> Diagnostic {
        let message = "cannot access a member after `,` if the struct contains samplers";
        self.error_expr(error::UNSUPPORTED_OPERATION, id, message)
            .note("the browser does not compile it")
            .help("access the member of the variable directly")
    }

    /// A constant index that is out of range.
    pub(crate) fn explain_index_range(
        &self,
        object: ExprId,
        index: ExprId,
        value: i64,
        size: u32,
    ) -> Diagnostic {
        let of = self.name_of(self.ty(object));
        let message = format!("index {value} is out of range for `{of}`");
        let d = self
            .error_expr(error::INDEX_OUT_OF_RANGE, index, message)
            .mark(format!("last index is {}", size - 1));
        let variable = self.variable_of(object);
        match variable.and_then(|v| self.variables.get(v.0 as usize)) {
            Some(v) if v.token.is_some() => self.with_declaration(d, v.token, "declared here"),
            _ => d,
        }
    }

    /// An index that must be constant and is not.
    pub(crate) fn explain_dynamic_index(&self, id: ExprId, what: Indexed) -> Diagnostic {
        let what = match what {
            Indexed::Samplers => "an array of samplers",
            Indexed::Blocks => "an array of blocks",
            Indexed::Outputs => "an array of fragment outputs",
            Indexed::Output => "a fragment output",
            Indexed::Unsized => "a built-in array that is not declared with a size",
        };
        let message = format!("{what} must be indexed with a constant");
        self.error_expr(error::INVALID_INDEX, id, message)
            .note("in GLSL ES 3.00 the index must be a constant expression (sections 4.1.7, 4.3.6, 4.3.7)")
            .help("use `switch` or `if` to select the element")
    }
}
