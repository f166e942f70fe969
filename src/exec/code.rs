//! Register code: what the machine runs.

use super::compile::options::Lean;
use super::row::LANES;
use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_semantic::{FunctionRef, Sampler, Scalar, Type, Undefined};

/// Number of a register.
pub(super) type Reg = u16;

/// How many registers there can be.
pub(super) const MAX_REGISTERS: usize = 1 << 16;

/// Number of a mask that is kept aside.
pub(super) type Slot = u16;

/// The mask that is empty at all times.
pub(super) const EMPTY: Slot = 0;

/// Index of an instruction.
pub(super) type Target = u32;

/// A shader as register code, with what it takes and gives.
#[derive(Default, Debug)]
pub struct Code {
    /// The uniforms, each scalar, vector, matrix or array of these by itself.
    pub uniforms: Vec<UniformSlot>,
    /// The samplers.
    pub samplers: Vec<SamplerSlot>,
    /// What differs from pixel to pixel.
    pub inputs: Vec<InputSlot>,
    /// What the shader gives for each pixel.
    pub outputs: Vec<OutputSlot>,
    /// Runs once for all pixels: what depends on constants and uniforms alone.
    pub(super) prologue: Vec<Instr>,
    /// Runs for each group of pixels.
    pub(super) body: Vec<Instr>,
    /// How many registers it works with.
    pub(super) registers: usize,
    /// Registers that hold the same bits at all times.
    pub(super) constants: Vec<(Reg, u32)>,
    /// What lies in the memory behind the uniforms: large constants.
    pub(super) tables: Vec<u32>,
    /// How many words the uniforms take.
    pub(super) uniform_words: u32,
    /// Where elements with computed numbers lie.
    pub(super) arrays: Vec<ArraySite>,
    /// Lookups in textures.
    pub(super) lookups: Vec<LookupSite>,
    /// How many masks are kept aside.
    pub(super) slots: u32,
    /// By number that [`Instr::Enter`] and its like name: the loop.
    pub(super) loops: Vec<LoopId>,
    /// By number that [`Instr::Branch`] names: the condition's construct.
    pub(super) branches: Vec<Provenance>,
    /// By number that [`Instr::Spend`] names: the function, and the functions that called it.
    pub(super) calls: Vec<CallPath>,
    /// By number that [`Look`] names: what is checked.
    pub(super) checks: Vec<CheckSite>,
    /// By number that [`Comparison`] names: the operation.
    pub(super) compared: Vec<OpId>,
    /// By number that [`Instr::Compare`] names: what is compared.
    pub(super) comparisons: Vec<Comparison>,
    /// By number that [`Instr::Check`] names: where it is looked at.
    pub(super) looks: Vec<Look>,
}

impl Code {
    /// How many bytes it takes to run it in one thread, itself and what it is given included;
    /// textures and what is watched apart.
    pub fn bytes(&self) -> usize {
        let instructions = self.prologue.len() + self.body.len();
        let words = self.registers * LANES + self.uniform_words as usize + self.tables.len();
        let masks = self.slots as usize;
        instructions * size_of::<Instr>() + (words + masks) * size_of::<u32>()
    }
}

/// A uniform without members.
#[derive(Clone, PartialEq, Debug)]
pub struct UniformSlot {
    /// As `getUniformLocation` takes it: `lights[1].position`, `Block.member`; an array without its
    /// brackets.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Where its scalars begin in the memory.
    pub(super) at: u32,
}

/// A sampler.
#[derive(Clone, PartialEq, Debug)]
pub struct SamplerSlot {
    /// As `getUniformLocation` takes it, elements of arrays one by one.
    pub name: String,
    /// What it looks up.
    pub sampler: Sampler,
}

/// An input of the stage, or an `in` parameter of an entry that a host calls.
#[derive(Clone, PartialEq, Debug)]
pub struct InputSlot {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Its registers.
    pub(super) regs: Vec<Reg>,
}

/// An output of the stage, or an `out` parameter of an entry that a host calls, or what it returns.
#[derive(Clone, PartialEq, Debug)]
pub struct OutputSlot {
    /// Its name; empty for what the entry returns.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Its registers.
    pub(super) regs: Vec<Reg>,
}

