//! A value or a setter that does not fit the type of its uniform.

// Reported by the engine, which evaluates the program around the shaders.
rule! { uniform_type, Webgl2, Warning, Recommended, Page }
