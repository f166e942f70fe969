//! GLSL ES 1.00 in a project that converts its shaders to GLSL ES 3.00.

// Reports complete shaders with their conversion, which needs the other stage: the engine finds them.
rule! { old_version, Webgl2, Warning, Recommended, Page }
