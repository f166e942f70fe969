//! Messages for [`NameError`]: reserved, redeclared and undeclared names, with suggestions.

use super::*;
use shaderlint_semantic::typing::SWIZZLES;
use shaderlint_syntax::{
    TypeWord, WordClass, classify, has_same_letters, keyword_near, type_in_another_case,
};

/// Longest distance to a closing bracket, in tokens.
const MAX_BRACKETED: TokenId = 200;

/// Length of the longest name that WebGL2 accepts (WebGL 2.0 section 4.3.1), in bytes.
const MAX_NAME: usize = 1_024;

/// Names that shaders give their output.
pub(super) const OUTPUT_NAMES: &str = "\
    fragColor FragColor outColor out_Color out_color outputColor fragmentColor o_color oColor \
    color_out pc_fragColor out_FragColor myOutputColor finalColor";

/// Whether a name is a typo of `gl_FragColor`.
fn is_near_output(name: &str) -> bool {
    const OUTPUT: &str = "gl_fragcolor";
    let is_like = name.len().abs_diff(OUTPUT.len()) <= 1 && name.starts_with("gl");
    is_like && strsim::damerau_levenshtein(&name.to_ascii_lowercase(), OUTPUT) <= 1
}

impl Explain for NameError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        match self {
            NameError::Reserved(name, owner) => {
                let message = format!("identifier `{}` is reserved", c.text(name));
                let why = match owner {
                    Owner::Language => "GLSL reserves names that start with `gl_` (section 3.9)",
                    Owner::Webgl => {
                        "WebGL reserves names that start with `webgl_` (WebGL 1.0 section 6.22)"
                    }
                    Owner::Browser => "WebGL reserves names with two underscores in a row",
                };
                c.error(error::RESERVED_IDENTIFIER, at, message).note(why)
            }
            NameError::Twice(name, before) => {
                let message = format!("`{}` is already declared in this scope", c.text(name));
                let d = c.error(error::REDEFINITION, at, message);
                c.with_declaration(d, c.declaration_token(name, before), "first declared here")
            }
            NameError::NotAVariable(name, binding) => {
                c.explain_not_a_variable(name, at.first, binding)
            }
            NameError::Undeclared(name) => c.explain_undeclared_variable(name, at.first),
            NameError::UnknownType(name) => c.explain_unknown_type(name, at.first),
            NameError::LegacyFunction(name, new) => {
                c.explain_legacy_function(c.text(name), new, at.first)
            }
            NameError::UndeclaredFunction(name) => c.explain_undeclared_function(name, at.first),
        }
    }
}

