//! Values of varyings at each pixel: computed by a vertex shader at the corners of a triangle, and
//! interpolated.

use shaderlint_exec::{Bytecode, CompileOptions, Draw, compile, draw};
use shaderlint_explain::analyze_alone;
use shaderlint_ir::lower;
use shaderlint_project::VaryingValue;
use shaderlint_text::Role;

/// Corners of the triangle that covers the image, in normalised device coordinates.
const CORNERS: [[f64; 2]; 3] = [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]];

/// The values of the varyings of a shader.
pub(super) struct Varyings {
    places: Vec<Column>,
    /// Computes the value of a varying at a corner.
    code: Bytecode,
}

/// A varying without members, or one of its columns.
struct Column {
    place: String,
    lanes: usize,
}

impl Varyings {
    /// `None` if there are none, or their values cannot be computed.
    pub fn of(values: &[VaryingValue]) -> Option<Varyings> {
        let mut places = Vec::new();
        let mut chosen = String::new();
        for VaryingValue { place, ty, value } in values {
            let (_, columns, lanes) = ty.numeric()?;
            for column in 0..columns {
                let value = match columns {
                    1 => value.clone(),
                    _ => format!("({value})[{column}]"),
                };
                let number = places.len();
                let zeros = ", 0.0".repeat(usize::from(4_u8.saturating_sub(lanes)));
                let vector = match lanes {
                    1 => "float".to_string(),
                    _ => format!("vec{lanes}"),
                };
                chosen.push_str(&format!(
                    "    if (port_at == {number}) port_value = vec4({vector}({value}){zeros});\n"
                ));
                places.push(Column {
                    place: place.clone(),
                    lanes: usize::from(lanes),
                });
            }
        }
        if places.is_empty() {
            return None;
        }
        let text = format!(
            "#version 300 es\nprecision highp float;\nprecision highp int;\n\
             uniform vec2 port_pos, port_size;\nuniform int port_at;\nout vec4 port_value;\n\
             void main() {{\n    vec2 port_place = 0.5 + 0.5 * port_pos;\n{chosen}}}\n"
        );
        let checked = analyze_alone(text, Role::Prelude)?;
        let module = lower(&checked.program);
        let code = compile(&checked.program, &module, &CompileOptions::default()).ok()?;
        Some(Varyings { places, code })
    }

    /// Sets the varyings in a draw.
    pub fn set(&self, of: &mut Draw<'_>) {
        let names = of.code.inputs.iter().map(|input| input.name.clone());
        for name in names.collect::<Vec<_>>() {
            let columns = self.places.iter().zip(0..);
            let is_part = |place: &str| {
                let rest = place.strip_prefix(name.as_str());
                rest.is_some_and(|r| r.is_empty() || r.starts_with(['.', '[']))
            };
            let columns = columns.filter(|(column, _)| is_part(&column.place));
            let planes = columns.flat_map(|(column, at)| self.planes(at, column.lanes, of.size));
            let planes: Vec<[f32; 3]> = planes.collect();
            of.input(&name, &planes);
        }
    }

    /// By component: the value at the lower left corner, and the slope to the right and up.
    fn planes(&self, at: u32, lanes: usize, size: [u32; 2]) -> Vec<[f32; 3]> {
        let [first, right, above] = CORNERS.map(|corner| self.value(at, corner, size));
        let [width, height] = size.map(|n| 2.0 * n as f32);
        let all = first.into_iter().zip(right).zip(above);
        let planes = all.map(|((first, right), above)| {
            [first, (right - first) / width, (above - first) / height]
        });
        planes.take(lanes).collect()
    }

    fn value(&self, at: u32, corner: [f64; 2], size: [u32; 2]) -> [f32; 4] {
        let mut one = Draw::new(&self.code, [1, 1]);
        one.set("port_pos", &corner);
        one.set("port_size", &size.map(f64::from));
        one.set("port_at", &[f64::from(at)]);
        let drawn = draw(&one, 1).ok();
        let outputs = drawn.map_or(Vec::new(), |d| d.outputs);
        let first = outputs.first().and_then(|output| output.first());
        first.map_or([0.0; 4], |bits| bits.map(f32::from_bits))
    }
}
