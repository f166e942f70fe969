//! A uniform that its shader uses and nothing in the program sets.

// Reported by the engine, which evaluates the program around the shaders.
rule! { unset_uniform, Webgl2, Warning, Recommended, Page }
