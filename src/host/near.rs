//! Words that are none of those that may stand somewhere.

/// That a word is none of some words, with the one that was probably meant.
pub fn none_of(word: &str, known: &[&str]) -> String {
    let distances = known
        .iter()
        .map(|k| (strsim::damerau_levenshtein(k, word), *k));
    let near = distances.filter(|(d, _)| *d <= 3).min();
    let near = near.map_or(String::new(), |(_, k)| format!("; did you mean `{k}`?"));
    format!("`{word}` is none of `{}`{near}", known.join("`, `"))
}
