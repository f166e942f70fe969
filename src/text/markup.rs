//! Text inside HTML, XML and addresses.

/// Escapes a text for an element or a quoted attribute. Characters that no document may contain
/// are replaced.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            '\n' | '\r' | '\t' => out.push(c),
            // Line breaks that no reader sees.
            '\u{2028}' | '\u{2029}' => {}
            // Not allowed even as character references.
            c if c < ' ' || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// Escapes JSON for an element of HTML and for JavaScript.
pub fn escape_json(json: &str) -> String {
    let mut out = String::with_capacity(json.len() + json.len() / 16);
    let mut from = 0;
    for (i, c) in json.char_indices() {
        if matches!(c, '<' | '>' | '&' | '\u{2028}' | '\u{2029}') {
            out.push_str(json.get(from..i).unwrap_or(""));
            out.push_str(&format!("\\u{:04x}", c as u32));
            from = i + c.len_utf8();
        }
    }
    out.push_str(json.get(from..).unwrap_or(""));
    out
}

/// A file name as a part of an address.
pub fn in_address(name: &str) -> String {
    let mut out = String::with_capacity(name.len());
    for byte in name.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' => {
                out.push(char::from(byte));
            }
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

/// Decodes the entities of a text, each once.
pub fn decode(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('&') {
        out.push_str(before);
        let named = after.split_once(';');
        let read = named.and_then(|(name, after)| Some((entity(name)?, after)));
        let (c, after) = read.unwrap_or(('&', after));
        out.push(c);
        rest = after;
    }
    out + rest
}

/// The character of an entity, given without `&` and `;`.
pub fn entity(name: &str) -> Option<char> {
    if let Some(digits) = name.strip_prefix('#') {
        let code = match digits.strip_prefix(['x', 'X']) {
            Some(hex) => u32::from_str_radix(hex, 16).ok()?,
            None => digits.parse().ok()?,
        };
        return char::from_u32(code);
    }
    Some(match name {
        "lt" => '<',
        "gt" => '>',
        "amp" => '&',
        "quot" => '"',
        "apos" => '\'',
        "nbsp" => '\u{a0}',
        "times" => '×',
        "minus" => '\u{2212}',
        "sol" => '/',
        "ast" => '*',
        "num" => '#',
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_for_html_and_json() {
        assert_eq!(escape("\"><b&"), "&quot;&gt;&lt;b&amp;");
        assert_eq!(escape("it's\u{1}\n"), "it&apos;s\u{fffd}\n");
        let escaped = escape_json("\"</script><!--&\u{2028}é\"");
        let expected = "\"\\u003c/script\\u003e\\u003c!--\\u0026\\u2028é\"";
        assert_eq!(escaped, expected);
    }

    #[test]
    fn entities_are_decoded_once() {
        assert_eq!(decode("a &amp;lt; &lt;b&gt;"), "a &lt; <b>");
        assert_eq!(decode("&#39;&#x27;&unknown; & &"), "''&unknown; & &");
        let text = "<a href=\"b\">it's & that</a>";
        assert_eq!(decode(&escape(text)), text);
    }
}
