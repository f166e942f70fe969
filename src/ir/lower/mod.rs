//! Lowers the checked syntax tree to the [IR](super::form).
//!
//! Everything is lowered, including functions that are never called and code with errors: an
//! expression with a reported error becomes [`OpKind::Unknown`], so that the code around it can
//! still be analysed.

mod call;
mod construct;
mod expression;
mod order;
mod place;
mod precision;
mod statement;
mod writing;

use super::form::*;
use precision::{DefaultPrecisions, Returned};
use shaderlint_semantic::{
    Constant, Direction, FunctionRef, Program, Scalar, Storage, Type, Value, VariableId,
};
use shaderlint_syntax::ast::{DeclId, DeclKind, ExprId, FunctionId, Item, List, TokenId};
use writing::Writing;

/// Maximum nesting of expressions and statements; deeper ones become unknown. Browsers reject trees
/// deeper than 256.
const MAX_DEPTH: u32 = 600;

/// Lowers a shader, in linear time.
pub fn lower(program: &Program) -> Module {
    let exprs = program.tree.exprs.len();
    let mut lowerer = Lowerer {
        program,
        writing: Writing::of(program),
        module: Module {
            stage: Some(program.stage),
            by_expr: vec![None; exprs],
            ops: Vec::with_capacity(exprs),
            provenances: Vec::with_capacity(exprs),
            places: Vec::with_capacity(exprs / 2),
            access_lists: Vec::with_capacity(exprs / 4),
            operand_lists: Vec::with_capacity(exprs / 4),
            ..Module::default()
        },
        precisions: DefaultPrecisions::new(program.stage),
        returned: Returned::default(),
        open: Vec::new(),
        covered: 0,
        origin: Provenance::Language,
        function: None,
        depth: 0,
    };
    lowerer.variables();
    lowerer.items();
    lowerer.module.entry = program.entry();
    lowerer.module
}

struct Lowerer<'p> {
    program: &'p Program,
    writing: Writing,
    module: Module,
    precisions: DefaultPrecisions,
    returned: Returned,
    /// The steps of the regions under construction, the innermost last.
    open: Vec<Step>,
    /// The number of operations already covered by a run or region.
    covered: u32,
    /// The provenance of new operations.
    origin: Provenance,
    function: Option<FunctionRef>,
    depth: u32,
}

