//! Which operation broke a pixel.

use super::Trial;
use super::bench::colors;
use crate::context::Context;
use crate::facts::Facts;
use shaderlint_exec::{CompileOptions, Kind, NumberSeen, Watch};

/// A pixel whose colour is no number that a screen could show, and what made it so.
#[derive(Clone, PartialEq, Debug)]
pub struct Culprit {
    /// The share of the pixels that are like it.
    pub share: f64,
    /// The pixel.
    pub pixel: [u32; 2],
    /// When it was drawn, in seconds.
    pub time: f64,
    /// The first operation of the shader that made such a number in it, with what it worked on.
    pub number: Option<NumberSeen>,
}

impl Facts<'_> {
    /// The first pixel of the picture that has a channel like this, looked at number by number.
    pub fn culprit(&self, kind: Kind, is_broken: fn(f32) -> bool) -> Option<Culprit> {
        let is_hit = |color: &[f32; 3]| color.iter().any(|lane| is_broken(*lane));
        let has_one = |trial: &Trial| trial.drawn().any(|pixel| is_hit(&pixel.color));
        let trial = self.picture().filter(|trial| has_one(trial))?;
        if !self.is_seen(has_one) {
            return None;
        }
        let share = super::share(trial.drawn(), |pixel| is_hit(&pixel.color));
        let (instant, pixel) = trial.shots.iter().find_map(|shot| {
            let found = shot.drawn().find(|pixel| is_hit(&pixel.color))?;
            Some((shot.instant, found))
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
        let mut own = numbers.filter(|n| n.kind == kind && n.witness.pixel == pixel.at);
        Some(Culprit {
            share,
            pixel: pixel.at,
            time: instant.time,
            number: own.next().filter(|_| is_same),
        })
    }
}

impl Culprit {
    /// Where and when it was seen, and with which numbers, as a note.
    pub fn told(&self) -> String {
        let [x, y] = self.pixel;
        let time = self.time;
        let operands = self
            .number
            .as_ref()
            .map_or(&[][..], |n| &n.witness.operands);
        let numbers: Vec<String> = operands
            .iter()
            .map(|n| format!("{n:.6}"))
            .map(short)
            .collect();
        let of = match numbers.as_slice() {
            [] => String::new(),
            numbers => format!(", of {}", numbers.join(" and ")),
        };
        format!("at the pixel ({x}, {y}) at {time} s{of}")
    }
}

/// Reports the share of the picture that is broken in a way, where the first operation stands that
/// made it so; nothing where another rule tells of that.
pub fn report_broken(cx: &mut Context, kind: Kind, is_broken: fn(f32) -> bool, what: &str) {
    let Some(culprit) = cx.facts.culprit(kind, is_broken) else {
        return;
    };
    let op = culprit.number.as_ref().map(|n| n.op);
    if op.is_some_and(|op| cx.facts.is_told(op)) {
        return;
    }
    let told = cx.facts.trial().map_or(String::new(), Trial::told);
    let message = format!("{} of the picture is {what}", percent(culprit.share));
    let finding = match op {
        Some(op) => cx.report_op(op, message).mark("it begins here"),
        None => cx.report_picture(message),
    };
    finding.note(culprit.told()).note(told);
}

/// Without zeros at the end.
fn short(number: String) -> String {
    match number.contains('.') {
        true => number
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_string(),
        false => number,
    }
}

/// A share in percent, as a person would say it.
pub fn percent(share: f64) -> String {
    match share * 100.0 {
        p if p < 0.01 => "less than 0.01 %".to_string(),
        p if p < 1.0 => format!("{p:.2} %"),
        p if p < 10.0 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}
