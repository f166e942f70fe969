//! What the language defines: functions and variables. Their declarations are GLSL text; what the
//! functions do stands in `table.rs`.

mod prototype;
mod row;
mod table;

pub use row::{Axis, BuiltinKind, Level, Lookup, Transfer};
pub use table::BuiltinId;

use super::constant::Value;
use super::fold::Folding;
use super::types::Type;
use crate::syntax::Version;
use crate::syntax::ast::QualifierKind;
use prototype::{Prototype, declarations, read_variable};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::sync::OnceLock;

/// Most parameters of a built-in function.
pub const MAX_PARAMS: usize = 5;

/// The stage a shader is written for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Stage {
    /// Vertex shader.
    Vertex,
    /// Fragment shader.
    Fragment,
}

impl BuiltinId {
    /// As it is written.
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// The function of a name, in whatever version. Looks through the table, so it is for words that
    /// are looked at once.
    pub fn named(name: &str) -> Option<BuiltinId> {
        BuiltinId::ALL.iter().copied().find(|id| id.name() == name)
    }

    /// What it does.
    pub const fn kind(self) -> BuiltinKind {
        self.row().kind
    }

    /// What a call costs, on a rough scale: one for what is one instruction, four for what takes a
    /// special unit, eight for a texture.
    pub const fn cost(self) -> f64 {
        self.row().cost as f64
    }

    /// What is known of its result's range.
    pub const fn transfer(self) -> Transfer {
        self.row().transfer
    }

    /// How it is computed of constants.
    pub const fn folding(self) -> Folding {
        self.row().fold
    }

    /// Whether shaders in GLSL ES 3.00 may define it anew all the same: extensions that the
    /// browser's compiler knows have forms of their own of each, and it takes the names for theirs
    /// alone. Measured in Chromium over all built-in names.
    pub const fn is_redefinable(self) -> bool {
        use BuiltinId::*;
        matches!(
            self,
            Mix | TexelFetch | Texture | TextureGrad | TextureLod | TextureSize
        )
    }
}

/// One form of a built-in function.
#[derive(Clone, Debug)]
pub struct Overload {
    /// Its function.
    pub function: BuiltinId,
    /// Types of the parameters; unused places are `void`.
    pub params: [Type; MAX_PARAMS],
    /// Number of parameters.
    pub count: u8,
    /// Bit `i` is set if parameter `i` is `out`.
    pub out: u8,
    /// Bit `i` is set if argument `i` must be a constant expression.
    pub constant: u8,
    /// What it yields.
    pub returns: Type,
}

impl Overload {
    /// The types of its parameters.
    pub fn params(&self) -> &[Type] {
        self.params
            .get(..self.count as usize)
            .unwrap_or(&self.params)
    }

    /// Whether it writes to the argument at a position.
    pub fn writes(&self, position: usize) -> bool {
        self.out & 1 << position != 0
    }

    /// Whether its last argument shifts the level that a lookup reads.
    pub fn has_bias(&self) -> bool {
        match self.function.kind() {
            BuiltinKind::Lookup(lookup) => {
                lookup.level == Level::Implicit && self.count > 2 + lookup.has_offset as u8
            }
            BuiltinKind::Math | BuiltinKind::Derivative(_) | BuiltinKind::Size => false,
        }
    }

    /// Its result of constant arguments, given as scalars; `None` where it is not known.
    pub fn fold(&self, args: &[&[Value]]) -> Option<Vec<Value>> {
        let first = self.params().first().copied().unwrap_or(Type::VOID);
        self.function.folding().fold(first, args)
    }
}

/// How a built-in variable may be used.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BuiltinStorage {
    /// Read only, different at each fragment or vertex.
    In,
    /// Written by the shader.
    Out,
    /// Read only, the same everywhere.
    Uniform,
    /// A constant of this value.
    Const(i32),
}

/// A built-in variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BuiltinVariable {
    /// Its type; `None` for the struct of `gl_DepthRange`, with the members `near`, `far`, `diff`.
    pub ty: Option<Type>,
    /// How it may be used.
    pub storage: BuiltinStorage,
    /// How exact it is, where the language says.
    pub precision: Option<QualifierKind>,
}

/// Everything that one version of the language defines for one stage.
#[derive(Default, Debug)]
pub struct Builtins {
    /// The overloads of all functions, those of one function side by side.
    pub overloads: Vec<Overload>,
    /// By [`BuiltinId`]: where its overloads are.
    ranges: Vec<Range<u32>>,
    by_name: FxHashMap<&'static str, BuiltinId>,
    variables: FxHashMap<&'static str, BuiltinVariable>,
}

