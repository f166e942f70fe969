//! HTML tags.

/// Length of a tag up to its `>`; quoted `>` do not end it.
pub(super) fn tag_length(head: &str) -> Option<usize> {
    let mut quote = None;
    head.char_indices().find_map(|(i, c)| {
        match quote {
            Some(q) if c == q => quote = None,
            Some(_) => {}
            None if c == '"' || c == '\'' => quote = Some(c),
            None if c == '>' => return Some(i),
            None => {}
        }
        None
    })
}

/// The value of an attribute.
pub(super) fn attribute<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    let named = head.match_indices(name).find_map(|(at, _)| {
        let before = head.get(..at)?;
        let after = head
            .get(at + name.len()..)?
            .trim_start()
            .strip_prefix('=')?;
        before
            .ends_with(|c: char| c.is_ascii_whitespace())
            .then_some(after.trim_start())
    })?;
    match named.chars().next() {
        Some(quote @ ('"' | '\'')) => named.get(1..)?.split(quote).next(),
        _ => named.split_ascii_whitespace().next(),
    }
}
