//! Makes naga's HLSL acceptable to all HLSL compilers: some require braced lists for arrays of
//! zeros and for constant arrays, where naga writes `(float[3])0` and constructor calls.

/// Rewrites such declarations with braced lists.
pub(super) fn with_lists(text: &str) -> String {
    let mut lines = String::with_capacity(text.len());
    for line in text.lines() {
        match zeros(line).or_else(|| constants(line)) {
            Some(line) => lines.push_str(&line),
            None => lines.push_str(line),
        }
        lines.push('\n');
    }
    lines
}

/// `float a[3] = (float[3])0;`
fn zeros(line: &str) -> Option<String> {
    let (declared, rest) = line.split_once(" = (")?;
    let (ty, rest) = rest.split_once('[')?;
    let (size, rest) = rest.split_once(']')?;
    let count: usize = size.parse().ok()?;
    if rest != ")0;" {
        return None;
    }
    let all = vec![format!("({ty})0"); count].join(", ");
    Some(format!("{declared} = {{ {all} }};"))
}

/// `static const float a[2] = Constructarray2_float_(1.0, 2.0);`
fn constants(line: &str) -> Option<String> {
    let (declared, mut rest) = line.split_once(" = ")?;
    if !declared.starts_with("static const ") || !rest.contains(CONSTRUCTOR) {
        return None;
    }
    let mut value = String::new();
    // By open parenthesis: whether it was replaced by a brace.
    let mut open = Vec::new();
    while let Some(at) = rest.find(['(', ')']) {
        let (before, after) = rest.split_at(at);
        let is_open = after.starts_with('(');
        let word = before.rfind(|c: char| !is_of_name(c)).map_or(0, |i| i + 1);
        let (text, name) = before.split_at_checked(word).unwrap_or((before, ""));
        let is_list = if is_open {
            let is_list = name.starts_with(CONSTRUCTOR);
            open.push(is_list);
            is_list
        } else {
            open.pop().unwrap_or(false)
        };
        value.push_str(if is_open && is_list { text } else { before });
        value.push_str(match (is_open, is_list) {
            (true, true) => "{ ",
            (true, false) => "(",
            (false, true) => " }",
            (false, false) => ")",
        });
        rest = after.get(1..).unwrap_or("");
    }
    Some(format!("{declared} = {value}{rest}"))
}

/// Prefix of naga's constructor functions.
const CONSTRUCTOR: &str = "Construct";

fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn array_initializers_become_lists() {
        for (line, expected) in [
            (
                "    float2 a[2] = (float2[2])0;",
                "    float2 a[2] = { (float2)0, (float2)0 };",
            ),
            (
                "static const float2 a[2] = Constructarray2_float2_(float2(1.0, 2.0), (2.0).xx);",
                "static const float2 a[2] = { float2(1.0, 2.0), (2.0).xx };",
            ),
            (
                "static const S s = ConstructS(Constructarray1_float_(1.0), 2.0);",
                "static const S s = { { 1.0 }, 2.0 };",
            ),
            (
                "    a = Constructarray1_float_(1.0);",
                "    a = Constructarray1_float_(1.0);",
            ),
            ("    float a = (float)0;", "    float a = (float)0;"),
        ] {
            assert_eq!(with_lists(line), format!("{expected}\n"));
        }
    }
}
