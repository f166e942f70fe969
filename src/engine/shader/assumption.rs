//! Which macros must be defined so that a branch of `#if` is compiled, and the shaders of a text that macros
//! select.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_semantic::{Program, Stage};
use shaderlint_syntax::{
    BranchId, ConditionalDirective, ConditionalGroup, ConditionalGroups, Lexer, MacroTestKind,
    RawKind, TokenKind, is_blank,
};
use shaderlint_text::{FileId, Role, Sources};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::ops::Range;

/// Maximum nesting of groups.
const DEEPEST: usize = 32;
/// Maximum number of branches in a group.
const MOST_BRANCHES: usize = 32;
/// Maximum number of shaders in a text.
const MOST_SHADERS: usize = 8;
/// Maximum number of different assumptions.
const MOST_NEEDS: usize = 128;

/// What is assumed about a macro.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum AssumedValue {
    Undefined,
    Defined,
    Value(i64),
}

/// What is assumed about macros that a text does not define itself, by name.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct AssumedMacros(BTreeMap<String, AssumedValue>);

impl AssumedMacros {
    /// Whether no macro is assumed to be defined.
    pub fn is_empty(&self) -> bool {
        self.0.values().all(|a| *a == AssumedValue::Undefined)
    }

    /// Whether a name is that of a macro whose value is assumed, or of any assumed macro.
    pub fn replaces(&self, name: &str, is_any: bool) -> bool {
        let assumed = self.0.get(name);
        assumed.is_some_and(|a| is_any || matches!(a, AssumedValue::Value(_)))
    }

    /// Adds other assumptions, unless they contradict these; returns whether it did.
    pub fn join(&mut self, others: &AssumedMacros) -> bool {
        let mut all = self.clone();
        let is_joined = others
            .0
            .iter()
            .all(|(name, assumed)| all.add(name, *assumed));
        if is_joined {
            *self = all;
        }
        is_joined
    }

    /// Adds an assumption, unless it contradicts what is known; returns whether it did.
    fn add(&mut self, name: &str, assumed: AssumedValue) -> bool {
        use AssumedValue::{Defined, Value};
        match (self.0.get(name).copied(), assumed) {
            (None, _) | (Some(Defined), Value(_)) => {
                self.0.insert(name.to_string(), assumed);
                true
            }
            (Some(Value(_)), Defined) => true,
            (Some(known), _) => known == assumed,
        }
    }

    /// The definitions of these macros. One without a known value stands for itself, so that it is
    /// an unknown name elsewhere.
    pub fn definitions(&self) -> String {
        let each = self.0.iter().map(|(name, assumed)| match assumed {
            AssumedValue::Undefined => format!("#undef {name}\n"),
            AssumedValue::Defined => format!("#define {name} {name}\n"),
            AssumedValue::Value(value) => format!("#define {name} {value}\n"),
        });
        each.collect()
    }
}

impl fmt::Display for AssumedMacros {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let defined = self.0.iter().filter_map(|(name, assumed)| match assumed {
            AssumedValue::Undefined => None,
            AssumedValue::Defined => Some(format!("`{name}` is defined")),
            AssumedValue::Value(value) => Some(format!("`{name}` is {value}")),
        });
        f.write_str(&defined.collect::<Vec<_>>().join(" and "))
    }
}

/// What the branches of a shader's conditional groups need.
pub struct BranchNeeds {
    /// By the address from which on they apply: the assumptions; `None` where no macro selects the
    /// branch.
    marks: BTreeMap<u32, Option<AssumedMacros>>,
    /// The addresses of branches that are not compiled, in source order.
    excluded: Vec<u32>,
}

impl BranchNeeds {
    /// Reads the directives of a shader's files.
    pub fn of(sources: &Sources, files: &[FileId], program: &Program) -> BranchNeeds {
        let fixed = fixed_names(program);
        let mut groups = ConditionalGroups::default();
        let mut starts = Vec::new();
        let codes = files.iter().filter_map(|id| sources.code(*id));
        for code in codes.filter(|c| c.role == Role::User) {
            starts.push((code.base, groups.current()));
            groups.read(code.text, code.base);
        }
        let (mut marks, needs) = marks_of(&groups, &fixed);
        marks.extend(
            starts
                .into_iter()
                .map(|(base, id)| (base, needs_of(&needs, id))),
        );
        let tokens = &program.tokens;
        let starts = tokens.inactive.iter().filter(|s| tokens.is_undecided(**s));
        let within = |s: &shaderlint_text::Span| marks.range(s.start..s.end).map(|(at, _)| *at);
        let first =
            |s: &shaderlint_text::Span| marks.range(..=s.start).next_back().map(|(at, _)| *at);
        let excluded = starts
            .flat_map(|s| first(s).into_iter().chain(within(s)))
            .collect();
        BranchNeeds { marks, excluded }
    }

