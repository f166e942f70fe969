//! Tests of the VM: results per pixel, independence of pixels that run side by side, and
//! termination.

use shaderlint_exec::{
    Bytecode, COMPARED_SIZE, CompileOptions, Draw, Drawn, Equality, ErrorDirection, FaultKind,
    GpuProfile, Observations, OperationCost, Stop, Watch, compile, draw, equality, quads_all_over,
    sample,
};
use shaderlint_ir::lower;
use shaderlint_semantic::check_fragment;
use std::collections::BTreeSet;

/// The declarations of every shader here, on one line.
const HEAD: &str = "#version 300 es\nprecision highp float; precision highp int; out vec4 color; \
                    uniform int n; uniform float x; uniform vec3 v; uniform mat3 m; \
                    uniform float a[4]; struct S { float a; vec2 b; };\n";

pub(super) fn compiled(code: &str, options: &CompileOptions) -> Bytecode {
    let analysis = check_fragment(code);
    assert!(analysis.is_valid(), "{code}: {:?}", analysis.problems.all);
    let module = lower(&analysis.program);
    let made = compile(&analysis.program, &module, options);
    made.unwrap_or_else(|refusal| panic!("{refusal:?}\n{code}"))
}

fn set_all(draw: &mut Draw<'_>) {
    draw.set("n", &[3.0]);
    draw.set("x", &[0.5]);
    draw.set("v", &[1.0, 2.0, 3.0]);
    draw.set("m", &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    draw.set("a", &[10.0, 20.0, 30.0, 40.0]);
}

fn drawn(code: &str, size: [u32; 2]) -> Drawn {
    let code = compiled(code, &CompileOptions::default());
    let mut ready = Draw::new(&code, size);
    set_all(&mut ready);
    draw(&ready, 1).unwrap()
}

/// The pixels of the first row, as floats.
pub(super) fn row(code: &str, width: u32) -> Vec<[f32; 4]> {
    let drawn = drawn(code, [width, 1]);
    let pixels = drawn.outputs.first().unwrap().iter();
    pixels.map(|p| p.map(f32::from_bits)).collect()
}

/// Checks the value of an expression with four components.
#[track_caller]
fn check(expression: &str, expected: [f32; 4]) {
    let code = format!("{HEAD}void main() {{ color = {expression}; }}");
    assert_eq!(row(&code, 1), [expected], "{expression}");
}

#[test]
fn results_are_those_of_the_specification() {
    let mut given = "";
    for line in include_str!("results.txt").lines() {
        if line.is_empty() {
            given = "";
        } else if let Some(functions) = line.strip_prefix("given:") {
            given = functions;
        } else if !line.starts_with('#') {
            let (code, values) = line.split_once(" => ").unwrap();
            let values = values.split(' ').map(|v| v.parse().unwrap());
            let values: Vec<f32> = values.collect();
            match <[f32; 4]>::try_from(&*values) {
                Ok(components) => check(code, components),
                Err(_) => check_row(given, code, &values),
            }
        }
    }
}

/// Checks the first component that the statements produce in the pixels `p` of a row of eight.
#[track_caller]
fn check_row(functions: &str, statements: &str, expected: &[f32]) {
    let main = format!("void main() {{ int p = int(gl_FragCoord.x); {statements} }}");
    let code = format!("{HEAD}{functions}\n{main}");
    let found: Vec<f32> = row(&code, 8).iter().map(|p| p[0]).collect();
    assert_eq!(found, expected, "{statements}");
}

/// The values that Chromium gives for programs that write to the operands of the same expression.
#[test]
fn operands_that_are_variables_are_loaded_last() {
    let global = "float G = 1.0; int I = 1; vec3 V = vec3(1, 2, 3); float A[4] = float[4](10.0, 20.0, 30.0, 40.0);
        float f() { G = 5.0; return 10.0; } float h() { G += 1.0; return G; }
        int fi() { I = 2; return 3; } vec3 fv() { V = vec3(7, 8, 9); return vec3(0); }
        float two(float a, float b) { return a * 10.0 + b; }
        float o(inout float x) { x += 3.0; return x; }";
    for line in include_str!("operands.txt").lines() {
        let (program, expected) = line.split_once(" => ").unwrap();
        let expected: f32 = expected.parse().unwrap();
        let main =
            format!("float r, x = 1.0, y = 2.0; vec2 v = vec2(1, 2); {program} color = vec4(r);");
        let code = format!(
            "#version 300 es\nprecision highp float;\nout vec4 color;\n{global}\nvoid main() {{ {main} }}"
        );
        assert_eq!(row(&code, 1), [[expected; 4]], "{program}");
    }
}

/// Chromium returns the second operand if one of them is NaN.
#[test]
fn min_max_and_clamp_of_nan_are_those_of_chromium() {
    let nan = "uintBitsToFloat(0x7fc00000u + uint(n - 3))";
    check(
        &format!("vec4(min({nan}, x), max({nan}, x), clamp({nan}, x, 2.0), clamp(x, {nan}, 2.0))"),
        [0.5, 0.5, 0.5, 2.0],
    );
    check(
        &format!(
            "vec4(isnan(min(x, {nan})), isnan(max(x, {nan})), isnan(clamp(x, 0.0, {nan})), fract({nan}) < 1.0)"
        ),
        [1.0; 4],
    );
}

#[test]
fn modf_gives_both_parts() {
    let modf = format!("{HEAD}void main() {{ float w; color = vec4(modf(-2.5, w), w, 0, 0); }}");
    assert_eq!(row(&modf, 1), [[-0.5, -2.0, 0.0, 0.0]]);
}

#[test]
fn derivatives_use_the_neighbours_in_the_quad() {
    // A quad shares one derivative, that of its first pixel.
    let area = "gl_FragCoord.x * gl_FragCoord.y";
    let one = format!("{HEAD}void main() {{ color = vec4(dFdx({area}), dFdy({area}), 0, 0); }}");
    let one = drawn(&one, [2, 2]).outputs.swap_remove(0);
    assert!(
        one.iter()
            .all(|p| p.map(f32::from_bits) == [0.5, 0.5, 0.0, 0.0])
    );
    let discard =
        format!("{HEAD}void main() {{ if (gl_FragCoord.x < 2.0) discard; color = vec4(1); }}");
    assert_eq!(drawn(&discard, [4, 1]).covered, [false, false, true, true]);
}

/// A shader with loops, calls, branches and derivatives.
const BUSY: &str = include_str!("busy.glsl");

/// Eight quads give the same results together as alone, and two threads the same as one.
#[test]
fn quads_do_not_depend_on_each_other() {
    let code = compiled(&format!("{HEAD}{BUSY}"), &CompileOptions::default());
    let mut ready = Draw::new(&code, [40, 24]);
    set_all(&mut ready);
    let together = draw(&ready, 2).unwrap();
    assert_eq!(draw(&ready, 1).unwrap().outputs, together.outputs);
    for y in (0..24).step_by(2) {
        for x in (0..40).step_by(2) {
            let alone = sample(&ready, &[[x, y]]).unwrap();
            for (pixel, found) in alone.pixels.iter().zip(&alone.outputs[0]) {
                let at = (pixel[1] * 40 + pixel[0]) as usize;
                assert_eq!(*found, together.outputs[0][at], "{pixel:?}");
            }
        }
    }
}

/// Statistics do not change the image.
#[test]
fn statistics_do_not_change_the_image() {
    let text = format!("{HEAD}{BUSY}");
    let levels = [Watch::Nothing, Watch::Flow, Watch::Faults, Watch::Numbers];
    let renders = levels.map(|watch| {
        let code = compiled(&text, &watching(watch));
        let mut ready = Draw::new(&code, [40, 24]);
        set_all(&mut ready);
        draw(&ready, 1).unwrap().outputs
    });
    for render in &renders {
        assert_eq!(*render, renders[0]);
    }
}

fn watching(watch: Watch) -> CompileOptions {
    CompileOptions {
        watch,
        ..CompileOptions::default()
    }
}

fn seen(statements: &str) -> Observations {
    seen_by(Watch::Numbers, statements)
}

fn seen_by(watch: Watch, statements: &str) -> Observations {
    let text = format!("{HEAD}void main() {{ int p = int(gl_FragCoord.x); {statements} }}");
    let code = compiled(&text, &watching(watch));
    let mut ready = Draw::new(&code, [8, 1]);
    set_all(&mut ready);
    draw(&ready, 1).unwrap().seen
}

#[test]
fn loop_iterations_are_counted() {
    let seen = seen("for (int i = 0; i < 5; i++) { if (i == p) break; } color = vec4(0);");
    let [only] = seen.loops.as_slice() else {
        panic!("{seen:?}")
    };
    assert_eq!((only.pixels, only.entries, only.most), (8, 8, 5));
    // Pixels 5, 6 and 7 never break.
    assert_eq!((only.exhausted, only.exhausted_pixels), (3, 3));
    assert_eq!(only.iterations, 1 + 2 + 3 + 4 + 5 + 5 + 5 + 5);
    assert_eq!(only.histogram, [0, 1, 1, 1, 1, 4]);
}

#[test]
fn branches_and_faults_are_counted() {
    let seen = seen(
        "float q = float(p) - 2.0; if (p > 2) q = -q; color = vec4(1.0 / q, sqrt(q), a[p], 0);",
    );
    let [branch] = seen.branches.as_slice() else {
        panic!("{seen:?}")
    };
    assert_eq!((branch.taken, branch.skipped), (5, 3));
    let found: Vec<_> = seen
        .numbers
        .iter()
        .map(|n| (n.kind, n.times, n.witness.pixel[0]))
        .collect();
    assert_eq!(
        found,
        [
            (FaultKind::Infinite, 1, 2),
            (FaultKind::DivisionByZero, 1, 2),
            (FaultKind::Nan, 7, 0),
            (FaultKind::Undefined, 7, 0),
            (FaultKind::OutOfRange, 4, 4)
        ]
    );
    let [compared] = seen.compared.as_slice() else {
        panic!("{seen:?}")
    };
    assert_eq!((compared.held, compared.failed), (5, 3));
    assert_eq!((compared.left, compared.right), ([0.0, 7.0], [2.0, 2.0]));
}

/// Operands with undefined results are found, whatever the VM computes for them.
#[test]
fn undefined_results_are_recorded() {
    let lines = include_str!("undefined.txt").lines();
    for line in lines.filter(|line| !line.starts_with('#')) {
        let (code, expected) = line.split_once(" => ").unwrap();
        let statements = match code.ends_with(';') {
            true => code.to_string(),
            false => format!("float q = float(p) - 2.0; color = vec4({code});"),
        };
        let found = seen(&statements).numbers;
        let undefined = found.iter().filter(|n| n.kind == FaultKind::Undefined);
        let shown = undefined.map(|n| {
            let (pixel, operands) = (n.witness.pixel[0], &n.witness.operands);
            format!("{} from pixel {pixel}: {operands:?}", n.times)
        });
        assert_eq!(shown.collect::<Vec<_>>().join("; "), expected, "{code}");
    }
}

/// `Watch::Faults` and `Watch::Numbers` find the same faults.
#[test]
fn watching_faults_or_all_values_finds_the_same_faults() {
    let statements = "float q = float(p) - 2.0; if (p > 2) q = -q; \
                      color = vec4(1.0 / q, sqrt(q), a[p], 4 % (p - 3));";
    let (all, faults) = (seen(statements), seen_by(Watch::Faults, statements));
    let is_fault = |kind: FaultKind| !matches!(kind, FaultKind::Nan | FaultKind::Infinite);
    let mut expected = all.numbers;
    expected.retain(|number| is_fault(number.kind));
    assert!(expected.len() >= 4, "{expected:?}");
    for (number, other) in faults.numbers.iter().zip(&mut expected) {
        other.witness = number.witness.clone();
    }
    assert_eq!(faults.numbers, expected);
    assert_eq!(faults.compared, []);
    let compared = seen_by(Watch::Comparisons, statements).compared;
    assert_eq!((compared.len(), &compared), (1, &all.compared));
}

/// A draw call lists the uniforms that differ from another one.
#[test]
fn uniforms_that_differ_between_draws_are_listed() {
    let text = format!("{HEAD}void main() {{ color = vec4(x, v[1], a[n], m[0][0]); }}");
    let code = compiled(&text, &CompileOptions::default());
    let [mut one, other] = [(); 2].map(|()| Draw::new(&code, [8, 1]));
    one.set("a[2]", &[1.0]);
    one.set("x", &[2.0]);
    one.set("n", &[0.0]);
    let names: Vec<&str> = one.differences(&other).map(|u| u.name.as_str()).collect();
    assert_eq!(names, ["a", "x"]);
}

/// A GPU with the maximum permitted error draws sine noise differently, and a plain gradient almost
/// identically.
#[test]
fn gpu_profiles_differ_only_where_gpus_may() {
    let render = |expression: &str, gpu_profile: GpuProfile| {
        let text = format!(
            "{HEAD}void main() {{ vec2 q = gl_FragCoord.xy; color = vec4({expression}); }}"
        );
        let options = CompileOptions {
            gpu_profile,
            ..CompileOptions::default()
        };
        let code = compiled(&text, &options);
        let drawn = draw(&Draw::new(&code, [8, 8]), 1).unwrap();
        let reds = drawn.outputs[0].iter().map(|p| f32::from_bits(p[0]));
        reds.collect::<Vec<f32>>()
    };
    let most = |expression: &str, gpu_profile: GpuProfile| {
        let exact = render(expression, GpuProfile::Exact);
        let pairs = exact.iter().zip(render(expression, gpu_profile));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
    };
    let noise = "fract(sin(dot(q, vec2(12.9898, 78.233))) * 43758.5453)";
    let plain = "sin(q.x / 8.0) * exp(-q.y / 8.0)";
    for direction in [
        ErrorDirection::Out,
        ErrorDirection::In,
        ErrorDirection::Either,
    ] {
        assert!(
            most(noise, GpuProfile::Inexact(direction)) > 0.1,
            "{direction:?}"
        );
        let off = most(plain, GpuProfile::Inexact(direction));
        assert!(0.0 < off && off < 0.001, "{direction:?}: {off}");
    }
    assert_eq!(most(plain, GpuProfile::Mobile), 0.0);
    let bounded = "max(q.x, sqrt(-q.y))";
    assert!(render(bounded, GpuProfile::Exact)[0].is_nan());
    for gpu_profile in [GpuProfile::Inexact(ErrorDirection::Out), GpuProfile::Mobile] {
        assert_eq!(render(bounded, gpu_profile)[0], 0.5);
    }
}

/// Names, declaration order and helper functions do not change the bytecode; a constant does.
#[test]
fn equivalent_code_compiles_to_the_same_bytecode() {
    let code = |text: &str| compiled(&format!("{HEAD}{text}"), &CompileOptions::default());
    let plain = code("void main() { float k = x * 2.0; color = vec4(k + v.x); }");
    let compare = |text: &str| {
        let other = code(text);
        let ready = |code| {
            let mut draw = Draw::new(code, COMPARED_SIZE);
            set_all(&mut draw);
            draw
        };
        let mut fuel = 10_000_000;
        equality([&plain, &other], &mut fuel, &|_| {
            [ready(&plain), ready(&other)]
        })
    };
    let renamed =
        "float twice(float b) { return b * 2.0; } void main() { color = vec4(twice(x) + v.x); }";
    assert_eq!(compare(renamed), Equality::Proved);
    let other = "void main() { float k = x + x; color = vec4(k + v.x); }";
    assert_eq!(compare(other), Equality::SampledEqual { pixels: 9152 });
    let wrong = "void main() { color = vec4(x * 2.0 + v.x + floor(gl_FragCoord.x / 300.0)); }";
    assert!(matches!(
        compare(wrong),
        Equality::Differs { moment: 0, .. }
    ));
}

#[test]
fn endless_loops_run_out_of_fuel() {
    let endless = format!("{HEAD}void main() {{ while (n > 0) {{ color.x += 1.0; }} }}");
    let code = compiled(&endless, &CompileOptions::default());
    let mut ready = Draw::new(&code, [2, 2]);
    set_all(&mut ready);
    assert!(matches!(draw(&ready, 1), Err(Stop::OutOfFuel { .. })));
}

#[test]
fn values_that_are_too_large_are_refused() {
    let large =
        format!("{HEAD}void main() {{ float k[40000]; k[n] = 1.0; color = vec4(k[n + 1]); }}");
    let analysis = check_fragment(&large);
    let module = lower(&analysis.program);
    let refusal = compile(&analysis.program, &module, &CompileOptions::default());
    assert_eq!(
        refusal.unwrap_err().what,
        "a value with more than 32,768 scalars"
    );
}

#[test]
fn costs_are_attributed_to_the_called_function() {
    let code = format!(
        "{HEAD}float f(float y) {{ return y * y; }}
        float g(float y) {{ return f(y) + 1.0; }}
        void main() {{
            float y = f(gl_FragCoord.x);
            if (gl_FragCoord.x < 4.0) y += g(y);
            color = vec4(y);
        }}"
    );
    let options = CompileOptions {
        cost: true,
        ..CompileOptions::default()
    };
    let code = compiled(&code, &options);
    for threads in [1, 2] {
        let drawn = draw(&Draw::new(&code, [16, 4]), threads).unwrap();
        let seen = &drawn.seen;
        let [globals, main, f, g] = seen.functions[..] else {
            panic!("{:?}", seen.functions)
        };
        let sum: u64 = seen.functions.iter().map(|f| f.own).sum();
        assert_eq!(sum, seen.operations);
        assert_eq!(globals.own + main.inclusive, seen.operations);
        let costs: Vec<_> = code.costs(seen).filter(|c| c.operations > 0).collect();
        let of = |is_it: fn(&OperationCost) -> bool| -> u64 {
            costs
                .iter()
                .filter(|c| is_it(c))
                .map(|c| c.operations)
                .sum()
        };
        assert_eq!(of(|_| true), seen.operations);
        // `f` is called by `main`, and by `main` through `g`.
        assert_eq!(of(|c| c.calls.is_empty()), globals.own + main.own);
        assert_eq!(of(|c| c.calls.len() == 1), 64 + g.own);
        assert_eq!(of(|c| c.calls.len() == 2), 16);
        // All 64 pixels call `f`; 16 of them call `g`, which calls `f` again.
        assert_eq!(f.own, 5 * (g.inclusive - g.own));
        let paid = |x: usize| (drawn.cost[x], drawn.ran[x]);
        let (branch, all) = paid(0);
        assert_eq!(branch, all);
        assert_eq!(paid(4).1, all);
        assert!(paid(4).0 < all && paid(8) == (paid(4).0, paid(4).0));
    }
}

#[test]
fn sampled_quads_are_distributed_over_the_image() {
    let size = [1280, 720];
    for count in [250, 576] {
        let quads = quads_all_over(size, count, 1);
        assert!(
            quads.len() <= count && quads.len() * 10 > count * 8,
            "{}",
            quads.len()
        );
        assert!(quads.iter().all(|[x, y]| x % 2 == 0 && y % 2 == 0));
        assert!(quads.iter().all(|[x, y]| *x < size[0] && *y < size[1]));
        let sixteenths: BTreeSet<_> = quads.iter().map(|[x, y]| (x / 320, y / 180)).collect();
        assert_eq!(sixteenths.len(), 16);
        assert_ne!(quads, quads_all_over(size, count, 2));
    }
}

/// Groups of pixels at the right and upper edge are partly outside of the image.
#[test]
fn every_pixel_has_its_own_coordinates() {
    let text = format!("{HEAD}void main() {{ color = gl_FragCoord; }}");
    for size in [[1, 1], [13, 7], [16, 8], [5, 9], [61, 37]] {
        let drawn = drawn(&text, size);
        let found = drawn.outputs.first().unwrap().iter();
        let found: Vec<[f32; 2]> = found.map(|p| [p[0], p[1]].map(f32::from_bits)).collect();
        let rows = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y]));
        let expected: Vec<_> = rows.map(|pixel| pixel.map(|n| n as f32 + 0.5)).collect();
        assert_eq!(found, expected, "{size:?}");
        assert_eq!(drawn.seen.pixels, u64::from(size[0] * size[1]));
    }
}
