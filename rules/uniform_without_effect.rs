//! Uniforms that are read but do not affect the image.

use shaderlint_exec::{Bytecode, UniformSlot, quads_all_over};
use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::{Instant, Press, SIZE};

rule! { uniform_without_effect, Runtime, Info, Recommended, Run(check) }

/// Values to which all components of a user-defined uniform are set.
const VALUES: [f64; 7] = [0.0, 1.0, 0.5, -1.0, 2.0, 10.0, 100.0];
/// Times in seconds at which pixels are compared.
const TIMES: [f64; 2] = [2.3, 10.7];
/// Frames with a dragged and with a just clicked mouse.
const DRAGGED: usize = 5;
const CLICKED: usize = 6;
/// Number of quads around the mouse, 3 by 3.
const POINTERS: usize = 9;
/// Number of quads per round: few at first, since most uniforms affect many pixels.
const QUADS: [usize; 2] = [8, 256];

fn check(cx: &mut Context) {
    if cx.facts.is_blank() || !cx.facts.is_image_known() {
        return;
    }
    let Some((bench, _)) = cx.facts.bench() else {
        return;
    };
    let code = bench.watched();
    for slot in &code.uniforms {
        let Some(way) = way(cx, code, slot) else {
            continue;
        };
        if changes(cx, code, slot, way) != Some(false) {
            continue;
        }
        let name = &slot.name;
        let Some(mention) = mention(cx, name) else {
            continue;
        };
        let values = match way {
            Way::Mouse => "with the mouse released, clicked, held and dragged".to_string(),
            Way::Values => format!(
                "with the values {}",
                VALUES.map(|v| v.to_string()).join(", ")
            ),
        };
        let finding = cx.report_expr(
            mention,
            format!("`{name}` is read, but has no effect on the image"),
        );
        let near = if way == Way::Mouse { POINTERS } else { 0 };
        let pixels = grouped((QUADS[1] + near) as u64 * 4);
        finding.note(format!("{pixels} sampled pixels are identical {values}"));
    }
}

/// How a uniform is varied.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Mouse,
    /// By setting it.
    Values,
}

/// How to vary a uniform; `None` for those that the user does not control, such as time and size.
fn way(cx: &Context, code: &Bytecode, slot: &UniformSlot) -> Option<Way> {
    let (_, supplier) = cx.facts.bench()?;
    let draw = |instant: &Instant| supplier.draw(code, SIZE, instant);
    let [still, late] = [0.0, 10.7].map(Instant::at);
    let names =
        |a: &Instant, b: &Instant| draw(a).differences(&draw(b)).any(|u| u.name == slot.name);
    if names(&still, &late) {
        return None;
    }
    if names(&still, &pressed(0.0, pointer(1))) {
        return Some(Way::Mouse);
    }
    (!supplier.knows(&slot.name)).then_some(Way::Values)
}

/// The place of the mouse in a frame, in pixels.
fn pointer(number: usize) -> [f64; 2] {
    let place = 90.0 * number as f64;
    [place, place * 0.7]
}

fn pressed(time: f64, at: [f64; 2]) -> Instant {
    let press = Press { at, is_down: true };
    Instant {
        time,
        mouse: Some(press),
    }
}

/// Whether some value of a uniform changes some pixel.
fn changes(cx: &Context, code: &Bytecode, slot: &UniformSlot, way: Way) -> Option<bool> {
    let (bench, supplier) = cx.facts.bench()?;
    let scalars = (slot.ty.element().components() * slot.ty.array.max(1)) as usize;
    for count in QUADS {
        let mut quads = quads_all_over(SIZE, count, 0);
        if way == Way::Mouse && count == QUADS[1] {
            // A pointer may be drawn where the mouse is.
            let [x, y] = pointer(1).map(|lane| lane as u32 & !1);
            quads.extend((0..POINTERS as u32).map(|i| [x + i % 3 * 4 - 4, y + i / 3 * 4 - 4]));
        }
        for time in TIMES {
            let frame = |number: usize| {
                let instant = match (way, number) {
                    (Way::Mouse, 1..) => pressed(time, pointer(number)),
                    _ => Instant::at(time),
                };
                let mut draw = supplier.draw(code, SIZE, &instant);
                let [x, y] = pointer(number);
                match (way, VALUES.get(number)) {
                    (Way::Values, Some(value)) => {
                        draw.set(&slot.name, &vec![*value; scalars]);
                    }
                    // ShaderToy's mouse while it is dragged, and in the frame of the click.
                    (Way::Mouse, _) if scalars == 4 && number == DRAGGED => {
                        draw.set(&slot.name, &[x, y, 0.5 * x, -0.5 * y]);
                    }
                    (Way::Mouse, _) if scalars == 4 && number == CLICKED => {
                        draw.set(&slot.name, &[x, y, x, y]);
                    }
                    _ => {}
                }
                let sampled = bench.sample_draw(draw, &quads)?;
                Some((sampled.outputs, sampled.covered))
            };
            let first = frame(0)?;
            for number in 1..VALUES.len() {
                if frame(number)? != first {
                    return Some(true);
                }
            }
        }
    }
    Some(false)
}

/// The first use of a uniform in the user's files.
fn mention(cx: &Context, name: &str) -> Option<shaderlint_syntax::ast::ExprId> {
    let program = cx.program;
    let root = name.split(['.', '[']).next()?;
    let mut variables = program.variables.iter().zip(0..);
    let (_, number) = variables
        .find(|(v, _)| v.storage == Storage::Uniform && program.names.text(v.name) == root)?;
    let mentions = cx.facts.mentions().all(VariableId(number)).iter();
    let mut own = mentions.filter(|e| program.is_user(program.expr_span(**e)));
    own.next().copied()
}