impl OutputSlot {
    /// How many numbers of a pixel it holds, at most four.
    pub fn lanes(&self) -> usize {
        self.ty.element().components().min(4) as usize
    }

    /// How many numbers it has.
    pub fn scalars(&self) -> usize {
        self.regs.len()
    }

    /// The number that bits of it stand for.
    pub fn number(&self, bits: u32) -> f32 {
        match self.ty.scalar_kind().unwrap_or(Scalar::Float) {
            Scalar::Float => f32::from_bits(bits),
            Scalar::Int => bits as i32 as f32,
            Scalar::Uint => bits as f32,
            Scalar::Bool => f32::from(u8::from(bits != 0)),
        }
    }
}

/// Where elements with computed numbers lie.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct ArraySite {
    /// The first register, or word of the memory.
    pub base: u32,
    /// How many of them may be meant from there on.
    pub len: u32,
}

/// A lookup in a texture.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct LookupSite {
    /// Number of the sampler.
    pub sampler: u16,
    /// What is asked.
    pub query: LookupQuery,
    /// Coordinates, those of a projection divided already, the layer last; a texel's for `Fetch`.
    pub coordinates: Vec<Reg>,
    /// What a depth is compared with.
    pub reference: Option<Reg>,
    /// Bias, level, or gradients: those along x, then those along y.
    pub level: Vec<Reg>,
    /// The constant offset, in texels.
    pub offset: [i32; 3],
    /// Where the answer goes: four registers, or as many as the size has numbers.
    pub results: Vec<Reg>,
}

/// What a lookup asks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LookupQuery {
    /// The level follows from the neighbours.
    Implicit,
    /// The level is given.
    Explicit,
    /// The gradients are given.
    Gradient,
    /// One texel.
    Fetch,
    /// How large a level is.
    Size,
}

/// A function, and who called it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct CallPath {
    /// The function; `None` for the initial values of globals.
    pub function: Option<FunctionRef>,
    /// The path of its caller.
    pub caller: Option<u32>,
}

/// A result that is looked at.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Look {
    /// Number of the site, one for all calls of its function.
    pub site: u32,
    /// What the operation gave.
    pub result: Reg,
    /// What it worked on.
    pub operands: Vec<Reg>,
}

/// A comparison that is looked at.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Comparison {
    /// Number of the operation, one for all calls of its function.
    pub site: u32,
    /// What it gave.
    pub result: Reg,
    /// What it compared.
    pub left: Reg,
    /// With what.
    pub right: Reg,
    /// As which kind of number.
    pub scalar: Scalar,
}

/// What is checked, for all calls of a function.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct CheckSite {
    /// The operation.
    pub op: OpId,
    /// What is looked for.
    pub checked: Checked,
}

/// What is looked for in the result of an operation.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Checked {
    /// A NaN or an infinity that no operand is.
    Float,
    /// The same, and a divisor that is zero.
    Quotient,
    /// A divisor that is zero, of a kind.
    Divisor(Scalar),
    /// A number that is not below the second operand.
    Index,
    /// Operands of a kind for which the result is undefined.
    Operands(Undefined, Scalar),
    /// Neighbours that do not take part, so that there is nothing to take a derivative from.
    Neighbours,
}

impl Checked {
    /// What the operands are.
    pub const fn scalar(self) -> Scalar {
        match self {
            Checked::Float | Checked::Quotient | Checked::Neighbours => Scalar::Float,
            Checked::Divisor(scalar) | Checked::Operands(_, scalar) => scalar,
            Checked::Index => Scalar::Int,
        }
    }
}

