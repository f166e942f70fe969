//! A simple reader for Rust: tokens, the modules of a crate, and the names that each file uses from
//! others.

use std::collections::{BTreeMap, BTreeSet};

/// A Rust token; comments are skipped.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Token<'a> {
    /// An identifier or a keyword.
    Name(&'a str),
    /// The content of a string literal.
    Text(&'a str),
    /// `::`
    Path,
    Mark(char),
}

/// The tokens of a file, with their line numbers.
pub fn tokens(text: &str) -> Vec<(Token<'_>, usize)> {
    let mut tokens = Vec::new();
    let (mut rest, mut line) = (text, 1);
    while let Some(first) = rest.chars().next() {
        let (token, length) = next(rest, first);
        tokens.extend(token.map(|t| (t, line)));
        let (read, after) = rest.split_at(length);
        line += read.matches('\n').count();
        rest = after;
    }
    tokens
}

/// The token at the start of a text, and its length in bytes.
fn next(rest: &str, first: char) -> (Option<Token<'_>>, usize) {
    if rest.starts_with("//") {
        return (None, rest.find('\n').unwrap_or(rest.len()));
    }
    if rest.starts_with("/*") {
        return (None, rest.find("*/").map_or(rest.len(), |end| end + 2));
    }
    if rest.starts_with("::") {
        return (Some(Token::Path), 2);
    }
    if first == '"' {
        return string(rest, 1);
    }
    let raw = rest.trim_start_matches('b').trim_start_matches('r');
    let prefix = rest.len() - raw.len();
    let hashes = raw.len() - raw.trim_start_matches('#').len();
    if (1..=2).contains(&prefix) && raw[hashes..].starts_with('"') {
        let start = prefix + hashes + 1;
        if !rest[..prefix].contains('r') {
            return string(rest, start);
        }
        let close = format!("\"{}", "#".repeat(hashes));
        let end = rest[start..]
            .find(&close)
            .expect("unterminated string literal")
            + start;
        return (Some(Token::Text(&rest[start..end])), end + close.len());
    }
    if first == '\'' {
        return (None, character(rest));
    }
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_';
    if is_of_name(first) {
        let end = rest.find(|c| !is_of_name(c)).unwrap_or(rest.len());
        return (Some(Token::Name(&rest[..end])), end);
    }
    let mark = (!first.is_whitespace()).then_some(Token::Mark(first));
    (mark, first.len_utf8())
}

/// A string literal whose content begins at `start`.
fn string(rest: &str, start: usize) -> (Option<Token<'_>>, usize) {
    let mut is_escaped = false;
    let end = rest[start..].find(|c| {
        let is_end = c == '"' && !is_escaped;
        is_escaped = c == '\\' && !is_escaped;
        is_end
    });
    let end = end.expect("unterminated string literal") + start;
    (Some(Token::Text(&rest[start..end])), end + 1)
}

/// The length of a character literal, or of the quote of a lifetime.
fn character(rest: &str) -> usize {
    let mut chars = rest.char_indices().skip(1);
    match chars.next() {
        Some((_, '\\')) => {
            let after = chars.next().map_or(1, |(at, c)| at + c.len_utf8());
            rest[after..].find('\'').map_or(1, |end| after + end + 1)
        }
        Some((at, c)) if rest[at + c.len_utf8()..].starts_with('\'') => at + c.len_utf8() + 1,
        _ => 1,
    }
}

/// Tokens without the items that are compiled only for tests.
pub fn without_tests<'a>(tokens: &[(Token<'a>, usize)]) -> Vec<(Token<'a>, usize)> {
    let test = ["cfg", "(", "test", ")", "]"];
    let is_test = |at: usize| {
        test.iter().enumerate().all(|(i, word)| {
            tokens.get(at + 2 + i).is_some_and(|(t, _)| match t {
                Token::Name(name) => name == word,
                Token::Mark(mark) => word.starts_with(*mark),
                _ => false,
            })
        })
    };
    let mut kept = Vec::new();
    let mut at = 0;
    while let Some(&(token, line)) = tokens.get(at) {
        if token == Token::Mark('#') && is_test(at) {
            at = end_of_item(tokens, at + 2 + test.len());
        } else {
            kept.push((token, line));
            at += 1;
        }
    }
    kept
}

/// The end of the item that starts at `at`: after its `;`, or after the `}` of its block.
pub fn end_of_item(tokens: &[(Token, usize)], mut at: usize) -> usize {
    let mut depth = 0;
    while let Some((token, _)) = tokens.get(at) {
        at += 1;
        match token {
            Token::Mark('{' | '(' | '[') => depth += 1,
            Token::Mark(')' | ']') => depth -= 1,
            Token::Mark('}') => {
                depth -= 1;
                if depth == 0 {
                    break;
                }
            }
            Token::Mark(';') if depth == 0 => break,
            _ => {}
        }
    }
    at
}

/// The names of a path, from first to last.
type Names<'a> = Vec<&'a str>;

/// The imports and paths of one file.
#[derive(Default)]
pub struct Module<'a> {
    pub file: &'a str,
    /// The imports of its `use` declarations by local name; `*` imports everything of a module.
    imports: Vec<(&'a str, Names<'a>)>,
    /// The paths used in its code.
    paths: BTreeSet<Names<'a>>,
}

/// The files of one crate, by module path.
#[derive(Default)]
pub struct Crate<'a> {
    modules: BTreeMap<Names<'a>, Module<'a>>,
}

