//! How a pass of a whole shader is drawn, where that is not one triangle over the picture, in bytes.

use serde::Serialize;
use std::sync::Arc;

/// How a pass is drawn.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct PassDraw {
    /// The width and height of what it draws into; without them those of the picture.
    pub size: Option<[SizeTerm; 2]>,
    /// Whether it draws into floats.
    pub is_float: bool,
    /// The other shader of the pair, where the text brings it: for a fragment shader the vertex
    /// shader.
    pub partner: Option<Arc<str>>,
    /// Whether the text is a vertex shader that is run for many numbered vertices.
    pub has_vertices: bool,
}

/// A size, as a term of the picture's size and of what the user sets.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[serde(untagged)]
pub enum SizeTerm {
    /// A number.
    Number(f64),
    /// `$WIDTH` and `$HEIGHT` of the picture, or a control.
    Name(String),
    /// A function of terms, by its name in the player.
    Call(&'static str, Vec<SizeTerm>),
}

/// The functions of terms, with how many terms each takes at least and at most.
const FUNCTIONS: &[(&str, usize, usize)] = &[
    ("floor", 1, 1),
    ("ceil", 1, 1),
    ("round", 1, 1),
    ("trunc", 1, 1),
    ("abs", 1, 1),
    ("sqrt", 1, 1),
    ("exp", 1, 1),
    ("log", 1, 1),
    ("log2", 1, 1),
    ("sin", 1, 1),
    ("cos", 1, 1),
    ("pow", 2, 2),
    ("min", 1, 8),
    ("max", 1, 8),
];

/// How deep terms may stand in each other.
const MAX_DEPTH: usize = 32;

impl SizeTerm {
    /// Reads a term like `max($WIDTH * 0.5, 1)`. Gives the part that cannot be read.
    ///
    /// # Errors
    /// Where it is none.
    pub fn read(text: &str) -> Result<SizeTerm, String> {
        let mut reader = DrawReader {
            rest: text.trim_start(),
            depth: 0,
        };
        let term = reader.sum().ok_or_else(|| reader.rest.to_string())?;
        match reader.rest.is_empty() {
            true => Ok(term),
            false => Err(reader.rest.to_string()),
        }
    }
}

struct DrawReader<'t> {
    rest: &'t str,
    depth: usize,
}

impl<'t> DrawReader<'t> {
    fn take(&mut self, sign: char) -> bool {
        let Some(rest) = self.rest.strip_prefix(sign) else {
            return false;
        };
        self.rest = rest.trim_start();
        true
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> &'t str {
        let end = self.rest.find(|c| !wanted(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at_checked(end).unwrap_or(("", self.rest));
        self.rest = rest.trim_start();
        word
    }

    fn sum(&mut self) -> Option<SizeTerm> {
        self.chain(&[('+', "add"), ('-', "subtract")], DrawReader::product)
    }

    fn product(&mut self) -> Option<SizeTerm> {
        let signs = [('*', "multiply"), ('/', "divide"), ('%', "modulo")];
        self.chain(&signs, DrawReader::factor)
    }

    /// Terms with operators of one rank between them.
    fn chain(
        &mut self,
        signs: &[(char, &'static str)],
        next: fn(&mut Self) -> Option<SizeTerm>,
    ) -> Option<SizeTerm> {
        let mut term = next(self)?;
        while let Some((_, name)) = signs.iter().find(|(sign, _)| self.take(*sign)) {
            term = SizeTerm::Call(name, vec![term, next(self)?]);
        }
        Some(term)
    }

    fn factor(&mut self) -> Option<SizeTerm> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return None;
        }
        let term = match self.take('-') {
            true => SizeTerm::Call("subtract", vec![SizeTerm::Number(0.0), self.factor()?]),
            false => self.primary()?,
        };
        self.depth -= 1;
        match self.take('^') {
            true => Some(SizeTerm::Call("pow", vec![term, self.factor()?])),
            false => Some(term),
        }
    }

    fn primary(&mut self) -> Option<SizeTerm> {
        if self.take('(') {
            let term = self.sum()?;
            return self.take(')').then_some(term);
        }
        if self.take('$') {
            let name = self.take_while(|c| c.is_alphanumeric() || c == '_');
            return (!name.is_empty()).then(|| {
                SizeTerm::Name(match name {
                    "WIDTH" | "HEIGHT" => format!("${name}"),
                    name => name.to_string(),
                })
            });
        }
        if self
            .rest
            .starts_with(|c: char| c.is_ascii_digit() || c == '.')
        {
            let number = self.take_while(|c| c.is_ascii_digit() || c == '.');
            return number.parse().ok().map(SizeTerm::Number);
        }
        let before = self.rest;
        let name = self.take_while(|c| c.is_alphanumeric() || c == '_');
        let found = FUNCTIONS.iter().find(|(own, ..)| *own == name);
        let Some((name, least, most)) = found.filter(|_| self.take('(')) else {
            self.rest = before;
            return None;
        };
        let mut terms = vec![self.sum()?];
        while self.take(',') {
            terms.push(self.sum()?);
        }
        let fits = (*least..=*most).contains(&terms.len());
        (self.take(')') && fits).then_some(SizeTerm::Call(name, terms))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let read = match SizeTerm::read(text) {
            Ok(term) => serde_json::to_string(&term).unwrap(),
            Err(rest) => format!("at `{rest}`"),
        };
        assert_eq!(read, expected, "{text}");
    }

    #[test]
    fn terms_are_read() {
        check("$WIDTH", r#""$WIDTH""#);
        check("16", "16.0");
        check("$WIDTH / 2", r#"["divide",["$WIDTH",2.0]]"#);
        check(
            "max($HEIGHT*(1.0-$blur)/2, 1)",
            r#"["max",[["divide",[["multiply",["$HEIGHT",["subtract",[1.0,"blur"]]]],2.0]],1.0]]"#,
        );
        check("1+2*3", r#"["add",[1.0,["multiply",[2.0,3.0]]]]"#);
        check("2^-$n", r#"["pow",[2.0,["subtract",[0.0,"n"]]]]"#);
    }

    #[test]
    fn what_is_no_term_is_named() {
        check("", "at ``");
        check("$WIDTH / fetch(1)", "at `fetch(1)`");
        check("floor(1, 2)", "at ``");
        check("1 2", "at `2`");
        check("WIDTH", "at `WIDTH`");
        assert!(SizeTerm::read(&"(".repeat(100_000)).is_err());
        assert!(SizeTerm::read(&"-".repeat(100_000)).is_err());
    }
}
