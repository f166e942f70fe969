//! The IR: functions of a checked shader as typed operations with structured control flow.
//!
//! Lowering resolves everything that depends on the source: overloads, conversions, swizzles,
//! variables and the order of evaluation. All data is in flat vectors of the [`Module`]. Operations
//! are numbered in evaluation order, one function after another, so that a basic region
//! (straight-line code) is a range of ids.

use shaderlint_semantic::{
    BuiltinId, Constant, FunctionRef, Pool, Scalar, Stage, Type, VariableId,
};
use shaderlint_syntax::ast::{ExprId, Extent, List, StmtId, TokenId, Tree};

/// Index of an [`Op`], and of its value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct OpId(pub u32);

/// Index of a [`Place`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct PlaceId(pub u32);

/// Index of a [`Loop`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct LoopId(pub u32);

/// Index of a [`Switch`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct SwitchId(pub u32);

/// A lowered shader. Immutable after lowering.
#[derive(Clone, Default, Debug)]
pub struct Module {
    /// All operations.
    pub ops: Vec<Op>,
    /// By operation: its origin in the source.
    pub provenances: Vec<Provenance>,
    /// All places that are loaded or stored.
    pub places: Vec<Place>,
    /// The paths of places.
    pub access_lists: Vec<Access>,
    /// Operands of operations with a variable number of operands.
    pub operand_lists: Vec<OpId>,
    /// The steps of all regions.
    pub steps: Vec<Step>,
    /// All loops.
    pub loops: Vec<Loop>,
    /// All `switch` statements.
    pub switches: Vec<Switch>,
    /// The cases of all `switch` statements.
    pub case_lists: Vec<Case>,
    /// The labels of all cases.
    pub label_lists: Vec<CaseLabel>,
    /// The variables of the program, with the same ids, followed by the temporaries of lowering.
    pub variables: Vec<Variable>,
    /// By [`FunctionRef`]; prototypes without a definition have no body.
    pub functions: Vec<Function>,
    /// The parameters of all functions.
    pub parameter_lists: Vec<VariableId>,
    /// Global initialisers, in order; run before the entry point.
    pub globals: Region,
    /// The entry point, which runs for each pixel or vertex.
    pub entry: Option<FunctionRef>,
    /// The values of constants.
    pub pool: Pool,
    /// The shader stage.
    pub stage: Option<Stage>,
    /// By expression: the operation that computes it.
    pub(super) by_expr: Vec<Option<OpId>>,
}

/// A function.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Range in [`Module::parameter_lists`]; unnamed parameters have variables, too.
    pub parameters: List,
    /// The return type.
    pub returns: Type,
    /// The body; `None` for a prototype.
    pub body: Option<Region>,
    /// All operations of the body.
    pub ops: Run,
}

/// A variable: the storage of a place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Variable {
    /// The declared type.
    pub ty: Type,
    /// The precision, declared or by default.
    pub precision: Precision,
    /// The function that declares it; `None` for variables that outlive calls.
    pub function: Option<FunctionRef>,
    /// The storage class.
    pub root: Root,
    /// Whether it is `flat`, i.e. not interpolated.
    pub is_flat: bool,
}

/// The storage class of a variable.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Root {
    /// A local variable, which lives from its declaration to the end of the call.
    Local,
    /// A temporary made by lowering, for a value merged by control flow.
    Temporary,
    /// An `in` parameter.
    Parameter,
    /// An `out` parameter: undefined on entry, copied back to the caller.
    ParameterOut,
    /// An `inout` parameter.
    ParameterInout,
    /// A global variable.
    Global,
    /// A uniform, constant for a draw call.
    Uniform,
    /// An input of the stage.
    Input,
    /// An output of the stage.
    Output,
}

/// The precision of a value (GLSL ES 3.00 section 4.5).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Debug)]
pub enum Precision {
    /// No precision: a `bool`, or a value whose operands have none.
    #[default]
    None,
    /// `lowp`
    Low,
    /// `mediump`
    Medium,
    /// `highp`
    High,
}

/// A variable or part of a variable that can be loaded or stored.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Place {
    /// The variable.
    pub variable: VariableId,
    /// The path into the variable, a range in [`Module::access_lists`].
    pub path: List,
    /// The type of the part.
    pub ty: Type,
}

/// A step of a path. `Lanes` can only be the last.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Access {
    /// A member of a struct or block, by index.
    Member(u32),
    /// An element of an array or a column of a matrix, by constant index.
    Element(u32),
    /// An element of an array, a column of a matrix or a component of a vector, by dynamic index.
    Computed(OpId),
    /// A swizzle.
    Lanes(Lanes),
}

/// A swizzle: up to four components of a vector, in order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Lanes {
    lanes: [u8; 4],
    len: u8,
}

