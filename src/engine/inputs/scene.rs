//! The inputs of one shader: uniforms by the meaning of their names, varyings, and values set by
//! the user.

use super::moment::Moment;
use super::varyings::Varyings;
use shaderlint_contract::InputValue;
use shaderlint_exec::{Bytecode, CompileOptions, Draw, Refusal, UniformSlot, compile};
use shaderlint_host::{Feed, Preset};
use shaderlint_ir::Module;
use shaderlint_project::{Bindings, UniformControl, bindings};
use shaderlint_semantic::{Program, Storage, Type};

/// A shader with its inputs, ready to draw.
pub struct Scene {
    /// The bytecode of the shader.
    pub code: Bytecode,
    /// The inputs of the shader.
    pub given: GivenUniforms,
    /// The declared uniforms, including unused ones.
    declared: Vec<String>,
}

/// The inputs of a shader that declares its own uniforms.
pub struct GivenUniforms {
    /// The meaning of its names.
    pub bound: Bindings,
    varyings: Option<Varyings>,
    /// Uniforms with values that do not depend on the frame.
    fixed: Vec<(String, Vec<f64>)>,
}

/// Why a uniform cannot be set.
#[derive(Clone, PartialEq, Debug)]
pub enum Unfit {
    /// There is no uniform of this name.
    Unknown,
    /// The uniform is a sampler.
    Sampler,
    /// It has a different number of components.
    Count {
        /// Type of the uniform.
        ty: Type,
        /// Number of components that it has.
        takes: u32,
    },
}

impl Scene {
    /// A shader that declares its own uniforms, or a pass that ShaderToy's player completes. Names
    /// determine the inputs. `host` is the host that the user names.
    ///
    /// # Errors
    /// What cannot be run.
    pub fn of(
        program: &Program,
        host: Option<&'static Preset>,
        module: &Module,
        options: &CompileOptions,
    ) -> Result<Scene, Refusal> {
        Scene::bound(program, module, bindings(program, host), options)
    }

    /// A shader with known inputs.
    ///
    /// # Errors
    /// What cannot be run.
    pub fn bound(
        program: &Program,
        module: &Module,
        bound: Bindings,
        options: &CompileOptions,
    ) -> Result<Scene, Refusal> {
        let uniforms = program.variables.iter();
        let uniforms = uniforms.filter(|v| v.storage == Storage::Uniform);
        Ok(Scene {
            code: compile(program, module, options)?,
            given: GivenUniforms::of(bound),
            declared: uniforms
                .map(|v| program.names.text(v.name).to_string())
                .collect(),
        })
    }

    /// Sets controls to the defaults that the shader describes.
    pub fn set_controls(&mut self, controls: &[UniformControl]) {
        let set = controls.iter().map(|c| (c.name.clone(), c.value.clone()));
        self.given.fixed.extend(set);
    }

    /// Sets a uniform for all frames, as [`Draw::set`] does; unused uniforms are ignored.
    ///
    /// # Errors
    /// Why it cannot be set.
    pub fn set(&mut self, name: &str, scalars: &[f64]) -> Result<(), Unfit> {
        let mut draw = Draw::new(&self.code, [1, 1]);
        if !draw.set(name, scalars) {
            self.unfit(name)?;
        }
        self.given.fixed.push((name.to_string(), scalars.to_vec()));
        Ok(())
    }

    /// Why a uniform cannot be set; `Ok` if the shader declares it but does not use it.
    fn unfit(&self, name: &str) -> Result<(), Unfit> {
        let element = name.strip_suffix(']').and_then(|n| n.rsplit_once('['));
        let by_name = |name: &str| self.code.uniforms.iter().find(|slot| slot.name == name);
        let slot = by_name(name).map(|slot| slot.ty);
        let slot = slot.or_else(|| by_name(element?.0).map(|slot| slot.ty.element()));
        if let Some(ty) = slot {
            let takes = scalars(ty);
            return Err(Unfit::Count { ty, takes });
        }
        if self.code.samplers.iter().any(|slot| slot.name == name) {
            return Err(Unfit::Sampler);
        }
        let root = name.split(['.', '[']).next().unwrap_or(name);
        match self.declared.iter().any(|declared| declared == root) {
            true => Ok(()),
            false => Err(Unfit::Unknown),
        }
    }

