//! Macro definitions and their expansion (GLSL ES 3.00 section 3.4).
//!
//! Expansion follows ANGLE's `MacroExpander`, so results match the browser: a stack of replacement
//! lists, macros disabled while their own list is active, and arguments expanded separately before
//! substitution.

use super::{MAX_GATHERED, Preprocessor, TokenInput, TokenList, bad, error_at};
use crate::names::Name;
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::{count, error};
use shaderlint_text::{Sources, Span};
use std::ops::Range;
use std::rc::Rc;

/// Maximum total length of open replacement lists, in tokens; same as ANGLE.
const MAX_OPEN_TOKENS: usize = 10_000;
/// Maximum nesting of macro calls in arguments; ANGLE uses 1,000.
const MAX_ARGUMENT_DEPTH: u32 = 1_000;

/// Index of a [`Macro`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct MacroId(pub u32);

/// A macro definition, user-defined or predefined.
#[derive(Debug)]
pub struct Macro {
    /// Name of the macro.
    pub name: Name,
    /// Span of the name in the `#define`; empty for a predefined macro.
    pub name_span: Span,
    /// Parameters of a function-like macro.
    pub params: Option<Vec<Name>>,
    /// Replacement list. A token's `expansion` is the index of its parameter, or [`Token::DIRECT`].
    pub body: Vec<Piece>,
    /// Whether it is predefined by the language.
    pub predefined: bool,
    /// Number of expansions and of tests by `#ifdef` and `defined`.
    pub uses: u32,
    disabled: bool,
    open_calls: u32,
}

impl Macro {
    pub(super) fn new(name: Name, name_span: Span) -> Macro {
        Macro {
            name,
            name_span,
            params: None,
            body: Vec::new(),
            predefined: false,
            uses: 0,
            disabled: false,
            open_calls: 0,
        }
    }

    /// Whether a call of it is being expanded.
    pub(super) fn is_open(&self) -> bool {
        self.open_calls > 0
    }

    /// Whether `other` is an identical definition, so that repeating it is not an error.
    pub(super) fn same_as(&self, other: &Macro, sources: &Sources) -> bool {
        // Equal numbers in different notation count as different.
        let same_text = |a: &Token, b: &Token| sources.text(a.span) == sources.text(b.span);
        self.params == other.params
            && self.body.len() == other.body.len()
            && self.body.iter().zip(&other.body).all(|(a, b)| {
                let (x, y) = (&a.token, &b.token);
                a.space == b.space && x.kind == y.kind && x.value == y.value && same_text(x, y)
            })
    }
}

/// A token inside the preprocessor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Piece {
    /// The token; all words are `Identifier` until they leave the preprocessor.
    pub token: Token,
    /// Whether whitespace precedes it.
    pub space: bool,
    /// Whether it names a macro that must not be expanded again.
    pub(super) frozen: bool,
}

/// One expanded call of a macro.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expansion {
    /// The macro that was called.
    pub definition: MacroId,
    /// The call from its name to the closing parenthesis in the source; for a call inside another
    /// macro's body, only the name there.
    pub call: Span,
    /// The expansion that produced the call, or [`Token::DIRECT`].
    pub parent: u32,
}

/// Placeholder that the parser sees for a macro call with a reported error.
fn reported(name: Piece) -> Piece {
    let token = Token {
        kind: TokenKind::Bad,
        value: bad::REPORTED,
        ..name.token
    };
    Piece { token, ..name }
}

struct OpenList {
    of: MacroId,
    pieces: Vec<Piece>,
    at: usize,
}

/// Expands the macros of one input.
#[derive(Default)]
pub(super) struct Expander {
    open: Vec<OpenList>,
    put_back: Option<Piece>,
    open_tokens: usize,
    /// While arguments are collected, macros that finish stay disabled.
    keep_disabled: bool,
    to_enable: Vec<MacroId>,
    depth: u32,
}

