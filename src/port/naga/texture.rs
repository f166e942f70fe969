//! Texture lookups.

use super::body::Body;
use super::sampler::Looked;
use super::target::{Res, Value};
use super::types::{Sink, image, texel};
use ::naga::{
    BinaryOperator as Op, Block, Expression, Handle, ImageQuery, Literal, MathFunction,
    RelationalFunction, SampleLevel, ScalarKind, Statement,
};
use shaderlint_ir::{Lanes, OpId};
use shaderlint_semantic::builtins::{BuiltinKind, Level, Lookup};
use shaderlint_semantic::{Sampler, Scalar, Type};

/// The coordinates of a sampler type.
pub(super) struct CoordinateShape {
    pub(super) size: u8,
    /// Number of components of the size, without layers.
    pub(super) extent: u8,
    /// Whether it has layers.
    pub(super) is_layered: bool,
    /// Whether it compares depth.
    is_shadow: bool,
}

impl CoordinateShape {
    pub(super) fn of(kind: Sampler) -> CoordinateShape {
        use Sampler as S;
        let size = match kind {
            S::Sampler2D | S::Isampler2D | S::Usampler2D | S::Sampler2DShadow => 2,
            S::Sampler2DArray | S::Isampler2DArray | S::Usampler2DArray => 2,
            S::Sampler2DArrayShadow => 2,
            _ => 3,
        };
        let is_layered = matches!(
            kind,
            S::Sampler2DArray | S::Isampler2DArray | S::Usampler2DArray | S::Sampler2DArrayShadow
        );
        let is_deep = matches!(kind, S::Sampler3D | S::Isampler3D | S::Usampler3D);
        CoordinateShape {
            size,
            extent: if is_deep { 3 } else { 2 },
            is_layered,
            is_shadow: texel(kind).is_none(),
        }
    }
}

impl Body<'_, '_> {
    /// Lowers a call of a texture function.
    pub(super) fn texture(&mut self, kind: BuiltinKind, operands: &[OpId], ty: Type) -> Res<Value> {
        let [texture, rest @ ..] = operands else {
            return self.lowerer.refuse("this is not a texture lookup");
        };
        let value = self.with_sampler(*texture, ty, |it, looked| {
            it.look(kind, looked, rest).map(Some)
        })?;
        match value {
            Some(value) => Ok(value),
            None => self.lowerer.refuse("this is not a texture lookup"),
        }
    }

    /// Lowers a texture function for one texture.
    fn look(&mut self, kind: BuiltinKind, looked: Looked, rest: &[OpId]) -> Res<Value> {
        let Looked {
            image,
            sampler,
            kind: sampled,
        } = looked;
        let shape = CoordinateShape::of(sampled);
        match (kind, rest) {
            (BuiltinKind::Size, &[lod]) => self.texture_size(image, lod, &shape),
            (BuiltinKind::Lookup(lookup), &[at, lod, ..]) if lookup.level == Level::Fetch => {
                self.fetch(image, at, lod, rest.get(2).copied(), sampled)
            }
            (BuiltinKind::Lookup(lookup), &[at, ref more @ ..]) => match texel(sampled) {
                Some(ScalarKind::Sint | ScalarKind::Uint) => {
                    self.nearest(lookup, image, at, more, sampled)
                }
                _ => self.sample(lookup, (image, sampler), at, more, &shape),
            },
            _ => self
                .lowerer
                .refuse("this texture function is not supported"),
        }
    }

    /// The size of a level, as in WebGL for any number: each level has half the size, at least 1.
    fn texture_size(&mut self, image: Value, lod: OpId, shape: &CoordinateShape) -> Res<Value> {
        let query = ImageQuery::Size { level: None };
        let mut size = self.add(Expression::ImageQuery { image, query });
        if !self.is_zero(lod) {
            let ty = Type::vector(Scalar::Uint, shape.extent);
            let level = self.value(lod)?;
            let level = self.convert(level, Scalar::Uint);
            let most = self.add(Expression::Literal(Literal::U32(31)));
            let level = self.math(MathFunction::Min, &[level, most]);
            let level = self.splat(level, ty);
            size = self.op(Op::ShiftRight, size, level);
            let one = self.add(Expression::Literal(Literal::U32(1)));
            let one = self.splat(one, ty);
            size = self.math(MathFunction::Max, &[size, one]);
        }
        let size = self.cast(size, ScalarKind::Sint, Some(4));
        if !shape.is_layered {
            return Ok(size);
        }
        let query = ImageQuery::NumLayers;
        let layers = self.add(Expression::ImageQuery { image, query });
        let layers = self.cast(layers, ScalarKind::Sint, Some(4));
        self.compose(Type::vector(Scalar::Int, 3), vec![size, layers])
    }

