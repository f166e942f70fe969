//! Formats the shaders of every kind of file: shaders, ShaderToy exports, and embedded shaders.

use shaderlint_detect::embed::{DocumentLanguage, Embedded, Wrapping, extract_named};
use shaderlint_detect::kind::{Claim, Decision, Evidence, FileKind, ShaderLanguage, decide};
use shaderlint_format::{
    Indentation, Lines, Style, StyleChoice, TextExtent, Unformatted, counts_lines,
    format as format_code,
};
use shaderlint_project::Project;
use shaderlint_text::json::{JsonString, strings_in};
use shaderlint_text::{Edit, Span};

/// The result of formatting a file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Formatting {
    /// The edits in source order, with spans relative to the start of the file.
    pub edits: Vec<Edit>,
    /// Shaders that were not formatted, and why.
    pub left: Vec<Unformatted>,
}

/// Formats the shaders of a file.
///
/// # Errors
/// If the file contains no shader, with the reason.
pub fn format(
    name: &str,
    text: &str,
    claim: Claim,
    choice: impl Into<StyleChoice>,
) -> Result<Formatting, Decision> {
    let decision = decide(name, text, claim);
    let choice = choice.into();
    let style = &choice.style();
    let mut formatting = Formatting::default();
    match decision.kind {
        FileKind::Shader | FileKind::Foreign(ShaderLanguage::Desktop) => {
            formatting.shader(text, style);
        }
        FileKind::Holds(language) => formatting.inside(name, language, text, choice),
        FileKind::Export if Project::from_json(text).is_ok() => formatting.export(text, style),
        FileKind::Export => return Err(decision.no_export()),
        FileKind::Foreign(_) | FileKind::Other => return Err(decision),
    }
    Ok(formatting)
}

/// Byte order mark at the start of a file.
const BYTE_ORDER_MARK: char = '\u{feff}';

impl Formatting {
    fn shader(&mut self, text: &str, style: &Style) {
        let code = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
        let before = (text.len() - code.len()) as u32;
        let formatted = format_code(code, style, TextExtent::File, Lines::Free);
        let edits = formatted.edits.into_iter();
        self.edits.extend(edits.map(|e| moved(e, before)));
        self.leave(formatted.left, before);
    }

    /// Reports what was left, in a text that starts at `start`.
    fn leave(&mut self, left: Vec<Unformatted>, start: u32) {
        let left = left.into_iter().map(|why| Unformatted {
            span: moved_span(why.span, start),
            ..why
        });
        self.left.extend(left);
    }

    fn inside(&mut self, name: &str, language: DocumentLanguage, text: &str, choice: StyleChoice) {
        let shaders = extract_named(name, language, text);
        let around = StyleChoice {
            indent: match language {
                DocumentLanguage::Markdown => None,
                _ => indentation_around(&shaders, text),
            },
            ..StyleChoice::default()
        };
        let style = choice.or(around).style();
        for embedded in &shaders {
            let language = Evidence::of(&embedded.code).foreign();
            if language.is_none_or(|language| language == ShaderLanguage::Desktop) {
                self.embedded(embedded, text, &style);
            }
        }
    }

    fn embedded(&mut self, embedded: &Embedded, text: &str, style: &Style) {
        let start = embedded.start as u32;
        let formatted = format_code(&embedded.code, style, TextExtent::Inside, Lines::Free);
        self.leave(formatted.left, start);
        let edits = formatted.edits.into_iter().map(|e| moved(e, start));
        let is_template = embedded.wrapping == Wrapping::Template;
        let edits =
            edits.filter_map(
                |e| match is_template && !embedded.is_verbatim(text, e.span) {
                    true => indentation_after(text, &e),
                    false => Some(e),
                },
            );
        let edits: Vec<Edit> = edits.collect();
        // A shader is skipped completely if the surrounding language would change the meaning of an
        // edit.
        if edits.iter().all(|e| embedded.admits(text, e)) {
            self.edits.extend(edits);
        }
    }

    fn export(&mut self, text: &str, style: &Style) {
        let codes = strings_in(text, "renderpass", "code").unwrap_or_default();
        // A macro of one pass may use the line number of another.
        let lines = match codes.iter().any(|(_, code)| counts_lines(&code.value)) {
            true => Lines::Kept,
            false => Lines::Free,
        };
        for (_, code) in &codes {
            let formatted = format_code(&code.value, style, TextExtent::File, lines);
            let edits: Option<Vec<Edit>> =
                formatted.edits.iter().map(|e| in_json(e, code)).collect();
            self.edits.extend(edits.unwrap_or_default());
            for why in formatted.left {
                let (from, to) = (why.span.start as usize, why.span.end as usize);
                let place = code.place(from, to);
                self.left.push(Unformatted {
                    span: place.map_or(Span::at(0), |p| Span::new(p.start, p.end)),
                    ..why
                });
            }
        }
        self.edits.sort_by_key(|e| e.span);
    }
}

/// Widths of a level of indentation in scripts and pages.
const LEVELS: std::ops::RangeInclusive<usize> = 2..=8;

