//! Values as hash-consed expressions: equal expressions of both shaders have the same number.

use rustc_hash::FxHashMap;
use shaderlint_ir::{Binary, Lanes, Precision, Unary};
use shaderlint_semantic::{Base, BuiltinId, Scalar, Type, Value};

/// Number of a value, a list of side effects, or a position in the control flow.
pub(super) type NodeId = u32;

/// What a node is, apart from its operands.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum NodeTag {
    /// The bits of a constant.
    Const(Vec<(Scalar, u32)>),
    Undef,
    /// The value of a variable on entry, by name.
    Entry(String),
    Parameter(u32),
    Unary(Unary),
    Binary(Binary),
    MatrixProduct,
    Same(bool),
    /// A value that depends on a condition, chosen by an operator or by control flow.
    Select,
    Convert,
    Splat,
    Swizzle(Lanes),
    Compose,
    Extract(u32),
    ExtractComputed,
    Builtin(BuiltinId),
    /// A call of a function that both shaders have, by its signature.
    Call(String),
    /// The value that a call returns in the parameter at an index.
    Returned(u32),
    /// The value of a global variable after a call, by name.
    After(String),
    /// A value with a part replaced.
    Insert(Vec<PathStep>),
    /// A value rounded to a lower precision.
    Rounded(Precision),
    /// The value of a variable at the start of an iteration: the number of the loop, the name of the
    /// variable, and its position among those of that name.
    Carried(u32, String, u32),
    /// The value where control flow meets.
    Join(Meeting, u32),
    /// Side effects.
    If,
    Loop(u32),
    Switch(u32),
    Case(Vec<Option<u32>>),
    Effects,
    Break,
    Continue,
    Return,
    Discard,
    /// Positions in the control flow.
    Start,
    Within(u32),
    Past,
}

/// Where control flow meets.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Meeting {
    Iteration,
    LoopExit,
    Case(u32),
    SwitchExit,
}

/// A step of a path into a value.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum PathStep {
    Part(u32),
    /// The index is an operand.
    Computed,
    Lanes(Lanes),
}

#[derive(Clone, PartialEq, Eq, Hash)]
struct ValueNode {
    tag: NodeTag,
    ty: Type,
    operands: Vec<NodeId>,
}

/// The nodes of two shaders.
#[derive(Default)]
pub(super) struct Nodes {
    numbers: FxHashMap<ValueNode, NodeId>,
    all: Vec<ValueNode>,
    /// The number of structs that the host declares before those of the shader, which may differ.
    pub host_structs: u16,
}

impl Nodes {
    /// The number of a node, after simplification.
    pub fn add(&mut self, tag: NodeTag, ty: Type, operands: Vec<NodeId>) -> NodeId {
        let (tag, operands) = match self.folded(&tag, ty, &operands) {
            Some(NodeTag::Const(values)) => (NodeTag::Const(values), Vec::new()),
            Some(other) => (other, operands),
            None => (tag, operands),
        };
        match (&tag, &operands[..]) {
            // Control flow that does not change a value.
            (NodeTag::Join(..), [first, rest @ ..]) if rest.iter().all(|o| o == first) => *first,
            (NodeTag::Select, &[_, a, b]) if a == b => a,
            // `a ? b : false` is `a && b`, and `a ? true : b` is `a || b`.
            (NodeTag::Select, &[c, a, b]) if self.is_bool(b, false) => {
                self.number(NodeTag::Binary(Binary::And), ty, vec![c, a])
            }
            (NodeTag::Select, &[c, a, b]) if self.is_bool(a, true) => {
                self.number(NodeTag::Binary(Binary::Or), ty, vec![c, b])
            }
            (NodeTag::Swizzle(outer), &[of]) => match self.node(of) {
                Some((NodeTag::Swizzle(inner), operands)) => {
                    let (lanes, operands) = (inner.pick(*outer), operands.to_vec());
                    self.number(NodeTag::Swizzle(lanes), ty, operands)
                }
                _ => self.number(tag, ty, operands),
            },
            _ => self.number(tag, ty, operands),
        }
    }

