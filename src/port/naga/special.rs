//! Built-in variables.

use super::body::{Body, Bound};
use super::lower::NagaLowerer;
use super::port::location;
use super::target::{FirstRow, Res, TargetLanguage, Value};
use super::types::Sink;
use ::naga::{BinaryOperator as Op, Binding, BuiltIn, Expression, GlobalVariable, Handle};
use shaderlint_ir::Access;
use shaderlint_semantic::{Scalar, Stage, Type, VariableId};

/// A built-in variable in the module.
#[derive(Clone, Copy, Debug)]
pub(super) struct Special {
    /// The variable of the shader.
    id: VariableId,
    /// The private variable with its value.
    global: Handle<GlobalVariable>,
}

/// An output of the stage.
pub(super) struct Leaving {
    pub(super) name: String,
    pub(super) value: Value,
    pub(super) ty: Type,
    /// The location or built-in.
    pub(super) binding: Binding,
}

const VEC4: Type = Type::vector(Scalar::Float, 4);

impl NagaLowerer<'_> {
    /// Whether the target language supports point sizes.
    fn has_points(&self) -> bool {
        matches!(self.language, TargetLanguage::Spirv | TargetLanguage::Msl)
    }

    /// Adds a note to the interface, without duplicates.
    pub(super) fn note(&mut self, text: &str) {
        if !self.interface.notes.iter().any(|n| n == text) {
            self.interface.notes.push(text.to_string());
        }
    }

    /// Declares a private variable for a built-in variable.
    fn special(&mut self, id: VariableId, name: &'static str, ty: Type) -> Res<Special> {
        if let Some(found) = self.specials.get(name) {
            return Ok(*found);
        }
        let ty = self.ty(ty)?;
        let global = self.private(name, ty);
        let special = Special { id, global };
        self.specials.insert(name, special);
        Ok(special)
    }
}

impl Body<'_, '_> {
    /// Where a built-in variable is stored in this function.
    pub(super) fn special(&mut self, id: VariableId) -> Res<Bound> {
        let name = self.lowerer.name(id).unwrap_or_default();
        let ty = self.lowerer.form.variable(id).map_or(Type::ERROR, |v| v.ty);
        let name = match name {
            "gl_FragCoord" => "gl_FragCoord",
            "gl_FrontFacing" => "gl_FrontFacing",
            "gl_FragDepth" => "gl_FragDepth",
            "gl_FragColor" => "gl_FragColor",
            "gl_FragData" => "gl_FragData",
            "gl_Position" => "gl_Position",
            "gl_VertexID" => "gl_VertexID",
            "gl_InstanceID" => "gl_InstanceID",
            "gl_PointSize" => {
                if !self.lowerer.has_points() {
                    self.lowerer
                        .note("gl_PointSize has no equivalent: points cover one pixel");
                }
                "gl_PointSize"
            }
            "gl_PointCoord" if self.lowerer.has_points() => "gl_PointCoord",
            "gl_PointCoord" => {
                self.lowerer
                    .note("gl_PointCoord is 0.5: points cover one pixel");
                let middle = self.float(0.5);
                return Ok(Bound::Value(self.splat(middle, ty)));
            }
            "gl_DepthRange" => {
                self.lowerer
                    .note("gl_DepthRange is fixed at WebGL's default, 0 to 1");
                // The struct has only the members that the shader uses.
                let program = self.lowerer.program;
                let fields = program.struct_of(ty).map_or(&[][..], |s| &s.fields);
                let value = |name: &str| if name == "near" { 0.0 } else { 1.0 };
                let values = fields.iter().map(|f| value(program.names.text(f.name)));
                let values = values.map(|v| self.float(v)).collect();
                return self.compose(ty, values).map(Bound::Value);
            }
            other => {
                let message = format!("`{other}` has no equivalent in the target language");
                return self.lowerer.refuse(message);
            }
        };
        let special = self.lowerer.special(id, name, ty)?;
        Ok(Bound::Pointer(
            self.add(Expression::GlobalVariable(special.global)),
        ))
    }

    /// Loads the built-in inputs.
    pub(super) fn take_specials(&mut self) -> Res<()> {
        for name in [
            "gl_FragCoord",
            "gl_FrontFacing",
            "gl_PointCoord",
            "gl_VertexID",
            "gl_InstanceID",
        ] {
            let Some(special) = self.lowerer.specials.get(name).copied() else {
                continue;
            };
            let (argument, ty, binding) = match name {
                "gl_FragCoord" => ("position", VEC4, BuiltIn::Position { invariant: false }),
                "gl_FrontFacing" => ("front", Type::BOOL, BuiltIn::FrontFacing),
                "gl_PointCoord" => ("point", Type::vector(Scalar::Float, 2), BuiltIn::PointCoord),
                "gl_VertexID" => ("vertex", Type::UINT, BuiltIn::VertexIndex),
                _ => ("instance", Type::UINT, BuiltIn::InstanceIndex),
            };
            let ty = self.lowerer.ty(ty)?;
            let mut value = self.argument(argument, ty);
            self.bind(Binding::BuiltIn(binding));
            match binding {
                BuiltIn::Position { .. } => value = self.position(value)?,
                BuiltIn::VertexIndex | BuiltIn::InstanceIndex => {
                    value = self.convert(value, Scalar::Int);
                }
                _ => {}
            }
            let to = self.add(Expression::GlobalVariable(special.global));
            self.store(to, value);
        }
        Ok(())
    }

