//! Uniforms: one struct for the numbers, a texture and a sampler for each sampler.

use super::body::{Body, Bound};
use super::global::Global;
use super::lower::{FirstRow, Lowerer};
use super::types::{Sink, image};
use super::{Res, Value};
use crate::ir::Place;
use crate::semantic::{Sampler, Scalar, Storage, Type, Variable, VariableId};
use ::naga::{
    AddressSpace, Expression, GlobalVariable, Handle, MemoryDecorations, ResourceBinding, Span,
    TypeInner,
};

/// The uniforms of a pass.
#[derive(Default)]
pub(super) struct Uniforms {
    /// The struct that holds them.
    pub(super) block: Option<Handle<GlobalVariable>>,
    /// Where the height of the picture stands, of a picture whose rows are turned.
    pub(super) height: Option<Height>,
    /// What the host must know.
    legend: Vec<String>,
}

/// Where the height of the picture stands among the uniforms.
#[derive(Clone, Copy, Debug)]
pub(super) enum Height {
    /// In the second component of this member.
    Resolution(u32),
    /// In this member, which the shader knows nothing of.
    Own(u32),
}

/// How a uniform lies in the struct.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Form {
    /// As it is.
    Plain(Type),
    /// As a number, which is not 0 where it is true.
    Flag(Type),
    /// Each element at the start of four numbers, as arrays must lie.
    Wide(Type),
}

impl Form {
    fn of(ty: Type) -> Option<Form> {
        let (scalar, columns, rows) = ty.element().numeric()?;
        match (ty.is_array(), scalar) {
            (false, Scalar::Bool) => Some(Form::Flag(ty.with_scalar(Scalar::Uint))),
            (true, Scalar::Bool) => None,
            (true, _) if columns == 1 && rows < 3 => {
                Some(Form::Wide(Type::vector(scalar, 4).array_of(ty.array)))
            }
            // Two rows lie closer together than arrays and structs of the others allow.
            _ if columns > 1 && rows == 2 => None,
            _ => Some(Form::Plain(ty)),
        }
    }

    fn ty(self) -> Type {
        match self {
            Form::Plain(ty) | Form::Flag(ty) | Form::Wide(ty) => ty,
        }
    }
}

impl<'p> Lowerer<'p> {
    /// Declares all uniforms that can be; the others are refused where they are used.
    pub(super) fn declare_uniforms(&mut self) -> Res<()> {
        let program = self.program;
        let mut members = Vec::new();
        let mut number = 0;
        for (i, variable) in program.variables.iter().enumerate() {
            if variable.storage != Storage::Uniform || variable.token.is_none() {
                continue;
            }
            let id = VariableId(i as u32);
            let name = program.names.text(variable.name);
            if let Some(kind) = variable.ty.as_sampler() {
                self.declare_sampler(id, name, kind, number);
                number += 1;
            } else if let Some(form) = Form::of(variable.ty) {
                let member = members.len() as u32;
                if self.tells_size(variable) {
                    self.uniforms.height = Some(Height::Resolution(member));
                }
                members.push((name.to_string(), self.ty(form.ty())?));
                self.globals.insert(id, Global::Uniform(member));
            }
        }
        if self.uniforms.height.is_none() && self.turns_rows() {
            self.uniforms.height = Some(Height::Own(members.len() as u32));
            let name = self.unused("pictureHeight");
            self.uniforms.legend.push(format!(
                "{name} is the height of the picture in pixels: rows are counted from below"
            ));
            members.push((name, self.ty(Type::FLOAT)?));
        }
        if members.is_empty() {
            return Ok(());
        }
        let ty = self.record(Some("Uniforms".to_string()), members)?;
        self.describe(ty);
        let block = self.resource("uniforms", ty, AddressSpace::Uniform, 0);
        self.uniforms.block = Some(block);
        Ok(())
    }

    /// Whether a uniform is the one by which ShaderToy's player tells the size of the picture. What
    /// the user calls so may be anything.
    fn tells_size(&self, variable: &Variable) -> bool {
        let program = self.program;
        let is_players = program
            .declared_at(variable)
            .is_some_and(|at| !program.is_user(at));
        is_players && program.names.text(variable.name) == "iResolution"
    }

