//! The `#if` groups of a text as a tree, and what their conditions test.
//!
//! Directives are read without macros, so that the tree is also there for texts that do not compile.
//! The preprocessor decides which branches are compiled.

use crate::lexer::tokenize;
use crate::lines::{RawItem, is_blank, raw_items};
use shaderlint_text::Span;

/// What a directive does to groups.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GroupDirective {
    /// `#if`, `#ifdef`, `#ifndef`
    Opens,
    /// `#elif`, `#else`
    Alternates,
    /// `#endif`
    Closes,
}

impl GroupDirective {
    /// What the directive with this name does; `None` if it does not belong to groups.
    pub fn of(name: &str) -> Option<GroupDirective> {
        match name {
            "if" | "ifdef" | "ifndef" => Some(GroupDirective::Opens),
            "elif" | "else" => Some(GroupDirective::Alternates),
            "endif" => Some(GroupDirective::Closes),
            _ => None,
        }
    }
}

/// A branch by the indices of its group and in its group.
pub type BranchId = (usize, usize);

/// Groups in the order of their `#if`, each directive as `D`.
#[derive(Debug)]
pub struct ConditionalGroups<D> {
    /// All groups, also those without `#endif`.
    pub all: Vec<ConditionalGroup<D>>,
    /// Indices of the groups that are open after the last directive.
    open: Vec<usize>,
}

/// From `#if` to `#endif`.
#[derive(Debug)]
pub struct ConditionalGroup<D> {
    /// The branch that it is in.
    pub around: Option<BranchId>,
    /// Number of groups around it.
    pub depth: usize,
    /// At least one.
    pub branches: Vec<GroupBranch<D>>,
    /// Its `#endif`.
    pub end: Option<D>,
}

/// The code after a directive of a group, up to the next one.
#[derive(Debug)]
pub struct GroupBranch<D> {
    /// The directive that starts it.
    pub directive: D,
    /// Indices of the groups in it, without those inside them.
    pub inner: Vec<usize>,
}

impl<D> Default for ConditionalGroups<D> {
    fn default() -> Self {
        let (all, open) = (Vec::new(), Vec::new());
        ConditionalGroups { all, open }
    }
}

impl<D> ConditionalGroups<D> {
    /// Adds the next directive of the text. One without an `#if` is ignored.
    pub fn add(&mut self, effect: GroupDirective, directive: D) {
        let around = self.current();
        let branch = |directive| {
            let inner = Vec::new();
            GroupBranch { directive, inner }
        };
        if effect == GroupDirective::Opens {
            let index = self.all.len();
            if let Some(outer) = around.and_then(|id| self.branch_mut(id)) {
                outer.inner.push(index);
            }
            self.all.push(ConditionalGroup {
                around,
                depth: self.open.len(),
                branches: vec![branch(directive)],
                end: None,
            });
            return self.open.push(index);
        }
        let Some(group) = self.open.last().and_then(|at| self.all.get_mut(*at)) else {
            return;
        };
        if effect == GroupDirective::Alternates {
            return group.branches.push(branch(directive));
        }
        group.end = Some(directive);
        self.open.pop();
    }

    /// The branch that goes on after the last directive.
    pub fn current(&self) -> Option<BranchId> {
        let group = *self.open.last()?;
        Some((group, self.all.get(group)?.branches.len() - 1))
    }

    /// The branches that go on after the last directive, outermost first.
    pub fn open(&self) -> impl Iterator<Item = &D> {
        let groups = self.open.iter().filter_map(|at| self.all.get(*at));
        groups.filter_map(|group| Some(&group.branches.last()?.directive))
    }

    /// The branch with this id.
    pub fn branch_mut(&mut self, (group, branch): BranchId) -> Option<&mut GroupBranch<D>> {
        self.all.get_mut(group)?.branches.get_mut(branch)
    }
}

impl<D> ConditionalGroup<D> {
    /// All directives in order.
    pub fn directives(&self) -> impl Iterator<Item = &D> {
        self.branches.iter().map(|b| &b.directive).chain(&self.end)
    }
}

/// A directive of a group.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConditionalDirective<'t> {
    /// What it does.
    pub effect: GroupDirective,
    /// From its `#` to the end of its line, without the line break.
    pub span: Span,
    /// Its name, such as `ifdef`.
    pub name: &'t str,
    /// The words and operators of the condition.
    words: Vec<&'t str>,
}

/// A test of one macro in a condition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MacroTest<'t> {
    /// The macro.
    pub name: &'t str,
    /// Whether `!` precedes it, or the directive is `#ifndef`.
    pub is_negated: bool,
    /// What is tested.
    pub kind: MacroTestKind<'t>,
}

/// What a condition tests of a macro.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MacroTestKind<'t> {
    /// Whether it is defined.
    Defined,
    /// Whether it is not 0.
    Value,
    /// An operator, and the word after it.
    Compared(&'t str, &'t str),
}

