//! Uniforms: one buffer for those outside of blocks, one for each block, and a texture and a
//! sampler for each sampler.

use super::body::{Body, Bound};
use super::global::Global;
use super::interface::{BindSlot, Buffer, BufferMember, HostInterface, TexturePair};
use super::lower::NagaLowerer;
use super::stored::{Major, Packing, Stored, StoredField, StoredPlace, StoredRecord};
use super::target::{FirstRow, Res, TargetLanguage, Value};
use super::types::{Sink, image};
use ::naga::{AddressSpace, Expression, GlobalVariable, Handle, ResourceBinding, TypeInner};
use rustc_hash::FxHashMap;
use shaderlint_ir::Place;
use shaderlint_semantic::{Base, Sampler, Stage, Storage, Type, Variable, VariableId};

/// The uniforms of a shader.
#[derive(Default)]
pub(super) struct Uniforms {
    /// Where the height of the image is stored, if rows are flipped.
    pub(super) height: Option<Height>,
    /// The layouts of structs and blocks, with the places of their fields.
    pub(super) records: FxHashMap<(Type, Major), StoredRecord>,
    /// The buffer for uniforms outside of blocks.
    own: Option<Handle<GlobalVariable>>,
    /// By struct of a block without an instance name: its buffer.
    blocks: FxHashMap<u16, Handle<GlobalVariable>>,
    /// By block with an instance name: its buffers, one for each element.
    pub(super) instances: FxHashMap<VariableId, Vec<Handle<GlobalVariable>>>,
    /// The samplers, by variable and by the indexes of members and elements.
    pub(super) samplers: FxHashMap<(VariableId, Vec<u32>), Pair>,
    /// The next free binding after those of the samplers.
    next: u32,
}

/// A sampler of the shader.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    /// The texture.
    pub(super) image: Handle<GlobalVariable>,
    pub(super) sampler: Handle<GlobalVariable>,
    /// The sampler type in GLSL.
    pub(super) kind: Sampler,
}

/// The uniform with the height of the image.
#[derive(Clone, Copy, Debug)]
pub(super) enum Height {
    /// The second component of this member.
    Resolution(u32),
    /// This additional member.
    Own(u32),
}

/// The uniforms outside of blocks.
#[derive(Default)]
struct Alone {
    packing: Packing,
    listed: Vec<BufferMember>,
    members: Vec<(VariableId, u32)>,
}

impl<'p> NagaLowerer<'p> {
    /// Declares all uniforms in source order: those outside of blocks, then samplers, then blocks.
    pub(super) fn declare_uniforms(&mut self) -> Res<()> {
        let program = self.program;
        let uniforms = || {
            let all = (0..).map(VariableId).zip(&program.variables);
            all.filter(|(_, v)| v.storage == Storage::Uniform && v.token.is_some())
        };
        let mut alone = Alone::default();
        for (id, variable) in uniforms() {
            self.stand_at_name(variable);
            let inside = self.inside(variable.ty);
            if inside.sampler && (variable.ty.element().is_sampler() || variable.read) {
                let name = program.names.text(variable.name).to_string();
                self.declare_samplers(id, &mut Vec::new(), &name, variable.ty);
            }
            let is_block = matches!(variable.ty.base, Base::Block(_));
            let is_data = !inside.sampler || (variable.read && !variable.ty.element().is_sampler());
            if is_data && !is_block && self.block_of(variable).is_none() {
                self.declare_alone(id, variable, &mut alone)?;
            }
        }
        self.finish_alone(alone)?;
        for (id, variable) in uniforms() {
            self.stand_at_name(variable);
            if matches!(variable.ty.base, Base::Block(_)) {
                self.declare_instances(id, variable)?;
            } else if let Some((block, field)) = self.block_of(variable) {
                self.declare_field(id, block, field)?;
            }
        }
        Ok(())
    }

    fn declare_alone(&mut self, id: VariableId, variable: &Variable, alone: &mut Alone) -> Res<()> {
        let name = self.program.names.text(variable.name);
        let ty = (variable.ty, Major::Columns);
        let stored = self.stored(ty.0, ty.1)?;
        let StoredField { member, offset, .. } = alone.packing.add(self, name, stored)?;
        self.list(name, ty, offset, &mut alone.listed);
        alone.members.push((id, member));
        if self.gives_size(variable) {
            self.uniforms.height = Some(Height::Resolution(member));
        }
        Ok(())
    }

