//! The value of one meaning as an expression of the names of a host: the inverse of reading these
//! names.

use super::meaning::{Feed, FeedRow, Meanings, is_one_name};

/// How a value follows from another one, in lines `VALUE TYPE = OTHER TYPE: EXPRESSION`; `{}` in the
/// expression is the other value.
const DERIVED: &str = include_str!("derivations.txt");

impl Meanings {
    /// A value of a type as an expression of the names that the host sets; `None` if they do not
    /// determine it.
    pub fn expression(&self, feed: Feed, ty: &str) -> Option<String> {
        self.direct(feed, ty).or_else(|| {
            DERIVED.lines().find_map(|way| {
                let (value, other) = way.split_once(" = ")?;
                let own = value.strip_prefix(feed.name())?.strip_prefix(' ')?;
                let (other, form) = other.split_once(": ")?;
                let (from, other) = other.split_once(' ')?;
                let value = self.direct(Feed::named(from).ok()?, other)?;
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
