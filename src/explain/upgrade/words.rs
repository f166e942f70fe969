//! The words that the conversion replaces.

use super::obstacle::{ObstacleKind, UpgradeObstacle};
use super::scan::RawScan;
use shaderlint_semantic::Base;
use shaderlint_semantic::builtins::{Builtins, LEGACY_FUNCTIONS, Stage};
use shaderlint_semantic::parsed::own_name;
use shaderlint_semantic::{Program, Resolution, Storage};
use shaderlint_syntax::ast::{ExprKind, Ident};
use shaderlint_syntax::{Version, WordClass, classify};
use std::collections::{BTreeMap, BTreeSet};

/// The replacement of a word.
#[derive(Debug)]
pub(super) struct Replacement {
    pub to: String,
    /// Whether names of members are replaced as well.
    pub has_members: bool,
    /// The addresses of the only words that are replaced, if others mean something else.
    pub only: Option<BTreeSet<u32>>,
    /// Whether the code around the shader uses the name.
    is_interface: bool,
}

/// Replacements by word.
#[derive(Debug, Default)]
pub(super) struct WordMap(BTreeMap<String, Replacement>);

/// The names that a shader declares.
struct DeclaredNames<'p> {
    functions: BTreeSet<&'p str>,
    members: BTreeSet<&'p str>,
    /// Variables, parameters, structs.
    others: BTreeSet<&'p str>,
    /// Macros and their parameters.
    macros: BTreeSet<&'p str>,
    /// Uniforms, attributes, varyings and members of uniforms.
    interface: BTreeSet<&'p str>,
}

impl<'p> DeclaredNames<'p> {
    fn of(program: &'p Program) -> DeclaredNames<'p> {
        let (tree, names) = (&program.tree, &program.names);
        let text = |ident: Ident| names.text(ident.name);
        let members = tree.field_lists.iter();
        let members = members.flat_map(|f| tree.declarators(f.declarators));
        let members: BTreeSet<&str> = members.map(|d| text(d.ident)).collect();
        let declarators = tree.declarator_lists.iter().zip(&program.declared);
        let variables = declarators.filter(|(_, variable)| variable.is_some());
        let params = tree.param_lists.iter().filter_map(|p| p.ident);
        let structs = tree.structs.iter().filter_map(|s| s.name);
        let others = variables.map(|(d, _)| d.ident).chain(params).chain(structs);
        let macros = program.tokens.macros.iter().filter(|m| !m.predefined);
        let macros = macros.flat_map(|m| m.params.iter().flatten().chain([&m.name]));
        let is_shared =
            |s: Storage| matches!(s, Storage::Uniform | Storage::Input | Storage::Output);
        let shared = program.variables.iter();
        let shared = shared.filter(|v| v.token.is_some() && is_shared(v.storage));
        let mut interface: BTreeSet<&str> = shared.clone().map(|v| names.text(v.name)).collect();
        let mut shared = shared;
        if shared.any(|v| matches!(v.ty.base, Base::Struct(_))) {
            interface.extend(&members);
        }
        DeclaredNames {
            functions: tree.functions.iter().map(|f| text(f.ident)).collect(),
            members,
            others: others.map(text).collect(),
            macros: macros.map(|name| names.text(*name)).collect(),
            interface,
        }
    }

    fn has(&self, word: &str) -> bool {
        let all = [&self.functions, &self.members, &self.others, &self.macros];
        all.into_iter().any(|set| set.contains(word))
    }
}

impl WordMap {
    pub fn of(program: &Program, scan: &RawScan) -> Result<WordMap, UpgradeObstacle> {
        let declared = DeclaredNames::of(program);
        let mut map = WordMap::default();
        let mut needed = BTreeSet::new();
        for (old, new) in LEGACY_FUNCTIONS {
            if scan.has_word(old) && !declared.has(old) {
                map.replace(old, new);
                needed.insert(*new);
            }
        }
        map.replace("attribute", "in");
        let varying = match program.stage {
            Stage::Vertex => "out",
            Stage::Fragment => "in",
        };
        map.replace("varying", varying);
        map.replace("gl_FragDepthEXT", "gl_FragDepth");
        for word in declared.functions.iter().chain(&declared.others) {
            map.rename_reserved(word, &declared, program, scan);
        }
        for word in &declared.members {
            map.rename_reserved(word, &declared, program, scan);
        }
        for word in &declared.functions {
            map.rename_builtin(word, &declared, program, scan)?;
        }
        let hiding = declared.functions.iter().chain(&declared.others);
        for word in hiding.chain(&declared.macros) {
            if needed.contains(*word) {
                map.rename(word, &declared, program, scan);
            }
        }
        Ok(map)
    }

