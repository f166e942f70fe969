//! Messages for [`PlaceError`], and fixes for redeclared and undeclared names.

use crate::messages::*;

/// Longest statement, in tokens, that a fix removes.
const MAX_STATEMENT: TokenId = 1000;
/// Most uses of a name that a fix renames.
const MAX_RENAMED: usize = 500;

impl Explain for PlaceError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use PlaceError as E;
        let (id, why) = match self {
            E::NoPlace(id, by) => return c.no_place(id, by, at),
            E::Repeats(letters, rows) => {
                let letters = c.text(letters);
                let message =
                    format!("cannot assign to swizzle `{letters}`: it repeats a component");
                return c
                    .error(error::NOT_ASSIGNABLE, at, message)
                    .fix(c.fix_swizzle(letters, rows, at.first));
            }
            E::Constant(id) => (id, "is a constant"),
            E::Uniform(id) => (id, "is a uniform"),
            E::Input(id) => (id, "is a shader input"),
            E::ConstParameter(id) => (id, "is a `const` parameter"),
            E::Sampler(id) => (id, "is a sampler"),
            E::SamplerInside(id) => (id, "contains a sampler, so browsers make it read-only"),
        };
        let variable = c.variables.get(id.0 as usize);
        let name = variable.map_or("", |v| c.text(v.name));
        let token = variable.and_then(|v| v.token);
        let message = format!("cannot assign to `{name}`: it {why}");
        let d = c.error(error::NOT_ASSIGNABLE, at, message);
        let d = c.with_declaration(d, token, "declared here");
        d.fix(match variable.map(|v| v.storage) {
            _ if matches!(self, E::Constant(_)) => c.remove_const(token),
            Some(Storage::Input | Storage::Uniform) => c.copy_first(id),
            Some(Storage::Param(_)) => c.remove_const(token),
            _ => None,
        })
    }
}

