//! Arrays: their sizes, and where they are not allowed (GLSL ES 3.00 section 4.1.9).

use super::qualifier::StorageRequest;
use crate::checker::*;
use crate::constant::Value;

/// An error in an array type or declaration.
#[derive(Clone, Copy, Debug)]
pub enum ArrayError {
    /// An array without a size.
    NoSize,
    /// An array without a size and without an initializer to infer it from.
    NoSizeNorValue,
    /// An array without a size, in a version that does not infer it from an initializer.
    NoSizeYet,
    /// A size after the type, in a version that only allows it after the name.
    BehindType,
    OfArrays,
    /// An array of structs as an input or output between stages.
    OfPassedStructs,
    /// An attribute that is an array.
    Attribute,
    /// A vertex shader input that is an array.
    Input,
    /// A constant array, in a version without array values.
    Constant,
    /// An array initializer, in a version without them.
    Value,
    /// An array constructor, in a version without them.
    Constructor,
    /// A size that is not an integer.
    SizeType(Type),
    /// A size that is not constant.
    SizeNotConstant(ExprId),
    /// A size below 0.
    NegativeSize,
    ZeroSize,
}

impl Checker<'_> {
    /// The type with its array sizes. `storage` is that of the declaration, if there is one.
    pub(super) fn with_arrays(
        &mut self,
        base: Type,
        arrays: List,
        storage: StorageRequest,
    ) -> Type {
        let tree = self.tree;
        let sizes = tree.arrays(arrays);
        let Some(first) = sizes.first() else {
            return base;
        };
        let mut ty = base;
        for size in sizes {
            let Some(len) = self.array_size(size) else {
                return Type::ERROR;
            };
            if ty.is_array() {
                self.reject(size.extent, ArrayError::OfArrays);
                return Type::ERROR;
            }
            if !ty.is_error() {
                ty.array = len;
            }
        }
        self.check_array_qualifier(base, storage, first.extent);
        ty
    }

    fn check_array_qualifier(&mut self, base: Type, storage: StorageRequest, extent: Extent) {
        let vertex_in = self.stage == Stage::Vertex && storage == StorageRequest::In;
        let varying = !vertex_in && (storage.is_input() || storage.is_output());
        let problem = match storage {
            StorageRequest::Attribute => ArrayError::Attribute,
            StorageRequest::Const if !self.has(Feature::ArrayValues) => ArrayError::Constant,
            _ if vertex_in => ArrayError::Input,
            _ if varying && matches!(base.base, Base::Struct(_)) => ArrayError::OfPassedStructs,
            _ => return,
        };
        self.reject(extent, problem);
    }

    /// The size in one pair of brackets; `None` if it depends on something unknown.
    fn array_size(&mut self, size: &ArraySize) -> Option<u32> {
        let Some(expr) = size.size else {
            if !self.has(Feature::ArrayValues) {
                self.reject(size.extent, ArrayError::NoSizeYet);
            }
            return Some(Type::UNSIZED);
        };
        self.eval(expr);
        let info = self.info(expr);
        if info.ty.is_error() {
            return None;
        }
        let problem = match self.pool.scalar(info.constant) {
            _ if !matches!(info.ty, Type::INT | Type::UINT) => ArrayError::SizeType(info.ty),
            _ if !info.is_const => ArrayError::SizeNotConstant(expr),
            Some(Value::Int(v)) if v < 0 => ArrayError::NegativeSize,
            Some(v) if v.as_uint() == 0 => ArrayError::ZeroSize,
            Some(v) => return Some(v.as_uint().min(Type::UNSIZED - 1)),
            None => return Some(1),
        };
        self.reject(self.tree.expr(expr).extent, problem);
        Some(1)
    }
}
