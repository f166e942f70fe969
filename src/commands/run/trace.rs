//! Traces a pixel: what it wrote, passed and returned, step by step.

use super::columns::columns;
use super::facts::{self, MouseFacts};
use super::loops::{self, LoopRow};
use super::numbers::{self, NumberRow};
use super::place::{position, span};
use super::scalars::{TracedScalar, scalars, shown};
use super::shot::{Loaded, Shot};
use rustc_hash::FxHashMap;
use serde::Serialize;
use shaderlint_diagnostic::count;
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::{OutputSlot, PixelTrace, TraceSite, TracedValue};
use shaderlint_ir::{Module, Provenance};
use shaderlint_semantic::{FunctionRef, Program};
use shaderlint_text::number::seconds;
use shaderlint_text::{SetAt, Span};
use std::sync::Arc;

/// Maximum number of steps that are recorded.
const MOST_STEPS: usize = 20_000;

/// What a pixel did. The JSON format may gain fields, but never loses any.
#[derive(Serialize)]
pub struct TraceFacts {
    /// Version of the JSON format.
    schema: u32,
    /// Name of the shader file.
    file: String,
    /// Width and height of the image in pixels.
    size: [u32; 2],
    /// Time in seconds since the start.
    time: f64,
    /// Frame number, from 0.
    frame: u32,
    /// The mouse, if it was pressed.
    mouse: Option<MouseFacts>,
    /// The pixel, from the lower left corner.
    pixel: [u32; 2],
    /// The outputs; the first is the image.
    outputs: Vec<TracedOutput>,
    /// Whether the pixel was discarded.
    discarded: bool,
    /// Number of operations.
    operations: u32,
    /// Iterations of the loops.
    loops: Vec<LoopRow>,
    /// Invalid numbers.
    numbers: Vec<NumberRow>,
    /// The places at which values were written, passed or returned, in source order.
    sites: Vec<TraceRow>,
    /// The steps in the order in which they were executed.
    steps: Vec<TracedStep>,
    /// Whether there were more steps, which were not recorded.
    more: bool,
    /// Why the run was stopped, if it was.
    stopped: Option<String>,
    /// Notes about inputs that were missing or replaced.
    notes: Vec<String>,
}

/// An output of the pixel.
#[derive(Serialize)]
struct TracedOutput {
    name: String,
    #[serde(rename = "type")]
    ty: String,
    value: Vec<TracedScalar>,
}

/// A place at which values were written, passed or returned.
#[derive(Serialize)]
struct TraceRow {
    /// Position: `file:line:column`.
    at: String,
    /// The pass whose code it is, for projects: `image`, `common`.
    pass: Option<String>,
    /// Line and column, from 1.
    line: u32,
    column: u32,
    /// Name of the variable or parameter; of the function for results.
    name: String,
    #[serde(rename = "type")]
    ty: String,
    /// `written`, `passed` or `returned`.
    kind: &'static str,
    /// Name of the function that ran; empty for the initialisers of globals.
    function: String,
    /// Number of steps.
    times: u32,
    first: Vec<TracedScalar>,
    last: Vec<TracedScalar>,
    #[serde(skip)]
    start: u32,
}

/// A step: an index into the places, and the value.
#[derive(Serialize)]
struct TracedStep(usize, Vec<TracedScalar>);

/// Traces a pixel. `progress` is called before each frame that the frame depends on, with its number.
///
/// # Errors
/// A message about a pixel that cannot be traced.
pub fn trace(
    loaded: &Loaded,
    shot: &mut Shot,
    moment: &Moment,
    pixel: [u32; 2],
    progress: &mut dyn FnMut(u32),
) -> Result<TraceFacts, String> {
    let traced = shot.traced(moment, (pixel, MOST_STEPS), progress)?;
    let program = loaded.program(shot).ok_or("the pass has no code")?;
    let stopped = traced
        .stop
        .as_ref()
        .map(|_| "the pixel exceeded the operation limit");
    let (sites, steps) = Sites::of(loaded, program, shot, &traced).finish();
    let outputs = shot.code().outputs.iter().zip(&traced.outputs);
    Ok(TraceFacts {
        schema: 1,
        file: loaded.name.clone(),
        size: shot.size,
        time: moment.time,
        frame: moment.frame,
        mouse: facts::mouse(moment),
        pixel,
        outputs: outputs
            .map(|(slot, bits)| output(program, slot, bits))
            .collect(),
        discarded: traced.stop.is_none() && !traced.is_covered,
        operations: traced.cost,
        loops: loops::rows(program, shot, &traced.seen),
        numbers: numbers::rows(program, shot, &traced.seen),
        sites,
        steps,
        more: traced.is_cut,
        stopped: stopped.map(str::to_string),
        notes: shot.notes(&loaded.project),
    })
}

fn output(program: &Program, slot: &OutputSlot, bits: &[u32; 4]) -> TracedOutput {
    let bits = bits.get(..slot.lanes()).unwrap_or(bits);
    TracedOutput {
        name: slot.name.clone(),
        ty: program.type_name(slot.ty),
        value: scalars(program, slot.ty, bits),
    }
}

/// The places of a trace. Calls are inlined: a place is that of all calls.
struct Sites<'a> {
    loaded: &'a Loaded,
    program: &'a Program,
    module: Arc<Module>,
    known: FxHashMap<(TracedValue, Option<FunctionRef>), usize>,
    rows: Vec<TraceRow>,
    steps: Vec<TracedStep>,
}

