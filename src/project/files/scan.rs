//! Finds the include directives of a text, and whether it may be included twice.

use shaderlint_syntax::{
    ConditionalDirective, ConditionalGroups, Lexer, MacroTestKind, RawKind, TokenKind, raw_items,
    tokenize,
};
use std::ops::Range;
use std::sync::Arc;

/// Maximum number of restarts after a path that contains comment delimiters.
const MAX_STARTS: usize = 64;
/// Keywords before a parenthesis that are not functions.
const CONTROL: [&str; 4] = ["if", "for", "while", "switch"];
/// Keywords that start a declaration that must be unique.
const ONCE: [&str; 7] = [
    "struct",
    "uniform",
    "varying",
    "attribute",
    "in",
    "out",
    "layout",
];

/// How a path is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Manner {
    /// In quotes or bare.
    Path,
    /// As `<name>`, which may be a chunk of the host.
    Chunk,
}

/// A file that a directive names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RequestedFile {
    /// The path as written.
    pub path: String,
    /// How the path is written.
    pub manner: Manner,
}

/// What a directive does with the file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Form {
    /// Includes it unchanged.
    Put,
    /// Includes a glslify module: the name of its export, and pairs of names that replace names of
    /// the module.
    Require(String, Vec<(String, String)>),
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct IncludeDirective {
    /// Start offset in the text.
    pub start: usize,
    /// End offset, without a trailing comment.
    pub end: usize,
    pub requested: RequestedFile,
    /// What the directive does.
    pub form: Form,
    /// Whether it is in an `#if` group other than an include guard.
    pub is_conditional: bool,
    /// Number of open braces at the directive.
    pub depth: u32,
}

/// The result of scanning a text.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Scan {
    /// The directives in order.
    pub directives: Vec<IncludeDirective>,
    /// Whether it contains `#pragma once`.
    pub is_once: bool,
    /// Whether all code is inside include guards.
    pub is_guarded: bool,
    /// Whether it contains declarations that must be unique.
    pub declares: bool,
    /// The macros that it defines.
    pub defined: Vec<String>,
    /// The macros that it undefines.
    pub undefined: Vec<String>,
    /// The name that glslify's `export` gives.
    pub export: Option<String>,
}

pub fn scan(text: &str) -> Scan {
    let mut scanner = Scanner {
        text,
        found: Scan {
            is_guarded: true,
            ..Scan::default()
        },
        groups: ConditionalGroups::default(),
        depth: 0,
        brackets: 0,
        last: "",
        head: "",
        is_after_bracket: false,
        line_end: 0,
        starts: 0,
    };
    scanner.run();
    scanner.found
}

/// A directive for a chunk of the host.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct IncludedChunk {
    /// The range of the directive.
    pub range: Range<usize>,
    /// The name of the chunk.
    pub name: String,
}

/// The chunks of its host that a text includes.
pub fn chunks_in(text: &str) -> Vec<IncludedChunk> {
    if !text.contains("include") {
        return Vec::new();
    }
    let all = scan(text).directives.into_iter();
    let all = all.filter(|d| d.requested.manner == Manner::Chunk);
    all.map(|d| IncludedChunk {
        range: d.start..d.end,
        name: d.requested.path,
    })
    .collect()
}

/// The names that a text gives to modules of glslify.
pub fn required_names(text: &str) -> Vec<String> {
    if !text.contains("glslify") {
        return Vec::new();
    }
    let all = scan(text).directives.into_iter();
    let names = all.filter_map(|d| match d.form {
        Form::Require(name, _) => Some(name),
        Form::Put => None,
    });
    names.collect()
}

/// A branch of an `#if` group.
struct ScannedBranch<'a> {
    /// The macro that must not be defined.
    guard: Option<&'a str>,
    /// Whether the branch defines it, as an include guard does.
    is_guard: bool,
}

struct Scanner<'a> {
    text: &'a str,
    found: Scan,
    groups: ConditionalGroups<ScannedBranch<'a>>,
    depth: u32,
    /// Number of open parentheses.
    brackets: u32,
    last: &'a str,
    /// The word before the outermost parenthesis.
    head: &'a str,
    is_after_bracket: bool,
    /// End of the line of the current directive.
    line_end: usize,
    starts: usize,
}

