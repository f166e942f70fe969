//! Tables of tests in text files.

/// Calls `check` for each case of a table, for the tests of all layers: a line `given ⇒ expected`, with `↵` for a
/// line break. Lines that start with `# ` are comments.
pub fn each_case(table: &str, mut check: impl FnMut(&str, &str)) {
    for case in table.lines().filter(|case| !case.starts_with("# ")) {
        let (given, expected) = case.split_once(" ⇒ ").unwrap_or((case, "no case"));
        check(&given.replace('↵', "\n"), &expected.replace('↵', "\n"));
    }
}
