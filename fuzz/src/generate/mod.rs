//! Generates typed programs with scopes, correct by construction unless one error is inserted on
//! purpose. The same seed always gives the same program.
//!
//! `mod.rs` contains the state of a program, `types.rs` its types, `globals.rs` declarations
//! outside functions, `statement.rs` and `expression.rs` function bodies.

mod expression;
mod globals;
mod statement;
mod types;

use crate::mutate::{Random, split};
use shaderlint::semantic::builtins::Builtins;
use shaderlint::semantic::{Stage, Type};
use shaderlint::syntax::Version;

/// A generated program.
pub struct Written {
    /// The stage that it is written for.
    pub stage: Stage,
    /// The source text.
    pub text: String,
    /// Whether it is correct by construction: no error was inserted, and nothing was generated
    /// whose validity depends on values.
    pub is_right: bool,
}

/// The program for a seed.
pub fn generate(seed: u64) -> Written {
    let mut random = Random::new(seed);
    // The first random numbers of small seeds are similar.
    for _ in 0..8 {
        random.below(2);
    }
    let is_300 = random.below(3) > 0;
    let stage = if random.below(3) > 0 {
        Stage::Fragment
    } else {
        Stage::Vertex
    };
    let mistake_in = (random.below(5) > 1).then(|| random.below(160) as u32);
    let version = if is_300 {
        Version::Es300
    } else {
        Version::Es100
    };
    let mut writer = Writer {
        random,
        is_300,
        stage,
        builtins: Builtins::of(version, stage),
        scopes: vec![Scope::default()],
        structs: Vec::new(),
        functions: Vec::new(),
        names: 0,
        constant: false,
        loops: 0,
        switches: 0,
        returns: Type::VOID,
        mistake_in,
        is_right: true,
    };
    let mut text = writer.program();
    if writer.random.below(12) == 0 {
        writer.is_right = false;
        text = writer.break_a_token(&text);
    }
    Written {
        stage,
        text,
        is_right: writer.is_right,
    }
}

/// How a variable may be used.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Use {
    /// `const`, with a constant value.
    Constant,
    /// Readable and writable.
    Free,
    Read,
    /// The index of a loop in GLSL ES 1.00: usable as an index everywhere, never written.
    Index,
}

#[derive(Clone, Debug)]
struct Variable {
    name: String,
    ty: Type,
    usage: Use,
}

#[derive(Clone, Debug)]
struct Record {
    name: String,
    fields: Vec<(String, Type)>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    In,
    Out,
    Inout,
}

#[derive(Clone, Debug)]
struct Function {
    name: String,
    params: Vec<(Way, Type)>,
    returns: Type,
}

/// The declarations between two braces.
#[derive(Default)]
struct Scope {
    variables: Vec<Variable>,
    structs: Vec<usize>,
    /// All names declared in this scope.
    taken: Vec<String>,
}

/// A program that is being generated.
struct Writer {
    random: Random,
    is_300: bool,
    stage: Stage,
    builtins: Builtins,
    scopes: Vec<Scope>,
    structs: Vec<Record>,
    functions: Vec<Function>,
    names: u32,
    /// Whether only constant expressions are allowed.
    constant: bool,
    loops: u32,
    switches: u32,
    returns: Type,
    /// Number of opportunities for an error to skip before one is inserted.
    mistake_in: Option<u32>,
    is_right: bool,
}

impl Writer {
    fn below(&mut self, limit: usize) -> usize {
        self.random.below(limit)
    }

    /// True with probability `1 / n`.
    fn one_in(&mut self, n: usize) -> bool {
        self.random.below(n) == 0
    }

