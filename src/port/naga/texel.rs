//! Integer textures, which the target languages can only load and not sample.

use super::body::Body;
use super::target::{Res, Value};
use super::texture::CoordinateShape;
use super::types::Sink;
use ::naga::{BinaryOperator as Op, Expression, ImageQuery, MathFunction};
use shaderlint_ir::{Lanes, OpId};
use shaderlint_semantic::builtins::{Level, Lookup};
use shaderlint_semantic::{Sampler, Scalar, Type};

impl Body<'_, '_> {
    /// The nearest texel, with repeat wrapping. Where WebGL would choose the level with
    /// derivatives, level 0 is used.
    pub(super) fn nearest(
        &mut self,
        lookup: Lookup,
        image: Value,
        at: OpId,
        more: &[OpId],
        kind: Sampler,
    ) -> Res<Value> {
        let shape = CoordinateShape::of(kind);
        if shape.extent != shape.size {
            let message = "integer cube maps have no equivalent in the target language";
            return self.lowerer.refuse(message);
        }
        self.lowerer
            .note("integer textures use nearest filtering and repeat wrapping");
        let at_ty = self.lowerer.form.ty(at);
        let mut at = self.value(at)?;
        if lookup.is_projective {
            at = self.projected(at, at_ty, &shape)?;
        }
        let mut more = more.iter().copied();
        let mut level = self.zero(Type::INT)?;
        match lookup.level {
            Level::Explicit => {
                if let Some(lod) = more.next() {
                    let lod = self.value(lod)?;
                    let nearest = self.math(MathFunction::Round, &[lod]);
                    let nearest = self.convert(nearest, Scalar::Int);
                    level = self.nearest_level(image, nearest)?;
                }
            }
            Level::Gradient => _ = more.nth(1),
            Level::Implicit | Level::Fetch => {}
        }
        let offset = more.next().filter(|_| lookup.has_offset);
        let offset = offset.map(|offset| self.value(offset)).transpose()?;
        let query = ImageQuery::Size { level: Some(level) };
        let size = self.add(Expression::ImageQuery { image, query });
        let size = self.convert(size, Scalar::Int);
        let (place, layer) = match shape.is_layered {
            true => (self.swizzle(at, Lanes::new(0..2)), Some(self.part(at, 2))),
            false => (at, None),
        };
        let extent = self.convert(size, Scalar::Float);
        let scaled = self.op(Op::Multiply, place, extent);
        let floor_part = self.math(MathFunction::Floor, &[scaled]);
        let mut texel = self.convert(floor_part, Scalar::Int);
        if let Some(offset) = offset {
            texel = self.op(Op::Add, texel, offset);
        }
        // The remainder has the sign of the dividend.
        let rest = self.op(Op::Modulo, texel, size);
        let above = self.op(Op::Add, rest, size);
        let coordinate = self.op(Op::Modulo, above, size);
        let array_index = layer
            .map(|layer| self.nearest_layer(image, layer))
            .transpose()?;
        Ok(self.add(Expression::ImageLoad {
            image,
            coordinate,
            array_index,
            sample: None,
            level: Some(level),
        }))
    }

    fn nearest_layer(&mut self, image: Value, layer: Value) -> Res<Value> {
        let nearest = self.math(MathFunction::Round, &[layer]);
        let nearest = self.convert(nearest, Scalar::Int);
        self.within(image, nearest, ImageQuery::NumLayers)
    }
}
