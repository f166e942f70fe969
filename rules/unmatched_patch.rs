//! A `replace` in `onBeforeCompile` that searches for a chunk which three.js does not have.

// Reported by the engine, which evaluates the program around the shaders.
rule! { unmatched_patch, Webgl2, Warning, Recommended, Page }
