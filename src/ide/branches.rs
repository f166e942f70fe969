//! Texts in which other branches of `#if` are compiled than those that a shader selects.
//!
//! A text has the same length as the original: directives and the branches that are not selected
//! are blank. So names in code that is not compiled are resolved like all others.

use super::document::Document;
use super::index::is_inactive;
use shaderlint_engine::Files;
use shaderlint_semantic::Program;
use shaderlint_syntax::{RawItem, RawKind, RawToken, is_blank, raw_items, tokenize};
use shaderlint_text::Span;

/// Maximum number of texts.
const MOST: usize = 16;
/// Maximum nesting of groups.
const DEEPEST: usize = 32;

/// The branches from `#if` to `#endif`.
#[derive(Default)]
struct ConditionalGroup {
    /// Lines of its directives.
    directives: Vec<Span>,
    branches: Vec<Branch>,
    /// The branch that the next text compiles.
    selected: Option<usize>,
}

/// The code between two directives of a group.
#[derive(Default)]
struct Branch {
    span: Span,
    condition: MacroCondition,
    /// Whether the shader compiles it.
    is_active: bool,
    /// Whether it has words that no text so far compiles.
    is_unread: bool,
    inner: Vec<ConditionalGroup>,
}

impl Branch {
    fn is_needed(&self) -> bool {
        let mut inner = self.inner.iter().flat_map(|g| &g.branches);
        self.is_unread || inner.any(Branch::is_needed)
    }

    fn is_active(&self) -> bool {
        let mut inner = self.inner.iter().flat_map(|g| &g.branches);
        self.is_active || inner.any(Branch::is_active)
    }

    /// Takes note of a token.
    fn add(&mut self, program: &Program, token: Span) {
        match is_inactive(program, token) {
            true => self.is_unread = true,
            false => self.is_active = true,
        }
    }
}

impl Document {
    /// The document with other branches of its conditional groups, so that each branch is compiled
    /// in one of them. Positions are the same. `files` are those that the document was made with.
    pub fn alternatives(&self, files: &dyn Files) -> &[Document] {
        self.alternatives.get_or_init(|| {
            let texts = other_branches(self).into_iter();
            texts.map(|text| self.read_as(text, files)).collect()
        })
    }

    /// The alternative that compiles the code at an offset, if the document itself does not.
    pub(super) fn compiled_at(&self, offset: u32, files: &dyn Files) -> &Document {
        let spot = self.spot(offset);
        if !spot.is_some_and(|spot| is_inactive(spot.program(), Span::at(spot.address))) {
            return self;
        }
        let around = offset.saturating_sub(1) as usize..offset as usize + 1;
        let own = self.text.get(around.clone());
        let is_blank = own.is_none_or(|code| code.trim().is_empty());
        let mut others = match is_blank {
            true => [].iter(),
            false => self.alternatives(files).iter(),
        };
        // Where an alternative does not compile the code, it is blank.
        let other = others.find(|other| other.text.get(around.clone()) == own);
        other.unwrap_or(self)
    }

    /// The document, and its alternatives if code that it does not compile contains a word.
    pub(super) fn readings(&self, word: &str, files: &dyn Files) -> Vec<&Document> {
        let mut inactive = self.shaders().flat_map(|(program, _)| {
            let spans = program.tokens.inactive.iter();
            spans.map(|span| program.sources.text(*span))
        });
        let mut found = vec![self];
        if inactive.any(|code| code.contains(word)) {
            found.extend(self.alternatives(files));
        }
        found
    }
}

/// The texts in which every branch of a document's shaders is compiled at least once, apart from
/// those that are compiled anyway.
fn other_branches(document: &Document) -> Vec<String> {
    let mut codes: Vec<(Span, Vec<ConditionalGroup>)> = Vec::new();
    for (program, _) in document.shaders() {
        // The first inactive code may be that of an included file.
        let inactive = program.tokens.inactive.iter();
        let own = inactive.filter(|span| document.report.in_input(Span::at(span.start)).is_some());
        for span in own {
            if codes.iter().any(|(known, _)| known.contains(*span)) {
                continue;
            }
            if let Some(code) = document.report.sources.code_at(span.start) {
                let span = Span::new(code.base, code.base + code.text.len() as u32);
                codes.push((span, groups(code.text, code.base, program)));
            }
        }
    }
    let mut texts = Vec::new();
    let is_needed = |g: &ConditionalGroup| g.branches.iter().any(Branch::is_needed);
    while texts.len() < MOST && codes.iter().any(|(_, all)| all.iter().any(is_needed)) {
        let mut blank = Vec::new();
        for (_, groups) in &mut codes {
            let mut chosen = Choices::default();
            if !select_unread(groups, &mut chosen) {
                // What remains contradicts the conditions around it.
                chosen = Choices {
                    is_free: true,
                    ..Choices::default()
                };
                select_unread(groups, &mut chosen);
            }
            select_others(groups, &chosen, &mut blank);
        }
        texts.push(blanked(document, &blank));
    }
    texts
}

