// Built-in variables of vertex shaders in GLSL ES 1.00 (7.1).
out highp vec4 gl_Position;
out mediump float gl_PointSize;