impl<'a> Sites<'a> {
    fn of(loaded: &'a Loaded, program: &'a Program, shot: &Shot, traced: &PixelTrace) -> Sites<'a> {
        let mut sites = Sites {
            loaded,
            program,
            module: shot.module.clone(),
            known: FxHashMap::default(),
            rows: Vec::new(),
            steps: Vec::new(),
        };
        for step in &traced.steps {
            if let Some(site) = traced.sites.get(step.site as usize) {
                sites.add(site, &step.bits);
            }
        }
        sites
    }

    /// Adds a step, if its place is in the code of the user.
    fn add(&mut self, site: &TraceSite, bits: &[u32]) {
        let key = (site.value, site.function);
        let at = match self.known.get(&key) {
            Some(at) => *at,
            None => {
                let Some(row) = self.row(site) else {
                    return;
                };
                self.rows.push(row);
                self.known.insert(key, self.rows.len() - 1);
                self.rows.len() - 1
            }
        };
        let value = scalars(self.program, site.ty, bits);
        if let Some(row) = self.rows.get_mut(at) {
            if row.times == 0 {
                row.first.clone_from(&value);
            }
            row.times += 1;
            row.last.clone_from(&value);
        }
        self.steps.push(TracedStep(at, value));
    }

    fn row(&self, site: &TraceSite) -> Option<TraceRow> {
        let program = self.program;
        let span = place(program, &self.module, site)?;
        let sources = &program.sources;
        let file = sources
            .file_at(span.start)
            .filter(|_| sources.is_user(span.start))?;
        let start = file.position(span.start);
        let pass = sources.file_id_at(span.start);
        let pass = pass.and_then(|id| self.loaded.composed.owner(id));
        let pass = pass.and_then(|pass| self.loaded.project.passes.get(pass));
        let function = site.function.and_then(|id| program.function(id));
        let function = function.map_or("", |f| program.names.text(f.name));
        let variable = |id| program.variable(id).map(|v| program.names.text(v.name));
        let (kind, name) = match site.value {
            TracedValue::Written(id, _) => ("written", variable(id)?),
            TracedValue::Parameter(id) => ("passed", variable(id)?),
            TracedValue::Returned(_) => ("returned", function),
        };
        Some(TraceRow {
            at: position(sources, span)?,
            pass: pass.map(|pass| pass.slug().to_string()),
            line: file.origin(start.line).1,
            column: start.column,
            name: name.to_string(),
            ty: program.type_name(site.ty),
            kind,
            function: function.to_string(),
            times: 0,
            first: Vec::new(),
            last: Vec::new(),
            start: span.start,
        })
    }

    /// The places in source order, and the steps.
    fn finish(self) -> (Vec<TraceRow>, Vec<TracedStep>) {
        let Sites {
            mut rows,
            mut steps,
            ..
        } = self;
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_by_key(|at| rows.get(*at).map(|row| row.start));
        let mut places = vec![0; rows.len()];
        for (new, old) in order.into_iter().enumerate() {
            places.set_at(old, new);
        }
        rows.sort_by_key(|row| row.start);
        for step in &mut steps {
            step.0 = places.get(step.0).copied().unwrap_or(0);
        }
        (rows, steps)
    }
}

/// Where a value was written, passed or returned.
fn place(program: &Program, module: &Module, site: &TraceSite) -> Option<Span> {
    match site.value {
        TracedValue::Written(_, op) | TracedValue::Returned(op) => {
            span(program, module.provenance(op))
        }
        TracedValue::Parameter(id) => {
            let declared = program.variable(id)?.token?;
            span(program, Provenance::Declaration(declared))
        }
    }
}

impl TraceFacts {
    /// The text for people.
    pub fn text(&self) -> String {
        let ([x, y], [width, height]) = (self.pixel, self.size);
        let (file, time, frame) = (&self.file, seconds(self.time), self.frame);
        let mut text =
            format!("{file}: pixel {x},{y} of {width}x{height}, {time}, frame {frame}\n");
        for (output, number) in self.outputs.iter().zip(0..) {
            let name = match number {
                0 => "image",
                _ => output.name.as_str(),
            };
            let value = match self.discarded {
                true => "discarded".to_string(),
                false => shown(&output.value),
            };
            text.push_str(&format!("  {name:9} {value}\n"));
        }
        text.push_str(&format!(
            "  {:9} {}\n",
            "cost",
            count(self.operations, "operation")
        ));
        if let Some(stopped) = &self.stopped {
            text.push_str(&format!("  {:9} {stopped}\n", "stopped"));
        }
        if !self.loops.is_empty() {
            text.push_str(&loops::table(&self.loops));
        }
        if !self.numbers.is_empty() {
            text.push_str(&numbers::table(&self.numbers));
        }
        text.push_str(&self.table());
        if self.more {
            let steps = count(self.steps.len() as u32, "step");
            text.push_str(&format!("  {:9} the first {steps} only\n", "recorded"));
        }
        text
    }

    /// The places as a table.
    fn table(&self) -> String {
        let head = ["place", "function", "variable", "first", "last", "times"];
        let mut cells = vec![head.map(str::to_string)];
        cells.extend(self.sites.iter().map(|row| {
            let name = match row.kind {
                "returned" => "return",
                _ => &row.name,
            };
            [
                row.at.clone(),
                row.function.clone(),
                name.to_string(),
                shown(&row.first),
                shown(&row.last),
                row.times.to_string(),
            ]
        }));
        columns(&cells, 5)
    }
}
