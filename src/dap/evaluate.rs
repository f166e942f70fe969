//! Evaluates expressions: by the values of variables if that is enough, else by the compiler.

use super::debuggee::{Debuggee, message};
use super::insertion::{InsertedText, InsertionPlace, NAME};
use super::places::{StackFrame, StopPlaces};
use super::timeline::Timeline;
use super::value::{DebugValue, MOST};
use shaderlint_commands::run::{Bitmap, Variant, value_image};
use shaderlint_exec::{Bytecode, CompileOptions, Drawn, Probe, Replay, Stop, draw};
use shaderlint_ir::OpKind;
use shaderlint_semantic::{Program, Type, VariableId};
use shaderlint_syntax::ast::ExprKind;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Maximum number of values of one expression that are kept.
const MOST_VALUES: usize = 100_000;

/// A copy of the program that evaluates an expression before each execution of a statement.
pub struct EvaluatedExpression {
    build: Variant,
    places: StopPlaces,
    /// The address of the statement that stores the value.
    start: u32,
    variable: VariableId,
    ty: Type,
    /// Index of the pass whose text evaluates the expression, and that text.
    pass: usize,
    text: Arc<str>,
}

impl EvaluatedExpression {
    /// Compiles an expression before the statement that a frame executes.
    ///
    /// # Errors
    /// The compiler's message about the expression, or why it cannot be evaluated there.
    pub fn of(
        debuggee: &Debuggee,
        frame: &StackFrame,
        expression: &str,
    ) -> Result<EvaluatedExpression, String> {
        let place = InsertionPlace::of(&debuggee.build, frame)?;
        let plain = place.insert(expression, None)?;
        let options = CompileOptions {
            steps: true,
            ..CompileOptions::default()
        };
        let typed = debuggee.variant(Some((place.pass, plain.code.as_str().into())), &options);
        let typed = typed.map_err(message)?;
        let program = typed.program().ok_or("the program is gone")?;
        let ty =
            type_of(program, &typed, place.pass, &plain).ok_or("the expression has no type")?;
        if ty.is_void() || ty.is_sampler() {
            return Err("the expression has no value".to_string());
        }
        let stored = place.insert(expression, Some(&program.type_name(ty)))?;
        EvaluatedExpression::stored(debuggee, place.pass, stored, ty)
    }

    /// Whether a condition held before any execution of a statement so far.
    ///
    /// # Errors
    /// The compiler's message about the condition, or why it cannot be evaluated there.
    pub fn ever(
        debuggee: &Debuggee,
        frame: &StackFrame,
        condition: &str,
    ) -> Result<EvaluatedExpression, String> {
        let place = InsertionPlace::of(&debuggee.build, frame)?;
        let stored = place.insert(&format!("{NAME} || ({condition})"), Some("bool"))?;
        EvaluatedExpression::stored(debuggee, place.pass, stored, Type::BOOL)
    }

    fn stored(
        debuggee: &Debuggee,
        pass: usize,
        stored: InsertedText,
        ty: Type,
    ) -> Result<EvaluatedExpression, String> {
        let text: Arc<str> = stored.code.into();
        let options = CompileOptions {
            steps: true,
            ..CompileOptions::default()
        };
        let build = debuggee.variant(Some((pass, text.clone())), &options);
        let build = build.map_err(message)?;
        let program = build.program().ok_or("the program is gone")?;
        let name = program.names.get(NAME);
        let mut variables = (0..).map(VariableId).zip(&program.variables);
        let variable = variables.find(|(_, v)| Some(v.name) == name && v.function.is_none());
        let (variable, _) = variable.ok_or("the value was not stored")?;
        let base = base_of(&build, pass).ok_or("the pass is gone")?;
        Ok(EvaluatedExpression {
            places: StopPlaces::of(program, &build.code),
            start: base + stored.start as u32,
            variable,
            ty,
            pass,
            text,
            build,
        })
    }

    /// The program of the expression, for its types.
    pub fn program(&self) -> Option<&Program> {
        self.build.program()
    }

    /// The values of a pixel, one for each execution of the statement, the first `most` at most.
    ///
    /// # Errors
    /// The pixel ran out of fuel.
    pub fn values(&self, pixel: [u32; 2], most: usize) -> Result<Vec<DebugValue>, Stop> {
        let draw = self.build.draw();
        let mut timeline = Timeline::of(pixel);
        let lane = timeline.lane();
        let most = most.min(MOST_VALUES);
        let mut values = Vec::new();
        // The depth of the store that is not done yet.
        let mut pending: Option<u32> = None;
        timeline.scan(&draw, 0, &mut |replay, pause| {
            let place = pause.and_then(|pause| self.places.at(pause.site));
            let is_done = |depth: &u32| {
                place.is_none_or(|place| place.depth <= *depth && place.returned.is_none())
            };
            if pending.as_ref().is_some_and(is_done) {
                pending = None;
                values.extend(self.value(replay, lane));
            }
            let is_store = |place: &&super::places::StopPlace| {
                place.span.start == self.start && place.returned.is_none()
            };
            pending = place.filter(is_store).map(|place| place.depth).or(pending);
            values.len() >= most
        })?;
        Ok(values)
    }

