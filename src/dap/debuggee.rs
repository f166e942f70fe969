//! The program that is debugged: one pass of a shader, in one frame.

use super::arguments::Launch;
use super::pending::PendingInputs;
use super::places::{StackFrame, StopPlaces, frames};
use super::scopes::VariableScopes;
use super::value::{DebugValue, MOST};
use shaderlint_commands::run::{
    FrameDraw, Loaded, ObservedRays, RunFront, ShotSetting, Unmade, Variant, shot,
};
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::{CompileOptions, Location, Pause, Replay, Watch};
use shaderlint_ir::{LoopId, OpId, Step};
use shaderlint_play::Decode;
use shaderlint_semantic::{Program, VariableId};
use shaderlint_syntax::ast::{StmtId, StmtKind};
use shaderlint_text::path::slashed;
use std::sync::Arc;

/// Reads programs.
pub trait ProgramSource {
    /// Loads what a client launches.
    ///
    /// # Errors
    /// A message about files that cannot be read, or about errors in the shader.
    fn load(&self, launch: &Launch) -> Result<Loaded, String>;

    /// Decoder for images on channels.
    fn decode(&self) -> Option<Decode>;

    /// The number of threads that draw.
    fn threads(&self) -> usize;

    /// The text of a file, if it can be read.
    fn text(&self, path: &str) -> Option<String>;

    /// The path that names a file, whatever a client calls it.
    fn path(&self, path: &str) -> String {
        slashed(path)
    }
}

/// A pass with the inputs of a frame, compiled for stepping.
pub struct Debuggee {
    loaded: Loaded,
    /// Index of the compile unit.
    unit: usize,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Notes about inputs that were missing or replaced.
    pub notes: Vec<String>,
    /// What the frame depends on, unless it is drawn.
    pending: Option<PendingInputs>,
    /// Why it cannot be drawn.
    failure: Option<String>,
    moment: Moment,
    /// The code that steps.
    pub build: Variant,
    /// The places at which it stops.
    pub places: StopPlaces,
    scopes: VariableScopes,
}

/// How code is compiled that a debugger steps through.
pub fn stepping() -> CompileOptions {
    CompileOptions {
        watch: Watch::Numbers,
        steps: true,
        trace: true,
        ..CompileOptions::default()
    }
}

/// What every run in the debugger has.
pub fn front(programs: &dyn ProgramSource) -> RunFront<'static> {
    RunFront {
        size: [320, 180],
        max_pixels: 1 << 24,
        threads: programs.threads(),
        decode: programs.decode(),
        uniforms: None,
    }
}

impl Debuggee {
    /// Prepares a frame of a loaded shader.
    ///
    /// # Errors
    /// A message about what cannot be run.
    pub fn start(
        loaded: Loaded,
        launch: &Launch,
        programs: &dyn ProgramSource,
    ) -> Result<Debuggee, String> {
        let uniforms = launch.request.uniforms();
        let setting = launch
            .request
            .setting(&front(programs), uniforms.as_deref())?;
        let setting = ShotSetting {
            show: None,
            watch: Watch::Nothing,
            trace: false,
            rays: ObservedRays::Nothing,
            ..setting
        };
        let mut shot = shot(&loaded, &setting)?;
        let moment = launch.request.moment();
        let inputs = shot.undrawn(&moment)?;
        let from = FrameDraw::of(&shot, &inputs, &moment);
        let build = Variant::of(&loaded, from, None, &stepping()).map_err(message)?;
        let (unit, size, notes) = (shot.unit, shot.size, shot.notes(&loaded.project));
        let pending = match shot.depends(&moment) {
            true => Some(PendingInputs::start(Box::new(shot), &moment)?),
            false => None,
        };
        let program = build.program().ok_or("the pass is gone")?;
        let places = StopPlaces::of(program, &build.code);
        let scopes = VariableScopes::of(program, &build.module);
        Ok(Debuggee {
            places,
            scopes,
            loaded,
            unit,
            size,
            notes,
            pending,
            failure: None,
            moment,
            build,
        })
    }

    /// The same frame with another text of a pass of the project, given by its index.
    ///
    /// # Errors
    /// Why it cannot be run.
    pub fn variant(
        &self,
        text: Option<(usize, Arc<str>)>,
        options: &CompileOptions,
    ) -> Result<Variant, Unmade> {
        let from = FrameDraw {
            unit: self.unit,
            size: self.size,
            moment: &self.moment,
            code: &self.build.code,
            inputs: &self.build.inputs,
        };
        Variant::of(&self.loaded, from, text, options)
    }