/// Selects branches that no text so far compiles, as far as their conditions agree. Returns
/// whether there are some.
fn select_unread(groups: &mut [ConditionalGroup], chosen: &mut Choices) -> bool {
    let mut any = false;
    for group in groups {
        let allowed = |i: usize| chosen.allow(&group.branches, i);
        let needed = |i: &usize| group.branches.get(*i).is_some_and(Branch::is_needed);
        let found = (0..group.branches.len())
            .filter(needed)
            .find(|i| allowed(*i));
        let Some(i) = found else {
            continue;
        };
        group.selected = Some(i);
        chosen.choose(&group.branches, i);
        if let Some(branch) = group.branches.get_mut(i) {
            any |= std::mem::take(&mut branch.is_unread);
            any |= select_unread(&mut branch.inner, chosen);
        }
    }
    any
}

/// Selects a branch of each other group, and adds all code that is not selected to `blank`.
fn select_others(groups: &mut [ConditionalGroup], chosen: &Choices, blank: &mut Vec<Span>) {
    for group in groups {
        let by_choice = || {
            let mut all = 0..group.branches.len();
            all.find(|i| chosen.require(&group.branches, *i))
        };
        let active = || group.branches.iter().position(Branch::is_active);
        let allowed = |i: &usize| chosen.allow(&group.branches, *i);
        let selected = group.selected.take().or_else(by_choice);
        let selected = selected.or_else(|| active().filter(allowed));
        blank.append(&mut group.directives.clone());
        for (i, branch) in group.branches.iter_mut().enumerate() {
            if selected == Some(i) {
                select_others(&mut branch.inner, chosen, blank);
            } else {
                blank.push(branch.span);
            }
        }
    }
}

/// The condition of a branch, if it compares one macro with a number. A macro that is not defined
/// is 0.
#[derive(Clone, Default)]
struct MacroCondition {
    /// Name of the macro; empty for any other condition.
    name: String,
    value: String,
    /// Whether the macro must have the value, or another one.
    is_equal: bool,
}

impl MacroCondition {
    /// Reads `#ifdef A`, `#if !defined(A)`, `#if A`, `#if A == 1`.
    fn of(directive: &str, words: &[&str]) -> MacroCondition {
        let words: Vec<&str> = words
            .iter()
            .copied()
            .filter(|w| !matches!(*w, "(" | ")"))
            .collect();
        let none = ("", "0", false);
        let (name, value, is_equal) = match (directive, words.as_slice()) {
            ("ifdef", [name]) => (*name, "0", false),
            ("ifndef", [name]) => (*name, "0", true),
            (_, ["defined", name] | [name]) => (*name, "0", false),
            (_, ["!", "defined", name] | ["!", name]) => (*name, "0", true),
            (_, [name, "==", value]) => (*name, *value, true),
            (_, [name, "!=", value]) => (*name, *value, false),
            _ => none,
        };
        let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
        MacroCondition {
            name: if is_name {
                name.to_string()
            } else {
                String::new()
            },
            value: value.to_string(),
            is_equal,
        }
    }
}

/// What the selected branches say about macros.
#[derive(Default)]
struct Choices {
    facts: Vec<MacroCondition>,
    /// Whether contradictions are allowed.
    is_free: bool,
}

impl Choices {
    /// Whether a condition holds; `None` if both is possible.
    fn holds(&self, condition: &MacroCondition) -> Option<bool> {
        let about = self
            .facts
            .iter()
            .filter(|f| f.name == condition.name && !f.name.is_empty());
        let mut known =
            about.filter_map(
                |fact| match (fact.is_equal, fact.value == condition.value) {
                    (true, is_same) => Some(is_same == condition.is_equal),
                    (false, true) => Some(!condition.is_equal),
                    (false, false) => None,
                },
            );
        known.next()
    }

