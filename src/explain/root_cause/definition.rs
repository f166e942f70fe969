//! Malformed macro definitions.

use super::calls::MacroCalls;
use super::candidate::RepairCandidate;
use super::{FaultyShader, MAX_LOOKED_AT};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_syntax::{Macro, MacroId, Piece, TokenKind};
use shaderlint_text::{Edit, Span};

/// Maximum number of lines after a definition that may belong to it if a `\` is missing.
const MAX_LINES: u32 = 40;

/// A macro definition and its name.
pub(super) struct Definition<'a> {
    pub of: &'a Macro,
    pub name: &'a str,
}

impl<'a> Definition<'a> {
    pub fn first(&self) -> Option<&'a Piece> {
        self.of.body.first()
    }

    pub fn last(&self) -> Option<&'a Piece> {
        self.of.body.last()
    }

    /// A candidate repair with its diagnostic.
    pub fn candidate(&self, d: Diagnostic, fix: Fix) -> RepairCandidate {
        RepairCandidate {
            of: Some(self.of.name_span),
            ..RepairCandidate::new(d, fix)
        }
    }

    pub fn faulty(&self, span: Span, message: String) -> Diagnostic {
        Diagnostic::error(error::FAULTY_MACRO, span, message)
    }
}

impl FaultyShader<'_> {
    /// Candidate repairs for the macros called near an error.
    pub(super) fn definitions(&self) -> Vec<RepairCandidate> {
        let mut all = Vec::new();
        let suspects = self.suspects();
        for d in suspects.iter().filter_map(|id| self.definition(*id)) {
            self.equals_and_semicolon(&d, &mut all);
            all.extend(self.blank_before_params(&d));
            all.extend(self.returned(&d));
            all.extend(self.broken_line(&d));
            self.brackets(&d, &mut all);
            self.edge_operators(&d, &mut all);
            self.empty_body(&d, &mut all);
        }
        self.lost_continuations(&mut all);
        for d in suspects.iter().filter_map(|id| self.definition(*id)) {
            self.literals(&d, &mut all);
            self.misspelled_params(&d, &mut all);
        }
        all
    }

    pub(super) fn definition(&self, id: MacroId) -> Option<Definition<'_>> {
        let of = self.program.tokens.macros.get(id.0 as usize)?;
        let name = self.program.names.text(of.name);
        let is_own = !of.predefined && self.is_user(of.name_span);
        is_own.then_some(Definition { of, name })
    }

    /// The macros called near an error, nearest first.
    fn suspects(&self) -> Vec<MacroId> {
        let mut all: Vec<MacroId> = Vec::new();
        for d in self.errors.iter().take(MAX_LOOKED_AT) {
            let near: &[_] = MacroCalls::near(&self.calls, self.program, d.span);
            let through = d.macros.iter().filter_map(|used| {
                let macros = &self.program.tokens.macros;
                let at = macros.iter().position(|m| m.name_span == used.definition)?;
                Some(MacroId(at as u32))
            });
            let near = near.iter().rev().take(MAX_LOOKED_AT).map(|(_, id)| *id);
            for id in through.chain(near) {
                if !all.contains(&id) {
                    all.push(id);
                }
            }
        }
        all.truncate(2 * MAX_LOOKED_AT);
        all
    }

    /// `#define PI = 3.14;`
    fn equals_and_semicolon(&self, d: &Definition, all: &mut Vec<RepairCandidate>) {
        let (Some(first), Some(last)) = (d.first(), d.last()) else {
            return;
        };
        let (start, end) = (first.token.span, last.token.span);
        let head = matches!(first.token.kind, TokenKind::Equal | TokenKind::Colon);
        let next = d.of.body.get(1).map_or(start.end, |p| p.token.span.start);
        let head = head.then(|| {
            let what = self.text(start);
            let message = format!("the definition of macro `{}` starts with `{what}`", d.name);
            let note = "a macro definition has no `=` after the name (section 3.4)";
            let d = d.faulty(start, message).mark("inserted at every use");
            (
                Edit::delete(Span::new(start.start, next)),
                what,
                d.note(note),
            )
        });
        let tail = matches!(last.token.kind, TokenKind::Semicolon | TokenKind::Comma);
        let tail = tail.then(|| {
            let what = self.text(end);
            let message = format!("the definition of macro `{}` ends with `{what}`", d.name);
            let note = "preprocessor directives do not end with `;` (section 3.4)";
            let d = d.faulty(end, message).mark("inserted at every use");
            (Edit::delete(end), what, d.note(note))
        });
        if let (Some((e, _, found)), Some((f, _, _))) = (&head, &tail) {
            let fix = Fix::safe("keep only the value", vec![e.clone(), f.clone()]);
            all.push(d.candidate(found.clone(), fix));
        }
        for (edit, what, found) in head.into_iter().chain(tail) {
            all.push(d.candidate(found, Fix::safe(format!("remove `{what}`"), vec![edit])));
        }
    }

    /// `#define SQ (x) x*x`
    fn blank_before_params(&self, d: &Definition) -> Option<RepairCandidate> {
        let first = d.first().filter(|_| d.of.params.is_none())?;
        let mut kinds = d.of.body.iter().map(|p| p.token.kind);
        if kinds.next() != Some(TokenKind::LeftParen) {
            return None;
        }
        let mut expects_name = true;
        for kind in kinds {
            match (kind, expects_name) {
                (TokenKind::Identifier, true) | (TokenKind::Comma, false) => {
                    expects_name = !expects_name
                }
                (TokenKind::RightParen, _) => break,
                _ => return None,
            }
        }
        let gap = Span::new(d.of.name_span.end, first.token.span.start);
        let message = format!("space between macro `{}` and its parameters", d.name);
        let note = format!(
            "with the space, `{}` has no parameters and expands to the rest of the line",
            d.name
        );
        let found = d.faulty(gap, message).mark("no space allowed here");
        let fix = Fix::safe("remove the space", vec![Edit::delete(gap)]);
        Some(d.candidate(found.note(note), fix))
    }

    /// `#define SQ(x) { return x*x; }`
    fn returned(&self, d: &Definition) -> Option<RepairCandidate> {
        let body = &d.of.body;
        let at = |i: usize| body.get(i).map(|p| p.token.kind);
        let open = (at(0) == Some(TokenKind::LeftBrace)) as usize;
        let word = body
            .get(open)
            .filter(|p| self.text(p.token.span) == "return");
        let (Some(word), Some(value)) = (word, body.get(open + 1)) else {
            return None;
        };
        let ends =
            |p: &&Piece| matches!(p.token.kind, TokenKind::Semicolon | TokenKind::RightBrace);
        let after = body.iter().rev().take_while(ends).last();
        let from = d
            .first()
            .map_or(word.token.span.start, |p| p.token.span.start);
        let mut edits = vec![Edit::delete(Span::new(from, value.token.span.start))];
        if let (Some(after), Some(last)) = (after, d.last()) {
            edits.push(Edit::delete(after.token.span.to(last.token.span)));
        }
        let message = format!("macro `{}` contains `return`", d.name);
        let found = d.faulty(word.token.span, message);
        let found = found.mark("macros do not return values");
        Some(d.candidate(found, Fix::safe("keep only the value", edits)))
    }

    /// A `\` followed by blanks, which does not continue the line.
    fn broken_line(&self, d: &Definition) -> Option<RepairCandidate> {
        let last = d.last().map(|p| p.token.span)?;
        let end = self.end_of_line(last.end);
        let gap = Span::new(last.end, end);
        if self.text(last) != "\\" || gap.is_empty() || !self.text(gap).trim().is_empty() {
            return None;
        }
        let message = format!("space after `\\` ends the definition of macro `{}`", d.name);
        let found = d.faulty(gap, message).mark("no space allowed here");
        let found = found.note("`\\` continues a line only as its last character");
        let fix = Fix::safe("remove the space", vec![Edit::delete(gap)]);
        Some(d.candidate(found, fix))
    }

    /// `#define X * 2.0`, `#define X a +`
    fn edge_operators(&self, d: &Definition, all: &mut Vec<RepairCandidate>) {
        let body = d.of.body.as_slice();
        let ([first, next, ..], [.., before, last]) = (body, body) else {
            return;
        };
        let (start, end) = (first.token.span, last.token.span);
        let until_end = Span::new(before.token.span.end, end.end);
        let from_start = Span::new(start.start, next.token.span.start);
        let edges = [
            (last.token, until_end, "ends", "missing operand after it"),
            (
                first.token,
                from_start,
                "starts",
                "missing operand before it",
            ),
        ];
        for (edge, gap, verb, missing) in edges {
            if !is_operator(edge.kind) {
                continue;
            }
            let what = self.text(edge.span);
            let message = format!("the definition of macro `{}` {verb} with `{what}`", d.name);
            let found = d.faulty(edge.span, message).mark(missing);
            let fix = Fix::suggestion(format!("remove `{what}`"), vec![Edit::delete(gap)]);
            all.push(d.candidate(found, fix));
        }
    }

    /// Definitions over several lines with a missing `\`, where an error follows on the next lines.
    fn lost_continuations(&self, all: &mut Vec<RepairCandidate>) {
        let macros = &self.program.tokens.macros;
        let mut seen = Vec::new();
        for (i, of) in macros.iter().enumerate() {
            let id = MacroId(i as u32);
            if of.predefined || all.len() > 300 {
                continue;
            }
            let Some(file) = self.program.sources.file_at(of.name_span.start) else {
                continue;
            };
            let line = |at: u32| file.lines().line(at.saturating_sub(file.base));
            let last = line(self.end_of(of));
            let near = self.errors.iter().take(MAX_LOOKED_AT).any(|e| {
                let at = line(e.span.start);
                file.span().contains(Span::at(e.span.start)) && last < at && at <= last + MAX_LINES
            });
            if near && !seen.contains(&id) {
                seen.push(id);
            }
        }
        for &id in seen.iter().rev().take(MAX_LOOKED_AT) {
            if let Some(d) = self.definition(id) {
                all.extend(self.lost_continuation(&d));
            }
        }
    }

    fn lost_continuation(&self, d: &Definition) -> Option<RepairCandidate> {
        let end = self.end_of(d.of);
        let line_end = self.end_of_line(end);
        let gap = Span::new(end, line_end);
        let code = self.program.sources.code_at(end)?;
        let rest = code.text.get((line_end - code.base) as usize..)?;
        let next = rest.trim_start_matches(['\r', '\n']);
        let next = next.split(['\r', '\n']).next().unwrap_or("");
        if !self.text(gap).trim().is_empty()
            || next.trim().is_empty()
            || next.trim_start().starts_with('#')
        {
            return None;
        }
        let head = Span::new(d.of.name_span.start, end);
        let is_long = self.text(head).contains('\n');
        let goes_on = next.trim_end().ends_with('\\');
        let is_open = d.last().is_none_or(|p| {
            is_operator(p.token.kind)
                || matches!(p.token.kind, TokenKind::Comma | TokenKind::LeftBrace)
        }) || self.unclosed(d) > 0;
        let is_indented = next.starts_with([' ', '\t']);
        if !(goes_on || is_open || is_long && is_indented) {
            return None;
        }
        // An empty macro that is never expanded is a flag for `#ifdef`.
        let is_put_in = || {
            let expansions = self.program.tokens.expansions.iter();
            let macros = &self.program.tokens.macros;
            let mut of = expansions.filter_map(|e| macros.get(e.definition.0 as usize));
            of.any(|m| m.name_span == d.of.name_span)
        };
        if d.last().is_none() && !is_put_in() {
            return None;
        }
        let message = format!("missing `\\` in the definition of macro `{}`", d.name);
        let found = d.faulty(gap, message).mark("expected `\\` here");
        let found = found.note("a macro definition continues on the next line only after `\\`");
        let fix = Fix::safe("add `\\`", vec![Edit::replace(gap, " \\")]);
        Some(d.candidate(found, fix))
    }

    /// Where the code of a definition ends.
    pub(super) fn end_of(&self, of: &Macro) -> u32 {
        match (of.body.last(), &of.params) {
            (Some(last), _) => last.token.span.end,
            (None, None) => of.name_span.end,
            (None, Some(_)) => {
                let line = Span::new(of.name_span.end, self.end_of_line(of.name_span.end));
                let close = self.text(line).find(')').map_or(0, |at| at as u32 + 1);
                of.name_span.end + close
            }
        }
    }

    pub(super) fn end_of_line(&self, at: u32) -> u32 {
        let (_, rest) = self.program.sources.around(at);
        at + rest.find(['\r', '\n']).unwrap_or(rest.len()) as u32
    }

    pub(super) fn text(&self, span: Span) -> &str {
        self.program.sources.text(span)
    }
}

/// Whether a token is an operator between two operands.
pub(super) fn is_operator(kind: TokenKind) -> bool {
    kind.is_binary_operator() || matches!(kind, TokenKind::Dot | TokenKind::Question)
}
