//! `fragment_main`: fills what the stage gives, runs `main`, hands on what it wrote.

use super::body::Body;
use super::global::Global;
use super::lower::{FirstRow, Lowerer};
use super::types::Sink;
use super::uniform::Height;
use super::{Res, Value};
use crate::semantic::{FunctionRef, Scalar, Storage, Type, VariableId};
use crate::syntax::ast::{DeclKind, Item, List, QualifierKind};
use ::naga::{
    BinaryOperator as Op, Binding, BuiltIn, EntryPoint, Expression, FunctionResult, GlobalVariable,
    Handle, Interpolation, ShaderStage, Statement, StructMember, TypeInner,
};

/// What is called by the host.
pub(super) const ENTRY: &str = "fragment_main";

/// Something that leaves the shader.
struct Out {
    name: String,
    global: Handle<GlobalVariable>,
    ty: Type,
    binding: Binding,
}

impl<'p> Lowerer<'p> {
    /// Makes the entry point.
    pub(super) fn entry(&mut self, main: FunctionRef) -> Res<()> {
        let Some(main) = self.functions.get(&main).copied() else {
            return self.refuse("there is no `main`");
        };
        let form = self.form;
        let outputs = self.outputs()?;
        let mut body = Body::new(self, ENTRY);
        body.inputs()?;
        body.region(form.globals)?;
        body.call(main, Vec::new(), Type::VOID);
        body.hand_on(&outputs)?;
        let function = body.finish();
        self.module.entry_points.push(EntryPoint {
            name: ENTRY.to_string(),
            stage: ShaderStage::Fragment,
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

    /// What the shader writes, in the order of its locations.
    fn outputs(&mut self) -> Res<Vec<Out>> {
        let program = self.program;
        let mut found = Vec::new();
        let mut next = 0;
        for (variable, qualifiers) in declarations(self) {
            let Some(declared) = program.variable(variable) else {
                continue;
            };
            if declared.storage != Storage::Output {
                continue;
            }
            let location = location(self, qualifiers).unwrap_or(next);
            next = location + 1;
            let Some(Global::Variable(global)) = self.globals.get(&variable).copied() else {
                continue;
            };
            if declared.ty.is_array() {
                return self.refuse("an array of outputs is not supported");
            }
            found.push(Out {
                name: program.names.text(declared.name).to_string(),
                global,
                ty: declared.ty,
                binding: place(location, declared.ty),
            });
        }
        let vec4 = Type::vector(Scalar::Float, 4);
        let builtins = [
            ("gl_FragColor", vec4, place(0, vec4)),
            (
                "gl_FragDepth",
                Type::FLOAT,
                Binding::BuiltIn(BuiltIn::FragDepth),
            ),
        ];
        for (name, ty, binding) in builtins {
            if let Some(global) = self.builtins.get(name) {
                found.push(Out {
                    name: name.to_string(),
                    global: *global,
                    ty,
                    binding,
                });
            }
        }
        Ok(found)
    }
}

impl Body<'_, '_> {
    /// Takes what the stage before gives.
    fn inputs(&mut self) -> Res<()> {
        let vec4 = self.lowerer.ty(Type::vector(Scalar::Float, 4))?;
        if let Some(global) = self.lowerer.builtins.get("gl_FragCoord").copied() {
            let position = BuiltIn::Position { invariant: false };
            let at = self.argument("position", vec4);
            self.bind(Binding::BuiltIn(position));
            let at = match self.lowerer.origin {
                FirstRow::Row => at,
                FirstRow::Picture => self.turned(at)?,
            };
            let to = self.add(Expression::GlobalVariable(global));
            self.store(to, at);
        }
        if let Some(global) = self.lowerer.builtins.get("gl_FrontFacing").copied() {
            let ty = self.lowerer.ty(Type::BOOL)?;
            let is_front = self.argument("front", ty);
            self.bind(Binding::BuiltIn(BuiltIn::FrontFacing));
            let to = self.add(Expression::GlobalVariable(global));
            self.store(to, is_front);
        }
        let program = self.lowerer.program;
        let mut next = 0;
        for (variable, qualifiers) in declarations(self.lowerer) {
            let Some(declared) = program.variable(variable) else {
                continue;
            };
            if declared.storage != Storage::Input {
                continue;
            }
            let location = location(self.lowerer, qualifiers).unwrap_or(next);
            next = location + 1;
            let Some(Global::Variable(global)) = self.lowerer.globals.get(&variable).copied()
            else {
                continue;
            };
            if !(declared.ty.is_scalar() || declared.ty.is_vector()) {
                return self
                    .lowerer
                    .refuse("only numbers and vectors can be inputs in the other languages");
            }
            let ty = self.lowerer.ty(declared.ty)?;
            let value = self.argument(program.names.text(declared.name), ty);
            self.bind(place(location, declared.ty));
            let to = self.add(Expression::GlobalVariable(global));
            self.store(to, value);
        }
        Ok(())
    }

    fn bind(&mut self, binding: Binding) {
        if let Some(argument) = self.function.arguments.last_mut() {
            argument.binding = Some(binding);
        }
    }

    /// A position whose rows are counted from below.
    fn turned(&mut self, at: Value) -> Res<Value> {
        let height = match self.lowerer.uniforms.height {
            Some(Height::Own(member)) => self.uniform_member(member)?,
            Some(Height::Resolution(member)) => {
                let resolution = self.uniform_member(member)?;
                self.part(resolution, 1)
            }
            None => {
                return self
                    .lowerer
                    .refuse("nothing tells the height of the picture");
            }
        };
        let height = self.load(height);
        let parts: Vec<Value> = (0..4).map(|i| self.part(at, i)).collect();
        let &[x, y, z, w] = &parts[..] else {
            return self.lowerer.refuse("a position has four parts");
        };
        let y = self.op(Op::Subtract, height, y);
        self.compose(Type::vector(Scalar::Float, 4), vec![x, y, z, w])
    }

    /// Returns what was written.
    fn hand_on(&mut self, outputs: &[Out]) -> Res<()> {
        let mut values = Vec::new();
        for out in outputs {
            let from = self.add(Expression::GlobalVariable(out.global));
            values.push(self.load(from));
        }
        if let ([out], [value]) = (outputs, &values[..]) {
            let ty = self.lowerer.ty(out.ty)?;
            self.function.result = Some(FunctionResult {
                ty,
                binding: Some(out.binding.clone()),
            });
            let value = Some(*value);
            self.push(Statement::Return { value });
            return Ok(());
        }
        if outputs.is_empty() {
            self.push(Statement::Return { value: None });
            return Ok(());
        }
        let mut members = Vec::new();
        let mut offset = 0;
        for out in outputs {
            let ty = self.lowerer.ty(out.ty)?;
            members.push(StructMember {
                name: Some(out.name.clone()),
                ty,
                binding: Some(out.binding.clone()),
                offset,
            });
            // Every output has room for four numbers; the offsets say nothing to a stage.
            offset += 16;
        }
        let span = offset;
        let name = Some("FragmentOutput".to_string());
        let ty = self
            .lowerer
            .inner(name, TypeInner::Struct { members, span });
        let value = self.add(Expression::Compose {
            ty,
            components: values,
        });
        self.function.result = Some(FunctionResult { ty, binding: None });
        self.push(Statement::Return { value: Some(value) });
        Ok(())
    }
}

/// The place between two stages.
fn place(location: u32, ty: Type) -> Binding {
    let interpolation = match ty.scalar_kind() {
        Some(Scalar::Float) => Interpolation::Perspective,
        _ => Interpolation::Flat,
    };
    Binding::Location {
        location,
        interpolation: Some(interpolation),
        sampling: None,
        blend_src: None,
        per_primitive: false,
    }
}

/// The variables that stand at global scope, with their qualifiers, in the order of the text.
fn declarations(lowerer: &Lowerer) -> Vec<(VariableId, List)> {
    let program = lowerer.program;
    let mut found = Vec::new();
    for item in &program.tree.items {
        let Item::Decl(id) = item else { continue };
        let Some(decl) = program.tree.decl(*id) else {
            continue;
        };
        let DeclKind::Variables {
            qualifiers,
            declarators,
            ..
        } = decl.kind
        else {
            continue;
        };
        let declared = declarators.start as usize..(declarators.start + declarators.len) as usize;
        let declared = program.declared.get(declared).unwrap_or(&[]);
        found.extend(declared.iter().flatten().map(|id| (*id, qualifiers)));
    }
    found
}

/// The number of `layout(location = n)`.
fn location(lowerer: &Lowerer, qualifiers: List) -> Option<u32> {
    let program = lowerer.program;
    let tree = &program.tree;
    let layouts = tree
        .qualifiers(qualifiers)
        .iter()
        .filter_map(|q| match q.kind {
            QualifierKind::Layout(entries) => Some(tree.layout(entries)),
            _ => None,
        });
    let mut entries = layouts.flatten();
    let entry = entries.find(|e| program.names.text(e.ident.name) == "location")?;
    u32::try_from(entry.value?.value).ok()
}