    /// Whether rows are turned where the shader asks which one it draws.
    fn turns_rows(&self) -> bool {
        let name = self.program.names.get("gl_FragCoord");
        let is_it = |p: &Place| self.program.variable(p.variable).map(|v| v.name) == name;
        self.origin == FirstRow::Picture && name.is_some() && self.form.places.iter().any(is_it)
    }

    /// A name that the shader does not use.
    fn unused(&self, name: &str) -> String {
        let mut name = name.to_string();
        while self.program.names.get(&name).is_some() {
            name.push_str("InPixels");
        }
        name
    }

    fn declare_sampler(&mut self, id: VariableId, name: &str, kind: Sampler, number: u32) {
        let (texture, sampler) = (2 * number + 1, 2 * number + 2);
        self.uniforms.legend.push(format!(
            "group 0, binding {texture}: the texture of {name}; binding {sampler}: how it is sampled"
        ));
        let ty = self.inner(None, image(kind));
        let space = AddressSpace::Handle;
        let image = self.resource(name, ty, space, texture);
        let comparison = super::types::texel(kind).is_none();
        let ty = self.inner(None, TypeInner::Sampler { comparison });
        let space = AddressSpace::Handle;
        let sampler = self.resource(&format!("{name}Sampler"), ty, space, sampler);
        self.globals.insert(
            id,
            Global::Sampler {
                image,
                sampler,
                kind,
            },
        );
    }

    fn resource(
        &mut self,
        name: &str,
        ty: Handle<::naga::Type>,
        space: AddressSpace,
        binding: u32,
    ) -> Handle<GlobalVariable> {
        let variable = GlobalVariable {
            name: Some(name.to_string()),
            space,
            binding: Some(ResourceBinding { group: 0, binding }),
            ty,
            init: None,
            memory_decorations: MemoryDecorations::empty(),
        };
        self.module
            .global_variables
            .append(variable, Span::UNDEFINED)
    }

    fn describe(&mut self, ty: Handle<::naga::Type>) {
        let TypeInner::Struct { members, span } = &self.module.types[ty].inner else {
            return;
        };
        let placed: Vec<String> = members
            .iter()
            .map(|m| format!("{} at {}", m.name.as_deref().unwrap_or(""), m.offset))
            .collect();
        let first = format!(
            "group 0, binding 0: the uniforms, {span} bytes: {}",
            placed.join(", ")
        );
        self.uniforms.legend.insert(0, first);
    }

    /// What the host must know.
    pub(super) fn legend(&self) -> Vec<String> {
        self.uniforms.legend.clone()
    }
}

impl Body<'_, '_> {
    /// What points at a member of the uniforms.
    pub(super) fn uniform_member(&mut self, member: u32) -> Res<Value> {
        let Some(block) = self.lowerer.uniforms.block else {
            return self.lowerer.refuse("there are no uniforms");
        };
        let base = self.add(Expression::GlobalVariable(block));
        Ok(self.part(base, member))
    }

    /// A uniform of the shader.
    pub(super) fn uniform(&mut self, id: VariableId, member: u32) -> Res<Bound> {
        let ty = self.lowerer.form.variable(id).map_or(Type::ERROR, |v| v.ty);
        let pointer = self.uniform_member(member)?;
        match Form::of(ty) {
            Some(Form::Plain(_)) => Ok(Bound::Pointer(pointer)),
            Some(Form::Flag(_)) => {
                let value = self.load(pointer);
                Ok(Bound::Value(self.convert(value, Scalar::Bool)))
            }
            Some(Form::Wide(wide)) => self.narrow(ty, wide, pointer).map(Bound::Pointer),
            None => self
                .lowerer
                .refuse("a uniform of this type is not supported"),
        }
    }

    /// An array of numbers out of one whose elements take four each.
    fn narrow(&mut self, ty: Type, wide: Type, pointer: Value) -> Res<Value> {
        let rows = ty.element().components();
        let copy = self.local(None, ty)?;
        for i in 0..wide.array {
            let from = self.part(pointer, i);
            let value = self.load(from);
            let mut parts: Vec<Value> = (0..rows).map(|r| self.part(value, r)).collect();
            let element = match (parts.pop(), rows) {
                (Some(only), 1) => only,
                (last, _) => {
                    parts.extend(last);
                    self.compose(ty.element(), parts)?
                }
            };
            let to = self.part(copy, i);
            self.store(to, element);
        }
        Ok(copy)
    }
}