impl<'t> ConditionalDirective<'t> {
    /// Reads a directive of a text that starts at `base`; `None` for all other items.
    pub fn read(item: &RawItem, text: &'t str, base: u32) -> Option<ConditionalDirective<'t>> {
        let RawItem::Directive(hash, line) = item else {
            return None;
        };
        let solid = line.iter().filter(|t| !is_blank(t.kind));
        let mut words = solid.map(|t| {
            let range = (t.span.start - base) as usize..(t.span.end - base) as usize;
            text.get(range).unwrap_or("")
        });
        let name = words.next()?;
        Some(ConditionalDirective {
            effect: GroupDirective::of(name)?,
            span: hash.span.to(line.last()?.span),
            name,
            words: words.collect(),
        })
    }

    /// The tests of macros in the condition.
    pub fn tests(&self) -> Vec<MacroTest<'t>> {
        let by_name = matches!(self.name, "ifdef" | "ifndef");
        let words = self.words.iter().copied();
        let words: Vec<&str> = words.filter(|w| !matches!(*w, "(" | ")")).collect();
        let word = |at: Option<usize>| at.and_then(|at| words.get(at)).copied().unwrap_or("");
        let names = words.iter().enumerate().filter(|(_, w)| is_name(w));
        let tests = names.map(|(at, name)| {
            let is_defined = by_name || word(at.checked_sub(1)) == "defined";
            let before = at.checked_sub(1 + usize::from(is_defined));
            let kind = match (is_defined, word(Some(at + 1))) {
                (true, _) => MacroTestKind::Defined,
                (false, "" | "&&" | "||") => MacroTestKind::Value,
                (false, operator) => MacroTestKind::Compared(operator, word(Some(at + 2))),
            };
            MacroTest {
                name,
                is_negated: self.name == "ifndef" || word(before) == "!",
                kind,
            }
        });
        tests.take(if by_name { 1 } else { words.len() }).collect()
    }

    /// The test that is the whole condition.
    pub fn only_test(&self) -> Option<MacroTest<'t>> {
        let test = *self.tests().first()?;
        let own = match test.kind {
            MacroTestKind::Defined if self.name != "if" && self.name != "elif" => 1,
            MacroTestKind::Defined => 2 + usize::from(test.is_negated),
            MacroTestKind::Value => 1 + usize::from(test.is_negated),
            MacroTestKind::Compared(..) => 3,
        };
        let words = self.words.iter().filter(|w| !matches!(**w, "(" | ")"));
        (words.count() == own).then_some(test)
    }

    /// Whether it is `#if 0`.
    pub fn is_never(&self) -> bool {
        self.name == "if" && self.words == ["0"]
    }
}

impl<'t> ConditionalGroups<ConditionalDirective<'t>> {
    /// The groups of a text that starts at an address.
    pub fn of(text: &'t str, base: u32) -> Self {
        let mut groups = ConditionalGroups::default();
        groups.read(text, base);
        groups
    }

    /// Goes on with the next text.
    pub fn read(&mut self, text: &'t str, base: u32) {
        for item in raw_items(&tokenize(text, base)) {
            if let Some(directive) = ConditionalDirective::read(&item, text, base) {
                self.add(directive.effect, directive);
            }
        }
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') && word != "defined"
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each group as its depth, its directives and the number of groups in each branch.
    fn tree(text: &str) -> Vec<String> {
        let groups = ConditionalGroups::of(text, 10);
        let text_of = |d: &ConditionalDirective| {
            let range = d.span.start as usize - 10..d.span.end as usize - 10;
            text[range].to_string()
        };
        let each = groups.all.iter().map(|group| {
            let directives: Vec<String> = group.directives().map(text_of).collect();
            let inner: Vec<usize> = group.branches.iter().map(|b| b.inner.len()).collect();
            format!("{} {} {inner:?}", group.depth, directives.join(" "))
        });
        each.collect()
    }

    #[test]
    fn conditional_groups_are_nested() {
        let text =
            "#if A\n#ifdef B // b\n#endif\n#elif C\n#else\n# ifndef D\n#endif\n#endif\n#endif\n";
        assert_eq!(
            tree(text),
            [
                "0 #if A #elif C #else #endif [1, 0, 1]",
                "1 #ifdef B // b #endif [0]",
                "1 # ifndef D #endif [0]"
            ]
        );
        assert_eq!(
            tree("#else\n#ifdef A\n#else\n/*\n#endif\n*/"),
            ["0 #ifdef A #else [0, 0]"]
        );
    }

    #[test]
    fn tested_macros_of_conditions_are_found() {
        let read = |line: &'static str| {
            let tokens = tokenize(line, 0);
            let directive = ConditionalDirective::read(&raw_items(&tokens)[0], line, 0).unwrap();
            let tests = directive.tests().into_iter();
            let is_only = directive.only_test().is_some();
            let shown = tests.map(|t| {
                let not = if t.is_negated { "not " } else { "" };
                match t.kind {
                    MacroTestKind::Defined => format!("{not}defined {}", t.name),
                    MacroTestKind::Value => format!("{not}{}", t.name),
                    MacroTestKind::Compared(by, with) => format!("{not}{} {by} {with}", t.name),
                }
            });
            (shown.collect::<Vec<_>>().join(", "), is_only)
        };
        let check = |line, tests: &str, is_only| {
            assert_eq!(read(line), (tests.to_string(), is_only), "{line}");
        };
        check("#ifdef A", "defined A", true);
        check("#ifndef A // B", "not defined A", true);
        check("#if !defined(A)", "not defined A", true);
        check("#elif defined A && B", "defined A, B", false);
        check("#if (A == 2)", "A == 2", true);
        check("#if !A", "not A", true);
        check("#if A > 1 || !B", "A > 1, not B", false);
        check("#if 0", "", false);
        check("#else", "", false);
    }
}