impl Expander {
    /// The next token with all macros expanded.
    #[inline]
    pub fn next(&mut self, pp: &mut Preprocessor, input: &mut TokenInput) -> Piece {
        loop {
            let piece = if self.is_idle() {
                input.next(pp)
            } else {
                self.take(pp, input)
            };
            let Some(id) = pp.macro_of_piece(&piece) else {
                return piece;
            };
            if let Some(piece) = self.call(pp, input, id, piece) {
                return piece;
            }
        }
    }

    /// Puts a token back; it will be read next.
    pub fn put_back(&mut self, piece: Piece) {
        self.put_back = Some(piece);
    }

    /// Whether the next token comes directly from the input, the usual case.
    pub fn is_idle(&self) -> bool {
        self.open.is_empty() && self.put_back.is_none()
    }

    /// Expands the macro that `piece` names, or returns the piece if it is not a call.
    #[inline(never)]
    fn call(
        &mut self,
        pp: &mut Preprocessor,
        input: &mut TokenInput,
        id: MacroId,
        mut piece: Piece,
    ) -> Option<Piece> {
        let definition = pp.macros.get(id.0 as usize)?;
        if definition.disabled {
            piece.frozen = true;
            return Some(piece);
        }
        if definition.params.is_some() && !self.at_left_paren(pp, input) {
            return Some(piece);
        }
        self.expand(pp, input, id, piece);
        None
    }

    fn take(&mut self, pp: &mut Preprocessor, input: &mut TokenInput) -> Piece {
        if let Some(piece) = self.put_back.take() {
            return piece;
        }
        while let Some(list) = self.open.last_mut() {
            if let Some(&piece) = list.pieces.get(list.at) {
                list.at += 1;
                return piece;
            }
            self.close_list(pp);
        }
        input.next(pp)
    }

    fn close_list(&mut self, pp: &mut Preprocessor) {
        let Some(list) = self.open.pop() else { return };
        self.open_tokens -= list.pieces.len();
        let Some(definition) = pp.macros.get_mut(list.of.0 as usize) else {
            return;
        };
        definition.open_calls -= 1;
        if self.keep_disabled {
            self.to_enable.push(list.of);
        } else {
            definition.disabled = false;
        }
    }

    fn at_left_paren(&mut self, pp: &mut Preprocessor, input: &mut TokenInput) -> bool {
        let was_kept = std::mem::replace(&mut self.keep_disabled, true);
        let piece = self.take(pp, input);
        match self.open.last_mut() {
            Some(list) if list.at > 0 => list.at -= 1,
            _ => self.put_back = Some(piece),
        }
        self.enable(pp, was_kept);
        piece.token.kind == TokenKind::LeftParen
    }

    fn enable(&mut self, pp: &mut Preprocessor, keep: bool) {
        self.keep_disabled = keep;
        if !keep {
            for id in self.to_enable.drain(..) {
                if let Some(definition) = pp.macros.get_mut(id.0 as usize) {
                    definition.disabled = false;
                }
            }
        }
    }

    /// Expands the call that starts with `name` and pushes its replacement list.
    fn expand(&mut self, pp: &mut Preprocessor, input: &mut TokenInput, id: MacroId, name: Piece) {
        let Some(definition) = pp.macros.get_mut(id.0 as usize) else {
            return;
        };
        definition.uses += 1;
        definition.open_calls += 1;
        let has_params = definition.params.is_some();
        let was_kept = std::mem::replace(&mut self.keep_disabled, true);
        let mut args = Vec::new();
        let mut end = name.token;
        if has_params {
            match self.arguments(pp, input, id, name) {
                Some((found, close)) => (args, end) = (found, close),
                None => {
                    self.put_back.get_or_insert(reported(name));
                    self.enable(pp, was_kept);
                    if let Some(definition) = pp.macros.get_mut(id.0 as usize) {
                        definition.open_calls -= 1;
                    }
                    return;
                }
            }
        }
        self.enable(pp, was_kept);
        let pieces = self.replace(pp, id, name, end, &args);
        if let Some(definition) = pp.macros.get_mut(id.0 as usize) {
            definition.disabled = true;
        }
        self.open_tokens += pieces.len();
        pp.expanded += pieces.len();
        self.open.push(OpenList {
            of: id,
            pieces,
            at: 0,
        });
    }

