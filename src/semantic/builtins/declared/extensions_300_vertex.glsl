// What extensions of WebGL2 add to vertex shaders.
out highp float gl_ClipDistance[8];
out highp float gl_CullDistance[8];
