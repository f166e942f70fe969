// Built-in variables of vertex shaders in GLSL ES 3.00 (7.1).
in highp int gl_VertexID;
in highp int gl_InstanceID;
out highp vec4 gl_Position;
out highp float gl_PointSize;
