//! `010`, which is eight.

use shaderlint_lint::prelude::*;

rule! { octal_literal, Tidy, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    for token in &program.tokens.tokens {
        let is_integer = matches!(token.kind, TokenKind::Int | TokenKind::Uint);
        if !is_integer || !token.is_direct() || !program.is_user(token.span) {
            continue;
        }
        let text = program.sources.text(token.span);
        let Some(digits) = text.strip_prefix('0') else {
            continue;
        };
        let digits = digits.trim_start_matches('0').trim_end_matches(['u', 'U']);
        let meant = digits.parse::<u32>().ok();
        if let Some(meant) = meant.filter(|m| *m != token.value) {
            let suffix = if text.ends_with(['u', 'U']) { "u" } else { "" };
            let decimal = format!("{meant}{suffix}");
            let edit = Edit::replace(token.span, decimal.clone());
            let value = token.value;
            cx.report_span(
                token.span,
                format!("`{text}` is an octal literal with the value {value}"),
            )
            .note("an integer literal with a leading 0 is octal (section 4.1.3)")
            .fix(Fix::suggestion(
                format!("did you mean `{decimal}`?"),
                vec![edit],
            ));
        }
    }
}
