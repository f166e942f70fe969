//! The pass of a shot, compiled in another way or with another text, with the inputs of the same draw.

use super::shot::{Loaded, Shot, refused};
use shaderlint_diagnostic::Severity;
use shaderlint_engine::playback::{GivenUniforms, Moment, player_draw};
use shaderlint_exec::{Bytecode, CompileOptions, Draw, DrawInputs, compile};
use shaderlint_ir::{Module, lower};
use shaderlint_port::{Composed, PassUnit, Wrapper, compose};
use shaderlint_semantic::Program;
use shaderlint_text::Span;
use std::sync::Arc;

/// A pass with its own code, and the inputs of a frame.
pub struct Variant {
    composed: Composed,
    unit: usize,
    /// The IR.
    pub module: Module,
    /// The bytecode.
    pub code: Bytecode,
    inputs: DrawInputs,
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
    /// Compiles the pass that a shot shows, for the frame whose draw is `prepared`. `text` replaces the
    /// code of a pass of the project, given by its index.
    ///
    /// # Errors
    /// Why it cannot be run.
    pub fn of(
        loaded: &Loaded,
        (shot, prepared, moment): (&Shot, &DrawInputs, &Moment),
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
        let number = shot.unit();
        let unit = composed.units.get(number);
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
        let mut inputs = fresh(loaded, unit, (&code, shot.size(), moment));
        inputs.take_over(&code, prepared, shot.code());
        Ok(Variant {
            unit: number,
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

    /// The texts of the passes.
    pub const fn composed(&self) -> &Composed {
        &self.composed
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
