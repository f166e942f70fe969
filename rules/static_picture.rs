//! Shaders that read the time and draw the same image in every frame.

use shaderlint_exec::{Draw, quads_all_over};
use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::{Instant, SIZE};

rule! { static_picture, Runtime, Info, Recommended, Run(check) }

/// Times in seconds at which pixels are compared, without a mouse.
const TIMES: [f64; 8] = [0.0, 0.13, 0.71, 2.3, 5.9, 10.7, 23.3, 43.1];
/// Number of quads per round: some images change in a few places only.
const QUADS: [usize; 2] = [64, 4096];

fn check(cx: &mut Context) {
    if cx.facts.is_blank() || !cx.facts.is_image_known() {
        return;
    }
    let Some((bench, supplier)) = cx.facts.bench() else {
        return;
    };
    let code = bench.watched();
    let draw = |time: f64| -> Draw<'_> { supplier.draw(code, SIZE, &Instant::at(time)) };
    let [first, second] = [2.3, 10.7].map(draw);
    let moving: Vec<&str> = first
        .differences(&second)
        .map(|u| u.name.as_str())
        .collect();
    let Some(name) = moving.first().map(|name| name.to_string()) else {
        return;
    };
    // Most images change at once.
    if cx.facts.changes_later() != Some(false) {
        return;
    }
    for count in QUADS {
        let quads = quads_all_over(SIZE, count, 0);
        let images = TIMES.iter().map(|time| {
            let sampled = bench.sample(code, supplier, &Instant::at(*time), &quads)?;
            Some((sampled.outputs, sampled.covered))
        });
        let mut known = None;
        for image in images {
            let Some(image) = image else { return };
            if known.get_or_insert_with(|| image.clone()) != &image {
                return;
            }
        }
    }
    let times = TIMES.map(|t| t.to_string()).join(", ");
    let message = format!("`{name}` is read, but the image does not change");
    let finding = cx.report_image(message);
    let pixels = grouped(QUADS[1] as u64 * 4);
    finding.note(format!(
        "{pixels} sampled pixels are identical at {times} s"
    ));
}