    /// Whether a branch of a group may be compiled.
    fn allow(&self, branches: &[Branch], at: usize) -> bool {
        let earlier = branches.iter().take(at);
        let mut earlier = earlier.map(|b| self.holds(&b.condition));
        let own = branches.get(at).map(|b| self.holds(&b.condition));
        self.is_free || own != Some(Some(false)) && earlier.all(|held| held != Some(true))
    }

    /// Whether a branch of a group must be compiled.
    fn require(&self, branches: &[Branch], at: usize) -> bool {
        let own = branches.get(at).and_then(|b| self.holds(&b.condition));
        own == Some(true) && self.allow(branches, at)
    }

    fn choose(&mut self, branches: &[Branch], at: usize) {
        let earlier = branches.iter().take(at).map(|b| MacroCondition {
            is_equal: !b.condition.is_equal,
            ..b.condition.clone()
        });
        let own = branches.get(at).map(|b| b.condition.clone());
        self.facts
            .extend(earlier.chain(own).filter(|c| !c.name.is_empty()));
    }
}

/// The document with some code blank.
fn blanked(document: &Document, blank: &[Span]) -> String {
    let mut bytes = document.text.to_string().into_bytes();
    let sources = &document.report.sources;
    for span in blank {
        let mut start = span.start;
        // Line breaks stay, however the file writes them.
        for line in sources.text(*span).split(['\n', '\r']) {
            let end = start + line.len() as u32;
            let own = document.report.in_input(Span::new(start, end));
            let own = own.map_or(0..0, |own| own.start as usize..own.end as usize);
            if let Some(own) = bytes.get_mut(own) {
                own.fill(b' ');
            }
            start = end + 1;
        }
    }
    String::from_utf8(bytes).unwrap_or_default()
}

/// The conditional groups of some code.
fn groups(text: &str, base: u32, program: &Program) -> Vec<ConditionalGroup> {
    let mut open = vec![ConditionalGroup::default()];
    // The code around all groups is the branch of a group without directives.
    open.iter_mut()
        .for_each(|g| g.branches.push(Branch::default()));
    let tokens = tokenize(text, base);
    let word = |t: &RawToken| {
        let range = (t.span.start - base) as usize..(t.span.end - base) as usize;
        text.get(range).unwrap_or("")
    };
    for item in raw_items(&tokens) {
        let first = match item {
            RawItem::Directive(hash, line) => {
                let words = line.iter().filter(|t| !is_blank(t.kind)).map(word);
                let words: Vec<&str> = words.collect();
                let span = line
                    .last()
                    .map_or(hash.span, |last| hash.span.to(last.span));
                if directive(&mut open, &words, span) {
                    continue;
                }
                hash
            }
            RawItem::Token(token) if token.kind == RawKind::Word => token,
            RawItem::Token(_) => continue,
        };
        if let Some(branch) = open.last_mut().and_then(|g| g.branches.last_mut()) {
            branch.add(program, first.span);
        }
    }
    // A group without `#endif` is an error, and left alone.
    open.truncate(1);
    let around = open.pop().and_then(|mut g| g.branches.pop());
    around.map_or(Vec::new(), |branch| branch.inner)
}

/// Opens, continues or closes a group; returns whether the directive is one that does.
fn directive(open: &mut Vec<ConditionalGroup>, words: &[&str], line: Span) -> bool {
    let [name, words @ ..] = words else {
        return false;
    };
    let next = Branch {
        span: Span::at(line.end),
        condition: MacroCondition::of(name, words),
        ..Branch::default()
    };
    if matches!(*name, "if" | "ifdef" | "ifndef") && open.len() < DEEPEST {
        open.push(ConditionalGroup {
            directives: vec![line],
            branches: vec![next],
            selected: None,
        });
        return true;
    }
    if !matches!(*name, "elif" | "else" | "endif") || open.len() < 2 {
        return false;
    }
    let Some(mut group) = open.pop() else {
        return false;
    };
    group.directives.push(line);
    if let Some(last) = group.branches.last_mut() {
        last.span = Span::new(last.span.start, line.start);
    }
    if *name != "endif" {
        group.branches.push(next);
        open.push(group);
    } else if let Some(outer) = open.last_mut().and_then(|g| g.branches.last_mut()) {
        outer.inner.push(group);
    }
    true
}
