//! The interface of a shader: uniforms, samplers, inputs and outputs.

use super::emit::{Compiler, Made, Regs, Value};
use crate::bytecode::{InputSlot, Instr, OutputSlot, SamplerSlot, UniformSlot};
use shaderlint_ir::Root;
use shaderlint_semantic::{Base, FunctionRef, Type, Variable, VariableId};
use shaderlint_text::SetAt;

/// Maximum number of samplers; browsers support 16 or 32 texture units.
const MAX_SAMPLERS: usize = 1024;

impl Compiler<'_> {
    /// Lays out the uniforms, and allocates registers for outputs and globals.
    pub fn interface(&mut self) {
        let program = self.program;
        let is_uniform = |(number, variable): &(VariableId, &Variable)| {
            let root = self.module.variable(*number).map(|v| v.root);
            root == Some(Root::Uniform) && variable.read
        };
        let all = (0..).map(VariableId).zip(&program.variables);
        let mut uniforms: Vec<_> = all.filter(is_uniform).collect();
        // Sorted by name, so that the code does not depend on the order of declarations.
        uniforms.sort_by_key(|(_, variable)| program.names.text(variable.name));
        for (number, variable) in uniforms {
            let at = self.code.uniform_words;
            let first = self.code.samplers.len() as u32;
            let name = program.names.text(variable.name).to_string();
            if self.uniform(&name, variable.ty).is_none() {
                let _: Made<()> = self.refuse(format!("the uniform `{name}`"));
                return;
            }
            self.samplers_of.insert(number, first);
            let value = match self.code.uniform_words - at {
                0 => Value::Samplers(first),
                len => Value::Memory { at, len },
            };
            self.set_variable(number, value);
        }
    }

    /// Lays out a uniform, including the members of a struct.
    fn uniform(&mut self, name: &str, ty: Type) -> Made<()> {
        let program = self.program;
        match ty.base {
            Base::Sampler(sampler) => {
                for at in 0..ty.array.max(1) {
                    if self.code.samplers.len() >= MAX_SAMPLERS {
                        return None;
                    }
                    let name = match ty.is_array() {
                        true => format!("{name}[{at}]"),
                        false => name.to_string(),
                    };
                    self.code.samplers.push(SamplerSlot { name, sampler });
                }
            }
            Base::Struct(_) | Base::Block(_) => {
                self.scalars(ty)?;
                let fields = &program.struct_of(ty.element())?.fields;
                for at in 0..ty.array.max(1) {
                    for field in fields {
                        let member = program.names.text(field.name);
                        let name = match ty.is_array() {
                            true => format!("{name}[{at}].{member}"),
                            false => format!("{name}.{member}"),
                        };
                        self.uniform(&name, field.ty)?;
                    }
                }
            }
            _ => {
                let name = name.to_string();
                let at = self.code.uniform_words;
                self.code.uniforms.push(UniformSlot { name, ty, at });
                self.code.uniform_words += self.scalars(ty)?;
            }
        }
        Some(())
    }

    /// The number of samplers in a type.
    pub fn samplers_in(&self, ty: Type) -> u32 {
        let one = match ty.base {
            Base::Sampler(_) => 1,
            Base::Struct(_) => {
                let made = self.program.struct_of(ty.element());
                let fields = made.map_or(&[][..], |s| &s.fields);
                fields.iter().map(|f| self.samplers_in(f.ty)).sum()
            }
            _ => 0,
        };
        one * ty.array.max(1)
    }

    /// Allocates the registers of an input, output or global.
    pub fn open(&mut self, variable: VariableId) -> Made<Value> {
        let known = *self.module.variable(variable)?;
        let count = self.scalars(known.ty);
        let Some(count) = count else {
            return self.refuse("a variable with more than 32,768 scalars");
        };
        let is_outer = known.function.is_none();
        let first = self.registers.row(count, variable, is_outer);
        let regs = self.listed((0..count).map(|n| first.saturating_add(n as u16)));
        let value = Value::Regs(regs);
        self.set_variable(variable, value);
        let name = self.program.variable(variable).map(|v| v.name);
        let name = name.map_or("", |n| self.program.names.text(n)).to_string();
        if known.root == Root::Input {
            self.code.inputs.push(InputSlot {
                name,
                ty: known.ty,
                regs: self.list(regs).to_vec(),
            });
        }
        Some(value)
    }

    /// Allocates and zeroes all outputs and modified globals that the shader uses, as the browser
    /// does.
    pub fn clear_outer(&mut self) {
        for number in (0..self.module.variables.len() as u32).map(VariableId) {
            let Some(known) = self.module.variable(number).copied() else {
                continue;
            };
            let is_output = known.root == Root::Output;
            let changes = !self.plan.is_never_written(number);
            let is_global = known.root == Root::Global && !self.plan.is_name(self.module, number);
            if !changes || !is_output && !is_global {
                continue;
            }
            let Some(Value::Regs(regs)) = self.open(number) else {
                return;
            };
            self.zero(regs);
            if is_output {
                let name = self.program.variable(number).map(|v| v.name);
                let name = name.map_or("", |n| self.program.names.text(n)).to_string();
                self.code.outputs.push(OutputSlot {
                    name,
                    ty: known.ty,
                    regs: self.list(regs).to_vec(),
                });
            }
        }
    }

    /// Sets registers to zero.
    pub fn zero(&mut self, regs: Regs) {
        let zero = self.constant(0);
        for at in 0..regs.len {
            let reg = self.reg(regs, at);
            self.push(Instr::Move(reg, zero));
        }
    }

    /// Makes the parameters of the entry point inputs and outputs of the shader.
    pub fn entry_parameters(&mut self, entry: FunctionRef) -> Made<()> {
        let function = *self.module.function(entry)?;
        for &parameter in self.module.parameters(&function) {
            let known = *self.module.variable(parameter)?;
            let Some(count) = self.scalars(known.ty) else {
                return self.refuse("a parameter with more than 32,768 scalars");
            };
            let first = self.registers.row(count, parameter, true);
            let regs = self.listed((0..count).map(|n| first.saturating_add(n as u16)));
            self.set_variable(parameter, Value::Regs(regs));
            let name = self.program.variable(parameter).map(|v| v.name);
            let name = name.map_or("", |n| self.program.names.text(n)).to_string();
            let (ty, regs_list) = (known.ty, self.list(regs).to_vec());
            let reads = known.root != Root::ParameterOut;
            if reads {
                self.code.inputs.push(InputSlot {
                    name: name.clone(),
                    ty,
                    regs: regs_list.clone(),
                });
            } else {
                self.zero(regs);
            }
            if known.root != Root::Parameter {
                self.code.outputs.push(OutputSlot {
                    name,
                    ty,
                    regs: regs_list,
                });
            }
        }
        Some(())
    }

    pub fn set_variable(&mut self, variable: VariableId, value: Value) {
        self.locate(variable, value);
        self.variables.set_at(variable.0 as usize, value);
    }
}
