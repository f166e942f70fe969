//! A uniform that is set while another program, or none, is in use, or on a program that does not have it.

// Reported by the engine, which evaluates the program around the shaders.
rule! { program_state, Webgl2, Warning, Recommended, Page }
