//! Shader fragments, which a host completes before a browser sees them: keeps the errors that occur
//! in any completion.
//!
//! Anything that a fragment does not declare may be anything: a value of any type, a type, or a
//! macro, so the syntax around it is not checked. Groups of `#if` that depend on a name of the host
//! may be included or not.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_diagnostic::{
    Certainty, Diagnostic, Facet, Lack, MacroUse, Severity, Subject, error,
};
use shaderlint_semantic::{Completeness, Function, Program};
use shaderlint_syntax::{
    DIRECTIVES, Expansion, Name, RawKind, Token, TokenKind, TokenSet, WordClass, classify, set,
    written_tokens,
};
use shaderlint_text::{Role, Span, is_respelled};
use std::collections::BTreeSet;

/// Maximum number of calls of empty macros that are considered.
const MAX_EMPTY_CALLS: usize = 1_000;
/// Maximum distance to a matching bracket, in tokens.
const MAX_LOOK: usize = 400;

/// What cannot be resolved in a fragment.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Open {
    /// Names that are not declared in the fragment and must come from its host.
    pub names: BTreeSet<String>,
    /// Whether any finding depends on the completion.
    pub is_any: bool,
    /// Whether code may be missing anywhere, so that nothing about the fragment is known.
    pub is_torn: bool,
    /// Where the code that a browser compiles depends on the host: errors that a host may resolve,
    /// conditional groups, and names that another group declares.
    pub unclear: Vec<Span>,
    /// Findings about those names in source order, one per name at its first use. Their severity
    /// depends on what is known about the host.
    pub unknown: Vec<Diagnostic>,
}

/// Keeps the errors that occur with any host of a fragment and returns what is unresolved.
pub(super) fn keep_certain(
    program: &Program,
    completeness: Completeness,
    diagnostics: &mut Vec<Diagnostic>,
) -> Open {
    let mut names = BTreeSet::new();
    let mut unknown = Vec::new();
    let count = diagnostics.len();
    let mut part = ChunkReader::of(program, completeness);
    let is_foreign =
        |d: &&Diagnostic| d.certainty() == Certainty::Syntax && part.is_foreign(d.span);
    part.foreign = diagnostics
        .iter()
        .filter(is_foreign)
        .map(|d| d.span)
        .collect();
    let words = part.foreign.iter().map(|span| program.sources.text(*span));
    let is_word = |text: &&str| text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    names.extend(words.filter(is_word).map(str::to_string));
    let is_torn = completeness == Completeness::Excerpt
        || diagnostics
            .iter()
            .any(|d| d.certainty() == Certainty::Syntax && part.is_excused(d));
    let mut unclear = Vec::new();
    let mut is_displaced = false;
    // An overload elsewhere may have another type.
    let is_overloaded = |d: &&Diagnostic| d.is(error::ARGUMENT_MISMATCH) && part.is_of_own_call(d);
    let of_calls = diagnostics.iter().filter(is_overloaded);
    let of_calls = of_calls.map(|d| (part.statement(d.span).start, part.is_likely(d)));
    let of_calls: FxHashMap<usize, bool> = of_calls.collect();
    diagnostics.retain_mut(|d| {
        if d.lacks() == Some(Lack::Name) {
            names.insert(program.sources.text(d.span).to_string());
            if part.is_user(d.span) {
                unknown.push(d.clone());
            }
        }
        if !is_torn && part.is_likely(d) {
            d.severity = Severity::Warning;
            d.notes.push(OTHER_OVERLOAD.to_string());
            return true;
        }
        // One finding about the call is enough.
        let of_call = of_calls.get(&part.statement(d.span).start).copied();
        let is_certain = of_call != Some(true) && part.is_certain(d, is_torn);
        if of_call.is_some() && is_certain {
            d.severity = Severity::Warning;
            d.notes.push(OTHER_OVERLOAD.to_string());
        }
        if !is_certain && !is_absent(d) {
            is_displaced |= d.subject.is_brace() || d.has(Facet::Moves);
            unclear.push(d.span);
        }
        // The groups themselves are read in any case.
        let is_chosen = part.is_undecided(d.span) && !d.is(error::UNBALANCED_CONDITIONAL);
        if is_certain && d.severity == Severity::Error && is_chosen {
            d.severity = Severity::Warning;
            d.notes
                .push("no error if the host defines macros that exclude it".to_string());
        }
        is_certain
    });
    let dropped = count - diagnostics.len();
    let tokens = &part.program.tokens;
    let is_undecided = tokens.undecided.iter().any(|g| part.is_user(*g));
    unclear.extend(&tokens.forks);
    unclear.extend(part.uses_of_groups());
    unclear.retain(|span| program.sources.is_user(span.start));
    unknown.sort_by_key(|d| d.span.start);
    Open {
        names,
        is_any: dropped > 0 || is_undecided,
        is_torn: is_torn || is_displaced,
        unclear,
        unknown,
    }
}

