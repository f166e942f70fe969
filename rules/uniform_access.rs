//! A script that reads or sets a uniform in a way that does not reach the shader.

// Reported by the engine, which evaluates the program around the shaders.
rule! { uniform_access, Webgl2, Warning, Recommended, Page }
