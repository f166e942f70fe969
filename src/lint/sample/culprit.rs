//! The operation that made a pixel NaN or infinite.

use super::bench::colors;
use super::{Round, SampleRun};
use crate::context::Context;
use crate::facts::Facts;
use rustc_hash::FxHashSet;
use shaderlint_exec::{CompileOptions, FaultKind, NumberObservation, Watch};
use shaderlint_flow::backward_slice;
use shaderlint_ir::{OpId, OpKind};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_text::number::{decimals, rounded_percent};

/// A pixel with an invalid colour, and the operation that caused it.
#[derive(Clone, PartialEq, Debug)]
pub struct Culprit {
    /// The share of sampled pixels with such a colour, from 0 to 1.
    pub share: f64,
    /// The first such pixel, as `gl_FragCoord.xy - 0.5`.
    pub pixel: [u32; 2],
    /// Time of its frame, in seconds.
    pub time: f64,
    /// The first operation that produced such a number in it, with its operands.
    pub number: Option<NumberObservation>,
}

impl Facts<'_> {
    /// The first sampled pixel with such a channel, run again while watching every number.
    pub fn culprit(&self, kind: FaultKind, is_broken: fn(f32) -> bool) -> Option<Culprit> {
        let is_hit = |color: &[f32; 3]| color.iter().any(|lane| is_broken(*lane));
        let has_one = |sample_run: &SampleRun| sample_run.drawn().any(|pixel| is_hit(&pixel.color));
        if !self.is_image_known() || !self.round(Round::Second).is_some_and(has_one) {
            return None;
        }
        let sample_run = self.sample_run().filter(|_| self.is_seen(has_one))?;
        let share = super::share(sample_run.drawn(), |pixel| is_hit(&pixel.color));
        let (instant, pixel) = sample_run.frames.iter().find_map(|frame| {
            let found = frame.drawn().find(|pixel| is_hit(&pixel.color))?;
            Some((frame.instant, found))
        })?;
        let (bench, supplier) = self.bench()?;
        let options = CompileOptions {
            watch: Watch::Numbers,
            ..CompileOptions::default()
        };
        let code = self.compiled(&options)?;
        let quad = pixel.at.map(|at| at & !1);
        let sampled = bench.sample(&code, supplier, &instant, &[quad])?;
        let again = sampled.pixels.iter().zip(colors(&code, &sampled));
        let mut again = again.filter(|(at, _)| **at == pixel.at);
        let is_same = again.all(|(_, color)| is_hit(&color));
        let numbers = sampled.seen.numbers.into_iter();
        let own = numbers.filter(|n| n.kind == kind && n.witness.pixel == pixel.at);
        let own: Vec<NumberObservation> = own.collect();
        let shown = match own.len() {
            0 | 1 => None,
            _ => {
                let carriers = self.carriers(kind);
                own.iter().find(|n| carriers.contains(&n.op)).cloned()
            }
        };
        Some(Culprit {
            share,
            pixel: pixel.at,
            time: instant.time,
            number: shown.or_else(|| own.into_iter().next()).filter(|_| is_same),
        })
    }

    /// The operations from which such a number may reach the outputs: not those whose result is
    /// overwritten, unused, or limited afterwards.
    fn carriers(&self, kind: FaultKind) -> FxHashSet<OpId> {
        let (module, defs) = (self.module(), self.reaching_definitions());
        let slots = self.outputs().into_iter().flat_map(|id| {
            let lanes = module.variable(id).map_or(0, |v| defs.layout.lanes(v.ty));
            (0..lanes).map(move |lane| (id, lane))
        });
        let exits = slots.filter_map(|(id, lane)| defs.exit(defs.slot(id, lane)));
        backward_slice(module, defs, exits, |op| match module.op(op).kind {
            OpKind::Binary(operator, ..) => !operator.compares(),
            OpKind::Same { .. } => false,
            OpKind::Builtin(function, _) => match function.transfer() {
                Transfer::Between | Transfer::Threshold | Transfer::Ramp => false,
                Transfer::Minimum | Transfer::Maximum => kind != FaultKind::Nan,
                _ => true,
            },
            _ => true,
        })
    }
}

impl Culprit {
    /// The pixel, time and operands, as a note.
    pub fn evidence_note(&self) -> String {
        let [x, y] = self.pixel;
        let time = self.time;
        let operands = self
            .number
            .as_ref()
            .map_or(&[][..], |n| &n.witness.operands);
        let numbers: Vec<String> = operands.iter().map(|n| decimals(*n, 6)).collect();
        let of = match numbers.as_slice() {
            [] => String::new(),
            numbers => format!(", with operands {}", numbers.join(" and ")),
        };
        format!("first at pixel ({x}, {y}) at {time} s{of}")
    }
}

/// Reports the share of pixels with an invalid colour at the operation that caused the first one, unless
/// another rule has reported that operation.
pub fn report_broken(cx: &mut Context, kind: FaultKind, is_broken: fn(f32) -> bool, what: &str) {
    let Some(culprit) = cx.facts.culprit(kind, is_broken) else {
        return;
    };
    let op = culprit.number.as_ref().map(|n| n.op);
    if op.is_some_and(|op| cx.facts.is_reported(op)) {
        return;
    }
    cx.facts.mark_reported(op);
    let note = cx
        .facts
        .sample_run()
        .map_or(String::new(), SampleRun::sampled_note);
    let message = format!(
        "{} of the pixels are {what}",
        rounded_percent(culprit.share)
    );
    let finding = match op {
        Some(op) => cx.report_op(op, message).mark("first occurs here"),
        None => cx.report_image(message),
    };
    finding.note(culprit.evidence_note()).note(note);
}
