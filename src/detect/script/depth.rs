//! Whether the nesting of a script is limited, so that a recursive parser has room for it.

use super::token::{ScriptTokenKind, tokens};

/// Maximum depth of constructs that are open at the same time.
const MAX_DEPTH: usize = 200;

/// Words after which an operand or a statement must follow.
const OPEN_WORDS: [&str; 14] = [
    "await",
    "case",
    "delete",
    "do",
    "else",
    "extends",
    "in",
    "instanceof",
    "new",
    "of",
    "return",
    "typeof",
    "void",
    "yield",
];

/// Whether a script nests its constructs less than a limit. Constructs without brackets count until a
/// statement or an argument ends: operators before an operand, assignments, conditions, arrows.
pub fn is_limited(text: &str) -> bool {
    // By open bracket: the constructs in it that are still open.
    let mut open: Vec<usize> = vec![0];
    let mut total = 0;
    let mut last_end = 0;
    let mut ends_operand = false;
    for token in tokens(text) {
        let word = text.get(token.range.clone()).unwrap_or("");
        let between = text.get(last_end..token.range.start).unwrap_or("");
        last_end = token.range.end;
        let is_new_line = between.contains('\n');
        let adds = match token.kind {
            ScriptTokenKind::Comment => continue,
            ScriptTokenKind::Template(ref holes) => {
                let nested = holes
                    .iter()
                    .map(|hole| text.get(hole.clone()).unwrap_or(""));
                let depth = nested.map(|hole| hole.matches("${").count()).max();
                if depth.unwrap_or(0) > MAX_DEPTH {
                    return false;
                }
                false
            }
            ScriptTokenKind::Quoted => false,
            ScriptTokenKind::Word => OPEN_WORDS.contains(&word) || word == "if",
            ScriptTokenKind::Mark(mark) => match mark {
                b'(' | b'[' | b'{' => {
                    open.push(0);
                    if open.len() + total > MAX_DEPTH {
                        return false;
                    }
                    ends_operand = false;
                    continue;
                }
                b')' | b']' | b'}' => {
                    if open.len() > 1 {
                        total -= open.pop().unwrap_or(0);
                    }
                    // A block ends the statement that it belongs to.
                    if mark == b'}' && is_new_line {
                        total -= std::mem::take(open.last_mut().unwrap_or(&mut 0));
                    }
                    ends_operand = mark != b')';
                    continue;
                }
                b';' | b',' => {
                    total -= std::mem::take(open.last_mut().unwrap_or(&mut 0));
                    ends_operand = false;
                    continue;
                }
                b'+' | b'-' => !ends_operand,
                _ => matches!(mark, b'!' | b'~' | b'?' | b':' | b'=' | b'<' | b'*' | b'@'),
            },
        };
        let is_word = token.kind == ScriptTokenKind::Word;
        // A statement without a semicolon ends with its line.
        if is_new_line && ends_operand && is_word && !matches!(word, "in" | "instanceof" | "else") {
            total -= std::mem::take(open.last_mut().unwrap_or(&mut 0));
        }
        if adds {
            total += 1;
            if let Some(count) = open.last_mut() {
                *count += 1;
            }
            if open.len() + total > MAX_DEPTH {
                return false;
            }
        }
        ends_operand = matches!(
            token.kind,
            ScriptTokenKind::Quoted | ScriptTokenKind::Template(_)
        ) || is_word && !adds;
    }
    true
}
