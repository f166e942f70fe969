//! Types that can be passed between stages, and to and from the shader (GLSL ES 3.00 sections 4.3.4
//! and 4.3.6).

use super::qualifier::StorageRequest;
use crate::checker::*;

/// An error in the type of an input or output.
#[derive(Clone, Copy, Debug)]
pub enum InterfaceError {
    /// A type that is not allowed with this storage.
    Type(StorageRequest, Type),
    /// A `bool` or vector of them.
    Bool(StorageRequest),
    /// A struct, which is not allowed with this storage.
    Struct(StorageRequest),
    /// A vertex shader input that is an array.
    InputArray,
    /// A fragment shader output that is a matrix.
    OutputMatrix,
    /// An integer without `flat`.
    NotFlat(StorageRequest),
    ArrayOfStructs,
    /// A struct containing an array.
    ArrayInside,
    /// A struct containing a struct.
    StructInside,
    /// A struct containing a `bool`.
    BoolInside,
}

impl Checker<'_> {
    /// Checks that values of a type can be passed with these qualifiers.
    pub(in crate::checker) fn passed(
        &self,
        storage: StorageRequest,
        ty: Type,
    ) -> Result<(), InterfaceError> {
        use InterfaceError as E;
        let scalar = match ty.base {
            Base::Numeric { scalar, .. } => Some(scalar),
            _ => None,
        };
        let is_legacy = matches!(storage, StorageRequest::Attribute | StorageRequest::Varying);
        if !self.has(Feature::InOut) {
            return match scalar {
                Some(Scalar::Bool | Scalar::Int) if is_legacy => Err(E::Type(storage, ty)),
                _ => Ok(()),
            };
        }
        if !storage.is_input() && !storage.is_output() {
            return Ok(());
        }
        if scalar == Some(Scalar::Bool) {
            return Err(E::Bool(storage));
        }
        match self.end_of(storage) {
            Some(Stage::Vertex) if ty.is_array() => Err(E::InputArray),
            Some(Stage::Fragment) if ty.element().is_matrix() => Err(E::OutputMatrix),
            Some(_) => Ok(()),
            None if self.inside(ty).integer
                && !matches!(storage, StorageRequest::FlatIn | StorageRequest::FlatOut) =>
            {
                Err(E::NotFlat(storage))
            }
            None => self.passed_struct(ty),
        }
    }

    /// The stage, if variables of this storage are at an end of the pipeline: vertex shader inputs
    /// and fragment shader outputs.
    fn end_of(&self, storage: StorageRequest) -> Option<Stage> {
        match (self.stage, storage) {
            (Stage::Vertex, StorageRequest::In) | (Stage::Fragment, StorageRequest::Out) => {
                Some(self.stage)
            }
            _ => None,
        }
    }

    fn passed_struct(&self, ty: Type) -> Result<(), InterfaceError> {
        use InterfaceError as E;
        let record = match ty.base {
            Base::Struct(id) => self.structs.get(id as usize),
            _ => None,
        };
        let Some(Struct { fields, .. }) = record else {
            return Ok(());
        };
        let is_bool = |f: &Field| f.ty.element().scalar_kind() == Some(Scalar::Bool);
        if ty.is_array() {
            Err(E::ArrayOfStructs)
        } else if fields.iter().any(|f| f.ty.is_array()) {
            Err(E::ArrayInside)
        } else if fields.iter().any(|f| matches!(f.ty.base, Base::Struct(_))) {
            Err(E::StructInside)
        } else if fields.iter().any(is_bool) {
            Err(E::BoolInside)
        } else {
            Ok(())
        }
    }

    /// Checks that variables of a type can have this storage: no structs at the ends of the
    /// pipeline.
    pub(super) fn passed_as(
        &self,
        storage: StorageRequest,
        ty: Type,
    ) -> Result<(), InterfaceError> {
        let is_legacy = matches!(storage, StorageRequest::Attribute | StorageRequest::Varying);
        let takes_none = is_legacy || self.end_of(storage).is_some();
        match ty.base {
            Base::Struct(_) if takes_none => Err(InterfaceError::Struct(storage)),
            _ => Ok(()),
        }
    }
}
