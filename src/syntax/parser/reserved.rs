//! Reserved words and keywords used as names.

use super::{Parsed, Parser, Reported};
use crate::ast::*;
use crate::language::LanguageProfile;
use crate::names::{Name, Version, WordClass, classify};
use crate::set::{self, TokenSet};
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::{Diagnostic, Fix, Subject, error};
use shaderlint_text::{Edit, Span};

/// Reserved words that name a type in other languages, with the GLSL equivalent.
#[rustfmt::skip]
const TYPES: &[(&str, &str)] = &[
    ("double", "float"), ("half", "float"), ("long", "int"), ("short", "int"), ("fixed", "float"),
    ("unsigned", "uint"),
    ("dvec2", "vec2"), ("dvec3", "vec3"), ("dvec4", "vec4"),
    ("hvec2", "vec2"), ("hvec3", "vec3"), ("hvec4", "vec4"),
    ("fvec2", "vec2"), ("fvec3", "vec3"), ("fvec4", "vec4"),
    ("sampler1D", "sampler2D"), ("sampler2DRect", "sampler2D"), ("samplerExternalOES", "sampler2D"),
];

/// Reserved words that are declaration modifiers in other languages and versions.
const MODIFIERS: &str = "\
    static inline noinline extern external public volatile coherent restrict readonly writeonly \
    noperspective resource patch subroutine common superp";

fn is_modifier(word: &str) -> bool {
    MODIFIERS.split(' ').any(|modifier| modifier == word)
}

/// Suggested replacement names for frequently used reserved words.
#[rustfmt::skip]
const NAMES: &[(&str, &str)] = &[
    ("cast", "castRay"), ("sample", "sampleColor"), ("filter", "filterColor"),
    ("input", "inputValue"), ("output", "outputValue"), ("half", "halfSize"), ("this", "self"),
    ("active", "isActive"), ("common", "commonValue"), ("partition", "part"), ("union", "unite"),
];

/// Most uses of a name that a fix renames.
const MAX_RENAMED: usize = 1_000;

/// Whether a keyword is not reserved in the oldest version, so that its shaders may use it as a name.
fn is_newer(word: &str) -> bool {
    let old = classify(word, Version::Es100);
    matches!(old, WordClass::Plain | WordClass::Reserved)
}