/// An operation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Op {
    /// The opcode and operands.
    pub kind: OpKind,
    /// The type of its value; `void` if there is none.
    pub ty: Type,
    /// The precision of its value.
    pub precision: Precision,
}

/// The opcode and operands of an operation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum OpKind {
    /// A compile-time constant in [`Module::pool`].
    Const(Constant),
    /// The undefined value of an uninitialised variable.
    Undef,
    /// An expression with an error, about which nothing is known.
    Unknown,
    /// Loads a place.
    Load(PlaceId),
    /// Stores to a place; has no value.
    Store(PlaceId, OpId),
    /// A unary operation, applied to each component.
    Unary(Unary, OpId),
    /// A binary operation on operands of equal type, applied to each component; the operands of a
    /// shift may have different integer types.
    Binary(Binary, OpId, OpId),
    /// A matrix product: matrix by matrix, matrix by vector, or vector by matrix.
    MatrixProduct(OpId, OpId),
    /// Equality (`==`) of two values of equal type, over all components, elements and members.
    Same {
        /// Whether the result is negated (`!=`).
        negated: bool,
        /// The left operand.
        left: OpId,
        /// The right operand.
        right: OpId,
    },
    /// Selects a value by a scalar condition; both values are evaluated.
    Select {
        /// The condition.
        condition: OpId,
        /// The value if it is true.
        then: OpId,
        /// The value if it is false.
        otherwise: OpId,
    },
    /// Converts each component to the scalar type of the operation.
    Convert(OpId),
    /// Copies a scalar to all components.
    Splat(OpId),
    /// Selects components of a vector; the result is a scalar if there is one.
    Swizzle(OpId, Lanes),
    /// Composes a vector from scalars and vectors, a matrix from columns, an array from elements,
    /// or a struct from members. The operands are in [`Module::operand_lists`].
    Compose(List),
    /// The element, column or member at a constant index.
    Extract(OpId, u32),
    /// The element, column or component at a dynamic index.
    ExtractComputed {
        /// The array, matrix or vector.
        base: OpId,
        /// The index.
        index: OpId,
    },
    /// Calls a built-in function. The operands are in [`Module::operand_lists`], without `out`
    /// arguments.
    Builtin(BuiltinId, List),
    /// Calls a user-defined function, with one operand per parameter in [`Module::operand_lists`];
    /// the operand of an `out` parameter is [`OpKind::Undef`]. Results of `out` parameters are
    /// stored after the call.
    Call(FunctionRef, List),
    /// The value of the `out` or `inout` parameter at this index after a call.
    Returned(OpId, u32),
}

/// Unary operators.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Unary {
    /// `-`
    Negate,
    /// `!`
    Not,
    /// `~`
    BitNot,
}

/// Binary operators.
#[expect(missing_docs, reason = "the variants are standard terms")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum Binary {
    Add, Subtract, Multiply, Divide, Remainder,
    ShiftLeft, ShiftRight, BitAnd, BitOr, BitXor,
    Less, LessEqual, Greater, GreaterEqual,
    /// `&&` with both operands evaluated.
    And,
    /// `||` with both operands evaluated.
    Or,
    /// `^^`
    Xor,
}

/// A run of operations with consecutive ids.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Run {
    /// The first operation.
    pub first: OpId,
    /// The number of operations.
    pub len: u32,
}

/// A sequence of steps, as a range in [`Module::steps`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Region(pub List);

/// A step of a region.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Step {
    /// Operations, in order.
    Run(Run),
    /// A branch.
    If {
        /// The condition, a `bool`.
        condition: OpId,
        /// Runs if it is true.
        then: Region,
        /// Runs if it is false.
        otherwise: Region,
        /// The statement or expression of the branch.
        origin: Provenance,
    },
    /// A loop.
    Loop(LoopId),
    /// A `switch`.
    Switch(SwitchId),
    /// Leaves the innermost loop or `switch`.
    Break(StmtId),
    /// Continues with the next iteration of the innermost loop.
    Continue(StmtId),
    /// Returns from the function, with its value.
    Return(Option<OpId>, StmtId),
    /// Discards the pixel.
    Discard(StmtId),
}

/// A loop. `for` and `while` run test, body, step in each iteration; `do` runs body, test.
/// `continue` jumps to the end of the body. The initialiser of a `for` precedes the loop.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Loop {
    /// Computes the condition.
    pub test: Region,
    /// The loop continues while this is true; endlessly if there is none.
    pub condition: Option<OpId>,
    /// The body.
    pub body: Region,
    /// The step expression of a `for`, run after each iteration.
    pub step: Region,
    /// Whether the condition is tested before the first iteration; `false` for `do`.
    pub tests_first: bool,
    /// All operations of the test, body and step.
    pub ops: Run,
    /// The loop statement.
    pub stmt: StmtId,
}

