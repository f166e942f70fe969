//! Which macros must be defined so that a branch of `#if` is compiled.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_semantic::Program;
use shaderlint_syntax::{RawItem, RawToken, is_blank, raw_items, tokenize};
use shaderlint_text::{CompiledText, FileId, Role, Sources};
use std::collections::BTreeMap;
use std::fmt;

/// Maximum nesting of groups.
const DEEPEST: usize = 32;
/// Maximum number of branches in a group.
const MOST_BRANCHES: usize = 32;
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
            AssumedValue::Undefined => String::new(),
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
        let mut reader = GroupReader {
            is_fixed: fixed_names(program),
            open: Vec::new(),
            marks: BTreeMap::new(),
        };
        let codes = files.iter().filter_map(|id| sources.code(*id));
        for code in codes.filter(|c| c.role == Role::User) {
            reader.read(&code);
        }
        let marks = reader.marks;
        let starts = program.tokens.inactive.iter();
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

/// A group under construction.
struct OpenGroup<'t> {
    /// What the code around the group needs.
    around: Option<AssumedMacros>,
    /// The conditions of the branches so far.
    conditions: Vec<BranchCondition<'t>>,
}

/// The words of a condition.
#[derive(Clone)]
struct BranchCondition<'t> {
    directive: &'t str,
    words: Vec<&'t str>,
}

struct GroupReader<'t> {
    is_fixed: FxHashSet<String>,
    open: Vec<OpenGroup<'t>>,
    marks: BTreeMap<u32, Option<AssumedMacros>>,
}

impl<'t> GroupReader<'t> {
    fn read(&mut self, code: &CompiledText<'t>) {
        let needs = self.needs();
        self.marks.insert(code.base, needs);
        let tokens = tokenize(code.text, code.base);
        let word = |t: &RawToken| -> &'t str {
            let range = (t.span.start - code.base) as usize..(t.span.end - code.base) as usize;
            code.text.get(range).unwrap_or("")
        };
        for item in raw_items(&tokens) {
            let RawItem::Directive(hash, line) = item else {
                continue;
            };
            let mut words = line.iter().filter(|t| !is_blank(t.kind)).map(word);
            let directive = words.next().unwrap_or("");
            let condition = BranchCondition {
                directive,
                words: words.collect(),
            };
            self.directive(condition);
            if matches!(
                directive,
                "if" | "ifdef" | "ifndef" | "elif" | "else" | "endif"
            ) {
                let end = line.last().map_or(hash.span.end, |t| t.span.end);
                let needs = self.needs();
                self.marks.insert(end, needs);
            }
        }
    }

    fn directive(&mut self, condition: BranchCondition<'t>) {
        match condition.directive {
            "if" | "ifdef" | "ifndef" if self.open.len() < DEEPEST => {
                let around = self.needs();
                self.open.push(OpenGroup {
                    around,
                    conditions: vec![condition],
                });
            }
            "elif" | "else" => {
                if let Some(group) = self.open.last_mut() {
                    group.conditions.push(condition);
                }
            }
            "endif" => {
                self.open.pop();
            }
            _ => {}
        }
    }

    /// What the code after the last directive needs.
    fn needs(&self) -> Option<AssumedMacros> {
        let Some(group) = self.open.last() else {
            return Some(AssumedMacros::default());
        };
        let (own, earlier) = group.conditions.split_last()?;
        if earlier.len() >= MOST_BRANCHES {
            return None;
        }
        let mut needs = group.around.clone()?;
        for (name, assumed) in self.needed(own, true) {
            if !needs.add(name, assumed?) {
                return None;
            }
        }
        // The largest value that no earlier branch tests.
        let mut others: FxHashMap<&str, AssumedValue> = FxHashMap::default();
        for (name, assumed) in earlier.iter().flat_map(|c| self.needed(c, false)) {
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
    fn needed(
        &self,
        condition: &BranchCondition<'t>,
        truth: bool,
    ) -> Vec<(&'t str, Option<AssumedValue>)> {
        let words: Vec<&'t str> = condition
            .words
            .iter()
            .copied()
            .filter(|w| !matches!(*w, "(" | ")"))
            .collect();
        let word = |i: usize| words.get(i).copied().unwrap_or("");
        let is_test = |i: usize| match condition.directive {
            "ifdef" | "ifndef" => i == 0,
            _ => i > 0 && word(i - 1) == "defined",
        };
        let mut found = Vec::new();
        for (i, name) in words.iter().copied().enumerate() {
            if !self.is_free(name) {
                continue;
            }
            let assumed = if is_test(i) {
                let is_negated = i > 1 && word(i - 2) == "!" || condition.directive == "ifndef";
                match is_negated == truth {
                    true => Some(AssumedValue::Undefined),
                    false => Some(AssumedValue::Defined),
                }
            } else {
                let is_negated = i > 0 && word(i - 1) == "!";
                value(word(i + 1), word(i + 2), truth != is_negated)
            };
            found.push((name, assumed));
        }
        found
    }

    /// Whether a word is a name that a host or a user may define. Names with `GL_` and `__` belong to
    /// the compiler (section 3.4).
    fn is_free(&self, word: &str) -> bool {
        let is_name = word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
        let is_reserved = word.starts_with("GL_") || word.contains("__") || word == "defined";
        is_name && !is_reserved && !self.is_fixed.contains(word)
    }
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
        ("" | "&&" | "||", _) => i64::from(truth),
        _ => return None,
    };
    Some(AssumedValue::Value(value))
}
