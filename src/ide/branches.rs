//! Texts in which other branches of `#if` are compiled than those that a shader selects.
//!
//! A text has the same length as the original: directives and the branches that are not selected
//! are blank. So names in code that is not compiled are resolved like all others.

use super::document::Document;
use super::index::is_inactive;
use shaderlint_project::Files;
use shaderlint_semantic::Program;
use shaderlint_syntax::{
    BranchId, ConditionalDirective, ConditionalGroups, GroupBranch, MacroTestKind, RawItem,
    RawKind, raw_items, tokenize,
};
use shaderlint_text::{SetAt, Span};

/// Maximum number of texts.
const MOST: usize = 16;
/// Maximum nesting of groups.
const DEEPEST: usize = 32;

/// The groups of a code.
struct CodeGroups<'t> {
    groups: ConditionalGroups<BranchState<'t>>,
    /// By group: the branch that the next text compiles.
    selected: Vec<Option<usize>>,
}

/// What is known of a directive of a group, and of the branch that it starts.
struct BranchState<'t> {
    /// The line of the directive.
    line: Span,
    condition: Option<MacroCondition<'t>>,
    /// Whether the shader compiles the branch.
    is_active: bool,
    /// Whether the branch has words that no text so far compiles.
    is_unread: bool,
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
    let mut codes: Vec<(Span, CodeGroups)> = Vec::new();
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
                codes.push((span, CodeGroups::of(code.text, code.base, program)));
            }
        }
    }
    let mut texts = Vec::new();
    while texts.len() < MOST && codes.iter().any(|(_, code)| code.any(None, &is_unread)) {
        let mut blank = Vec::new();
        for (_, code) in &mut codes {
            let mut chosen = Choices::default();
            if !code.select_unread(None, &mut chosen) {
                // What remains contradicts the conditions around it.
                chosen = Choices {
                    is_free: true,
                    ..Choices::default()
                };
                code.select_unread(None, &mut chosen);
            }
            code.select_others(None, &chosen, &mut blank);
        }
        texts.push(blanked(document, &blank));
    }
    texts
}

fn is_unread(branch: &BranchState) -> bool {
    branch.is_unread
}

impl<'t> CodeGroups<'t> {
    /// The groups of a text.
    fn of(text: &'t str, base: u32, program: &Program) -> CodeGroups<'t> {
        let mut groups: ConditionalGroups<BranchState> = ConditionalGroups::default();
        for item in raw_items(&tokenize(text, base)) {
            if let Some(directive) = ConditionalDirective::read(&item, text, base) {
                let state = BranchState {
                    line: directive.span,
                    condition: MacroCondition::of(&directive),
                    is_active: false,
                    is_unread: false,
                };
                groups.add(directive.effect, state);
                continue;
            }
            let first = match item {
                RawItem::Directive(hash, _) => hash,
                RawItem::Token(token) if token.kind == RawKind::Word => token,
                RawItem::Token(_) => continue,
            };
            let around = groups.current().and_then(|id| groups.branch_mut(id));
            if let Some(branch) = around.map(|branch| &mut branch.directive) {
                match is_inactive(program, first.span) {
                    true => branch.is_unread = true,
                    false => branch.is_active = true,
                }
            }
        }
        CodeGroups {
            selected: vec![None; groups.all.len()],
            groups,
        }
    }

    /// The groups in a branch, or outside of all groups. Those without `#endif` are errors, and
    /// left alone with all that is in them.
    fn inner(&self, around: Option<BranchId>) -> Vec<usize> {
        let branch = |(group, at): BranchId| self.groups.all.get(group)?.branches.get(at);
        let all = match around {
            Some(id) => branch(id).map_or(Vec::new(), |b| b.inner.clone()),
            None => {
                let all = self.groups.all.iter().zip(0..);
                let outermost = all.filter(|(group, _)| group.around.is_none());
                outermost.map(|(_, index)| index).collect()
            }
        };
        let is_whole = |at: &usize| {
            let group = self.groups.all.get(*at);
            group.is_some_and(|g| g.end.is_some() && g.depth < DEEPEST)
        };
        all.into_iter().filter(is_whole).collect()
    }

    /// Whether there is such a branch.
    fn any(&self, around: Option<BranchId>, is_such: &dyn Fn(&BranchState) -> bool) -> bool {
        let groups = self.inner(around).into_iter();
        let mut branches = groups.flat_map(|g| self.ids(g));
        branches.any(|id| self.has(id, is_such))
    }

    /// Whether a branch or one inside it is such a branch.
    fn has(&self, id: BranchId, is_such: &dyn Fn(&BranchState) -> bool) -> bool {
        let own = self.branches(id.0).get(id.1);
        own.is_some_and(|b| is_such(&b.directive)) || self.any(Some(id), is_such)
    }

    fn branches(&self, group: usize) -> &[GroupBranch<BranchState<'t>>] {
        let group = self.groups.all.get(group);
        group.map_or(&[], |group| &group.branches)
    }

    fn ids(&self, group: usize) -> impl Iterator<Item = BranchId> + use<> {
        (0..self.branches(group).len()).map(move |at| (group, at))
    }

    /// Selects branches that no text so far compiles, as far as their conditions agree. Returns
    /// whether there are some.
    fn select_unread(&mut self, around: Option<BranchId>, chosen: &mut Choices<'t>) -> bool {
        let mut any = false;
        for group in self.inner(around) {
            let mut needed = self.ids(group).filter(|id| self.has(*id, &is_unread));
            let Some(id) = needed.find(|id| chosen.allow(self.branches(group), id.1)) else {
                continue;
            };
            self.selected.set_at(group, Some(id.1));
            chosen.choose(self.branches(group), id.1);
            if let Some(branch) = self.groups.branch_mut(id) {
                any |= std::mem::take(&mut branch.directive.is_unread);
            }
            any |= self.select_unread(Some(id), chosen);
        }
        any
    }

    /// Selects a branch of each other group, and adds all code that is not selected to `blank`.
    fn select_others(&mut self, around: Option<BranchId>, chosen: &Choices, blank: &mut Vec<Span>) {
        for group in self.inner(around) {
            let branches = self.branches(group);
            let by_choice = || (0..branches.len()).find(|at| chosen.require(branches, *at));
            let active = || self.ids(group).find(|id| self.has(*id, &|b| b.is_active));
            let allowed = |at: &usize| chosen.allow(branches, *at);
            let selected = self.selected.get(group).copied().flatten();
            let selected = selected.or_else(by_choice);
            let selected = selected.or_else(|| active().map(|id| id.1).filter(allowed));
            let lines = self.groups.all.get(group).into_iter();
            let lines: Vec<Span> = lines.flat_map(|g| g.directives()).map(|d| d.line).collect();
            self.selected.set_at(group, None);
            for (at, pair) in lines.windows(2).enumerate() {
                match pair {
                    _ if selected == Some(at) => {
                        self.select_others(Some((group, at)), chosen, blank)
                    }
                    [from, to] => blank.push(Span::new(from.end, to.start)),
                    _ => {}
                }
            }
            blank.extend(lines);
        }
    }
}

/// The condition of a branch that compares one macro with a number. A macro that is not defined is
/// 0.
#[derive(Clone, Copy)]
struct MacroCondition<'t> {
    name: &'t str,
    value: &'t str,
    /// Whether the macro must have the value, or another one.
    is_equal: bool,
}

