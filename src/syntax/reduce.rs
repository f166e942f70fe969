//! Test case reduction: makes a shader smaller while a property of it holds, by delta debugging
//! first on the tree, then on tokens.

use super::ast::*;
use super::{ParseOptions, RawKind, Tokens, parse_corrected, preprocess, tokenize};
use shaderlint_text::{Role, Sources};
use std::ops::Range;

/// Result of a reduction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Reduced {
    /// The reduced text.
    pub text: String,
    /// Number of candidate texts that were tested.
    pub tries: usize,
}

/// Replacement for a range of the text.
#[derive(Clone)]
enum By {
    /// A smaller range of the same text.
    Part(Range<usize>),
    /// A fixed short text.
    Text(&'static str),
}

/// Removes from `text` what `keeps` does not need, with at most `most_tries` calls of it.
///
/// Each candidate is shorter than the last accepted text, so this terminates. The text itself is
/// assumed to satisfy `keeps`.
pub fn reduce(text: &str, most_tries: usize, keeps: &mut dyn FnMut(&str) -> bool) -> Reduced {
    let mut search = Reduction {
        text: text.to_string(),
        tries: 0,
        most_tries,
        keeps,
    };
    loop {
        let before = search.text.len();
        let mut depth = 0;
        // Deeper nodes are tried after the nodes around them.
        loop {
            let parts = layers(TextStructure::of(&search.text).deletable());
            let Some(parts) = parts.get(depth) else { break };
            search.delete(parts);
            depth += 1;
        }
        search.replace();
        let tokens = solid_tokens(&search.text);
        search.delete(&tokens);
        search.squeeze();
        if search.text.len() == before || search.is_over() {
            break;
        }
    }
    Reduced {
        text: search.text,
        tries: search.tries,
    }
}

struct Reduction<'a> {
    text: String,
    tries: usize,
    most_tries: usize,
    keeps: &'a mut dyn FnMut(&str) -> bool,
}

impl Reduction<'_> {
    fn is_over(&self) -> bool {
        self.tries >= self.most_tries
    }

    /// Whether a candidate satisfies the predicate; if so, it becomes the current text.
    fn accept(&mut self, text: String) -> bool {
        if text.len() >= self.text.len() || self.is_over() {
            return false;
        }
        self.tries += 1;
        let kept = (self.keeps)(&text);
        if kept {
            self.text = text;
        }
        kept
    }

    /// Removes ranges: large groups of neighbours first, then smaller ones, then single ranges. The
    /// ranges are in source order.
    fn delete(&mut self, parts: &[Range<usize>]) {
        let whole = self.text.clone();
        let mut removed = vec![false; parts.len()];
        let mut size = parts.len();
        while size > 0 && !self.is_over() {
            for start in (0..parts.len()).step_by(size) {
                let chunk = start..(start + size).min(parts.len());
                let mut candidate = removed.clone();
                for slot in candidate.iter_mut().take(chunk.end).skip(chunk.start) {
                    *slot = true;
                }
                if candidate != removed && self.accept(without(&whole, parts, &candidate)) {
                    removed = candidate;
                }
            }
            size /= 2;
        }
    }

    /// Replaces larger ranges with smaller ones while the predicate holds.
    fn replace(&mut self) {
        let mut next = 0;
        let mut all = TextStructure::of(&self.text).replaceable();
        while let Some((range, by)) = all.get(next).cloned() {
            if self.is_over() {
                return;
            }
            let by = match by {
                By::Part(part) => self.text.get(part).unwrap_or("").to_string(),
                By::Text(text) => text.to_string(),
            };
            let mut text = self.text.clone();
            text.replace_range(range, &by);
            if self.accept(text) {
                all = TextStructure::of(&self.text).replaceable();
            } else {
                next += 1;
            }
        }
    }

    /// Collapses whitespace and removes empty lines, in one step.
    fn squeeze(&mut self) {
        let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        let lines = self.text.lines().map(words).filter(|l| !l.is_empty());
        let text = lines.map(|l| l + "\n").collect();
        self.accept(text);
    }
}

/// The text without the ranges marked in `removed`. Ranges may overlap.
fn without(text: &str, parts: &[Range<usize>], removed: &[bool]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for (part, _) in parts.iter().zip(removed).filter(|(_, removed)| **removed) {
        if part.start > at {
            out.push_str(text.get(at..part.start).unwrap_or(""));
        }
        at = at.max(part.end);
    }
    out.push_str(text.get(at..).unwrap_or(""));
    out
}

/// Groups ranges by nesting depth.
fn layers(mut parts: Vec<Range<usize>>) -> Vec<Vec<Range<usize>>> {
    parts.sort_by_key(|p| (p.start, std::cmp::Reverse(p.end)));
    parts.dedup();
    let mut layers: Vec<Vec<Range<usize>>> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    for part in parts {
        while open.last().is_some_and(|end| *end < part.end) {
            open.pop();
        }
        if layers.len() <= open.len() {
            layers.push(Vec::new());
        }
        if let Some(layer) = layers.get_mut(open.len()) {
            layer.push(part.clone());
        }
        open.push(part.end);
    }
    layers
}