/// A `switch`. Cases fall through unless they end in a jump.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Switch {
    /// The selector, an `int` or `uint`.
    pub selector: OpId,
    /// Range in [`Module::case_lists`].
    pub cases: List,
    /// The `switch` statement.
    pub stmt: StmtId,
}

/// The statements of a `switch` after one or more labels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Case {
    /// Range in [`Module::label_lists`].
    pub labels: List,
    /// The statements up to the next label.
    pub body: Region,
}

/// The label of a case.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CaseLabel {
    /// The bits of an `int` or `uint`.
    Value(u32),
    /// `default`
    Default,
}

/// The origin of an operation in the source.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Provenance {
    /// An expression, or an operation needed for it.
    Expr(ExprId),
    /// The declaration of a variable, by the token of its name.
    Declaration(TokenId),
    /// A statement.
    Stmt(StmtId),
    /// Implicit behaviour of the language, without a source position.
    Language,
}

const _: () = assert!(size_of::<Op>() <= 28);
const _: () = assert!(size_of::<Step>() <= 32);

impl Root {
    /// Whether it is a parameter.
    pub const fn is_parameter(self) -> bool {
        use Root::*;
        matches!(self, Parameter | ParameterOut | ParameterInout)
    }
}

impl Precision {
    /// The qualifier as written in GLSL; empty for none.
    pub const fn name(self) -> &'static str {
        match self {
            Precision::None => "",
            Precision::Low => "lowp",
            Precision::Medium => "mediump",
            Precision::High => "highp",
        }
    }
}

impl Provenance {
    /// The source range; `None` if there is none.
    pub fn extent(self, tree: &Tree) -> Option<Extent> {
        match self {
            Provenance::Expr(id) => Some(tree.expr(id).extent),
            Provenance::Declaration(token) => Some(Extent::token(token)),
            Provenance::Stmt(id) => Some(tree.stmt(id).extent),
            Provenance::Language => None,
        }
    }
}

impl Lanes {
    /// A swizzle of the components with these indices; more than four are ignored.
    pub fn new(numbers: impl IntoIterator<Item = u8>) -> Lanes {
        let mut made = Lanes::default();
        for (slot, number) in made.lanes.iter_mut().zip(numbers) {
            *slot = number & 3;
            made.len += 1;
        }
        made
    }

    /// The indices of the components.
    pub fn numbers(&self) -> &[u8] {
        self.lanes.get(..self.len as usize).unwrap_or(&[])
    }

    /// The number of components.
    pub const fn count(&self) -> u8 {
        self.len
    }

    /// The swizzle `inner` applied to the result of this one.
    pub fn pick(&self, inner: Lanes) -> Lanes {
        let at = |n: &u8| self.numbers().get(*n as usize).copied().unwrap_or(0);
        Lanes::new(inner.numbers().iter().map(at))
    }
}

impl Run {
    /// The ids of the operations.
    pub fn ops(self) -> impl DoubleEndedIterator<Item = OpId> + ExactSizeIterator {
        (self.first.0..self.first.0 + self.len).map(OpId)
    }

    /// Whether it contains an operation.
    pub const fn contains(self, op: OpId) -> bool {
        self.first.0 <= op.0 && op.0 < self.first.0 + self.len
    }
}

impl Binary {
    /// The operator as written in GLSL.
    pub const fn symbol(self) -> &'static str {
        match self {
            Binary::Add => "+",
            Binary::Subtract => "-",
            Binary::Multiply => "*",
            Binary::Divide => "/",
            Binary::Remainder => "%",
            Binary::ShiftLeft => "<<",
            Binary::ShiftRight => ">>",
            Binary::BitAnd => "&",
            Binary::BitOr => "|",
            Binary::BitXor => "^",
            Binary::Less => "<",
            Binary::LessEqual => "<=",
            Binary::Greater => ">",
            Binary::GreaterEqual => ">=",
            Binary::And => "&&",
            Binary::Or => "||",
            Binary::Xor => "^^",
        }
    }

    /// Whether it is a comparison operator.
    pub const fn compares(self) -> bool {
        use Binary::*;
        matches!(self, Less | LessEqual | Greater | GreaterEqual)
    }
}

/// The items of a list.
fn list<T>(all: &[T], list: List) -> &[T] {
    let start = list.start as usize;
    all.get(start..start + list.len as usize).unwrap_or(&[])
}

impl Module {
    const NO_OP: Op = Op {
        kind: OpKind::Unknown,
        ty: Type::ERROR,
        precision: Precision::None,
    };
    const NO_PLACE: Place = Place {
        variable: VariableId(u32::MAX),
        path: List { start: 0, len: 0 },
        ty: Type::ERROR,
    };

    /// An operation; `Unknown` if the id belongs to another module.
    pub fn op(&self, id: OpId) -> &Op {
        self.ops.get(id.0 as usize).unwrap_or(&Module::NO_OP)
    }