impl<'t> MacroCondition<'t> {
    /// Reads `#ifdef A`, `#if !defined(A)`, `#if A`, `#if A == 1`.
    fn of(directive: &ConditionalDirective<'t>) -> Option<MacroCondition<'t>> {
        let test = directive.only_test()?;
        let (value, is_equal) = match test.kind {
            MacroTestKind::Defined | MacroTestKind::Value => ("0", test.is_negated),
            MacroTestKind::Compared("==", value) => (value, true),
            MacroTestKind::Compared("!=", value) => (value, false),
            MacroTestKind::Compared(..) => return None,
        };
        let name = test.name;
        Some(MacroCondition {
            name,
            value,
            is_equal,
        })
    }
}

/// What the selected branches say about macros.
#[derive(Default)]
struct Choices<'t> {
    facts: Vec<MacroCondition<'t>>,
    /// Whether contradictions are allowed.
    is_free: bool,
}

impl<'t> Choices<'t> {
    /// Whether the condition of a branch holds; `None` if both is possible.
    fn holds(&self, branch: &GroupBranch<BranchState>) -> Option<bool> {
        let condition = branch.directive.condition?;
        let mut about = self.facts.iter().filter(|f| f.name == condition.name);
        about.find_map(
            |fact| match (fact.is_equal, fact.value == condition.value) {
                (true, is_same) => Some(is_same == condition.is_equal),
                (false, true) => Some(!condition.is_equal),
                (false, false) => None,
            },
        )
    }

    /// Whether a branch of a group may be compiled.
    fn allow(&self, branches: &[GroupBranch<BranchState>], at: usize) -> bool {
        let mut earlier = branches.iter().take(at).map(|b| self.holds(b));
        let own = branches.get(at).map(|b| self.holds(b));
        self.is_free || own != Some(Some(false)) && earlier.all(|held| held != Some(true))
    }

    /// Whether a branch of a group must be compiled.
    fn require(&self, branches: &[GroupBranch<BranchState>], at: usize) -> bool {
        let own = branches.get(at).and_then(|b| self.holds(b));
        own == Some(true) && self.allow(branches, at)
    }

    fn choose(&mut self, branches: &[GroupBranch<BranchState<'t>>], at: usize) {
        let condition = |b: &GroupBranch<BranchState<'t>>| b.directive.condition;
        let earlier = branches.iter().take(at).filter_map(condition);
        let earlier = earlier.map(|c| MacroCondition {
            is_equal: !c.is_equal,
            ..c
        });
        let own = branches.get(at).and_then(condition);
        self.facts.extend(earlier.chain(own));
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