    /// Whether passes that the frame depends on are not drawn yet. Until then, only the first stop
    /// is correct.
    pub const fn is_pending(&self) -> bool {
        self.pending.is_some()
    }

    /// Whether another thread draws what the frame depends on.
    pub fn is_drawing(&self) -> bool {
        self.pending.as_ref().is_some_and(PendingInputs::is_drawing)
    }

    /// Waits for what the frame depends on.
    ///
    /// # Errors
    /// A message about a run that was stopped.
    pub fn complete(&mut self) -> Result<(), String> {
        if let Some(pending) = self.pending.take() {
            match pending.complete() {
                Ok((shot, inputs)) => self.build.take_over(shot.code(), &inputs),
                Err(message) => self.failure = Some(message),
            }
        }
        match &self.failure {
            Some(message) => Err(message.clone()),
            None => Ok(()),
        }
    }

    /// The checked program.
    pub fn program(&self) -> Option<&Program> {
        self.build.program()
    }

    /// Whether a loop has an exit besides its condition: it searches, and may run out of iterations.
    pub fn ends_early(&self, id: LoopId) -> bool {
        let module = &self.build.module;
        let Some((looped, program)) = module.looped(id).zip(self.program()) else {
            return false;
        };
        let tree = &program.tree;
        let is_own = |jump: StmtId| {
            let at = tree.stmt(jump).extent;
            let around = (0..).map(StmtId).zip(&tree.stmts).filter(|(_, s)| {
                let is_left = s.kind.is_loop() || matches!(s.kind, StmtKind::Switch { .. });
                is_left && s.extent.contains(at)
            });
            let innermost = around.min_by_key(|(_, s)| s.extent.last - s.extent.first);
            innermost.is_some_and(|(id, _)| id == looped.stmt)
        };
        module
            .steps_in(module.steps(looped.body))
            .any(|step| match step {
                Step::Return(..) => true,
                Step::Break(stmt) => is_own(*stmt),
                _ => false,
            })
    }

    /// The functions that run at a site, innermost first.
    pub fn frames(&self, site: u32) -> Vec<StackFrame> {
        let stops = self.build.code.stops();
        match (self.program(), stops.get(site as usize)) {
            (Some(program), Some(stop)) => {
                frames(program, &self.build.module, &self.build.code, stop)
            }
            _ => Vec::new(),
        }
    }

    /// The variables that a frame can name: parameters and locals, globals, uniforms.
    pub fn variables(&self, frame: &StackFrame) -> [Vec<VariableId>; 3] {
        let locals = match (self.program(), frame.function) {
            (Some(program), Some(function)) => self.scopes.locals(program, function, frame.extent),
            _ => Vec::new(),
        };
        [
            locals,
            self.scopes.globals.clone(),
            self.scopes.uniforms.clone(),
        ]
    }

    /// The value of a variable at a stop of a lane; `None` if it has none yet.
    pub fn value(
        &self,
        replay: &Replay<'_>,
        lane: usize,
        variable: VariableId,
    ) -> Option<DebugValue> {
        let ty = self.build.module.variable(variable)?.ty;
        let bits = replay.scalars(variable, lane, MOST)?;
        Some(DebugValue { ty, bits })
    }

    /// The value that a call returned, at the stop after it.
    pub fn returned(&self, replay: &Replay<'_>, lane: usize, pause: &Pause) -> Option<DebugValue> {
        let shaderlint_exec::StopKind::Return(call, location) = replay.site(pause.site)?.kind
        else {
            return None;
        };
        self.value_at(replay, lane, (call, location))
    }

    fn value_at(
        &self,
        replay: &Replay<'_>,
        lane: usize,
        (op, location): (OpId, Location),
    ) -> Option<DebugValue> {
        let ty = self.build.module.ty(op);
        let bits = replay.scalars_at(location, lane, MOST)?;
        (!ty.is_void()).then_some(DebugValue { ty, bits })
    }
}

/// Why a variant was not created.
pub fn message(unmade: Unmade) -> String {
    match unmade {
        Unmade::Error(message, _) | Unmade::Other(message) => message,
    }
}
