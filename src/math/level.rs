//! The SIMD instructions that the functions are compiled for. Results do not depend on them.

#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
use fearless_simd::Level;

#[cfg(target_arch = "x86_64")]
pub use fearless_simd::x86::{Avx2 as Faster, Sse2 as Baseline};

#[cfg(not(target_arch = "x86_64"))]
pub use self::Baseline as Faster;

#[cfg(target_arch = "aarch64")]
pub use fearless_simd::aarch64::Neon as Baseline;

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub use fearless_simd::wasm32::WasmSimd128 as Baseline;

#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
pub use fearless_simd::Fallback as Baseline;

/// The instructions that every machine of this target has.
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
#[expect(clippy::expect_used, reason = "decided when the program is compiled")]
#[inline(always)]
pub fn baseline() -> Baseline {
    let level = Level::baseline();
    #[cfg(target_arch = "x86_64")]
    let simd = level.as_sse2();
    #[cfg(target_arch = "aarch64")]
    let simd = level.as_neon();
    #[cfg(target_arch = "wasm32")]
    let simd = level.as_wasm_simd128();
    simd.expect("part of the target")
}

/// The instructions that every machine of this target has.
#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
#[inline(always)]
pub fn baseline() -> Baseline {
    Baseline::new()
}

/// Faster instructions, if this machine has them.
#[cfg(target_arch = "x86_64")]
pub fn faster() -> Option<Faster> {
    Level::new().as_avx2()
}

/// Faster instructions: this target has none that functions are compiled for.
#[cfg(not(target_arch = "x86_64"))]
pub fn faster() -> Option<Faster> {
    None
}