    /// Declares the buffer for uniforms outside of blocks, with the height of the image if needed.
    fn finish_alone(&mut self, mut alone: Alone) -> Res<()> {
        if self.uniforms.height.is_none() && self.flips_rows() {
            let name = self.program.names.unused("pictureHeight");
            let ty = (Type::FLOAT, Major::Columns);
            let stored = self.stored(ty.0, ty.1)?;
            let StoredField { member, offset, .. } = alone.packing.add(self, &name, stored)?;
            self.list(&name, ty, offset, &mut alone.listed);
            self.uniforms.height = Some(Height::Own(member));
            self.interface.notes.push(format!(
                "{name} is the height of the image in pixels: rows are counted from the bottom"
            ));
        }
        if alone.packing.is_empty() {
            return Ok(());
        }
        let stored = alone.packing.finish(self, Some("Uniforms".to_string()))?;
        let name = HostInterface::UNIFORMS;
        let buffer = self.declare_buffer(name, stored, 0, alone.listed);
        for (id, member) in alone.members {
            let place = Global::Stored(buffer, member, Major::Columns);
            self.globals.insert(id, place);
        }
        self.uniforms.own = Some(buffer);
        Ok(())
    }

    /// Declares the buffers of a block with an instance name.
    fn declare_instances(&mut self, id: VariableId, variable: &Variable) -> Res<()> {
        let block = variable.ty.element();
        let stored = self.stored(block, Major::Columns)?;
        let mut buffers = Vec::new();
        for i in 0..variable.ty.array.max(1) {
            let mut name = self.program.type_name(block);
            if variable.ty.is_array() {
                name = format!("{name}[{i}]");
            }
            let mut listed = Vec::new();
            self.list(&name, (block, Major::Columns), 0, &mut listed);
            buffers.push(self.declare_block(&name, stored, listed));
        }
        self.uniforms.instances.insert(id, buffers);
        Ok(())
    }

    /// Declares a member of a block without an instance name.
    fn declare_field(&mut self, id: VariableId, block: u16, field: usize) -> Res<()> {
        let ty = Type::block(block.into());
        let buffer = match self.uniforms.blocks.get(&block) {
            Some(buffer) => *buffer,
            None => {
                let stored = self.stored(ty, Major::Columns)?;
                let mut listed = Vec::new();
                // Without an instance name, the members have no prefix.
                self.list("", (ty, Major::Columns), 0, &mut listed);
                let name = self.program.type_name(ty);
                let buffer = self.declare_block(&name, stored, listed);
                self.uniforms.blocks.insert(block, buffer);
                buffer
            }
        };
        if let Some(Some(place)) = self.stored_fields(ty, Major::Columns).get(field) {
            let place = Global::Stored(buffer, place.member, place.major);
            self.globals.insert(id, place);
        }
        Ok(())
    }

    fn declare_block(
        &mut self,
        name: &str,
        stored: Stored,
        listed: Vec<BufferMember>,
    ) -> Handle<GlobalVariable> {
        let binding = self.uniforms.next.max(1);
        self.uniforms.next = binding + 1;
        self.declare_buffer(name, stored, binding, listed)
    }

    fn declare_buffer(
        &mut self,
        name: &str,
        stored: Stored,
        binding: u32,
        members: Vec<BufferMember>,
    ) -> Handle<GlobalVariable> {
        let number = self.interface.buffers.len() as u32;
        let slot = self.slot(
            binding,
            match self.language {
                TargetLanguage::Hlsl => format!("register(b{binding}, space{})", self.group()),
                _ => format!("[[buffer({number})]]"),
            },
        );
        self.interface.buffers.push(Buffer {
            name: name.to_string(),
            slot,
            size: stored.size,
            members,
        });
        let written = name.replace(['[', ']'], "_");
        self.resource(&written, stored.ty, AddressSpace::Uniform, binding)
    }

    /// The block without an instance name that declares a uniform, and the index of the member.
    fn block_of(&self, variable: &Variable) -> Option<(u16, usize)> {
        let token = variable.token?;
        let structs = (0..).zip(&self.program.structs);
        let mut found = structs.filter_map(|(id, s)| {
            let field = s.fields.iter().position(|f| f.token == token)?;
            Some((id, field))
        });
        found.next()
    }

    /// Whether a uniform is `iResolution` of ShaderToy's player. A user's uniform of that name may
    /// have any meaning.
    fn gives_size(&self, variable: &Variable) -> bool {
        let program = self.program;
        let is_players = program
            .declared_at(variable)
            .is_some_and(|at| !program.is_user(at));
        is_players && program.names.text(variable.name) == "iResolution"
    }

    /// Whether rows are flipped and the shader uses the row of the pixel.
    fn flips_rows(&self) -> bool {
        let name = self.program.names.get("gl_FragCoord");
        let is_it = |p: &Place| self.program.variable(p.variable).map(|v| v.name) == name;
        self.origin == FirstRow::Top && name.is_some() && self.form.places.iter().any(is_it)
    }