impl Lowerer<'_> {
    /// Declares the variables of the program.
    fn variables(&mut self) {
        let program = self.program;
        let root = |storage| match storage {
            Storage::Local => Root::Local,
            Storage::Global => Root::Global,
            Storage::Param(Direction::Out) => Root::ParameterOut,
            Storage::Param(Direction::Inout) => Root::ParameterInout,
            Storage::Param(Direction::In | Direction::ConstIn) => Root::Parameter,
            Storage::Uniform => Root::Uniform,
            Storage::Input => Root::Input,
            Storage::Output => Root::Output,
        };
        let variables = program.variables.iter().map(|v| Variable {
            ty: v.ty,
            precision: precision::of_language(v, program),
            function: v.function,
            root: root(v.storage),
            is_flat: false,
        });
        self.module.variables = variables.collect();
        self.module.functions = program
            .functions
            .iter()
            .map(|f| Function {
                parameters: List::default(),
                returns: f.returns,
                body: None,
                ops: Run {
                    first: OpId(0),
                    len: 0,
                },
            })
            .collect();
    }

    /// Lowers global scope: first all global initialisers, so that their operations form one range,
    /// then the functions.
    fn items(&mut self) {
        let tree = &self.program.tree;
        let mut defined = Vec::new();
        let globals = self.region(|l| {
            for item in &tree.items {
                match item {
                    Item::Decl(id) => l.global(*id),
                    // A `precision` statement applies from its position on, so each function
                    // records the defaults at its own.
                    Item::Function(id) => defined.push((*id, l.precisions.clone())),
                }
            }
        });
        self.module.globals = globals;
        let mut by_definition: Vec<_> = (0..)
            .zip(&self.program.functions)
            .filter_map(|(i, f)| Some((f.definition?, FunctionRef(i))))
            .collect();
        by_definition.sort_unstable_by_key(|(definition, _)| *definition);
        let function_of = |id: FunctionId| {
            let at = by_definition.binary_search_by_key(&id, |(definition, _)| *definition);
            Some(by_definition.get(at.ok()?)?.1)
        };
        // A call may precede the definition of its function.
        for (id, precisions) in &defined {
            if let Some(function) = function_of(*id) {
                self.precisions = precisions.clone();
                self.parameters(function, *id);
            }
        }
        for (id, precisions) in defined {
            if let Some(function) = function_of(id) {
                self.precisions = precisions;
                self.body(function, id);
            }
        }
    }

    fn global(&mut self, id: DeclId) {
        match self.program.tree.decl(id).map(|d| d.kind) {
            Some(DeclKind::Block { members, .. }) => self.block(members),
            Some(_) => self.declaration(id),
            None => {}
        }
    }

    /// Adds an operation with the current provenance.
    fn op(&mut self, kind: OpKind, ty: Type) -> OpId {
        let id = OpId(self.module.ops.len() as u32);
        let precision = match ty.scalar_kind() {
            Some(Scalar::Bool) => Precision::None,
            _ => precision::of_operation(&self.module, &self.returned, kind),
        };
        self.module.ops.push(Op {
            kind,
            ty,
            precision,
        });
        self.module.provenances.push(self.origin);
        id
    }

    /// The id of the next operation.
    fn next_op(&self) -> OpId {
        OpId(self.module.ops.len() as u32)
    }

    /// All operations from `first` on.
    fn run_from(&self, first: OpId) -> Run {
        Run {
            first,
            len: self.next_op().0.saturating_sub(first.0),
        }
    }

    fn operands(&mut self, operands: &[OpId]) -> List {
        let start = self.module.operand_lists.len() as u32;
        self.module.operand_lists.extend_from_slice(operands);
        List {
            start,
            len: operands.len() as u32,
        }
    }

    fn constant(&mut self, values: impl IntoIterator<Item = Value>, ty: Type) -> OpId {
        let constant = self.module.pool.add(values);
        match constant {
            Constant::NONE => self.op(OpKind::Unknown, ty),
            constant => self.op(OpKind::Const(constant), ty),
        }
    }

    /// A constant with the same number in all components of a type.
    fn number(&mut self, number: i32, ty: Type) -> OpId {
        let scalar = ty.scalar_kind().unwrap_or(Scalar::Int);
        let value = Value::Int(number).to(scalar);
        self.constant((0..ty.components()).map(|_| value), ty)
    }

    /// Adds a run for the operations that no step covers yet.
    fn close_run(&mut self) {
        let end = self.module.ops.len() as u32;
        if end > self.covered {
            self.open.push(Step::Run(Run {
                first: OpId(self.covered),
                len: end - self.covered,
            }));
            self.covered = end;
        }
    }

    /// Adds a step after all operations so far.
    fn step(&mut self, step: Step) {
        self.close_run();
        self.open.push(step);
    }

    /// Lowers code into a region of its own.
    fn region(&mut self, fill: impl FnOnce(&mut Self)) -> Region {
        self.close_run();
        let mark = self.open.len();
        fill(self);
        self.close_run();
        let start = self.module.steps.len() as u32;
        self.module.steps.extend(self.open.drain(mark..));
        Region(List {
            start,
            len: self.module.steps.len() as u32 - start,
        })
    }

    /// Lowers code at one more level of nesting; `None` if that is too deep.
    fn deeper<T>(&mut self, lower: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.depth >= MAX_DEPTH {
            return None;
        }
        self.depth += 1;
        let made = lower(self);
        self.depth -= 1;
        Some(made)
    }

    /// A new temporary variable, for a value merged by control flow.
    fn temporary(&mut self, ty: Type) -> PlaceId {
        let variable = self.new_variable(ty, Root::Temporary);
        self.place_of(variable, ty)
    }

    fn new_variable(&mut self, ty: Type, root: Root) -> VariableId {
        let id = VariableId(self.module.variables.len() as u32);
        self.module.variables.push(Variable {
            ty,
            precision: self.precisions.default_of(ty),
            function: self.function,
            root,
            is_flat: false,
        });
        id
    }

    /// The place of a whole variable.
    fn place_of(&mut self, variable: VariableId, ty: Type) -> PlaceId {
        self.add_place(variable, &[], ty)
    }

    fn add_place(&mut self, variable: VariableId, path: &[Access], ty: Type) -> PlaceId {
        let start = self.module.access_lists.len() as u32;
        self.module.access_lists.extend_from_slice(path);
        self.add_place_along(variable, start, ty)
    }

    /// Adds a place whose path is the end of the access list, from `start` on.
    fn add_place_along(&mut self, variable: VariableId, start: u32, ty: Type) -> PlaceId {
        let id = PlaceId(self.module.places.len() as u32);
        let len = self.module.access_lists.len() as u32 - start;
        let path = List { start, len };
        self.module.places.push(Place { variable, path, ty });
        id
    }

    fn load(&mut self, place: PlaceId) -> OpId {
        let ty = self.module.place(place).ty;
        self.op(OpKind::Load(place), ty)
    }

    fn store(&mut self, place: PlaceId, value: OpId) {
        self.op(OpKind::Store(place, value), Type::VOID);
    }

    /// Sets the provenance to the declaration of a name.
    fn at_declaration(&mut self, token: TokenId) {
        self.origin = Provenance::Declaration(token);
    }

    /// Records the operation that computes an expression.
    fn note(&mut self, expr: ExprId, op: OpId) {
        if let Some(slot) = self.module.by_expr.get_mut(expr.0 as usize) {
            *slot = Some(op);
        }
    }
}