/// The note of warnings about calls of a function that has no such overload in a fragment.
pub const OTHER_OVERLOAD: &str = "the host may define another overload";

/// Whether an error is about what a host adds around a fragment, which means the same without it.
fn is_absent(d: &Diagnostic) -> bool {
    let kinds = [
        error::MISSING_MAIN,
        error::MISSING_PRECISION,
        error::UNWRAPPED_MAINIMAGE,
    ];
    kinds.iter().any(|kind| d.is(*kind))
}

/// A shader fragment under analysis.
struct ChunkReader<'p> {
    program: &'p Program,
    completeness: Completeness,
    /// Spans and indices of the user's tokens, in source order.
    places: Vec<(Span, u32)>,
    /// Names declared by the fragment or the language.
    known: FxHashSet<Name>,
    /// Functions declared by the fragment or its host, and where.
    own_functions: Vec<(Name, Span)>,
    /// Names that skipped groups declare.
    groups: GroupNames,
    /// Calls of macros with an empty body.
    empty_calls: Vec<Span>,
    /// Syntax errors about words that only a host may know, which corrections removed.
    foreign: Vec<Span>,
}

impl<'p> ChunkReader<'p> {
    fn of(program: &'p Program, completeness: Completeness) -> ChunkReader<'p> {
        let tokens = program.tokens.tokens.iter().zip(0..);
        let mut places: Vec<(Span, u32)> = tokens.map(|(t, i)| (t.span, i)).collect();
        places.sort_by_key(|(span, _)| span.start);
        let place = |f: &Function| {
            let ident = program.tree.function(f.declaration)?.ident;
            Some((f.name, program.token(ident.token)?.span))
        };
        ChunkReader {
            program,
            completeness,
            places,
            known: known_names(program),
            own_functions: program.functions.iter().filter_map(place).collect(),
            groups: GroupNames::of(program),
            empty_calls: empty_calls(program),
            foreign: Vec::new(),
        }
    }

    fn is_certain(&self, d: &Diagnostic, is_torn: bool) -> bool {
        let file = self.program.sources.file_at(d.span.start);
        if !file.is_some_and(|f| f.role == Role::User && f.span().contains(d.span)) {
            return false;
        }
        match d.certainty() {
            _ if d.is(error::MISSING_MAIN) => !is_torn && self.is_misspelled_main(d.span),
            Certainty::Never => false,
            // Placeholders of template programs use ASCII characters.
            Certainty::Syntax if d.is(error::INVALID_CHARACTER) => {
                !self.program.sources.text(d.span).is_ascii()
            }
            Certainty::Syntax => !self.is_torn_apart(d, is_torn) && !self.is_excused(d),
            Certainty::Meaning => self.depends_on_nothing(d) && self.means_that(d, is_torn),
        }
    }

    /// Whether a function is called `main` but for a typo, and nothing else names it.
    fn is_misspelled_main(&self, span: Span) -> bool {
        let word = self.program.sources.text(span);
        let names = self.program.tokens.tokens.iter();
        let same = names.filter(|t| self.program.sources.text(t.span) == word);
        is_respelled(word, "main") && same.count() == 1
    }

    /// Whether an error is likely although a host could resolve it: a call does not match the only
    /// overload of a function that the fragment defines.
    fn is_likely(&self, d: &Diagnostic) -> bool {
        let declared = |span: Span| self.own_functions.iter().find(|(_, own)| *own == span);
        let Some((name, place)) = d.labels.iter().find_map(|l| declared(l.span)) else {
            return false;
        };
        let forms = self.own_functions.iter().filter(|(own, _)| own == name);
        // An unknown macro may call its argument: `PLOT(f, 0.1)`.
        let is_unknown =
            |t: Token| t.kind == TokenKind::Identifier && !self.known.contains(&Name(t.value));
        let mut statement = self.statement(d.span).filter_map(|i| self.token(i));
        if d.is(error::NOT_A_VARIABLE) && statement.any(is_unknown) {
            return false;
        }
        d.certainty() == Certainty::Meaning
            && forms.count() == 1
            && self.is_user(d.span)
            && self.is_user(*place)
            && !self.is_undecided(*place)
            && self.depends_on_nothing(d)
    }

    /// Whether a syntax error may be caused by omitted code, or by a macro elsewhere that contains
    /// a brace.
    fn is_torn_apart(&self, d: &Diagnostic, is_torn: bool) -> bool {
        let is_brace = is_unclosed_brace(d);
        let is_outside = d.subject == Subject::OuterStatement;
        let is_piece = matches!(
            self.completeness,
            Completeness::Piece | Completeness::Excerpt
        );
        let is_cut = is_piece && (self.is_at_end(d.span) || is_brace && !self.is_inside(d));
        is_outside
            || is_cut
            || self.is_call(d)
            || is_torn && (is_brace || d.is(error::LOCAL_FUNCTION))
    }

    /// Whether an apparent function header without a type is a call: a statement that a host
    /// inserts into a function.
    fn is_call(&self, d: &Diagnostic) -> bool {
        let kind = |i: usize| self.token(i).map_or(TokenKind::End, |t| t.kind);
        let at = self.at(d.span.start);
        let close = (at..at + MAX_LOOK).find(|i| kind(*i) == TokenKind::RightParen);
        let after = (close.unwrap_or(at)..at + MAX_LOOK).find(|i| {
            let kind = kind(*i);
            matches!(
                kind,
                TokenKind::Semicolon | TokenKind::LeftBrace | TokenKind::End
            )
        });
        d.subject == Subject::UntypedFunction
            && after.is_some_and(|i| kind(i) != TokenKind::LeftBrace)
    }

    /// Whether a brace is wrong whatever comes before and after the fragment: a function follows an
    /// unclosed one, or ends before an unopened one.
    fn is_inside(&self, d: &Diagnostic) -> bool {
        let functions = self
            .program
            .tree
            .functions
            .iter()
            .filter(|f| f.body.is_some());
        let mut places = functions.map(|f| self.program.span(f.extent));
        let own = |span: Span| self.is_user(span);
        match d.subject == Subject::MissingClose {
            true => places.any(|f| own(f) && f.start > d.span.start),
            false => places.any(|f| own(f) && f.end < d.span.start),
        }
    }

    /// Whether a type error involves no name or macro that the host determines.
    fn depends_on_nothing(&self, d: &Diagnostic) -> bool {
        let is_unsure = |i: usize| {
            let token = self.token(i).filter(|t| t.kind == TokenKind::Identifier);
            let before = i.checked_sub(1).and_then(|b| self.token(b));
            // Names declared right here are known.
            let is_declared = before.is_some_and(|b| b.kind == TokenKind::Type);
            !is_declared && token.is_some_and(|t| self.is_ambiguous(t))
        };
        !self.statement(d.span).any(is_unsure) && !d.macros.iter().any(|m| self.is_open_macro(m))
    }

    /// Whether a type error occurs with every host.
    fn means_that(&self, d: &Diagnostic, is_torn: bool) -> bool {
        // The host may define other overloads.
        if self.is_of_own_call(d) {
            return false;
        }
        let Some(kind) = d.kind else { return true };
        match kind {
            // Members may differ between releases of a host.
            error::NO_SUCH_FIELD => d.labels.iter().any(|l| self.is_user(l.span)),
            error::MISSING_RETURN => !is_torn && !self.holds_group(d.span),
            // A host may add a prototype or another body.
            error::REDEFINITION | error::FUNCTION_MISMATCH => {
                let is_own = d.labels.iter().any(|l| self.is_user(l.span));
                is_own && !is_torn && !d.labels.iter().any(|l| self.is_undecided(l.span))
            }
            error::UNBALANCED_CONDITIONAL => self.completeness == Completeness::Chunk && !is_torn,
            error::MACRO_REDEFINITION => {
                let is_sure = |span| self.is_user(span) && !self.is_undecided(span);
                self.completeness != Completeness::Excerpt
                    && is_sure(d.span)
                    && d.labels.iter().all(|l| is_sure(l.span))
            }
            // The name after the dot may be a macro.
            error::INVALID_SWIZZLE => {
                let word = self.program.sources.text(d.span);
                word.chars().all(|c| "xyzwrgbastpq".contains(c))
            }
            error::BAD_DIRECTIVE => self.is_bad_everywhere(d.span),
            // All its members may be in groups.
            error::INVALID_STRUCT => self.program.tokens.undecided.is_empty(),
            // Some hosts rename `main`.
            error::RETURN_TYPE => !is_torn && !self.is_in_main(d.span),
            error::INVALID_PARAMETER => !is_torn,
            // `UNI sampler2D map;`: the unknown word may be `uniform`.
            error::SAMPLER_RESTRICTION => {
                let start = self.statement(d.span).start;
                !self.foreign.iter().any(|span| self.at(span.start) == start)
            }
            _ => true,
        }
    }

    fn is_in_main(&self, span: Span) -> bool {
        let mut functions = self.program.tree.functions.iter();
        functions.any(|f| {
            self.program.names.text(f.ident.name) == "main"
                && self.program.span(f.extent).contains(span)
        })
    }

    /// Whether a malformed directive is one of GLSL that a host would not rewrite.
    fn is_bad_everywhere(&self, span: Span) -> bool {
        let Some(file) = self.program.sources.file_at(span.start) else {
            return false;
        };
        let before = file.text.get(..(span.start - file.base) as usize);
        let start = before.and_then(|b| b.rfind('\n')).map_or(0, |at| at + 1);
        let line = file.text.get(start..).unwrap_or("").trim_start();
        let word = line.strip_prefix('#').unwrap_or(line).trim_start();
        let end = word.find(|c: char| !c.is_ascii_alphabetic());
        let word = word.get(..end.unwrap_or(word.len())).unwrap_or("");
        let rest = line.split('\n').next().unwrap_or("");
        // Hosts with their own preprocessor accept more conditions.
        DIRECTIVES.contains(&word)
            && !word.starts_with("if")
            && !matches!(word, "version" | "elif")
            && !rest.contains(['{', '$', '@'])
    }

    fn token(&self, index: usize) -> Option<Token> {
        let (_, id) = self.places.get(index)?;
        self.program.token(*id).copied()
    }

    fn is_user(&self, span: Span) -> bool {
        self.program.sources.is_user(span.start)
    }

    /// Whether nothing of the user's text follows a position, except closing braces of its host.
    fn is_at_end(&self, span: Span) -> bool {
        let at = self.at(span.start);
        let own = |i: usize| {
            let token = self.token(i)?;
            (token.kind != TokenKind::End && self.is_user(token.span)).then_some(token)
        };
        own(at).is_none() || own(at + 1).is_none()
    }

    /// Index of the first token at or after an address.
    fn at(&self, address: u32) -> usize {
        self.places
            .partition_point(|(span, _)| span.start < address && span.end <= address)
    }

    /// Token range of the statement around a position.
    fn statement(&self, span: Span) -> std::ops::Range<usize> {
        let at = self.at(span.start);
        let ends = |i: &usize| {
            set::ENDS_STATEMENT.contains(self.token(*i).map_or(TokenKind::End, |t| t.kind))
        };
        let from = (at.saturating_sub(MAX_LOOK)..at).rev().find(ends);
        let to = (at..at + MAX_LOOK).find(ends).unwrap_or(at + MAX_LOOK);
        from.map_or(at.saturating_sub(MAX_LOOK), |f| f + 1)..to
    }

    /// Whether a token is an undeclared identifier that may be a macro of the host.
    fn is_unknown(&self, index: usize) -> bool {
        let before = index.checked_sub(1).and_then(|i| self.token(i));
        let is_member = before.is_some_and(|t| t.kind == TokenKind::Dot);
        self.token(index).is_some_and(|t| {
            t.kind == TokenKind::Identifier && !is_member && !self.known.contains(&Name(t.value))
        })
    }

    /// Whether an identifier that may be a macro can explain a syntax error: it is at or next to
    /// the position, or the position is an argument that only a macro can accept.
    fn is_excused(&self, d: &Diagnostic) -> bool {
        use TokenKind as T;
        let at = self.at(d.span.start);
        let end = self.at(d.span.end).max(at) + 1;
        if self.is_foreign(d.span) || self.is_empty_call(at) {
            return true;
        }
        let is_delimiter = d.is(error::UNCLOSED_DELIMITER) && !d.subject.is_brace();
        if is_delimiter && self.is_unbalanced(at) {
            return false;
        }
        let kind = |i: usize| self.token(i).map_or(T::End, |t| t.kind);
        let is_operand = |i: usize| matches!(kind(i), T::Identifier | T::RightParen);
        let before = at.saturating_sub(1);
        let callee = self.callee(before);
        if d.is(error::MISSING_SEMICOLON) {
            let word = callee.unwrap_or(before);
            let starts = word.checked_sub(1).map_or(T::End, kind);
            let is_alone = matches!(starts, T::Semicolon | T::LeftBrace | T::RightBrace | T::End);
            let may_end = is_alone || self.completeness == Completeness::Excerpt;
            return self.is_unknown(at) || self.is_unknown(word) && may_end;
        }
        let is_near = (at.saturating_sub(2)..end.min(at + MAX_LOOK)).any(|i| self.is_unknown(i));
        let touches = is_operand(before) || is_operand(at);
        is_near && touches || callee.is_some_and(|c| self.is_unknown(c)) || self.is_of_macro(at)
    }

    /// The word before the parentheses that end at a token.
    fn callee(&self, close: usize) -> Option<usize> {
        let kind = |i: usize| self.token(i).map_or(TokenKind::End, |t| t.kind);
        if kind(close) != TokenKind::RightParen {
            return None;
        }
        let mut depth = 0_u32;
        for i in (close.saturating_sub(MAX_LOOK)..=close).rev() {
            match kind(i) {
                TokenKind::RightParen => depth += 1,
                TokenKind::LeftParen => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                return i.checked_sub(1);
            }
        }
        None
    }

    /// Whether a position is in the arguments of an unknown name, next to a keyword that only a
    /// macro can accept.
    fn is_of_macro(&self, at: usize) -> bool {
        use TokenKind as T;
        let kind = |i: usize| self.token(i).map_or(T::End, |t| t.kind);
        const WORDS: TokenSet = set::QUALIFIES_PARAMETER.and(&[T::Type, T::Uniform]);
        let is_word = |i: usize| WORDS.contains(kind(i));
        if !(at.saturating_sub(2)..=at + 1).any(is_word) {
            return false;
        }
        let mut depth = 0_u32;
        for i in (at.saturating_sub(MAX_LOOK)..at).rev() {
            match kind(i) {
                T::RightParen => depth += 1,
                T::LeftParen if depth > 0 => depth -= 1,
                T::LeftParen if i.checked_sub(1).is_some_and(|c| self.is_unknown(c)) => {
                    return true;
                }
                T::LeftParen => {}
                T::Semicolon | T::LeftBrace | T::RightBrace | T::End => return false,
                _ => {}
            }
        }
        false
    }

    /// Whether the statement around a token opens and closes different numbers of parentheses or
    /// brackets. Loop headers consist of several.
    fn is_unbalanced(&self, at: usize) -> bool {
        use TokenKind as T;
        let mut open = [0_i32; 2];
        let statement = self.statement(self.places.get(at).map_or(Span::default(), |p| p.0));
        for token in statement.filter_map(|i| self.token(i)) {
            match token.kind {
                T::For => return false,
                _ if token.span.is_empty() => {}
                T::LeftParen => open[0] += 1,
                T::RightParen => open[0] -= 1,
                T::LeftBracket => open[1] += 1,
                T::RightBracket => open[1] -= 1,
                _ => {}
            }
        }
        open != [0, 0]
    }

    /// Whether the text at a position contains undeclared names or characters outside GLSL, which a
    /// correction may have removed from the tokens.
    fn is_foreign(&self, span: Span) -> bool {
        let text = self.program.sources.text(span);
        for (kind, _, word) in written_tokens(text) {
            match kind {
                RawKind::Other | RawKind::ForeignWord => return true,
                RawKind::Word => {
                    let name = self.program.names.get(word);
                    let is_known = name.is_some_and(|n| self.known.contains(&n));
                    let is_plain = classify(word, self.program.version) == WordClass::Plain;
                    if is_plain && !is_known {
                        return true;
                    }
                }
                _ => {}
            }
        }
        false
    }

    /// Whether the statement around a token calls an empty macro, which a host may define.
    fn is_empty_call(&self, at: usize) -> bool {
        let start = |i: usize| self.places.get(i).map_or(u32::MAX, |(span, _)| span.start);
        let statement = self.statement(Span::at(start(at)));
        let around = Span::new(
            start(statement.start.saturating_sub(1)),
            start(statement.end),
        );
        self.empty_calls.iter().any(|call| around.touches(*call))
    }

    fn is_ambiguous(&self, token: Token) -> bool {
        self.groups.ambiguous.contains(&Name(token.value))
    }

    /// Whether a host may define a macro differently: it defines the macro itself, or tests it
    /// before the fragment does.
    fn is_open_macro(&self, used: &MacroUse) -> bool {
        let definition = used.definition;
        let mut macros = self.program.tokens.macros.iter();
        let own = macros.find(|m| m.name_span == definition);
        // A macro for another name: hosts map names of GLSL ES 1.00 to newer ones.
        let is_renaming = own.is_some_and(
            |m| matches!(m.body.as_slice(), [one] if one.token.kind == TokenKind::Identifier),
        );
        let is_of_host = !definition.is_empty() && !self.is_user(definition);
        self.is_undecided(definition) || is_of_host && !is_renaming
    }

    /// Whether a position is in a group of the fragment that the host may skip. The groups of its own
    /// text are decided.
    fn is_undecided(&self, span: Span) -> bool {
        !span.is_empty() && self.is_user(span) && self.program.tokens.is_undecided(span)
    }

    /// Where the fragment uses names that skipped groups declare too.
    fn uses_of_groups(&self) -> impl Iterator<Item = Span> {
        let tokens = self.program.tokens.tokens.iter();
        let is_use = |t: &&Token| {
            t.kind == TokenKind::Identifier && self.groups.all.contains(&Name(t.value))
        };
        let all = &self.program.tokens;
        let is_call = |e: &&Expansion| {
            let definition = all.macros.get(e.definition.0 as usize);
            definition.is_some_and(|m| self.groups.all.contains(&m.name))
        };
        let calls = all.expansions.iter().filter(is_call).map(|e| e.call);
        tokens.filter(is_use).map(|t| t.span).chain(calls)
    }

    /// Whether the function with its name or header at a position contains a group that the host
    /// controls.
    fn holds_group(&self, span: Span) -> bool {
        let functions = self.program.tree.functions.iter();
        let around = functions
            .map(|f| self.program.span(f.extent))
            .find(|extent| extent.contains(span));
        around.is_none_or(|extent| {
            self.program
                .tokens
                .undecided
                .iter()
                .any(|g| extent.contains(*g))
        })
    }

    /// Whether an error says that no overload of a user-defined function matches.
    fn is_of_own_call(&self, d: &Diagnostic) -> bool {
        let is_declaration = |span: Span| self.own_functions.iter().any(|(_, own)| *own == span);
        if d.labels.iter().any(|l| is_declaration(l.span)) {
            return true;
        }
        let of_host = |t: Token| {
            let mut own = self.own_functions.iter();
            t.kind == TokenKind::Identifier
                && own.any(|(name, span)| name.0 == t.value && !self.is_user(*span))
        };
        let mut statement = self.statement(d.span).filter_map(|i| self.token(i));
        let may_be_call = [
            error::ARGUMENT_MISMATCH,
            error::VECTOR_SIZE,
            error::INT_FLOAT_MIX,
        ]
        .iter()
        .any(|kind| d.is(*kind));
        may_be_call && statement.any(of_host)
    }
}

/// Names declared by a fragment, and the built-in names that it uses.
fn known_names(program: &Program) -> FxHashSet<Name> {
    let mut known = FxHashSet::default();
    known.extend(program.variables.iter().map(|v| v.name));
    known.extend(program.functions.iter().map(|f| f.name));
    for declared in &program.structs {
        known.extend(declared.name);
        known.extend(declared.fields.iter().map(|f| f.name));
    }
    let tree = &program.tree;
    known.extend(tree.declarator_lists.iter().map(|d| d.ident.name));
    known.extend(tree.param_lists.iter().filter_map(|p| Some(p.ident?.name)));
    known.extend(tree.functions.iter().map(|f| f.ident.name));
    known.extend(program.tokens.macros.iter().map(|m| m.name));
    let builtins = program.builtins();
    known.extend(
        builtins
            .functions()
            .filter_map(|f| program.names.get(f.name())),
    );
    known
}

/// Whether an error is about an unmatched brace.
fn is_unclosed_brace(d: &Diagnostic) -> bool {
    d.is(error::UNCLOSED_DELIMITER) && d.subject.is_brace()
}

/// Calls of empty macros, in the user's text.
fn empty_calls(program: &Program) -> Vec<Span> {
    let is_empty = |e: &&Expansion| {
        let definition = program.tokens.macros.get(e.definition.0 as usize);
        definition.is_some_and(|m| m.body.is_empty() && m.params.is_none())
    };
    let calls = program.tokens.expansions.iter().filter(is_empty);
    calls.map(|e| e.call).take(MAX_EMPTY_CALLS).collect()
}

/// Names that skipped groups declare, and the fragment declares too.
#[derive(Default)]
struct GroupNames {
    /// Those that the group declares differently, or as a macro.
    ambiguous: FxHashSet<Name>,
    /// Macros, and what is declared at global scope: their values depend on the host.
    all: FxHashSet<Name>,
}

impl GroupNames {
    fn of(program: &Program) -> GroupNames {
        let mut found = GroupNames::default();
        let tokens = &program.tokens;
        if tokens.undecided.is_empty() || program.tokens.inactive.is_empty() {
            return found;
        }
        // Declared names, each with the word of its type.
        let mut declared: FxHashSet<(Name, &str)> = FxHashSet::default();
        let mut names: FxHashSet<Name> = FxHashSet::default();
        for pair in program.tokens.tokens.windows(2) {
            let [ty, name] = pair else { continue };
            let is_type = matches!(
                ty.kind,
                TokenKind::Type | TokenKind::Identifier | TokenKind::Void
            );
            if is_type && name.kind == TokenKind::Identifier && name.is_direct() {
                declared.insert((Name(name.value), program.sources.text(ty.span)));
                names.insert(Name(name.value));
            }
        }
        let variables = program.variables.iter().filter(|v| v.function.is_none());
        let mut globals: FxHashSet<Name> = variables.map(|v| v.name).collect();
        globals.extend(program.functions.iter().map(|f| f.name));
        globals.extend(program.structs.iter().filter_map(|s| s.name));
        let is_user = |span: &Span| program.sources.is_user(span.start);
        let inactive = program.tokens.inactive.iter();
        let mut alternatives = tokens.alternatives.iter().peekable();
        for span in inactive.filter(|s| is_user(s) && tokens.is_undecided(**s)) {
            while alternatives.next_if(|a| a.start < span.start).is_some() {}
            let is_alternative = alternatives.next_if_eq(&span).is_some();
            for (before, word) in word_pairs(program.sources.text(*span)) {
                let Some(name) = program.names.get(word) else {
                    continue;
                };
                let is_macro = before == "define";
                let is_again = names.contains(&name) && !is_statement_word(before);
                if is_alternative && (is_macro || is_again && globals.contains(&name)) {
                    found.all.insert(name);
                }
                if is_macro || is_again && !declared.contains(&(name, before)) {
                    found.ambiguous.insert(name);
                }
            }
        }
        found
    }
}

/// Whether a word before a name means that it is not declared there.
fn is_statement_word(word: &str) -> bool {
    matches!(
        word,
        "return" | "else" | "case" | "in" | "out" | "inout" | "const"
    )
}

/// Pairs of adjacent words in a text.
fn word_pairs(text: &str) -> Vec<(&str, &str)> {
    let mut before: Option<&str> = None;
    let mut pairs = Vec::new();
    for (kind, _, word) in written_tokens(text) {
        match kind {
            RawKind::Whitespace | RawKind::BlockComment | RawKind::LineComment => {}
            RawKind::Word => {
                pairs.extend(before.map(|b| (b, word)));
                before = Some(word);
            }
            _ => before = None,
        }
    }
    pairs
}
