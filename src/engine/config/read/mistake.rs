//! What is wrong with a configuration, and the words for it.

use std::ops::Range;
use toml::Spanned;

/// An error at a range of bytes.
pub struct Mistake {
    /// Where.
    pub span: Range<usize>,
    /// What is wrong.
    pub message: String,
}

impl Mistake {
    /// That something is wrong with this.
    pub fn at<T>(place: &Spanned<T>, message: String) -> Mistake {
        Mistake {
            span: place.span(),
            message,
        }
    }
}

impl From<toml::de::Error> for Mistake {
    fn from(error: toml::de::Error) -> Mistake {
        Mistake {
            span: error.span().unwrap_or_default(),
            message: in_own_words(error.message()),
        }
    }
}

/// What serde says, as this program says it: its errors are texts alone. Others stay.
fn in_own_words(message: &str) -> String {
    let (wrong, expected) = message.rsplit_once(", expected ").unwrap_or((message, ""));
    let (kind, found) = wrong.split_once(" `").unwrap_or((wrong, ""));
    let found = found.strip_suffix('`').unwrap_or(found);
    let known: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    let type_of = |expected| match expected {
        "a string" => "a text in quotes",
        "a sequence" => "a list: `[...]`",
        "a map" => "a table",
        "a boolean" => "`true` or `false`",
        "u64" => "a whole number, 0 or more",
        "f64" => "a number, 0 or more",
        other => other,
    };
    match kind {
        "unknown field" => unknown_key(found, &known),
        "unknown variant" => none_of(found, &known),
        // No other key is needed.
        "missing field" => format!("an override needs `{found}`: `{found} = [\"legacy/**\"]`"),
        "wanted string or table" => "this must be a text in quotes".to_string(),
        _ if kind.starts_with("invalid type: ") || kind.starts_with("invalid value: ") => {
            format!("this must be {}", type_of(expected))
        }
        _ => message.lines().collect::<Vec<_>>().join("; "),
    }
}

/// That there is no such key.
pub fn unknown_key(name: &str, known: &[&str]) -> String {
    match near(name, known) {
        Some(near) => format!("unknown key `{name}`; did you mean `{near}`?"),
        None => format!("unknown key `{name}`; there are `{}`", known.join("`, `")),
    }
}

/// That this is none of some words.
pub fn none_of(word: &str, known: &[&str]) -> String {
    let near = near(word, known).map_or(String::new(), |n| format!("; did you mean `{n}`?"));
    format!("`{word}` is none of `{}`{near}", known.join("`, `"))
}

fn near<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let distances = known
        .iter()
        .map(|k| (strsim::damerau_levenshtein(k, name), *k));
    distances.filter(|(d, _)| *d <= 3).min().map(|(_, k)| k)
}
