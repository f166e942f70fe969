//! The SIMD instructions that the functions are compiled for. Results do not depend on them.

use fearless_simd::Level;
pub use target::{Baseline, Faster};

#[cfg(target_arch = "x86_64")]
mod target {
    use fearless_simd::Level;
    pub use fearless_simd::x86::{Avx2 as Faster, Sse2 as Baseline};

    #[inline(always)]
    pub fn baseline(level: Level) -> Option<Baseline> {
        level.as_sse2()
    }

    pub fn faster() -> Option<Faster> {
        Level::new().as_avx2()
    }
}

#[cfg(target_arch = "aarch64")]
mod target {
    use fearless_simd::Level;
    pub use fearless_simd::aarch64::{Neon as Baseline, Neon as Faster};

    #[inline(always)]
    pub fn baseline(level: Level) -> Option<Baseline> {
        level.as_neon()
    }

    pub fn faster() -> Option<Faster> {
        None
    }
}

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod target {
    use fearless_simd::Level;
    pub use fearless_simd::wasm32::{WasmSimd128 as Baseline, WasmSimd128 as Faster};

    #[inline(always)]
    pub fn baseline(level: Level) -> Option<Baseline> {
        level.as_wasm_simd128()
    }

    pub fn faster() -> Option<Faster> {
        None
    }
}

#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
mod target {
    use fearless_simd::Level;
    pub use fearless_simd::{Fallback as Baseline, Fallback as Faster};

    #[inline(always)]
    pub fn baseline(_: Level) -> Option<Baseline> {
        Some(Baseline::new())
    }

    pub fn faster() -> Option<Faster> {
        None
    }
}

/// The instructions that every machine of this target has.
#[expect(clippy::expect_used, reason = "decided when the program is compiled")]
#[inline(always)]
pub fn baseline() -> Baseline {
    target::baseline(Level::baseline()).expect("part of the target")
}

/// Faster instructions, if the functions are compiled for some and this machine has them.
pub fn faster() -> Option<Faster> {
    target::faster()
}
