//! An attribute whose data does not fit its declaration, or that gets none.

// Reported by the engine, which evaluates the program around the shaders.
rule! { attribute_data, Webgl2, Warning, Recommended, Page }
