//! The raw words and directives of a shader.

use shaderlint_syntax::{ConditionalGroups, GroupDirective, Lexer, RawKind};
use shaderlint_text::{CompiledText, Span};

/// A raw token that is not blank and no comment.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScannedToken<'t> {
    pub kind: RawKind,
    pub span: Span,
    pub text: &'t str,
    /// The directive that it is part of.
    pub directive: Option<usize>,
}

impl ScannedToken<'_> {
    pub fn is_word(&self) -> bool {
        self.kind == RawKind::Word
    }
}

/// A directive.
#[derive(Debug)]
pub(super) struct ScannedDirective<'t> {
    /// From its `#` to its last token.
    pub span: Span,
    /// Its word, such as `ifdef`; empty for a lone `#`.
    pub name: &'t str,
    /// The tokens after the word.
    pub rest: std::ops::Range<usize>,
}

/// The tokens of a shader before the preprocessor.
pub(super) struct RawScan<'t> {
    pub tokens: Vec<ScannedToken<'t>>,
    pub directives: Vec<ScannedDirective<'t>>,
}

impl<'t> RawScan<'t> {
    pub fn of(code: &CompiledText<'t>) -> RawScan<'t> {
        let mut lexer = Lexer::new(code.text, code.base);
        let mut scan = RawScan {
            tokens: Vec::new(),
            directives: Vec::new(),
        };
        let (mut at_line_start, mut directive) = (true, None);
        loop {
            let token = lexer.next_token();
            let range = |at: u32| (at - code.base) as usize;
            let own = range(token.span.start)..range(token.span.end);
            let text = code.text.get(own).unwrap_or("");
            match token.kind {
                RawKind::End => return scan,
                RawKind::Newline => (at_line_start, directive) = (true, None),
                RawKind::Whitespace | RawKind::LineComment => {}
                RawKind::BlockComment | RawKind::OpenComment => {}
                RawKind::Hash if at_line_start => {
                    at_line_start = false;
                    directive = Some(scan.directives.len());
                    let rest = scan.tokens.len()..scan.tokens.len();
                    scan.directives.push(ScannedDirective {
                        span: token.span,
                        name: "",
                        rest,
                    });
                }
                kind => {
                    at_line_start = false;
                    if let Some(last) = directive.and_then(|i| scan.directives.get_mut(i)) {
                        let is_name = last.name.is_empty() && last.rest.is_empty();
                        last.span.end = token.span.end;
                        if is_name {
                            last.name = text;
                            continue;
                        }
                        last.rest.end += 1;
                    }
                    scan.tokens.push(ScannedToken {
                        kind,
                        span: token.span,
                        text,
                        directive,
                    });
                }
            }
        }
    }

    /// The tokens of a directive after its word.
    pub fn rest(&self, directive: &ScannedDirective) -> &[ScannedToken<'t>] {
        self.tokens.get(directive.rest.clone()).unwrap_or(&[])
    }

    /// The directive that a token is part of.
    pub fn directive_of(&self, token: &ScannedToken) -> Option<&ScannedDirective<'t>> {
        self.directives.get(token.directive?)
    }

    /// Whether a word occurs.
    pub fn has_word(&self, word: &str) -> bool {
        self.tokens.iter().any(|t| t.is_word() && t.text == word)
    }

    /// The groups of `#if`, by the indices of their directives.
    pub fn groups(&self) -> ConditionalGroups<usize> {
        let mut groups = ConditionalGroups::default();
        for (at, directive) in self.directives.iter().enumerate() {
            if let Some(effect) = GroupDirective::of(directive.name) {
                groups.add(effect, at);
            }
        }
        groups
    }

    /// The start of the outermost `#if` that is open at an address.
    pub fn open_group(&self, address: u32) -> Option<u32> {
        let groups = self.groups().all.into_iter();
        let mut spans = groups.map(|group| {
            let at = |index: &usize| self.directives.get(*index).map(|d| d.span.start);
            let start = group.directives().next().and_then(at);
            (start, group.end.as_ref().and_then(at))
        });
        let is_open = |end: Option<u32>| end.is_none_or(|end| address <= end);
        let found = spans.find(|(start, end)| start.is_some_and(|s| s < address) && is_open(*end));
        found?.0
    }
}
