//! Variables and blocks of C++: `vec3 p(1, 2, 3);`, `vec3 p{1, 2, 3};`, `buffer Z { ... };`.

use super::*;
use shaderlint_syntax::{RawKind, TokenKind, TypeWord};

impl FaultyShader<'_> {
    pub(super) fn variables(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        for at in 0..line.tokens.len() {
            all.extend(self.constructed(line, at));
        }
    }

    /// `vec3 p(1, 2, 3);` and `vec3 p{1, 2, 3};`
    fn constructed(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let open = at + 2;
        let has_parens = line.is(open, TokenKind::LeftParen);
        let is_word = |i: usize| line.kind(i) == Some(RawKind::Word);
        let opens = has_parens || line.is(open, TokenKind::LeftBrace);
        if !is_word(at) || !is_word(at + 1) || !opens || !self.is_type(line.token(at)) {
            return None;
        }
        let after = line.after(open).filter(|&after| {
            line.is(after, TokenKind::Semicolon) || line.is(after, TokenKind::Comma)
        })?;
        let (ty, name) = (line.token(at), line.token(at + 1));
        let inside = line
            .of(Span::new(line.span(open).end, line.span(after - 1).start))
            .trim();
        let value = match inside {
            "" => "0".to_string(),
            inside => inside.to_string(),
        };
        let text = format!("{name} = {ty}({value})");
        let span = line.span(at + 1).to(line.span(after - 1));
        let message = match has_parens {
            true => format!("GLSL has no constructor calls in declarations such as `{name}(...)`"),
            false => format!("GLSL ES 3.00 has no initializer lists such as `{name}{{...}}`"),
        };
        let edits = vec![Edit::replace(span, text.clone())];
        let title = format!("use `{ty} {text}`");
        Some(foreign(span, message, title, edits))
    }

    /// Whether a word is a built-in type or a struct.
    fn is_type(&self, word: &str) -> bool {
        let names = &self.program.names;
        let is_struct = || {
            let mut structs = self.program.structs.iter();
            names
                .get(word)
                .is_some_and(|name| structs.any(|s| s.name == Some(name)))
        };
        TypeWord::named(word).is_some() || is_struct()
    }
}
