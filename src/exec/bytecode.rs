//! The bytecode that the VM executes: a register machine over 32 pixels.

use super::observations::{FaultKind, Observations, OperationCost};
use super::options::ErrorDirection;
use super::row::LANES;
use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_semantic::{FunctionRef, Sampler, Scalar, Type, Undefined, VariableId};
use shaderlint_syntax::ast::Extent;

/// Index of a register.
pub(super) type Reg = u16;

pub(super) const MAX_REGISTERS: usize = 1 << 16;

/// Index of a saved execution mask.
pub(super) type MaskSlot = u16;

/// The mask slot that is always empty.
pub(super) const EMPTY: MaskSlot = 0;

pub(super) type InstrIndex = u32;

/// A compiled shader, with its interface.
#[derive(Default, Debug)]
pub struct Bytecode {
    /// The uniforms; structs are split into members, which are scalars, vectors, matrices or arrays
    /// of these.
    pub uniforms: Vec<UniformSlot>,
    /// The samplers, one per array element.
    pub samplers: Vec<SamplerSlot>,
    /// The inputs, which vary per pixel.
    pub inputs: Vec<InputSlot>,
    /// The outputs, per pixel.
    pub outputs: Vec<OutputSlot>,
    /// The uniform prologue: hoisted code that depends only on constants and uniforms, run once per
    /// draw.
    pub(super) uniform_prologue: Vec<Instr>,
    /// The code that runs for each group of 32 pixels.
    pub(super) body: Vec<Instr>,
    pub(super) registers: usize,
    /// Registers with constant bits.
    pub(super) constants: Vec<(Reg, u32)>,
    /// Large constants, stored in memory after the uniforms.
    pub(super) tables: Vec<u32>,
    /// The number of memory words that the uniforms occupy.
    pub(super) uniform_words: u32,
    /// The register or memory ranges of dynamic indexing.
    pub(super) arrays: Vec<ArraySite>,
    /// The operands of texture lookups.
    pub(super) lookups: Vec<LookupSite>,
    /// The number of mask slots.
    pub(super) slots: u32,
    /// The loops referenced by [`Instr::Enter`] and the other loop instructions.
    pub(super) loops: Vec<LoopId>,
    /// The conditional constructs referenced by [`Instr::Branch`].
    pub(super) branches: Vec<Provenance>,
    /// The charges referenced by [`Instr::Spend`].
    pub(super) charges: Vec<Charge>,
    /// The call paths referenced by charges.
    pub(super) calls: Vec<CallPath>,
    /// The check sites referenced by [`OperandCheck`].
    pub(super) checks: Vec<CheckSite>,
    /// The comparisons referenced by [`Comparison`].
    pub(super) compared: Vec<OpId>,
    /// The operands of [`Instr::Compare`].
    pub(super) comparisons: Vec<Comparison>,
    /// The operands of [`Instr::Check`].
    pub(super) looks: Vec<OperandCheck>,
    /// The sites referenced by [`Instr::Trace`].
    pub(super) traces: Vec<TraceSite>,
    /// Where statements start, and where their variables are.
    pub(super) debug: DebugInfo,
}

impl Bytecode {
    /// The operations that are checked for faults while they run.
    pub fn checked(&self) -> impl Iterator<Item = (OpId, FaultKind)> {
        let sites = self.checks.iter();
        sites.flat_map(|site| site.checked.kinds().iter().map(|kind| (site.op, *kind)))
    }

