//! The comments above a test: the values of its parameters, whether it is expected to fail, and its
//! textures.

use shaderlint_text::Span;

/// A piece of a comment.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Marked {
    /// The text.
    pub text: String,
    /// Its span in the file.
    pub at: Span,
}

/// Something that is wrong with the comments or the parameters of a test.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TestProblem {
    /// The span of the mistake.
    pub at: Span,
    /// What is wrong.
    pub message: String,
}

impl TestProblem {
    /// A mistake with a message.
    pub fn new(at: Span, message: impl Into<String>) -> TestProblem {
        TestProblem {
            at,
            message: message.into(),
        }
    }
}

/// The values of a parameter: `// each: x = 0.0, 0.5`.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct EachMark {
    /// The parameter; `None` for the only one.
    pub name: Option<Marked>,
    pub values: Vec<Marked>,
    pub at: Span,
}

/// The interval of a parameter: `// any: x in -10..10`.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct AnyMark {
    pub name: Marked,
    pub low: Marked,
    pub high: Marked,
}

/// A texture of a sampler: `// texture: iChannel0 = brick.png`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextureMark {
    /// Name of the sampler.
    pub sampler: String,
    /// The file, or the buffer and its frame, as written.
    pub source: String,
    /// Span of the source.
    pub at: Span,
}

/// What the comments above a test say.
#[derive(Default, Debug)]
pub(super) struct Marks {
    pub each: Vec<EachMark>,
    pub any: Vec<AnyMark>,
    /// Why the test is expected to fail.
    pub fails: Option<String>,
    pub textures: Vec<TextureMark>,
    pub problems: Vec<TestProblem>,
    /// Where the comments start.
    pub start: usize,
}

/// A text at an address.
#[derive(Clone, Copy)]
struct Part<'t> {
    text: &'t str,
    start: u32,
}

impl<'t> Part<'t> {
    /// A part of the text, which is one of its slices, without white space around it.
    fn within(self, slice: &'t str) -> Part<'t> {
        let trimmed = slice.trim();
        let offset = (trimmed.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize);
        Part {
            text: trimmed,
            start: self.start + offset as u32,
        }
    }

    const fn span(self) -> Span {
        Span::new(self.start, self.start + self.text.len() as u32)
    }

    fn marked(self) -> Marked {
        Marked {
            text: self.text.to_string(),
            at: self.span(),
        }
    }

    /// The content of a comment of its own line such as `// each: 1.0` with this word.
    fn after(self, word: &str) -> Option<Part<'t>> {
        let rest = self.text.trim().strip_prefix("//")?.trim_start();
        let rest = rest.strip_prefix(word)?.strip_prefix(':')?;
        Some(self.within(rest))
    }

    /// The parts between separators that are outside of brackets.
    fn split(self, separator: char) -> Vec<Part<'t>> {
        let mut depth = 0_i32;
        let is_end = |c: char| {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth -= 1,
                _ => {}
            }
            c == separator && depth == 0
        };
        self.text
            .split(is_end)
            .map(|part| self.within(part))
            .collect()
    }

    fn is_name(self) -> bool {
        let mut chars = self.text.chars();
        chars
            .next()
            .is_some_and(|c| c == '_' || c.is_ascii_alphabetic())
            && chars.all(|c| c == '_' || c.is_ascii_alphanumeric())
    }
}

/// The comments directly above the line of an offset in a file.
pub(super) fn marks(text: &str, base: u32, offset: usize) -> Marks {
    let mut found = Marks::default();
    let head = text.get(..offset).unwrap_or("");
    let mut start = head.rfind('\n').map_or(0, |at| at + 1);
    let mut lines = Vec::new();
    while let Some(above) = text.get(..start.saturating_sub(1)).filter(|_| start > 0) {
        let line_start = above.rfind('\n').map_or(0, |at| at + 1);
        let line = above.get(line_start..).unwrap_or("");
        if !line.trim_start().starts_with("//") {
            break;
        }
        lines.push(Part {
            text: line,
            start: base + line_start as u32,
        });
        start = line_start;
    }
    found.start = start;
    for line in lines.into_iter().rev() {
        found.read(line);
    }
    found
}