    fn pick<'a>(&mut self, all: &[&'a str]) -> &'a str {
        let at = self.below(all.len());
        all.get(at).copied().unwrap_or("")
    }

    /// Whether to insert the error here. Called at every opportunity.
    fn mistake(&mut self) -> bool {
        match &mut self.mistake_in {
            Some(0) => {
                self.mistake_in = None;
                self.is_right = false;
                true
            }
            Some(n) => {
                *n -= 1;
                false
            }
            None => false,
        }
    }

    /// Marks that validity depends on values, which are not tracked here.
    fn unsure(&mut self) {
        self.is_right = false;
    }

    fn is_fragment(&self) -> bool {
        self.stage == Stage::Fragment
    }

    /// A name for a new declaration; sometimes one that shadows an outer name.
    fn new_name(&mut self, letter: &str) -> String {
        if self.mistake() {
            return match self.below(4) {
                0 => "gl_x".to_string(),
                1 => "a__b".to_string(),
                2 => "filter".to_string(),
                _ => self.some_taken_name(),
            };
        }
        if self.scopes.len() > 1 && self.one_in(8) {
            let name = self.some_taken_name();
            let here = self.scopes.last();
            let is_free = here.is_some_and(|s| !s.taken.contains(&name));
            // The parameters of a function share their scope with its body.
            if is_free && !name.is_empty() {
                return name;
            }
        }
        self.names += 1;
        format!("{letter}{}", self.names)
    }

    fn some_taken_name(&mut self) -> String {
        let all = self.scopes.iter().flat_map(|s| s.taken.clone());
        // A declaration that hides a struct would hide its constructor.
        let all: Vec<String> = all
            .filter(|n| !n.starts_with("gl_") && !n.starts_with('S'))
            .collect();
        let at = self.below(all.len());
        all.get(at).cloned().unwrap_or_default()
    }

    fn take_name(&mut self, name: &str) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.taken.push(name.to_string());
        }
    }

    fn declare(&mut self, name: &str, ty: Type, usage: Use) {
        self.take_name(name);
        if let Some(scope) = self.scopes.last_mut() {
            let name = name.to_string();
            scope.variables.push(Variable { name, ty, usage });
        }
    }

    /// The scope in which a name is declared, counted from the outermost.
    fn scope_of(&self, name: &str) -> Option<usize> {
        // Members of blocks are accessed through the instance.
        let name = name.split(['.', '[']).next().unwrap_or(name);
        let holds = |s: &Scope| s.taken.iter().any(|t| t == name);
        self.scopes.iter().rposition(holds)
    }

    fn visible(&self) -> Vec<Variable> {
        let mut found = Vec::new();
        for (depth, scope) in self.scopes.iter().enumerate() {
            let seen = |v: &&Variable| self.scope_of(&v.name) == Some(depth);
            found.extend(scope.variables.iter().filter(seen).cloned());
        }
        found
    }

    fn in_scope(&mut self, write: impl FnOnce(&mut Writer) -> String) -> String {
        self.scopes.push(Scope::default());
        let text = write(self);
        self.scopes.pop();
        text
    }

    /// Generates only constant expressions.
    fn constantly(&mut self, write: impl FnOnce(&mut Writer) -> String) -> String {
        let before = std::mem::replace(&mut self.constant, true);
        if self.mistake() {
            self.constant = false;
        }
        let text = write(self);
        self.constant = before;
        text
    }

    /// Removes a token, duplicates it, or replaces it by another.
    fn break_a_token(&mut self, text: &str) -> String {
        let mut tokens = split(text);
        let solid = |t: &String| !t.trim().is_empty();
        let places: Vec<usize> = (0..tokens.len()).filter(|&i| solid(&tokens[i])).collect();
        let (a, b) = (self.below(places.len()), self.below(places.len()));
        let (Some(&a), Some(&b)) = (places.get(a), places.get(b)) else {
            return text.to_string();
        };
        match self.below(4) {
            0 => tokens[a].clear(),
            1 => tokens[a] = format!("{0} {0}", tokens[a]),
            2 => tokens.swap(a, b),
            _ => tokens[a] = tokens[b].clone(),
        }
        tokens.concat()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_gives_the_same_program() {
        for seed in 0..50 {
            assert_eq!(generate(seed).text, generate(seed).text);
        }
        assert_ne!(generate(1).text, generate(2).text);
    }

    /// Programs that are correct by construction are accepted: Chromium agrees for over 100,000
    /// seeds.
    #[test]
    fn correct_programs_compile() {
        let right = (0..1000).map(generate).filter(|p| p.is_right);
        let mut count = 0;
        for program in right {
            assert!(
                crate::targets::is_accepted(&program.text, program.stage),
                "{}",
                program.text
            );
            count += 1;
        }
        assert!(count > 200, "{count}");
    }
}
