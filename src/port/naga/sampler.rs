//! Resolves samplers. The target languages have no arrays of textures, so a texture with a computed
//! index becomes a `switch` over all elements.

use super::body::Body;
use super::target::{Res, Value};
use super::types::{Sink, image, texel};
use super::uniform::Pair;
use ::naga::{Expression, Statement, SwitchCase, SwitchValue, TypeInner};
use shaderlint_ir::{Access, OpId, OpKind};
use shaderlint_semantic::{Sampler, Scalar, Type, VariableId};

/// A texture with its sampler.
#[derive(Clone, Copy)]
pub(super) struct Looked {
    /// The texture.
    pub(super) image: Value,
    pub(super) sampler: Value,
    /// The sampler type in GLSL.
    pub(super) kind: Sampler,
}

/// The possible samplers of an operand.
enum SamplerChoice {
    One(Looked),
    /// The elements of an array, and the computed index.
    Element(OpId, Vec<Looked>),
}

impl Body<'_, '_> {
    /// Applies `make` to the texture of an operand, for each possible element. Returns its result.
    pub(super) fn with_sampler(
        &mut self,
        operand: OpId,
        ty: Type,
        mut make: impl FnMut(&mut Self, Looked) -> Res<Option<Value>>,
    ) -> Res<Option<Value>> {
        let (index, all) = match self.choice(operand)? {
            SamplerChoice::One(looked) => return make(self, looked),
            SamplerChoice::Element(index, all) => (index, all),
        };
        let result = match ty.is_void() {
            true => None,
            false => Some(self.local(None, ty)?),
        };
        let is_unsigned = self.lowerer.form.scalar(index) == Some(Scalar::Uint);
        let selector = self.value(index)?;
        let mut cases = Vec::new();
        for (number, looked) in (0..).zip(all) {
            let body = self.nested(|it| {
                let value = make(it, looked)?;
                if let (Some(to), Some(value)) = (result, value) {
                    it.store(to, value);
                }
                Ok(())
            })?;
            let value = match is_unsigned {
                true => SwitchValue::U32(number),
                false => SwitchValue::I32(number as i32),
            };
            cases.push(SwitchCase {
                value,
                body,
                fall_through: false,
            });
        }
        // Any other index selects the last element.
        if let Some(last) = cases.last_mut() {
            last.value = SwitchValue::Default;
        }
        self.push(Statement::Switch { selector, cases });
        Ok(result.map(|from| self.load(from)))
    }

    /// The textures of an operand: one, or the elements of an array.
    pub(super) fn samplers(&mut self, operand: OpId) -> Res<Vec<Looked>> {
        let ty = self.lowerer.form.ty(operand);
        if ty.is_array() {
            return self.elements(operand, ty.array);
        }
        match self.choice(operand)? {
            SamplerChoice::One(looked) => Ok(vec![looked]),
            SamplerChoice::Element(..) => self.lowerer.refuse(MANY),
        }
    }

    /// Whether the texture of an operand has a computed index.
    pub(super) fn is_chosen(&self, operand: OpId) -> bool {
        let form = self.lowerer.form;
        match form.op(operand).kind {
            OpKind::Load(place) => {
                let path = form.path(form.place(place));
                path.iter().any(|a| matches!(a, Access::Computed(_)))
            }
            _ => false,
        }
    }

    fn elements(&mut self, operand: OpId, count: u32) -> Res<Vec<Looked>> {
        let (variable, path) = self.path_of(operand)?;
        let Some(mut steps) = path.iter().map(number).collect::<Option<Vec<u32>>>() else {
            return self.lowerer.refuse(MANY);
        };
        let mut found = Vec::new();
        for i in 0..count {
            steps.push(i);
            found.extend(self.looked(variable, &steps));
            steps.pop();
        }
        Ok(found)
    }

    fn choice(&mut self, operand: OpId) -> Res<SamplerChoice> {
        let (variable, path) = self.path_of(operand)?;
        let computed = path.iter().position(|a| matches!(a, Access::Computed(_)));
        let (before, chosen, after) = match computed {
            None => (&path[..], None, &[][..]),
            Some(at) => {
                let (before, rest) = path.split_at(at);
                (before, rest.first(), rest.get(1..).unwrap_or(&[]))
            }
        };
        let before: Option<Vec<u32>> = before.iter().map(number).collect();
        let after: Option<Vec<u32>> = after.iter().map(number).collect();
        let (Some(mut steps), Some(after)) = (before, after) else {
            return self.lowerer.refuse(MANY);
        };
        let Some(Access::Computed(index)) = chosen else {
            return match self.looked(variable, &steps) {
                Some(looked) => Ok(SamplerChoice::One(looked)),
                None => self.lowerer.refuse("unknown sampler"),
            };
        };
        let known = steps.len();
        let mut all = Vec::new();
        for i in 0.. {
            steps.truncate(known);
            steps.push(i);
            steps.extend(&after);
            match self.looked(variable, &steps) {
                Some(looked) => all.push(looked),
                None => break,
            }
        }
        match all.is_empty() {
            true => self.lowerer.refuse("unknown sampler"),
            false => Ok(SamplerChoice::Element(*index, all)),
        }
    }

    /// The variable that an operand is read from, with its path.
    fn path_of(&mut self, operand: OpId) -> Res<(VariableId, Vec<Access>)> {
        let form = self.lowerer.form;
        let OpKind::Load(place) = form.op(operand).kind else {
            self.lowerer.stand_at(form.provenance(operand));
            return self.lowerer.refuse("this is not a sampler");
        };
        let place = form.place(place);
        Ok((place.variable, form.path(place).to_vec()))
    }

    /// The texture at a path.
    fn looked(&mut self, variable: VariableId, steps: &[u32]) -> Option<Looked> {
        let key = (variable, steps.to_vec());
        if let Some(found) = self.samplers.get(&key) {
            return Some(*found);
        }
        let Pair {
            image,
            sampler,
            kind,
        } = *self.lowerer.uniforms.samplers.get(&key)?;
        Some(Looked {
            image: self.add(Expression::GlobalVariable(image)),
            sampler: self.add(Expression::GlobalVariable(sampler)),
            kind,
        })
    }

    /// Declares the arguments for a sampler parameter, or for an array of samplers.
    pub(super) fn sampler_parameter(&mut self, id: VariableId, name: &str, ty: Type) -> Res<()> {
        let Some(kind) = ty.element().as_sampler() else {
            let message = "the target language cannot pass a struct with a sampler to a \
                           function; pass its members instead";
            return self.lowerer.refuse(message);
        };
        for i in 0..ty.array.max(1) {
            let (steps, name) = match ty.is_array() {
                true => (vec![i], format!("{name}_{i}")),
                false => (Vec::new(), name.to_string()),
            };
            let ty = self.lowerer.inner(None, image(kind));
            let image = self.argument(&name, ty);
            let comparison = texel(kind).is_none();
            let ty = self.lowerer.inner(None, TypeInner::Sampler { comparison });
            let sampler = self.argument(&format!("{name}Sampler"), ty);
            let looked = Looked {
                image,
                sampler,
                kind,
            };
            self.samplers.insert((id, steps), looked);
        }
        Ok(())
    }
}

const MANY: &str = "the target language cannot select a sampler with several computed indices";

/// The constant index of an access.
fn number(access: &Access) -> Option<u32> {
    match access {
        Access::Member(index) | Access::Element(index) => Some(*index),
        _ => None,
    }
}