impl ExplainContext<'_> {
    fn no_place(&self, id: ExprId, by: Writer, at: Extent) -> Diagnostic {
        let symbol = match by {
            Writer::Assign(op) => &format!("{}=", op.map_or("", BinaryOp::symbol)),
            Writer::Word(word) => word,
        };
        let fix = self
            .swap_sides(id)
            .or_else(|| self.compare_instead(self.root_expr));
        let message = "cannot assign to this expression";
        self.error(error::NOT_ASSIGNABLE, at, message)
            .note(format!(
                "`{symbol}` requires an l-value: a variable or a part of one (section 5.8)"
            ))
            .fix(fix)
    }

    /// Copies an input or uniform into a local variable at the start of the function, and uses
    /// that.
    pub(crate) fn copy_first(&self, variable: VariableId) -> Option<Fix> {
        let function = self.functions.get(self.current?.0 as usize)?;
        let declaration = self.tree.function(function.definition?)?;
        let body = self.tree.stmt(declaration.body?).extent;
        let open = self.token(body.first);
        let Variable { name, ty, .. } = *self.variables.get(variable.0 as usize)?;
        if ty.is_sampler() || matches!(ty.base, Base::Block(_)) || !open.is_direct() {
            return None;
        }
        let text = self.text(name);
        let bare = ["gl_", "u_", "v_", "a_", "i", "u", "v", "a"]
            .iter()
            .find_map(|prefix| {
                let rest = text.strip_prefix(prefix)?;
                let starts = |c: char| {
                    c.is_ascii_uppercase() || (prefix.ends_with('_') && c.is_ascii_alphabetic())
                };
                rest.starts_with(starts).then(|| {
                    let (first, rest) = rest.split_at_checked(1)?;
                    Some(first.to_ascii_lowercase() + rest)
                })?
            });
        let copy = self
            .names
            .unused(&bare.unwrap_or_else(|| format!("{text}Copy")));
        let line = format!("{} {copy} = {text};", self.name_of(ty));
        let mut edits = vec![Edit::insert(open.span.end, format!("\n    {line}"))];
        edits.extend(self.rename_within(name, body, &copy)?);
        Some(Fix::suggestion(
            format!("use a local copy: `{line}`"),
            edits,
        ))
    }

    /// Edits that rename every use of a name within `chunk`; `None` if one is in a macro, or if
    /// there are more than [`MAX_RENAMED`].
    fn rename_within(&self, name: Name, part: Extent, to: &str) -> Option<Vec<Edit>> {
        let tokens = &self.tokens.tokens;
        let mut edits = Vec::new();
        let mut before = TokenKind::End;
        for token in tokens.get(part.first as usize..=part.last as usize)? {
            let is_use = token.kind == TokenKind::Identifier && token.value == name.0;
            if is_use && before != TokenKind::Dot {
                if !token.is_direct() || edits.len() == MAX_RENAMED {
                    return None;
                }
                edits.push(Edit::replace(token.span, to));
            }
            before = token.kind;
        }
        Some(edits)
    }

    /// Removes `const` from the declaration of the name at `token`.
    pub(crate) fn remove_const(&self, token: Option<TokenId>) -> Option<Fix> {
        use TokenKind as T;
        let mut at = token?;
        while !matches!(
            self.token(at).kind,
            T::Semicolon | T::LeftBrace | T::RightBrace | T::LeftParen
        ) {
            let found = self.token(at);
            if found.kind == T::Const && found.is_direct() {
                let span = Span::new(found.span.start, self.token(at + 1).span.start);
                return Some(Fix::safe(
                    "remove `const` from the declaration",
                    vec![Edit::delete(span)],
                ));
            }
            at = at.checked_sub(1)?;
        }
        None
    }

    /// Whether the text defines `main` or `mainImage` twice.
    fn has_two_entries(&self) -> bool {
        let is_entry = |name: &str| matches!(name, "main" | "mainImage");
        let defined = self.tree.functions.iter().filter(|f| f.body.is_some());
        defined
            .filter(|f| is_entry(self.text(f.ident.name)))
            .count()
            > 1
    }

    /// A fix for a redeclared name: removes an identical declaration, makes an assignment of one
    /// with the same type, and renames one with another type.
    pub(in crate::messages) fn second_declaration(&self, second: SecondDeclaration) -> Option<Fix> {
        let SecondDeclaration {
            ident,
            first,
            ty,
            spec,
            is_meant,
        } = second;
        let first = self.variables.get(first.0 as usize)?;
        let spec = spec?;
        // Two shaders in one text, which a script splits.
        if self.at_global_scope() && self.has_two_entries() {
            return None;
        }
        let second = self.statement_around(ident.token)?;
        if let Some(declared) = first.token.and_then(|t| self.statement_around(t)) {
            let is_same = self.same_tokens(declared, second);
            if is_same && self.is_direct(second) {
                let edit = Edit::delete(self.span(second));
                return Some(Fix::safe("remove the second declaration", vec![edit]));
            }
        }
        let has_value = self.token(ident.token + 1).kind == TokenKind::Equal;
        let is_local = !self.at_global_scope() && !first.is_const;
        if first.ty == ty && has_value && is_local && spec.first == second.first {
            let span = Span::new(
                self.token_span(spec.first).start,
                self.token_span(ident.token).start,
            );
            return Some(Fix::safe(
                "remove the type to assign to it instead",
                vec![Edit::delete(span)],
            ));
        }
        let to = self.names.unused(&format!("{}2", self.text(ident.name)));
        let rest = Extent {
            first: ident.token,
            last: match is_meant {
                true => self.end_of_block(ident.token),
                false => ident.token,
            },
        };
        let edits = self.rename_within(ident.name, rest, &to)?;
        Some(Fix::suggestion(
            format!("rename the second one to `{to}`"),
            edits,
        ))
    }

    /// The statement around a token, from after one `;`, `{` or `}` to the next `;`; `None` if it
    /// is longer than [`MAX_STATEMENT`].
    fn statement_around(&self, token: TokenId) -> Option<Extent> {
        use TokenKind as T;
        let ends = |at: TokenId| {
            matches!(
                self.token(at).kind,
                T::Semicolon | T::LeftBrace | T::RightBrace | T::End
            )
        };
        let mut first = token;
        while first > 0 && !ends(first - 1) && token - first < MAX_STATEMENT {
            first -= 1;
        }
        let mut last = token;
        while !ends(last) && last - first < MAX_STATEMENT {
            last += 1;
        }
        (self.token(last).kind == T::Semicolon).then_some(Extent { first, last })
    }

    fn same_tokens(&self, a: Extent, b: Extent) -> bool {
        let texts = |e: Extent| (e.first..=e.last).map(|t| self.sources.text(self.token_span(t)));
        a.first != b.first && a.last - a.first == b.last - b.first && texts(a).eq(texts(b))
    }

    /// The last token of the block around a token; at global scope, of the text.
    fn end_of_block(&self, token: TokenId) -> TokenId {
        let mut open = 0_u32;
        let tokens = &self.tokens.tokens;
        for (i, t) in tokens.iter().enumerate().skip(token as usize) {
            match t.kind {
                TokenKind::LeftBrace => open += 1,
                TokenKind::RightBrace if open == 0 => return i as TokenId,
                TokenKind::RightBrace => open -= 1,
                _ => {}
            }
        }
        tokens.len().saturating_sub(1) as TokenId
    }

    /// Declares an undeclared variable at its first assignment, if all other uses come after it.
    pub(crate) fn declaration_where_set(
        &self,
        name: Name,
        token: TokenId,
        ty: Type,
    ) -> Option<Fix> {
        if ty.is_error() || ty.is_void() || ty.is_sampler() || !self.is_statement_start(token) {
            return None;
        }
        let (uses, inside) = self.uses_after(name, token);
        let (word, text) = (self.name_of(ty), self.text(name));
        let edits = vec![Edit::insert(
            self.token_span(token).start,
            format!("{word} "),
        )];
        (uses >= 2 && inside)
            .then(|| Fix::suggestion(format!("declare it here: `{word} {text} = ...`"), edits))
    }

    /// Whether a statement of a block, or a loop's head, starts with a token of the user's text.
    fn is_statement_start(&self, token: TokenId) -> bool {
        use TokenKind as T;
        let before = |n: u32| {
            token
                .checked_sub(n)
                .map_or(T::End, |at| self.token(at).kind)
        };
        self.token(token).is_direct()
            && (matches!(before(1), T::Semicolon | T::LeftBrace | T::RightBrace)
                || (before(1) == T::LeftParen && before(2) == T::For))
    }

    /// How often a name is used from a token to the end of the function, and whether all these uses
    /// are in the block around the token.
    fn uses_after(&self, name: Name, token: TokenId) -> (u32, bool) {
        let function = self
            .tree
            .functions
            .iter()
            .find(|f| (f.extent.first..=f.extent.last).contains(&token) && f.body.is_some());
        let Some(function) = function else {
            return (0, false);
        };
        let end = self.end_of_block(token);
        let (mut uses, mut inside) = (0, true);
        for at in token..=function.extent.last {
            let found = self.token(at);
            if found.kind == TokenKind::Identifier && found.value == name.0 {
                uses += 1;
                inside &= at <= end;
            }
        }
        (uses, inside)
    }

    /// `1.0 = x` becomes `x = 1.0`.
    pub(crate) fn swap_sides(&self, left: ExprId) -> Option<Fix> {
        let ExprKind::Assign(None, l, right) = self.tree.expr(self.root_expr).kind else {
            return None;
        };
        let is_place = self.variable_of(right).is_some_and(|id| {
            self.variables
                .get(id.0 as usize)
                .is_some_and(|v| self.is_writable(v))
        });
        let fits = l == left && is_place && self.ty(left) == self.ty(right);
        let (a, b) = (self.expr_span(left), self.expr_span(right));
        let edits = vec![
            Edit::replace(a, self.sources.text(b)),
            Edit::replace(b, self.sources.text(a)),
        ];
        (fits && self.is_direct(self.tree.expr(self.root_expr).extent))
            .then(|| Fix::suggestion("swap the two sides", edits))
    }
}
