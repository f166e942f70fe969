// Built-in variables of fragment shaders in GLSL ES 1.00 (7.2).
in mediump vec4 gl_FragCoord;
in bool gl_FrontFacing;
in mediump vec2 gl_PointCoord;
out mediump vec4 gl_FragColor;
out mediump vec4 gl_FragData[1];
