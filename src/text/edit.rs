//! Replacements of text.

use super::Span;
use serde::{Deserialize, Serialize};

/// Replaces the text under `span` with `text`; an empty span inserts.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Edit {
    /// The replaced text.
    pub span: Span,
    /// The replacement.
    pub text: String,
}

impl Edit {
    /// Replaces the text under `span`.
    pub fn replace(span: Span, text: impl Into<String>) -> Edit {
        Edit {
            span,
            text: text.into(),
        }
    }

    /// Inserts `text` at an address.
    pub fn insert(address: u32, text: impl Into<String>) -> Edit {
        Edit {
            span: Span::at(address),
            text: text.into(),
        }
    }

    /// Inserts texts before and after the text under `span`.
    pub fn around(span: Span, before: impl Into<String>, after: impl Into<String>) -> Vec<Edit> {
        vec![
            Edit::insert(span.start, before),
            Edit::insert(span.end, after),
        ]
    }

    /// Deletes the text under `span`.
    pub fn delete(span: Span) -> Edit {
        Edit {
            span,
            text: String::new(),
        }
    }
}

/// Why a set of edits cannot be applied.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EditError {
    /// Two edits change the same characters, or insert at the same position.
    Overlap(Span, Span),
    /// An edit is outside of the text, or splits a character.
    OutOfText(Span),
}

/// Applies edits, given in any order, to the file text that starts at address `base`.
pub fn apply_edits(text: &str, base: u32, edits: &[Edit]) -> Result<String, EditError> {
    let mut sorted: Vec<&Edit> = edits.iter().collect();
    sorted.sort_by_key(|e| e.span);
    let mut out = String::with_capacity(text.len());
    let mut done = base;
    let mut last: Option<Span> = None;
    for edit in sorted {
        if let Some(last) = last
            && (edit.span.start < last.end || edit.span == last)
        {
            return Err(EditError::Overlap(last, edit.span));
        }
        out.push_str(
            between(text, base, done, edit.span.start).ok_or(EditError::OutOfText(edit.span))?,
        );
        between(text, base, edit.span.start, edit.span.end)
            .ok_or(EditError::OutOfText(edit.span))?;
        out.push_str(&edit.text);
        done = edit.span.end;
        last = Some(edit.span);
    }
    let end = base + text.len() as u32;
    out.push_str(between(text, base, done, end).ok_or(EditError::OutOfText(Span::new(done, end)))?);
    Ok(out)
}

fn between(text: &str, base: u32, from: u32, to: u32) -> Option<&str> {
    text.get(from.checked_sub(base)? as usize..to.checked_sub(base)? as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_applied_in_text_order() {
        let edits = [
            Edit::insert(13, "!"),
            Edit::replace(Span::new(10, 11), "A"),
            Edit::delete(Span::new(11, 12)),
        ];
        assert_eq!(apply_edits("abc", 10, &edits).as_deref(), Ok("Ac!"));
    }

    #[test]
    fn overlapping_edits_are_refused() {
        let edits = [Edit::delete(Span::new(0, 2)), Edit::delete(Span::new(1, 3))];
        assert_eq!(
            apply_edits("abc", 0, &edits),
            Err(EditError::Overlap(Span::new(0, 2), Span::new(1, 3)))
        );
        assert!(apply_edits("abc", 0, &[Edit::insert(1, "x"), Edit::insert(1, "y")]).is_err());
    }

    #[test]
    fn edits_outside_the_text_are_refused() {
        assert!(apply_edits("é", 0, &[Edit::delete(Span::new(0, 1))]).is_err());
        assert!(apply_edits("a", 0, &[Edit::insert(5, "x")]).is_err());
    }
}