    /// What each operation cost in a run of the code with [`CompileOptions::cost`], for each path of
    /// calls that leads to it.
    ///
    /// [`CompileOptions::cost`]: crate::CompileOptions::cost
    pub fn costs(&self, seen: &Observations) -> impl Iterator<Item = OperationCost> {
        let charges = self.charges.iter().zip(&seen.charged);
        charges.flat_map(|(charge, &charged)| {
            let next = |path: &CallPath| self.calls.get(path.caller? as usize).copied();
            let own = self.calls.get(charge.path as usize).copied();
            let calls: Vec<OpId> = std::iter::successors(own, next)
                .filter_map(|path| path.call)
                .collect();
            let total: u64 = charge.parts.iter().map(|(_, cost)| u64::from(*cost)).sum();
            let times = charged / total.max(1);
            charge.parts.iter().map(move |&(at, cost)| OperationCost {
                at,
                calls: calls.clone(),
                operations: times * u64::from(cost),
            })
        })
    }

    /// Whether results depend on the neighbours in a quad.
    pub fn takes_derivatives(&self) -> bool {
        let mut code = self.uniform_prologue.iter().chain(&self.body);
        let is_difference =
            |i: &Instr| matches!(i, Instr::One(F1::DifferenceX | F1::DifferenceY, ..));
        code.any(is_difference)
            || self
                .lookups
                .iter()
                .any(|l| l.query == LookupQuery::Implicit)
    }

    /// The sites at which a debugger can stop.
    pub fn stops(&self) -> &[StopSite] {
        &self.debug.stops
    }

    /// What the sites stop at: statements, conditions and steps of constructs, and ends of functions.
    pub fn statements(&self) -> &[Extent] {
        &self.debug.statements
    }

    /// The functions that run at a site, innermost first: each with its call, which is `None` for the
    /// entry point. The function is `None` for global initialisers.
    pub fn frames(
        &self,
        site: &StopSite,
    ) -> impl Iterator<Item = (Option<FunctionRef>, Option<OpId>)> {
        let path = |at: u32| self.calls.get(at as usize);
        let paths = std::iter::successors(path(site.path), move |p| path(p.caller?));
        paths.map(|path| (path.function, path.call))
    }

    /// The memory in bytes that one thread needs to run the code: code, registers, uniforms and
    /// inputs, without textures and statistics.
    pub fn bytes(&self) -> usize {
        let instructions = self.uniform_prologue.len() + self.body.len();
        let words = self.registers * LANES + self.uniform_words as usize + self.tables.len();
        let masks = self.slots as usize;
        instructions * size_of::<Instr>() + (words + masks) * size_of::<u32>()
    }
}

/// A uniform that is not a struct.
#[derive(Clone, PartialEq, Debug)]
pub struct UniformSlot {
    /// The name as in `getUniformLocation`: `lights[1].position`, `Block.member`. Arrays have no
    /// `[0]`.
    pub name: String,
    /// The type.
    pub ty: Type,
    /// The first word in memory.
    pub(super) at: u32,
}

/// A sampler, or one element of an array of samplers.
#[derive(Clone, PartialEq, Debug)]
pub struct SamplerSlot {
    /// The name as in `getUniformLocation`.
    pub name: String,
    /// The sampler type.
    pub sampler: Sampler,
}

/// An input of the stage, or an `in` parameter of an entry point called by a host.
#[derive(Clone, PartialEq, Debug)]
pub struct InputSlot {
    /// The name of the variable.
    pub name: String,
    /// The type.
    pub ty: Type,
    /// One register per scalar.
    pub(super) regs: Vec<Reg>,
}

/// An output of the stage, an `out` parameter of an entry point called by a host, or its return
/// value.
#[derive(Clone, PartialEq, Debug)]
pub struct OutputSlot {
    /// The name of the variable; empty for the return value.
    pub name: String,
    /// The type.
    pub ty: Type,
    /// One register per scalar.
    pub(super) regs: Vec<Reg>,
}

impl OutputSlot {
    /// The number of components stored per pixel, at most four.
    pub fn lanes(&self) -> usize {
        self.ty.element().components().min(4) as usize
    }

    /// The number of scalars, including all array elements.
    pub fn scalars(&self) -> usize {
        self.regs.len()
    }