/// The textures that comments of a file give to all its tests: those that are not directly above a
/// test.
pub(super) fn shared_textures(
    text: &str,
    base: u32,
    is_of_test: impl Fn(usize) -> bool,
) -> (Vec<TextureMark>, Vec<TestProblem>) {
    let mut found = Marks::default();
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let part = Part {
            text: line,
            start: base + offset as u32,
        };
        if !is_of_test(offset)
            && let Some(rest) = part.after("texture")
        {
            found.texture(rest);
        }
        offset += line.len();
    }
    (found.textures, found.problems)
}

impl Marks {
    fn read(&mut self, line: Part<'_>) {
        if let Some(rest) = line.after("each") {
            rest.split(';').into_iter().for_each(|part| self.each(part));
        } else if let Some(rest) = line.after("any") {
            rest.split(';').into_iter().for_each(|part| self.any(part));
        } else if let Some(rest) = line.after("texture") {
            self.texture(rest);
        } else if let Some(rest) = line.after("fails") {
            self.fails = Some(rest.text.to_string());
        }
    }

    fn wrong(&mut self, part: Part<'_>, message: &str) {
        self.problems.push(TestProblem::new(part.span(), message));
    }

    fn each(&mut self, part: Part<'_>) {
        let named = part.text.split_once('=');
        let named = named.map(|(name, values)| (part.within(name), part.within(values)));
        let named = named.filter(|(name, values)| name.is_name() && !values.text.starts_with('='));
        let (name, values) = match named {
            Some((name, values)) => (Some(name.marked()), values),
            None => (None, part),
        };
        let values = values.split(',');
        if values.iter().any(|value| value.text.is_empty()) {
            self.wrong(
                part,
                "expected values: `// each: 0.0, 0.5` or `// each: x = 0.0, 0.5`",
            );
            return;
        }
        self.each.push(EachMark {
            name,
            values: values.into_iter().map(Part::marked).collect(),
            at: part.span(),
        });
    }

    fn any(&mut self, part: Part<'_>) {
        let split = part.text.split_once(" in ");
        let ends = split.and_then(|(name, rest)| Some((name, rest.split_once("..")?)));
        let parts = ends.map(|(name, (low, high))| [name, low, high].map(|p| part.within(p)));
        let is_valid = |[name, low, high]: &[Part<'_>; 3]| {
            name.is_name() && !low.text.is_empty() && !high.text.is_empty()
        };
        match parts.filter(is_valid) {
            Some([name, low, high]) => self.any.push(AnyMark {
                name: name.marked(),
                low: low.marked(),
                high: high.marked(),
            }),
            None => self.wrong(
                part,
                "expected a parameter and an interval: `// any: x in -10..10`",
            ),
        }
    }

    fn texture(&mut self, part: Part<'_>) {
        let split = part.text.split_once('=');
        let parts = split.map(|(name, source)| [name, source].map(|p| part.within(p)));
        match parts.filter(|[name, source]| !name.text.is_empty() && !source.text.is_empty()) {
            Some([name, source]) => self.textures.push(TextureMark {
                sampler: name.text.to_string(),
                source: source.text.to_string(),
                at: source.span(),
            }),
            None => self.wrong(
                part,
                "expected a sampler and a file or buffer: `// texture: iChannel0 = brick.png`",
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_directly_above_a_test_are_read() {
        let text = "// each: 9\n\n// Says why.\n// each: x = vec2(0, 1), vec2(1.0); n = 1, 2\n\
            //any: p in vec3(-5)..vec3(5)\n// fails: too steep\nbool test_x(";
        let found = marks(text, 100, text.len() - 3);
        let each: Vec<_> = found.each.iter().map(|e| e.values.len()).collect();
        assert_eq!(each, [2, 2], "{found:?}");
        let value = &found.each[0].values[0];
        assert_eq!(value.text, "vec2(0, 1)");
        let at = value.at.start as usize - 100;
        assert_eq!(text.get(at..at + 10), Some("vec2(0, 1)"));
        assert_eq!(found.any[0].low.text, "vec3(-5)");
        assert_eq!(found.fails.as_deref(), Some("too steep"));
        assert!(found.problems.is_empty());
    }

    #[test]
    fn malformed_comments_are_reported() {
        for (comment, part) in [
            ("each: 1, , 2", "1, , 2"),
            ("any: x", "x"),
            ("texture: a.png", "a.png"),
        ] {
            let text = format!("// {comment}\nbool test_x(float x)");
            let found = marks(&text, 0, comment.len() + 5);
            assert_eq!(found.problems.len(), 1, "{comment}");
            let at = found.problems[0].at;
            assert_eq!(&text[at.start as usize..at.end as usize], part);
        }
    }
}
