//! How a pass that is a complete shader is drawn, if not as one triangle over the image in bytes.

use serde::Serialize;
use std::sync::Arc;

/// Draw settings of a pass.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct PassDraw {
    /// Width and height of the target; `None` is the size of the image.
    pub size: Option<[SizeTerm; 2]>,
    /// Whether the target has float components.
    pub is_float: bool,
    /// The shader of the other stage, if the file provides it: for a fragment shader the vertex
    /// shader.
    pub partner: Option<Arc<str>>,
    /// Whether the text is a vertex shader that runs for many numbered vertices.
    pub has_vertices: bool,
}

/// A size as an expression of the image size and of controls.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[serde(untagged)]
pub enum SizeTerm {
    /// A constant.
    Number(f64),
    /// `$WIDTH` or `$HEIGHT` of the image, or the value of a control.
    Name(String),
    /// A call of a function of the player, by name, with its arguments.
    Call(&'static str, Vec<SizeTerm>),
}

/// The functions, with the minimum and maximum number of arguments.
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

/// Maximum nesting depth of expressions.
const MAX_DEPTH: usize = 32;

impl SizeTerm {
    /// Parses an expression such as `max($WIDTH * 0.5, 1)`.
    ///
    /// # Errors
    /// Returns the rest of the text that cannot be parsed.
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

    fn take_while(&mut self, is_accepted: impl Fn(char) -> bool) -> &'t str {
        let end = self
            .rest
            .find(|c| !is_accepted(c))
            .unwrap_or(self.rest.len());
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

    /// Parses left-associative operators of one precedence level.
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
    use shaderlint_text::each_case;

    #[test]
    fn size_expressions_are_parsed() {
        each_case(include_str!("sizes.txt"), |text, expected| {
            let read = match SizeTerm::read(text) {
                Ok(term) => serde_json::to_string(&term).unwrap(),
                Err(rest) => format!("at `{rest}`"),
            };
            assert_eq!(read, expected, "{text}");
        });
        assert!(SizeTerm::read(&"(".repeat(100_000)).is_err());
        assert!(SizeTerm::read(&"-".repeat(100_000)).is_err());
    }
}