    /// Declares the samplers in a value of a type.
    fn declare_samplers(&mut self, id: VariableId, path: &mut Vec<u32>, name: &str, ty: Type) {
        let program = self.program;
        if ty.is_array() {
            for i in 0..ty.array {
                path.push(i);
                self.declare_samplers(id, path, &format!("{name}[{i}]"), ty.element());
                path.pop();
            }
        } else if let Some(kind) = ty.as_sampler() {
            let pair = self.declare_sampler(name, kind);
            self.uniforms.samplers.insert((id, path.clone()), pair);
        } else if let Some(found) = program.struct_of(ty) {
            for (i, field) in (0..).zip(&found.fields) {
                let inner = format!("{name}.{}", program.names.text(field.name));
                path.push(i);
                self.declare_samplers(id, path, &inner, field.ty);
                path.pop();
            }
        }
    }

    fn declare_sampler(&mut self, name: &str, kind: Sampler) -> Pair {
        let number = self.interface.textures.len() as u32;
        let (texture, how) = (2 * number + 1, 2 * number + 2);
        self.uniforms.next = how + 1;
        let is_hlsl = self.language == TargetLanguage::Hlsl;
        let space = self.group();
        let texture_slot = self.slot(
            texture,
            match is_hlsl {
                true => format!("register(t{texture}, space{space})"),
                false => format!("[[texture({number})]]"),
            },
        );
        let sampler_slot = self.slot(
            how,
            match is_hlsl {
                true => format!("entry {how} of nagaGroup{space}SamplerIndexArray"),
                false => format!("[[sampler({number})]]"),
            },
        );
        self.interface.textures.push(TexturePair {
            name: name.to_string(),
            ty: kind.name(),
            texture: texture_slot,
            sampler: sampler_slot,
            source: None,
        });
        let written = name.replace(['[', ']', '.'], "_");
        let ty = self.inner(None, image(kind));
        let image = self.resource(&written, ty, AddressSpace::Handle, texture);
        let comparison = super::types::texel(kind).is_none();
        let ty = self.inner(None, TypeInner::Sampler { comparison });
        let name = format!("{written}Sampler");
        let sampler = self.resource(&name, ty, AddressSpace::Handle, how);
        Pair {
            image,
            sampler,
            kind,
        }
    }

    /// The binding of a resource; `place` is its name in HLSL and MSL.
    fn slot(&self, binding: u32, place: String) -> BindSlot {
        let is_own = matches!(self.language, TargetLanguage::Hlsl | TargetLanguage::Msl);
        BindSlot {
            group: self.group(),
            binding,
            place: is_own.then_some(place),
        }
    }

    /// The bind group of the stage: a pipeline has both stages, each with its own uniforms.
    fn group(&self) -> u32 {
        match self.program.stage {
            Stage::Vertex => 1,
            Stage::Fragment => 0,
        }
    }

    fn resource(
        &mut self,
        name: &str,
        ty: Handle<::naga::Type>,
        space: AddressSpace,
        binding: u32,
    ) -> Handle<GlobalVariable> {
        let group = self.group();
        self.global_variable(name, ty, space, Some(ResourceBinding { group, binding }))
    }
}

impl Body<'_, '_> {
    /// A pointer to a member of a buffer.
    fn member_of(&mut self, buffer: Handle<GlobalVariable>, member: u32) -> Value {
        let base = self.add(Expression::GlobalVariable(buffer));
        self.part(base, member)
    }

    /// The place of a uniform.
    pub(super) fn stored_uniform(
        &mut self,
        id: VariableId,
        buffer: Handle<GlobalVariable>,
        member: u32,
        major: Major,
    ) -> Bound {
        let ty = self.lowerer.form.variable(id).map_or(Type::ERROR, |v| v.ty);
        let at = self.member_of(buffer, member);
        Bound::Stored(StoredPlace::new(at, ty, major))
    }

    /// The place of a block with an instance name, or of an element of an array of blocks.
    pub(super) fn block(&mut self, id: VariableId, number: u32) -> Res<StoredPlace> {
        let found = self.lowerer.uniforms.instances.get(&id);
        let buffer = found.and_then(|all| all.get(number as usize)).copied();
        let ty = self.lowerer.form.variable(id).map(|v| v.ty.element());
        match (buffer, ty) {
            (Some(buffer), Some(ty)) => {
                let at = self.add(Expression::GlobalVariable(buffer));
                Ok(StoredPlace::new(at, ty, Major::Columns))
            }
            _ => self.lowerer.refuse("unknown block"),
        }
    }

    /// The height of the image in pixels.
    pub(super) fn height(&mut self) -> Res<Value> {
        let uniforms = &self.lowerer.uniforms;
        let (Some(buffer), Some(height)) = (uniforms.own, uniforms.height) else {
            return self.lowerer.refuse("the height of the image is unknown");
        };
        let at = match height {
            Height::Own(member) => self.member_of(buffer, member),
            Height::Resolution(member) => {
                let resolution = self.member_of(buffer, member);
                self.part(resolution, 1)
            }
        };
        Ok(self.load(at))
    }
}
