//! The steepest place of a distance field, searched with runs of its function.
//!
//! The function is drawn over planes in space: random ones of several sizes, then smaller ones around the
//! steepest places, along their gradients. Two neighbouring pixels are a witness of a slope.

use serde::Serialize;
use shaderlint_engine::inputs::{Moment, Scene};
use shaderlint_exec::{CompileOptions, Draw, Drawn, draw};
use shaderlint_flow::DistanceField;
use shaderlint_host::Preset;
use shaderlint_ir::{Module, OpKind, Root};
use shaderlint_math::hash;
use shaderlint_semantic::{FunctionRef, Program, Value, VariableId};

/// Width and height of a plane in pixels.
const SIZE: [u32; 2] = [32, 32];
/// Times in seconds at which functions that read uniforms are run.
const TIMES: [f64; 3] = [0.0, 1.0, 10.0];
/// Half the side of the regions that are searched.
const REGIONS: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 20.0];
/// Number of places that are searched further.
const KEPT: usize = 3;
/// Rounds of that search.
const ROUNDS: u32 = 8;
/// Relative rounding error of values and positions that a slope has to exceed.
const ROUNDING: f64 = 1e-6;

/// Two points, and the values of a field there.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Steepest {
    /// The difference of the values divided by the distance, less what rounding may contribute.
    pub slope: f64,
    /// The points.
    pub points: [[f64; 3]; 2],
    /// The values.
    pub values: [f64; 2],
    /// Time in seconds, if the field reads uniforms.
    pub time: Option<f64>,
    /// Number of points at which the field was evaluated.
    pub samples: u64,
}

/// Why a field cannot be evaluated on its own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unsampled {
    /// It has other parameters than the point.
    Parameters,
    /// It reads a global variable that other functions write.
    Global(VariableId),
    /// It reads a texture or an input of the shader.
    Input,
    /// It cannot be run.
    Refused,
}

/// Searches the steepest place of a field, with about this number of planes per time.
///
/// # Errors
/// Why the field cannot be evaluated.
pub fn steepest(
    (program, module): (&Program, &Module),
    host: Option<&'static Preset>,
    field: DistanceField,
    planes: u32,
) -> Result<Option<Steepest>, Unsampled> {
    let own = with_callees(module, field.function);
    if let Some(global) = written_elsewhere(module, &own) {
        return Err(Unsampled::Global(global));
    }
    let reads_texture = |f: &FunctionRef| {
        let ops = module.function(*f).map(|f| f.ops.ops());
        ops.into_iter()
            .flatten()
            .any(|op| match module.op(op).kind {
                OpKind::Builtin(function, _) => function.kind().is_texture(),
                _ => false,
            })
    };
    if own.iter().any(reads_texture) {
        return Err(Unsampled::Input);
    }
    let options = CompileOptions {
        entry: Some(field.function),
        ..CompileOptions::default()
    };
    let scene = Scene::of(program, host, module, &options).map_err(|_| Unsampled::Refused)?;
    let parameters = parameters(program, module, field).ok_or(Unsampled::Parameters)?;
    let name = program.variable(field.point).map(|v| v.name);
    let point = name.map_or("", |name| program.names.text(name));
    let is_given = |name: &str| name == point || parameters.iter().any(|(own, _)| own == name);
    if !scene.code.inputs.iter().all(|input| is_given(&input.name)) {
        return Err(Unsampled::Input);
    }
    let output = scene
        .code
        .outputs
        .iter()
        .position(|slot| slot.name.is_empty());
    let output = output
        .filter(|_| field.scalar < 4)
        .ok_or(Unsampled::Refused)?;
    let has_time = !scene.code.uniforms.is_empty();
    let mut search = SteepSearch {
        point,
        output: (output, field.scalar as usize),
        best: Vec::new(),
        seed: 1,
        samples: 0,
        time: None,
    };
    let times = TIMES.get(..if has_time { TIMES.len() } else { 1 });
    for &time in times.into_iter().flatten() {
        search.time = has_time.then_some(time);
        let mut state = scene.draw(SIZE, &Moment::at(time));
        for (name, values) in &parameters {
            let planes: Vec<[f32; 3]> = values.iter().map(|value| [*value, 0.0, 0.0]).collect();
            state.input(name, &planes);
        }
        search.run(state, planes);
    }
    let samples = search.samples;
    let best = search
        .best
        .into_iter()
        .max_by(|a, b| a.slope.total_cmp(&b.slope));
    Ok(best.map(|best| Steepest { samples, ..best }))
}