impl<'a> Scanner<'a> {
    fn run(&mut self) {
        let mut from = 0;
        let mut lexer = Lexer::new(self.text, 0);
        let mut at_line_start = true;
        loop {
            let token = lexer.next_token();
            let (start, end) = (
                from + token.span.start as usize,
                from + token.span.end as usize,
            );
            let word = self.text.get(start..end).unwrap_or("");
            match token.kind {
                RawKind::End => return,
                RawKind::Newline => at_line_start = true,
                RawKind::Whitespace
                | RawKind::LineComment
                | RawKind::BlockComment
                | RawKind::OpenComment => {}
                // One loader of webpack accepts `@import`.
                RawKind::Hash | RawKind::Other if at_line_start && matches!(word, "#" | "@") => {
                    let stop = self.directive(start, end);
                    let reached = from + skip_line(&mut lexer, stop.saturating_sub(from));
                    at_line_start = true;
                    if stop > 0 && reached > stop && self.starts < MAX_STARTS {
                        // The apparent comment is part of the path.
                        self.starts += 1;
                        from = stop;
                        lexer = Lexer::new(self.text.get(stop..).unwrap_or(""), 0);
                        at_line_start = false;
                    }
                }
                kind => {
                    at_line_start = false;
                    self.code(kind, word);
                }
            }
        }
    }

    fn code(&mut self, kind: RawKind, word: &'a str) {
        self.found.is_guarded &= self.groups.open().any(|b| b.is_guard);
        let was_after_bracket = std::mem::take(&mut self.is_after_bracket);
        let at_top = self.depth == 0 && self.brackets == 0;
        match kind {
            RawKind::Word => {
                self.found.declares |= at_top && ONCE.contains(&word);
                self.last = word;
            }
            RawKind::Operator(TokenKind::LeftParen) => {
                if at_top {
                    self.head = self.last;
                }
                self.brackets += 1;
            }
            RawKind::Operator(TokenKind::RightParen) => {
                self.brackets = self.brackets.saturating_sub(1);
                self.is_after_bracket = true;
            }
            RawKind::Operator(TokenKind::LeftBrace) => {
                let is_body = at_top && was_after_bracket && !CONTROL.contains(&self.head);
                self.found.declares |= is_body;
                self.depth += 1;
            }
            RawKind::Operator(TokenKind::RightBrace) => {
                self.depth = self.depth.saturating_sub(1);
                self.brackets = 0;
            }
            _ => {}
        }
    }

    /// Parses the directive after a `#`. Returns its end if it names a file, otherwise 0.
    fn directive(&mut self, start: usize, after: usize) -> usize {
        let line = self.text.get(after..).unwrap_or("");
        let line = line.split(['\n', '\r']).next().unwrap_or("");
        self.line_end = after + line.len();
        let (word, rest) = first_word(line);
        let is_at = self.text.get(start..after) == Some("@");
        if is_at && word != "import" {
            return 0;
        }
        match word {
            "include" | "import" => return self.names(start, rest, Form::Put),
            "pragma" => return self.pragma(start, rest),
            "define" => self.define(rest),
            "undef" => self.found.undefined.push(first_word(rest).0.to_string()),
            _ => self.group(start),
        }
        0
    }

    fn group(&mut self, start: usize) {
        let text = self.text.get(start..self.line_end).unwrap_or("");
        let tokens = tokenize(text, 0);
        let item = raw_items(&tokens).into_iter().next();
        let directive = item.and_then(|item| ConditionalDirective::read(&item, text, 0));
        let Some(directive) = directive else {
            return;
        };
        let test = directive.only_test();
        let asked = test.filter(|t| t.is_negated && t.kind == MacroTestKind::Defined);
        let branch = ScannedBranch {
            guard: asked.map(|t| t.name),
            is_guard: false,
        };
        self.groups.add(directive.effect, branch);
    }