/// All tokens except whitespace; comments are included.
fn solid_tokens(text: &str) -> Vec<Range<usize>> {
    let tokens = tokenize(text, 0);
    let solid = tokens.iter().filter(|t| {
        !matches!(
            t.kind,
            RawKind::Whitespace | RawKind::Newline | RawKind::End
        )
    });
    solid
        .map(|t| t.span.start as usize..t.span.end as usize)
        .collect()
}

/// The lines that are directives.
fn directives(text: &str) -> Vec<Range<usize>> {
    let mut at = 0;
    let mut found = Vec::new();
    for line in text.split_inclusive('\n') {
        if line.trim_start().starts_with('#') {
            found.push(at..at + line.len());
        }
        at += line.len();
    }
    found
}

/// A text and its syntax tree.
struct TextStructure<'a> {
    text: &'a str,
    tokens: Tokens,
    tree: Tree,
    /// Address of the text's first byte.
    base: usize,
}

impl TextStructure<'_> {
    fn of(text: &str) -> TextStructure<'_> {
        let mut sources = Sources::new();
        // A text without `#version` may be a ShaderToy pass.
        let header = match text.contains("#version") {
            true => "",
            false => "#version 300 es\n",
        };
        let mut files = Vec::new();
        files.extend(sources.add("", None, Role::Prelude, header));
        files.extend(sources.add("", None, Role::User, text));
        let mut read = preprocess(&sources, &files, true, crate::GlContext::WEBGL2);
        let language = ParseOptions {
            version: read.version,
            is_fragment: true,
        };
        // Parsed without corrections, because inserted tokens have no place in the text.
        let tree = parse_corrected(&sources, &mut read.tokens, &read.names, language, &[]).tree;
        let file = files.last().and_then(|id| sources.file(*id));
        TextStructure {
            text,
            tokens: read.tokens,
            tree,
            base: file.map_or(0, |f| f.base as usize),
        }
    }

    /// The range of a node, if it is written in the text outside macro calls.
    fn range(&self, extent: Extent) -> Option<Range<usize>> {
        let tokens = &self.tokens.tokens;
        let inside = tokens.get(extent.first as usize..=extent.last as usize)?;
        if !inside.iter().all(|t| t.is_direct()) {
            return None;
        }
        let (first, last) = (inside.first()?, inside.last()?);
        let start = (first.span.start as usize).checked_sub(self.base)?;
        let end = (last.span.end as usize).checked_sub(self.base)?;
        (start < end && end <= self.text.len()).then_some(start..end)
    }

    /// As [`TextStructure::range`], including a `;` after it.
    fn line(&self, extent: Extent) -> Option<Range<usize>> {
        let range = self.range(extent)?;
        let rest = self.text.get(range.end..)?;
        let blanks = rest.len() - rest.trim_start().len();
        let ends = self.text.get(range.clone())?.ends_with([';', '}']);
        let more = !ends && rest.trim_start().starts_with(';');
        Some(range.start..range.end + if more { blanks + 1 } else { 0 })
    }

    /// Ranges that can be removed as a whole.
    fn deletable(&self) -> Vec<Range<usize>> {
        let tree = &self.tree;
        let mut all = directives(self.text);
        all.extend(tree.items.iter().filter_map(|item| match *item {
            Item::Function(id) => self.line(tree.function(id)?.extent),
            Item::Decl(id) => self.line(tree.decl(id)?.extent),
        }));
        let statements = tree.stmt_lists.iter().map(|&id| tree.stmt(id).extent);
        all.extend(statements.filter_map(|e| self.line(e)));
        let fields = tree.field_lists.iter().map(|f| f.extent);
        all.extend(fields.filter_map(|e| self.line(e)));
        for decl in &tree.decls {
            if let DeclKind::Variables { declarators, .. } = decl.kind {
                let list = tree.declarators(declarators);
                self.add_list(list.iter().map(|d| d.extent), &mut all);
            }
        }
        for function in &tree.functions {
            let list = tree.params(function.params);
            self.add_list(list.iter().map(|p| p.extent), &mut all);
        }
        for expr in &tree.exprs {
            if let ExprKind::Call(_, args) | ExprKind::Construct(_, args) = expr.kind {
                let list = tree.args(args);
                self.add_list(list.iter().map(|&a| tree.expr(a).extent), &mut all);
            }
        }
        all
    }

    /// The elements of a list, each with its adjacent comma.
    fn add_list(&self, list: impl Iterator<Item = Extent>, all: &mut Vec<Range<usize>>) {
        let ranges: Vec<Range<usize>> = list.filter_map(|e| self.range(e)).collect();
        for (i, range) in ranges.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|i| ranges.get(i));
            all.push(match (ranges.get(i + 1), before) {
                (Some(next), _) if next.start > range.start => range.start..next.start,
                (None, Some(before)) if before.end < range.end => before.end..range.end,
                _ => range.clone(),
            });
        }
    }

    /// Ranges that can be replaced with something smaller, largest first.
    fn replaceable(&self) -> Vec<(Range<usize>, By)> {
        let mut all = Vec::new();
        for stmt in &self.tree.stmts {
            self.replace_statement(stmt, &mut all);
        }
        for expr in &self.tree.exprs {
            self.replace_expression(expr, &mut all);
        }
        all.sort_by_key(|(range, _)| std::cmp::Reverse(range.len()));
        all
    }

    /// Replaces a statement with one that it contains, and a block with its contents.
    fn replace_statement(&self, stmt: &Stmt, all: &mut Vec<(Range<usize>, By)>) {
        let Some(range) = self.range(stmt.extent) else {
            return;
        };
        let parts = match stmt.kind {
            StmtKind::If {
                then, otherwise, ..
            } => [Some(then), otherwise],
            StmtKind::For { init, body, .. } => [Some(body), Some(init)],
            StmtKind::While { body, .. } | StmtKind::Do { body, .. } => [Some(body), None],
            StmtKind::Block(_) => {
                let inside = range.start + 1..range.end.saturating_sub(1);
                if inside.start < inside.end {
                    all.push((range, By::Part(inside)));
                }
                return;
            }
            _ => return,
        };
        for part in parts.into_iter().flatten() {
            if let Some(inner) = self.line(self.tree.stmt(part).extent) {
                all.push((range.clone(), By::Part(inner)));
            }
        }
    }

    /// Replaces an expression with one of its operands, or with a literal.
    fn replace_expression(&self, expr: &Expr, all: &mut Vec<(Range<usize>, By)>) {
        let Some(range) = self.range(expr.extent) else {
            return;
        };
        let tree = &self.tree;
        let mut parts: Vec<ExprId> = Vec::new();
        match expr.kind {
            ExprKind::Paren(e)
            | ExprKind::Unary(_, e)
            | ExprKind::Postfix(_, e)
            | ExprKind::Member(e, _)
            | ExprKind::Method(e, ..) => parts.push(e),
            ExprKind::Binary(_, a, b)
            | ExprKind::Assign(_, a, b)
            | ExprKind::Comma(a, b)
            | ExprKind::Index(a, b) => parts.extend([a, b]),
            ExprKind::Ternary(a, b, c) => parts.extend([a, b, c]),
            ExprKind::Call(_, args) | ExprKind::Construct(_, args) => {
                parts.extend_from_slice(tree.args(args));
            }
            _ => {}
        }
        let inner = parts
            .iter()
            .filter_map(|&p| self.range(tree.expr(p).extent));
        all.extend(inner.map(|p| (range.clone(), By::Part(p))));
        for text in ["1", "1.0", "true"] {
            if text.len() < range.len() {
                all.push((range.clone(), By::Text(text)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, needed: &[&str], expected: &str) {
        let mut keeps = |t: &str| needed.iter().all(|n| t.contains(n));
        assert_eq!(reduce(text, 10_000, &mut keeps).text, expected);
    }

    #[test]
    fn unnecessary_code_is_removed() {
        check(
            "#define N 3\nuniform float a, b;\nvoid f() { a; }\nvoid main() { f(); if (a > b) { g(x + y * z); } }\n",
            &["void main", "g(", "z"],
            "void main g( z\n",
        );
        check("int a;\nint b;\nint c;\n", &["int b;"], "int b;\n");
        check("void m(){f(one, two, three);}", &["f(", "two"], " f(two");
    }

    #[test]
    fn reduced_code_stays_valid() {
        let text = "float f(float x) { return x; }\nvoid main() { for (int i = 0; i < 3; i++) { float y = f(float(i)) * 2.0; } }\n";
        let mut keeps = |t: &str| {
            let s = TextStructure::of(t);
            let calls = |e: &Expr| matches!(e.kind, ExprKind::Call(..));
            !s.tree.stmts.iter().any(|s| s.kind == StmtKind::Error)
                && s.tree.exprs.iter().any(calls)
        };
        let left = reduce(text, 10_000, &mut keeps);
        assert!(left.text.len() < 25, "{}", left.text);
    }

    #[test]
    fn reduction_stops_at_the_limit_of_attempts() {
        let text = "int a;\n".repeat(500);
        let mut keeps = |_: &str| false;
        let left = reduce(&text, 100, &mut keeps);
        assert_eq!((left.text.as_str(), left.tries), (text.as_str(), 100));
        assert_eq!(reduce(&text, 100, &mut |_| true).text, "");
    }

    #[test]
    fn every_text_can_be_reduced() {
        for text in ["", "#", "}", "é{", "/*", "a b\\\nc", "#define A (\nA A A"] {
            reduce(text, 200, &mut |t| !t.is_empty());
        }
    }
}
