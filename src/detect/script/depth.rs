//! Whether the nesting of a script is limited, so that a recursive parser has room for it.

use super::token::{ScriptTokenKind, tokens};
use std::ops::Range;

/// Maximum depth of constructs that are open at the same time.
const MAX_DEPTH: usize = 200;

/// Words after which an operand or a statement must follow.
#[rustfmt::skip]
const OPEN_WORDS: [&str; 23] = [
    "asserts", "await", "case", "delete", "do", "extends", "for", "if", "in", "infer", "instanceof", "is",
    "keyof", "new", "of", "readonly", "return", "typeof", "unique", "void", "while", "with", "yield",
];

/// The constructs that are open inside a pair of brackets.
#[derive(Default)]
struct OpenBracket {
    /// Constructs that the end of a statement or an argument closes.
    constructs: usize,
    /// Branches of a chain of `else`, which is nested to the right.
    elses: usize,
    /// Whether a statement has ended, so that only `else` continues the chain.
    has_ended: bool,
    /// Whether a statement follows it, as after `if (...)`.
    is_header: bool,
}

/// The nesting at a place of a script.
struct Nesting<'t> {
    open: Vec<OpenBracket>,
    /// Number of all open constructs without brackets.
    total: usize,
    /// Whether an operand ends here.
    ends_operand: bool,
    /// The word before, unless it is the name of a member.
    last_word: &'t str,
    is_after_dot: bool,
    /// Whether the name of a namespace goes on: each part of it is a namespace of its own.
    in_namespace: bool,
}

impl<'t> Nesting<'t> {
    fn is_limited(&self) -> bool {
        self.open.len() + self.total <= MAX_DEPTH
    }

    /// A statement or an argument ends.
    fn end(&mut self) {
        let ended = self
            .open
            .last_mut()
            .map_or(0, |last| std::mem::take(&mut last.constructs));
        self.total -= ended;
    }

    /// Whether what is closed is an operand.
    fn close(&mut self) -> bool {
        let closed = match self.open.len() > 1 {
            true => self.open.pop().unwrap_or_default(),
            false => OpenBracket::default(),
        };
        self.total -= closed.constructs + closed.elses;
        !closed.is_header
    }

    fn add(&mut self) {
        if let Some(last) = self.open.last_mut() {
            last.constructs += 1;
            self.total += 1;
        }
    }

    fn word(&mut self, word: &'t str, is_new_line: bool) {
        self.follow(word == "else");
        let is_member = std::mem::take(&mut self.is_after_dot);
        // A statement without a semicolon ends with its line.
        if is_new_line && self.ends_operand && !matches!(word, "in" | "instanceof" | "else") {
            self.end();
        }
        let opens = !is_member && OPEN_WORDS.contains(&word);
        if opens {
            self.add();
        }
        self.ends_operand = !opens;
        self.last_word = if is_member { "" } else { word };
        self.in_namespace |= matches!(self.last_word, "namespace" | "module");
    }

    fn mark(&mut self, mark: u8, is_new_line: bool) {
        let last_word = std::mem::take(&mut self.last_word);
        self.is_after_dot = mark == b'.';
        self.in_namespace &= self.is_after_dot;
        if !matches!(mark, b')' | b']' | b'}') {
            self.follow(false);
        }
        match mark {
            b'(' | b'[' | b'{' => {
                let headers = ["if", "for", "while", "with", "switch", "catch"];
                self.open.push(OpenBracket {
                    is_header: headers.contains(&last_word),
                    ..OpenBracket::default()
                });
                self.ends_operand = false;
            }
            b')' | b']' | b'}' => {
                self.ends_operand = self.close();
                if let Some(last) = self.open.last_mut().filter(|_| mark == b'}') {
                    last.has_ended = true;
                }
                // A block ends the statement that it belongs to.
                if mark == b'}' && is_new_line {
                    self.end();
                }
            }
            b';' | b',' => {
                self.end();
                if let Some(last) = self.open.last_mut().filter(|_| mark == b';') {
                    last.has_ended = true;
                }
                self.ends_operand = false;
            }
            _ => {
                let opens = match mark {
                    b'+' | b'-' => !self.ends_operand,
                    b'.' => self.in_namespace,
                    _ => matches!(mark, b'!' | b'~' | b'?' | b':' | b'=' | b'<' | b'*' | b'@'),
                };
                if opens {
                    self.add();
                }
                self.ends_operand = false;
            }
        }
    }

    /// A word or mark follows; it continues a chain of `else`, or ends it.
    fn follow(&mut self, is_else: bool) {
        let Some(last) = self.open.last_mut() else {
            return;
        };
        if is_else {
            last.elses += 1;
            self.total += 1;
        } else if last.has_ended {
            self.total -= std::mem::take(&mut last.elses);
        }
        last.has_ended = false;
    }
}

/// Whether a hole of a template nests too many templates.
fn are_deep(text: &str, holes: &[Range<usize>]) -> bool {
    let nested = holes.iter().filter_map(|hole| text.get(hole.clone()));
    nested
        .map(|hole| hole.matches("${").count())
        .any(|depth| depth > MAX_DEPTH)
}

/// Whether a script nests its constructs less than a limit. Constructs without brackets count until a
/// statement or an argument ends: operators before an operand, assignments, conditions, arrows.
pub fn is_limited(text: &str) -> bool {
    let mut nesting = Nesting {
        open: vec![OpenBracket::default()],
        total: 0,
        ends_operand: false,
        last_word: "",
        is_after_dot: false,
        in_namespace: false,
    };
    let mut last_end = 0;
    for token in tokens(text) {
        let word = text.get(token.range.clone()).unwrap_or("");
        let between = text.get(last_end..token.range.start).unwrap_or("");
        let is_new_line = between.contains('\n');
        last_end = token.range.end;
        match token.kind {
            ScriptTokenKind::Comment => {}
            ScriptTokenKind::Word => nesting.word(word, is_new_line),
            ScriptTokenKind::Mark(mark) => nesting.mark(mark, is_new_line),
            ScriptTokenKind::Template(ref holes) if are_deep(text, holes) => return false,
            ScriptTokenKind::Quoted | ScriptTokenKind::Template(_) => {
                // The quote is not part of the token.
                last_end += 1;
                nesting.follow(false);
                nesting.ends_operand = true;
                (nesting.last_word, nesting.is_after_dot) = ("", false);
            }
        }
        if !nesting.is_limited() {
            return false;
        }
    }
    // What follows a literal that is not closed was not looked at.
    text.get(last_end..)
        .is_none_or(|rest| rest.trim().is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_scripts_are_limited_and_deep_ones_are_not() {
        let repeated = |text: &str| text.repeat(1_000);
        let long = [
            "x = f(1)\n",
            "x = f(1);",
            "const a = b\n",
            "if (a) b()\n",
            "for (;;) { a = b }\n",
            "x = !a, ",
            "if (a) { b } else { c }\n",
            "a.with(1)\n",
            "f(x => y)\n",
        ];
        for text in long {
            assert!(is_limited(&repeated(text)), "{text}");
        }
        let deep = [
            "x = ",
            "if (a) ",
            "if (a); else ",
            "while (a) ",
            "a ? b : ",
            "!",
            "- ",
            "f(",
            "a => ",
            "await ",
            "{ a: ",
            "`${",
            "keyof ",
        ];
        for text in deep {
            assert!(!is_limited(&repeated(text)), "{text}");
        }
    }
}
