//! Suppression comments: `// shaderlint: allow(rule) reason`.
//!
//! After code, the comment applies to its line; alone on a line, to the next statement, declaration,
//! function or directive; as `allow-file(rule)`, to the whole file. Unused comments are reported. Compile
//! errors cannot be allowed: the browser rejects the shader anyway. A file that tests a compiler uses
//! `expect(error)` in the same way: the error is hidden, and its absence is reported.

mod misspelled;

use super::fix::removal::remove_lines;
use super::rule::{Rule, rule_name};
use super::settings::{Settings, nearest_rule};
use misspelled::MisspelledComment;
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::{Diagnostic, ERRORS, Fix, Origin};
use shaderlint_semantic::Program;
use shaderlint_syntax::{Lexer, RawKind};
use shaderlint_text::{Edit, LineIndex, Span};
use std::collections::BTreeMap;

/// The prefix of `allow`.
const MARK: &str = "shaderlint:";

/// The suppression comments of one input; passes of an export may share some.
#[derive(Default)]
pub struct Allows {
    /// By address of the comment.
    found: BTreeMap<u32, AllowComment>,
}

struct AllowComment {
    removal: Edit,
    /// Span in which the findings start.
    target: Span,
    names: Vec<Allowed>,
    /// Whether it is an `expect(...)`.
    expects: bool,
    /// Set if the comment is malformed.
    problem: Option<BadAllow>,
}

/// A malformed `allow(...)`.
struct BadAllow {
    span: Span,
    meant: Option<MisspelledComment>,
    /// The rules with findings that it may refer to.
    found: Vec<&'static str>,
}

struct Allowed {
    span: Span,
    name: String,
    used: bool,
}

