//! Statements and declarations of other languages that the parser reports as several errors.

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_syntax::{
    DIRECTIVES, RawKind, RawToken, TokenKind, TypeWord, WordClass, classify, keyword_near, tokenize,
};

/// Maximum number of errors that are compared with a place.
const MAX_ERRORS: usize = 40;
/// Maximum length of the statements before an `else`, in bytes.
const MAX_BLOCK: usize = 1_500;
/// Maximum number of members of a struct.
const MAX_MEMBERS: usize = 100;

impl FaultyShader<'_> {
    pub(super) fn statements(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        all.extend(self.lost_hash(line));
        all.extend(self.character(line));
        self.string(line, all);
        all.extend(self.colon_header(line));
        all.extend(self.member_commas(line));
        all.extend(self.lost_struct(line));
        all.extend(self.lost_braces(line));
        all.extend(self.typed_names(line));
        for at in 0..line.tokens.len() {
            all.extend(self.lost_if(line, at));
            all.extend(self.type_after_name(line, at));
            all.extend(self.other_case(line, at));
            all.extend(self.lost_case(line, at));
            all.extend(self.local_qualifier(line, at));
            all.extend(self.typed_arguments(line, at));
            all.extend(self.component_index(line, at));
            all.extend(self.bracketed_constructor(line, at));
            self.half_ternary(line, at, all);
        }
    }

    /// `define PI 3.14`, `pragma once`
    fn lost_hash(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let word = line.token(0);
        if !DIRECTIVES.contains(&word) || classify(word, self.program.version) != WordClass::Plain {
            return None;
        }
        let span = line.span(0);
        let message = format!("expected `#{word}`, found `{word}`");
        let edits = vec![Edit::insert(span.start, "#")];
        let (kind, title) = (error::BAD_DIRECTIVE, format!("use `#{word}`"));
        Some(candidate(kind, span, message, title, edits))
    }

    /// `'a'`, with or without the type `char`: a character is its code.
    fn character(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let code = |at: usize| {
            let quoted = line.token(at).strip_prefix('\'')?.strip_suffix('\'')?;
            let mut chars = quoted.chars();
            let first = chars.next().filter(|_| chars.next().is_none())?;
            first.is_ascii().then_some(u32::from(first))
        };
        let mut places = 0..line.tokens.len();
        let (at, code) = places.find_map(|at| Some((at, code(at)?)))?;
        let span = line.span(at);
        let mut edits = vec![Edit::replace(span, code.to_string())];
        if let Some(ty) = (0..at).find(|&at| line.token(at) == "char") {
            edits.push(Edit::replace(line.span(ty), "int"));
        }
        let message = "GLSL has no characters; use the code of the character";
        let title = format!("use `{code}`");
        let kind = error::INVALID_CHARACTER;
        Some(candidate(kind, span, message, title, edits))
    }

    /// A statement with a string: it is removed, unless the string names a component.
    fn string(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let is_quote = |at: usize| line.token(at).starts_with(['"', '\'', '“', '‘']);
        let Some(quote) = (0..line.tokens.len()).find(|&at| is_quote(at)) else {
            return;
        };
        // The fix of another error may remove the string too: `import "a.glsl";`.
        let place = line.span(quote);
        let removes = |d: &&Diagnostic| {
            let fix = d.fix.as_ref().filter(|_| d.span.start >= line.start);
            fix.is_some_and(|f| f.edits.iter().any(|e| e.span.contains(place)))
        };
        if let Some(d) = self.errors.iter().take(MAX_ERRORS).find(removes)
            && let Some(fix) = &d.fix
        {
            all.push(RepairCandidate::of_error(d, fix.clone()));
        }
        let starts = |&at: &usize| line.starts_statement(at);
        let Some(start) = (0..=quote).rev().find(starts) else {
            return;
        };
        let end = (quote..line.tokens.len()).rfind(|&at| line.is(at, TokenKind::Semicolon));
        let Some(end) = end else { return };
        let span = line.span(start).to(line.span(end));
        let edits = vec![Edit::delete(span)];
        let quoted = Span::new(line.span(quote).start, line.span(end).start);
        let message = "GLSL has no strings";
        let (kind, title) = (error::INVALID_CHARACTER, "remove the statement");
        all.push(candidate(kind, quoted, message, title, edits));
    }

    /// `if d < 0.3:`, `else:`
    fn colon_header(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let colon = line
            .tokens
            .len()
            .checked_sub(1)
            .filter(|&at| line.is(at, TokenKind::Colon))?;
        let word = line.token(0);
        let (span, place) = (line.span(0).to(line.span(colon)), line.span(colon));
        let mut edits = Vec::new();
        let has_parens = line.is(1, TokenKind::LeftParen) && line.after(1) == Some(colon);
        match word {
            "if" | "while" if colon > 1 && !has_parens => {
                edits.push(Edit::insert(line.span(1).start, "("));
                edits.push(Edit::replace(place, ")"));
            }
            "if" | "while" | "else" => edits.push(Edit::delete(place)),
            _ => return None,
        }
        let message = format!("unexpected `:` after `{word}`; GLSL uses parentheses and braces");
        Some(foreign(span, message, "use parentheses", edits))
    }

    /// `if (c) a(); b(); else d();`: several statements before `else` need braces.
    fn lost_braces(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let is_else =
            |d: &&Diagnostic| line.errors.contains(&d.span) && self.text(d.span) == "else";
        let d = self.errors.iter().find(is_else)?;
        let code = self.program.sources.code_at(line.start)?;
        let end = (d.span.start - code.base) as usize;
        let from = end.saturating_sub(MAX_BLOCK);
        let from = (from..end).find(|&i| code.text.is_char_boundary(i));
        let before = from.and_then(|from| Some((from, code.text.get(from..end)?)));
        let (from, before) = before?;
        let tokens = tokenize(before, code.base + from as u32);
        let open = place_of_brace(before, code.base + from as u32, &tokens)?;
        let edits = vec![Edit::insert(open, " {"), Edit::insert(d.span.start, "} ")];
        let fix = Fix::suggestion("enclose the statements before it in braces", edits);
        Some(RepairCandidate::of_error(d, fix))
    }

    /// `Ray { vec3 o; };`
    fn lost_struct(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let word = line.token(0);
        if !self.is_plain(line, 0) || !line.is(1, TokenKind::LeftBrace) {
            return None;
        }
        let span = line.span(0);
        let message = format!("missing `struct` before `{word}`");
        let edits = vec![Edit::insert(span.start, "struct ")];
        let title = format!("use `struct {word}`");
        Some(syntax(span, message, title, edits))
    }

    /// `vec3 o, vec3 d,` as members of a struct.
    fn member_commas(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let code = self.program.sources.code_at(line.start)?;
        let offset = (line.start - code.base) as usize;
        let open = code.text.get(..offset).and_then(|t| t.rfind('{'))?;
        // `struct Ray {`
        let header = code.text.get(..open).unwrap_or("").trim_end();
        let name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let header = header.trim_end_matches(name).trim_end();
        if !header.ends_with("struct") {
            return None;
        }
        let close = code.text.get(open..).and_then(|t| t.find('}'))?;
        let body = code.text.get(open..open + close)?;
        let mut edits = Vec::new();
        for (at, _) in body.match_indices(',') {
            let rest = body.get(at + 1..).unwrap_or("").trim_start();
            let word: String = rest
                .chars()
                .take_while(char::is_ascii_alphanumeric)
                .collect();
            if word.is_empty() || TypeWord::named(&word).is_some() {
                let start = code.base + (open + at) as u32;
                edits.push(Edit::replace(Span::new(start, start + 1), ";"));
            }
            if edits.len() > MAX_MEMBERS {
                return None;
            }
        }
        let span = edits.first().map(|e| e.span)?;
        let message = "expected `;` after the member, found `,`";
        Some(syntax(span, message, "use `;`", edits))
    }

    /// `float f(p: vec2, k: float)`
    fn typed_names(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let mut edits = Vec::new();
        for at in 0..line.tokens.len() {
            let (name, ty) = (line.token(at), line.token(at + 2));
            let is_pair = line.kind(at) == Some(RawKind::Word)
                && line.is(at + 1, TokenKind::Colon)
                && TypeWord::named(ty).is_some();
            if is_pair {
                let span = line.span(at).to(line.span(at + 2));
                edits.push(Edit::replace(span, format!("{ty} {name}")));
            }
        }
        let first = edits.first().cloned()?;
        let message = "the type must come before the name";
        let title = format!("use `{}`", first.text);
        Some(foreign(first.span, message, title, edits))
    }

    /// `} else (c) {`
    fn lost_if(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        if line.token(at) != "else" || !line.is(at + 1, TokenKind::LeftParen) {
            return None;
        }
        let span = line.span(at).to(line.span(at + 1));
        let edits = vec![Edit::insert(line.span(at).end, " if")];
        let message = "missing `if` between `else` and a condition";
        Some(syntax(span, message, "add `if`", edits))
    }

    /// `p vec2 = uv;`
    fn type_after_name(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        use TokenKind as T;
        let ends = [T::Equal, T::Semicolon, T::Comma, T::RightParen];
        let is_pair = self.is_plain(line, at)
            && TypeWord::named(line.token(at + 1)).is_some()
            && ends.iter().any(|&kind| line.is(at + 2, kind));
        let span = line.span(at).to(line.span(at + 1));
        let text = format!("{} {}", line.token(at + 1), line.token(at));
        let message = "the type must come before the name";
        is_pair.then(|| replacement(error::FOREIGN_SYNTAX, span, message, text))
    }

    /// `Return x;`, `IF (c)`: a keyword in another case.
    fn other_case(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let word = line.token(at);
        let is_plain = line.kind(at) == Some(RawKind::Word)
            && classify(word, self.program.version) == WordClass::Plain;
        let near = keyword_near(word).filter(|(k, _)| is_plain && k.eq_ignore_ascii_case(word));
        let (keyword, _) = near?;
        let span = line.span(at);
        let message = format!("expected `{keyword}`, found `{word}`");
        let text = keyword.to_string();
        Some(replacement(error::SYNTAX_ERROR, span, message, text))
    }

    /// `0: x = 1.0;` in a `switch`
    fn lost_case(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_label = line.kind(at) == Some(RawKind::Integer) && line.is(at + 1, TokenKind::Colon);
        if !is_label || !line.starts_statement(at) {
            return None;
        }
        let span = line.span(at);
        let message = format!("expected `case {}`, found `{0}`", line.token(at));
        let edits = vec![Edit::insert(span.start, "case ")];
        Some(syntax(span, message, "add `case`", edits))
    }

    /// `in float x = 0.5;` as a local variable.
    fn local_qualifier(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let word = line.token(at);
        let is_storage = matches!(word, "in" | "out" | "inout" | "varying" | "attribute");
        let is_local = || {
            let mut errors = self.errors.iter().filter(|d| line.errors.contains(&d.span));
            errors.any(|d| d.is(error::INVALID_QUALIFIER) && d.span.touches(line.span(at)))
        };
        if !is_storage || !line.starts_statement(at) || !is_local() {
            return None;
        }
        let (span, next) = (line.span(at), line.span(at + 1));
        let edits = vec![Edit::delete(Span::new(span.start, next.start))];
        let message = format!("a local variable cannot be `{word}`");
        let (kind, title) = (error::INVALID_QUALIFIER, format!("remove `{word}`"));
        Some(candidate(kind, span, message, title, edits))
    }

    /// `f(vec2 p, float 0.3)` as a call.
    fn typed_arguments(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_call = line.kind(at) == Some(RawKind::Word) && line.is(at + 1, TokenKind::LeftParen);
        // After a type it is a declaration, whose parameters have types.
        let declares =
            at > 0 && line.kind(at - 1) == Some(RawKind::Word) && line.token(at - 1) != "return";
        let after = (is_call && !declares)
            .then(|| line.after(at + 1))
            .flatten()?;
        let mut edits = Vec::new();
        let mut depth = 0_u32;
        for i in at + 2..after {
            depth += u32::from(line.is(i - 1, TokenKind::LeftParen));
            depth -= u32::from(line.is(i - 1, TokenKind::RightParen)).min(depth);
            if depth != 1 {
                continue;
            }
            let starts = line.is(i - 1, TokenKind::LeftParen) || line.is(i - 1, TokenKind::Comma);
            let word = line.token(i);
            let is_type = TypeWord::named(word).is_some() || matches!(word, "in" | "out" | "inout");
            let next = line.kind(i + 1);
            if starts && is_type && !matches!(next, Some(RawKind::Operator(_))) {
                edits.push(Edit::delete(Span::new(
                    line.span(i).start,
                    line.span(i + 1).start,
                )));
            }
        }
        let span = edits.first().map(|e| e.span)?;
        let message = format!(
            "the arguments of a call have no types, as in `{}(...)`",
            line.token(at)
        );
        Some(syntax(span, message, "remove the types", edits))
    }

    /// `v[x]` and `v["x"]`
    fn component_index(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        if !line.is(at, TokenKind::LeftBracket) || at == 0 {
            return None;
        }
        let after = line.after(at)?;
        let inside = line.of(Span::new(line.span(at).end, line.span(after - 1).start));
        let letter = inside.trim_matches(['"', '\'', ' ']);
        if letter.len() != 1 || !"xyzwrgba".contains(letter) {
            return None;
        }
        let span = line.span(at).to(line.span(after - 1));
        let message = format!("`{}` is not an index; use `.{letter}`", inside.trim());
        let (kind, text) = (error::FOREIGN_SYNTAX, format!(".{letter}"));
        Some(replacement(kind, span, message, text))
    }

    /// `vec3[1.0, 2.0, 3.0]`
    fn bracketed_constructor(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_one = TypeWord::named(line.token(at)).is_some()
            && (line.is(at + 1, TokenKind::LeftBracket) || line.is(at + 1, TokenKind::LeftBrace));
        let after = is_one.then(|| line.after(at + 1)).flatten()?;
        let (open, close) = (line.span(at + 1), line.span(after - 1));
        // An index or a size is one expression.
        if !(at + 2..after).any(|i| line.is(i, TokenKind::Comma)) {
            return None;
        }
        let edits = vec![Edit::replace(open, "("), Edit::replace(close, ")")];
        let message = format!("`{}` must be called with parentheses", line.token(at));
        let span = line.span(at).to(close);
        Some(syntax(span, message, "use `(...)`", edits))
    }

    /// `c ? 1.0;`
    fn half_ternary(&self, line: &FaultyLine, at: usize, all: &mut Vec<RepairCandidate>) {
        if !line.is(at, TokenKind::Question) {
            return;
        }
        let end = (at..line.tokens.len()).find(|&i| line.is(i, TokenKind::Semicolon));
        let Some(end) = end.filter(|&end| end > at + 1) else {
            return;
        };
        if (at..end).any(|i| line.is(i, TokenKind::Colon)) {
            return;
        }
        let place = line.span(end - 1).end;
        for value in ["0.0", "0", "vec3(0.0)", "vec2(0.0)", "vec4(0.0)"] {
            let edits = vec![Edit::insert(place, format!(" : {value}"))];
            let message = "missing `:` of the `?:` operator";
            let title = format!("add the other value, such as `: {value}`");
            let span = Span::new(place, line.span(end).end);
            all.push(syntax(span, message, title, edits));
        }
    }
}

/// Where the condition of the last `if` of the innermost block ends, unless a brace follows it.
fn place_of_brace(text: &str, base: u32, tokens: &[RawToken]) -> Option<u32> {
    use TokenKind as T;
    let word = |t: &RawToken| {
        let range = (t.span.start - base) as usize..(t.span.end - base) as usize;
        text.get(range).unwrap_or("")
    };
    let mut depth = 0_u32;
    let mut place = None;
    let mut next = None;
    for token in tokens.iter().rev() {
        match token.kind {
            RawKind::Whitespace | RawKind::Newline | RawKind::LineComment => continue,
            RawKind::Operator(T::RightParen | T::RightBrace) => {
                if depth == 0 {
                    place = Some(token.span.end).filter(|_| next != Some(T::LeftBrace));
                }
                depth += 1;
            }
            RawKind::Operator(T::LeftParen | T::LeftBrace) => depth = depth.checked_sub(1)?,
            RawKind::Word if depth == 0 && word(token) == "if" => return place,
            _ => {}
        }
        next = match token.kind {
            RawKind::Operator(kind) => Some(kind),
            _ => None,
        };
    }
    None
}