/// The indentation per level of a file, without the shaders in it: tabs if most indented lines
/// start with one, or else the most frequent step between a line and the next.
fn indentation_around(shaders: &[Embedded], text: &str) -> Option<Indentation> {
    let mut steps = [0u32; *LEVELS.end() + 1];
    let (mut tabs, mut blanks) = (0, 0);
    let (mut start, mut before) = (0, 0);
    let mut shaders = shaders.iter().peekable();
    for line in text.split_inclusive('\n') {
        let at = start;
        start += line.len();
        while shaders.next_if(|shader| shader.end() <= at).is_some() {}
        let is_inside = shaders.peek().is_some_and(|shader| shader.start < at);
        let code = line.trim_start_matches([' ', '\t']);
        if is_inside || code.trim().is_empty() {
            continue;
        }
        let width = line.len() - code.len();
        tabs += u32::from(line.starts_with('\t'));
        blanks += u32::from(line.starts_with(' '));
        let step = width.saturating_sub(before);
        if let Some(count) = steps.get_mut(step).filter(|_| LEVELS.contains(&step)) {
            *count += 1;
        }
        before = width;
    }
    if tabs > blanks {
        return Some(Indentation::Tab(Style::default().indent.width()));
    }
    let most = *steps.iter().max()?;
    let step = steps.iter().position(|count| *count == most)?;
    (most > 0).then_some(Indentation::Spaces(step as u32))
}

/// The remainder of an edit around an interpolation such as `${noise}`, which is kept: only the
/// line after it is indented.
fn indentation_after(text: &str, edit: &Edit) -> Option<Edit> {
    let gap = text.get(edit.span.start as usize..edit.span.end as usize)?;
    let (_, was) = gap.rsplit_once('\n')?;
    let (_, indentation) = edit.text.rsplit_once('\n')?;
    let span = Span::new(edit.span.end - was.len() as u32, edit.span.end);
    (was.trim().is_empty() && was != indentation).then(|| Edit::replace(span, indentation))
}

fn moved_span(span: Span, by: u32) -> Span {
    Span::new(span.start + by, span.end + by)
}

fn moved(edit: Edit, by: u32) -> Edit {
    Edit {
        span: moved_span(edit.span, by),
        ..edit
    }
}

/// An edit of a text as an edit of the JSON string that contains it.
fn in_json(edit: &Edit, code: &JsonString) -> Option<Edit> {
    let place = code.place(edit.span.start as usize, edit.span.end as usize)?;
    Some(Edit::replace(
        Span::new(place.start, place.end),
        code.escape(&edit.text),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::apply_edits;

    /// Each case is a file and its formatted text, which stays as it is; `␂` is a byte order mark.
    #[test]
    fn shaders_in_other_texts_are_formatted() {
        let cases = include_str!("formatted.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let case = case.replace('↵', "\n").replace('␂', "\u{feff}");
            let (name, texts) = case.split_once(": ").unwrap();
            let (text, expected) = texts.split_once(" ⇒ ").unwrap();
            for text in [text, expected] {
                let formatting = format(name, text, Claim::None, &Style::default()).unwrap();
                assert_eq!(formatting.left, [], "{text}");
                let found = apply_edits(text, 0, &formatting.edits);
                assert_eq!(found.as_deref(), Ok(expected), "{text}");
            }
        }
    }

    #[test]
    fn shaders_in_scripts_use_the_indentation_of_the_script() {
        let unset = |name: &str, text: &str| {
            let formatting = format(name, text, Claim::None, StyleChoice::default()).unwrap();
            apply_edits(text, 0, &formatting.edits).unwrap()
        };
        let shader = "void main(){\n      gl_FragColor=vec4(1.0);\n}";
        let two = |shader: &str| {
            format!("function f() {{\n  if (a) {{\n    b();\n  }}\n}}\nconst c = `\n{shader}\n`;\n")
        };
        let expected = "void main() {\n  gl_FragColor = vec4(1.0);\n}";
        assert_eq!(unset("a.js", &two(shader)), two(expected));
        let tab = |shader: &str| {
            format!("class A {{\n\tb() {{\n\t\treturn `\n\t\t{shader}`;\n\t}}\n}}\n")
        };
        let expected = "void main() {\n\t\t\tgl_FragColor = vec4(1.0);\n\t\t}";
        assert_eq!(unset("a.js", &tab(shader)), tab(expected));
        let style = Style::default();
        let formatting = format("a.js", &two(shader), Claim::None, &style).unwrap();
        let formatted = apply_edits(&two(shader), 0, &formatting.edits).unwrap();
        assert_eq!(
            formatted,
            two("void main() {\n    gl_FragColor = vec4(1.0);\n}")
        );
    }

    #[test]
    fn files_without_glsl_are_not_formatted() {
        assert!(format("a.json", "{\"a\": 1}", Claim::None, &Style::default()).is_err());
        let wgsl = "@fragment fn main() -> vec4<f32> {return vec4<f32>(1.0);}";
        assert!(format("a.wgsl", wgsl, Claim::None, &Style::default()).is_err());
    }

    #[test]
    fn unmatched_brackets_have_positions() {
        let text = "\nvoid main() {\n  if (a[0) {}\n}\n";
        let formatting = format("a.frag", text, Claim::None, &Style::default()).unwrap();
        assert_eq!(formatting.edits, []);
        let [left] = &formatting.left[..] else {
            panic!("one bracket")
        };
        assert_eq!(left.span, Span::new(22, 23));
        assert_eq!(left.message, "unclosed bracket");
    }
}
