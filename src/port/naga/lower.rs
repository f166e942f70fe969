//! The module: what stands around the functions, and in which order they are made.

use super::body::{Body, Given};
use super::function::order;
use super::interface::HostInterface;
use super::port::{entry_name, stage_name, varyings};
use super::special::Special;
use super::target::{FirstRow, LowerOptions, Refused, Res, TargetLanguage, Value};
use super::types::Sink;
use super::{global::Global, uniform::Uniforms};
use ::naga::proc::Layouter;
use ::naga::{Arena, Expression, Handle, Module};
use rustc_hash::FxHashMap;
use shaderlint_ir::{self as ir, Layout, OpId, OpKind};
use shaderlint_semantic::link::{Block, Interface};
use shaderlint_semantic::{
    Function, FunctionRef, Inside, Program, Sampler, Stage, Type, Variable, VariableId,
};
use shaderlint_text::Span;

/// A shader in naga's form.
pub struct Lowered {
    /// The language that it goes into.
    pub language: TargetLanguage,
    /// What a host must know.
    pub interface: HostInterface,
    /// The form.
    pub(super) module: Module,
}

/// The module that is being made.
pub(super) struct Lowerer<'p> {
    pub(super) program: &'p Program,
    /// How its values lie.
    pub(super) layout: Layout,
    /// The program, resolved.
    pub(super) form: &'p ir::Module,
    pub(super) origin: FirstRow,
    pub(super) language: TargetLanguage,
    /// The blocks of uniforms, as their layouts say.
    pub(super) blocks: Vec<Block>,
    /// Whether equal expressions give equal positions in all shaders.
    pub(super) is_position_invariant: bool,
    /// Varyings that another stage has numbered.
    pub(super) varyings: &'p [(String, u32)],
    pub(super) module: Module,
    pub(super) layouter: Layouter,
    pub(super) types: FxHashMap<Type, Handle<::naga::Type>>,
    pub(super) globals: FxHashMap<VariableId, Global>,
    /// Variables of the language, such as `gl_FragCoord`.
    pub(super) specials: FxHashMap<&'static str, Special>,
    pub(super) functions: FxHashMap<FunctionRef, Handle<::naga::Function>>,
    /// `inverse` of each size.
    pub(super) inverses: FxHashMap<u8, Handle<::naga::Function>>,
    /// What reads a texel, by the kind of texture.
    pub(super) fetches: FxHashMap<Sampler, Handle<::naga::Function>>,
    pub(super) uniforms: Uniforms,
    pub(super) interface: HostInterface,
    /// By operation: what it gave, in the function that it belongs to.
    given: Vec<Given>,
    /// By variable: how many operations write to it.
    stores: Vec<u32>,
    /// What is being lowered.
    pub(super) place: Span,
    /// How many expressions the finished functions have.
    pub(super) made: usize,
}

/// Most expressions of a module; bodies of `switch` that fall through are written out again.
const MAX_EXPRESSIONS: usize = 1_000_000;

