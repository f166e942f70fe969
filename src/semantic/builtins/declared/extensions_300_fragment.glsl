// What extensions of WebGL2 add to fragment shaders.
in lowp int gl_SampleID;
in mediump vec2 gl_SamplePosition;
in highp int gl_SampleMaskIn[1];
out highp int gl_SampleMask[1];
in highp float gl_ClipDistance[8];
in highp float gl_CullDistance[8];
genType interpolateAtCentroid(genType interpolant);
genType interpolateAtSample(genType interpolant, int number);
genType interpolateAtOffset(genType interpolant, vec2 offset);