impl<'a> Crate<'a> {
    /// Reads the files of the crate in `folder`, without the crates in `others`.
    pub fn new(folder: &str, others: &[String], files: &'a [(String, String)]) -> Self {
        let mut read = Crate::default();
        let is_of = |file: &str, folder: &str| {
            let place = file.strip_prefix(folder);
            place.is_some_and(|place| place.starts_with('/'))
        };
        for (file, text) in files {
            let is_inside = |other: &&String| other.len() > folder.len() && is_of(file, other);
            if !is_of(file, folder) || others.iter().any(|other| is_inside(&other)) {
                continue;
            }
            let place = &file[folder.len() + 1..];
            let place = place.trim_end_matches(".rs");
            let mut names: Vec<&str> = place.split('/').collect();
            if matches!(names.last(), Some(&("lib" | "main" | "mod"))) {
                names.pop();
            }
            if names.last() != Some(&"tests") {
                read.modules.insert(names, Module::new(file, text));
            }
        }
        read
    }

    /// The dependencies between files: each pair once.
    pub fn arrows(&self) -> BTreeMap<&'a str, BTreeSet<&'a str>> {
        let mut arrows: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for (place, module) in &self.modules {
            let imported = module.imports.iter().map(|(_, path)| path);
            for path in imported.chain(&module.paths) {
                let Some(to) = self.definer(place, path, 0) else {
                    continue;
                };
                if to != module.file {
                    arrows.entry(module.file).or_default().insert(to);
                }
            }
        }
        arrows
    }

    /// The file that defines the item of a path in a module. A module itself has no definition:
    /// each use of an imported module names the item.
    fn definer(&self, place: &[&'a str], path: &[&'a str], depth: usize) -> Option<&'a str> {
        let (mut module, rest) = self.start(place, path)?;
        let mut rest = rest.to_vec();
        while let Some((first, after)) = rest.split_first() {
            let mut child = module.clone();
            child.push(first);
            if !self.modules.contains_key(&child) {
                break;
            }
            module = child;
            rest = after.to_vec();
        }
        let name = rest.first()?;
        let here = self.modules.get(&module)?;
        let import = here.imports.iter().find(|(own, _)| own == name);
        if let Some((_, path)) = import.filter(|_| depth < 8) {
            let mut path = path.clone();
            path.extend(&rest[1..]);
            // Items of other crates are imported from there.
            return self.definer(&module, &path, depth + 1);
        }
        Some(here.file)
    }

    /// The module in which a path starts, and the rest of the path.
    fn start<'p>(
        &self,
        place: &[&'a str],
        path: &'p [&'a str],
    ) -> Option<(Names<'a>, &'p [&'a str])> {
        let mut module = place.to_vec();
        let mut rest = path;
        match path.first()? {
            &"crate" => {
                module.clear();
                rest = &rest[1..];
            }
            &"self" => rest = &rest[1..],
            &"super" => {}
            name => {
                let mut child = module.clone();
                child.push(name);
                let is_import = |(own, _): &&(&str, Names)| own == name;
                let is_here = self.modules.contains_key(&child)
                    || self.modules[place].imports.iter().any(|i| is_import(&i));
                return is_here.then_some((module, rest));
            }
        }
        while rest.first() == Some(&"super") {
            module.pop()?;
            rest = &rest[1..];
        }
        Some((module, rest))
    }
}

impl<'a> Module<'a> {
    fn new(file: &'a str, text: &'a str) -> Self {
        let all = tokens(text);
        let tokens: Vec<Token> = without_tests(&all).into_iter().map(|(t, _)| t).collect();
        let mut module = Module {
            file,
            ..Module::default()
        };
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            match token {
                Token::Name("use") => at = module.import(&tokens, at + 1, &[]),
                Token::Name(_) if tokens.get(at + 1) == Some(&Token::Path) => {
                    at = module.path(&tokens, at);
                }
                _ => at += 1,
            }
        }
        module
    }

    /// One path of a `use`, or a group of them; returns its end.
    fn import(&mut self, tokens: &[Token<'a>], mut at: usize, before: &[&'a str]) -> usize {
        let mut path = before.to_vec();
        loop {
            match tokens.get(at) {
                Some(Token::Name("as")) => {
                    if let Some(Token::Name(name)) = tokens.get(at + 1) {
                        self.imports.push((name, path));
                    }
                    return at + 2;
                }
                Some(Token::Name(name)) => path.push(name),
                Some(Token::Mark('*')) => path.push("*"),
                Some(Token::Path) => {}
                Some(Token::Mark('{')) => {
                    at += 1;
                    while !matches!(tokens.get(at), None | Some(Token::Mark('}'))) {
                        at = self.import(tokens, at, &path);
                        at += usize::from(tokens.get(at) == Some(&Token::Mark(',')));
                    }
                    return at + 1;
                }
                _ => break,
            }
            at += 1;
        }
        if path.last() == Some(&"self") && path.len() > 1 {
            path.pop();
        }
        if let Some(name) = path.last() {
            self.imports.push((name, path.clone()));
        }
        at
    }

    /// A path in the code; returns its end.
    fn path(&mut self, tokens: &[Token<'a>], mut at: usize) -> usize {
        let mut path = Vec::new();
        while let Some(Token::Name(name)) = tokens.get(at) {
            path.push(*name);
            at += 1;
            if tokens.get(at) != Some(&Token::Path) {
                break;
            }
            at += 1;
        }
        self.paths.insert(path);
        at
    }
}