    /// The replacement list of a call with arguments substituted and each token's origin recorded.
    fn replace(
        &self,
        pp: &mut Preprocessor,
        id: MacroId,
        name: Piece,
        end: Token,
        args: &[Vec<Piece>],
    ) -> Vec<Piece> {
        let is_direct = name.token.is_direct();
        let length = pp.names.text(Name(name.token.value)).len() as u32;
        let own = Span::new(name.token.spelled, name.token.spelled + length);
        let call = if is_direct {
            name.token.span.to(end.span)
        } else {
            own
        };
        let seen = if is_direct { call } else { name.token.span };
        let expansion = pp.out.expansions.len() as u32;
        pp.out.expansions.push(Expansion {
            definition: id,
            call,
            parent: name.token.expansion,
        });
        let magic = pp.magic_value(id, &name.token);
        let Some(definition) = pp.macros.get(id.0 as usize) else {
            return Vec::new();
        };
        let mut pieces: Vec<Piece> = Vec::with_capacity(definition.body.len());
        for piece in &definition.body {
            if pieces.len() + self.open_tokens > MAX_OPEN_TOKENS && definition.params.is_some() {
                pp.too_much_expansion(seen);
                break;
            }
            let Some(arg) = args.get(piece.token.expansion as usize) else {
                let token = Token {
                    span: seen,
                    expansion,
                    ..piece.token
                };
                pieces.push(Piece { token, ..*piece });
                continue;
            };
            for (i, piece_of_arg) in arg.iter().enumerate() {
                let mut p = *piece_of_arg;
                if p.token.is_direct() {
                    p.token.expansion = expansion;
                }
                if i == 0 {
                    p.space = piece.space;
                }
                pieces.push(p);
            }
        }
        if let (Some(value), Some(first)) = (magic, pieces.first_mut()) {
            first.token.value = value;
        }
        if let Some(first) = pieces.first_mut() {
            first.space = name.space;
        }
        pieces
    }

    /// Parses `( a, b )` and expands each argument. Returns the arguments and the closing
    /// parenthesis; `None` if the call is invalid, which has been reported.
    fn arguments(
        &mut self,
        pp: &mut Preprocessor,
        input: &mut TokenInput,
        id: MacroId,
        name: Piece,
    ) -> Option<(Vec<Vec<Piece>>, Token)> {
        let (list, mut args, close) = self.gather(pp, input, id, name)?;
        self.check_count(pp, id, &name.token, close.span, &mut args)?;
        let mut total = 0;
        let mut expanded = Vec::with_capacity(args.len());
        for arg in args {
            expanded.push(self.expand_argument(pp, &list, arg, &mut total)?);
        }
        Some((expanded, close))
    }

    /// Parses `( a, b )`: returns the token list, the ranges of the arguments in it, and the
    /// closing parenthesis.
    fn gather(
        &mut self,
        pp: &mut Preprocessor,
        input: &mut TokenInput,
        id: MacroId,
        name: Piece,
    ) -> Option<(Rc<TokenList>, Vec<Range<usize>>, Token)> {
        self.take(pp, input); // the left parenthesis that was seen before
        if self.is_idle()
            && let TokenInput::Pieces(list, range) = input
            && let Some(found) = written_arguments(list, range)
        {
            return Some(found);
        }
        let mut pieces: Vec<Piece> = Vec::new();
        let mut args: Vec<Range<usize>> = Vec::new();
        let mut from = 0;
        let mut open = 1;
        let close = loop {
            let piece = self.take(pp, input);
            match piece.token.kind {
                TokenKind::End => {
                    self.put_back = Some(piece);
                    pp.unterminated_call(name.token.span, id);
                    return None;
                }
                TokenKind::LeftParen => open += 1,
                TokenKind::RightParen => {
                    open -= 1;
                    if open == 0 {
                        break piece.token;
                    }
                }
                TokenKind::Comma if open == 1 => {
                    args.push(from..pieces.len());
                    from = pieces.len();
                    continue;
                }
                _ => {}
            }
            pieces.push(piece);
        };
        args.push(from..pieces.len());
        if self.depth > 0 {
            pp.gathered += pieces.len();
            if pp.gathered > MAX_GATHERED {
                pp.too_much_expansion(name.token.span);
                return None;
            }
        }
        Some((Rc::new(TokenList::new(pieces)), args, close))
    }

