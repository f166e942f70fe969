//! The function that is being made: its expressions, variables and blocks.

use super::lower::Lowerer;
use super::sampler::Looked;
use super::stored::Held;
use super::target::{Res, TargetLanguage, Value};
use super::types::Sink;
use ::naga::front::Typifier;
use ::naga::{Block, Expression, Handle, Literal, LocalVariable, Statement};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::OpId;
use shaderlint_semantic::{Type, VariableId};
use shaderlint_text::Span;

/// Where a variable of the shader is found in the function.
#[derive(Clone, Copy)]
pub(super) enum Bound {
    /// It never changes, and this is its value.
    Value(Value),
    /// This points at it.
    Pointer(Value),
    /// It lies in a buffer of uniforms.
    Stored(Held),
}

/// What an operation gave.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Given {
    /// Its value; `None` where it gave none, or who asks for it makes it.
    pub(super) value: Option<Value>,
    /// How deep what it is made of nests.
    pub(super) depth: u32,
}

/// A function that is being made.
pub(super) struct Body<'l, 'p> {
    /// The module.
    pub(super) lowerer: &'l mut Lowerer<'p>,
    /// What there is of it.
    pub(super) function: ::naga::Function,
    /// Its variables, those of the module that it uses included.
    pub(super) variables: FxHashMap<VariableId, Bound>,
    /// The samplers among its parameters, by the numbers of elements that lead to them.
    pub(super) samplers: FxHashMap<(VariableId, Vec<u32>), Looked>,
    /// By call and parameter: what points at the copy that travels there.
    pub(super) copies: FxHashMap<(OpId, u32), Value>,
    /// Whether a loop stands around.
    pub(super) in_loop: bool,
    /// Whether a `switch` stands around, and no loop between, whose cases share their variables.
    pub(super) in_switch: bool,
    /// How deep regions nest.
    pub(super) depth: u32,
    /// The expressions whose value a compiler of what is written knows.
    pub(super) known: FxHashSet<Value>,
    /// The types of expressions, as far as they were asked for.
    pub(super) types: Typifier,
    block: Block,
    emitted: usize,
}

impl<'p> Sink<'p> for Body<'_, 'p> {
    fn lowerer(&mut self) -> &mut Lowerer<'p> {
        self.lowerer
    }

    fn add(&mut self, expression: Expression) -> Value {
        let expression = self.at_run_time(expression);
        let is_known = self.is_known(&expression);
        let is_free = expression.needs_pre_emit();
        if is_free {
            self.flush();
        }
        let span = self.span();
        let handle = self.function.expressions.append(expression, span);
        if is_free {
            self.emitted = self.function.expressions.len();
        }
        if is_known {
            self.known.insert(handle);
        }
        handle
    }
}

impl<'l, 'p> Body<'l, 'p> {
    /// An empty function.
    pub(super) fn new(lowerer: &'l mut Lowerer<'p>, name: &str) -> Body<'l, 'p> {
        Body {
            lowerer,
            function: ::naga::Function {
                name: Some(name.to_string()),
                ..::naga::Function::default()
            },
            variables: FxHashMap::default(),
            samplers: FxHashMap::default(),
            copies: FxHashMap::default(),
            in_loop: false,
            in_switch: false,
            depth: 0,
            known: FxHashSet::default(),
            types: Typifier::new(),
            block: Block::new(),
            emitted: 0,
        }
    }

    /// The finished function.
    pub(super) fn finish(mut self) -> ::naga::Function {
        self.flush();
        self.function.body = self.block;
        self.function
    }

    fn span(&self) -> ::naga::Span {
        let Span { start, end } = self.lowerer.place;
        ::naga::Span::new(start, end)
    }

    /// Makes the block evaluate what was added since.
    fn flush(&mut self) {
        let len = self.function.expressions.len();
        if len > self.emitted {
            let range = self.function.expressions.range_from(self.emitted);
            let span = self.span();
            self.block.push(Statement::Emit(range), span);
            self.emitted = len;
        }
    }

    /// Adds a statement, behind what was evaluated so far.
    pub(super) fn push(&mut self, statement: Statement) {
        self.flush();
        let span = self.span();
        self.block.push(statement, span);
    }

    /// The block that `fill` makes.
    pub(super) fn nested(&mut self, fill: impl FnOnce(&mut Self) -> Res<()>) -> Res<Block> {
        self.flush();
        let outer = std::mem::take(&mut self.block);
        let filled = fill(self);
        self.flush();
        let inner = std::mem::replace(&mut self.block, outer);
        filled.map(|()| inner)
    }

    /// Whether nothing that follows in the block can run.
    pub(super) fn is_terminated(&self) -> bool {
        self.block.last().is_some_and(|s| s.is_terminator())
    }

    /// Calls a function of the module.
    pub(super) fn call(
        &mut self,
        function: Handle<::naga::Function>,
        arguments: Vec<Value>,
        returns: Type,
    ) -> Option<Value> {
        self.flush();
        let result = (!returns.is_void()).then(|| {
            let span = self.span();
            let call = Expression::CallResult(function);
            self.function.expressions.append(call, span)
        });
        self.emitted = self.function.expressions.len();
        self.push(Statement::Call {
            function,
            arguments,
            result,
        });
        result
    }

    /// A new variable; gives what points at it.
    pub(super) fn local(&mut self, name: Option<&str>, ty: Type) -> Res<Value> {
        let ty = self.lowerer.ty(ty)?;
        let span = self.span();
        let variable = LocalVariable {
            name: name.map(str::to_string),
            ty,
            init: None,
        };
        let handle = self.function.local_variables.append(variable, span);
        Ok(self.add(Expression::LocalVariable(handle)))
    }

    /// A new variable that holds a value.
    pub(super) fn spill(&mut self, value: Value, ty: Type) -> Res<Value> {
        let pointer = self.local(None, ty)?;
        self.store(pointer, value);
        Ok(pointer)
    }

    /// Writes a value.
    pub(super) fn store(&mut self, pointer: Value, value: Value) {
        self.push(Statement::Store { pointer, value });
    }

    /// Reads a value.
    pub(super) fn load(&mut self, pointer: Value) -> Value {
        self.add(Expression::Load { pointer })
    }

    /// Part of a value, or what points at part of a variable.
    pub(super) fn part(&mut self, base: Value, index: u32) -> Value {
        self.add(Expression::AccessIndex { base, index })
    }

    /// A number.
    pub(super) fn float(&mut self, value: f32) -> Value {
        self.add(Expression::Literal(Literal::F32(value)))
    }

    /// The parts put together.
    pub(super) fn compose(&mut self, ty: Type, components: Vec<Value>) -> Res<Value> {
        let ty = self.lowerer.ty(ty)?;
        Ok(self.add(Expression::Compose { ty, components }))
    }

    /// Zero in every component.
    pub(super) fn zero(&mut self, ty: Type) -> Res<Value> {
        if ty.is_array() && self.lowerer.language == TargetLanguage::Hlsl {
            // There it is a list at a declaration, and only there.
            let nothing = self.local(None, ty)?;
            return Ok(self.load(nothing));
        }
        let ty = self.lowerer.ty(ty)?;
        Ok(self.add(Expression::ZeroValue(ty)))
    }
}
