//! Errors in a configuration, and their messages.

use std::ops::Range;
use toml::Spanned;

/// An error at a range of bytes.
pub struct Mistake {
    /// Range of bytes in the configuration.
    pub span: Range<usize>,
    /// Message without position.
    pub message: String,
}

impl Mistake {
    /// An error at the position of a value.
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

/// Rewords messages of serde, which are only available as text. Unknown ones stay.
fn in_own_words(message: &str) -> String {
    let (wrong, expected) = message.rsplit_once(", expected ").unwrap_or((message, ""));
    let (kind, found) = wrong.split_once(" `").unwrap_or((wrong, ""));
    let found = found.strip_suffix('`').unwrap_or(found);
    let known: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    let type_of = |expected| match expected {
        "a sequence" => "a list: `[...]`",
        "a map" => "a table",
        "a boolean" => "`true` or `false`",
        "u64" => "a non-negative integer",
        "f64" => "a non-negative number",
        other => other,
    };
    match kind {
        "unknown field" => unknown_key(found, &known),
        "unknown variant" => none_of(found, &known),
        // No other key is required.
        "missing field" => {
            format!("an override requires `{found}`; add `{found} = [\"legacy/**\"]`")
        }
        "wanted string or table" => "expected a string".to_string(),
        _ if kind.starts_with("invalid type: ") || kind.starts_with("invalid value: ") => {
            format!("expected {}", type_of(expected))
        }
        _ => message.lines().collect::<Vec<_>>().join("; "),
    }
}

/// The message about an unknown key.
pub fn unknown_key(name: &str, known: &[&str]) -> String {
    match near(name, known) {
        Some(near) => format!("unknown key `{name}`; did you mean `{near}`?"),
        None => format!(
            "unknown key `{name}`; expected one of `{}`",
            known.join("`, `")
        ),
    }
}

/// The message about an unknown value.
pub fn none_of(word: &str, known: &[&str]) -> String {
    let near = near(word, known).map_or(String::new(), |n| format!("; did you mean `{n}`?"));
    format!(
        "unknown value `{word}`; expected one of `{}`{near}",
        known.join("`, `")
    )
}

fn near<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let distances = known
        .iter()
        .map(|k| (strsim::damerau_levenshtein(k, name), *k));
    distances.filter(|(d, _)| *d <= 3).min().map(|(_, k)| k)
}