impl Builtins {
    /// What `version` defines for `stage`; read at the first call.
    pub fn of(version: Version, stage: Stage) -> &'static Builtins {
        static ALL: [OnceLock<Builtins>; 4] = [
            OnceLock::new(),
            OnceLock::new(),
            OnceLock::new(),
            OnceLock::new(),
        ];
        let index = (version == Version::Es300) as usize * 2 + (stage == Stage::Fragment) as usize;
        match ALL.get(index) {
            Some(cell) => cell.get_or_init(|| load(version, stage)),
            None => {
                static NONE: OnceLock<Builtins> = OnceLock::new();
                NONE.get_or_init(Builtins::default)
            }
        }
    }

    /// The function of this name.
    pub fn function(&self, name: &str) -> Option<BuiltinId> {
        self.by_name.get(name).copied()
    }

    /// All functions, in the order of the table.
    pub fn functions(&self) -> impl Iterator<Item = BuiltinId> {
        let all = BuiltinId::ALL.iter().zip(&self.ranges);
        all.filter(|(_, range)| !range.is_empty())
            .map(|(id, _)| *id)
    }

    /// The variable of this name.
    pub fn variable(&self, name: &str) -> Option<BuiltinVariable> {
        self.variables.get(name).copied()
    }

    /// The number of a function's first overload, and its overloads.
    pub fn overloads_of(&self, function: BuiltinId) -> (u32, &[Overload]) {
        let range = self.ranges.get(function as usize).cloned();
        let range = range.unwrap_or_default();
        let overloads = self.overloads.get(range.start as usize..range.end as usize);
        (range.start, overloads.unwrap_or(&[]))
    }

    /// An overload by its number.
    pub fn overload(&self, number: u32) -> Option<&Overload> {
        self.overloads.get(number as usize)
    }
}

fn texts(version: Version, stage: Stage) -> Vec<&'static str> {
    match (version, stage) {
        (Version::Es300, Stage::Fragment) => vec![
            include_str!("functions_300.glsl"),
            include_str!("functions_300_fragment.glsl"),
            include_str!("variables_300.glsl"),
            include_str!("variables_300_fragment.glsl"),
        ],
        (Version::Es300, Stage::Vertex) => vec![
            include_str!("functions_300.glsl"),
            include_str!("variables_300.glsl"),
            include_str!("variables_300_vertex.glsl"),
        ],
        (Version::Es100, Stage::Fragment) => vec![
            include_str!("functions_100.glsl"),
            include_str!("functions_100_fragment.glsl"),
            include_str!("variables_100.glsl"),
            include_str!("variables_100_fragment.glsl"),
        ],
        (Version::Es100, Stage::Vertex) => vec![
            include_str!("functions_100.glsl"),
            include_str!("functions_100_vertex.glsl"),
            include_str!("variables_100.glsl"),
            include_str!("variables_100_vertex.glsl"),
        ],
    }
}

fn load(version: Version, stage: Stage) -> Builtins {
    let ids: FxHashMap<&str, BuiltinId> =
        BuiltinId::ALL.iter().map(|id| (id.name(), *id)).collect();
    let mut overloads: Vec<Vec<Overload>> = vec![Vec::new(); BuiltinId::ALL.len()];
    let mut builtins = Builtins::default();
    for line in texts(version, stage).into_iter().flat_map(declarations) {
        if let Some(prototype) = Prototype::read(line) {
            let id = ids.get(prototype.name).copied();
            if let Some((id, forms)) = id.and_then(|id| Some((id, overloads.get_mut(id as usize)?)))
            {
                prototype.expand(id, forms);
            }
        } else if let Some((name, variable)) = read_variable(line) {
            builtins.variables.insert(name, variable);
        }
    }
    builtins.by_name = ids;
    for (id, forms) in BuiltinId::ALL.iter().zip(overloads) {
        let start = builtins.overloads.len() as u32;
        builtins.overloads.extend(forms);
        let range = start..builtins.overloads.len() as u32;
        if range.is_empty() {
            builtins.by_name.remove(id.name());
        }
        builtins.ranges.push(range);
    }
    builtins
}

