//! `// shaderlint: allow(rule) reason`: findings that the author has looked at.
//!
//! Behind code, it speaks of its line; alone on a line, of the next statement, declaration,
//! function or directive; as `allow-file(rule)`, of the whole file. What allows nothing is itself
//! reported. Compile errors cannot be allowed: the browser does not ask.

use super::removal::remove_lines;
use super::{Check, Group, Rule, Settings, nearest_rule};
use crate::diagnostic::{Diagnostic, ERRORS, Origin};
use crate::semantic::Program;
use crate::syntax::{Lexer, RawKind};
use crate::text::{Edit, Span};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// What stands before `allow`.
const MARK: &str = "shaderlint:";

/// The comments of one input that allow findings; passes of an export may share some.
#[derive(Default)]
pub struct Allows {
    /// By the address of the comment.
    found: BTreeMap<u32, Allow>,
}

struct Allow {
    /// Takes the comment away.
    removal: Edit,
    /// Where it allows findings to start.
    target: Span,
    names: Vec<Allowed>,
    /// Text that is no `allow(...)`.
    problem: Option<Span>,
}

struct Allowed {
    span: Span,
    name: String,
    used: bool,
}

impl Allows {
    /// Takes away the findings of one shader that are allowed in it.
    pub fn apply(
        &mut self,
        program: &Program,
        rules: &[&'static Rule],
        found: &mut Vec<Diagnostic>,
    ) {
        let mut own = Vec::new();
        let mut ends: Option<FxHashMap<u32, u32>> = None;
        for &comment in &program.tokens.comments {
            let text = program.sources.text(comment);
            if text.contains(MARK) {
                own.push(comment.start);
                self.found.entry(comment.start).or_insert_with(|| {
                    let ends = ends.get_or_insert_with(|| statement_ends(program));
                    read(program, comment, text, ends)
                });
            }
        }
        if own.is_empty() {
            return;
        }
        let group_of = |name: &str| rules.iter().find(|r| r.name == name).map(|r| r.group);
        found.retain(|diagnostic| {
            let group = group_of(diagnostic.rule).map(Group::name);
            let mut keep = true;
            for address in &own {
                let Some(allow) = self.found.get_mut(address) else {
                    continue;
                };
                if !allow.covers(diagnostic) {
                    continue;
                }
                for allowed in &mut allow.names {
                    if allowed.name == diagnostic.rule || Some(allowed.name.as_str()) == group {
                        allowed.used = true;
                        keep = false;
                    }
                }
            }
            keep
        });
    }

    /// Reports what allows nothing.
    pub fn report(self, rules: &[&'static Rule], settings: &Settings, out: &mut Vec<Diagnostic>) {
        let own = rules.iter().find(|r| matches!(r.check, Check::Allows));
        let Some((rule, level)) = own.and_then(|r| Some((r, settings.level(r)?))) else {
            return;
        };
        let finding =
            |span, message: String| Diagnostic::new(rule.name, Origin::Rule, level, span, message);
        for allow in self.found.into_values() {
            if let Some(span) = allow.problem {
                let message = "this is no `allow(...)`, so it allows nothing".to_string();
                out.push(finding(span, message).help(
                    "write `// shaderlint: allow(rule-name) reason` or `allow-file(rule-name)`",
                ));
            }
            let is_alone = allow.names.len() == 1;
            for name in &allow.names {
                let fix = is_alone.then(|| {
                    let title = "take the comment out";
                    crate::diagnostic::Fix::safe(title, vec![allow.removal.clone()])
                });
                if let Some(d) = judge(name, rules, settings, finding, fix) {
                    out.push(d);
                }
            }
        }
    }
}

/// What is wrong with one name in an `allow(...)`.
fn judge(
    allowed: &Allowed,
    rules: &[&'static Rule],
    settings: &Settings,
    finding: impl Fn(Span, String) -> Diagnostic,
    fix: Option<crate::diagnostic::Fix>,
) -> Option<Diagnostic> {
    let name = allowed.name.as_str();
    let in_group = |r: &&&'static Rule| r.name == name || r.group.name() == name;
    if rules.iter().any(|r| in_group(&r)) {
        let runs = rules
            .iter()
            .filter(in_group)
            .any(|r| settings.level(r).is_some());
        if allowed.used || !runs {
            return None;
        }
        let message = format!("there is no finding of `{name}` here to allow");
        return Some(finding(allowed.span, message).fix(fix));
    }
    if ERRORS.contains(&name) {
        let message = format!("`{name}` is a compile error, which cannot be allowed");
        return Some(
            finding(allowed.span, message).note("the browser refuses the shader all the same"),
        );
    }
    let message = format!("there is no rule or group `{name}`");
    let d = finding(allowed.span, message);
    Some(match nearest_rule(rules, name) {
        Some(near) => d.fix(crate::diagnostic::Fix::safe(
            format!("did you mean `{near}`?"),
            vec![Edit::replace(allowed.span, near)],
        )),
        None => d,
    })
}

impl Allow {
    fn covers(&self, diagnostic: &Diagnostic) -> bool {
        let inside = |at: u32| self.target.start <= at && at < self.target.end;
        let mut macros = diagnostic.macros.iter();
        inside(diagnostic.span.start) || macros.any(|m| inside(m.definition.start))
    }
}

/// Reads a comment.
fn read(program: &Program, comment: Span, text: &str, ends: &FxHashMap<u32, u32>) -> Allow {
    let mut allow = Allow {
        removal: remove_lines(program, comment),
        target: Span::at(comment.end),
        names: Vec::new(),
        problem: None,
    };
    let mark = text.find(MARK).unwrap_or(0) + MARK.len();
    let order = text.get(mark..).unwrap_or("");
    let blanks = order.len() - order.trim_start().len();
    let order = order.trim_start();
    let (word, list) = order.split_once('(').unwrap_or((order, ""));
    let list = list.split_once(')').map(|(names, _)| names);
    let (Some(names), "allow" | "allow-file") = (list, word.trim_end()) else {
        let from = comment.start + mark as u32 + blanks as u32;
        let length = order.trim_end_matches(['*', '/']).trim_end().len() as u32;
        allow.problem = Some(Span::new(from, from + length));
        return allow;
    };
    let mut at = comment.start + (mark + blanks + word.len() + 1) as u32;
    for part in names.split(',') {
        let start = at + (part.len() - part.trim_start().len()) as u32;
        let name = part.trim();
        if !name.is_empty() {
            allow.names.push(Allowed {
                span: Span::new(start, start + name.len() as u32),
                name: name.to_string(),
                used: false,
            });
        }
        at += part.len() as u32 + 1;
    }
    if allow.names.is_empty() {
        let from = comment.start + (mark + blanks) as u32;
        allow.problem = Some(Span::new(from, at));
    }
    allow.target = if word.trim_end() == "allow-file" {
        let file = program.sources.file_at(comment.start);
        file.map_or(comment, |f| Span::new(f.base, f.span().end + 1))
    } else {
        target(program, comment, ends)
    };
    allow
}

/// What a comment speaks of.
fn target(program: &Program, comment: Span, ends: &FxHashMap<u32, u32>) -> Span {
    let Some(code) = program.sources.code_at(comment.start) else {
        return comment;
    };
    let offset = (comment.start - code.base) as usize;
    let before = code.text.get(..offset).unwrap_or("");
    let line = before.rfind(['\n', '\r']).map_or(0, |i| i + 1);
    if !before.get(line..).unwrap_or("").trim().is_empty() {
        return Span::new(code.base + line as u32, comment.start);
    }
    let behind = (comment.end - code.base) as usize;
    let mut lexer = Lexer::new(code.text.get(behind..).unwrap_or(""), comment.end);
    let mut first: Option<u32> = None;
    loop {
        let token = lexer.next_token();
        match token.kind {
            RawKind::Whitespace
            | RawKind::LineComment
            | RawKind::BlockComment
            | RawKind::OpenComment => {}
            RawKind::Newline if first.is_none() => {}
            RawKind::Newline | RawKind::End => {
                let start = first.unwrap_or(token.span.start);
                let end = ends.get(&start).copied().unwrap_or(0);
                return Span::new(start, end.max(token.span.start));
            }
            _ => {
                first.get_or_insert(token.span.start);
            }
        }
    }
}

/// Where statements, declarations and functions end, by where they start.
fn statement_ends(program: &Program) -> FxHashMap<u32, u32> {
    let tree = &program.tree;
    let statements = tree.stmts.iter().map(|s| s.extent);
    let declarations = tree.decls.iter().map(|d| d.extent);
    let functions = tree.functions.iter().map(|f| f.extent);
    let mut ends = FxHashMap::default();
    for extent in statements.chain(declarations).chain(functions) {
        let span = program.span(extent);
        let end = ends.entry(span.start).or_insert(span.end);
        *end = (*end).max(span.end);
    }
    ends
}
