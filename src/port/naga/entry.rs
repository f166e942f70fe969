//! The entry point: loads the inputs of the stage, calls `main` and returns the outputs.

use super::body::Body;
use super::global::Global;
use super::lower::NagaLowerer;
use super::port::{Leaf, entry_name, leaves, location};
use super::special::Leaving;
use super::target::{Res, Value};
use super::types::Sink;
use ::naga::{
    Binding, EntryPoint, Expression, FunctionResult, Handle, ShaderStage, Statement, StructMember,
    TypeInner,
};
use shaderlint_ir::Visit;
use shaderlint_semantic::{FunctionRef, Stage, Storage, Type};

impl<'p> NagaLowerer<'p> {
    /// Builds the entry point.
    pub(super) fn entry(&mut self, main: FunctionRef) -> Res<()> {
        let Some(main) = self.functions.get(&main).copied() else {
            return self.refuse("missing `main` function");
        };
        let form = self.form;
        let stage = self.program.stage;
        let mut body = Body::new(self, entry_name(stage));
        body.take_specials()?;
        body.inputs()?;
        body.region(form.globals)?;
        body.call(main, Vec::new(), Type::VOID);
        body.hand_on()?;
        let function = body.finish();
        self.module.entry_points.push(EntryPoint {
            name: entry_name(stage).to_string(),
            stage: match stage {
                Stage::Vertex => ShaderStage::Vertex,
                Stage::Fragment => ShaderStage::Fragment,
            },
            early_depth_test: None,
            workgroup_size: [0; 3],
            workgroup_size_overrides: None,
            function,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        });
        Ok(())
    }

    /// The scalars and vectors of the inputs or outputs that the shader uses.
    fn ports(&self, storage: Storage) -> Vec<Leaf> {
        let is_varying = match self.program.stage {
            Stage::Vertex => storage == Storage::Output,
            Stage::Fragment => storage == Storage::Input,
        };
        let known = if is_varying { self.varyings } else { &[] };
        let mut all = leaves(self.program, storage, known);
        all.retain(|leaf| self.globals.contains_key(&leaf.variable));
        all
    }
}

impl Body<'_, '_> {
    /// Loads the outputs of the previous stage.
    fn inputs(&mut self) -> Res<()> {
        for leaf in self.lowerer.ports(Storage::Input) {
            let binding = match self.lowerer.program.stage {
                Stage::Vertex => location(leaf.location),
                Stage::Fragment => {
                    if leaf.is_flat(self.lowerer) {
                        self.lowerer.note(
                            "flat inputs have the value of the first vertex; in WebGL, of the last",
                        );
                    }
                    leaf.varying(self.lowerer)
                }
            };
            let ty = self.lowerer.ty(leaf.ty)?;
            let value = self.argument(&leaf.word(), ty);
            self.bind(binding);
            if let Some(to) = self.leaf(&leaf) {
                self.store(to, value);
            }
            let port = leaf.port(self.lowerer.program);
            self.lowerer.interface.inputs.push(port);
        }
        Ok(())
    }

    /// A pointer to a scalar or vector in a variable of the module.
    fn leaf(&mut self, leaf: &Leaf) -> Option<Value> {
        let Some(Global::Variable(global)) = self.lowerer.globals.get(&leaf.variable).copied()
        else {
            return None;
        };
        let mut at = self.add(Expression::GlobalVariable(global));
        for step in &leaf.path {
            at = self.part(at, *step);
        }
        Some(at)
    }

    /// Sets the binding of the last argument.
    pub(super) fn bind(&mut self, binding: Binding) {
        if let Some(argument) = self.function.arguments.last_mut() {
            argument.binding = Some(binding);
        }
    }

    /// The outputs of the stage.
    fn leaving(&mut self) -> Res<Vec<Leaving>> {
        let mut all = self.leaving_specials()?;
        for leaf in self.lowerer.ports(Storage::Output) {
            let binding = match self.lowerer.program.stage {
                Stage::Vertex => leaf.varying(self.lowerer),
                Stage::Fragment => location(leaf.location),
            };
            if let Some(from) = self.leaf(&leaf) {
                let value = self.load(from);
                all.push(Leaving {
                    name: leaf.name.clone(),
                    value,
                    ty: leaf.ty,
                    binding,
                });
            }
        }
        let program = self.lowerer.program;
        for out in &all {
            if let Binding::Location { location, .. } = out.binding {
                self.lowerer.interface.outputs.push(super::interface::Port {
                    name: out.name.clone(),
                    ty: program.type_name(out.ty),
                    location,
                });
            }
        }
        Ok(all)
    }

    /// Returns the outputs.
    fn hand_on(&mut self) -> Res<()> {
        let leaving = self.leaving()?;
        let Some(first) = leaving.first() else {
            self.push(Statement::Return { value: None });
            return Ok(());
        };
        let (ty, binding, value) = if leaving.len() == 1 {
            let ty = self.lowerer.ty(first.ty)?;
            (ty, Some(first.binding.clone()), first.value)
        } else {
            let ty = self.record_of(&leaving)?;
            let components = leaving.iter().map(|out| out.value).collect();
            (ty, None, self.add(Expression::Compose { ty, components }))
        };
        self.function.result = Some(FunctionResult { ty, binding });
        self.push(Statement::Return { value: Some(value) });
        Ok(())
    }

    /// The struct type for several outputs.
    fn record_of(&mut self, leaving: &[Leaving]) -> Res<Handle<::naga::Type>> {
        let mut members = Vec::new();
        let mut offset = 0;
        for out in leaving {
            members.push(StructMember {
                name: Some(out.name.replace(['[', ']', '.'], "_")),
                ty: self.lowerer.ty(out.ty)?,
                binding: Some(out.binding.clone()),
                offset,
            });
            // Every output has room for four components; the offsets have no meaning between
            // stages.
            offset += 16;
        }
        let span = offset;
        let name = match self.lowerer.program.stage {
            Stage::Vertex => "VertexOutput",
            Stage::Fragment => "FragmentOutput",
        };
        let inner = TypeInner::Struct { members, span };
        Ok(self.lowerer.inner(Some(name.to_string()), inner))
    }
}
