//! Declarations of other languages that GLSL does not have or spells differently.

use super::*;
use shaderlint_diagnostic::Applicability;

/// Keywords that introduce a function.
const FUNCTIONS: &[&str] = &["def", "function", "fn", "func", "fun", "sub", "proc"];
/// Keywords that introduce an import.
const IMPORTS: &[&str] = &[
    "import", "include", "from", "require", "use", "using", "package", "module",
];
/// Declaration modifiers and their GLSL equivalents.
const MODIFIERS: &[(&str, TokenKind)] = &[
    ("constexpr", TokenKind::Const),
    ("readonly", TokenKind::Const),
];

impl Translator<'_> {
    pub(super) fn declaration(&mut self) -> bool {
        self.alias()
            || self.import()
            || self.typedef()
            || self.type_of_classes()
            || self.storage_buffer()
            || self.uniform_buffer()
            || self.function()
            || self.annotated()
            || self.reference()
            || self.modifier()
            || self.constant()
            || self.returned()
            || self.semantic()
    }

    /// A type name introduced by `typedef`.
    fn alias(&mut self) -> bool {
        let token = self.token(0);
        let is_word = token.kind == TokenKind::Identifier;
        let found = self
            .aliases
            .iter()
            .find(|(name, _)| is_word && *name == token.value);
        let Some(&(_, word)) = found else {
            return false;
        };
        self.put_type(word, token.span);
        self.at += 1;
        true
    }

    /// `import x`, `using namespace x;`
    fn import(&mut self) -> bool {
        use TokenKind as T;
        let is_word = matches!(self.kind(0), T::Identifier | T::Reserved);
        let is_one = is_word
            && self.braces == 0
            && self.starts_line(0)
            && self.starts_statement()
            && IMPORTS.contains(&self.text(0))
            && matches!(
                self.kind(1),
                T::Identifier | T::Reserved | T::Bad | T::LeftParen | T::LeftBrace | T::Star
            );
        if is_one {
            let mut end = self.end_of_line();
            if let Some(at) = (1..end).find(|&i| self.kind(i) == T::Semicolon) {
                end = at + 1;
            }
            let fix = self
                .remove(0, end)
                .map(|fix| Fix::suggestion(fix.title, fix.edits));
            let message = format!("GLSL has no `{}`; a shader is a single text", self.text(0));
            self.report(self.span(0, end), message, fix);
            self.at += end;
        }
        is_one
    }

    /// `typedef vec3 color;`
    fn typedef(&mut self) -> bool {
        use TokenKind as T;
        // Used as a variable name, it is only a reserved word.
        if self.text(0) != "typedef" || !self.starts_statement() || self.kind(1) == T::Equal {
            return false;
        }
        let ends = |i: &usize| matches!(self.kind(*i), T::Semicolon | T::LeftBrace | T::End);
        let end = (2..MAX_INSIDE).find(ends);
        let names =
            |&end: &usize| (self.kind(end), self.kind(end - 1)) == (T::Semicolon, T::Identifier);
        let Some(end) = end.filter(names) else {
            return false;
        };
        let span = self.span(0, end + 1);
        let alias = self
            .type_at(1)
            .filter(|&(_, after)| self.kind(after) == T::Identifier && after + 1 == end);
        let fix = alias.map(|(word, _)| {
            let line = format!("#define {} {}", self.text(end - 1), word.name());
            Fix::suggested_replacement(span, line)
        });
        let is_line = self.starts_line(0) && self.starts_line(end + 1);
        self.report(span, "GLSL has no `typedef`", fix.filter(|_| is_line));
        let name = self.token(end - 1).value;
        match alias {
            Some((word, _)) => self.aliases.push((name, word)),
            None => self.lost.push(Name(name)),
        }
        self.at += end + 1;
        true
    }

    /// `enum`, `class`, `namespace` and `template`, including their contents.
    fn type_of_classes(&mut self) -> bool {
        use TokenKind as T;
        let word = self.text(0);
        let is_word = matches!(self.kind(0), T::Reserved | T::Identifier);
        let is_one = matches!(
            word,
            "enum" | "class" | "namespace" | "template" | "interface" | "trait" | "impl"
        );
        if !is_word || !is_one || !self.starts_statement() {
            return false;
        }
        let ends = |i: &usize| matches!(self.kind(*i), T::LeftBrace | T::Semicolon | T::End);
        let Some(open) = (1..MAX_INSIDE)
            .find(ends)
            .filter(|&i| self.kind(i) == T::LeftBrace)
        else {
            return false;
        };
        let Some(mut end) = self.after(open) else {
            return false;
        };
        end += (self.kind(end) == T::Semicolon) as usize;
        self.report(self.span(0, open), format!("GLSL has no `{word}`"), None);
        match word {
            "enum" => self.note("use `const int A = 0, B = 1;` for named numbers"),
            "class" => self.note("use a `struct` for data and separate functions"),
            "template" => self.note("write one overload of the function for each type"),
            _ => {}
        }
        for ahead in 1..end {
            if self.kind(ahead) == T::Identifier {
                self.lost.push(Name(self.token(ahead).value));
            }
        }
        self.at += end;
        true
    }

    /// `buffer Particles { ... };`, with or without `layout(std430, binding = 0)`.
    fn storage_buffer(&mut self) -> bool {
        use TokenKind as T;
        let has_layout = self.kind(0) == T::Layout && self.kind(1) == T::LeftParen;
        let word = match has_layout {
            true => self.after(1),
            false => Some(0),
        };
        let Some(at) = word.filter(|&at| {
            self.text(at) == "buffer"
                && (self.kind(at + 1), self.kind(at + 2)) == (T::Identifier, T::LeftBrace)
        }) else {
            return false;
        };
        if self.braces > 0 || !self.starts_statement() {
            return false;
        }
        let span = self.span(0, at + 1);
        self.report(
            self.token(at).span,
            "WebGL2 has no `buffer` blocks; use a `uniform` block",
            Self::write(span, "uniform"),
        );
        self.note("they were added in GLSL ES 3.10; shaders cannot write to a uniform block");
        self.put(T::Uniform, 0, span);
        self.at += at + 1;
        true
    }

    /// `cbuffer Params : register(b0) { ... };`
    fn uniform_buffer(&mut self) -> bool {
        use TokenKind as T;
        let is_word =
            matches!(self.word(0), "cbuffer" | "tbuffer") && self.kind(1) == T::Identifier;
        let open = || (2..12).find(|&i| self.kind(i) == T::LeftBrace);
        let Some(open) = is_word.then(open).flatten() else {
            return false;
        };
        let span = self.token(0).span;
        let mut edits = vec![Edit::replace(span, "uniform")];
        if open > 2 {
            let binding = Span::new(self.token(1).span.end, self.token(open - 1).span.end);
            edits.push(Edit::delete(binding));
        }
        let message = format!("GLSL has no `{}`; use a `uniform` block", self.text(0));
        self.report(span, message, Some(Fix::safe("use `uniform`", edits)));
        self.put(T::Uniform, 0, span);
        self.at += 1;
        self.keep();
        self.at += open - 2;
        true
    }

    /// `fn f(x: f32) -> f32 {`, `def f(x):`, `function f(x) {`, `auto f(float x) -> float {`
    fn function(&mut self) -> bool {
        use TokenKind as T;
        let is_word = FUNCTIONS.contains(&self.word(0)) || self.word(0) == "auto";
        let is_one = is_word
            && self.braces == 0
            && self.starts_statement()
            && self.kind(1) == T::Identifier
            && self.kind(2) == T::LeftParen;
        let Some(close) = is_one.then(|| self.after(2)).flatten() else {
            return false;
        };
        let is_arrow = self.kind(close) == T::Minus && self.kind(close + 1) == T::Greater;
        let returns = match is_arrow {
            true => self.type_at(close + 2),
            false if self.kind(close) == T::Colon => self.type_at(close + 1),
            false => self.type_at(close),
        };
        let params = self.parameters(3, close - 1);
        let body = returns.map_or(close, |(_, end)| end);
        if let (Some(params), T::LeftBrace) = (params, self.kind(body)) {
            self.rewrite_function(returns.map(|r| r.0), &params, body);
            return true;
        }
        let end = match self.kind(body) {
            T::LeftBrace => self.after(body).unwrap_or(body + 1),
            _ => self.end_of_indented(),
        };
        let head = self.span(0, body);
        self.report(
            head,
            format!("expected a return type, found `{}`", self.text(0)),
            None,
        );
        self.note(
            "a function and each of its parameters start with a type: `float f(vec2 p) { ... }`",
        );
        self.lost.push(Name(self.token(1).value));
        self.at += end;
        true
    }

    /// `float f(float x) -> float {`
    fn returned(&mut self) -> bool {
        use TokenKind as T;
        let is_arrow =
            self.kind(0) == T::Minus && self.kind(1) == T::Greater && self.touches_next(0);
        if !is_arrow || self.braces > 0 || self.before() != T::RightParen {
            return false;
        }
        let end = self.type_at(2).map(|(_, end)| end);
        let Some(end) = end.filter(|&end| self.kind(end) == T::LeftBrace) else {
            return false;
        };
        let span = self.span(0, end);
        let before = self.out.last().map_or(span, |t| t.span);
        let edit = Edit::delete(Span::new(before.end, span.end));
        let message = "the return type must come before the function name";
        self.report(
            span,
            message,
            Some(Fix::suggestion("remove it here", vec![edit])),
        );
        self.at += end;
        true
    }

    /// Rewrites a function header in GLSL syntax.
    fn rewrite_function(
        &mut self,
        returns: Option<TypeWord>,
        params: &[(TypeWord, Token)],
        body: usize,
    ) {
        use TokenKind as T;
        let (head, name) = (self.span(0, body), self.token(1));
        let list: Vec<String> = params
            .iter()
            .map(|(ty, name)| format!("{} {}", ty.name(), self.sources.text(name.span)))
            .collect();
        let word = returns.map_or("void", TypeWord::name);
        let text = format!("{word} {}({})", self.text(1), list.join(", "));
        let message = format!("expected a return type, found `{}`", self.text(0));
        self.report(head, message, Self::write(head, &text));
        match returns {
            Some(word) => self.put_type(word, head),
            None => self.put(T::Void, 0, head),
        }
        self.push(name);
        self.put(T::LeftParen, 0, name.span);
        for (i, &(ty, param)) in params.iter().enumerate() {
            if i > 0 {
                self.put(T::Comma, 0, param.span);
            }
            self.put_type(ty, param.span);
            self.push(param);
        }
        self.put(T::RightParen, 0, name.span);
        self.at += body;
    }

    /// Parameters with known types, in any notation.
    fn parameters(&self, first: usize, close: usize) -> Option<Vec<(TypeWord, Token)>> {
        use TokenKind as T;
        let mut found = Vec::new();
        let mut at = first;
        while at < close {
            let (name, word, end) = match (self.kind(at), self.kind(at + 1)) {
                (T::Identifier, T::Colon) => {
                    let (word, end) = self.type_at(at + 2)?;
                    (self.token(at), word, end)
                }
                _ => match self.type_at(at) {
                    Some((word, end)) => (self.token(end), word, end + 1),
                    None => {
                        let (word, end) = self.type_at(at + 1)?;
                        (self.token(at), word, end)
                    }
                },
            };
            if name.kind != T::Identifier || !(end == close || self.kind(end) == T::Comma) {
                return None;
            }
            found.push((word, name));
            at = end + 1;
        }
        Some(found)
    }

    /// Index after the lines that are indented more than the current one.
    fn end_of_indented(&self) -> usize {
        let column = |ahead: usize| {
            let start = self.token(ahead).span.start;
            self.sources
                .file_at(start)
                .map_or(0, |f| f.position(start).column)
        };
        let mut end = self.end_of_line();
        while self.kind(end) != TokenKind::End
            && !(self.starts_line(end) && column(end) <= column(0))
        {
            end += 1;
        }
        end
    }

    /// `let x: f32 = 1.0`
    fn annotated(&mut self) -> bool {
        use TokenKind as T;
        if !self.starts_declaration() {
            return false;
        }
        let meaning = foreign(self.word(0), self.version).map(|f| f.meaning);
        let is_let = meaning == Some(Meaning::Inferred);
        if !(is_let || self.kind(0) == T::Const) {
            return false;
        }
        let name = 1 + (self.word(1) == "mut") as usize;
        if self.kind(name) != T::Identifier || self.kind(name + 1) != T::Colon {
            return false;
        }
        let Some((word, end)) = self.type_at(name + 2) else {
            return false;
        };
        if !matches!(self.kind(end), T::Equal | T::Semicolon | T::Comma) {
            return false;
        }
        let from = !is_let as usize;
        let span = self.span(from, end);
        let text = format!("{} {}", word.name(), self.text(name));
        self.report(
            span,
            "the type must come before the variable name",
            Self::write(span, &text),
        );
        if !is_let {
            self.keep();
        }
        let (name, skipped) = (self.token(name - from), end - from);
        self.put_type(word, span);
        self.push(name);
        self.at += skipped;
        true
    }

    /// Whether a declaration can start here: at the start of a statement or loop header.
    fn starts_declaration(&self) -> bool {
        let after_head = || match self.out.as_slice() {
            [.., head, open] => (head.kind, open.kind) == (TokenKind::For, TokenKind::LeftParen),
            _ => false,
        };
        self.starts_statement() || after_head()
    }

    /// `const auto& x = ...`: reduced to the single word that the checker understands.
    fn reference(&mut self) -> bool {
        use TokenKind as T;
        let first = (self.kind(0) == T::Const) as usize;
        let is_one = self.word(first) == "auto"
            && self.starts_declaration()
            && (first == 1 || matches!(self.kind(1), T::And | T::AndAnd | T::Star));
        if !is_one {
            return false;
        }
        let has_sign = matches!(self.kind(first + 1), T::And | T::AndAnd | T::Star);
        let end = first + 1 + has_sign as usize;
        let word = self.token(first);
        self.put(T::Identifier, word.value, self.span(0, end));
        self.at += end;
        self.changed = true;
        true
    }

    /// `constexpr float`, `let mut x`: a modifier before a declaration.
    fn modifier(&mut self) -> bool {
        use TokenKind as T;
        if self.kind(0) != T::Identifier || !self.starts_declaration() {
            return false;
        }
        let names = (self.kind(1), self.kind(2), self.kind(3));
        let has_type = matches!(
            names.0,
            T::Type | T::Const | T::Uniform | T::Void | T::Struct | T::Lowp | T::Mediump | T::Highp
        ) && names.1 != T::LeftParen;
        let three = (names.0, names.1) == (T::Identifier, T::Identifier)
            && matches!(
                names.2,
                T::Equal | T::Semicolon | T::Comma | T::LeftBracket | T::LeftParen
            )
            && !self.starts_line(1);
        if !(has_type || three) || self.starts_line(1) {
            return false;
        }
        if three && self.word(1) == "mut" {
            // Reduced to the first word, which the checker understands.
            self.put(T::Identifier, self.token(0).value, self.span(0, 2));
            self.at += 2;
            self.changed = true;
            return true;
        }
        let (word, span) = (self.text(0), self.token(0).span);
        let message = format!("GLSL has no `{word}`");
        match MODIFIERS.iter().find(|(w, _)| *w == word) {
            Some(&(_, kind)) => {
                self.report(span, message, Self::write(span, "const"));
                self.put(kind, 0, span);
            }
            None => match storage_near(word) {
                Some((near, kind)) => {
                    let title = format!("did you mean `{near}`?");
                    let fix = Fix::suggestion(title, vec![Edit::replace(span, near)]);
                    self.report(span, message, Some(fix));
                    self.put(kind, 0, span);
                }
                None => {
                    let fix = self.remove(0, 1).map(|fix| Fix {
                        applicability: Applicability::Unsafe,
                        ..fix
                    });
                    self.report(span, message, fix);
                }
            },
        }
        self.at += 1;
        true
    }

    /// `const x = 1.0`: adds the type of a literal or constructor.
    fn constant(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::Const
            && self.kind(1) == T::Identifier
            && self.kind(2) == T::Equal
            && self.starts_declaration();
        if !is_one {
            return false;
        }
        let value = 3 + matches!(self.kind(3), T::Minus | T::Plus) as usize;
        let word = match self.kind(value) {
            T::Float => TypeWord::Float,
            T::Int => TypeWord::Int,
            T::Uint => TypeWord::Uint,
            T::True | T::False | T::Not => TypeWord::Bool,
            T::Type | T::Identifier => match self.type_at(value) {
                Some((word, _)) => word,
                None => return false,
            },
            _ => return false,
        };
        let name = self.token(1).span;
        let text = self.sources.text(name);
        let edit = Edit::insert(name.start, format!("{} ", word.name()));
        let fix = Fix::safe(format!("use `const {} {text}`", word.name()), vec![edit]);
        self.report(name, format!("constant `{text}` has no type"), Some(fix));
        self.keep();
        self.put_type(word, name);
        true
    }

    /// `: SV_Target`, `: TEXCOORD0`, `: register(t0)`
    fn semantic(&mut self) -> bool {
        use TokenKind as T;
        let is_one =
            self.kind(0) == T::Colon && self.kind(1) == T::Identifier && self.questions == 0;
        if !is_one {
            return false;
        }
        let end = match self.kind(2) {
            T::LeftParen => match self.after(2) {
                Some(end) => end,
                None => return false,
            },
            _ => 2,
        };
        let start = self.start.max(self.out.len().saturating_sub(MAX_INSIDE));
        let statement = self.out.get(start..).unwrap_or(&[]);
        let declares = match (self.before(), statement) {
            (T::RightParen, [_, ..]) => matches!(self.kind(end), T::LeftBrace | T::Semicolon),
            (T::Identifier, [.., before, _]) => {
                matches!(before.kind, T::Type | T::Identifier)
                    && matches!(
                        self.kind(end),
                        T::Semicolon | T::Comma | T::RightParen | T::Equal
                    )
            }
            (T::RightBracket, _) => self.kind(end) == T::Semicolon,
            _ => false,
        };
        let is_label = |t: &Token| matches!(t.kind, T::Case | T::Default);
        if !declares || statement.iter().any(is_label) {
            return false;
        }
        let before = self.out.last().map_or(self.token(0).span, |t| t.span);
        let span = self.span(0, end);
        let gap = Span::new(before.end, span.end);
        let fix = Fix::safe("remove the semantic", vec![Edit::delete(gap)]);
        self.report(span, "GLSL has no semantics", Some(fix));
        self.note("inputs and outputs are matched by name or by `layout(location = 0)`");
        self.at += end;
        true
    }
}

/// The storage qualifier that a word is probably a typo of.
fn storage_near(word: &str) -> Option<(&'static str, TokenKind)> {
    const WORDS: [(&str, TokenKind); 5] = [
        ("varying", TokenKind::Varying),
        ("attribute", TokenKind::Attribute),
        ("uniform", TokenKind::Uniform),
        ("const", TokenKind::Const),
        ("flat", TokenKind::Flat),
    ];
    let is_near = |(near, _): &&(&str, TokenKind)| strsim::damerau_levenshtein(word, near) == 1;
    WORDS.iter().find(is_near).copied()
}
