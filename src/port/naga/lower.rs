//! Builds the naga module: declarations first, then functions in dependency order.

use super::body::{Body, Emitted};
use super::function::order;
use super::interface::HostInterface;
use super::port::{entry_name, stage_name, varyings};
use super::special::Special;
use super::target::{FirstRow, LowerOptions, Refused, Res, TargetLanguage, Value};
use super::types::Sink;
use super::{global::Global, uniform::Uniforms};
use ::naga::proc::Layouter;
use ::naga::{Arena, Expression, Handle, Module};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{self as ir, Layout, OpId, OpKind};
use shaderlint_semantic::interface::{Block, Interface};
use shaderlint_semantic::{
    Function, FunctionRef, Inside, Program, Sampler, Stage, Type, Variable, VariableId,
};
use shaderlint_text::{SetAt, Span};

/// A shader as a naga module.
pub struct Lowered {
    /// The target language.
    pub language: TargetLanguage,
    /// The resource interface.
    pub interface: HostInterface,
    pub(super) module: Module,
}

/// A module under construction.
pub(super) struct NagaLowerer<'p> {
    pub(super) program: &'p Program,
    /// The memory layout of its types.
    pub(super) layout: Layout,
    /// The IR of the program.
    pub(super) form: &'p ir::Module,
    pub(super) origin: FirstRow,
    pub(super) language: TargetLanguage,
    /// The uniform blocks with their layouts.
    pub(super) blocks: Vec<Block>,
    /// Whether `gl_Position` is `invariant`.
    pub(super) is_position_invariant: bool,
    /// Locations of varyings that the vertex shader determines.
    pub(super) varyings: &'p [(String, u32)],
    pub(super) module: Module,
    pub(super) layouter: Layouter,
    pub(super) types: FxHashMap<Type, Handle<::naga::Type>>,
    pub(super) globals: FxHashMap<VariableId, Global>,
    /// Built-in variables, such as `gl_FragCoord`.
    pub(super) specials: FxHashMap<&'static str, Special>,
    pub(super) functions: FxHashMap<FunctionRef, Handle<::naga::Function>>,
    /// Functions that take derivatives, also in functions that they call.
    pub(super) deriving: FxHashSet<FunctionRef>,
    /// `inverse` functions by matrix size.
    pub(super) inverses: FxHashMap<u8, Handle<::naga::Function>>,
    /// `smoothstep` functions by type.
    pub(super) smoothsteps: FxHashMap<Type, Handle<::naga::Function>>,
    /// Functions that read a texel, by sampler type.
    pub(super) fetches: FxHashMap<Sampler, Handle<::naga::Function>>,
    pub(super) uniforms: Uniforms,
    pub(super) interface: HostInterface,
    /// By operation: its result in its function.
    given: Vec<Emitted>,
    /// By variable: the number of stores to it.
    stores: Vec<u32>,
    /// The span that is being lowered, for error messages.
    pub(super) place: Span,
    /// Number of expressions in the finished functions.
    pub(super) made: usize,
}

/// Maximum number of expressions in a module; `switch` cases with fallthrough are duplicated.
const MAX_EXPRESSIONS: usize = 1_000_000;

/// Lowers a shader that compiles.
///
/// # Errors
/// If the target language does not support something.
pub fn lower(program: &Program, options: LowerOptions) -> Result<Lowered, Refused> {
    let form = ir::lower(program);
    let interface = Interface::of(program);
    let varyings = options.vertex.map_or(Vec::new(), varyings);
    let mut lowerer = NagaLowerer {
        program,
        layout: Layout::of(program),
        form: &form,
        origin: options.first_row,
        is_position_invariant: interface.is_invariant("gl_Position"),
        blocks: interface.blocks.clone(),
        language: options.language,
        varyings: &varyings,
        module: Module::default(),
        layouter: Layouter::default(),
        types: FxHashMap::default(),
        globals: FxHashMap::default(),
        specials: FxHashMap::default(),
        functions: FxHashMap::default(),
        deriving: FxHashSet::default(),
        inverses: FxHashMap::default(),
        smoothsteps: FxHashMap::default(),
        fetches: FxHashMap::default(),
        uniforms: Uniforms::default(),
        interface: HostInterface {
            stage: stage_name(program.stage),
            entry: entry_name(program.stage),
            first_row: (program.stage == Stage::Fragment).then_some(options.first_row),
            pass: None,
            buffers: Vec::new(),
            textures: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            notes: Vec::new(),
        },
        given: vec![Emitted::default(); form.ops.len()],
        stores: stores(&form),
        place: Span::default(),
        made: 0,
    };
    let mut varyings = interface.inputs.iter().chain(&interface.outputs);
    if varyings.any(|v| v.is_invariant) {
        lowerer.note("`invariant` applies to gl_Position only");
    }
    let main = lowerer.main()?;
    lowerer.declare_uniforms()?;
    lowerer.declare_globals()?;
    for function in order(&form, main) {
        lowerer.function(function)?;
    }
    lowerer.entry(main)?;
    Ok(Lowered {
        language: options.language,
        interface: lowerer.interface,
        module: lowerer.module,
    })
}