impl ExplainContext<'_> {
    /// A function, block or type used as a variable.
    pub(crate) fn explain_not_a_variable(
        &self,
        name: Name,
        token: TokenId,
        binding: Binding,
    ) -> Diagnostic {
        let text = self.text(name);
        let what = match binding {
            Binding::Function => "function",
            Binding::Block(_) => "block",
            _ => "type",
        };
        let d = self.error_at(
            error::NOT_A_VARIABLE,
            token,
            format!("`{text}` is a {what}, not a variable"),
        );
        let declared = self.declaration_token(name, binding);
        let d = self.with_declaration(d, declared, "declared here");
        match binding {
            Binding::Block(_) => self.advise_block(d.clone(), name, token).unwrap_or(d),
            _ => d,
        }
    }

    /// A variable that is not declared.
    pub(crate) fn explain_undeclared_variable(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let known = self.legacy_variable(name, token);
        match known.or_else(|| self.foreign_value(name, token)) {
            Some(d) => d,
            None if self.builtins.function(text).is_some() => self.function_as_value(text, token),
            None => {
                let message = format!("`{text}` is not declared");
                let d = self.error_at(error::UNDECLARED_NAME, token, message);
                match self.keyword_alone(text, token) {
                    Some(fix) => d.fix(fix),
                    None => self.advise_name(d, name, token, false),
                }
            }
        }
    }

    /// A name used as a type that is not a type.
    pub(crate) fn explain_unknown_type(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let message = match self.scopes().get(name) {
            Some(Binding::Variable(_)) => format!("`{text}` is a variable, not a type"),
            Some(Binding::Function) => format!("`{text}` is a function, not a type"),
            _ => format!("unknown type `{text}`"),
        };
        let d = self.error_at(error::UNKNOWN_TYPE, token, message);
        self.advise_type(d, name, token)
    }

    /// A GLSL ES 1.00 function in a GLSL ES 3.00 shader.
    pub(crate) fn explain_legacy_function(
        &self,
        text: &str,
        new: &str,
        token: TokenId,
    ) -> Diagnostic {
        let span = self.token_span(token);
        self.error_at(
            error::LEGACY_GLSL,
            token,
            format!("`{text}` was removed in GLSL ES 3.00"),
        )
        .note("in GLSL ES 3.00 the type of the sampler selects the lookup")
        .fix(self.use_instead(new, Edit::replace(span, new)))
    }

    /// Uses a built-in function of GLSL ES 3.00. What the shader calls so gets another name, because it hides
    /// the function.
    fn use_instead(&self, new: &str, edit: Edit) -> Option<Fix> {
        let own = self.names.get(new).filter(|name| self.has_own(*name));
        let Some(name) = own else {
            return Some(Fix::safe(format!("use `{new}`"), vec![edit]));
        };
        let is_function = self.tree.functions.iter().any(|f| f.ident.name == name);
        let free = self.names.unused(&own_name(new));
        let is_meant = |token| is_function || !self.is_before_paren(token);
        let mut edits = self.rename_where(name, &free, is_meant);
        edits.push(edit);
        let title = format!("use `{new}`, and rename the shader's own `{new}` to `{free}`");
        (edits.len() > 1).then(|| Fix::safe(title, edits))
    }

    /// Renames the variables that hide a function.
    pub(super) fn rename_variable(&self, name: Name) -> Option<Fix> {
        let free = self.names.unused(&own_name(self.text(name)));
        let edits = self.rename_where(name, &free, |token| !self.is_before_paren(token));
        let title = format!("rename the variable to `{free}`");
        (!edits.is_empty()).then(|| Fix::safe(title, edits))
    }

    /// Whether a name is called, or declared as a function.
    fn is_before_paren(&self, name: TokenId) -> bool {
        self.token(name + 1).kind == TokenKind::LeftParen
    }

    /// Whether the shader declares a variable, a parameter or a function of this name.
    fn has_own(&self, name: Name) -> bool {
        let tree = self.tree;
        let variables = tree.declarator_lists.iter().map(|d| d.ident);
        let params = tree.param_lists.iter().filter_map(|p| p.ident);
        let functions = tree.functions.iter().map(|f| f.ident);
        let mut all = variables.chain(params).chain(functions);
        all.any(|ident| ident.name == name)
    }

    /// A function that is not declared.
    pub(crate) fn explain_undeclared_function(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let newest = Builtins::of(Version::NEWEST, self.stage);
        if let Some(d) = self.extension_needed(text, token) {
            d
        } else if self.version != Version::NEWEST && newest.function(text).is_some() {
            let message = format!("`{text}` requires GLSL ES 3.00");
            self.error_at(error::NEEDS_WEBGL2, token, message)
                .help(self.help_for_version(text))
        } else if self.declared_later(name, token).is_some() {
            self.used_before_declaration(name, token)
        } else {
            let message = format!("function `{text}` is not declared");
            let d = self.error_at(error::UNDECLARED_NAME, token, message);
            self.advise_name(d, name, token, true)
        }
    }

    /// `sin[x]`, or `sin` alone.
    fn function_as_value(&self, text: &str, token: TokenId) -> Diagnostic {
        let message = format!("function `{text}` must be called with parentheses");
        let d = self.error_at(error::UNDECLARED_NAME, token, message);
        d.fix(self.other_brackets(token + 1, TokenKind::LeftBracket, ("(", ")")))
    }

    /// Replaces the bracket at `open` and its closing bracket.
    pub(crate) fn other_brackets(
        &self,
        open: TokenId,
        kind: TokenKind,
        (left, right): (&str, &str),
    ) -> Option<Fix> {
        use TokenKind as T;
        let mut depth = 0_u32;
        let close = (open..open.saturating_add(MAX_BRACKETED)).find(|&at| {
            match self.token(at).kind {
                T::LeftParen | T::LeftBracket => depth += 1,
                T::RightParen | T::RightBracket => depth = depth.saturating_sub(1),
                T::Semicolon | T::End => return true,
                _ => {}
            }
            depth == 0
        })?;
        let ends = matches!(self.token(close).kind, T::RightParen | T::RightBracket);
        let is_direct = self.token(open).is_direct() && self.token(close).is_direct();
        (ends && is_direct && self.token(open).kind == kind).then(|| {
            let edits = vec![
                Edit::replace(self.token_span(open), left),
                Edit::replace(self.token_span(close), right),
            ];
            Fix::suggestion(format!("use `{left}...{right}`"), edits)
        })
    }

    /// A statement of one word that is a typo of `break`, `continue`, `discard` or `return`.
    fn keyword_alone(&self, text: &str, token: TokenId) -> Option<Fix> {
        use TokenKind as T;
        let before = token.checked_sub(1).map(|t| self.token(t).kind);
        let starts = matches!(
            before?,
            T::Semicolon | T::LeftBrace | T::RightBrace | T::RightParen | T::Else | T::Colon
        );
        let is_alone = starts && self.token(token + 1).kind == T::Semicolon;
        // All letters of a keyword in another order are a typo if nothing else fits.
        let mixed = [
            ("break", T::Break),
            ("continue", T::Continue),
            ("discard", T::Discard),
        ];
        let mixed = mixed
            .into_iter()
            .find(|(word, _)| has_same_letters(word, text));
        let near = keyword_near(text).or(mixed);
        let (keyword, kind) = near.filter(|_| is_alone)?;
        matches!(kind, T::Break | T::Continue | T::Discard | T::Return).then(|| {
            let edit = Edit::replace(self.token_span(token), keyword);
            Fix::suggestion(format!("did you mean `{keyword}`?"), vec![edit])
        })
    }

    /// Variables that only another version of GLSL ES or of the host has.
    fn legacy_variable(&self, name: Name, token: TokenId) -> Option<Diagnostic> {
        let text = self.text(name);
        let is_fragment = self.stage == Stage::Fragment;
        if let Some(d) = self.extension_needed(text, token) {
            return Some(d);
        }
        if self.version != Version::NEWEST {
            let newest = Builtins::of(Version::NEWEST, self.stage);
            newest.variable(text)?;
            let message = format!("`{text}` requires GLSL ES 3.00");
            let d = self.error_at(error::NEEDS_WEBGL2, token, message);
            return Some(d.help("add `#version 300 es` as the first line"));
        }
        let host = self.dialect.host();
        if let Some((old, new, since)) = host.renamed.iter().find(|(old, ..)| *old == text) {
            let message = format!("`{old}` was renamed to `{new}` in {since}");
            let fix = Fix::safe(format!("use `{new}`"), self.rename_all(name, new));
            return Some(self.error_at(error::LEGACY_GLSL, token, message).fix(fix));
        }
        match text {
            "gl_FragColor" | "gl_FragData" if is_fragment => Some(self.legacy_output(name, token)),
            _ if is_fragment && is_near_output(text) => Some(self.legacy_output(name, token)),
            "gl_FragDepthEXT" => Some(
                self.error_at(
                    error::LEGACY_GLSL,
                    token,
                    format!("`{text}` was removed in GLSL ES 3.00"),
                )
                .fix(Fix::safe_replacement(
                    self.token_span(token),
                    "gl_FragDepth",
                )),
            ),
            "fragCoord" if is_fragment && !self.is_called_by_host() => {
                Some(self.fragcoord_in_main(token))
            }
            _ if is_fragment
                && OUTPUT_NAMES.split(' ').any(|name| name == text)
                && self.is_assigned(token) =>
            {
                Some(self.missing_output(text, token))
            }
            _ => None,
        }
    }

    /// `fragCoord` outside ShaderToy's `mainImage`, where it is a parameter.
    fn fragcoord_in_main(&self, token: TokenId) -> Diagnostic {
        let message = "`fragCoord` is not declared; it is a parameter of `mainImage`";
        let d = self.error_at(error::FRAGCOORD_IN_MAIN, token, message);
        let holds = |e: Extent| (e.first..=e.last).contains(&token);
        let mut functions = self.tree.functions.iter();
        let body = functions.find(|f| f.body.is_some() && holds(f.extent));
        let open = body
            .and_then(|f| f.body)
            .map(|b| self.token(self.tree.stmt(b).extent.first));
        match open.filter(|t| t.is_direct()) {
            Some(open) => d.fix(Fix::safe(
                "add `vec2 fragCoord = gl_FragCoord.xy;`",
                vec![Edit::insert(
                    open.span.end,
                    "\n    vec2 fragCoord = gl_FragCoord.xy;",
                )],
            )),
            None => d.help("use `gl_FragCoord.xy`"),
        }
    }

    /// Whether a token is followed by `=`, or by a component and `=`.
    fn is_assigned(&self, token: TokenId) -> bool {
        let kind = |i: u32| self.token(token + i).kind;
        kind(1) == TokenKind::Equal || (kind(1) == TokenKind::Dot && kind(3) == TokenKind::Equal)
    }

    fn missing_output(&self, text: &str, token: TokenId) -> Diagnostic {
        let line = format!("out vec4 {text};");
        let d = self.error_at(
            error::MISSING_OUTPUT,
            token,
            format!("output `{text}` is not declared"),
        );
        if self.is_called_by_host() {
            return d.help("assign to the first parameter of `mainImage` instead");
        }
        let d = d.note("a WebGL2 fragment shader must declare its outputs (section 4.3.6)");
        match self.first_declaration() {
            Some(at) => d.fix(Fix::safe(
                format!("add `{line}`"),
                vec![Edit::insert(at, format!("{line}\n"))],
            )),
            None => d.help(format!("add `{line}` at the top")),
        }
    }

    /// Edits that replace every use of a name with `to`, also in the macros that the text defines and calls;
    /// empty if one cannot be edited, such as a name that `##` makes.
    pub(crate) fn rename_all(&self, name: Name, to: &str) -> Vec<Edit> {
        self.rename_where(name, to, |_| true)
    }

    /// The same for the uses that `is_meant` selects.
    fn rename_where(&self, name: Name, to: &str, is_meant: impl Fn(TokenId) -> bool) -> Vec<Edit> {
        let mut edits = Vec::new();
        let mut after_dot = false;
        if !self.affords(self.tokens.tokens.len()) {
            return edits;
        }
        for (id, token) in (0..).zip(&self.tokens.tokens) {
            let is_use = token.kind == TokenKind::Identifier && token.value == name.0 && !after_dot;
            after_dot = token.kind == TokenKind::Dot;
            if !is_use || !is_meant(id) {
                continue;
            }
            if token.is_direct() {
                edits.push(Edit::replace(token.span, to));
                continue;
            }
            let text = self.text(name);
            let span = Span::new(token.spelled, token.spelled + text.len() as u32);
            if !self.sources.is_user(span.start) || self.sources.text(span) != text {
                return Vec::new();
            }
            edits.push(Edit::replace(span, to));
        }
        // A macro may be called more than once.
        edits.sort_by_key(|e| e.span);
        edits.dedup();
        edits
    }

    /// Position of the first declaration in the user's text, `precision` statements aside.
    pub(super) fn first_declaration(&self) -> Option<u32> {
        let tree = self.tree;
        let first = tree.items.iter().find_map(|item| {
            let extent = match *item {
                Item::Function(id) => tree.function(id)?.extent,
                Item::Decl(id) => {
                    let decl = tree.decl(id)?;
                    if matches!(decl.kind, DeclKind::Precision { .. }) {
                        return None;
                    }
                    decl.extent
                }
            };
            (!self.is_prelude(extent.first)).then_some(extent.first)
        })?;
        self.token(first)
            .is_direct()
            .then(|| self.token_span(first).start)
    }

    /// Points at a declaration of the name elsewhere, or suggests a similar name.
    fn advise_name(&self, d: Diagnostic, name: Name, token: TokenId, is_call: bool) -> Diagnostic {
        let text = self.text(name);
        if let Some(later) = self.declared_later(name, token) {
            let line = self
                .sources
                .file_at(later.start)
                .map_or(0, |f| f.position(later.start).line);
            return d.label(later, "declared here").note(format!(
                "it is declared on line {line}; GLSL requires the declaration before the first use"
            ));
        }
        if let Some(variable) = self.left_scope(name, token).filter(|_| !is_call) {
            let declared = self.token_span(variable);
            return d
                .label(declared, "declared here")
                .note("it is out of scope: the block that declares it has ended");
        }
        if let Some(later) = self.declared_below(name, token).filter(|_| !is_call) {
            return d
                .label(self.token_span(later), "declared here")
                .note("GLSL requires the declaration before the first use");
        }
        if text.len() > MAX_NAME {
            return d;
        }
        let of_block = || self.advise_block(d.clone(), name, token);
        if let Some(d) = (!is_call).then(of_block).flatten() {
            return d;
        }
        let near = self.numbered_element(text).filter(|_| !is_call);
        let near = near.or_else(|| self.nearest_name(text, is_call));
        let near = near.or_else(|| self.with_prefix(text).filter(|_| !is_call));
        let near = near.or_else(|| self.lost_dot(text).filter(|_| !is_call));
        match near.or_else(|| self.without_double(text, is_call)) {
            Some(near) => {
                let span = self.token_span(token);
                let edit = Edit::replace(span, near.clone());
                d.fix(Fix::suggestion(
                    format!("did you mean `{near}`?"),
                    vec![edit],
                ))
            }
            None => d,
        }
    }

    /// `iTime` for `time` or `uTime`, `u_color` for `color`: the only variable in scope with this name and the
    /// short prefix of a host or of a storage.
    fn with_prefix(&self, text: &str) -> Option<String> {
        if !self.affords(self.names.len()) {
            return None;
        }
        let stem = without_prefix(text).unwrap_or(text);
        let is_it = |name: &str| {
            without_prefix(name).is_some_and(|rest| rest.eq_ignore_ascii_case(stem)) && name != text
        };
        let variables = self.scopes().visible();
        let variables = variables.filter(|(_, b)| matches!(b, Binding::Variable(_)));
        let mut found = variables
            .map(|(name, _)| self.text(name))
            .filter(|name| is_it(name));
        let first = found.next()?;
        found.next().is_none().then(|| first.to_string())
    }

    /// `p.y` for `py`: a vector in scope and one of its swizzles.
    fn lost_dot(&self, text: &str) -> Option<String> {
        let splits = (1..text.len()).filter_map(|at| text.split_at_checked(at));
        let mut found = splits.filter(|(object, letters)| {
            let name = self.names.get(object);
            let ty = match name.and_then(|name| self.scopes().get(name)) {
                Some(Binding::Variable(id)) => self.variables.get(id.0 as usize).map(|v| v.ty),
                _ => None,
            };
            let size = ty
                .filter(|ty| ty.is_vector())
                .map_or(0, |ty| ty.components() as usize);
            letters.len() <= 4
                && SWIZZLES.iter().any(|set| {
                    let has = |c: char| set.find(c).is_some_and(|at| at < size);
                    letters.chars().all(has)
                })
        });
        let (object, letters) = found.next()?;
        Some(format!("{object}.{letters}"))
    }

    /// `h` for `hh`: a name in scope with one letter less, where a letter is doubled.
    fn without_double(&self, text: &str, is_call: bool) -> Option<String> {
        let letters = text.as_bytes().windows(2).zip(1..);
        let mut doubled = letters.filter(|(pair, _)| pair.first() == pair.last());
        doubled.find_map(|(_, at)| {
            let name = format!("{}{}", text.get(..at)?, text.get(at + 1..)?);
            let binding = self.scopes().get(self.names.get(&name)?)?;
            let is_it = match binding {
                Binding::Variable(_) => !is_call,
                Binding::Function => is_call,
                _ => false,
            };
            is_it.then_some(name)
        })
    }

    /// The declaration of a variable of this name in the current function, in a block that has
    /// ended.
    fn left_scope(&self, name: Name, token: TokenId) -> Option<TokenId> {
        let mut found = self.variables.iter().rev();
        let is_it = |v: &&Variable| v.name == name && v.function == self.current;
        let declared = found
            .find(is_it)
            .filter(|_| self.current.is_some())?
            .token?;
        (declared < token).then_some(declared)
    }

    /// The declaration of a name in the current function after a token.
    fn declared_below(&self, name: Name, token: TokenId) -> Option<TokenId> {
        let function = self.functions.get(self.current?.0 as usize)?;
        let extent = self.tree.function(function.definition?)?.extent;
        let mut all = self.tree.declarator_lists.iter().map(|d| d.ident);
        let is_it = |i: &Ident| i.name == name && i.token > token && i.token <= extent.last;
        all.find(is_it).map(|i| i.token)
    }

    /// `iChannelResolution[0]` for `iChannelResolution0`: an array in scope and the number of an element.
    fn numbered_element(&self, text: &str) -> Option<String> {
        let array = text.trim_end_matches(|c: char| c.is_ascii_digit());
        let index = text.get(array.len()..)?.parse::<u32>().ok()?;
        let Binding::Variable(id) = self.scopes().get(self.names.get(array)?)? else {
            return None;
        };
        let size = self.variables.get(id.0 as usize)?.ty.array;
        (index < size).then(|| format!("{array}[{index}]"))
    }

    /// The name in scope that is most similar to `text`; one that differs only in case comes first.
    pub(super) fn nearest_name(&self, text: &str, is_call: bool) -> Option<String> {
        let limit = match text.len() {
            0..=2 => 0,
            3..=5 => 1,
            6..=9 => 2,
            _ => 3,
        };
        if !self.affords(self.names.len()) {
            return None;
        }
        let fits = |binding| match binding {
            Binding::Function => is_call,
            Binding::Variable(_) => !is_call,
            Binding::Struct(_) => is_call,
            Binding::Block(_) | Binding::Error => false,
        };
        let scope = self
            .scopes()
            .visible()
            .filter(|(n, b)| fits(*b) && (*b != Binding::Function || self.is_callable(*n)))
            .map(|(n, _)| self.text(n));
        let builtins = self
            .builtins
            .functions()
            .filter(|_| is_call)
            .map(|id| -> &str { id.name() });
        let variables = self.builtins.variable_names().filter(|_| !is_call);
        let variables = variables.map(|name| -> &str { name });
        let types = TypeWord::ALL.into_iter().filter(|_| is_call);
        scope
            .chain(builtins)
            .chain(variables)
            .chain(types.map(|t| -> &str { t.name() }))
            .filter(|n| n.len().abs_diff(text.len()) <= limit && !n.starts_with("st_"))
            .take_while(|n| self.affords(n.len() * text.len()))
            .filter_map(|n| match n.eq_ignore_ascii_case(text) {
                true => Some((0, n)),
                false if limit == 0 => None,
                false => Some((strsim::damerau_levenshtein(n, text), n)),
            })
            .filter(|(distance, n)| *distance <= limit && *n != text)
            .min()
            .map(|(_, n)| n.to_string())
    }

    /// Whether a call of a function of the shader would be right here: it has a body, and is not the one
    /// that the call is in, because GLSL has no recursion.
    fn is_callable(&self, name: Name) -> bool {
        let current = self.current.and_then(|f| self.functions.get(f.0 as usize));
        let mut defined = self.tree.functions.iter().filter(|f| f.body.is_some());
        current.is_none_or(|f| f.name != name) && defined.any(|f| f.ident.name == name)
    }

    /// Suggests a type with a similar name.
    fn advise_type(&self, d: Diagnostic, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        if let Some(word) = type_in_another_case(text, self.version) {
            return self.rename_fix(d, name, word.name());
        }
        let lower = text.to_ascii_lowercase();
        let structs = self.structs.iter().filter_map(|s| s.name);
        let near = TypeWord::ALL
            .into_iter()
            .map(|t| -> &str { t.name() })
            .filter(|t| matches!(classify(t, self.version), WordClass::Type(_)))
            .chain(["void"])
            .chain(structs.map(|n| self.text(n)))
            .filter(|t| t.len().abs_diff(lower.len()) <= 1)
            .take_while(|t| self.affords(t.len() * lower.len()))
            .map(|t| (strsim::damerau_levenshtein(t, &lower), t))
            .filter(|(distance, _)| *distance <= 1)
            .min();
        match near {
            Some((_, near)) => {
                let edit = Edit::replace(self.token_span(token), near);
                let title = format!("did you mean `{near}`?");
                d.fix(Fix::suggestion(title, vec![edit]))
            }
            None => d,
        }
    }

    fn used_before_declaration(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let d = self.error_at(
            error::USE_BEFORE_DECLARATION,
            token,
            format!("function `{text}` is used before its declaration"),
        );
        let d = self.advise_name(d, name, token, true);
        let prototype =
            self.tree.functions.iter().find(|f| {
                f.ident.name == name && f.ident.token > token && self.is_direct(f.header)
            });
        let user = self.current.and_then(|f| self.functions.get(f.0 as usize));
        let place = user
            .and_then(|f| self.tree.function(f.definition?))
            .map(|f| f.extent.first);
        match (prototype, place) {
            (Some(prototype), Some(place)) if self.token(place).is_direct() => {
                let text = self.sources.text(self.span(prototype.header));
                let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
                let at = self.token_span(place).start;
                d.fix(Fix::safe(
                    format!("add the prototype `{line};`"),
                    vec![Edit::insert(at, format!("{line};\n"))],
                ))
            }
            _ => d,
        }
    }
}

/// A name without a prefix of one or two letters: `Time` of `iTime`, `color` of `u_color`.
fn without_prefix(name: &str) -> Option<&str> {
    let is_prefix = |prefix: &str, rest: &str| {
        let starts = prefix.ends_with('_') || rest.starts_with(|c: char| c.is_ascii_uppercase());
        starts && prefix.starts_with(|c: char| c.is_ascii_lowercase()) && !rest.is_empty()
    };
    let splits = [2, 1]
        .into_iter()
        .filter_map(|at| name.split_at_checked(at));
    let mut found = splits.filter(|(prefix, rest)| is_prefix(prefix, rest));
    found.next().map(|(_, rest)| rest)
}
