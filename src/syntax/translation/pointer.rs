//! References and pointers as parameters: `vec2& p`, `const vec3 &q`, `float *x`. GLSL copies
//! arguments in and out instead.

use super::*;

impl Translator<'_> {
    pub(super) fn pointer(&mut self) -> bool {
        self.pointed_parameter() || self.dereferenced() || self.address()
    }

    /// A parameter becomes `inout`, unless it is `const`.
    fn pointed_parameter(&mut self) -> bool {
        use TokenKind as T;
        let is_type = matches!(self.kind(0), T::Type | T::Identifier);
        let signs = matches!(self.kind(1), T::And | T::Star) && self.kind(2) == T::Identifier;
        let ends = matches!(self.kind(3), T::Comma | T::RightParen);
        // `float f(`
        let in_header = self.braces == 0
            && self.parens == 1
            && self.out.get(self.start + 2).map(|t| t.kind) == Some(T::LeftParen);
        if !(is_type && signs && ends && in_header) {
            return false;
        }
        let (ty, sign) = (self.token(0), self.token(1));
        let (is_plain, is_const) = match self.before() {
            T::LeftParen | T::Comma => (true, false),
            T::Const => (false, true),
            T::In | T::Out | T::Inout => (false, false),
            _ => return false,
        };
        let (written, name) = (self.text(0), self.text(2));
        let before = if is_plain { "inout " } else { "" };
        let mut edits = Vec::new();
        if is_plain {
            edits.push(Edit::insert(ty.span.start, before));
        }
        // From `vec2& p`, `vec2 &p` and `vec2 & p` one blank is left.
        let gap = Span::new(ty.span.end, self.token(2).span.start);
        edits.push(Edit::replace(gap, " "));
        let title = match is_const {
            true => format!("use `const {written} {name}`"),
            false => format!("use `{before}{written} {name}`"),
        };
        let what = match sign.kind {
            T::Star => "pointers",
            _ => "references",
        };
        let message = format!("GLSL has no {what}");
        self.report(sign.span, message, Some(Fix::suggestion(title, edits)));
        self.note("arguments of `inout` parameters are copied in and out");
        if is_plain {
            self.put(T::Inout, 0, ty.span);
        }
        self.keep();
        self.at += 1;
        self.keep();
        if sign.kind == T::Star {
            self.pointer = Some(self.diagnostics.len() - 1);
        }
        true
    }

    /// `*p` of a parameter `p`: part of the same mistake.
    fn dereferenced(&mut self) -> bool {
        use TokenKind as T;
        let is_unary = !matches!(
            self.before(),
            T::Identifier | T::Int | T::Uint | T::Float | T::RightParen | T::RightBracket
        );
        let is_one = self.kind(0) == T::Star && self.kind(1) == T::Identifier && is_unary;
        is_one && self.drop_sign()
    }

    /// `f(&x)` for a parameter that is a pointer.
    fn address(&mut self) -> bool {
        use TokenKind as T;
        let is_argument = matches!(self.before(), T::LeftParen | T::Comma);
        let is_one = self.kind(0) == T::And && self.kind(1) == T::Identifier && is_argument;
        is_one && self.drop_sign()
    }

    /// Removes a sign with the fix of the last pointer. Returns whether there is one.
    fn drop_sign(&mut self) -> bool {
        let span = self.token(0).span;
        let found = self.pointer.and_then(|at| self.diagnostics.get_mut(at));
        let Some(fix) = found.and_then(|d| d.fix.as_mut()) else {
            return false;
        };
        fix.edits.push(Edit::delete(span));
        self.at += 1;
        self.changed = true;
        true
    }
}