/// A function and those that it calls.
fn with_callees(module: &Module, function: FunctionRef) -> Vec<FunctionRef> {
    let mut own = vec![function];
    let mut at = 0;
    while let Some(function) = own.get(at).and_then(|f| module.function(*f)) {
        at += 1;
        for op in function.ops.ops() {
            if let OpKind::Call(callee, _) = module.op(op).kind
                && !own.contains(&callee)
            {
                own.push(callee);
            }
        }
    }
    own
}

/// The values of the parameters other than the point, as at the first call that passes constants.
fn parameters(
    program: &Program,
    module: &Module,
    field: DistanceField,
) -> Option<Vec<(String, Vec<f32>)>> {
    let function = module.function(field.function)?;
    let all = module.parameters(function);
    let others = (0..).zip(all).filter(|(_, id)| **id != field.point);
    let others: Vec<(usize, VariableId)> = others.map(|(at, id)| (at, *id)).collect();
    if others.is_empty() {
        return Some(Vec::new());
    }
    let calls = module.ops.iter().filter_map(|op| match op.kind {
        OpKind::Call(callee, list) if callee == field.function => Some(module.operands(list)),
        _ => None,
    });
    let mut passed = calls.filter_map(|arguments| {
        let values = others.iter().map(|(at, id)| {
            let name = program.names.text(program.variable(*id)?.name);
            let values = module.constant(*arguments.get(*at)?);
            let is_float = |value: &&Value| matches!(value, Value::Float(_));
            let is_all = !values.is_empty() && values.iter().all(|value| is_float(&value));
            let values = values.iter().map(|value| value.as_float()).collect();
            is_all.then(|| (name.to_string(), values))
        });
        values.collect::<Option<Vec<_>>>()
    });
    passed.next()
}

/// A global variable that some functions read, and that others write.
fn written_elsewhere(module: &Module, own: &[FunctionRef]) -> Option<VariableId> {
    let each = |functions: &mut dyn Iterator<Item = FunctionRef>| -> Vec<(bool, VariableId)> {
        let ops = functions
            .filter_map(|f| module.function(f))
            .flat_map(|f| f.ops.ops());
        let places = ops.filter_map(|op| match module.op(op).kind {
            OpKind::Store(place, _) => Some((true, module.place(place).variable)),
            OpKind::Load(place) => Some((false, module.place(place).variable)),
            _ => None,
        });
        let is_global =
            |id: &VariableId| module.variable(*id).is_some_and(|v| v.root == Root::Global);
        places.filter(|(_, id)| is_global(id)).collect()
    };
    let all = (0..module.functions.len() as u32).map(FunctionRef);
    let written = each(&mut all.filter(|f| !own.contains(f)));
    let read = each(&mut own.iter().copied());
    let mut read = read.into_iter().filter(|(is_store, _)| !is_store);
    let found = read.find(|(_, id)| written.contains(&(true, *id)));
    found.map(|(_, id)| id)
}

/// A plane in space: its middle, and the steps between pixels.
#[derive(Clone, Copy)]
struct SampledPlane {
    middle: [f64; 3],
    steps: [[f64; 3]; 2],
}

struct SteepSearch<'c> {
    point: &'c str,
    output: (usize, usize),
    best: Vec<Steepest>,
    seed: u32,
    samples: u64,
    time: Option<f64>,
}

