//! A shader whose output is lost or refused by where the program draws.

// Reported by the engine, which evaluates the program around the shaders.
rule! { render_target, Webgl2, Warning, Recommended, Page }
