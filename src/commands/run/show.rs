//! Draws the value of a variable on a line.

use super::bitmap::Bitmap;
use super::heat;
use super::place::span;
use super::setting::Show;
use shaderlint_exec::{Bytecode, Drawn, Probe};
use shaderlint_ir::{Module, OpId, OpKind};
use shaderlint_play::RenderedImage;
use shaderlint_project::{Composed, PassUnit};
use shaderlint_semantic::{Program, VariableId};
use shaderlint_text::{SourceFile, Span};
use std::collections::BTreeSet;

/// The probe that records the variable.
pub fn probe(
    show: &Show,
    composed: &Composed,
    unit: &PassUnit,
    program: &Program,
    module: &Module,
) -> Result<Probe, String> {
    let mut files = unit.files.iter();
    let own = files.find(|id| composed.owner(**id) == Some(unit.pass));
    let file = own.and_then(|id| composed.sources.file(*id));
    let uses = uses(&show.name, program, module);
    let in_file = uses
        .iter()
        .filter_map(|(variable, span)| Some((*variable, line_of(file?, *span)?)));
    // By the line in its file: the line in the text.
    let lines: BTreeSet<(u32, u32, VariableId)> = in_file
        .filter_map(|(v, line)| Some((file?.origin(line).1, line, v)))
        .collect();
    let found = lines.iter().find(|(line, ..)| *line == show.line);
    let within = found.zip(file);
    let within = within.and_then(|((_, line, _), file)| full_line(file, *line));
    if let (Some((.., variable)), Some(within)) = (found, within) {
        return Ok(Probe::Variable {
            variable: *variable,
            within,
        });
    }
    let name = &show.name;
    let others: BTreeSet<u32> = lines.iter().map(|(line, ..)| *line).collect();
    let others: Vec<String> = others.iter().map(u32::to_string).collect();
    Err(match others.len() {
        0 => format!("--show: the shader reads or writes no variable `{name}`"),
        1 => format!(
            "--show: `{name}` is not used on line {}; it is used on line {}",
            show.line,
            others.concat()
        ),
        _ => format!(
            "--show: `{name}` is not used on line {}; it is used on lines {}",
            show.line,
            others.join(", ")
        ),
    })
}

/// The places where variables of a name are read or written.
fn uses(name: &str, program: &Program, module: &Module) -> Vec<(VariableId, Span)> {
    let Some(name) = program.names.get(name) else {
        return Vec::new();
    };
    let ids = (0..module.ops.len() as u32).map(OpId);
    let uses = ids.filter_map(|id| {
        let (OpKind::Load(place) | OpKind::Store(place, _)) = module.op(id).kind else {
            return None;
        };
        let variable = module.place(place).variable;
        let is_it = program.variable(variable).is_some_and(|v| v.name == name);
        let span = span(program, module.provenance(id)).filter(|_| is_it)?;
        Some((variable, span))
    });
    uses.collect()
}

/// The line of a span, if it is in this file.
fn line_of(file: &SourceFile, span: Span) -> Option<u32> {
    file.span()
        .contains(Span::at(span.start))
        .then(|| file.position(span.start).line)
}

/// The span of a line, by its number from 1.
fn full_line(file: &SourceFile, number: u32) -> Option<Span> {
    let lines = file.text.split_inclusive('\n');
    let before = lines.clone().take(number as usize - 1).map(str::len);
    let start = file.base + before.sum::<usize>() as u32;
    let line = file.text.split_inclusive('\n').nth(number as usize - 1)?;
    Some(Span::new(start, start + line.len() as u32))
}

/// Draws a scalar as a heat map and a vector as colours. Values outside 0 to 1 are scaled to the
/// range from smallest to largest.
pub fn value_image(name: &str, code: &Bytecode, drawn: &Drawn) -> Bitmap {
    // The last output is the flag that says whether the line ran.
    let at = code.outputs.len().saturating_sub(2);
    let lanes = code.outputs.get(at).map_or(0, |slot| slot.ty.components());
    let image = RenderedImage::of(code, drawn, at);
    if lanes == 1 {
        let values = image.pixels.iter().map(|p| f64::from(p[0]));
        return heat::map(drawn.size, &values.collect::<Vec<_>>(), name);
    }
    let numbers = || {
        image
            .pixels
            .iter()
            .flat_map(|p| p.iter().take(lanes as usize))
    };
    let finite = || numbers().copied().filter(|n| n.is_finite());
    let (least, most) = (finite().fold(0.0, f32::min), finite().fold(1.0, f32::max));
    let scaled = image.pixels.iter().map(|p| {
        let lane = |n: f32| (n - least) / (most - least);
        let mut pixel = p.map(lane);
        if lanes == 2 {
            pixel[2] = 0.0;
        }
        pixel
    });
    let scaled = RenderedImage {
        size: drawn.size,
        pixels: scaled.collect(),
    };
    Bitmap {
        size: drawn.size,
        bytes: scaled.bytes(),
    }
}
