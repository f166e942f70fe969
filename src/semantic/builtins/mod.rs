//! Built-in functions and variables. Their declarations are GLSL text; the properties of the
//! functions are in `table.rs`.

mod overload;
mod prototype;
mod row;
mod table;

pub use overload::{BuiltinStorage, BuiltinVariable, MAX_PARAMS, Overload};
pub use row::{Axis, BuiltinKind, Level, Lookup, Transfer};
pub use table::BuiltinId;

use super::constant::Value;
use super::fold::set_undefined_to_zero;
use super::types::Type;
use super::undefined::Undefined;
use prototype::Declared;
use shaderlint_syntax::{Extensions, GlContext, GlExtension, Version, WebGl};
use std::ops::Range;

/// The stage of a shader.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Stage {
    /// Vertex shader.
    Vertex,
    /// Fragment shader.
    Fragment,
}

impl Stage {
    /// The other stage of a program.
    pub fn other(self) -> Stage {
        match self {
            Stage::Vertex => Stage::Fragment,
            Stage::Fragment => Stage::Vertex,
        }
    }
}

impl BuiltinId {
    /// The function's name in GLSL.
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// What the function does.
    pub const fn kind(self) -> BuiltinKind {
        self.row().kind
    }

    /// Rough cost of a call: 1 for a single instruction, 4 for a special function unit, 8 for a
    /// texture access.
    pub const fn cost(self) -> f64 {
        self.row().cost as f64
    }

    /// How the range of the result depends on the arguments.
    pub const fn transfer(self) -> Transfer {
        self.row().transfer
    }

    /// The arguments for which the result is undefined.
    pub const fn undefined(self) -> Undefined {
        self.row().undefined
    }

    /// The result for constant arguments, given as scalars; `first` is the type of the first
    /// argument. Zero where the result is undefined, as in the browser; `None` if it is unknown.
    pub fn fold(self, first: Type, args: &[&[Value]]) -> Option<Vec<Value>> {
        let mut made = self.row().fold.fold(first, args)?;
        set_undefined_to_zero(&mut made, self.undefined(), args);
        Some(made)
    }

    /// The operand that it compares and the threshold; the lower one if there are two.
    pub fn comparison<T: Copy>(self, operands: &[T]) -> Option<(T, T)> {
        match (self, operands) {
            (BuiltinId::Step, &[edge, value]) | (BuiltinId::Smoothstep, &[edge, _, value]) => {
                Some((value, edge))
            }
            _ => None,
        }
    }

    /// Whether it interpolates an input of the fragment shader again.
    pub const fn interpolates(self) -> bool {
        use BuiltinId::*;
        matches!(
            self,
            InterpolateAtCentroid | InterpolateAtSample | InterpolateAtOffset
        )
    }

    /// Whether GLSL ES 3.00 shaders may redefine it anyway: extensions known to the browser's
    /// compiler have overloads of it, and the compiler reserves the name only for those. Measured
    /// in Chromium for all built-in names.
    pub const fn is_redefinable(self) -> bool {
        use BuiltinId::*;
        matches!(
            self,
            Mix | TexelFetch | Texture | TextureGrad | TextureLod | TextureSize
        )
    }
}

/// Functions of GLSL ES 1.00 and its extensions, with their replacements.
#[rustfmt::skip]
pub const LEGACY_FUNCTIONS: &[(&str, &str)] = &[
    ("texture2D", "texture"), ("texture2DProj", "textureProj"), ("texture2DLod", "textureLod"),
    ("texture2DProjLod", "textureProjLod"), ("textureCube", "texture"),
    ("textureCubeLod", "textureLod"), ("texture3D", "texture"), ("texture2DLodEXT", "textureLod"),
    ("texture2DProjLodEXT", "textureProjLod"), ("textureCubeLodEXT", "textureLod"),
    ("texture2DGradEXT", "textureGrad"), ("texture2DProjGradEXT", "textureProjGrad"),
    ("textureCubeGradEXT", "textureGrad"), ("shadow2D", "texture"),
];

