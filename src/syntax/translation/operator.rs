//! Operators and operands that GLSL does not have.

use super::*;

/// Word operators of other languages.
const WORDS: &[(&str, TokenKind, &str)] = &[
    ("and", TokenKind::AndAnd, "&&"),
    ("or", TokenKind::OrOr, "||"),
    ("xor", TokenKind::XorXor, "^^"),
    ("is", TokenKind::EqualEqual, "=="),
];

/// Two-character operators that GLSL does not have, with their equivalents.
const PAIRS: &[(TokenKind, TokenKind, TokenKind, &str)] = {
    use TokenKind as T;
    &[
        (T::EqualEqual, T::Equal, T::EqualEqual, "=="),
        (T::NotEqual, T::Equal, T::NotEqual, "!="),
        (T::Less, T::Greater, T::NotEqual, "!="),
        (T::Tilde, T::Equal, T::NotEqual, "!="),
        (T::Equal, T::NotEqual, T::NotEqual, "!="),
        (T::Equal, T::Less, T::LessEqual, "<="),
        (T::Equal, T::Greater, T::GreaterEqual, ">="),
        (T::Colon, T::Equal, T::Equal, "="),
    ]
};

impl Translator<'_> {
    pub(super) fn operator(&mut self) -> bool {
        self.word_operator()
            || self.pair()
            || self.logical_assignment()
            || self.power()
            || self.arrow()
            || self.namespace()
            || self.decimal_comma()
            || self.new_operator()
            || self.generic()
            || self.cast_after()
            || self.cast_before()
            || self.list()
    }

    /// `a and b`, `not a`, `a is not b`
    fn word_operator(&mut self) -> bool {
        let word = self.word(0);
        let span = self.token(0).span;
        let next = self.kind(1);
        if word == "not" && !self.before().ends_operand() {
            let is_operand = next.starts_operand() && next != TokenKind::LeftParen;
            if is_operand {
                let with_blank = Span::new(span.start, self.token(1).span.start);
                self.report(
                    span,
                    "GLSL has no `not`; use `!`",
                    Self::write(with_blank, "!"),
                );
                self.put(TokenKind::Not, 0, span);
                self.at += 1;
            }
            return is_operand;
        }
        let Some(&(_, kind, symbol)) = WORDS.iter().find(|(w, ..)| *w == word) else {
            return false;
        };
        let is_declared = self.out.len() <= self.start + 1 && next == TokenKind::LeftParen;
        if !self.before().ends_operand() || !next.starts_operand() || is_declared {
            return false;
        }
        if word == "is" && self.word(1) == "not" {
            let both = self.span(0, 2);
            self.report(
                both,
                "GLSL has no `is not`; use `!=`",
                Self::write(both, "!="),
            );
            self.put(TokenKind::NotEqual, 0, both);
            self.at += 2;
            return true;
        }
        let message = format!("GLSL has no `{word}`; use `{symbol}`");
        self.report(span, message, Self::write(span, symbol));
        self.put(kind, 0, span);
        self.at += 1;
        true
    }

    /// `===`, `<>`, `=<`, `:=`
    fn pair(&mut self) -> bool {
        let (first, second) = (self.kind(0), self.kind(1));
        let found = PAIRS.iter().find(|(a, b, ..)| (*a, *b) == (first, second));
        let Some(&(_, _, kind, symbol)) = found.filter(|_| self.touches_next(0)) else {
            return false;
        };
        let is_between = self.before().ends_operand() && self.kind(2).starts_operand();
        // `(q) => ...` is not a comparison.
        let is_arrow = kind == TokenKind::GreaterEqual
            && (self.before() == TokenKind::RightParen || self.parens == 0);
        if !is_between || is_arrow {
            return false;
        }
        let span = self.span(0, 2);
        let text = self.sources.text(span);
        let message = format!("GLSL has no `{text}`; use `{symbol}`");
        self.report(span, message, Self::write(span, symbol));
        self.put(kind, 0, span);
        self.at += 2;
        true
    }

    /// `p &&= q`
    fn logical_assignment(&mut self) -> bool {
        use TokenKind as T;
        let is_one = matches!(self.kind(0), T::AndAnd | T::OrOr | T::XorXor)
            && self.kind(1) == T::Equal
            && self.touches_next(0);
        let Some(first) = self.out.get(self.start).copied().filter(|_| is_one) else {
            return false;
        };
        let (span, symbol) = (self.span(0, 2), self.text(0));
        let last = self.out.last().map_or(first.span, |t| t.span);
        let left = self.sources.text(first.span.to(last));
        let fix = Self::write(span, &format!("= {left} {symbol}"));
        self.report(span, format!("GLSL has no `{symbol}=`"), fix);
        self.put(T::Equal, 0, span);
        self.at += 2;
        true
    }

    /// `a ** b`
    fn power(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::Star && self.kind(1) == T::Star && self.touches_next(0);
        if !is_one || !self.before().ends_operand() {
            return false;
        }
        let span = self.span(0, 2);
        let exponent = self.operand_after(2);
        let fix = self.operand_before().zip(exponent).map(|(base, end)| {
            let base = self.out.get(base).map_or(span, |t| t.span);
            let last = self.out.last().map_or(span, |t| t.span);
            let mut to = self.sources.text(self.span(2, end)).to_string();
            if self.kind(2) == T::Int && end == 3 {
                to += ".0";
            }
            let whole = base.to(self.token(end - 1).span);
            let text = format!("pow({}, {to})", self.sources.text(base.to(last)));
            Fix::suggested_replacement(whole, text)
        });
        self.report(span, "GLSL has no `**`; use `pow(a, b)`", fix);
        self.put(T::Star, 0, span);
        self.at += 2;
        if self.kind(0) == T::Int && exponent == Some(3) {
            let token = self.token(0);
            let value = self.text(0).parse::<f32>().unwrap_or(0.0);
            self.put(T::Float, value.to_bits(), token.span);
            self.at += 1;
        }
        true
    }

    /// Index in `out` where the last operand starts.
    fn operand_before(&self) -> Option<usize> {
        use TokenKind as T;
        let mut at = self.out.len().checked_sub(1)?;
        loop {
            let mut depth = 0_u32;
            while matches!(self.out.get(at)?.kind, T::RightParen | T::RightBracket) || depth > 0 {
                match self.out.get(at)?.kind {
                    T::RightParen | T::RightBracket => depth += 1,
                    T::LeftParen | T::LeftBracket => depth -= 1,
                    _ => {}
                }
                if depth == 0 {
                    let named = at.checked_sub(1).filter(|&i| {
                        let kind = self.out.get(i).map(|t| t.kind);
                        matches!(kind, Some(T::Identifier | T::Type | T::RightBracket))
                    });
                    match named {
                        Some(before) => at = before,
                        None => return Some(at),
                    }
                    continue;
                }
                at = at.checked_sub(1)?;
            }
            let dotted = at.checked_sub(1).and_then(|i| self.out.get(i));
            match dotted.map(|t| t.kind) {
                Some(T::Dot) => at = at.checked_sub(2)?,
                _ => return Some(at),
            }
        }
    }

    /// Offset after the operand that starts at `ahead`.
    fn operand_after(&self, ahead: usize) -> Option<usize> {
        use TokenKind as T;
        let mut at = ahead;
        while matches!(self.kind(at), T::Minus | T::Plus | T::Not | T::Tilde) {
            at += 1;
        }
        at = match self.kind(at) {
            T::LeftParen => self.after(at)?,
            kind if kind.starts_operand() => at + 1,
            _ => return None,
        };
        loop {
            at = match self.kind(at) {
                T::LeftParen | T::LeftBracket => self.after(at)?,
                T::Dot => at + 2,
                _ => return Some(at),
            };
        }
    }

    /// `p->x`
    fn arrow(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::Minus && self.kind(1) == T::Greater && self.touches_next(0);
        if !is_one || !self.before().ends_operand() || self.kind(2) != T::Identifier {
            return false;
        }
        // `) -> type {` is a function header.
        if self.kind(3) == T::LeftBrace {
            return false;
        }
        let span = self.span(0, 2);
        self.report(
            span,
            "GLSL has no pointers and no `->`",
            Self::write(span, "."),
        );
        self.put(T::Dot, 0, span);
        self.at += 2;
        true
    }

    /// `std::sin`
    fn namespace(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::Identifier
            && (self.kind(1), self.kind(2)) == (T::Colon, T::Colon)
            && self.touches_next(1)
            && matches!(self.kind(3), T::Identifier | T::Type);
        if is_one {
            let word = self.text(0);
            let message = format!("GLSL has no namespaces such as `{word}::`");
            let title = format!("remove `{word}::`");
            let fix = Fix::safe(title, vec![Edit::delete(self.span(0, 3))]);
            self.report(self.span(0, 3), message, Some(fix));
            self.at += 3;
        }
        is_one
    }

    /// `float x = 1,5;`
    fn decimal_comma(&mut self) -> bool {
        use TokenKind as T;
        let declares = self.out.get(self.start..).is_some_and(|statement| {
            let is_const = statement.first().is_some_and(|t| t.kind == T::Const);
            statement
                .get(is_const as usize)
                .is_some_and(|t| t.kind == T::Type)
        });
        let is_one = self.kind(0) == T::Comma
            && self.kind(1) == T::Int
            && self.before() == T::Int
            && self.parens == 0
            && declares
            && self.touches_next(0);
        let Some(whole) = self.out.last().copied().filter(|_| is_one) else {
            return false;
        };
        let span = whole.span.to(self.token(1).span);
        let text = self.sources.text(span).replace(',', ".");
        let Ok(value) = text.parse::<f32>() else {
            return false;
        };
        self.report(
            span,
            "expected a decimal point, found `,`",
            Self::write(span, &text),
        );
        self.out.pop();
        self.put(T::Float, value.to_bits(), span);
        self.at += 2;
        true
    }

    /// `float c[3] = [1.0, 2.0, 3.0];`
    fn list(&mut self) -> bool {
        use TokenKind as T;
        if self.kind(0) != T::LeftBracket || self.before() != T::Equal {
            return false;
        }
        let statement = self.out.get(self.start..).unwrap_or(&[]);
        let skip = statement.first().is_some_and(|t| t.kind == T::Const) as usize;
        let Some(ty) = statement.get(skip).copied().filter(|t| t.kind == T::Type) else {
            return false;
        };
        let is_array = statement.iter().any(|t| t.kind == T::LeftBracket);
        let Some(end) = self.after(0).filter(|&end| end > 2) else {
            return false;
        };
        let word = TypeWord::ALL
            .get(ty.value as usize)
            .map_or("", |w| w.name());
        let call = if is_array {
            format!("{word}[](")
        } else {
            format!("{word}(")
        };
        let (open, close) = (self.token(0).span, self.token(end - 1).span);
        let edits = vec![Edit::replace(open, call.clone()), Edit::replace(close, ")")];
        let fix = Fix::safe(format!("use `{call}...)`"), edits);
        let span = self.span(0, end);
        self.report(span, "GLSL has no `[...]` array literals", Some(fix));
        self.note("arrays and vectors are built with constructors (section 5.4)");
        self.put(T::Type, ty.value, open);
        if is_array {
            self.put(T::LeftBracket, 0, open);
            self.put(T::RightBracket, 0, open);
        }
        self.put(T::LeftParen, 0, open);
        self.at += 1;
        for _ in 1..end - 1 {
            self.keep();
        }
        self.put(T::RightParen, 0, close);
        self.at += 1;
        true
    }

    /// `new vec3(...)`
    fn new_operator(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.word(0) == "new"
            && matches!(self.kind(1), T::Identifier | T::Type)
            && self.kind(2) == T::LeftParen
            && !self.starts_statement();
        if is_one {
            let fix = self.remove(0, 1);
            self.report(self.token(0).span, "GLSL has no `new`", fix);
            self.note("values are created with constructors (section 5.4)");
            self.at += 1;
        }
        is_one
    }

    /// `vec3<f32>` and `static_cast<float>(...)`
    fn generic(&mut self) -> bool {
        use TokenKind as T;
        if self.kind(1) != T::Less {
            return false;
        }
        let is_cast = self.word(0).ends_with("_cast");
        let found = match is_cast {
            true => self
                .plain_type(2)
                .filter(|&(_, end)| self.kind(end) == T::Greater),
            false => self.type_at(0).filter(|&(_, end)| end == 4),
        };
        let Some((word, end)) = found.map(|(w, end)| (w, end + is_cast as usize)) else {
            return false;
        };
        if !matches!(self.kind(end), T::LeftParen | T::Identifier) {
            return false;
        }
        let span = self.span(0, end);
        let text = self.sources.text(span);
        let message = format!("GLSL has no `{text}`; use `{}`", word.name());
        self.report(span, message, Self::write(span, word.name()));
        self.put_type(word, span);
        self.at += end;
        true
    }

    /// `x as f32`
    fn cast_after(&mut self) -> bool {
        if self.word(0) != "as" || !self.before().ends_operand() {
            return false;
        }
        let (Some((word, end)), Some(first)) = (self.type_at(1), self.operand_before()) else {
            return false;
        };
        let Some(start) = self.out.get(first).map(|t| t.span) else {
            return false;
        };
        let last = self.out.last().map_or(start, |t| t.span);
        let text = format!("{}({})", word.name(), self.sources.text(start.to(last)));
        let whole = start.to(self.token(end - 1).span);
        let message = "GLSL has no `as`; use a constructor";
        self.report(self.span(0, end), message, Self::write(whole, &text));
        let operand = self.out.split_off(first);
        self.put_type(word, start);
        self.put(TokenKind::LeftParen, 0, start);
        self.out.extend(operand);
        self.put(TokenKind::RightParen, 0, self.token(0).span);
        self.at += end;
        true
    }

    /// `(float3) x`: translates the type, so that the parser recognises the cast.
    fn cast_before(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::LeftParen
            && matches!(self.kind(1), T::Identifier | T::Reserved)
            && self.kind(2) == T::RightParen
            && self.kind(3).starts_operand()
            && !matches!(self.kind(3), T::Minus | T::Plus)
            && !self.before().ends_operand();
        let word = match is_one {
            true => self.foreign_type(self.text(1)),
            false => None,
        };
        if let Some(word) = word {
            self.keep();
            let span = self.token(0).span;
            self.put_type(word, span);
            self.at += 1;
            self.changed = true;
        }
        word.is_some()
    }
}
