//! Looking into textures.

use super::body::{Body, Bound};
use super::types::{Sink, image, texel};
use super::uniform::Pair;
use super::{Res, Value};
use crate::ir::{Access, Lanes, OpId, OpKind};
use crate::semantic::builtins::{BuiltinKind, Level, Lookup};
use crate::semantic::{Sampler, Scalar, Type};
use ::naga::{
    BinaryOperator as Op, Block, Expression, Handle, ImageQuery, Literal, MathFunction,
    RelationalFunction, SampleLevel, ScalarKind, Statement,
};

/// What a sampler asks of the coordinates.
struct Shape {
    /// How many coordinates there are.
    size: u8,
    /// Whether a layer is chosen.
    is_layered: bool,
    /// Whether the depth is compared.
    is_shadow: bool,
}

impl Shape {
    fn of(kind: Sampler) -> Shape {
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
        Shape {
            size,
            is_layered,
            is_shadow: texel(kind).is_none(),
        }
    }
}

impl Body<'_, '_> {
    /// The texture that an operand is, and how it is sampled.
    pub(super) fn sampler(&mut self, operand: OpId) -> Res<(Value, Value, Sampler)> {
        let form = self.lowerer.form;
        let refuse = |it: &mut Self, message: &str| {
            it.lowerer.stand_at(form.provenance(operand));
            it.lowerer.refuse(message)
        };
        let OpKind::Load(place) = form.op(operand).kind else {
            return refuse(self, "this is no sampler");
        };
        let place = form.place(place);
        let step = |access: &Access| match access {
            Access::Member(index) | Access::Element(index) => Some(*index),
            _ => None,
        };
        let path: Option<Vec<u32>> = form.path(place).iter().map(step).collect();
        let Some(path) = path else {
            let message = "a sampler can only be chosen by a constant in the other languages";
            return refuse(self, message);
        };
        if let Some(pair) = self.lowerer.uniforms.samplers.get(&(place.variable, path)) {
            let Pair {
                image,
                sampler,
                kind,
            } = *pair;
            let image = self.add(Expression::GlobalVariable(image));
            let sampler = self.add(Expression::GlobalVariable(sampler));
            return Ok((image, sampler, kind));
        }
        match self.bound(place.variable)? {
            Bound::Sampler {
                image,
                sampler,
                kind,
            } if place.path.len == 0 => Ok((image, sampler, kind)),
            _ => refuse(
                self,
                "a sampler travels alone in the other languages, in no array or struct",
            ),
        }
    }

    /// A call of one of the texture functions.
    pub(super) fn texture(&mut self, kind: BuiltinKind, operands: &[OpId]) -> Res<Value> {
        let [texture, rest @ ..] = operands else {
            return self.lowerer.refuse("this reads no texture");
        };
        let (image, sampler, sampled) = self.sampler(*texture)?;
        let shape = Shape::of(sampled);
        match (kind, rest) {
            (BuiltinKind::Size, &[lod]) => self.texture_size(image, lod, &shape),
            (BuiltinKind::Lookup(lookup), &[at, lod, ..]) if lookup.level == Level::Fetch => {
                self.fetch(image, at, lod, rest.get(2).copied(), sampled)
            }
            (BuiltinKind::Lookup(lookup), &[at, ref more @ ..]) => {
                if matches!(texel(sampled), Some(ScalarKind::Sint | ScalarKind::Uint)) {
                    let message = "textures of whole numbers cannot be sampled in the other \
                                   languages; read them with `texelFetch`";
                    return self.lowerer.refuse(message);
                }
                self.sample(lookup, (image, sampler), at, more, &shape)
            }
            _ => self
                .lowerer
                .refuse("this texture function is not supported"),
        }
    }

    fn texture_size(&mut self, image: Value, lod: OpId, shape: &Shape) -> Res<Value> {
        let level = Some(self.value(lod)?);
        let query = ImageQuery::Size { level };
        let size = self.add(Expression::ImageQuery { image, query });
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

    /// An offset, for coordinates of a type: the layer stays.
    fn offset_of(&mut self, offset: OpId, at: Type) -> Res<Value> {
        let ty = self.lowerer.form.ty(offset);
        let value = self.value(offset)?;
        if ty == at {
            return Ok(value);
        }
        let layer = self.zero(Type::INT)?;
        self.compose(at, vec![value, layer])
    }

    /// The level of a texture that is nearest to a number, as in WebGL.
    fn nearest_level(&mut self, image: Value, level: Value) -> Res<Value> {
        let query = ImageQuery::NumLevels;
        let levels = self.add(Expression::ImageQuery { image, query });
        let levels = self.convert(levels, Scalar::Int);
        let one = self.add(Expression::Literal(Literal::I32(1)));
        let last = self.op(Op::Subtract, levels, one);
        let first = self.zero(Type::INT)?;
        let level = self.math(MathFunction::Max, &[level, first]);
        Ok(self.math(MathFunction::Min, &[level, last]))
    }

    /// Returns the texel of a texture where there is one.
    fn texel_inside(&mut self, image: Value, at: Value, level: Value, shape: &Shape) -> Res<()> {
        let (coordinate, array_index) = match shape.is_layered {
            true => (self.swizzle(at, Lanes::new(0..2)), Some(self.part(at, 2))),
            false => (at, None),
        };
        let level = Some(level);
        let query = ImageQuery::Size { level };
        let size = self.add(Expression::ImageQuery { image, query });
        // What lies below zero is a large number without a sign.
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
        shape: &Shape,
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
                _ => return self.lowerer.refuse("depth can only be compared at level 0"),
            },
            Level::Gradient => {
                let (Some(x), Some(y), false) = (more.next(), more.next(), shape.is_shadow) else {
                    return self
                        .lowerer
                        .refuse("depth cannot be compared with given derivatives");
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
                return self.lowerer.refuse("depth cannot be compared with a bias");
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

    /// Coordinates divided by the last.
    fn projected(&mut self, at: Value, ty: Type, shape: &Shape) -> Res<Value> {
        let last = self.part(at, ty.components().saturating_sub(1));
        let count = shape.size + shape.is_shadow as u8;
        let first = self.swizzle(at, Lanes::new(0..count));
        let by = self.splat(last, Type::vector(Scalar::Float, count));
        Ok(self.op(Op::Divide, first, by))
    }

    /// Coordinates, layer and the depth to compare with.
    fn coordinates(&mut self, at: Value, shape: &Shape) -> (Value, Option<Value>, Option<Value>) {
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

/// What a texel of a texture is.
fn texel_ty(kind: Sampler) -> Type {
    let scalar = match texel(kind) {
        Some(ScalarKind::Sint) => Scalar::Int,
        Some(ScalarKind::Uint) => Scalar::Uint,
        _ => Scalar::Float,
    };
    Type::vector(scalar, 4)
}

/// The function that reads a texel of a kind of texture.
fn fetch(body: &mut Body, kind: Sampler) -> Res<Handle<::naga::Function>> {
    let shape = Shape::of(kind);
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
    // Outside there is nothing, as in WebGL.
    let value = Some(fetch.zero(ty)?);
    fetch.push(Statement::Return { value });
    let function = fetch.finish();
    body.lowerer.define(function)
}
