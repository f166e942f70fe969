//! Code in the wrong place: a shader pasted twice, a function inside a function or a struct, and
//! characters of another alphabet throughout a text.

use super::*;
use shaderlint_diagnostic::{Fix, error};
use shaderlint_syntax::{Lexer, RawKind, TokenKind, tokenize};

/// Longest nested function, in tokens.
const MAX_TOKENS: usize = 4_000;

impl FaultyShader<'_> {
    /// Candidates that concern the whole text rather than a line.
    pub(super) fn copies(&self, all: &mut Vec<RepairCandidate>) {
        all.extend(self.pasted_twice());
        self.nested_functions(all);
        all.extend(self.all_characters());
    }

    /// The same shader twice in one text.
    fn pasted_twice(&self) -> Option<RepairCandidate> {
        let mut errors = self.errors.iter();
        let d = errors.find(|d| d.is(error::VERSION_PLACEMENT))?;
        let (first, second) = self.program.sources.around(d.span.start);
        if second.is_empty() || first.trim() != second.trim() {
            return None;
        }
        let end = d.span.start + second.len() as u32;
        let edits = vec![Edit::delete(Span::new(d.span.start, end))];
        let (kind, title) = (error::VERSION_PLACEMENT, "remove the second copy");
        let message = "the shader is pasted twice";
        Some(candidate(kind, d.span, message, title, edits))
    }

    /// A function inside a function moves before it; one inside a struct is skipped.
    fn nested_functions(&self, all: &mut Vec<RepairCandidate>) {
        let nested = self.errors.iter().filter(|d| d.is(error::LOCAL_FUNCTION));
        for d in nested.take(4) {
            let Some(outer) = self.function_around(d.span.start) else {
                continue;
            };
            let Some(inner) = self.braced_from(d.span.start) else {
                continue;
            };
            let place = self.line_at(d.span.start).map_or(inner.start, |l| l.start);
            let gap = Span::new(place.min(inner.start), inner.start);
            let indent = self.text(gap);
            let whole = match indent.trim().is_empty() {
                true => Span::new(gap.start.saturating_sub(1), inner.end),
                false => inner,
            };
            let text = self.text(inner);
            let text = match indent.is_empty() || !indent.trim().is_empty() {
                true => text.to_string(),
                false => text.replace(&format!("\n{indent}"), "\n"),
            };
            let edits = vec![
                Edit::insert(outer, format!("{text}\n\n")),
                Edit::delete(whole),
            ];
            let fix = Fix::safe("move it before the function", edits);
            all.push(RepairCandidate::of_error(d, fix));
        }
    }

    /// Where the function that contains an address starts.
    pub(super) fn function_around(&self, address: u32) -> Option<u32> {
        let program = self.program;
        let start = |token: u32| Some(program.token(token)?.span);
        let functions = program.tree.functions.iter().filter(|f| f.body.is_some());
        let around = functions.filter_map(|f| {
            let span = start(f.extent.first)?.to(start(f.extent.last)?);
            (span.start < address && address < span.end).then_some(span.start)
        });
        around.max()
    }

    /// The code from an address to the brace that closes the first one after it.
    pub(super) fn braced_from(&self, start: u32) -> Option<Span> {
        let (_, rest) = self.program.sources.around(start);
        let mut depth = 0_u32;
        for token in Lexer::new(rest, start).take(MAX_TOKENS) {
            match token.kind {
                RawKind::Operator(TokenKind::LeftBrace) => depth += 1,
                RawKind::Operator(TokenKind::RightBrace) => {
                    depth = depth.checked_sub(1)?;
                    if depth == 0 {
                        return Some(Span::new(start, token.span.end));
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// A function inside a struct.
    pub(super) fn methods(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let is_word = |at: usize| line.kind(at) == Some(RawKind::Word);
        if !is_word(0) || !is_word(1) || !line.is(2, TokenKind::LeftParen) {
            return None;
        }
        let start = line.span(0).start;
        let body = self.braced_from(start)?;
        let (before, _) = self.program.sources.around(start);
        // The innermost open brace is that of a struct.
        let from = before.rfind("struct").unwrap_or(before.len());
        let tokens = tokenize(before.get(from..).unwrap_or(""), 0);
        let count = |kind| {
            tokens
                .iter()
                .filter(|t| t.kind == RawKind::Operator(kind))
                .count()
        };
        if count(TokenKind::LeftBrace) != count(TokenKind::RightBrace) + 1 {
            return None;
        }
        let mut found = foreign(
            line.span(0).to(line.span(1)),
            "a struct cannot have member functions",
            "",
            vec![Edit::delete(body)],
        );
        found.diagnostic.fix = None;
        found.diagnostic = found
            .diagnostic
            .note("write a function with the struct as a parameter");
        Some(found)
    }

    /// Characters of another alphabet in several places: all are replaced together.
    fn all_characters(&self) -> Option<RepairCandidate> {
        let errors = self.errors.iter();
        let mut found = errors.filter(|d| d.is(error::INVALID_CHARACTER));
        let fixes = found.clone().filter_map(|d| d.fix.as_ref());
        let edits: Vec<Edit> = fixes.flat_map(|f| f.edits.clone()).collect();
        let first = found.find(|d| d.fix.is_some());
        let first = first.filter(|_| edits.len() > 1)?;
        let title = format!("replace {} characters with ASCII characters", edits.len());
        let (kind, message) = (error::INVALID_CHARACTER, first.message.clone());
        let mut found = candidate(kind, first.span, message, title, edits);
        let note = "the text contains several such characters";
        found.diagnostic = found.diagnostic.note(note);
        Some(found)
    }
}
