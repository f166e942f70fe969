// What WEBGL_multi_draw adds to vertex shaders.
in highp int gl_DrawID;
