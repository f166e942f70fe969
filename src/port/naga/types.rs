//! Types: scalars, vectors, matrices, arrays, structs, textures.

use super::lower::NagaLowerer;
use super::target::{Res, Value};
use ::naga::proc::TypeLayout;
use ::naga::{
    ArraySize, Expression, Handle, ImageClass, ImageDimension, Literal, ScalarKind, Span,
    StructMember, TypeInner, VectorSize,
};
use shaderlint_semantic::{Base, Sampler, Scalar, Type, Value as Constant};
use std::num::NonZeroU32;

/// Something that expressions can be added to: a function, or the global expressions of the module.
pub(super) trait Sink<'p> {
    /// The module under construction.
    fn lowerer(&mut self) -> &mut NagaLowerer<'p>;
    fn add(&mut self, expression: Expression) -> Value;
}

/// Converts a scalar type to naga's.
pub(super) fn scalar(scalar: Scalar) -> ::naga::Scalar {
    match scalar {
        Scalar::Bool => ::naga::Scalar::BOOL,
        Scalar::Int => ::naga::Scalar::I32,
        Scalar::Uint => ::naga::Scalar::U32,
        Scalar::Float => ::naga::Scalar::F32,
    }
}

/// Converts a number of components to naga's.
pub(super) fn size(rows: u8) -> VectorSize {
    match rows {
        3 => VectorSize::Tri,
        4 => VectorSize::Quad,
        _ => VectorSize::Bi,
    }
}

/// A value as a literal. Naga has none for infinities and NaN, and prints the largest float with so
/// few digits that WGSL reads a larger number.
pub(super) fn literal(value: Constant) -> Option<Literal> {
    Some(match value {
        Constant::Bool(v) => Literal::Bool(v),
        Constant::Int(v) => Literal::I32(v),
        Constant::Uint(v) => Literal::U32(v),
        Constant::Float(v) if v.abs() < f32::MAX => Literal::F32(v),
        Constant::Float(_) => return None,
    })
}

/// The naga type of a sampler's texture.
pub(super) fn image(sampler: Sampler) -> TypeInner {
    use Sampler as S;
    let dim = match sampler {
        S::Sampler3D | S::Isampler3D | S::Usampler3D => ImageDimension::D3,
        S::SamplerCube | S::IsamplerCube | S::UsamplerCube | S::SamplerCubeShadow => {
            ImageDimension::Cube
        }
        _ => ImageDimension::D2,
    };
    let arrayed = matches!(
        sampler,
        S::Sampler2DArray | S::Isampler2DArray | S::Usampler2DArray | S::Sampler2DArrayShadow
    );
    let class = match texel(sampler) {
        None => ImageClass::Depth { multi: false },
        Some(kind) => ImageClass::Sampled { kind, multi: false },
    };
    TypeInner::Image {
        dim,
        arrayed,
        class,
    }
}

/// The scalar type of a texel; `None` for shadow samplers.
pub(super) fn texel(sampler: Sampler) -> Option<ScalarKind> {
    use Sampler as S;
    match sampler {
        S::Sampler2D | S::Sampler3D | S::SamplerCube | S::Sampler2DArray => Some(ScalarKind::Float),
        S::Isampler2D | S::Isampler3D | S::IsamplerCube | S::Isampler2DArray => {
            Some(ScalarKind::Sint)
        }
        S::Usampler2D | S::Usampler3D | S::UsamplerCube | S::Usampler2DArray => {
            Some(ScalarKind::Uint)
        }
        S::Sampler2DShadow | S::SamplerCubeShadow | S::Sampler2DArrayShadow => None,
    }
}