    /// The position of a pixel as in OpenGL: rows are counted from the bottom, and `w` is the
    /// reciprocal of Direct3D's.
    fn position(&mut self, at: Value) -> Res<Value> {
        let is_flipped = self.lowerer.origin == FirstRow::Top;
        let is_inverse = self.lowerer.language == TargetLanguage::Hlsl;
        if !is_flipped && !is_inverse {
            return Ok(at);
        }
        let mut parts: Vec<Value> = (0..4).map(|i| self.part(at, i)).collect();
        let [_, y, _, w] = &mut parts[..] else {
            return self
                .lowerer
                .refuse("expected a position with four components");
        };
        if is_flipped {
            let height = self.height()?;
            *y = self.op(Op::Subtract, height, *y);
        }
        if is_inverse {
            let one = self.float(1.0);
            *w = self.op(Op::Divide, one, *w);
        }
        self.compose(VEC4, parts)
    }

    /// The built-in outputs.
    pub(super) fn leaving_specials(&mut self) -> Res<Vec<Leaving>> {
        let mut found = Vec::new();
        if self.lowerer.program.stage == Stage::Vertex {
            found.push(self.leaving_position()?);
        }
        for name in ["gl_PointSize", "gl_FragColor", "gl_FragDepth"] {
            let Some(special) = self.lowerer.specials.get(name).copied() else {
                continue;
            };
            let (ty, binding) = match name {
                "gl_FragColor" => (VEC4, location(0)),
                "gl_FragDepth" => (Type::FLOAT, Binding::BuiltIn(BuiltIn::FragDepth)),
                _ if !self.lowerer.has_points() => continue,
                _ => (Type::FLOAT, Binding::BuiltIn(BuiltIn::PointSize)),
            };
            let from = self.add(Expression::GlobalVariable(special.global));
            let value = self.load(from);
            found.push(Leaving {
                name: name.to_string(),
                value,
                ty,
                binding,
            });
        }
        if let Some(special) = self.lowerer.specials.get("gl_FragData").copied() {
            for i in self.elements_written(special.id) {
                let all = self.add(Expression::GlobalVariable(special.global));
                let from = self.part(all, i);
                let value = self.load(from);
                found.push(Leaving {
                    name: format!("gl_FragData[{i}]"),
                    value,
                    ty: VEC4,
                    binding: location(i),
                });
            }
        }
        Ok(found)
    }

    /// The position of the vertex; depth ranges from -1 to 1 in OpenGL, and from 0 to 1 elsewhere.
    fn leaving_position(&mut self) -> Res<Leaving> {
        let at = match self.lowerer.specials.get("gl_Position").copied() {
            Some(special) => {
                let from = self.add(Expression::GlobalVariable(special.global));
                self.load(from)
            }
            None => self.zero(VEC4)?,
        };
        let mut parts: Vec<Value> = (0..4).map(|i| self.part(at, i)).collect();
        let [_, _, z, w] = &mut parts[..] else {
            return self
                .lowerer
                .refuse("expected a position with four components");
        };
        let sum = self.op(Op::Add, *z, *w);
        let half = self.float(0.5);
        *z = self.op(Op::Multiply, sum, half);
        let value = self.compose(VEC4, parts)?;
        self.lowerer
            .note("gl_Position: depth is mapped from -1..1 to 0..1");
        if self.lowerer.language == TargetLanguage::Spirv {
            self.lowerer
                .note("gl_Position: y points up as in OpenGL and is flipped for Vulkan");
        }
        Ok(Leaving {
            name: "position".to_string(),
            value,
            ty: VEC4,
            binding: Binding::BuiltIn(BuiltIn::Position {
                invariant: self.lowerer.is_position_invariant,
            }),
        })
    }

    /// The elements of an array that are written; all elements if an index is computed.
    fn elements_written(&self, id: VariableId) -> Vec<u32> {
        let form = self.lowerer.form;
        let mut found = std::collections::BTreeSet::new();
        for place in form.places.iter().filter(|p| p.variable == id) {
            match form.path(place).first() {
                Some(Access::Element(i)) => _ = found.insert(*i),
                _ => found.extend(0..form.variable(id).map_or(0, |v| v.ty.array)),
            }
        }
        found.into_iter().collect()
    }
}