    /// The declared uniforms, for suggestions.
    pub fn declared(&self) -> &[String] {
        &self.declared
    }

    /// The used uniforms that nothing sets, which are zero.
    pub fn zeros(&self) -> Vec<&str> {
        let is_fixed = |name: &str| {
            let matches = |fixed: &str| fixed.split(['.', '[']).next() == Some(name);
            self.given.fixed.iter().any(|(fixed, _)| matches(fixed))
        };
        let controls = self.given.bound.controls.iter().map(|c| c.name.as_str());
        let zeros = self.given.bound.zeros.iter().map(String::as_str);
        let all = controls.chain(zeros).filter(|name| !is_fixed(name));
        let is_needed = |name: &&str| {
            let root = |slot: &UniformSlot| slot.name.split(['.', '[']).next() == Some(*name);
            self.code.uniforms.iter().any(root)
        };
        all.filter(is_needed).collect()
    }

    /// A draw of a frame, with everything set except textures.
    pub fn draw(&self, size: [u32; 2], moment: &Moment) -> Draw<'_> {
        self.given.draw(&self.code, size, moment)
    }
}

impl GivenUniforms {
    /// Inputs by the meaning of names, without values set by the user.
    pub fn of(bound: Bindings) -> GivenUniforms {
        GivenUniforms {
            varyings: Varyings::of(&bound.varyings),
            bound,
            fixed: Vec::new(),
        }
    }

    /// Gives a uniform whose meaning is not known a value for all frames.
    pub(crate) fn fix(&mut self, name: &str, value: InputValue) {
        let mut known = self.bound.controls.iter().map(|c| &c.name);
        let is_open =
            known.any(|known| known == name) || self.bound.zeros.iter().any(|z| z == name);
        if let (true, InputValue::Numbers(numbers)) = (is_open, value) {
            self.fixed.push((name.to_string(), numbers));
        }
    }

    /// A draw of the bytecode for a frame, with everything set except textures.
    pub fn draw<'c>(&self, code: &'c Bytecode, size: [u32; 2], moment: &Moment) -> Draw<'c> {
        let mut draw = Draw::new(code, size);
        for given in &self.bound.uniforms {
            let slot = code.uniforms.iter().find(|s| s.name == given.name);
            let Some(ty) = slot.map(|s| s.ty) else {
                continue;
            };
            let mut lanes = match given.source {
                Feed::Identity => identity(ty),
                source => moment.lanes(source, size),
            };
            if !lanes.is_empty() {
                lanes.resize(scalars(ty) as usize, 0.0);
                draw.set(&given.name, &lanes);
            }
        }
        for (name, lanes) in &self.fixed {
            draw.set(name, lanes);
        }
        if let Some(varyings) = &self.varyings {
            varyings.set(&mut draw);
        }
        draw
    }
}

/// Number of components of a uniform.
fn scalars(ty: Type) -> u32 {
    ty.element().components() * ty.array.max(1)
}

/// The components of identity matrices in column order.
fn identity(ty: Type) -> Vec<f64> {
    let Some((_, columns, rows)) = ty.element().numeric() else {
        return Vec::new();
    };
    let cells = (0..columns).flat_map(|c| (0..rows).map(move |r| f64::from(u8::from(c == r))));
    let one: Vec<f64> = cells.collect();
    one.repeat(ty.array.max(1) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_default_to_the_identity() {
        assert_eq!(identity(Type::matrix(2, 3)), [1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        assert_eq!(scalars(Type::matrix(2, 3).array_of(2)), 12);
    }
}