/// Lowers a shader that compiles.
///
/// # Errors
/// Where the other languages have no words for something.
pub fn lower(program: &Program, options: LowerOptions) -> Result<Lowered, Refused> {
    let form = ir::lower(program);
    let interface = Interface::of(program);
    let varyings = options.vertex.map_or(Vec::new(), varyings);
    let mut lowerer = Lowerer {
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
        inverses: FxHashMap::default(),
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
        given: vec![Given::default(); form.ops.len()],
        stores: stores(&form),
        place: Span::default(),
        made: 0,
    };
    let mut varyings = interface.inputs.iter().chain(&interface.outputs);
    if varyings.any(|v| v.is_invariant) {
        lowerer.note("invariant holds for the position alone");
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

impl<'p> Lowerer<'p> {
    /// Refuses what is being lowered.
    pub(super) fn refuse<T>(&self, message: impl Into<String>) -> Res<T> {
        Err(Refused::new(self.place, message))
    }

    /// What runs is `main`, which stands in the text around a shader of ShaderToy too.
    fn main(&self) -> Res<FunctionRef> {
        let program = self.program;
        let name = program.names.get("main");
        let is_main = |f: &Function| Some(f.name) == name && f.params.is_empty();
        match program.functions.iter().position(is_main) {
            Some(index) => Ok(FunctionRef(index as u32)),
            None => self.refuse("there is no `main`"),
        }
    }

    /// Says where what is lowered now comes from.
    pub(super) fn stand_at(&mut self, origin: ir::Provenance) {
        if let Some(extent) = origin.extent(&self.program.tree) {
            self.place = self.program.span(extent);
        }
    }

    /// Says that what is lowered now is what declares a variable.
    pub(super) fn stand_at_name(&mut self, variable: &Variable) {
        if let Some(span) = self.program.declared_at(variable) {
            self.place = span;
        }
    }

    /// What lies inside a type.
    pub(super) fn inside(&self, ty: Type) -> Inside {
        let structs = &self.program.structs;
        let of = |id: u16| structs.get(id as usize).map(|s| s.inside);
        Inside::of(ty, |id| of(id).unwrap_or_default())
    }

    /// What an operation gave.
    pub(super) fn given(&self, id: OpId) -> Given {
        self.given.get(id.0 as usize).copied().unwrap_or_default()
    }

    /// Keeps what an operation gave.
    pub(super) fn give(&mut self, id: OpId, given: Given) {
        if let Some(slot) = self.given.get_mut(id.0 as usize) {
            *slot = given;
        }
    }

    /// How many operations write to a variable.
    pub(super) fn stores(&self, id: VariableId) -> u32 {
        self.stores.get(id.0 as usize).copied().unwrap_or(0)
    }

    /// What the shader calls a variable.
    pub(super) fn name(&self, id: VariableId) -> Option<&'p str> {
        let variable = self.program.variable(id)?;
        Some(self.program.names.text(variable.name))
    }

    /// Adds a finished function.
    pub(super) fn define(&mut self, function: ::naga::Function) -> Res<Handle<::naga::Function>> {
        self.made += function.expressions.len();
        if self.made > MAX_EXPRESSIONS {
            return self.refuse("this is too long when it is written out");
        }
        let span = ::naga::Span::new(self.place.start, self.place.end);
        Ok(self.module.functions.append(function, span))
    }
}

/// By variable: how many operations write to it.
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

/// The initialisers of the module.
pub(super) struct Initialisers<'l, 'p> {
    pub(super) lowerer: &'l mut Lowerer<'p>,
    pub(super) arena: Arena<Expression>,
}

impl<'l, 'p> Initialisers<'l, 'p> {
    /// Takes them out of the module, to be put back with [`Initialisers::finish`].
    pub(super) fn new(lowerer: &'l mut Lowerer<'p>) -> Initialisers<'l, 'p> {
        let arena = std::mem::take(&mut lowerer.module.global_expressions);
        Initialisers { lowerer, arena }
    }

    pub(super) fn finish(self) {
        self.lowerer.module.global_expressions = self.arena;
    }
}

impl<'p> Sink<'p> for Initialisers<'_, 'p> {
    fn lowerer(&mut self) -> &mut Lowerer<'p> {
        self.lowerer
    }

    fn add(&mut self, expression: Expression) -> Value {
        self.arena.append(expression, ::naga::Span::UNDEFINED)
    }
}

impl Body<'_, '_> {
    /// Asks that what is being lowered does not nest too deep and has not grown too long.
    pub(super) fn check_limits(&self) -> Res<()> {
        /// The deepest nesting: what the browser takes, with room for what it folds.
        const MAX_DEPTH: u32 = 400;
        if self.depth > MAX_DEPTH {
            return self.lowerer.refuse("this nests too deep");
        }
        if self.lowerer.made + self.function.expressions.len() > MAX_EXPRESSIONS {
            return self
                .lowerer
                .refuse("this is too long when it is written out");
        }
        Ok(())
    }
}