/// An instruction. The first register is the one that is written; operands follow.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Instr {
    /// All lanes.
    Move(Reg, Reg),
    /// Lanes that take part.
    MoveActive(Reg, Reg),
    One(F1, Reg, Reg),
    Two(F2, Reg, Reg, Reg),
    Three(F3, Reg, Reg, Reg, Reg),
    /// One word of the memory, in all lanes.
    Word(Reg, u32),
    /// The register of a site whose number is computed.
    Gather {
        to: Reg,
        index: Reg,
        site: u32,
    },
    /// Into the register of a site whose number is computed, in lanes that take part.
    Scatter {
        from: Reg,
        index: Reg,
        site: u32,
    },
    /// The word of a site whose number is computed.
    Table {
        to: Reg,
        index: Reg,
        site: u32,
    },
    /// Asks a texture.
    Lookup(u32),

    /// Lanes that take part and where this holds; the others are kept aside. Jumps where none are
    /// left.
    If {
        condition: Reg,
        others: Slot,
        to: Target,
    },
    /// Changes place with those kept aside. Jumps where none are left.
    Else {
        others: Slot,
        to: Target,
    },
    /// Those kept aside take part again.
    EndIf {
        others: Slot,
    },
    /// Keeps aside who comes here.
    Keep(Slot),
    /// Nobody is kept here.
    Clear(Slot),
    /// Lanes where this holds, whether they take part or not, are kept here.
    Mark(Slot, Reg),
    /// Those who came take part again, unless they left otherwise, or are gone.
    Restore {
        came: Slot,
        left: Slot,
        others: Slot,
    },
    /// Only lanes where this holds go on. Jumps where none are left.
    While {
        condition: Reg,
        to: Target,
    },
    /// Those who wait here take part again.
    Resume(Slot),
    /// All who take part wait here, and nobody goes on.
    Wait(Slot),
    /// Of those who wait, the ones that are marked take part, too. Jumps where none take part.
    Case {
        waiting: Slot,
        marked: Slot,
        to: Target,
    },
    /// Nobody goes on.
    Halt,
    /// Who takes part is gone.
    Discard,
    /// Jumps where none take part.
    SkipIfNone(Target),
    /// Jumps back; it costs as much as what is run again.
    Back(Target),

    /// A loop begins.
    Enter(u32),
    /// A turn of a loop begins.
    Turn(u32),
    /// Lanes that take part and where this does not hold have exhausted a loop.
    Exhaust(u32, Reg),
    /// A loop has ended.
    Leave(u32),
    /// Which lanes take a branch.
    Branch(u32, Reg),
    /// What lanes that take part have to pay.
    Spend {
        cost: u32,
        /// Number of the path of calls that leads here.
        by: u32,
    },
    /// Looks at a result.
    Check(u32),
    /// Looks at a comparison.
    Compare(u32),
}

/// Instructions with one operand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub(super) enum F1 {
    Negate, Abs, Sign, Floor, Ceil, Trunc, RoundEven, Fract, Sqrt, InverseSqrt,
    Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Asinh, Acosh, Atanh,
    Exp, Log, Exp2, Log2, IsNan, IsInf,
    IntNegate, IntAbs, IntSign, Not,
    FloatOfInt, FloatOfUint, IntOfFloat, UintOfFloat,
    HalfLow, HalfHigh, SnormLow, SnormHigh, UnormLow, UnormHigh,
    /// The difference to the neighbour on the right.
    DifferenceX,
    /// The difference to the neighbour above.
    DifferenceY,
    /// The nearest number of 16 bits.
    Half,
}

/// Instructions with two operands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub(super) enum F2 {
    Add, Subtract, Multiply, Divide, Min, Max, Modulo, Pow, Atan2, Step,
    Less, LessEqual, Equal, NotEqual,
    IntAdd, IntSubtract, IntMultiply, IntDivide, IntRemainder, UintDivide, UintRemainder,
    IntLess, IntLessEqual, UintLess, UintLessEqual, SameBits, OtherBits,
    And, Or, Xor, ShiftLeft, ShiftRight, ShiftRightUnsigned,
    IntMin, IntMax, UintMin, UintMax,
    PackHalf, PackSnorm, PackUnorm,
    /// The first operand, off by as much as a GPU may be for the second.
    Off(Inexact, Lean),
}

/// What a GPU need not compute exactly.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Inexact {
    /// `/`, and `sqrt`
    Quotient,
    /// `inversesqrt`
    InverseRoot,
    /// `exp`, `exp2`
    Exponential,
    /// `log`, `log2`
    Logarithm,
    /// `sin`, `cos`
    Sine,
    /// `atan`, `asin`, `acos`
    ArcTangent,
}

/// Instructions with three operands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub(super) enum F3 {
    /// The product of the first two, rounded, and the third.
    MultiplyAdd,
    /// The second where the first is true, else the third.
    Select,
    Mix, Smoothstep,
}

const _: () = assert!(size_of::<Instr>() <= 12);
