//! Mipmap generation.

use super::texels::Texels;

/// Generates the next level: each texel is interpolated at the centre of the area that it covers,
/// between two texels along each halved axis. Odd sizes are rounded down, as in browsers.
pub(super) fn half(texels: &Texels, from: [u32; 3], to: [u32; 3]) -> Texels {
    match texels {
        Texels::Unorm8(texels) => Texels::Unorm8(
            shrink(texels, |t: &[u8; 4]| t.map(f32::from), from, to)
                .into_iter()
                .map(|texel| texel.map(|part| part.round_ties_even() as u8))
                .collect(),
        ),
        Texels::Float(texels) => Texels::Float(shrink(texels, |t: &[f32; 4]| *t, from, to)),
        Texels::Int(_) | Texels::Uint(_) => texels.clone(),
    }
}

fn shrink<T>(
    texels: &[T],
    value: impl Fn(&T) -> [f32; 4],
    from: [u32; 3],
    to: [u32; 3],
) -> Vec<[f32; 4]> {
    let [across, up, deep] = [0, 1, 2].map(|axis| {
        let side = |size: [u32; 3]| size.get(axis).copied().unwrap_or(1);
        taps(side(from), side(to))
    });
    let [width, height, _] = from.map(|side| side as usize);
    let mut shrunk = Vec::with_capacity(across.len() * up.len() * deep.len());
    for z in &deep {
        for y in &up {
            for x in &across {
                let mut sum = [0.0; 4];
                for (slice, part_z) in z {
                    for (row, part_y) in y {
                        for (column, part_x) in x {
                            let share = part_x * part_y * part_z;
                            let number = (slice * height + row) * width + column;
                            let Some(texel) = texels.get(number) else {
                                continue;
                            };
                            for (sum, part) in sum.iter_mut().zip(value(texel)) {
                                *sum += share * part;
                            }
                        }
                    }
                }
                shrunk.push(sum);
            }
        }
    }
    shrunk
}

/// For each texel of the smaller level along one axis: the two texels of the larger level to
/// interpolate, with their weights.
fn taps(from: u32, to: u32) -> Vec<Vec<(usize, f32)>> {
    let step = from as f32 / to as f32;
    let last = from as usize - 1;
    (0..to)
        .map(|at| {
            let middle = (at as f32 + 0.5) * step - 0.5;
            let low = middle as usize;
            let share = middle - low as f32;
            if share == 0.0 {
                return vec![(low, 1.0)];
            }
            vec![(low, 1.0 - share), ((low + 1).min(last), share)]
        })
        .collect()
}
