//! The pass of a shot, compiled in another way or with another text, with the inputs of the same draw.

use super::shot::{Loaded, Shot, refused};
use shaderlint_diagnostic::Severity;
use shaderlint_engine::inputs::{GivenUniforms, Moment, player_draw};
use shaderlint_exec::{Bytecode, CompileOptions, Draw, DrawInputs, compile};
use shaderlint_ir::{Module, lower};
use shaderlint_project::{Composed, PassUnit, Wrapper, compose};
use shaderlint_semantic::Program;
use shaderlint_text::Span;
use std::sync::Arc;

/// A pass with its own code, and the inputs of a frame.
pub struct Variant {
    /// The texts of the passes.
    pub composed: Composed,
    unit: usize,
    /// The IR.
    pub module: Module,
    /// The bytecode.
    pub code: Bytecode,
    /// The inputs of the draw.
    pub inputs: DrawInputs,
}

/// The draw of a frame, whose inputs a variant takes over.
#[derive(Clone, Copy)]
pub struct FrameDraw<'d> {
    /// Index of the compile unit.
    pub unit: usize,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// The frame.
    pub moment: &'d Moment,
    /// The code that the inputs are for.
    pub code: &'d Bytecode,
    /// The inputs.
    pub inputs: &'d DrawInputs,
}

impl<'d> FrameDraw<'d> {
    /// The draw that a shot has prepared.
    pub fn of(shot: &'d Shot, inputs: &'d DrawInputs, moment: &'d Moment) -> FrameDraw<'d> {
        FrameDraw {
            unit: shot.unit,
            size: shot.size,
            moment,
            code: shot.code(),
            inputs,
        }
    }
}

/// Why there is no variant.
#[derive(Debug)]
pub enum Unmade {
    /// An error of the compiler, and where it is.
    Error(String, Span),
    /// Another reason, as a message.
    Other(String),
}

impl Variant {
    /// Compiles the pass of a draw. `text` replaces the code of a pass of the project, given by its index.
    ///
    /// # Errors
    /// Why it cannot be run.
    pub fn of(
        loaded: &Loaded,
        from: FrameDraw<'_>,
        text: Option<(usize, Arc<str>)>,
        options: &CompileOptions,
    ) -> Result<Variant, Unmade> {
        let mut project = loaded.project.clone();
        if let Some((pass, text)) = text
            && let Some(pass) = project.passes.get_mut(pass)
        {
            pass.code = text;
        }
        let composed = compose(&project, &loaded.name);
        let composed =
            composed.ok_or_else(|| Unmade::Other("the text is too large".to_string()))?;
        let unit = composed.units.get(from.unit);
        let unit = unit.ok_or_else(|| Unmade::Other("the pass is gone".to_string()))?;
        let checked = composed.analysis(unit);
        let mut found = checked.diagnostics.iter();
        if let Some(error) = found.find(|d| d.severity == Severity::Error) {
            return Err(Unmade::Error(error.message.clone(), error.span));
        }
        let program = &checked.program;
        let module = lower(program);
        let code = compile(program, &module, options);
        let code = code.map_err(|refusal| {
            Unmade::Other(refused(&composed.sources, program, &loaded.name, &refusal))
        })?;
        let mut inputs = fresh(loaded, unit, (&code, from.size, from.moment));
        inputs.take_over(&code, from.inputs, from.code);
        Ok(Variant {
            unit: from.unit,
            module,
            code,
            inputs,
            composed,
        })
    }

    /// The checked program.
    pub fn program(&self) -> Option<&Program> {
        let unit = self.composed.units.get(self.unit)?;
        Some(&self.composed.analysis(unit).program)
    }

    /// Takes over the inputs of another draw of the same frame.
    pub fn take_over(&mut self, code: &Bytecode, inputs: &DrawInputs) {
        self.inputs.take_over(&self.code, inputs, code);
    }

    /// The draw of the frame.
    pub fn draw(&self) -> Draw<'_> {
        self.inputs.with(&self.code)
    }
}

/// The inputs of a frame, without those that come from other passes.
fn fresh(
    loaded: &Loaded,
    unit: &PassUnit,
    (code, size, moment): (&Bytecode, [u32; 2], &Moment),
) -> DrawInputs {
    let bound = loaded.project.passes.get(unit.pass).map(|pass| &pass.bound);
    match (unit.wrapper, bound) {
        (Wrapper::Own, Some(bound)) => {
            let given = GivenUniforms::of(bound.clone());
            given.draw(code, size, moment).into_inputs()
        }
        _ => player_draw(code, size, moment).into_inputs(),
    }
}
