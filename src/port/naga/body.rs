//! Builds a naga function: its expressions, variables and blocks.

use super::lower::NagaLowerer;
use super::sampler::Looked;
use super::stored::StoredPlace;
use super::target::{Res, TargetLanguage, Value};
use super::types::Sink;
use ::naga::front::Typifier;
use ::naga::{Block, Expression, Handle, Literal, LocalVariable, Statement};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::OpId;
use shaderlint_semantic::{Type, VariableId};
use shaderlint_text::Span;

/// Where a variable of the shader is stored in the function.
#[derive(Clone, Copy)]
pub(super) enum Bound {
    /// A variable that never changes, as its value.
    Value(Value),
    /// A pointer to the variable.
    Pointer(Value),
    /// A place in a uniform buffer.
    Stored(StoredPlace),
}

/// The result of an operation.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Emitted {
    /// The value; `None` if there is none, or if it is created on use.
    pub(super) value: Option<Value>,
    /// Nesting depth of the expression.
    pub(super) depth: u32,
}

/// A function under construction.
pub(super) struct Body<'l, 'p> {
    /// The module that it belongs to.
    pub(super) lowerer: &'l mut NagaLowerer<'p>,
    /// The naga function so far.
    pub(super) function: ::naga::Function,
    /// Its variables, including the module's variables that it uses.
    pub(super) variables: FxHashMap<VariableId, Bound>,
    /// Its sampler parameters, by variable and element indexes.
    pub(super) samplers: FxHashMap<(VariableId, Vec<u32>), Looked>,
    /// By call and parameter: the pointer to the copy that is passed.
    pub(super) copies: FxHashMap<(OpId, u32), Value>,
    /// Whether it is inside of a loop.
    pub(super) in_loop: bool,
    /// Whether it is inside of a `switch` without a loop in between; the cases of a `switch` share
    /// variables.
    pub(super) in_switch: bool,
    /// Nesting depth of regions.
    pub(super) depth: u32,
    /// Expressions with a value that the target compiler can evaluate.
    pub(super) known: FxHashSet<Value>,
    /// The types of expressions, computed on demand.
    pub(super) types: Typifier,
    block: Block,
    emitted: usize,
}

impl<'p> Sink<'p> for Body<'_, 'p> {
    fn lowerer(&mut self) -> &mut NagaLowerer<'p> {
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
    /// Starts a function.
    pub(super) fn new(lowerer: &'l mut NagaLowerer<'p>, name: &str) -> Body<'l, 'p> {
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

    pub(super) fn finish(mut self) -> ::naga::Function {
        self.flush();
        self.function.body = self.block;
        self.function
    }

    fn span(&self) -> ::naga::Span {
        let Span { start, end } = self.lowerer.place;
        ::naga::Span::new(start, end)
    }

    /// Emits the expressions that were added since the last flush.
    fn flush(&mut self) {
        let len = self.function.expressions.len();
        if len > self.emitted {
            let range = self.function.expressions.range_from(self.emitted);
            let span = self.span();
            self.block.push(Statement::Emit(range), span);
            self.emitted = len;
        }
    }

    /// Adds a statement after the pending expressions.
    pub(super) fn push(&mut self, statement: Statement) {
        self.flush();
        let span = self.span();
        self.block.push(statement, span);
    }

    pub(super) fn nested(&mut self, fill: impl FnOnce(&mut Self) -> Res<()>) -> Res<Block> {
        self.flush();
        let outer = std::mem::take(&mut self.block);
        let filled = fill(self);
        self.flush();
        let inner = std::mem::replace(&mut self.block, outer);
        filled.map(|()| inner)
    }

    /// Whether the rest of the block is unreachable.
    pub(super) fn is_terminated(&self) -> bool {
        let last = self.block.last();
        last.is_some_and(|s| s.is_terminator() || returns(s))
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

    /// Declares a variable and returns a pointer to it.
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

    /// Stores a value in a new variable and returns a pointer to it.
    pub(super) fn spill(&mut self, value: Value, ty: Type) -> Res<Value> {
        let pointer = self.local(None, ty)?;
        self.store(pointer, value);
        Ok(pointer)
    }

    pub(super) fn store(&mut self, pointer: Value, value: Value) {
        self.push(Statement::Store { pointer, value });
    }

    pub(super) fn load(&mut self, pointer: Value) -> Value {
        self.add(Expression::Load { pointer })
    }

    /// A component, member or element of a value, or a pointer to one.
    pub(super) fn part(&mut self, base: Value, index: u32) -> Value {
        self.add(Expression::AccessIndex { base, index })
    }

    pub(super) fn float(&mut self, value: f32) -> Value {
        self.add(Expression::Literal(Literal::F32(value)))
    }

    /// Composes a value of its components.
    pub(super) fn compose(&mut self, ty: Type, components: Vec<Value>) -> Res<Value> {
        let ty = self.lowerer.ty(ty)?;
        Ok(self.add(Expression::Compose { ty, components }))
    }

    /// The zero value of a type.
    pub(super) fn zero(&mut self, ty: Type) -> Res<Value> {
        if ty.is_array() && self.lowerer.language == TargetLanguage::Hlsl {
            // HLSL accepts this form only as an initialiser in a declaration.
            let nothing = self.local(None, ty)?;
            return Ok(self.load(nothing));
        }
        let ty = self.lowerer.ty(ty)?;
        Ok(self.add(Expression::ZeroValue(ty)))
    }
}

/// Whether a statement returns on all paths.
fn returns(statement: &Statement) -> bool {
    match statement {
        Statement::Return { .. } => true,
        Statement::If { accept, reject, .. } => [accept, reject]
            .iter()
            .all(|side| side.last().is_some_and(returns)),
        _ => false,
    }
}
