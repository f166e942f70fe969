//! Thresholds that a height, or another quantity, never reaches in a sample run.

use shaderlint_exec::ComparisonObservation;
use shaderlint_ir::Op;
use shaderlint_lint::prelude::*;

rule! { unreachable_height, Runtime, Warning, Recommended, Run(check) }

/// Fewest sampled comparisons that count as evidence.
const LEAST: u64 = 125;

/// Most comparisons that are analysed, since each is compared with all others.
const MOST: usize = 200;

/// Comparisons of one value with several constants, such as the height bands of a mountain.
struct Bands {
    value: OpId,
    /// The comparison with the largest constant.
    last: OpId,
    /// The largest constant.
    limit: f32,
    /// The comparisons with smaller constants.
    others: Vec<OpId>,
}

fn check(cx: &mut Context) {
    if !cx.facts.is_image_known() {
        return;
    }
    let mut bands = bands(cx);
    bands.retain(|bands| {
        let is_bounded = !cx.facts.may_move(bands.value) || proves(cx, bands);
        is_bounded && cx.facts.is_known(bands.first())
    });
    if bands.is_empty() {
        return;
    }
    let may_be_missed = |few: &SampleRun| {
        let mut all = bands.iter();
        all.any(|bands| Reached::of(few, bands).is_none_or(|seen| seen.is_below()))
    };
    if !cx.facts.compared().is_some_and(may_be_missed) {
        return;
    }
    let mut runs = cx.facts.smaller_runs(Watch::Comparisons);
    let Some(Some(usual)) = runs.next() else {
        return;
    };
    let missed = |bands: Bands| Some((Reached::of(&usual, &bands)?, bands));
    let missed = bands
        .into_iter()
        .filter_map(missed)
        .filter(|(seen, bands)| seen.distinguishes && seen.is_below() && !grows(&usual, bands));
    let missed: Vec<(Reached, Bands)> = missed.collect();
    if missed.is_empty() {
        return;
    }
    let Some(later) = cx.facts.later_run(Watch::Comparisons) else {
        return;
    };
    let Some(sample_run) = cx.facts.sample_run() else {
        return;
    };
    let others: Vec<SampleRun> = runs.flatten().chain([later]).collect();
    for (seen, bands) in missed {
        let is_same =
            |sample_run: &SampleRun| Reached::of(sample_run, &bands).is_none_or(|r| r.is_below());
        if !others.iter().all(is_same) {
            continue;
        }
        let Reached {
            most, limit, times, ..
        } = seen;
        let note = sample_run.sampled_note();
        let message =
            format!("value is at most {most:.3}, so the threshold {limit} is never reached");
        let finding = cx.report_op(bands.value, message);
        finding
            .note(format!(
                "{most:.3} is the maximum of {} sampled comparisons",
                grouped(times)
            ))
            .note(note)
            .help("divide by the largest value that is actually reached, or lower the thresholds");
    }
}

/// All bands of a shader.
fn bands(cx: &Context) -> Vec<Bands> {
    let module = cx.facts.module();
    let numbered = module.ops.iter().zip(0..);
    let compared = numbered.filter_map(|(op, number)| {
        let (value, limit) = threshold(module, op)?;
        let [limit] = module.constant(limit) else {
            return None;
        };
        let is_float = module.ty(value) == Type::FLOAT;
        is_float.then_some((OpId(number), value, limit.as_float()))
    });
    let compared: Vec<(OpId, OpId, f32)> = compared.take(MOST).collect();
    let mut all = Vec::new();
    for &(last, value, limit) in &compared {
        let same = compared
            .iter()
            .filter(|(op, other, _)| *op != last && cx.facts.is_same_value(value, *other));
        let others: Vec<&(OpId, OpId, f32)> = same.collect();
        if !others.is_empty() && others.iter().all(|(.., other)| *other < limit) {
            let others = others.iter().map(|(op, ..)| *op).collect();
            all.push(Bands {
                value,
                last,
                limit,
                others,
            });
        }
    }
    all
}

/// The value and the threshold of a comparison, `step` or `smoothstep`.
fn threshold(module: &Module, op: &Op) -> Option<(OpId, OpId)> {
    match op.kind {
        OpKind::Binary(binary, value, limit) if binary.compares() => Some((value, limit)),
        OpKind::Builtin(function, list) => function.comparison(module.operands(list)),
        _ => None,
    }
}

impl Bands {
    /// The comparison that runs first.
    fn first(&self) -> OpId {
        self.others.iter().copied().fold(self.last, OpId::min)
    }
}

/// The sampled maximum of the value of some bands.
struct Reached {
    most: f64,
    /// The largest threshold.
    limit: f32,
    /// Number of evaluations of the comparison that ran most often.
    times: u64,
    /// Whether some comparison was both true and false.
    distinguishes: bool,
}

impl Reached {
    fn of(sample_run: &SampleRun, bands: &Bands) -> Option<Reached> {
        let ops = bands.others.iter().chain([&bands.last]);
        let seen = |op: &OpId| sample_run.seen.compared.iter().find(|c| c.op == *op);
        let seen: Vec<&ComparisonObservation> = ops.filter_map(seen).collect();
        let times = seen.iter().map(|c| c.held + c.failed).max()?;
        (times >= LEAST).then(|| Reached {
            most: seen
                .iter()
                .map(|c| c.left[1])
                .fold(f64::NEG_INFINITY, f64::max),
            limit: bands.limit,
            times,
            distinguishes: seen.iter().any(|c| c.held > 0 && c.failed > 0),
        })
    }

    /// Whether the maximum stays below the largest threshold by more than 1 %.
    fn is_below(&self) -> bool {
        let limit = f64::from(self.limit);
        self.most + 0.01 * limit.abs() < limit
    }
}

/// Whether the range of the value ends below the largest threshold, at any time.
fn proves(cx: &Context, bands: &Bands) -> bool {
    cx.facts.ranges().lane(bands.value, 0).hi.value < f64::from(bands.limit)
}

/// Whether the maximum at the last instant is far above the earlier ones, so that it may keep growing.
fn grows(sample_run: &SampleRun, bands: &Bands) -> bool {
    let most = |frame: &SampleFrame| {
        let compared = frame.sampled.seen.compared.iter();
        let own = compared.filter(|c| c.op == bands.last || bands.others.contains(&c.op));
        own.map(|c| c.left[1]).fold(f64::NEG_INFINITY, f64::max)
    };
    let Some((last, earlier)) = sample_run.frames.split_last() else {
        return false;
    };
    let earlier = earlier.iter().map(most).fold(f64::NEG_INFINITY, f64::max);
    most(last) > earlier + 0.1 * earlier.abs()
}
