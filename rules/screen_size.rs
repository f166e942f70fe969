//! A size in CSS pixels for a shader that divides `gl_FragCoord` by it.

// Reported by the engine, which evaluates the program around the shaders.
rule! { screen_size, Webgl2, Warning, Recommended, Page }
