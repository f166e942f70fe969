//! HTML elements and tags.

/// An element of a page in lower case.
pub(super) struct Element<'a> {
    /// Its name.
    pub name: &'static str,
    /// The attributes.
    pub head: &'a str,
    /// Start of the content.
    pub start: usize,
    /// End of the content.
    pub end: usize,
}

/// The first element after an offset that has one of some names, and is neither in a comment nor in an element
/// with one of the other names.
pub(super) fn next_element<'a>(
    lower: &'a str,
    mut at: usize,
    names: &[&'static str],
    skipped: &[&'static str],
) -> Option<Element<'a>> {
    loop {
        let open = at + lower.get(at..)?.find('<')?;
        let rest = lower.get(open..)?;
        at = open + 1;
        if rest.starts_with("<!--") {
            at = open + rest.find("-->")? + 3;
            continue;
        }
        let opens = |name: &&&'static str| {
            let after = rest.get(1..).and_then(|r| r.strip_prefix(**name));
            after.is_some_and(|r| {
                r.starts_with(|c: char| c.is_ascii_whitespace() || "/>".contains(c))
            })
        };
        let (name, is_skipped) = match (skipped.iter().find(opens), names.iter().find(opens)) {
            (Some(name), _) => (name, true),
            (None, Some(name)) => (name, false),
            (None, None) => continue,
        };
        let close = format!("</{name}");
        if is_skipped {
            at = open + rest.find(&close)? + 1;
            continue;
        }
        let head = rest.get(1 + name.len()..)?;
        let length = tag_length(head)?;
        let start = open + 1 + name.len() + length + 1;
        let end = start + lower.get(start..)?.find(&close)?;
        let head = head.get(..length)?;
        return Some(Element {
            name,
            head,
            start,
            end,
        });
    }
}

/// Length of a tag up to its `>`; quoted `>` do not end it.
fn tag_length(head: &str) -> Option<usize> {
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