impl<'p> NagaLowerer<'p> {
    /// Returns an error at the current span.
    pub(super) fn refuse<T>(&self, message: impl Into<String>) -> Res<T> {
        Err(Refused::new(self.place, message))
    }

    /// Finds `main`, which for ShaderToy is in the surrounding text.
    fn main(&self) -> Res<FunctionRef> {
        let program = self.program;
        let name = program.names.get("main");
        let is_main = |f: &Function| Some(f.name) == name && f.params.is_empty();
        match program.functions.iter().position(is_main) {
            Some(index) => Ok(FunctionRef(index as u32)),
            None => self.refuse("missing `main` function"),
        }
    }

    /// Sets the current span to the origin of an operation.
    pub(super) fn stand_at(&mut self, origin: ir::Provenance) {
        if let Some(extent) = origin.extent(&self.program.tree) {
            self.place = self.program.span(extent);
        }
    }

    /// Sets the current span to the declaration of a variable.
    pub(super) fn stand_at_name(&mut self, variable: &Variable) {
        if let Some(span) = self.program.declared_at(variable) {
            self.place = span;
        }
    }

    /// The properties of a type's members.
    pub(super) fn inside(&self, ty: Type) -> Inside {
        let structs = &self.program.structs;
        let of = |id: u16| structs.get(id as usize).map(|s| s.inside);
        Inside::of(ty, |id| of(id).unwrap_or_default())
    }

    /// The result of an operation.
    pub(super) fn given(&self, id: OpId) -> Emitted {
        self.given.get(id.0 as usize).copied().unwrap_or_default()
    }

    /// Records the result of an operation.
    pub(super) fn give(&mut self, id: OpId, given: Emitted) {
        self.given.set_at(id.0 as usize, given);
    }

    /// The number of stores to a variable.
    pub(super) fn stores(&self, id: VariableId) -> u32 {
        self.stores.get(id.0 as usize).copied().unwrap_or(0)
    }

    /// The name of a variable in the shader.
    pub(super) fn name(&self, id: VariableId) -> Option<&'p str> {
        let variable = self.program.variable(id)?;
        Some(self.program.names.text(variable.name))
    }

    /// Adds a finished function.
    pub(super) fn define(&mut self, function: ::naga::Function) -> Res<Handle<::naga::Function>> {
        self.made += function.expressions.len();
        if self.made > MAX_EXPRESSIONS {
            return self.refuse("the expanded shader is too large");
        }
        let span = ::naga::Span::new(self.place.start, self.place.end);
        Ok(self.module.functions.append(function, span))
    }
}

/// By variable: the number of stores to it.
fn stores(form: &ir::Module) -> Vec<u32> {
    let mut count = vec![0; form.variables.len()];
    for op in &form.ops {
        if let OpKind::Store(place, _) = op.kind
            && let Some(count) = count.get_mut(form.place(place).variable.0 as usize)
        {
            *count += 1;
        }
    }
    count
}

/// The global expressions of the module.
pub(super) struct Initialisers<'l, 'p> {
    pub(super) lowerer: &'l mut NagaLowerer<'p>,
    pub(super) arena: Arena<Expression>,
}

impl<'l, 'p> Initialisers<'l, 'p> {
    /// Takes them out of the module; [`Initialisers::finish`] puts them back.
    pub(super) fn new(lowerer: &'l mut NagaLowerer<'p>) -> Initialisers<'l, 'p> {
        let arena = std::mem::take(&mut lowerer.module.global_expressions);
        Initialisers { lowerer, arena }
    }

    pub(super) fn finish(self) {
        self.lowerer.module.global_expressions = self.arena;
    }
}

impl<'p> Sink<'p> for Initialisers<'_, 'p> {
    fn lowerer(&mut self) -> &mut NagaLowerer<'p> {
        self.lowerer
    }

    fn add(&mut self, expression: Expression) -> Value {
        self.arena.append(expression, ::naga::Span::UNDEFINED)
    }
}

impl Body<'_, '_> {
    /// Checks the limits for nesting and size.
    pub(super) fn check_limits(&self) -> Res<()> {
        /// Maximum nesting: the browser's limit, with a margin for expressions that it folds.
        const MAX_DEPTH: u32 = 400;
        if self.depth > MAX_DEPTH {
            return self.lowerer.refuse("nesting is too deep");
        }
        if self.lowerer.made + self.function.expressions.len() > MAX_EXPRESSIONS {
            return self.lowerer.refuse("the expanded shader is too large");
        }
        Ok(())
    }
}