/// All built-in functions and variables of one version and stage, with those of extensions.
#[derive(Debug)]
struct BuiltinList {
    /// Overloads of all functions, grouped by function.
    overloads: &'static [Overload],
    /// By [`BuiltinId`]: index of its first overload, with the total count as the last entry.
    starts: [u16; BuiltinId::ALL.len() + 1],
    variables: &'static [(&'static str, BuiltinVariable)],
}

/// The built-in functions and variables that a shader can use.
#[derive(Clone, Copy, Debug)]
pub struct Builtins {
    all: &'static BuiltinList,
    version: Version,
    context: GlContext,
    /// The extensions that the shader turns on.
    active: Extensions,
}

/// Builds a [`BuiltinList`] from declarations parsed at compile time.
macro_rules! builtins {
    ($declared:ident) => {
        BuiltinList {
            overloads: &const { $declared.overloads::<{ $declared.count }>() },
            starts: $declared.starts(),
            variables: &const { $declared.variables::<{ $declared.variable_count }>() },
        }
    };
}

/// Common declarations are parsed once to save compile time.
const OF_300: Declared = Declared::NOTHING
    .and(include_str!("declared/functions_300.glsl"))
    .and(include_str!("declared/variables_300.glsl"))
    .and(include_str!("declared/extensions_300.glsl"));
const OF_300_FRAGMENT: Declared = OF_300
    .and(include_str!("declared/functions_300_fragment.glsl"))
    .and(include_str!("declared/variables_300_fragment.glsl"))
    .and(include_str!("declared/extensions_300_fragment.glsl"));
const OF_300_VERTEX: Declared = OF_300
    .and(include_str!("declared/variables_300_vertex.glsl"))
    .and(include_str!("declared/extensions_300_vertex.glsl"))
    .and(include_str!("declared/extensions_vertex.glsl"));
const OF_100: Declared = Declared::NOTHING
    .and(include_str!("declared/functions_100.glsl"))
    .and(include_str!("declared/variables_100.glsl"))
    .and(include_str!("declared/extensions_100.glsl"));
const OF_100_FRAGMENT: Declared = OF_100
    .and(include_str!("declared/functions_100_fragment.glsl"))
    .and(include_str!("declared/variables_100_fragment.glsl"))
    .and(include_str!("declared/extensions_100_fragment.glsl"));
const OF_100_VERTEX: Declared = OF_100
    .and(include_str!("declared/functions_100_vertex.glsl"))
    .and(include_str!("declared/variables_100_vertex.glsl"))
    .and(include_str!("declared/extensions_vertex.glsl"));

static ES_300_FRAGMENT: BuiltinList = builtins!(OF_300_FRAGMENT);
static ES_300_VERTEX: BuiltinList = builtins!(OF_300_VERTEX);
static ES_100_FRAGMENT: BuiltinList = builtins!(OF_100_FRAGMENT);
static ES_100_VERTEX: BuiltinList = builtins!(OF_100_VERTEX);

impl Builtins {
    /// The built-ins of a version and stage in WebGL2, without extensions.
    pub fn of(version: Version, stage: Stage) -> Builtins {
        Builtins {
            all: match (version, stage) {
                (Version::Es300, Stage::Fragment) => &ES_300_FRAGMENT,
                (Version::Es300, Stage::Vertex) => &ES_300_VERTEX,
                (Version::Es100, Stage::Fragment) => &ES_100_FRAGMENT,
                (Version::Es100, Stage::Vertex) => &ES_100_VERTEX,
            },
            version,
            context: GlContext::WEBGL2,
            active: Extensions::NONE,
        }
    }

    /// Those in a context, for a shader that turns on some of its extensions.
    pub fn in_context(self, context: GlContext, active: Extensions) -> Builtins {
        Builtins {
            context,
            active,
            ..self
        }
    }

