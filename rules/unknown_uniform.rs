//! A uniform that a script sets or looks up, but no shader of its program declares.

// Reported by the engine, which evaluates the program around the shaders.
rule! { unknown_uniform, Webgl2, Warning, Recommended, Page }