    /// The type of an operation's value.
    pub fn ty(&self, id: OpId) -> Type {
        self.op(id).ty
    }

    /// The component of an operand that component `lane` of a componentwise result depends on: a
    /// scalar has only one.
    pub fn operand_lane(&self, operand: OpId, lane: u32) -> u32 {
        match self.ty(operand).is_scalar() {
            true => 0,
            false => lane,
        }
    }

    /// The origin of an operation.
    pub fn provenance(&self, id: OpId) -> Provenance {
        let origin = self.provenances.get(id.0 as usize);
        origin.copied().unwrap_or(Provenance::Language)
    }

    /// The operation that computes an expression. `None` inside a constant expression, and where
    /// the value is unused and has no side effects.
    pub fn op_of(&self, expr: ExprId) -> Option<OpId> {
        self.by_expr.get(expr.0 as usize).copied().flatten()
    }

    /// A place; one without a variable if the id belongs to another module.
    pub fn place(&self, id: PlaceId) -> &Place {
        self.places.get(id.0 as usize).unwrap_or(&Module::NO_PLACE)
    }

    /// The path of a place.
    pub fn path(&self, place: &Place) -> &[Access] {
        list(&self.access_lists, place.path)
    }

    /// A variable; `None` if the id belongs to another module.
    pub fn variable(&self, id: VariableId) -> Option<&Variable> {
        self.variables.get(id.0 as usize)
    }

    /// A function; `None` if the id belongs to another module.
    pub fn function(&self, id: FunctionRef) -> Option<&Function> {
        self.functions.get(id.0 as usize)
    }

    /// The parameters of a function.
    pub fn parameters(&self, function: &Function) -> &[VariableId] {
        list(&self.parameter_lists, function.parameters)
    }

    /// The steps of a region.
    pub fn steps(&self, region: Region) -> &[Step] {
        list(&self.steps, region.0)
    }

    /// The operands in a list.
    pub fn operands(&self, operands: List) -> &[OpId] {
        list(&self.operand_lists, operands)
    }

    /// A loop; `None` if the id belongs to another module.
    pub fn looped(&self, id: LoopId) -> Option<&Loop> {
        self.loops.get(id.0 as usize)
    }

    /// A `switch`; `None` if the id belongs to another module.
    pub fn switch(&self, id: SwitchId) -> Option<&Switch> {
        self.switches.get(id.0 as usize)
    }

    /// The cases of a `switch`.
    pub fn cases(&self, switch: &Switch) -> &[Case] {
        list(&self.case_lists, switch.cases)
    }

    /// The labels of a case.
    pub fn labels(&self, case: &Case) -> &[CaseLabel] {
        list(&self.label_lists, case.labels)
    }

    /// The scalars of a constant; empty for other operations.
    pub fn constant(&self, id: OpId) -> &[shaderlint_semantic::Value] {
        match self.op(id).kind {
            OpKind::Const(constant) => self.pool.values(constant),
            _ => &[],
        }
    }

    /// Calls `each` with every operand of an operation, in evaluation order, including the dynamic
    /// indices of its place.
    pub fn each_operand(&self, id: OpId, mut each: impl FnMut(OpId)) {
        match self.op(id).kind {
            OpKind::Const(_) | OpKind::Undef | OpKind::Unknown => {}
            OpKind::Load(place) => self.each_index(place, each),
            OpKind::Store(place, value) => {
                self.each_index(place, &mut each);
                each(value);
            }
            OpKind::Unary(_, a)
            | OpKind::Convert(a)
            | OpKind::Splat(a)
            | OpKind::Swizzle(a, _)
            | OpKind::Extract(a, _)
            | OpKind::Returned(a, _) => each(a),
            OpKind::Binary(_, a, b)
            | OpKind::MatrixProduct(a, b)
            | OpKind::Same {
                left: a, right: b, ..
            }
            | OpKind::ExtractComputed { base: a, index: b } => {
                each(a);
                each(b);
            }
            OpKind::Select {
                condition,
                then,
                otherwise,
            } => [condition, then, otherwise].into_iter().for_each(each),
            OpKind::Compose(list) | OpKind::Builtin(_, list) | OpKind::Call(_, list) => {
                self.operands(list).iter().copied().for_each(each);
            }
        }
    }

    /// Calls `each` with the dynamic indices in the path of a place.
    pub fn each_index(&self, place: PlaceId, mut each: impl FnMut(OpId)) {
        for access in self.path(self.place(place)) {
            if let Access::Computed(index) = access {
                each(*index);
            }
        }
    }

    /// The scalar type of a value's components; `None` for samplers, structs and the like.
    pub fn scalar(&self, id: OpId) -> Option<Scalar> {
        self.ty(id).scalar_kind()
    }
}
