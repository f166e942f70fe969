//! Macro definitions with numbers of the wrong type, without a value, or with a misspelled parameter.

use super::FaultyShader;
use super::candidate::RepairCandidate;
use super::definition::Definition;
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_semantic::parsed::is_decimal;
use shaderlint_syntax::TokenKind;
use shaderlint_text::Edit;

/// Maximum number of literals per definition that are tried.
const MAX_NUMBERS: usize = 8;

/// Values of well-known macro names.
const KNOWN_VALUES: &[(&str, &str)] = &[
    ("pi", "3.14159265359"),
    ("tau", "6.28318530718"),
    ("twopi", "6.28318530718"),
    ("pi2", "6.28318530718"),
    ("halfpi", "1.57079632679"),
    ("epsilon", "0.0001"),
    ("eps", "0.0001"),
];

impl FaultyShader<'_> {
    /// Literals that every use of the macro needs to be of the other type.
    pub(super) fn literals(&self, d: &Definition, all: &mut Vec<RepairCandidate>) {
        let mut ints = Vec::new();
        if divides_integers(d) {
            return;
        }
        for piece in d.of.body.iter().take(200) {
            let span = piece.token.span;
            let text = self.text(span);
            let (other, is, needs) = match piece.token.kind {
                TokenKind::Int if is_decimal(text) => (format!("{text}.0"), "`int`", "`float`"),
                TokenKind::Float => match integral(text) {
                    Some(digits) => (digits.to_string(), "`float`", "`int`"),
                    None => continue,
                },
                _ => continue,
            };
            let edit = Edit::replace(span, other.clone());
            if is == "`int`" {
                ints.push(edit.clone());
            }
            let message = format!(
                "expected {needs}, found {is} `{text}` in macro `{}`",
                d.name
            );
            let found = Diagnostic::error(error::INT_FLOAT_MIX, span, message)
                .mark(format!("used as {needs}"))
                .note("GLSL ES has no implicit conversions (section 4.1.10)");
            all.push(d.candidate(found, Fix::safe(format!("use `{other}`"), vec![edit])));
            if ints.len() >= MAX_NUMBERS {
                break;
            }
        }
        let Some(first) = ints.first().filter(|_| ints.len() > 1) else {
            return;
        };
        let message = format!(
            "expected `float`, found `int` literals in macro `{}`",
            d.name
        );
        let found = Diagnostic::error(error::INT_FLOAT_MIX, first.span, message)
            .mark("used as `float`")
            .note("GLSL ES has no implicit conversions (section 4.1.10)");
        all.push(d.candidate(found, Fix::safe("add `.0` to each of them", ints)));
    }

    /// An undeclared name in the body that is probably a misspelled parameter.
    pub(super) fn misspelled_params(&self, d: &Definition, all: &mut Vec<RepairCandidate>) {
        let Some(params) = &d.of.params else { return };
        let is_used = |index: usize| d.of.body.iter().any(|p| p.token.expansion == index as u32);
        let undeclared = |e: &&Diagnostic| {
            e.is(error::UNDECLARED_NAME) && e.macros.iter().any(|m| m.definition == d.of.name_span)
        };
        for e in self.errors.iter().filter(undeclared).take(4) {
            let word = self.text(e.span);
            let is_name = |p: &&shaderlint_syntax::Piece| self.text(p.token.span) == word;
            let edits = |name: &str| -> Vec<Edit> {
                let places = d.of.body.iter().filter(is_name);
                places.map(|p| Edit::replace(p.token.span, name)).collect()
            };
            let mut order: Vec<(usize, usize)> = (0..params.len())
                .filter_map(|i| {
                    let name = self.program.names.text(*params.get(i)?);
                    let distance = strsim::damerau_levenshtein(name, word);
                    Some((distance + 3 * is_used(i) as usize, i))
                })
                .collect();
            order.sort_unstable();
            for (_, index) in order.into_iter().take(3) {
                let Some(param) = params.get(index) else {
                    continue;
                };
                let name = self.program.names.text(*param);
                let mut found = e.clone();
                found.notes.clear();
                found.help.clear();
                let found = found.note(format!("macro `{}` has no such parameter", d.name));
                let fix = Fix::suggestion(format!("did you mean `{name}`?"), edits(name));
                all.push(d.candidate(found, fix));
            }
        }
    }

    /// `#define PI` without a value, used where one is needed.
    pub(super) fn empty_body(&self, d: &Definition, all: &mut Vec<RepairCandidate>) {
        if !d.of.body.is_empty() || d.of.params.is_some() {
            return;
        }
        let plain: String = d.name.chars().filter(char::is_ascii_alphanumeric).collect();
        let plain = plain.to_ascii_lowercase();
        let known = KNOWN_VALUES.iter().find(|(name, _)| *name == plain);
        let values = known.into_iter().map(|(_, value)| *value);
        for value in values.chain([
            "1.0",
            "1",
            "true",
            "vec2(1.0)",
            "vec3(1.0)",
            "vec4(1.0)",
            "1u",
            "ivec2(1)",
        ]) {
            let end = d.of.name_span.end;
            let found = d
                .faulty(d.of.name_span, format!("macro `{}` has no value", d.name))
                .mark("expands to nothing");
            let title = match known {
                Some((_, known)) if *known == value => format!("define it as `{value}`"),
                _ => format!("give it a value, such as `{value}`"),
            };
            let fix = Fix::suggestion(title, vec![Edit::insert(end, format!(" {value}"))]);
            all.push(d.candidate(found, fix));
        }
    }
}

/// Whether a definition divides literals: as floats, they would have another quotient.
fn divides_integers(d: &Definition) -> bool {
    let mut three = d.of.body.windows(3);
    three.any(|pieces| {
        let kinds = pieces.iter().map(|piece| piece.token.kind);
        kinds.eq([TokenKind::Int, TokenKind::Slash, TokenKind::Int])
    })
}

/// The digits of a float literal with an integer value.
fn integral(text: &str) -> Option<&str> {
    let digits = text.trim_end_matches(['f', 'F']);
    let (digits, rest) = digits.split_once('.')?;
    let is_integer = !digits.is_empty() && rest.bytes().all(|b| b == b'0');
    is_integer.then_some(digits)
}