    /// Converts the bits of a component to a number.
    pub fn number(&self, bits: u32) -> f32 {
        match self.ty.scalar_kind().unwrap_or(Scalar::Float) {
            Scalar::Float => f32::from_bits(bits),
            Scalar::Int => bits as i32 as f32,
            Scalar::Uint => bits as f32,
            Scalar::Bool => f32::from(u8::from(bits != 0)),
        }
    }
}

/// The range of a dynamically indexed access.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct ArraySite {
    /// The first register or memory word.
    pub base: u32,
    /// The number of registers or words that may be accessed.
    pub len: u32,
}

/// The operands of a texture lookup.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct LookupSite {
    /// Index of the sampler.
    pub sampler: u16,
    /// The kind of lookup.
    pub query: LookupQuery,
    /// The coordinates, after projection, with the layer last; texel coordinates for `Fetch`.
    pub coordinates: Vec<Reg>,
    /// The depth reference of a shadow sampler.
    pub reference: Option<Reg>,
    /// The bias, the level, or the gradients (all components of x, then of y).
    pub level: Vec<Reg>,
    /// The constant offset in texels.
    pub offset: [i32; 3],
    /// The result: four registers, or one per component of a size.
    pub results: Vec<Reg>,
}

/// The kind of a lookup.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LookupQuery {
    /// The level is computed from implicit derivatives.
    Implicit,
    Explicit,
    Gradient,
    /// `texelFetch`
    Fetch,
    /// `textureSize`
    Size,
}

/// Operations that the same lanes execute.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Charge {
    /// Index of the call path.
    pub path: u32,
    /// The operations, with their costs.
    pub parts: Vec<(Provenance, u32)>,
}

/// A function with its call path.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct CallPath {
    /// The function; `None` for global initialisers.
    pub function: Option<FunctionRef>,
    /// The call; `None` for global initialisers and the entry point.
    pub call: Option<OpId>,
    /// The path of the caller.
    pub caller: Option<u32>,
}

/// The operands of [`Instr::Check`].
#[derive(Clone, PartialEq, Debug)]
pub(super) struct OperandCheck {
    /// Index of the check site, shared by all inlined copies of the operation.
    pub site: u32,
    /// The result of the operation.
    pub result: Reg,
    pub operands: Vec<Reg>,
}

/// The operands of [`Instr::Compare`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Comparison {
    /// Index of the comparison, shared by all inlined copies of the operation.
    pub site: u32,
    /// The result of the comparison.
    pub result: Reg,
    /// The left operand.
    pub left: Reg,
    /// The right operand.
    pub right: Reg,
    /// The type of the operands.
    pub scalar: Scalar,
}

/// What a traced value is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TracedValue {
    /// A variable after an operation wrote to it, or to a part of it.
    Written(VariableId, OpId),
    /// A parameter at the start of a call.
    Parameter(VariableId),
    /// The result of a call, an operation.
    Returned(OpId),
}

/// How many scalars of a value are traced: enough for four matrices.
pub const MAX_TRACED: usize = 64;

/// A value that is traced. Calls are inlined: each has its own sites.
#[derive(Clone, PartialEq, Debug)]
pub struct TraceSite {
    /// What the value is.
    pub value: TracedValue,
    /// Its type.
    pub ty: Type,
    /// The function that runs; `None` for global initialisers.
    pub function: Option<FunctionRef>,
    /// One register per scalar, of the first [`MAX_TRACED`].
    pub(super) regs: Vec<Reg>,
}

/// What a debugger needs, of code compiled with [`CompileOptions::steps`].
///
/// [`CompileOptions::steps`]: crate::CompileOptions::steps
#[derive(Default, Debug)]
pub(super) struct DebugInfo {
    /// The sites referenced by [`Instr::Stop`].
    pub stops: Vec<StopSite>,
    /// The statements of the sites, which are those of all inlined copies.
    pub statements: Vec<Extent>,
    /// By variable: its locations, each from an instruction on, ordered by instruction.
    pub locations: Vec<Vec<(InstrIndex, Location)>>,
    /// The registers of locations.
    pub lists: Vec<Reg>,
}