impl Allows {
    /// Removes the errors of one shader that an `expect(...)` names.
    pub fn expect(
        &mut self,
        program: &Program,
        rules: &[&'static Rule],
        errors: &mut Vec<Diagnostic>,
    ) {
        let mut comments = program.tokens.comments.iter();
        if !comments.any(|c| program.sources.text(*c).contains("expect")) {
            return;
        }
        for address in self.read(program, rules) {
            let Some(allow) = self.found.get_mut(&address).filter(|a| a.expects) else {
                continue;
            };
            let target = allow.target;
            for name in &mut allow.names {
                let is_meant = |d: &Diagnostic| {
                    let start = d.span.start;
                    d.rule == name.name && target.start <= start && start < target.end
                };
                name.used |= errors.iter().any(is_meant);
                errors.retain(|d| !is_meant(d));
            }
        }
    }

    /// Parses the comments of a shader; returns the addresses of suppression comments.
    fn read(&mut self, program: &Program, rules: &[&'static Rule]) -> Vec<u32> {
        let mut own = Vec::new();
        let mut reader: Option<CommentReader> = None;
        for &comment in &program.tokens.comments {
            let text = program.sources.text(comment);
            if text.contains(MARK) || misspelled::read(text, rules).is_some() {
                own.push(comment.start);
                self.found.entry(comment.start).or_insert_with(|| {
                    let reader = reader.get_or_insert_with(|| CommentReader::new(program));
                    reader.read(comment, text, rules)
                });
            }
        }
        own
    }

    /// Removes the findings of one shader that are allowed in it.
    pub fn apply(
        &mut self,
        program: &Program,
        rules: &[&'static Rule],
        found: &mut Vec<Diagnostic>,
    ) {
        let own = self.read(program, rules);
        if own.is_empty() {
            return;
        }
        let places = AllowPlaces::of(rules, found);
        let mut allowed_at: FxHashMap<String, Vec<Span>> = FxHashMap::default();
        for address in &own {
            let Some(allow) = self.found.get_mut(address) else {
                continue;
            };
            if let Some(problem) = &mut allow.problem
                && problem.meant.as_ref().is_some_and(|m| m.names.is_empty())
            {
                problem.found = places.rules_within(rules, allow.target);
            }
            for allowed in &mut allow.names {
                allowed.used |= places.any_within(&allowed.name, allow.target);
                let targets = allowed_at.entry(allowed.name.clone()).or_default();
                // Consecutive comments usually apply to the same code.
                if targets.last() != Some(&allow.target) {
                    targets.push(allow.target);
                }
            }
        }
        allowed_at.values_mut().for_each(merge);
        let is_allowed = |name: &str, place: u32| {
            let targets = allowed_at.get(name).map_or(&[][..], Vec::as_slice);
            let after = targets.partition_point(|t| t.start <= place);
            let last = after.checked_sub(1).and_then(|i| targets.get(i));
            last.is_some_and(|t| place < t.end)
        };
        found.retain(|diagnostic| {
            let group = group_of(rules, diagnostic);
            !places_of(diagnostic).any(|place| {
                is_allowed(diagnostic.rule, place) || group.is_some_and(|g| is_allowed(g, place))
            })
        });
    }

    /// Treats comments as used if they apply to code with errors; the spans are in order.
    pub fn excuse(&mut self, broken: &[Span]) {
        for allow in self.found.values_mut() {
            let first = broken.partition_point(|b| b.end <= allow.target.start);
            if broken
                .get(first)
                .is_some_and(|b| b.start < allow.target.end)
            {
                allow.names.iter_mut().for_each(|n| n.used = true);
            }
        }
    }

    /// Reports malformed and unused comments.
    pub fn report(self, rules: &[&'static Rule], settings: &Settings, out: &mut Vec<Diagnostic>) {
        let own = rules.iter().find(|r| r.is_of_allows());
        let Some((rule, level)) = own.and_then(|r| Some((r, settings.level(r)?))) else {
            return;
        };
        let finding =
            |span, message: String| Diagnostic::new(rule.name, Origin::Rule, level, span, message);
        for allow in self.found.into_values() {
            if let Some(problem) = &allow.problem {
                let message = "malformed `allow(...)` comment has no effect".to_string();
                let fix = problem.fix();
                let help =
                    "use `// shaderlint: allow(rule-name) reason` or `allow-file(rule-name)`";
                let help = fix.is_none().then_some(help);
                let finding = finding(problem.span, message).fix(fix);
                out.push(help.into_iter().fold(finding, Diagnostic::help));
            }
            let is_alone = allow.names.len() == 1;
            for name in &allow.names {
                let fix = is_alone.then(|| {
                    let title = "remove the comment";
                    Fix::safe(title, vec![allow.removal.clone()])
                });
                let diagnostic = match allow.expects {
                    true => unmet(name, finding, fix),
                    false => check_name(name, rules, settings, finding, fix),
                };
                out.extend(diagnostic);
            }
        }
    }
}

/// Checks one name in an `expect(...)`.
fn unmet(
    expected: &Allowed,
    finding: impl Fn(Span, String) -> Diagnostic,
    fix: Option<Fix>,
) -> Option<Diagnostic> {
    let message = format!("expected `{}` here, but it is not reported", expected.name);
    (!expected.used).then(|| finding(expected.span, message).fix(fix))
}

/// Checks one name in an `allow(...)`.
fn check_name(
    allowed: &Allowed,
    rules: &[&'static Rule],
    settings: &Settings,
    finding: impl Fn(Span, String) -> Diagnostic,
    fix: Option<Fix>,
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
        let message = format!("unused `allow`: no finding of `{name}` here");
        return Some(finding(allowed.span, message).fix(fix));
    }
    if ERRORS.contains(&name) {
        let message = format!("compile error `{name}` cannot be allowed");
        return Some(finding(allowed.span, message).note("the browser rejects the shader anyway"));
    }
    let message = format!("unknown rule or group `{name}`");
    let d = finding(allowed.span, message);
    Some(match nearest_rule(rules, name) {
        Some(near) => d.fix(Fix::safe(
            format!("did you mean `{near}`?"),
            vec![Edit::replace(allowed.span, near)],
        )),
        None => d,
    })
}

impl BadAllow {
    /// Corrects the spelling, for the rules that it names, or else for those with findings there.
    fn fix(&self) -> Option<Fix> {
        let meant = self.meant.as_ref()?;
        let names = match meant.names.as_slice() {
            [] => &self.found,
            names => names,
        };
        if names.is_empty() {
            return None;
        }
        let corrected = meant.corrected(names);
        let title = format!("use `{corrected}`");
        Some(Fix::safe(title, vec![Edit::replace(self.span, corrected)]))
    }
}

/// The name of the group of a finding.
fn group_of(rules: &[&'static Rule], diagnostic: &Diagnostic) -> Option<&'static str> {
    let rule = rules.iter().find(|r| r.name == diagnostic.rule);
    rule.map(|r| r.group.name())
}

/// Where a finding may be allowed: at its start, and at the definitions of the macros it comes from.
fn places_of(diagnostic: &Diagnostic) -> impl Iterator<Item = u32> {
    let macros = diagnostic.macros.iter().map(|m| m.definition.start);
    std::iter::once(diagnostic.span.start).chain(macros)
}

/// Where findings may be allowed, sorted, by the names of rules and groups.
struct AllowPlaces(FxHashMap<&'static str, Vec<u32>>);

impl AllowPlaces {
    fn of(rules: &[&'static Rule], found: &[Diagnostic]) -> AllowPlaces {
        let mut by_name: FxHashMap<&'static str, Vec<u32>> = FxHashMap::default();
        for diagnostic in found {
            for name in [Some(diagnostic.rule), group_of(rules, diagnostic)] {
                let of_name = name.map(|n| by_name.entry(n).or_default());
                of_name
                    .into_iter()
                    .for_each(|p| p.extend(places_of(diagnostic)));
            }
        }
        by_name.values_mut().for_each(|p| p.sort_unstable());
        AllowPlaces(by_name)
    }

    /// The rules with a finding within a target.
    fn rules_within(&self, rules: &[&'static Rule], target: Span) -> Vec<&'static str> {
        let names = rules.iter().map(|r| r.name);
        names.filter(|n| self.any_within(n, target)).collect()
    }

    /// Whether a finding of a rule or group starts within a target.
    fn any_within(&self, name: &str, target: Span) -> bool {
        let places = self.0.get(name).map_or(&[][..], Vec::as_slice);
        let first = places.partition_point(|&p| p < target.start);
        places.get(first).is_some_and(|&p| p < target.end)
    }
}

/// Sorts targets and merges overlapping ones.
fn merge(targets: &mut Vec<Span>) {
    targets.sort_unstable_by_key(|t| t.start);
    targets.dedup_by(|next, before| {
        let overlaps = next.start <= before.end;
        if overlaps {
            before.end = before.end.max(next.end);
        }
        overlaps
    });
}

/// Parses the comments of one shader, in the order of the text.
struct CommentReader<'a> {
    program: &'a Program,
    /// Ends of statements by their starts.
    ends: FxHashMap<u32, u32>,
    /// Address and line index of the text that contains the previous comment.
    lines: Option<(u32, LineIndex)>,
    /// The last run of blanks and comments, and the code after it: all comments in it apply to the same
    /// code.
    stretch: Option<(Span, Span)>,
}

impl<'a> CommentReader<'a> {
    fn new(program: &'a Program) -> CommentReader<'a> {
        CommentReader {
            program,
            ends: statement_ends(program),
            lines: None,
            stretch: None,
        }
    }

    /// Parses a suppression comment.
    fn read(&mut self, comment: Span, text: &str, rules: &[&'static Rule]) -> AllowComment {
        let program = self.program;
        let mut allow = AllowComment {
            removal: remove_lines(program, comment),
            target: Span::at(comment.end),
            names: Vec::new(),
            expects: false,
            problem: None,
        };
        let found = text.find(MARK);
        let mark = found.map_or(text.len(), |m| m + MARK.len());
        let order = text.get(mark..).unwrap_or("");
        let blanks = order.len() - order.trim_start().len();
        let order = order.trim_start();
        let (word, list) = order.split_once('(').unwrap_or((order, ""));
        let list = list.split_once(')').map(|(names, _)| names);
        allow.expects = word.starts_with("expect");
        let (Some(names), "allow" | "allow-file" | "expect" | "expect-file") =
            (list, word.trim_end())
        else {
            let length = order.trim_end_matches(['*', '/']).trim_end().len();
            let meant = misspelled::read(text, rules);
            let range = meant.as_ref().map(|m| m.range.clone());
            let range = range.unwrap_or(mark + blanks..mark + blanks + length);
            let at = |offset: usize| comment.start + offset as u32;
            allow.problem = Some(BadAllow {
                span: Span::new(at(range.start), at(range.end)),
                meant,
                found: Vec::new(),
            });
            allow.target = self.target(comment);
            return allow;
        };
        let mut at = comment.start + (mark + blanks + word.len() + 1) as u32;
        for part in names.split(',') {
            let start = at + (part.len() - part.trim_start().len()) as u32;
            let name = part.trim();
            if !name.is_empty() {
                allow.names.push(Allowed {
                    span: Span::new(start, start + name.len() as u32),
                    name: rule_name(name).to_string(),
                    used: false,
                });
            }
            at += part.len() as u32 + 1;
        }
        if allow.names.is_empty() {
            let from = comment.start + (mark + blanks) as u32;
            allow.problem = Some(BadAllow {
                span: Span::new(from, at),
                meant: None,
                found: Vec::new(),
            });
        }
        allow.target = if word.trim_end().ends_with("-file") {
            let file = program.sources.file_at(comment.start);
            file.map_or(comment, |f| Span::new(f.base, f.span().end + 1))
        } else {
            self.target(comment)
        };
        allow
    }

    /// The code that a comment applies to.
    fn target(&mut self, comment: Span) -> Span {
        let Some(code) = self.program.sources.code_at(comment.start) else {
            return comment;
        };
        let offset = comment.start - code.base;
        if self
            .lines
            .as_ref()
            .is_none_or(|(base, _)| *base != code.base)
        {
            self.lines = Some((code.base, LineIndex::new(code.text)));
        }
        let line = match &self.lines {
            Some((_, lines)) => lines.bounds(offset, code.text.len() as u32).0,
            None => 0,
        };
        let before = code.text.get(line as usize..offset as usize);
        if !before.unwrap_or("").trim_start().is_empty() {
            return Span::new(code.base + line, comment.start);
        }
        match self.stretch {
            Some((stretch, target)) if stretch.contains(Span::at(comment.end)) => target,
            _ => {
                let after = (comment.end - code.base) as usize;
                let rest = code.text.get(after..).unwrap_or("");
                let (first, target) = next_code(rest, comment.end, &self.ends);
                self.stretch = Some((Span::new(comment.end, first), target));
                target
            }
        }
    }
}

/// The first code in `text`, which starts at `address`: its start, and the span that a comment before it
/// applies to.
fn next_code(text: &str, address: u32, ends: &FxHashMap<u32, u32>) -> (u32, Span) {
    let mut lexer = Lexer::new(text, address);
    let mut first: Option<u32> = None;
    loop {
        let token = lexer.next_token();
        match token.kind {
            blank if blank.is_blank() => {}
            RawKind::Newline if first.is_none() => {}
            RawKind::Newline | RawKind::End => {
                let start = first.unwrap_or(token.span.start);
                let end = ends.get(&start).copied().unwrap_or(0);
                return (start, Span::new(start, end.max(token.span.start)));
            }
            _ => {
                first.get_or_insert(token.span.start);
            }
        }
    }
}

/// Ends of statements, declarations and functions by their starts.
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