    fn fetch(
        &mut self,
        image: Value,
        at: OpId,
        lod: OpId,
        offset: Option<OpId>,
        kind: Sampler,
    ) -> Res<Value> {
        let at_ty = self.lowerer.form.ty(at);
        let mut at = self.value(at)?;
        let level = self.value(lod)?;
        if let Some(offset) = offset {
            let offset = self.offset_of(offset, at_ty)?;
            at = self.op(Op::Add, at, offset);
        }
        let function = match self.lowerer.fetches.get(&kind) {
            Some(found) => *found,
            None => {
                let made = fetch(self, kind)?;
                self.lowerer.fetches.insert(kind, made);
                made
            }
        };
        match self.call(function, vec![image, at, level], texel_ty(kind)) {
            Some(value) => Ok(value),
            None => self.lowerer.refuse("this texture cannot be read"),
        }
    }

    /// An offset extended to the type of the coordinates: the layer does not change.
    fn offset_of(&mut self, offset: OpId, at: Type) -> Res<Value> {
        let ty = self.lowerer.form.ty(offset);
        let value = self.value(offset)?;
        if ty == at {
            return Ok(value);
        }
        let layer = self.zero(Type::INT)?;
        self.compose(at, vec![value, layer])
    }

    /// Clamps a level to those of a texture, as in WebGL.
    pub(super) fn nearest_level(&mut self, image: Value, level: Value) -> Res<Value> {
        self.within(image, level, ImageQuery::NumLevels)
    }

    /// Clamps a number to those from 0 to a count of a texture, exclusive.
    pub(super) fn within(&mut self, image: Value, number: Value, query: ImageQuery) -> Res<Value> {
        let count = self.add(Expression::ImageQuery { image, query });
        let count = self.convert(count, Scalar::Int);
        let one = self.add(Expression::Literal(Literal::I32(1)));
        let last = self.op(Op::Subtract, count, one);
        let first = self.zero(Type::INT)?;
        let number = self.math(MathFunction::Max, &[number, first]);
        Ok(self.math(MathFunction::Min, &[number, last]))
    }

    /// Returns a texel if the coordinates are in range.
    pub(super) fn texel_inside(
        &mut self,
        image: Value,
        at: Value,
        level: Value,
        shape: &CoordinateShape,
    ) -> Res<()> {
        let (coordinate, array_index) = match shape.is_layered {
            true => (self.swizzle(at, Lanes::new(0..2)), Some(self.part(at, 2))),
            false => (at, None),
        };
        let level = Some(level);
        let query = ImageQuery::Size { level };
        let size = self.add(Expression::ImageQuery { image, query });
        // Negative coordinates become large unsigned values.
        let unsigned = self.convert(coordinate, Scalar::Uint);
        let argument = self.op(Op::Less, unsigned, size);
        let fun = RelationalFunction::All;
        let mut condition = self.add(Expression::Relational { fun, argument });
        if let Some(layer) = array_index {
            let query = ImageQuery::NumLayers;
            let layers = self.add(Expression::ImageQuery { image, query });
            let layer = self.convert(layer, Scalar::Uint);
            let is_there = self.op(Op::Less, layer, layers);
            condition = self.op(Op::LogicalAnd, condition, is_there);
        }
        let accept = self.nested(|it| {
            let texel = it.add(Expression::ImageLoad {
                image,
                coordinate,
                array_index,
                sample: None,
                level,
            });
            it.push(Statement::Return { value: Some(texel) });
            Ok(())
        })?;
        self.push(Statement::If {
            condition,
            accept,
            reject: Block::new(),
        });
        Ok(())
    }