    /// What the branches need that are not compiled, as far as macros select them.
    pub fn excluded(&self) -> Vec<&AssumedMacros> {
        let mut found: Vec<&AssumedMacros> = Vec::new();
        for needs in self.excluded.iter().filter_map(|at| self.at(*at)) {
            if found.len() < MOST_NEEDS && !found.contains(&needs) {
                found.push(needs);
            }
        }
        found
    }

    /// What the branch at an address needs.
    pub fn at(&self, address: u32) -> Option<&AssumedMacros> {
        let (_, needs) = self.marks.range(..=address).next_back()?;
        needs.as_ref().filter(|needs| !needs.is_empty())
    }
}

/// What applies from each address on, and what each branch needs.
type Needs = (
    BTreeMap<u32, Option<AssumedMacros>>,
    FxHashMap<BranchId, Option<AssumedMacros>>,
);

/// What the branches of some groups need.
fn marks_of(groups: &ConditionalGroups<ConditionalDirective>, fixed: &FxHashSet<String>) -> Needs {
    let mut needs = FxHashMap::default();
    let mut marks = BTreeMap::new();
    for (index, group) in groups.all.iter().enumerate() {
        let around = needs_of(&needs, group.around);
        for (at, directive) in group.directives().enumerate() {
            let own = match at < group.branches.len() {
                true => needed_by(group, at, around.clone(), fixed),
                false => around.clone(),
            };
            marks.insert(directive.span.end, own.clone());
            needs.insert((index, at), own);
        }
    }
    (marks, needs)
}

/// A shader among several in a text.
pub struct SelectedShader {
    /// The macros that a program defines before the text, to compile this one.
    pub macros: AssumedMacros,
    /// Its stage.
    pub stage: Stage,
}

/// The shaders of a text with a `main` for each stage, of which macros select one that the text does not define
/// itself; empty for all other texts.
pub fn selected_shaders(text: &str) -> Vec<SelectedShader> {
    if text.matches("main").count() < 2 || !text.contains("#if") {
        return Vec::new();
    }
    let mains = entries(text);
    let groups = ConditionalGroups::of(text, 0);
    let (marks, _) = marks_of(&groups, &FxHashSet::default());
    let is_defined = |name: &String| text.contains(&format!("#define {name}"));
    let select = |entry: &Range<usize>| {
        let (_, needs) = marks.range(..=entry.start as u32).next_back()?;
        let macros = needs.clone().filter(|needs| !needs.0.is_empty())?;
        let is_vertex = text.get(entry.clone())?.contains("gl_Position");
        (!macros.0.keys().any(is_defined)).then_some(SelectedShader {
            macros,
            stage: if is_vertex {
                Stage::Vertex
            } else {
                Stage::Fragment
            },
        })
    };
    let all: Option<Vec<SelectedShader>> = mains.iter().map(select).collect();
    let all = all.unwrap_or_default();
    let is_both = all.iter().any(|s| s.stage == Stage::Vertex)
        && all.iter().any(|s| s.stage == Stage::Fragment);
    let is_apart = |(at, one): (usize, &SelectedShader)| {
        let others = all.iter().enumerate();
        others
            .filter(|(other, _)| *other != at)
            .all(|(_, s)| s.macros != one.macros)
    };
    match is_both && all.len() <= MOST_SHADERS && all.iter().enumerate().all(is_apart) {
        true => exclusive(all),
        false => Vec::new(),
    }
}

/// The same shaders, each without the macros of the others.
fn exclusive(mut all: Vec<SelectedShader>) -> Vec<SelectedShader> {
    let names = all.iter().flat_map(|s| s.macros.0.keys().cloned());
    let names: BTreeSet<String> = names.collect();
    for shader in &mut all {
        for name in &names {
            shader.macros.add(name, AssumedValue::Undefined);
        }
    }
    all
}

