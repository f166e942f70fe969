//! Conditional groups: `#if` to `#endif` (GLSL ES 3.00 section 3.4).

use super::condition::{ConditionProblem, evaluate};
use super::macros::{Expander, Macro, Piece};
use super::{ConditionGroup, Preprocessor, TokenInput, error_at};
use crate::names::Name;
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::{Fix, error};
use shaderlint_text::{Edit, Span};

/// Deepest nesting of `#if`.
const MAX_GROUPS: usize = 100_000;

impl Preprocessor<'_> {
    pub(super) fn open_group(&mut self, word: &str, span: Span, rest: &[Piece]) {
        let skip_all = self.is_skipping();
        let mut group = ConditionGroup {
            start: span,
            skip_all,
            ..ConditionGroup::default()
        };
        if !skip_all {
            group.is_undecided = self.is_undecided(rest);
            group.guard = rest
                .first()
                .filter(|p| word == "ifndef" && p.token.kind == TokenKind::Identifier)
                .map(|p| Name(p.token.value));
            let holds = match word {
                "if" => self.condition(span, rest),
                _ => self.is_defined(span, rest, word) == (word == "ifdef"),
            };
            group.skip = !holds;
            group.taken = holds;
        }
        if self.groups.len() < MAX_GROUPS {
            self.groups.push(group);
        } else if !self.gave_up {
            self.gave_up = true;
            let d = error_at(error::BROWSER_LIMIT, span, "too many nested `#if`");
            self.report(d);
        }
    }

    pub(super) fn is_defined(&mut self, span: Span, rest: &[Piece], directive: &str) -> bool {
        let Some((first, rest)) = rest
            .split_first()
            .filter(|(p, _)| p.token.kind == TokenKind::Identifier)
        else {
            let always = format!("#if {}", (directive == "ifdef") as u8);
            let fix = rest.is_empty().then(|| {
                let title = format!("use a condition, such as `{always}`");
                Fix::suggestion(title, vec![Edit::replace(span, always)])
            });
            self.expected_or(span, rest, &format!("a name after `#{directive}`"), fix);
            return false;
        };
        let defined = self.ask_defined(Name(first.token.value));
        let fix = self.as_condition(span, directive, first, rest);
        self.expect_end_or(rest, directive, fix);
        defined
    }

    pub(super) fn ask_defined(&mut self, name: Name) -> bool {
        let Some(id) = self.macro_named(name) else {
            return false;
        };
        if let Some(definition) = self.macros.get_mut(id.0 as usize) {
            definition.uses += 1;
        }
        true
    }

    pub(super) fn elif(&mut self, span: Span, rest: &[Piece]) {
        let Some(group) = self.groups.last_mut() else {
            return self.without_if("elif", span);
        };
        if group.skip_all {
            return;
        }
        if let Some(at) = group.else_at {
            return self.after_else("elif", span, at);
        }
        group.skip = true;
        if group.taken {
            return;
        }
        let is_undecided = self.is_undecided(rest);
        let holds = self.condition(span, rest);
        if let Some(group) = self.groups.last_mut() {
            group.skip = !holds;
            group.taken = holds;
            group.is_undecided |= is_undecided;
        }
    }

    /// Whether a condition tests a name that is not defined here but may be defined by a host.
    fn is_undecided(&self, condition: &[Piece]) -> bool {
        condition.iter().any(|p| {
            let name = Name(p.token.value);
            p.token.kind == TokenKind::Identifier
                && self.macro_named(name).is_none()
                && !self.undefined.contains(&name)
                && self.names.text(name) != "defined"
        })
    }

    /// Records a macro definition, which may make the current group an include guard.
    pub(super) fn note_definition(&mut self, definition: &Macro) {
        if definition.body.is_empty()
            && definition.params.is_none()
            && let Some(group) = self.groups.last_mut()
            && group.guard == Some(definition.name)
        {
            group.is_undecided = false;
        }
    }

    /// Records a group that ends at an address.
    pub(super) fn close_group(&mut self, group: &ConditionGroup, end: u32) {
        if group.is_undecided && end >= group.start.start {
            self.out.undecided.push(Span::new(group.start.start, end));
            self.out.forks.push(Span::new(group.start.start, end));
        }
    }

    pub(super) fn else_group(&mut self, span: Span, rest: &[Piece]) {
        let Some(group) = self.groups.last_mut() else {
            return self.without_if("else", span);
        };
        if group.skip_all {
            return;
        }
        if let Some(at) = group.else_at {
            return self.after_else("else", span, at);
        }
        group.else_at = Some(span);
        group.skip = group.taken;
        group.taken = true;
        let goes_on = rest.first().filter(|p| self.raw_text(p.token.span) == "if");
        let fix = goes_on.map(|p| {
            let word = Span::new(span.start, p.token.span.end);
            Fix::safe_replacement(word, "#elif")
        });
        self.expect_end_or(rest, "else", fix);
    }

    pub(super) fn endif(&mut self, span: Span, rest: &[Piece]) {
        match self.groups.pop() {
            None => self.without_if("endif", span),
            Some(group) => {
                if !group.skip_all {
                    self.close_group(&group, span.end);
                }
                // Checked in skipped groups as well, unlike other directives.
                self.expect_end(rest, "endif");
            }
        }
    }

    pub(super) fn without_if(&mut self, word: &str, span: Span) {
        let message = format!("`#{word}` without a matching `#if`");
        let d = error_at(error::UNBALANCED_CONDITIONAL, span, message);
        let title = format!("remove `#{word}`");
        self.report(d.fix(Fix::suggestion(title, vec![Edit::delete(span)])));
    }

    pub(super) fn after_else(&mut self, word: &str, span: Span, at: Span) {
        let message = format!("`#{word}` after `#else`");
        let d = error_at(error::UNBALANCED_CONDITIONAL, span, message);
        let fix = Fix::suggestion(format!("remove `#{word}`"), vec![Edit::delete(span)]);
        self.report(d.label(at, "`#else` here").fix(fix));
    }

    /// Evaluates the condition of `#if` or `#elif`; reports errors and returns false for them.
    pub(super) fn condition(&mut self, span: Span, rest: &[Piece]) -> bool {
        let Some(pieces) = self.resolve_defined(span, rest) else {
            return false;
        };
        let pieces = self.expand_all(pieces);
        match evaluate(&pieces) {
            Ok(value) => value != 0,
            Err(problem) => {
                self.report_condition(span, rest, problem);
                false
            }
        }
    }

    pub(super) fn expand_all(&mut self, pieces: Vec<Piece>) -> Vec<Piece> {
        let mut expander = Expander::default();
        let mut input = TokenInput::of(pieces);
        let mut out = Vec::new();
        loop {
            let piece = expander.next(self, &mut input);
            if piece.token.kind == TokenKind::End || self.gave_up {
                return out;
            }
            out.push(piece);
        }
    }

    /// Replaces `defined X` and `defined(X)` with 0 or 1 before macros are expanded.
    pub(super) fn resolve_defined(&mut self, span: Span, line: &[Piece]) -> Option<Vec<Piece>> {
        let mut out = Vec::with_capacity(line.len());
        let mut rest = line;
        while let Some((&first, more)) = rest.split_first() {
            rest = more;
            let is_defined = first.token.kind == TokenKind::Identifier
                && self.names.text(Name(first.token.value)) == "defined";
            if !is_defined {
                out.push(first);
                continue;
            }
            let (name, after) = match rest {
                [name, after @ ..] if name.token.kind == TokenKind::Identifier => (name, after),
                [open, name, close, after @ ..]
                    if open.token.kind == TokenKind::LeftParen
                        && name.token.kind == TokenKind::Identifier
                        && close.token.kind == TokenKind::RightParen =>
                {
                    (name, after)
                }
                _ => {
                    self.expected(span, rest, "a name after `defined`");
                    return None;
                }
            };
            let value = self.ask_defined(Name(name.token.value)) as u32;
            out.push(Piece {
                token: Token {
                    kind: TokenKind::Int,
                    value,
                    ..first.token
                },
                ..first
            });
            rest = after;
        }
        Some(out)
    }

    pub(super) fn report_condition(
        &mut self,
        directive: Span,
        rest: &[Piece],
        problem: ConditionProblem,
    ) {
        let (span, message, note) = match problem {
            ConditionProblem::Empty => (
                directive,
                "missing preprocessor condition".to_string(),
                None,
            ),
            ConditionProblem::Undefined(span) => {
                let name = self.sources.text(span);
                let note = "an undefined name is an error in GLSL ES, not 0 as in C (section 3.4)";
                (span, format!("macro `{name}` is not defined"), Some(note))
            }
            ConditionProblem::Unexpected(span) => {
                let text = self.sources.text(span);
                let note = "preprocessor expressions consist of integers, macros and operators";
                (
                    span,
                    format!("unexpected `{text}` in a preprocessor expression"),
                    Some(note),
                )
            }
            ConditionProblem::Incomplete(span) => {
                (span, "incomplete preprocessor expression".to_string(), None)
            }
            ConditionProblem::DivisionByZero(span) => (
                span,
                "division by zero in a preprocessor expression".to_string(),
                None,
            ),
            ConditionProblem::Shift(span) => (
                span,
                "shift by a negative number or by more than 31 bits".to_string(),
                None,
            ),
            ConditionProblem::TooDeep(span) => (
                span,
                "preprocessor expression is nested too deeply".to_string(),
                None,
            ),
        };
        let mut d = error_at(error::PREPROCESSOR_EXPRESSION, span, message);
        d.notes.extend(note.map(String::from));
        d.fix = match problem {
            ConditionProblem::Unexpected(at) => self.repair_condition(rest, at),
            ConditionProblem::Undefined(at) => self.foreign_operator(rest, at),
            ConditionProblem::Empty if self.sources.text(directive).ends_with("elif") => {
                Some(Fix::suggested_replacement(directive, "#else"))
            }
            _ => None,
        };
        if let ConditionProblem::Undefined(span) = problem {
            let name = self.sources.text(span);
            d = d.help(format!(
                "use `#ifdef {name}` or `#if defined({name}) && {name} ...`"
            ));
        }
        self.report(d);
    }
}
