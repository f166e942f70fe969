//! Misspelt words.

/// Whether a word is another one in other capitals, or with two neighbouring letters swapped: a mistake that
/// makes no other word of a short one.
pub fn is_respelled(word: &str, right: &str) -> bool {
    if word.len() != right.len() {
        return false;
    }
    let [mut word, right] = [word, right].map(|w| w.to_ascii_lowercase().into_bytes());
    word == right
        || (1..word.len()).any(|at| {
            word.swap(at - 1, at);
            let is_same = word == right;
            word.swap(at - 1, at);
            is_same
        })
}
