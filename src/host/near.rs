//! Error messages for unknown words.

/// The message for a word that is not one of the expected ones, with the most similar of these.
pub fn none_of(word: &str, known: &[&str]) -> String {
    let distances = known
        .iter()
        .map(|k| (strsim::damerau_levenshtein(k, word), *k));
    let near = distances.filter(|(d, _)| *d <= 3).min();
    let near = near.map_or(String::new(), |(_, k)| format!("; did you mean `{k}`?"));
    format!(
        "expected one of `{}`, found `{word}`{near}",
        known.join("`, `")
    )
}
