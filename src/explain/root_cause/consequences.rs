//! Errors that follow from another one in the same statement.

use shaderlint_diagnostic::{Diagnostic, Facet, Severity, Subject, error};
use shaderlint_semantic::Program;
use shaderlint_syntax::{RawKind, RawToken, Token, TokenKind, tokenize};
use shaderlint_text::Span;

/// Keeps the first error of a statement that does not parse. What is reported about the names and
/// types in it depends on how it was parsed, so it is not a second mistake. `errors` are in source
/// order.
pub(super) fn keep_causes(program: &Program, errors: &mut Vec<Diagnostic>) {
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(errors.len());
    let mut statement: Vec<Diagnostic> = Vec::new();
    for d in errors.drain(..) {
        let last = statement.last();
        if !last.is_some_and(|last| is_one_statement(program, last.span, d.span)) {
            kept.extend(causes(program, &mut statement));
        }
        statement.push(d);
    }
    kept.extend(causes(program, &mut statement));
    *errors = kept;
}

/// The errors of a statement that are reported.
fn causes(program: &Program, statement: &mut Vec<Diagnostic>) -> Vec<Diagnostic> {
    let is_cut = |d: &Diagnostic| is_unread(d) && d.is(error::SYNTAX_ERROR);
    if statement.iter().any(is_cut) || statement.first().is_some_and(is_unread) {
        let mut at = 0;
        statement.retain(|d| {
            at += 1;
            at == 1 || at < MAX_DROPPED && is_used_below(program, d)
        });
    }
    std::mem::take(statement)
}

/// Maximum number of errors of a statement whose names are searched below it.
const MAX_DROPPED: usize = 10;

/// Whether an error is about an undeclared name that another line uses: it is reported only once.
fn is_used_below(program: &Program, d: &Diagnostic) -> bool {
    let text = program.sources.text(d.span);
    let name = program
        .names
        .get(text)
        .filter(|_| d.is(error::UNDECLARED_NAME));
    name.is_some_and(|name| {
        let tokens = program.tokens.tokens.iter();
        let mut uses = tokens.filter(|t| t.kind == TokenKind::Identifier && t.value == name.0);
        uses.any(|t| t.span.start > d.span.end && !is_one_statement(program, d.span, t.span))
    })
}

/// Keeps one error where the text simply ends: in the middle of a statement, of which nothing can be said,
/// or inside a block.
pub(super) fn keep_end(program: &Program, errors: &mut Vec<Diagnostic>) {
    let Some(end) = last_statement(program) else {
        return;
    };
    let lacks_rest = |d: &Diagnostic| {
        let kinds = [
            error::MISSING_MAIN,
            error::UNWRAPPED_MAINIMAGE,
            error::UNDEFINED_FUNCTION,
        ];
        kinds.iter().any(|kind| d.is(*kind))
    };
    let is_unclosed = |d: &Diagnostic| d.subject == Subject::MissingClose;
    // The text goes on in a comment or in a group of a directive that is not read.
    if errors
        .iter()
        .any(|d| d.has(Facet::Moves) || d.has(Facet::Directive))
    {
        return;
    }
    let is_in_end = |d: &Diagnostic| d.span.end > end.statement.start;
    let is_part = |d: &&Diagnostic| is_in_end(d) || is_unclosed(d) || lacks_rest(d);
    if end.is_cut && errors.iter().any(is_in_end) && errors.iter().filter(is_part).count() > 1 {
        errors.retain(|d| !is_part(&d));
        let message = "the text ends in the middle of a statement";
        let place = Span::new(end.last.start, end.statement.end);
        let d = Diagnostic::error(error::SYNTAX_ERROR, place, message);
        errors.push(d.mark("the rest is missing"));
    } else if errors
        .iter()
        .any(|d| is_unclosed(d) && d.span.end >= end.last.end)
    {
        errors.retain(|d| !lacks_rest(d));
    }
}

/// Where the text of a shader ends.
struct TextEnd {
    /// After the token before the last statement to the last token.
    statement: Span,
    last: Span,
    /// Whether no statement can end with the last token.
    is_cut: bool,
}

/// `None` if the text does not end where the parsed code does, or is no code.
fn last_statement(program: &Program) -> Option<TextEnd> {
    let sources = &program.sources;
    let tokens = program.tokens.tokens.iter().rev();
    let is_text = |t: &&Token| t.kind != TokenKind::End && !t.span.is_empty();
    let mut tokens = tokens
        .filter(is_text)
        .filter(|t| sources.is_user(t.span.start));
    let parsed = tokens.next()?.span;
    // A correction may have removed the last token, or changed its kind.
    let code = sources.code_at(parsed.start)?;
    let rest = code.text.get((parsed.end - code.base) as usize..)?;
    if rest.contains([';', '{', '}']) {
        return None;
    }
    use RawKind as R;
    let is_code = |t: &&RawToken| {
        let kinds = [
            R::Whitespace,
            R::Newline,
            R::LineComment,
            R::BlockComment,
            R::OpenComment,
        ];
        !kinds.contains(&t.kind)
    };
    let removed = tokenize(rest, parsed.end);
    let removed = removed.iter().rfind(is_code).map(|t| t.span);
    let last = removed.unwrap_or(parsed);
    let is_one = |span: Span, texts: &[&str]| texts.contains(&sources.text(span));
    let mut ends = [parsed]
        .into_iter()
        .chain(tokens.map(|t| t.span))
        .filter(|span| *span != last);
    let before = ends.find(|span| is_one(*span, &[";", "{", "}"]))?;
    Some(TextEnd {
        statement: Span::new(before.end.min(last.start), last.end),
        last,
        is_cut: !is_one(last, &[";", "}"]),
    })
}

/// An error after which the rest of a statement cannot be read as it was meant, and that no correction
/// explains.
fn is_unread(d: &Diagnostic) -> bool {
    let kinds = [
        error::SYNTAX_ERROR,
        error::UNKNOWN_TYPE,
        error::FOREIGN_SYNTAX,
        error::RESERVED_WORD,
    ];
    d.severity == Severity::Error && d.fix.is_none() && kinds.iter().any(|kind| d.is(*kind))
}

/// Whether two places are on one line without the end of a statement between them.
fn is_one_statement(program: &Program, a: Span, b: Span) -> bool {
    let between = Span::new(a.start, b.start.max(a.start));
    let sources = &program.sources;
    sources.file_id_at(a.start) == sources.file_id_at(b.start)
        && !sources.text(between).contains([';', '{', '}', '\n', '\r'])
}