impl NagaLowerer<'_> {
    pub(super) fn inner(&mut self, name: Option<String>, inner: TypeInner) -> Handle<::naga::Type> {
        let ty = ::naga::Type { name, inner };
        self.module.types.insert(ty, Span::UNDEFINED)
    }

    /// Converts a type to naga's.
    pub(super) fn ty(&mut self, ty: Type) -> Res<Handle<::naga::Type>> {
        if let Some(found) = self.types.get(&ty) {
            return Ok(*found);
        }
        let handle = if ty.is_array() {
            self.array(ty)?
        } else {
            match ty.base {
                Base::Numeric {
                    scalar: kind,
                    columns: 1,
                    rows: 1,
                } => self.inner(None, TypeInner::Scalar(scalar(kind))),
                Base::Numeric {
                    scalar: kind,
                    columns: 1,
                    rows,
                } => self.inner(
                    None,
                    TypeInner::Vector {
                        size: size(rows),
                        scalar: scalar(kind),
                    },
                ),
                Base::Numeric {
                    scalar: kind,
                    columns,
                    rows,
                } => self.inner(
                    None,
                    TypeInner::Matrix {
                        columns: size(columns),
                        rows: size(rows),
                        scalar: scalar(kind),
                    },
                ),
                Base::Struct(_) => self.structure(ty)?,
                Base::Sampler(_) => return self.refuse("a sampler cannot be used as a value"),
                Base::Block(_) => return self.refuse("interface blocks are not supported"),
                Base::Error | Base::Void => return self.refuse("this has no type"),
            }
        };
        self.types.insert(ty, handle);
        Ok(handle)
    }

    fn array(&mut self, ty: Type) -> Res<Handle<::naga::Type>> {
        let base = self.ty(ty.element())?;
        let Some(count) = NonZeroU32::new(ty.array).filter(|_| ty.array != Type::UNSIZED) else {
            return self.refuse("the size of this array is unknown");
        };
        let stride = self.layout(base)?.to_stride();
        Ok(self.inner(
            None,
            TypeInner::Array {
                base,
                size: ArraySize::Constant(count),
                stride,
            },
        ))
    }

    fn structure(&mut self, ty: Type) -> Res<Handle<::naga::Type>> {
        let program = self.program;
        let Some(found) = program.struct_of(ty) else {
            return self.refuse("unknown struct");
        };
        let mut members = Vec::new();
        for field in &found.fields {
            let name = program.names.text(field.name).to_string();
            members.push((name, self.ty(field.ty)?));
        }
        let name = found.name.map(|n| program.names.text(n).to_string());
        self.record(name, members)
    }

    /// A struct with its members packed as tightly as their alignment allows.
    fn record(
        &mut self,
        name: Option<String>,
        members: Vec<(String, Handle<::naga::Type>)>,
    ) -> Res<Handle<::naga::Type>> {
        let (mut offset, mut widest) = (0_u32, 1_u32);
        let mut placed = Vec::new();
        for (name, ty) in members {
            let TypeLayout {
                size, alignment, ..
            } = self.layout(ty)?;
            let align = alignment.round_up(1);
            widest = widest.max(align);
            offset = offset.next_multiple_of(align);
            placed.push(StructMember {
                name: Some(name),
                ty,
                binding: None,
                offset,
            });
            offset = offset.saturating_add(size);
        }
        let span = offset.max(1).next_multiple_of(widest);
        let members = placed;
        Ok(self.inner(name, TypeInner::Struct { members, span }))
    }

    fn layout(&mut self, ty: Handle<::naga::Type>) -> Res<TypeLayout> {
        if self.layouter.update(self.module.to_ctx()).is_err() {
            return self.refuse("this type is too large");
        }
        Ok(self.layouter[ty])
    }
}

/// Builds a constant of a type from its scalars; `None` if one cannot be written as a literal.
pub(super) fn compose<'p>(
    sink: &mut impl Sink<'p>,
    ty: Type,
    values: &mut std::slice::Iter<Constant>,
) -> Res<Option<Value>> {
    if ty.is_scalar() {
        let found = values.next().copied().and_then(literal);
        return Ok(found.map(|l| sink.add(Expression::Literal(l))));
    }
    let parts: Vec<Type> = sink.lowerer().layout.parts(ty).collect();
    let mut components = Vec::new();
    for part in parts {
        match compose(sink, part, values)? {
            Some(value) => components.push(value),
            None => return Ok(None),
        }
    }
    let ty = sink.lowerer().ty(ty)?;
    Ok(Some(sink.add(Expression::Compose { ty, components })))
}