    /// Whether the shader can use a function or variable of the list.
    fn has(&self, name: &str) -> bool {
        let owner = GlExtension::that_adds(name, self.version);
        owner.is_none_or(|extension| self.active.contains(extension))
    }

    /// The function of this name, if it exists in this version and stage.
    pub fn function(&self, name: &str) -> Option<BuiltinId> {
        let found = BuiltinId::named(name).filter(|id| !self.range(*id).is_empty());
        found.filter(|_| self.has(name))
    }

    /// The function of this name that a shader must not define for itself. In GLSL ES 1.00 it need not
    /// turn on the extension.
    pub fn protected_function(&self, name: &str) -> Option<BuiltinId> {
        let owner = GlExtension::that_adds(name, self.version);
        let is_enabled = |extension| self.context.has(extension, self.version);
        let mut known = *self;
        if self.version == Version::Es100 {
            known
                .active
                .extend(owner.filter(|owner| is_enabled(*owner)));
        }
        known.function(name)
    }

    /// All functions, in table order.
    pub fn functions(&self) -> impl Iterator<Item = BuiltinId> {
        let all = BuiltinId::ALL.iter().copied();
        all.filter(|id| !self.range(*id).is_empty() && self.has(id.name()))
    }

    /// The variable of this name, if it exists in this version and stage.
    pub fn variable(&self, name: &str) -> Option<BuiltinVariable> {
        let mut variables = self.all.variables.iter();
        let found = variables.find(|(n, _)| *n == name && self.has(name));
        let mut variable = found.map(|(_, variable)| *variable)?;
        let (has, is_active) = (
            self.context.has(GlExtension::DrawBuffers, self.version),
            self.active.contains(GlExtension::DrawBuffers),
        );
        match name {
            "gl_FragData" if is_active => {
                variable.ty = variable.ty.map(|ty| ty.element().array_of(8))
            }
            "gl_MaxDrawBuffers" if self.context.webgl == WebGl::One && !has => {
                variable.storage = BuiltinStorage::Const(1);
            }
            _ => {}
        }
        Some(variable)
    }