    pub fn get(&self, word: &str) -> Option<&Replacement> {
        self.0.get(word)
    }

    /// The names that the code around the shader uses, and their replacements.
    pub fn renamed_interface(&self) -> Vec<(String, String)> {
        let renamed = self.0.iter().filter(|(_, r)| r.is_interface);
        renamed
            .map(|(old, r)| (old.clone(), r.to.clone()))
            .collect()
    }

    /// Replaces a word of the language.
    pub fn replace(&mut self, old: &str, new: &str) {
        let replacement = Replacement {
            to: new.to_string(),
            has_members: false,
            only: None,
            is_interface: false,
        };
        self.0.insert(old.to_string(), replacement);
    }

    fn rename_reserved(
        &mut self,
        word: &str,
        declared: &DeclaredNames,
        program: &Program,
        scan: &RawScan,
    ) {
        let class = |version| classify(word, version) == WordClass::Plain;
        if class(Version::Es100) && !class(Version::Es300) {
            self.rename(word, declared, program, scan);
        }
    }

    fn rename(&mut self, word: &str, declared: &DeclaredNames, program: &Program, scan: &RawScan) {
        let replacement = Replacement {
            to: self.unused(&own_name(word), program, scan),
            has_members: declared.members.contains(word),
            only: None,
            is_interface: declared.interface.contains(word),
        };
        self.0.entry(word.to_string()).or_insert(replacement);
    }

    /// Renames a function that GLSL ES 3.00 does not allow to declare.
    fn rename_builtin(
        &mut self,
        word: &str,
        declared: &DeclaredNames,
        program: &Program,
        scan: &RawScan,
    ) -> Result<(), UpgradeObstacle> {
        let is_builtin = |version| {
            Builtins::of(version, program.stage)
                .function(word)
                .is_some()
        };
        if !is_builtin(Version::Es300) || self.0.contains_key(word) {
            return Ok(());
        }
        // Other calls may be of the built-in function, and variables may have the same name.
        let is_shared = is_builtin(Version::Es100) || declared.others.contains(word);
        let only = match is_shared {
            true => Some(uses_of(word, is_builtin(Version::Es100), program)?),
            false => None,
        };
        let replacement = Replacement {
            to: self.unused(&own_name(word), program, scan),
            has_members: false,
            only,
            is_interface: false,
        };
        self.0.insert(word.to_string(), replacement);
        Ok(())
    }

    /// A name that neither the shader nor another replacement uses.
    pub fn unused(&self, base: &str, program: &Program, scan: &RawScan) -> String {
        let mut name = base.to_string();
        let mut number = 2;
        let is_used = |name: &str| {
            program.names.get(name).is_some()
                || scan.has_word(name)
                || self.0.values().any(|r| r.to == name)
        };
        while is_used(&name) {
            name = format!("{base}{number}");
            number += 1;
        }
        name
    }
}

/// Where a function of the shader is declared and called.
fn uses_of(
    word: &str,
    was_builtin: bool,
    program: &Program,
) -> Result<BTreeSet<u32>, UpgradeObstacle> {
    let mut tokens = Vec::new();
    for (expr, info) in program.tree.exprs.iter().zip(&program.exprs) {
        let ExprKind::Call(name, _) = expr.kind else {
            continue;
        };
        match info.resolution {
            _ if program.names.text(name) != word => {}
            Resolution::Builtin(_) => {}
            // Its arguments have an error in GLSL ES 1.00.
            Resolution::None if was_builtin => {
                let span = program.span(expr.extent);
                return Err(UpgradeObstacle::at(span, ObstacleKind::UnknownCall));
            }
            _ => tokens.push(expr.extent.first),
        }
    }
    let declared = program.tree.functions.iter().map(|f| f.ident);
    let declared = declared.filter(|ident| program.names.text(ident.name) == word);
    tokens.extend(declared.map(|ident| ident.token));
    let places = tokens
        .into_iter()
        .filter_map(|t| Some(program.token(t)?.spelled));
    Ok(places.collect())
}