    fn number(&mut self, tag: NodeTag, ty: Type, operands: Vec<NodeId>) -> NodeId {
        let base = match ty.base {
            Base::Struct(id) => Base::Struct(id.wrapping_sub(self.host_structs)),
            other => other,
        };
        let ty = Type { base, ..ty };
        let node = ValueNode { tag, ty, operands };
        if let Some(number) = self.numbers.get(&node) {
            return *number;
        }
        let number = self.all.len() as NodeId;
        self.all.push(node.clone());
        self.numbers.insert(node, number);
        number
    }

    pub fn node(&self, id: NodeId) -> Option<(&NodeTag, &[NodeId])> {
        let node = self.all.get(id as usize)?;
        Some((&node.tag, &node.operands))
    }

    /// The number of a constant.
    pub fn constant(&mut self, values: &[Value], ty: Type) -> NodeId {
        let values = values.iter().map(|value| value.bits()).collect();
        self.number(NodeTag::Const(values), ty, Vec::new())
    }

    /// Whether it is an empty list of side effects.
    pub fn is_idle(&self, id: NodeId) -> bool {
        matches!(self.node(id), Some((NodeTag::Effects, [])))
    }

    fn is_bool(&self, id: NodeId, value: bool) -> bool {
        let expected = [(Scalar::Bool, u32::from(value))];
        matches!(self.node(id), Some((NodeTag::Const(values), _)) if values[..] == expected)
    }

    /// The constant that an operation on constants is, as far as lowering also computes it.
    fn folded(&self, tag: &NodeTag, ty: Type, operands: &[NodeId]) -> Option<NodeTag> {
        let is_plain = ty.is_scalar() || ty.is_vector();
        if !is_plain || operands.is_empty() {
            return None;
        }
        let constants = operands.iter().map(|o| match self.node(*o) {
            Some((NodeTag::Const(values), _)) => Some(&values[..]),
            _ => None,
        });
        let constants: Vec<&[(Scalar, u32)]> = constants.collect::<Option<_>>()?;
        let count = ty.components() as usize;
        let values: Vec<(Scalar, u32)> = match (tag, &constants[..]) {
            (NodeTag::Splat, [[one]]) => vec![*one; count],
            (NodeTag::Compose, parts) => parts.concat(),
            (NodeTag::Swizzle(lanes), [of]) => {
                let lane = |n: &u8| of.get(*n as usize).copied();
                lanes.numbers().iter().map(lane).collect::<Option<_>>()?
            }
            (NodeTag::Unary(Unary::Negate), [of]) => {
                of.iter().map(negated).collect::<Option<_>>()?
            }
            (NodeTag::Binary(op), [a, b]) if a.len() == b.len() => {
                let pairs = a.iter().zip(*b);
                let value = pairs.map(|(a, b)| arithmetic(*op, *a, *b));
                value.collect::<Option<_>>()?
            }
            _ => return None,
        };
        (values.len() == count).then_some(NodeTag::Const(values))
    }
}

fn negated(value: &(Scalar, u32)) -> Option<(Scalar, u32)> {
    match *value {
        (Scalar::Float, bits) => Some((Scalar::Float, (-f32::from_bits(bits)).to_bits())),
        (Scalar::Int, bits) => Some((Scalar::Int, (bits as i32).wrapping_neg() as u32)),
        _ => None,
    }
}

fn arithmetic(op: Binary, a: (Scalar, u32), b: (Scalar, u32)) -> Option<(Scalar, u32)> {
    match (a, b) {
        ((Scalar::Float, a), (Scalar::Float, b)) => {
            let (a, b) = (f32::from_bits(a), f32::from_bits(b));
            let made = match op {
                Binary::Add => a + b,
                Binary::Subtract => a - b,
                Binary::Multiply => a * b,
                Binary::Divide if b != 0.0 => a / b,
                _ => return None,
            };
            Some((Scalar::Float, made.to_bits()))
        }
        ((Scalar::Int, a), (Scalar::Int, b)) => {
            let (a, b) = (a as i32, b as i32);
            let made = match op {
                Binary::Add => a.wrapping_add(b),
                Binary::Subtract => a.wrapping_sub(b),
                Binary::Multiply => a.wrapping_mul(b),
                _ => return None,
            };
            Some((Scalar::Int, made as u32))
        }
        _ => None,
    }
}
