//! Elements in the templates of Vue and Svelte, written as JSX in place, so that scripts that make programs of them
//! are read with them: `<T.Mesh {geometry}>`, `<TresMesh :args="[1]">`.

use oxc_allocator::Allocator;
use oxc_parser::Parser;
use oxc_span::SourceType;
use std::ops::Range;

/// Maximum number of bytes of a tag, so that brackets without an end are not searched for to the end of the file
/// each time.
const MAX_TAG: usize = 8_000;

/// Writes the elements of a component whose names start with a capital letter into its code, which has blanks
/// outside of its scripts. Their attributes keep their places.
///
/// The elements between two scripts are one expression in a function that nothing calls, so that they are read after
/// the scripts: `;()=><A/>&<B/>;`.
pub(super) fn add_elements(text: &str, scripts: &[Range<usize>], code: &mut String) {
    let (mut at, mut last) = (0, None);
    while let Some(open) = text.get(at..).and_then(|rest| rest.find('<')) {
        let open = at + open;
        at = open + 1;
        let rest = text.get(open..).unwrap_or("");
        let tag = rest.get(..rest.floor_char_boundary(MAX_TAG)).unwrap_or("");
        if let Some(script) = scripts.iter().find(|range| range.contains(&open)) {
            at = script.end;
            end(code, last.take());
        } else if rest.starts_with("<!--") {
            at = open + rest.find("-->").unwrap_or(rest.len());
        } else if rest
            .get(1..)
            .is_some_and(|name| name.starts_with(|c: char| c.is_ascii_uppercase()))
            && let Some(element) = element(tag).filter(|element| is_expression(element))
        {
            let before = if last.is_some() { "&" } else { ";()=>" };
            if put(code, open, (before, &element)) {
                at = open + element.len();
                last = Some(at);
            }
        }
    }
    end(code, last);
}

/// Writes an element where only blanks are.
fn put(code: &mut String, open: usize, (before, element): (&str, &str)) -> bool {
    let Some(start) = open.checked_sub(before.len()) else {
        return false;
    };
    let place = start..open + element.len();
    let is_free = code
        .get(place.clone())
        .is_some_and(|old| old.trim().is_empty());
    if is_free {
        code.replace_range(place, &format!("{before}{element}"));
    }
    is_free
}

/// Ends the expression of elements at a place.
fn end(code: &mut String, at: Option<usize>) {
    if let Some(at) = at {
        put(code, at, ("", ";"));
    }
}

/// Whether a text is an expression without mistakes.
fn is_expression(text: &str) -> bool {
    let allocator = Allocator::default();
    let parsed = Parser::new(&allocator, text, SourceType::tsx()).parse();
    !parsed.panicked && parsed.diagnostics.is_empty()
}

/// The tag that a text starts with as an element of JSX, in the same places.
fn element(text: &str) -> Option<String> {
    let name = text.find(|c: char| c.is_whitespace() || "/>{".contains(c))?;
    let mut out = text.get(..name)?.to_string();
    loop {
        let rest = text.get(out.len()..)?;
        let mut chars = rest.chars();
        let first = chars.next()?;
        if first.is_whitespace() {
            out.push_str(&" ".repeat(first.len_utf8()));
        } else if first == '/' {
            return rest.starts_with("/>").then(|| out + "/>");
        } else if first == '>' {
            // A blank before or after it has room for the slash.
            let is_roomy = out.ends_with(' ');
            if is_roomy {
                out.pop();
            }
            return (is_roomy || chars.next()?.is_ascii_whitespace()).then(|| out + "/>");
        } else {
            out.push_str(&attribute(rest)?);
        }
    }
}

/// The attribute that a text starts with as one of JSX. What JSX does not have is blank.
fn attribute(text: &str) -> Option<String> {
    if text.starts_with('{') {
        let whole = text.get(..braced(text)?)?;
        let inner = whole.get(1..whole.len() - 1)?;
        return Some(match inner.trim_start().starts_with("...") {
            true => whole.to_string(),
            // `{uniforms}`: the evaluator knows the mark.
            false => format!("${inner} "),
        });
    }
    let end = text.find(|c: char| c.is_whitespace() || "=/>{".contains(c))?;
    let (name, rest) = text.split_at(end);
    if name.is_empty() {
        return None;
    }
    let value = match rest.strip_prefix('=') {
        None => "",
        Some(value) => match value.chars().next()? {
            '{' => value.get(..braced(value)?)?,
            quote @ ('"' | '\'') => value.get(..value.get(1..)?.find(quote)? + 2)?,
            _ => value.get(..value.find(|c: char| c.is_whitespace() || c == '>')?)?,
        },
    };
    let length = end + usize::from(rest.starts_with('=')) + value.len();
    let blank = || " ".repeat(length);
    let quoted = value.get(1..value.len().saturating_sub(1));
    if name == "v-bind" {
        return quoted.map(|object| format!("    {{...{object}}}"));
    }
    let own = name
        .strip_prefix("v-bind:")
        .or_else(|| name.strip_prefix(':'));
    let is_other = |c: char| !(c.is_ascii_alphanumeric() || "-_.$".contains(c));
    let word = own.unwrap_or(name);
    if word.contains(is_other) || word.starts_with("v-") {
        return Some(blank());
    }
    let word = camel(word);
    let value = match (own, quoted) {
        (Some(_), Some(inner)) => format!("{{{inner}}}"),
        _ => value.to_string(),
    };
    let sign = if value.is_empty() { "" } else { "=" };
    let out = format!("{word}{sign}");
    let before = length.checked_sub(out.len() + value.len())?;
    Some(format!("{}{out}{value}", " ".repeat(before)))
}

/// Length of the text in braces that a text starts with.
fn braced(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    text.char_indices().find_map(|(at, c)| {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        (depth == 0).then_some(at + 1)
    })
}

/// `vertexShader` for `vertex-shader`; a name that leads to a uniform keeps its hyphens.
fn camel(name: &str) -> String {
    let mut parts = name.split(['-', '.']);
    let first = parts.next().unwrap_or("");
    if first == "uniforms" {
        return name.replace('.', "-");
    }
    parts.fold(first.to_string(), |mut all, part| {
        let mut chars = part.chars();
        all.extend(chars.next().map(|c| c.to_ascii_uppercase()));
        all + chars.as_str()
    })
}
