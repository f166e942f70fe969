//! The module: what stands around the functions, and in which order they are made.

use super::body::Body;
use super::function::order;
use super::types::Sink;
use super::weight::{Weight, weights};
use super::{Refused, Res, Value};
use super::{global::Global, uniform::Uniforms};
use crate::semantic::{FunctionRef, Program, Type, VariableId};
use crate::syntax::ast::ExprId;
use crate::text::Span;
use ::naga::proc::Layouter;
use ::naga::{Arena, Expression, Handle, Module};
use rustc_hash::FxHashMap;

/// Where the first row of the picture lies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// Below, as in OpenGL: the pass is read by others, by the number of the row.
    Row,
    /// On top, as the other interfaces show pictures: rows are turned, so that the picture stands
    /// upright.
    Picture,
}

/// A pass in naga's form.
pub struct Lowered {
    /// The form.
    pub(super) module: Module,
    /// What the host must know: the places of uniforms, textures and samplers.
    pub(super) legend: Vec<String>,
}

/// The module that is being made.
pub(super) struct Lowerer<'p> {
    pub(super) program: &'p Program,
    pub(super) origin: Origin,
    pub(super) module: Module,
    pub(super) layouter: Layouter,
    pub(super) types: FxHashMap<Type, Handle<::naga::Type>>,
    pub(super) globals: FxHashMap<VariableId, Global>,
    /// Globals by what naga itself calls them, such as `gl_FragCoord`.
    pub(super) builtins: FxHashMap<&'static str, Handle<::naga::GlobalVariable>>,
    pub(super) functions: FxHashMap<FunctionRef, Handle<::naga::Function>>,
    /// `inverse` of each size.
    pub(super) inverses: FxHashMap<u8, Handle<::naga::Function>>,
    pub(super) uniforms: Uniforms,
    pub(super) weights: Vec<Weight>,
    /// What is being lowered.
    pub(super) place: Span,
    /// How many expressions the finished functions have.
    pub(super) made: usize,
}

/// Most expressions of a module; bodies of `switch` that fall through are written out again.
const MAX_EXPRESSIONS: usize = 1_000_000;

/// Lowers a fragment shader that compiles.
pub fn lower(program: &Program, origin: Origin) -> Result<Lowered, Refused> {
    let mut lowerer = Lowerer {
        program,
        origin,
        module: Module::default(),
        layouter: Layouter::default(),
        types: FxHashMap::default(),
        globals: FxHashMap::default(),
        builtins: FxHashMap::default(),
        functions: FxHashMap::default(),
        inverses: FxHashMap::default(),
        uniforms: Uniforms::default(),
        weights: weights(program),
        place: Span::default(),
        made: 0,
    };
    let main = lowerer.main()?;
    lowerer.declare_uniforms()?;
    lowerer.declare_globals()?;
    for function in order(program, main) {
        lowerer.function(function)?;
    }
    lowerer.entry(main)?;
    let legend = lowerer.legend();
    Ok(Lowered {
        module: lowerer.module,
        legend,
    })
}

impl<'p> Lowerer<'p> {
    /// Refuses what is being lowered.
    pub(super) fn refuse<T>(&self, message: impl Into<String>) -> Res<T> {
        Err(Refused::new(self.place, message))
    }

    /// What is known of the cost of an expression.
    pub(super) fn weight(&self, id: ExprId) -> Weight {
        self.weights.get(id.0 as usize).copied().unwrap_or_default()
    }

    fn main(&self) -> Res<FunctionRef> {
        let program = self.program;
        let name = program.names.get("main");
        let at = program
            .functions
            .iter()
            .position(|f| Some(f.name) == name && f.params.is_empty());
        match at {
            Some(index) => Ok(FunctionRef(index as u32)),
            None => self.refuse("there is no `main`"),
        }
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
