//! Where a script and its shaders disagree.

use shaderlint_script::ScriptPlace;

/// A place where a script and its shaders disagree.
#[derive(Clone, PartialEq, Debug)]
pub struct Breach {
    /// The rule that reports it.
    pub rule: &'static str,
    /// Where.
    pub place: ScriptPlace,
    /// What is wrong.
    pub message: String,
    /// Another place, with its label.
    pub label: Option<(ScriptPlace, String)>,
    /// The evidence.
    pub note: Option<String>,
    /// What to do.
    pub help: Option<String>,
}

impl Breach {
    /// A breach of a rule at a place.
    pub fn new(rule: &'static str, place: ScriptPlace, message: String) -> Breach {
        Breach {
            rule,
            place,
            message,
            label: None,
            note: None,
            help: None,
        }
    }

    /// With another place.
    pub fn label(mut self, place: Option<ScriptPlace>, text: impl Into<String>) -> Breach {
        self.label = place.map(|place| (place, text.into()));
        self
    }

    /// With the evidence.
    pub fn note(mut self, note: impl Into<String>) -> Breach {
        self.note = Some(note.into());
        self
    }

    /// With advice.
    pub fn help(mut self, help: Option<String>) -> Breach {
        self.help = help;
        self
    }
}

/// The name of the uniform that `lights[0].color` is a part of.
pub fn base(name: &str) -> &str {
    name.split(['[', '.']).next().unwrap_or(name)
}

/// The name among some that another looks like.
pub fn nearest<'n>(name: &str, all: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let lower = name.to_ascii_lowercase();
    let limit = if name.len() < 6 { 1 } else { 2 };
    let near = all.filter_map(|other| {
        let of = other.to_ascii_lowercase();
        let distance = strsim::damerau_levenshtein(&lower, &of);
        // `time` for `uTime`
        let is_same = strip(name).eq_ignore_ascii_case(strip(other));
        (distance <= limit || is_same).then_some((distance, other))
    });
    near.min().map(|(_, other)| other)
}

/// A name without the letter that marks its kind.
fn strip(name: &str) -> &str {
    let mut chars = name.char_indices();
    let first = chars.next().map_or(' ', |(_, c)| c);
    match chars.next() {
        Some((at, c)) if first.is_ascii_lowercase() && c.is_ascii_uppercase() => {
            name.get(at..).unwrap_or(name)
        }
        Some((at, '_')) if first.is_ascii_lowercase() => name.get(at + 1..).unwrap_or(name),
        _ => name,
    }
}