    /// The macro of an include guard has no replacement text.
    fn define(&mut self, rest: &'a str) {
        let (name, body) = first_word(rest);
        self.found.defined.push(name.to_string());
        let body = body.split("//").next().unwrap_or("");
        let body = body.split("/*").next().unwrap_or("").trim();
        let current = self.groups.current();
        if let Some(branch) = current.and_then(|id| self.groups.branch_mut(id))
            && branch.directive.guard == Some(name)
        {
            branch.directive.is_guard |= body.is_empty() || body == "1";
        }
    }

    fn pragma(&mut self, start: usize, rest: &'a str) -> usize {
        let (word, rest) = first_word(rest);
        match word {
            "once" => self.found.is_once = true,
            "include" | "import" => return self.names(start, rest, Form::Put),
            "glslify" => {
                let rest = rest.trim_start().strip_prefix(':').unwrap_or("");
                return self.glslify(start, rest);
            }
            _ => {}
        }
        0
    }

    /// `export(name)`, `import(path)` or `name = require(path, a = b)`.
    fn glslify(&mut self, start: usize, rest: &'a str) -> usize {
        let (word, after) = first_word(rest);
        let inside = |text: &'a str| text.trim_start().strip_prefix('(')?.split_once(')');
        match word {
            "export" => {
                let name = inside(after).map(|(name, _)| name.trim().to_string());
                self.found.export = name.filter(|n| !n.is_empty());
                0
            }
            "import" => match inside(after) {
                Some((path, after)) => {
                    let end = self.end(after);
                    self.add(start, end, unquoted(path), Manner::Path, Form::Put)
                }
                None => 0,
            },
            name => {
                let call = after.trim_start().strip_prefix('=').map(str::trim_start);
                let call = call.and_then(|c| c.strip_prefix("require"));
                let Some((arguments, after)) = call.and_then(inside) else {
                    return 0;
                };
                let end = self.end(after);
                let mut arguments = arguments.split(',');
                let path = unquoted(arguments.next().unwrap_or(""));
                let pairs = arguments.filter_map(|a| {
                    let (name, value) = a.split_once('=')?;
                    Some((name.trim().to_string(), value.trim().to_string()))
                });
                let form = Form::Require(name.to_string(), pairs.collect());
                self.add(start, end, path, Manner::Path, form)
            }
        }
    }

    /// A path in quotes, in angle brackets or bare, and the rest of the line.
    fn names(&mut self, start: usize, rest: &'a str, form: Form) -> usize {
        let named = rest.trim_start();
        let (path, after, manner) = match named.chars().next() {
            Some(quote @ ('"' | '\'' | '<')) => {
                let close = if quote == '<' { '>' } else { quote };
                let inside = named.get(1..).and_then(|n| n.split_once(close));
                let Some((path, after)) = inside else {
                    return 0;
                };
                let is_chunk = quote == '<';
                let manner = if is_chunk {
                    Manner::Chunk
                } else {
                    Manner::Path
                };
                (path, after, manner)
            }
            _ => {
                let end = named.find(|c: char| c.is_whitespace() || c == ';');
                let (path, after) = named.split_at(end.unwrap_or(named.len()));
                (path, after, Manner::Path)
            }
        };
        let end = self.end(after);
        self.add(start, end, path.trim(), manner, form)
    }

    /// The end of a directive with the rest of its line. A comment may continue on the next line,
    /// and is kept.
    fn end(&self, after: &str) -> usize {
        let comment = [after.find("//"), after.find("/*")];
        let comment = comment.into_iter().flatten().min();
        self.line_end - after.len() + comment.unwrap_or(after.len())
    }

    fn add(&mut self, start: usize, end: usize, path: &str, manner: Manner, form: Form) -> usize {
        let is_path = |c: char| !c.is_control() && !"(){}\"<>|".contains(c);
        if path.is_empty() || !path.chars().all(is_path) {
            return 0;
        }
        self.found.directives.push(IncludeDirective {
            start,
            end,
            requested: RequestedFile {
                path: path.to_string(),
                manner,
            },
            form,
            is_conditional: self.groups.open().any(|b| !b.is_guard),
            depth: self.depth,
        });
        end
    }
}

