//! `getUniformLocation(program, "name")` for a uniform that no shader of the file declares.

// Reports names that the linking code of the engine did not find in the shaders.
rule! { unknown_uniform, Webgl2, Warning, Recommended, Page }