    fn sample(
        &mut self,
        lookup: Lookup,
        (image, sampler): (Value, Value),
        at: OpId,
        more: &[OpId],
        shape: &CoordinateShape,
    ) -> Res<Value> {
        let at_ty = self.lowerer.form.ty(at);
        let at = self.value(at)?;
        let at = if lookup.is_projective {
            self.projected(at, at_ty, shape)?
        } else {
            at
        };
        let mut more = more.iter().copied();
        let mut level = match lookup.level {
            Level::Implicit => SampleLevel::Auto,
            Level::Explicit | Level::Fetch => match more.next() {
                Some(lod) if shape.is_shadow && self.is_zero(lod) => SampleLevel::Zero,
                Some(lod) if !shape.is_shadow => SampleLevel::Exact(self.value(lod)?),
                _ => return self.lowerer.refuse("depth comparison requires level 0"),
            },
            Level::Gradient => {
                let (Some(x), Some(y), false) = (more.next(), more.next(), shape.is_shadow) else {
                    return self
                        .lowerer
                        .refuse("depth comparison does not support explicit derivatives");
                };
                let (x, y) = (self.value(x)?, self.value(y)?);
                SampleLevel::Gradient { x, y }
            }
        };
        let offset = match lookup.has_offset {
            true => more.next().map(|offset| self.value(offset)).transpose()?,
            false => None,
        };
        if let Some(bias) = more.next() {
            if shape.is_shadow {
                return self
                    .lowerer
                    .refuse("depth comparison does not support a bias");
            }
            level = SampleLevel::Bias(self.value(bias)?);
        }
        let (coordinate, array_index, depth_ref) = self.coordinates(at, shape);
        Ok(self.add(Expression::ImageSample {
            image,
            sampler,
            gather: None,
            coordinate,
            array_index,
            offset,
            level,
            depth_ref,
            clamp_to_edge: false,
        }))
    }

    fn is_zero(&self, level: OpId) -> bool {
        let known = self.lowerer.form.constant(level).first();
        known.is_some_and(|level| level.as_float() == 0.0)
    }

    /// Divides the coordinates by the last component.
    pub(super) fn projected(&mut self, at: Value, ty: Type, shape: &CoordinateShape) -> Res<Value> {
        let last = self.part(at, ty.components().saturating_sub(1));
        let count = shape.size + shape.is_shadow as u8;
        let first = self.swizzle(at, Lanes::new(0..count));
        let by = self.splat(last, Type::vector(Scalar::Float, count));
        Ok(self.op(Op::Divide, first, by))
    }

    /// Splits the coordinates into coordinates, layer and depth reference.
    fn coordinates(
        &mut self,
        at: Value,
        shape: &CoordinateShape,
    ) -> (Value, Option<Value>, Option<Value>) {
        if !shape.is_layered && !shape.is_shadow {
            return (at, None, None);
        }
        let coordinate = self.swizzle(at, Lanes::new(0..shape.size));
        let mut next = shape.size as u32;
        let layer = shape.is_layered.then(|| {
            let layer = self.part(at, next);
            next += 1;
            let nearest = self.math(MathFunction::Round, &[layer]);
            self.cast(nearest, ScalarKind::Sint, Some(4))
        });
        let depth = shape.is_shadow.then(|| self.part(at, next));
        (coordinate, layer, depth)
    }
}

/// The type of a texel.
fn texel_ty(kind: Sampler) -> Type {
    let scalar = match texel(kind) {
        Some(ScalarKind::Sint) => Scalar::Int,
        Some(ScalarKind::Uint) => Scalar::Uint,
        _ => Scalar::Float,
    };
    Type::vector(scalar, 4)
}

/// Generates the function that reads a texel.
fn fetch(body: &mut Body, kind: Sampler) -> Res<Handle<::naga::Function>> {
    let shape = CoordinateShape::of(kind);
    let size = shape.size + u8::from(shape.is_layered);
    let image_ty = body.lowerer.inner(None, image(kind));
    let at_ty = body.lowerer.ty(Type::vector(Scalar::Int, size))?;
    let level_ty = body.lowerer.ty(Type::INT)?;
    let ty = texel_ty(kind);
    let result = body.lowerer.ty(ty)?;
    let mut fetch = Body::new(body.lowerer, &format!("texelFetch_{}", kind.name()));
    let image = fetch.argument("image", image_ty);
    let at = fetch.argument("at", at_ty);
    let level = fetch.argument("level", level_ty);
    fetch.function.result = Some(::naga::FunctionResult {
        ty: result,
        binding: None,
    });
    let level = fetch.nearest_level(image, level)?;
    fetch.texel_inside(image, at, level, &shape)?;
    // Texels out of range are zero, as in WebGL.
    let value = Some(fetch.zero(ty)?);
    fetch.push(Statement::Return { value });
    let function = fetch.finish();
    body.lowerer.define(function)
}