/// The definitions of `main` in a text, each from its name up to the next one.
fn entries(text: &str) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let mut lexer = Lexer::new(text, 0);
    let (mut before, mut last) = ("", "");
    loop {
        let token = lexer.next_token();
        let word = text
            .get(token.span.start as usize..token.span.end as usize)
            .unwrap_or("");
        match token.kind {
            RawKind::End => break,
            kind if is_blank(kind) => continue,
            RawKind::Operator(TokenKind::LeftParen) if (before, last) == ("void", "main") => {
                let start = token.span.start as usize;
                if let Some(known) = found.last_mut() {
                    known.end = start;
                }
                found.push(start..text.len());
            }
            _ => {}
        }
        (before, last) = (last, word);
    }
    found
}

/// The macros whose definition does not depend on a host or a user.
fn fixed_names(program: &Program) -> FxHashSet<String> {
    let tokens = &program.tokens;
    let fixed = tokens.macros.iter().filter(|m| {
        let is_user = program.sources.is_user(m.name_span.start);
        m.predefined || !is_user || !tokens.is_undecided(m.name_span)
    });
    let names = fixed.map(|m| program.names.text(m.name).to_string());
    names.collect()
}

/// What the code of a branch needs; nothing outside of all groups.
fn needs_of(
    known: &FxHashMap<BranchId, Option<AssumedMacros>>,
    branch: Option<BranchId>,
) -> Option<AssumedMacros> {
    let known = |id| known.get(&id).cloned().flatten();
    branch.map_or_else(|| Some(AssumedMacros::default()), known)
}

/// What a branch needs, in a group in code that needs `around`.
fn needed_by(
    group: &ConditionalGroup<ConditionalDirective>,
    at: usize,
    around: Option<AssumedMacros>,
    fixed: &FxHashSet<String>,
) -> Option<AssumedMacros> {
    if at > MOST_BRANCHES || group.depth >= DEEPEST {
        return None;
    }
    let mut needs = around?;
    let mut directives = group.directives();
    let earlier: Vec<_> = directives.by_ref().take(at).collect();
    for (name, assumed) in needed(directives.next()?, true, fixed) {
        if !needs.add(name, assumed?) {
            return None;
        }
    }
    // The largest value that no earlier branch tests.
    let mut others: FxHashMap<&str, AssumedValue> = FxHashMap::default();
    for (name, assumed) in earlier.iter().flat_map(|d| needed(d, false, fixed)) {
        let Some(assumed) = assumed else {
            continue;
        };
        let known = others.entry(name).or_insert(assumed);
        if let (AssumedValue::Value(a), AssumedValue::Value(b)) = (*known, assumed) {
            *known = AssumedValue::Value(a.max(b));
        }
    }
    for (name, assumed) in others {
        if !needs.0.contains_key(name) {
            needs.add(name, assumed);
        }
    }
    Some(needs)
}

/// What makes the tests of a condition true, or false; `None` if it is unknown.
fn needed<'t>(
    directive: &ConditionalDirective<'t>,
    truth: bool,
    fixed: &FxHashSet<String>,
) -> Vec<(&'t str, Option<AssumedValue>)> {
    let tests = directive.tests().into_iter();
    let tests = tests.filter(|t| is_free(t.name) && !fixed.contains(t.name));
    let all = tests.map(|test| {
        let holds = test.is_negated != truth;
        let assumed = match test.kind {
            MacroTestKind::Defined if holds => Some(AssumedValue::Defined),
            MacroTestKind::Defined => Some(AssumedValue::Undefined),
            MacroTestKind::Value => Some(AssumedValue::Value(i64::from(holds))),
            MacroTestKind::Compared(operator, with) => value(operator, with, holds),
        };
        (test.name, assumed)
    });
    all.collect()
}

/// Whether a host or a user may define a macro with this name. Names with `GL_` and `__` belong to
/// the compiler (section 3.4).
fn is_free(name: &str) -> bool {
    !name.starts_with("GL_") && !name.contains("__")
}

/// A value for which a test of a macro is true, or false.
fn value(operator: &str, with: &str, truth: bool) -> Option<AssumedValue> {
    let with: Option<i64> = with.parse().ok();
    let value = match (operator, with) {
        ("==" | ">=" | "<=", Some(n)) if truth => n,
        ("!=", Some(n)) if !truth => n,
        ("==" | "!=" | "<=", Some(n)) => n + 1,
        (">=", Some(n)) => n - 1,
        (">", Some(n)) => n + i64::from(truth),
        ("<", Some(n)) => n - i64::from(truth),
        _ => return None,
    };
    Some(AssumedValue::Value(value))
}
