//! The VM with the instructions of every machine and with faster ones.

use super::{Tile, Vm};
use crate::{CompileOptions, Draw, ErrorDirection, GpuProfile, Watch, compile};
use shaderlint_ir::lower;
use shaderlint_math::{Faster, faster};
use shaderlint_semantic::check_fragment;

/// Results and statistics are the same with the instructions of every machine and with faster ones.
#[test]
fn results_are_the_same_on_every_machine() {
    let code = "#version 300 es\nprecision highp float; precision highp int; out vec4 color;
        uniform int n; uniform float x, a[4];
        float f(float p) { return p < 9.0 ? sin(p * 1e5) : pow(p, 1.7) / (p - 20.0); }
        void main() { vec2 p = gl_FragCoord.xy; float s = 0.0; int k = n;
        for (int i = 0; i < 20; i++) { s += f(p.x + float(i)); if (s > p.y * 9.0) break; k ^= i << k; }
        if (k % 3 == 1) s = mod(s, dFdx(s)); uint u = uint(abs(k)) / uint(n - 3 + k % 2);
        color = vec4(s, a[k & 3], uintBitsToFloat(u), inversesqrt(x - s)); }";
    let program = check_fragment(code).program;
    let module = lower(&program);
    let pixels = std::array::from_fn(|lane| [lane as u32 % 8, lane as u32 / 8]);
    let requested = u32::MAX >> 3;
    for watch in [
        Watch::Nothing,
        Watch::Flow,
        Watch::Faults,
        Watch::Comparisons,
    ] {
        for gpu_profile in [
            GpuProfile::Exact,
            GpuProfile::Inexact(ErrorDirection::Either),
        ] {
            let options = CompileOptions {
                watch,
                cost: true,
                gpu_profile,
                ..CompileOptions::default()
            };
            let bytecode = compile(&program, &module, &options).unwrap();
            let mut ready = Draw::new(&bytecode, [8, 4]);
            ready.set("n", &[3.0]);
            ready.set("x", &[0.5]);
            ready.set("a", &[10.0, 20.0, 30.0, 40.0]);
            let run = |faster: Option<Faster>| {
                let mut vm = Vm::with(&ready, faster);
                let covered = vm.run(&Tile {
                    pixels,
                    requested,
                    cases: [0; crate::LANES],
                });
                let outputs = bytecode.outputs.iter().flat_map(|slot| &slot.regs);
                let outputs: Vec<_> = outputs.map(|reg| vm.row(*reg).0).collect();
                let spent = vm.spent;
                format!("{covered:?} {outputs:x?} {spent} {:?}", vm.finish())
            };
            assert_eq!(run(faster()), run(None), "{watch:?} {gpu_profile:?}");
        }
    }
}
