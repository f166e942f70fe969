//! The form: functions of a checked shader as typed operations and structured control flow.
//!
//! What a reader never has to ask again is settled here: which overload is called, what is
//! converted to what, which lanes of which variable are meant, and in which order it all happens.
//! Everything lies in flat vectors of the [`Module`]; operations are numbered in the order of
//! evaluation, functions one after another, so that the operations of one stretch of straight code
//! are a range of numbers.

use shaderlint_semantic::{
    BuiltinId, Constant, FunctionRef, Pool, Scalar, Stage, Type, VariableId,
};
use shaderlint_syntax::ast::{ExprId, Extent, List, StmtId, TokenId, Tree};

/// Index of an [`Op`], and of the value that it gives.
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

/// A shader, resolved. Never changed once it is lowered.
#[derive(Clone, Default, Debug)]
pub struct Module {
    /// All operations.
    pub ops: Vec<Op>,
    /// By operation: where it comes from.
    pub provenances: Vec<Provenance>,
    /// All places that are read or written.
    pub places: Vec<Place>,
    /// The ways into places.
    pub access_lists: Vec<Access>,
    /// Operands of the operations that have any number of them.
    pub operand_lists: Vec<OpId>,
    /// The steps of regions.
    pub steps: Vec<Step>,
    /// All loops.
    pub loops: Vec<Loop>,
    /// All `switch` statements.
    pub switches: Vec<Switch>,
    /// The cases of `switch` statements.
    pub case_lists: Vec<Case>,
    /// What the cases stand for.
    pub label_lists: Vec<CaseLabel>,
    /// The shader's variables under their own numbers, then those that lowering made.
    pub variables: Vec<Variable>,
    /// By [`FunctionRef`]; a function that is only declared has no body.
    pub functions: Vec<Function>,
    /// Parameters of functions.
    pub parameter_lists: Vec<VariableId>,
    /// The initial values of globals, in order; runs before the entry.
    pub globals: Region,
    /// The function that runs for each pixel or vertex.
    pub entry: Option<FunctionRef>,
    /// The values of constants.
    pub pool: Pool,
    /// The stage.
    pub stage: Option<Stage>,
    /// By expression: the operation that gives its value.
    pub(super) by_expr: Vec<Option<OpId>>,
}

/// A function.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Its parameters, in [`Module::parameter_lists`]; one without a name has a variable too.
    pub parameters: List,
    /// What it returns.
    pub returns: Type,
    /// What it does; `None` where it is only declared.
    pub body: Option<Region>,
    /// Its operations.
    pub ops: Run,
}

/// A variable: storage that places start from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Variable {
    /// Its type.
    pub ty: Type,
    /// How exact it is.
    pub precision: Precision,
    /// The function that it belongs to; `None` for what outlives all calls.
    pub function: Option<FunctionRef>,
    /// Where it lives.
    pub root: Root,
    /// Whether it is `flat`: the same all over a triangle.
    pub is_flat: bool,
}

/// Where a variable lives and how long.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Root {
    /// In a call of its function, from its declaration on.
    Local,
    /// Made by lowering, for a value that control flow brings together.
    Temporary,
    /// An `in` parameter.
    Parameter,
    /// An `out` parameter: undefined when a call begins, taken back by the caller.
    ParameterOut,
    /// An `inout` parameter.
    ParameterInout,
    /// At global scope, as long as the shader runs.
    Global,
    /// Set for all pixels or vertices of a draw.
    Uniform,
    /// `in` of the stage.
    Input,
    /// `out` of the stage.
    Output,
}

/// How exact a value is (GLSL ES 3.00 section 4.5).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Debug)]
pub enum Precision {
    /// It has none, such as a `bool`, or nothing that it is made of has one.
    #[default]
    None,
    /// `lowp`
    Low,
    /// `mediump`
    Medium,
    /// `highp`
    High,
}

/// Something that can be read or written: a variable, or a part of one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Place {
    /// The variable.
    pub variable: VariableId,
    /// The way into it, in [`Module::access_lists`].
    pub path: List,
    /// The type of what stands there.
    pub ty: Type,
}

/// A step on the way into a variable. `Lanes` is the last one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Access {
    /// The member of a struct or block with this number.
    Member(u32),
    /// The element of an array, or the column of a matrix, with this number.
    Element(u32),
    /// The element of an array, the column of a matrix or the component of a vector whose number is
    /// computed.
    Computed(OpId),
    /// Some components of a vector.
    Lanes(Lanes),
}

/// Up to four components of a vector, in the order in which they are taken.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Lanes {
    lanes: [u8; 4],
    len: u8,
}

/// An operation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Op {
    /// What it does.
    pub kind: OpKind,
    /// The type of its value; `void` where it gives none.
    pub ty: Type,
    /// How exact its value is.
    pub precision: Precision,
}

