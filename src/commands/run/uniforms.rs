//! Parses the JSON file of uniform values.

use serde_json::value::RawValue;
use std::collections::BTreeMap;

const MAX_DEPTH: usize = 16;

/// A uniform and its value.
#[derive(Clone, PartialEq, Debug)]
pub struct Assignment {
    /// Name, as `getUniformLocation` accepts it.
    pub name: String,
    /// Scalars of the value, in order.
    pub scalars: Vec<f64>,
    /// Position of the value: line and column, from 1.
    pub at: (usize, usize),
}

/// An error in the JSON.
#[derive(Clone, PartialEq, Debug)]
pub struct BadUniforms {
    /// Position of the error: line and column, from 1.
    pub at: (usize, usize),
    /// Description of the error.
    pub message: String,
}

/// A value; nested values are parsed on demand.
enum GivenValue<'t> {
    Number(f64),
    Truth(bool),
    List(Vec<&'t RawValue>),
    Members(BTreeMap<String, &'t RawValue>),
}

/// Parses the uniform values.
///
/// # Errors
/// The first value that is not valid.
pub fn read(text: &str) -> Result<Vec<Assignment>, BadUniforms> {
    let members: BTreeMap<String, &RawValue> =
        serde_json::from_str(text).map_err(|error| BadUniforms {
            at: (error.line().max(1), error.column().max(1)),
            message: match error.classify() {
                serde_json::error::Category::Data => {
                    "expected an object of uniforms, such as {\"speed\": 2}".to_string()
                }
                _ => plain(&error),
            },
        })?;
    let mut found = Vec::new();
    for (name, value) in members {
        add(text, name, value, 0, &mut found)?;
    }
    Ok(found)
}

/// The message of a JSON error without its position, which is printed separately.
fn plain(error: &serde_json::Error) -> String {
    let words = error.to_string();
    match words.rsplit_once(" at line ") {
        Some((words, _)) => words.to_string(),
        None => words,
    }
}

/// Adds a value, or the values of its members.
fn add(
    text: &str,
    name: String,
    raw: &RawValue,
    depth: usize,
    found: &mut Vec<Assignment>,
) -> Result<(), BadUniforms> {
    let at = place(text, raw);
    let wrong = |message: String| BadUniforms { at, message };
    let scalars = match given(raw).filter(|_| depth < MAX_DEPTH) {
        Some(GivenValue::Members(members)) => {
            for (member, value) in members {
                add(text, format!("{name}.{member}"), value, depth + 1, found)?;
            }
            return Ok(());
        }
        Some(GivenValue::List(items)) if items.iter().any(|i| holds_members(i)) => {
            for (item, i) in items.into_iter().zip(0..) {
                add(text, format!("{name}[{i}]"), item, depth + 1, found)?;
            }
            return Ok(());
        }
        Some(GivenValue::List(items)) => {
            let mut scalars = Vec::new();
            for item in items {
                flatten(item, depth + 1, &mut scalars)
                    .ok_or_else(|| wrong(format!("`{name}`: {NO_VALUE}")))?;
            }
            scalars
        }
        Some(GivenValue::Number(number)) => vec![number],
        Some(GivenValue::Truth(truth)) => vec![f64::from(u8::from(truth))],
        None => return Err(wrong(format!("`{name}`: {NO_VALUE}"))),
    };
    found.push(Assignment { name, scalars, at });
    Ok(())
}

const NO_VALUE: &str = "expected a number, a boolean or an array of these";

fn given(raw: &RawValue) -> Option<GivenValue<'_>> {
    let text = raw.get();
    match text.bytes().next()? {
        b'[' => serde_json::from_str(text).ok().map(GivenValue::List),
        b'{' => serde_json::from_str(text).ok().map(GivenValue::Members),
        b't' | b'f' => serde_json::from_str(text).ok().map(GivenValue::Truth),
        _ => serde_json::from_str(text).ok().map(GivenValue::Number),
    }
}

fn holds_members(raw: &RawValue) -> bool {
    raw.get().starts_with('{')
}

/// The scalars of nested arrays, flattened.
fn flatten(raw: &RawValue, depth: usize, scalars: &mut Vec<f64>) -> Option<()> {
    if depth >= MAX_DEPTH {
        return None;
    }
    match given(raw)? {
        GivenValue::Number(number) => scalars.push(number),
        GivenValue::Truth(truth) => scalars.push(f64::from(u8::from(truth))),
        GivenValue::List(items) => {
            for item in items {
                flatten(item, depth + 1, scalars)?;
            }
        }
        GivenValue::Members(_) => return None,
    }
    Some(())
}

/// Line and column of a value, which is a slice of the text.
fn place(text: &str, raw: &RawValue) -> (usize, usize) {
    let offset = (raw.get().as_ptr() as usize).wrapping_sub(text.as_ptr() as usize);
    let before = text.get(..offset).unwrap_or("");
    let line = before.rsplit('\n').next().unwrap_or("");
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &[(&str, &[f64])]) {
        let read = read(text).unwrap();
        let found: Vec<(&str, &[f64])> = read
            .iter()
            .map(|a| (a.name.as_str(), &a.scalars[..]))
            .collect();
        assert_eq!(found, expected, "{text}");
    }

    #[track_caller]
    fn refuse(text: &str, at: (usize, usize), words: &str) {
        let bad = read(text).unwrap_err();
        assert_eq!(bad.at, at, "{}", bad.message);
        assert!(bad.message.contains(words), "{}", bad.message);
    }

    #[test]
    fn numbers_booleans_and_arrays_are_read() {
        check("{}", &[]);
        check(
            r#"{"a": 1.5, "b": true, "c": [1, -2e3], "d": [[1, 0], [0, 1]], "e": [true, false]}"#,
            &[
                ("a", &[1.5]),
                ("b", &[1.0]),
                ("c", &[1.0, -2000.0]),
                ("d", &[1.0, 0.0, 0.0, 1.0]),
                ("e", &[1.0, 0.0]),
            ],
        );
        check(r#"{"u": 4294967295}"#, &[("u", &[4_294_967_295.0])]);
    }

    #[test]
    fn members_of_structs_are_read() {
        check(
            r#"{"lights": [{"at": [0, 1, 2]}, {"at": [3, 4, 5], "on": false}], "fog.far": 9}"#,
            &[
                ("fog.far", &[9.0]),
                ("lights[0].at", &[0.0, 1.0, 2.0]),
                ("lights[1].at", &[3.0, 4.0, 5.0]),
                ("lights[1].on", &[0.0]),
            ],
        );
    }

    #[test]
    fn invalid_uniforms_are_reported_with_their_position() {
        refuse("[1]", (1, 1), "expected an object of uniforms");
        refuse("{\n  \"a\": \"x\"\n}", (2, 8), "`a`: expected a number");
        refuse("{\n  \"a\": [1, null]\n}", (2, 8), "`a`: expected a number");
        refuse("{\"a\": 1,\n}", (2, 1), "trailing comma");
        let deep = format!("{{\"a\": {}{}}}", "[".repeat(40), "]".repeat(40));
        assert!(read(&deep).is_err());
    }
}
