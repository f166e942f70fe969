//! Characters that a web page spells as entities: `i &lt; 4`.

use super::*;
use shaderlint_diagnostic::error;

/// Longest entity, with `&` and `;`.
const MAX_LENGTH: usize = 10;
/// Maximum number of entities that are replaced.
const MAX_ENTITIES: usize = 2_000;

impl FaultyShader<'_> {
    /// All entities of the text are replaced together.
    pub(super) fn entities(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let Some((first, _)) = entities(line.text).next() else {
            return;
        };
        let Some(code) = self.program.sources.code_at(line.start) else {
            return;
        };
        let edit = |(text, at): (&str, usize)| {
            let start = code.base + at as u32;
            let plain = plain(text)?;
            Some(Edit::replace(
                Span::new(start, start + text.len() as u32),
                plain.to_string(),
            ))
        };
        let comments = &self.program.tokens.comments;
        let is_code = |e: &Edit| !comments.iter().any(|c| c.contains(e.span));
        let edits: Vec<Edit> = entities(code.text)
            .filter_map(edit)
            .filter(is_code)
            .take(MAX_ENTITIES)
            .collect();
        let (Some(symbol), Some(place)) = (plain(first), edits.first()) else {
            return;
        };
        let span = place.span;
        let text = self.text(span);
        let message = match plain(text).unwrap_or(symbol) {
            ' ' => format!("unexpected HTML entity `{text}`"),
            symbol => format!("expected `{symbol}`, found HTML entity `{text}`"),
        };
        let number = edits.len();
        let title = match number {
            1 => "replace it with the character".to_string(),
            _ => format!("replace {number} entities with their characters"),
        };
        let mut found = candidate(error::INVALID_CHARACTER, span, message, title, edits);
        let note = "the text contains HTML entities, as in the source of a web page";
        found.diagnostic = found.diagnostic.note(note);
        all.push(found);
    }
}

/// The entities of a text with their offsets.
fn entities(text: &str) -> impl Iterator<Item = (&str, usize)> {
    text.match_indices('&').filter_map(move |(at, _)| {
        let rest = text.get(at..)?;
        let rest = rest.get(..rest.len().min(MAX_LENGTH)).unwrap_or(rest);
        let end = rest.find(';')? + 1;
        let entity = rest.get(..end)?;
        plain(entity).map(|_| (entity, at))
    })
}

/// The character that an entity stands for.
fn plain(entity: &str) -> Option<char> {
    let name = entity.strip_prefix('&')?.strip_suffix(';')?;
    if let Some(digits) = name.strip_prefix('#') {
        let code = match digits.strip_prefix(['x', 'X']) {
            Some(hex) => u32::from_str_radix(hex, 16).ok()?,
            None => digits.parse().ok()?,
        };
        let c = char::from_u32(code)?;
        return Some(if c == '\u{a0}' { ' ' } else { c });
    }
    Some(match name {
        "lt" => '<',
        "gt" => '>',
        "amp" => '&',
        "quot" => '"',
        "apos" => '\'',
        "nbsp" => ' ',
        "times" => '*',
        "minus" => '-',
        "sol" => '/',
        "ast" => '*',
        "num" => '#',
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entities_are_found_with_their_characters() {
        let found: String = entities("a &lt; b && c; &#x3E; &amp;&amp; d & e; &unknown;")
            .filter_map(|(text, _)| plain(text))
            .collect();
        assert_eq!(found, "<>&&");
    }
}
