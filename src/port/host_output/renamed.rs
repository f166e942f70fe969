//! The code of a user with other names for some identifiers, and the positions in it.

use shaderlint_syntax::{Lexer, RawKind};
use std::collections::{BTreeMap, BTreeSet};

/// New names of identifiers.
pub(super) type NewNames = BTreeMap<String, String>;

/// A text in which identifiers were renamed.
pub(super) struct RenamedText {
    pub(super) text: String,
    /// By renamed identifier: its offset and length in the old text, and its length in the new one.
    moves: Vec<(usize, usize, usize)>,
}

impl RenamedText {
    /// Renames all identifiers at once, also in directives.
    pub(super) fn of(old: &str, names: &NewNames) -> RenamedText {
        let (mut text, mut moves, mut from) = (String::new(), Vec::new(), 0);
        for (start, word) in words(old) {
            let Some(new) = names.get(word) else {
                continue;
            };
            text.push_str(old.get(from..start).unwrap_or(""));
            text.push_str(new);
            from = start + word.len();
            moves.push((start, word.len(), new.len()));
        }
        text.push_str(old.get(from..).unwrap_or(""));
        RenamedText { text, moves }
    }

    /// The offset in the old text for one in the new text.
    pub(super) fn old_offset(&self, new: usize) -> usize {
        let mut grown = 0_isize;
        for (start, old_length, new_length) in &self.moves {
            let at = start.saturating_add_signed(grown);
            if new < at {
                break;
            }
            if new < at + new_length {
                return *start;
            }
            grown += *new_length as isize - *old_length as isize;
        }
        new.saturating_add_signed(-grown)
    }
}

/// The words of a text with their offsets, without those in comments.
pub(super) fn words(text: &str) -> Vec<(usize, &str)> {
    let mut lexer = Lexer::new(text, 0);
    let mut found = Vec::new();
    loop {
        let token = lexer.next_token();
        let (start, end) = (token.span.start as usize, token.span.end as usize);
        match token.kind {
            RawKind::End => return found,
            RawKind::Word => found.push((start, text.get(start..end).unwrap_or(""))),
            _ => {}
        }
    }
}

/// A name that is not among the words, based on another one.
pub(super) fn unused(base: &str, taken: &BTreeSet<String>) -> String {
    let mut number = 2;
    loop {
        let name = format!("{base}{number}");
        if !taken.contains(&name) {
            return name;
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_change_at_once() {
        let names: NewNames = [("a", "bb"), ("bb", "a"), ("c", "long")]
            .map(|(old, new)| (old.to_string(), new.to_string()))
            .into();
        let text = "a = bb + c; // a\n#define bb c\nd";
        let renamed = RenamedText::of(text, &names);
        assert_eq!(renamed.text, "bb = a + long; // a\n#define a long\nd");
        for (old, letter) in [(2, '='), (9, 'c'), (10, ';'), (30, 'd')] {
            let new = renamed.text.rfind(letter).unwrap();
            let new = if letter == 'c' { 9 } else { new };
            assert_eq!(renamed.old_offset(new), old, "{letter}");
        }
    }
}