impl BuiltinStorage {
    /// The value of a constant.
    pub fn value(self) -> Option<Value> {
        match self {
            BuiltinStorage::Const(value) => Some(Value::Int(value)),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::{Language, parse_corrected, preprocess};
    use crate::text::{Role, Sources};
    use std::collections::BTreeSet;

    #[test]
    fn generic_prototypes_stand_for_all_their_forms() {
        let all = Builtins::of(Version::Es300, Stage::Fragment);
        let count = |name: &str| all.function(name).map(|f| all.overloads_of(f).1.len());
        assert_eq!(count("sin"), Some(4));
        assert_eq!(count("min"), Some(4 + 3 + 4 + 3 + 4 + 3));
        assert_eq!(count("matrixCompMult"), Some(9));
        assert_eq!(count("texture"), Some(3 * 4 + 3 + 3 * 4 + 2));
        assert_eq!(count("nothing"), None);
        assert!(all.overloads.iter().all(|o| !o.returns.is_error()));
    }

    #[test]
    fn rows_and_prototypes_belong_together() {
        let mut without: BTreeSet<BuiltinId> = BuiltinId::ALL.iter().copied().collect();
        for version in [Version::Es100, Version::Es300] {
            for stage in [Stage::Vertex, Stage::Fragment] {
                for overload in &Builtins::of(version, stage).overloads {
                    without.remove(&overload.function);
                }
                let prototypes = texts(version, stage).concat();
                let lines = prototypes.lines().filter(|l| !l.starts_with("//"));
                for line in lines.filter(|l| l.ends_with(");")) {
                    let name = line.split(['(', ' ']).nth(1);
                    assert!(name.and_then(BuiltinId::named).is_some(), "{line}");
                }
            }
        }
        assert!(without.is_empty(), "no prototype: {without:?}");
    }

    #[test]
    fn what_a_lookup_takes_tells_its_parameters() {
        for stage in [Stage::Vertex, Stage::Fragment] {
            for version in [Version::Es100, Version::Es300] {
                for overload in &Builtins::of(version, stage).overloads {
                    let BuiltinKind::Lookup(lookup) = overload.function.kind() else {
                        assert!(!overload.has_bias());
                        continue;
                    };
                    let level = match lookup.level {
                        Level::Implicit => overload.has_bias() as u8,
                        Level::Explicit | Level::Fetch => 1,
                        Level::Gradient => 2,
                    };
                    let count = 2 + level + lookup.has_offset as u8;
                    assert_eq!(overload.count, count, "{overload:?}");
                    assert_eq!(overload.constant != 0, lookup.has_offset, "{overload:?}");
                }
            }
        }
    }

    #[test]
    fn stages_and_versions_differ() {
        assert!(
            Builtins::of(Version::Es300, Stage::Vertex)
                .function("dFdx")
                .is_none()
        );
        assert!(
            Builtins::of(Version::Es100, Stage::Fragment)
                .function("texture")
                .is_none()
        );
        assert!(
            Builtins::of(Version::Es100, Stage::Vertex)
                .function("texture2DLod")
                .is_some()
        );
        let fragment = Builtins::of(Version::Es300, Stage::Fragment);
        assert_eq!(
            fragment.variable("gl_MaxDrawBuffers").map(|v| v.storage),
            Some(BuiltinStorage::Const(8))
        );
        assert_eq!(fragment.variable("gl_DepthRange").map(|v| v.ty), Some(None));
        let old = Builtins::of(Version::Es100, Stage::Fragment);
        assert_eq!(
            old.variable("gl_FragData")
                .and_then(|v| v.ty)
                .map(|t| t.array),
            Some(1)
        );
    }

    #[test]
    fn the_texts_are_read_without_errors() {
        for version in [Version::Es100, Version::Es300] {
            for stage in [Stage::Vertex, Stage::Fragment] {
                for text in texts(version, stage) {
                    for line in declarations(text) {
                        let is_read =
                            Prototype::read(line).is_some() || read_variable(line).is_some();
                        assert!(is_read, "{line}");
                    }
                    let mut sources = Sources::new();
                    let files = [
                        sources
                            .add("", None, Role::User, "#version 300 es\n")
                            .unwrap(),
                        sources.add("", None, Role::User, text).unwrap(),
                    ];
                    let mut read = preprocess(&sources, &files, true);
                    let language = Language {
                        version: Version::Es300,
                        is_fragment: true,
                    };
                    let tokens = &mut read.tokens;
                    let parse = parse_corrected(&sources, tokens, &read.names, language, &[]);
                    let errors = parse.diagnostics;
                    assert!(
                        read.diagnostics.is_empty() && errors.is_empty(),
                        "{errors:?}"
                    );
                }
            }
        }
    }
}
