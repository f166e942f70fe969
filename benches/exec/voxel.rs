//! `corpus/templates/voxel.glsl` in hand-written Rust: one pixel at a time, in 32-bit floats.

type Vec3 = [f32; 3];

fn map(a: Vec3, f: impl Fn(f32) -> f32) -> Vec3 {
    a.map(f)
}

fn zip(a: Vec3, b: Vec3, f: impl Fn(f32, f32) -> f32) -> Vec3 {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

fn add(a: Vec3, b: Vec3) -> Vec3 {
    zip(a, b, |a, b| a + b)
}

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    zip(a, b, |a, b| a - b)
}

fn mul(a: Vec3, b: Vec3) -> Vec3 {
    zip(a, b, |a, b| a * b)
}

fn scale(a: Vec3, b: f32) -> Vec3 {
    map(a, |a| a * b)
}

fn dot(a: Vec3, b: Vec3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: Vec3) -> f32 {
    dot(a, a).sqrt()
}

fn normalize(a: Vec3) -> Vec3 {
    scale(a, 1.0 / length(a))
}

fn mix(a: f32, b: f32, t: f32) -> f32 {
    a * (1.0 - t) + b * t
}

/// GLSL's `sign`: `sign(0.0)` is 0.
fn sign(x: f32) -> f32 {
    f32::from(u8::from(x > 0.0)) - f32::from(u8::from(x < 0.0))
}

/// GLSL's `step` applied to neighbouring components: the axis of the next voxel boundary.
fn next_axis(side: Vec3) -> Vec3 {
    let step = |edge: f32, x: f32| if x < edge { 0.0 } else { 1.0 };
    let [x, y, z] = side;
    [
        step(x, y) * step(x, z),
        step(y, z) * step(y, x),
        step(z, x) * step(z, y),
    ]
}

fn rotated([x, z]: [f32; 2], angle: f32) -> [f32; 2] {
    let (s, c) = angle.sin_cos();
    [x * c - z * s, z * c + x * s]
}

fn box_distance(p: Vec3, size: Vec3) -> f32 {
    let d = sub(map(p, f32::abs), size);
    let inside = d[0].max(d[1].max(d[2])).min(0.0);
    inside + length(map(d, |lane| lane.max(0.0)))
}

fn voxel(cell: Vec3) -> i32 {
    let p = map(cell, |lane| lane + 0.5);
    match box_distance(p, [6.0; 3]) < 0.0 {
        true if p[1] < -3.0 => 2,
        true => 1,
        false => 0,
    }
}

struct Hit {
    t: f32,
    place: Vec3,
    normal: Vec3,
    cell: Vec3,
    uv: [f32; 2],
    material: i32,
}

fn cast_ray(from: Vec3, way: Vec3) -> Option<Hit> {
    let mut cell = map(from, f32::floor);
    let step = map(way, sign);
    let delta = map(way, |lane| (1.0 / lane).abs());
    let first = add(mul(step, sub(cell, from)), map(step, |s| s * 0.5 + 0.5));
    let mut side = mul(first, delta);
    let mut mask = [0.0; 3];
    for _ in 0..64 {
        let material = voxel(cell);
        if material > 0 {
            let t = dot(sub(side, delta), mask);
            let place = add(from, scale(way, t));
            let [x, y, z] = sub(place, cell);
            return Some(Hit {
                t,
                place,
                normal: mul(map(mask, |m| -m), step),
                cell,
                uv: [dot(mask, [y, z, x]), dot(mask, [z, x, y])],
                material,
            });
        }
        mask = next_axis(side);
        side = add(side, mul(mask, delta));
        cell = add(cell, mul(mask, step));
    }
    None
}

fn is_lit(from: Vec3, way: Vec3) -> f32 {
    let mut cell = map(from, f32::floor);
    let inverse = map(way, |lane| 1.0 / lane);
    let step = map(way, sign);
    let first = add(sub(cell, from), map(step, |s| 0.5 + s * 0.5));
    let mut side = mul(first, inverse);
    for _ in 0..16 {
        if voxel(cell) > 0 {
            return 0.0;
        }
        let mask = next_axis(side);
        side = add(side, mul(mul(mask, step), inverse));
        cell = add(cell, mul(mask, step));
    }
    1.0
}

fn occlusion(cell: Vec3, u: Vec3, v: Vec3, [s, t]: [f32; 2]) -> f32 {
    let full = |p: Vec3| if voxel(p) > 0 { 1.0_f32 } else { 0.0 };
    let (up, right) = (add(cell, u), add(cell, v));
    let (down, left) = (sub(cell, u), sub(cell, v));
    let sides = [full(up), full(right), full(down), full(left)];
    let corners = [
        full(add(up, v)),
        full(add(down, v)),
        full(sub(down, v)),
        full(sub(up, v)),
    ];
    let vertex = |i: usize| {
        let (a, b) = (sides[i], sides[(i + 1) % 4]);
        1.0 - (a + b + corners[i].max(a * b)) / 3.0
    };
    mix(
        mix(vertex(2), vertex(3), s),
        mix(vertex(1), vertex(0), s),
        t,
    )
}

fn surface(material: i32, [u, v]: [f32; 2]) -> Vec3 {
    let color = match material {
        1 => [0.7, 0.7, 0.75],
        2 => [0.4, 0.55, 0.3],
        _ => [0.6; 3],
    };
    let sum = (u * 4.0).floor() + (v * 4.0).floor();
    let checker = sum - 2.0 * (sum / 2.0).floor();
    scale(color, 0.85 + 0.15 * checker)
}

/// Colour of the pixel with the given lower left corner.
pub fn pixel([x, y]: [u32; 2], size: [u32; 2], time: f32) -> Vec3 {
    let [width, height] = size.map(|side| side as f32);
    let screen = [
        ((x as f32 + 0.5) / width * 2.0 - 1.0) * (width / height),
        (y as f32 + 0.5) / height * 2.0 - 1.0,
    ];
    let mut from = [0.0, 2.0 * (time * 0.5).sin(), -12.0];
    let mut way = normalize([screen[0], screen[1], 0.8]);
    [from[0], from[2]] = rotated([from[0], from[2]], time * 0.3);
    [way[0], way[2]] = rotated([way[0], way[2]], time * 0.3);
    let sun = normalize([-0.5, 0.6, 0.7]);
    let sky = [0.6, 0.75, 0.9];
    let color = match cast_ray(from, way) {
        None => map(sky, |lane| lane - way[1] * 0.2),
        Some(hit) => {
            let [mx, my, mz] = map(hit.normal, f32::abs);
            let open = occlusion(hit.cell, [mz, mx, my], [my, mz, mx], hit.uv).powf(0.5);
            let lit = is_lit(add(hit.place, scale(hit.normal, 0.01)), sun);
            let facing = dot(hit.normal, sun).max(0.0);
            let above = 0.5 + 0.5 * hit.normal[1];
            let warm = scale([1.0, 0.95, 0.8], 2.0 * facing * lit);
            let light = scale(add(warm, scale(sky, above)), open);
            let color = mul(surface(hit.material, hit.uv), light);
            let fog = (1.0 - (-0.0002 * hit.t * hit.t).exp()).clamp(0.0, 0.7);
            zip(color, sky, |own, sky| mix(own, sky, fog))
        }
    };
    map(color, |lane| lane.clamp(0.0, 1.0).powf(0.4545))
}
