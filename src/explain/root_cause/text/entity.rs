//! Characters that a web page spells as entities: `i &lt; 4`.

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_text::markup;

/// Longest name of an entity.
const MAX_LENGTH: usize = 8;
/// An `&` that was escaped.
const TWICE: &str = "&amp;";
/// Maximum number of entities that are replaced.
const MAX_ENTITIES: usize = 2_000;

impl FaultyShader<'_> {
    /// All entities of the text are replaced together.
    pub(super) fn entities(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let (first, _) = entities(line.text).next()?;
        let code = self.program.sources.code_at(line.start)?;
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
            return None;
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
        Some(found)
    }
}

/// The entities of a text with their offsets, also those that were escaped twice (`&amp;lt;`) or lack
/// the `;`.
fn entities(text: &str) -> impl Iterator<Item = (&str, usize)> {
    text.match_indices('&').filter_map(move |(at, _)| {
        let rest = text.get(at..)?;
        let escaped = rest.strip_prefix(TWICE);
        let name = escaped.or(rest.strip_prefix('&'))?;
        let len = name
            .bytes()
            .take(MAX_LENGTH)
            .take_while(|b| b.is_ascii_alphanumeric() || *b == b'#')
            .count();
        let has_end = name.as_bytes().get(len) == Some(&b';');
        let start = rest.len() - name.len();
        let entity = rest.get(..start + len + usize::from(has_end))?;
        // Without the `;`, `a &lt` may be an operator and a name.
        let is_short = |e: &str| matches!(e, "&lt" | "&gt" | "&amp" | "&quot");
        (plain(entity).is_some() && (entity.ends_with(';') || is_short(entity)))
            .then_some((entity, at))
    })
}

/// The character that an entity stands for.
fn plain(entity: &str) -> Option<char> {
    let name = entity.strip_prefix(TWICE).or(entity.strip_prefix('&'))?;
    let name = name.strip_suffix(';').unwrap_or(name);
    if name.is_empty() {
        return entity.starts_with(TWICE).then_some('&');
    }
    Some(match markup::entity(name)? {
        '\u{a0}' => ' ',
        '×' => '*',
        '\u{2212}' => '-',
        c => c,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn html_entities_are_found_and_decoded() {
        let found: String = entities("a &lt; b && c; &#x3E; &amp;&amp; d & e; &unknown;")
            .filter_map(|(text, _)| plain(text))
            .collect();
        assert_eq!(found, "<>&&");
        let twice: Vec<&str> = entities("a &amp;lt; b &lt 2 &amp; c &ampere")
            .map(|e| e.0)
            .collect();
        assert_eq!(twice, ["&amp;lt;", "&lt", "&amp;"]);
    }
}