/// The first word of a line, and the rest.
fn first_word(line: &str) -> (&str, &str) {
    let line = line.trim_start();
    let end = line.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    line.split_at(end.unwrap_or(line.len()))
}

fn unquoted(path: &str) -> &str {
    path.trim().trim_matches(['"', '\''])
}

/// Skips the rest of a directive with its line break. Returns the end of the last token that starts
/// before `stop`.
fn skip_line(lexer: &mut Lexer, stop: usize) -> usize {
    let mut reached = 0;
    loop {
        let token = lexer.next_token();
        match token.kind {
            RawKind::End | RawKind::Newline => return reached,
            _ if (token.span.start as usize) < stop => reached = token.span.end as usize,
            _ => {}
        }
    }
}

/// An included file and its directives.
#[derive(Debug)]
pub struct IncludedFile {
    /// Contents of the file.
    pub text: Arc<str>,
    /// Include directives in source order.
    pub scan: Scan,
}

impl IncludedFile {
    /// Scans a text.
    pub fn new(text: Arc<str>) -> IncludedFile {
        let scan = scan(&text);
        IncludedFile { text, scan }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each directive as `path`, and the remaining text.
    fn read(text: &str) -> (Vec<String>, String) {
        let mut left = String::new();
        let mut done = 0;
        let mut paths = Vec::new();
        for directive in scan(text).directives {
            left += &text[done..directive.start];
            done = directive.end;
            paths.push(directive.requested.path);
        }
        (paths, left + &text[done..])
    }

    /// Each case is a text, the paths that it includes, and the remaining text.
    #[test]
    fn includes_are_separated_from_other_text() {
        let cases = include_str!("includes.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            let (expected, rest) = expected.split_once(" ‖ ").unwrap_or((expected, ""));
            let (paths, left) = read(&text.replace('↵', "\n"));
            assert_eq!(paths.join(", "), expected.replace("none", ""), "{text}");
            assert_eq!(left, rest.replace('↵', "\n"), "{text}");
        }
        let spaced = read("# include 'a.glsl' ;");
        assert_eq!(spaced, (vec!["a.glsl".to_string()], String::new()));
    }

    #[test]
    fn arguments_of_glslify_modules_are_read() {
        let found = scan("#pragma glslify: trace = require('./t', map = doModel, steps = 90)");
        let pair = |a: &str, b: &str| (a.to_string(), b.to_string());
        let pairs = vec![pair("map", "doModel"), pair("steps", "90")];
        let form = Form::Require("trace".to_string(), pairs);
        assert_eq!(found.directives[0].form, form);
        let found = scan("float f() { return 1.; }\n#pragma glslify:export( f )");
        assert_eq!(found.export.as_deref(), Some("f"));
    }

    #[test]
    fn include_guards_are_not_conditions() {
        let guarded = "#include \"a\"\n#ifndef FNC_F\n#define FNC_F\n#include \"b\"\nfloat f() { return 1.; }\n#endif\n";
        let found = scan(guarded);
        assert!(found.is_guarded && found.declares);
        assert!(found.directives.iter().all(|d| !d.is_conditional));
        let asked = scan("#if !defined(A)\n#define A 1\nint a;\n#endif");
        assert!(asked.is_guarded);
        let open = scan("#ifndef K\n#define K 3.\n#include \"a\"\n#endif\nfloat f();");
        assert!(!open.is_guarded && open.directives[0].is_conditional);
        assert!(!scan("#ifndef A\n#define A\n#else\nint a;\n#endif").is_guarded);
        assert!(scan("#pragma once\nint a;").is_once);
    }

    #[test]
    fn bodies_are_distinguished_from_declarations() {
        assert!(scan("float f(vec2 p) {\n}").declares);
        assert!(scan("uniform float a;").declares);
        assert!(!scan("if (a < b) { c = d; } else if (e) { for (;;) { } }").declares);
        assert!(!scan("const float PI = 3.14;").declares);
        assert_eq!(
            scan("void f() {\n#include \"body\"\n}").directives[0].depth,
            1
        );
    }
}