    /// The names of all variables.
    pub fn variable_names(&self) -> impl Iterator<Item = &'static str> {
        let names = self.all.variables.iter().map(|(name, _)| *name);
        names.filter(|name| self.has(name))
    }

    /// Index of a function's first overload, and all its overloads.
    pub fn overloads_of(&self, function: BuiltinId) -> (u32, &'static [Overload]) {
        let range = self.range(function);
        let overloads = self.all.overloads.get(range.clone());
        (range.start as u32, overloads.unwrap_or(&[]))
    }

    /// The overloads of all functions.
    pub fn overloads(&self) -> impl Iterator<Item = &'static Overload> {
        self.functions()
            .flat_map(|function| self.overloads_of(function).1)
    }

    /// The overload with this index.
    pub fn overload(&self, index: u32) -> Option<&'static Overload> {
        self.all.overloads.get(index as usize)
    }

    /// Index range of a function's overloads.
    fn range(&self, function: BuiltinId) -> Range<usize> {
        let at = |i| self.all.starts.get(i).copied().unwrap_or(0) as usize;
        at(function as usize)..at(function as usize + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_syntax::{ParseOptions, parse_corrected, preprocess};
    use shaderlint_text::{Role, Sources};
    use std::collections::BTreeSet;

    #[test]
    fn generic_prototypes_expand_to_all_overloads() {
        let all = Builtins::of(Version::Es300, Stage::Fragment);
        let count = |name: &str| all.function(name).map(|f| all.overloads_of(f).1.len());
        assert_eq!(count("sin"), Some(4));
        assert_eq!(count("min"), Some(4 + 3 + 4 + 3 + 4 + 3));
        assert_eq!(count("matrixCompMult"), Some(9));
        assert_eq!(count("texture"), Some(3 * 4 + 3 + 3 * 4 + 2));
        assert_eq!(count("nothing"), None);
        assert!(all.all.overloads.iter().all(|o| !o.returns.is_error()));
    }

    #[test]
    fn every_built_in_has_a_prototype() {
        let mut without: BTreeSet<BuiltinId> = BuiltinId::ALL.iter().copied().collect();
        for version in [Version::Es100, Version::Es300] {
            for stage in [Stage::Vertex, Stage::Fragment] {
                for overload in Builtins::of(version, stage).all.overloads {
                    without.remove(&overload.function);
                }
            }
        }
        assert!(without.is_empty(), "no prototype: {without:?}");
    }

    #[test]
    fn parameters_of_texture_lookups_match_the_table() {
        for stage in [Stage::Vertex, Stage::Fragment] {
            for version in [Version::Es100, Version::Es300] {
                for overload in Builtins::of(version, stage).all.overloads {
                    let BuiltinKind::Lookup(lookup) = overload.function.kind() else {
                        continue;
                    };
                    let offset = lookup.has_offset as u8;
                    let level = match lookup.level {
                        // The last argument may be a bias.
                        Level::Implicit => u8::from(overload.count > 2 + offset),
                        Level::Explicit | Level::Fetch => 1,
                        Level::Gradient => 2,
                    };
                    let count = 2 + level + offset;
                    assert_eq!(overload.count, count, "{overload:?}");
                    assert_eq!(overload.constant != 0, lookup.has_offset, "{overload:?}");
                }
            }
        }
    }

    #[test]
    fn built_ins_depend_on_the_stage_and_version() {
        let has = |version, stage, name| Builtins::of(version, stage).function(name).is_some();
        assert!(!has(Version::Es300, Stage::Vertex, "dFdx"));
        assert!(!has(Version::Es100, Stage::Fragment, "texture"));
        assert!(has(Version::Es100, Stage::Vertex, "texture2DLod"));
        let fragment = Builtins::of(Version::Es300, Stage::Fragment);
        assert_eq!(
            fragment.variable("gl_MaxDrawBuffers").map(|v| v.storage),
            Some(BuiltinStorage::Const(8))
        );
        assert_eq!(fragment.variable("gl_DepthRange").map(|v| v.ty), Some(None));
        let old = Builtins::of(Version::Es100, Stage::Fragment);
        let data = old.variable("gl_FragData").and_then(|v| v.ty);
        assert_eq!(data.map(|t| t.array), Some(1));
    }

    #[test]
    fn declarations_of_built_ins_are_valid() {
        for text in [
            include_str!("declared/functions_100.glsl"),
            include_str!("declared/functions_100_fragment.glsl"),
            include_str!("declared/functions_100_vertex.glsl"),
            include_str!("declared/functions_300.glsl"),
            include_str!("declared/functions_300_fragment.glsl"),
            include_str!("declared/variables_100.glsl"),
            include_str!("declared/variables_100_fragment.glsl"),
            include_str!("declared/variables_100_vertex.glsl"),
            include_str!("declared/variables_300.glsl"),
            include_str!("declared/variables_300_fragment.glsl"),
            include_str!("declared/variables_300_vertex.glsl"),
            include_str!("declared/extensions_100.glsl"),
            include_str!("declared/extensions_100_fragment.glsl"),
            include_str!("declared/extensions_300.glsl"),
            include_str!("declared/extensions_300_fragment.glsl"),
            include_str!("declared/extensions_300_vertex.glsl"),
            include_str!("declared/extensions_vertex.glsl"),
        ] {
            let mut sources = Sources::new();
            let files = ["#version 300 es\n", text]
                .map(|text| sources.add("", None, Role::User, text).unwrap());
            let mut read = preprocess(&sources, &files, true, GlContext::WEBGL2);
            let language = ParseOptions {
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