    fn value(&self, replay: &Replay<'_>, lane: usize) -> Option<DebugValue> {
        let bits = replay.scalars(self.variable, lane, MOST)?;
        Some(DebugValue { ty: self.ty, bits })
    }

    /// Whether the expression is a condition.
    pub fn is_condition(&self) -> bool {
        self.ty == Type::BOOL
    }

    /// Draws the last value of each pixel, or returns why that was stopped.
    ///
    /// # Errors
    /// A message about a draw that cannot be run.
    pub fn image(
        &self,
        debuggee: &Debuggee,
        limits: DrawLimits,
    ) -> Result<Result<ValueImage, Stop>, String> {
        let probe = self.probe().ok_or("the value is not stored")?;
        let options = CompileOptions {
            probe: Some(probe),
            ..CompileOptions::default()
        };
        let build = debuggee.variant(Some((self.pass, self.text.clone())), &options);
        let build = build.map_err(message)?;
        let mut whole = build.draw();
        whole.budget = limits.budget;
        whole.cancelled = limits.interrupt;
        let drawn = draw(&whole, limits.threads);
        drop(whole);
        let code = build.code;
        Ok(drawn.map(|drawn| ValueImage { code, drawn }))
    }

    /// The store, whose last value of each pixel is drawn.
    fn probe(&self) -> Option<Probe> {
        let module = &self.build.module;
        let stores = module.ops.iter().filter_map(|op| match op.kind {
            OpKind::Store(place, value) => Some((module.place(place).variable, value)),
            _ => None,
        });
        let mut own = stores.filter(|(variable, _)| *variable == self.variable);
        own.find_map(|(_, value)| {
            let is_value = module.op(value).kind != OpKind::Undef;
            is_value.then_some(Probe::Value(value))
        })
    }
}

/// How an image is drawn.
pub struct DrawLimits {
    pub threads: usize,
    /// The number of instructions per thread.
    pub budget: u64,
    /// Stops the draw when it is set.
    pub interrupt: Option<Arc<AtomicBool>>,
}

/// The values of an expression over the screen.
pub struct ValueImage {
    code: Bytecode,
    drawn: Drawn,
}

impl ValueImage {
    /// The number of pixels whose value is true.
    pub fn count_true(&self) -> u64 {
        let [value, reached] = self.planes();
        let pixels = value.iter().zip(reached);
        pixels
            .filter(|(value, reached)| value[0] != 0 && reached[0] != 0)
            .count() as u64
    }

    /// The image, as `run --show` draws it.
    pub fn bitmap(&self, name: &str) -> Bitmap {
        value_image(name, &self.code, &self.drawn)
    }

    /// The number of pixels that evaluate the expression.
    pub fn count(&self) -> u64 {
        let [_, reached] = self.planes();
        reached.iter().filter(|reached| reached[0] != 0).count() as u64
    }

    /// The values, and whether there are any.
    fn planes(&self) -> [&[[u32; 4]]; 2] {
        match self.drawn.outputs.as_slice() {
            [.., value, reached] => [value, reached],
            _ => [&[], &[]],
        }
    }
}

/// The address of the code of a pass.
fn base_of(build: &Variant, pass: usize) -> Option<u32> {
    let composed = &build.composed;
    let mut files = (0..)
        .map(shaderlint_text::FileId)
        .zip(composed.sources.files());
    let found = files.find(|(id, _)| composed.owner(*id) == Some(pass));
    found.map(|(_, file)| file.base)
}

/// The type of the inserted expression.
fn type_of(program: &Program, build: &Variant, pass: usize, text: &InsertedText) -> Option<Type> {
    let at = base_of(build, pass)? + text.expression as u32;
    let ids = (0..).map(shaderlint_syntax::ast::ExprId);
    let mut all = ids.zip(&program.tree.exprs);
    let is_it = |expr: &shaderlint_syntax::ast::Expr| {
        matches!(expr.kind, ExprKind::Paren(_)) && program.span(expr.extent).start == at
    };
    // Children come before parents, so the last one is the outermost.
    let found = all.by_ref().filter(|(_, expr)| is_it(expr)).last();
    found.map(|(id, _)| program.ty(id))
}

/// The value of a variable, or of a part of it, if the expression names nothing else.
pub fn named(
    program: &Program,
    expression: &str,
    find: &mut dyn FnMut(&str) -> Option<DebugValue>,
) -> Option<DebugValue> {
    let expression = expression.trim();
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let end = expression.find(|c| !is_word(c)).unwrap_or(expression.len());
    let (name, mut rest) = expression.split_at(end);
    let mut value = find(name)?;
    while !rest.is_empty() {
        let parts = value.parts(program);
        let part = parts.into_iter().find(|part| {
            let after = rest.strip_prefix(part.suffix.as_str());
            after.is_some_and(|after| !after.starts_with(is_word))
        })?;
        rest = rest.get(part.suffix.len()..)?;
        value = part.value;
    }
    Some(value)
}