impl Parser<'_> {
    /// Parses a name; reports a reserved word and accepts it as a name.
    pub(super) fn ident(&mut self, what: &str) -> Parsed<Ident> {
        while self.is(TokenKind::Bad) {
            self.advance();
        }
        let token = self.next();
        match token.kind {
            TokenKind::Identifier => {}
            TokenKind::Reserved => self.report_reserved(&token),
            _ if self.is_keyword(&token) => {
                let name = self
                    .names
                    .get(self.text(&token))
                    .ok_or_else(|| self.unexpected(what))?;
                self.report_keyword(name, &token);
                return Ok(Ident {
                    name,
                    token: self.advance(),
                });
            }
            _ => return Err(self.unexpected(what)),
        }
        Ok(Ident {
            name: Name(token.value),
            token: self.advance(),
        })
    }

    /// Whether a keyword is used as a name, so that the declaration continues after it.
    fn is_keyword(&self, token: &Token) -> bool {
        let is_word = self
            .text(token)
            .starts_with(|c: char| c.is_ascii_alphabetic());
        is_word
            && token.is_direct()
            && !matches!(token.kind, TokenKind::End | TokenKind::Bad)
            && set::FOLLOWS_NAME.contains(self.kind(1))
    }

    /// Reports a keyword used as a name; one that an older version lacks once for all its uses.
    fn report_keyword(&mut self, name: Name, token: &Token) {
        let word = self.text(token).to_string();
        if is_newer(&word) {
            if self.reserved.contains(&name) {
                return;
            }
            self.reserved.push(name);
        }
        let d = Diagnostic::error(
            error::RESERVED_WORD,
            token.span,
            format!("`{word}` is a keyword and cannot be used as a name"),
        );
        let d = match is_newer(&word) {
            true => self.with_rename(d, token, &word),
            false => d.help("use another name"),
        };
        self.report_at(d, token);
    }

    /// Whether a token is a qualifier that older versions lack. At the start of an expression, it is a name.
    pub(super) fn is_qualifier_as_name(&self, token: &Token) -> bool {
        let is_keyword =
            token.kind != TokenKind::Type && set::STARTS_DECLARATION.contains(token.kind);
        is_keyword && is_newer(self.text(token))
    }

    /// Parses such an expression.
    pub(super) fn qualifier_as_name(&mut self) -> Parsed<ExprId> {
        let token = self.next();
        let name = Name(token.value);
        self.report_keyword(name, &token);
        self.name_or_call()
    }

    /// Adds a fix that renames a word used as a name.
    fn with_rename(&self, d: Diagnostic, token: &Token, word: &str) -> Diagnostic {
        let free = self.free_name(word);
        match self.rename(token, word, &free) {
            Some(edits) if (1..=MAX_RENAMED).contains(&edits.len()) => {
                let title = match edits.len() {
                    1 => format!("rename it to `{free}`"),
                    2 => format!("rename both uses to `{free}`"),
                    n => format!("rename all {n} uses to `{free}`"),
                };
                d.fix(Fix::safe(title, edits))
            }
            _ => d.help(format!("rename it, for example to `{free}`")),
        }
    }

    /// Reports a reserved word used as a name, once for all its uses.
    pub(super) fn report_reserved(&mut self, token: &Token) {
        let name = Name(token.value);
        if self.reserved.contains(&name) {
            return;
        }
        self.reserved.push(name);
        let word = self.names.text(name);
        let LanguageProfile {
            name: language,
            reserved_words,
            ..
        } = self.version.profile();
        let d = Diagnostic::error(
            error::RESERVED_WORD,
            token.span,
            format!("`{word}` is a reserved word and cannot be used as a name"),
        )
        .note(format!(
            "{language} reserves it for future use ({reserved_words})"
        ));
        let d = self.with_rename(d, token, word);
        self.report_at(d, token);
    }

    /// A name based on `word` that the shader does not use.
    fn free_name(&self, word: &str) -> String {
        let known = NAMES
            .iter()
            .find(|(w, _)| *w == word)
            .map(|(_, n)| n.to_string());
        let base = known.unwrap_or_else(|| format!("{word}Value"));
        self.names.unused(&base)
    }

    /// Edits that rename every use of a word, also as a member and in macros; `None` if one is not spelled in
    /// the user's text.
    fn rename(&self, used: &Token, word: &str, to: &str) -> Option<Vec<Edit>> {
        let mut edits = Vec::new();
        let tokens = self.tokens.iter();
        for token in tokens.filter(|t| (t.kind, t.value) == (used.kind, used.value)) {
            let span = match token.is_direct() {
                true => token.span,
                false => Span::new(token.spelled, token.spelled + word.len() as u32),
            };
            if !self.sources.is_user(span.start) || self.sources.text(span) != word {
                return None;
            }
            edits.push(Edit::replace(span, to));
        }
        edits.sort_by_key(|e| e.span);
        edits.dedup();
        Some(edits)
    }

    /// Parses a reserved word at the start of an expression.
    pub(super) fn reserved_primary(&mut self) -> Parsed<ExprId> {
        let token = self.next();
        let word = self.names.text(Name(token.value));
        if self.kind(1) == TokenKind::LeftParen && TYPES.iter().any(|(w, _)| *w == word) {
            let ty = self.type_spec()?;
            let first = self.tree.ty(ty).extent.first;
            self.skip_parens();
            return Ok(self.error_expr(first));
        }
        self.report_reserved(&token);
        self.name_or_call()
    }

    /// Whether a statement of a newer version of GLSL ES starts here: `switch (...) {`.
    pub(super) fn at_newer_statement(&self) -> bool {
        let is_statement = |word| {
            let class = classify(word, Version::NEWEST);
            matches!(class, WordClass::Keyword(TokenKind::Switch))
        };
        self.is(TokenKind::Reserved)
            && self.kind(1) == TokenKind::LeftParen
            && is_statement(self.names.text(Name(self.next().value)))
    }

    /// Reports a statement of a newer version and skips it.
    pub(super) fn newer_statement(&mut self) -> StmtKind {
        let token = self.next();
        let word = self.names.text(Name(token.value));
        let name = self.version.profile().name;
        let message = format!("{name} has no `{word}` statement");
        let d = Diagnostic::error(error::RESERVED_WORD, token.span, message)
            .help("use `if` and `else if`, or GLSL ES 3.00");
        self.report_at(d, &token);
        self.advance();
        self.skip_parens();
        if self.is(TokenKind::LeftBrace) {
            self.skip_braces();
        }
        StmtKind::Error
    }

    /// Parses a reserved word used as a type.
    pub(super) fn reserved_type(&mut self) -> TypeBase {
        let token = self.next();
        let name = Name(token.value);
        let word = self.names.text(name);
        self.advance();
        if !self.reserved.contains(&name) {
            self.reserved.push(name);
            let d = Diagnostic::error(
                error::RESERVED_WORD,
                token.span,
                format!("WebGL2 has no type `{word}`"),
            )
            .note("it is a reserved word");
            let other = TYPES.iter().find(|(w, _)| *w == word).map(|(_, t)| *t);
            let d = match other {
                Some("uint") if self.is(TokenKind::Type) => d.fix(Fix::safe_replacement(
                    token.span.to(self.next().span),
                    "uint",
                )),
                Some(other) => d.fix(Fix::suggestion(
                    format!("use `{other}`"),
                    self.rename(&token, word, other).unwrap_or_default(),
                )),
                None => d,
            };
            self.report_at(d, &token);
        }
        if word == "unsigned" {
            self.eat(TokenKind::Type);
        }
        TypeBase::Error
    }

    /// Parses a reserved word among qualifiers: `attribute` and `varying` of GLSL ES 1.00, which
    /// have a meaning (`Some(Some(..))`), or a modifier of another language, which is reported and
    /// dropped (`Some(None)`). `None` if the word is not a qualifier.
    pub(super) fn reserved_qualifier(&mut self) -> Option<Option<QualifierKind>> {
        let token = self.next();
        let word = self.names.text(Name(token.value));
        if word == "attribute" || word == "varying" {
            return Some(Some(self.legacy_qualifier(&token, word)));
        }
        use TokenKind as T;
        const DECLARES: TokenSet = TokenSet::of(&[
            T::Type,
            T::Void,
            T::Identifier,
            T::Const,
            T::Uniform,
            T::In,
            T::Out,
            T::Attribute,
            T::Varying,
        ]);
        let newer = classify(word, Version::NEWEST);
        let is_newer = matches!(
            newer,
            WordClass::Keyword(T::Flat | T::Smooth | T::Centroid | T::Layout)
        );
        let is_modifier = is_modifier(word) || is_newer;
        if !is_modifier || !DECLARES.contains(self.kind(1)) {
            return None;
        }
        let (language, note) = match is_newer {
            true => (
                self.version.profile().name,
                "it was added in GLSL ES 3.00, as `#version 300 es` declares",
            ),
            false => ("WebGL2", "it is a reserved word"),
        };
        let d = Diagnostic::error(
            error::RESERVED_WORD,
            token.span,
            format!("{language} has no qualifier `{word}`"),
        )
        .note(note)
        .fix(Fix::safe(
            format!("remove `{word}`"),
            vec![Edit::delete(
                token.span.to(self.token(self.at + 1).span.before()),
            )],
        ));
        self.report_at(d, &token);
        self.advance();
        Some(None)
    }

    fn legacy_qualifier(&mut self, token: &Token, word: &str) -> QualifierKind {
        let kind = if word == "attribute" {
            QualifierKind::Attribute
        } else {
            QualifierKind::Varying
        };
        let now = if word == "varying" && !self.is_fragment {
            "out"
        } else {
            "in"
        };
        let d = Diagnostic::error(
            error::LEGACY_GLSL,
            token.span,
            format!("`{word}` was removed in GLSL ES 3.00"),
        )
        .note(match word {
            "attribute" => "inputs of the vertex shader are declared `in`",
            _ => "varyings are declared `out` in the vertex shader and `in` in the fragment shader",
        })
        .fix(Fix::safe_replacement(token.span, now));
        self.report_at(d, token);
        kind
    }

    /// Whether a declaration starts here, inside a function.
    pub(super) fn at_declaration(&self) -> bool {
        use TokenKind as T;
        match self.peek() {
            T::Type => match self.kind(1) {
                T::LeftParen => false,
                T::LeftBracket => self
                    .after_brackets(self.at + 1)
                    .is_none_or(|at| self.token(at).kind != T::LeftParen),
                _ => true,
            },
            T::Identifier => match self.kind(1) {
                T::Identifier | T::Reserved => true,
                T::LeftBracket => self
                    .after_brackets(self.at + 1)
                    .is_some_and(|at| self.token(at).kind == T::Identifier),
                _ => false,
            },
            T::Reserved => {
                let word = self.names.text(Name(self.next().value));
                let is_type = TYPES.iter().any(|(w, _)| *w == word);
                matches!(word, "attribute" | "varying")
                    || (matches!(
                        self.kind(1),
                        T::Identifier | T::Reserved | T::Type | T::Const | T::Void
                    ) && (is_type || is_modifier(word) || self.kind(1) == T::Identifier))
            }
            kind => {
                let is_used = kind != T::Layout && set::FOLLOWS_USE.contains(self.kind(1));
                let is_name = is_used && self.is_qualifier_as_name(&self.next());
                set::STARTS_DECLARATION.contains(kind) && !is_name
            }
        }
    }

    /// Whether a declaration starts here, at global scope.
    pub(super) fn at_global_declaration(&self) -> bool {
        match self.peek() {
            TokenKind::Identifier | TokenKind::Reserved => !set::FOLLOWS_USE.contains(self.kind(1)),
            TokenKind::Type => self.kind(1) != TokenKind::LeftParen,
            _ => self.at_declaration(),
        }
    }

    /// Reports code where only declarations are allowed.
    pub(super) fn code_outside_function(&mut self) -> Reported {
        if set::STARTS_OUTER_STATEMENT.contains(self.peek()) {
            let d = self
                .error_here(error::SYNTAX_ERROR, "statement outside a function")
                .about(Subject::OuterStatement)
                .note("an extra `}` may have closed the previous function");
            self.report(d);
            return Reported;
        }
        self.unexpected("a declaration")
    }
}
