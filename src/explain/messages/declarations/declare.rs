//! Messages for [`DeclarationError`].

use crate::messages::*;

impl Explain for DeclarationError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use DeclarationError as E;
        match self {
            E::Void => c.error(error::VOID_VALUE, at, "a variable cannot have type `void`"),
            E::Sampler => c
                .error(
                    error::SAMPLER_RESTRICTION,
                    at,
                    "a sampler must be a `uniform` or a function parameter",
                )
                .note("samplers cannot be copied into variables (section 4.1.7)")
                .fix(c.as_uniform(at)),
            E::NoValue(name) => {
                let message = format!("constant `{}` has no initializer", c.text(name));
                let d = c.error(error::NOT_CONSTANT, at, message);
                let word = at
                    .first
                    .checked_sub(2)
                    .filter(|&t| c.token(t).kind == TokenKind::Const);
                d.fix(word.map(|word| c.without_word(word)))
            }
            E::Value(storage) => {
                let word = storage.name();
                let message = format!("`{word}` variables cannot have an initializer");
                c.error(error::INVALID_QUALIFIER, at, message)
                    .note("only `const` and unqualified variables accept an initializer")
                    .fix(c.without_initializer(at))
            }
        }
    }
}

/// Most tokens of an initializer that is removed.
const MAX_INITIALIZER: u32 = 200;

impl ExplainContext<'_> {
    /// Adds `uniform` to a declaration at global scope whose name is at `at`.
    fn as_uniform(&self, at: Extent) -> Option<Fix> {
        let ty = self.token(at.first.checked_sub(1)?);
        let is_global = self.current.is_none() && ty.kind == TokenKind::Type;
        let edits = vec![Edit::insert(ty.span.start, "uniform ")];
        is_global.then(|| Fix::suggestion("declare it as `uniform`", edits))
    }

    /// Removes a word and the space after it.
    pub(super) fn without_word(&self, word: TokenId) -> Fix {
        let span = self.token_span(word);
        let next = self.token_span(word + 1).start.max(span.end);
        let title = format!("remove `{}`", self.sources.text(span));
        Fix::suggestion(title, vec![Edit::delete(Span::new(span.start, next))])
    }

    /// Removes the initializer of the variable whose name is at `at`.
    fn without_initializer(&self, at: Extent) -> Option<Fix> {
        use TokenKind as T;
        let mut depth = 0_u32;
        let end = (at.first + 1..at.first + MAX_INITIALIZER).find(|&token| {
            match self.token(token).kind {
                T::LeftParen | T::LeftBracket => depth += 1,
                T::RightParen | T::RightBracket => depth = depth.saturating_sub(1),
                T::Semicolon | T::End => return true,
                T::Comma => return depth == 0,
                _ => {}
            }
            false
        })?;
        let starts = self.token(at.first + 1).kind == T::Equal;
        let span = Span::new(self.token_span(at.first).end, self.token_span(end - 1).end);
        let edits = vec![Edit::delete(span)];
        starts.then(|| Fix::suggestion("remove the initializer", edits))
    }
}
