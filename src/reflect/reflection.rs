//! What a shader declares for the program around it.

use super::block::ReflectedBlock;
use super::defines::{SettableMacro, settable};
use super::inactive::inactive;
use super::variable::ReflectedVariable;
use serde::Serialize;
use shaderlint_semantic::interface::{Interface, InterfaceVariable};
use shaderlint_semantic::{Program, Stage, Storage};
use shaderlint_text::FileId;

/// What a shader declares for the program around it. What its host declares is left out.
#[derive(Clone, Default, Debug, Serialize)]
pub struct Reflection {
    /// `vertex` or `fragment`; `None` for a text without `main`, which shaders of both stages may include.
    pub stage: Option<&'static str>,
    /// 100 or 300, if the text says so; hosts decide on others.
    pub version: Option<u32>,
    /// Whether texts that it includes are not known.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub open: bool,
    /// Uniforms outside of blocks.
    pub uniforms: Vec<ReflectedVariable>,
    /// Uniform blocks.
    pub blocks: Vec<ReflectedBlock>,
    /// Inputs of a vertex shader.
    pub attributes: Vec<ReflectedVariable>,
    /// Outputs of a vertex shader, inputs of a fragment shader.
    pub varyings: Vec<ReflectedVariable>,
    /// Outputs of a fragment shader.
    pub outputs: Vec<ReflectedVariable>,
    /// Macros that conditions test and that the program around the shader may define.
    pub defines: Vec<SettableMacro>,
}

impl Reflection {
    /// Reads the declarations of a shader without errors that consists of these files.
    pub fn of(program: &Program, files: &[FileId]) -> Reflection {
        let interface = Interface::of(program);
        let all = |list: &[InterfaceVariable]| -> Vec<ReflectedVariable> {
            let own = list.iter().filter(|v| !interface.is_hosts(v.token));
            own.map(|v| ReflectedVariable::of(program, v)).collect()
        };
        let is_vertex = program.stage == Stage::Vertex;
        let (inputs, outputs) = (all(&interface.inputs), all(&interface.outputs));
        let (attributes, varyings, outputs) = match is_vertex {
            true => (inputs, outputs, Vec::new()),
            false => (Vec::new(), inputs, outputs),
        };
        // ShaderToy compiles a pass after its own text.
        let is_compiled = program.entry().is_some() && !program.dialect.is_shadertoy();
        let own_blocks = interface.blocks.iter();
        let own_blocks = own_blocks.filter(|b| !interface.is_hosts(b.token));
        let mut found = Reflection {
            stage: is_compiled.then_some(match is_vertex {
                true => "vertex",
                false => "fragment",
            }),
            version: program
                .tokens
                .version_span
                .map(|_| program.version.profile().number),
            open: false,
            uniforms: all(&interface.uniforms),
            blocks: own_blocks
                .filter_map(|block| ReflectedBlock::of(&interface, block))
                .collect(),
            attributes,
            varyings,
            outputs,
            defines: settable(program, files),
        };
        found.add_conditional(program);
        found
    }

    /// Adds what only other choices of macros declare.
    fn add_conditional(&mut self, program: &Program) {
        for (storage, variable) in inactive(program) {
            let list = match (storage, program.stage) {
                (Storage::Uniform, _) => &mut self.uniforms,
                (Storage::Input, Stage::Vertex) => &mut self.attributes,
                (Storage::Output, Stage::Fragment) => &mut self.outputs,
                _ => &mut self.varyings,
            };
            if list.iter().all(|known| known.name != variable.name) {
                list.push(variable);
            }
        }
    }
}
