//! Code in inactive groups of `#if`: the same text under the assumption that a place is active.

/// A group from its `#if` to its `#endif`: the spans of the lines of its directives.
type ConditionLines = Vec<(usize, usize)>;

/// The text in which the groups around an offset select the branches that contain it. Directives and
/// other branches become spaces, so all offsets stay the same. `None` if no group is around it.
pub(super) fn with_active_branches(text: &str, offset: usize) -> Option<String> {
    let around = groups_around(text, offset);
    if around.is_empty() {
        return None;
    }
    let mut bytes = text.as_bytes().to_vec();
    let mut blank = |from: usize, to: usize| {
        for byte in bytes.get_mut(from..to).into_iter().flatten() {
            if !matches!(byte, b'\n' | b'\r') {
                *byte = b' ';
            }
        }
    };
    for group in around {
        for lines in group.windows(2) {
            if let [(start, end), (next, _)] = *lines {
                blank(start, end);
                if !(end..next).contains(&offset) {
                    blank(end, next);
                }
            }
        }
        if let Some((start, end)) = group.last() {
            blank(*start, *end);
        }
    }
    String::from_utf8(bytes).ok()
}

/// The groups around an offset. A group without `#endif` ends with the text.
fn groups_around(text: &str, offset: usize) -> Vec<ConditionLines> {
    let mut open: Vec<ConditionLines> = Vec::new();
    let mut around = Vec::new();
    let is_around = |group: &ConditionLines, end: usize| {
        group.first().is_some_and(|(start, _)| *start <= offset) && offset < end
    };
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let end = start + line.len();
        let word = line
            .trim_start()
            .strip_prefix('#')
            .map_or("", str::trim_start);
        let word = word.split(|c: char| !c.is_ascii_alphabetic()).next();
        match word {
            Some("if" | "ifdef" | "ifndef") => open.push(vec![(start, end)]),
            Some("elif" | "else") => {
                if let Some(group) = open.last_mut() {
                    group.push((start, end));
                }
            }
            Some("endif") => {
                if let Some(mut group) = open.pop() {
                    group.push((start, end));
                    if is_around(&group, start) {
                        around.push(group);
                    }
                }
            }
            _ => {}
        }
        start = end;
    }
    let rest = open.into_iter().map(|mut group| {
        group.push((start, start));
        group
    });
    around.extend(rest.filter(|group| is_around(group, start + 1)));
    around
}