impl SteepSearch<'_> {
    /// A number from -1 to 1.
    fn random(&mut self) -> f64 {
        self.seed = self.seed.wrapping_add(1);
        f64::from(hash(self.seed)) / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn direction(&mut self) -> [f64; 3] {
        loop {
            let vector = [self.random(), self.random(), self.random()];
            let length = length(vector);
            if length > 0.1 && length < 1.0 {
                return scale(vector, 1.0 / length);
            }
        }
    }

    fn run(&mut self, mut state: Draw<'_>, planes: u32) {
        let mut found: Vec<Steepest> = Vec::new();
        for number in 0..planes {
            let region = REGIONS
                .get(number as usize % REGIONS.len())
                .copied()
                .unwrap_or(1.0);
            let middle = [self.random(), self.random(), self.random()];
            let along = self.direction();
            // Coarse and fine planes.
            let step = region * if number % 2 == 0 { 0.05 } else { 0.004 };
            let plane = self.plane(scale(middle, region), along, step);
            found.extend(self.steepest_in(&mut state, plane));
        }
        found.sort_by(|a, b| b.slope.total_cmp(&a.slope));
        found.truncate(KEPT);
        for start in found {
            let mut best = start;
            for round in 0..ROUNDS {
                let [p, q] = best.points;
                let middle = scale(add(p, q), 0.5);
                let along = subtract(q, p);
                let size = length(along).max(1e-12);
                let least = 2e-3 * (1.0 + 0.2 * length(middle));
                let step = (size * 0.6).clamp(least, least.max(1.0));
                let mut along = scale(along, 1.0 / size);
                if round % 2 == 1 {
                    let other = self.direction();
                    along = add(along, scale(other, 0.4));
                    along = scale(along, 1.0 / length(along).max(1e-6));
                }
                let plane = self.plane(middle, along, step);
                if let Some(next) = self.steepest_in(&mut state, plane)
                    && next.slope > best.slope
                {
                    best = next;
                }
            }
            best.slope -= self.noise(&mut state, &best);
            self.best.push(best);
        }
    }

    /// What numeric noise may contribute to a slope: how much more the values vary within the rounding of a
    /// point than the slope explains, at both points. Differences of large numbers and roots near zero are
    /// noisy, as in the distance to a curve.
    fn noise(&mut self, state: &mut Draw<'_>, found: &Steepest) -> f64 {
        let [p, q] = found.points;
        let step = ROUNDING * 0.25 * (length(p) + length(q));
        let mut noise = 0.0;
        for point in found.points {
            let along = self.direction();
            let plane = self.plane(point, along, step);
            let Some((drawn, _)) = self.drawn(state, plane) else {
                continue;
            };
            let all = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
            let values = all.filter_map(|(x, y)| self.value(&drawn, x, y));
            let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| {
                (a.min(value), b.max(value))
            });
            let explained = found.slope * step * f64::from(SIZE[0] + SIZE[1]);
            noise += (most - least - explained).max(0.0);
        }
        // Rounding also shifts all values around a point alike, by about as much.
        2.0 * noise / length(subtract(p, q)).max(1e-12)
    }

    fn plane(&mut self, middle: [f64; 3], along: [f64; 3], step: f64) -> SampledPlane {
        let mut other = [0.0; 3];
        while length(other) < 0.1 {
            let free = self.direction();
            other = subtract(free, scale(along, dot(free, along)));
        }
        let other = scale(other, step / length(other));
        SampledPlane {
            middle,
            steps: [scale(along, step), other],
        }
    }

    /// The steepest pair of neighbours in a plane.
    fn steepest_in(&mut self, state: &mut Draw<'_>, plane: SampledPlane) -> Option<Steepest> {
        let (drawn, planes) = self.drawn(state, plane)?;
        self.steepest_of(&drawn, &planes)
    }

    /// The values in a plane, and the point as a linear input.
    fn drawn(
        &mut self,
        state: &mut Draw<'_>,
        plane: SampledPlane,
    ) -> Option<(Drawn, Vec<[f32; 3]>)> {
        let [u, v] = plane.steps;
        let half = [f64::from(SIZE[0]) / 2.0, f64::from(SIZE[1]) / 2.0];
        let origin = subtract(subtract(plane.middle, scale(u, half[0])), scale(v, half[1]));
        let lanes = origin.iter().zip(u).zip(v);
        let planes: Vec<[f32; 3]> = lanes
            .map(|((a, b), c)| [*a as f32, b as f32, c as f32])
            .collect();
        if !state.input(self.point, &planes) {
            return None;
        }
        let drawn = draw(state, 1).ok()?;
        self.samples += u64::from(SIZE[0] * SIZE[1]);
        Some((drawn, planes))
    }

    fn steepest_of(&self, drawn: &Drawn, planes: &[[f32; 3]]) -> Option<Steepest> {
        let place = |x: u32, y: u32| {
            let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            let at = planes
                .iter()
                .map(|[a, b, c]| f64::from(*a) + x * f64::from(*b) + y * f64::from(*c));
            let mut point = [0.0; 3];
            point
                .iter_mut()
                .zip(at)
                .for_each(|(slot, value)| *slot = value);
            point
        };
        let mut best: Option<Steepest> = None;
        for y in 0..SIZE[1] {
            for x in 0..SIZE[0] {
                for [dx, dy] in [[1, 0], [0, 1], [1, 1]] {
                    let values = self
                        .value(drawn, x, y)
                        .zip(self.value(drawn, x + dx, y + dy));
                    let Some((a, b)) = values else {
                        continue;
                    };
                    let points = [place(x, y), place(x + dx, y + dy)];
                    let size = length(points[0]).max(length(points[1]));
                    let distance = length(subtract(points[0], points[1])) + ROUNDING * size;
                    let noise = ROUNDING * (a.abs() + b.abs() + size);
                    let slope = ((a - b).abs() - noise) / distance;
                    if slope.is_finite() && best.is_none_or(|best| slope > best.slope) {
                        best = Some(Steepest {
                            points,
                            values: [a, b],
                            slope,
                            time: self.time,
                            samples: 0,
                        });
                    }
                }
            }
        }
        best
    }

    fn value(&self, drawn: &Drawn, x: u32, y: u32) -> Option<f64> {
        if x >= SIZE[0] || y >= SIZE[1] {
            return None;
        }
        let at = (y * SIZE[0] + x) as usize;
        let (output, scalar) = self.output;
        let bits = *drawn.outputs.get(output)?.get(at)?.get(scalar)?;
        let value = f64::from(f32::from_bits(bits));
        (value.is_finite() && *drawn.covered.get(at)? && value.abs() < 1e5).then_some(value)
    }
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let ([x, y, z], [u, v, w]) = (a, b);
    [x + u, y + v, z + w]
}

fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    add(a, scale(b, -1.0))
}

fn scale([x, y, z]: [f64; 3], by: f64) -> [f64; 3] {
    [x * by, y * by, z * by]
}

fn dot([x, y, z]: [f64; 3], [u, v, w]: [f64; 3]) -> f64 {
    x * u + y * v + z * w
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_engine::{DialectChoice, Options, analyze};
    use shaderlint_lint::Settings;
    use shaderlint_project::NoFiles;

    /// The steepest slope of `map`, given by its body, that was sampled.
    fn sampled(body: &str) -> f64 {
        let code = format!(
            "float map(vec3 p) {{ {body} }}
            void mainImage(out vec4 o, vec2 q) {{
                vec3 ro = vec3(0.0, 0.0, -3.0), rd = normalize(vec3(q, 1.0)); float t = 0.0;
                for (int i = 0; i < 80; i++) {{
                    float d = map(ro + rd * t); if (d < 0.001 || t > 20.0) break; t += d; }}
                o = vec4(t); }}"
        );
        let settings = Settings::new(&[], &[], &[]).unwrap();
        let options = Options::new(DialectChoice::default(), settings);
        let report = analyze("a.glsl", &code, &options, &NoFiles);
        let analysis = report.analyses.first().unwrap();
        assert!(!analysis.has_errors, "{body}");
        let facts = analysis.facts();
        let [field] = facts.fields()[..] else {
            panic!("{body}");
        };
        let found = steepest(
            (&analysis.program, facts.module()),
            analysis.host,
            field,
            20,
        );
        found.unwrap().unwrap().slope
    }

    /// Each case is the body of a distance field, which is exact or steep.
    #[test]
    fn steep_distance_fields_are_found() {
        let cases = include_str!("steepest.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (kind, body) = case.split_once(": ").unwrap();
            let slope = sampled(body);
            match kind {
                "steep" => assert!(slope > 1.1, "{slope}: {body}"),
                _ => assert!(slope <= 1.001, "{slope}: {body}"),
            }
        }
    }
}