/// What an operation does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum OpKind {
    /// A value known before the shader runs, in [`Module::pool`].
    Const(Constant),
    /// Whatever was there: the value of what was never written.
    Undef,
    /// A value that nothing is known of, since its expression has an error.
    Unknown,
    /// What stands at a place.
    Load(PlaceId),
    /// Writes to a place; gives nothing.
    Store(PlaceId, OpId),
    /// One operand; component by component.
    Unary(Unary, OpId),
    /// Two operands of one type, component by component; a shift may have operands of different
    /// integer types.
    Binary(Binary, OpId, OpId),
    /// The product of linear algebra: matrix by matrix, matrix by vector, vector by matrix.
    MatrixProduct(OpId, OpId),
    /// Whether all components, elements and members of two values of one type are equal; with
    /// `true`, whether any differ.
    Same {
        /// Whether the answer is turned round: `!=`.
        negated: bool,
        /// One value.
        left: OpId,
        /// The other.
        right: OpId,
    },
    /// The one or the other by a scalar condition; both have been computed.
    Select {
        /// The condition.
        condition: OpId,
        /// The value where it holds.
        then: OpId,
        /// The value where it does not.
        otherwise: OpId,
    },
    /// The same components as another kind of scalar: that of the operation's type.
    Convert(OpId),
    /// Every component is this scalar.
    Splat(OpId),
    /// Some components of a vector; a scalar where it is one.
    Swizzle(OpId, Lanes),
    /// Put together: of a vector, from scalars and vectors with as many components; of a matrix,
    /// from its columns; of an array, from its elements; of a struct, from its members. Operands in
    /// [`Module::operand_lists`].
    Compose(List),
    /// The element, column or member with this number.
    Extract(OpId, u32),
    /// The element, column or component whose number is computed.
    ExtractComputed {
        /// The array, matrix or vector.
        base: OpId,
        /// The number.
        index: OpId,
    },
    /// A built-in function; arguments that it only writes to are left out. Operands in
    /// [`Module::operand_lists`].
    Builtin(BuiltinId, List),
    /// A function of the shader: one operand for each parameter, in [`Module::operand_lists`]; that
    /// of an `out` parameter is [`OpKind::Undef`]. What comes back is stored behind it.
    Call(FunctionRef, List),
    /// What a call left in the parameter with this number.
    Returned(OpId, u32),
}

/// Operators with one operand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Unary {
    /// `-`
    Negate,
    /// `!`
    Not,
    /// `~`
    BitNot,
}

/// Operators with two operands.
#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum Binary {
    Add, Subtract, Multiply, Divide, Remainder,
    ShiftLeft, ShiftRight, BitAnd, BitOr, BitXor,
    Less, LessEqual, Greater, GreaterEqual,
    /// `&&` of operands that have both been computed.
    And,
    /// `||` of operands that have both been computed.
    Or,
    /// `^^`
    Xor,
}

/// A run of operations with consecutive numbers.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Run {
    /// The first.
    pub first: OpId,
    /// How many.
    pub len: u32,
}

/// Steps that run one after another, in [`Module::steps`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Region(pub List);

/// A step of a region.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Step {
    /// Operations, in order.
    Run(Run),
    /// The one or the other.
    If {
        /// A `bool`.
        condition: OpId,
        /// Runs where it is true.
        then: Region,
        /// Runs where it is false.
        otherwise: Region,
        /// The statement or expression.
        origin: Provenance,
    },
    /// Again and again.
    Loop(LoopId),
    /// One of several.
    Switch(SwitchId),
    /// Leaves the innermost loop or `switch`.
    Break(StmtId),
    /// Goes on with the next turn of the innermost loop.
    Continue(StmtId),
    /// Leaves the function.
    Return(Option<OpId>, StmtId),
    /// Ends the pixel.
    Discard(StmtId),
}

/// A loop. `for` and `while`: condition, body, step, and again; `do`: body, condition, and again.
/// `continue` goes to what follows the body. What `for` does first stands before the loop.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Loop {
    /// Computes the condition.
    pub test: Region,
    /// Goes on while this is true; always, where there is none.
    pub condition: Option<OpId>,
    /// The body.
    pub body: Region,
    /// What `for` does after each turn.
    pub step: Region,
    /// Whether the condition is looked at before the first turn: not in `do`.
    pub tests_first: bool,
    /// All operations of the condition, the body and the step.
    pub ops: Run,
    /// The statement.
    pub stmt: StmtId,
}

/// A `switch`. A case that does not end in a jump goes on with the next.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Switch {
    /// An `int` or `uint`.
    pub selector: OpId,
    /// In [`Module::case_lists`].
    pub cases: List,
    /// The statement.
    pub stmt: StmtId,
}

/// Statements of a `switch` behind one or more labels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Case {
    /// In [`Module::label_lists`].
    pub labels: List,
    /// The statements up to the next label.
    pub body: Region,
}

/// What a case stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CaseLabel {
    /// A value, as the bits of an `int` or `uint`.
    Value(u32),
    /// `default`
    Default,
}

/// Where something comes from.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Provenance {
    /// An expression, or what had to be done for it.
    Expr(ExprId),
    /// The declaration of a variable: the token of its name.
    Declaration(TokenId),
    /// A statement.
    Stmt(StmtId),
    /// Nothing in the text: what the language does by itself.
    Language,
}