/// A place at which a debugger can stop. Calls are inlined: each has its own sites.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StopSite {
    /// The tokens of the statement, or of the condition or step of a construct.
    pub extent: Extent,
    /// Why it is a place to stop at.
    pub kind: StopKind,
    /// The index of the statement.
    pub(super) statement: u32,
    /// The index of the call path.
    pub(super) path: u32,
}

/// Why a debugger can stop at a site.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StopKind {
    /// Before a statement, or the condition or step of a construct.
    Statement,
    /// After this call, in the middle of the statement that calls.
    Return(OpId, Location),
}

/// Where a value is, in code that a debugger can stop.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Location {
    /// The variable is not in scope.
    None,
    /// Registers, one per scalar.
    #[expect(missing_docs, reason = "a range of a list of registers")]
    Registers { start: u32, len: u32 },
    /// Words of the memory, which holds uniforms and large constants.
    #[expect(missing_docs, reason = "a range of words")]
    Memory { at: u32, len: u32 },
    /// A sampler, by index.
    Sampler(u32),
}

/// A check, shared by all inlined copies of the operation.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct CheckSite {
    /// The checked operation.
    pub op: OpId,
    /// The fault that is checked for.
    pub checked: FaultCheck,
}

/// The fault that a check detects.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum FaultCheck {
    /// A NaN or infinity that none of the operands is.
    Float,
    /// The same, or a zero divisor.
    Quotient,
    /// A zero divisor of this type.
    Divisor(Scalar),
    /// An index not less than the second operand.
    Index,
    /// Operands of this type for which the result is undefined.
    Operands(Undefined, Scalar),
    /// Inactive neighbours in the quad, so that the derivative is undefined.
    Neighbours,
}

impl FaultCheck {
    /// The type of the operands.
    pub const fn scalar(self) -> Scalar {
        match self {
            FaultCheck::Float | FaultCheck::Quotient | FaultCheck::Neighbours => Scalar::Float,
            FaultCheck::Divisor(scalar) | FaultCheck::Operands(_, scalar) => scalar,
            FaultCheck::Index => Scalar::Int,
        }
    }
}

/// An instruction. The destination register comes first, followed by the operands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Instr {
    /// Copies all lanes.
    Move(Reg, Reg),
    /// Copies the active lanes.
    MoveActive(Reg, Reg),
    One(F1, Reg, Reg),
    Two(F2, Reg, Reg, Reg),
    Three(F3, Reg, Reg, Reg, Reg),
    /// Loads a word of memory into all lanes.
    Word(Reg, u32),
    /// Loads from a dynamically indexed register.
    Gather {
        to: Reg,
        index: Reg,
        site: u32,
    },
    /// Stores to a dynamically indexed register, in the active lanes.
    Scatter {
        from: Reg,
        index: Reg,
        site: u32,
    },
    /// Loads from a dynamically indexed memory word.
    Table {
        to: Reg,
        index: Reg,
        site: u32,
    },
    Lookup(u32),

    /// Saves the active lanes where the condition is false and disables them. Jumps if no lane is
    /// active.
    If {
        condition: Reg,
        others: MaskSlot,
        to: InstrIndex,
    },
    /// Swaps the active lanes with the saved ones. Jumps if no lane is active.
    Else {
        others: MaskSlot,
        to: InstrIndex,
    },
    /// Reactivates the saved lanes.
    EndIf {
        others: MaskSlot,
    },
    /// Saves the execution mask.
    Keep(MaskSlot),
    Clear(MaskSlot),
    /// Sets a mask slot to the lanes, active or not, where the register is true.
    Mark(MaskSlot, Reg),
    /// Restores the mask `came`, without the lanes in `left` and `others` and without discarded
    /// lanes.
    Restore {
        came: MaskSlot,
        left: MaskSlot,
        others: MaskSlot,
    },
    /// Disables the lanes where the condition is false. Jumps if no lane is active.
    While {
        condition: Reg,
        to: InstrIndex,
    },
    /// Reactivates the lanes in a mask slot and clears it.
    Resume(MaskSlot),
    /// Moves all active lanes to a mask slot and disables them.
    Wait(MaskSlot),
    /// Activates the marked ones of the waiting lanes. Jumps if no lane is active.
    Case {
        waiting: MaskSlot,
        marked: MaskSlot,
        to: InstrIndex,
    },
    /// Disables all lanes.
    Halt,
    /// Discards the active lanes.
    Discard,
    /// Jumps if no lane is active.
    SkipIfNone(InstrIndex),
    /// Jumps backwards. The repeated instructions are charged as fuel.
    Back(InstrIndex),

    /// Statistics: a loop is entered.
    Enter(u32),
    /// Statistics: an iteration starts.
    Iterate(u32),
    /// Statistics: the condition of a loop is false for some active lanes.
    Exhaust(u32, Reg),
    /// Statistics: a loop is left.
    Leave(u32),
    /// Statistics: how many active lanes take each side of a branch.
    Branch(u32, Reg),
    /// Statistics: charges the active lanes for operations.
    Spend {
        cost: u32,
        /// Index of the charge.
        by: u32,
    },
    /// Checks a result for faults.
    Check(u32),
    /// Records the operands of a comparison.
    Compare(u32),
    /// Records a value of the traced lane.
    Trace(u32),
    /// Counts the active lanes at a site, at which a debugger can pause.
    Stop(u32),
}

