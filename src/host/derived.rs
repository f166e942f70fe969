//! The value of one meaning as an expression of the names of a host: the inverse of reading these
//! names.

use super::meaning::{Feed, FeedRow, Meanings, is_one_name};

/// How a value follows from another one: the value, its type, the other value, its type, and the
/// expression, in which `{}` is the other value.
const DERIVED: &[(Feed, &str, Feed, &str, &str)] = {
    use Feed::*;
    &[
        (Milliseconds, "float", Time, "float", "1000.0 * {}"),
        (Time, "float", Milliseconds, "float", "{} / 1000.0"),
        (FrameFromOne, "int", Frame, "int", "{} + 1"),
        (Frame, "int", FrameFromOne, "int", "{} - 1"),
        (
            Date,
            "vec4",
            DateFromOne,
            "vec4",
            "{} - vec4(0.0, 1.0, 0.0, 0.0)",
        ),
        (
            DateFromOne,
            "vec4",
            Date,
            "vec4",
            "{} + vec4(0.0, 1.0, 0.0, 0.0)",
        ),
        (Width, "float", Resolution, "vec2", "{}.x"),
        (Height, "float", Resolution, "vec2", "{}.y"),
        (Aspect, "float", Resolution, "vec2", "{}.x / {}.y"),
        (Pixel, "vec2", Resolution, "vec2", "1.0 / {}"),
        (
            ResolutionAndPixel,
            "vec4",
            Resolution,
            "vec2",
            "vec4({}, 1.0 / {})",
        ),
        (
            PointerUnit,
            "vec2",
            PointerUnitDown,
            "vec2",
            "vec2({}.x, 1.0 - {}.y)",
        ),
        (
            PointerUnitDown,
            "vec2",
            PointerUnit,
            "vec2",
            "vec2({}.x, 1.0 - {}.y)",
        ),
        (PointerSigned, "vec2", PointerUnit, "vec2", "2.0 * {} - 1.0"),
    ]
};

impl Meanings {
    /// A value of a type as an expression of the names that the host sets; `None` if they do not
    /// determine it.
    pub fn expression(&self, feed: Feed, ty: &str) -> Option<String> {
        self.direct(feed, ty).or_else(|| {
            let mut ways = DERIVED.iter().filter(|way| way.0 == feed);
            ways.find_map(|(_, own, from, other, form)| {
                let value = self.direct(*from, other)?;
                converted(&form.replace("{}", &value), own, feed, ty)
            })
        })
    }

    /// The name that has a value itself, converted to a type.
    fn direct(&self, feed: Feed, ty: &str) -> Option<String> {
        let is_it = |r: &&FeedRow| r.feed == feed && is_one_name(&r.name);
        let mut rows = self.feeds.iter().filter(is_it);
        rows.find_map(|row| converted(&row.name, row.types.first()?, feed, ty))
    }
}

/// The scalar type and the number of components of a type; `None` for matrices and arrays.
fn shape(ty: &str) -> Option<(&'static str, usize)> {
    const VECTORS: [(&str, &str); 3] = [("vec", "float"), ("ivec", "int"), ("uvec", "uint")];
    let scalar = ["float", "int", "uint"].into_iter().find(|s| *s == ty);
    scalar.map(|s| (s, 1)).or_else(|| {
        let (_, scalar) = VECTORS
            .iter()
            .find(|(v, _)| ty.strip_suffix(['2', '3', '4']) == Some(v))?;
        Some((*scalar, ty.chars().last()?.to_digit(10)? as usize))
    })
}

/// An expression converted from a type to another. Only a size has a known third component: the
/// pixel aspect ratio.
fn converted(expression: &str, from: &str, feed: Feed, to: &str) -> Option<String> {
    if from == to {
        return Some(expression.to_string());
    }
    let ((scalar, count), (target, needed)) = (shape(from)?, shape(to)?);
    let is_name = expression
        .chars()
        .all(|c| c.is_ascii_alphanumeric() || c == '_');
    let inner = match is_name {
        true => expression.to_string(),
        false => format!("({expression})"),
    };
    match needed {
        _ if needed == count => Some(format!("{to}({expression})")),
        _ if needed < count && scalar == target => {
            Some(format!("{inner}.{}", "xyzw".get(..needed)?))
        }
        _ if needed < count => Some(format!("{to}({inner}.{})", "xyzw".get(..needed)?)),
        3 if count == 2 && feed == Feed::Resolution => Some(format!("{to}({expression}, 1.0)")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::{Feed, preset};

    /// Each case is a host, a meaning, a type, and the expression.
    #[test]
    fn missing_values_are_derived_from_names_of_the_host() {
        for case in include_str!("derived.txt").lines().skip(1) {
            let (given, expected) = case.split_once(" ⇒ ").unwrap();
            let [host, feed, ty] = given.split(' ').collect::<Vec<_>>()[..] else {
                panic!("{case}");
            };
            let feed = Feed::ALL.iter().find(|f| f.name() == feed).expect(case);
            let found = preset(host).unwrap().meanings.expression(*feed, ty);
            assert_eq!(found.as_deref().unwrap_or("none"), expected, "{case}");
        }
    }
}