const _: () = assert!(size_of::<Op>() <= 28);
const _: () = assert!(size_of::<Step>() <= 32);

impl Root {
    /// Whether it is a parameter of a function.
    pub const fn is_parameter(self) -> bool {
        use Root::*;
        matches!(self, Parameter | ParameterOut | ParameterInout)
    }
}

impl Precision {
    /// As it is written; nothing where there is none.
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
    /// Where that stands in the text; `None` for nothing in it.
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
    /// The components with these numbers, the first four of them.
    pub fn new(numbers: impl IntoIterator<Item = u8>) -> Lanes {
        let mut made = Lanes::default();
        for (slot, number) in made.lanes.iter_mut().zip(numbers) {
            *slot = number & 3;
            made.len += 1;
        }
        made
    }

    /// The numbers of the components.
    pub fn numbers(&self) -> &[u8] {
        self.lanes.get(..self.len as usize).unwrap_or(&[])
    }

    /// How many there are.
    pub const fn count(&self) -> u8 {
        self.len
    }

    /// The components that are picked by picking `inner` out of these.
    pub fn pick(&self, inner: Lanes) -> Lanes {
        let at = |n: &u8| self.numbers().get(*n as usize).copied().unwrap_or(0);
        Lanes::new(inner.numbers().iter().map(at))
    }
}

impl Run {
    /// The numbers of the operations.
    pub fn ops(self) -> impl DoubleEndedIterator<Item = OpId> + ExactSizeIterator {
        (self.first.0..self.first.0 + self.len).map(OpId)
    }

    /// Whether an operation is one of them.
    pub const fn contains(self, op: OpId) -> bool {
        self.first.0 <= op.0 && op.0 < self.first.0 + self.len
    }
}

impl Binary {
    /// As the operator is written in GLSL.
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

    /// Whether it compares two numbers and gives a `bool`.
    pub const fn compares(self) -> bool {
        use Binary::*;
        matches!(self, Less | LessEqual | Greater | GreaterEqual)
    }
}

/// The entries of a list.
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

    /// An operation; one that nothing is known of where the number is not this module's.
    pub fn op(&self, id: OpId) -> &Op {
        self.ops.get(id.0 as usize).unwrap_or(&Module::NO_OP)
    }

    /// The type of a value.
    pub fn ty(&self, id: OpId) -> Type {
        self.op(id).ty
    }

    /// Where an operation comes from.
    pub fn provenance(&self, id: OpId) -> Provenance {
        let origin = self.provenances.get(id.0 as usize);
        origin.copied().unwrap_or(Provenance::Language)
    }

    /// The operation that gives the value of an expression. `None` where none is needed: inside a
    /// constant, or where the value is not used and has no effect.
    pub fn op_of(&self, expr: ExprId) -> Option<OpId> {
        self.by_expr.get(expr.0 as usize).copied().flatten()
    }

    /// A place; of no variable where the number is not this module's.
    pub fn place(&self, id: PlaceId) -> &Place {
        self.places.get(id.0 as usize).unwrap_or(&Module::NO_PLACE)
    }

    /// The way into a place.
    pub fn path(&self, place: &Place) -> &[Access] {
        list(&self.access_lists, place.path)
    }

    /// A variable, if the number is this module's.
    pub fn variable(&self, id: VariableId) -> Option<&Variable> {
        self.variables.get(id.0 as usize)
    }

    /// A function, if the number is this module's.
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

    /// Operands of an operation that has any number of them.
    pub fn operands(&self, operands: List) -> &[OpId] {
        list(&self.operand_lists, operands)
    }

    /// A loop, if the number is this module's.
    pub fn looped(&self, id: LoopId) -> Option<&Loop> {
        self.loops.get(id.0 as usize)
    }

    /// A `switch`, if the number is this module's.
    pub fn switch(&self, id: SwitchId) -> Option<&Switch> {
        self.switches.get(id.0 as usize)
    }

    /// The cases of a `switch`.
    pub fn cases(&self, switch: &Switch) -> &[Case] {
        list(&self.case_lists, switch.cases)
    }

    /// What a case stands for.
    pub fn labels(&self, case: &Case) -> &[CaseLabel] {
        list(&self.label_lists, case.labels)
    }

    /// The scalars of a constant; nothing for any other operation.
    pub fn constant(&self, id: OpId) -> &[shaderlint_semantic::Value] {
        match self.op(id).kind {
            OpKind::Const(constant) => self.pool.values(constant),
            _ => &[],
        }
    }

    /// Calls `each` with every value that an operation works on, in the order of evaluation; the
    /// computed steps into a place that it reads or writes among them.
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

    /// Calls `each` with the computed steps into a place.
    pub fn each_index(&self, place: PlaceId, mut each: impl FnMut(OpId)) {
        for access in self.path(self.place(place)) {
            if let Access::Computed(index) = access {
                each(*index);
            }
        }
    }

    /// The scalar that components of a value are; `None` for samplers, structs and the like.
    pub fn scalar(&self, id: OpId) -> Option<Scalar> {
        self.ty(id).scalar_kind()
    }
}