    fn check_count(
        &self,
        pp: &mut Preprocessor,
        id: MacroId,
        called: &Token,
        close: Span,
        args: &mut Vec<Range<usize>>,
    ) -> Option<()> {
        let definition = pp.macros.get(id.0 as usize)?;
        let expected = definition.params.as_ref().map_or(0, Vec::len);
        if expected == 0 && args.len() == 1 && args.first().is_some_and(Range::is_empty) {
            args.clear();
        }
        if args.len() == expected {
            return Some(());
        }
        let name = pp.names.text(definition.name).to_string();
        let message = format!(
            "macro `{name}` expects {}, found {}",
            count(expected, "argument"),
            args.len()
        );
        let defined = definition.name_span;
        // A call inside another macro's body is reported there.
        let call = match called.is_direct() {
            true => called.span.to(close),
            false => Span::new(called.spelled, called.spelled + name.len() as u32),
        };
        let mut d = error_at(error::MACRO_ARGUMENTS, call, message);
        if !defined.is_empty() {
            d = d.label(defined, "defined here");
        }
        pp.report_token(d, called);
        None
    }

    fn expand_argument(
        &self,
        pp: &mut Preprocessor,
        list: &Rc<TokenList>,
        arg: Range<usize>,
        total: &mut usize,
    ) -> Option<Vec<Piece>> {
        let is_plain = |p: &Piece| {
            p.token.kind != TokenKind::Identifier || pp.macro_named(Name(p.token.value)).is_none()
        };
        let pieces = list.pieces.get(arg.clone()).unwrap_or(&[]);
        if pieces.iter().all(is_plain) {
            *total += pieces.len();
            return Some(pieces.to_vec());
        }
        let seen = pieces.first().map_or(Span::default(), |p| p.token.span);
        if self.depth + 1 >= MAX_ARGUMENT_DEPTH {
            pp.too_much_expansion(seen);
            return None;
        }
        let mut inner = Expander {
            depth: self.depth + 1,
            ..Expander::default()
        };
        let mut input = TokenInput::Pieces(list.clone(), arg);
        let mut out = Vec::new();
        loop {
            let piece = inner.next(pp, &mut input);
            if piece.token.kind == TokenKind::End {
                return Some(out);
            }
            out.push(piece);
            *total += 1;
            if *total + self.open_tokens > MAX_OPEN_TOKENS {
                pp.too_much_expansion(seen);
                return None;
            }
        }
    }
}

/// The arguments of a call inside a list, after its left parenthesis, and the closing parenthesis;
/// `range` advances past it. `None` if the list ends first.
fn written_arguments(
    list: &Rc<TokenList>,
    range: &mut Range<usize>,
) -> Option<(Rc<TokenList>, Vec<Range<usize>>, Token)> {
    let end = list.closing(range.start.checked_sub(1)?, range)?;
    let mut args = Vec::new();
    let (mut from, mut at) = (range.start, range.start);
    while at < end {
        match list.pieces.get(at).map(|p| p.token.kind) {
            Some(TokenKind::LeftParen) => at = list.closing(at, range)?,
            Some(TokenKind::Comma) => {
                args.push(from..at);
                from = at + 1;
            }
            _ => {}
        }
        at += 1;
    }
    args.push(from..end);
    range.start = end + 1;
    Some((list.clone(), args, list.pieces.get(end)?.token))
}