/// Unary operations.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub(super) enum F1 {
    Negate, Abs, Sign, Floor, Ceil, Trunc, RoundEven, Fract, Sqrt, InverseSqrt,
    Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Asinh, Acosh, Atanh,
    Exp, Log, Exp2, Log2, IsNan, IsInf,
    IntNegate, IntAbs, IntSign, Not,
    FloatOfInt, FloatOfUint, IntOfFloat, UintOfFloat,
    HalfLow, HalfHigh, SnormLow, SnormHigh, UnormLow, UnormHigh,
    /// Difference to the pixel on the right (`dFdx`).
    DifferenceX,
    /// Difference to the pixel above (`dFdy`).
    DifferenceY,
    /// Rounds to half precision (16 bits).
    Half,
    /// The bits of a float, the same for every NaN.
    BitsOfFloat,
}

/// Binary operations.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub(super) enum F2 {
    Add, Subtract, Multiply, Divide, Min, Max, MinNumber, MaxNumber, Modulo, Pow, Atan2, Step,
    Less, LessEqual, Equal, NotEqual,
    IntAdd, IntSubtract, IntMultiply, IntDivide, IntRemainder, UintDivide, UintRemainder,
    IntLess, IntLessEqual, UintLess, UintLessEqual, SameBits, OtherBits,
    And, Or, Xor, ShiftLeft, ShiftRight, ShiftRightUnsigned,
    IntMin, IntMax, UintMin, UintMax,
    PackHalf, PackSnorm, PackUnorm,
    /// The first operand with the maximum error that a GPU may have for the second operand.
    Imprecise(ImpreciseOp, ErrorDirection),
}

/// The operations that a GPU may compute inexactly.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum ImpreciseOp {
    /// `/` and `sqrt`
    Quotient,
    /// `inversesqrt`
    InverseSqrt,
    /// `exp` and `exp2`
    Exponential,
    /// `log` and `log2`
    Logarithm,
    /// `sin` and `cos`
    Sine,
    /// `atan`, `asin` and `acos`
    ArcTangent,
}

/// Ternary operations.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub(super) enum F3 {
    /// The rounded product of the first two operands plus the third (no fused multiply-add).
    MultiplyAdd,
    /// The second operand where the first is true, else the third.
    Select,
    Mix, Smoothstep,
}

const _: () = assert!(size_of::<Instr>() <= 12);
