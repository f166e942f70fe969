// Built-in variables of fragment shaders in GLSL ES 3.00 (7.2).
in highp vec4 gl_FragCoord;
in bool gl_FrontFacing;
in mediump vec2 gl_PointCoord;
out highp float gl_FragDepth;
